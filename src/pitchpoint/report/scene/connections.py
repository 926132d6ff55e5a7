# SPDX-License-Identifier: Apache-2.0
"""Connections in a scene: plain bearings, bushings, couplings, clutches, brakes, torsional springs.

They are at their positions in the model and move with the connected bodies; their size is symbolic, except
for the clearance of plain bearings, which is to scale.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import registry
from pitchpoint.model.frames import GROUND, axes_of, bodies_of, place_of, split
from pitchpoint.model.mechanism import seat_frame
from pitchpoint.model.rings import rings_of
from pitchpoint.model.sections import groups_of
from pitchpoint.report.scene import shapes
from pitchpoint.report.scene.places import placed_solid
from pitchpoint.report.scene.schematics import BAR, bar, link, piston, stand_in, stretched
from pitchpoint.report.scene.supports import DEFAULT_RADIUS, shaft_radius
from pitchpoint.viz.scene.content import SceneSolid

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from pitchpoint.model.model import Model
    from pitchpoint.report.scene.places import Places

Array = NDArray[np.float64]

BUSH = 1.35
"""Outer radius of the bush of a plain bearing relative to its bore radius."""
FLANGE, DISC = 1.9, 2.6
"""Radii of coupling halves and clutch discs relative to the radius of the rotating part."""
SMALLEST = 0.035
"""Minimum radius of a half, relative to the size of the machine."""
THICK = 0.3
"""Thickness of a half relative to its radius."""
SAME_LINE = 1e-6
"""Distance below which two axes count as one, relative to the size of the machine."""
WINDINGS = 4


def joining_parts(model: Model, at: Places) -> list[SceneSolid]:
    """Solids of all connections between bodies without a given shape.

    Parameters
    ----------
    model
        The model.
    at
        Where things sit in the scene.
    """
    found: list[SceneSolid] = []
    for section, schematic in drawn_sections(model):
        for name, part in getattr(model, section).items():
            if getattr(part, "stage", None) is None:  # hub and spring of a scissor gear are inside the gear
                found += SCHEMATICS[schematic](at, name, part)
    return found


def drawn_sections(model: Model) -> list[tuple[str, str]]:
    """Sections of a model with components that a schematic represents, and its name, from their kinds."""
    own = [section for section in groups_of(model) if getattr(model, section)]
    found = {}
    for name in registry.names(others=bool(model.others)):
        for section, schematic in registry.find(name).sections.items():
            if schematic and section in own:
                found[section] = schematic
    return [(section, found[section]) for section in own if section in found]


def _radius(model: Model, at: Places, end: str, place: Array) -> float | None:
    """Radius of the rotating part at a position in the world [m]; None if unknown."""
    body = split(end)[0]
    if body not in model.bodies:
        return None
    origin, axes = at.world(body)
    return shaft_radius(model, body, float((place - origin) @ axes[:, 2]))


def _round(clearance: float, radius: float) -> int:
    """Number of corners of a circle with a chord error below 1/16 of a clearance."""
    return int(np.clip(math.pi / math.sqrt(clearance / (8.0 * radius)), 48, 360))


def _journal(at: Places, name: str, part: Any) -> list[SceneSolid]:
    """Journal and bush, separated by the clearance, each on its body."""
    ends = rings_of(at.model, part)
    place = ends[0].place
    known = None if place is None else _radius(at.model, at, ends[0].body, place)
    # 0.1 % larger than the shaft, because coincident surfaces flicker
    radius = max(1.001 * (known or DEFAULT_RADIUS * at.size), part.clearance)
    bore = radius + 0.5 * part.clearance
    sides = _round(part.clearance, radius)
    rings = (shapes.disc(radius, 1.3 * radius, 0.0, sides), shapes.disc(BUSH * bore, radius, bore, sides))
    named = (("journal", "shaft"), ("bush", "bearing"))
    return [
        placed_solid(f"bearing {name}, {word}", kind, at.ring(end), ring)
        for end, ring, (word, kind) in zip(ends, rings, named, strict=True)
    ]


def _bushing(at: Places, name: str, part: Any) -> list[SceneSolid]:
    """Sleeve on the first end and a ring around it on the second; ground is at the other end."""
    model, ends = at.model, part.ends
    marks = [other if end == GROUND else end for end, other in zip(ends, ends[::-1], strict=True)]
    places = [place_of(model, end) for end in marks]
    known = [_radius(model, at, m, p) for m, p in zip(marks, places, strict=True) if p is not None]
    radius = max(DEFAULT_RADIUS * at.size, *(r or 0.0 for r in known))
    rings = {
        "sleeve": shapes.disc(1.3 * radius, 2.2 * radius, 1.002 * radius, 32),
        "ring": shapes.disc(2.0 * radius, 1.6 * radius, 1.35 * radius, 32),
    }
    found = []
    for end, mark, place, (word, ring) in zip(ends, marks, places, rings.items(), strict=True):
        if place is None:
            continue
        surface = shapes.moved(ring, place, axes_of(model, mark))
        found.append(stand_in(at, f"bushing {name}, {word}", "bearing", split(end)[0], surface, place))
    return found


class _Axis(NamedTuple):
    """Common axis of rotation of two bodies, and their facing ends along it."""

    origin: Array
    direction: Array
    near: float
    far: float
    other_origin: Array | None
    """Position of the second body on a different axis [m]; None if both have the same axis."""


def _spin_line(at: Places, body: str) -> tuple[Array, Array]:
    """Point on the spin axis of a body [m], and its direction."""
    place, axes = seat_frame(at.model, at.model.mechanism.seats[body])
    return place, axes[:, 2]


def _stretch(at: Places, end: str, origin: Array, direction: Array) -> tuple[float, float]:
    """Extent of a body along a line, by its gears, sections, markers and joints [m]; place of a marker."""
    body, marker = split(end)
    model, part = at.model, at.model.bodies[body]
    place = place_of(model, end) if marker else None
    if place is not None:
        height = float((place - origin) @ direction)
        return height, height
    found = [float((at.origin(body) - origin) @ direction)]
    found += [float((p - origin) @ direction) for p in at.anchors(body)]
    own, axes = at.world(body)
    middle, along = float((own - origin) @ direction), float(axes[:, 2] @ direction)
    for gear, z in part.gears.items():
        half = 0.5 * model.gears[gear].face_width
        found += [middle + along * (z - half), middle + along * (z + half)]
    if body in model.shafts:
        found.append(middle + along * model.shafts[body].length)
    return min(found), max(found)


def _axis(at: Places, ends: tuple[str, ...]) -> _Axis:
    """Position at which a body rotates relative to another body or ground; ends BODY or BODY.MARKER."""
    first, *others = ends
    origin, direction = _spin_line(at, split(first)[0])
    low, high = _stretch(at, first, origin, direction)
    if not others or others[0] == GROUND:
        return _Axis(origin, direction, low, low, None)
    other, along = _spin_line(at, split(others[0])[0])
    way = other - origin
    beside = np.linalg.norm(way - direction * (way @ direction)) > SAME_LINE * at.size
    if beside or abs(direction @ along) < 1.0 - SAME_LINE:
        return _Axis(origin, direction, 0.0, 0.0, other)
    start, end = _stretch(at, others[0], origin, direction)
    if start >= high:
        return _Axis(origin, direction, high, start, None)
    if end <= low:
        return _Axis(origin, direction, low, end, None)
    # overlapping: placed next to both
    return _Axis(origin, direction, max(high, end), max(high, end), None)


def _halves(
    at: Places, name: str, ends: tuple[str, ...], large: float, height: float | None = None
) -> list[SceneSolid]:
    """Discs of two bodies that face each other, with a neck to each body.

    The second part of a brake is a pair of pads on ground; parts on two axes are connected by a bar.
    """
    model, line, bodies = at.model, _axis(at, ends), bodies_of(ends)
    if line.other_origin is not None:
        return _across(at, name, "body", bodies, line)
    middle = 0.5 * (line.near + line.far)
    if height is not None:
        own, axes = at.world(bodies[0], (0.0, 0.0, height))
        middle = float((own - line.origin) @ line.direction)
    place = line.origin + middle * line.direction
    known = [r for b in bodies if (r := _radius(model, at, b, place))]
    radius = max(large * min(known, default=0.0), SMALLEST * at.size)
    side = 1.0 if line.far >= line.near else -1.0
    frame, thick = shapes.across(side * line.direction), THICK * radius
    necks = (line.near - middle, line.far - middle)
    found = []
    for body, sign, neck in zip((*bodies, GROUND)[:2], (-1.0, 1.0), necks, strict=True):
        half = shapes.moved(shapes.disc(radius, thick), (0.0, 0.0, 0.55 * sign * thick))
        pieces = [half]
        if body == GROUND:
            pieces = _pads(radius, thick)
        elif side * neck * sign > thick:
            way = ((0.0, 0.0, sign * thick), (0.0, 0.0, side * neck))
            pieces.append(shapes.rod(*way, 0.35 * radius))
        surface = shapes.moved(shapes.joined(pieces), place, frame)
        word = f"{name}, {'pads' if body == GROUND else body}"
        found.append(stand_in(at, word, "bearing", body, surface, place))
    return found


def _pads(radius: float, thick: float) -> list[shapes.Surface]:
    """Pads at the rim of the disc of a brake."""
    long, middle = 0.5 * radius, -0.55 * thick
    pad = (long, 0.7 * radius, 0.4 * thick)
    back = (0.25 * radius, 0.7 * radius, 1.9 * thick)
    return [
        shapes.box(pad, (0.8 * radius, 0.0, middle + 0.75 * thick)),
        shapes.box(pad, (0.8 * radius, 0.0, middle - 0.75 * thick)),
        shapes.box(back, (1.16 * radius, 0.0, middle)),
    ]


def _coil(at: Places, name: str, part: Any) -> list[SceneSolid]:
    """Coil between two bodies on one axis, flat spiral for overlapping bodies, else a bar."""
    bodies, line = bodies_of(part.bodies), _axis(at, part.bodies)
    if line.other_origin is not None:
        return _across(at, name, "spring", bodies, line)
    ends = [line.origin + h * line.direction for h in (line.near, line.far)]
    radius = SMALLEST * at.size
    if abs(line.far - line.near) > radius:
        points, triangles = shapes.coil(radius, 0.12 * radius, WINDINGS)
        places = [at.at_world(b, p, np.eye(3)) for b, p in zip(bodies, ends, strict=True)]
        return [stretched(name, "spring", places, (points, triangles))]
    spiral = shapes.tube(list(_spiral(radius)), 0.09 * radius)
    away = (-0.5 if len(bodies) == 1 else 0.5) * radius * line.direction
    surface = shapes.moved(spiral, ends[0] + away, shapes.across(line.direction))
    return [stand_in(at, name, "spring", bodies[0], surface, ends[0])]


def _spiral(radius: float) -> Iterator[tuple[float, float, float]]:
    """Points of a flat spiral about the third axis."""
    for share in np.linspace(0.15, 1.0, 24 * WINDINGS):
        angle = 2.0 * math.pi * WINDINGS * share
        yield radius * share * math.cos(angle), radius * share * math.sin(angle), 0.0


def _across(at: Places, name: str, kind: str, bodies: tuple[str, ...], line: _Axis) -> list[SceneSolid]:
    """Bar or coil between the axes of two bodies."""
    assert line.other_origin is not None
    thin = 0.4 * BAR * at.size
    bar = shapes.turned_profile([(0.0, 0.0), (thin, 0.0), (thin, 1.0), (0.0, 1.0)], 12)
    surface = bar if kind == "body" else shapes.coil(2.5 * thin, 0.5 * thin)
    origins = (line.origin, line.other_origin)
    ends = [at.at_world(b, p, np.eye(3)) for b, p in zip(bodies, origins, strict=True)]
    return [stretched(name, kind, ends, surface)]


def _spring(at: Places, name: str, part: Any) -> list[SceneSolid]:
    """Coil between two points; without stiffness a piston in its cylinder."""
    stiff = part.stiffness > 0.0
    surface = shapes.coil(0.022 * at.size, 0.004 * at.size) if stiff else piston(at)
    return [link(at, name, part.ends, "spring", surface)]


def _rod(at: Places, name: str, part: Any) -> list[SceneSolid]:
    """Bar between two points."""
    return [link(at, name, part.ends, "body", bar(at))]


def _flanges(at: Places, name: str, part: Any) -> list[SceneSolid]:
    """Flanges on two bodies with a common axis."""
    position = getattr(part, "position", None)
    height = None if position is None else position[2]
    return _halves(at, f"coupling {name}", part.bodies, FLANGE, height)


def _discs(at: Places, name: str, part: Any) -> list[SceneSolid]:
    """Friction discs, or a brake disc with pads on ground."""
    word = "clutch" if len(part.bodies) == 2 else "brake"
    return _halves(at, f"{word} {name}", part.bodies, DISC)


SCHEMATICS: dict[str, Callable[[Places, str, Any], list[SceneSolid]]] = {
    "bushing": _bushing,
    "coil": _coil,
    "discs": _discs,
    "flanges": _flanges,
    "journal": _journal,
    "rod": _rod,
    "spring": _spring,
}
"""Symbol of a component, by the name in its kind (`elements.kind.Kind.sections`). Coils, discs and flanges
require a component with the key `bodies`, all others one with `ends`."""
