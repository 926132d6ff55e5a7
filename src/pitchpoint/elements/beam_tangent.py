# SPDX-License-Identifier: Apache-2.0
"""How the wrenches of a beam change: one motion of one body at a time, through every step of `beam_forces`.

A motion is a displacement by ck, a twist by cd and an acceleration by cm along one of six directions; all
changes are linear, so one pass gives the column of ck K + cd D + cm M.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.beam_forces import E, PI, PJ, TI, XI, XJ, _row, _set
from pitchpoint.multibody.vectors import add, cross, dot, less, times, triple, unit


@kernel
def _fixed(b, k, o, e, cm, cd, ck, turn):
    """Changes of a vector that is fixed to a body."""
    w = _row(b["w"], k)
    about = cross(turn, w)
    d = times(ck, about)
    first = cross(o, d)
    second = add(cross(e, d), cross(o, first))
    second = add(second, times(cd, add(cross(turn, _row(b["w1"], k)), cross(o, about))))
    _set(b["dw"], k, d)
    _set(b["dw1"], k, add(first, times(cd, about)))
    _set(b["dw2"], k, add(second, times(cm, about)))


@kernel
def _still(b, k):
    nothing = (0.0, 0.0, 0.0)
    _set(b["dw"], k, nothing)
    _set(b["dw1"], k, nothing)
    _set(b["dw2"], k, nothing)


@kernel
def _move(b, side, c, cm, cd, ck):
    """Changes of the vectors of both ends with motion c of one body."""
    shift = unit(c)
    turn = unit(c - 3)
    nothing = (0.0, 0.0, 0.0)
    other = 1 - side
    o = _row(b["omega"], side)
    e = _row(b["alpha"], side)
    arm = _row(b["arm"], side)
    about = cross(turn, arm)
    d = times(ck, about)
    first = cross(o, d)
    second = add(cross(e, d), cross(o, first))
    second = add(second, times(cd, add(cross(turn, cross(o, arm)), cross(o, about))))
    _set(b["d_arm"], side, d)
    _set(b["dw"], XI + side, add(times(ck, shift), d))
    _set(b["dw1"], XI + side, add(first, times(cd, add(shift, about))))
    _set(b["dw2"], XI + side, add(second, times(cm, add(shift, about))))
    _fixed(b, TI + side, o, e, cm, cd, ck, turn)
    _fixed(b, PI + side, o, e, cm, cd, ck, turn)
    _still(b, XI + other)
    _still(b, TI + other)
    _still(b, PI + other)
    _set(b["d_theta"], side, times(ck, turn))
    _set(b["d_omega"], side, times(cd, turn))
    _set(b["d_alpha"], side, times(cm, turn))
    _set(b["d_arm"], other, nothing)
    _set(b["d_theta"], other, nothing)
    _set(b["d_omega"], other, nothing)
    _set(b["d_alpha"], other, nothing)


@kernel
def _chord(b):
    """Changes of the direction of the chord; returns those of its length and of the rate of its length."""
    e = _row(b["w"], E)
    e1 = _row(b["w1"], E)
    ell = b["ell"]
    ell1 = b["ell1"]
    d1 = less(_row(b["w1"], XJ), _row(b["w1"], XI))
    d2 = less(_row(b["w2"], XJ), _row(b["w2"], XI))
    x = less(_row(b["dw"], XJ), _row(b["dw"], XI))
    x1 = less(_row(b["dw1"], XJ), _row(b["dw1"], XI))
    x2 = less(_row(b["dw2"], XJ), _row(b["dw2"], XI))
    d_ell = dot(e, x)
    de = times(1.0 / ell, less(x, times(d_ell, e)))
    d_ell1 = dot(de, d1) + dot(e, x1)
    de1 = less(x1, add(times(ell1, de), times(d_ell1, e)))
    de1 = times(1.0 / ell, less(de1, times(d_ell, e1)))
    square = dot(e1, e1)
    seen = add(_row(b["w2"], E), times(square, e))
    de2 = less(x2, add(times(dot(e, d2), de), times(dot(de, d2) + dot(e, x2), e)))
    de2 = less(de2, add(times(2.0 * d_ell1, e1), times(2.0 * ell1, de1)))
    de2 = times(1.0 / ell, less(de2, times(d_ell, seen)))
    de2 = less(de2, add(times(2.0 * dot(e1, de1), e), times(square, de)))
    _set(b["dw"], E, de)
    _set(b["dw1"], E, de1)
    _set(b["dw2"], E, de2)
    return d_ell, d_ell1


@kernel
def _spin(b):
    """Change of the mean spin about the chord."""
    o = add(_row(b["omega"], 0), _row(b["omega"], 1))
    do = add(_row(b["d_omega"], 0), _row(b["d_omega"], 1))
    return 0.5 * (dot(_row(b["dw"], E), o) + dot(_row(b["w"], E), do))


@kernel
def _seen(b, k, ds):
    """Change of the rate of slope k as seen from the turning chord."""
    e = _row(b["w"], E)
    e1 = _row(b["w1"], E)
    de = _row(b["dw"], E)
    frame = add(cross(e, e1), times(b["s"], e))
    d_frame = add(add(cross(de, e1), cross(e, _row(b["dw1"], E))), add(times(ds, e), times(b["s"], de)))
    dg = less(_row(b["dw"], TI + k), de)
    dg1 = less(_row(b["dw1"], TI + k), _row(b["dw1"], E))
    return less(dg1, add(cross(d_frame, _row(b["g"], k)), cross(frame, dg)))


@kernel
def _inertial(b, ds):
    """Changes of the inertia forces of the five vectors."""
    e = _row(b["w"], E)
    de = _row(b["dw"], E)
    for k in range(5):
        f = (0.0, 0.0, 0.0)
        for n in range(5):
            f = add(f, times(b["M"][k, n], _row(b["dw2"], n)))
        if k >= E:
            g = (0.0, 0.0, 0.0)
            dg = (0.0, 0.0, 0.0)
            for n in range(3):
                g = add(g, times(b["gyro"][k - E, n], _row(b["w1"], E + n)))
                dg = add(dg, times(b["gyro"][k - E, n], _row(b["dw1"], E + n)))
            f = add(f, times(ds, cross(g, e)))
            f = add(f, times(b["s"], add(cross(dg, e), cross(g, de))))
        _set(b["d_inert"], k, f)


@kernel
def _polar(b, k):
    """Change of the moment of the polar inertia on end k."""
    t = _row(b["w"], TI + k)
    dt = _row(b["dw"], TI + k)
    s = 0.0
    ds = 0.0
    for n in range(2):
        tn = _row(b["w"], TI + n)
        a = _row(b["alpha"], n)
        s += b["polar"][k, n] * dot(a, tn)
        ds += b["polar"][k, n] * (dot(_row(b["d_alpha"], n), tn) + dot(a, _row(b["dw"], TI + n)))
    return add(times(ds, t), times(s, dt))


@kernel
def _first_axis(b, k):
    """Change of the slope towards the first axis of end k, with its damping share."""
    e = _row(b["w"], E)
    de = _row(b["dw"], E)
    p = _row(b["w"], PI + k)
    dp = _row(b["dw"], PI + k)
    rate = dot(_row(b["dw1"], PI + k), e) + dot(_row(b["w1"], PI + k), de)
    rate += dot(dp, _row(b["w1"], E)) + dot(p, _row(b["dw1"], E))
    return dot(dp, e) + dot(p, de) + b["eta"] * rate


@kernel
def _twist(b):
    """Changes of the torque and of the vector m."""
    ti = _row(b["w"], TI)
    tj = _row(b["w"], TI + 1)
    di = _row(b["dw"], TI)
    dj = _row(b["dw"], TI + 1)
    m = triple(b["m"], 0)
    s = 1.0 / (1.0 + dot(ti, tj))
    dm = times(s, less(add(di, dj), times(dot(di, tj) + dot(ti, dj), m)))
    turn = less(_row(b["d_theta"], 1), _row(b["d_theta"], 0))
    rate = dot(dm, less(_row(b["omega"], 1), _row(b["omega"], 0)))
    rate += dot(m, less(_row(b["d_omega"], 1), _row(b["d_omega"], 0)))
    return b["k_t"] * (dot(m, turn) + b["eta"] * rate), dm


@kernel
def _slope_forces(b, d_ell, d_ell1, ds):
    """Changes of the tension, of the slopes' forces, and of the moment c of the dampers."""
    de = _row(b["dw"], E)
    de1 = _row(b["dw1"], E)
    g0 = less(_row(b["dw"], TI), de)
    g1 = less(_row(b["dw"], TI + 1), de)
    r0 = less(_row(b["dw1"], TI), de1)
    r1 = less(_row(b["dw1"], TI + 1), de1)
    bow = b["length"] / 30.0
    q0 = times(bow, less(times(4.0, g0), g1))
    q1 = times(bow, less(times(4.0, g1), g0))
    qi = _row(b["q"], 0)
    qj = _row(b["q"], 1)
    u = d_ell + dot(qi, g0) + dot(qj, g1)
    rate = d_ell1 + dot(q0, _row(b["g1"], 0)) + dot(q1, _row(b["g1"], 1)) + dot(qi, r0) + dot(qj, r1)
    dN = b["k_u"] * (u + b["eta"] * rate)
    s0 = add(g0, times(b["eta"], _seen(b, 0, ds)))
    s1 = add(g1, times(b["eta"], _seen(b, 1, ds)))
    f0 = add(times(b["k_a"], s0), times(b["k_b"], s1))
    f1 = add(times(b["k_a"], s1), times(b["k_b"], s0))
    f0 = add(f0, add(times(dN, qi), times(b["axial"], q0)))
    f1 = add(f1, add(times(dN, qj), times(b["axial"], q1)))
    c = add(cross(g0, _row(b["f"], 0)), cross(_row(b["g"], 0), f0))
    c = add(c, add(cross(g1, _row(b["f"], 1)), cross(_row(b["g"], 1), f1)))
    return dN, f0, f1, c


@kernel
def _end(b, k, df, dh, along, along_c, torque, dm):
    """Change of the moment of end k."""
    e = _row(b["w"], E)
    de = _row(b["dw"], E)
    t = _row(b["w"], TI + k)
    dt = _row(b["dw"], TI + k)
    p = _row(b["w"], PI + k)
    dp = _row(b["dw"], PI + k)
    h = b["h"][k]
    f = _row(b["f"], k)
    if b["mass"] > 0.0:
        f = add(f, _row(b["inert"], TI + k))
        df = add(df, _row(b["d_inert"], TI + k))
    mu = add(cross(dt, f), cross(t, df))
    mu = add(mu, add(cross(dp, times(h, e)), cross(p, add(times(dh, e), times(h, de)))))
    mu = less(mu, add(times(0.5 * along_c, e), times(0.5 * along, de)))
    sign = 1.0 if k == 1 else -1.0
    mu = add(mu, times(sign, add(times(torque, triple(b["m"], 0)), times(b["torque"], dm))))
    if b["mass"] > 0.0:
        mu = add(mu, _polar(b, k))
    return mu


@kernel
def _column(b, k, c, F, mu, to):
    """Subtract the change of the wrench on the body of end k from a column of a pair block."""
    moment = add(cross(_row(b["d_arm"], k), _row(b["F"], k)), cross(_row(b["arm"], k), F))
    moment = less(moment, mu)
    for r in range(3):
        to[r, c] -= F[r]
        to[3 + r, c] -= moment[r]


@kernel
def _motion(b, side, c, cm, cd, ck, to_i, to_j):
    """Column c of the pair blocks (i, side) and (j, side)."""
    _move(b, side, c, cm, cd, ck)
    d_ell, d_ell1 = _chord(b)
    ds = _spin(b)
    dN, f0, f1, dc = _slope_forces(b, d_ell, d_ell1, ds)
    e = _row(b["w"], E)
    de = _row(b["dw"], E)
    cv = triple(b["c"], 0)
    y0 = _first_axis(b, 0)
    y1 = _first_axis(b, 1)
    h0 = b["c_a"] * y0 + b["c_b"] * y1
    h1 = b["c_a"] * y1 + b["c_b"] * y0
    dG = times(-1.0, add(add(f0, f1), add(cross(dc, e), cross(cv, de))))
    dG = add(dG, add(times(h0, _row(b["w"], PI)), times(b["h"][0], _row(b["dw"], PI))))
    dG = add(dG, add(times(h1, _row(b["w"], PJ)), times(b["h"][1], _row(b["dw"], PJ))))
    if b["mass"] > 0.0:
        _inertial(b, ds)
        dG = add(dG, _row(b["d_inert"], E))
    G = triple(b["G"], 0)
    across = less(G, times(dot(G, e), e))
    turn = less(dG, add(times(dot(G, e), de), times(dot(dG, e) + dot(G, de), e)))
    turn = less(turn, times(d_ell / b["ell"], across))
    V = add(add(times(dN, e), times(b["axial"], de)), times(1.0 / b["ell"], turn))
    torque, dm = _twist(b)
    along = dot(cv, e)
    along_c = dot(dc, e) + dot(cv, de)
    mu_i = _end(b, 0, f0, h0, along, along_c, torque, dm)
    mu_j = _end(b, 1, f1, h1, along, along_c, torque, dm)
    Fi = V
    Fj = times(-1.0, V)
    if b["mass"] > 0.0:
        Fi = less(Fi, _row(b["d_inert"], XI))
        Fj = less(Fj, _row(b["d_inert"], XJ))
    if b["i"] != 0:
        _column(b, 0, c, Fi, mu_i, to_i)
    if b["j"] != 0:
        _column(b, 1, c, Fj, mu_j, to_j)


@kernel
def tangent(b, kk, cm, cd, ck):
    """Add ck K + cd D + cm M of one beam to its pair blocks; `loads` was called before."""
    for c in range(6):
        if b["i"] != 0:
            _motion(b, 0, c, cm, cd, ck, kk[b["ii"]], kk[b["ji"]])
        if b["j"] != 0:
            _motion(b, 1, c, cm, cd, ck, kk[b["ij"]], kk[b["jj"]])
