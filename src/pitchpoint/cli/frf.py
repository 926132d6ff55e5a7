# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint frf`: frequency response about an operating point."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.options import common, model_file, output, quantity, state, writes
from pitchpoint.cli.output import emit_json, show, show_notes, shown, table
from pitchpoint.cli.settings import set_option

if TYPE_CHECKING:
    from pathlib import Path

    from pitchpoint.model.model import Model
    from pitchpoint.solvers.frequency_response import FrequencyResponse


@click.command()
@model_file
@click.option(
    "--input",
    "-i",
    "inputs",
    multiple=True,
    metavar="NAME",
    help="Excitation: BODY.COORDINATE, BODY.fx ... mz, transmission_error[MESH] or unbalance[BODY].",
)
@click.option(
    "--response",
    "-r",
    "responses",
    multiple=True,
    required=True,
    metavar="NAME",
    help="Response: BODY.COORDINATE, BODY.ux ... rz, or a channel such as mesh_force[MESH]; with "
    "--mesh-orders also velocity[...] and acceleration[...] of a displacement.",
)
@quantity("--from", "frequency", "Lowest frequency; default: 1 % of the highest.")
@quantity("--to", "frequency", "Highest frequency.")
@click.option("--points", type=click.IntRange(min=2), default=400, help="Number of frequencies or speeds.")
@click.option("--linear", is_flag=True, help="Linear instead of logarithmic frequency steps.")
@click.option(
    "--modes",
    type=click.IntRange(min=1),
    metavar="N",
    help="Use the lowest N modes; default: direct solution.",
)
@click.option(
    "--synchronous",
    metavar="BODY",
    help="Body whose speed follows the frequency, in its direction of rotation in the scenario; the other "
    "speeds follow by their ratios. For an unbalance: its own body.",
)
@click.option(
    "--mesh-orders",
    type=click.IntRange(min=1, max=16),
    metavar="N",
    help="Levels of the response to transmission error and shuttling force of every mesh under load, by its "
    "first N orders, over the speed of a body.",
)
@click.option(
    "--speed-of",
    metavar="BODY",
    help="Body whose speed is varied with --mesh-orders, in the direction of the scenario.",
)
@quantity("--from-speed", "angular_speed", "Lowest speed; default: 5 % of the highest.")
@quantity("--to-speed", "angular_speed", "Highest speed.")
@state
@writes("--picture", metavar="FILE", help="Write the plots (html, svg, png).")
@output("Result file (netCDF-4/HDF5); default: none.")
@set_option
@common
def frf(file: str, as_json: bool, allow_code: bool, quiet: bool, **options: Any) -> int:
    """Compute the frequency response of FILE about its loaded equilibrium, or levels by mesh order."""
    from pitchpoint.cli import frf_orders
    from pitchpoint.cli.failure import OK, exit_code_of
    from pitchpoint.cli.reading import read_model
    from pitchpoint.cli.results import known_scenario, result_path, unless_it_cannot_begin
    from pitchpoint.report.figure_picture import check_picture

    by_order = options["mesh_orders"] is not None
    if by_order:
        frf_orders.check_options(options)
    elif any(options[key] is not None for key in ("speed_of", "from_speed", "to_speed")):
        raise click.UsageError("--speed-of, --from-speed and --to-speed require --mesh-orders")
    elif not options["inputs"]:
        raise click.UsageError("--input is required: an excitation, such as 'transmission_error[MESH]'")
    elif options["to"] is None:
        raise click.UsageError("--to is required: the highest frequency, such as --to '2 kHz'")
    model = read_model(file, allow_code, quiet)
    scenario = options["scenario"]
    name = known_scenario(model, scenario) if scenario is not None else None
    target = result_path(options["output"], file, name or "") if options["output"] is not None else None
    if options["picture"] is not None:
        options["picture"] = check_picture(options["picture"], [file])
    chosen = frf_orders.compute if by_order else compute
    empty: dict[str, Any] = {"orders": [], "outputs": []} if by_order else {"inputs": [], "outputs": []}
    summary, error = unless_it_cannot_begin(
        lambda: chosen(model, file, name, target, options, quiet=quiet), empty
    )
    if as_json:
        emit_json(summary)
    elif error is not None or (quiet and target is not None):
        pass  # the tables are in the file
    elif by_order:
        frf_orders.print_orders(f"{model.title or file}: mesh orders", summary, quiet=quiet)
    else:
        _print(f"{model.title or file}: frequency response", summary, quiet=quiet)
    return OK if error is None else exit_code_of(error)


def frequencies(low: float | None, high: float, points: int, linear: bool) -> list[float]:
    """Frequencies in ascending order [Hz].

    Examples
    --------
    >>> frequencies(1.0, 100.0, 3, False), frequencies(0.0, 10.0, 3, True), frequencies(None, 100.0, 2, False)
    ([1.0, 10.0, 100.0], [0.0, 5.0, 10.0], [1.0, 100.0])
    """
    low = 0.01 * high if low is None else low
    if linear or low <= 0.0:
        return [low + (high - low) * k / (points - 1) for k in range(points)]
    return [float(low * (high / low) ** (k / (points - 1))) for k in range(points)]


def compute(
    model: Model, file: str, name: str | None, target: Path | None, options: dict[str, Any], *, quiet: bool
) -> tuple[dict[str, Any], None]:
    """Compute the response and write it if requested; return the output of `frf --json`."""
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.cli.results import finished, header_of
    from pitchpoint.io.dataset_tables import write_dataset
    from pitchpoint.solvers.frequency_response import find_response, response_dataset
    from pitchpoint.system.compile import compile_model

    begun = time.perf_counter()
    system = compile_model(model, name)
    hertz = frequencies(options["from"], options["to"], options["points"], options["linear"])
    with ProgressDisplay("frf", "frequencies", quiet=quiet) as progress:
        found = find_response(
            system,
            options["inputs"],
            options["responses"],
            hertz,
            name,
            modes=options["modes"],
            synchronous=options["synchronous"],
            progress=progress,
        )
    if target is not None:
        header = header_of(model, file, name or "", "frequency_response", "frequency_response")
        write_dataset(target, header, response_dataset(system, found), notes=found.notes)
    if options["picture"] is not None:
        _draw(options["picture"], found)
    summary = finished(begun, target, found.notes) | {
        "inputs": [{"name": n, "unit": u} for n, u in zip(found.inputs, found.input_units, strict=True)],
        "outputs": [{"name": n, "unit": u} for n, u in zip(found.outputs, found.output_units, strict=True)],
        "frequency": found.frequency.tolist(),
        "real": found.response.real.tolist(),
        "imag": found.response.imag.tolist(),
    }
    return summary, None


def _draw(path: Path, found: FrequencyResponse) -> None:
    """Write a picture of amplitude and phase."""
    from pitchpoint.report.figure_picture import write_picture
    from pitchpoint.viz.frequency_response_plot import curve_units, plot_frequency_response

    units = curve_units(found.output_units, found.input_units)
    figure = plot_frequency_response(found.frequency, found.response, found.outputs, found.inputs, units)
    write_picture(path, figure)


def _print(title: str, summary: dict[str, Any], *, quiet: bool) -> None:
    """Print the maximum of every response."""
    import numpy as np

    size = np.hypot(np.array(summary["real"]), np.array(summary["imag"]))
    hertz = summary["frequency"]
    cells = []
    for o, out in enumerate(summary["outputs"]):
        for i, put in enumerate(summary["inputs"]):
            at = int(np.argmax(size[:, o, i]))
            unit = f"{out['unit']} per {put['unit']}"
            cells.append(
                [
                    f"{out['name']} by {put['name']}",
                    f"{size[at, o, i]:.5g} {unit}",
                    shown(hertz[at], "frequency", 5),
                    f"{size[0, o, i]:.5g} {unit}",
                ]
            )
    table(title, ["response", "maximum", "at", f"at {shown(hertz[0], 'frequency', 4)}"], cells)
    if not quiet:
        show_notes(summary["notes"])
        if summary["output"] is not None:
            show(f"written to {summary['output']}")
