# SPDX-License-Identifier: Apache-2.0
"""Contact damping: how far it is switched on, and which rate acts.

A flank can only damp while it is in contact, and a damper that is fully on at zero penetration would pull or
hit like a step. So the rate fades in over the penetration s_0 (full damping at s_0), and compression and
decompression may have different rates.

Source: Mauer, SIMPACK User Meeting (2006).
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel


@kernel
def ramp(u, s_0):
    """Share of the full damping at penetration u, and its derivative by u [1/m].

    The cubic t^2 (3 - 2 t), t = u/s_0, between u = 0 and u = s_0 (both in m); 0 below, 1 above; s_0 = 0 gives
    a step that is on for u > 0. The same step function multiplies the damping of the impact force of
    multibody codes, written there with the normalised t.

    >>> value, slope = ramp(5.0e-6, 1.0e-5)
    >>> round(float(value), 12), round(float(slope), 6)
    (0.5, 150000.0)
    """
    if u <= 0.0:
        return 0.0, 0.0
    if u >= s_0:
        return 1.0, 0.0
    t = u / s_0
    return t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) / s_0


@kernel
def linear_ramp(u, s_0):
    """Share of the full damping at penetration u, growing in proportion up to s_0, and its derivative [1/m].

    The simplest law with a penetration of full damping, L. Mauer, SIMPACK User Meeting 2006; its slope jumps
    at both ends, which `ramp` avoids.

    >>> value, slope = linear_ramp(5.0e-6, 2.0e-5)
    >>> round(float(value), 12), round(float(slope), 6)
    (0.25, 50000.0)
    """
    if u <= 0.0:
        return 0.0, 0.0
    if u >= s_0:
        return 1.0, 0.0
    return u / s_0, 1.0 / s_0
