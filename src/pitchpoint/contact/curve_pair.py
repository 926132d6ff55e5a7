# SPDX-License-Identifier: Apache-2.0
"""Common normals of two planar curves: points whose outward normals are opposite and collinear.

Curve A is transformed into the plane of curve B by the translation d and the upper left part of M, the
rotation from the axes of A to those of B. All pairs of segments are evaluated. If one of the two is an arc,
the point nearest to its centre has a closed form or follows from one equation. Otherwise Newton's method
solves two equations in the parameters s of A and t of B, r1 = (x_A - x_B) . tau_B and r2 = tau_A . n_B,
starting from the best of 25 points. The search has no memory: equal positions give bit-identical results.

Derivation: docs/theory/contacts.md, "Curves".
"""

from __future__ import annotations

import math

from pitchpoint.contact.curve_point import (
    ARC,
    COURSE,
    EDGE,
    SPREAD,
    TWO_PI,
    nearest,
    point_of,
    sweep_place,
)
from pitchpoint.core.kernel import kernel

MAX_CONTACTS = 4
"""Maximum number of simultaneous contacts of two curves; the deepest are used."""
HIT = 5
"""Numbers per contact: gap, parameter and segment of A, parameter and segment of B."""


@kernel
def carried(rows, k, t, M, d):
    """`point_of` curve A, transformed into the plane of curve B; a tilt of A foreshortens it.

    >>> import numpy as np
    >>> from pitchpoint.contact.curve import circle
    >>> turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    >>> found = carried(circle(0.5).rows, 0, 0.0, turn, np.array([1.0, 0.0, 0.0]))
    >>> tuple(round(float(x), 6) + 0.0 for x in found)
    (1.0, 0.5, -1.0, 0.0, 3.141593, 6.283185)
    """
    x, y, tx, ty, speed, turn = point_of(rows, k, t)
    ux = M[0, 0] * tx + M[0, 1] * ty
    uy = M[1, 0] * tx + M[1, 1] * ty
    square = ux * ux + uy * uy
    size = math.sqrt(square)
    turn *= (M[0, 0] * M[1, 1] - M[0, 1] * M[1, 0]) / square
    px = d[0] + M[0, 0] * x + M[0, 1] * y
    py = d[1] + M[1, 0] * x + M[1, 1] * y
    return px, py, ux / size, uy / size, speed * size, turn


@kernel
def merit(A, ka, s, B, kb, t, M, d):
    """Residual norm of the common-normal equations at s and t; 1e300 if the normals point the same way.

    >>> import numpy as np
    >>> from pitchpoint.contact.curve import circle
    >>> one = circle(0.5).rows
    >>> float(merit(one, 0, 0.5, one, 0, 0.0, np.eye(3), np.array([1.2, 0.0, 0.0]))) < 1e-20
    True
    """
    ax, ay, aux, auy, asp, atn = carried(A, ka, s, M, d)
    bx, by, bux, buy, bsp, btn = point_of(B, kb, t)
    if aux * bux + auy * buy >= 0.0:
        return 1e300
    size = asp + bsp
    along = ((ax - bx) * bux + (ay - by) * buy) / size
    across = aux * buy - auy * bux
    return along * along + across * across


@kernel
def _newton(A, ka, s, B, kb, t, M, d):
    """Solve r1 = r2 = 0 by Newton's method from s and t; returns converged (1 or 0), s and t."""
    for _ in range(40):
        ax, ay, aux, auy, asp, atn = carried(A, ka, s, M, d)
        bx, by, bux, buy, bsp, btn = point_of(B, kb, t)
        dx = ax - bx
        dy = ay - by
        off = dx * buy - dy * bux
        r1 = dx * bux + dy * buy
        r2 = aux * buy - auy * bux
        cos = aux * bux + auy * buy
        # left of tau_A times the outward normal of B: (-auy, aux) . (buy, -bux)
        j11 = asp * cos
        j12 = -bsp - btn * off
        j21 = -atn * cos
        j22 = btn * cos
        det = j11 * j22 - j12 * j21
        if det == 0.0:
            return 0, s, t
        ds = (-r1 * j22 + r2 * j12) / det
        dt = (-r2 * j11 + r1 * j21) / det
        large = max(abs(ds), abs(dt))
        if large > 0.25:
            ds *= 0.25 / large
            dt *= 0.25 / large
        s += ds
        t += dt
        if not (abs(s - 0.5) < 2.0 and abs(t - 0.5) < 2.0):
            return 0, s, t
        if large < 1e-14:
            return 1, s, t
    return (1 if large < 1e-10 else 0), s, t


@kernel
def _arc_against_piece(A, ka, B, kb, M, d):
    """Parameters for a convex arc of A against a segment of B: the point of B nearest to the arc centre."""
    x = d[0] + M[0, 0] * A[ka, 4] + M[0, 1] * A[ka, 5]
    y = d[1] + M[1, 0] * A[ka, 4] + M[1, 1] * A[ka, 5]
    found, t, phi, nx, ny = nearest(B, kb, x, y)
    if found == 0:
        return 0, 0.0, 0.0
    u = -(M[0, 0] * nx + M[1, 0] * ny)
    w = -(M[0, 1] * nx + M[1, 1] * ny)
    return 1, sweep_place(A[ka, 7], A[ka, 8], math.atan2(w, u)), t


@kernel
def _piece_against_arc(A, ka, B, kb, M, d):
    """Parameters for a segment of A against a convex arc of B: the point of A nearest to the arc centre."""
    dx = B[kb, 4] - d[0]
    dy = B[kb, 5] - d[1]
    x = M[0, 0] * dx + M[1, 0] * dy
    y = M[0, 1] * dx + M[1, 1] * dy
    found, s, phi, nx, ny = nearest(A, ka, x, y)
    if found == 0:
        return 0, 0.0, 0.0
    u = -(M[0, 0] * nx + M[0, 1] * ny)
    w = -(M[1, 0] * nx + M[1, 1] * ny)
    return 1, s, sweep_place(B[kb, 7], B[kb, 8], math.atan2(w, u))


@kernel
def common_normal(A, ka, B, kb, M, d):
    """Common normal of segment ka of A and kb of B: found (1 or 0), parameters s and t, gap [m].

    The gap is negative if the bodies overlap. Points beyond the end of a segment are rejected, and so are
    internal contacts whose gap is not a minimum because of the curvatures.

    >>> import numpy as np
    >>> from pitchpoint.contact.curve import circle
    >>> one = circle(0.5).rows
    >>> found, s, t, gap = common_normal(one, 0, one, 0, np.eye(3), np.array([0.9, 0.0, 0.0]))
    >>> int(found), round(float(s), 9), round(float(t), 9), round(float(gap), 9)
    (1, 0.5, 0.0, -0.1)
    """
    arc_a = A[ka, 0] == ARC and A[ka, 8] > 0.0
    arc_b = B[kb, 0] == ARC and B[kb, 8] > 0.0
    tilted = abs(M[2, 2]) < 1.0 - 1e-14
    point = arc_a and A[ka, 6] == 0.0
    if arc_a:
        found, s, t = _arc_against_piece(A, ka, B, kb, M, d)
    elif arc_b:
        found, s, t = _piece_against_arc(A, ka, B, kb, M, d)
    else:
        found = 0
        s = 0.5
        t = 0.5
        best = 1e300
        for i in range(5):
            for k in range(5):
                m = merit(A, ka, 0.25 * i, B, kb, 0.25 * k, M, d)
                if m < best:
                    best = m
                    s = 0.25 * i
                    t = 0.25 * k
        if best < 1e300:
            found, s, t = _newton(A, ka, s, B, kb, t, M, d)
    if found != 0 and tilted and (arc_a or arc_b) and not point:
        found, s, t = _newton(A, ka, s, B, kb, t, M, d)
    if found == 0 or min(s, t) < -EDGE or max(s, t) > 1.0 + EDGE:
        return 0, 0.0, 0.0, 0.0
    ax, ay, aux, auy, asp, atn = carried(A, ka, s, M, d)
    bx, by, bux, buy, bsp, btn = point_of(B, kb, t)
    gap = (ax - bx) * buy - (ay - by) * bux
    if aux * bux + auy * buy >= 0.0 or atn * bsp + asp * btn + gap * atn * btn <= 0.0:
        return 0, 0.0, 0.0, 0.0
    return 1, s, t, gap


@kernel
def _may_be_opposite(A, ka, B, kb, turn, slack):
    """Whether outward normals of two segments can be opposite, with A rotated by `turn` [rad] against B."""
    off = A[ka, COURSE] + turn - B[kb, COURSE] + 0.5 * TWO_PI
    off -= TWO_PI * math.floor(off / TWO_PI + 0.5)
    return abs(off) <= A[ka, SPREAD] + B[kb, SPREAD] + slack


@kernel
def _same(hits, n, A, ka, s, B, kb, t):
    """Whether a contact at the joint of two segments has already been found."""
    ax, ay, aux, auy, asp, atn = point_of(A, ka, s)
    bx, by, bux, buy, bsp, btn = point_of(B, kb, t)
    near = 4.0 * EDGE * (A[ka, 3] + B[kb, 3])
    for h in range(n):
        px, py, pux, puy, psp, ptn = point_of(A, int(hits[h, 2]), hits[h, 1])
        qx, qy, qux, quy, qsp, qtn = point_of(B, int(hits[h, 4]), hits[h, 3])
        near_h = near + 4.0 * EDGE * (A[int(hits[h, 2]), 3] + B[int(hits[h, 4]), 3])
        apart = abs(ax - px) + abs(ay - py) + abs(bx - qx) + abs(by - qy)
        if apart < near_h and aux * pux + auy * puy > 0.999999 and bux * qux + buy * quy > 0.999999:
            return True
    return False


@kernel
def nearest_normal(A, B, M, d, least, hits):
    """Store the common normal with the smallest |gap| below `least` [m] in row 0 of `hits`; False if none.

    >>> import numpy as np
    >>> from pitchpoint.contact.curve import circle
    >>> one, hits = circle(0.5).rows, np.zeros((MAX_CONTACTS, HIT))
    >>> bool(nearest_normal(one, one, np.eye(3), np.array([0.9, 0.0, 0.0]), 1.0, hits))
    True
    >>> round(float(hits[0, 0]), 9), round(float(hits[0, 1]), 9)
    (-0.1, 0.5)
    """
    slack = 1e-6 + 2.0 * (1.0 - M[2, 2])
    turn = math.atan2(M[1, 0], M[0, 0])
    any_found = False
    for ka in range(A.shape[0]):
        x = d[0] + M[0, 0] * A[ka, 1] + M[0, 1] * A[ka, 2]
        y = d[1] + M[1, 0] * A[ka, 1] + M[1, 1] * A[ka, 2]
        for kb in range(B.shape[0]):
            apart = math.sqrt((x - B[kb, 1]) ** 2 + (y - B[kb, 2]) ** 2) - A[ka, 3] - B[kb, 3]
            if apart >= least or not _may_be_opposite(A, ka, B, kb, turn, slack):
                continue
            found, s, t, phi = common_normal(A, ka, B, kb, M, d)
            if found == 0 or abs(phi) >= least:
                continue
            any_found = True
            least = abs(phi)
            hits[0, 0] = phi
            hits[0, 1] = s
            hits[0, 2] = ka
            hits[0, 3] = t
            hits[0, 4] = kb
    return any_found


@kernel
def _deep_contact(A, B, M, d, reach, best, hits):
    """Whether the nearest points of the curves are a deep overlap; stored in row 0. `best`: gap found so far.

    The sign of the gap at the closest points of the curves without offset shows whether one body is inside
    the other.
    """
    offset = reach[0]
    near = False
    for ka in range(A.shape[0]):
        x = d[0] + M[0, 0] * A[ka, 1] + M[0, 1] * A[ka, 2] - reach[3]
        y = d[1] + M[1, 0] * A[ka, 1] + M[1, 1] * A[ka, 2] - reach[4]
        near = near or math.sqrt(x * x + y * y) < A[ka, 3] + offset + reach[5]
    before = (hits[0, 0], hits[0, 1], hits[0, 2], hits[0, 3], hits[0, 4])
    least = best + offset if before[4] >= 0.0 else 1e300
    if not near or not nearest_normal(A, B, M, d, least, hits):
        return False
    hits[0, 0] -= offset
    if hits[0, 0] < 0.0 and hits[0, 0] >= -reach[6]:
        return True
    for k in range(HIT):
        hits[0, k] = before[k]
    return False


@kernel
def contacts(A, B, M, d, reach, hits):
    """Store the deepest contacts in `hits` (MAX_CONTACTS rows); return their number and the gap.

    reach = (offset of A [m], maximum overlap of the regular search [m], maximum gap of the search [m], x, y
    and radius of the bounding circle of B [m], maximum overlap of all [m]). Row 0 holds the nearest common
    normal even without contact; its last number is -1 if none is within the maximum gap, which is then
    returned. If no contact is found, the closest points are accepted up to the maximum overlap of all: one
    body is then deep inside the other.

    >>> import numpy as np
    >>> from pitchpoint.contact.curve import circle
    >>> one = circle(0.5).rows
    >>> reach = np.array([0.0, 0.2, 1.0, 0.0, 0.0, 0.5, 0.2])
    >>> hits = np.zeros((MAX_CONTACTS, HIT))
    >>> n, gap = contacts(one, one, np.eye(3), np.array([0.9, 0.0, 0.0]), reach, hits)
    >>> int(n), round(float(gap), 9)
    (1, -0.1)
    """
    offset = reach[0]
    best = reach[2]
    n = 0
    hits[0, 4] = -1.0
    slack = 1e-6 + 2.0 * (1.0 - M[2, 2])  # a tilt changes the tangent directions
    turn = math.atan2(M[1, 0], M[0, 0])
    for ka in range(A.shape[0]):
        x = d[0] + M[0, 0] * A[ka, 1] + M[0, 1] * A[ka, 2]
        y = d[1] + M[1, 0] * A[ka, 1] + M[1, 1] * A[ka, 2]
        r = A[ka, 3] + offset
        whole = math.sqrt((x - reach[3]) ** 2 + (y - reach[4]) ** 2) - r - reach[5]
        if whole > max(best, reach[1]):  # overlaps are limited to reach[1]
            continue
        for kb in range(B.shape[0]):
            dx = x - B[kb, 1]
            dy = y - B[kb, 2]
            apart = max(best, reach[1]) + r + B[kb, 3]
            if dx * dx + dy * dy > apart * apart:
                continue
            if not _may_be_opposite(A, ka, B, kb, turn, slack):
                continue
            found, s, t, gap = common_normal(A, ka, B, kb, M, d)
            gap -= offset
            if found == 0 or gap < -reach[1] or (gap >= 0.0 and gap >= best):
                continue
            if gap < 0.0 and _same(hits, n, A, ka, s, B, kb, t):
                continue
            best = min(best, gap)
            at = n if gap < 0.0 else 0
            if gap < 0.0:
                while at > 0 and hits[at - 1, 0] > gap:
                    if at < MAX_CONTACTS:
                        for c in range(HIT):
                            hits[at, c] = hits[at - 1, c]
                    at -= 1
                n = min(n + 1, MAX_CONTACTS)
            if at < MAX_CONTACTS and (gap < 0.0 or n == 0):
                hits[at, 0] = gap
                hits[at, 1] = s
                hits[at, 2] = ka
                hits[at, 3] = t
                hits[at, 4] = kb
    if n == 0 and reach[6] > reach[1] and _deep_contact(A, B, M, d, reach, best, hits):
        return 1, hits[0, 0]
    return n, best
