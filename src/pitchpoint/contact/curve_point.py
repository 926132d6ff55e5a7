# SPDX-License-Identifier: Apache-2.0
"""Kernels for planar curves: position, tangent and curvature at a parameter; point nearest to a given point.

Derivation: docs/theory/contacts.md, "Curves".
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel

LINE, ARC, CUBIC, INVOLUTE = 0, 1, 2, 3
WIDTH = 16
FORM, BEGIN, LENGTH, COURSE, SPREAD = 0, 12, 13, 14, 15
TWO_PI = 6.283185307179586
EDGE = 1e-9
"""Tolerance of the parameter beyond the ends of a segment."""


@kernel
def point_of(rows, k, t):
    """Position x, y [m], unit tangent, speed [m] and turn [rad] of segment k at parameter t.

    speed and turn are the derivatives of arc length and direction by t; the curvature is turn/speed. Arcs of
    radius zero have speed 0.

    >>> from pitchpoint.contact.curve import circle
    >>> tuple(round(float(x), 9) + 0.0 for x in point_of(circle(0.5).rows, 0, 0.25))
    (0.0, 0.5, -1.0, 0.0, 3.141592654, 6.283185307)
    """
    form = rows[k, 0]
    if form == LINE:
        dx = rows[k, 6] - rows[k, 4]
        dy = rows[k, 7] - rows[k, 5]
        size = math.sqrt(dx * dx + dy * dy)
        return rows[k, 4] + t * dx, rows[k, 5] + t * dy, dx / size, dy / size, size, 0.0
    if form == ARC:
        sweep = rows[k, 8]
        angle = rows[k, 7] + sweep * t
        c = math.cos(angle)
        s = math.sin(angle)
        sign = 1.0 if sweep > 0.0 else -1.0
        r = rows[k, 6]
        return rows[k, 4] + r * c, rows[k, 5] + r * s, -sign * s, sign * c, r * abs(sweep), sweep
    if form == CUBIC:
        x = rows[k, 4] + t * (rows[k, 5] + t * (rows[k, 6] + t * rows[k, 7]))
        y = rows[k, 8] + t * (rows[k, 9] + t * (rows[k, 10] + t * rows[k, 11]))
        dx = rows[k, 5] + t * (2.0 * rows[k, 6] + 3.0 * t * rows[k, 7])
        dy = rows[k, 9] + t * (2.0 * rows[k, 10] + 3.0 * t * rows[k, 11])
        ex = 2.0 * rows[k, 6] + 6.0 * t * rows[k, 7]
        ey = 2.0 * rows[k, 10] + 6.0 * t * rows[k, 11]
        square = dx * dx + dy * dy
        size = math.sqrt(square)
        return x, y, dx / size, dy / size, size, (dx * ey - dy * ex) / square
    # involute: r_b (1 - i u) e^(iu), mirrored and rotated
    r = rows[k, 4]
    phase = rows[k, 5]
    hand = rows[k, 6]
    per = rows[k, 8] - rows[k, 7]
    u = rows[k, 7] + per * t
    c = math.cos(u)
    s = math.sin(u)
    x = r * (c + u * s)
    y = hand * r * (s - u * c)
    sign = 1.0 if per > 0.0 else -1.0
    tx = sign * c
    ty = sign * hand * s
    c = math.cos(phase)
    s = math.sin(phase)
    return c * x - s * y, s * x + c * y, c * tx - s * ty, s * tx + c * ty, r * u * abs(per), hand * per


@kernel
def arc_length(rows, k, t):
    """Arc length from the start of the curve to parameter t of segment k [m].

    >>> from pitchpoint.contact.curve import polygon
    >>> float(arc_length(polygon([(0, 0), (1, 0), (1, 1), (0, 1)]).rows, 2, 0.25))
    1.25
    """
    if rows[k, 0] == INVOLUTE:
        a = rows[k, 7]
        u = a + (rows[k, 8] - a) * t
        return rows[k, BEGIN] + 0.5 * rows[k, 4] * abs(u * u - a * a)
    return rows[k, BEGIN] + t * rows[k, LENGTH]


@kernel
def sweep_place(start, sweep, angle):
    """Parameter of an arc at a polar angle; outside 0 to 1 if the arc does not reach the angle.

    >>> float(sweep_place(0.5, 2.0, 1.5)), bool(sweep_place(0.0, 1.0, -0.1) < 0.0)
    (0.5, True)
    """
    sign = 1.0 if sweep > 0.0 else -1.0
    way = sign * (angle - start)
    way -= TWO_PI * math.floor(way / TWO_PI)
    whole = abs(sweep)
    if way > whole and way - whole > TWO_PI - way:
        way -= TWO_PI  # nearer to the start than to the end
    return way / whole


@kernel
def _nearest_by_newton(rows, k, x, y):
    """Parameter at which a smooth segment is nearest to a point, from -0.25 to 1.25."""
    best = 1e300
    t = 0.5
    for i in range(9):
        s = 0.125 * i
        px, py, tx, ty, speed, turn = point_of(rows, k, s)
        d = (px - x) * (px - x) + (py - y) * (py - y)
        if d < best:
            best = d
            t = s
    for _ in range(40):
        px, py, tx, ty, speed, turn = point_of(rows, k, t)
        along = (x - px) * tx + (y - py) * ty
        off = (x - px) * ty - (y - py) * tx
        slope = speed + turn * off
        if slope < 0.1 * speed:
            slope = speed
        step = min(max(along / slope, -0.25), 0.25)
        t = min(max(t + step, -0.25), 1.25)
        if abs(step) < 1e-15:
            break
    return t


@kernel
def nearest(rows, k, x, y):
    """Point of segment k nearest to (x, y): found (1 or 0), parameter, signed distance [m], outward normal.

    The distance is positive outside the material. Only points inside the segment at which the distance is a
    minimum are accepted, convex corners included.

    >>> from pitchpoint.contact.curve import circle
    >>> tuple(round(float(x), 9) for x in nearest(circle(0.5).rows, 0, 0.0, 0.75))
    (1.0, 0.25, 0.25, 0.0, 1.0)
    """
    if rows[k, 0] == ARC:
        dx = x - rows[k, 4]
        dy = y - rows[k, 5]
        d = math.sqrt(dx * dx + dy * dy)
        if d < 1e-12 * (1.0 + rows[k, 6]):
            return 0, 0.0, 0.0, 1.0, 0.0
        t = sweep_place(rows[k, 7], rows[k, 8], math.atan2(dy, dx))
        if t < -EDGE or t > 1.0 + EDGE:
            return 0, 0.0, 0.0, 1.0, 0.0
        if rows[k, 8] > 0.0:
            return 1, t, d - rows[k, 6], dx / d, dy / d
        return 1, t, rows[k, 6] - d, -dx / d, -dy / d
    if rows[k, 0] == LINE:
        dx = rows[k, 6] - rows[k, 4]
        dy = rows[k, 7] - rows[k, 5]
        t = ((x - rows[k, 4]) * dx + (y - rows[k, 5]) * dy) / (dx * dx + dy * dy)
    else:
        t = _nearest_by_newton(rows, k, x, y)
    if t < -EDGE or t > 1.0 + EDGE:
        return 0, 0.0, 0.0, 1.0, 0.0
    px, py, tx, ty, speed, turn = point_of(rows, k, t)
    off = (x - px) * ty - (y - py) * tx
    if speed + turn * off <= 0.0:
        return 0, 0.0, 0.0, 1.0, 0.0
    return 1, t, off, ty, -tx
