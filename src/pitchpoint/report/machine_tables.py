# SPDX-License-Identifier: Apache-2.0
"""Tables of the machine as texts, for `pitchpoint check` and the report: load cases, planetary stages,
scissor gears, ring modes, rolling bearings."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from pitchpoint.core.words import ranges
from pitchpoint.report.power_tables import FORCE, NOTHING, TORQUE, PowerTable, shown

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

ERRORS = {"tangential_pin_error": "tangential pin error", "radial_pin_error": "radial pin error"}
ROUNDING = 1e-13
"""Angle that counts as zero [rad]."""


def machine_tables(model: Model) -> list[PowerTable]:
    """Tables of a model; those without rows are omitted."""
    from pitchpoint.report.load_cases import load_case_facts
    from pitchpoint.report.planets import stages_of_model
    from pitchpoint.report.scissor_gears import scissors_of_model
    from pitchpoint.system.rules.flexible_rim import rim_facts

    found = [
        load_case_table(load_case_facts(model)),
        *stage_tables(stages_of_model(model)),
        scissor_table(scissors_of_model(model)),
        rim_table(rim_facts(model)),
        bearing_table(model),
    ]
    return [table for table in found if table.rows]


def load_case_table(cases: Mapping[str, Mapping[str, Any]]) -> PowerTable:
    """Speeds, loads and share of the time of every load case, from `load_case_facts`."""
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
    head = ["load case", "speeds", "loads", "temperature", "share of the time", *(["time"] if timed else [])]
    return PowerTable("Load cases", head, rows)


def _where(case: Mapping[str, Any]) -> str:
    """Where a load case is in effect."""
    if case["in_effect"]:
        return " (in effect)"
    return f" (in {ranges(case['scenarios'])})" if case["scenarios"] else ""


def _hours(time: float | None) -> str:
    return NOTHING if time is None else f"{time / 3600.0:.6g} h"


def _values(change: Mapping[str, Any]) -> str:
    """Values of one load as text, by their dimensions: torque, power, force."""
    found = []
    for key, value in change.items():
        each = value if isinstance(value, tuple) else (value,)
        text = ", ".join(shown(one, key, 6) for one in each)
        found.append(f"[{text}]" if isinstance(value, tuple) else text)
    return ", ".join(found)


def _listed(words: Mapping[str, str]) -> str:
    return ", ".join(f"{name} {text}" for name, text in words.items()) or NOTHING


def stage_tables(stages: Mapping[str, Mapping[str, Any]]) -> list[PowerTable]:
    """Angle, mesh phases [base pitches] and pin error of every planet, from `stages_of_model`."""
    found = []
    for name, stage in stages.items():
        planets = stage["planets"]
        errors = [key for key in ERRORS if any(row[key] for row in planets.values())]
        rows = [
            [
                planet,
                _angle(row["angle"], 7),
                *(f"{row['phases'][mate]:.4f}" for mate in stage["mates"]),
                *(_angle(angle, 5) for angle in row["orientations"].values()),
                *(shown(row[key], "length", 4) for key in errors),
            ]
            for planet, row in planets.items()
        ]
        notes = []
        if stage["center_distance"] is not None:
            notes.append(f"centre distance {shown(stage['center_distance'], 'length', 7)}")
        if stage["planet_gap"] is not None:
            notes.append(f"distance between neighbouring planets {shown(stage['planet_gap'], 'length', 4)}")
        if stage["ring_after_sun"] is not None:
            notes.append(
                f"flanks pass the pitch point with {stage['ring']} {stage['ring_after_sun']:.4f} mesh cycles "
                f"after those with {stage['sun']}, if {stage['sun']} drives"
            )
        steps = next(iter(planets.values()))["orientations"]
        columns = ["angle", *(f"phase, {mate}" for mate in stage["mates"])]
        columns += [*(f"teeth of {step}" for step in steps), *(ERRORS[key] for key in errors)]
        title = f"Planetary stage {name}: planets on {stage['carrier']}"
        found.append(PowerTable(title, ["planet", *columns], rows, notes))
    return found


def _angle(angle: float, digits: int) -> str:
    return shown(angle if abs(angle) >= ROUNDING else 0.0, "angle", digits)


def scissor_table(scissors: Mapping[str, Mapping[str, Any]]) -> PowerTable:
    """Backlash taken up, torque of the spring in mesh and flank force, from `scissors_of_model`."""
    head = ["free half", "next to", "face widths", "backlash taken up", "twist in mesh"]
    head += ["torque of the spring", "flank force"]
    rows = [
        [
            name,
            f"{row['gear']} of {row['body']}",
            " + ".join(shown(width, "length", 7) for width in row["face_widths"]),
            shown(row["backlash"], "length", 4),
            shown(row["twist"], "angle", 3),
            shown(row["spring_torque"], TORQUE, 4),
            shown(row["flank_force"], FORCE, 4),
        ]
        for name, row in scissors.items()
    ]
    notes = [
        "backlash along the base tangent; the fixed half lifts off at a load, with inertia torques, above "
        "the spring torque and against it"
    ]
    return PowerTable("Scissor gears", head, rows, notes)


def rim_table(rims: Mapping[str, Mapping[str, Any]]) -> PowerTable:
    """Natural frequencies of flexible rims, from `system.rules.flexible_rim.rim_facts`."""
    rows = []
    for name, rim in rims.items():
        for k, (n, free) in enumerate(zip(rim["waves"], rim["free"], strict=True)):
            held = rim["supported"][k] if rim["supported"] else []
            words = ", ".join(shown(f, "frequency", 5) for f in held) or "no supports"
            rows.append([name, str(n), shown(free, "frequency", 5), words])
    return PowerTable("Ring modes without planets", ["gear", "waves n", "free rim", "on its supports"], rows)


def bearing_table(model: Model) -> PowerTable:
    """Data of rolling bearings, given or estimated."""
    from pitchpoint.report.bearing_data import HEAD, bearing_lines

    rows, notes = bearing_lines(model)
    return PowerTable("Rolling bearings", HEAD, rows, notes)
