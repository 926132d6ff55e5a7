# SPDX-License-Identifier: Apache-2.0
"""Row definitions of the tables of gears and meshes: identifier, meaning, dimension."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from pitchpoint.contact.stiffness.description import Description

Row = tuple[str, str, str]
"""Identifier, meaning, dimension of `core.units`."""
C_PRIME_B, MEAN, ONE_PAIR = "c' b", "the mean", "K of one pair"
"""Reference value of a mesh cycle: single stiffness times common width, the mean of a prescribed wave, or
the constant of a pair whose force is a power of its deflection."""


def pick(source: Any, rows: Sequence[Row], positive: set[str]) -> dict[str, Any]:
    """Values of the attributes named in the rows; absolute values for those in `positive`."""
    numbers = {}
    for name, _, _ in rows:
        value = getattr(source, name)
        numbers[name] = abs(value) if name in positive else value
    return numbers


LAW_ROWS: tuple[Row, ...] = (
    ("stiffness_law", "stiffness law of the simulation", ""),
    ("c_prime_law", "its single stiffness", "stiffness_per_width"),
    ("mean_mesh_stiffness", "its mean mesh stiffness along the base tangent", "stiffness"),
)


def law_numbers(name: str, law: Description | None, mean: float | None) -> dict[str, Any]:
    """Stiffness of the law of a mesh; None where the law does not have such a value.

    Parameters
    ----------
    name
        Name of the law in model files.
    law
        Its description; the single stiffness is that of a linear law of tooth pairs.
    mean
        Mean stiffness over the mesh cycle along the base tangent [N/m].
    """
    from pitchpoint.contact.stiffness.description import PairShape

    linear = isinstance(law, PairShape) and law.power == 1.0
    return {
        "stiffness_law": name,
        "c_prime_law": law.c_prime if linear else None,  # type: ignore[union-attr]
        "mean_mesh_stiffness": mean,
    }
