# SPDX-License-Identifier: Apache-2.0
"""States of a blade station: dynamic inflow and dynamic stall (Øye 1990, 1991; Hansen 2008).

Induced velocities follow their steady values through two filters in series,
W_int + τ1 dW_int/dt = W_qs + k τ1 dW_qs/dt and W + τ2 dW/dt = W_int. The state z = W_int - k W_qs makes the
derivative of W_qs unnecessary. The point of separation f follows its steady value with τ = 4 c/W.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel

SHARE = 0.6
"""Share k of the steady induction that acts on the second filter at once (Øye 1990)."""
CHORDS = 4.0
"""Time constant of separation in chords travelled (Øye 1991)."""


@kernel
def inflow_times(a, share, radius, speed):
    """Time constants τ1, τ2 at r/R = share of a rotor of a radius in a wind speed.

    τ1 = 1.1/(1 - 1.3 a) R/V, a at most 0.5; τ2 = (0.39 - 0.26 (r/R)²) τ1.
    """
    first = 1.1 / (1.0 - 1.3 * min(a, 0.5)) * radius / speed
    return first, (0.39 - 0.26 * share * share) * first


@kernel
def advance_inflow(z, w, steady, times, h):
    """z and w after a time h with constant steady induction, exact; `times` are τ1 > τ2."""
    first, second = times
    end = (1.0 - SHARE) * steady
    slow = math.exp(-h / first)
    part = (z - end) * first / (first - second)
    return end + (z - end) * slow, steady + part * slow + (w - steady - part) * math.exp(-h / second)


@kernel
def advance_separation(f, steady, chord, speed, h):
    """Point of separation after a time h with a constant steady value, exact."""
    return steady + (f - steady) * math.exp(-h * speed / (CHORDS * chord))


@kernel
def stalling_lift(lift, steady, attached, f):
    """Lift with the point of separation f, from the steady lift, its point of separation and attached lift.

    f c_l,att + (1 - f) c_l,sep, where c_l,sep makes the steady lift with the steady point of separation; half
    of the attached lift where all flow is attached.
    """
    separated = 0.5 * attached
    if steady < 1.0 - 1e-6:
        separated = (lift - attached * steady) / (1.0 - steady)
    return f * attached + (1.0 - f) * separated


@kernel
def attached_lift(alpha, alpha_0, slope):
    """Lift of attached flow; sine, so that it is periodic."""
    return slope * math.sin(alpha - alpha_0)
