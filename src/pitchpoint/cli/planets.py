# SPDX-License-Identifier: Apache-2.0
"""Tables of planetary stages for `check` and `gears`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pitchpoint.cli.output import shown, table

TITLES = {
    "angle": "angle",
    "phase_sun": "phase, sun mesh",
    "phase_ring": "phase, ring mesh",
    "tangential_pin_error": "tangential pin error",
    "radial_pin_error": "radial pin error",
}
ERRORS = ("tangential_pin_error", "radial_pin_error")


def show_stages(stages: Mapping[str, Mapping[str, Any]]) -> None:
    """Print angle, mesh phases and pin error of every planet; phases are in base pitches."""
    for name, stage in stages.items():
        planets = stage["planets"]
        columns = [
            key
            for key in TITLES
            if any(key in row for row in planets.values())
            and (key not in ERRORS or any(row[key] for row in planets.values()))
        ]
        rows = [
            [planet, *(_cell(key, row[key]) for key in columns if key in row)]
            for planet, row in planets.items()
        ]
        notes = []
        if stage["center_distance"] is not None:
            notes.append(f"centre distance {shown(stage['center_distance'], 'length')}")
        if stage["planet_gap"] is not None:
            notes.append(f"distance between neighbouring planets {shown(stage['planet_gap'], 'length', 4)}")
        title = f"Planetary stage {name}: planets on {stage['carrier']}"
        table(title, ["planet", *(TITLES[key] for key in columns)], rows, notes)


def _cell(key: str, value: float) -> str:
    if key.startswith("phase"):
        return f"{value:.4f}"
    if key == "angle":
        return shown(value, "angle")
    return shown(value, "length", 4)
