# SPDX-License-Identifier: Apache-2.0
"""Tables of planetary stages for `check` and `gears`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pitchpoint.cli.output import shown, table

ERRORS = {"tangential_pin_error": "tangential pin error", "radial_pin_error": "radial pin error"}


def show_stages(stages: Mapping[str, Mapping[str, Any]]) -> None:
    """Print angle, mesh phases and pin error of every planet; phases are in base pitches."""
    for name, stage in stages.items():
        planets = stage["planets"]
        errors = [key for key in ERRORS if any(row[key] for row in planets.values())]
        rows = [
            [
                planet,
                shown(row["angle"], "angle"),
                *(f"{row['phases'][mate]:.4f}" for mate in stage["mates"]),
                *(shown(angle, "angle", 5) for angle in row["orientations"].values()),
                *(shown(row[key], "length", 4) for key in errors),
            ]
            for planet, row in planets.items()
        ]
        notes = []
        if stage["center_distance"] is not None:
            notes.append(f"centre distance {shown(stage['center_distance'], 'length')}")
        if stage["planet_gap"] is not None:
            notes.append(f"distance between neighbouring planets {shown(stage['planet_gap'], 'length', 4)}")
        title = f"Planetary stage {name}: planets on {stage['carrier']}"
        if stage["ring_after_sun"] is not None:
            notes.append(
                f"flanks pass the pitch point with {stage['ring']} {stage['ring_after_sun']:.4f} mesh cycles "
                f"after those with {stage['sun']}, if {stage['sun']} drives"
            )
        steps = next(iter(planets.values()))["orientations"]
        columns = ["angle", *(f"phase, {mate}" for mate in stage["mates"])]
        columns += [*(f"teeth of {step}" for step in steps), *(ERRORS[key] for key in errors)]
        table(title, ["planet", *columns], rows, notes)
