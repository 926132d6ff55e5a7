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
from pitchpoint.core.nearest import did_you_mean
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
    for wheel in stage.wheels:
        if wheel.step and not wheel.mates:
            report.problem(
                (*at, *wheel.key),
                "has no mate",
                remedy="give sun, ring or inner_planets that it meshes with",
            )
    if not any(side != "planet" for wheel in stage.wheels for side in wheel.mates):
        report.problem(at, "has neither sun nor ring", remedy="name the gear that the planets mesh with")
    _mates(parts, at, stage, report)
    if not parts.has("bodies", stage.carrier):
        known = parts.known("bodies") | parts.known("shafts") | parts.known("elastic_bodies")
        if stage.carrier not in known:
            guess = did_you_mean(stage.carrier, known)
            report.problem(
                (*at, "carrier"),
                f"names the body {stage.carrier[:40]!r}, which does not exist",
                remedy=guess + f"there are {', '.join(sorted(known)) or 'none'}",
            )
    for wheel in stage.wheels:
        if wheel.gear.type != "external":
            path = (*wheel.key, "gear") if wheel.step else ("planet",)
            report.problem((*at, *path, "type"), "is internal", limit="external", remedy="remove type")
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
    for name_of_step, step_part in stage.steps.items():
        if step_part.orientation is not None and step_part.gear.initial_angle is not None:
            report.problem(
                (*at, "steps", name_of_step, "orientation"),
                "is given twice: the gear has an initial_angle",
                remedy="remove one of them",
            )
    for planet, own in stage.single_planets.items():
        for step in own.steps.keys() - stage.steps.keys():
            report.problem(
                (*at, "single_planets", planet, "steps", step),
                "is not a step of the planets",
                remedy=did_you_mean(step, stage.steps) + f"there are {', '.join(stage.steps) or 'none'}",
            )
    return len(report.problems) == before and at not in report.tainted


def _mates(parts: Parts, at: Place, stage: PlanetaryStage, report: Reader) -> None:
    """Check names and types of sun, ring and inner planets of every gear of the planets."""
    taken: dict[str, Place] = {}
    inner = 0
    for wheel in stage.wheels:
        for side, mate in wheel.mates.items():
            key: Place = (*at, *wheel.key, "inner_planets" if side == "planet" else side)
            if mate in taken:
                report.problem(
                    key, f"names {mate}, as does {dotted(taken[mate])}", remedy="remove it from one of them"
                )
                continue
            taken[mate] = key
            if side == "planet":
                inner += 1
                _inner(parts, key, stage, mate, inner, report)
            else:
                _central(parts, key, mate, "external" if side == "sun" else "internal", report)


def _central(parts: Parts, key: Place, gear: str, kind: str, report: Reader) -> None:
    """Check that a sun or ring exists, with teeth of its type."""
    if not parts.has("gears", gear):
        guess = did_you_mean(gear, parts.known("gears"))
        have = f"there are {', '.join(sorted(parts.known('gears'))) or 'none'}"
        report.problem(key, f"names the gear {gear[:40]!r}, which does not exist", remedy=guess + have)
    elif gear in parts.gears and parts.gears[gear].type != kind:
        report.problem(
            key,
            f"names the {parts.gears[gear].type} gear {gear}",
            limit=f"an {kind} gear",
            remedy=f"name an {kind} gear, or give {gear} type: {kind}",
        )


def _inner(parts: Parts, key: Place, stage: PlanetaryStage, mate: str, count: int, report: Reader) -> None:
    """Check that inner planets are those of another stage, as many, on the same carrier."""
    others = {s.planet_name: s for s in parts.planetary_stages.values() if s is not stage}
    other = others.get(mate)
    unread = len(parts.planetary_stages) < len(parts.known(SECTION))
    if (other is None and unread) or (other is not None and not other.names):
        # of a stage that could not be read, or without a number of planets: reported there
        parts.names["gears"] = parts.known("gears") | set(names_of(mate, len(stage.names)))
        return
    if mate == stage.planet_name:
        report.problem(
            key,
            f"names its own planets, {mate}",
            remedy="give the stages different planet_name, and name that of the other one",
        )
    elif count > 1:
        report.problem(key, "is the second of the planets", limit="1", remedy="remove one inner_planets")
    elif other is None:
        report.problem(
            key,
            f"names the planets {mate[:40]!r}, which do not exist",
            remedy=did_you_mean(mate, others)
            + f"planet_name of other stages: {', '.join(others) or 'there is no other stage'}",
        )
    elif stage.names and len(other.names) != len(stage.names):
        report.problem(
            key,
            f"names {len(other.names)} planets for {len(stage.names)} planets",
            remedy="give both stages the same number of planets",
        )
    elif other.carrier != stage.carrier:
        report.problem(
            key,
            f"names planets on {other.carrier}",
            limit=f"planets on the same carrier, {stage.carrier}",
            remedy="give both stages the same carrier",
        )
    elif stage.planet_name in inner_chain(parts, stage):
        report.problem(
            key,
            "is a loop: each stage has the planets of the other as inner_planets",
            remedy="remove inner_planets from one of them",
        )


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


def inner_chain(parts: Any, stage: PlanetaryStage) -> list[str]:
    """Names of the inner planets of a stage, of theirs, and so on."""
    by_planets = {s.planet_name: s for s in parts.planetary_stages.values()}
    found: list[str] = []
    here: PlanetaryStage | None = stage
    while here is not None:
        mate = next((w.mates["planet"] for w in here.wheels if "planet" in w.mates), None)
        if mate is None or mate in found:
            break
        found.append(mate)
        here = by_planets.get(mate)
    return found


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
