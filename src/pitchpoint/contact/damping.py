# SPDX-License-Identifier: Apache-2.0
"""Contact damping: ramp of the damping coefficient over the penetration.

Flanks are damped only while they are in contact. Full damping at zero penetration would cause a force step
or a pulling force, so the coefficient increases from 0 to its full value at the penetration s_0.

Source: Mauer, SIMPACK User Meeting (2006).
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel


@kernel
def ramp(u, s_0):
    """Fraction of the full damping at penetration u, and its derivative by u [1/m].

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
    """Fraction of the full damping at penetration u, linear up to s_0, and its derivative by u [1/m].

    L. Mauer, SIMPACK User Meeting 2006. The slope is discontinuous at both ends; `ramp` avoids this.

    >>> value, slope = linear_ramp(5.0e-6, 2.0e-5)
    >>> round(float(value), 12), round(float(slope), 6)
    (0.25, 50000.0)
    """
    if u <= 0.0:
        return 0.0, 0.0
    if u >= s_0:
        return 1.0, 0.0
    return u / s_0, 1.0 / s_0


@kernel
def start_share(t, end):
    """Fraction of a damper for the start of a run: 1, and from 0.9 end to end a cubic decrease to 0.

    >>> [round(float(start_share(t, 1.0)), 6) for t in (0.5, 0.95, 1.0)]
    [1.0, 0.5, 0.0]
    """
    return 1.0 - ramp(t - 0.9 * end, 0.1 * end)[0]
