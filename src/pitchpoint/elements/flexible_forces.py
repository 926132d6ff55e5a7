# SPDX-License-Identifier: Apache-2.0
"""Wrench and modal forces of an elastic body; equations in `flexible_body`."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.multibody.vectors import add, cross, dot, into_body, into_world, less, times, triple


@kernel
def hidden(b, g):
    """Body that carries the modal coordinates of group g."""
    if g == 0:
        return b["j"]
    if g == 1:
        return b["k"]
    if g == 2:
        return b["l"]
    if g == 3:
        return b["m"]
    if g == 4:
        return b["m5"]
    if g == 5:
        return b["m6"]
    if g == 6:
        return b["m7"]
    if g == 7:
        return b["m8"]
    return b["m9"] if g == 8 else b["m10"]


@kernel
def column(x, k):
    """Column k of three rows."""
    return x[0, k], x[1, k], x[2, k]


@kernel
def row(x, k):
    """Row k of three numbers."""
    return x[k, 0], x[k, 1], x[k, 2]


@kernel
def put(x, k, a):
    """Write row k."""
    x[k, 0] = a[0]
    x[k, 1] = a[1]
    x[k, 2] = a[2]


@kernel
def coordinates(b, fr):
    """Read the modal coordinates, their rates and second rates."""
    for k in range(b["n"]):
        f = fr[hidden(b, k // 3)]
        b["eta"][0, k] = f["r"][k % 3]
        b["eta"][1, k] = f["tw"][k % 3]
        b["eta"][2, k] = f["ac"][k % 3]


@kernel
def combine(P, eta, order, n):
    """Sum of columns of P with the coordinates, rates or second rates."""
    x = 0.0
    y = 0.0
    z = 0.0
    for k in range(n):
        e = eta[order, k]
        x += P[0, k] * e
        y += P[1, k] * e
        z += P[2, k] * e
    return x, y, z


@kernel
def load(b, r, a, w):
    """Load r of those that stiffen the body."""
    if r < 3:
        return a[r]
    if r < 6:
        return w[r - 3] * w[r - 3]
    return w[r - 6] * w[(r - 5) % 3]


@kernel
def _integrals(b):
    """Moments, inertia and their changes at the deflection."""
    n = b["n"]
    eta = b["eta"]
    for order in range(3):
        put(b["s"], order, combine(b["P"], eta, order, n))
    put(b["s"], 0, add(row(b["s"], 0), triple(b["first"], 0)))
    for i in range(3):
        for j in range(3):
            J = b["inertia"][i, j]
            dJ = 0.0
            for k in range(n):
                half = 0.0
                for h in range(n):
                    half += b["J2"][k, h, i, j] * eta[0, h]
                b["Jk"][k, i, j] = b["J1"][k, i, j] + 2.0 * half
                J += eta[0, k] * (b["J1"][k, i, j] + half)
                dJ += eta[1, k] * b["Jk"][k, i, j]
            b["J"][i, j] = J
            b["dJ"][i, j] = dJ
        for k in range(n):
            C = b["C0"][i, k]
            for h in range(n):
                C += eta[0, h] * b["A"][h, i, k]
            b["C"][i, k] = C


@kernel
def _modal(b, a, alpha, w):
    """Modal forces and the stiffness by loads."""
    n = b["n"]
    eta = b["eta"]
    for k in range(n):
        q = dot(column(b["P"], k), a) + dot(column(b["C"], k), alpha)
        q -= 0.5 * dot(w, into_world(b["Jk"][k], w))
        for h in range(n):
            Kg = 0.0
            for r in range(9):
                Kg += load(b, r, a, w) * b["geo"][r, k, h]
            b["Kg"][k, h] = Kg
            coriolis = b["A"][h, 0, k] * w[0] + b["A"][h, 1, k] * w[1] + b["A"][h, 2, k] * w[2]
            q += b["modal"][k, h] * eta[2, h] + (2.0 * coriolis + b["D"][k, h]) * eta[1, h]
            q += (b["K"][k, h] + Kg) * eta[0, h]
        b["Q"][k] = -q


@kernel
def loads(b, f):
    """Wrench on the frame and modal forces, in the axes of the frame."""
    S = f["S"]
    a = into_body(S, less(triple(f["ac"], 0), triple(b["gravity"], 0)))
    alpha = into_body(S, triple(f["ac"], 3))
    w = into_body(S, triple(f["tw"], 3))
    put(b["x"], 0, a)
    put(b["x"], 1, alpha)
    put(b["x"], 2, w)
    _integrals(b)
    s = row(b["s"], 0)
    force = add(times(b["mass"], a), add(cross(alpha, s), cross(w, cross(w, s))))
    force = add(force, add(times(2.0, cross(w, row(b["s"], 1))), row(b["s"], 2)))
    n = b["n"]
    moment = add(cross(s, a), add(into_world(b["J"], alpha), cross(w, into_world(b["J"], w))))
    moment = add(moment, add(into_world(b["dJ"], w), combine(b["C"], b["eta"], 2, n)))
    moment = add(moment, cross(w, combine(b["C"], b["eta"], 1, n)))
    for r in range(3):
        b["F"][r] = -force[r]
        b["F"][3 + r] = -moment[r]
    _modal(b, a, alpha, w)


@kernel
def shares(b, f, fr):
    """Give the wrenches to the bodies."""
    force = into_world(f["S"], triple(b["F"], 0))
    moment = into_world(f["S"], triple(b["F"], 3))
    for r in range(3):
        f["F"][r] += force[r]
        f["F"][3 + r] += moment[r]
    for k in range(b["n"]):
        fr[hidden(b, k // 3)]["F"][k % 3] += b["Q"][k]
