# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint sweep`: continuous speed sweep up and down, with jumps."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.options import common, model_file, output, scenario
from pitchpoint.cli.output import emit_json, largest, show, show_notes, shown, table
from pitchpoint.cli.settings import set_option
from pitchpoint.cli.vary import base_model, vary_option
from pitchpoint.core.load_sharing import is_factor, stage_of

if TYPE_CHECKING:
    from pathlib import Path

    from pitchpoint.analysis.mesh_sweep import MeshSweep
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Sweep


NOT_BEGUN: dict[str, Any] = {"steps": 0, "mesh": None, "points": [], "jumps": []}
"""Parts of the summary that are empty if a sweep fails before its first step."""


@click.command()
@model_file
@scenario
@output("Result file (netCDF-4/HDF5); default: MODEL-SCENARIO.h5 in the current folder.")
@set_option
@vary_option
@common
def sweep(
    file: str,
    scenario: str | None,
    output: str | None,
    vary: tuple[str, ...],
    jobs: int | None,
    as_json: bool,
    allow_code: bool,
    quiet: bool,
) -> int:
    """Sweep the speed of a scenario of FILE and find the jumps of the response.

    Every completed point is written to the result file. Ctrl-C stops the sweep; partial results are kept.
    """
    from pitchpoint.cli.failure import OK, exit_code_of
    from pitchpoint.cli.results import (
        choose_scenario,
        refuse_without_effect,
        result_path,
        unless_it_cannot_begin,
    )

    model = base_model(file, allow_code, quiet, vary)
    name = choose_scenario(model, scenario, "sweep")
    refuse_without_effect("without --vary", {} if vary else {"--jobs": jobs})
    if vary:
        from pitchpoint.cli.cases import run_varied

        goal = result_path(output, file, f"{name}-cases")
        return run_varied(model, file, name, goal, vary, jobs=jobs, as_json=as_json, quiet=quiet)
    target = result_path(output, file, name)
    summary, error = unless_it_cannot_begin(
        lambda: compute(model, file, name, target, quiet=quiet), NOT_BEGUN, target
    )
    if as_json:
        emit_json(summary)
    elif summary["points"] and not quiet:
        _print(f"{model.title or file}: {name}", summary, model.scenarios[name].sweep)
        show(f"{len(summary['points'])} points in {summary['wall_s']:.3g} s, written to {target}")
        show_notes(summary["notes"])
    return OK if error is None else exit_code_of(error)


def compute(
    model: Model, file: str, name: str, target: Path, *, quiet: bool = False
) -> tuple[dict[str, Any], BaseException | None]:
    """Run a sweep into a file; return the summary for `sweep --json`, and the error that stopped it."""
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.cli.results import header_of, how_a_status_ends
    from pitchpoint.core.errors import SolverError
    from pitchpoint.core.kernel import expect
    from pitchpoint.core.status import OK
    from pitchpoint.io.sweep_store import SweepWriter
    from pitchpoint.solvers.fixed_steps import loop_of
    from pitchpoint.sweep.speed import plan_sweep, run_sweep
    from pitchpoint.system.compile import compile_model
    from pitchpoint.system.planet_loads import factor_quantities

    expect(loop_of(model.scenarios[name].method))
    system = compile_model(model, name)
    swept = plan_sweep(system, model.scenarios[name])
    speeds, frequencies = swept.speeds.tolist(), swept.frequencies.tolist()
    directions = [d for d in ("up", "down") if d in swept.directions]
    header = header_of(model, file, name, "sweep", model.scenarios[name].method)
    channels = [(c.name, c.unit, c.long_name) for c in system.layout.channels]
    channels += factor_quantities(model)
    with SweepWriter(target, header, swept.mesh, directions, speeds, frequencies, channels) as writer:

        def keep(point: dict[str, Any]) -> None:
            """Write a point at the index of its speed."""
            nearest = min(range(len(speeds)), key=lambda k: abs(speeds[k] - point["speed"]))
            writer.put(point["direction"], nearest, point)

        with ProgressDisplay(f"sweep {name}", "points", quiet=quiet) as progress:
            done = run_sweep(system, model.scenarios[name], progress=progress, sink=keep)
        writer.put_jumps(done.jumps)
        status = how_a_status_ends(done.status)
        writer.finish(status, done.sentence, code=done.status, steps=done.steps, notes=done.notes)
    summary = {
        "status": status,
        "sentence": done.sentence,
        "steps": done.steps,
        "wall_s": done.wall_s,
        "output": str(target),
        "notes": done.notes,
        "mesh": swept.mesh,
        "points": [{k: v for k, v in point.items() if k != "channels"} for point in done.points],
        "jumps": done.jumps,
    }
    error = None if done.status == OK else SolverError(done.sentence, done.status, str(target))
    return summary, error


def _print(title: str, summary: dict[str, Any], sweep: Sweep | None) -> None:
    """Print jumps and the maximum response of every mesh, the swept mesh first.

    The points of a sweep defined by speeds are labelled with the speed of the swept body, with its sign.
    """
    from pitchpoint.analysis.mesh_sweep import mesh_sweeps
    from pitchpoint.viz.sweep_meshes import closing_words, contact_sentences, mesh_rows, percent

    per_speed = None
    if sweep is not None and sweep.speed is not None:
        per_speed = max((p["mesh_frequency"] / p["speed"] for p in summary["points"]), key=abs)

    def place(frequency: float) -> str:
        """Label of a point of the sweep: mesh frequency or speed."""
        if per_speed is None:
            return shown(frequency, "frequency", 5)
        return shown(frequency / per_speed, "angular_speed", 5)

    points = summary["points"]
    found = mesh_sweeps(points)
    factors = [name for name in points[0] if is_factor(name)]
    rattles = any(one.closing > 0.0 for one in found)
    several = len({one.mesh for one in found}) > 1
    here = {one.direction: [p for p in points if p["direction"] == one.direction] for one in found}
    ranges = {
        d: " to ".join(place(p["mesh_frequency"]) for p in (own[0], own[-1])) for d, own in here.items()
    }
    k_gamma = {d: [largest(p.get(name) for p in own) for name in factors] for d, own in here.items()}

    def cells(one: MeshSweep) -> list[str]:
        """Cells of one mesh in one direction; of a single mesh also the range and the load factors."""
        d = one.direction
        return [
            *([d] if several else [f"{d}, {ranges[d]}", str(one.points)]),
            shown(one.rms, "length", 4),
            place(one.rms_at),
            shown(one.force, "force", 5),
            percent(one.loss),
            *([closing_words(one.closing)] if rattles else []),
            *([] if several else k_gamma[d]),
            ", ".join(place(f) for f in one.jumps) or "none",
        ]

    first = "mesh frequency" if sweep is None or per_speed is None else f"speed of {sweep.body}"
    columns = ["maximum rms of deflection", "at", "maximum mesh force", "maximum contact loss"]
    columns += ["maximum closing speed"] * rattles
    words = [f"maximum K_γ {stage_of(name)}" for name in factors]
    rows, note = mesh_rows(found, cells)
    if not several:
        heads = [first, "points", *columns, *words, "jumps at"]
        table(f"{title}, mesh {summary['mesh']}", heads, [row[1:] for row in rows])
        return
    head = f"{title}, swept mesh {summary['mesh']}, {first}"
    head += "".join(f", {d} {text}" for d, text in ranges.items())
    table(head, ["mesh", "direction", *columns, "jumps at"], rows, [note] if note else [], keys=2)
    for k, word in enumerate(words):
        show(f"{word}: {', '.join(f'{values[k]} {d}' for d, values in k_gamma.items())}")
    for sentence in contact_sentences(found, place):
        show(sentence)
