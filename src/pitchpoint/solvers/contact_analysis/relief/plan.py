# SPDX-License-Identifier: Apache-2.0
"""Plan of a relief design: variables, torques, tolerances, limits, effort."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pitchpoint.core.errors import Message
from pitchpoint.solvers.contact_analysis.load_checks import (
    angle_problem,
    count_problem,
    flank_problem,
    is_positive,
    number_problem,
    positions_problem,
    refuse,
    torque_problem,
)
from pitchpoint.solvers.contact_analysis.relief.analyses import Conditions
from pitchpoint.solvers.contact_analysis.relief.target import Target
from pitchpoint.solvers.contact_analysis.relief.variables import Variable

POSITIONS = 8, 10_000
"""Least and largest number of mesh phases of a search."""
LEAST_ANALYSES = 20
"""Smallest number of analyses of a search."""
FINER = 4
"""Factor of the positions at the end of a search."""


@dataclass(frozen=True, kw_only=True)
class ReliefPlan:
    """What is varied, and for what.

    Parameters
    ----------
    vary
        Lower and upper bound [m] of the variables by path, such as
        gears.pinion.modifications.both.tip_relief.amount.
    torques
        Torques on gear 1 [N m]; only the magnitudes count.
    weights
        Weight of each torque; None: equal.
    mean
        Minimise the weighted mean of the peak-to-peak errors over the torques instead of their maximum.
    tolerances
        Tolerance ± by path [m], of varied or other modifications; the worst deviations count.
    misalignments
        Angles between the flanks in the plane of action [rad]; the worst counts. Empty: that of the housing.
    max_pressure
        Limit of the Hertzian pressure on the path of contact at the highest torque [Pa].
    no_edge_contact
        Tip edges must not carry load at the highest torque.
    positions
        Mesh phases over one base pitch during the search; its end and all results have `FINER` times as
        many.
    flank
        1: front flanks (gear 1 drives counter-clockwise), -1: back flanks.
    analyses
        Maximum number of analyses of the search, each at all torques for one deviation; those with more
        positions count several times.
    samples
        Random deviations with more than four tolerances.
    seed
        Seed of search and samples.

    Raises
    ------
    SolverError
        With all parts that are out of range.
    """

    vary: Mapping[str, tuple[float, float]]
    torques: Sequence[float]
    weights: Sequence[float] | None = None
    mean: bool = False
    tolerances: Mapping[str, float] = field(default_factory=dict)
    misalignments: Sequence[float] = ()
    max_pressure: float | None = None
    no_edge_contact: bool = False
    positions: int = 64
    flank: int = 1
    analyses: int = 3000
    samples: int = 12
    seed: int = 1

    def __post_init__(self) -> None:
        refuse(*self._problems(), of="relief design")

    def _problems(self) -> Iterator[Message | None]:
        """Problems of all parts."""
        if not self.vary:
            yield Message("vary", "is empty", None, "at least one variable", "give paths with their bounds")
        for path, bounds in self.vary.items():
            yield _bounds_problem(path, bounds)
        if np.ndim(self.torques) == 0:
            yield Message("torques", "is not a list", repr(self.torques), "one or more", "write [200.0]")
        else:
            yield torque_problem(self.torques)
        if self.weights is not None:
            yield from self._of_weights()
        for path, width in self.tolerances.items():
            where, remedy = f"tolerances of {path}", "give tolerances >= 0, half of the whole width"
            yield number_problem(where, width, lambda value: value >= 0.0, "0 or more, in m", remedy)
        for angle in self.misalignments:
            yield angle_problem(angle)
        if self.max_pressure is not None:
            remedy = "give a limit such as 1.2e9, or None"
            yield number_problem("max_pressure", self.max_pressure, is_positive, "above 0, in Pa", remedy)
        yield positions_problem(self.positions, POSITIONS)
        yield flank_problem(self.flank)
        yield count_problem("analyses", self.analyses, LEAST_ANALYSES)
        yield count_problem("samples", self.samples, 1)
        yield count_problem("seed", self.seed, 0)

    def _of_weights(self) -> Iterator[Message | None]:
        """Problems of the weights."""
        assert self.weights is not None
        remedy = "give weights >= 0"
        for one in self.weights:
            yield number_problem("weights", one, lambda value: value >= 0.0, "0 or more", remedy)
        count = np.size(self.torques)
        if len(self.weights) != count:
            given = f"{len(self.weights)} weights"
            yield Message("weights", "do not fit", given, str(count), "give one weight for each torque")
        elif not any(self.weights):
            yield Message("weights", "are all 0", None, "one above 0", remedy)

    @property
    def variables(self) -> list[Variable]:
        """Variables in the order of `vary`."""
        return [Variable(path, float(low), float(high)) for path, (low, high) in self.vary.items()]

    def order(self) -> list[int]:
        """Order of the torques from the smallest to the largest."""
        return sorted(range(len(self.torques)), key=lambda k: abs(self.torques[k]))

    def target(self) -> Target:
        """Target for torques in increasing order."""
        weights = (
            np.ones(len(self.torques)) if self.weights is None else np.asarray(self.weights, dtype=float)
        )
        weights = weights[self.order()]
        return Target(weights / weights.max(), self.mean, self.max_pressure, self.no_edge_contact)

    def conditions(self, torques: Iterable[float], positions: int) -> Conditions:
        """Conditions of the analyses at given torques and a number of positions."""
        return Conditions(tuple(torques), positions, tuple(self.misalignments), self.flank)

    @property
    def loads(self) -> list[float]:
        """Magnitudes of the torques, increasing [N m]."""
        return [abs(self.torques[k]) for k in self.order()]

    @property
    def paths(self) -> list[str]:
        """Paths of the variables, then of other modifications with tolerances."""
        return [*self.vary, *(path for path in self.tolerances if path not in self.vary)]


def _bounds_problem(path: str, bounds: Any) -> Message | None:
    """Problem of the bounds of a variable [m]."""
    where = f"vary of {path}"
    if np.shape(bounds) != (2,):
        return Message(where, "is not a range", repr(bounds), "two numbers", "give lower and upper bound")
    for bound in bounds:
        wrong = number_problem(where, bound, lambda _: True, "finite, in m", "give lower and upper bound")
        if wrong is not None:
            return wrong
    if bounds[0] < bounds[1]:
        return None
    words = "the lower bound below the upper bound"
    return Message(where, "is not a range", f"{bounds[0]:g} to {bounds[1]:g} m", words, "exchange the bounds")
