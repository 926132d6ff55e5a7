# SPDX-License-Identifier: Apache-2.0
"""Loads of the planets of a run or slow roll, in the mean and over the positions of the carrier."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from pitchpoint.cli.output import show, shown, table

if TYPE_CHECKING:
    from pathlib import Path

    from pitchpoint.model.model import Model

WHOLE = 0.99
"""Turns of the carrier that count as a whole turn: the teeth deflect."""


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
