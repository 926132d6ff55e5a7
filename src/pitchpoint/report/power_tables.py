# SPDX-License-Identifier: Apache-2.0
"""Tables of the power flow at constant speed, as texts, for `pitchpoint check` and the report."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from pitchpoint.core.units import format_quantity
from pitchpoint.core.words import ranges

NOTHING = "–"
TORQUE, FORCE = "torque", "force"
"""Dimensions."""
SPRING = "torsion_springs"
"""Section of the springs of scissor gears."""
ZERO = 1e-9
"""Share of the largest torque that counts as none."""
SHAFT = ("shaft", "gears", "speed", "ratio", "frequency", TORQUE, "power", "driven by", "drives")
MESH = ("mesh", "gears", "z", "i", "T_1", "T_2", "F_wt", "F_wr", "F_a", "v_w", "f_z")
BEARING = ("bearing", "inner ring", "outer ring", "FTF", "BPFO", "BPFI", "BSF")
SYMBOLS = (
    "T_1, T_2 on gears 1 and 2, counter-clockwise about z; F_wt tangential, F_wr radial, F_a axial force on",
    "gear 1 (along z) at the operating pitch circle; bevel gears: mean pitch circle, away from the apex;",
    "v_w pitch-line velocity; f_z mesh frequency",
)


@dataclass(frozen=True)
class PowerTable:
    """A table as texts.

    Attributes
    ----------
    title
        Title.
    head, rows
        Heads of the columns, and rows.
    notes
        Lines below the table.
    """

    title: str
    head: Sequence[str]
    rows: Sequence[Sequence[str]]
    notes: Sequence[str] = ()


@dataclass(frozen=True)
class FlowText:
    """Power flow of scenarios with equal numbers.

    Attributes
    ----------
    names
        Scenarios.
    summary
        Power from the inputs to the outputs, in words.
    tables
        Shafts, meshes, couplings, rolling bearings.
    notes
        What is assumed or not known.
    """

    names: Sequence[str]
    summary: str
    tables: Sequence[PowerTable]
    notes: Sequence[str]


def flow_texts(flows: Mapping[str, Mapping[str, Any]]) -> list[FlowText]:
    """Power flows of all scenarios; those with equal numbers, or equal torques at rest, together.

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
    return [_texts(names, resting, flow) for names, resting, flow in groups]


def further_flows(flows: Sequence[FlowText]) -> list[PowerTable]:
    """Table of the power flows without tables of their own: names of the scenarios and summary."""
    rows = [[ranges(flow.names), flow.summary] for flow in flows]
    return [PowerTable("Power flow in further scenarios", ("scenario", "power flow"), rows)] if rows else []


def _texts(names: Sequence[str], resting: Sequence[str], flow: Mapping[str, Any]) -> FlowText:
    """One power flow as texts."""
    if "failure" in flow:
        return FlowText(names, f"not known; {flow['failure']}", (), ())
    tables = [
        PowerTable("Shafts", SHAFT, _shafts(flow)),
        PowerTable("Meshes", MESH, _meshes(flow), SYMBOLS),
        PowerTable("Couplings and ratios", ("name", "section", "bodies", TORQUE), _others(flow)),
        PowerTable("Rolling bearings: speeds and frequencies", BEARING, _bearings(flow)),
    ]
    if not flow["turns"] and all(t is None for row in flow["links"].values() for t in row["torques"]):
        tables = []  # neither speeds nor torques are known
    rest = [f"at rest the same torques in {ranges(resting)}"] if resting else []
    return FlowText(names, _summary(flow), [t for t in tables if t.rows], [*flow["notes"], *rest])


def _equal(one: Mapping[str, Any], other: Mapping[str, Any]) -> bool:
    return {**one, "notes": None} == {**other, "notes": None}


def _torques(flow: Mapping[str, Any]) -> list[tuple[str, str]]:
    """External torques by name, without round-off."""
    return [(row["name"], shown(row[TORQUE], TORQUE, 6)) for row in flow.get("external", ())]


def _summary(flow: Mapping[str, Any]) -> str:
    """Power or torque from the inputs to the outputs, in words."""
    sides: dict[str, list[str]] = {"from": [], "to": [], "held by": []}
    largest = max((abs(row[TORQUE] or 0.0) for row in flow["external"]), default=0.0)
    for row in flow["external"]:
        torque = row[TORQUE]
        if torque is None or abs(torque) <= ZERO * largest or row["section"] == SPRING:
            continue  # springs of scissor gears are within the train
        power = row["power"]
        size = f"({shown(torque, 'torque', 5)})"
        words = f"{row['name']} {size}"
        if not flow["turns"]:
            sides["from"].append(words)
        elif power:
            sides["from" if power > 0.0 else "to"].append(words)
        else:
            name = row["name"].removesuffix(", held").removesuffix(", fixed")
            sides["held by"].append(f"{name} {size}")
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
                NOTHING if row["ratio"] is None else f"{round(row['ratio'], 9) + 0.0:.6g}",
                _hertz(row["frequency"]),
                shown(row[TORQUE], TORQUE, 5),
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
                f"{row['ratio']:.6g}",
                *(shown(torque, TORQUE, 5) for torque in row["torques"]),
                *(
                    shown(row[key] or None, FORCE, 5)
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
    return "at rest" if speed == 0.0 else f"{round(speed * 30.0 / math.pi, 9) + 0.0:.6g} rpm"


def _others(flow: Mapping[str, Any]) -> list[list[str]]:
    """Rows of couplings and ratios."""
    return [
        [
            name,
            row["section"].replace("_", " "),
            " - ".join(row["bodies"]),
            shown(_largest(row["torques"]), TORQUE, 5),
        ]
        for name, row in flow["links"].items()
        if "gears" not in row
    ]


def _bearings(flow: Mapping[str, Any]) -> list[list[str]]:
    """Rows of rolling bearings."""
    return [
        [name, *(_speed(row[key]) for key in ("speed_inner", "speed_outer"))]
        + [_hertz(row[key]) for key in ("ftf", "bpfo", "bpfi", "bsf")]
        for name, row in flow["bearings"].items()
    ]


def shown(value: float | None, dimension: str, digits: int) -> str:
    """Value in a customary unit; an en dash if there is none.

    Examples
    --------
    >>> shown(0.5, "length", 4), shown(None, "length", 4)
    ('500 mm', '–')
    """
    return NOTHING if value is None else format_quantity(value + 0.0, dimension, digits)
