# SPDX-License-Identifier: Apache-2.0
"""Tables of housing, lubricant and load cases for `check`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pitchpoint.cli.output import show, show_tables, shown, table


def show_gearbox(found: Mapping[str, Any]) -> None:
    """Print housing, lubricant and load cases, as far as the model has them."""
    from pitchpoint.report.machine_tables import load_case_table

    show_housing(found["housing"])
    if oil := found["lubricant"]:
        viscosity = shown(oil["dynamic_viscosity"], "dynamic_viscosity", 4)
        alpha = shown(oil["pressure_viscosity"], "pressure_viscosity", 4)
        at = shown(oil["temperature"], "temperature", 4)
        show(f"lubricant: {oil['name']}, at {at} {viscosity}, pressure-viscosity coefficient {alpha}")
    show_tables(load_case_table(found["load_cases"]))


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
