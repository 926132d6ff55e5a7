# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint compare-solvers`: accuracy over processor time of all integrators and formulations."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.options import common, model_file, output, scenario
from pitchpoint.cli.output import NOTHING, emit_json, show, shown, table
from pitchpoint.cli.settings import set_option

if TYPE_CHECKING:
    from pathlib import Path

    from pitchpoint.model.model import Model
    from pitchpoint.solvers.compare import Comparison


@click.command(name="compare-solvers")
@model_file
@scenario
@output("Work-precision diagrams (html, svg, png); default: none.")
@click.option(
    "--limit",
    type=click.FloatRange(0.01, 86400.0),
    default=20.0,
    show_default=True,
    metavar="SECONDS",
    help="Maximum computing time per run.",
)
@set_option
@common
def compare_solvers(
    file: str,
    scenario: str | None,
    output: str | None,
    limit: float,
    as_json: bool,
    allow_code: bool,
    quiet: bool,
) -> int:
    """Run a scenario of FILE with all integrators and constraint formulations, at several settings each."""
    from pitchpoint.cli.failure import OK, exit_code_of
    from pitchpoint.cli.reading import read_model
    from pitchpoint.cli.results import choose_scenario, unless_it_cannot_begin
    from pitchpoint.report.figure_picture import check_picture

    model = read_model(file, allow_code, quiet)
    name = choose_scenario(model, scenario, "time")
    target = None if output is None else check_picture(output, [file])
    summary, error = unless_it_cannot_begin(
        lambda: compute(model, name, target, limit, quiet=quiet), {"runs": [], "reference": None}
    )
    if as_json:
        emit_json(summary)
    elif error is None:
        _print(f"{model.title or file}: {name}", summary, quiet=quiet)
    return OK if error is None else exit_code_of(error)


def compute(
    model: Model, name: str, target: Path | None, limit_s: float, *, quiet: bool
) -> tuple[dict[str, Any], None]:
    """Compare the integrators on one scenario; return the output of `compare-solvers --json`."""
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.cli.results import finished
    from pitchpoint.solvers.compare import compare_solvers
    from pitchpoint.system.compile import compile_model

    begun = time.perf_counter()
    scenario = model.scenarios[name]
    system = compile_model(model, scenario)
    with ProgressDisplay("compare", "runs", quiet=quiet) as progress:
        found = compare_solvers(system, scenario, limit_s=limit_s, progress=progress)
    runs = rows_of(found)
    if target is not None:
        _draw(target, runs, f"{model.title or name}: {name}")
    summary = finished(begun, target) | {
        "reference": found.reference,
        "reference_doubt": found.doubt,
        "runs": runs,
    }
    return summary, None


def rows_of(found: Comparison) -> list[dict[str, Any]]:
    """Output of `--json` for each run."""
    from pitchpoint.cli.results import how_a_status_ends

    return [
        {**vars(run), "code": run.status, "status": how_a_status_ends(run.status)} for run in found.attempts
    ]


def _draw(target: Path, runs: list[dict[str, Any]], title: str) -> None:
    """Write a picture of the work-precision curves."""
    from pitchpoint.report.figure_picture import write_picture
    from pitchpoint.viz.work_precision import plot_work_precision

    write_picture(target, plot_work_precision(runs, title))


def _print(title: str, summary: dict[str, Any], *, quiet: bool) -> None:
    """Print the runs as a table, with the reasons of failed runs below it."""
    cells, notes = [], []
    last = ""
    for run in summary["runs"]:
        name = f"{run['method']} {run['form']}".strip()
        if last and name != last:
            cells.append([""])
        last = name
        timed = run["setting"] == "step"
        value = shown(run["value"], "time", 3) if timed else f"{run['value']:.0e}"
        done = run["status"] == "finished"
        cells.append(
            [
                name,
                f"{run['setting']} {value}",
                str(run["steps"]),
                f"{run['cpu_s']:.3f} s",
                f"{run['error']:.1e}" if done else NOTHING,
                run["channel"] if done else run["status"],
            ]
        )
        if not done:
            notes.append(f"{name}, {run['setting']} {value}: {run['sentence']}")
    table(title, ["method", "setting", "steps", "processor time", "error", "worst channel"], cells, notes)
    doubt = summary["reference_doubt"]
    known = "" if doubt != doubt else f"; a second tight run differs from it by {doubt:.1e}"
    show(f"error against {summary['reference']}, as a share of the alternating part{known}")
    if not quiet and summary["output"] is not None:
        show(f"written to {summary['output']}")
