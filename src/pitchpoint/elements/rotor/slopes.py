# SPDX-License-Identifier: Apache-2.0
"""Derivatives of induced velocities and loads of a blade station; formulas of `induction` and `loads`.

The inputs are v_x, v_y and the angle of the chord, for a skewed wake also yaw and downwind; the inflow angle
is differentiated as the root of the momentum balance.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.rotor.polar import coefficient

VX, VY, THETA, YAW, DOWNWIND, Z_N, W_N, Z_T, W_T, F = range(10)
"""Columns of the derivatives: inputs, then states of dynamic inflow and stall (`unsteady`)."""
INPUTS, COLUMNS = 5, 10


@kernel
def no_induction(U):
    """Derivatives of the velocities of the air without induction."""
    for c in range(COLUMNS):
        U[0, c] = 1.0 if c == VX else 0.0
        U[1, c] = 1.0 if c == VY else 0.0


@kernel
def induced_slopes(b, p, U):
    """Derivatives of the velocities of `induced`, shape (2, 10), in U, from the balance written by it."""
    balance = p["balance"]
    phi = balance[0]
    if phi == 0.0:
        return
    x = balance[1]
    y = balance[2]
    x_p = balance[3]
    y_p = balance[4]
    x_t = balance[5]
    y_t = balance[6]
    sx = 1.0 if p["vx"] >= 0.0 else -1.0
    sy = 1.0 if p["vy"] >= 0.0 else -1.0
    flow = (abs(p["vx"]), abs(p["vy"]))
    steep = flow[1] * x_p - flow[0] * y_p
    square = x * x + y * y
    if steep == 0.0 or square == 0.0:
        return
    s = math.sin(phi)
    c = math.cos(phi)
    size = abs(s)
    size_p = c if s >= 0.0 else -c
    part = (flow[0] * x + flow[1] * y) / square
    for n in range(3):
        d0 = sx if n == VX else 0.0  # change of |v_x|
        d1 = sy if n == VY else 0.0
        turn = 1.0 if n == THETA else 0.0
        d_phi = (y * d0 - x * d1 - (flow[1] * x_t - flow[0] * y_t) * turn) / steep
        dx = x_p * d_phi + x_t * turn
        dy = y_p * d_phi + y_t * turn
        d_part = x * d0 + y * d1 + flow[0] * dx + flow[1] * dy - 2.0 * part * (x * dx + y * dy)
        dw = size_p * d_phi * part + size * d_part / square
        w = size * part
        U[0, n] = sx * (dw * s + w * c * d_phi)
        U[1, n] = sy * (dw * c - w * s * d_phi)


@kernel
def skew_slopes(air, b, p, ux, U):
    """Apply the skewed wake of `skewed` to the derivatives; ux is the normal velocity without it."""
    vx = p["vx"]
    a = 1.0 - ux / vx
    held = min(max(a, 0.0), 1.0)
    chi = (1.0 + 0.6 * held) * p["yaw"]
    limited = abs(chi) > 0.5 * math.pi
    chi = min(max(chi, -0.5 * math.pi), 0.5 * math.pi)
    half = math.tan(0.5 * chi)
    steep = 0.0 if limited else 0.5 * (1.0 + half * half)
    scale = air["skew"] * b["share"]
    bend = 0.6 * p["yaw"] if held == a else 0.0
    for n in range(INPUTS):
        da = -U[0, n] / vx
        if n == VX:
            da += ux / (vx * vx)
        d_chi = bend * da + (1.0 + 0.6 * held if n == YAW else 0.0)
        d_half = steep * d_chi * p["downwind"] + (half if n == DOWNWIND else 0.0)
        d_all = da * (1.0 + scale * half * p["downwind"]) + a * scale * d_half
        U[0, n] = -vx * d_all
        if n == VX:
            U[0, n] += 1.0 - a * (1.0 + scale * half * p["downwind"])


@kernel
def steady_slopes(b, air, p, U):
    """Derivatives of the velocities of `steady_inflow`, shape (2, 10), in U; after it, with its point."""
    no_induction(U)
    if b["tip"] <= 0.0 or b["hub"] <= 0.0:
        return
    if (air["axial"] == 0 and air["swirl"] == 0) or (p["vx"] == 0.0 and p["vy"] == 0.0):
        return
    induced_slopes(b, p, U)
    if air["skew"] != 0.0 and p["vx"] != 0.0:
        skew_slopes(air, b, p, p["balance"][7], U)


@kernel
def load_slopes(b, air, knots, p, U, lift, L):
    """Derivatives of normal and tangential force and moment per length, shape (3, 10), in L.

    U contains the derivatives of the velocities, `lift` those of the coefficient of lift with respect to the
    angle of attack and to the state of separation. The row of the polar is that of `set_coefficients`.
    """
    w = p["speed"]
    idle = p["loss"] == 0.0 or w == 0.0
    turn = direction(p)
    ux = w * turn[0]
    uy = w * turn[1]
    _, cd1 = coefficient(knots, p["row"], 3, p["alpha"])
    _, cm1 = coefficient(knots, p["row"], 5, p["alpha"])
    cl = p["lift"]
    cd = p["drag"]
    q = 0.0 if idle else 0.5 * air["rho"] * b["chord"]
    for n in range(COLUMNS):
        da = angle_slope(w, turn, U, n)
        dx = U[0, n]
        dy = U[1, n]
        dw = speed_slope(turn, U, n)
        dl = lift[0] * da + (lift[1] if n == F else 0.0)
        dd = cd1 * da
        L[0, n] = q * (dw * (cl * uy + cd * ux) + w * (cl * dy + cd * dx + dl * uy + dd * ux))
        L[1, n] = q * (dw * (cl * ux - cd * uy) + w * (cl * dx - cd * dy + dl * ux - dd * uy))
        L[2, n] = q * b["chord"] * (2.0 * w * dw * p["moment"] + w * w * cm1 * da)


@kernel
def direction(p):
    """Sine and cosine of the angle of the air at the station."""
    return math.sin(p["phi"]), math.cos(p["phi"])


@kernel
def angle_slope(w, turn, U, n):
    """Derivative of the angle of attack with respect to column n; speed w and `direction` of the air."""
    da = -1.0 if n == THETA else 0.0
    if w > 0.0:
        da += (turn[1] * U[0, n] - turn[0] * U[1, n]) / w
    return da


@kernel
def speed_slope(turn, U, n):
    """Derivative of the speed of the air relative to the station with respect to column n."""
    return turn[0] * U[0, n] + turn[1] * U[1, n]
