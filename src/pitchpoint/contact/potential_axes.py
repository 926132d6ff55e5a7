# SPDX-License-Identifier: Apache-2.0
"""Axes of the table of the elastic potential: points, cubic splines through them, blocks for the kernel.

Given slopes double the resolution of an axis: the value at the middle of two points is that of the cubic with
the given values and slopes at both, and the spline interpolates at points and middles. For a kink of the
force between two points the error of this local cubic does not reach the neighbouring cells.

Source: C. de Boor, A Practical Guide to Splines, Springer (2001), chapters IV and IX.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.potential_table import (
    BUCKETS,
    CELLS,
    COEFFICIENTS,
    EDGES,
    HIGH,
    LOW,
    POINTS,
    SCALE,
)
from pitchpoint.contact.stiffness.description import frozen_array, refuse

FloatArray = NDArray[np.float64]

MOST_POINTS = 512
"""Largest number of points of an axis."""
UNEVEN = 1e6
"""Largest ratio of two steps of an axis; the interpolation would become singular."""
_FEWEST = 4
"""Smallest number of interpolated points of a cubic spline."""


@dataclass(frozen=True, eq=False)
class TableAxis:
    """One axis of the table.

    Parameters
    ----------
    name
        Name for messages.
    points
        Tabulated points, increasing, shape (n,).
    doubled
        Whether slopes are given and double the resolution; a function of one point is linear with its slope,
        and constant without it.
    period
        Period, 0 for none; a periodic axis begins at 0.
    tolerance
        Distance from a single point up to which the table is valid.

    Examples
    --------
    >>> axis = TableAxis("approach", np.linspace(0.0, 1.0, 5))
    >>> c = axis.values_operator @ axis.points**3  # B-spline coefficients of a cubic
    >>> axis.n_coefficients, bool(np.isclose(axis.spline(c)(0.3), 0.027))
    (5, True)
    """

    name: str
    points: FloatArray
    doubled: bool = False
    period: float = 0.0
    tolerance: float = 0.0

    def __post_init__(self) -> None:
        """Check the points."""
        where = f"axis.{self.name}"
        points = frozen_array(where, self.points, 1)
        object.__setattr__(self, "points", points)
        count, steps = len(points), np.diff(points)
        if count > MOST_POINTS:
            words, limit = "is too large a number of points", f"<= {MOST_POINTS}"
            raise refuse(where, words, count, limit, "use a coarser axis")
        if np.any(steps <= 0.0):
            k = int(np.argmax(steps <= 0.0))
            pair = f"{points[k]:.6g}, {points[k + 1]:.6g}"
            raise refuse(where, "do not increase", pair, "increasing points", "sort them")
        if count > 1 and steps.max() > UNEVEN * steps.min():
            pair = f"{steps.min():.6g} and {steps.max():.6g}"
            raise refuse(where, "are too uneven as steps", pair, f"1:{UNEVEN:g}", "spread the points")
        if self.period and (points[0] != 0.0 or points[-1] >= self.period):
            pair, limit = f"{points[0]:.6g} to {points[-1]:.6g}", f"0 to below {self.period:g}"
            raise refuse(where, "is not one period", pair, limit, "shift the points")
        if not (self.tolerance >= 0.0 and np.isfinite(self.tolerance)):
            raise refuse(where, "is not a tolerance", self.tolerance, ">= 0", "give a distance")
        if (count > 1 or self.period) and len(self.refined) < _FEWEST:
            fewest = "1 without a period, >= 3 with slopes, >= 4 without"
            raise refuse(where, "is too small a number of points", count, fewest, "add points")

    @property
    def count(self) -> int:
        """Number of tabulated points."""
        return len(self.points)

    @property
    def size(self) -> int:
        """Number of coefficients without the repeated ones of a periodic axis."""
        return len(self.refined) + (self.count == 1 and self.doubled)

    @property
    def closed(self) -> FloatArray:
        """Tabulated points; of a periodic axis with the end of the period, shape (n,) or (n + 1,)."""
        return np.append(self.points, self.period) if self.period else self.points

    @property
    def refined(self) -> FloatArray:
        """Points of interpolation, without the end of a period, shape (m,)."""
        if not self.doubled or self.count == 1:
            return self.points
        ends = self.closed
        every = np.empty(2 * len(ends) - 1)
        every[::2], every[1::2] = ends, 0.5 * (ends[1:] + ends[:-1])
        return every[: 2 * self.count] if self.period else every

    @cached_property
    def _cardinal(self) -> Any:
        """Splines that are 1 at one interpolated point and 0 at the others."""
        return _through(self.refined, np.eye(len(self.refined)), self.period)

    @cached_property
    def n_coefficients(self) -> int:
        """Number of B-spline coefficients; of a periodic axis the first three are repeated at the end."""
        return self.size if self.count == 1 else len(self._cardinal.c)

    @cached_property
    def values_operator(self) -> FloatArray:
        """Coefficients of the spline through values at the points, shape (n_coefficients, n)."""
        if self.count == 1:
            return np.eye(self.size, 1)
        unit = np.eye(self.count)
        if not self.doubled:
            return np.array(self._cardinal.c)
        return np.array(self._cardinal.c) @ _through(self.points, unit, self.period)(self.refined)

    @cached_property
    def slopes_operators(self) -> tuple[FloatArray, FloatArray]:
        """Coefficients from values and from slopes at the points, both of shape (n_coefficients, n).

        The value at the middle is (f0 + f1)/2 + h (f0' - f1')/8.
        """
        if self.count == 1:
            return np.eye(self.size, 1), np.eye(self.size, 1, -1)
        if not self.doubled:
            return self.values_operator, np.zeros((self.n_coefficients, self.count))
        size = len(self.refined)
        value, slope = np.zeros((2, size, self.count))
        steps = np.diff(self.closed)
        for k in range(size):
            left, right = k // 2, (k // 2 + 1) % self.count
            if k % 2 == 0:
                value[k, left] = 1.0
            else:
                value[k, [left, right]] = 0.5
                slope[k, left], slope[k, right] = steps[left] / 8.0, -steps[left] / 8.0
        return np.array(self._cardinal.c) @ value, np.array(self._cardinal.c) @ slope

    def spline(self, coefficients: FloatArray) -> Any:
        """Spline of given coefficients along the first axis, shape (n_coefficients, ...), for single axes."""
        from scipy.interpolate import BSpline

        return BSpline(self._cardinal.t, coefficients, 3)

    @cached_property
    def edges(self) -> FloatArray:
        """Edges of the cells, in which the spline is one cubic, shape (n_coefficients - 2,)."""
        return np.array([]) if self.count == 1 else np.array(self._cardinal.t[3:-3])

    @property
    def range(self) -> tuple[float, float]:
        """Lowest and highest tabulated place."""
        if self.count == 1:
            return float(self.points[0]) - self.tolerance, float(self.points[0]) + self.tolerance
        return float(self.edges[0]), float(self.edges[-1])

    @cached_property
    def block(self) -> FloatArray:
        """Block for the kernel, see `contact.potential_table`, shape (k,)."""
        head = np.zeros(EDGES)
        head[COEFFICIENTS], head[POINTS] = self.n_coefficients, len(self.closed)
        head[LOW], head[HIGH] = self.range
        if self.count == 1:
            return np.concatenate([head, [0.0], self.points])
        cells = len(self.edges) - 1
        width = (head[HIGH] - head[LOW]) / cells
        head[CELLS] = head[BUCKETS] = cells
        head[SCALE] = 1.0 / width
        starts = head[LOW] + width * np.arange(cells)
        first = np.clip(np.searchsorted(self.edges, starts, side="right") - 1, 0, cells - 1)
        return np.concatenate([head, self.edges, first, self._pieces().ravel(), self.closed])

    def _pieces(self) -> FloatArray:
        """The four B-splines of each cell in powers of the distance from its left edge, (cells, 4, 4)."""
        from scipy.interpolate import BSpline

        every = BSpline(self._cardinal.t, np.eye(self.n_coefficients), 3)
        left = self.edges[:-1]
        powers = [every(left, nu) / math.factorial(nu) for nu in range(4)]
        return np.array([[power[k, k : k + 4] for power in powers] for k in range(len(left))])


def _through(points: FloatArray, values: FloatArray, period: float) -> Any:
    """Cubic spline through values along the first axis, periodic or with the not-a-knot condition."""
    from scipy.interpolate import make_interp_spline

    if period:
        ends, closed = np.append(points, period), np.concatenate([values, values[:1]])
        return make_interp_spline(ends, closed, k=3, axis=0, bc_type="periodic")
    if len(points) < _FEWEST:  # fewer points than a cubic needs: a polynomial of lower degree
        from scipy.interpolate import BarycentricInterpolator

        return BarycentricInterpolator(points, values)
    return make_interp_spline(points, values, k=3, axis=0)
