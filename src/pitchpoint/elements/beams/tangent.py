# SPDX-License-Identifier: Apache-2.0
"""Exact tangents of a beam: derivative of each step of `beams.forces` for one motion of one body at a time.

A motion is a displacement ck, a velocity cd and an acceleration cm in one of six directions; the derivative
is linear in them, so one pass gives one column of ck K + cd D + cm M.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.beams.forces import PI, PJ, TI, TJ, XI, XJ, E, _row, _set
from pitchpoint.multibody.vectors import add, cross, dot, less, times, triple, unit


@kernel
def _fixed(b, k, o, e, cm, cd, ck, turn):
    """Changes of a body-fixed vector and of its time derivatives."""
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
def _no_motion(b, k):
    nothing = (0.0, 0.0, 0.0)
    _set(b["dw"], k, nothing)
    _set(b["dw1"], k, nothing)
    _set(b["dw2"], k, nothing)


@kernel
def _move(b, side, c, cm, cd, ck):
    """Changes of the vectors of both ends for motion c of one body."""
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
    _no_motion(b, XI + other)
    _no_motion(b, TI + other)
    _no_motion(b, PI + other)
    _set(b["d_theta"], side, times(ck, turn))
    _set(b["d_omega"], side, times(cd, turn))
    _set(b["d_alpha"], side, times(cm, turn))
    _set(b["d_arm"], other, nothing)
    _set(b["d_theta"], other, nothing)
    _set(b["d_omega"], other, nothing)
    _set(b["d_alpha"], other, nothing)


@kernel
def _chord(b):
    """Changes of the chord direction; returns the changes of the chord length and of its rate."""
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
def _bend(b, ds):
    """Changes of difference of the normals and sum of the slopes, of their rates in world axes and in axes
    that rotate with the chord, and of the sum of the cosines."""
    e = _row(b["w"], E)
    e1 = _row(b["w1"], E)
    de = _row(b["dw"], E)
    de1 = _row(b["dw1"], E)
    both = add(_row(b["w"], TI), _row(b["w"], TJ))
    both1 = add(_row(b["w1"], TI), _row(b["w1"], TJ))
    x = add(_row(b["dw"], TI), _row(b["dw"], TJ))
    x1 = add(_row(b["dw1"], TI), _row(b["dw1"], TJ))
    dcos = dot(x, e) + dot(both, de)
    dcos1 = dot(x1, e) + dot(both1, de) + dot(x, e1) + dot(both, de1)
    D = less(_row(b["dw"], TJ), _row(b["dw"], TI))
    D1 = less(_row(b["dw1"], TJ), _row(b["dw1"], TI))
    S = less(x, add(times(dcos, e), times(b["cos"], de)))
    S1 = less(x1, add(times(dcos1, e), times(b["cos1"], de)))
    S1 = less(S1, add(times(dcos, e1), times(b["cos"], de1)))
    frame = add(cross(e, e1), times(b["s"], e))
    turn = add(add(cross(de, e1), cross(e, de1)), add(times(ds, e), times(b["s"], de)))
    D2 = less(D1, add(cross(turn, _row(b["D"], 0)), cross(frame, D)))
    S2 = less(S1, add(cross(turn, _row(b["S"], 0)), cross(frame, S)))
    return D, D1, D2, S, S1, S2, dcos


@kernel
def _bend_forces(b, d_ell, d_ell1, ds):
    """Changes of axial force, bending forces, damper moment c and sum of the cosines."""
    D, D1, D2, S, S1, S2, dcos = _bend(b, ds)
    x = _row(b["D"], 0)
    y = _row(b["S"], 0)
    length = b["length"]
    eta = b["eta"]
    arc = b["arc"]
    dw = dot(_row(b["dw"], TI), _row(b["w"], TJ)) + dot(_row(b["w"], TI), _row(b["dw"], TJ))
    darc = b["arc1"] * dw
    u = d_ell + length * (dot(y, S) / 20.0 - arc * dw / 12.0)
    x1 = _row(b["D"], 1)
    rate = arc * (dot(D, x1) + dot(x, D1)) + darc * dot(x, x1)
    rate = d_ell1 + length * (rate / 12.0 + (dot(S, _row(b["S"], 1)) + dot(y, S1)) / 20.0)
    dN = b["k_u"] * (u + eta * rate)
    stiff = b["k_d"] + b["axial"] * length / 12.0
    fd = add(times(stiff * darc + dN * length / 12.0 * arc, x), times(stiff * arc, D))
    fd = add(fd, times(eta * b["k_d"], D2))
    fs = add(times(dN * length / 20.0, y), times(b["k_s"] + b["axial"] * length / 20.0, S))
    fs = add(fs, times(eta * b["k_s"], S2))
    c = add(cross(D, triple(b["f_d"], 0)), cross(x, fd))
    c = add(c, add(cross(S, triple(b["f_s"], 0)), cross(y, fs)))
    return dN, fd, fs, c, dcos


@kernel
def _end(b, k, df, dh, along, along_c, torque, dm):
    """Change of the moment at end k."""
    e = _row(b["w"], E)
    de = _row(b["dw"], E)
    t = _row(b["w"], TI + k)
    dt = _row(b["dw"], TI + k)
    p = _row(b["w"], PI + k)
    dp = _row(b["dw"], PI + k)
    h = b["h"][k]
    sign = 1.0 if k == 1 else -1.0
    f = add(triple(b["f_s"], 0), times(sign, triple(b["f_d"], 0)))
    if b["mass"] > 0.0:
        f = add(f, _row(b["inert"], TI + k))
        df = add(df, _row(b["d_inert"], TI + k))
    mu = add(cross(dt, f), cross(t, df))
    mu = add(mu, add(cross(dp, times(h, e)), cross(p, add(times(dh, e), times(h, de)))))
    mu = less(mu, add(times(0.5 * along_c, e), times(0.5 * along, de)))
    mu = add(mu, times(sign, add(times(torque, triple(b["m"], 0)), times(b["torque"], dm))))
    if b["mass"] > 0.0:
        mu = add(mu, _polar(b, k))
    return mu


@kernel
def _column(b, k, c, F, mu, to):
    """Subtract the change of the wrench on the body of end k from column c of a pair block."""
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
    dN, fd, fs, dc, dcos = _bend_forces(b, d_ell, d_ell1, ds)
    e = _row(b["w"], E)
    de = _row(b["dw"], E)
    cv = triple(b["c"], 0)
    y0 = _first_axis(b, 0)
    y1 = _first_axis(b, 1)
    h0 = b["c_a"] * y0 + b["c_b"] * y1
    h1 = b["c_a"] * y1 + b["c_b"] * y0
    dG = add(times(b["cos"], fs), times(dcos, triple(b["f_s"], 0)))
    dG = times(-1.0, add(dG, add(cross(dc, e), cross(cv, de))))
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
    mu_i = _end(b, 0, less(fs, fd), h0, along, along_c, torque, dm)
    mu_j = _end(b, 1, add(fs, fd), h1, along, along_c, torque, dm)
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
    """Add ck K + cd D + cm M of one beam to its pair blocks; call `loads` first."""
    for c in range(6):
        if b["i"] != 0:
            _motion(b, 0, c, cm, cd, ck, kk[b["ii"]], kk[b["ji"]])
        if b["j"] != 0:
            _motion(b, 1, c, cm, cd, ck, kk[b["ij"]], kk[b["jj"]])
