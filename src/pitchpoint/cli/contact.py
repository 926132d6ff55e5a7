# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint contact`: loaded tooth contact of a mesh over mesh phase and torque."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.contact_input import (
    loads_of,
    mesh_option,
    mesh_with_contact,
    misalignment_help,
    misalignment_of,
    operation_of,
    refuse_fixed,
    torques_option,
)
from pitchpoint.cli.options import common, model_file, quantity, writes
from pitchpoint.cli.output import emit_json, show, show_notes, shown, table

if TYPE_CHECKING:
    from pathlib import Path

    import xarray as xr

    from pitchpoint.core.progress import Progress
    from pitchpoint.model.model import Model

CURVES = ("transmission_error", "unloaded_transmission_error", "mesh_stiffness", "secant_stiffness")
"""Curves over the mesh phase in the output of `--json`."""
UNDER_LOAD = ("misalignment", "center_distance")
"""Positions of the axes over the mesh phase, with --shafts."""


@click.command()
@model_file
@mesh_option
@torques_option
@click.option(
    "--positions",
    type=click.IntRange(4, 100_000),
    default=64,
    show_default=True,
    help="Number of mesh phases over one base pitch.",
)
@click.option("--misalignment", metavar="QUANTITY", help=misalignment_help)
@click.option(
    "--flank",
    type=click.Choice(["front", "back"]),
    help="Flanks in contact; default: by the sign of the default torque, else front.",
)
@click.option(
    "--shafts",
    is_flag=True,
    help="Axes as shafts, bearings and housing hold them under the loads of the model; default: fixed.",
)
@click.option(
    "--scenario", "-s", metavar="NAME", help="Scenario whose loads apply, with --shafts; default: at rest."
)
@click.option(
    "--root-stress",
    type=click.Choice(["tangent", "finite_elements"]),
    help="Method of the root stress: 30° tangent of the fillet to ISO 6336-3, or also finite elements "
    "(seconds per gear, stored); default: finite elements if the teeth of the contact are.",
)
@quantity("--speed", "angular_speed", "Speed of gear 1, for oil film and flash temperature.")
@click.option(
    "--friction",
    type=click.FloatRange(0.0, 2.0),
    metavar="MU",
    help="Mean coefficient of friction; default: that of the mesh, if any.",
)
@quantity(
    "--viscosity", "dynamic_viscosity", "Dynamic viscosity of the oil at the temperature of the flanks."
)
@quantity(
    "--pressure-viscosity",
    "pressure_viscosity",
    "Pressure-viscosity coefficient; default: 20 1/GPa, typical of mineral oils.",
)
@writes("--picture", metavar="HTML", help="Write an HTML page with plots.")
@writes(
    "-o", "--output", "--out", help="Result file (netCDF-4/HDF5), or page with plots (.html); default: none."
)
@common
def contact(file: str, as_json: bool, allow_code: bool, quiet: bool, **options: Any) -> int:
    """Analyse the loaded tooth contact of a mesh of FILE, which has `contact`.

    Transmission error, stiffness, pressure, root stress, load distribution and losses for each torque; with
    --speed also oil film and flash temperature. The axes of the gears are fixed, and --misalignment tilts the
    flanks; with --shafts they are in equilibrium with the whole machine.
    """
    from pitchpoint.cli.failure import OK, exit_code_of
    from pitchpoint.cli.reading import read_model
    from pitchpoint.cli.results import result_path, unless_it_cannot_begin
    from pitchpoint.io.target import check_target

    model = read_model(file, allow_code, quiet)
    mesh = mesh_with_contact(model, options["mesh"])
    options["operation"] = operation_of(model, mesh, options)
    if options["shafts"]:
        refuse_fixed(model, options)
    else:
        if options["scenario"] is not None:
            raise click.UsageError("--scenario requires --shafts; on fixed axes only --torque acts")
        options["torques"], options["flank"] = loads_of(model, mesh, options["torques"], options["flank"])
        if options["misalignment"] is not None:
            options["misalignment"] = misalignment_of(options["misalignment"], model, mesh)
    if options["picture"] is None and (options["output"] or "").lower().endswith(".html"):
        options["picture"], options["output"] = options["output"], None
    target = result_path(options["output"], file, "") if options["output"] is not None else None
    if options["picture"] is not None:
        options["picture"] = check_target(options["picture"], "page", [file])
    summary, error = unless_it_cannot_begin(
        lambda: compute(model, file, mesh, target, options, quiet=quiet), {"torque": [], "numbers": {}}
    )
    if as_json:
        emit_json(summary)
    elif summary["torque"]:
        _print(f"{model.title or file}: contact of {mesh}", summary, quiet=quiet)
    return OK if error is None else exit_code_of(error)


def compute(
    model: Model, file: str, mesh: str, target: Path | None, options: dict[str, Any], *, quiet: bool
) -> tuple[dict[str, Any], BaseException | None]:
    """Analyse the contact and write it if requested; return the output of `contact --json`.

    After a failure these are the torques before it.
    """
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.core.errors import SolverError
    from pitchpoint.io.writing import how_it_ended
    from pitchpoint.solvers.contact_analysis.lubrication import Operation, with_operation

    begun = time.perf_counter()
    failure: SolverError | None = None
    try:
        unit = "positions" if options["shafts"] else "torques"
        with ProgressDisplay("contact", unit, quiet=quiet) as progress:
            data = _solved(model, mesh, options, progress)
    except SolverError as error:
        if error.partial is None:
            raise
        failure, data = SolverError(str(error), error.status, target and str(target)), error.partial
    data = with_operation(data, Operation(**options["operation"]))
    data.attrs |= options["operation"]
    status, sentence, code = how_it_ended(failure)
    if target is not None:
        store(target, model, file, data, status=status, sentence=sentence, code=code)
    if options["picture"] is not None:
        _draw(options["picture"], data, model, "" if failure is None else f"{status}: {sentence}")
    summary = {
        "status": status,
        "sentence": sentence,
        "wall_s": time.perf_counter() - begun,
        "output": None if target is None else str(target),
        "notes": [note for note in str(data.attrs.get("notes", "")).split("; ") if note],
        **numbers(data),
    }
    return summary, failure


def _solved(model: Model, mesh: str, options: dict[str, Any], progress: Progress) -> xr.Dataset:
    """Contact analysis on fixed axes, or on shafts in equilibrium."""
    from pitchpoint.solvers.contact_analysis.on_shafts import solve_contact_on_shafts
    from pitchpoint.solvers.contact_analysis.solve import solve_contact

    n, root = options["positions"], options["root_stress"]
    if options["shafts"]:
        scenario = options["scenario"]
        return solve_contact_on_shafts(
            model, mesh, scenario=scenario, positions=n, root_stress=root, progress=progress
        )
    return solve_contact(
        model,
        mesh,
        torque=options["torques"],
        positions=n,
        misalignment=options["misalignment"],
        flank=options["flank"],
        root_stress=root,
        progress=progress,
    )


def numbers(data: xr.Dataset) -> dict[str, Any]:
    """Main results by torque, and curves over mesh phase and face width, in SI units."""
    from pitchpoint.analysis.flank_contact.active_flank import contact_path
    from pitchpoint.analysis.flank_contact.load_factors import load_over_width
    from pitchpoint.analysis.flank_contact.numbers import contact_numbers
    from pitchpoint.viz.contact_table import options_of

    return {
        "mesh": data.attrs["mesh"],
        "options": options_of(data),
        "torque": data["torque"].values.tolist(),
        "numbers": {name: values.tolist() for name, values in contact_numbers(data).items()},
        "mesh_phase": data["mesh_phase_position"].values.tolist(),
        "curves": {name: data[name].values.tolist() for name in CURVES},
        "plane": data["plane"].values.tolist(),
        "load_over_width": load_over_width(data).tolist(),
        **{name: data[name].values.tolist() for name in UNDER_LOAD if name in data},
        "contact_path": [contact_path(data, k) for k in range(data.sizes["torque"])],
        "active_flanks": active_flanks_of(data),
    }


def store(path: Path, model: Model, file: str, data: xr.Dataset, **ending: Any) -> None:
    """Write a contact analysis to a result file."""
    from dataclasses import replace

    from pitchpoint.cli.results import header_of
    from pitchpoint.io.dataset_tables import write_dataset
    from pitchpoint.viz.contact_table import options_of

    header = header_of(model, file, "", "contact", "contact")
    write_dataset(path, replace(header, options=options_of(data)), data, **ending)


def active_flanks_of(data: xr.Dataset) -> list[list[dict[str, Any]] | None]:
    """Flanks of both gears in contact, by torque: start and end towards root and tip."""
    from pitchpoint.analysis.flank_contact.active_flank import active_flanks

    found: list[list[dict[str, Any]] | None] = []
    for k in range(data.sizes["torque"]):
        both = active_flanks(data, k)
        found.append(both and [{key: v.tolist() for key, v in vars(one).items()} for one in both])
    return found


def _draw(path: Path, data: xr.Dataset, model: Model, note: str) -> None:
    """Write a page with plots, and a note on an incomplete analysis."""
    from pitchpoint.io.target import write_file
    from pitchpoint.viz.contact_page import contact_page

    gears = {name: model.gears[name].geometry for name in model.meshes[str(data.attrs["mesh"])].gears}
    write_file(path, contact_page(data, note, gears=gears))


def _print(title: str, summary: dict[str, Any], *, quiet: bool) -> None:
    """Print one row per torque, and the description of the contact."""
    from pitchpoint.viz.contact_table import columns, contact_words

    found = summary["numbers"]
    chosen = columns(found)
    rows = [
        [shown(torque, "torque", 5), *(c.text(found[c.key][k]) for c in chosen)]
        for k, torque in enumerate(summary["torque"])
    ]
    table(title, ["torque", *(c.heading for c in chosen)], rows)
    if quiet:
        return
    options = summary["options"]
    show(f"{contact_words(options)}; {len(summary['mesh_phase'])} mesh phases, {_where(summary)}")
    show_notes(summary["notes"])
    if summary["output"] is not None:
        show(f"written to {summary['output']}")


def _where(summary: dict[str, Any]) -> str:
    """Flank, misalignment and operating conditions in words."""
    from pitchpoint.viz.contact_table import operation_words

    options = summary["options"]
    words = ["back flanks" if options.get("flank") == -1 else "front flanks"]
    tilts = summary.get("misalignment", [options.get("misalignment", 0.0)])
    angle = sum(tilts) / len(tilts)
    words += ["shafts in equilibrium"] if options.get("shafts") else []
    words += [f"misalignment {shown(angle, 'angle', 4)}"] if angle else []
    return ", ".join([*words, *operation_words(options)])
