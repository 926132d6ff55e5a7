# SPDX-License-Identifier: Apache-2.0
"""Pits and spalls: elliptic hollows in a flank, given individually or as a random pattern.

Derivation: docs/theory/geometry.md, "Micro-geometry, deviations, damage".
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import Message
from pitchpoint.geometry.modifications import base_tangent, flank_range, roll_length, size_problems

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

FloatArray = NDArray[np.float64]

CELLS = 8
"""Grid cells across the shortest patch in either direction."""

FINEST = (64, 128)
"""Largest ratio of face width, and of roll length of the flank, to the size of a patch."""

_FIT = 1e-9


@dataclass(frozen=True, kw_only=True)
class Patch:
    """One hollow with an elliptic edge, deepest at its centre.

    Parameters
    ----------
    position
        Position of the centre along the face width [m], from z = −b/2.
    diameter
        Diameter at the centre on the flank [m], positive.
    length
        Axis of the ellipse along the face width [m].
    height
        Axis of the ellipse along the profile, measured radially [m].
    depth
        Depth at the centre, normal to the flank [m].
    """

    position: float
    diameter: float
    length: float
    height: float
    depth: float


def _rolls(patch: Patch, gear: CylindricalGear) -> float:
    """Roll length covered by a patch [m]: its height times dL/dr = r/L."""
    L = max(float(roll_length(gear, patch.diameter)), 1e-3 * abs(gear.d))
    return patch.height * 0.5 * patch.diameter / L


def patch_problems(patch: Patch, gear: CylindricalGear, where: str = "") -> list[Message]:
    """Problems of a patch that does not fit the flank of a gear or the finest grid.

    Parameters
    ----------
    patch
        The patch.
    gear
        External or internal gear.
    where
        Path of the patch in the model, prefix of the key in each message.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=50, m_n=3e-3, b=0.02)
    >>> tiny = Patch(position=0.01, diameter=0.15, length=1e-4, height=1e-3, depth=1e-4)
    >>> print(patch_problems(tiny, gear)[0])
    length: 0.1 mm is too short for the finest grid (limit 0.3125 mm, 1/64 of the face); enlarge it
    """
    place = f"{where}." if where else ""
    found = size_problems({f"{place}depth": patch.depth}, gear)
    low, high = sorted((abs(gear.d_Ff), abs(gear.d_Fa)))
    if not 0.0 <= patch.position <= gear.b * (1.0 + _FIT):
        found.append(_outside(f"{place}position", patch.position, 0.0, gear.b, "the face width"))
    if not low * (1.0 - _FIT) <= patch.diameter <= high * (1.0 + _FIT):
        found.append(_outside(f"{place}diameter", patch.diameter, low, high, "the usable flank"))
        return found
    if patch.length < gear.b / FINEST[0] * (1.0 - _FIT):
        found.append(_tiny(f"{place}length", patch.length, gear.b, FINEST[0], "the face"))
    root, tip = flank_range(gear)
    if _rolls(patch, gear) < abs(tip - root) / FINEST[1] * (1.0 - _FIT):
        whole = abs(tip - root) * patch.height / _rolls(patch, gear)
        found.append(_tiny(f"{place}height", patch.height, whole, FINEST[1], "the flank there"))
    return found


def _outside(where: str, value: float, low: float, high: float, of: str) -> Message:
    limit = f"{1e3 * low:.6g} to {1e3 * high:.6g} mm"
    return Message(
        where, f"lies outside {of}", f"{1e3 * value:.6g} mm", limit, "put the middle of the patch there"
    )


def _tiny(where: str, value: float, whole: float, parts: int, of: str) -> Message:
    limit = f"{1e3 * whole / parts:.6g} mm, 1/{parts} of {of}"
    return Message(where, "is too short for the finest grid", f"{1e3 * value:.6g} mm", limit, "enlarge it")


def stations(patches: Sequence[Patch], gear: CylindricalGear, least: tuple[int, int]) -> tuple[int, int]:
    """Numbers of grid stations over face width and roll length that resolve the shortest patch by `CELLS`.

    Parameters
    ----------
    patches
        All patches of the grid.
    gear
        External or internal gear.
    least
        Minimum numbers of stations.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=50, m_n=3e-3, b=0.02)
    >>> spall = Patch(position=0.01, diameter=0.15, length=2e-3, height=1e-3, depth=1e-4)
    >>> stations([spall], gear, (33, 129))
    (81, 129)
    """
    root, tip = flank_range(gear)
    n_z, n_x = least
    for patch in patches:
        n_z = max(n_z, math.ceil(CELLS * gear.b / patch.length - _FIT) + 1)
        n_x = max(n_x, math.ceil(CELLS * abs(tip - root) / _rolls(patch, gear) - _FIT) + 1)
    return n_z, n_x


def pit_level(
    gear: CylindricalGear, z: ArrayLike, roll: ArrayLike, patches: Sequence[Patch], severity: float = 1.0
) -> FloatArray:
    """Level function of all patches: where it is positive, the gap along the base tangent.

    Parameters
    ----------
    gear
        External or internal gear.
    z
        Positions along the face width [m], shape (n_z,), −b/2 to b/2.
    roll
        Roll lengths [m], shape (n_roll,).
    patches
        The patches.
    severity
        Scale s of both axes of every ellipse; the depth scales with s², the curvature at the bottom is kept.

    Returns
    -------
    ndarray, shape (n_z, n_roll)
        Maximum over all patches of depth (s² − ρ²)/cos β_b [m], with ρ = 1 on the ellipse.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=50, m_n=3e-3, b=0.02)
    >>> spall = Patch(position=0.01, diameter=gear.d, length=2e-3, height=1e-3, depth=1e-4)
    >>> level = pit_level(gear, [0.0, 0.5e-3, 1e-3], roll_length(gear, gear.d), [spall])
    >>> (1e6 * level[:, 0]).round(6).tolist()
    [100.0, 75.0, 0.0]
    """
    z = np.atleast_1d(np.asarray(z, dtype=float))
    radius = np.hypot(np.atleast_1d(np.asarray(roll, dtype=float)), 0.5 * gear.d_b)
    level = np.full((z.size, radius.size), -gear.m_n)
    for patch in patches:
        across = (z + 0.5 * gear.b - patch.position) / (0.5 * patch.length)
        along = (radius - 0.5 * patch.diameter) / (0.5 * patch.height)
        depth = float(base_tangent(patch.depth, gear))
        level = np.maximum(level, depth * (severity**2 - across[:, None] ** 2 - along[None, :] ** 2))
    return level


def random_patches(
    gear: CylindricalGear, *, number: int, seed: int, length: float, height: float, depth: float
) -> tuple[Patch, ...]:
    """Patches uniformly distributed over a flank, with sizes from half to all of the given ones.

    Parameters
    ----------
    gear
        External or internal gear.
    number
        Number of patches.
    seed
        Seed of the random number generator; the same seed gives the same patches.
    length, height, depth
        Maximum sizes [m].

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=50, m_n=3e-3, b=0.02)
    >>> size = dict(length=2e-3, height=1e-3, depth=1e-4)
    >>> first = random_patches(gear, number=5, seed=1, **size)
    >>> first == random_patches(gear, number=5, seed=1, **size), len(first)
    (True, 5)
    """
    rng = np.random.default_rng(seed)
    low, high = sorted((abs(gear.d_Ff), abs(gear.d_Fa)))
    drawn = rng.random((number, 3))
    return tuple(
        Patch(
            position=float(a * gear.b),
            diameter=float(low + b * (high - low)),
            length=float(length * (0.5 + 0.5 * c)),
            height=float(height * (0.5 + 0.5 * c)),
            depth=float(depth * (0.5 + 0.5 * c)),
        )
        for a, b, c in drawn
    )
