# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint campbell --wind-speeds`: frequencies and damping over the operating points of a turbine."""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from pitchpoint.cli.output import emit_json, show, show_notes, shown, table

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.core.errors import SolverError
    from pitchpoint.model.model import Model

COLUMNS = 6
"""Most wind speeds in a table of the terminal."""


def of_wind(
    file: str,
    speeds: tuple[float, float],
    options: dict[str, Any],
    *,
    as_json: bool,
    allow_code: bool,
    quiet: bool,
) -> int:
    """Compute and print the modes over the wind speed; return the exit code.

    Parameters
    ----------
    file, options
        Model file, and the options of `campbell`.
    speeds
        Lowest and highest wind speed [m/s].
    """
    from pitchpoint.cli.failure import OK, exit_code_of
    from pitchpoint.cli.reading import read_model
    from pitchpoint.cli.results import known_scenario, refuse_without_effect, unless_it_cannot_begin
    from pitchpoint.io.target import check_target
    from pitchpoint.report.figure_picture import check_picture

    unused = {
        f"--{key}": options[key] for key in ("body", "speeds", "orders", "operating", "frequency", "output")
    }
    refuse_without_effect("with --wind-speeds", unused)
    if not 0.0 < speeds[0] < speeds[1]:
        raise click.BadParameter("give LOW..HIGH with 0 < LOW < HIGH, 4..25m/s", param_hint="--wind-speeds")
    model = read_model(file, allow_code, quiet)
    name = known_scenario(model, options["scenario"]) if options["scenario"] is not None else None
    plot = None if options["plot"] is None else check_picture(options["plot"], [file])
    csv = None if options["csv"] is None else check_target(options["csv"], "analysis", [file])
    points = options["points"] or math.ceil(speeds[1] - speeds[0]) + 1
    winds = np.linspace(*speeds, points)
    summary, error = unless_it_cannot_begin(
        lambda: compute(model, name, winds, options["modes"], (plot, csv), quiet=quiet),
        {"wind_speed": [], "modes": [], "resonances": []},
    )
    if as_json:
        emit_json(summary)
    elif summary["modes"]:
        print_summary(f"{model.title or file}: modes over the wind speed", summary, quiet=quiet)
    return OK if error is None else exit_code_of(error)


def compute(
    model: Model,
    name: str | None,
    winds: Any,
    chosen: tuple[int | None, range | str | None],
    files: tuple[Path | None, Path | None],
    *,
    quiet: bool,
) -> tuple[dict[str, Any], SolverError | None]:
    """Compute the modes and write plot and table; return the output of `--json`, and an error if wind speeds
    have no operating point.

    Parameters
    ----------
    model, name
        The model, and the name of the scenario.
    winds
        Wind speeds [m/s], shape (n,).
    chosen
        Number of modes, and the selection among them.
    files
        Plot and table.
    """
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.cli.results import failed, finished
    from pitchpoint.core.errors import SolverError, split_notes
    from pitchpoint.core.status import SINGULAR
    from pitchpoint.io.target import write_file
    from pitchpoint.report.figure_picture import write_picture
    from pitchpoint.solvers.wind_campbell import solve_wind_campbell
    from pitchpoint.system.compile import compile_model
    from pitchpoint.viz.wind_campbell_plot import plot_wind_campbell

    begun = time.perf_counter()
    count, selection = chosen
    with ProgressDisplay("campbell", "wind speeds", quiet=quiet) as progress:
        data = solve_wind_campbell(compile_model(model, name), winds, name, count=count, progress=progress)
    data = _selected(data, selection)
    plot, csv = files
    if plot is not None:
        write_picture(plot, plot_wind_campbell(data))
    if csv is not None:
        write_file(csv, csv_of(data))
    notes = split_notes(str(data.attrs["notes"]))
    omitted = [float(wind) for wind in data.attrs.get("omitted_wind_speed", ())]
    error = SolverError(notes.pop(), SINGULAR) if omitted else None
    about = finished(begun, None, notes) if error is None else failed(begun, None, notes, error)
    return about | rows_of(data) | {"omitted_wind_speeds": omitted}, error


def _selected(data: xr.Dataset, selection: range | str | None) -> xr.Dataset:
    """Modes of a selection: numbers, or part of a name, in upper or lower case."""
    if selection is None:
        return data
    words = [str(name) for name in data["name"].values]
    numbers = data["mode"].values.tolist()
    kept = [
        k
        for k, number in enumerate(numbers)
        if (selection.lower() in words[k].lower() if isinstance(selection, str) else number in selection)
    ]
    if not kept:
        text = repr(selection) if isinstance(selection, str) else f"{selection[0]}..{selection[-1]}"
        raise click.BadParameter(f"no mode {text}; there are: {', '.join(words)}", param_hint="--modes")
    inside = np.isin(data["resonance_mode"].values, [numbers[k] for k in kept])
    return data.isel(mode=kept, resonance=np.flatnonzero(inside))


def rows_of(data: xr.Dataset) -> dict[str, Any]:
    """Output of `campbell --wind-speeds --json`."""
    names = dict(zip(data["mode"].values.tolist(), map(str, data["name"].values), strict=True))
    keys = ("wind_speed", "rotor_speed", "frequency", "damping_ratio", "mode", "order")
    found = [
        dict(zip(keys, row, strict=True))
        for row in zip(*(data[f"resonance_{key}"].values.tolist() for key in keys), strict=True)
    ]
    return {
        "wind_speed": data["wind_speed"].values.tolist(),
        "rotor_speed": data["rotor_speed"].values.tolist(),
        "pitch": data["pitch"].values.tolist() if "pitch" in data else None,
        "modes": [
            {
                "mode": number,
                "name": names[number],
                "frequency": data["frequency"].values[:, k].tolist(),
                "damping_ratio": data["damping_ratio"].values[:, k].tolist(),
            }
            for k, number in enumerate(data["mode"].values.tolist())
        ],
        "resonances": [row | {"mode": names[row["mode"]]} for row in found],
    }


def print_summary(title: str, summary: dict[str, Any], *, quiet: bool) -> None:
    """Print operating points, frequencies, damping ratios and resonances."""
    winds = summary["wind_speed"]
    places = sorted({round(k) for k in np.linspace(0, len(winds) - 1, min(COLUMNS, len(winds)))})
    heads = [shown(winds[k], "speed", 4) for k in places]
    rows = [["speed of the rotor", *(shown(summary["rotor_speed"][k], "angular_speed", 4) for k in places)]]
    if summary["pitch"] is not None:
        degrees = (round(math.degrees(summary["pitch"][k]), 2) + 0.0 for k in places)
        rows.append(["pitch", *(f"{angle:.2f}°" for angle in degrees)])
    table(title, ["operating point", *heads], rows)
    cells = [
        [row["name"], *(_mode_text(row["frequency"][k], row["damping_ratio"][k]) for k in places)]
        for row in summary["modes"]
    ]
    table("Natural frequency and damping ratio", ["mode", *heads], cells)
    if quiet:
        return
    if len(places) < len(winds):
        show(f"{len(places)} of {len(winds)} wind speeds; --table, --plot and --json have all of them")
    crossings = [
        [
            shown(row["wind_speed"], "speed", 4),
            shown(row["rotor_speed"], "angular_speed", 4),
            shown(row["frequency"], "frequency", 4),
            f"{100.0 * row['damping_ratio']:.3g} %",
            row["order"],
            row["mode"],
        ]
        for row in summary["resonances"]
    ]
    if crossings:
        heads = ["wind speed", "speed of the rotor", "frequency", "damping", "order", "mode"]
        table("Modes with the frequency of an order", heads, crossings)
    show_notes(summary["notes"])


def _mode_text(frequency: float, ratio: float) -> str:
    """Frequency and damping ratio of a mode at one wind speed."""
    return f"{frequency:.4g} Hz, {100.0 * ratio:.3g} %" if frequency > 0.0 else "overdamped"


def csv_of(data: xr.Dataset) -> str:
    """Table of all wind speeds as CSV."""
    from pitchpoint.io.target import ANALYSIS_MARK

    names = [str(name) for name in data["name"].values]
    columns = {
        "wind speed [m/s]": data["wind_speed"].values,
        "rotor speed [rad/s]": data["rotor_speed"].values,
    }
    if "pitch" in data:
        columns["pitch [rad]"] = data["pitch"].values
    for k, name in enumerate(names):
        columns[f'"{name}, frequency [Hz]"'] = data["frequency"].values[:, k]
        columns[f'"{name}, damping ratio"'] = data["damping_ratio"].values[:, k]
    lines = [ANALYSIS_MARK.rstrip("\n"), ",".join(columns)]
    lines += [",".join(f"{float(x):.9g}" for x in row) for row in zip(*columns.values(), strict=True)]
    return "\n".join(lines) + "\n"
