# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint relief`: flank modifications of least transmission error over a range of torques."""

from __future__ import annotations

import time
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.contact_input import (
    flank_option,
    mesh_option,
    misalignment_help,
    refused_input,
    torques_option,
)
from pitchpoint.cli.options import common, model_file, output, quantity, writes
from pitchpoint.cli.output import NOTHING, emit_json, show, shown, table

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model
    from pitchpoint.solvers.contact_analysis.relief.plan import ReliefPlan

FILES = ("output", "picture", "write")
"""Options of files."""
_MET = 1e-6
"""Relative violation up to which a limit counts as met."""


@click.command()
@model_file
@mesh_option
@torques_option
@click.option(
    "--vary",
    multiple=True,
    required=True,
    metavar="PATH=LOW:HIGH",
    help="Modification to be chosen and its bounds, repeatable, such as "
    "gears.pinion.modifications.both.tip_relief.amount=0:60um.",
)
@click.option(
    "--tolerance",
    multiple=True,
    metavar="PATH=LENGTH",
    help="Tolerance ± of a modification, varied or not, repeatable; the worst deviations count.",
)
@click.option(
    "--misalignment",
    multiple=True,
    metavar="QUANTITY",
    help=f"{misalignment_help} Repeatable; the worst counts.",
)
@click.option(
    "--objective",
    type=click.Choice(["maximum", "mean"]),
    default="maximum",
    show_default=True,
    help="Maximum or mean of the peak-to-peak transmission errors over the torques.",
)
@click.option("--weights", metavar="W1,W2,...", help="Weight of each torque; default: equal.")
@quantity("--max-pressure", "pressure", "Limit of the flank pressure at the highest torque.")
@click.option("--no-edge-contact", is_flag=True, help="Tip edges must not carry load at the highest torque.")
@flank_option
@click.option(
    "--positions",
    type=click.IntRange(8, 10_000),
    default=64,
    show_default=True,
    help="Number of mesh phases over one base pitch.",
)
@click.option(
    "--analyses",
    type=click.IntRange(min=20),
    default=6000,
    show_default=True,
    help="Maximum number of contact analyses of the search.",
)
@click.option("--seed", type=click.IntRange(min=0), default=1, show_default=True, help="Seed of the search.")
@click.option("--jobs", "-j", type=click.IntRange(min=1), metavar="N", help="Threads; default: one per core.")
@writes("--write", metavar="FILE", help="Write the model with the rounded modifications.")
@writes("--picture", metavar="FILE", help="Write the Harris map (html, svg, png).")
@output("Result file (netCDF-4/HDF5); default: none.")
@common
def relief(file: str, as_json: bool, allow_code: bool, quiet: bool, **options: Any) -> int:
    """Choose flank modifications of a mesh of FILE for the least transmission error over a range of torques.

    The mesh has `contact` of level flexible or rigid. Ctrl-C ends the search with the best modifications so
    far.
    """
    from pitchpoint.cli.contact_input import loads_of, mesh_with_contact
    from pitchpoint.cli.failure import OK, exit_code_of
    from pitchpoint.cli.reading import read_model
    from pitchpoint.cli.relief_options import plan_of
    from pitchpoint.cli.results import result_path
    from pitchpoint.io.target import check_target
    from pitchpoint.report.figure_picture import check_picture

    model = read_model(file, allow_code, quiet)
    mesh = mesh_with_contact(model, options["mesh"], ("flexible", "rigid"))  # others have tables
    torques, flank = loads_of(model, mesh, options["torques"], options["flank"])
    plan = plan_of(model, mesh, torques, flank, options)
    files: dict[str, Path] = {}
    if options["output"] is not None:
        files["output"] = result_path(options["output"], file, "")
    if options["picture"] is not None:
        files["picture"] = check_picture(options["picture"], [file])
    if options["write"] is not None:
        files["write"] = check_target(options["write"], "model", [file])
    summary, data, error = compute(model, file, mesh, plan, files, jobs=options["jobs"], quiet=quiet)
    if as_json:
        emit_json(summary)
    elif data is not None:
        _print(f"{model.title or file}: relief of {mesh}", summary, quiet=quiet)
    return OK if error is None else exit_code_of(error)


def compute(
    model: Model,
    file: str,
    mesh: str,
    plan: ReliefPlan,
    files: Mapping[str, Path],
    *,
    jobs: int | None,
    quiet: bool,
) -> tuple[dict[str, Any], xr.Dataset | None, BaseException | None]:
    """Search and write the files; return the output of `relief --json`, the result, and why it stopped."""
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.core.errors import SolverError
    from pitchpoint.io.writing import how_it_ended
    from pitchpoint.solvers.contact_analysis.relief.design import design_relief

    begun = time.perf_counter()
    failure: BaseException | None = None
    data: xr.Dataset | None = None
    try:
        with refused_input(), ProgressDisplay("relief", "analyses", quiet=quiet) as progress:
            data = design_relief(model, mesh, plan, jobs=jobs, progress=progress)
    except (SolverError, KeyboardInterrupt) as error:
        data = getattr(error, "partial", None)
        failure = error
        if isinstance(error, SolverError) and data is not None:
            failure = SolverError(
                str(error), error.status, str(files["output"]) if "output" in files else None
            )
    status, sentence, code = how_it_ended(failure)
    summary: dict[str, Any] = {
        "status": status,
        "sentence": sentence,
        "wall_s": time.perf_counter() - begun,
        "mesh": mesh,
        **{name: str(files[name]) if name in files and data is not None else None for name in FILES},
    }
    if data is not None:
        _write(model, file, data, files, {"status": status, "sentence": sentence, "code": code})
        summary |= numbers(data)
    return summary, data, failure


def _write(
    model: Model, file: str, data: xr.Dataset, files: Mapping[str, Path], ending: Mapping[str, Any]
) -> None:
    """Write result, picture and model."""
    import json
    from dataclasses import replace

    from pitchpoint.cli.results import header_of
    from pitchpoint.io.dataset_tables import write_dataset
    from pitchpoint.io.target import write_file
    from pitchpoint.io.yaml_edit import changed_text
    from pitchpoint.model.reading.yaml_tree import text_of
    from pitchpoint.model.write import quantity_text
    from pitchpoint.report.figure_picture import write_picture
    from pitchpoint.solvers.contact_analysis.relief.variables import with_values
    from pitchpoint.viz.relief_plot import plot_relief

    if "output" in files:
        header = replace(
            header_of(model, file, "", "relief", "relief"), options=json.loads(data.attrs["options"])
        )
        write_dataset(files["output"], header, data, **ending)
    if "picture" in files:
        write_picture(files["picture"], plot_relief(data))
    if "write" in files:
        chosen = data["value"].sel(design="rounded")
        values = {
            str(path): quantity_text(float(value), "length")
            for path, value in zip(data["variable"].values, chosen.values, strict=True)
        }
        changed = with_values(model, values)
        write_file(files["write"], changed_text(text_of(file), changed, values, str(files["write"])))


def numbers(data: xr.Dataset) -> dict[str, Any]:
    """Main results in SI units."""
    designs = data["design"].values.tolist()

    def by_design(name: str) -> dict[str, Any]:
        """Values of a variable by design."""
        return {d: data[name].sel(design=d).values.tolist() for d in designs}

    variables = [
        {
            "path": str(path),
            "low": float(data["lower_bound"][k]),
            "high": float(data["upper_bound"][k]),
            "tolerance": float(data["tolerance"][k]),
            **{d: float(data["value"].sel(design=d)[k]) for d in designs},
        }
        for k, path in enumerate(data["variable"].values)
    ]
    names = (
        "objective",
        "nominal_objective",
        "excess",
        "peak_to_peak_min",
        "peak_to_peak_max",
        "pressure",
        "edge_share",
    )
    return {
        "analyses": int(data.attrs["analyses"]),
        "variables": variables,
        "torque": data["torque"].values.tolist(),
        "peak_to_peak": {
            d: data["peak_to_peak"].sel(design=d).max("misalignment").values.tolist() for d in designs
        },
        **{name: by_design(name) for name in names},
        "map": {
            "torque": data["map_torque"].values.tolist(),
            **{name: by_design(f"map_{name}") for name in ("peak_to_peak", "min", "max")},
        },
    }


def _print(title: str, summary: dict[str, Any], *, quiet: bool) -> None:
    """Print modifications, and peak-to-peak errors by torque."""
    from pitchpoint.cli.cases import shortest

    paths = [v["path"] for v in summary["variables"]]
    designs = ("start", "optimum", "rounded")
    rows = [
        [
            shortest(v["path"], paths),
            *(shown(v[d], "length", 4) for d in designs),
            f"{shown(v['low'], 'length', 4)} to {shown(v['high'], 'length', 4)}",
            f"±{shown(v['tolerance'], 'length', 3)}" if v["tolerance"] else NOTHING,
        ]
        for v in summary["variables"]
    ]
    table(title, ["modification", *designs, "bounds", "tolerance"], rows)
    worst = any(summary["peak_to_peak_max"][d] != summary["peak_to_peak"][d] for d in designs)
    rows = []
    for k, torque in enumerate(summary["torque"]):
        row = [
            shown(torque, "torque", 5),
            *(shown(summary["peak_to_peak"][d][k], "length", 4) for d in designs),
        ]
        if worst:
            row.append(shown(summary["peak_to_peak_max"]["rounded"][k], "length", 4))
        row.append(shown(summary["pressure"]["rounded"][k], "pressure", 4))
        row.append(f"{100.0 * summary['edge_share']['rounded'][k]:.1f} %")
        rows.append(row)
    ends = ["p flank", "load on tip edges"]
    columns = ["torque", *(f"TE p–p, {d}" for d in designs), *["rounded, worst"] * worst, *ends]
    table("Peak-to-peak transmission error", columns, rows)
    values = " → ".join(shown(summary["objective"][d], "length", 4) for d in ("start", "rounded"))
    excess = summary["excess"]["rounded"]
    if excess > _MET:
        show(f"note: a limit is exceeded by {100.0 * excess:.3g} % with the rounded values")
    if not quiet:
        show(f"objective {values} after {summary['analyses']} analyses in {summary['wall_s']:.3g} s")
        for name in FILES:
            if summary[name] is not None:
                show(f"written to {summary[name]}")
