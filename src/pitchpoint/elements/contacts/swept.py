# SPDX-License-Identifier: Apache-2.0
"""Contact of a ring or a cone of body i with a curved surface of body j.

Both are balls of radius r(s) swept along a curve p(s) fixed to body i: a ring along its circle, r = tube; a
cone along its axis from the tip, r = s sin(half angle). With the signed distance phi of the surface of j and
its normal n, a contact point is a local minimum of the gap phi(p(s)) - r(s):

    F = n . p' - r' = 0,   F' = p'^T W p' + n . p'' > 0,   ds = -(dn . p' + n . dp')/F'

with the Hessian W of the distance; ds is the motion of the contact point for a motion of the bodies. A ring
may touch a cylinder, a cone or another ring at several points: each of them has the contact law. A ring
coaxial with the surface touches it everywhere: the law is divided equally among points around it. The
gap of a cone is convex along its axis; beyond its base the edge of the base, a ring without tube, touches.
"""

from __future__ import annotations

import math

from pitchpoint.contact.surface import CYLINDER, distance, of_length
from pitchpoint.core.kernel import kernel
from pitchpoint.elements.contacts.surface_place import curvature_in_world, point_place
from pitchpoint.elements.contacts.wrench import act, put, put_3, turned
from pitchpoint.multibody.vectors import column, dot, into_world, plus, row, triple

SAMPLES = 48
"""Points of a ring at which the search for minima starts, and at which a law for the whole ring applies."""
AROUND = 8
"""Points of a ring that is coaxial with the surface."""
COAXIAL = 1e-9
"""Variation of the gap over the radius of a ring below which it is coaxial."""
ITERATIONS = 60
FLAT = 1e-9
"""F' relative to the scale of the curve below which the contact point is fixed to body i."""


@kernel
def _distance(b):
    """Distance of b["y"] from the surface of j, its normal in axes of marker j; b["V"] is overwritten."""
    if b["form_j"] == CYLINDER and b["size_j"][1] > 0.0:
        return of_length(b["size_j"], b["sense"], b["y"], b["V"])
    return distance(b["form_j"], b["size_j"], b["sense"], b["y"], b["V"])


@kernel
def _in_marker(b, z, x, y):
    """Write the point (x, y, z) of marker i to b["y"], in axes of marker j."""
    for k in range(3):
        b["y"][k] = b["d"][k] + x * b["M"][k, 0] + y * b["M"][k, 1] + z * b["M"][k, 2]


@kernel
def _curved(b, t):
    """t^T V t of a vector in axes of marker j."""
    s = 0.0
    for r in range(3):
        for c in range(3):
            s += t[r] * b["V"][r, c] * t[c]
    return s


@kernel
def _on_ring(b, R, z, angle):
    """Distance of a point of a ring from the surface, F and F' by the angle."""
    c = math.cos(angle)
    s = math.sin(angle)
    _in_marker(b, z, R * c, R * s)
    phi, nx, ny, nz = _distance(b)
    n = (nx, ny, nz)
    e = plus((c * b["M"][0, 0], c * b["M"][1, 0], c * b["M"][2, 0]), s, column(b["M"], 1))
    t = plus((-s * b["M"][0, 0], -s * b["M"][1, 0], -s * b["M"][2, 0]), c, column(b["M"], 1))
    return phi, R * dot(n, t), R * R * _curved(b, t) - R * dot(n, e)


@kernel
def _on_axis(b, x):
    """Distance of the point at x from the tip of a cone, F and F'."""
    _in_marker(b, -x, 0.0, 0.0)
    phi, nx, ny, nz = _distance(b)
    a = column(b["M"], 2)
    return phi, -dot((nx, ny, nz), a) - math.sin(b["radius"]), _curved(b, a)


@kernel
def _place(b, f, g, along, r, r_rate, bend, weight, free):
    """Write the contact of the ball of radius r at b["y"]; `along` = p' and `bend` = p'' in world axes.

    The contact point is free to move along the curve, or fixed to body i.
    """
    phi, nx, ny, nz = _distance(b)
    curvature_in_world(b["Ej"], b["V"], b["W"])
    Q = plus(triple(b["oj"], 0), 1.0, into_world(b["Ej"], triple(b["y"], 0)))
    n = into_world(b["Ej"], (nx, ny, nz))
    b["side"] = 1.0
    point_place(b, f, g, Q, n, phi - r, 0.0, weight)
    W = b["W"]
    Wp = (dot(row(W, 0), along), dot(row(W, 1), along), dot(row(W, 2), along))
    slope = dot(along, Wp) + dot(n, bend)
    scale = math.sqrt(dot(along, along))
    for k in range(12):
        dn = column(b["dn"], k)
        dQ = column(b["dQ"], k)
        ds = 0.0
        if free and slope > FLAT * scale:
            dp = turned(k, along) if k < 6 else (0.0, 0.0, 0.0)
            ds = -(dot(dn, along) + dot(n, dp)) / slope
        dn = plus(dn, ds, Wp)
        put(b["dn"], k, dn)
        # the point of the surface of body i: Q - r n
        put(b["dQ"], k, plus(plus(plus(dQ, ds, along), -r, dn), -r_rate * ds, n))
    put_3(b["Q"], plus(Q, -r, n))


@kernel
def _press_ring(b, c, f, g, kk, ring, angle, weight, free):
    """Add the contact at one angle of a ring: its radius, the radius of its tube and its height [m]."""
    R, tube, z = ring
    x = math.cos(angle)
    y = math.sin(angle)
    _in_marker(b, z, R * x, R * y)
    one = column(b["Ei"], 0)
    two = column(b["Ei"], 1)
    along = plus((-R * y * one[0], -R * y * one[1], -R * y * one[2]), R * x, two)
    bend = plus((-R * x * one[0], -R * x * one[1], -R * x * one[2]), -R * y, two)
    _place(b, f, g, along, tube, 0.0, bend, weight, free)
    act(b, c, f, g, kk)


@kernel
def _newton(x, F, slope, lo, hi):
    """Newton step of a zero of F, or bisection outside its bracket, and the bracket with x as an end."""
    if F > 0.0:
        hi = x
    else:
        lo = x
    new = x - F / slope if slope > 0.0 else lo
    if not lo < new < hi:
        new = 0.5 * (lo + hi)
    return new, lo, hi


@kernel
def _minimum(b, R, z, lo, hi):
    """Angle of the minimum between two angles, by Newton steps within a bracket of F."""
    x = 0.5 * (lo + hi)
    for _ in range(ITERATIONS):
        _, F, slope = _on_ring(b, R, z, x)
        new, lo, hi = _newton(x, F, slope, lo, hi)
        if abs(new - x) < 1e-15:
            break
        x = new
    return x


@kernel
def ring_of_contact(b, c, f, g, kk, R, tube, z):
    """Add the contacts of a ring of radius R in the plane at z of marker i."""
    ring = (R, tube, z)
    step = 2.0 * math.pi / SAMPLES
    if b["stations"] > 0:  # law for the whole ring
        for k in range(SAMPLES):
            _press_ring(b, c, f, g, kk, ring, k * step, 1.0 / SAMPLES, False)
        return
    least = 1e300
    most = -1e300
    for k in range(SAMPLES):
        now, _, _ = _on_ring(b, R, z, k * step)
        least = min(least, now)
        most = max(most, now)
    if most - least <= COAXIAL * R:
        for k in range(AROUND):
            _press_ring(b, c, f, g, kk, ring, k * (2.0 * math.pi / AROUND), 1.0 / AROUND, False)
        return
    before, _, _ = _on_ring(b, R, z, -step)
    now, _, _ = _on_ring(b, R, z, 0.0)
    for k in range(SAMPLES):
        after, _, _ = _on_ring(b, R, z, (k + 1) * step)
        if now <= before and now < after:
            angle = _minimum(b, R, z, (k - 1) * step, (k + 1) * step)
            _press_ring(b, c, f, g, kk, ring, angle, 1.0, True)
        before = now
        now = after


@kernel
def cone_of_contact(b, c, f, g, kk):
    """Add the contact of a cone of body i with a convex surface of body j.

    The half angle is b["radius"], size_i = its tangent and the height [m].
    """
    height = b["size_i"][1]
    cosine = math.cos(b["radius"])
    sine = math.sin(b["radius"])
    lo = 0.0
    hi = height / (cosine * cosine)  # the ball there touches the cone at its base
    _, F, _ = _on_axis(b, hi)
    if F <= 0.0:
        ring_of_contact(b, c, f, g, kk, height * b["size_i"][0], 0.0, -height)
        return
    _, F, _ = _on_axis(b, lo)
    x = 0.0
    free = F < 0.0
    if free:
        x = 0.5 * hi
        for _ in range(ITERATIONS):
            _, F, slope = _on_axis(b, x)
            new, lo, hi = _newton(x, F, slope, lo, hi)
            if abs(new - x) < 1e-15 * height:
                break
            x = new
    _in_marker(b, -x, 0.0, 0.0)
    a = column(b["Ei"], 2)
    along = (-a[0], -a[1], -a[2])
    _place(b, f, g, along, x * sine, sine, (0.0, 0.0, 0.0), 1.0, free)
    act(b, c, f, g, kk)
