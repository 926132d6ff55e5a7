# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings in a scene: rings on their bodies, rolling elements that orbit with the cage, spalls.

Linear bearings are drawn in the size that their shaft has in a catalogue and marked as schematic.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import registry
from pitchpoint.model.checks.bearing_faults import element_angles, track_radius
from pitchpoint.model.components.bearing_fault import CageFault, ElementFault, Spall
from pitchpoint.model.frames import GROUND, split
from pitchpoint.model.rings import rings_of
from pitchpoint.report.scene.bearing_sections import element_surface, ring, spall
from pitchpoint.report.scene.bearing_sizes import BearingSize, size_of
from pitchpoint.report.scene.gear_room import seated
from pitchpoint.report.scene.modes import rest_axes
from pitchpoint.report.scene.motion import Motion, kinematic
from pitchpoint.report.scene.places import placed_solid
from pitchpoint.report.scene.supports import linear_size, shaft_radius
from pitchpoint.viz.scene.content import SceneBody, SceneLevel, ScenePiece, SceneSolid

if TYPE_CHECKING:
    from pitchpoint.model.components.rolling_bearing import RollingBearing
    from pitchpoint.model.model import Model
    from pitchpoint.report.scene.places import Places
    from pitchpoint.system.system import System

Array = NDArray[np.float64]
Seat = tuple[int, Array, Array]
TWO_PI = 2.0 * math.pi

BESIDE = 0.1
"""Gap between a bearing and the face of a gear that it would intersect, relative to the shaft radius."""
CORNERS = {"ball": (10, 16, 32), "roller": (12, 20, 40)}
"""Corners of a rolling element in each level of detail."""
NARROWEST = 0.02
"""Minimum half angle of a drawn spall [rad]."""
OFF_AXIS = 1e-3
"""Distance from the axis of a body up to which a bearing in it is on its pin, relative to the machine."""
MOST = 100
"""With more linear bearings, these are drawn without rolling elements."""


def ring_places(model: Model, name: str, size: float) -> list[float]:
    """Axial positions of a linear bearing on its body [m]: its own, or both sides of a gear.

    Parameters
    ----------
    model, name, size
        As for `supports.linear_size`.
    """
    part = model.bearings[name]
    z, drawn = part.position[2], linear_size(model, name, size)
    for gear in seated(model, part.body).values() if part.body in model.bodies else ():
        half = 0.5 * (gear.high - gear.low)
        if abs(z - gear.middle) < half + 0.5 * drawn.width:
            away = half + 0.5 * drawn.width + BESIDE * 0.5 * drawn.bore
            return [gear.middle - away, gear.middle + away]
    return [z]


class BearingSeat(NamedTuple):
    """Seat of a bearing on its body: ends along the axis [m] and radius [m]."""

    low: float
    high: float
    radius: float


def bearing_seats(model: Model, at: Places, body: str) -> list[BearingSeat]:
    """Seats of all rolling and linear bearings on a body.

    Parameters
    ----------
    model, at
        As for `bearing_solids`.
    body
        Name of the body.
    """
    found = []
    for name, part in model.bearings.items():
        if part.body == body:
            size = linear_size(model, name, at.size)
            found += [_seat(z, size) for z in ring_places(model, name, at.size)]
    origin, axes = at.world(body)
    for name, rolling in model.rolling_bearings.items():
        inner = rings_of(model, rolling)[0]
        if inner.body == body and inner.place is not None:
            found.append(_seat(float((inner.place - origin) @ axes[:, 2]), rolling_size(model, at, name)))
    return found


class Pin(NamedTuple):
    """Pin on which a body turns, by the rolling bearings in the body.

    Attributes
    ----------
    body
        Body of the pin, or ground.
    radius
        Radius of the pin [m].
    outside
        Largest outside diameter of its bearings [m].
    """

    body: str
    radius: float
    outside: float


def pin_of(model: Model, at: Places, body: str) -> Pin | None:
    """Pin on which a body turns: it contains the outer rings of bearings on its axis, and no inner ring.

    Parameters
    ----------
    model, at
        As for `bearing_solids`.
    body
        Name of the body.
    """
    if body in model.shafts:
        return None
    origin, axes = at.world(body)
    rings = {name: rings_of(model, part) for name, part in model.rolling_bearings.items()}
    inside = {
        name: inner.body
        for name, (inner, outer) in rings.items()
        if outer.body == body
        and outer.place is not None
        and np.hypot(*((outer.place - origin) @ axes[:, :2])) < OFF_AXIS * at.size
    }
    if not inside or any(inner.body == body for inner, _ in rings.values()):
        return None
    sizes = [rolling_size(model, at, name) for name in inside]
    radius = 0.5 * min(size.bore for size in sizes)
    return Pin(next(iter(inside.values())), radius, max(size.outside for size in sizes))


def _seat(z: float, size: BearingSize) -> BearingSeat:
    return BearingSeat(z - 0.5 * size.width, z + 0.5 * size.width, 0.5 * size.bore)


def bearing_solids(model: Model, at: Places) -> list[SceneSolid]:
    """Rings, rolling elements and spalls of all rolling and linear bearings.

    Parameters
    ----------
    model
        The model.
    at
        Positions in the scene, with the cages of `cage_bodies`, if any.
    """
    found: list[SceneSolid] = []
    for name, rolling in model.rolling_bearings.items():
        found += _rolling(model, at, name, rolling)
    for name, part in model.bearings.items():
        if part.body in model.bodies:
            found += _linear(model, at, name)
    return found


def _rolling(model: Model, at: Places, name: str, part: RollingBearing) -> list[SceneSolid]:
    size = rolling_size(model, at, name)
    rings = rings_of(model, part)
    seats = [at.ring(one) for one in rings]
    found = [
        placed_solid(f"{name}, {word} ring", "bearing", seat, ring(size, word == "inner"), schematic=False)
        for word, seat in zip(("inner", "outer"), seats, strict=True)
        if not (size.bare and word == "inner")
    ]
    faulty = {
        fault.element: f"spall on element {fault.element} ({label})"
        for label, fault in part.faults.items()
        if isinstance(fault, ElementFault) and fault.severity > 0.0
    }
    wide = {
        fault.element: f"wider gap behind element {fault.element} ({label})"
        for label, fault in part.faults.items()
        if isinstance(fault, CageFault) and fault.severity > 0.0
    }
    for row in range(size.rows):
        marked = {**wide, **faulty} if row == 0 else {}
        turns = element_angles(part) + row * math.pi / size.count
        found.append(_elements(at, name, size, seats[1], turns, marked, False, row))
    for label, fault in part.faults.items():
        if isinstance(fault, Spall) and not isinstance(fault, ElementFault) and fault.severity > 0.0:
            inner = fault.form == "inner_race"
            half = 0.5 * fault.severity * fault.length / track_radius(part, inner)
            points, triangles = spall(size, inner, max(half, NARROWEST))
            piece = ScenePiece(
                np.array([fault.angle]),
                [SceneLevel(0.0, points, triangles)],
                f"spall of {1e3 * fault.severity * fault.length:.3g} mm ({label})",
            )
            # angles on both races count from the x axis of the outer ring as assembled
            body, origin, axes = at.ring(rings[0 if inner else 1]._replace(axes=rings[1].axes))
            found.append(
                SceneSolid(
                    name=f"{name}, {'inner' if inner else 'outer'} race",
                    kind="bearing",
                    body=body,
                    pieces=[piece],
                    place=origin,
                    axes=axes,
                )
            )
    return found


def rolling_size(model: Model, at: Places, name: str) -> BearingSize:
    """Dimensions of a rolling bearing; its bore is that of the shaft in it, where that is possible.

    Parameters
    ----------
    model
        The model.
    at
        Positions in the scene.
    name
        Name of the bearing.
    """
    part = model.rolling_bearings[name]
    inner = rings_of(model, part)[0]
    radius = None
    if inner.body in model.bodies and inner.place is not None:
        origin, axes = at.world(inner.body)
        radius = shaft_radius(model, inner.body, float((inner.place - origin) @ axes[:, 2]))
    return size_of(part, radius)


def _linear(model: Model, at: Places, name: str) -> list[SceneSolid]:
    """A bearing on the shaft, twice if it is on both sides of a gear."""
    part = model.bearings[name]
    size = linear_size(model, name, at.size)
    found = []
    for z in ring_places(model, name, at.size):
        outer = _outer_seat(model, at, name, z)
        named = (("inner", at.own(part.body, (0.0, 0.0, z))), ("outer", outer))
        found += [
            placed_solid(f"bearing {name}, {word} ring", "bearing", seat, ring(size, word == "inner", 40))
            for word, seat in named
        ]
        if len(model.bearings) <= MOST:
            turns: Array = TWO_PI / size.count * np.arange(size.count, dtype=np.float64)
            found.append(_elements(at, name, size, outer, turns, {}, True))
    return found


def _outer_seat(model: Model, at: Places, name: str, z: float) -> Seat:
    """Outer ring of a linear bearing at a height on its body [m]."""
    part = model.bearings[name]
    origin, frame = at.world(part.body, (0.0, 0.0, z))
    return at.at_world(split(part.housing or GROUND)[0], origin, frame)


def _elements(
    at: Places,
    name: str,
    size: BearingSize,
    outer: Seat,
    turns: Array,
    faults: Mapping[int, str],
    schematic: bool,
    row: int = 0,
) -> SceneSolid:
    """Rolling elements on the cage, or at rest on the outer ring if the scene has none."""
    word = "balls" if size.type == "ball" else "rollers"
    levels = [
        SceneLevel(
            0.5 * size.element * (1.0 - math.cos(math.pi / sides)) if sides < CORNERS[size.type][-1] else 0.0,
            *element_surface(size, sides, row),
        )
        for sides in CORNERS[size.type]
    ]
    sound = [k for k in range(len(turns)) if k not in faults]
    pieces = [ScenePiece(turns[[k]], levels, text) for k, text in faults.items() if k < len(turns)]
    pieces = [ScenePiece(turns[sound], levels), *pieces] if sound else pieces
    body, place, axes = outer
    cage = at.cages.get(name)
    if cage is not None and cage[1][0] == body:
        body, (_, origin, frame) = cage
        place, axes = frame.T @ (place - origin), frame.T @ axes
    return SceneSolid(
        name=f"{name}, {word}" + (f" of row {row + 1}" if size.rows > 1 else ""),
        kind="element",
        body=body,
        pieces=pieces,
        place=place,
        axes=axes,
        creases=40.0,
        schematic=schematic,
    )


def cage_bodies(
    system: System, model: Model, at: Places, moved: Motion, bodies: list[SceneBody]
) -> dict[str, SceneBody]:
    """Cages of all bearings that are drawn with rolling elements, by bearing.

    Their angle is that of pure rolling, by the relative rotation of both rings with all whole turns.

    Parameters
    ----------
    system, model
        The machine.
    at
        Positions in the scene.
    moved
        Motion of the bodies over the frames.
    bodies
        Bodies of the scene.
    """
    found = {}
    for kind, records in system.records.items():
        drawn = registry.find(kind).arrow_of
        for record, name in zip(records, system.names.get(kind, ()), strict=False):
            how = drawn(record)
            if how == "ring" and name in model.rolling_bearings:
                size = rolling_size(model, at, name)
                number, place, axes = at.ring(rings_of(model, model.rolling_bearings[name])[1])
            elif (
                how == "bearing" and model.bearings[name].body in model.bodies and len(model.bearings) <= MOST
            ):
                size = linear_size(model, name, at.size)
                number, place, axes = _outer_seat(model, at, name, model.bearings[name].position[2])
            else:
                continue
            world = rest_axes(bodies, number) @ axes
            turned = _spin(system, moved, int(record["i"]), world[:, 2])
            turned = turned - _spin(system, moved, int(record["j"]), world[:, 2])
            angle = size.cage_ratio * turned
            gross, ratio = kinematic(angle, moved)
            if how == "bearing" and gross is not None:
                angle = ratio * gross  # a symbol does not vibrate
            found[name] = SceneBody(
                name=f"{name} (cage)",
                parent=number,
                place=place,
                axes=axes,
                angle=angle if np.any(angle) else None,
                gross=gross,
                ratio=ratio,
                part=True,
            )
    return found


def _spin(system: System, moved: Motion, b: int, direction: Array) -> Array:
    """Rotation of a body about a direction in the world, including whole turns, shape (n,) [rad]."""
    total = np.zeros(len(moved.angle))
    while b > 0:
        total += float(np.rint(moved.axes[0, b, :, 2] @ direction)) * moved.angle[:, b]
        b = int(system.program["body"]["parent"][b])
    return total
