# SPDX-License-Identifier: Apache-2.0
"""Tables of housing, lubricant and load cases for `check`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pitchpoint.cli.output import NOTHING, show, shown, table
from pitchpoint.core.words import ranges

DIMENSIONS = {"torque": "torque", "power": "power", "force": "force"}
"""Dimensions of the values of a load in a load case."""


def show_gearbox(found: Mapping[str, Any]) -> None:
    """Print housing, lubricant and load cases, as far as the model has them."""
    show_housing(found["housing"])
    if oil := found["lubricant"]:
        viscosity = shown(oil["dynamic_viscosity"], "dynamic_viscosity", 4)
        alpha = shown(oil["pressure_viscosity"], "pressure_viscosity", 4)
        at = shown(oil["temperature"], "temperature", 4)
        show(f"lubricant: {oil['name']}, at {at} {viscosity}, pressure-viscosity coefficient {alpha}")
    _show_load_cases(found["load_cases"])


def _show_load_cases(cases: Mapping[str, Mapping[str, Any]]) -> None:
    timed = any(case["load_duration"] is not None for case in cases.values())
    rows = [
        [
            name + _where(case),
            _listed({body: shown(rate, "angular_speed", 6) for body, rate in case["speed"].items()}),
            _listed({load: _values(change) for load, change in case["loads"].items()}),
            shown(case["temperature"], "temperature", 4),
            NOTHING
            if case["load_duration_fraction"] is None
            else f"{100.0 * case['load_duration_fraction']:.4g} %",
            *([] if not timed else [_hours(case["load_duration"])]),
        ]
        for name, case in cases.items()
    ]
    if rows:
        head = [
            "load case",
            "speed",
            "loads",
            "temperature",
            "share of the time",
            *(["time"] if timed else []),
        ]
        table("Load cases", head, rows)


def _where(case: Mapping[str, Any]) -> str:
    """Where a load case is in effect."""
    if case["in_effect"]:
        return " (in effect)"
    return f" (in {ranges(case['scenarios'])})" if case["scenarios"] else ""


def _hours(time: float | None) -> str:
    return NOTHING if time is None else f"{time / 3600.0:.6g} h"


def _values(change: Mapping[str, Any]) -> str:
    """Values of one load as text."""
    found = []
    for key, value in change.items():
        each = value if isinstance(value, tuple) else (value,)
        text = ", ".join(shown(one, DIMENSIONS[key], 6) for one in each)
        found.append(f"[{text}]" if isinstance(value, tuple) else text)
    return ", ".join(found)


def _listed(words: Mapping[str, str]) -> str:
    return ", ".join(f"{name} {text}" for name, text in words.items()) or NOTHING


def show_housing(housing: Mapping[str, Any]) -> None:
    """Print the seats of the bearings in the housing, if the model has one."""
    if housing["type"] is None:
        return
    stiff = any(seat["stiffness"] for seat in housing["seats"].values())
    head = ["bearing or node", "seat", *(f"stiffness {way}" for way in "xyz" if stiff)]
    rows = [
        [name, seat["seat"], *(shown(k, "stiffness", 4) for k in seat["stiffness"] or [None] * 3 * stiff)]
        for name, seat in housing["seats"].items()
    ]
    notes = (
        ["stiffness: of the node along the axes of the matrix, with the other nodes free"] if stiff else []
    )
    if housing["parts"]:
        notes.insert(0, f"fixed in the housing: {', '.join(housing['parts'])}")
    table(f"Housing: {housing['words']}", head, rows, notes)


def without_nodes(found: Mapping[str, Any]) -> dict[str, Any]:
    """The data of `check` without the bodies and joints that represent the nodes of a housing matrix."""
    hidden = found["housing"]["hidden"]
    fewer = {
        group: {n: p for n, p in found[group].items() if n not in hidden} for group in ("bodies", "joints")
    }
    return {**found, **fewer}
