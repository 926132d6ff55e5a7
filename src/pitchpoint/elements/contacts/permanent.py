# SPDX-License-Identifier: Apache-2.0
"""Constraint row of two bodies in permanent contact, from their contact point and its derivatives.

The row is the gap, g = h. The contact points on both bodies are not unknowns: they are eliminated, since the
geometry gives the derivatives of normal n and contact point Q by the motion of both bodies (dn, dQ). With u
the velocity of body i relative to body j at Q,

    g' = n . u,    g'' = n . u' + n' . u,    u' = sum of +-(a + alpha x r + omega x (Q' - v)),

where n' and Q' are dn and dQ times the velocities of both bodies: Q moves along the curves and surfaces. The
constraint force lambda acts at Q in the direction n and follows both.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.contacts.wrench import add_change, moved
from pitchpoint.multibody.channels import F8
from pitchpoint.multibody.vectors import column, cross, dot, plus, triple

FORCE = ("contact_force", "N", "normal force between the bodies; negative in tension")


@kernel
def _rate(A, f, g):
    """Time derivative of a vector from its derivatives (3, 12) and the velocities of both bodies."""
    x = (0.0, 0.0, 0.0)
    for k in range(12):
        speed = f["tw"][k] if k < 6 else g["tw"][k - 6]
        x = plus(x, speed, column(A, k))
    return x


@kernel
def _acceleration(o, Q, run):
    """Time derivative of the velocity of body o at a point Q that moves with the velocity `run`."""
    w = triple(o["tw"], 3)
    away = plus(run, -1.0, triple(o["tw"], 0))
    a = plus(triple(o["ac"], 0), 1.0, cross(triple(o["ac"], 3), plus(Q, -1.0, triple(o["r"], 0))))
    return plus(a, 1.0, cross(w, away))


@kernel
def _velocity(o, Q):
    """Velocity of body o at Q."""
    return plus(triple(o["tw"], 0), 1.0, cross(triple(o["tw"], 3), plus(Q, -1.0, triple(o["r"], 0))))


@kernel
def second_rate(b, f, g):
    """Second time derivative of the gap at the velocities and accelerations of the frames."""
    n = triple(b["n"], 0)
    Q = triple(b["Q"], 0)
    run = _rate(b["dQ"], f, g)
    u = plus(_velocity(f, Q), -1.0, _velocity(g, Q))
    du = plus(_acceleration(f, Q, run), -1.0, _acceleration(g, Q, run))
    return dot(n, du) + dot(_rate(b["dn"], f, g), u)


@kernel
def _tangent(b, ctl, f, g, lam):
    """Add the derivative of the constraint wrenches by the poses of both bodies."""
    kk = view(ctl["kk"], (ctl["np"], 6, 6), F8)
    s = ctl["ck"] * lam
    n = triple(b["n"], 0)
    Q = triple(b["Q"], 0)
    ai = plus(Q, -1.0, triple(f["r"], 0))
    aj = plus(Q, -1.0, triple(g["r"], 0))
    for k in range(12):
        if k >= 6 and b["j"] == 0:
            break
        c = k % 6
        dn = column(b["dn"], k)
        di = column(b["dQ"], k)
        dj = di
        if c < 3 and k < 6:
            di = plus(di, -1.0, moved(c, ai))
        elif c < 3:
            dj = plus(dj, -1.0, moved(c, aj))
        mi = plus(cross(di, n), 1.0, cross(ai, dn))
        mj = plus(cross(dj, n), 1.0, cross(aj, dn))
        ki = kk[b["ii"]] if k < 6 else kk[b["ij"]]
        kj = kk[b["ji"]] if k < 6 else kk[b["jj"]]
        add_change(ki, kj, c, s, dn, mi, mj, b["j"])


@kernel
def hold(b, ctl, f, o, g, gtt, Gf):
    """Write the constraint row of the contact point in the record; returns its multiplier."""
    r = b["row"]
    n = triple(b["n"], 0)
    Q = triple(b["Q"], 0)
    g[r] = b["h"]
    mi = cross(plus(Q, -1.0, triple(f["r"], 0)), n)
    mj = cross(plus(Q, -1.0, triple(o["r"], 0)), n)
    for k in range(3):
        Gf[r, 0, k] = n[k]
        Gf[r, 0, 3 + k] = mi[k]
        Gf[r, 1, k] = -n[k]
        Gf[r, 1, 3 + k] = -mj[k]
    gtt[r] = second_rate(b, f, o)
    lam = view(ctl["lam"], ctl["nc"], F8)[r]
    if ctl["jac"] != 0 and ctl["ck"] != 0.0 and lam != 0.0:
        _tangent(b, ctl, f, o, lam)
    return lam
