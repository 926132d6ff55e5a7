# SPDX-License-Identifier: Apache-2.0
"""Drop of a rolling element into a spall, and its entry length.

Derivation: docs/theory/contacts.md, "Rolling elements".
"""

from __future__ import annotations

import math


def spall_drop(length: float, depth: float, element_radius: float, race_radius: float) -> tuple[float, float]:
    """Drop of a rolling element into a spall, and the length of its entry and exit ramps.

    Parameters
    ----------
    length
        Length of the spall in the rolling direction [m], less than twice the smaller radius.
    depth
        Depth of the spall [m].
    element_radius
        Radius R of the rolling element [m].
    race_radius
        Raceway radius r in the rolling direction [m]: > 0 for an inner race, < 0 for an outer race.

    Returns
    -------
    drop : float
        Approach of the races at the centre of the spall at constant load [m].
    ramp : float
        Distance from either edge at which the drop is reached [m], at most half the length.

    Notes
    -----
    An element that bridges a deep spall touches both edges; its drop is then
    R - sqrt(R^2 - l^2/4) + r - sqrt(r^2 - l^2/4) (for r < 0 the last two terms are subtracted with |r|),
    approximately (1/R + 1/r) l^2/8. In a shallower spall the element reaches the floor at the distance
    sqrt(2 drop/(1/R + 1/r)) from the edge. Rigid edges; the load is that on an undamaged race.

    Examples
    --------
    A 10 mm ball bridges a 1 mm pit in a flat race and drops by 25 um, independent of a larger depth:

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
    """Sagitta of an arc over a chord, with the sign of the radius; free of cancellation."""
    root = math.sqrt(max(radius * radius - half * half, 0.0))
    return math.copysign(half * half / (abs(radius) + root), radius)
