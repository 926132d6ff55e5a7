# SPDX-License-Identifier: Apache-2.0
"""Checks of the members of planetary stages: suns, rings, carriers and inner planets exist and fit."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pitchpoint.core.nearest import did_you_mean
from pitchpoint.model.components.planetary_stage import PlanetaryStage, Wheel, names_of
from pitchpoint.model.keys import Place
from pitchpoint.model.parts import carriers_of
from pitchpoint.model.reading.names import USABLE, is_usable
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.show import dotted

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts

SECTION = "planetary_stages"


def fit_together(parts: Parts, name: str, stage: PlanetaryStage, report: Reader) -> bool:
    """Check names and types of the members of a stage; False with any problem."""
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
    _planet_name(parts, name, stage, report)
    if not parts.has("bodies", stage.carrier):
        known = parts.known("bodies") | parts.known("shafts") | parts.known("elastic_bodies")
        if stage.carrier not in known:
            guess = did_you_mean(stage.carrier, known)
            report.problem(
                (*at, "carrier"),
                f"names the body {stage.carrier[:40]!r}, which does not exist",
                remedy=guess + f"there are {', '.join(sorted(known)) or 'none'}",
            )
    owners = _owners(parts)
    for side, mate in ((side, mate) for wheel in stage.wheels for side, mate in wheel.mates.items()):
        if side != "planet" and owners.get(mate) == stage.carrier:
            report.problem(
                (*at, "carrier"),
                f"names {stage.carrier}, the body of the {side}, which would lock the planets",
                limit="a body without the sun and ring of the stage",
                remedy="name the body with the pins of the planets",
            )
    for wheel in stage.wheels:
        if wheel.gear.type != "external":
            path = (*wheel.key, "gear") if wheel.step else ("planet",)
            report.problem((*at, *path, "type"), "is internal", limit="external", remedy="remove type")
    readable = (*at, "motion") not in report.tainted
    if stage.motion == "torsion" and stage.bearing is not None and readable:
        report.problem(
            (*at, "bearing"),
            "has no effect: planets with motion: torsion cannot move on their pins",
            remedy="give motion: planar or motion: free, or remove bearing",
        )
    for key in ("pin_errors", "single_planets"):
        for planet in getattr(stage, key):
            if planet not in stage.names and stage.names and (*at, "planet_name") not in report.tainted:
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
    return len(report.problems) == before and at not in report.tainted and bool(stage.names)


def _owners(parts: Parts) -> dict[str, str]:
    """Body or shaft of every gear."""
    shafts = {gear: name for name, shaft in parts.shafts.items() for gear in shaft.gears}
    return {**carriers_of(parts.bodies), **shafts}


def _planet_name(parts: Parts, name: str, stage: PlanetaryStage, report: Reader) -> None:
    """Check that names of the planets are usable, and not those of another stage."""
    at: Place = (SECTION, name, "planet_name")
    if not is_usable(stage.planet_name):
        report.problem(at, "is not a usable name", value=repr(stage.planet_name[:40]), remedy=USABLE)
    for other, earlier in parts.planetary_stages.items():
        if other == name:
            return
        if earlier.planet_name == stage.planet_name and (*at[:2], "inner_planets") not in report.tainted:
            report.problem(
                at,
                f"is also the planet_name of {other}",
                value=stage.planet_name,
                remedy=f"give the planets of {name} another planet_name, such as {name}_planet",
            )
            return


def _mates(parts: Parts, at: Place, stage: PlanetaryStage, report: Reader) -> None:
    """Check names and types of sun, ring and inner planets of every gear of the planets."""
    taken: dict[str, Place] = {}
    inner = 0
    for wheel in stage.wheels:
        if _exchanged(parts, at, wheel, report):
            continue
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


def _exchanged(parts: Parts, at: Place, wheel: Wheel, report: Reader) -> bool:
    """Whether the ring is named as sun and the sun as ring; reported once."""
    found = [parts.gears.get(wheel.mates.get(side, "")) for side in ("sun", "ring")]
    types = [gear and gear.type for gear in found]
    if types != ["internal", "external"]:
        return False
    report.problem(
        (*at, *wheel.key, "sun"),
        f"names the internal gear {wheel.mates['sun']}, and ring the external gear {wheel.mates['ring']}",
        limit="an external gear",
        remedy="exchange sun and ring",
    )
    return True


def _central(parts: Parts, key: Place, gear: str, kind: str, report: Reader) -> None:
    """Check that a sun or ring exists, with teeth of its type."""
    if not parts.has("gears", gear):
        guess = did_you_mean(gear, parts.known("gears"))
        have = f"there are {', '.join(sorted(parts.known('gears'))) or 'none'}"
        report.problem(key, f"names the gear {gear[:40]!r}, which does not exist", remedy=guess + have)
    elif ("gears", gear, "type") in report.tainted:
        return
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
