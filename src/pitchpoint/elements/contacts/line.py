# SPDX-License-Identifier: Apache-2.0
"""Line contact of a cylinder on a plane, on another cylinder or in a bore, with parallel or tilted axes.

A cone on a plane is a cylinder whose radius varies along its axis.

The cylinder of body i is divided into slices at the points x of its axis; the force of a slice is the contact
law times dx over the reference length of the law (slice model of roller bearings: T. A. Harris, *Rolling
Bearing Analysis*; ISO 16281; exponent 10/9 with its stiffness: G. Lundberg and A. Palmgren). The gap of a
slice is the distance of x from the surface of body j less the radius: exact for parallel axes and for the
smallest gap of crossed axes, of second order in the angle in between.

Only the overlapping parts are integrated, with Gauss points between their ends; where such a part ends
because the gap opens, a change of variable removes the root singularity of the law: x = lo + (hi - lo) s^2 at
one end, s^2 (3 - 2 s) at both. Forces, stored energy and tangents have the accuracy of the quadrature, and
change smoothly from full to partial line contact, and from parallel axes to crossed ones, whose force grows
with the power e + 1/2 of the overlap.
"""

from __future__ import annotations

import math

from pitchpoint.contact.surface import CONE, PLANE, gap_of_length, of_length
from pitchpoint.core.kernel import kernel
from pitchpoint.elements.contacts.crossed_cylinders import rim_place
from pitchpoint.elements.contacts.surface_place import curvature_in_world, point_place
from pitchpoint.elements.contacts.wrench import act
from pitchpoint.multibody.vectors import column, into_world, plus, triple

GOLDEN = 0.3819660112501051
STRAIGHT = 1e-24
"""Squared sine of the angle between two axes below which they are parallel."""


@kernel
def _on_axis(b, x):
    """Write the point x [m] of the axis of body i to b["y"], in axes of marker j."""
    for k in range(3):
        b["y"][k] = b["d"][k] + x * b["M"][k, 2]


@kernel
def _slice(b, x):
    """Radius of the slice at x and its place on the axis of marker i [m]; x = 0 is the middle of the line.

    A cone has the tangent of its half angle and its height as sizes; its tip is the origin of the marker.
    """
    if b["form_i"] == CONE:
        below = 0.5 * b["size_i"][1] - x
        return below * b["size_i"][0], -below
    return b["size_i"][0], x


@kernel
def _gap(b, x):
    """Gap of the slice at x [m]."""
    if b["form_j"] == PLANE:
        up = b["M"][2, 2]
        radius, z = _slice(b, x)
        return b["d"][2] + z * up - radius * math.sqrt(max(0.0, 1.0 - up * up))
    _on_axis(b, x)
    return gap_of_length(b["size_j"], b["sense"], b["y"]) - b["size_i"][0]


@kernel
def _place(b, f, g, x, weight):
    """Write the contact point of the slice at x to the record."""
    if b["form_j"] == PLANE:
        radius, z = _slice(b, x)
        rim_place(b, f, g, radius, 0.0, z, weight)
        return
    _on_axis(b, x)
    phi, nx, ny, nz = of_length(b["size_j"], b["sense"], b["y"], b["V"])
    curvature_in_world(b["Ej"], b["V"], b["W"])
    Q = plus(triple(b["oi"], 0), x, column(b["Ei"], 2))
    b["side"] = 1.0
    point_place(b, f, g, Q, into_world(b["Ej"], (nx, ny, nz)), phi - b["size_i"][0], b["size_i"][0], weight)


@kernel
def _turning(b, lo, hi):
    """Position of the smallest gap between lo and hi; the gap is monotonic on either side of it."""
    half = 0.5 * b["size_j"][1]
    if b["form_j"] == PLANE:
        return 0.5 * (lo + hi)
    if abs(b["d"][2] + 0.5 * (lo + hi) * b["M"][2, 2]) <= half:
        m0 = b["M"][0, 2]
        m1 = b["M"][1, 2]
        square = m0 * m0 + m1 * m1
        if square < STRAIGHT:
            return 0.5 * (lo + hi)
        return min(max(-(b["d"][0] * m0 + b["d"][1] * m1) / square, lo), hi)
    p = lo + GOLDEN * (hi - lo)  # beyond an end of body j: golden-section search
    q = hi - GOLDEN * (hi - lo)
    gap_p = _gap(b, p)
    gap_q = _gap(b, q)
    for _ in range(30):
        if gap_p < gap_q:
            hi = q
            q = p
            gap_q = gap_p
            p = lo + GOLDEN * (hi - lo)
            gap_p = _gap(b, p)
        else:
            lo = p
            p = q
            gap_p = gap_q
            q = hi - GOLDEN * (hi - lo)
            gap_q = _gap(b, q)
    return 0.5 * (lo + hi)


@kernel
def _opening(b, inside, outside):
    """Zero of the gap between a point in contact and a point out of contact: bisection with secant steps."""
    gap_i = _gap(b, inside)
    gap_o = _gap(b, outside)
    for k in range(100):
        x = 0.5 * (inside + outside)
        if k % 3 != 2 and gap_o > gap_i:
            x = inside - gap_i * (outside - inside) / (gap_o - gap_i)
        gap = _gap(b, x)
        if gap < 0.0:
            inside = x
            gap_i = gap
        else:
            outside = x
            gap_o = gap
        if gap == 0.0 or abs(outside - inside) <= 1e-15 * b["size_i"][1]:
            break
    return outside


@kernel
def _press(b, c, f, g, kk, lo, hi, opens_lo, opens_hi):
    """Add the wrenches of the slices from lo to hi; `opens_lo`, `opens_hi`: the gap opens at that end."""
    wide = hi - lo
    length = b["length"]
    for k in range(b["stations"]):
        s = b["along"][k, 0]
        w = b["along"][k, 1] * wide / length
        x = lo + wide * s
        if opens_lo and opens_hi:
            x = lo + wide * s * s * (3.0 - 2.0 * s)
            w *= 6.0 * s * (1.0 - s)
        elif opens_lo:
            x = lo + wide * s * s
            w *= 2.0 * s
        elif opens_hi:
            x = hi - wide * s * s
            w *= 2.0 * s
        _place(b, f, g, x, w)
        if b["h"] < 0.0:
            act(b, c, f, g, kk)


@kernel
def _deepest(b, x, best):
    """Whichever of two positions on the axis has the smaller gap."""
    return x if _gap(b, x) < _gap(b, best) else best


@kernel
def line_of_contact(b, c, f, g, kk):
    """Add the line contact of the cylinder of body i."""
    half = 0.5 * b["size_i"][1]
    cut_lo = half
    cut_hi = half
    up = b["M"][2, 2]
    if b["form_j"] != PLANE and abs(up) > 1e-12:  # end planes of body j
        one = (-0.5 * b["size_j"][1] - b["d"][2]) / up
        two = (0.5 * b["size_j"][1] - b["d"][2]) / up
        cut_lo = min(max(min(one, two), -half), half)
        cut_hi = min(max(max(one, two), -half), half)
    best = -half
    lo = -half
    for part in range(3):
        hi = half
        if part == 0:
            hi = cut_lo
        elif part == 1:
            hi = cut_hi
        if not hi > lo:
            continue
        turn = _turning(b, lo, hi)
        best = _deepest(b, turn, _deepest(b, hi, _deepest(b, lo, best)))
        in_lo = _gap(b, lo) < 0.0
        in_hi = _gap(b, hi) < 0.0
        if _gap(b, turn) < 0.0:
            start = lo if in_lo else _opening(b, turn, lo)
            end = hi if in_hi else _opening(b, turn, hi)
            _press(b, c, f, g, kk, start, end, not in_lo, not in_hi)
        else:
            if in_lo:
                _press(b, c, f, g, kk, lo, _opening(b, lo, turn), False, True)
            if in_hi:
                _press(b, c, f, g, kk, _opening(b, hi, turn), hi, True, False)
        lo = hi
    _place(b, f, g, best, 0.0)
    act(b, c, f, g, kk)  # weight 0, without force: records the smallest gap and its position
