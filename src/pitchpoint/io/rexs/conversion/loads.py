# SPDX-License-Identifier: Apache-2.0
"""Gravity, loads and scenarios."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.io.rexs.conversion.frames import TO_MODEL, world
from pitchpoint.io.rexs.conversion.state import Conversion, q, vector
from pitchpoint.io.rexs.document import RexsComponent, RexsLoadCase, RexsModel

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

GRAVITY = 9.80665
PERIODS, STEPS = 20.0, 50.0
"""Duration of the scenario `steady` in periods of the slowest mesh; steps per period of the fastest one."""


def load_cases(model: RexsModel) -> list[RexsLoadCase]:
    """All load cases of a model."""
    return [case for spectrum in model.load_spectra for case in spectrum.cases]


def with_load_case(model: RexsModel, number: int | None) -> tuple[RexsModel, RexsLoadCase | None]:
    """Model with the values of one load case, by default the first one.

    Raises
    ------
    ModelError
        If there is no such load case.
    """
    cases = load_cases(model)
    if number is None:
        case = cases[0] if cases else None
    else:
        case = next((c for c in cases if c.id == number), None)
        if case is None:
            there = ", ".join(str(c.id) for c in cases) or "none"
            raise ModelError([Message("--load-case", "does not exist", str(number), f"load cases: {there}")])
    if case is None:
        return model, None
    components = dict(model.components)
    for id, values in case.components.items():
        components[id] = replace(components[id], attributes={**components[id].attributes, **values})
    return replace(model, components=components), case


def convert_gravity(conversion: Conversion) -> None:
    """Add gravity if the gear unit has it."""
    for unit in conversion.source.of_type("gear_unit"):
        if not conversion.flag(unit, "account_for_gravity"):
            continue
        direction = [
            conversion.number(unit, f"direction_vector_gravity_{a}", "gravity") or 0.0 for a in "uvw"
        ]
        size = float(np.linalg.norm(direction))
        if size == 0.0:
            conversion.default(
                unit, "direction_vector_gravity", "no weight", "gravity", "it has no direction"
            )
            return
        g = conversion.number(unit, "gravitational_acceleration", "gravity")
        if g is None:
            g = GRAVITY
            conversion.default(unit, "gravitational_acceleration", f"{g} m/s^2", "gravity")
        conversion.data["gravity"] = vector(g / size * TO_MODEL @ np.array(direction), "acceleration")


def convert_loads(conversion: Conversion, active: set[int]) -> None:
    """Add the external loads; the one that transmits torque without a value balances the others.

    Parameters
    ----------
    conversion
        The conversion.
    active
        Loads that act in at least one load case of the file.
    """
    free: list[tuple[RexsComponent, dict[str, Any]]] = []
    driven = False
    for load in conversion.source.of_type("external_load"):
        shaft = conversion.owner(load, "shaft")
        seat = conversion.seats.get(shaft.id) if shaft is not None else None
        if seat is None or shaft is None:
            if shaft is None:
                conversion.problem(load, "is on no shaft", remedy="give a relation 'assembly' with a shaft")
            continue
        u = conversion.number(load, "u_coordinate_on_shaft")
        if u is None:
            u = 0.0
            conversion.default(
                load, "u_coordinate_on_shaft", "0 mm", f"loads.{conversion.name(load)}.position"
            )
        values: dict[str, Any] = {"body": seat.body}
        torque = _torque(conversion, load, shaft)
        forces = [conversion.number(load, f"force_{a}_direction") or 0.0 for a in "uvw"]
        moments = [conversion.number(load, f"torque_around_{a}_axis") or 0.0 for a in "vw"]
        if torque:
            values["torque"] = q(seat.sign * torque, "torque")
            driven = True
        if any(forces):
            values["force"] = vector(world(conversion.frames[shaft.id], forces), "force")
        if any(moments):
            values["moment"] = vector(world(conversion.frames[shaft.id], [0.0, *moments]), "torque")
        place = [0, 0, q(seat.place(u), "length")]
        if any(forces) or seat.body in conversion.data.get("shafts", {}):
            values["position"] = place  # without effect on the torque of a rigid body
        if torque is None and conversion.flag(load, "transmits_torque"):
            free.append((load, values))
        elif torque or any(forces) or any(moments):
            conversion.put("loads", load, values)
        elif load.id in active:
            zero: dict[str, Any] = {"force": ["0 N"] * 3, "position": place}
            zero = {"torque": "0 N m"} if torque is not None else zero
            conversion.put("loads", load, {"body": seat.body, **zero})
        else:
            conversion.ignored(load, "all", "it has neither torque nor force in this load case")
    if len(free) > 1:
        free = [one for one in free if not _held(conversion, one[0])]
    if (driven or conversion.own) and len(free) == 1:
        load, values = free[0]
        values = {
            "body": values["body"],
            "torque": "balance",
            **{k: v for k, v in values.items() if k != "body"},
        }
        name = conversion.put("loads", load, values)
        conversion.default(load, "torque_around_u_axis", "balance", f"loads.{name}.torque", "equilibrium")
        return
    for load, values in free:
        if "force" in values or "moment" in values:
            conversion.put("loads", load, values)
        else:
            conversion.ignored(load, "all", "its torque is not known" if driven else "no load has a torque")


def _held(conversion: Conversion, load: RexsComponent) -> bool:
    """Whether a load without torque holds a shaft whose speed is given as zero, such as a brake."""
    shaft = conversion.owner(load, "shaft")
    if shaft is None or shaft.get("defines_speed") is not True or shaft.get("rotational_speed") != 0.0:
        return False
    body = conversion.seats[shaft.id].body
    conversion.held.append(body)
    conversion.done.add(load.id)
    reason = "its speed is 0, and its load has no torque"
    conversion.changed(load, "transmits_torque", f"hold {body}", "scenarios.*.hold", reason)
    return True


def _torque(conversion: Conversion, load: RexsComponent, shaft: RexsComponent | None) -> float | None:
    """Torque of a load [N m], from its power if it has no torque."""
    torque = conversion.number(load, "torque_around_u_axis", f"loads.{conversion.name(load)}.torque")
    if torque is not None:
        return torque
    power = conversion.number(load, "power", f"loads.{conversion.name(load)}.torque")
    speed = None if shaft is None else conversion.number(shaft, "rotational_speed")
    if power is None or not speed:
        return None
    return power / speed


def _with_speed(conversion: Conversion) -> list[RexsComponent]:
    return [
        s
        for s in conversion.source.of_type("shaft")
        if s.get("rotational_speed") is not None and s.id in conversion.seats
    ]


def speed_shafts(conversion: Conversion) -> list[RexsComponent]:
    """Shafts whose speeds are given: those that define the speed, else the first one with a speed."""
    shafts = _with_speed(conversion)
    return [s for s in shafts if s.get("defines_speed") is True] or shafts[:1]


def convert_speeds(conversion: Conversion) -> None:
    """Add the scenarios: a slow roll through the first mesh, and a time response at the given speed."""
    chosen = speed_shafts(conversion)
    for shaft in _with_speed(conversion):
        if shaft not in chosen:
            conversion.ignored(shaft, "rotational_speed", "the speed follows from the gear ratios")
    speeds = {}
    for shaft in chosen:
        conversion.flag(shaft, "defines_speed")
        value = conversion.number(shaft, "rotational_speed", "scenarios.steady.speed")
        if value or (value is not None and shaft.get("defines_speed") is True):
            seat = conversion.seats[shaft.id]
            speeds[seat.body] = seat.sign * value
    scenarios: dict[str, Any] = {}
    meshes = [*conversion.data.get("meshes", {}), *conversion.data.get("bevel_meshes", {})]
    mesh = next(iter(meshes), None) or _mesh_of_stage(conversion)
    if mesh is not None:
        scenarios["slow"] = {"quasi_static": {"mesh": mesh, "points": 20}}
        conversion.default("scenario", "slow", f"mesh {mesh}, 20 points", "scenarios.slow", "slow roll")
    if any(speeds.values()):
        named = {name: q(value, "angular_speed") for name, value in speeds.items()}
        scenarios["steady"] = {"speed": named, "duration": "1 s"}
    else:
        conversion.default(
            "shaft", "rotational_speed", "no time response", "scenarios", "no shaft has a speed"
        )
    if conversion.held:
        for scenario in scenarios.values():
            scenario["hold"] = list(conversion.held)
    if scenarios:
        conversion.data["scenarios"] = scenarios


def time_response(conversion: Conversion, model: Model) -> dict[str, Any] | None:
    """Scenario `steady` with duration and step by the mesh frequencies; None without speeds.

    Parameters
    ----------
    conversion
        The conversion.
    model
        The model with the speeds of this scenario.
    """
    if "steady" not in model.scenarios:
        return None
    frequencies = sorted(f for f in _mesh_frequencies(model) if f > 0.0)
    if not frequencies:
        return None
    duration = float(f"{PERIODS / frequencies[0]:.2g}")
    step = float(f"{1.0 / (STEPS * frequencies[-1]):.2g}")
    reason = f"{PERIODS:g} periods of the slowest mesh"
    conversion.default("scenario", "duration", f"{duration:g} s", "scenarios.steady.duration", reason)
    reason = f"{STEPS:g} steps per period of the fastest mesh"
    conversion.default("scenario", "step", f"{step:g} s", "scenarios.steady.step", reason)
    found: dict[str, Any] = dict(conversion.data["scenarios"]["steady"])
    return {**found, "duration": q(duration, "time"), "step": q(step, "time")}


def _mesh_frequencies(model: Model) -> list[float]:
    """Mesh frequencies of the scenario `steady` [Hz]."""
    speeds = model.start_speeds("steady")
    found = []
    for mesh in model.meshes.values():
        gear = mesh.gears[0]
        body = next((n for n, b in model.bodies.items() if gear in b.gears), "")
        stage = model.planetary_stages.get(mesh.stage or "")
        carrier = speeds.get(stage.carrier, 0.0) if stage is not None else 0.0
        turning = speeds.get(body, 0.0) - carrier
        found.append(abs(turning) * model.gears[gear].number_of_teeth / math.tau)
    for bevel in model.bevel_meshes.values():
        gear = bevel.gears[0]
        body = next((n for n, b in model.bodies.items() if gear in b.bevel_gears), "")
        found.append(abs(speeds.get(body, 0.0)) * model.bevel_gears[gear].number_of_teeth / math.tau)
    return found


def _mesh_of_stage(conversion: Conversion) -> str | None:
    for stage in conversion.data.get("planetary_stages", {}).values():
        name = f"{stage.get('planet_name', 'planet')}_1"
        return f"{stage['sun']}-{name}" if "sun" in stage else f"{name}-{stage['ring']}"
    return None
