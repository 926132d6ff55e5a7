# SPDX-License-Identifier: Apache-2.0
"""Wrench and modal forces of an elastic body; equations in `flexible_body`.

Exact tangents are their derivatives for one motion of the frame or of one modal coordinate at a time.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.multibody.vectors import add, cross, dot, into_body, into_world, less, times, triple, unit


@kernel
def hidden(b, g):
    """Hidden body of the modal coordinates of group g."""
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
    """Column k of an array of three rows."""
    return x[0, k], x[1, k], x[2, k]


@kernel
def row(x, k):
    """Row k of an array of three columns."""
    return x[k, 0], x[k, 1], x[k, 2]


@kernel
def put(x, k, a):
    """Write row k."""
    x[k, 0] = a[0]
    x[k, 1] = a[1]
    x[k, 2] = a[2]


@kernel
def coordinates(b, fr):
    """Read the modal coordinates with their first and second time derivatives."""
    for k in range(b["n"]):
        f = fr[hidden(b, k // 3)]
        b["eta"][0, k] = f["r"][k % 3]
        b["eta"][1, k] = f["tw"][k % 3]
        b["eta"][2, k] = f["ac"][k % 3]


@kernel
def combine(P, eta, order, n):
    """P times the modal coordinates (`order` 0) or their time derivatives (1, 2)."""
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
    """Load r with geometric stiffness: component of a or product of components of omega."""
    if r < 3:
        return a[r]
    if r < 6:
        return w[r - 3] * w[r - 3]
    return w[r - 6] * w[(r - 5) % 3]


@kernel
def _integrals(b):
    """Set s, J and C of the deflected body, and the time derivatives of s and J."""
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
    """Set the modal forces and the geometric stiffness."""
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
    """Set the wrench on the frame, in its axes, and the modal forces."""
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
    """Add the wrench to the frame and the modal forces to the hidden bodies."""
    force = into_world(f["S"], triple(b["F"], 0))
    moment = into_world(f["S"], triple(b["F"], 3))
    for r in range(3):
        f["F"][r] += force[r]
        f["F"][3 + r] += moment[r]
    for k in range(b["n"]):
        fr[hidden(b, k // 3)]["F"][k % 3] += b["Q"][k]


@kernel
def _swing(b):
    """Changes of J alpha, J omega, J' omega, C eta'' and C eta' with the modal coordinates."""
    n = b["n"]
    alpha = row(b["x"], 1)
    w = row(b["x"], 2)
    eta = b["eta"]
    d = b["d_eta"]
    ja = (0.0, 0.0, 0.0)
    jw = (0.0, 0.0, 0.0)
    j1 = (0.0, 0.0, 0.0)
    c2 = combine(b["C"], d, 2, n)
    c1 = combine(b["C"], d, 1, n)
    for k in range(n):
        x = d[0, k]
        y = d[1, k]
        if x != 0.0 or y != 0.0:
            by = into_world(b["Jk"][k], w)
            ja = add(ja, times(x, into_world(b["Jk"][k], alpha)))
            jw = add(jw, times(x, by))
            j1 = add(j1, times(y, by))
        if x != 0.0:
            for h in range(n):
                j1 = add(j1, times(2.0 * x * eta[1, h], into_world(b["J2"][k, h], w)))
                A = (b["A"][k, 0, h], b["A"][k, 1, h], b["A"][k, 2, h])
                c2 = add(c2, times(x * eta[2, h], A))
                c1 = add(c1, times(x * eta[1, h], A))
    return ja, jw, j1, c2, c1


@kernel
def _modal_change(b, k, da, dalpha, dw):
    """Change of modal force k."""
    n = b["n"]
    alpha = row(b["x"], 1)
    w = row(b["x"], 2)
    eta = b["eta"]
    d = b["d_eta"]
    q = dot(column(b["P"], k), da) + dot(column(b["C"], k), dalpha) - dot(dw, into_world(b["Jk"][k], w))
    for h in range(n):
        A = (b["A"][h, 0, k], b["A"][h, 1, k], b["A"][h, 2, k])
        if d[0, h] != 0.0:
            q += d[0, h] * (dot(A, alpha) - dot(w, into_world(b["J2"][k, h], w)))
        q += 2.0 * (dot(A, dw) * eta[1, h] + dot(A, w) * d[1, h])
        q += b["modal"][k, h] * d[2, h] + b["D"][k, h] * d[1, h] + (b["K"][k, h] + b["Kg"][k, h]) * d[0, h]
        Kg = 0.0
        for r in range(9):
            if r < 3:
                change = da[r]
            elif r < 6:
                change = 2.0 * w[r - 3] * dw[r - 3]
            else:
                change = w[r - 6] * dw[(r - 5) % 3] + dw[r - 6] * w[(r - 5) % 3]
            Kg += change * b["geo"][r, k, h]
        q += Kg * eta[0, h]
    return -q


@kernel
def _change(b):
    """Changes of wrench and modal forces for given changes of frame motion and modal coordinates."""
    n = b["n"]
    a = row(b["x"], 0)
    alpha = row(b["x"], 1)
    w = row(b["x"], 2)
    da = row(b["d_x"], 0)
    dalpha = row(b["d_x"], 1)
    dw = row(b["d_x"], 2)
    s = row(b["s"], 0)
    s1 = row(b["s"], 1)
    ds = combine(b["P"], b["d_eta"], 0, n)
    ds1 = combine(b["P"], b["d_eta"], 1, n)
    ds2 = combine(b["P"], b["d_eta"], 2, n)
    ws = cross(w, s)
    force = add(times(b["mass"], da), add(cross(dalpha, s), cross(alpha, ds)))
    force = add(force, add(cross(dw, ws), cross(w, add(cross(dw, s), cross(w, ds)))))
    force = add(force, add(times(2.0, add(cross(dw, s1), cross(w, ds1))), ds2))
    ja, jw, j1, c2, c1 = _swing(b)
    Jw = into_world(b["J"], w)
    moment = add(add(cross(ds, a), cross(s, da)), add(into_world(b["J"], dalpha), ja))
    moment = add(moment, add(cross(dw, Jw), cross(w, add(into_world(b["J"], dw), jw))))
    moment = add(moment, add(into_world(b["dJ"], dw), add(j1, c2)))
    moment = add(moment, add(cross(dw, combine(b["C"], b["eta"], 1, n)), cross(w, c1)))
    for r in range(3):
        b["dF"][r] = -force[r]
        b["dF"][3 + r] = -moment[r]
    for k in range(n):
        b["dQ"][k] = _modal_change(b, k, da, dalpha, dw)


@kernel
def _column(b, S, turn, kk, p, c):
    """Subtract the changes from column c of the blocks with body p; `turn`: rotation of the frame axes."""
    F = triple(b["F"], 0)
    M = triple(b["F"], 3)
    force = into_world(S, add(triple(b["dF"], 0), cross(turn, F)))
    moment = into_world(S, add(triple(b["dF"], 3), cross(turn, M)))
    k = kk[b["pairs"][0, p]]
    for r in range(3):
        k[r, c] -= force[r]
        k[3 + r, c] -= moment[r]
    for h in range(b["n"]):
        kk[b["pairs"][1 + h // 3, p], h % 3, c] -= b["dQ"][h]


@kernel
def tangent(b, S, kk, cm, cd, ck):
    """Add ck K + cd D + cm M of one elastic body to its pair blocks; call `loads` first."""
    nothing = (0.0, 0.0, 0.0)
    for order in range(3):
        for k in range(b["n"]):
            b["d_eta"][order, k] = 0.0
    for c in range(6):
        shift = into_body(S, unit(c))
        turn = into_body(S, unit(c - 3))
        spun = times(ck, turn)
        put(b["d_x"], 0, less(times(cm, shift), cross(spun, row(b["x"], 0))))
        put(b["d_x"], 1, less(times(cm, turn), cross(spun, row(b["x"], 1))))
        put(b["d_x"], 2, less(times(cd, turn), cross(spun, row(b["x"], 2))))
        _change(b)
        _column(b, S, spun, kk, 0, c)
    for order in range(3):
        put(b["d_x"], order, nothing)
    for k in range(b["n"]):
        b["d_eta"][0, k] = ck
        b["d_eta"][1, k] = cd
        b["d_eta"][2, k] = cm
        _change(b)
        _column(b, S, nothing, kk, 1 + k // 3, k % 3)
        for order in range(3):
            b["d_eta"][order, k] = 0.0
