# SPDX-License-Identifier: Apache-2.0
"""Context of the rules: model, mapping of names to records, and hidden bodies of element states."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.multibody.bodies import Body

if TYPE_CHECKING:
    from pitchpoint.model.scenario import Scenario

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Places:
    """Mapping of names in a model to its records.

    Parameters
    ----------
    end
        Function of ground, BODY, BODY.MARKER or BEAM.STATION: body number, point from the body origin [m] and
        axes (columns), both in the body-fixed frame.
    world
        Function of the same names: position in the world with all coordinates zero [m].
    axes
        Function of the same names: axes in the world with all coordinates zero, columns.
    state
        Function of the name of an element with a state: number of its hidden body.
    model, scenario
        Model and scenario to compile.
    numbers
        Number of each body of the model.
    tree
        Bodies of the model and stations of its beams, in the order of their numbers, from 1.
    """

    end: Callable[[str], tuple[int, Array, Array]]
    world: Callable[[str], Array]
    axes: Callable[[str], Array]
    state: Callable[[str], int]
    model: Any = None
    scenario: Scenario | None = None
    numbers: Mapping[str, int] = field(default_factory=dict)
    tree: Sequence[Body] = ()

    def mark(self, row: Any, ends: Iterable[str]) -> None:
        """Set bodies, points and, if the record has them, axes of two ends."""
        for letter, name in zip("ij", ends, strict=True):
            row[letter], row["p_" + letter], axes = self.end(name)
            if "A_" + letter in row.dtype.names:
                row["A_" + letter] = axes

    def pair(self, row: Any, bodies: tuple[str, ...]) -> None:
        """Set the numbers of one or two bodies; the second is ground if omitted."""
        row["i"] = self.end(bodies[0])[0]
        row["j"] = self.end(bodies[1])[0] if len(bodies) == 2 else 0


STATE = ".state"
"""End of the names of hidden bodies."""


def hidden_bodies(elements: Iterable[str]) -> list[Body]:
    """Hidden bodies whose spin rates are the states of elements, numbered after all others.

    Parameters
    ----------
    elements
        Names of the elements with a state.
    """
    return [Body(name=f"{name}{STATE}", polar_inertia=1.0, state=True) for name in elements]
