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
from pitchpoint.model.rings import rings_of
from pitchpoint.report.scene.bearing_sizes import size_of
from pitchpoint.report.scene.supports import shaft_radius, spindle_radius
from pitchpoint.report.section.axes import Line
from pitchpoint.report.section.bearings import bearing_pieces
from pitchpoint.report.section.boxes import box_line, extent
from pitchpoint.report.section.carriers import Carrier, carrier_ends, carrier_of_axis, is_planet, ring_radius
from pitchpoint.report.section.clutches import clutch_pieces
from pitchpoint.report.section.drums import Part, drum_pieces, free_gaps, has_ring
from pitchpoint.report.section.joined_bodies import connected
from pitchpoint.report.section.places import Positions
from pitchpoint.viz.section_content import Piece

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

OVERHANG = 0.45
"""Length of a schematic spindle beyond its gears, relative to their width."""


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
    carriers: dict[str, Carrier] = {}
    for body in line.bodies:
        seats = _seats(model, _on(model, body, bearings))
        carrier = carrier_of_axis(model, line, at, body, seats)
        carriers |= {} if carrier is None else {body: carrier}
    ends: dict[str, tuple[float, float]] = {}
    for body in line.bodies:
        own = [p for p in gears if p.name in _labels(model, body, named)] + _on(model, body, bearings)
        reach = (
            carrier_ends(carriers[body]) if body in carriers else _ends(model, line, at, body, own, carriers)
        )
        if reach is not None:
            ends[body] = reach
    joints, masses, ends = connected(model, line, at, ends, size, carriers)
    shafts = [
        piece
        for body in line.bodies
        for piece in _shaft(model, line, at, body, ends.get(body), _on(model, body, bearings))
        if body not in carriers or body in model.shafts
    ]
    free = free_gaps(model, line, at, carriers)
    drums = drum_pieces(
        model, line, at, carriers, free, ends, _ring_seats(model, line, at, carriers, bearings), size
    )
    drums += clutch_pieces(model, line, at, carriers, free, ends, size)
    plates = [piece for carrier in carriers.values() for piece in carrier.pieces]
    return [*plates, *shafts, *drums, *gears, *bearings, *joints, *masses]


def _ring_seats(
    model: Model, line: Line, at: Positions, carriers: Mapping[str, Carrier], bearings: Sequence[Piece]
) -> dict[str, list[Part]]:
    """Tube inside the inner rings and hub around the outer rings of the rolling bearings on bodies without
    sections: rings, and carriers beyond their plates."""
    found: dict[str, list[Part]] = {}
    drawn = {piece.name: piece for piece in bearings if piece.name in model.rolling_bearings}
    for inside in (True, False):
        spans: dict[str, list[tuple[float, float, float]]] = {}
        for name, piece in drawn.items():
            body = rings_of(model, model.rolling_bearings[name])[not inside].body
            if body not in line.bodies or body in model.shafts or (inside and body in carriers):
                continue
            low, high = extent([piece])
            radius = _bore(model, name) if inside else float(piece.line[:, 1].max())
            spans.setdefault(body, []).append((low, high, radius))
        for body, ends in spans.items():
            radii = [radius for _, _, radius in ends]
            limits = (0.85 * min(radii), min(radii)) if inside else (max(radii), 1.12 * max(radii))
            found.setdefault(body, []).append(
                Part(min(low for low, _, _ in ends), max(high for _, high, _ in ends), *limits)
            )
    return found


def _seats(model: Model, bearings: Sequence[Piece]) -> dict[str, tuple[float, float, float]]:
    """Ends along the axis, and radius of the seat of bearings [m]."""
    found = {}
    for piece in bearings:
        low, high = extent([piece])
        radius = _bore(model, piece.name) if piece.name in model.rolling_bearings else piece.line[:, 1].min()
        found[piece.name] = (low, high, float(radius))
    return found


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
            outer = ring_radius(gear)
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
    model: Model, line: Line, at: Positions, body: str, own: Sequence[Piece], carriers: Mapping[str, Carrier]
) -> tuple[float, float] | None:
    """Ends of a shaft by its sections, or of a schematic spindle through its gears and bearings."""
    if body in model.shafts:
        start = at.starts[body]
        end = start + line.bodies[body] * model.shafts[body].length
        return min(start, end), max(start, end)
    if not own or is_planet(model, body):
        return None
    if has_ring(model, body):
        return extent([p for p in own if p.kind == "teeth"])
    low, high = extent(list(own))
    width = OVERHANG * (high - low) if len(own) == 1 else 0.2 * (high - low)
    before = any(c.closed < 0.0 and c.room.plate(-1.0)[0] < low < c.room.high for c in carriers.values())
    after = any(c.closed > 0.0 and c.room.low < high < c.room.plate(1.0)[1] for c in carriers.values())
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
    if ends is None or radius is None or model.bodies[body].moves == "fixed" or has_ring(model, body):
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
