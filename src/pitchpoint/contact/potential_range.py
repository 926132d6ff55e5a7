# SPDX-License-Identifier: Apache-2.0
"""Range and axes of the table of the elastic potential.

The points of the mesh phase are dense where tooth pairs enter and leave contact: there the force has kinks,
and their position depends on load and misalignment. The density follows second differences of the force in a
preliminary scan. All other axes are fixed by range and size.

Derivation: docs/theory/stiffness.md, "Pre-computed flank contact".
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.potential_axes import MOST_POINTS, TableAxis
from pitchpoint.contact.stiffness.description import refuse

FloatArray = NDArray[np.float64]

SCAN = 4
"""Phases of the preliminary scan per point of the phase axis."""
APPROACHES = 6
"""Approaches of the preliminary scan."""
_SCAN_MISALIGNMENT = 0.6
"""Share of the largest misalignment at which the preliminary scan meets the ends of the centre distance."""
_EVEN = 0.5
"""Weight of equal steps in the density of the phase axis."""
_GRADING = 1.25
"""Power of the spacing of misalignments: denser about zero, where contact over the whole width begins."""


@dataclass(frozen=True)
class TableRange:
    """Range of a table.

    Parameters
    ----------
    approach
        Lowest approach at which any teeth touch, and highest approach [m].
    misalignment
        Largest absolute misalignment [rad]; 0: fixed at zero.
    centre_distance
        Smallest and largest centre distance [m]; equal: fixed.
    tolerances
        Largest deviations from a fixed misalignment [rad] and centre distance [m]; the table is linear there.
    """

    approach: tuple[float, float]
    misalignment: float = 0.0
    centre_distance: tuple[float, float] = (0.0, 0.0)
    tolerances: tuple[float, float] = (0.0, 0.0)

    def __post_init__(self) -> None:
        """Check the numbers."""
        numbers = (*self.approach, self.misalignment, *self.centre_distance, *self.tolerances)
        if any(isinstance(n, bool) or not math.isfinite(n) for n in numbers):
            raise refuse("range", "are not numbers", numbers, "finite numbers", "give SI values")
        if not self.approach[0] < self.approach[1]:
            raise refuse("range.approach", "does not increase", self.approach, "low < high", "swap the ends")
        if not self.centre_distance[0] <= self.centre_distance[1]:
            where, pair = "range.centre_distance", self.centre_distance
            raise refuse(where, "decreases", pair, "low <= high", "swap the ends")
        lowest = min(self.misalignment, *self.tolerances)
        if lowest < 0.0:
            raise refuse("range", "is negative", lowest, ">= 0", "give absolute values")


@dataclass(frozen=True)
class TableSize:
    """Number of points of the axes; misalignment and centre distance have one point if fixed."""

    phase: int = 64
    approach: int = 24
    misalignment: int = 9
    centre_distance: int = 5

    def __post_init__(self) -> None:
        """Check the numbers."""
        for name, fewest in (("phase", 4), ("approach", 4), ("misalignment", 3), ("centre_distance", 3)):
            count = getattr(self, name)
            if isinstance(count, bool) or not isinstance(count, int) or not fewest <= count <= MOST_POINTS:
                limit = f"{fewest} to {MOST_POINTS}"
                raise refuse(f"size.{name}", "is not a number of points", count, limit, "change it")


def fixed_axes(span: TableRange, size: TableSize) -> tuple[TableAxis, TableAxis, TableAxis]:
    """Axes of approach, misalignment and centre distance.

    Approaches have equal steps, the first one step below the lowest contact; misalignments are symmetric.

    Parameters
    ----------
    span, size
        Range and size of the table.

    Examples
    --------
    >>> x, kappa, a = fixed_axes(TableRange((0.0, 3e-5), 1e-3), TableSize(approach=5))
    >>> [round(float(1e6 * p)) for p in x.points], kappa.count, a.count
    ([-10, 0, 10, 20, 30], 9, 1)
    """
    (low, high), (near, far) = span.approach, span.centre_distance
    step = (high - low) / (size.approach - 2)
    x = TableAxis("approach", high - step * np.arange(size.approach, dtype=np.float64)[::-1])
    kappa = TableAxis("misalignment", np.zeros(1), True, tolerance=span.tolerances[0])
    if span.misalignment:
        u = np.linspace(-1.0, 1.0, size.misalignment)
        kappa = TableAxis("misalignment", span.misalignment * np.sign(u) * np.abs(u) ** _GRADING, True)
    if near == far:
        return x, kappa, TableAxis("centre_distance", np.array([near]), True, tolerance=span.tolerances[1])
    return x, kappa, TableAxis("centre_distance", np.linspace(near, far, size.centre_distance), True)


def scan_states(span: TableRange, size: TableSize) -> FloatArray:
    """States of the preliminary scan, lines along the approach, shape (n, APPROACHES, 4).

    Parameters
    ----------
    span, size
        Range and size of the table.

    Examples
    --------
    >>> scan_states(TableRange((0.0, 3e-5), 1e-3), TableSize()).shape  # 256 phases, 3 misalignments
    (768, 6, 4)
    """
    phases = np.arange(SCAN * size.phase) / (SCAN * size.phase)
    approaches = np.linspace(*span.approach, APPROACHES + 1)[1:]
    share, phase, approach = np.meshgrid([-1.0, 0.0, 1.0], phases, approaches, indexing="ij")
    near, far = span.centre_distance
    centre = 0.5 * (near + far) + 0.5 * (far - near) * share
    kappa = _SCAN_MISALIGNMENT * span.misalignment * share
    return np.stack([phase, approach, kappa, centre], -1).reshape(-1, APPROACHES, 4)


def phase_axis(forces: FloatArray, count: int) -> TableAxis:
    """Axis of the mesh phase from the forces of the preliminary scan.

    A kink of the force over the phase costs an error in proportion to the step; the sum of squares is
    smallest for a density as the fourth root of the mean square of the kinks.

    Parameters
    ----------
    forces
        Forces at the scanned states, shape (n, APPROACHES).
    count
        Number of points.

    Examples
    --------
    >>> [round(float(s), 12) for s in phase_axis(np.ones((16, APPROACHES)), 4).points]
    [0.0, 0.25, 0.5, 0.75]
    """
    scanned = forces.reshape(-1, SCAN * count, APPROACHES)
    kinks = np.roll(scanned, -1, 1) - 2.0 * scanned + np.roll(scanned, 1, 1)
    density = np.mean(kinks**2, axis=(0, 2)) ** 0.25
    for _ in range(8):  # kinks between the scanned states
        density = (np.roll(density, 1) + density + np.roll(density, -1)) / 3.0
    density += _EVEN * np.mean(density) + 1e-300
    sums = np.concatenate([[0.0], np.cumsum(0.5 * (density + np.roll(density, -1)))])
    shares = np.arange(count) / count
    return TableAxis("phase", np.interp(shares, sums / sums[-1], np.linspace(0.0, 1.0, len(sums))), True, 1.0)
