# SPDX-License-Identifier: Apache-2.0
"""Parts of the axes in half section: shafts, gears, carriers, couplings, masses."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.words import ranges
from pitchpoint.model.frames import split
from pitchpoint.report.scene.bearing_sizes import size_of
from pitchpoint.report.scene.supports import shaft_radius, spindle_radius
from pitchpoint.report.section.axes import Line
from pitchpoint.report.section.bearings import bearing_pieces, box_line, extent, span_line
from pitchpoint.report.section.joined_bodies import connected
from pitchpoint.report.section.places import Positions
from pitchpoint.viz.section_content import Piece

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

RIM_MODULES = 2.5
"""Thickness of a ring behind its roots without `bore_diameter`, in modules."""
OVERHANG = 0.45
"""Length of a schematic spindle beyond its gears, relative to their width."""
PLATE = 0.22
"""Thickness of a carrier plate, relative to the width of the planets."""


def pieces_of(
    model: Model, line: Line, at: Positions, size: float, named: dict[str, list[str]]
) -> list[Piece]:
    """Parts of one axis, from the back to the front of the drawing.

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
    named
        Gears that a drawn gear represents.
    """
    gears = [piece for body in line.bodies for piece in gear_pieces(model, line, at, body, named)]
    bearings = bearing_pieces(model, line, at, size)
    carriers = {body: found for body in line.bodies if (found := _carrier(model, line, at, body))}
    closed = {c: leads_on(model, line, at, c, extent(p)[1]) for c, p in carriers.items()}
    ends: dict[str, tuple[float, float]] = {}
    for body in line.bodies:
        own = [p for p in gears if p.name in _labels(model, body, named)] + _on(model, body, bearings)
        reach = extent(carriers[body]) if body in carriers else _ends(model, line, at, body, own, closed)
        if reach is not None:
            ends[body] = reach
    joints, masses, ends = connected(model, line, at, ends, size)
    shafts = [
        piece
        for body in line.bodies
        for piece in _shaft(model, line, at, body, ends.get(body), _on(model, body, bearings))
        if body not in carriers
    ]
    plates = [piece for found in carriers.values() for piece in found]
    return [*plates, *shafts, *gears, *bearings, *joints, *masses]


def _labels(model: Model, body: str, named: dict[str, list[str]]) -> set[str]:
    part = model.bodies[body]
    return {ranges(named.get(g, [g])) for g in (*part.gears, *part.bevel_gears)}


def _on(model: Model, body: str, bearings: Sequence[Piece]) -> list[Piece]:
    """Bearings on a body."""
    names = {
        name
        for group in (model.bearings, model.plain_bearings)
        for name, p in group.items()
        if p.body == body
    }
    for name, part in model.rolling_bearings.items():
        inner = part.body if part.ends is None else split(part.ends[0])[0]
        names |= {name} if inner == body else set()
    return [piece for piece in bearings if piece.name in names]


# --- gears --------------------------------------------------------------------------------------------------
def gear_pieces(
    model: Model, line: Line, at: Positions, body: str, named: dict[str, list[str]]
) -> list[Piece]:
    """Body, teeth and pitch line of every gear of a body."""
    found: list[Piece] = []
    for name, place in model.bodies[body].gears.items():
        gear = model.gears[name]
        shape, half, z = gear.geometry, 0.5 * gear.face_width, at.gears[name]
        label, words = ranges(named.get(name, [name])), str(gear.number_of_teeth)
        root, tip = 0.5 * abs(shape.d_f), 0.5 * abs(shape.d_a)
        if shape.is_internal:
            outer = max(0.5 * gear.bore_diameter, root + RIM_MODULES * gear.normal_module)
            found.append(Piece(kind="gear", line=box_line(z - half, z + half, root, outer)))
            if model.bodies[body].moves == "fixed":
                held = box_line(z - 0.8 * half, z + 0.8 * half, outer, outer + 0.5 * (outer - root))
                found.append(Piece(kind="held", line=held))
        else:
            hub = min(shaft_radius(model, body, place) or 0.35 * root, 0.999 * root)
            found.append(Piece(kind="gear", line=_blank(gear, z, hub, root)))
        teeth = box_line(z - half, z + half, root, tip)
        found.append(Piece(kind="teeth", line=teeth, name=label, words=words))
        r_w = 0.5 * pitch_diameter(model, name)
        more = 0.12 * half
        found.append(Piece(kind="pitch", line=np.array([(z - half - more, r_w), (z + half + more, r_w)])))
    for name, apex in model.bodies[body].bevel_gears.items():
        found += _bevel(model, line, at, body, name, apex)
    return found


def pitch_diameter(model: Model, gear: str) -> float:
    """Operating pitch diameter of a gear in its first mesh; without mesh its reference diameter [m]."""
    for name, mesh in model.meshes.items():
        if gear in mesh.gears:
            pair = model.pairs[name]
            return abs(pair.d_w1 if mesh.gears[0] == gear else pair.d_w2)
    return abs(model.gears[gear].geometry.d)


def _blank(gear: object, z: float, hub: float, root: float) -> Array:
    """Wheel body: solid, or rim and web of the given thicknesses."""
    half = 0.5 * gear.face_width  # type: ignore[attr-defined]
    rim, web = gear.rim_thickness, gear.web_thickness  # type: ignore[attr-defined]
    inner = root - rim if rim is not None else root
    if rim is None or web is None or web >= 2.0 * half or inner <= 1.2 * hub:
        return box_line(z - half, z + half, hub, root)
    boss = min(1.35 * hub, 0.5 * (hub + inner))
    w = 0.5 * web
    side = [
        (z + half, root),
        (z + half, inner),
        (z + w, inner),
        (z + w, boss),
        (z + half, boss),
        (z + half, hub),
    ]
    return np.array([*side, *((2.0 * z - x, r) for x, r in reversed(side))])


def _bevel(model: Model, line: Line, at: Positions, body: str, name: str, apex: float) -> list[Piece]:
    """Body, teeth and pitch line of a bevel gear."""
    part = model.bevel_gears[name]
    gear, blank = part.geometry, part.blank
    sign = line.bodies[body]
    way = sign * part.direction
    start = at.starts[body] + sign * apex

    def point(R: float, h: float) -> tuple[float, float]:
        """Position along the axis and radius at a cone distance, at a height above the pitch cone."""
        c, s = math.cos(gear.delta), math.sin(gear.delta)
        return start + way * (R * c - h * s), R * s + h * c

    inner = gear.R_i / gear.R_e
    teeth = [
        point(gear.R_i, -inner * gear.h_fe),
        point(gear.R_e, -gear.h_fe),
        point(gear.R_e, gear.h_ae),
        point(gear.R_i, inner * gear.h_ae),
    ]
    hub = min(max(spindle_radius(model, body) or 0.0, blank.bore), 0.9 * min(blank.toe[0], blank.back[0]))
    corners = [blank.toe, blank.heel, blank.back, (hub, blank.back[1]), (hub, blank.toe[1])]
    solid = np.array([(start + way * z, r) for r, z in corners])
    pitch = np.array([point(0.97 * gear.R_i, 0.0), point(1.03 * gear.R_e, 0.0)])
    return [
        Piece(kind="gear", line=solid),
        Piece(kind="teeth", line=np.array(teeth), name=name, words=str(gear.z)),
        Piece(kind="pitch", line=pitch),
    ]


# --- shafts and other bodies --------------------------------------------------------------------------------
def _ends(
    model: Model, line: Line, at: Positions, body: str, own: Sequence[Piece], closed: Mapping[str, bool]
) -> tuple[float, float] | None:
    """Ends of a shaft by its sections, or of a schematic spindle through its gears and bearings."""
    if body in model.shafts:
        start = at.starts[body]
        end = start + line.bodies[body] * model.shafts[body].length
        return min(start, end), max(start, end)
    if not own or _is_planet(model, body):
        return None
    low, high = extent(list(own))
    width = OVERHANG * (high - low) if len(own) == 1 else 0.2 * (high - low)
    before, after = (any(c is side for c in closed.values()) for side in (True, False))
    return low - width * (not before), high + width * (not after)


def _shaft(
    model: Model,
    line: Line,
    at: Positions,
    body: str,
    ends: tuple[float, float] | None,
    bearings: Sequence[Piece],
) -> list[Piece]:
    """Shaft by its sections, or schematic spindle with seats of the bore of its bearings."""
    if body in model.shafts:
        found, z = [], at.starts[body]
        for section in model.shafts[body].sections:
            end = z + line.bodies[body] * section.length
            box = box_line(min(z, end), max(z, end), 0.5 * section.bore, 0.5 * section.diameter)
            found.append(Piece(kind="shaft", line=box))
            z = end
        return found
    radius = spindle_radius(model, body)
    if ends is None or radius is None or model.bodies[body].moves == "fixed":
        return []
    wide = {g: 0.5 * model.gears[g].face_width for g in model.bodies[body].gears}
    low = min([at.gears[g] - half for g, half in wide.items()], default=ends[1])
    high = max([at.gears[g] + half for g, half in wide.items()], default=ends[0])
    steps = [(ends[0], low, lambda z: z < low), (low, high, None), (high, ends[1], lambda z: z > high)]
    found = []
    for start, end, outside in steps if low <= high else [(*ends, None)]:
        seats = [p for p in bearings if outside and p.kind == "outer" and outside(float(p.line[:, 0].mean()))]
        bores = [_bore(model, p.name) for p in seats if p.name in model.rolling_bearings]
        if end > start:
            found.append(
                Piece(kind="spindle", line=box_line(start, end, 0.0, min(bores, default=radius) or radius))
            )
    return found


def _bore(model: Model, bearing: str) -> float:
    """Radius of the seat of a rolling bearing [m]."""
    return 0.5 * size_of(model.rolling_bearings[bearing], None).bore


def _is_planet(model: Model, body: str) -> bool:
    seat = model.mechanism.seats.get(body)
    return seat is not None and seat.joint is not None and bool(_planets(model, seat.parent))


def _planets(model: Model, body: str) -> list[str]:
    """Bodies with gears on joints of a body."""
    return [
        name
        for name, seat in model.mechanism.seats.items()
        if seat.parent == body and seat.joint is not None and model.bodies[name].gears
    ]


def _carrier(model: Model, line: Line, at: Positions, body: str) -> list[Piece]:
    """Plates on both sides of the planets, and a stub shaft."""
    planets = [name for name in _planets(model, body) if name not in line.bodies]
    if not planets:
        return []
    kind = "held" if model.bodies[body].moves == "fixed" else "plate"
    low, high, pin = planet_room(model, at, planets)
    far = max(pin_distance(model, line, name) for name in planets)
    thick = PLATE * (high - low)
    gap = 0.3 * thick
    others = [spindle_radius(model, b) or 0.0 for b in line.bodies if b != body and model.bodies[b].gears]
    hole = 1.25 * max([*others, 0.25 * far * bool(others)], default=0.0)
    outer = far + 1.7 * pin
    way = -1.0 if leads_on(model, line, at, body, high) else 1.0
    start, end = (high, low) if way > 0.0 else (low, high)  # sides of the closed and of the open plate
    found = [
        Piece(kind=kind, line=span_line(end - way * gap, -way * thick, min(hole, 0.7 * far), outer)),
        Piece(kind=kind, line=span_line(start + way * gap, way * thick, 0.0, outer), name=body),
    ]
    if kind == "plate":  # rotates: a stub shaft
        stub = span_line(start + way * (gap + thick), way * 1.4 * thick, 0.0, 0.2 * far)
        found.append(Piece(kind=kind, line=stub))
    return found


def leads_on(model: Model, line: Line, at: Positions, carrier: str, high: float) -> bool:
    """Whether the shaft of a gear on the axis of a carrier leads beyond the upper end of the planets."""
    others = [b for b in line.bodies if b != carrier]
    return any(at.gears[g] > high for b in others for g in model.bodies[b].gears)


def planet_room(model: Model, at: Positions, planets: Sequence[str]) -> tuple[float, float, float]:
    """Ends of the planets along the axis, and the radius of their pins [m]."""
    ends = [
        at.gears[g] + side * 0.5 * model.gears[g].face_width
        for p in planets
        for g in model.bodies[p].gears
        for side in (-1, 1)
    ]
    pin = min(spindle_radius(model, p) or 0.0 for p in planets)
    return min(ends), max(ends), pin


def pin_distance(model: Model, line: Line, planet: str) -> float:
    """Distance of a planet from an axis [m]."""
    origin = np.array(model.bodies[planet].origin or (0.0, 0.0, 0.0))
    return float(np.linalg.norm(origin - line.way * (line.way @ origin) - line.point))


def pin_pieces(model: Model, at: Positions, line: Line) -> list[Piece]:
    """Pin of a planet, through both plates of its carrier."""
    for body in line.bodies:
        if _is_planet(model, body):
            carrier = model.mechanism.seats[body].parent
            planets = _planets(model, carrier)
            low, high, pin = planet_room(model, at, planets)
            thick = PLATE * (high - low)
            return [Piece(kind="pin", line=box_line(low - 1.5 * thick, high + 1.5 * thick, 0.0, pin))]
    return []
