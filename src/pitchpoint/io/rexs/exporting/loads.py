# SPDX-License-Identifier: Apache-2.0
"""Loads and scenarios as external loads and load cases of REXS."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.io.rexs.conversion.frames import TO_MODEL
from pitchpoint.io.rexs.document import RexsAttribute, RexsLoadCase, RexsLoadSpectrum
from pitchpoint.io.rexs.exporting.draft import Draft, attribute

if TYPE_CHECKING:
    from collections.abc import Mapping

Values = dict[int, dict[str, RexsAttribute]]


def add_loads(draft: Draft) -> Values:
    """Add the external loads; their values by component are returned."""
    from pitchpoint.model.components.law import Balance, Constant

    found: Values = {}
    for name, load in draft.model.loads.items():
        path = f"loads.{name}"
        shaft = draft.shafts.get(load.body)
        if shaft is None or load.reaction is not None or load.marker is not None:
            draft.omit(path, "only loads at a position of a shaft are written")
            continue
        if max(map(abs, load.position[:2])) > 0.0:
            draft.omit(f"{path}.position", "only the position along the axis is written")
        values: dict[str, float] = {}
        balance = isinstance(load.torque, Balance)
        if isinstance(load.torque, Constant):
            values["torque_around_u_axis"] = load.torque.value
        elif load.torque is not None and not balance:
            draft.omit(f"{path}.torque", "only constant values are written")
        for key, name_of in (("force", "force_{}_direction"), ("moment", "torque_around_{}_axis")):
            laws = getattr(load, key)
            if laws is None:
                continue
            if not all(isinstance(law, Constant) for law in laws):
                draft.omit(f"{path}.{key}", "only constant values are written")
                continue
            along = TO_MODEL @ (draft.frame(load.body)[1].T @ np.array([law.value for law in laws]))
            for axis, value in zip("uvw", along, strict=True):
                given = name_of.format(axis)
                if value or key == "force":
                    values[given] = values.get(given, 0.0) + float(value)
        if not any(values.values()) and load.torque is None:
            draft.omit(path, "has neither torque nor force in the file")
        id = draft.part(
            "external_load",
            name,
            shaft,
            u_coordinate_on_shaft=float(load.position[2]),
            transmits_torque=True if balance or isinstance(load.torque, Constant) else None,
        )
        draft.loads[name] = id
        found[id] = {key: attribute(key, value, "external_load") for key, value in values.items()}
    return found


def load_spectra(draft: Draft, loads: Values, results: Mapping[str, Values]) -> tuple[RexsLoadSpectrum, ...]:
    """One load case for each scenario with speeds, with the results of its run, and for each load case.

    A scenario with the speeds and loads of a load case is not written twice. Without scenarios and load
    cases, the loads are one load case.

    Parameters
    ----------
    draft
        The draft, with all loads and shafts.
    loads
        Values of the external loads.
    results
        Results of the scenarios, by component.
    """
    model = draft.model
    own = {name: _of_load_case(draft, name, loads) for name in model.load_cases}
    moving: list[Values] = []
    others: list[Values] = []
    scenarios = {n: s for n, s in model.scenarios.items() if s.speed or n in results}
    for name, scenario in scenarios.items():
        case = own.get(scenario.load_case or "", {}) if model.load_case is None else {}
        acting = {id: case.get(id, values) for id, values in loads.items()}
        values = _with_speeds(draft, acting, f"scenarios.{name}.speed", scenario.speed)
        if name not in results and _plain(values) in [_plain(one) for one in (*own.values(), *moving)]:
            continue
        for id, more in results.get(name, {}).items():
            values.setdefault(id, {}).update(more)
        (moving if scenario.speed else others).append(values)
    # the import takes the first load case: one with speeds
    cases = [*moving, *own.values(), *others]
    for number, name in enumerate(own, len(moving) + 1):
        draft.omit(f"load_cases.{name}", f"is load case {number} of the file, which has no names of them")
    if not cases and loads:
        cases.append({id: dict(one) for id, one in loads.items()})
    for name, scenario in model.scenarios.items():
        if name not in scenarios:
            draft.omit(f"scenarios.{name}", "scenarios without speeds are not written")
        elif scenario.drive or scenario.hold:
            draft.omit(f"scenarios.{name}", "prescribed motions are not written, only speeds")
    numbered = tuple(RexsLoadCase(k, values) for k, values in enumerate(cases, 1))
    return (RexsLoadSpectrum(1, numbered),) if numbered else ()


def _plain(values: Values) -> dict[tuple[int, str], object]:
    """Speeds and loads of a load case, to compare it with others."""
    left = ("operating_time_fraction", "temperature_lubricant")
    return {
        (id, name): one.value
        for id, found in values.items()
        for name, one in found.items()
        if name not in left
    }


def _with_speeds(draft: Draft, loads: Values, path: str, speeds: Mapping[str, float]) -> Values:
    """Values of the loads, and of the shafts with a speed."""
    values: Values = {id: dict(one) for id, one in loads.items()}
    for body, speed in speeds.items():
        id = draft.shafts.get(body)
        if id is None:
            draft.omit(f"{path}.{body}", "is not a shaft of the file")
            continue
        one = draft.components[id]
        flag = attribute("defines_speed", True, "shaft")
        draft.components[id] = replace(one, attributes={**one.attributes, "defines_speed": flag})
        values.setdefault(id, {})["rotational_speed"] = attribute("rotational_speed", speed, "shaft")
    return values


def _of_load_case(draft: Draft, name: str, loads: Values) -> Values:
    """Values of a load case: its speeds, loads, temperature and share of the time."""
    from pitchpoint.model.scenario import Scenario

    case = draft.model.load_cases[name]
    path = f"load_cases.{name}"
    values = _with_speeds(draft, loads, f"{path}.speed", case.speed)
    speeds = draft.model.start_speeds(Scenario(speed=case.speed)) if case.speed else {}
    for load, change in case.loads.items():
        id = draft.loads.get(load)
        if id is None:
            draft.omit(f"{path}.loads.{load}", "is not a load of the file")
            continue
        found = values.setdefault(id, {})
        body = draft.model.loads[load].body
        torque = change.torque
        if change.power is not None:
            torque = change.power / speeds[body.partition(".")[0]]
        if torque is not None:
            found["torque_around_u_axis"] = attribute("torque_around_u_axis", torque, "external_load")
        if change.force is not None:
            along = TO_MODEL @ (draft.frame(body)[1].T @ np.array(change.force))
            for axis, value in zip("uvw", along, strict=True):
                key = f"force_{axis}_direction"
                found[key] = attribute(key, float(value), "external_load")
    if case.temperature is not None:
        temperature = attribute("temperature_lubricant", case.temperature, "gear_casing")
        values.setdefault(draft.casing, {})["temperature_lubricant"] = temperature
    if case.load_duration_fraction is not None:
        share = attribute("operating_time_fraction", case.load_duration_fraction, "gear_unit")
        values.setdefault(draft.unit, {})["operating_time_fraction"] = share
    return values
