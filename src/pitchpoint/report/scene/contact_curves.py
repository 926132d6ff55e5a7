# SPDX-License-Identifier: Apache-2.0
"""Curves and surfaces of contacts in a scene: cams, rollers, balls, planes, in the marker frames."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import PitchpointError
from pitchpoint.report.scene import shapes

if TYPE_CHECKING:
    from pitchpoint.contact.curve import Curve
    from pitchpoint.model.components.contact import ContactCurve, ContactSurface
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]
Part = tuple[str, str, shapes.Surface]
"""Name of a solid, its end (BODY or BODY.MARKER), and its surface in the frame of the end."""

POINTS, MAX_POINTS = 6, 96
"""Minimum number of points of a segment of a curve, and of a whole curve."""


def contact_parts(model: Model, size: float) -> tuple[list[Part], list[str]]:
    """Surfaces of all contacts, and remarks on omitted ones.

    Parameters
    ----------
    model
        The model.
    size
        Size of the machine [m], which defines dimensions that are not given.
    """
    found: list[Part] = []
    notes: list[str] = []
    width = 0.05 * size
    for name, cam in model.cam_contacts.items():
        _curve(found, notes, (f"{name}, curve", cam.ends[1]), cam.curve, width)
        if cam.radius > 0.0:
            found.append((f"{name}, roller", cam.ends[0], shapes.disc(cam.radius, 0.8 * width)))
    for name, pair in model.curve_contacts.items():
        for word, end, curve in zip(("first", "second"), pair.ends, (pair.first, pair.second), strict=True):
            _curve(found, notes, (f"{name}, {word} curve", end), curve, width)
    for name, touch in model.surface_contacts.items():
        sides = zip(("first", "second"), touch.ends, (touch.first, touch.second), strict=True)
        for word, end, surface in sides:
            try:
                found.append((f"{name}, {word} surface", end, _surface(surface, size)))
            except PitchpointError as error:
                notes.append(f"{name}: its {word} surface is not drawn: {error}")
    return found, notes


def _curve(
    found: list[Part], notes: list[str], where: tuple[str, str], part: ContactCurve, width: float
) -> None:
    """Add a curve as a plate, or as a strip if it is open or the boundary of a hole."""
    from pitchpoint.system.rules.contact import curve_of

    try:
        line, closed = curve_points(curve_of(part, where[0]))
    except PitchpointError as error:
        notes.append(f"{where[0]} is not drawn: {error}")
        return
    area = 0.5 * float(np.sum(line[:, 0] * np.roll(line[:, 1], -1) - np.roll(line[:, 0], -1) * line[:, 1]))
    solid = closed and not part.hollow and abs(area) > 0.0
    ring = line if area > 0.0 else line[::-1]
    found.append((*where, shapes.plate(ring, width) if solid else shapes.ribbon(line, width, closed)))


def curve_points(curve: Curve) -> tuple[Array, bool]:
    """Points along a curve, shape (n, 2) [m], and whether it is closed."""
    from pitchpoint.contact.curve_point import point_of

    share = np.linspace(0.0, 1.0, max(POINTS, MAX_POINTS // len(curve.rows)) + 1)
    rows = np.ascontiguousarray(curve.rows)
    line = np.array([point_of(rows, k, t)[:2] for k in range(len(rows)) for t in share])
    # adjacent segments share a point
    apart = np.hypot(*np.diff(line, axis=0).T) > 1e-9 * np.abs(line).max()
    line = line[np.append(True, apart)]
    return (line[:-1], True) if curve.closed else (line, False)


def _surface(part: ContactSurface, size: float) -> shapes.Surface:
    """Surface of a contact; unbounded surfaces are sized relative to the machine."""
    if part.shape == "triangles":
        from pitchpoint.geometry.triangle_file import join_corners, placed_triangles, read_triangles

        assert part.file is not None
        corners = placed_triangles(read_triangles(part.file), part.unit or 1.0)
        first, triangles = join_corners(corners)
        return corners.reshape(-1, 3)[first], triangles
    radius = part.radius or 0.1 * size
    if part.shape == "plane":
        sides, deep = part.size or (0.2 * size, 0.2 * size), 0.01 * size
        return shapes.box((*sides, deep), (0.0, 0.0, -0.5 * deep))
    if part.shape == "sphere":
        return shapes.ball(radius)
    if part.shape == "cylinder":
        length = part.length or 0.5 * size
        if part.hollow:
            return shapes.disc(radius + 0.02 * size, length, radius)
        return shapes.disc(radius, length)
    if part.shape == "cone":
        high = part.length or 0.15 * size
        return shapes.turned_profile(
            [(0.0, -high), (high * math.tan(part.half_angle or 0.5), -high), (0.0, 0.0)], 48
        )
    around = np.linspace(-math.pi, math.pi, 25)
    tube = part.tube or 0.2 * radius
    return shapes.turned_profile(np.column_stack([radius + tube * np.cos(around), tube * np.sin(around)]), 64)
