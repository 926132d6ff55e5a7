# SPDX-License-Identifier: Apache-2.0
"""Elementary surfaces of scenes: rods, balls, rings, coils, plates."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Surface = tuple[Array, Indices]
"""Points (n, 3) [m] and triangles (m, 3), counter-clockwise seen from outside."""

SIDES = 16
"""Number of corners of a thin round rod."""


def joined(parts: Iterable[Surface]) -> Surface:
    """Several surfaces as one."""
    points, triangles, count = [np.zeros((0, 3))], [np.zeros((0, 3), np.int64)], 0
    for corners, faces in parts:
        points.append(corners)
        triangles.append(faces + count)
        count += len(corners)
    return np.concatenate(points), np.concatenate(triangles)


def moved(surface: Surface, place: ArrayLike, axes: Array | None = None) -> Surface:
    """A surface in another frame: its origin [m] and its axes, columns."""
    points, triangles = surface
    return (points if axes is None else points @ axes.T) + np.asarray(place, float), triangles


def across(direction: ArrayLike) -> Array:
    """A right-handed frame, columns, whose third axis has a direction."""
    z = np.asarray(direction, float)
    size = float(np.linalg.norm(z))
    if size == 0.0:
        return np.eye(3)
    z = z / size
    x = np.cross(np.eye(3)[int(np.argmin(np.abs(z)))], z)
    x /= np.linalg.norm(x)
    return np.column_stack([x, np.cross(z, x), z])


def turned_profile(profile: ArrayLike, sides: int = 32) -> Surface:
    """Closed surface of revolution of a line (radius, height) about the third axis, its inside to the left.

    Ends on the axis are closed by points there; a line whose last point is its first makes a ring.
    """
    corners = np.asarray(profile, float)
    angle = 2.0 * math.pi / sides * np.arange(sides)
    rings = [np.column_stack([r * np.cos(angle), r * np.sin(angle), np.full(sides, h)]) for r, h in corners]
    k, after = np.arange(sides), (np.arange(sides) + 1) % sides
    faces = []
    for n in range(len(corners) - 1):
        low, high = n * sides, (n + 1) * sides
        if corners[n, 0] > 0.0:
            faces.append(np.column_stack([low + k, low + after, high + k]))
        if corners[n + 1, 0] > 0.0:
            faces.append(np.column_stack([low + after, high + after, high + k]))
    return np.concatenate(rings), np.concatenate(faces)


def disc(radius: float, width: float, bore: float = 0.0, sides: int = 48) -> Surface:
    """A disc or ring about the third axis, its middle at the origin [m]."""
    h = 0.5 * width
    line = [(bore, -h), (radius, -h), (radius, h), (bore, h)]
    return turned_profile([*line, line[0]] if bore > 0.0 else line, sides)


def rod(a: ArrayLike, b: ArrayLike, radius: float, sides: int = SIDES) -> Surface:
    """A round rod between two points [m]."""
    start, way = np.asarray(a, float), np.asarray(b, float) - np.asarray(a, float)
    long = float(np.linalg.norm(way))
    line = [(0.0, 0.0), (radius, 0.0), (radius, long), (0.0, long)]
    return moved(turned_profile(line, sides), start, across(way))


def ball(radius: float, place: ArrayLike = (0.0, 0.0, 0.0), sides: int = 24) -> Surface:
    """A ball [m]."""
    angle = np.linspace(-0.5 * math.pi, 0.5 * math.pi, sides // 2 + 1)
    line = np.column_stack([radius * np.cos(angle), radius * np.sin(angle)])
    line[[0, -1], 0] = 0.0
    return moved(turned_profile(line, sides), place)


def box(size: ArrayLike, place: ArrayLike = (0.0, 0.0, 0.0), axes: Array | None = None) -> Surface:
    """A box with its middle at a place [m]."""
    corner = np.array([[(-0.5, 0.5)[k >> i & 1] for i in range(3)] for k in range(8)]) * np.asarray(size)
    quads = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    faces = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])
    return moved((corner, faces), place, axes)


def rounded_box(size: ArrayLike, radius: float, steps: int = 6) -> Surface:
    """A box with round edges, its middle at the origin [m]; `steps` divide a quarter of a circle."""
    if radius <= 0.0:
        return box(size)
    half = 0.5 * np.asarray(size, float) - radius
    quarter = np.linspace(0.0, 0.5 * math.pi, steps + 1)
    turns = np.concatenate([quarter + 0.5 * math.pi * k for k in range(4)])
    corners = np.repeat([[1, 1], [-1, 1], [-1, -1], [1, -1]], steps + 1, axis=0)
    rings = []
    for tilt, side in [(t, -1.0) for t in -quarter[::-1]] + [(t, 1.0) for t in quarter]:
        beside = radius * math.cos(tilt) * np.column_stack([np.cos(turns), np.sin(turns)])
        height = np.full(turns.size, radius * math.sin(tilt) + side * half[2])
        rings.append(np.column_stack([beside + corners * half[:2], height]))
    return np.concatenate(rings), skin(len(rings), turns.size)


def tube(line: ArrayLike, radius: float, sides: int = 6) -> Surface:
    """A tube of small radius along a line of points [m], its ends closed."""
    points = np.asarray(line, float)
    along = np.gradient(points, axis=0)
    frame = across(along[0])
    rings = []
    angle = 2.0 * math.pi / sides * np.arange(sides)
    x = frame[:, 0]
    for p, t in zip(points, along, strict=True):
        z = t / np.linalg.norm(t)
        x = x - z * (x @ z)
        x /= np.linalg.norm(x)
        rings.append(p + radius * (np.cos(angle)[:, None] * x + np.sin(angle)[:, None] * np.cross(z, x)))
    return np.concatenate(rings), skin(len(points), sides)


def skin(rings: int, sides: int) -> Indices:
    """Triangles of a closed surface over rings of `sides` points each, one ring after the other."""
    k, after = np.arange(sides), (np.arange(sides) + 1) % sides
    faces = []
    for low in range(0, (rings - 1) * sides, sides):
        high = low + sides
        faces += [np.c_[low + k, low + after, high + k], np.c_[low + after, high + after, high + k]]
    last = (rings - 1) * sides
    faces.append(np.c_[0 * k[1:-1], after[1:-1], k[1:-1]])
    faces.append(np.c_[last + 0 * k[1:-1], last + k[1:-1], last + after[1:-1]])
    return np.concatenate(faces)


def coil(radius: float, wire: float, turns: int = 7) -> Surface:
    """A helical spring about the third axis, from 0 to 1 on it, radius and wire in metres."""
    t = np.linspace(0.0, 1.0, 14 * turns + 1)
    angle = 2.0 * math.pi * turns * t
    # created with a pitch of one radius, then scaled to length 1: the wire is flattened invisibly
    long = 2.0 * radius * turns
    line = np.column_stack([radius * np.cos(angle), radius * np.sin(angle), long * t])
    points, faces = tube(line, wire)
    return points / np.array([1.0, 1.0, long]), faces


def plate(outline: ArrayLike, width: float) -> Surface:
    """A plate with a closed outline, counter-clockwise about the third axis, its middle at height 0 [m].

    Its faces are fans about the mean of the corners, for outlines that are star-shaped about this point.
    """
    ring = np.asarray(outline, float)
    n, h = len(ring), 0.5 * width
    middle = ring.mean(axis=0)
    points = np.concatenate(
        [np.c_[ring, np.full(n, z)] for z in (-h, h)] + [np.array([[*middle, -h], [*middle, h]])]
    )
    k, after = np.arange(n), (np.arange(n) + 1) % n
    walls = [np.c_[k, after, n + after], np.c_[k, n + after, n + k]]
    ends = [np.c_[after, k, np.full(n, 2 * n)], np.c_[n + k, n + after, np.full(n, 2 * n + 1)]]
    return points, np.concatenate([*walls, *ends])


def ribbon(line: ArrayLike, width: float, closed: bool) -> Surface:
    """A strip along a plane line, visible from both sides [m]."""
    points = np.asarray(line, float)
    n, h = len(points), 0.5 * width
    corners = np.concatenate([np.c_[points, np.full(n, z)] for z in (-h, h)])
    k = np.arange(n if closed else n - 1)
    after = (k + 1) % n
    side = np.concatenate([np.c_[k, after, n + after], np.c_[k, n + after, n + k]])
    # separate corners for the back, so that it has its own shading
    return np.concatenate([corners, corners]), np.concatenate([side, side[:, ::-1] + 2 * n])
