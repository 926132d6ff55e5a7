# SPDX-License-Identifier: Apache-2.0
"""States of a blade station: dynamic inflow and dynamic stall (Øye 1990, 1991; Hansen 2008).

Induced velocities follow their steady values through two filters in series,
W_int + τ1 dW_int/dt = W_qs + k τ1 dW_qs/dt and W + τ2 dW/dt = W_int. The state z = W_int - k W_qs makes the
derivative of W_qs unnecessary. The point of separation f follows its steady value with τ = 4 c/W.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.rotor.polar import coefficient
from pitchpoint.elements.rotor.slopes import (
    COLUMNS,
    INPUTS,
    VX,
    W_N,
    W_T,
    F,
    angle_slope,
    direction,
    no_induction,
    speed_slope,
)

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
def stalling_lift(lift, steady, attached, separated, f):
    """Lift with the point of separation f, from the steady lift and its point of separation.

    f c_l,att + (1 - f) c_l,sep, as the change from the steady lift: c_l,sep from the steady lift between the
    points of a polar would be a quotient of two small errors where the flow is almost attached.
    """
    return lift + (f - steady) * (attached - separated)


@kernel
def attached_lift(alpha, alpha_0, slope):
    """Lift of attached flow; sine, so that it is periodic."""
    return slope * math.sin(alpha - alpha_0)


@kernel
def inflow_speed(p):
    """Wind speed of the time constants, at least 0.1 m/s."""
    return max(abs(p["vx"]), 0.1)


@kernel
def state_rates(b, p, x, steady, rates):
    """Rates of the states x = (z_n, w_n, z_t, w_t, f) for the steady induction and point of separation."""
    steady_n, steady_t, steady_f = steady
    speed = inflow_speed(p)
    first, second = inflow_times(steady_n / speed, b["share"], b["radius"], speed)
    for k in range(2):
        w = steady_n if k == 0 else steady_t
        rates[2 * k] = ((1.0 - SHARE) * w - x[2 * k]) / first
        rates[2 * k + 1] = (x[2 * k] + SHARE * w - x[2 * k + 1]) / second
    rates[4] = (steady_f - x[4]) * p["speed"] / (CHORDS * b["chord"])


@kernel
def held_velocities(U):
    """Derivatives of the velocities at a station whose induced velocities are states."""
    no_induction(U)
    U[0, W_N] = -1.0
    U[1, W_T] = 1.0


@kernel
def rate_slopes(b, p, x, steady, slopes, U, Q):
    """Derivatives of the rates, shape (5, 10), in Q.

    `slopes` contains the derivatives of the steady velocities, shape (2, 10), and that of the steady point of
    separation with respect to the angle of attack; U those of the velocities at the station.
    """
    by_steady, by_alpha = slopes
    steady_n, steady_t, steady_f = steady
    speed = inflow_speed(p)
    a = steady_n / speed
    first, second = inflow_times(a, b["share"], b["radius"], speed)
    turn = direction(p)
    faster = 0.0 if abs(p["vx"]) <= 0.1 else 1.0 if p["vx"] > 0.0 else -1.0
    for n in range(COLUMNS):
        d_speed = faster if n == VX else 0.0
        dn = (1.0 if n == VX else 0.0) - by_steady[0, n] if n < INPUTS else 0.0
        dt = by_steady[1, n] - (1.0 if n == VX + 1 else 0.0) if n < INPUTS else 0.0
        da = (dn - a * d_speed) / speed
        longer = -d_speed / speed  # change of the time constants over them
        if a < 0.5:
            longer += 1.3 * da / (1.0 - 1.3 * a)
        for k in range(2):
            w = steady_n if k == 0 else steady_t
            dw = dn if k == 0 else dt
            z = 2 * k
            dz = 1.0 if n == INPUTS + z else 0.0
            own = 1.0 if n == INPUTS + z + 1 else 0.0
            Q[z, n] = ((1.0 - SHARE) * dw - dz - longer * ((1.0 - SHARE) * w - x[z])) / first
            slow = x[z] + SHARE * w - x[z + 1]
            Q[z + 1, n] = (dz + SHARE * dw - own - longer * slow) / second
        df = by_alpha * angle_slope(p["speed"], turn, U, n) - (1.0 if n == F else 0.0)
        fast = p["speed"] / (CHORDS * b["chord"])
        Q[4, n] = df * fast + (steady_f - x[4]) * speed_slope(turn, U, n) / (CHORDS * b["chord"])


@kernel
def lift_slopes(b, p, knots, i, stall, x, lift):
    """Derivatives of the coefficient of lift with respect to the angle of attack and to the state f."""
    _, cl1 = coefficient(knots, i, 1, p["alpha"])
    lift[0] = cl1
    lift[1] = 0.0
    if stall == 0 or b["slope"] <= 0.0:
        return
    f, f1 = coefficient(knots, i, 7, p["alpha"])
    separated, separated1 = coefficient(knots, i, 9, p["alpha"])
    lift[1] = attached_lift(p["alpha"], b["alpha_0"], b["slope"]) - separated
    change = b["slope"] * math.cos(p["alpha"] - b["alpha_0"]) - separated1
    lift[0] += (x[4] - f) * change - f1 * lift[1]
