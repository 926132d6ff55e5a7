# SPDX-License-Identifier: Apache-2.0
"""Inertia forces of bodies that are not round: Newton-Euler equations about the body origin, world axes.

With c the centre of mass from the origin, I the inertia about the origin (both rotated with S), o the angular
velocity and e its derivative:

    F = -m (a + e x c + o x (o x c)),  M = -(I e + o x I o + m c x a)

Tangents as in `inertia`: the 6 x 6 mass matrix (factor cm), the derivative by the velocity (cd) and, for
exact linearisation, by the attitude (ck).
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.multibody.bodies import GENERAL
from pitchpoint.multibody.vectors import add, cross, into_body, into_world, triple, unit


@kernel
def _turned_inertia(o, f, a):
    """I a with the inertia rotated to world axes."""
    return into_world(f["S"], into_world(o["inertia"], into_body(f["S"], a)))


@kernel
def _center(o, f):
    """Centre of mass from the origin, world axes."""
    return into_world(f["S"], (o["com"][0], o["com"][1], o["com"][2]))


@kernel
def _put(k, row, col, factor, a):
    for i in range(3):
        k[row + i, col] += factor * a[i]


@kernel
def _wrench(o, f):
    """Set the wrench of a body to its inertia forces."""
    m = o["mass"]
    w = triple(f["tw"], 3)
    e = triple(f["ac"], 3)
    a = triple(f["ac"], 0)
    c = _center(o, f)
    h = _turned_inertia(o, f, w)
    s = add(a, add(cross(e, c), cross(w, cross(w, c))))
    t = add(_turned_inertia(o, f, e), cross(w, h))
    u = cross(c, a)
    for i in range(3):
        f["F"][i] = -m * s[i]
        f["F"][3 + i] = -(t[i] + m * u[i])


@kernel
def _mass_and_gyration(o, f, k, cm, cd):
    """Add cm times the mass matrix and cd times the derivative of the inertia forces by the twist."""
    m = o["mass"]
    w = triple(f["tw"], 3)
    c = _center(o, f)
    h = _turned_inertia(o, f, w)
    for j in range(3):
        x = unit(j)
        xc = cross(x, c)
        k[j, j] += cm * m
        _put(k, 0, 3 + j, cm * m, xc)
        _put(k, 3, 3 + j, cm, _turned_inertia(o, f, x))
        _put(k, 3, j, cm * m, cross(c, x))
        if cd != 0.0:
            _put(k, 0, 3 + j, cd * m, add(cross(x, cross(w, c)), cross(w, xc)))
            _put(k, 3, 3 + j, cd, add(cross(x, h), cross(w, _turned_inertia(o, f, x))))


@kernel
def _attitude(o, f, k, ck):
    """Add ck times the derivative of the inertia forces by a rotation of the body (constant tw, ac).

    A small rotation x changes c by x x c and I b by x x (I b) - I (x x b).
    """
    m = o["mass"]
    w = triple(f["tw"], 3)
    e = triple(f["ac"], 3)
    a = triple(f["ac"], 0)
    c = _center(o, f)
    h = _turned_inertia(o, f, w)
    g = _turned_inertia(o, f, e)
    for j in range(3):
        x = unit(j)
        neg = (-x[0], -x[1], -x[2])
        dc = cross(x, c)
        dh = add(cross(x, h), _turned_inertia(o, f, cross(neg, w)))
        dg = add(cross(x, g), _turned_inertia(o, f, cross(neg, e)))
        _put(k, 0, 3 + j, ck * m, add(cross(e, dc), cross(w, cross(w, dc))))
        _put(k, 3, 3 + j, ck, add(dg, cross(w, dh)))
        _put(k, 3, 3 + j, ck * m, cross(dc, a))


@kernel
def tree_inertia(body, fr, kk, jac, cm, cd):
    """Set the wrenches of bodies that are not round to the inertia forces; with jac > 0 add the tangents."""
    for b in range(body.size):
        o = body[b]
        if o["joint"] == GENERAL:
            _wrench(o, fr[b])
            if jac != 0:
                _mass_and_gyration(o, fr[b], kk[o["ii"]], cm, cd)


@kernel
def tree_attitude(body, fr, kk, ck):
    """Add the tangents of the inertia forces by the attitude (exact linearisation)."""
    for b in range(body.size):
        o = body[b]
        if o["joint"] == GENERAL:
            _attitude(o, fr[b], kk[o["ii"]], ck)
