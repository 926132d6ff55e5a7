# SPDX-License-Identifier: Apache-2.0
"""Loop-closing constraint rows: point in plane, perpendicular directions, constant distance, screw.

Every joint outside the spanning tree consists of such rows (`system/closures.py`). Markers are fixed to both
bodies; s is the arm of marker i from the origin of body i, d that of the same point from the origin of body
j, and rho points from marker j to marker i:

    POINT     g = a . rho          a fixed to body j      rows (a, s x a) and -(a, d x a)
    RIGHT     g = b . a            b fixed to body i      rows (0, b x a) and -(0, b x a)
    DISTANCE  g = |rho| - length   n = rho / |rho|        rows (n, s x n) and -(n, s_j x n)
    SCREW     g = a . rho - lead theta                    rows of POINT less lead (0, grad theta)

theta is the angle about a from x_j (body j) to b (body i), known up to whole turns; g uses the number of
turns that makes |g| smallest, since the travel along the axis determines the turns of the screw.

The tangent is that of the constraint forces at constant multipliers.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import INCONSISTENT, OK
from pitchpoint.elements.kind import CLOSURE, CONSTRAINT, Kind, Power
from pitchpoint.multibody.channels import F8, constraint_args, constraint_rates, observations, tangents
from pitchpoint.multibody.vectors import add, cross, dot, less, moved_axis, times, triple, unit

POINT, RIGHT, DISTANCE, SCREW = 0, 1, 2, 3
TWO_PI = 6.283185307179586

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("row", "i8"),  # constraint row; written by the layout
        ("form", "i8"),  # POINT, RIGHT, DISTANCE or SCREW
        ("p_i", "f8", 3),  # marker i, axes S of body i [m]
        ("p_j", "f8", 3),  # marker j, axes S of body j [m]
        ("b_i", "f8", 3),  # RIGHT, SCREW: direction fixed to body i
        ("a_j", "f8", 3),  # POINT, RIGHT, SCREW: direction fixed to body j
        ("x_j", "f8", 3),  # SCREW: direction fixed to body j at which the angle is zero
        ("lead", "f8"),  # SCREW: travel along a per radian [m/rad]
        ("length", "f8"),  # DISTANCE [m]
        ("out", "i8"),
    ],
    align=True,
)

OUTPUTS = (("reaction_force", "N", "force of the row on the first body"),)


def outputs(record: np.void) -> tuple[tuple[str, str, str], ...]:
    """Observations of one record: a reaction force, or a reaction moment for perpendicular directions."""
    if record["form"] == RIGHT:
        return (("reaction_moment", "N m", "moment of the row on the first body"),)
    return OUTPUTS


@kernel
def _row(Gf, r, side, sign, linear, angular):
    for k in range(3):
        Gf[r, side, k] = sign * linear[k]
        Gf[r, side, 3 + k] = sign * angular[k]


@kernel
def _second(f, s):
    """Acceleration of the point at the arm s of a body."""
    w = triple(f["tw"], 3)
    return add(triple(f["ac"], 0), add(cross(triple(f["ac"], 3), s), cross(w, cross(w, s))))


@kernel
def _velocity(f, s):
    return add(triple(f["tw"], 0), cross(triple(f["tw"], 3), s))


@kernel
def _turning(f, a):
    """First and second time derivative of a vector fixed to a body."""
    w = triple(f["tw"], 3)
    first = cross(w, a)
    return first, add(cross(triple(f["ac"], 3), a), cross(w, first))


@kernel
def _put(k, ck, first, linear, angular, col):
    """Add to one column of a pair tangent."""
    for i in range(3):
        k[i, col] += ck * first * linear[i]
        k[3 + i, col] += ck * first * angular[i]


@kernel
def _point(b, f, g, rows, r, ck, kk):
    """Row and tangent of a point of body i in a plane of body j; returns g and its second time derivative."""
    a = moved_axis(g, b["a_j"])
    s = moved_axis(f, b["p_i"])
    s_j = moved_axis(g, b["p_j"])
    d = less(add(triple(f["r"], 0), s), triple(g["r"], 0))
    rho = less(d, s_j)
    _row(rows, r, 0, 1.0, a, cross(s, a))
    _row(rows, r, 1, -1.0, a, cross(d, a))
    a1, a2 = _turning(g, a)
    speed = less(_velocity(f, s), _velocity(g, s_j))
    second = dot(a, less(_second(f, s), _second(g, s_j))) + 2.0 * dot(a1, speed) + dot(a2, rho)
    if ck != 0.0:
        nothing = (0.0, 0.0, 0.0)
        for c in range(3):
            x = unit(c)
            xa = cross(x, a)
            xs = cross(x, s)
            _put(kk[b["ii"]], ck, 1.0, nothing, cross(xs, a), 3 + c)
            _put(kk[b["ij"]], ck, 1.0, xa, cross(s, xa), 3 + c)
            _put(kk[b["ji"]], ck, -1.0, nothing, xa, c)
            _put(kk[b["ji"]], ck, -1.0, nothing, cross(xs, a), 3 + c)
            _put(kk[b["jj"]], ck, 1.0, nothing, xa, c)
            _put(kk[b["jj"]], ck, -1.0, xa, cross(d, xa), 3 + c)
    return dot(a, rho), second


@kernel
def _right(b, f, g, rows, r, ck, kk):
    """Row and tangent of two perpendicular directions; returns g and its second time derivative."""
    a = moved_axis(g, b["a_j"])
    e = moved_axis(f, b["b_i"])
    nothing = (0.0, 0.0, 0.0)
    turn = cross(e, a)
    _row(rows, r, 0, 1.0, nothing, turn)
    _row(rows, r, 1, -1.0, nothing, turn)
    a1, a2 = _turning(g, a)
    e1, e2 = _turning(f, e)
    if ck != 0.0:
        for c in range(3):
            x = unit(c)
            by_i = cross(cross(x, e), a)
            by_j = cross(e, cross(x, a))
            _put(kk[b["ii"]], ck, 1.0, nothing, by_i, 3 + c)
            _put(kk[b["ij"]], ck, 1.0, nothing, by_j, 3 + c)
            _put(kk[b["ji"]], ck, -1.0, nothing, by_i, 3 + c)
            _put(kk[b["jj"]], ck, -1.0, nothing, by_j, 3 + c)
    return dot(e, a), dot(e2, a) + 2.0 * dot(e1, a1) + dot(e, a2)


@kernel
def _distance(b, f, g, rows, r, ck, kk):
    """Row and tangent of two points at constant distance; returns g, its second derivative, the distance."""
    s = moved_axis(f, b["p_i"])
    s_j = moved_axis(g, b["p_j"])
    rho = less(add(triple(f["r"], 0), s), add(triple(g["r"], 0), s_j))
    length = math.sqrt(dot(rho, rho))
    if length == 0.0:
        return 0.0, 0.0, 0.0
    n = times(1.0 / length, rho)
    _row(rows, r, 0, 1.0, n, cross(s, n))
    _row(rows, r, 1, -1.0, n, cross(s_j, n))
    speed = less(_velocity(f, s), _velocity(g, s_j))
    along = dot(n, speed)
    second = dot(n, less(_second(f, s), _second(g, s_j))) + (dot(speed, speed) - along * along) / length
    if ck != 0.0:
        for c in range(6):
            x = unit(c) if c < 3 else cross(unit(c - 3), s)  # motion of marker i, then of marker j
            y = unit(c) if c < 3 else cross(unit(c - 3), s_j)
            dn = times(1.0 / length, less(x, times(dot(n, x), n)))
            dm = times(-1.0 / length, less(y, times(dot(n, y), n)))
            by_i = cross(s, dn)
            by_j = cross(s_j, dm)
            if c >= 3:
                by_i = add(by_i, cross(x, n))
                by_j = add(by_j, cross(y, n))
            _put(kk[b["ii"]], ck, 1.0, dn, by_i, c)
            _put(kk[b["ij"]], ck, 1.0, dm, cross(s, dm), c)
            _put(kk[b["ji"]], ck, -1.0, dn, cross(s_j, dn), c)
            _put(kk[b["jj"]], ck, -1.0, dm, by_j, c)
    return length - b["length"], second, length


@kernel
def _angle(e, x, y, de, dx, dy):
    """Gradient of the angle of e in the plane x, y by a rotation of e, and its change for given de, dx, dy.

    theta = atan2(s, p) with p = e . x, s = e . y, so d(theta) = turn . (e x u), u = (p y - s x)/(p p + s s).
    """
    p = dot(e, x)
    s = dot(e, y)
    dp = dot(de, x) + dot(e, dx)
    ds = dot(de, y) + dot(e, dy)
    size = p * p + s * s
    u = times(1.0 / size, less(times(p, y), times(s, x)))
    du = add(less(times(dp, y), times(ds, x)), less(times(p, dy), times(s, dx)))
    du = times(1.0 / size, less(du, times(2.0 * (p * dp + s * ds), u)))
    return cross(e, u), add(cross(de, u), cross(e, du))


@kernel
def _screw(b, f, g, rows, r, ck, kk):
    """Row and tangent of a screw; returns g and its second time derivative."""
    way, second = _point(b, f, g, rows, r, ck, kk)
    lead = b["lead"]
    x = moved_axis(g, b["x_j"])
    y = cross(moved_axis(g, b["a_j"]), x)
    e = moved_axis(f, b["b_i"])
    o_i = triple(f["tw"], 3)
    o_j = triple(g["tw"], 3)
    w, rate = _angle(e, x, y, cross(o_i, e), cross(o_j, x), cross(o_j, y))
    for k in range(3):
        rows[r, 0, 3 + k] -= lead * w[k]
        rows[r, 1, 3 + k] += lead * w[k]
    second -= lead * dot(less(triple(f["ac"], 3), triple(g["ac"], 3)), w)
    second -= lead * dot(less(o_i, o_j), rate)
    if ck != 0.0:
        nothing = (0.0, 0.0, 0.0)
        for c in range(3):
            z = unit(c)
            _, by_i = _angle(e, x, y, cross(z, e), nothing, nothing)
            _, by_j = _angle(e, x, y, nothing, cross(z, x), cross(z, y))
            _put(kk[b["ii"]], ck, -lead, nothing, by_i, 3 + c)
            _put(kk[b["ij"]], ck, -lead, nothing, by_j, 3 + c)
            _put(kk[b["ji"]], ck, lead, nothing, by_i, 3 + c)
            _put(kk[b["jj"]], ck, lead, nothing, by_j, 3 + c)
    theta = math.atan2(dot(e, y), dot(e, x))
    turns = math.floor((way / lead - theta) / TWO_PI + 0.5)
    return way - lead * (theta + TWO_PI * turns), second


@kernel
def closure(rec, ctl, fr, g):
    """Constraint rows of all closures, their second derivatives, tangents and reactions."""
    c = ctl[0]
    v, gt, gtt, rows = constraint_rates(ctl)
    lam = view(c["lam"], c["nc"], F8)
    kk = tangents(ctl)
    for e in range(rec.size):
        b = rec[e]
        r = b["row"]
        f = fr[b["i"]]
        h = fr[b["j"]]
        # exact tangents only: near singular positions the noise of large multipliers would spoil iterations
        ck = c["ck"] * lam[r] if c["jac"] == 2 else 0.0
        if b["form"] == POINT:
            g[r], gtt[r] = _point(b, f, h, rows, r, ck, kk)
        elif b["form"] == SCREW:
            g[r], gtt[r] = _screw(b, f, h, rows, r, ck, kk)
        elif b["form"] == RIGHT:
            g[r], gtt[r] = _right(b, f, h, rows, r, ck, kk)
        else:
            g[r], gtt[r], length = _distance(b, f, h, rows, r, ck, kk)
            if length == 0.0:
                c["bad"] = e
                return INCONSISTENT
        if c["out"] != 0:
            observations(ctl)[b["out"]] = -lam[r]
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, q, g, G = constraint_args(ctl)
    return closure(view(rec, n, RECORD), c, fr, g)


def _row_unit(record: np.void) -> str:
    """Rows of perpendicular directions have no unit."""
    return "" if record["form"] == RIGHT else "m"


KIND = Kind(
    name="closure",
    channel=CONSTRAINT,
    record=RECORD,
    entry=entry,
    outputs=outputs,
    rows=1,
    row_unit=_row_unit,
    body_fixed=True,
    role=CLOSURE,
    massless=True,
    sections={"joints": "", "rods": "rod"},
    label="reaction",
    names_modes=False,
    power=Power(),
)
