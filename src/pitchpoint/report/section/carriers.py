# SPDX-License-Identifier: Apache-2.0
"""Planet carriers in half section: plates on both sides of the planets, hubs to shaft and bearings, pins."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.model.frames import split
from pitchpoint.report.scene.supports import shaft_radius, spindle_radius
from pitchpoint.report.section.axes import Line, seat_shaft
from pitchpoint.report.section.boxes import box_line, extent, span_line
from pitchpoint.report.section.places import Positions
from pitchpoint.viz.section_content import Piece

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

PLATE, GAP = 0.22, 0.3
"""Thickness of a plate relative to the width of the planets, and its distance from these relative to the
thickness."""
RIM, HUB, STUB = 1.7, 0.2, 1.4
"""Plate beyond the pins relative to their radius; radius of a hub relative to the distance of the pins, and
its length relative to the thickness of a plate."""
COLLAR = 0.85
"""Inner radius of a collar for a bearing around a plate, relative to the outer one."""
HOLE = 1.1
"""Radius of the hole of a plate relative to that of the shaft in it."""


@dataclass(frozen=True)
class Room:
    """Space of the planets of a carrier [m].

    Attributes
    ----------
    low, high
        Ends of the planets along the axis.
    pin
        Radius of the pins.
    far
        Distance of the pins from the axis.
    """

    low: float
    high: float
    pin: float
    far: float

    @property
    def thick(self) -> float:
        """Thickness of the plates."""
        return PLATE * (self.high - self.low)

    @property
    def outer(self) -> float:
        """Outside radius of the plates."""
        return self.far + RIM * self.pin

    def plate(self, way: float) -> tuple[float, float]:
        """Ends of the plate on the upper (1) or lower (-1) side."""
        start = (self.high if way > 0.0 else self.low) + way * GAP * self.thick
        return min(start, start + way * self.thick), max(start, start + way * self.thick)


@dataclass(frozen=True)
class Carrier:
    """A carrier in half section.

    Attributes
    ----------
    room
        Space of its planets.
    pieces
        Plates and hubs.
    closed
        Side on which it is connected: 1 the upper one, -1 the lower one.
    """

    room: Room
    pieces: Sequence[Piece]
    closed: float


def planets_of(model: Model, body: str) -> list[str]:
    """Bodies with gears that rotate on joints of a body."""
    return [
        name
        for name, seat in model.mechanism.seats.items()
        if seat.parent == body and seat.joint is not None and seat.coordinates and model.bodies[name].gears
    ]


def is_planet(model: Model, body: str) -> bool:
    """Whether a body rotates on the joint of another one."""
    seat = model.mechanism.seats.get(body)
    return seat is not None and seat.joint is not None and bool(planets_of(model, seat.parent))


def room_of(model: Model, line: Line, at: Positions, body: str) -> Room | None:
    """Space of the planets that a body of an axis carries around it; None without."""
    planets = [name for name in planets_of(model, body) if name not in line.bodies]
    if not planets or body not in line.bodies:
        return None
    ends = [
        at.gears[g] + side * 0.5 * model.gears[g].face_width
        for p in planets
        for g in model.bodies[p].gears
        for side in (-1, 1)
    ]
    pin = min(spindle_radius(model, p) or 0.0 for p in planets)
    return Room(min(ends), max(ends), pin, max(pin_distance(model, line, p) for p in planets))


def pin_distance(model: Model, line: Line, planet: str) -> float:
    """Distance of a planet from an axis [m]."""
    origin = np.array(model.bodies[planet].origin or (0.0, 0.0, 0.0))
    return float(np.linalg.norm(origin - line.way * (line.way @ origin) - line.point))


def rim_radius(model: Model, line: Line, at: Positions, body: str, z: float) -> tuple[float, bool] | None:
    """Radius of the seat of a bearing by stiffness on a carrier or around a ring [m], and whether it is
    around a plate or ring; None for other bodies.

    Parameters
    ----------
    model
        The model.
    line
        The axis.
    at
        Positions along the axes.
    body
        The body with the bearing.
    z
        Position of the bearing along the axis [m].
    """
    gears = [model.gears[g] for g in model.bodies[body].gears]
    ring = bool(gears) and all(g.geometry.is_internal for g in gears)
    if body in model.shafts:
        radius = shaft_radius(model, body, (z - at.starts[body]) * line.bodies[body]) if ring else None
        return None if radius is None else (radius, True)
    room = room_of(model, line, at, body)
    if room is not None:
        inside = room.plate(-1.0)[0] - room.thick <= z <= room.plate(1.0)[1] + room.thick
        return (room.outer, True) if inside else (HUB * room.far, False)
    if not ring:
        return None
    return max(ring_radius(gear) for gear in gears), True


RIM_MODULES = 2.5
"""Thickness of a ring behind its roots without `bore_diameter`, in modules."""


def ring_radius(gear: object) -> float:
    """Outside radius of a ring gear [m]."""
    root = 0.5 * abs(gear.geometry.d_f)  # type: ignore[attr-defined]
    return max(0.5 * gear.bore_diameter, root + RIM_MODULES * gear.normal_module)  # type: ignore[attr-defined]


def carrier_of_axis(
    model: Model, line: Line, at: Positions, body: str, seats: Mapping[str, tuple[float, float, float]]
) -> Carrier | None:
    """Plates, and hubs to the shaft and to the bearings of a carrier; None for other bodies.

    Parameters
    ----------
    model
        The model.
    line
        The axis.
    at
        Positions along the axes.
    body
        A body of the axis.
    seats
        Bearings on the body: ends along the axis, and radius of the seat [m].
    """
    room = room_of(model, line, at, body)
    if room is None:
        return None
    kind = "held" if model.bodies[body].moves == "fixed" else "plate"
    closed = closed_side(model, line, at, body, room)
    found = []
    for way in (-closed, closed):
        low, high = room.plate(way)
        hole = _hole(model, line, at, body, room, way)
        name = body if way == closed else ""
        found.append(
            Piece(kind=kind, line=box_line(low, high, min(hole, 0.8 * room.far), room.outer), name=name)
        )
        face = high if way > 0.0 else low
        found += _hubs(kind, face, way, hole, seats, room)
    if kind == "plate" and body not in model.shafts:
        end = room.plate(closed)[closed > 0.0]
        shaft = seat_shaft(model, body)
        length, radius = STUB * room.thick, HUB * room.far
        if shaft is not None:
            near = min(_span(model, line, at, shaft), key=lambda z: abs(z - end))
            length, radius = max(closed * (near - end), 0.0), shaft_radius(model, shaft, 0.0) or radius
        inner = _hole(model, line, at, body, room, closed)
        beyond = any(closed * (s[1] - end) > 0.0 for s in seats.values()) or _inner(
            model, line, at, body, closed
        )
        if length > 0.0 and (shaft is not None or not beyond):
            outer = max(radius, 1.3 * inner)
            found.append(Piece(kind=kind, line=span_line(end, closed * length, inner, outer)))
    return Carrier(room, found, closed)


def _hubs(
    kind: str,
    face: float,
    way: float,
    hole: float,
    seats: Mapping[str, tuple[float, float, float]],
    room: Room,
) -> list[Piece]:
    """Hubs from a plate to the bearings beyond it."""
    found = []
    for low, high, radius in seats.values():
        far = high if way > 0.0 else low
        if way * (far - face) > 0.0 and radius <= room.outer:
            inner = hole if hole < 0.95 * radius < 0.95 * room.outer else COLLAR * radius
            found.append(Piece(kind=kind, line=span_line(face, far - face, inner, radius)))
    return found


def closed_side(model: Model, line: Line, at: Positions, body: str, room: Room) -> float:
    """Side on which a carrier is connected: that of its shaft, else away from the shafts of the suns."""
    middle = 0.5 * (room.low + room.high)
    shaft = seat_shaft(model, body)
    if shaft is not None:
        return 1.0 if sum(_span(model, line, at, shaft)) > 2.0 * middle else -1.0
    beyond = [_outside(z, room) for z in _partners(model, line, at, body)]
    if any(beyond):
        return 1.0 if sum(beyond) > 0.0 else -1.0
    suns = _suns(model, line, at, body, room)
    reach = [_span(model, line, at, sun) for sun in suns]
    reach += [(z, z) for sun in suns for z in _partners(model, line, at, sun)]
    above = max([high for _, high in reach], default=room.high) - room.high
    below = room.low - min([low for low, _ in reach], default=room.low)
    if abs(above - below) < 1e-9:  # towards the nearer end of the axis
        gears = [at.gears[g] for b in line.bodies for g in model.bodies[b].gears]
        return -1.0 if gears and 0.5 * (min(gears) + max(gears)) > middle + 1e-9 else 1.0
    return -1.0 if above > below else 1.0


def _inner(model: Model, line: Line, at: Positions, body: str, way: float) -> bool:
    """Whether gears of other bodies follow on the connected side of a carrier without a coupling."""
    room = room_of(model, line, at, body)
    if room is None or _partners(model, line, at, body):
        return False
    return any(_outside(at.gears[g], room) == way for b in line.bodies for g in model.bodies[b].gears)


def _outside(z: float, room: Room) -> float:
    """Side of the planets on which a position is; 0 between their ends."""
    return float(z > room.high) - float(z < room.low)


def _partners(model: Model, line: Line, at: Positions, body: str) -> list[float]:
    """Middles of the bodies of an axis to which couplings connect a body [m]."""
    ends = [
        [split(end)[0] for end in part.bodies]
        for group in (model.couplings, model.torsion_springs)
        for part in group.values()
        if part.stage is None and len(part.bodies) == 2
    ]
    others = [b for pair in ends if body in pair for b in pair if b != body and b in line.bodies]
    rooms = {b: room for b in others if (room := room_of(model, line, at, b)) is not None}
    return [
        0.5 * (rooms[b].low + rooms[b].high) if b in rooms else 0.5 * sum(_span(model, line, at, b))
        for b in others
    ]


def _suns(model: Model, line: Line, at: Positions, body: str, room: Room) -> list[str]:
    """Bodies of an axis with external gears between the plates of a carrier."""
    return [
        other
        for other in line.bodies
        if other != body
        and any(
            room.low < at.gears[g] < room.high and not model.gears[g].geometry.is_internal
            for g in model.bodies[other].gears
        )
    ]


def _span(model: Model, line: Line, at: Positions, body: str) -> tuple[float, float]:
    """Ends of a body by its sections, else by its gears [m]."""
    if body in model.shafts:
        end = at.starts[body] + line.bodies[body] * model.shafts[body].length
        return min(at.starts[body], end), max(at.starts[body], end)
    ends = [
        at.gears[g] + side * 0.5 * model.gears[g].face_width
        for g in model.bodies[body].gears
        for side in (-1, 1)
    ]
    return (min(ends), max(ends)) if ends else (at.starts[body], at.starts[body])


def _hole(model: Model, line: Line, at: Positions, body: str, room: Room, way: float) -> float:
    """Radius of the hole of a plate for the shafts that pass it, or of its seat on its own shaft [m]."""
    low, high = room.plate(way)
    middle = 0.5 * (low + high)

    def radius(other: str) -> float:
        """Radius of a body in the plate."""
        start, end = _span(model, line, at, other)
        if not start < middle < end:
            return 0.0
        if other in model.shafts:
            return shaft_radius(model, other, (middle - at.starts[other]) * line.bodies[other]) or 0.0
        inside = [model.gears[g] for g in model.bodies[other].gears]
        if any(g.geometry.is_internal for g in inside):  # a drum ends at the root circle of the sun
            return min(0.5 * abs(g.geometry.d_f) for g in inside)
        return spindle_radius(model, other) or 0.0

    if body in model.shafts and radius(body) > 0.0:
        return radius(body)
    if way != closed_side(model, line, at, body, room):
        suns = [
            spindle_radius(model, b) or 0.0
            for b in _suns(model, line, at, body, room)
            if b not in model.shafts
        ]
        least = [max(*suns, 0.25 * room.far)] if suns else []
    else:
        least = []
    passing = [r for b in line.bodies if b != body and (r := radius(b)) < 0.8 * room.far]
    return HOLE * max([*passing, *least], default=0.0)


def pin_pieces(model: Model, at: Positions, line: Line, carriers: Line | None) -> list[Piece]:
    """Pin of a planet, through both plates of its carrier.

    Parameters
    ----------
    model
        The model.
    at
        Positions along the axes.
    line
        The axis.
    carriers
        The axis of the carrier of its planet; None without.
    """
    for body in line.bodies:
        if carriers is not None and is_planet(model, body):
            room = room_of(model, carriers, at, model.mechanism.seats[body].parent)
            if room is not None:
                more = 1.5 * room.thick
                ends = box_line(room.low - more, room.high + more, 0.0, room.pin)
                return [Piece(kind="pin", line=ends)]
    return []


def carrier_ends(carrier: Carrier) -> tuple[float, float]:
    """Ends of a carrier along its axis [m]."""
    return extent(list(carrier.pieces))
