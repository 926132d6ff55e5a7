# SPDX-License-Identifier: Apache-2.0
"""Power flow of a model at constant speed without losses: speeds, torques, tooth forces, frequencies.

Speeds follow from the ratios, torques from the balance (`model.torque_balance`); nothing is compiled or
solved.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import ModelError
from pitchpoint.core.words import listed, ranges
from pitchpoint.report.acting_torques import acting_torques

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.model.torque_balance import External, TorqueBalance

SAME = 1e-9
"""Share of the largest torque or power that counts as zero."""
BEARING = ("speed_inner", "speed_outer", "ftf", "bpfo", "bpfi", "bsf")
WORDS = {"drive": "drive of {}", "hold": "{}, held", "support": "support of {}"}


def static_powers(model: Model, only: str | None = None) -> dict[str, dict[str, Any]]:
    """Power flow of every scenario, as in `check --json`; with loads but no scenario that of the loads.

    Parameters
    ----------
    model
        The model.
    only
        Name of a single scenario; None for all.

    Returns
    -------
    dict
        By scenario: `shafts`, `links` (meshes, couplings, ratios), `external` torques, `bearings`, `power_in`
        and `power_out` [W], `notes`; or `failure`, why there is none.
    """
    from pitchpoint.model.scenario import Scenario

    if not model.bodies:
        return {}
    scenarios = model.scenarios if only is None else {only: model.scenarios[only]}
    found = {}
    for name, scenario in (scenarios or {"": Scenario()}).items():
        try:
            found[name] = static_power(model, scenario, name)
        except ModelError as error:
            found[name] = {"failure": str(error)}
    return {name: flow for name, flow in found.items() if "failure" in flow or _flows(flow)}


def _flows(flow: Mapping[str, Any]) -> bool:
    """Whether there is a mesh, a torque or a rolling bearing to show."""
    torques = [row["torque"] for row in flow["external"]]
    return bool(flow["bearings"] or any("gears" in row for row in flow["links"].values()) or any(torques))


def static_power(model: Model, scenario: Scenario, name: str = "") -> dict[str, Any]:
    """Power flow of one scenario.

    A scenario without speed has torques and ratios: its directions are those of a positive speed of the first
    loaded body.

    Parameters
    ----------
    model
        The model.
    scenario
        The scenario.
    name
        Its name; empty for one that the file does not contain.

    Raises
    ------
    ModelError
        If the speeds are not known or contradict each other.
    """
    from pitchpoint.model.load_cases import in_own_load_case
    from pitchpoint.model.torque_balance import torque_balance
    from pitchpoint.report.external_torques import external_torques, overloaded_clutches
    from pitchpoint.report.frequencies import frequencies_of, turning_speeds, undetermined_speeds

    model, scenario = in_own_load_case(model, scenario)
    given, notes = _speeds(model, scenario, name)
    spins = turning_speeds(model, given, scenario)
    external, sticking, remarks = external_torques(model, scenario, spins)
    machine: Any = model
    balance = torque_balance(machine, external, sticking)
    turns = any(spins.values())
    loaded = [each.body for each in external if balance.external[each.name]]
    if not turns and loaded:
        spins = _unit_speeds(model, loaded[0], scenario)
    rates = frequencies_of(model, spins)
    outer = _external(model, balance, external, spins)
    powers = [row["power"] for row in outer if row["power"] is not None]
    first = next((row["body"] for row in outer if (row["power"] or 0.0) > 0.0), loaded[0] if loaded else None)
    closed = not balance.unbalanced and not balance.undetermined
    found = {
        "turns": turns,
        "input": first,
        "shafts": _shafts(model, balance, outer, rates, first),
        "links": _links(model, balance, rates),
        "external": outer,
        "bearings": {
            bearing: {key: row[key] for key in BEARING} for bearing, row in rates["rolling_bearings"].items()
        },
        "power_in": sum(p for p in powers if p > 0.0) if closed else None,
        "power_out": sum(-p for p in powers if p < 0.0) if closed else None,
        "notes": [
            *notes,
            *undetermined_speeds(model, [*given, *scenario.hold], scenario.engaged),
            *remarks,
            *overloaded_clutches(model, scenario, balance),
            *_notes(model, balance),
        ],
    }
    return found if turns else _at_rest(found)


def _speeds(model: Model, scenario: Scenario, name: str) -> tuple[dict[str, float], list[str]]:
    """Given speeds of a scenario [rad/s], the highest of a sweep, and remarks."""
    from pitchpoint.report.frequencies import frequencies_of, scenario_speeds

    given, notes = scenario_speeds(model, name) if name else (dict(scenario.speed), [])
    given = {body: speed for body, speed in given.items() if body in model.bodies}
    sweep = scenario.sweep
    if sweep is not None:
        speed = sweep.speed[1] if sweep.speed is not None else 0.0
        if sweep.mesh_frequency is not None:
            rates = frequencies_of(model, _unit_speeds(model, sweep.body, scenario))["meshes"]
            speed = sweep.mesh_frequency[1] / rates[model.sweep_mesh(scenario)]["frequency"]
        given[sweep.body] = speed
        notes.append(f"{sweep.body}: highest speed of the sweep")
    return given, notes


def _unit_speeds(model: Model, body: str, scenario: Scenario) -> dict[str, float]:
    """Speeds of all bodies at 1 rad/s of one of them in a scenario; all zero if it cannot rotate."""
    from pitchpoint.report.frequencies import turning_speeds

    try:
        return turning_speeds(model, {body: 1.0}, scenario)
    except ModelError:
        return dict.fromkeys(model.bodies, 0.0)


def _at_rest(found: dict[str, Any]) -> dict[str, Any]:
    """Power flow without speeds, powers and frequencies."""
    for row in found["shafts"].values():
        row |= dict.fromkeys(("speed", "frequency", "power"))
    for row in found["links"].values():
        row |= {key: None for key in ("pitch_line_velocity", "mesh_frequency") if key in row}
    for row in found["external"]:
        row["power"] = None
    return found | {"bearings": {}, "power_in": None, "power_out": None}


def _external(
    model: Model, balance: TorqueBalance, external: Sequence[External], spins: Mapping[str, float]
) -> list[dict[str, Any]]:
    """External torques with their power on both bodies; those of fixed bodies are reactions."""
    from pitchpoint.model.carried_trains import speed_in_space

    machine: Any = model
    found = []
    for one in external:
        torque = _finite(balance.external[one.name])
        against = one.reaction if one.reaction in model.bodies else None
        speed = speed_in_space(machine, spins, one.body, against=against)
        found.append(
            {
                "name": WORDS.get(str(one.name[0]), "{}").format(one.name[1]),
                "section": str(one.name[0]),
                "body": one.body,
                "reaction": against,
                "torque": torque,
                "power": None if torque is None else torque * speed,
            }
        )
    for body, part in model.bodies.items():
        if part.moves != "fixed":
            continue
        torques = [
            t
            for link in balance.links.values()
            for b, t in zip(link.bodies, link.torques, strict=True)
            if b == body
        ]
        if torques:
            torque = _finite(-sum(torques))
            found.append(
                {
                    "name": f"{body}, fixed",
                    "section": "support",
                    "body": body,
                    "reaction": None,
                    "torque": torque,
                    "power": 0.0,
                }
            )
    return found


def _shafts(
    model: Model,
    balance: TorqueBalance,
    outer: Sequence[Mapping[str, Any]],
    rates: Mapping[str, Any],
    first: str | None,
) -> dict[str, dict[str, Any]]:
    """Speed, frequency, transmitted torque and power of every body that rotates or transmits a torque."""
    found = {}
    reference = rates["shafts"][first]["speed"] if first else 0.0
    torques = acting_torques(model, balance, outer)
    for body in _along_the_power(model, balance, first):
        row = rates["shafts"].get(body)
        if row is None:
            continue
        acting = torques[body]
        known = [torque for _, torque in acting if torque is not None]
        largest = max((abs(t) for t in known), default=0.0)
        if not row["speed"] and not largest:
            continue
        carrier = _carrier(model, rates, body)
        way = math.copysign(1.0, row["speed"]) if row["speed"] else 1.0
        sides: dict[bool, list[str]] = {True: [], False: []}
        for name, torque in acting:
            if torque is not None and abs(torque) > SAME * largest:
                sides[torque * way > 0.0] += name
        torque = None if len(known) < len(acting) else sum(abs(t) for t in known if t * way > 0.0)
        found[body] = {
            "gears": row["gears"],
            "speed": row["speed"],
            "ratio": reference / row["speed"] if reference and row["speed"] else None,
            "frequency": row["frequency"],
            "torque": torque,
            "power": None if torque is None or carrier else torque * abs(row["speed"]),
            "carrier": carrier,
            "driven_by": sides[True],
            "drives": sides[False],
        }
    return found


def _along_the_power(model: Model, balance: TorqueBalance, first: str | None) -> list[str]:
    """Bodies from the input along joints, meshes and couplings, all others as in the file."""
    beside: dict[str, list[str]] = {body: [] for body in model.bodies}
    pairs = [(name, seat.parent) for name, seat in model.mechanism.seats.items()]
    pairs += [(one, two) for link in balance.links.values() for one in link.bodies for two in link.bodies]
    for one, two in pairs:
        if one != two and {one, two} <= beside.keys():
            beside[one].append(two)
            beside[two].append(one)
    found = [] if first is None else [first]
    for body in found:  # grows
        found += [name for name in dict.fromkeys(beside[body]) if name not in found]
    return [*found, *(body for body in model.bodies if body not in found)]


def _carrier(model: Model, rates: Mapping[str, Any], body: str) -> str | None:
    """Rotating body on which a body has its bearings, such as the carrier of a planet."""
    from pitchpoint.model.mechanism import base_of

    base = base_of(model, model.mechanism, body)
    return base if rates["shafts"].get(base, {}).get("speed", 0.0) else None


def _links(model: Model, balance: TorqueBalance, rates: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
    """Torques of all links; for meshes with forces, velocity and frequency."""
    from pitchpoint.geometry.tooth_forces import bevel_force, tooth_force

    found = {}
    for place, link in balance.links.items():
        section, name = str(place[0]), str(place[1])
        torques = [_finite(torque) for torque in link.torques]
        row: dict[str, Any] = {"section": section, "bodies": list(link.bodies), "torques": torques}
        if name in rates["meshes"] and section in ("meshes", "bevel_meshes"):
            mesh = rates["meshes"][name]
            one, two = mesh["gears"]
            if section == "meshes":
                pair = model.pairs[name]
                d, force = abs(pair.d_w1), None if torques[0] is None else tooth_force(pair, torques[0])
            else:
                bevel = model.bevel_pairs[name]
                sense = model.bevel_gears[one].direction
                d = bevel.gear1.d_m
                force = None if torques[0] is None else bevel_force(bevel, sense * torques[0])
            row |= {
                "gears": mesh["gears"],
                "teeth": mesh["teeth"],
                "ratio": mesh["teeth"][1] / mesh["teeth"][0],
                "tangential_force": None if force is None else abs(force.tangential),
                "radial_force": None if force is None else force.radial,
                "axial_force": None if force is None else force.axial,
                "pitch_line_velocity": math.pi * d * mesh["rotation"][0],
                "mesh_frequency": mesh["frequency"],
            }
        # names are unique within a section
        found[name if name not in found else f"{section}.{name}"] = row
    return found


def _finite(value: float) -> float | None:
    return value + 0.0 if math.isfinite(value) else None


def _notes(model: Model, balance: TorqueBalance) -> list[str]:
    """What balance does not decide, in words."""
    from pitchpoint.core.units import format_quantity

    found = [
        f"{ranges(group)} share the torque as if equally stiff: the torque split is statically indeterminate"
        for group in balance.shared
    ]
    for group in balance.undetermined:
        names = listed([WORDS.get(str(n[0]), "{}").format(n[1]) for n in group])
        found.append(f"the torques of {names} are statically indeterminate; a run determines them")
    for train, body, missing in balance.unbalanced:
        torque = "a torque" if missing is None else format_quantity(missing, "torque", 5)
        others = _others(model, train)
        found.append(
            f"the loads of {body} do not balance without {ranges(others)}, whose forces a run determines"
            if others
            else f"the loads do not balance: {torque} on {body} is missing for constant speed; give one "
            "of them torque: balance, or drive a body"
        )
    return found


def _others(model: Model, train: Sequence[str]) -> list[str]:
    """Elements that may transmit forces to bodies of a train, other than along its gears and couplings."""
    from pitchpoint.model.frames import bodies_of

    train = [*train, *(name for body in train for name in model.mechanism.carried_by(body))]
    found = [name for name in model.mechanism.cut if {*bodies_of(model.joints[name].bodies)} & {*train}]
    groups = ("springs", "maxwells", "rods", "bushings", "beams", "cam_contacts", "curve_contacts")
    for group in (*groups, "surface_contacts", "wind_rotors"):
        for name, part in getattr(model, group).items():
            ends = getattr(part, "ends", None) or getattr(part, "bodies", None) or ()
            ends = (*ends, part.hub) if group == "wind_rotors" else ends
            if {*bodies_of(ends)} & {*train}:
                found.append(name)
    return found
