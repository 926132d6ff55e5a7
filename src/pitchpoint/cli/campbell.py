# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint campbell`: natural frequencies over speed, excitation orders, ranked critical speeds."""

from __future__ import annotations

import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.campbell_output import mode_rows, print_summary, rows_of, unstable_rows
from pitchpoint.cli.options import common, model_file, output, state, writes
from pitchpoint.cli.output import emit_json
from pitchpoint.cli.ranges import modes_of, quantities
from pitchpoint.cli.settings import set_option
from pitchpoint.cli.wind_campbell import of_wind

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.core.errors import SolverError
    from pitchpoint.model.model import Model


POINTS = 41
"""Default number of speeds."""


def checked_orders(_: click.Context, __: click.Parameter, text: str | None) -> str | None:
    """Stop if a word is not an order."""
    from pitchpoint.core.errors import SolverError
    from pitchpoint.report.campbell import BEARINGS
    from pitchpoint.solvers.excitation_orders import BLADES, LOADS, order_words, read_orders

    if text is None:
        return None
    try:
        read_orders([word for word in order_words(text) if word not in (LOADS, BLADES, BEARINGS)])
    except SolverError as error:
        raise click.BadParameter(str(error)) from None
    return text


@click.command()
@model_file
@state
@click.option(
    "--body",
    metavar="NAME",
    help="Body of the speed; default: the hub of a wind rotor, else the one whose speed the scenario gives, "
    "else the first that rotates, has a gear and is not a planet.",
)
@quantities(
    "--speeds",
    "angular_speed",
    "LOW..HIGH",
    "Speeds of the body, such as 300..7200rpm; default: from zero to 1.2 times the highest operating speed.",
)
@quantities(
    "--wind-speeds",
    "speed",
    "LOW..HIGH",
    "Wind speeds at the hub of a wind rotor instead of speeds, such as 4..25m/s: at each, rotor and "
    "controllers are in equilibrium.",
)
@click.option(
    "--points",
    type=click.IntRange(min=2),
    help="Number of speeds; default: 41, of wind speeds one for each m/s.",
)
@click.option(
    "--orders",
    metavar="LIST",
    callback=checked_orders,
    help="Excitation orders, separated by commas: 1x, 2x (of every shaft), mesh, 2mesh, sidebands, "
    "2sidebands, loads (pulsating torques, ripples of drives), blades (3P, 6P, 9P of a wind rotor with three "
    "blades), bearings (fault frequencies), numbers. Default: 1x,2x,mesh,2mesh,sidebands,loads,blades.",
)
@click.option(
    "--modes", metavar="SELECTION", help="The lowest N modes, modes A..B, or modes with a text in their name."
)
@quantities(
    "--frequency", "frequency", "LOW..HIGH", "Frequencies, such as 0..2kHz; default: those of the modes."
)
@quantities(
    "--operating",
    "angular_speed",
    "LOW..HIGH",
    "Operating speeds of the body, for the separation of critical speeds; default: those of the scenarios.",
)
@writes("--plot", metavar="FILE", help="Write the diagram (html, svg, png).")
@writes("--table", "csv", metavar="CSV", help="Write all critical speeds, with those of sidebands.")
@output("Result file (netCDF-4/HDF5); default: none.")
@set_option
@common
def campbell(file: str, as_json: bool, allow_code: bool, quiet: bool, **options: Any) -> int:
    """Compute the Campbell diagram and the critical speeds of FILE."""
    from pitchpoint.cli.failure import OK, exit_code_of
    from pitchpoint.cli.reading import read_model
    from pitchpoint.cli.results import known_scenario, result_path, unless_it_cannot_begin
    from pitchpoint.io.target import check_target
    from pitchpoint.report.figure_picture import check_picture

    options["modes"] = modes_of(options["modes"])
    if options["speeds"] is not None and options["speeds"][0] == options["speeds"][1]:
        raise click.BadParameter("a single speed; write LOW..HIGH, 0..3000rpm", param_hint="--speeds")
    if options["operating"] is not None and options["operating"][1] == 0.0:
        raise click.BadParameter("zero speed; give a speed above 0", param_hint="--operating")
    over_wind = options.pop("wind_speeds")
    if over_wind is not None:
        return of_wind(file, over_wind, options, as_json=as_json, allow_code=allow_code, quiet=quiet)
    options["points"] = options["points"] or POINTS
    model = read_model(file, allow_code, quiet)
    name = known_scenario(model, options["scenario"]) if options["scenario"] is not None else None
    _check_body(model, name, options["body"])
    files: dict[str, Path | None] = {"output": None, "plot": None, "csv": None}
    if options["output"] is not None:
        files["output"] = result_path(options["output"], file, name or "")
    if options["plot"] is not None:
        files["plot"] = check_picture(options["plot"], [file])
    if options["csv"] is not None:
        files["csv"] = check_target(options["csv"], "analysis", [file])
    summary, error = unless_it_cannot_begin(
        lambda: compute(model, file, name, files, options, quiet=quiet),
        {"critical_speeds": [], "unstable_modes": [], "modes": []},
    )
    if as_json:
        emit_json(summary)
    elif summary["modes"] and not (quiet and files["output"] is not None):
        print_summary(f"{model.title or file}: critical speeds", summary, quiet=quiet)
    return OK if error is None else exit_code_of(error)


def _check_body(model: Model, scenario: str | None, name: str | None) -> None:
    """Stop if no body has this name."""
    from pitchpoint.core.nearest import hint
    from pitchpoint.system.compile import compile_model

    if name is not None and name not in (known := compile_model(model, scenario).layout.bodies[1:]):
        raise click.BadParameter(f"no body {name!r}; {hint(name, known)}", param_hint="--body")


def compute(
    model: Model,
    file: str,
    name: str | None,
    files: dict[str, Path | None],
    options: dict[str, Any],
    *,
    quiet: bool,
) -> tuple[dict[str, Any], SolverError | None]:
    """Compute the diagram and write what is requested; return the output of `campbell --json`.

    Also an error if some speeds have no equilibrium: the diagram contains the others.
    """
    from pitchpoint.analysis.campbell_ranking import select_modes
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.cli.results import failed, finished
    from pitchpoint.core.errors import SolverError, split_notes
    from pitchpoint.core.status import SINGULAR
    from pitchpoint.report.campbell import campbell_of
    from pitchpoint.solvers.campbell_dataset import NO_EQUILIBRIUM

    begun = time.perf_counter()
    count, selection = options["modes"]
    with ProgressDisplay("campbell", "speeds", quiet=quiet) as progress:
        data = campbell_of(
            model,
            name,
            body=options["body"],
            speeds=options["speeds"],
            points=options["points"],
            orders=options["orders"],
            count=count,
            frequency=options["frequency"],
            operating=options["operating"],
            progress=progress,
        )
    data = select_modes(data, selection, options["frequency"])
    _write(model, file, name, files, data, options)
    notes = split_notes(str(data.attrs["notes"]))
    omitted = [float(speed) for speed in data.attrs.get("omitted_speed", ())]
    error = None
    if omitted:
        left_out = [text for text in notes if text.startswith(NO_EQUILIBRIUM)]
        error = SolverError("; ".join(left_out), SINGULAR)
        notes = [text for text in notes if text not in left_out]
    summary = (
        finished(begun, files["output"], notes)
        if error is None
        else failed(begun, files["output"], notes, error)
    ) | {
        "omitted_speeds": omitted,
        "body": data.attrs["body"],
        "speeds": [float(data["speed"][0]), float(data["speed"][-1])],
        "operating_speed": data.attrs.get("operating_speed"),
        "ranking": data.attrs["ranking"],
        "critical_speeds": rows_of(data),
        "unstable_modes": unstable_rows(data),
        "modes": mode_rows(data),
    }
    return summary, error


def _write(
    model: Model,
    file: str,
    name: str | None,
    files: dict[str, Path | None],
    data: xr.Dataset,
    options: dict[str, Any],
) -> None:
    """Write result file, plot and table."""
    from pitchpoint.cli.results import header_of
    from pitchpoint.io.dataset_tables import write_dataset
    from pitchpoint.io.target import write_file
    from pitchpoint.report.campbell import campbell_header
    from pitchpoint.report.figure_picture import write_picture
    from pitchpoint.viz.campbell_plot import plot_campbell

    if files["output"] is not None:
        header = campbell_header(header_of(model, file, name or "", "campbell", "campbell"), data)
        write_dataset(files["output"], header, data)
    if files["plot"] is not None:
        figure = plot_campbell(data, frequency=options["frequency"])
        write_picture(files["plot"], figure)
    if files["csv"] is not None:
        write_file(files["csv"], csv_of(data))


def csv_of(data: xr.Dataset) -> str:
    """Table of all critical speeds as CSV."""
    from pitchpoint.io.target import ANALYSIS_MARK

    names = dict(zip(data["mode"].values.tolist(), map(str, data["name"].values), strict=True))
    columns: dict[str, Any] = {}
    for key, found in data.data_vars.items():
        name = f"{str(key).removeprefix('crossing_')}{_unit(found.attrs.get('units', ''))}"
        if found.dims == ("crossing",):
            columns[name] = found.values
        elif found.dims[:1] == ("crossing",):  # sensitivities by component or part
            labels = data[found.dims[1]].values
            columns |= {f'"{name}, {label}"': found.values[:, k] for k, label in enumerate(labels)}
    lines = [
        ANALYSIS_MARK.rstrip("\n"),
        f"# {data.attrs['ranking']}",
        ",".join(["rank", *columns, "mode name"]),
    ]
    for k, rank in enumerate(data["crossing"].values):
        cells = [_cell(values[k]) for values in columns.values()]
        lines.append(",".join([str(rank), *cells, f'"{names[int(data["crossing_mode"].values[k])]}"']))
    return "\n".join(lines) + "\n"


def _unit(unit: str) -> str:
    return f" [{unit}]" if unit not in ("", "1") else ""


def _cell(value: Any) -> str:
    """Cell of a CSV table."""
    return f'"{value}"' if isinstance(value, str) else f"{float(value):.9g}"
