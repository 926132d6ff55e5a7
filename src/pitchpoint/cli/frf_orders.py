# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint frf --mesh-orders`: response to the excitation by the meshes, by order and speed."""

from __future__ import annotations

import time
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from pitchpoint.cli.output import show, show_notes, shown, table

if TYPE_CHECKING:
    from pathlib import Path

    from pitchpoint.model.model import Model
    from pitchpoint.solvers.mesh_response import MeshResponse

MAX_ROWS = 3
"""Resonances listed per response and order."""


def compute(
    model: Model, file: str, name: str | None, target: Path | None, options: dict[str, Any], *, quiet: bool
) -> tuple[dict[str, Any], None]:
    """Compute the response and write it if requested; return the output of `frf --json`."""
    from pitchpoint.analysis.levels import level, reference_of
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.cli.results import finished, header_of
    from pitchpoint.io.dataset_tables import write_dataset
    from pitchpoint.solvers.mesh_response import find_mesh_response, mesh_response_dataset
    from pitchpoint.system.compile import compile_model

    begun = time.perf_counter()
    top = options["to_speed"]
    low = 0.05 * top if options["from_speed"] is None else options["from_speed"]
    speeds = np.linspace(low, top, options["points"])
    system = compile_model(model, name)
    with ProgressDisplay("frf", "speeds", quiet=quiet) as progress:
        found = find_mesh_response(
            system,
            options["responses"],
            options["speed_of"],
            speeds,
            name,
            harmonics=options["mesh_orders"],
            progress=progress,
        )
    if target is not None:
        header = header_of(model, file, name or "", "mesh_response", "frequency_response")
        header = replace(header, options={**header.options, "body": found.body})
        write_dataset(target, header, mesh_response_dataset(system, found), notes=found.notes)
    if options["picture"] is not None:
        _draw(options["picture"], found)
    sizes = np.abs(found.response) / np.sqrt(2.0)
    summary = finished(begun, target, found.notes) | {
        "body": found.body,
        "speed": found.speed.tolist(),
        "orders": [
            {"mesh": m, "harmonic": h, "order": float(o), "error": float(abs(e))}
            for m, h, o, e in zip(found.meshes, found.harmonics, found.order, found.error, strict=True)
        ],
        "outputs": [
            {"name": n, "unit": u, "reference": reference_of(u)[0]}
            for n, u in zip(found.outputs, found.units, strict=True)
        ],
        "level": [level(sizes[:, :, o], u).tolist() for o, u in enumerate(found.units)],
        "modes": [
            {"name": n, "frequency": float(f)}
            for n, f in zip(found.mode_names, found.mode_frequency, strict=True)
        ],
    }
    return summary, None


def check_options(options: dict[str, Any]) -> None:
    """Stop if options are missing or without effect for the response by mesh order."""
    if options["speed_of"] is None or options["to_speed"] is None:
        raise click.UsageError(
            "--mesh-orders needs the speeds: --speed-of BODY and --to-speed, such as --to-speed '3000 rpm'"
        )
    for key in ("inputs", "from", "to", "linear", "modes", "synchronous"):
        if options[key]:
            name = {"inputs": "input"}.get(key, key)
            raise click.UsageError(f"--{name} has no effect with --mesh-orders; omit it")


def _draw(path: Path, found: MeshResponse) -> None:
    """Write a picture of order cuts and maps."""
    from pitchpoint.report.figure_picture import write_picture
    from pitchpoint.viz.mesh_response_plot import order_names, plot_mesh_response

    figure = plot_mesh_response(
        found.speed,
        found.frequency,
        np.abs(found.response),
        order_names(found.meshes, found.harmonics),
        found.outputs,
        found.units,
        modes=found.mode_frequency,
        shaft=found.body,
    )
    write_picture(path, figure)


def print_orders(title: str, summary: dict[str, Any], *, quiet: bool) -> None:
    """Print the highest resonances of every response and mesh order, with the nearest mode."""
    from pitchpoint.analysis.levels import reference_of
    from pitchpoint.viz.mesh_response_plot import peaks

    rows = []
    speeds = np.array(summary["speed"])
    for output, levels in zip(summary["outputs"], summary["level"], strict=True):
        for k, order in enumerate(summary["orders"]):
            curve = np.array(levels)[:, k]
            places = peaks(curve)[:MAX_ROWS] or [int(np.argmax(curve))]
            for number, at in enumerate(places):
                hertz = abs(speeds[at]) * order["order"] / (2.0 * np.pi)
                name = f"{output['name']}, {order['harmonic']} × {order['mesh']}"
                rows.append(
                    [
                        name if number == 0 else "",
                        f"{curve[at]:.1f} dB",
                        shown(speeds[at], "angular_speed", 5),
                        shown(hertz, "frequency", 4),
                        nearest_mode(hertz, summary["modes"]),
                    ]
                )
    references = dict.fromkeys(reference_of(o["unit"])[1] for o in summary["outputs"])
    notes = [f"levels of rms values, dB re {', '.join(references)}"]
    errors = ", ".join(f"{o['harmonic']} × {o['mesh']} {1e6 * o['error']:.3g} µm" for o in summary["orders"])
    notes.append(f"loaded transmission error, peak amplitudes: {errors}")
    table(title, ["response", "level", f"at speed of {summary['body']}", "frequency", "mode"], rows, notes)
    if not quiet:
        show_notes(summary["notes"])
        if summary["output"] is not None:
            show(f"written to {summary['output']}")


NEAR = 0.05
"""Relative distance from a natural frequency within which a maximum is assigned to it."""


def nearest_mode(hertz: float, modes: list[dict[str, Any]]) -> str:
    """Main motion and frequency of the mode at a frequency [Hz]; a dash if none is near.

    Examples
    --------
    >>> nearest_mode(101.0, [{"name": "bounce", "frequency": 100.0}]), nearest_mode(50.0, [])
    ('bounce, 100 Hz', '–')
    """
    near = [m for m in modes if m["frequency"] > 0.0 and abs(hertz / m["frequency"] - 1.0) <= NEAR]
    if not near:
        return "–"
    mode = min(near, key=lambda m: abs(hertz - m["frequency"]))
    return f"{mode['name'].partition(',')[0]}, {shown(mode['frequency'], 'frequency', 4)}"
