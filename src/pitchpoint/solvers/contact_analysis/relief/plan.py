# SPDX-License-Identifier: Apache-2.0
"""Plan of a relief design: variables, torques, tolerances, limits, effort."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.solvers.contact_analysis.load_checks import check_misalignment, checked_torques
from pitchpoint.solvers.contact_analysis.relief.analyses import Conditions
from pitchpoint.solvers.contact_analysis.relief.target import Target
from pitchpoint.solvers.contact_analysis.relief.variables import Variable

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
        checked_torques(self.torques)
        for angle in self.misalignments:
            check_misalignment(angle)
        for wrong, what in self._faults():
            if wrong:
                raise SolverError(f"relief design: {what}", INCONSISTENT)

    def _faults(self) -> list[tuple[bool, str]]:
        """Conditions that a plan must not meet, and what to do."""
        bounds = [v.high > v.low and math.isfinite(v.high - v.low) for v in self.variables]
        weights = np.ones(1) if self.weights is None else np.asarray(self.weights, dtype=np.float64)
        fitting = self.weights is None or len(self.weights) == len(self.torques)
        return [
            (not self.vary, "give at least one variable"),
            (not all(bounds), "the lower bound of a variable is not below its upper bound; exchange them"),
            (not fitting, "give one weight for each torque"),
            (
                not (np.isfinite(weights).all() and (weights >= 0.0).all() and weights.any()),
                "give weights >= 0",
            ),
            (
                not all(math.isfinite(t) and t >= 0.0 for t in self.tolerances.values()),
                "give tolerances >= 0",
            ),
            (self.positions < 8, "give at least 8 positions"),
            (self.analyses < LEAST_ANALYSES, f"give at least {LEAST_ANALYSES} analyses"),
        ]

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
