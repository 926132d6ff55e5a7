# SPDX-License-Identifier: Apache-2.0
"""Contact points of a circle on a plane and of two crossed cylinders, with their derivatives."""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.contacts.wrench import moved, put, put_3, turned
from pitchpoint.multibody.vectors import column, dot, plus, triple

FLAT = 1e-9
"""Sine of the tilt below which a circle is flat on a plane: its centre is taken as the lowest point."""


@kernel
def rim_place(b, f, g, R, tube, along, weight):
    """Lowest point of the circle of radius R at `along` [m] on the axis of marker i, above the plane of j.

    With m = n - (n . a) a the point is C - R m/|m|; m depends on both bodies.
    """
    a = column(b["Ei"], 2)
    n = column(b["Ej"], 2)
    na = dot(n, a)
    m = plus(n, -na, a)
    size = math.sqrt(dot(m, m))
    flat = size < FLAT
    e = (0.0, 0.0, 0.0)
    if not flat:
        e = (m[0] / size, m[1] / size, m[2] / size)
    C = plus(triple(b["oi"], 0), along, a)
    Q = plus(C, -R, e)
    put_3(b["n"], n)
    put_3(b["Q"], Q)
    b["side"] = 1.0
    b["r"] = tube
    b["h"] = dot(n, plus(Q, -1.0, triple(b["oj"], 0))) - tube
    b["weight"] = weight
    arm = plus(C, -1.0, triple(f["r"], 0))
    for k in range(12):
        c = k % 6
        dn = (0.0, 0.0, 0.0)
        da = (0.0, 0.0, 0.0)
        dQ = (0.0, 0.0, 0.0)
        if k < 6:
            da = turned(c, a)
            dQ = moved(c, arm)
        else:
            dn = turned(c, n)
        if not flat:
            dm = plus(plus(dn, -(dot(dn, a) + dot(n, da)), a), -na, da)
            dQ = plus(dQ, -R / size, plus(dm, -dot(e, dm), e))
        put(b["dQ"], k, dQ)
        put(b["dn"], k, dn)


@kernel
def _nearest_on_axes(w, a, c, half_a, half_c):
    """Closest points s and t of two axes, each with a flag: interior (1) or at an end (0).

    w = middle of the first - middle of the second; a and c unit directions.
    """
    ac = dot(a, c)
    aw = dot(a, w)
    cw = dot(c, w)
    sine = 1.0 - ac * ac
    s = 0.0
    if sine > 1e-12:
        s = (ac * cw - aw) / sine
    free = 1.0
    if abs(s) > half_a or sine <= 1e-12:
        s = min(max(s, -half_a), half_a)
        free = 0.0
    t = cw + s * ac
    if abs(t) <= half_c:
        return s, t, free, 1.0
    t = min(max(t, -half_c), half_c)
    s = t * ac - aw
    if abs(s) <= half_a:
        return s, t, 1.0, 0.0
    return min(max(s, -half_a), half_a), t, 0.0, 0.0


@kernel
def rods_place(b, f, g):
    """Common normal of the axes of two cylinders with round ends; derivatives include the motion of both
    contact points along the axes."""
    a = column(b["Ei"], 2)
    c = column(b["Ej"], 2)
    w = plus(triple(b["oi"], 0), -1.0, triple(b["oj"], 0))
    s, t, free_s, free_t = _nearest_on_axes(w, a, c, 0.5 * b["size_i"][1], 0.5 * b["size_j"][1])
    d = plus(plus(w, s, a), -t, c)
    phi = max(math.sqrt(dot(d, d)), 1e-12)
    n = (d[0] / phi, d[1] / phi, d[2] / phi)
    Q = plus(triple(b["oi"], 0), s, a)
    put_3(b["n"], n)
    put_3(b["Q"], Q)
    b["side"] = 1.0
    b["r"] = b["size_i"][0]
    b["h"] = phi - b["size_i"][0] - b["size_j"][0]
    b["weight"] = 1.0
    arm_i = plus(Q, -1.0, triple(f["r"], 0))
    arm_j = plus(plus(Q, -1.0, d), -1.0, triple(g["r"], 0))
    ac = dot(a, c)
    for k in range(12):
        motion = moved(k % 6, arm_i if k < 6 else arm_j)
        sign = 1.0 if k < 6 else -1.0
        da = (0.0, 0.0, 0.0)
        dc = (0.0, 0.0, 0.0)
        if k < 6:
            da = turned(k % 6, a)
        else:
            dc = turned(k % 6, c)
        # d . a = 0 where s is free, d . c = 0 where t is free
        p = -(dot(d, da) + sign * dot(a, motion))
        q = dot(d, dc) + sign * dot(c, motion)
        ds = 0.0
        dt = 0.0
        if free_s > 0.0 and free_t > 0.0:
            ds = (p + ac * q) / (1.0 - ac * ac)
            dt = q + ac * ds
        elif free_s > 0.0:
            ds = p
        elif free_t > 0.0:
            dt = q
        dd = plus(plus((sign * motion[0], sign * motion[1], sign * motion[2]), ds, a), -dt, c)
        across = plus(dd, -dot(n, dd), n)
        put(b["dn"], k, (across[0] / phi, across[1] / phi, across[2] / phi))
        dQ = (ds * a[0], ds * a[1], ds * a[2])
        put(b["dQ"], k, plus(dQ, 1.0, motion) if k < 6 else dQ)
