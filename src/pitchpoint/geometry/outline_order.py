# SPDX-License-Identifier: Apache-2.0
"""Checks of the order of the points of a real tooth: a path that neither runs back nor crosses itself.

Points, `index` and `part` as in `pitchpoint.geometry.outline_check`.

Derivation: docs/theory/geometry.md, "Generation by the tool".
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.geometry.outline_check import ComplexArray, IntArray, OutlineError

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

# Largest turn between successive segments. The sharpest corners of a real tooth, tip edges without chamfer,
# turn by up to 90 deg, a pointed tip by about 120 deg; a path that runs back along itself turns by 180 deg.
_MAX_TURN = math.radians(150.0)
# Distance between points, as a share of their extent (about 0.01 m_n for a tooth), below which the direction
# has no meaning: scatter of a measurement, or repeated points.
_SCATTER = 3e-3
_IN_ORDER = "put the points in order along the outline"


def check_path(plane: ComplexArray, index: IntArray, part: str) -> None:
    """Check that a path of points neither runs back along itself nor crosses itself.

    Parameters
    ----------
    plane
        Points in order, shape (n,) [m].
    index
        Numbers of the points in the input, shape (n,).
    part
        Name of the input.

    Raises
    ------
    OutlineError
        If the path turns by more than 150 deg between successive segments, or crosses itself. Points closer
        to the previous one than 0.3 % of the extent of the path are omitted: the direction of shorter
        segments is scatter.

    Examples
    --------
    >>> check_path(np.array([0.0, 1.0, 1.0 + 1j, 0.5 + 1j]), np.arange(4), "tooth")
    >>> check_path(np.array([0.0, 2.0, 1.0, 3.0]), np.arange(4), "tooth")  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    ...
    pitchpoint.geometry.outline_check.OutlineError: tooth[2]: 180 deg turn ...
    """
    if plane.size < 3:
        return
    apart = _SCATTER * float(np.abs(plane - plane[0]).max())
    kept = [0]
    for i, point in enumerate(plane.tolist()):
        if abs(point - plane[kept[-1]]) > apart:
            kept.append(i)
    plane, index = plane[kept], index[kept]
    step = np.diff(plane)
    turn = np.abs(np.angle(step[1:] * step[:-1].conj()))
    sharp = np.nonzero(turn > _MAX_TURN)[0]
    if sharp.size:
        raise OutlineError(
            part,
            int(index[sharp[0] + 2]),
            "turn before this point: the outline runs back along itself",
            value=f"{math.degrees(turn[sharp[0]]):.4g} deg",
            limit=f"{math.degrees(_MAX_TURN):g} deg",
            remedy=f"{_IN_ORDER}, and omit repeated parts of it",
        )
    at = _crossing(plane, plane.size - 1)
    if at is not None:
        raise OutlineError(part, int(index[at]), "crosses itself after this point", remedy=_IN_ORDER)


def check_simple(gear: CylindricalGear, plane: ComplexArray, index: IntArray | None, part: str) -> None:
    """Check that the outline crosses neither itself nor that of the next tooth.

    Parameters
    ----------
    gear
        External or internal gear, whose generated tooth is the nominal one.
    plane
        Points of one pitch, shape (n,) [m].
    index
        Numbers of the points in the input, shape (n,), or None.
    part
        Name of the input.

    Raises
    ------
    OutlineError
        If the outline crosses itself or that of the next tooth.
    """
    turn = np.exp(2j * math.pi / abs(gear.z))
    chain = np.concatenate([plane, plane * turn, plane[:1] * turn * turn])
    at = _crossing(chain, plane.size)
    if at is not None:
        raise OutlineError(
            part,
            None if index is None else int(index[at]),
            "crosses itself or the next tooth",
            remedy=_IN_ORDER,
        )


def _crossing(chain: ComplexArray, size: int) -> int | None:
    """First of the `size` first segments of a chain of points that crosses another one, or None."""
    a, b = chain[:-1], chain[1:]
    for first in range(0, size, 64):
        p, q = (side[first : first + 64][: size - first, None] for side in (a, b))
        apart = ((q - p).conj() * (a - p)).imag * ((q - p).conj() * (b - p)).imag < 0.0
        apart &= ((b - a).conj() * (p - a)).imag * ((b - a).conj() * (q - a)).imag < 0.0
        found = np.argwhere(apart)
        if found.size:
            return first + int(found[0, 0])
    return None
