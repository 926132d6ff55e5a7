# SPDX-License-Identifier: Apache-2.0
"""Closest points of the profiles of a flank to the flank of the mate.

Derivation: docs/theory/geometry.md, "Distance of two flanks".
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.geometry.flank_distance import Facing, Gap, flank_distance
from pitchpoint.geometry.flank_surface import space_vectors

FloatArray = NDArray[np.float64]

SAMPLES = 81
"""Points along a profile from which the search of its closest point starts."""
RESOLUTION = 1e-12
"""Accuracy of the length of roll of a closest point [m]."""
_DIFFERENCE = 1e-8
"""Step of differences along a profile [m]."""
_STEPS = 60
"""Maximum number of steps of a search."""


def closest_points(facing: Facing, z: ArrayLike) -> Gap:
    """Closest point of each transverse profile of a flank to the flank of the mate.

    Parameters
    ----------
    facing
        The flanks and their relative position.
    z
        Positions of the profiles along the face width of `own` [m], shape (n,).

    Returns
    -------
    Gap
        Smallest distances of points of the usable flank whose nearest points are on that of the mate, shape
        (n,); NaN where there are none. Lengths of roll are accurate to `RESOLUTION`.

    Notes
    -----
    Newton's method for the slope of the distance, starting at the closest of `SAMPLES` points and with
    bisection of the interval, so that it converges at the start of a relief, too, there to 10 nm. An edge of
    the mate is the closest point of a profile of the mate: see `Facing.swapped`.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.flank_distance import Mounting
    >>> from pitchpoint.geometry.flank_surface import Flank
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> gear = CylindricalGear(z=30, m_n=2e-3, thickness_allowance=-40e-6)
    >>> pair = GearPair(gear, gear, 0.06)
    >>> one, two = Flank(gear=gear), Flank(gear=gear, tooth=-1)
    >>> found = closest_points(Facing(mounting=Mounting(pair=pair), own=one, mate=two), [0.0])
    >>> bool(abs(found.distance[0] - 0.5 * pair.j_bn) < 1e-15)
    True
    """
    z = np.atleast_1d(np.asarray(z, dtype=float))
    span = np.linspace(*facing.own.span, SAMPLES)
    found = flank_distance(facing, span[:, None], z[None, :])
    heights = np.where(facing.mate.covers(found.mate_roll, found.mate_z), found.distance, np.inf)
    k = np.argmin(heights, axis=0)
    some = np.isfinite(np.take_along_axis(heights, k[None], axis=0)[0])
    roll = span[k]
    if some.any():
        low, high = span[np.maximum(k - 1, 0)], span[np.minimum(k + 1, SAMPLES - 1)]
        roll[some] = _least(facing, low[some], roll[some], high[some], z[some])
    result = flank_distance(facing, roll, z)
    return Gap(np.where(some, result.distance, np.nan), roll, z, result.mate_roll, result.mate_z)


def _least(facing: Facing, low: FloatArray, start: FloatArray, high: FloatArray, z: FloatArray) -> FloatArray:
    """Length of roll of the least distance between two bounds, with a nearest point on the mate [m]."""
    best = _flat(facing, low, start, high, z)
    outside = ~_fits(facing, best, z)
    if outside.any():
        best[outside] = _last_on_the_mate(facing, start[outside], best[outside], z[outside])
    return best


def _flat(facing: Facing, low: FloatArray, start: FloatArray, high: FloatArray, z: FloatArray) -> FloatArray:
    """Length of roll at which the slope is zero, or the bound towards which the distance decreases [m]."""
    here, h, last = start, _DIFFERENCE, high - low
    for _ in range(_STEPS):
        slope = _slope(facing, here, z)
        low, high = np.where(slope < 0.0, here, low), np.where(slope > 0.0, here, high)
        curvature = (_slope(facing, here + h, z) - _slope(facing, here - h, z)) / (2.0 * h)
        guess = here - slope / np.where(curvature > 0.0, curvature, np.inf)
        newton = (curvature > 0.0) & (guess >= low) & (guess <= high) & (2.0 * np.abs(guess - here) < last)
        after = np.where(slope == 0.0, here, np.where(newton, guess, 0.5 * (low + high)))
        last = np.abs(after - here)
        here = after
        if float(last.max()) < RESOLUTION:
            break
    return here


def _slope(facing: Facing, roll: FloatArray, z: FloatArray) -> FloatArray:
    """Derivative of the distance by the length of roll; that of the micro-geometry by differences."""
    own, mate = facing.own, facing.mate
    beta_b, r_b = own.gear.beta_b, abs(own.gear.r_b)
    points, normals = own.points(roll, z)
    gap = own.gap(roll, z)
    there = facing.mounting.transfer(points - gap[..., None] * normals, facing.gear)
    # along a profile a point moves away from the axis by roll/r_b, and its normal turns about the axis
    outwards = -1j * own.hand * (normals[..., 0] + 1j * normals[..., 1]) / math.cos(beta_b)
    rate = (roll - gap * own.gear.sign * math.cos(beta_b)) / r_b
    step = space_vectors(outwards * rate, np.zeros(z.shape))
    facing_normals = mate.normals_at(there)
    slope = np.sum(facing_normals * facing.mounting.transfer(step, facing.gear, free=True), axis=-1)
    if own.is_ideal and mate.is_ideal:
        return np.asarray(slope)
    turned = facing.mounting.transfer(normals, facing.gear, free=True)
    lean = np.sum(facing_normals * turned, axis=-1)
    h = _DIFFERENCE
    grown = own.gap(roll + h, z) - own.gap(roll - h, z)
    opened = _mate_gap(facing, roll + h, z) - _mate_gap(facing, roll - h, z)
    return np.asarray(slope + (opened - lean * grown) / (2.0 * h))


def _mate_gap(facing: Facing, roll: FloatArray, z: FloatArray) -> FloatArray:
    found = flank_distance(facing, roll, z)
    return facing.mate.gap(found.mate_roll, found.mate_z)


def _fits(facing: Facing, roll: FloatArray, z: FloatArray) -> NDArray[np.bool_]:
    """Whether the nearest points are on the usable flank of the mate."""
    found = flank_distance(facing, roll, z)
    return facing.mate.covers(found.mate_roll, found.mate_z)


def _last_on_the_mate(facing: Facing, inside: FloatArray, outside: FloatArray, z: FloatArray) -> FloatArray:
    """Length of roll between two points at which the nearest point leaves the mate [m]."""
    for _ in range(_STEPS):
        middle = 0.5 * (inside + outside)
        good = _fits(facing, middle, z)
        inside, outside = np.where(good, middle, inside), np.where(good, outside, middle)
        if float(np.abs(outside - inside).max()) < RESOLUTION:
            break
    return inside
