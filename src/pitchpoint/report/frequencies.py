# SPDX-License-Identifier: Apache-2.0
"""Kinematic frequencies of a model: shafts, meshes, tooth contacts, planetary gear sets, rolling bearings.

Frequencies are in Hz, speeds in rad/s relative to the inertial frame; the formulas are in `analysis`.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.core.nearest import hint
from pitchpoint.core.words import listed
from pitchpoint.model.components.gear import Gear
from pitchpoint.model.engagement import engaged_brakes, engaged_links
from pitchpoint.model.frames import GROUND, bodies_of
from pitchpoint.report.planets import Array, mesh_phases, planet_angles

if TYPE_CHECKING:
    from pitchpoint.model.components.bevel_gear import BevelGear
    from pitchpoint.model.engagement import Engaged
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Drive, Scenario

EQUAL = 0.1
"""Tolerance of equally spaced planets: part of the angle between places where the teeth of a planet fit. That
is 2 pi over the sum of the teeth of the central gears; errors of pins are far smaller, and unequal spacing is
a whole multiple."""


def scenario_speeds(model: Model, name: str) -> tuple[dict[str, float], list[str]]:
    """Speeds of bodies in a scenario [rad/s], and remarks; for driven bodies the speed at the end of the run.

    Raises
    ------
    ModelError
        If a drive is a Python function.
    """
    from pitchpoint.model.components.law import Constant

    scenario = model.scenarios[name]
    speeds, remarks = dict(scenario.speed), []
    for body, drive in scenario.drive.items():
        end = scenario.duration or 0.0
        if drive.rate is None and drive.value is None:
            continue  # a ripple about the speed of a sweep
        if isinstance(drive.speed, Constant):
            speeds[body] = drive.speed.value
            continue
        speed = _at_end(drive, end)
        if speed is None:
            where = f"scenarios.{name}.drive.{body}"
            remedy = f"give --speed {body}=QUANTITY"
            raise ModelError(
                [Message(where, "is a Python function, whose speed is not known", remedy=remedy)]
            )
        speeds[body] = speed
        remarks.append(f"{body}: speed of its drive at the end of the run, {end:g} s")
    return speeds, remarks


def _at_end(drive: Drive, end: float) -> float | None:
    """Speed of a drive at the end of a run [rad/s]; None if only a run gives it."""
    from pitchpoint.core.formula.formula import Formula
    from pitchpoint.model.components.law import Constant, FormulaLaw, TableLaw

    law = drive.speed if drive.speed is not None else drive.angle
    if isinstance(law, FormulaLaw):
        formula = Formula.parse(law.text, ("t",))
        if drive.speed is not None:
            return float(formula(end))
        h = 1e-4 * end  # exact for quadratic laws; relative error (h/end)^2 for cubic ones
        return float((3.0 * formula(end) - 4.0 * formula(end - h) + formula(end - 2.0 * h)) / (2.0 * h))
    if isinstance(law, TableLaw):
        if drive.speed is not None:
            return float(np.interp(end, law.abscissa, law.values))
        last = max(int(np.searchsorted(law.abscissa, end)) - 1, 0)
        last = min(last, len(law.abscissa) - 2)
        step = law.abscissa[last + 1] - law.abscissa[last]
        return float((law.values[last + 1] - law.values[last]) / step)
    return 0.0 if isinstance(law, Constant) else None


def turning_speeds(
    model: Model, given: Mapping[str, float], scenario: Scenario | None = None
) -> dict[str, float]:
    """Speeds of all bodies relative to their parents [rad/s], from given ones through meshes and couplings.

    Parameters
    ----------
    model
        The model.
    given
        Speeds by body [rad/s].
    scenario
        Its driven bodies may contradict the gear ratios, which take precedence; its held bodies are at rest
        if the given speeds permit it; its engaged clutches are links.

    Raises
    ------
    ModelError
        If a body is unknown or cannot rotate, or given speeds contradict each other.
    """
    from pitchpoint.model.speed_ratios import locked_links, start_speeds

    machine: Any = model
    problems = []
    for body in given:
        seat = model.mechanism.seats.get(body)
        if body not in model.bodies:
            problems.append(
                Message(f"speed.{body}", "is not a body of the model", remedy=hint(body, model.bodies))
            )
        elif seat is None or "spin" not in seat.coordinates:
            problems.append(Message(f"speed.{body}", "is given, but the body cannot rotate on its parent"))
        else:
            problems += [
                Message(
                    f"speed.{body}", f"cannot be: {'.'.join(map(str, link[0]))} locks {link[1]} and {link[2]}"
                )
                for link in locked_links(machine, body)
            ]
    if problems:
        raise ModelError(problems)
    drive, held, engaged = (
        ({}, (), None) if scenario is None else (scenario.drive, scenario.hold, scenario.engaged)
    )
    spins, found = start_speeds(machine, given, held, engaged)
    wrong = [(body, fitting) for body, fitting in found if body not in drive]
    if wrong:
        raise ModelError(
            [
                Message(
                    f"speed.{body}",
                    "does not fit the ratio to the other given speeds",
                    value=f"{given[body]:.6g} rad/s",
                    limit=f"{fitting:.6g} rad/s",
                    remedy="correct or omit it; the other speeds follow from the ratios",
                )
                for body, fitting in wrong
            ]
        )
    return spins


def undetermined_speeds(model: Model, known: Collection[str], engaged: Engaged = None) -> list[str]:
    """Remarks on bodies whose speeds do not follow from those that are known or held, or from clutches."""
    from pitchpoint.model.carried_trains import has_carriers, undetermined
    from pitchpoint.model.speed_ratios import links_of
    from pitchpoint.model.torsional_supports import supported_bodies

    machine: Any = model
    links = links_of(machine) + engaged_links(machine, engaged)
    if not has_carriers(machine, links):
        return []
    still = [*engaged_brakes(machine, engaged), *supported_bodies(machine, engaged)]
    loose = undetermined(machine, links, [*known, *still])
    own = [body for body in loose if model.bodies[body].stage is None]
    if not own or not known:
        return []
    remedy = "give the speed of another member, or fix it"
    if {body for clutch in model.clutches.values() for body in bodies_of(clutch.bodies)} & {*own}:
        remedy += ", or name the clutches that are engaged in the scenario: engaged: [...]"
    return [
        f"the speeds of {listed(own)} do not follow from those of {listed(known)}: the smallest possible "
        f"speeds are shown; {remedy}"
    ]


def frequencies_of(model: Model, spins: Mapping[str, float]) -> dict[str, Any]:
    """Output of `frequencies --json`.

    Parameters
    ----------
    model
        The model.
    spins
        Speeds of all bodies relative to their parents [rad/s].
    """
    from pitchpoint.model.carried_trains import speed_in_space

    machine: Any = model
    speeds = {body: speed_in_space(machine, spins, body) for body in model.bodies}
    meshes = _meshes(model, spins)
    return {
        "shafts": {
            body: {
                "gears": [*part.gears, *part.bevel_gears],
                "speed": speeds[body],
                "frequency": abs(speeds[body]) / math.tau,
            }
            for body, part in model.bodies.items()
            if not part.of_housing
        },
        "meshes": meshes,
        "gears": _gears(model, meshes),
        "planet_sets": _planet_sets(model, meshes, speeds),
        "rolling_bearings": _rolling_bearings(model, spins),
    }


def _meshes(model: Model, spins: Mapping[str, float]) -> dict[str, dict[str, Any]]:
    """Frequencies of every mesh, and the body that carries its line of centres; None if this is fixed."""
    from pitchpoint.analysis.fault_frequencies import gear_pair_frequencies
    from pitchpoint.model.carried_trains import line_carrier, speed_in_space

    machine: Any = model
    found = {}
    for name, mesh in model.every_mesh.items():
        bodies = [model.body_of(gear) for gear in mesh.gears]
        if None in bodies:  # gears without bodies do not rotate
            continue
        one, two = (str(body) for body in bodies)
        carrier = line_carrier(machine, one, two)
        turning = speed_in_space(machine, spins, one, against=carrier)
        z_1, z_2 = (_teeth(model.toothed[g]) for g in mesh.gears)
        pair = gear_pair_frequencies(z_1, z_2, turning)
        found[name] = {
            "gears": list(mesh.gears),
            "teeth": [abs(z_1), abs(z_2)],
            "carrier": None if carrier == GROUND or model.bodies[carrier].moves == "fixed" else carrier,
            "frequency": pair.mesh,
            "assembly_phase": pair.assembly_phase,
            "hunting_tooth": pair.hunting_tooth,
            "common_factor": pair.common_factor,
            "rotation": [pair.rotation_1, pair.rotation_2],
        }
    return found


def _teeth(gear: Gear | BevelGear) -> int:
    """Number of teeth, negative for internal gears."""
    return gear.sign * gear.number_of_teeth if isinstance(gear, Gear) else gear.number_of_teeth


def _gears(model: Model, meshes: Mapping[str, Mapping[str, Any]]) -> dict[str, dict[str, Any]]:
    """Contact frequency of one tooth of each gear with each mating gear, and with all."""
    found = {}
    for name, gear in model.toothed.items():
        meets = {
            mesh: row["rotation"][row["gears"].index(name)]
            for mesh, row in meshes.items()
            if name in row["gears"]
        }
        if meets:
            found[name] = {
                "body": model.body_of(name),
                "teeth": gear.number_of_teeth,
                "type": gear.type if isinstance(gear, Gear) else "bevel",
                "tooth_meets": meets,
                "tooth_meets_all": sum(meets.values()),
            }
    return found


def _planet_sets(
    model: Model, meshes: Mapping[str, Mapping[str, Any]], speeds: Mapping[str, float]
) -> dict[str, dict[str, Any]]:
    """Carriers with their planets, and the phases of the meshes with each central gear."""
    from pitchpoint.analysis.planet_frequencies import excited_motion
    from pitchpoint.model.mechanism import base_of

    sets: dict[tuple[str, str], dict[str, Any]] = {}
    for name, row in ((n, r) for n, r in meshes.items() if n in model.meshes):
        bodies = [str(model.body_of(gear)) for gear in row["gears"]]
        own = model.planetary_stages.get(model.meshes[name].stage or "")
        carrier = row["carrier"] or (None if own is None else own.carrier)  # or a fixed one
        if own is None:
            rides = [base_of(model, model.mechanism, body) == carrier for body in bodies]
        else:
            rides = [model.bodies[body].stage in model.planetary_stages for body in bodies]
        if carrier is None or rides[0] == rides[1]:
            continue
        planet, central = bodies[rides.index(True)], row["gears"][rides.index(False)]
        stage = model.bodies[planet].stage or ""
        entry = sets.setdefault((carrier, stage), {"planets": [], "central": {}})
        if planet not in entry["planets"]:
            entry["planets"].append(planet)
        entry["central"].setdefault(central, []).append((name, planet))
    on_one = [carrier for carrier, _ in sets]
    found = {}
    for (carrier, stage), entry in sets.items():
        turns = abs(speeds[carrier]) / math.tau
        found[carrier if on_one.count(carrier) == 1 else f"{carrier}, {stage}"] = entry
        entry |= {"frequency": turns, "planet_pass": len(entry["planets"]) * turns}
        places = math.tau / _places(model, stage, entry["central"])
        for gear, pairs in entry["central"].items():
            angles = planet_angles(model, carrier, [planet for _, planet in pairs])
            z, n = model.gears[gear].number_of_teeth, len(pairs)
            error, limit = _spacing_error(angles), EQUAL * places
            even = error < limit
            apart = len(set((angles * n / math.tau).round().astype(int) % n)) == n
            entry["central"][gear] = {
                "phases": dict(zip((m for m, _ in pairs), mesh_phases(model, gear, angles), strict=True)),
                "excites": list(excited_motion(z, n)) if even and apart and n > 2 else None,
                "spacing_error": error,
                "spacing_limit": limit,
            }
    return found


def _places(model: Model, stage: str, central: Mapping[str, Any]) -> int:
    """Number of places on a turn at which planets fit; the sum of all teeth without a condition."""
    from pitchpoint.model.planet_spacing import connected, spacing_teeth, stage_meshes

    for chain in connected(model):
        if stage in chain:
            stages = [model.planetary_stages[name] for name in chain]
            return spacing_teeth(stage_meshes(model, stages)) or sum(
                model.gears[gear].number_of_teeth for gear in central
            )
    return sum(model.gears[gear].number_of_teeth for gear in central)


def _spacing_error(angles: Array) -> float:
    """Largest deviation of angles [rad] from equal spacing, whose position is their mean."""
    part = math.tau / len(angles)
    off = (angles + 0.5 * part) % part - 0.5 * part
    return float(np.abs(off - off.mean()).max())


def _rolling_bearings(model: Model, spins: Mapping[str, float]) -> dict[str, dict[str, Any]]:
    """Frequencies of every rolling bearing, relative to the carrier of its inner ring and load."""
    from pitchpoint.analysis.bearing_frequencies import bearing_frequencies
    from pitchpoint.model.carried_trains import line_carrier, speed_in_space
    from pitchpoint.model.frames import carrying_end, split
    from pitchpoint.model.rings import ring_ends

    machine: Any = model
    found = {}
    for name, part in model.rolling_bearings.items():
        inner, outer = (split(carrying_end(model, end))[0] for end in ring_ends(part))
        axis = inner if inner != GROUND else outer
        base = line_carrier(machine, inner, outer)
        rings = [speed_in_space(machine, spins, body, axis, against=base) for body in (inner, outer)]
        rates = bearing_frequencies(
            elements=part.geometry.elements,
            element_diameter=part.geometry.element_diameter,
            pitch_diameter=part.geometry.pitch_diameter,
            contact_angle=part.geometry.contact_angle,
            speed_inner=rings[0],
            speed_outer=rings[1],
        )
        found[name] = {"speed_inner": rings[0], "speed_outer": rings[1], **asdict(rates)}
    return found
