# SPDX-License-Identifier: Apache-2.0
"""Bearings in section: rings and rolling elements in true form, linear bearings in simplified form (ISO
8826-1)."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.model.frames import GROUND, split
from pitchpoint.model.rings import rings_of
from pitchpoint.report.scene.bearing_sections import ring_line, roller_profile, rows_of
from pitchpoint.report.scene.bearing_sizes import BearingSize, size_of, size_on
from pitchpoint.report.scene.supports import linear_size, shaft_radius
from pitchpoint.report.section.axes import Line
from pitchpoint.report.section.boxes import box_line
from pitchpoint.report.section.carriers import planets_of, rim_radius
from pitchpoint.report.section.places import Positions
from pitchpoint.viz.section_content import Piece

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

SEAT = 0.3
"""Thickness of the housing around a bearing, relative to the height of its section, and its least thickness
relative to the outside diameter."""
THIN_SEAT = 0.06
LIGHT = 1.12
"""Largest outside diameter of a bearing around the plates of a carrier or a ring, relative to its bore."""
CORNERS = 24
BUSH, WIDE = 0.2, 0.8
"""Thickness and half width of a bush, relative to the radius of the shaft."""


def bearing_pieces(model: Model, line: Line, at: Positions, size: float) -> list[Piece]:
    """All bearings on the bodies of an axis.

    Parameters
    ----------
    model
        The model.
    line
        The axis.
    at
        Positions along the axes.
    size
        Size of the machine [m].
    """
    found: list[Piece] = []
    for name, part in model.rolling_bearings.items():
        inner, outer = rings_of(model, part)
        place = outer.place if outer.place is not None else inner.place
        if place is None or not {inner.body, outer.body} & line.bodies.keys():
            continue
        if np.linalg.norm(place - line.way * (line.way @ place) - line.point) > 1e-3 * size:
            continue
        way = float(np.sign(line.way @ outer.axes[:, 2])) or 1.0
        body = inner.body if inner.body in line.bodies else outer.body
        radius = shaft_radius(model, body, part.position[2]) if body in model.bodies else None
        found += rolling(
            name,
            size_of(part, radius),
            float(line.way @ place),
            way,
            seat_kind(model, outer.body, inner.body),
        )
    for name, plain in model.plain_bearings.items():
        inner, outer = rings_of(model, plain)
        if inner.place is None or inner.body not in line.bodies:
            continue
        radius = shaft_radius(model, inner.body, plain.position[2]) or 0.03 * size
        found += bush(name, radius, float(line.way @ inner.place), seat_kind(model, outer.body, inner.body))
    for name, bearing in model.bearings.items():
        body = bearing.body
        if body not in line.bodies or model.bodies[body].stage is not None:
            continue
        z = at.starts[body] + line.bodies[body] * bearing.position[2]
        rim = rim_radius(model, line, at, body, z)
        drawn = linear_size(model, name, size)
        if rim is not None:
            radius, light = rim
            drawn = size_on(radius, True, LIGHT * 2.0 * radius if light else math.inf)
        places = [z] if rim is not None else _beside(model, line, at, body, z, drawn.width)
        if any(planets_of(model, other) for other in line.bodies):
            places = places[:1]  # plates of a carrier are on the other side
        housed = seat_kind(model, split(bearing.housing or GROUND)[0], body)
        for k, at_z in enumerate(places):
            found += linear("" if k else name, drawn, at_z, housed)
    return found


def seat_kind(model: Model, body: str, shaft: str) -> str:
    """Kind of the part around a bearing: seat in the gearbox, pedestal of a shaft without gears, or none.

    Parameters
    ----------
    model
        The model.
    body
        Body with the outer ring.
    shaft
        Body with the inner ring.
    """
    if not _is_housed(model, body):
        return ""
    part = model.bodies.get(shaft)
    geared = part is not None and (part.gears or part.bevel_gears or planets_of(model, shaft))
    return "seat" if geared else "pedestal"


def _is_housed(model: Model, body: str) -> bool:
    """Whether a ring is in the housing: on ground, or on a body that neither rotates nor has gears."""
    from pitchpoint.report.scene.supports import covers

    if body in model.bodies and model.bodies[body].moves != "fixed" and planets_of(model, body):
        return False  # a carrier on bearings
    return body == GROUND or covers(model).get(body) == "housing"


def _beside(model: Model, line: Line, at: Positions, body: str, z: float, width: float) -> list[float]:
    """Positions of a linear bearing: its own, or both sides of the gears that it would intersect."""
    spans = [
        (at.gears[g] - 0.5 * model.gears[g].face_width, at.gears[g] + 0.5 * model.gears[g].face_width)
        for g in model.bodies[body].gears
    ]
    hit = [s for s in spans if s[0] - 0.5 * width < z < s[1] + 0.5 * width]
    if at.schematic and spans:
        hit = spans
    if not hit:
        return [z]
    away = 0.7 * width
    return [min(s[0] for s in hit) - away, max(s[1] for s in hit) + away]


def rolling(name: str, size: BearingSize, z: float, way: float, housed: str) -> list[Piece]:
    """Rings, rolling elements and seat of a rolling bearing.

    Parameters
    ----------
    name
        Name of the bearing.
    size
        Its dimensions.
    z
        Position of its middle along the axis [m].
    way
        Sign of its z axis along the axis.
    housed
        Kind of its seat in the housing; empty without one.
    """
    found = []
    for inner in (True, False):
        if inner and size.bare:
            continue
        line = np.array([(z + way * h, r) for r, h in ring_line(size, inner)])
        kind = "inner" if inner else "outer"
        found.append(Piece(kind=kind, line=line, name="" if inner else name))
    for k, row in enumerate(rows_of(size)):
        if size.type == "ball":
            angles = np.linspace(0.0, 2.0 * math.pi, CORNERS + 1)
            shape = 0.5 * size.element * np.column_stack([np.cos(angles), np.sin(angles)])
        else:
            half = roller_profile(size, k)
            across = np.array([(x, r) for r, x in half] + [(x, -r) for r, x in half[::-1]])
            c, s = math.cos(row.angle), math.sin(row.angle)
            # along the roller (-sin a, cos a) in (r, z)
            shape = np.column_stack(
                [across[:, 0] * c + across[:, 1] * s, -across[:, 0] * s + across[:, 1] * c]
            )
        line = np.column_stack([z + way * (row.height + shape[:, 0]), row.radius + shape[:, 1]])
        found.append(Piece(kind="element", line=line))
    return [*found, *([seat(size, z, housed)] if housed else [])]


def linear(name: str, size: BearingSize, z: float, housed: str) -> list[Piece]:
    """Simplified symbol of a bearing of given stiffness, and its seat."""
    h = 0.5 * size.width
    box = box_line(z - h, z + h, 0.5 * size.bore, 0.5 * size.outside)
    return [Piece(kind="linear", line=box, name=name), *([seat(size, z, housed)] if housed else [])]


def bush(name: str, radius: float, z: float, housed: str) -> list[Piece]:
    """Bush of a plain bearing, and its seat."""
    line = box_line(z - WIDE * radius, z + WIDE * radius, radius, (1.0 + BUSH) * radius)
    around = box_line(
        z - WIDE * radius, z + WIDE * radius, (1.0 + BUSH) * radius, (1.0 + 2.5 * BUSH) * radius
    )
    return [Piece(kind="outer", line=line, name=name), *([Piece(kind=housed, line=around)] if housed else [])]


def seat(size: BearingSize, z: float, kind: str = "seat") -> Piece:
    """Housing around a bearing."""
    outer = 0.5 * size.outside
    thick = max(SEAT * 0.5 * (size.outside - size.bore), THIN_SEAT * size.outside)
    return Piece(kind=kind, line=box_line(z - 0.6 * size.width, z + 0.6 * size.width, outer, outer + thick))
