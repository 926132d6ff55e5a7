# SPDX-License-Identifier: Apache-2.0
"""Exact tangents of a beam: derivative of each step of `beams.forces` for one motion of one body at a time.

A motion is a displacement ck, a velocity cd and an acceleration cm in one of six directions; the derivative
is linear in them, so one pass gives one column of ck K + cd D + cm M.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.beams.coupled import coupled_changes, coupled_chord_change, coupled_moment_change
from pitchpoint.elements.beams.record import PI, PJ, QI, TI, TJ, XI, XJ, E
from pitchpoint.multibody.vectors import add, cross, dot, less, row, set_row, times, triple, unit


@kernel
def _fixed(b, k, o, e, cm, cd, ck, turn):
    """Changes of a body-fixed vector and of its time derivatives."""
    w = row(b["w"], k)
    about = cross(turn, w)
    d = times(ck, about)
    first = cross(o, d)
    second = add(cross(e, d), cross(o, first))
    second = add(second, times(cd, add(cross(turn, row(b["w1"], k)), cross(o, about))))
    set_row(b["dw"], k, d)
    set_row(b["dw1"], k, add(first, times(cd, about)))
    set_row(b["dw2"], k, add(second, times(cm, about)))


@kernel
def _no_motion(b, k):
    nothing = (0.0, 0.0, 0.0)
    set_row(b["dw"], k, nothing)
    set_row(b["dw1"], k, nothing)
    set_row(b["dw2"], k, nothing)


@kernel
def _move(b, side, c, cm, cd, ck):
    """Changes of the vectors of both ends for motion c of one body."""
    shift = unit(c)
    turn = unit(c - 3)
    nothing = (0.0, 0.0, 0.0)
    other = 1 - side
    o = row(b["omega"], side)
    e = row(b["alpha"], side)
    arm = row(b["arm"], side)
    about = cross(turn, arm)
    d = times(ck, about)
    first = cross(o, d)
    second = add(cross(e, d), cross(o, first))
    second = add(second, times(cd, add(cross(turn, cross(o, arm)), cross(o, about))))
    set_row(b["d_arm"], side, d)
    set_row(b["dw"], XI + side, add(times(ck, shift), d))
    set_row(b["dw1"], XI + side, add(first, times(cd, add(shift, about))))
    set_row(b["dw2"], XI + side, add(second, times(cm, add(shift, about))))
    _fixed(b, TI + side, o, e, cm, cd, ck, turn)
    _fixed(b, PI + side, o, e, cm, cd, ck, turn)
    _no_motion(b, XI + other)
    _no_motion(b, TI + other)
    _no_motion(b, PI + other)
    if b["coupled"] != 0:
        _fixed(b, QI + side, o, e, cm, cd, ck, turn)
        _no_motion(b, QI + other)
    set_row(b["d_theta"], side, times(ck, turn))
    set_row(b["d_omega"], side, times(cd, turn))
    set_row(b["d_alpha"], side, times(cm, turn))
    set_row(b["d_arm"], other, nothing)
    set_row(b["d_theta"], other, nothing)
    set_row(b["d_omega"], other, nothing)
    set_row(b["d_alpha"], other, nothing)


@kernel
def _chord(b):
    """Changes of the chord direction; returns the changes of the chord length and of its rate."""
    e = row(b["w"], E)
    e1 = row(b["w1"], E)
    ell = b["ell"]
    ell1 = b["ell1"]
    d1 = less(row(b["w1"], XJ), row(b["w1"], XI))
    d2 = less(row(b["w2"], XJ), row(b["w2"], XI))
    x = less(row(b["dw"], XJ), row(b["dw"], XI))
    x1 = less(row(b["dw1"], XJ), row(b["dw1"], XI))
    x2 = less(row(b["dw2"], XJ), row(b["dw2"], XI))
    d_ell = dot(e, x)
    de = times(1.0 / ell, less(x, times(d_ell, e)))
    d_ell1 = dot(de, d1) + dot(e, x1)
    de1 = less(x1, add(times(ell1, de), times(d_ell1, e)))
    de1 = times(1.0 / ell, less(de1, times(d_ell, e1)))
    square = dot(e1, e1)
    seen = add(row(b["w2"], E), times(square, e))
    de2 = less(x2, add(times(dot(e, d2), de), times(dot(de, d2) + dot(e, x2), e)))
    de2 = less(de2, add(times(2.0 * d_ell1, e1), times(2.0 * ell1, de1)))
    de2 = times(1.0 / ell, less(de2, times(d_ell, seen)))
    de2 = less(de2, add(times(2.0 * dot(e1, de1), e), times(square, de)))
    set_row(b["dw"], E, de)
    set_row(b["dw1"], E, de1)
    set_row(b["dw2"], E, de2)
    return d_ell, d_ell1


@kernel
def _spin(b):
    """Change of the mean spin about the chord."""
    o = add(row(b["omega"], 0), row(b["omega"], 1))
    do = add(row(b["d_omega"], 0), row(b["d_omega"], 1))
    return 0.5 * (dot(row(b["dw"], E), o) + dot(row(b["w"], E), do))


@kernel
def _inertial(b, ds):
    """Changes of the inertia forces of the five vectors."""
    e = row(b["w"], E)
    de = row(b["dw"], E)
    for k in range(5):
        f = (0.0, 0.0, 0.0)
        for n in range(5):
            f = add(f, times(b["M"][k, n], row(b["dw2"], n)))
        if k >= E:
            g = (0.0, 0.0, 0.0)
            dg = (0.0, 0.0, 0.0)
            for n in range(3):
                g = add(g, times(b["gyro"][k - E, n], row(b["w1"], E + n)))
                dg = add(dg, times(b["gyro"][k - E, n], row(b["dw1"], E + n)))
            f = add(f, times(ds, cross(g, e)))
            f = add(f, times(b["s"], add(cross(dg, e), cross(g, de))))
        set_row(b["d_inert"], k, f)


@kernel
def _polar(b, k):
    """Change of the moment of the polar inertia on end k."""
    t = row(b["w"], TI + k)
    dt = row(b["dw"], TI + k)
    s = 0.0
    ds = 0.0
    for n in range(2):
        tn = row(b["w"], TI + n)
        a = row(b["alpha"], n)
        s += b["polar"][k, n] * dot(a, tn)
        ds += b["polar"][k, n] * (dot(row(b["d_alpha"], n), tn) + dot(a, row(b["dw"], TI + n)))
    return add(times(ds, t), times(s, dt))


@kernel
def _first_axis(b, k):
    """Change of the slope towards the first axis of end k, with its damping share."""
    e = row(b["w"], E)
    de = row(b["dw"], E)
    p = row(b["w"], PI + k)
    dp = row(b["dw"], PI + k)
    rate = dot(row(b["dw1"], PI + k), e) + dot(row(b["w1"], PI + k), de)
    rate += dot(dp, row(b["w1"], E)) + dot(p, row(b["dw1"], E))
    return dot(dp, e) + dot(p, de) + b["eta"] * rate


@kernel
def _twist(b):
    """Changes of the torque and of the vector m."""
    ti = row(b["w"], TI)
    tj = row(b["w"], TI + 1)
    di = row(b["dw"], TI)
    dj = row(b["dw"], TI + 1)
    m = triple(b["m"], 0)
    s = 1.0 / (1.0 + dot(ti, tj))
    dm = times(s, less(add(di, dj), times(dot(di, tj) + dot(ti, dj), m)))
    turn = less(row(b["d_theta"], 1), row(b["d_theta"], 0))
    rate = dot(dm, less(row(b["omega"], 1), row(b["omega"], 0)))
    rate += dot(m, less(row(b["d_omega"], 1), row(b["d_omega"], 0)))
    b["y"][2, 1] = dot(m, turn)
    b["y"][3, 1] = rate
    return b["k_t"] * (dot(m, turn) + b["eta"] * rate), dm


@kernel
def _bend(b, ds):
    """Changes of difference of the normals and sum of the slopes, of their rates in world axes and in axes
    that rotate with the chord, and of the sum of the cosines."""
    e = row(b["w"], E)
    e1 = row(b["w1"], E)
    de = row(b["dw"], E)
    de1 = row(b["dw1"], E)
    both = add(row(b["w"], TI), row(b["w"], TJ))
    both1 = add(row(b["w1"], TI), row(b["w1"], TJ))
    x = add(row(b["dw"], TI), row(b["dw"], TJ))
    x1 = add(row(b["dw1"], TI), row(b["dw1"], TJ))
    dcos = dot(x, e) + dot(both, de)
    dcos1 = dot(x1, e) + dot(both1, de) + dot(x, e1) + dot(both, de1)
    D = less(row(b["dw"], TJ), row(b["dw"], TI))
    D1 = less(row(b["dw1"], TJ), row(b["dw1"], TI))
    S = less(x, add(times(dcos, e), times(b["cos"], de)))
    S1 = less(x1, add(times(dcos1, e), times(b["cos1"], de)))
    S1 = less(S1, add(times(dcos, e1), times(b["cos"], de1)))
    frame = add(cross(e, e1), times(b["s"], e))
    turn = add(add(cross(de, e1), cross(e, de1)), add(times(ds, e), times(b["s"], de)))
    D2 = less(D1, add(cross(turn, row(b["D"], 0)), cross(frame, D)))
    S2 = less(S1, add(cross(turn, row(b["S"], 0)), cross(frame, S)))
    return D, D1, D2, S, S1, S2, dcos


@kernel
def _bend_forces(b, d_ell, d_ell1, ds):
    """Changes of axial force, bending forces, damper moment c and sum of the cosines."""
    D, D1, D2, S, S1, S2, dcos = _bend(b, ds)
    x = row(b["D"], 0)
    y = row(b["S"], 0)
    length = b["length"]
    eta = b["eta"]
    half = 0.5 * b["n_s"]
    arc = b["arc"]
    dw = dot(row(b["dw"], TI), row(b["w"], TJ)) + dot(row(b["w"], TI), row(b["dw"], TJ))
    darc = b["arc1"] * dw
    u = d_ell + length * (dot(y, S) / half - arc * dw / 12.0)
    x1 = row(b["D"], 1)
    rate = arc * (dot(D, x1) + dot(x, D1)) + darc * dot(x, x1)
    rate = d_ell1 + length * (rate / 12.0 + (dot(S, row(b["S"], 1)) + dot(y, S1)) / half)
    dN = b["k_u"] * (u + eta * rate)
    if b["coupled"] != 0:
        b["y"][2, 0] = u
        b["y"][3, 0] = rate
        coupled_changes(b)
        dN += b["g"][1, 0]
    stiff = b["k_d"] + b["axial"] * length / 12.0
    fd = add(times(stiff * darc + dN * length / 12.0 * arc, x), times(stiff * arc, D))
    fd = add(fd, times(eta * b["k_d"], D2))
    fs = add(times(dN * length / half, y), times(b["k_s"] + b["axial"] * length / half, S))
    fs = add(fs, times(eta * b["k_s"], S2))
    c = add(cross(D, triple(b["f_d"], 0)), cross(x, fd))
    c = add(c, add(cross(S, triple(b["f_s"], 0)), cross(y, fs)))
    return dN, fd, fs, c, dcos


@kernel
def _end(b, k, df, dh, along, along_c, torque, dm):
    """Change of the moment at end k."""
    e = row(b["w"], E)
    de = row(b["dw"], E)
    t = row(b["w"], TI + k)
    dt = row(b["dw"], TI + k)
    p = row(b["w"], PI + k)
    dp = row(b["dw"], PI + k)
    h = b["h"][k]
    sign = 1.0 if k == 1 else -1.0
    f = add(triple(b["f_s"], 0), times(sign, triple(b["f_d"], 0)))
    if b["mass"] > 0.0:
        f = add(f, row(b["inert"], TI + k))
        df = add(df, row(b["d_inert"], TI + k))
    mu = add(cross(dt, f), cross(t, df))
    mu = add(mu, add(cross(dp, times(h, e)), cross(p, add(times(dh, e), times(h, de)))))
    if b["coupled"] != 0:
        mu = add(mu, coupled_moment_change(b, k))
    mu = less(mu, add(times(0.5 * along_c, e), times(0.5 * along, de)))
    mu = add(mu, times(sign, add(times(torque, triple(b["m"], 0)), times(b["torque"], dm))))
    if b["mass"] > 0.0:
        mu = add(mu, _polar(b, k))
    return mu


@kernel
def _column(b, k, c, F, mu, to):
    """Subtract the change of the wrench on the body of end k from column c of a pair block."""
    moment = add(cross(row(b["d_arm"], k), row(b["F"], k)), cross(row(b["arm"], k), F))
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
    torque, dm = _twist(b)
    dN, fd, fs, dc, dcos = _bend_forces(b, d_ell, d_ell1, ds)
    e = row(b["w"], E)
    de = row(b["dw"], E)
    cv = triple(b["c"], 0)
    y0 = _first_axis(b, 0)
    y1 = _first_axis(b, 1)
    h0 = b["c_a"] * y0 + b["c_b"] * y1
    h1 = b["c_a"] * y1 + b["c_b"] * y0
    if b["coupled"] != 0:
        torque += b["g"][1, 1]
    dG = add(times(b["cos"], fs), times(dcos, triple(b["f_s"], 0)))
    dG = times(-1.0, add(dG, add(cross(dc, e), cross(cv, de))))
    dG = add(dG, add(times(h0, row(b["w"], PI)), times(b["h"][0], row(b["dw"], PI))))
    dG = add(dG, add(times(h1, row(b["w"], PJ)), times(b["h"][1], row(b["dw"], PJ))))
    if b["coupled"] != 0:
        dG = add(dG, coupled_chord_change(b))
    if b["mass"] > 0.0:
        _inertial(b, ds)
        dG = add(dG, row(b["d_inert"], E))
    G = triple(b["G"], 0)
    across = less(G, times(dot(G, e), e))
    turn = less(dG, add(times(dot(G, e), de), times(dot(dG, e) + dot(G, de), e)))
    turn = less(turn, times(d_ell / b["ell"], across))
    V = add(add(times(dN, e), times(b["axial"], de)), times(1.0 / b["ell"], turn))
    along = dot(cv, e)
    along_c = dot(dc, e) + dot(cv, de)
    mu_i = _end(b, 0, less(fs, fd), h0, along, along_c, torque, dm)
    mu_j = _end(b, 1, add(fs, fd), h1, along, along_c, torque, dm)
    Fi = V
    Fj = times(-1.0, V)
    if b["mass"] > 0.0:
        Fi = less(Fi, row(b["d_inert"], XI))
        Fj = less(Fj, row(b["d_inert"], XJ))
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
