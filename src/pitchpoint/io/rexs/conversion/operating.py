# SPDX-License-Identifier: Apache-2.0
"""Lubricant of a gear unit, and the load cases of its load spectrum."""

from __future__ import annotations

import re
from collections import Counter
from typing import Any

from pitchpoint.io.rexs.conversion.frames import world
from pitchpoint.io.rexs.conversion.loads import load_cases, speed_shafts
from pitchpoint.io.rexs.conversion.state import Conversion, q, vector
from pitchpoint.io.rexs.document import RexsAttribute, RexsComponent, RexsLoadCase, RexsModel

STAGES = ("cylindrical_stage", "bevel_stage")
BASES = {
    "mineral_oil": "mineral",
    "mineral": "mineral",
    "polyalfaolefin": "polyalphaolefin",
    "non_water_soluble_polyglycol": "polyglycol",
    "water_soluble_polyglycol": "polyglycol",
}
"""Base oil of the model by `lubricant_type_iso_6336_2006` and `basis`."""
GRADE = 0.1
"""Range of the viscosity at 40 degrees Celsius of a grade to ISO 3448, relative."""
TORQUE, POWER, SPEED = "torque_around_u_axis", "power", "rotational_speed"
GEAR, STATES = "gear_shift_index", "is_engaged"


# --- lubricant ----------------------------------------------------------------------------------------------
def convert_lubricant(conversion: Conversion) -> None:
    """Add the lubricant of the meshes, at the temperature of the casing."""
    oil = _of_meshes(conversion)
    if oil is None:
        return
    conversion.done.add(oil.id)
    temperature = _temperature(conversion, oil)
    at_40 = conversion.number(
        oil, "viscosity_at_40_degree_celsius", "lubricant.viscosity_at_40_degree_celsius"
    )
    if temperature is None or not at_40:
        missing = "temperature_lubricant of gear_casing" if at_40 else "viscosity_at_40_degree_celsius"
        conversion.ignored(oil, "all", f"{missing} is missing: add lubricant to the model file")
        return
    values: dict[str, Any] = {}
    name = conversion.word(oil, "name", "lubricant.name") or oil.name
    if name:
        values["name"] = name
    values["viscosity_at_40_degree_celsius"] = q(at_40, "kinematic_viscosity")
    at_100 = conversion.number(
        oil, "viscosity_at_100_degree_celsius", "lubricant.viscosity_at_100_degree_celsius"
    )
    if at_100:
        values["viscosity_at_100_degree_celsius"] = q(at_100, "kinematic_viscosity")
    else:
        grade = _grade(at_40)
        if grade is None:
            conversion.ignored(
                oil, "all", "viscosity_at_100_degree_celsius is missing: add lubricant by hand"
            )
            return
        values["grade"] = grade
        target = "lubricant.viscosity_at_100_degree_celsius"
        conversion.default(oil, "viscosity_at_100_degree_celsius", f"of {grade}", target)
    density = conversion.number(oil, "density_at_15_degree_celsius", "lubricant.density_at_15_degree_celsius")
    if density:
        values["density_at_15_degree_celsius"] = q(density, "density")
    words = [conversion.word(oil, key, "lubricant.base") for key in ("lubricant_type_iso_6336_2006", "basis")]
    base = next((BASES[word] for word in words if word in BASES), None)
    if base is None:
        conversion.default(oil, "basis", "mineral", "lubricant.base")
    elif base != "mineral":
        values["base"] = base
    pressure = conversion.number(oil, "pressure_viscosity_coefficient_at_38_degrees_celsius")
    if pressure:
        reason = "a model has it at the operating temperature: that of the base oil"
        conversion.ignored(oil, "pressure_viscosity_coefficient_at_38_degrees_celsius", reason)
    values["temperature"] = q(temperature, "temperature")
    conversion.data["lubricant"] = values


def _of_meshes(conversion: Conversion) -> RexsComponent | None:
    """Oil of most meshes, else of the casing; None without any."""
    parts: dict[str, RexsComponent] = {}
    counts: Counter[str] = Counter()
    for part in conversion.source.of_type(*STAGES, "gear_casing"):
        for oil in conversion.referenced(part, "lubricant"):
            if oil.get("kind") == "grease":
                continue
            key = str([oil.get(name) for name in ("name", *_VISCOSITIES)])
            parts.setdefault(key, oil)
            counts[key] += 1000 if part.type in STAGES else 1
            if parts[key] is not oil:
                conversion.done.add(oil.id)  # the same oil of another mesh
                conversion.used |= {(oil.id, name) for name in oil.attributes}
    if not counts:
        return None
    first = parts[counts.most_common(1)[0][0]]
    for oil in parts.values():
        if oil is not first:
            text = f"a model has one oil, that of most meshes ({first.get('name') or first.name})"
            conversion.ignored(oil, "all", text)
    return first


_VISCOSITIES = ("viscosity_at_40_degree_celsius", "viscosity_at_100_degree_celsius")


def _temperature(conversion: Conversion, oil: RexsComponent) -> float | None:
    """Temperature of the oil [K]: of the casing, else of the first mesh that has one."""
    for part in conversion.source.of_type("gear_casing", *STAGES):
        value = conversion.number(part, "temperature_lubricant", "lubricant.temperature")
        if value is not None:
            return value
    return None


def _grade(at_40: float) -> str | None:
    """Grade to ISO 3448 by the viscosity at 40 degrees Celsius [m^2/s].

    >>> _grade(330e-6), _grade(270e-6)
    ('ISO VG 320', None)
    """
    from pitchpoint.contact.lubricant import GRADES

    near = min(GRADES, key=lambda name: abs(GRADES[name][0] - at_40))
    return near if abs(at_40 / GRADES[near][0] - 1.0) <= GRADE else None


# --- load cases ---------------------------------------------------------------------------------------------
def active_loads(whole: RexsModel) -> set[int]:
    """External loads with a torque or force in at least one load case."""
    found = set()
    for case in load_cases(whole):
        for id, values in case.components.items():
            if whole.components[id].type == "external_load" and any(
                isinstance(one.value, float) and one.value for one in values.values()
            ):
                found.add(id)
    return found


def convert_load_cases(conversion: Conversion, whole: RexsModel) -> set[int]:
    """Add all load cases of the file, if it has several; the numbers of those that were added."""
    cases = load_cases(whole)
    added: dict[int, dict[str, Any]] = {}
    if len(cases) < 2:
        return set()
    for case in cases:
        reason = _obstacle(conversion, whole, case)
        values = _of_case(conversion, whole, case) if not reason else {}
        if values:
            added[case.id] = values
        else:
            text = reason or "it has neither speed nor loads"
            conversion.ignored(f"load case {case.id}", "all", f"{text}: --load-case {case.id}")
    shares = [float(values.get("load_duration_fraction", 0.0)) for values in added.values()]
    if sum(shares) > 1.0 + 1e-6:
        for values in added.values():
            values.pop("load_duration_fraction", None)
        text = f"they add up to {100.0 * sum(shares):.6g} %"
        conversion.changed("gear_unit", "operating_time_fraction", "none", "load_cases", text)
    if added:
        conversion.data["load_cases"] = {_case_name(id): values for id, values in added.items()}
    return set(added)


def _case_name(id: int) -> str:
    return f"case_{re.sub('[^0-9]', '_', str(id))}"


def _merged(whole: RexsModel, case: RexsLoadCase, id: int) -> dict[str, RexsAttribute]:
    """Values of a component in a load case."""
    return {**whole.components[id].attributes, **case.components.get(id, {})}


def _plain(values: dict[str, RexsAttribute], key: str) -> float | None:
    found = values.get(key)
    if found is None or isinstance(found.value, bool) or not isinstance(found.value, int | float):
        return None
    return float(found.value)


def _obstacle(conversion: Conversion, whole: RexsModel, case: RexsLoadCase) -> str:
    """Why a load case is none of the same model; empty if it is."""
    for id in case.components:
        now = conversion.source.components[id]
        other = _merged(whole, case, id)
        for key in (GEAR, STATES):
            if key in other and other[key].value != now.get(key):
                return "another gear of the transmission"
    for name, load in conversion.data.get("loads", {}).items():
        part = conversion.origins["loads", name]
        torque = _torque_of(conversion, whole, case, part)
        if load.get("torque") != "balance" and "torque" in load and torque is None:
            return "another load balances the torques"
    return ""


def _torque_of(
    conversion: Conversion, whole: RexsModel, case: RexsLoadCase, load: RexsComponent
) -> float | None:
    """Torque of a load in a load case [N m], from its power if it has no torque."""
    values = _merged(whole, case, load.id)
    torque = _plain(values, TORQUE)
    power, shaft = _plain(values, POWER), conversion.owner(load, "shaft")
    if torque is not None or power is None or shaft is None:
        return torque
    speed = _plain(_merged(whole, case, shaft.id), SPEED)
    return power / speed if speed else None


def _of_case(conversion: Conversion, whole: RexsModel, case: RexsLoadCase) -> dict[str, Any]:
    """Values of a load case for the model file."""
    found: dict[str, Any] = {}
    speed = {}
    for shaft in speed_shafts(conversion):
        seat, value = conversion.seats[shaft.id], _plain(_merged(whole, case, shaft.id), SPEED)
        if value is not None:
            speed[seat.body] = q(seat.sign * value, "angular_speed")
    if any(value != 0 and not str(value).startswith("0 ") for value in speed.values()):
        found["speed"] = speed
    loads = {}
    for name in conversion.data.get("loads", {}):
        values = _of_load(conversion, whole, case, conversion.origins["loads", name])
        if values:
            loads[name] = values
    if loads:
        found["loads"] = loads
    for part in conversion.source.of_type("gear_casing"):
        value = _plain(_merged(whole, case, part.id), "temperature_lubricant")
        if value is not None and "lubricant" in conversion.data:
            found["temperature"] = q(value, "temperature")
    if not found:
        return {}
    for unit in conversion.source.of_type("gear_unit"):
        share = _plain(_merged(whole, case, unit.id), "operating_time_fraction")
        conversion.value(unit, "operating_time_fraction", "load_cases.*.load_duration_fraction")
        if share is not None:
            found["load_duration_fraction"] = share
    return found


def _of_load(
    conversion: Conversion, whole: RexsModel, case: RexsLoadCase, load: RexsComponent
) -> dict[str, Any]:
    """Torque and force of a load in a load case."""
    shaft = conversion.owner(load, "shaft")
    seat = conversion.seats.get(shaft.id) if shaft is not None else None
    if seat is None or shaft is None:
        return {}
    values, torque = _merged(whole, case, load.id), _torque_of(conversion, whole, case, load)
    found: dict[str, Any] = {}
    if torque is not None:
        found["torque"] = q(seat.sign * torque, "torque")
    forces = [_plain(values, f"force_{axis}_direction") for axis in "uvw"]
    if any(forces) or any(load.get(f"force_{axis}_direction") for axis in "uvw"):
        found["force"] = vector(world(conversion.frames[shaft.id], [f or 0.0 for f in forces]), "force")
    return found
