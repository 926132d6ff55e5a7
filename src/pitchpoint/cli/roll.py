# SPDX-License-Identifier: Apache-2.0
"""Slow roll for `run` and `report`: result file, JSON, printed table."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from pitchpoint.cli.output import NOTHING, shown, table

if TYPE_CHECKING:
    from pathlib import Path

    from pitchpoint.model.model import Model
    from pitchpoint.solvers.quasistatic.roll import Roll, Table

WORDS = (
    "mesh force, mean",
    "transmission error, mean",
    "peak to peak",
    "without load, mean",
    "without load, peak to peak",
    "mesh stiffness, mean",
)
"""Printed quantities of a mesh after a slow roll."""
SIZES = [
    f"{load}transmission_error_{size}" for load in ("", "unloaded_") for size in ("mean", "peak_to_peak")
]
FORCES = ("Bearings", "Connections")
"""Groups of main channels that are printed as a second table."""
ROUND_OFF = 1e-12
"""Lengths below this are shown as zero [m]."""

NOT_BEGUN: dict[str, Any] = {
    "steps": 0,
    "mesh": None,
    "periods_rolled": [],
    "meshes": {},
    "channels": {},
    "planet_loads": {},
}
"""Parts of the summary that are empty if a roll fails before its first point."""


def compute(
    model: Model, file: str, name: str, target: Path, *, quiet: bool = False
) -> tuple[dict[str, Any], BaseException | None]:
    """Compute a slow roll into a file; return the output of `run --json`, and the error that stopped it."""
    from pitchpoint.cli.planet_loads import with_stored_positions
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.cli.results import header_of, how_a_status_ends
    from pitchpoint.core.errors import SolverError
    from pitchpoint.core.status import OK
    from pitchpoint.report.bearing_loads import loads_above_ratings
    from pitchpoint.solvers.quasistatic.roll import roll_through, statistics, tables
    from pitchpoint.system.compile import compile_model
    from pitchpoint.system.no_load import unloaded_meshes
    from pitchpoint.system.planet_loads import loads_in

    begun = time.perf_counter()
    chosen = model.scenarios[name]
    system = compile_model(model, chosen)
    with ProgressDisplay(f"run {name}", "points", quiet=quiet) as progress:
        roll = roll_through(system, chosen, progress=progress)
    found = tables(system, roll)
    channels = {t.name: statistics(t) for t in found if t.rolled and len(t.values)}
    status = how_a_status_ends(roll.status)
    notes = [*roll.notes, *roll.cycle_notes, *loads_above_ratings(model, channels)]
    store(target, header_of(model, file, name, "quasi_static", "quasistatic"), roll, found, status, notes)
    meshes = {name: numbers(name, roll, found) for name in roll.meshes}
    for name in unloaded_meshes(model, channels) & meshes.keys():
        meshes[name]["mean_stiffness"] = None
    summary = {
        "status": status,
        "sentence": roll.sentence,
        "steps": len(roll.position),
        "wall_s": time.perf_counter() - begun,
        "mesh": roll.mesh,
        "output": str(target),
        "notes": notes,
        "periods_rolled": roll.position,
        "meshes": meshes,
        "channels": channels,
        "planet_loads": with_stored_positions(model, loads_in(model, channels), target),
    }
    return summary, None if roll.status == OK else SolverError(roll.sentence, roll.status, str(target))


def store(path: Path, header: Any, roll: Roll, found: list[Table], status: str, notes: Sequence[str]) -> None:
    """Write a roll to a result file, over its periods."""
    from pitchpoint.io.tables import Axis, Quantity, write_tables
    from pitchpoint.solvers.quasistatic.roll import DIMENSION

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
        notes=notes,
    )


def numbers(mesh: str, roll: Roll, found: list[Table]) -> dict[str, Any]:
    """Main results of one mesh: both transmission errors and the stiffness [SI]."""
    by_name = {t.name: t.values for t in found}
    stiffness = roll.meshes[mesh].tangent_stiffness
    return {
        "transmission_error": by_name[f"transmission_error[{mesh}]"],
        "unloaded_transmission_error": by_name[f"unloaded_transmission_error[{mesh}]"],
        "tangent_stiffness": stiffness,
        "mesh_phase": by_name[f"mesh_phase[{mesh}]"],
        "load_share": [share.tolist() for share in roll.meshes[mesh].share.T],
        **{name: by_name[f"{name}[{mesh}]"] for name in SIZES},
        "mean_stiffness": float(stiffness[: max(len(stiffness) - 1, 1)].mean()) if len(stiffness) else None,
        "repeats_after_periods": roll.meshes[mesh].repeats_after,
    }


def show_roll(title: str, summary: dict[str, Any]) -> None:
    """Print transmission errors and stiffness of every mesh, and mark incomplete periods."""
    rows = []
    periods = round(float(summary["periods_rolled"][-1]))
    for name, mesh in summary["meshes"].items():
        whole = mesh["repeats_after_periods"]
        part = f", {periods} of {whole} periods" if 0 < periods < whole else ""
        words = [f"{name}{part}: {WORDS[0]}", *(f"  {word}" for word in WORDS[1:])]
        cells = mesh_cells(summary["channels"], name, loaded=mesh["mean_stiffness"] is not None)
        rows += [list(row) for row in zip(words, cells, strict=True)]
    table(title, ["slow roll", "value"], rows)


def show_forces(model: Model, channels: Mapping[str, Mapping[str, Any]], name: str) -> None:
    """Print forces of bearings and torques over a slow roll."""
    from pitchpoint.cli.results import statistics_table
    from pitchpoint.report.main_channels import channel_groups

    groups = channel_groups(model, channels, name)
    chosen = [one for group in groups if group.title in FORCES for one in group.names]
    if chosen:
        statistics_table("bearings and loads", {one: channels[one] for one in chosen})


def mesh_cells(channels: Mapping[str, Mapping[str, Any]], mesh: str, *, loaded: bool = True) -> list[str]:
    """Values for `WORDS` from the statistics of the channels of a roll; no stiffness without load."""
    force, stiffness = channels[f"mesh_force[{mesh}]"], channels[f"tangent_stiffness[{mesh}]"]
    errors = []
    for name in ("transmission_error", "unloaded_transmission_error"):
        row = channels[f"{name}[{mesh}]"]
        errors += [length(row["mean"], 5), length(row["max"] - row["min"], 4)]
    if not loaded:
        return ["no load", *errors, NOTHING]
    return [shown(force["mean"], "force", 5), *errors, shown(stiffness["mean"], "stiffness", 5)]


def length(value: float, digits: int) -> str:
    """Length of the size of a transmission error as text; round-off becomes zero.

    Examples
    --------
    >>> length(2.5e-6, 4), length(4e-19, 4)
    ('2.5 µm', '0 µm')
    """
    return shown(value, "length", digits) if not abs(value) <= ROUND_OFF else "0 µm"
