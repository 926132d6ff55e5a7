# SPDX-License-Identifier: Apache-2.0
"""Inflow angle of a blade station from the balance of momentum: one equation in one unknown (Ning 2014).

The velocities of the air relative to the station are W sin φ normal to the blade and W cos φ against the
direction of rotation. Momentum theory gives the velocities without induction as W X(φ) and W Y(φ); the
residual is v_y X - v_x Y, multiplied by sin φ so that it is finite everywhere. All four quadrants are
mirrored into v_x, v_y >= 0.

Newton's method starts from an estimate that depends on the present flow only, so that the root does not
depend on earlier evaluations. Where it fails, Brent's method converges in a bracket.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel
from pitchpoint.core.status import DIVERGED, OK
from pitchpoint.elements.rotor.polar import coefficient, interval, wrapped

_EDGE = 1e-9
_TOLERANCE = 1e-15
LAST = 1e-9
"""Newton step [rad] that ends the iteration: with quadratic convergence the error after it is round-off."""
NEWTON_STEPS = 10
UNDISTURBED = 0.7
"""Share of the wind of the first estimate: an axial induction of 0.3."""
_AWAY = 1e-6
"""Smallest inflow angle [rad] from Newton's method: without drag, the residual vanishes at zero, too."""
CERTAIN = 40.0
"""Exponent from which exp(-x) is below half a unit in the last place of 1."""


@kernel
def end_loss(g, sine):
    """Loss factor of one end of a blade, and its derivative with respect to |sin φ| over the factor."""
    x = g / sine
    if x > CERTAIN:
        return 1.0, 0.0
    e = math.exp(-x)
    angle = math.acos(e)
    return 2.0 / math.pi * angle, -e * x / (sine * angle * math.sqrt(1.0 - e * e))


@kernel
def loss(b, sine):
    """Prandtl's factor of tip and hub loss for |sin φ| > 0 (Glauert 1935), and its derivative."""
    tip, tip_slope = end_loss(b["tip"], sine)
    hub, hub_slope = end_loss(b["hub"], sine)
    f = tip * hub
    if f <= 1e-9:
        return 1e-9, 0.0
    return f, f * (tip_slope + hub_slope)


@kernel
def heavy_induction(kappa, f):
    """Axial induction of a heavily loaded rotor, a > 0.4, by Buhl's curve (Buhl 2005), and its derivatives
    with respect to κ and F.

    C_T = 8/9 + (4F - 40/9) a + (50/9 - 4F) a^2 equals 4 F κ (1 - a)^2. It tends to 1 for large κ. The
    quadratic equation has the root a = 1 - 1/(r + q) with r^2 = 2Fκ - F(4/3 - F) and q = 5/3 - F, which
    does not cancel anywhere.
    """
    root = math.sqrt(2.0 * f * kappa - f * (4.0 / 3.0 - f))
    free = 1.0 / (root + 5.0 / 3.0 - f)
    by_kappa = f / root * free * free
    by_f = ((kappa - 2.0 / 3.0 + f) / root - 1.0) * free * free
    return 1.0 - free, by_kappa, by_f


@kernel
def momentum(b, air, knots, flow, p, phi):
    """Momentum balance at an inflow angle, and its derivatives with respect to φ and the angle of the chord.

    flow contains |v_x|, |v_y|, their signs and the angle of the chord. Returns X sin φ, Y sin φ, both for
    |sin φ|, their derivatives by φ, and those by the angle of the chord.
    """
    _, _, sx, sy, theta = flow
    s = math.sin(phi)
    c = math.cos(phi)
    alpha = wrapped(sx * (phi if sy > 0.0 else math.pi - phi) - theta)
    i = interval(knots, b["first"], b["last"], alpha, p["row"])
    p["row"] = i
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
    f, f_size = loss(b, size)
    f_p = f_size * size_p
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
    if phi < 0.0:  # propeller brake: the air flows backwards through the rotor
        return k - s * s, y, k_p - 2.0 * s * c, y_p, k_t, y_t
    if 1.5 * k <= s * s:
        return s * s + k, y, k_p + 2.0 * s * c, y_p, k_t, y_t
    a, by_kappa, by_f = heavy_induction(k / (s * s), f)
    free = 1.0 - a
    a_p = by_kappa * (k_p - 2.0 * k * c / s) / (s * s) + by_f * f_p
    a_t = by_kappa * k_t / (s * s)
    x = s * s / free
    return x, y, (2.0 * s * c + x * a_p) / free, y_p, x * a_t / free, y_t


@kernel
def residual(b, air, knots, flow, p, phi):
    """Residual v_y X - v_x Y, times |sin φ|, relative to the speed of the air."""
    x, y, _, _, _, _ = momentum(b, air, knots, flow, p, phi)
    return (flow[1] * x - flow[0] * y) / (flow[0] + flow[1])


@kernel
def bracketed_root(b, air, knots, flow, p, low, high):
    """Root between two angles with residuals of opposite signs (Brent 1973).

    Inverse quadratic interpolation or secant where they converge faster than bisection.
    """
    a = low
    z = high
    fa = residual(b, air, knots, flow, p, a)
    fz = residual(b, air, knots, flow, p, z)
    c = a
    fc = fa
    step = z - a
    before = step
    for _ in range(200):
        if (fz > 0.0) == (fc > 0.0):
            c = a
            fc = fa
            step = z - a
            before = step
        if abs(fc) < abs(fz):
            a = z
            z = c
            c = a
            fa = fz
            fz = fc
            fc = fa
        limit = 2.0 * 2.3e-16 * abs(z) + _TOLERANCE
        half = 0.5 * (c - z)
        if abs(half) <= limit or fz == 0.0:
            break
        u = 0.0
        q = 0.0
        if abs(before) >= limit and abs(fa) > abs(fz):
            t = fz / fa
            if a == c:
                u = 2.0 * half * t
                q = 1.0 - t
            else:
                w = fa / fc
                r = fz / fc
                u = t * (2.0 * half * w * (w - r) - (z - a) * (r - 1.0))
                q = (w - 1.0) * (r - 1.0) * (t - 1.0)
            if u > 0.0:
                q = -q
            u = abs(u)
        if u > 0.0 and 2.0 * u < min(3.0 * half * q - abs(limit * q), abs(before * q)):
            before = step
            step = u / q
        else:
            step = half
            before = half
        a = z
        fa = fz
        if abs(step) > limit:
            z += step
        else:
            z += math.copysign(limit, half)
        fz = residual(b, air, knots, flow, p, z)
    return z


@kernel
def opposite(b, air, knots, flow, p, low, high):
    """Whether the residuals at two angles have opposite signs."""
    left = residual(b, air, knots, flow, p, low)
    right = residual(b, air, knots, flow, p, high)
    return (left < 0.0) != (right < 0.0)


@kernel
def searched_angle(b, air, knots, flow, p):
    """Inflow angle in the mirrored quadrants by search of a bracket, and its status.

    The angle lies between 0 and 90° (windmill, propeller), otherwise between -45° and 0 (propeller brake) or
    between 90° and 180°; one of these intervals brackets a root (Ning 2014). Where none does, because of an
    unusual polar, all angles are searched in small intervals. Zero: a section without lift turns in still
    air, and no air flows through the rotor.
    """
    quarter = 0.5 * math.pi
    for k in range(3):
        low = _EDGE
        high = quarter
        if k == 1:
            low = -0.5 * quarter
            high = -_EDGE
        elif k == 2:
            low = quarter
            high = math.pi - _EDGE
        if opposite(b, air, knots, flow, p, low, high):
            return bracketed_root(b, air, knots, flow, p, low, high), OK
    for k in range(-40, 80):
        low = quarter * k / 40.0
        high = quarter * (k + 1) / 40.0
        low = _EDGE if k == 0 else low
        high = -_EDGE if k == -1 else high
        high = math.pi - _EDGE if k == 79 else high
        if opposite(b, air, knots, flow, p, low, high):
            return bracketed_root(b, air, knots, flow, p, low, high), OK
    if opposite(b, air, knots, flow, p, -_EDGE, _EDGE):
        return 0.0, OK
    return math.atan2(flow[0], flow[1]), DIVERGED


@kernel
def inflow_angle(b, air, knots, flow, p):
    """Inflow angle in the mirrored quadrants, its status, and the values of `momentum` there.

    Newton's method in the quadrant of windmill and propeller, then `searched_angle`.
    """
    quarter = 0.5 * math.pi
    phi = math.atan2(UNDISTURBED * flow[0], flow[1])
    for _ in range(NEWTON_STEPS):
        x, y, x_p, y_p, x_t, y_t = momentum(b, air, knots, flow, p, phi)
        step = (flow[0] * y - flow[1] * x) / (flow[1] * x_p - flow[0] * y_p)
        if abs(step) <= LAST and phi > _AWAY:
            return phi + step, OK, x + step * x_p, y + step * y_p, x_p, y_p, x_t, y_t
        if not math.isfinite(step):
            break
        phi = min(max(phi + step, 0.5 * phi), 0.5 * (phi + quarter))
    phi, status = searched_angle(b, air, knots, flow, p)
    x, y, x_p, y_p, x_t, y_t = momentum(b, air, knots, flow, p, phi)
    return phi, status, x, y, x_p, y_p, x_t, y_t
