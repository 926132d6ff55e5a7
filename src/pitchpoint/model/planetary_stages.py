# SPDX-License-Identifier: Apache-2.0
"""Planetary stages: representation as the gears, bodies, pins, bearings and meshes of their planets.

Every planet is a gear and a body of the same name on a joint of the carrier. Its place is on the circle of
the pins, moved by the error of its pin; the distances of the places are the centre distances of its meshes.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import Message
from pitchpoint.core.nearest import did_you_mean
from pitchpoint.model.components.bearing import Bearing
from pitchpoint.model.components.body import Body
from pitchpoint.model.components.joint import Joint
from pitchpoint.model.components.planetary_stage import JOINTS, PinError, PlanetaryStage, SinglePlanet
from pitchpoint.model.frames import Array, body_frame
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.scissor_gears import places_of_free_half
from pitchpoint.model.show import dotted

if TYPE_CHECKING:
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.parts import Parts

SECTION = "planetary_stages"
GROUPS = ("gears", "bodies", "joints", "bearings", "meshes")
"""Sections of the components of a stage."""


# --- representation -----------------------------------------------------------------------------------------
def add_planetary_stages(parts: Parts, report: Reader) -> None:
    """Check the references of the stages and add the components of their planets.

    Later problems of these components are reported for the stages.
    """
    for name in parts.known(SECTION) - set(parts.planetary_stages):
        # the number of planets of an unreadable stage is unknown
        names = {f"planet_{k}" for k in range(1, 51)}
        gears = parts.known("gears")
        meshes = {f"{one}-{two}" for g in gears for n in names for one, two in ((g, n), (n, g))}
        others = {"joints": {f"{n}-pin" for n in names}, "bearings": {f"{n}-bearing" for n in names}}
        for group, added in {"gears": names, "bodies": names, "meshes": meshes, **others}.items():
            parts.names[group] = parts.known(group) | added
            report.tainted.add((group,))
        report.tainted.add((SECTION, name))
    for name, stage in parts.planetary_stages.items():
        if not (_usable(parts, name, stage, report) and _add(parts, name, stage, report)):
            for group, word, _, _ in members(name, stage):  # known, though without data
                parts.names[group] = parts.known(group) | {word}
                report.tainted.add((group,))


def _usable(parts: Parts, name: str, stage: PlanetaryStage, report: Reader) -> bool:
    """Check names and types of the members of a stage."""
    at: Place = (SECTION, name)
    before = len(report.problems)
    if stage.sun is None and stage.ring is None:
        report.problem(at, "has neither sun nor ring", remedy="name the gear that the planets mesh with")
    for key, gear, kind in (("sun", stage.sun, "external"), ("ring", stage.ring, "internal")):
        if gear is None:
            continue
        if not parts.has("gears", gear):
            guess = did_you_mean(gear, parts.known("gears"))
            have = f"there are {', '.join(sorted(parts.known('gears'))) or 'none'}"
            report.problem(
                (*at, key), f"names the gear {gear[:40]!r}, which does not exist", remedy=guess + have
            )
        elif gear in parts.gears and parts.gears[gear].type != kind:
            report.problem(
                (*at, key),
                f"names the {parts.gears[gear].type} gear {gear}",
                limit=f"an {kind} gear",
                remedy=f"name an {kind} gear, or give {gear} type: {kind}",
            )
    if not parts.has("bodies", stage.carrier):
        known = parts.known("bodies") | parts.known("shafts") | parts.known("elastic_bodies")
        if stage.carrier not in known:
            guess = did_you_mean(stage.carrier, known)
            report.problem(
                (*at, "carrier"),
                f"names the body {stage.carrier[:40]!r}, which does not exist",
                remedy=guess + f"there are {', '.join(sorted(known)) or 'none'}",
            )
    if stage.planet.type != "external":
        report.problem((*at, "planet", "type"), "is internal", limit="external", remedy="remove type")
    if stage.motion == "torsion" and stage.bearing is not None:
        report.problem(
            (*at, "bearing"),
            "has no effect: planets with motion: torsion cannot move on their pins",
            remedy="give motion: planar or motion: free, or remove bearing",
        )
    for key in ("pin_errors", "single_planets"):
        for planet in getattr(stage, key):
            if planet not in stage.names:
                report.problem(
                    (*at, key, planet),
                    "is not a planet of the stage",
                    remedy=did_you_mean(planet, stage.names) + f"its planets are {', '.join(stage.names)}",
                )
    return len(report.problems) == before and at not in report.tainted


def _add(parts: Parts, name: str, stage: PlanetaryStage, report: Reader) -> bool:
    """Add the components of the planets of one stage; False if their names are taken."""
    at: Place = (SECTION, name)
    taken = {
        (group, word) for group, word, _, _ in members(name, stage) if word in parts.known(group)
    }  # reported once for each name
    for group, word in sorted(taken):
        report.problem(
            at,
            f"needs the name {word}, which {group}.{word} has already",
            remedy="rename that component, or give the stage another planet_name",
        )
    if taken:
        return False
    for group, word, part, _ in members(name, stage):
        parts.section(group)[word] = part
        parts.names[group] = parts.known(group) | {word}
    report.aliases |= places_in_file(name, stage)
    return True


def places_in_file(name: str, stage: PlanetaryStage) -> dict[Place, Place]:
    """Paths in the file that describe the components of the planets: SECTION, NAME or SECTION, NAME, KEY."""
    at: Place = (SECTION, name)
    found: dict[Place, Place] = {}
    for group, word, _, key in members(name, stage):
        found[group, word] = (*at, key) if key else at
        if group == "meshes":
            found[group, word, "gears"] = at
            found[group, word, "center_distance"] = (*at, "center_distance")
        elif group == "bearings":
            found |= {(group, word, "body"): at, (group, word, "housing"): (*at, "carrier")}
        elif group == "joints":
            found[group, word, "position"] = (*at, "carrier")
    for planet, own in stage.single_planets.items():
        place: Place = (*at, "single_planets", planet)
        for key in ("modifications", "deviations", "tooth_thickness_allowance"):
            if getattr(own, key) is not None:
                found["gears", planet, key] = (*place, key)
        found |= {("gears", planet, "faults", fault): (*place, "faults", fault) for fault in own.faults}
        for side, mesh in _meshes_of(stage, planet).items():
            found |= {("meshes", mesh, key): (*place, side, key) for key in getattr(own, side).given}
    return found


def _meshes_of(stage: PlanetaryStage, planet: str) -> dict[str, str]:
    """Meshes of one planet, by the key of the stage that describes them."""
    sides = {"sun_mesh": stage.sun_meshes(), "ring_mesh": stage.ring_meshes()}
    if planet not in stage.names:
        return {}
    return {side: meshes[stage.names.index(planet)] for side, meshes in sides.items() if meshes}


def lines_of_planets(
    stages: Mapping[str, PlanetaryStage], lines: Mapping[Place, int]
) -> Iterator[tuple[Place, int]]:
    """Components of the planets with the lines of the keys that describe them, or of their stages."""
    for name, stage in stages.items():
        for place, key in places_in_file(name, stage).items():
            known = [line for n in range(len(key), 1, -1) if (line := lines.get(key[:n])) is not None]
            if known:
                yield place, known[0]


def at_stages(model: Any, messages: Iterable[Message]) -> tuple[Message, ...]:
    """Messages on components of planets and free halves at the keys that describe them, equal ones once.

    Parameters
    ----------
    model
        The model.
    messages
        Messages with paths of the components.
    """
    places = {
        dotted(p): dotted(q)
        for n, s in model.planetary_stages.items()
        for p, q in places_in_file(n, s).items()
    }
    for name, scissor in model.scissor_gears.items():
        places |= {dotted(p): dotted(q) for p, q in places_of_free_half(model, name, scissor).items()}
    if not places:
        return tuple(messages)
    found = []
    for message in messages:
        whole = message.where
        while whole and whole not in places:
            whole = whole.rpartition(".")[0]
        found.append(message.changed(where=places[whole] + message.where[len(whole) :]) if whole else message)
    # numbers of the planets differ by their pin errors
    return told_once(model.planetary_stages, found, lambda each: f"{each.where} {each.value} {each.text}")


def told_once(
    stages: Mapping[str, PlanetaryStage],
    messages: Iterable[Message],
    same: Callable[[Message], str] = str,
) -> tuple[Message, ...]:
    """Messages without those that differ from an earlier one only in the number of the planet.

    `same` gives the text that is compared.
    """
    planets = [re.escape(planet) for stage in stages.values() for planet in stage.names]
    if not planets:
        return tuple(messages)
    numbered = re.compile(rf"\b({'|'.join(planets)})\b")
    found: dict[str, Message] = {}
    for message in messages:
        found.setdefault(numbered.sub("planet", same(message)), message)
    return tuple(found.values())


def members(name: str, stage: PlanetaryStage) -> Iterator[tuple[str, str, Any, str]]:
    """Components of the planets: section, name, component, and key of the stage that describes it."""
    for planet in stage.names:
        yield "gears", planet, _gear(name, stage, planet), "planet"
        yield "bodies", planet, _body(name, stage, planet), ""
        pin = Joint(type=JOINTS[stage.motion], bodies=(stage.carrier, planet), stage=name)
        yield "joints", f"{planet}-pin", pin, ""
        if stage.bearing is not None:
            bearing = Bearing(
                body=planet,
                housing=stage.carrier,
                stiffness=stage.bearing.on_pin(),
                damping=stage.bearing.damping,
                stage=name,
            )
            yield "bearings", f"{planet}-bearing", bearing, "bearing"
    common = {"center_distance": stage.center_distance, "stage": name}
    own = {planet: stage.single_planets.get(planet, SinglePlanet()) for planet in stage.names}
    for planet, mesh in zip(stage.names, stage.sun_meshes(), strict=False):
        gears = (str(stage.sun), planet)
        yield "meshes", mesh, stage.sun_mesh.between(gears, own[planet].sun_mesh, **common), "sun_mesh"
    for planet, mesh in zip(stage.names, stage.ring_meshes(), strict=False):
        gears = (planet, str(stage.ring))
        yield "meshes", mesh, stage.ring_mesh.between(gears, own[planet].ring_mesh, **common), "ring_mesh"


def _gear(name: str, stage: PlanetaryStage, planet: str) -> Gear:
    """Gear of one planet."""
    own = stage.single_planets.get(planet)
    changes: dict[str, Any] = {"stage": name}
    if own is not None:
        given = {key: getattr(own, key) for key in ("modifications", "deviations")}
        given["tooth_thickness_allowance"] = own.tooth_thickness_allowance
        changes |= {key: value for key, value in given.items() if value is not None}
        changes |= {"faults": {**stage.planet.faults, **own.faults}} if own.faults else {}
    return replace(stage.planet, **changes)


def _body(name: str, stage: PlanetaryStage, planet: str) -> Body:
    """Body of one planet; its place follows from the stage."""
    return Body(
        gears={planet: 0.0},
        mass=stage.planet_mass,
        inertia=stage.planet_inertia,
        transverse_inertia=stage.planet_transverse_inertia,
        stage=name,
    )


# --- places -------------------------------------------------------------------------------------------------
def central_bodies(parts: Any, stage: PlanetaryStage) -> list[tuple[str, float]]:
    """Bodies of sun and ring, and axial positions of the gears on them [m]."""
    found = []
    for gear in (stage.sun, stage.ring):
        body = None if gear is None else parts.body_of(gear)
        if body is not None and body in parts.bodies:
            found.append((body, parts.bodies[body].gears[gear]))
    return found


def axis_bodies(parts: Any, stage: PlanetaryStage) -> list[str]:
    """Bodies on the axis of a stage: those of sun and ring, and the carrier."""
    return [*(body for body, _ in central_bodies(parts, stage)), stage.carrier]


def orient_pins(parts: Parts) -> None:
    """Give the pins of the planets the axes of their bodies."""
    for name, joint in parts.joints.items():
        if joint.stage is not None and joint.bodies[1] in parts.bodies:
            parts.joints[name] = replace(joint, axes=parts.bodies[joint.bodies[1]].orientation)


def nominal_distance(parts: Any, stage: PlanetaryStage) -> float | None:
    """Distance of the pins from the axis without pin errors [m]; None if its meshes are not valid."""
    for name in (*stage.sun_meshes(), *stage.ring_meshes()):
        if name in parts.meshes and (a := parts.meshes[name].a_w) is not None:
            return abs(a)
    return None


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
            _put(parts, planet, origin + axes @ np.array((x, y, 0.0)))


def _centre(
    parts: Parts, seats: list[tuple[str, float]], stage: PlanetaryStage
) -> tuple[Array, Array] | None:
    """Middle of the gears on the axis of a stage [m] and its axes; None if its place is unknown."""
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
