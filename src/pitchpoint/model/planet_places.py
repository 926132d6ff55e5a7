# SPDX-License-Identifier: Apache-2.0
"""Places of the bodies of planetary stages: sun, ring and carrier on the axis, planets on their pins.

The angle between planets and inner planets is that of the triangle of the axis and both pins.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.units import format_quantity
from pitchpoint.model.components.planetary_stage import PinError, PlanetaryStage
from pitchpoint.model.frames import Array, body_frame
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts


def central_bodies(parts: Any, stage: PlanetaryStage) -> list[tuple[str, float]]:
    """Bodies of the suns and rings of a stage, and axial positions of its middle on them [m].

    The middle is the mid-face of sun and ring in mesh with the gear given as `planet`.
    """
    found = []
    for wheel in stage.wheels:
        for side, gear in wheel.mates.items():
            body = None if side == "planet" else parts.body_of(gear)
            if body is not None and body in parts.bodies:
                rise = stage.position + wheel.position if wheel.step else 0.0
                found.append((body, parts.bodies[body].gears[gear] - rise))
    return found


def axis_bodies(parts: Any, stage: PlanetaryStage) -> list[str]:
    """Bodies on the axis of a stage: those of suns and rings, and the carrier."""
    return [*(body for body, _ in central_bodies(parts, stage)), stage.carrier]


def inner_stage(parts: Any, stage: PlanetaryStage) -> PlanetaryStage | None:
    """Stage of the inner planets, if there are any."""
    mate = next((wheel.mates["planet"] for wheel in stage.wheels if "planet" in wheel.mates), None)
    stages = parts.planetary_stages.values()
    return next((s for s in stages if s.planet_name == mate and s is not stage), None)


def settle_angles(parts: Parts, report: Reader) -> None:
    """Compute the angles of planets from those of their inner planets."""
    waiting = dict(parts.planetary_stages)
    while waiting:
        ready = [
            name
            for name, stage in waiting.items()
            if (inner := inner_stage(parts, stage)) is None or inner not in waiting.values()
        ]
        if not ready:
            return  # a loop, reported before
        for name in ready:
            stage = waiting.pop(name)
            inner = inner_stage(parts, stage)
            if inner is not None and stage.planets is not None:
                lead = _lead(parts, name, stage, inner, report)
                parts.planetary_stages[name] = replace(stage, inner_angles=inner.places, lead=lead)


def _lead(parts: Parts, name: str, stage: PlanetaryStage, inner: PlanetaryStage, report: Reader) -> float:
    """Angle from an inner planet to its planet [rad]: that of a triangle of three centre distances."""
    own, other = nominal_distance(parts, stage), nominal_distance(parts, inner)
    (group,) = (g for g in stage.groups if g.side == "planet")
    between = parts.meshes[group.names[0]].a_w if group.names[0] in parts.meshes else None
    if own is None or other is None or between is None:
        return 0.0  # reported for the meshes
    cosine = (own**2 + other**2 - between**2) / (2.0 * own * other)
    if abs(cosine) >= 1.0:
        report.problem(
            ("planetary_stages", name, "planet_center_distance"),
            f"does not fit the pins, which are {format_quantity(own, 'length')} and "
            f"{format_quantity(other, 'length')} from the axis",
            value=format_quantity(between, "length"),
            limit=" to ".join(format_quantity(x, "length") for x in (abs(own - other), own + other)),
            remedy="change a centre distance, or the teeth",
        )
        return 0.0
    return math.acos(cosine) * (1.0 if stage.planet_side == "counter_clockwise" else -1.0)


def orient_pins(parts: Parts) -> None:
    """Give the pins of the planets the axes of their bodies."""
    for name, joint in parts.joints.items():
        if joint.stage is not None and joint.bodies[1] in parts.bodies:
            parts.joints[name] = replace(joint, axes=parts.bodies[joint.bodies[1]].orientation)


def nominal_distance(parts: Any, stage: PlanetaryStage) -> float | None:
    """Distance of the pins from the axis without pin errors [m]; None if its meshes are not valid."""
    if stage.center_distance is not None:
        return stage.center_distance
    firsts = [name for group in stage.groups if group.side != "planet" for name in group.names[:1]]
    known = (parts.meshes[name].a_w for name in firsts if name in parts.meshes)
    return next((abs(a) for a in known if a is not None), None)


def place_planets(parts: Parts) -> None:
    """Locate the bodies of all stages whose axis is known: sun, ring and carrier on it, planets around it."""
    for stage in parts.planetary_stages.values():
        seats = [(b, at) for b, at in central_bodies(parts, stage) if parts.bodies[b].origin is not None]
        centre = _centre(parts, seats, stage)
        if centre is None:
            continue
        origin, axes = centre
        for body, at in central_bodies(parts, stage):
            if parts.bodies[body].origin is None:
                _put(parts, body, origin - at * axes[:, 2])
        if stage.carrier in parts.bodies and parts.bodies[stage.carrier].origin is None:
            _put(parts, stage.carrier, origin)
        distance = nominal_distance(parts, stage)
        for planet, angle in zip(stage.names, stage.places, strict=True):
            if distance is None or planet not in parts.bodies or parts.bodies[planet].origin is not None:
                continue
            error = stage.pin_errors.get(planet, PinError())
            out, along = distance + error.radial, error.tangential
            x = out * math.cos(angle) - along * math.sin(angle)
            y = out * math.sin(angle) + along * math.cos(angle)
            _put(parts, planet, origin + axes @ np.array((x, y, stage.position)))


def _centre(
    parts: Parts, seats: list[tuple[str, float]], stage: PlanetaryStage
) -> tuple[Array, Array] | None:
    """Middle of a stage [m] and its axes; None if its place is unknown."""
    for body, at in seats:
        origin, axes = body_frame(parts, body)
        if origin is not None:
            return origin + at * axes[:, 2], axes
    origin, _ = body_frame(parts, stage.carrier)
    members = central_bodies(parts, stage)
    if origin is None or not members:
        return None
    return origin, body_frame(parts, members[0][0])[1]


def _put(parts: Parts, body: str, place: Array) -> None:
    x, y, z = (float(v) for v in place)
    parts.bodies[body] = replace(parts.bodies[body], origin=(x, y, z))
