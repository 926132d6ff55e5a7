# SPDX-License-Identifier: Apache-2.0
"""Cross-sections of the rings and rolling elements of a bearing in a scene.

All are in the plane of the axis (r, z), z along the axis of the bearing from its middle. The contact of a row
is in the direction (cos a, sin a) from its elements with its contact angle a. The outer raceway of
self-aligning bearings is a sphere about the middle: their elements lie in these directions from it, and
rollers are barrels with the radius of the sphere.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.bearings.inner import ROW_SPACING
from pitchpoint.report.scene import shapes
from pitchpoint.report.scene.bearing_sizes import THINNEST, BearingSize

Array = NDArray[np.float64]
Line = list[tuple[float, float]]

SHOULDER = 0.3
"""Depth of the shoulders inside the pitch circle of balls, relative to their diameter."""
GROOVE = 0.52
"""Radius of a drawn groove relative to the diameter of a ball."""
OPEN_SHOULDER = 0.42
"""The same on the side where balls with a contact angle are not supported."""
RIB = 0.3
"""Height of the ribs of roller bearings outside and inside the pitch circle, relative to the diameter."""
ARC = 9
"""Points of an arc of a section."""
CLEAR = 0.04
"""Gap between the washers of a thrust bearing and the other seat, relative to the width of the section."""


class Row(NamedTuple):
    """Place of a row: radius and height of the middle of its elements [m], contact angle [rad]."""

    radius: float
    height: float
    angle: float


def rows_of(size: BearingSize) -> list[Row]:
    """Rows of a bearing, in the order of the simulation.

    Parameters
    ----------
    size
        Dimensions of the bearing.
    """
    middle = 0.5 * size.pitch
    if size.rows == 1:
        return [Row(middle, 0.0, size.angle)]
    least = 0.52 * size.length
    if size.type == "ball":  # the rows are half a spacing apart and reach into each other
        beside = size.pitch * math.sin(0.5 * math.pi / size.count)
        least = 0.51 * math.sqrt(max(size.element**2 - beside**2, 0.0))
    if size.form == "sphere":
        height = max(middle * math.tan(abs(size.angle)), least)
        angle = math.atan2(height, middle)
        return [Row(middle, height, angle), Row(middle, -height, -angle)]
    height = max(0.5 * ROW_SPACING * size.element, least)
    return [Row(middle, -height, size.angle), Row(middle, height, -size.angle)]


def sphere_radius(size: BearingSize) -> float:
    """Radius of the outer raceway of a self-aligning bearing [m]."""
    row = rows_of(size)[0]
    return math.hypot(row.radius, row.height) + 0.5 * size.element


def ring(size: BearingSize, inner: bool, sides: int = 48) -> shapes.Surface:
    """Surface of a ring with its raceway, about the third axis, the middle of the elements at the origin.

    Parameters
    ----------
    size
        Dimensions of the bearing.
    inner
        The inner one.
    sides
        Number of corners of a circle.
    """
    return shapes.turned_profile(ring_line(size, inner), sides)


def ring_line(size: BearingSize, inner: bool) -> Line:
    """Closed section of a ring (r, z), from the middle of the elements [m].

    Parameters
    ----------
    size
        Dimensions of the bearing.
    inner
        The inner one.
    """
    if size.form == "thrust":
        return _washer(size, inner)
    h = 0.5 * size.width
    seat = 0.5 * (size.bore if inner else size.outside)
    race = [(float(r), float(z)) for r, z in raceway(size, inner)]
    ends = [(seat, -h), (seat, h)]
    # counter-clockwise in the section: the seat of an inner ring is on the left
    line = [ends[0], *race, ends[1]] if inner else [*ends, *race[::-1]]
    return [*line, line[0]]


def raceway(size: BearingSize, inner: bool) -> Array:
    """Radius and height along the inside of a ring from its lower to its upper face, shape (n, 2) [m].

    Of thrust bearings it is the groove of the washer, from the inside.
    """
    if size.form == "thrust":
        return _washer_groove(size, inner)
    h, sign = 0.5 * size.width, -1.0 if inner else 1.0
    seat = 0.5 * (size.bore if inner else size.outside)
    if size.form == "sphere" and not inner:
        radius = sphere_radius(size)
        heights = np.linspace(-h, h, 2 * ARC)
        line: Array = np.column_stack([np.sqrt(radius**2 - heights**2), heights])
    elif size.type == "ball":
        line = np.array(_ball_races(size, sign, h))
    elif size.form == "sphere":
        line = np.array(_barrel_races(size, h))
    else:
        line = np.array(_roller_race(size, inner, h))
    limit = seat - sign * THINNEST * size.element
    line[:, 0] = np.minimum(line[:, 0], limit) if not inner else np.maximum(line[:, 0], limit)
    return line


def _ball_races(size: BearingSize, sign: float, h: float) -> Line:
    """Grooves of all rows of balls, with a low shoulder on the side where they are not supported."""
    radius = GROOVE * size.element
    line: Line = []
    for row in sorted(rows_of(size), key=lambda row: row.height):
        centre = row.radius + sign * (0.5 * size.element - radius)
        for side in (-1.0, 1.0):
            open_side = size.form != "sphere" and row.angle * side * sign < 0.0
            edge = row.radius + sign * (OPEN_SHOULDER if open_side else SHOULDER) * size.element
            most = math.acos(min(1.0, abs(edge - centre) / radius))
            angles = np.linspace(most, 0.0, 5) if side < 0.0 else np.linspace(0.0, most, 5)[1:]
            arc = [
                (centre + sign * radius * math.cos(a), row.height + side * radius * math.sin(a))
                for a in angles
            ]
            line += arc
    return [(line[0][0], -h), *line, (line[-1][0], h)]


def _barrel_races(size: BearingSize, h: float) -> Line:
    """Inner raceway of barrel rollers, which follows their inside, with a rib between the rows."""
    line: Line = []
    for row in sorted(rows_of(size), key=lambda row: row.height):
        c, s = math.cos(row.angle), math.sin(row.angle)
        for x in np.linspace(-0.5, 0.5, ARC) * size.length:
            below = 0.5 * size.element - _drop(size, float(x))
            line.append((row.radius - x * s - below * c, row.height + x * c - below * s))
    return [(line[0][0], -h), *line, (line[-1][0], h)]


def _drop(size: BearingSize, x: float) -> float:
    """Reduction of the radius of a barrel at the distance x from its middle [m]."""
    radius = sphere_radius(size)
    return radius - math.sqrt(radius**2 - x**2)


def _roller_race(size: BearingSize, inner: bool, h: float) -> Line:
    """Raceway of cylindrical and tapered rollers, with the ribs that guide cylindrical ones."""
    sign = -1.0 if inner else 1.0
    (r0, z0), (r1, z1) = roller_line(size, sign)
    slope = (r1 - r0) / (z1 - z0)
    if size.angle != 0.0:
        return [(r0 + slope * (z - z0), z) for z in (-h, z0, z1, h)]
    rib = 0.5 * size.pitch + sign * RIB * size.element
    low, high = size.flanges if inner else (True, True)
    start = [(rib, -h), (rib, z0), (r0, z0)] if low else [(r0, -h), (r0, z0)]
    end = [(r1, z1), (rib, z1), (rib, h)] if high else [(r1, z1), (r1, h)]
    return [*start, *end]


def _washer_groove(size: BearingSize, inner: bool) -> Array:
    """Groove of a washer of a thrust bearing, from the inside; the force on the shaft washer is along z."""
    side = math.copysign(1.0, size.angle) * (-1.0 if inner else 1.0)
    radius = GROOVE * size.element
    centre = side * (0.5 * size.element - radius)
    most = math.acos((SHOULDER * size.element - abs(centre)) / radius)
    angles = np.linspace(-most, most, ARC)
    middle = 0.5 * size.pitch
    return np.column_stack([middle + radius * np.sin(angles), centre + side * radius * np.cos(angles)])


def _washer(size: BearingSize, inner: bool) -> Line:
    """Closed section of a washer of a thrust bearing, counter-clockwise."""
    gap = CLEAR * (size.outside - size.bore)
    low, high = 0.5 * size.bore, 0.5 * size.outside
    low, high = (low, high - gap) if inner else (low + gap, high)
    groove = [(float(r), float(z)) for r, z in _washer_groove(size, inner)]
    side = math.copysign(1.0, groove[0][1])
    face = side * 0.5 * size.width
    line = [(low, face), (low, groove[0][1]), *groove, (high, groove[-1][1]), (high, face)]
    line = line[::-1] if side < 0.0 else line
    return [*line, line[0]]


def roller_line(size: BearingSize, sign: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """Ends of the contact line of a roller with the inner (-1) or outer (1) ring, lower end first: (r, z).

    The cone of a roller and both raceways have a common apex on the axis of the bearing, as for pure rolling.
    """
    ends = []
    for place in (-0.5, 0.5):
        half = 0.5 * size.element * (1.0 - 2.0 * place * size.length / size.pitch * math.sin(size.angle))
        r = 0.5 * size.pitch - place * size.length * math.sin(size.angle) + sign * half * math.cos(size.angle)
        ends.append((r, place * size.length * math.cos(size.angle) + sign * half * math.sin(size.angle)))
    return ends[0], ends[1]


def element_surface(size: BearingSize, sides: int, row: int = 0) -> shapes.Surface:
    """Surface of a ball or roller of a row, above the first axis."""
    at = rows_of(size)[row]
    place = (at.radius, 0.0, at.height)
    if size.type == "ball":
        return shapes.ball(0.5 * size.element, place, sides)
    h = 0.5 * size.length
    profile = roller_profile(size, row)
    line = [(0.0, -h), *profile, (0.0, h)]
    direction = (-math.sin(at.angle), 0.0, math.cos(at.angle))
    return shapes.moved(shapes.turned_profile(line, sides), place, shapes.across(direction))


def roller_profile(size: BearingSize, row: int = 0) -> Line:
    """Half section of a roller of a row: radius and position along its own axis [m].

    Parameters
    ----------
    size
        Dimensions of the bearing.
    row
        Number of the row.
    """
    h, edge = 0.5 * size.length, 0.04 * size.element
    if size.form == "sphere":
        return [(0.5 * size.element - _drop(size, float(x)), float(x)) for x in np.linspace(-h, h, ARC)]
    angle = rows_of(size)[row].angle
    low, high = (
        0.5 * size.element * (1.0 - 2.0 * s * size.length / size.pitch * math.sin(angle)) for s in (-0.5, 0.5)
    )
    return [(low - edge, -h), (low, edge - h), (high, h - edge), (high - edge, h)]


def spall(size: BearingSize, inner: bool, half: float) -> shapes.Surface:
    """Patch over the width of a track around the first axis, over the angle 2 `half` [rad]."""
    line = raceway(size, inner)
    at = rows_of(size)[0]
    lift = (-1.0 if inner else 1.0) * 0.015 * size.element
    if size.form == "thrust":
        track = line - [0.0, math.copysign(1.0, size.angle) * lift]
    else:
        wide_of = size.length if size.type == "roller" else 0.9 * size.element
        track = line[np.abs(line[:, 1] - at.height) <= 0.5 * wide_of]
        if not inner:
            track = track[track[:, 0] > at.radius + 0.4 * size.element * math.cos(at.angle)]
        track = track - [lift, 0.0]
    angles = np.linspace(-half, half, 13)
    rows, wide = len(angles), len(track)
    points = np.array([(r * math.cos(a), r * math.sin(a), z) for a in angles for r, z in track])
    k = np.array([i * wide + j for i in range(rows - 1) for j in range(wide - 1)])
    faces = np.concatenate([np.c_[k, k + wide, k + 1], np.c_[k + 1, k + wide, k + wide + 1]])
    return points, faces if inner else faces[:, ::-1]
