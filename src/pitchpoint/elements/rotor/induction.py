# SPDX-License-Identifier: Apache-2.0
"""Inflow angle of a blade station from the balance of momentum: one equation in one unknown (Ning 2014).

The velocities of the air relative to the station are W sin φ normal to the blade and W cos φ against the
direction of rotation. Momentum theory gives the velocities without induction as W X(φ) and W Y(φ); the
residual is v_y X - v_x Y, multiplied by sin φ so that it is finite everywhere. All four quadrants are
mirrored into v_x, v_y >= 0.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel
from pitchpoint.core.status import DIVERGED, OK
from pitchpoint.elements.rotor.polar import coefficient, interval, wrapped

_EDGE = 1e-9
_TOLERANCE = 1e-15


@kernel
def loss_factor(b, sine):
    """Prandtl's factor of tip and hub loss for |sin φ| > 0 (Glauert 1935)."""
    f = 1.0
    if b["tip"] < 1e300:
        f *= 2.0 / math.pi * math.acos(math.exp(-b["tip"] / sine))
    if b["hub"] < 1e300:
        f *= 2.0 / math.pi * math.acos(math.exp(-b["hub"] / sine))
    return max(f, 1e-9)


@kernel
def momentum(b, air, knots, flow, phi):
    """Momentum balance at an inflow angle.

    flow contains |v_x|, |v_y|, their signs and the angle of the chord. Returns X sin φ, Y sin φ, both for
    |sin φ|.
    """
    vx, vy, sx, sy, theta = flow
    s = math.sin(phi)
    c = math.cos(phi)
    alpha = wrapped(math.atan2(sx * s, sy * c) - theta)
    i = interval(knots, b["first"], b["last"], alpha)
    cl, _ = coefficient(knots, i, 1, alpha)
    cd, _ = coefficient(knots, i, 3, alpha)
    cn = sx * sy * cl * c + air["axial_drag"] * cd * s
    ct = sx * sy * cl * s - air["swirl_drag"] * cd * c
    size = abs(s)
    f = loss_factor(b, size)
    k = 0.25 * b["solidity"] * cn / f
    y = size * c
    if air["swirl"] != 0:
        y -= 0.25 * b["solidity"] * ct / f
    if air["axial"] == 0:
        return s * size, y
    if phi < 0.0:  # propeller brake: the air flows backwards through the rotor
        return k - s * s, y
    if 1.5 * k <= s * s:
        return s * s + k, y
    return s * s / (1.0 - heavy_induction(k / (s * s), f)), y


@kernel
def heavy_induction(kappa, f):
    """Axial induction of a heavily loaded rotor, a > 0.4, by Buhl's curve (Buhl 2005).

    C_T = 8/9 + (4F - 40/9) a + (50/9 - 4F) a^2 equals 4 F κ (1 - a)^2. It tends to 1 for large κ.
    """
    g1 = 2.0 * f * kappa - (10.0 / 9.0 - f)
    g2 = 2.0 * f * kappa - f * (4.0 / 3.0 - f)
    g3 = 2.0 * f * kappa - (25.0 / 9.0 - 2.0 * f)
    if abs(g3) < 1e-6:
        return 1.0 - 0.5 / math.sqrt(g2)
    return (g1 - math.sqrt(g2)) / g3


@kernel
def residual(b, air, knots, flow, phi):
    """Residual v_y X - v_x Y, times |sin φ|, relative to the speed of the air."""
    x, y = momentum(b, air, knots, flow, phi)
    return (flow[1] * x - flow[0] * y) / (flow[0] + flow[1])


@kernel
def bracketed_root(b, air, knots, flow, low, high):
    """Root between two angles with residuals of opposite signs (Brent 1973).

    Inverse quadratic interpolation or secant where they converge faster than bisection.
    """
    a = low
    z = high
    fa = residual(b, air, knots, flow, a)
    fz = residual(b, air, knots, flow, z)
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
        p = 0.0
        q = 0.0
        if abs(before) >= limit and abs(fa) > abs(fz):
            t = fz / fa
            if a == c:
                p = 2.0 * half * t
                q = 1.0 - t
            else:
                u = fa / fc
                r = fz / fc
                p = t * (2.0 * half * u * (u - r) - (z - a) * (r - 1.0))
                q = (u - 1.0) * (r - 1.0) * (t - 1.0)
            if p > 0.0:
                q = -q
            p = abs(p)
        if p > 0.0 and 2.0 * p < min(3.0 * half * q - abs(limit * q), abs(before * q)):
            before = step
            step = p / q
        else:
            step = half
            before = half
        a = z
        fa = fz
        if abs(step) > limit:
            z += step
        else:
            z += math.copysign(limit, half)
        fz = residual(b, air, knots, flow, z)
    return z


@kernel
def opposite(b, air, knots, flow, low, high):
    """Whether the residuals at two angles have opposite signs."""
    left = residual(b, air, knots, flow, low)
    right = residual(b, air, knots, flow, high)
    return (left < 0.0) != (right < 0.0)


@kernel
def inflow_angle(b, air, knots, flow):
    """Inflow angle in the mirrored quadrants, and its status.

    The angle lies between 0 and 90° (windmill, propeller), otherwise between -45° and 0 (propeller brake) or
    between 90° and 180°; one of these intervals brackets a root (Ning 2014). Where none does, because of an
    unusual polar, all angles are searched in small intervals. Zero: a section without lift turns in still
    air, and no air flows through the rotor.
    """
    quarter = 0.5 * math.pi
    if opposite(b, air, knots, flow, _EDGE, quarter):
        return bracketed_root(b, air, knots, flow, _EDGE, quarter), OK
    if opposite(b, air, knots, flow, -0.5 * quarter, -_EDGE):
        return bracketed_root(b, air, knots, flow, -0.5 * quarter, -_EDGE), OK
    if opposite(b, air, knots, flow, quarter, math.pi - _EDGE):
        return bracketed_root(b, air, knots, flow, quarter, math.pi - _EDGE), OK
    for k in range(-40, 80):
        low = quarter * k / 40.0
        high = quarter * (k + 1) / 40.0
        low = _EDGE if k == 0 else low
        high = -_EDGE if k == -1 else high
        high = math.pi - _EDGE if k == 79 else high
        if opposite(b, air, knots, flow, low, high):
            return bracketed_root(b, air, knots, flow, low, high), OK
    if opposite(b, air, knots, flow, -_EDGE, _EDGE):
        return 0.0, OK
    return math.atan2(flow[0], flow[1]), DIVERGED
