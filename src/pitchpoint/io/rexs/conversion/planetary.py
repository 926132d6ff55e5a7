# SPDX-License-Identifier: Apache-2.0
"""Planetary stages: circles of equal planets on the pins of a carrier, with suns, rings and inner planets."""

from __future__ import annotations

import math
from typing import Any

from pitchpoint.io.rexs.conversion.carriers import convert_carrier
from pitchpoint.io.rexs.conversion.gears import add_material, gear_data
from pitchpoint.io.rexs.conversion.hubs import shaft_of
from pitchpoint.io.rexs.conversion.meshes import MESH_DAMPING, backlash_of, seat_gear
from pitchpoint.io.rexs.conversion.planet_bearings import convert_planet_bearings
from pitchpoint.io.rexs.conversion.planets import (
    EQUAL,
    Circle,
    Mate,
    check_equal,
    circles_of,
    fitting_angles,
    places_on_turn,
    planet_shafts,
    settle_places,
)
from pitchpoint.io.rexs.conversion.shafts import sections_of
from pitchpoint.io.rexs.conversion.state import Conversion, Meshing, Seat, q
from pitchpoint.io.rexs.document import RexsComponent

LETTERS = "abcdefghijklmnopqrstuvwxyz"
"""Names of the planets of several circles: planet_a_1, planet_b_1."""


def convert_carriers(conversion: Conversion) -> dict[int, str]:
    """Add the carriers of all planetary stages; their names by the id of the stage."""
    found = {}
    for stage in conversion.source.of_type("planetary_stage"):
        conversion.done.update(shaft.id for shaft in planet_shafts(conversion, stage))
        name = convert_carrier(conversion, stage)
        if name is not None:
            found[stage.id] = name
    return found


def convert_planetary_stage(conversion: Conversion, stage: RexsComponent, carrier: str) -> None:
    """Add a planetary stage: an entry of the model file for each circle of planets."""
    before = len(conversion.problems)
    conversion.done.add(stage.id)
    circles = circles_of(conversion, stage)
    central = [m for c in circles for mates in c.mates for m in mates if m.side != "planet"]
    for mate in central:
        if mate.gear.id not in conversion.done:
            seat_gear(conversion, mate.gear)
    for mate in central:
        if conversion.names.get(mate.gear.id) not in conversion.data.get("gears", {}):
            conversion.problem(mate.gear, "is on no shaft of the model", remedy="correct its relations")
    if len(conversion.problems) > before or not central:
        return
    owner = shaft_of(conversion, central[0].gear)
    axis = None if owner is None else conversion.seats.get(owner.id)
    if axis is None or not settle_places(conversion, circles, axis):
        return
    name = conversion.name(stage)
    several = len(circles) > 1 or len(conversion.source.of_type("planetary_stage")) > 1
    for k, circle in enumerate(circles):
        circle.name = name if k == 0 else conversion.free(f"{name}_{k + 1}")
        number = len(conversion.data.get("planetary_stages", {})) + k
        other = f"planet_{LETTERS[number % len(LETTERS)]}" if several else "planet"
        circle.planet_name = _stem(conversion, circle) or other
    data: dict[int, dict[str, Any]] = {}
    for circle in circles:
        _convert_circle(conversion, stage, circle, (carrier, axis), data)
        if len(conversion.problems) > before:
            return


def _stem(conversion: Conversion, circle: Circle) -> str:
    """Common beginning of the names of planets in files of pitchpoint; else empty."""
    names = [planet.shaft.name for planet in circle.planets]
    stem = names[0].removesuffix("_1")
    numbered = [f"{stem}_{k}" for k in range(1, len(names) + 1)]
    return stem if conversion.own and sorted(names) == sorted(numbered) else ""


def _convert_circle(
    conversion: Conversion,
    stage: RexsComponent,
    circle: Circle,
    seat: tuple[str, Seat],
    data: dict[int, dict[str, Any]],
) -> None:
    """Add one circle of planets.

    Parameters
    ----------
    conversion, stage, circle
        The conversion, the planetary stage and the circle.
    seat
        Name of the carrier, and seat of the shaft on the axis.
    data
        Data of the gears of the first planets by their ids, to which those of this circle are added.
    """
    carrier, axis = seat
    path = f"planetary_stages.{circle.name}"
    first, main = circle.planets[0], circle.order[0]
    for k in circle.order:
        gear, at = first.gears[k], f"{path}.{'planet' if k == main else f'steps.step_{k + 1}.gear'}"
        found = gear_data(conversion, gear, at)
        if found is None:
            return
        add_material(conversion, gear, at, found)
        _bore(conversion, first.shaft, gear, at, found)
        data[gear.id] = found
        conversion.done.add(gear.id)
    check_equal(conversion, circle.planets)
    fitted = len(circle.order) > 1 and fitting_angles(circle, places_on_turn(circle, False)) is None
    angles = fitting_angles(circle, places_on_turn(circle, fitted))
    angles = [planet.angle for planet in circle.planets] if angles is None else angles
    values: dict[str, Any] = {}
    _add_mates(conversion, circle, main, values, data)
    values |= {"carrier": carrier, "planet": data[first.gears[main].id]}
    if circle.inner is None:
        values["angles"] = [q(angle, "angle") for angle in angles]
    else:
        values["planets"] = len(circle.planets)
        _by_inner(conversion, stage, circle, values)
    values["center_distance"] = q(circle.distance, "length")
    if circle.planet_name != "planet":
        values["planet_name"] = circle.planet_name
    _add_position(conversion, circle, axis, values)
    _add_pin_errors(conversion, circle, angles, values)
    _add_steps(conversion, circle, fitted, values, data)
    convert_planet_bearings(conversion, stage, circle, carrier, values)
    conversion.put("planetary_stages", stage, values, circle.name)


def _add_mates(
    conversion: Conversion,
    circle: Circle,
    wheel: int,
    values: dict[str, Any],
    data: dict[int, dict[str, Any]],
) -> None:
    """Add sun, ring and inner planets of a gear of the planets, with the settings of the meshes."""
    own = circle.planets[0].gears[wheel]
    for mate in sorted(circle.mates[wheel], key=lambda m: ("sun", "ring", "planet").index(m.side)):
        key = "inner_planets" if mate.side == "planet" else mate.side
        inner = circle.inner if mate.side == "planet" else None
        values[key] = conversion.names.get(mate.gear.id) if inner is None else inner.planet_name
        distance = _distance_of(circle, inner)
        _check_distances(conversion, circle, mate, distance)
        mesh, gears = _first(mate, own)
        entries = [
            data[g.id] if g.id in data else conversion.data["gears"][conversion.names[g.id]] for g in gears
        ]
        conversion.meshings.append(Meshing(mesh, gears, entries, distance))
        target = f"planetary_stages.{circle.name}.{mate.side}_mesh"
        values[f"{mate.side}_mesh"] = {
            "damping": {"ratio": MESH_DAMPING},
            "backlash": backlash_of(conversion, mesh, f"{target}.backlash"),
        }
        text = f"ratio {MESH_DAMPING}"
        conversion.default(mesh, "damping", text, f"{target}.damping", "REXS has no damping")
        conversion.default(mesh, "mesh stiffness", "law din3990", f"{target}.stiffness", "by geometry")


def _first(mate: Mate, own: RexsComponent) -> tuple[RexsComponent, list[RexsComponent]]:
    """Mesh of a gear of the first planet with a mate."""
    return next(((m, pair) for m, pair in mate.meshes if own in pair), mate.meshes[0])


def _distance_of(circle: Circle, inner: Circle | None) -> float:
    """Distance of the pins from the axis, or between the first planets of two circles [m]."""
    if inner is None:
        return circle.distance
    one, two = circle.planets[0], inner.planets[0]
    angle = one.angle - two.angle
    return math.sqrt(one.distance**2 + two.distance**2 - 2.0 * one.distance * two.distance * math.cos(angle))


def _check_distances(conversion: Conversion, circle: Circle, mate: Mate, distance: float) -> None:
    """Check that the centre distances of the meshes with a mate are those of the planets."""
    own = {gear.id: planet for planet in circle.planets for gear in planet.gears}
    for mesh, pair in mate.meshes:
        given = conversion.number(mesh, "center_distance", f"planetary_stages.{circle.name}.center_distance")
        planet = next(own[gear.id] for gear in pair if gear.id in own)
        right = distance if mate.side == "planet" else planet.distance
        if given is not None and abs(abs(given) - right) > EQUAL:
            what = "of two planets" if mate.side == "planet" else f"of {planet.shaft} from the axis"
            conversion.problem(
                mesh,
                f"differs from the distance {what}",
                "center_distance",
                f"{1e3 * given:.6g} mm",
                f"{1e3 * right:.6g} mm by support_vector",
                "correct one of the two",
            )


def _by_inner(conversion: Conversion, stage: RexsComponent, circle: Circle, values: dict[str, Any]) -> None:
    """Add the place of planets next to their inner planets, which is the same for all of them."""
    inner = circle.inner
    assert inner is not None
    leads = [
        math.remainder(outer.angle - one.angle, math.tau)
        for outer, one in zip(circle.planets, inner.planets, strict=True)
    ]
    values["planet_center_distance"] = q(_distance_of(circle, inner), "length")
    if leads[0] < 0.0:
        values["planet_side"] = "clockwise"
    for lead, planet in zip(leads, circle.planets, strict=True):
        if abs(math.remainder(lead - leads[0], math.tau)) * planet.distance > EQUAL:
            conversion.problem(
                planet.shaft,
                "is at another angle from its inner planet than the first one",
                "support_vector",
                f"{math.degrees(lead):.6g} deg",
                f"{math.degrees(leads[0]):.6g} deg",
                "planets of a stage are equal",
            )


def _add_position(conversion: Conversion, circle: Circle, axis: Seat, values: dict[str, Any]) -> None:
    """Add the axial position of the planets from the mid-face of their sun or ring."""
    main = circle.order[0]
    order = {"sun": 0, "ring": 1}
    central = sorted((m for m in circle.mates[main] if m.side in order), key=lambda m: order[m.side])
    if not central:
        return
    gear = central[0].gear
    shaft = shaft_of(conversion, gear)
    u = conversion.number(gear, "u_coordinate_on_shaft")
    seat = None if shaft is None else conversion.seats.get(shaft.id)
    if seat is None or u is None:
        return
    middle = float((seat.point(u) - axis.frame.origin) @ axis.frame.z)
    offset = circle.planets[0].middle(main) - middle
    if abs(offset) > EQUAL:
        values["position"] = q(offset, "length")


def _add_pin_errors(
    conversion: Conversion, circle: Circle, angles: list[float], values: dict[str, Any]
) -> None:
    """Add the errors of pins that are not at the distance of the others or not at a fitting angle."""
    nominal = circle.distance
    errors = {}
    for k, (planet, angle) in enumerate(zip(circle.planets, angles, strict=True)):
        off = math.remainder(planet.angle - angle, math.tau)
        found = {
            "tangential": planet.distance * math.sin(off),
            "radial": planet.distance * math.cos(off) - nominal,
        }
        given = {key: q(value, "length") for key, value in found.items() if abs(value) > EQUAL}
        if given:
            name = f"{circle.planet_name}_{k + 1}"
            errors[name] = given
            target = f"planetary_stages.{circle.name}.pin_errors.{name}"
            text = ", ".join(f"{key} {value}" for key, value in given.items())
            reason = f"from the place at {1e3 * nominal:.6g} mm and {math.degrees(angle):.6g} deg"
            conversion.changed(planet.shaft, "support_vector", text, target, reason)
    if errors:
        values["pin_errors"] = errors


def _add_steps(
    conversion: Conversion,
    circle: Circle,
    fitted: bool,
    values: dict[str, Any],
    data: dict[int, dict[str, Any]],
) -> None:
    """Add the further gears of stepped planets."""
    main, *others = circle.order
    if not others:
        return
    first = circle.planets[0]
    steps = {}
    for k in others:
        step: dict[str, Any] = {}
        _add_mates(conversion, circle, k, step, data)
        step["gear"] = data[first.gears[k].id]
        step["position"] = q(first.middle(k) - first.middle(main), "length")
        name = f"step_{k + 1}"
        if fitted:
            step["fitted"] = True
            target = f"planetary_stages.{circle.name}.steps.{name}.fitted"
            text = "equal planets do not fit at these angles: the teeth of each are oriented at its assembly"
            conversion.changed(first.gears[k], "w_axis_vector", "true", target, text)
        steps[name] = step
    values["steps"] = steps


def _bore(
    conversion: Conversion, shaft: RexsComponent, gear: RexsComponent, path: str, data: dict[str, Any]
) -> None:
    """Bore of the planets: that of their shafts, whose mass is then part of the gear."""
    sections = sections_of(conversion, shaft)
    inner = max((bore for *_, bore in sections), default=0.0)
    if "bore_diameter" not in data and inner > 0.0:
        data["bore_diameter"] = q(inner, "length")
        reason = "bore of the planet shaft, whose mass is part of the gear"
        conversion.default(gear, "inner_diameter", str(q(inner, "length")), f"{path}.bore_diameter", reason)
