# SPDX-License-Identifier: Apache-2.0
"""Power flow at constant speed in `pitchpoint check`: shafts, meshes, couplings, rolling bearings."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from typing import Any

from pitchpoint.cli.output import NOTHING, show, show_notes, shown, table
from pitchpoint.core.words import ranges

MAX_FLOWS = 3
"""Largest number of power flows that are printed without `--scenario`."""
ZERO = 1e-9
"""Share of the largest torque that counts as none."""
SHAFT = ["shaft", "gears", "speed", "ratio", "frequency", "torque", "power", "driven by", "drives"]
MESH = ["mesh", "gears", "z", "i", "T_1", "T_2", "F_wt", "F_wr", "F_a", "v_w", "f_z"]
BEARING = ["bearing", "inner ring", "outer ring", "FTF", "BPFO", "BPFI", "BSF"]
SYMBOLS = (
    "T_1, T_2 on gears 1 and 2, anticlockwise about z; F_wt tangential, F_wr radial, F_a axial force on",
    "gear 1 (along z) at the operating pitch circle; bevel gears: mean pitch circle, away from the apex;",
    "v_w pitch-line velocity; f_z mesh frequency",
)


def show_power_flows(flows: Mapping[str, Mapping[str, Any]]) -> None:
    """Print the power flow of all scenarios; those with equal tables together.

    Parameters
    ----------
    flows
        Power flows by scenario, see `report.static_power`.
    """
    groups: list[tuple[list[str], list[str], Mapping[str, Any]]] = []
    ordered = sorted(flows.items(), key=lambda item: not item[1].get("turns", False))
    for name, flow in ordered:
        for names, resting, other in groups:
            if _equal(flow, other):
                names.append(name)
                break
            if not flow.get("turns", True) and flow.get("external") and _torques(flow) == _torques(other):
                resting.append(name)
                break
        else:
            groups.append(([name], [], flow))
    for names, resting, flow in groups[:MAX_FLOWS]:
        _show(names, flow)
        if resting:
            show(f"at rest the same torques in {ranges(resting)}")
    if more := [ranges(names) for names, *_ in groups[MAX_FLOWS:]]:
        show(f"power flow in other scenarios, with --scenario: {ranges(more)}")


def _equal(one: Mapping[str, Any], other: Mapping[str, Any]) -> bool:
    return {**one, "notes": None} == {**other, "notes": None}


def _torques(flow: Mapping[str, Any]) -> list[tuple[str, str]]:
    """External torques by name, without round-off."""
    return [(row["name"], shown(row["torque"], "torque", 6)) for row in flow.get("external", ())]


def _show(names: Sequence[str], flow: Mapping[str, Any]) -> None:
    """Print one power flow."""
    place = f" in {ranges(names)}" if any(names) else ""
    if "failure" in flow:
        show(f"power flow{place}: not known; {flow['failure']}")
        return
    table(f"Power flow{place}: {_summary(flow)}", SHAFT, _shafts(flow))
    rows = _meshes(flow)
    if rows:
        table("Meshes", MESH, rows, SYMBOLS)
    rows = [
        [
            name,
            row["section"].replace("_", " "),
            " - ".join(row["bodies"]),
            shown(_largest(row["torques"]), "torque", 5),
        ]
        for name, row in flow["links"].items()
        if "gears" not in row
    ]
    if rows:
        table("Couplings and ratios", ["name", "section", "bodies", "torque"], rows)
    rows = [
        [name, *(_speed(row[key]) for key in ("speed_inner", "speed_outer"))]
        + [_hertz(row[key]) for key in ("ftf", "bpfo", "bpfi", "bsf")]
        for name, row in flow["bearings"].items()
    ]
    if rows:
        table("Rolling bearings: speeds and frequencies", BEARING, rows)
    show_notes(flow["notes"])


def _summary(flow: Mapping[str, Any]) -> str:
    """Power or torque from the inputs to the outputs, in words."""
    sides: dict[str, list[str]] = {"from": [], "to": [], "held by": []}
    largest = max((abs(row["torque"] or 0.0) for row in flow["external"]), default=0.0)
    for row in flow["external"]:
        torque = row["torque"]
        if torque is None or abs(torque) <= ZERO * largest:
            continue
        power = row["power"]
        words = f"{row['name']} ({shown(torque, 'torque', 5)})"
        if not flow["turns"]:
            sides["from"].append(words)
        elif power:
            sides["from" if power > 0.0 else "to"].append(words)
        else:
            sides["held by"].append(words)
    parts = [f"{word} {ranges(sides[word])}" for word in sides if sides[word]]
    size = "at rest" if not flow["turns"] else shown(flow["power_in"], "power", 5)
    if flow["turns"] and flow["power_in"] is None:
        size = "loads and speeds"
    return ", ".join([" ".join([size, *parts[:1]]), *parts[1:]]) + "; no losses"


def _shafts(flow: Mapping[str, Any]) -> list[list[str]]:
    """Rows of shafts; those with equal numbers are one."""
    rows = [
        (
            [[name], row["gears"], row["driven_by"], row["drives"]],
            [
                _speed(row["speed"]),
                NOTHING if row["ratio"] is None else f"{round(row['ratio'], 9) + 0.0:.7g}",
                _hertz(row["frequency"]),
                shown(row["torque"], "torque", 5),
                shown(row["power"] or None, "power", 5),
            ],
        )
        for name, row in flow["shafts"].items()
    ]
    return [
        [shaft, gears, *cells, inputs, outputs] for (shaft, gears, inputs, outputs), cells in _merged(rows)
    ]


def _meshes(flow: Mapping[str, Any]) -> list[list[str]]:
    """Rows of meshes; those with equal numbers are one."""
    rows = [
        (
            [[name], *([gear] for gear in row["gears"])],
            [
                " / ".join(map(str, row["teeth"])),
                f"{row['ratio']:.7g}",
                *(shown(torque, "torque", 5) for torque in row["torques"]),
                *(
                    shown(row[key] or None, "force", 5)
                    for key in ("tangential_force", "radial_force", "axial_force")
                ),
                shown(row["pitch_line_velocity"] or None, "speed", 4),
                _hertz(row["mesh_frequency"]),
            ],
        )
        for name, row in flow["links"].items()
        if "gears" in row
    ]
    return [[mesh, f"{one} / {two}", *cells] for (mesh, one, two), cells in _merged(rows)]


def _merged(rows: Sequence[tuple[list[list[str]], list[str]]]) -> list[tuple[list[str], list[str]]]:
    """Rows of names and cells; rows with equal cells whose names differ only by numbers are one."""
    groups: dict[tuple[Any, ...], list[list[list[str]]]] = {}
    for names, cells in rows:
        alike = tuple(tuple(re.sub(r"\d+", "#", name) for name in each) for each in names)
        groups.setdefault((alike, tuple(cells)), []).append(names)
    return [
        ([ranges([n for each in column for n in each]) for column in zip(*group, strict=True)], list(cells))
        for (_, cells), group in groups.items()
    ]


def _largest(values: Sequence[float | None]) -> float | None:
    known = [abs(value) for value in values if value is not None]
    return max(known) if known else None


def _hertz(frequency: float | None) -> str:
    return shown(frequency or None, "frequency", 6)


def _speed(speed: float | None) -> str:
    if speed is None:
        return NOTHING
    return "at rest" if speed == 0.0 else f"{round(speed * 30.0 / math.pi, 9) + 0.0:.7g} rpm"
