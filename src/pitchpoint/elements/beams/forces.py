# SPDX-License-Identifier: Apache-2.0
"""Forces of beams between rotating bodies: small strains, rotations of any size.

With e the direction of the chord from node i to node j and t_i, t_j the normals of the end sections, bending
is described by the angle a between both normals and the sum of their slopes against the chord, s = t_i + t_j
less its component along e. With the axial force N, the energy is

    1/2 k_u u^2 + 1/2 k_t twist^2 + 1/2 k_d a^2 + 1/2 k_s s^2,   k_d = E I/L,   k_s = 3 E I / (1 + phi) L,
    u = chord - length + length/24 a^2 + length/40 s^2,

where u is the elongation of the bent axis, so that tension stiffens bending within one element too; a
circular arc is exact. The spin angle of a round section does not enter; the twist is the difference of the
spin angles (counted over whole turns) and of the non-spinning frames, along the shortest rotation from t_i to
t_j. Sections of unequal stiffness add the energy of the slopes p . e of their first axes p; coupled sections
have a quadratic form of elongation, twist and bending instead (`coupled`). Damping acts on
the rates seen from axes that follow the chord and spin with the shaft (internal damping), so it destabilises
a shaft that spins faster than it whirls.

Inertia is that of the points x = sum N_k w_k, linear combinations with constant factors of five vectors w:
both nodes, e, t_i and t_j. A variation of the energy is sum f_k . dw_k, and e depends on the nodes: the
wrenches on both bodies are assembled from the forces f_k, and likewise their derivatives.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.beams.coupled import coupled_chord, coupled_forces, coupled_moment
from pitchpoint.elements.beams.record import PI, PJ, QI, TI, TJ, XI, XJ, E
from pitchpoint.multibody.vectors import add, cross, dot, into_world, less, row, set_row, times, triple

TWO_PI = 6.283185307179586


@kernel
def _fix(b, k, w, o, e):
    """Write a body-fixed vector with its first and second time derivative."""
    first = cross(o, w)
    set_row(b["w"], k, w)
    set_row(b["w1"], k, first)
    set_row(b["w2"], k, add(cross(e, w), cross(o, first)))


@kernel
def node(b, side, f, axes, p, B):
    """Set the vectors of one end from the frame of its body; returns its second transverse axis."""
    arm = into_world(axes, triple(p, 0))
    o = triple(f["tw"], 3)
    e = triple(f["ac"], 3)
    set_row(b["arm"], side, arm)
    set_row(b["omega"], side, o)
    set_row(b["alpha"], side, e)
    swept = cross(o, arm)
    set_row(b["w"], XI + side, add(triple(f["r"], 0), arm))
    set_row(b["w1"], XI + side, add(triple(f["tw"], 0), swept))
    set_row(b["w2"], XI + side, add(triple(f["ac"], 0), add(cross(e, arm), cross(o, swept))))
    _fix(b, TI + side, into_world(axes, (B[0, 2], B[1, 2], B[2, 2])), o, e)
    _fix(b, PI + side, into_world(axes, (B[0, 0], B[1, 0], B[2, 0])), o, e)
    second = into_world(axes, (B[0, 1], B[1, 1], B[2, 1]))
    if b["coupled"] != 0:
        _fix(b, QI + side, second, o, e)
    return second


@kernel
def turned(b, second_i, second_j):
    """Twist angle of the second end relative to the first, along the shortest rotation between their axes."""
    one_i = row(b["w"], PI)
    one_j = row(b["w"], PJ)
    return math.atan2(
        dot(second_i, one_j) - dot(one_i, second_j), dot(one_i, one_j) + dot(second_i, second_j)
    )


@kernel
def _chord(b):
    """Set length and direction of the chord with their time derivatives."""
    d = less(row(b["w"], XJ), row(b["w"], XI))
    d1 = less(row(b["w1"], XJ), row(b["w1"], XI))
    d2 = less(row(b["w2"], XJ), row(b["w2"], XI))
    ell = math.sqrt(dot(d, d))
    e = times(1.0 / ell, d)
    ell1 = dot(e, d1)
    e1 = times(1.0 / ell, less(d1, times(ell1, e)))
    e2 = times(1.0 / ell, less(less(d2, times(dot(e, d2), e)), times(2.0 * ell1, e1)))
    b["ell"] = ell
    b["ell1"] = ell1
    set_row(b["w"], E, e)
    set_row(b["w1"], E, e1)
    set_row(b["w2"], E, less(e2, times(dot(e1, e1), e)))


@kernel
def _arc(w):
    """Ratio of an angle to its sine, and its derivative with respect to the cosine w."""
    y = 1.0 - w
    if y > 0.05:
        s = 1.0 - w * w
        g = math.acos(w) / math.sqrt(s)
        return g, (w * g - 1.0) / s
    g = 1.0
    g1 = 0.0
    a = 1.0
    power = 1.0
    for n in range(1, 11):  # a_n = a_(n-1) n/(2 n + 1); truncation error below 1e-16
        a *= n / (2.0 * n + 1.0)
        g1 -= n * a * power
        power *= y
        g += a * power
    return g, g1


@kernel
def _bend(b):
    """Set difference of the normals and sum of the slopes, with their rates in world axes and in axes that
    rotate with the chord."""
    e = row(b["w"], E)
    e1 = row(b["w1"], E)
    ti = row(b["w"], TI)
    tj = row(b["w"], TJ)
    ti1 = row(b["w1"], TI)
    tj1 = row(b["w1"], TJ)
    both = add(ti, tj)
    both1 = add(ti1, tj1)
    b["cos"] = dot(both, e)
    b["cos1"] = dot(both1, e) + dot(both, e1)
    D = less(tj, ti)
    D1 = less(tj1, ti1)
    S = less(both, times(b["cos"], e))
    S1 = less(both1, add(times(b["cos1"], e), times(b["cos"], e1)))
    b["s"] = 0.5 * dot(e, add(row(b["omega"], 0), row(b["omega"], 1)))
    frame = add(cross(e, e1), times(b["s"], e))
    set_row(b["D"], 0, D)
    set_row(b["D"], 1, D1)
    set_row(b["D"], 2, less(D1, cross(frame, D)))
    set_row(b["S"], 0, S)
    set_row(b["S"], 1, S1)
    set_row(b["S"], 2, less(S1, cross(frame, S)))
    b["arc"], b["arc1"] = _arc(dot(ti, tj))


@kernel
def _strain(b):
    """Set the axial force and the generalised bending forces."""
    _bend(b)
    D = row(b["D"], 0)
    S = row(b["S"], 0)
    length = b["length"]
    eta = b["eta"]
    half = 0.5 * b["n_s"]
    # a^2 from sin^2 a, accurate for small angles; `arc` is a / sin a
    w = dot(row(b["w"], TI), row(b["w"], TJ))
    square = b["arc"] * b["arc"] * (1.0 - w * w)
    u = b["ell"] - length + length * (square / 24.0 + dot(S, S) / b["n_s"])
    u1 = b["ell1"] + length * (b["arc"] * dot(D, row(b["D"], 1)) / 12.0 + dot(S, row(b["S"], 1)) / half)
    N = b["k_u"] * (u + eta * u1)
    if b["coupled"] != 0:
        b["y"][0, 0] = u
        b["y"][1, 0] = u1
        coupled_forces(b)
        N += b["g"][0, 0]
        b["torque"] += b["g"][0, 1]
    b["axial"] = N
    fd = times((b["k_d"] + N * length / 12.0) * b["arc"], D)
    fs = times(b["k_s"] + N * length / half, S)
    fd = add(fd, times(eta * b["k_d"], row(b["D"], 2)))
    fs = add(fs, times(eta * b["k_s"], row(b["S"], 2)))
    c = add(cross(D, fd), cross(S, fs))
    for r in range(3):
        b["f_d"][r] = fd[r]
        b["f_s"][r] = fs[r]
        b["c"][r] = c[r]
    e = row(b["w"], E)
    e1 = row(b["w1"], E)
    for k in range(2):
        own = dot(row(b["w"], PI + k), e)
        other = dot(row(b["w"], PJ - k), e)
        own += eta * (dot(row(b["w1"], PI + k), e) + dot(row(b["w"], PI + k), e1))
        other += eta * (dot(row(b["w1"], PJ - k), e) + dot(row(b["w"], PJ - k), e1))
        b["h"][k] = b["c_a"] * own + b["c_b"] * other


@kernel
def _elastic(b):
    """Set generalised force of the chord direction and moments at both ends; `_cut` sets the node force V."""
    e = row(b["w"], E)
    c = triple(b["c"], 0)
    fd = triple(b["f_d"], 0)
    fs = triple(b["f_s"], 0)
    G = times(-1.0, add(times(b["cos"], fs), cross(c, e)))
    for k in range(2):
        first = row(b["w"], PI + k)
        h = b["h"][k]
        sign = 1.0 if k == 1 else -1.0
        G = add(G, times(h, first))
        mu = cross(row(b["w"], TI + k), add(fs, times(sign, fd)))
        mu = add(mu, cross(first, times(h, e)))
        if b["coupled"] != 0:
            mu = add(mu, coupled_moment(b, k))
        mu = less(mu, times(0.5 * dot(c, e), e))
        set_row(b["mu"], k, add(mu, times(sign * b["torque"], triple(b["m"], 0))))
    if b["coupled"] != 0:
        G = add(G, coupled_chord(b))
    for r in range(3):
        b["G"][r] = G[r]


@kernel
def _twisted(b, angle):
    """Set torque and gradient m of the twist: its scalar product with a rotation of the second end is the
    change of the twist."""
    ti = row(b["w"], TI)
    tj = row(b["w"], TJ)
    m = times(1.0 / (1.0 + dot(ti, tj)), add(ti, tj))
    rate = dot(m, less(row(b["omega"], 1), row(b["omega"], 0)))
    b["torque"] = b["k_t"] * (angle - b["twist"] + b["eta"] * rate)
    b["y"][0, 1] = angle - b["twist"]
    b["y"][1, 1] = rate
    for r in range(3):
        b["m"][r] = m[r]


@kernel
def _inertia(b):
    """Add the inertia forces of the five vectors to the force of the chord direction and to the moments."""
    M = b["M"]
    e = row(b["w"], E)
    for k in range(5):
        f = (0.0, 0.0, 0.0)
        for n in range(5):
            w2 = row(b["w2"], n)
            if n < 2:
                w2 = less(w2, triple(b["gravity"], 0))
            f = add(f, times(M[k, n], w2))
        if k >= E:
            g = (0.0, 0.0, 0.0)
            for n in range(3):
                g = add(g, times(b["gyro"][k - E, n], row(b["w1"], E + n)))
            f = add(f, times(b["s"], cross(g, e)))
        set_row(b["inert"], k, f)
    for r in range(3):
        b["G"][r] += b["inert"][E, r]
    for k in range(2):
        t = row(b["w"], TI + k)
        mu = cross(t, row(b["inert"], TI + k))
        for n in range(2):
            s1 = dot(row(b["alpha"], n), row(b["w"], TI + n))
            mu = add(mu, times(b["polar"][k, n] * s1, t))
        set_row(b["mu"], k, add(row(b["mu"], k), mu))


@kernel
def _cut(b):
    """Set the node force V: axial force and the transverse force that rotates the chord."""
    e = row(b["w"], E)
    G = triple(b["G"], 0)
    V = add(times(b["axial"], e), times(1.0 / b["ell"], less(G, times(dot(G, e), e))))
    for r in range(3):
        b["V"][r] = V[r]


@kernel
def _gather(b, f, g):
    """Add the wrenches on both bodies."""
    V = triple(b["V"], 0)
    for k in range(2):
        F = V if k == 0 else times(-1.0, V)
        if b["mass"] > 0.0:
            F = less(F, row(b["inert"], XI + k))
        set_row(b["F"], k, F)
        moment = less(cross(row(b["arm"], k), F), row(b["mu"], k))
        at = f if k == 0 else g
        for r in range(3):
            at["F"][r] += F[r]
            at["F"][3 + r] += moment[r]


@kernel
def loads(b, f, g, angle):
    """Forces of one beam after `node` has set both ends; V and mu remain in the scratch."""
    _chord(b)
    _twisted(b, angle)
    _strain(b)
    _elastic(b)
    if b["mass"] > 0.0:
        _inertia(b)
    _cut(b)
    _gather(b, f, g)


@kernel
def internal(b, out, first, axes_i, axes_j):
    """Write the section forces at both ends in the axes of the ends, without inertia forces of the beam."""
    _elastic(b)
    _cut(b)
    V = triple(b["V"], 0)
    for k in range(2):
        mu = row(b["mu"], k)
        if k == 0:
            mu = times(-1.0, mu)
        A = axes_i if k == 0 else axes_j
        B = b["B_i"] if k == 0 else b["B_j"]
        for r in range(3):
            axis = into_world(A, (B[0, r], B[1, r], B[2, r]))
            out[first + 6 * k + r] = dot(V, axis)
            out[first + 6 * k + 3 + r] = dot(mu, axis)
