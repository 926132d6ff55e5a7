# SPDX-License-Identifier: Apache-2.0
"""Tables of planetary stages: places and phases for `check` and `gears`, loads for `run`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from pitchpoint.cli.output import show, shown, table

if TYPE_CHECKING:
    from pathlib import Path

    from pitchpoint.model.model import Model

WHOLE = 0.99
"""Turns of the carrier that count as a whole turn: the teeth deflect."""
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


def with_stored_positions(
    model: Model, loads: dict[str, dict[str, Any]], target: Path, settle_time: float = 0.0
) -> dict[str, dict[str, Any]]:
    """Loads of the planets with the extremes of their shares over the carrier positions in a result file."""
    if not loads:
        return loads
    from pitchpoint.io.reading import open_result
    from pitchpoint.system.planet_positions import with_positions

    with open_result(target) as data:
        return with_positions(model, loads, data, settle_time)


def show_planets(loads: Mapping[str, Mapping[str, Any]]) -> None:
    """Print mean mesh force and share of every planet, its shares over the carrier positions, and K_γ."""
    for stage, found in loads.items():
        if found["load_sharing_factor"] is None:
            show(f"{stage}: no load on the planets, no mesh load factor K_γ")
            continue
        means = zip(found["planets"], found["meshes"], found["mean_force"], found["share"], strict=True)
        rows = [[name, mesh, shown(force, "force", 5), _percent(part)] for name, mesh, force, part in means]
        head = ["planet", "mesh", "mean mesh force", "share"]
        title, notes = f"{stage}: mesh load factor K_γ = {found['load_sharing_factor']:.4f}", []
        positions = found.get("positions")
        if positions is not None:
            head += ["smallest", "largest"]
            extremes = zip(positions["least_share"], positions["largest_share"], strict=True)
            rows = [[*row, *map(_percent, pair)] for row, pair in zip(rows, extremes, strict=True)]
            title += f" of the means, largest at a carrier position {positions['load_sharing_factor']:.4f}"
            notes.append(position_words(positions))
        table(title, head, rows, notes)


def position_words(positions: Mapping[str, Any]) -> str:
    """Where the largest K_γ is, and over which positions of the carrier.

    Examples
    --------
    >>> position_words({"carrier_angle": 1.5707963, "turns": 1.5})
    'largest K_γ at a carrier angle of 90 deg; shares over 1/12 turn each, in 1.5 turns of the carrier'
    """
    turns = positions["turns"]
    words = f"{turns:.3g} turn{'s' if turns >= WHOLE + 0.01 else ''} of the carrier"
    part = ", which is less than all positions" if turns < WHOLE else ""
    angle = shown(positions["carrier_angle"], "angle", 3)
    return f"largest K_γ at a carrier angle of {angle}; shares over 1/12 turn each, in {words}{part}"


def _percent(share: float) -> str:
    return f"{round(100.0 * share, 2) + 0.0:.2f} %"
