# SPDX-License-Identifier: Apache-2.0
"""Forces of beams between turning bodies: small strains, rotations of any size.

Seen from its chord, the line e from node i to node j, an end section with the normal t has the slope t - e:
twice the sine of half its angle. With g_i, g_j the slopes and N the tension, the energy is

    1/2 k_u u^2 + 1/2 k_t twist^2 + k_a/2 (g_i^2 + g_j^2) + k_b g_i . g_j,
    u = chord - length + length/60 (4 g_i^2 - 2 g_i . g_j + 4 g_j^2),

u being the stretch of the bowed axis, so that tension stiffens bending also inside one element. Nothing in it
asks how far a round section has spun; the twist is the difference of the counted spins and of the
frames that do not spin, along the shortest turn from t_i to t_j. Sections that are stiffer in one direction add the same
energy of the slopes towards their first axis. Damping acts on the rates seen from a frame that goes with the
chord and spins with the shaft, so a shaft that spins faster than it whirls is driven by it.

Inertia is that of points x = sum N_k w_k, which are sums with constant factors of the five vectors w: both
nodes, e, t_i and t_j. A variation of the energy is sum f_k . dw_k, and e goes with the nodes: the wrenches on
both bodies are gathered from these forces once, and so are their changes.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel
from pitchpoint.multibody.vectors import add, cross, dot, into_world, less, times, triple

TWO_PI = 6.283185307179586
XI, XJ, E, TI, TJ, PI, PJ = 0, 1, 2, 3, 4, 5, 6


@kernel
def _set(x, k, a):
    x[k, 0] = a[0]
    x[k, 1] = a[1]
    x[k, 2] = a[2]


@kernel
def _row(x, k):
    return x[k, 0], x[k, 1], x[k, 2]


@kernel
def _fix(b, k, w, o, e):
    """Write a vector that is fixed to a body, its rate and its second rate."""
    first = cross(o, w)
    _set(b["w"], k, w)
    _set(b["w1"], k, first)
    _set(b["w2"], k, add(cross(e, w), cross(o, first)))


@kernel
def node(b, side, f, axes, p, B):
    """Vectors of one end, from its body; returns its second transverse axis."""
    arm = into_world(axes, triple(p, 0))
    o = triple(f["tw"], 3)
    e = triple(f["ac"], 3)
    _set(b["arm"], side, arm)
    _set(b["omega"], side, o)
    _set(b["alpha"], side, e)
    swept = cross(o, arm)
    _set(b["w"], XI + side, add(triple(f["r"], 0), arm))
    _set(b["w1"], XI + side, add(triple(f["tw"], 0), swept))
    _set(b["w2"], XI + side, add(triple(f["ac"], 0), add(cross(e, arm), cross(o, swept))))
    _fix(b, TI + side, into_world(axes, (B[0, 2], B[1, 2], B[2, 2])), o, e)
    _fix(b, PI + side, into_world(axes, (B[0, 0], B[1, 0], B[2, 0])), o, e)
    return into_world(axes, (B[0, 1], B[1, 1], B[2, 1]))


@kernel
def turned(b, second_i, second_j):
    """Angle of the second end against the first along the shortest turn between their axes."""
    one_i = _row(b["w"], PI)
    one_j = _row(b["w"], PJ)
    return math.atan2(
        dot(second_i, one_j) - dot(one_i, second_j), dot(one_i, one_j) + dot(second_i, second_j)
    )


@kernel
def _chord(b):
    """Direction of the chord with its rates."""
    d = less(_row(b["w"], XJ), _row(b["w"], XI))
    d1 = less(_row(b["w1"], XJ), _row(b["w1"], XI))
    d2 = less(_row(b["w2"], XJ), _row(b["w2"], XI))
    ell = math.sqrt(dot(d, d))
    e = times(1.0 / ell, d)
    ell1 = dot(e, d1)
    e1 = times(1.0 / ell, less(d1, times(ell1, e)))
    e2 = times(1.0 / ell, less(less(d2, times(dot(e, d2), e)), times(2.0 * ell1, e1)))
    b["ell"] = ell
    b["ell1"] = ell1
    _set(b["w"], E, e)
    _set(b["w1"], E, e1)
    _set(b["w2"], E, less(e2, times(dot(e1, e1), e)))


@kernel
def _bow(b, x, k):
    """Elongation by bowing per slope k, a third of a fourth of both slopes of x."""
    return times(b["length"] / 30.0, less(times(4.0, _row(x, k)), _row(x, 1 - k)))


@kernel
def _slopes(b, x, k):
    """Bending moments k of two slopes."""
    return add(times(b["k_a"], _row(x, k)), times(b["k_b"], _row(x, 1 - k)))


@kernel
def _strain(b):
    """Slopes, tension and the forces of the slopes."""
    e = _row(b["w"], E)
    e1 = _row(b["w1"], E)
    b["s"] = 0.5 * dot(e, add(_row(b["omega"], 0), _row(b["omega"], 1)))
    frame = add(cross(e, e1), times(b["s"], e))
    for k in range(2):
        g = less(_row(b["w"], TI + k), e)
        g1 = less(_row(b["w1"], TI + k), e1)
        _set(b["g"], k, g)
        _set(b["g1"], k, g1)
        _set(b["rho"], k, less(g1, cross(frame, g)))
    u = b["ell"] - b["length"]
    u1 = b["ell1"]
    for k in range(2):
        q = _bow(b, b["g"], k)
        _set(b["q"], k, q)
        u += 0.5 * dot(q, _row(b["g"], k))
        u1 += dot(q, _row(b["g1"], k))
    eta = b["eta"]
    b["axial"] = b["k_u"] * (u + eta * u1)
    c = (0.0, 0.0, 0.0)
    for k in range(2):
        f = add(_slopes(b, b["g"], k), times(eta, _slopes(b, b["rho"], k)))
        f = add(f, times(b["axial"], _row(b["q"], k)))
        _set(b["f"], k, f)
        c = add(c, cross(_row(b["g"], k), f))
        own = dot(_row(b["w"], PI + k), e)
        other = dot(_row(b["w"], PJ - k), e)
        own += eta * (dot(_row(b["w1"], PI + k), e) + dot(_row(b["w"], PI + k), e1))
        other += eta * (dot(_row(b["w1"], PJ - k), e) + dot(_row(b["w"], PJ - k), e1))
        b["h"][k] = b["c_a"] * own + b["c_b"] * other
    for r in range(3):
        b["c"][r] = c[r]


@kernel
def _elastic(b):
    """Force of the chord and moments of both ends; the force V at the nodes is left to `_gather`."""
    e = _row(b["w"], E)
    c = triple(b["c"], 0)
    G = times(-1.0, cross(c, e))
    for k in range(2):
        first = _row(b["w"], PI + k)
        h = b["h"][k]
        G = add(G, less(times(h, first), _row(b["f"], k)))
        mu = add(cross(_row(b["w"], TI + k), _row(b["f"], k)), cross(first, times(h, e)))
        mu = less(mu, times(0.5 * dot(c, e), e))
        sign = 1.0 if k == 1 else -1.0
        _set(b["mu"], k, add(mu, times(sign * b["torque"], triple(b["m"], 0))))
    for r in range(3):
        b["G"][r] = G[r]


@kernel
def _twisted(b, angle):
    """Torque of the twist, and the vector m whose product with a turn of an end is the change of the twist."""
    ti = _row(b["w"], TI)
    tj = _row(b["w"], TJ)
    m = times(1.0 / (1.0 + dot(ti, tj)), add(ti, tj))
    rate = dot(m, less(_row(b["omega"], 1), _row(b["omega"], 0)))
    b["torque"] = b["k_t"] * (angle - b["twist"] + b["eta"] * rate)
    for r in range(3):
        b["m"][r] = m[r]


@kernel
def _inertia(b):
    """Inertia forces of the five vectors, added to the force of the chord and to the moments."""
    M = b["M"]
    e = _row(b["w"], E)
    for k in range(5):
        f = (0.0, 0.0, 0.0)
        for n in range(5):
            w2 = _row(b["w2"], n)
            if n < 2:
                w2 = less(w2, triple(b["gravity"], 0))
            f = add(f, times(M[k, n], w2))
        if k >= E:
            g = (0.0, 0.0, 0.0)
            for n in range(3):
                g = add(g, times(b["gyro"][k - E, n], _row(b["w1"], E + n)))
            f = add(f, times(b["s"], cross(g, e)))
        _set(b["inert"], k, f)
    for r in range(3):
        b["G"][r] += b["inert"][E, r]
    for k in range(2):
        t = _row(b["w"], TI + k)
        mu = cross(t, _row(b["inert"], TI + k))
        for n in range(2):
            s1 = dot(_row(b["alpha"], n), _row(b["w"], TI + n))
            mu = add(mu, times(b["polar"][k, n] * s1, t))
        _set(b["mu"], k, add(_row(b["mu"], k), mu))


@kernel
def _cut(b):
    """Force in the chord: the tension and what turns the chord."""
    e = _row(b["w"], E)
    G = triple(b["G"], 0)
    V = add(times(b["axial"], e), times(1.0 / b["ell"], less(G, times(dot(G, e), e))))
    for r in range(3):
        b["V"][r] = V[r]


@kernel
def _gather(b, f, g):
    """Wrenches on both bodies."""
    V = triple(b["V"], 0)
    for k in range(2):
        F = V if k == 0 else times(-1.0, V)
        if b["mass"] > 0.0:
            F = less(F, _row(b["inert"], XI + k))
        _set(b["F"], k, F)
        moment = less(cross(_row(b["arm"], k), F), _row(b["mu"], k))
        at = f if k == 0 else g
        for r in range(3):
            at["F"][r] += F[r]
            at["F"][3 + r] += moment[r]


@kernel
def loads(b, f, g, angle):
    """All forces of one beam whose ends are in place; V and mu of the elastic part remain for observation."""
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
    """Forces in the sections at both ends, without the inertia of the beam itself, in the axes of the ends."""
    _elastic(b)
    _cut(b)
    V = triple(b["V"], 0)
    for k in range(2):
        mu = _row(b["mu"], k)
        if k == 0:
            mu = times(-1.0, mu)
        A = axes_i if k == 0 else axes_j
        B = b["B_i"] if k == 0 else b["B_j"]
        for r in range(3):
            axis = into_world(A, (B[0, r], B[1, r], B[2, r]))
            out[first + 6 * k + r] = dot(V, axis)
            out[first + 6 * k + 3 + r] = dot(mu, axis)
