# SPDX-License-Identifier: Apache-2.0
"""Contact of two planar curves: common normals in the plane of the marker of body j, with exact tangents.

The curve of body j is a cylinder along the third axis of its marker; that of body i is a curve in space, or a
roller whose circle is in that plane. With tau the tangent of the curve of j, rotation and speed (a, b) of the
curve of i and (c, d) of that of j per parameter, phi the signed distance, dalpha the rotation of i relative
to j and dtau the motion of i relative to j along tau at Q, the contact points move along the curves by

    s_j = d (b dalpha + a dtau)/D,  s_i = (d + phi c)(b dalpha + a dtau)/D - dtau,  D = a d + b c + phi a c,

and the normal rotates with body j and by c/d s_j. Curvatures are quotients, so that corners (a > 0, b = 0)
and straight lines (a = 0) need no special case. D = 0 where the curves osculate.
"""

from __future__ import annotations

from pitchpoint.contact.curve_pair import carried, contacts
from pitchpoint.contact.curve_point import WIDTH, arc_length, point_of
from pitchpoint.contact.surface import SPHERE
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK, REFUSED
from pitchpoint.elements.contacts.record import RECORD
from pitchpoint.elements.contacts.wrench import act, begin, finish, moved, put, put_3, turned
from pitchpoint.multibody.channels import F8, frame_args
from pitchpoint.multibody.vectors import column, cross, dot, plus, triple

MIN_COSINE = 0.1
"""Minimum cosine between the planes of two curves; at larger tilt the curve of i is seen edge-on."""


@kernel
def _in_world(E, x, y):
    """World components of a vector in the plane of a marker."""
    return E[0, 0] * x + E[0, 1] * y, E[1, 0] * x + E[1, 1] * y, E[2, 0] * x + E[2, 1] * y


@kernel
def _running(b, f, g, along, T, size, rows):
    """Derivatives of contact point and normal for all motions, from the differential geometry of both curves.

    `along` is tau, T the unit direction of curve i in space and `size` its length in the plane of j; rows =
    (a, b, c, d, phi).
    """
    n = triple(b["n"], 0)
    Q = triple(b["Q"], 0)
    z = column(b["Ej"], 2)
    ai = plus(Q, -1.0, triple(f["r"], 0))
    aj = plus(Q, -1.0, triple(g["r"], 0))
    phi = rows[4]
    below = rows[0] * rows[3] + rows[1] * rows[2] + phi * rows[0] * rows[2]
    flat = plus(T, -dot(T, z), z)
    for k in range(12):
        side = k // 6
        c = k % 6
        sign = 1.0 if side == 0 else -1.0
        motion = moved(c, ai if side == 0 else aj)
        slide = sign * dot(along, motion)
        turn = 0.0
        if rows[1] != 0.0:
            turn = sign * dot(z, cross(flat, turned(c, T))) / (size * size)
        x = (rows[1] * turn + rows[0] * slide) / below
        dn = (rows[2] * x * along[0], rows[2] * x * along[1], rows[2] * x * along[2])
        dQ = (0.0, 0.0, 0.0)
        if side == 0:
            dQ = motion
        else:
            dn = plus(dn, 1.0, turned(c, n))
        if rows[1] != 0.0:  # the contact point on i moves against tau, along -T
            dQ = plus(dQ, -((rows[3] + phi * rows[2]) * x - slide) / size, T)
        put(b["dn"], k, dn)
        put(b["dQ"], k, dQ)


@kernel
def place_contact(b, f, g, A, B, hit):
    """Write gap, normal and position of one contact point to the record, with their derivatives."""
    ka = int(b["hits"][hit, 2])
    kb = int(b["hits"][hit, 4])
    s = b["hits"][hit, 1]
    t = b["hits"][hit, 3]
    x, y, tx, ty, speed, turn = point_of(A, ka, s)
    px, py, ux, uy, aspeed, aturn = carried(A, ka, s, b["M"], b["d"])
    qx, qy, bx, by, bspeed, bturn = point_of(B, kb, t)
    along = _in_world(b["Ej"], bx, by)
    T = _in_world(b["Ei"], tx, ty)
    put_3(b["n"], _in_world(b["Ej"], by, -bx))
    put_3(b["Q"], plus(triple(b["oi"], 0), 1.0, _in_world(b["Ei"], x, y)))
    phi = (px - qx) * by - (py - qy) * bx
    b["r"] = b["radius"]
    b["h"] = phi - b["radius"]
    b["side"] = 1.0
    b["weight"] = 1.0
    size = aspeed / speed if speed > 0.0 else 1.0
    _running(b, f, g, along, T, size, (aturn, aspeed, bturn, bspeed, phi))


@kernel
def _without_axes(b):
    """Align marker i with marker j: the orientation of a roller has no effect."""
    for r in range(3):
        for k in range(3):
            b["Ei"][r, k] = b["Ej"][r, k]
            b["M"][r, k] = 1.0 if r == k else 0.0


@kernel
def planar_contact(rec, ctl, fr, kk):
    """Wrenches, tangents and results of all contacts of planar curves."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        begin(b, f, g)
        if b["form_i"] == SPHERE:
            _without_axes(b)
        elif not b["M"][2, 2] > MIN_COSINE:
            c["bad"] = e
            return REFUSED
        A = view(b["pool"] + 8 * b["start_i"], (b["rows_i"], WIDTH), F8)
        B = view(b["pool"] + 8 * b["start_j"], (b["rows_j"], WIDTH), F8)
        b["reach"][0] = b["radius"]
        b["reach"][1] = b["depth"]
        b["reach"][2] = b["margin"]
        b["reach"][6] = b["deepest"]
        n, gap = contacts(A, B, b["M"], b["d"], b["reach"], b["hits"])
        if n == 0 and b["hits"][0, 4] < 0.0:
            finish(b, ctl, 1)
            continue
        for hit in range(max(n, 1)):
            place_contact(b, f, g, A, B, hit)
            act(b, c, f, g, kk)
        b["place"][3] = arc_length(A, int(b["hits"][0, 2]), b["hits"][0, 1])
        b["place"][4] = arc_length(B, int(b["hits"][0, 4]), b["hits"][0, 3])
        finish(b, ctl, 1)
    return OK


@kernel
def planar_entry(ctl, rec, n):
    """Common entry point of the kinds with planar curves."""
    c, fr, kk = frame_args(ctl)
    return planar_contact(view(rec, n, RECORD), c, fr, kk)
