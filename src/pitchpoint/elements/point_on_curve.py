# SPDX-License-Identifier: Apache-2.0
"""Permanent contact of a point or roller with a planar curve: a cam with positively guided follower.

The constraint row is g = phi(y) - r, where phi is the signed distance of the point y of body i from the
curve, in the plane of the marker of body j. The contact point on the curve is eliminated: with the tangent
tau, the curvature kappa and W = kappa/(1 + kappa phi) tau tau^T, the unit normal changes by n' = omega_j x n
+ W u, where u is the velocity of the point relative to the plane; see `contacts.permanent`. Of several
nearest points of the curve, the one with the smallest |g| is used.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.contact.curve import Curve
from pitchpoint.contact.curve_point import WIDTH, arc_length, nearest, point_of
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import INCONSISTENT, OK
from pitchpoint.elements.contacts.permanent import hold
from pitchpoint.elements.contacts.wrench import moved, turned
from pitchpoint.elements.kind import CONSTRAINT, Kind
from pitchpoint.elements.signal import Pool
from pitchpoint.multibody.channels import F8, constraint_args, constraint_rates, observations
from pitchpoint.multibody.vectors import column, dot, plus, triple

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("row", "i8"),  # constraint row; written by the layout
        ("pi", "f8", 3),  # the point of body i, axes S [m]
        ("pj", "f8", 3),  # marker of the curve on body j
        ("Bj", "f8", (3, 3)),  # its axes, columns in axes S
        ("radius", "f8"),  # of the roller [m]
        ("pool", "i8"),
        ("start", "i8"),
        ("rows", "i8"),  # pieces of the curve
        ("E", "f8", (3, 3)),  # scratch: axes of the marker in the world
        ("y", "f8", 3),  # scratch: the point in axes of the marker
        ("c", "f8", 3),  # scratch: the point in the world
        ("o", "f8", 3),  # scratch: the marker in the world
        ("h", "f8"),  # scratch: distance less the radius
        ("n", "f8", 3),  # scratch: normal and contact point in the world, and their derivatives
        ("Q", "f8", 3),
        ("dn", "f8", (3, 12)),
        ("dQ", "f8", (3, 12)),
        ("out", "i8"),
    ],
    align=True,
)

OUTPUTS = (
    ("contact_force", "N", "normal force between point and curve; negative in tension"),
    ("contact_path[{}.j]", "m", "position of the contact along the curve of the second body"),
)


def set_point_on_curve(record: np.void, pool: Pool, curve: Curve, radius: float = 0.0) -> None:
    """Set the curve of a constraint.

    Parameters
    ----------
    record
        Record with bodies i and j; marker axes that are not set are those of body j.
    pool
        Pool of the kind.
    curve
        Curve of body j.
    radius
        Radius of the roller on the outer side of the curve [m], 0 for a point; negative on the inner side.
    """
    if not np.any(record["Bj"]):
        record["Bj"] = np.eye(3)
    record["start"], record["rows"] = pool.add(curve.rows), len(curve.rows)
    record["radius"] = radius


@kernel
def _project(b, f, g):
    """Set the position of the point in the axes of the curve marker."""
    E = b["E"]
    for r in range(3):
        p = b["pi"]
        q = b["pj"]
        S = f["S"]
        T = g["S"]
        b["c"][r] = f["r"][r] + S[r, 0] * p[0] + S[r, 1] * p[1] + S[r, 2] * p[2]
        b["o"][r] = g["r"][r] + T[r, 0] * q[0] + T[r, 1] * q[1] + T[r, 2] * q[2]
        for c in range(3):
            E[r, c] = T[r, 0] * b["Bj"][0, c] + T[r, 1] * b["Bj"][1, c] + T[r, 2] * b["Bj"][2, c]
    gap = plus(triple(b["c"], 0), -1.0, triple(b["o"], 0))
    for k in range(3):
        b["y"][k] = dot(gap, column(E, k))


@kernel
def _search(b, rows):
    """Piece and parameter of the contact point on the curve, and g there; piece -1 if there is none."""
    best = 1e300
    piece = -1
    s = 0.0
    g = 0.0
    x = b["y"][0]
    y = b["y"][1]
    for k in range(rows.shape[0]):
        dx = x - rows[k, 1]
        dy = y - rows[k, 2]
        if (dx * dx + dy * dy) ** 0.5 - rows[k, 3] > best + abs(b["radius"]):
            continue
        found, t, phi, nx, ny = nearest(rows, k, x, y)
        if found != 0 and abs(phi - b["radius"]) < best:
            best = abs(phi - b["radius"])
            piece = k
            s = t
            g = phi - b["radius"]
    return piece, s, g


@kernel
def _run(b, f, g, tau, w):
    """Set the derivatives of normal and contact point by the motion of both bodies.

    The contact point of the row is the point of body i.
    """
    n = triple(b["n"], 0)
    ai = plus(triple(b["c"], 0), -1.0, triple(f["r"], 0))
    aj = plus(triple(b["c"], 0), -1.0, triple(g["r"], 0))
    for k in range(12):
        c = k % 6
        motion = moved(c, ai if k < 6 else aj)
        along = w * dot(tau, motion)
        dn = (along * tau[0], along * tau[1], along * tau[2])
        if k >= 6:
            dn = plus(turned(c, n), -1.0, dn)
        for r in range(3):
            b["dn"][r, k] = dn[r]
            b["dQ"][r, k] = motion[r] if k < 6 else 0.0


@kernel
def point_on_curve(rec, ctl, fr, q, g, G):
    """Constraint rows of all points on curves, their second derivatives and constraint forces."""
    c = ctl[0]
    v, gt, gtt, Gf = constraint_rates(ctl)
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        o = fr[b["j"]]
        _project(b, f, o)
        rows = view(b["pool"] + 8 * b["start"], (b["rows"], WIDTH), F8)
        piece, t, value = _search(b, rows)
        if piece < 0:
            c["bad"] = e
            return INCONSISTENT
        x, y, tx, ty, speed, turn = point_of(rows, piece, t)
        E = b["E"]
        tau = plus((tx * E[0, 0], tx * E[1, 0], tx * E[2, 0]), ty, column(E, 1))
        n = plus((ty * E[0, 0], ty * E[1, 0], ty * E[2, 0]), -tx, column(E, 1))
        b["h"] = value
        for k in range(3):
            b["n"][k] = n[k]
            b["Q"][k] = b["c"][k]
        _run(b, f, o, tau, turn / (speed + turn * (value + b["radius"])))
        lam = hold(b, c, f, o, g, gtt, Gf)
        if c["out"] != 0:
            out = observations(ctl)
            out[b["out"]] = -lam
            out[b["out"] + 1] = arc_length(rows, piece, t)
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, q, g, G = constraint_args(ctl)
    return point_on_curve(view(rec, n, RECORD), c, fr, q, g, G)


KIND = Kind(
    name="point_on_curve",
    channel=CONSTRAINT,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    rows=1,
    row_unit=lambda record: "m",
    body_fixed=True,
    sections={"cam_contacts": ""},
)
