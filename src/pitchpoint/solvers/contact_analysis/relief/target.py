# SPDX-License-Identifier: Apache-2.0
"""Target of relief design: peak-to-peak transmission error over torques, tolerances and misalignments."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.solvers.contact_analysis.relief.curves import Curves

Array = NDArray[np.float64]

MICRO = 1e-6
"""Unit of the score [m]."""
PENALTY = 1e3
"""Score of a violation of limits by their own size."""
MAX_CORNERS = 4
"""Number of tolerances up to which all corners are analysed."""


@dataclass(frozen=True)
class Target:
    """What is minimised.

    Parameters
    ----------
    weights
        Weight of each torque, shape (torques,); the maximum is 1.
    mean
        Weighted mean over the torques instead of the weighted maximum.
    max_pressure
        Limit of the Hertzian pressure on the path of contact at the highest torque [Pa]; None: no limit.
    no_edge
        Whether tip edges must not carry load at the highest torque.
    """

    weights: Array
    mean: bool = False
    max_pressure: float | None = None
    no_edge: bool = False

    def factors(self) -> Array:
        """Factors of the peak-to-peak errors in the objective, shape (torques,)."""
        return self.weights / self.weights.sum() if self.mean else self.weights

    def objective(self, samples: Sequence[Curves]) -> float:
        """Worst value over samples of the tolerances and misalignments [m]."""
        values = np.array([curves.peak_to_peak for curves in samples]) * self.factors()
        return float((values.sum(axis=2) if self.mean else values.max(axis=2)).max())

    def excess(self, curves: Curves) -> Array:
        """Violations of the limits at the highest torque, positive if violated [-], shape (limits,)."""
        found = []
        if self.max_pressure is not None:
            found.append(curves.pressure[:, -1].ravel() / self.max_pressure - 1.0)
        if self.no_edge:
            found.append(curves.edge[:, -1].ravel())
        return np.concatenate(found) if found else np.zeros(0)

    def score(self, samples: Sequence[Curves]) -> float:
        """Objective [µm] with the largest violation of a limit added."""
        worst = max((float(self.excess(c).max(initial=0.0)) for c in samples), default=0.0)
        return self.objective(samples) / MICRO + PENALTY * worst


def tolerance_samples(tolerances: Sequence[float], count: int, seed: int) -> Array:
    """Deviations within tolerances at which a design is analysed.

    Parameters
    ----------
    tolerances
        Tolerance ± of each key [m]; 0: none.
    count
        Number of random samples, if there are more than `MAX_CORNERS` tolerances.
    seed
        Seed of these.

    Returns
    -------
    ndarray, shape (samples, keys)
        The first is zero. All corners for few tolerances; for more of them both ends of each, and random
        corners.

    Examples
    --------
    >>> tolerance_samples([0.0, 2.0, 1.0], 8, 0).tolist()
    [[0.0, 0.0, 0.0], [0.0, -2.0, -1.0], [0.0, -2.0, 1.0], [0.0, 2.0, -1.0], [0.0, 2.0, 1.0]]
    """
    wide = np.asarray(tolerances, dtype=np.float64)
    moving = np.flatnonzero(wide)
    nominal = np.zeros((1, wide.size))
    if moving.size == 0:
        return nominal
    if moving.size <= MAX_CORNERS:
        signs = np.array(list(itertools.product((-1.0, 1.0), repeat=moving.size)))
    else:
        rng = np.random.default_rng(seed)
        ends = np.concatenate([-np.eye(moving.size), np.eye(moving.size)])
        signs = np.concatenate([ends, rng.choice((-1.0, 1.0), size=(count, moving.size))])
    found = np.zeros((len(signs), wide.size))
    found[:, moving] = signs * wide[moving]
    return np.concatenate([nominal, found])
