# SPDX-License-Identifier: Apache-2.0
"""How deep a rolling element drops into a spall, and over which distance.

Derivation: docs/theory/contacts.md, "Rolling elements".
"""

from __future__ import annotations

import math


def spall_drop(length: float, depth: float, element_radius: float, race_radius: float) -> tuple[float, float]:
    """Drop of a rolling element into a spall, and the distance over which it goes down at either edge.

    Parameters
    ----------
    length
        Extent of the spall along the rolling direction [m], below twice the smaller radius.
    depth
        Depth of its floor [m].
    element_radius
        Radius R of the rolling element [m].
    race_radius
        Radius r of the race along the rolling direction [m]: > 0 for an inner race, < 0 for an outer one.

    Returns
    -------
    drop : float
        How much nearer both races come at the middle of the spall without a change of force [m].
    ramp : float
        Distance from either edge at which that drop is reached [m], at most half of the length.

    Notes
    -----
    An element whose surface spans the spall rests on both edges; it has then dropped by
    R - sqrt(R^2 - l^2/4) + r - sqrt(r^2 - l^2/4) (r < 0: less the same of an outer race), near
    (1/R + 1/r) l^2/8. It reaches a floor that is less deep over the distance sqrt(2 drop/(1/R + 1/r)) from
    the edge on which it rolls off. Rigid edges; the loads carry on as on a whole race.

    Examples
    --------
    A ball of 10 mm spans a pit of 1 mm in a plane race and drops by 25 um, however deep the pit is:

    >>> drop, ramp = spall_drop(1e-3, 0.5e-3, 5e-3, 1e9)
    >>> round(drop * 1e6, 3), round(ramp * 1e3, 4)
    (25.063, 0.5)
    """
    if length <= 0.0 or depth <= 0.0:
        return 0.0, 0.0
    half = 0.5 * length
    spanned = _sagitta(half, element_radius) + _sagitta(half, race_radius)
    drop = min(depth, spanned)
    return drop, min(half, math.sqrt(2.0 * drop / (1.0 / element_radius + 1.0 / race_radius)))


def _sagitta(half: float, radius: float) -> float:
    """Height of an arc over its chord, with the sign of the radius; free of cancellation."""
    root = math.sqrt(max(radius * radius - half * half, 0.0))
    return math.copysign(half * half / (abs(radius) + root), radius)
