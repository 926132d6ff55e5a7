# SPDX-License-Identifier: Apache-2.0
"""Pressure of a line contact with any gap in its section: two elastic half-planes, divided into strips.

Hertz requires a constant curvature within the contact. Where the curvature of a flank changes, as at the
start of a relief or of a tip rounding, the pressure is between those of both curvatures.

Source: K. L. Johnson, *Contact Mechanics* (1985), 2.7 and 5.9.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import GeometryError, SolverError
from pitchpoint.core.status import SLOW

FloatArray = NDArray[np.float64]

STRIPS = 240
"""Number of strips over the range of a stepped gap."""
RANGE = 1.5
"""Half of this range in half widths of the smallest curvature; the contact moves towards it by a tenth."""
_STEPS = 100
"""Maximum number of changes of the strips in contact; ten are usual."""


@dataclass(frozen=True)
class StripPressure:
    """Pressure over the section of a line contact.

    Attributes
    ----------
    x
        Middles of the strips [m], shape (n,).
    pressure
        Pressure [Pa], shape (n,); zero without contact.
    """

    x: FloatArray
    pressure: FloatArray

    @property
    def maximum(self) -> float:
        """Maximum pressure [Pa]."""
        return float(self.pressure.max())


@cache
def _influence(n: int) -> FloatArray:
    """Displacements of n strips of width 1 by a unit pressure on each, times pi/2 compliance; shape (n, n).

    Minus the integral of ln |x - s| over a strip.
    """
    distance = np.abs(np.arange(n) - 0.5)[:, None] * np.ones(2) + np.array([0.0, 1.0])
    distance[0] = 0.5, 0.5
    sign = np.ones((n, 2))
    sign[0, 0] = -1.0
    part = sign * distance * (np.log(distance) - 1.0)
    by_distance = part[:, 1] - part[:, 0]
    index = np.abs(np.arange(n)[:, None] - np.arange(n)[None, :])
    return np.asarray(-by_distance[index])


def strip_pressure(x: ArrayLike, gap: ArrayLike, load: float, compliance: float) -> StripPressure:
    """Pressure of two elastic half-planes in contact along a line.

    Parameters
    ----------
    x
        Equidistant middles of the strips across the contact line [m], shape (n,).
    gap
        Gap of both surfaces without load [m], shape (n,).
    load
        Normal force per length of the contact line q [N/m], > 0.
    compliance
        Sum of (1 - nu^2)/E of both bodies [1/Pa].

    Returns
    -------
    StripPressure
        Constant pressure in each strip.

    Raises
    ------
    GeometryError
        If the contact reaches the ends of the range.
    SolverError
        If the strips in contact still change after `_STEPS` steps.

    Notes
    -----
    Displacement by the pressure p: u(x) = -(2/pi) compliance ∫ p(s) ln |x - s| ds (Johnson 1985, 2.7). In
    contact gap + u = approach and p >= 0, elsewhere p = 0 and gap + u >= approach; Σ p dx = q. The strips in
    contact are found by removing those in tension and adding those that overlap.

    Examples
    --------
    A cylinder of 8 mm on a plane, 500 N/mm; Hertz: 2 q/(pi b_H), b_H = sqrt(4 q R compliance/pi):

    >>> x = (np.arange(400) - 199.5) * 2e-6
    >>> found = strip_pressure(x, x**2 / (2.0 * 8e-3), 5e5, 2.0 * 0.91 / 206e9)
    >>> round(found.maximum / 1e6, 0), round(math.sqrt(5e5 * 206e9 / (2.0 * 0.91 * math.pi * 8e-3)) / 1e6, 0)
    (1501.0, 1501.0)
    """
    places, gaps = np.asarray(x, dtype=np.float64), np.asarray(gap, dtype=np.float64)
    n, width = places.size, float(places[1] - places[0])
    A = (2.0 * compliance / math.pi * width) * _influence(n)
    active = gaps < gaps.min() + 0.5 * float(np.ptp(gaps))
    p = np.zeros(n)
    for _ in range(_STEPS):
        on = np.flatnonzero(active)
        m = on.size
        system = np.ones((m + 1, m + 1))
        system[:m, :m] = A[np.ix_(on, on)]
        system[:m, m] = -1.0
        system[m, m] = 0.0
        found = np.linalg.solve(system, np.append(-gaps[on], load / width))
        p[:] = 0.0
        p[on], approach = found[:m], float(found[m])
        pulled = p < 0.0
        if pulled.any():
            active &= ~pulled
            continue
        overlapping = ~active & (gaps + A @ p < approach)
        if not overlapping.any():
            break
        active |= overlapping
    else:
        raise SolverError(f"the strips in contact still change after {_STEPS} steps", SLOW)
    if active[0] or active[-1]:
        raise GeometryError(
            "is too small for the contact",
            where="range of strips",
            value=f"{1e3 * n * width:.4g} mm",
            limit="wider than the contact",
            remedy="extend it on both sides",
        )
    return StripPressure(x=places, pressure=p)


def least_curvature(curvature: ArrayLike, places: ArrayLike, steps: ArrayLike) -> FloatArray:
    """Smallest curvature of sections with steps of it.

    Parameters
    ----------
    curvature
        Curvature at the contact points [1/m], shape (n,).
    places, steps
        Places [m] and additional curvatures [1/m] as for `stepped_pressure`, shape (steps, n).

    Returns
    -------
    ndarray, shape (n,)
        [1/m]; steps on the same side of the contact point add up.

    Examples
    --------
    >>> least_curvature([500.0], [[1e-5], [2e-5], [-1e-5]], [[-100.0], [-200.0], [-250.0]])
    array([200.])
    """
    at, more = np.asarray(places, dtype=np.float64), np.asarray(steps, dtype=np.float64)
    order = np.argsort(np.abs(at), axis=0, kind="stable")
    at, more = np.take_along_axis(at, order, axis=0), np.take_along_axis(more, order, axis=0)
    least = np.zeros(at.shape[1:])
    for ahead in (False, True):
        there = np.where(np.signbit(at) == ahead, more, 0.0)
        least = np.minimum(least, np.cumsum(there, axis=0).min(axis=0, initial=0.0))
    return np.asarray(curvature, dtype=np.float64) + least


def stepped_pressure(
    curvature: float, steps: Sequence[tuple[float, float]], load: float, compliance: float
) -> StripPressure:
    """Pressure of a contact with steps of curvature.

    Parameters
    ----------
    curvature
        Sum of the curvatures of both surfaces at the contact point, 1/R [1/m], > 0.
    steps
        Places [m] and additional curvatures [1/m]: it applies beyond the place, away from the contact point;
        at 0 and −0 on the positive and negative side.
    load
        Normal force per length of the contact line q [N/m], > 0.
    compliance
        Sum of (1 - nu^2)/E of both bodies [1/Pa].

    Returns
    -------
    StripPressure
        Over a range of `RANGE` half widths of the smallest curvature on both sides.

    Raises
    ------
    GeometryError
        If a curvature is not positive.

    Notes
    -----
    The contact point, x = 0, is that of the unloaded surfaces. Sums of the parabolas of all curvatures, each
    from its place (Johnson 1985, 5.9).

    Examples
    --------
    Curvature 2.08/mm on one side and 10/mm more on the other, 100 N/mm; Hertz with the larger: 6597 MPa:

    >>> found = stepped_pressure(2080.0, [(0.0, 1e4)], 1e5, 2.0 * 0.91 / 206e9)
    >>> round(found.maximum / 1e6)
    4855
    """
    places, more = np.array(steps, dtype=np.float64).reshape(-1, 2).T[..., None]
    least = float(least_curvature([curvature], places, more)[0])
    if not least > 0.0:
        raise GeometryError(
            "is not convex",
            where="curvature",
            value=f"{least:.6g} 1/m",
            limit="> 0",
            remedy="use line_approach",
        )
    half = RANGE * math.sqrt(4.0 * load * compliance / (math.pi * least))
    x = (np.arange(STRIPS) + 0.5) * (2.0 * half / STRIPS) - half
    gap = 0.5 * curvature * x * x
    for place, added in steps:
        beyond = np.maximum(math.copysign(1.0, place) * (x - place), 0.0)
        gap += 0.5 * added * beyond * beyond
    return strip_pressure(x, gap, load, compliance)
