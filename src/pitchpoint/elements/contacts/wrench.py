# SPDX-License-Identifier: Apache-2.0
"""Wrenches of one contact point on two bodies, with exact tangents.

The geometry has written gap, normal and contact point to the record, with their derivatives by the motion of
both bodies; the motion of the contact point along the surfaces is eliminated there. This file applies contact
law and friction. The gap changes by n . (motion of i - motion of j) at P for any curvatures, so the
penetration rate is conjugate to the normal force.
"""

from __future__ import annotations

import math

from pitchpoint.contact.friction import friction_per_speed
from pitchpoint.contact.impact import elastic_energy, normal_force
from pitchpoint.core.kernel import kernel
from pitchpoint.multibody.channels import events, observations
from pitchpoint.multibody.vectors import column, cross, dot, plus, triple


@kernel
def put_3(a, x):
    """Write a triple into an array of three."""
    a[0] = x[0]
    a[1] = x[1]
    a[2] = x[2]


@kernel
def put(A, c, x):
    """Write the change of a vector for motion c to an array (3, 12)."""
    A[0, c] = x[0]
    A[1, c] = x[1]
    A[2, c] = x[2]


@kernel
def moved(c, arm):
    """Motion of a point at `arm` for unit motion c of its body: a translation (c < 3) or a rotation."""
    e = (1.0 if c % 3 == 0 else 0.0, 1.0 if c % 3 == 1 else 0.0, 1.0 if c % 3 == 2 else 0.0)
    if c < 3:
        return e
    return cross(e, arm)


@kernel
def turned(c, x):
    """Change of a body-fixed vector for unit motion c of its body."""
    if c < 3:
        return 0.0, 0.0, 0.0
    return moved(c, x)


@kernel
def place_markers(b, f, g):
    """Write both markers in world axes, and marker i relative to marker j."""
    for side in range(2):
        o = f if side == 0 else g
        p = b["pi"] if side == 0 else b["pj"]
        B = b["Bi"] if side == 0 else b["Bj"]
        at = b["oi"] if side == 0 else b["oj"]
        E = b["Ei"] if side == 0 else b["Ej"]
        S = o["S"]
        for r in range(3):
            at[r] = o["r"][r] + S[r, 0] * p[0] + S[r, 1] * p[1] + S[r, 2] * p[2]
            for c in range(3):
                E[r, c] = S[r, 0] * B[0, c] + S[r, 1] * B[1, c] + S[r, 2] * B[2, c]
    gap = plus(triple(b["oi"], 0), -1.0, triple(b["oj"], 0))
    for r in range(3):
        axis = column(b["Ej"], r)
        b["d"][r] = dot(axis, gap)
        for c in range(3):
            b["M"][r, c] = dot(axis, column(b["Ei"], c))


@kernel
def begin(b, f, g):
    """Set the markers and reset the results."""
    place_markers(b, f, g)
    b["gap"] = b["margin"]
    b["normal"] = 0.0
    b["sliding"] = 0.0
    b["loss"] = 0.0
    b["energy"] = 0.0
    for k in range(5):
        b["place"][k] = 0.0


@kernel
def _arms(b, f, g):
    """Point of application, and its arms about the origins of both bodies."""
    P = plus(triple(b["Q"], 0), -(b["r"] + 0.5 * b["side"] * b["h"]), triple(b["n"], 0))
    return P, plus(P, -1.0, triple(f["r"], 0)), plus(P, -1.0, triple(g["r"], 0))


@kernel
def _forces(b, f, g, ai, aj):
    """Velocity of i relative to j, its normal component, and normal force and friction with their slopes."""
    u = plus(triple(f["tw"], 0), 1.0, cross(triple(f["tw"], 3), ai))
    u = plus(u, -1.0, plus(triple(g["tw"], 0), 1.0, cross(triple(g["tw"], 3), aj)))
    n = triple(b["n"], 0)
    rate = dot(n, u)
    N, by_h, by_rate, loss = normal_force(b, -b["h"], -rate)
    s = plus(u, -rate, n)
    speed = math.sqrt(dot(s, s))
    c = 0.0
    c2 = 0.0
    if b["mu_s"] > 0.0 or b["mu_d"] > 0.0:
        c, c2 = friction_per_speed(speed, b["mu_s"], b["mu_d"], b["v_s"], b["v_d"])
    w = b["weight"]
    return u, rate, (w * N, -w * by_h, -w * by_rate, w * loss), (c, c2, speed)


@kernel
def _change(n, s, law, slip, dh, drate, dn, ds):
    """Change of the force on i for given changes of gap, rate, normal and sliding velocity."""
    N = law[0]
    dN = law[1] * dh + law[2] * drate
    c = slip[0]
    dF = plus((dN * n[0], dN * n[1], dN * n[2]), N, dn)
    along = slip[1] * dot(s, ds)
    return plus(plus(dF, -(dN * c + N * along), s), -N * c, ds)


@kernel
def _tangent(b, ctl, f, g, kk, F, u, rate, law, slip):
    """Add the exact tangents of both wrenches by poses (ck) and velocities (cd) of both bodies."""
    P, ai, aj = _arms(b, f, g)
    n = triple(b["n"], 0)
    s = plus(u, -rate, n)
    wi = triple(f["tw"], 3)
    wj = triple(g["tw"], 3)
    for k in range(12):
        side = k // 6
        c = k % 6
        if side == 1 and b["j"] == 0:
            break
        sign = 1.0 if side == 0 else -1.0
        ki = kk[b["ii"]] if side == 0 else kk[b["ij"]]
        kj = kk[b["ji"]] if side == 0 else kk[b["jj"]]
        motion = moved(c, ai if side == 0 else aj)
        dh = sign * dot(n, motion)
        if ctl["cd"] != 0.0:
            ds = plus(motion, -sign * dh, n)
            ds = (sign * ds[0], sign * ds[1], sign * ds[2])
            dF = _change(n, s, law, slip, 0.0, dh, (0.0, 0.0, 0.0), ds)
            add_change(ki, kj, c, -ctl["cd"], dF, cross(ai, dF), cross(aj, dF), b["j"])
        if ctl["ck"] != 0.0:
            dn = column(b["dn"], k)
            dP = plus(column(b["dQ"], k), -(b["r"] + 0.5 * b["side"] * b["h"]), dn)
            dP = plus(dP, -0.5 * b["side"] * dh, n)
            di = dP
            dj = dP
            if c < 3 and side == 0:
                di = plus(dP, -1.0, motion)
            elif c < 3:
                dj = plus(dP, -1.0, motion)
            du = plus(cross(wi, di), -1.0, cross(wj, dj))
            drate = dot(dn, u) + dot(n, du)
            ds = plus(plus(du, -drate, n), -rate, dn)
            dF = _change(n, s, law, slip, dh, drate, dn, ds)
            mi = plus(cross(di, F), 1.0, cross(ai, dF))
            mj = plus(cross(dj, F), 1.0, cross(aj, dF))
            add_change(ki, kj, c, -ctl["ck"], dF, mi, mj, b["j"])


@kernel
def add_change(ki, kj, c, s, dF, mi, mj, j):
    """Add s times a change of the force on i and of its moments to column c of the blocks of i and j."""
    for r in range(3):
        ki[r, c] += s * dF[r]
        ki[3 + r, c] += s * mi[r]
        if j != 0:
            kj[r, c] -= s * dF[r]
            kj[3 + r, c] -= s * mj[r]


@kernel
def act(b, ctl, f, g, kk):
    """Add wrenches and tangents of the contact point in the record; add its results to the sums."""
    P, ai, aj = _arms(b, f, g)
    if b["h"] < b["gap"]:
        b["gap"] = b["h"]
        away = plus(P, -1.0, triple(b["oj"], 0))
        for k in range(3):
            b["place"][k] = dot(away, column(b["Ej"], k))
    if b["h"] >= 0.0:
        return
    u, rate, law, slip = _forces(b, f, g, ai, aj)
    b["energy"] += b["weight"] * elastic_energy(b, -b["h"])
    if law[0] == 0.0:  # no force: weight 0, or damping exceeds the elastic force
        b["loss"] += law[3]
        return
    n = triple(b["n"], 0)
    s = plus(u, -rate, n)
    push = law[0] * slip[0]
    F = plus((law[0] * n[0], law[0] * n[1], law[0] * n[2]), -push, s)
    mi = cross(ai, F)
    mj = cross(aj, F)
    for r in range(3):
        f["F"][r] += F[r]
        f["F"][3 + r] += mi[r]
        g["F"][r] -= F[r]
        g["F"][3 + r] -= mj[r]
    b["normal"] += law[0]
    b["sliding"] += push * slip[2]
    b["loss"] += law[3] + push * slip[2] * slip[2]
    if ctl["jac"] != 0:
        _tangent(b, ctl, f, g, kk, F, u, rate, law, slip)


@kernel
def finish(b, ctl, paths):
    """Write the observations of a contact (`paths` 1: with both arc lengths) and its event function."""
    c = ctl[0]
    if c["out"] != 0:
        out = observations(ctl)
        k = b["out"]
        out[k] = b["normal"]
        out[k + 1] = b["sliding"]
        out[k + 2] = b["gap"]
        out[k + 3] = b["loss"]
        out[k + 4] = b["energy"]
        for i in range(3 + 2 * paths):
            out[k + 5 + i] = b["place"][i]
    if c["ev"] != 0:
        events(ctl)[b["ev"]] = b["gap"]
