# SPDX-License-Identifier: Apache-2.0
"""Slow roll for `run` and `report`: into a result file, into JSON, into a table for people."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from pitchpoint.cli.output import shown, table

if TYPE_CHECKING:
    from pathlib import Path

    from pitchpoint.model.model import Model
    from pitchpoint.solvers.quasistatic import Roll, Table

NOT_BEGUN: dict[str, Any] = {"steps": 0, "mesh": None, "periods_rolled": [], "meshes": {}, "channels": {}}
"""What is empty of a roll that failed before its first point."""


def compute(
    model: Model, file: str, name: str, target: Path, *, quiet: bool = False
) -> tuple[dict[str, Any], BaseException | None]:
    """Roll through a scenario into a file; gives what `run --json` prints, and what stopped it early."""
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.cli.results import header_of, how_a_status_ends
    from pitchpoint.core.errors import SolverError
    from pitchpoint.core.status import OK
    from pitchpoint.solvers.quasistatic import roll_through, statistics, tables
    from pitchpoint.system.compile import compile_model

    begun = time.perf_counter()
    chosen = model.scenarios[name]
    system = compile_model(model, chosen)
    with ProgressDisplay(f"run {name}", "points", quiet=quiet) as progress:
        roll = roll_through(system, chosen, progress=progress)
    found = tables(system, roll)
    channels = {t.name: statistics(t) for t in found if t.rolled and len(t.values)}
    status = how_a_status_ends(roll.status)
    store(target, header_of(model, file, name, "quasi_static", "quasistatic"), roll, found, status)
    summary = {
        "status": status,
        "sentence": roll.sentence,
        "steps": len(roll.position),
        "wall_s": time.perf_counter() - begun,
        "mesh": roll.mesh,
        "output": str(target),
        "notes": list(roll.notes),
        "periods_rolled": roll.position,
        "meshes": {name: numbers(name, roll, found) for name in roll.meshes},
        "channels": channels,
    }
    return summary, None if roll.status == OK else SolverError(roll.sentence, roll.status, str(target))


def store(path: Path, header: Any, roll: Roll, found: list[Table], status: str) -> None:
    """Write a roll to a result file, over the periods rolled."""
    from pitchpoint.io.tables import Axis, Quantity, write_tables
    from pitchpoint.solvers.quasistatic import DIMENSION

    words = f"periods of {roll.mesh} rolled"
    axis = Axis(DIMENSION, [float(p) for p in roll.position], "1", words)
    filled = [(Quantity(t.name, (DIMENSION,) * t.rolled, t.unit, t.long_name), t.values) for t in found]
    write_tables(
        path,
        header,
        [axis],
        filled,
        status=status,
        sentence=roll.sentence,
        code=roll.status,
        steps=len(roll.position),
        notes=roll.notes,
    )


def numbers(mesh: str, roll: Roll, found: list[Table]) -> dict[str, Any]:
    """Collect what is read first of one mesh: both transmission errors and the stiffness [SI]."""
    by_name = {t.name: t.values for t in found}
    stiffness = roll.meshes[mesh].tangent_stiffness
    return {
        "transmission_error": by_name[f"transmission_error[{mesh}]"],
        "unloaded_transmission_error": by_name[f"unloaded_transmission_error[{mesh}]"],
        "tangent_stiffness": stiffness,
        "mesh_phase": by_name[f"mesh_phase[{mesh}]"],
        "load_share": [share.tolist() for share in roll.meshes[mesh].share.T],
        "transmission_error_mean": by_name[f"transmission_error_mean[{mesh}]"],
        "transmission_error_peak_to_peak": by_name[f"transmission_error_peak_to_peak[{mesh}]"],
        "unloaded_transmission_error_mean": by_name[f"unloaded_transmission_error_mean[{mesh}]"],
        "unloaded_transmission_error_peak_to_peak": by_name[
            f"unloaded_transmission_error_peak_to_peak[{mesh}]"
        ],
        "mean_stiffness": float(stiffness[: max(len(stiffness) - 1, 1)].mean()) if len(stiffness) else None,
    }


def show_roll(title: str, summary: dict[str, Any]) -> None:
    """Show transmission errors and stiffness of every mesh."""
    rows = []
    for name, mesh in summary["meshes"].items():
        force = summary["channels"][f"mesh_force[{name}]"]
        rows += [
            [f"{name}: mesh force, mean", shown(force["mean"], "force", 5)],
            ["  transmission error, mean", shown(mesh["transmission_error_mean"], "length", 5)],
            ["  peak to peak", shown(mesh["transmission_error_peak_to_peak"], "length", 4)],
            ["  without load, mean", shown(mesh["unloaded_transmission_error_mean"], "length", 5)],
            ["  peak to peak", shown(_quiet(mesh), "length", 4)],
            ["  mesh stiffness, mean", shown(mesh["mean_stiffness"], "stiffness", 5)],
        ]
    table(title, ["slow roll", "value"], rows)


def _quiet(mesh: dict[str, Any]) -> float:
    """Range of the error without load; what is only round-off becomes zero."""
    span = float(mesh["unloaded_transmission_error_peak_to_peak"])
    return span if span > 1e-12 else 0.0
