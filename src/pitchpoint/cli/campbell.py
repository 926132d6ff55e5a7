# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint campbell`: natural frequencies over speed, excitation orders, ranked critical speeds."""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.options import common, model_file, output, state, writes
from pitchpoint.cli.output import NOTHING, emit_json, show, show_notes, shown, table
from pitchpoint.cli.ranges import modes_of, quantities
from pitchpoint.cli.settings import set_option

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model

SHOWN = 20
"""Number of critical speeds in the table."""


def checked_orders(_: click.Context, __: click.Parameter, text: str | None) -> str | None:
    """Stop if a word is not an order."""
    from pitchpoint.core.errors import SolverError
    from pitchpoint.report.campbell import BEARINGS
    from pitchpoint.solvers.excitation_orders import LOADS, order_words, read_orders

    if text is None:
        return None
    try:
        read_orders([word for word in order_words(text) if word not in (LOADS, BEARINGS)])
    except SolverError as error:
        raise click.BadParameter(str(error)) from None
    return text


@click.command()
@model_file
@state
@click.option(
    "--body",
    metavar="NAME",
    help="Body of the speed; default: the one whose speed the scenario gives, else the first that rotates, "
    "has a gear and is not a planet.",
)
@quantities(
    "--speeds",
    "angular_speed",
    "LOW..HIGH",
    "Speeds of the body, such as 300..7200rpm; default: from zero to 1.2 times the highest operating speed.",
)
@click.option("--points", type=click.IntRange(min=2), default=41, help="Number of speeds.", show_default=True)
@click.option(
    "--orders",
    metavar="LIST",
    callback=checked_orders,
    help="Excitation orders, separated by commas: 1x, 2x (of every shaft), mesh, 2mesh, sidebands, "
    "2sidebands, loads (pulsating torques, ripples of drives), bearings (fault frequencies), numbers. "
    "Default: 1x,2x,mesh,2mesh,sidebands,loads.",
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
    elif error is None and not (quiet and files["output"] is not None):
        _print(f"{model.title or file}: critical speeds", summary, quiet=quiet)
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
) -> tuple[dict[str, Any], None]:
    """Compute the diagram and write what is requested; return the output of `campbell --json`."""
    from pitchpoint.analysis.campbell_ranking import select_modes
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.cli.results import finished
    from pitchpoint.core.errors import split_notes
    from pitchpoint.report.campbell import campbell_of

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
    summary = finished(begun, files["output"], split_notes(str(data.attrs["notes"]))) | {
        "body": data.attrs["body"],
        "speeds": [float(data["speed"][0]), float(data["speed"][-1])],
        "operating_speed": data.attrs.get("operating_speed"),
        "ranking": data.attrs["ranking"],
        "critical_speeds": rows_of(data),
        "unstable_modes": unstable_rows(data),
        "modes": mode_rows(data),
    }
    return summary, None


def rows_of(data: xr.Dataset) -> list[dict[str, Any]]:
    """Critical speeds of `campbell --json`, in order of rank."""
    from dataclasses import asdict

    from pitchpoint.analysis.campbell_ranking import ranked_speeds

    rows = []
    for row in map(asdict, ranked_speeds(data)):
        row["sidebands"] = None if math.isnan(row["sidebands"][0]) else list(row["sidebands"])
        rows.append(row)
    return rows


def unstable_rows(data: xr.Dataset) -> list[dict[str, Any]]:
    """Unstable modes of `campbell --json`, lowest damping first."""
    from dataclasses import asdict

    from pitchpoint.analysis.campbell_ranking import unstable_ranges

    return [asdict(row) for row in unstable_ranges(data)]


def mode_rows(data: xr.Dataset) -> list[dict[str, Any]]:
    """Modes of `campbell --json`: values at the ends of the speeds, energies at the highest speed."""
    last = data.isel(speed=-1)
    return [
        {
            "mode": int(number),
            "name": str(data["name"].values[k]),
            "frequency": [float(data["frequency"].values[s, k]) for s in (0, -1)],
            "damping_ratio": [float(data["damping_ratio"].values[s, k]) for s in (0, -1)],
            "whirl_index": float(last["whirl_index"].values[k]),
            "strain_share": dict(
                zip(last["component"].values.tolist(), last["strain_share"].values[k].tolist(), strict=True)
            ),
            "kinetic_share": dict(
                zip(
                    last["part"].values.tolist(),
                    last["kinetic_share"].values[k].sum(axis=1).tolist(),
                    strict=True,
                )
            ),
        }
        for k, number in enumerate(data["mode"].values)
    ]


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
    columns = [str(name) for name in data.data_vars if str(name).startswith("crossing_")]
    heads = [f"{c.removeprefix('crossing_')}{_unit(data[c].attrs.get('units', ''))}" for c in columns]
    lines = [
        ANALYSIS_MARK.rstrip("\n"),
        f"# {data.attrs['ranking']}",
        ",".join(["rank", *heads, "mode name"]),
    ]
    for k, rank in enumerate(data["crossing"].values):
        cells = [_cell(data[c].values[k]) for c in columns]
        lines.append(",".join([str(rank), *cells, f'"{names[int(data["crossing_mode"].values[k])]}"']))
    return "\n".join(lines) + "\n"


def _unit(unit: str) -> str:
    return f" [{unit}]" if unit not in ("", "1") else ""


def _cell(value: Any) -> str:
    """Cell of a CSV table."""
    return f'"{value}"' if isinstance(value, str) else f"{float(value):.9g}"


def _print(title: str, summary: dict[str, Any], *, quiet: bool) -> None:
    """Print critical speeds and modes."""
    from pitchpoint.analysis.campbell_ranking import NO_CRITICAL_SPEED

    apart = summary["operating_speed"] is not None
    cells = [
        [
            str(rank),
            _rpm(row["speed"]),
            shown(row["frequency"], "frequency", 5),
            f"{100.0 * row['damping_ratio']:.3g} %",
            row["order"],
            row["mode"],
            f"{row['source']} {100.0 * row['participation']:.3g} %",
            _amplification(row),
            f"{row['response']:.4g}",
            *([_separation(row["separation"])] if apart else []),
            NOTHING if row["sidebands"] is None else "–".join(f"{_number(s)}" for s in row["sidebands"]),
        ]
        for rank, row in enumerate(summary["critical_speeds"][:SHOWN], start=1)
    ]
    heads = ["rank", f"speed of {summary['body']}", "frequency", "damping", "order", "mode", "driven by"]
    heads += ["amplification", "response", *(["separation"] if apart else []), "sidebands [rpm]"]
    if cells:
        table(title, heads, cells)
    else:
        show(f"{title}: {NO_CRITICAL_SPEED} in this range of speeds and frequencies")
    _print_unstable(summary)
    if quiet:
        return
    more = len(summary["critical_speeds"]) - len(cells)
    show(f"{summary['ranking']}" + (f"; {more} more: --table, --json or -o contain all" if more > 0 else ""))
    low, high = (_rpm(speed) for speed in summary["speeds"])
    rows = [
        [
            str(row["mode"]),
            row["name"],
            *(shown(f, "frequency", 5) for f in row["frequency"]),
            f"{100.0 * row['damping_ratio'][1]:.3g} %",
            largest(row["strain_share"]),
            largest(row["kinetic_share"]),
        ]
        for row in summary["modes"]
        if max(row["frequency"]) > 0.0
    ]
    heads = ["no.", "mode", f"at {low}", f"at {high}", "damping", "strain energy", "kinetic energy"]
    table("Modes", heads, rows, keys=2)
    show(f"damping and energies at {high}")
    show_notes(summary["notes"])
    if summary["output"] is not None:
        show(f"written to {summary['output']}")


def _print_unstable(summary: dict[str, Any]) -> None:
    """Print unstable modes, if there are any."""
    rows = [
        [
            row["mode"],
            f"{_number(row['low'])}–{_rpm(row['high'])}",
            f"{100.0 * row['damping_ratio']:.3g} %",
            row["source"] or NOTHING,
        ]
        for row in summary["unstable_modes"]
    ]
    if rows:
        table("Unstable modes", ["mode", f"speed of {summary['body']}", "lowest damping", "driven by"], rows)


def _amplification(row: dict[str, Any]) -> str:
    """Amplification of a critical speed in words."""
    if math.isfinite(row["amplification"]):
        return f"{row['amplification']:.4g}"
    return "unstable" if row["damping_ratio"] < 0.0 else "∞"


def largest(shares: dict[str, float], count: int = 2, least: float = 0.1) -> str:
    """Largest shares of an energy in words.

    Examples
    --------
    >>> largest({"mesh stage": 0.2, "shaft rotor": 0.75, "bearing a": 0.05})
    'shaft rotor 75 %, mesh stage 20 %'
    """
    order = sorted(shares.items(), key=lambda item: -item[1])[:count]
    words = [
        f"{name} {100.0 * share:.0f} %"
        for k, (name, share) in enumerate(order)
        if share >= least or (k == 0 and share > 0.0)
    ]
    return ", ".join(words) or NOTHING


def _number(speed: float) -> str:
    return f"{speed * 30.0 / math.pi:.5g}"


def _rpm(speed: float) -> str:
    return f"{_number(speed)} rpm"


def _separation(share: float) -> str:
    return "in range" if share == 0.0 else f"{round(100.0 * share, 1) + 0.0:+.1f} %"
