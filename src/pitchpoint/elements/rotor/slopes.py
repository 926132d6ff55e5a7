# SPDX-License-Identifier: Apache-2.0
"""Derivatives of induced velocities and loads of a blade station; formulas of `induction` and `loads`.

The inputs are v_x, v_y and the angle of the chord, for a skewed wake also yaw and downwind; the inflow angle
is differentiated as the root of the momentum balance.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel
from pitchpoint.core.status import OK
from pitchpoint.elements.rotor.induction import heavy_induction, inflow_angle, loss_factor
from pitchpoint.elements.rotor.loads import induced
from pitchpoint.elements.rotor.polar import coefficient, interval, wrapped

VX, VY, THETA, YAW, DOWNWIND, Z_N, W_N, Z_T, W_T, F = range(10)
"""Columns of the derivatives: inputs, then states of dynamic inflow and stall (`unsteady`)."""
INPUTS, COLUMNS = 5, 10


@kernel
def loss_slope(b, sine):
    """Derivative of `loss_factor` with respect to |sin φ|."""
    whole = loss_factor(b, sine)
    if whole <= 1e-9:
        return 0.0
    slope = 0.0
    for end in range(2):
        g = b["tip"] if end == 0 else b["hub"]
        if g >= 1e300:
            continue
        e = math.exp(-g / sine)
        if e <= 1e-300:
            continue
        part = math.acos(e)
        slope -= whole * e * g / (sine * sine * part * math.sqrt(1.0 - e * e))
    return slope


@kernel
def heavy_slopes(kappa, f):
    """Derivatives of `heavy_induction` with respect to κ and F."""
    g2 = 2.0 * f * kappa - f * (4.0 / 3.0 - f)
    g3 = 2.0 * f * kappa - (25.0 / 9.0 - 2.0 * f)
    root = math.sqrt(g2)
    k2 = 2.0 * f
    f2 = 2.0 * kappa - 4.0 / 3.0 + 2.0 * f
    if abs(g3) < 1e-6:
        return 0.25 * k2 / (g2 * root), 0.25 * f2 / (g2 * root)
    a = heavy_induction(kappa, f)
    by_kappa = (2.0 * f - 0.5 * k2 / root - a * 2.0 * f) / g3
    by_f = (2.0 * kappa + 1.0 - 0.5 * f2 / root - a * (2.0 * kappa + 2.0)) / g3
    return by_kappa, by_f


@kernel
def momentum_slopes(b, air, knots, flow, phi):
    """Values of `momentum`, and their derivatives with respect to φ and to the angle of the chord."""
    _, _, sx, sy, theta = flow
    s = math.sin(phi)
    c = math.cos(phi)
    alpha = wrapped(math.atan2(sx * s, sy * c) - theta)
    i = interval(knots, b["first"], b["last"], alpha)
    cl, cl1 = coefficient(knots, i, 1, alpha)
    cd, cd1 = coefficient(knots, i, 3, alpha)
    sign = sx * sy
    ad = air["axial_drag"]
    sd = air["swirl_drag"]
    cn = sign * cl * c + ad * cd * s
    ct = sign * cl * s - sd * cd * c
    cn_a = sign * cl1 * c + ad * cd1 * s  # by the angle of attack
    ct_a = sign * cl1 * s - sd * cd1 * c
    cn_p = -sign * cl * s + ad * cd * c + sign * cn_a  # by φ
    ct_p = sign * cl * c + sd * cd * s + sign * ct_a
    size = abs(s)
    size_p = c if s >= 0.0 else -c
    f = loss_factor(b, size)
    f_p = loss_slope(b, size) * size_p
    n = 0.25 * b["solidity"] / f
    k = n * cn
    k_p = n * cn_p - k * f_p / f
    k_t = -n * cn_a
    y = size * c
    y_p = size_p * c - size * s
    y_t = 0.0
    if air["swirl"] != 0:
        y -= n * ct
        y_p -= n * ct_p - n * ct * f_p / f
        y_t = n * ct_a
    if air["axial"] == 0:
        return s * size, y, size_p * s + size * c, y_p, 0.0, y_t
    if phi < 0.0:
        return k - s * s, y, k_p - 2.0 * s * c, y_p, k_t, y_t
    if 1.5 * k <= s * s:
        return s * s + k, y, k_p + 2.0 * s * c, y_p, k_t, y_t
    kappa = k / (s * s)
    free = 1.0 - heavy_induction(kappa, f)
    by_kappa, by_f = heavy_slopes(kappa, f)
    a_p = by_kappa * (k_p - 2.0 * k * c / s) / (s * s) + by_f * f_p
    a_t = by_kappa * k_t / (s * s)
    x = s * s / free
    return x, y, (2.0 * s * c + x * a_p) / free, y_p, x * a_t / free, y_t


@kernel
def no_induction(U):
    """Derivatives of the velocities of the air without induction."""
    for c in range(COLUMNS):
        U[0, c] = 1.0 if c == VX else 0.0
        U[1, c] = 1.0 if c == VY else 0.0


@kernel
def induced_slopes(b, air, knots, p, U):
    """Derivatives of the velocities of `induced`, shape (2, 10), in U."""
    no_induction(U)
    sx = 1.0 if p["vx"] >= 0.0 else -1.0
    sy = 1.0 if p["vy"] >= 0.0 else -1.0
    flow = (abs(p["vx"]), abs(p["vy"]), sx, sy, b["twist"] + p["pitch"])
    phi, status = inflow_angle(b, air, knots, flow)
    if status != OK or phi == 0.0:
        return
    x, y, x_p, y_p, x_t, y_t = momentum_slopes(b, air, knots, flow, phi)
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
def steady_slopes(b, air, knots, p, U):
    """Derivatives of the velocities of `steady_inflow`, shape (2, 10), in U."""
    no_induction(U)
    if b["tip"] <= 0.0 or b["hub"] <= 0.0:
        return
    if (air["axial"] == 0 and air["swirl"] == 0) or (p["vx"] == 0.0 and p["vy"] == 0.0):
        return
    induced_slopes(b, air, knots, p, U)
    if air["skew"] != 0.0 and p["vx"] != 0.0:
        loss = p["loss"]
        ux, _, _ = induced(b, air, knots, p)
        p["loss"] = loss
        skew_slopes(air, b, p, ux, U)


@kernel
def load_slopes(b, air, knots, p, U, lift, L):
    """Derivatives of normal and tangential force and moment per length, shape (3, 10), in L.

    U contains the derivatives of the velocities, `lift` those of the coefficient of lift with respect to the
    angle of attack and to the state of separation.
    """
    w = p["speed"]
    idle = p["loss"] == 0.0 or w == 0.0
    ux = w * math.sin(p["phi"])
    uy = w * math.cos(p["phi"])
    i = interval(knots, b["first"], b["last"], p["alpha"])
    _, cd1 = coefficient(knots, i, 3, p["alpha"])
    _, cm1 = coefficient(knots, i, 5, p["alpha"])
    cl = p["lift"]
    cd = p["drag"]
    q = 0.0 if idle else 0.5 * air["rho"] * b["chord"]
    for n in range(COLUMNS):
        da = angle_slope(p, U, n)
        dx = U[0, n]
        dy = U[1, n]
        dw = speed_slope(p, U, n)
        dl = lift[0] * da + (lift[1] if n == F else 0.0)
        dd = cd1 * da
        L[0, n] = q * (dw * (cl * uy + cd * ux) + w * (cl * dy + cd * dx + dl * uy + dd * ux))
        L[1, n] = q * (dw * (cl * ux - cd * uy) + w * (cl * dx - cd * dy + dl * ux - dd * uy))
        L[2, n] = q * b["chord"] * (2.0 * w * dw * p["moment"] + w * w * cm1 * da)


@kernel
def angle_slope(p, U, n):
    """Derivative of the angle of attack with respect to column n."""
    w = p["speed"]
    da = -1.0 if n == THETA else 0.0
    if w > 0.0:
        da += (math.cos(p["phi"]) * U[0, n] - math.sin(p["phi"]) * U[1, n]) / w
    return da


@kernel
def speed_slope(p, U, n):
    """Derivative of the speed of the air relative to the station with respect to column n."""
    return math.sin(p["phi"]) * U[0, n] + math.cos(p["phi"]) * U[1, n]
