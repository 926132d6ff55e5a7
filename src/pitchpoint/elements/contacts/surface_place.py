# SPDX-License-Identifier: Apache-2.0
"""Contact of a point with a surface: derivatives of contact point and normal by the motion of both bodies.

The surface has the signed distance phi with gradient n and Hessian W. If the point moves by dy relative to
the surface, phi changes by n . dy and n by W dy; no other property of the shape is needed, and the contact
point on the surface is eliminated through W.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.contacts.wrench import moved, put, put_3, turned
from pitchpoint.multibody.vectors import column, dot, plus, row, triple


@kernel
def curvature_in_world(E, V, W):
    """W = E V E^T."""
    for r in range(3):
        for c in range(3):
            s = 0.0
            for h in range(3):
                for k in range(3):
                    s += E[r, h] * V[h, k] * E[c, k]
            W[r, c] = s


@kernel
def local(b, E, o, x):
    """Write the coordinates of the world point x in marker (o, E) to b["y"]."""
    gap = plus(x, -1.0, triple(o, 0))
    for k in range(3):
        b["y"][k] = dot(gap, column(E, k))


@kernel
def point_place(b, f, g, Q, m, h, r, weight):
    """Write the contact of a point Q with a surface of outward normal m, gap h and distance Hessian b["W"].

    b["side"] = 1: the point is on body i and the surface on j; -1: the reverse.
    """
    side = b["side"]
    b["h"] = h
    b["r"] = r
    b["weight"] = weight
    put_3(b["Q"], Q)
    put_3(b["n"], (side * m[0], side * m[1], side * m[2]))
    W = b["W"]
    for k in range(12):
        mine = (k < 6) == (side > 0.0)  # motion of the body of the point, not of the surface
        o = f["r"] if k < 6 else g["r"]
        motion = moved(k % 6, plus(Q, -1.0, triple(o, 0)))
        s = side if mine else -side
        dn = (
            s * dot(row(W, 0), motion),
            s * dot(row(W, 1), motion),
            s * dot(row(W, 2), motion),
        )
        if mine:
            put(b["dQ"], k, motion)
        else:
            put(b["dQ"], k, (0.0, 0.0, 0.0))
            dn = plus(dn, side, turned(k % 6, m))
        put(b["dn"], k, dn)
