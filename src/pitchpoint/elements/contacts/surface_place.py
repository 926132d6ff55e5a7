# SPDX-License-Identifier: Apache-2.0
"""Place of contact of a point against a surface: how place and normal move with both bodies.

The surface has the signed distance phi with gradient n and Hessian W. A point that moves by dy against the
surface changes phi by n . dy and n by W dy; nothing else of the shape is needed, and the contact location is
eliminated in W.
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
    """World point x from marker (o, E) into b["y"]."""
    gap = plus(x, -1.0, triple(o, 0))
    for k in range(3):
        b["y"][k] = dot(gap, column(E, k))


@kernel
def point_place(b, f, g, Q, m, h, r, weight):
    """Write the place of a point Q against a surface with outward normal m, gap h and curvature b["W"].

    With b["side"] 1 the point belongs to body i and the surface to j, with -1 the other way round.
    """
    side = b["side"]
    b["h"] = h
    b["r"] = r
    b["weight"] = weight
    put_3(b["Q"], Q)
    put_3(b["n"], (side * m[0], side * m[1], side * m[2]))
    W = b["W"]
    for k in range(12):
        mine = (k < 6) == (side > 0.0)  # the body of the point moves, not that of the surface
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
