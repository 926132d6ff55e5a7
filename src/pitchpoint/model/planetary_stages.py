# SPDX-License-Identifier: Apache-2.0
"""Planetary stages: representation as the gears, bodies, pins, bearings and meshes of their planets.

Every planet is a gear and a body of the same name on a joint of the carrier. Its place is on the circle of
the pins, moved by the error of its pin; the distances of the places are the centre distances of its meshes.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import Message
from pitchpoint.model.components.bearing import Bearing
from pitchpoint.model.components.body import Body
from pitchpoint.model.components.joint import Joint
from pitchpoint.model.components.planetary_stage import (
    JOINTS,
    PlanetaryStage,
    SinglePlanet,
    SingleStep,
    Wheel,
    names_of,
)
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.scissor_gears import places_of_free_half
from pitchpoint.model.show import dotted
from pitchpoint.model.stage_members import SECTION, fit_together

if TYPE_CHECKING:
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.parts import Parts

GROUPS = ("gears", "bodies", "joints", "bearings", "meshes")
"""Sections of the components of a stage."""
MATES = ("sun", "ring", "inner_planets", "steps", "planet_name")
"""Keys that give the names of the meshes."""
MOST = 50
"""Maximum number of planets of a stage."""


# --- representation -----------------------------------------------------------------------------------------
def add_planetary_stages(parts: Parts, report: Reader) -> None:
    """Check the references of the stages and add the components of their planets.

    Later problems of these components are reported for the stages.
    """
    for name in parts.known(SECTION) - set(parts.planetary_stages):
        planets = names_of(parts.planet_names.get(name, "planet"), MOST)  # their number is unknown
        _assume(parts, planets, report)
        report.tainted.add((SECTION, name))
    for name, stage in parts.planetary_stages.items():
        if not (fit_together(parts, name, stage, report) and _add(parts, name, stage, report)):
            if not stage.names or any((SECTION, name, key) in report.tainted for key in MATES):
                count = len(stage.names) or MOST
                _assume(parts, (*names_of(stage.planet_name, count), *names_of("planet", count)), report)
            for group, word, _, _ in members(name, stage):  # known, though without data
                parts.names[group] = parts.known(group) | {word}
                report.tainted.add((group,))


def _assume(parts: Parts, planets: tuple[str, ...], report: Reader) -> None:
    """Make the components of planets known that cannot be added, with any gear as their mate."""
    pairs = [(one, two) for one in parts.known("gears") for two in planets]
    meshes = [f"{one}-{two}" for each in pairs for one, two in (each, each[::-1])]
    others = {"joints": [f"{n}-pin" for n in planets], "bearings": [f"{n}-bearing" for n in planets]}
    for group, added in {"gears": planets, "bodies": planets, "meshes": meshes, **others}.items():
        parts.names[group] = parts.known(group) | set(added)
        report.tainted.add((group,))


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
        found[group, word] = (*at, *key)
        if group == "meshes":
            found[group, word, "gears"] = at
            apart = "planet_center_distance" if key[-1] == "planet_mesh" else "center_distance"
            found[group, word, "center_distance"] = (*at, apart)
        elif group == "bearings":
            found |= {(group, word, "body"): at, (group, word, "housing"): (*at, "carrier")}
        elif group == "joints":
            found[group, word, "position"] = (*at, "carrier")
    for planet in stage.single_planets.keys() & set(stage.names):
        for wheel in stage.wheels:
            own = single_step(stage, planet, wheel.step)
            place: Place = (*at, "single_planets", planet, *wheel.key)
            gear = wheel.of(planet)
            for word in ("modifications", "deviations", "tooth_thickness_allowance"):
                if getattr(own, word) is not None:
                    found["gears", gear, word] = (*place, word)
            found |= {("gears", gear, "faults", fault): (*place, "faults", fault) for fault in own.faults}
    for mesh_group in stage.groups:
        side = f"{mesh_group.side}_mesh"
        for planet, mesh in zip(stage.names, mesh_group.names, strict=True):
            given = getattr(single_step(stage, planet, mesh_group.wheel.step), side).given
            base: Place = (*at, "single_planets", planet, *mesh_group.wheel.key, side)
            found |= {("meshes", mesh, word): (*base, word) for word in given}
    return found


def place_of_gear(model: Any, gear: str) -> tuple[str, ...]:
    """Path of a gear in the file: of planets that of the single planet."""
    for name, stage in model.planetary_stages.items():
        for wheel in stage.wheels:
            for planet in stage.names:
                if wheel.of(planet) == gear:
                    return (SECTION, name, "single_planets", planet, *map(str, wheel.key))
    return ("gears", gear)


def single_step(stage: PlanetaryStage, planet: str, step: str) -> SingleStep:
    """Data of one planet, or of one of its steps, that replace the common ones."""
    own = stage.single_planets.get(planet, SinglePlanet())
    return own.steps.get(step, SingleStep()) if step else own


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
    """Messages on planets, free halves and mounts at the keys that describe them, equal ones once.

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
    for mount in getattr(model.housing, "mounts", {}):
        places[f"bushings.housing-{mount}"] = f"housing.mounts.{mount}"
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


def members(name: str, stage: PlanetaryStage) -> Iterator[tuple[str, str, Any, tuple[str, ...]]]:
    """Components of the planets: section, name, component, and keys of the stage that describe it."""
    for planet, seat in zip(stage.names, stage.seats, strict=True):
        for wheel in stage.wheels:
            key = (*wheel.key, "gear") if wheel.step else ("planet",)
            yield "gears", wheel.of(planet), _gear(name, stage, planet, wheel), key
        yield "bodies", planet, _body(name, stage, planet), ()
        pin = Joint(type=JOINTS[stage.motion], bodies=(seat, planet), stage=name)
        yield "joints", f"{planet}-pin", pin, ()
        if stage.bearing is not None:
            bearing = Bearing(
                body=planet,
                position=(0.0, 0.0, stage.bearing.position),
                housing=seat,
                stiffness=stage.bearing.on_pin(),
                damping=stage.bearing.damping,
                stage=name,
            )
            yield "bearings", f"{planet}-bearing", bearing, ("bearing",)
    for group in stage.groups:
        apart = stage.planet_center_distance if group.side == "planet" else stage.center_distance
        settings = group.wheel.settings[group.side]
        for planet, mesh, gears in zip(stage.names, group.names, group.gears, strict=True):
            own = getattr(single_step(stage, planet, group.wheel.step), f"{group.side}_mesh")
            part = settings.between(gears, own, center_distance=apart, stage=name)
            yield "meshes", mesh, part, group.key


def _gear(name: str, stage: PlanetaryStage, planet: str, wheel: Wheel) -> Gear:
    """One gear of one planet."""
    own = single_step(stage, planet, wheel.step)
    given = {key: getattr(own, key) for key in ("modifications", "deviations", "tooth_thickness_allowance")}
    changes: dict[str, Any] = {"stage": name}
    changes |= {key: value for key, value in given.items() if value is not None}
    changes |= {"faults": {**wheel.gear.faults, **own.faults}} if own.faults else {}
    if wheel.step and planet == stage.names[0]:  # the others follow from their meshes, as they are equal
        angle = stage.steps[wheel.step].orientation
        changes["aligned"] = None if angle is None else (planet, angle)
    return replace(wheel.gear, **changes)


def _body(name: str, stage: PlanetaryStage, planet: str) -> Body:
    """Body of one planet; its place follows from the stage."""
    return Body(
        gears={wheel.of(planet): wheel.position for wheel in stage.wheels},
        mass=stage.planet_mass,
        inertia=stage.planet_inertia,
        transverse_inertia=stage.planet_transverse_inertia,
        stage=name,
    )
