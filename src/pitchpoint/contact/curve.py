# SPDX-License-Identifier: Apache-2.0
"""Planar curves as arrays for the kernels: segments are straight lines, arcs, cubics and involutes.

A curve has a direction, with the material on its left: a counter-clockwise outline is a body, a clockwise
one a hole. The outward normal points to the right. Convex corners are arcs of radius zero, so that the
nearest point and its normal move continuously around them.

A row has 16 numbers: type of the segment, centre and radius of its bounding circle [m], eight numbers of the
type, arc length at its start and its length [m], mean direction and the largest deviation from it [rad]. The
parameter of a segment runs from 0 to 1. The position along the curve is the arc length; within a cubic
segment it is proportional to the parameter.

Derivation: docs/theory/contacts.md, "Curves".
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.contact.curve_point import (
    ARC,
    BEGIN,
    COURSE,
    CUBIC,
    FORM,
    INVOLUTE,
    LENGTH,
    LINE,
    SPREAD,
    TWO_PI,
    WIDTH,
    point_of,
)

NUMBERS = 4
SMOOTH = 1e-9
"""Change of direction between two segments below which no corner is inserted [rad]."""

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class Curve:
    """A planar curve.

    Parameters
    ----------
    rows
        Segments, shape (n, 16).
    closed
        Whether the last segment ends where the first begins.
    """

    rows: FloatArray
    closed: bool

    @property
    def length(self) -> float:
        """Arc length [m]."""
        return float(self.rows[-1, BEGIN] + self.rows[-1, LENGTH])

    def circle(self) -> tuple[float, float, float]:
        """Centre and radius of a bounding circle of the curve [m]."""
        low = (self.rows[:, 1:3] - self.rows[:, 3:4]).min(axis=0)
        high = (self.rows[:, 1:3] + self.rows[:, 3:4]).max(axis=0)
        center = 0.5 * (low + high)
        reach = np.hypot(*(self.rows[:, 1:3] - center).T) + self.rows[:, 3]
        return float(center[0]), float(center[1]), float(reach.max())


def _row(form: int, numbers: Sequence[float], points: FloatArray, length: float) -> FloatArray:
    """Row of one segment; its bounding circle encloses `points` on it plus half their spacing."""
    row = np.zeros(WIDTH)
    row[FORM], row[LENGTH] = form, length
    row[NUMBERS : NUMBERS + len(numbers)] = numbers
    center = 0.5 * (points.min(axis=0) + points.max(axis=0))
    between = length / max(len(points) - 1, 1)
    row[1:3], row[3] = center, np.hypot(*(points - center).T).max() + 0.5 * between
    return row


def line_piece(start: ArrayLike, end: ArrayLike) -> FloatArray:
    """Straight segment, as a row for `chain`.

    Parameters
    ----------
    start, end
        End points [m], shape (2,).

    Examples
    --------
    >>> float(line_piece((0.0, 0.0), (3.0, 4.0))[LENGTH])
    5.0
    """
    points = np.array([start, end], float)
    length = float(np.hypot(*(points[1] - points[0])))
    row = _row(LINE, points.ravel().tolist(), points, length)
    row[3] = 0.5 * length
    return row


def arc_piece(center: ArrayLike, radius: float, start: float, sweep: float) -> FloatArray:
    """Circular arc, as a row for `chain`, shape (n,).

    Parameters
    ----------
    center, radius
        Centre and radius [m]; a radius of zero is a corner.
    start
        Start angle [rad].
    sweep
        Sweep angle [rad]: positive (counter-clockwise) for a convex arc, negative (clockwise) for a concave
        one.

    Examples
    --------
    >>> round(float(arc_piece((0.0, 0.0), 0.5, 0.0, -1.0)[LENGTH]), 9)
    0.5
    """
    x, y = np.asarray(center, float)
    row = _row(ARC, (x, y, radius, start, sweep), np.zeros((1, 2)), radius * abs(sweep))
    row[1:4] = x, y, radius
    return row


def _pair(z: complex) -> tuple[float, float]:
    return z.real, z.imag


def _ends(row: FloatArray) -> tuple[complex, complex, complex, complex]:
    """Start and end point of a segment, and the unit tangents there."""
    found = []
    for t in (0.0, 1.0):
        x, y, tx, ty, _, _ = point_of(np.ascontiguousarray(row)[None, :], 0, t)
        found.append((complex(x, y), complex(tx, ty)))
    return found[0][0], found[1][0], found[0][1], found[1][1]


def _course(row: FloatArray) -> tuple[float, float]:
    """Mean direction of a segment and the largest deviation from it [rad]."""
    rows = np.ascontiguousarray(row)[None, :]
    directions = []
    for t in np.linspace(0.0, 1.0, 65):
        _, _, tx, ty, _, _ = point_of(rows, 0, t)
        directions.append(math.atan2(ty, tx))
    angle = np.unwrap(directions)
    step = 0.0 if row[FORM] != CUBIC else float(np.abs(np.diff(angle)).max())  # monotone in others
    return 0.5 * float(angle.min() + angle.max()), 0.5 * float(np.ptp(angle)) + step


def chain(rows: Sequence[FloatArray], closed: bool) -> Curve:
    """Join segments to a curve: set arc lengths and directions, insert zero-radius arcs at convex corners.

    Parameters
    ----------
    rows
        Segments in order, rows of equal shape; each begins where the previous one ends.
    closed
        Whether the last segment ends where the first begins.

    Raises
    ------
    ValueError
        If a segment does not end where the next one begins.

    Examples
    --------
    >>> square = polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> len(square.rows), square.length
    (8, 4.0)
    """
    ends = [_ends(row) for row in rows]
    size = max(float(row[3]) for row in rows)
    found = []
    for k, row in enumerate(rows):
        found.append(row)
        if k == len(rows) - 1 and not closed:
            break
        following = ends[(k + 1) % len(rows)]
        if abs(following[0] - ends[k][1]) > 1e-9 * size:
            raise ValueError(f"piece {k + 1} of the curve does not end where the next one begins")
        turn = following[2] / ends[k][3]
        angle = math.atan2(turn.imag, turn.real)
        if angle > SMOOTH:
            normal = -1j * ends[k][3]
            found.append(arc_piece(_pair(ends[k][1]), 0.0, math.atan2(normal.imag, normal.real), angle))
    made = np.array(found)
    made[:, COURSE], made[:, SPREAD] = np.transpose([_course(row) for row in made])
    made[:, BEGIN] = np.concatenate([[0.0], np.cumsum(made[:-1, LENGTH])])
    return Curve(made, closed)


def circle(radius: float, center: tuple[float, float] = (0.0, 0.0), hole: bool = False) -> Curve:
    """Circle as a closed curve.

    Parameters
    ----------
    radius, center
        Radius and centre [m].
    hole
        Whether the material is outside the circle.

    Examples
    --------
    >>> round(circle(0.5).length, 6)
    3.141593
    """
    return chain([arc_piece(center, radius, 0.0, -TWO_PI if hole else TWO_PI)], True)


def vertex(x: float = 0.0, y: float = 0.0) -> FloatArray:
    """Single point, as a row (shape as of `arc_piece`) for `chain`: a full circle of radius zero.

    Parameters
    ----------
    x, y
        Coordinates [m].

    Examples
    --------
    >>> float(vertex(1.0)[4])
    1.0
    """
    return arc_piece((x, y), 0.0, 0.0, TWO_PI)


def polygon(points: ArrayLike, radii: ArrayLike = 0.0, closed: bool = True) -> Curve:
    """Polygon with corners rounded by arcs.

    Parameters
    ----------
    points
        Corners [m], shape (n, 2), in the direction of the curve.
    radii
        Radius of the arc at each corner [m], one number or shape (n,); ignored at the ends of an open
        polygon.
    closed
        Whether the last corner is joined to the first.

    Raises
    ------
    ValueError
        If the arcs at two neighbouring corners overlap.

    Examples
    --------
    >>> round(polygon([(0, 0), (1, 0), (1, 1), (0, 1)], 0.1).length, 6)
    3.828319
    """
    corners = np.asarray(points, float) @ np.array([1.0, 1j])
    n = corners.size
    r = np.broadcast_to(np.asarray(radii, float), (n,)).copy()
    if not closed:
        r[[0, -1]] = 0.0
    before, after = corners - np.roll(corners, 1), np.roll(corners, -1) - corners
    entry, leave = corners.copy(), corners.copy()
    arcs: list[FloatArray | None] = [None] * n
    for k in range(n):
        if r[k] <= 0.0:
            continue
        one, two = before[k] / abs(before[k]), after[k] / abs(after[k])
        turn = math.atan2((two / one).imag, (two / one).real)
        cut = r[k] * math.tan(0.5 * abs(turn))
        entry[k], leave[k] = corners[k] - cut * one, corners[k] + cut * two
        if turn != 0.0:
            side = math.copysign(1.0, turn)
            normal = -1j * side * one
            arcs[k] = arc_piece(
                _pair(entry[k] - r[k] * normal), float(r[k]), math.atan2(normal.imag, normal.real), turn
            )
    rows: list[FloatArray] = []
    for k in range(n if closed else n - 1):
        if arcs[k] is not None:
            rows.append(arcs[k])  # type: ignore[arg-type]
        start, end = leave[k], entry[(k + 1) % n]
        along = (end - start) / after[k]
        if along.real < -1e-12:
            raise ValueError(f"the arcs at corners {k + 1} and {(k + 1) % n + 1} overlap")
        if along.real > 1e-12:
            rows.append(line_piece(_pair(start), _pair(end)))
    return chain(rows, closed)


def spline(points: ArrayLike, closed: bool = True) -> Curve:
    """Cubic spline through points, parametrised by chord length; continuous in curvature.

    Parameters
    ----------
    points
        Points [m], shape (n, 2), in the direction of the curve; a closed spline lists its first point only
        once.
    closed
        Whether the last point is joined to the first.

    Raises
    ------
    ValueError
        If two consecutive points coincide.

    Examples
    --------
    >>> angle = np.linspace(0.0, TWO_PI, 40, endpoint=False)
    >>> round(spline(np.column_stack([np.cos(angle), np.sin(angle)])).length, 4)
    6.2832
    """
    from scipy.interpolate import CubicSpline

    p = np.asarray(points, float)
    if closed:
        p = np.concatenate([p, p[:1]])
    chord = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(p, axis=0).T))])
    if np.any(np.diff(chord) <= 0.0):
        raise ValueError("two consecutive points of a spline coincide")
    form: Any = CubicSpline(chord, p, bc_type="periodic" if closed else "not-a-knot")
    rows = []
    for k, h in enumerate(np.diff(chord)):
        powers = form.c[::-1, k, :] * h ** np.arange(4)[:, None]
        t = np.linspace(0.0, 1.0, 17)
        line = np.vander(t, 4, increasing=True) @ powers
        rate = np.vander(t, 3, increasing=True) @ (powers[1:] * np.arange(1, 4)[:, None])
        speed = np.hypot(*rate.T)
        length = float(speed @ np.r_[1, [4, 2] * 7, 4, 1]) / 48.0
        rows.append(_row(CUBIC, (*powers[:, 0], *powers[:, 1]), line, length))
    return chain(rows, closed)


def involute_piece(r_b: float, phase: float, u: tuple[float, float], hand: int = 1) -> FloatArray:
    """Involute segment, base circle about the origin, as a row (shape as of `arc_piece`) for `chain`.

    Parameters
    ----------
    r_b
        Base radius [m].
    phase
        Angle at which the involute starts on the base circle [rad].
    u
        Roll angles at start and end [rad], both > 0; the radius is r_b sqrt(1 + u^2).
    hand
        1 if it unwinds counter-clockwise, -1 if clockwise.

    Raises
    ------
    ValueError
        If the base radius is not > 0, a roll angle is not > 0, or both roll angles are equal.

    Examples
    --------
    >>> row = involute_piece(0.05, 0.0, (0.2, 0.5))
    >>> round(float(row[LENGTH]), 6)
    0.00525
    """
    if not (min(u) > 0.0 and u[0] != u[1] and r_b > 0.0 and hand in (1, -1)):
        raise ValueError("an involute requires a positive base radius and two different positive roll angles")
    t = np.linspace(u[0], u[1], 17)
    z = r_b * (1.0 - 1j * t) * np.exp(1j * t)
    z = (z if hand > 0 else z.conj()) * np.exp(1j * phase)
    length = 0.5 * r_b * abs(u[1] ** 2 - u[0] ** 2)
    return _row(INVOLUTE, (r_b, phase, hand, u[0], u[1]), np.column_stack([z.real, z.imag]), length)
