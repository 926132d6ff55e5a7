# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint contact`: loaded tooth contact over mesh phase and torque, or of all meshes on their shafts."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.contact_input import (
    flank_option,
    loads_of,
    mesh_with_contact,
    meshes_on_shafts,
    misalignment_help,
    misalignment_of,
    operation_of,
    refuse_fixed,
    torques_option,
)
from pitchpoint.cli.options import common, model_file, quantity, writes
from pitchpoint.cli.output import emit_json
from pitchpoint.cli.settings import set_option

if TYPE_CHECKING:
    from pathlib import Path

    import xarray as xr

    from pitchpoint.core.errors import SolverError
    from pitchpoint.core.progress import Progress
    from pitchpoint.model.model import Model
    from pitchpoint.solvers.contact_analysis.on_shafts import ContactsOnShafts

CURVES = ("transmission_error", "unloaded_transmission_error", "mesh_stiffness", "secant_stiffness")
"""Curves over the mesh phase in the output of `--json`."""
UNDER_LOAD = ("misalignment", "center_distance")
"""Positions of the axes over the mesh phase, with --shafts."""


@click.command()
@model_file
@click.option(
    "--mesh",
    "-m",
    "meshes",
    multiple=True,
    metavar="NAME",
    help="Mesh; default: the only one with contact, with --shafts all. Repeatable with --shafts.",
)
@torques_option
@click.option(
    "--positions",
    type=click.IntRange(4, 100_000),
    default=64,
    show_default=True,
    help="Number of mesh phases over one base pitch.",
)
@click.option("--misalignment", metavar="QUANTITY", help=misalignment_help)
@flank_option
@click.option(
    "--shafts",
    is_flag=True,
    help="Axes as shafts, bearings and housing hold them under the loads of the model; default: fixed.",
)
@click.option(
    "--scenario", "-s", metavar="NAME", help="Scenario whose loads apply, with --shafts; default: at rest."
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
@click.option(
    "--root-stress",
    type=click.Choice(["tangent", "finite_elements"]),
    help="Method of the root stress: 30° tangent of the fillet to ISO 6336-3, or also finite elements "
    "(seconds per gear, stored); default: finite elements if the teeth of the contact are.",
)
@writes("--picture", metavar="HTML", help="Write an HTML page with plots.")
@writes(
    "-o", "--output", "--out", help="Result file (netCDF-4/HDF5), or page with plots (.html); default: none."
)
@click.option(
    "--load-cases",
    is_flag=True,
    help="Analyse all load cases of the file in turn; files get the name of the load case.",
)
@set_option
@common
def contact(file: str, as_json: bool, allow_code: bool, quiet: bool, **options: Any) -> int:
    """Analyse the loaded tooth contact of a mesh of FILE, which has `contact`.

    Transmission error, stiffness, pressure, root stress, load distribution and losses for each torque; with
    --speed also oil film and flash temperature. The axes of the gears are fixed, and --misalignment tilts the
    flanks; with --shafts they are in equilibrium with the whole machine, and all meshes with `contact` are
    analysed.
    """
    from pitchpoint.cli.contact_output import print_meshes, print_torques
    from pitchpoint.cli.failure import OK, exit_code_of
    from pitchpoint.cli.reading import read_model
    from pitchpoint.cli.vary import load_cases_in

    model = read_model(file, allow_code, quiet)
    every = load_cases_in(file) if options.pop("load_cases") else None
    summaries, code = {}, OK
    for case in every or [""]:
        own = model.replace("load_case", case) if case else model
        given = {**options, **{key: of_case(options[key], case) for key in ("output", "picture")}}
        summary, error, meshes = analysed(own, file, given, quiet=quiet)
        code = code if error is None else exit_code_of(error)
        summaries[case] = summary
        title = (model.title or file) + (f", {case}" if case else "")
        if as_json or quiet and given["output"] is not None and error is None:
            pass  # the file contains everything
        elif summary.get("torque"):
            print_torques(f"{title}: contact of {meshes[0]}", summary, quiet=quiet)
        elif summary.get("meshes"):
            print_meshes(f"{title}: contact of all meshes", summary, quiet=quiet)
    if as_json:
        emit_json(summaries[""] if every is None else {"load_cases": summaries})
    return code


def of_case(path: str | None, case: str) -> str | None:
    """File name of a load case.

    Examples
    --------
    >>> of_case("contact.h5", "rated"), of_case("contact.h5", ""), of_case(None, "rated")
    ('contact-rated.h5', 'contact.h5', None)
    """
    from pathlib import Path

    if path is None or not case:
        return path
    return str(Path(path).with_name(f"{Path(path).stem}-{case}{Path(path).suffix}"))


def analysed(
    model: Model, file: str, options: dict[str, Any], *, quiet: bool
) -> tuple[dict[str, Any], BaseException | None, tuple[str, ...]]:
    """Check the options against a model and analyse its contacts: summary, failure, analysed meshes."""
    from pitchpoint.cli.results import result_path, unless_it_cannot_begin
    from pitchpoint.report.figure_picture import check_picture

    if options["shafts"]:
        refuse_fixed(model, options)
        meshes = meshes_on_shafts(model, options)
    else:
        if options["scenario"] is not None:
            raise click.UsageError("--scenario requires --shafts; on fixed axes only --torque acts")
        if len(options["meshes"]) > 1:
            raise click.UsageError("several --mesh require --shafts; on fixed axes analyse one at a time")
        mesh = mesh_with_contact(model, *options["meshes"] or (None,))
        meshes = (mesh,)
        options["torques"], options["flank"] = loads_of(model, mesh, options["torques"], options["flank"])
        if options["misalignment"] is not None:
            options["misalignment"] = misalignment_of(options["misalignment"], model, mesh)
    options["operation"] = {mesh: operation_of(model, mesh, options) for mesh in meshes}
    if (options["output"] or "").lower().endswith(".html"):
        if options["picture"] is not None:
            raise click.UsageError(
                f"{options['output']} is a page, too; name a result file such as result.h5"
            )
        options["picture"], options["output"] = options["output"], None
    target = result_path(options["output"], file, "") if options["output"] is not None else None
    if options["picture"] is not None:
        options["picture"] = check_picture(options["picture"], [file], (".html",))
    empty: dict[str, Any] = {"torque": [], "numbers": {}}
    if len(meshes) > 1:
        empty = {"omitted": {}, "failed": {}, "meshes": {}}
    empty["picture"] = None
    summary, error = unless_it_cannot_begin(
        lambda: compute(model, file, meshes, target, options, quiet=quiet), empty
    )
    return summary, error, meshes


def compute(
    model: Model,
    file: str,
    meshes: tuple[str, ...],
    target: Path | None,
    options: dict[str, Any],
    *,
    quiet: bool,
) -> tuple[dict[str, Any], BaseException | None]:
    """Analyse the contact and write it if requested; return the output of `contact --json`.

    After a failure these are the torques before it, and the other meshes.
    """
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.core.errors import SolverError
    from pitchpoint.io.writing import how_it_ended
    from pitchpoint.solvers.contact_analysis.lubrication import Operation, with_operation

    begun = time.perf_counter()
    unit = "positions" if options["shafts"] else "torques"
    with ProgressDisplay("contact", unit, quiet=quiet) as progress:
        found, stopped = _solved(model, meshes, options, progress)
    failure = stopped and SolverError(str(stopped), stopped.status, target and str(target))
    for mesh, data in found.meshes.items():
        own = options["operation"][mesh]
        found.meshes[mesh] = with_operation(data, Operation(**own)).assign_attrs(own)
    status, sentence, code = how_it_ended(failure)
    if target is not None:
        store(target, model, file, found, meshes, status=status, sentence=sentence, code=code)
    if options["picture"] is not None:
        _draw(options["picture"], found, model, "" if failure is None else f"{status}: {sentence}")
    summary = {
        "status": status,
        "sentence": sentence,
        "wall_s": time.perf_counter() - begun,
        "output": None if target is None else str(target),
        "picture": None if options["picture"] is None else str(options["picture"]),
        "notes": notes_of(found),
    }
    if len(meshes) == 1:
        return summary | numbers(found.meshes[meshes[0]]), failure
    summary |= {"omitted": found.omitted, "failed": found.failed}
    return summary | {"meshes": {mesh: numbers(data) for mesh, data in found.meshes.items()}}, failure


def _solved(
    model: Model, meshes: tuple[str, ...], options: dict[str, Any], progress: Progress
) -> tuple[ContactsOnShafts, SolverError | None]:
    """Contact analyses on fixed axes, or on shafts in equilibrium, and the error that stopped them."""
    from pitchpoint.core.errors import SolverError
    from pitchpoint.solvers.contact_analysis.on_shafts import ContactsOnShafts, solve_contacts_on_shafts
    from pitchpoint.solvers.contact_analysis.solve import solve_contact

    n, root = options["positions"], options["root_stress"]
    try:
        if options["shafts"]:
            chosen, scenario = options["meshes"] or None, options["scenario"]
            return solve_contacts_on_shafts(
                model, chosen, scenario=scenario, positions=n, root_stress=root, progress=progress
            ), None
        data = solve_contact(
            model,
            meshes[0],
            torque=options["torques"],
            positions=n,
            misalignment=options["misalignment"],
            flank=options["flank"],
            root_stress=root,
            progress=progress,
        )
        return ContactsOnShafts({meshes[0]: data}), None
    except SolverError as error:
        found = error.partial
        if found is not None and not isinstance(found, ContactsOnShafts):
            found = ContactsOnShafts({meshes[0]: found})
        if found is None or not found.meshes:
            error.partial = None
            raise
        return found, error


def notes_of(found: ContactsOnShafts) -> list[str]:
    """Notes of all analyses, and meshes that were omitted."""
    from pitchpoint.core.errors import split_notes

    notes = [note for data in found.meshes.values() for note in split_notes(str(data.attrs.get("notes", "")))]
    left = [f"mesh {mesh} is omitted: {reason}" for mesh, reason in found.omitted.items()]
    return [*dict.fromkeys(notes), *left]


def numbers(data: xr.Dataset) -> dict[str, Any]:
    """Main results and mean mesh force by torque, and curves over mesh phase and face width, in SI units."""
    from pitchpoint.analysis.flank_contact.active_flank import contact_path
    from pitchpoint.analysis.flank_contact.load_factors import load_over_width
    from pitchpoint.analysis.flank_contact.numbers import contact_numbers
    from pitchpoint.viz.contact_table import options_of

    return {
        "mesh": data.attrs["mesh"],
        "options": options_of(data),
        "torque": data["torque"].values.tolist(),
        "mesh_force": data["mesh_force"].mean("mesh_phase_position").values.tolist(),
        "numbers": {name: values.tolist() for name, values in contact_numbers(data).items()},
        "mesh_phase": data["mesh_phase_position"].values.tolist(),
        "curves": {name: data[name].values.tolist() for name in CURVES},
        "face_width": float(data["plane_width"].sum()),
        "plane": data["plane"].values.tolist(),
        "load_over_width": load_over_width(data).tolist(),
        **{name: data[name].values.tolist() for name in UNDER_LOAD if name in data},
        "contact_path": [contact_path(data, k) for k in range(data.sizes["torque"])],
        "active_flanks": active_flanks_of(data),
    }


def store(
    path: Path, model: Model, file: str, found: ContactsOnShafts, meshes: tuple[str, ...], **ending: Any
) -> None:
    """Write contact analyses to a result file: several meshes as groups `meshes/NAME`."""
    import json
    from dataclasses import replace

    from pitchpoint.cli.results import header_of
    from pitchpoint.io.dataset_tables import write_dataset, write_datasets
    from pitchpoint.viz.contact_table import options_of

    header = header_of(model, file, "", "contact", "contact")
    options = {mesh: options_of(data) for mesh, data in found.meshes.items()}
    if len(meshes) == 1:
        write_dataset(path, replace(header, options=options[meshes[0]]), found.meshes[meshes[0]], **ending)
        return
    texts = {
        f"meshes/{mesh}": {
            "mesh": mesh,
            "options": json.dumps(options[mesh], sort_keys=True),
            "notes": str(data.attrs.get("notes", "")),
            "sentence": found.failed.get(mesh, ""),
        }
        for mesh, data in found.meshes.items()
    }
    groups = {f"meshes/{mesh}": data for mesh, data in found.meshes.items()}
    header = replace(header, options={"meshes": list(found.meshes), "omitted": found.omitted})
    write_datasets(path, header, groups, texts, notes=notes_of(found), **ending)


def active_flanks_of(data: xr.Dataset) -> list[list[dict[str, Any]] | None]:
    """Flanks of both gears in contact, by torque: start and end towards root and tip."""
    from pitchpoint.analysis.flank_contact.active_flank import active_flanks

    found: list[list[dict[str, Any]] | None] = []
    for k in range(data.sizes["torque"]):
        both = active_flanks(data, k)
        found.append(both and [{key: v.tolist() for key, v in vars(one).items()} for one in both])
    return found


def _draw(path: Path, found: ContactsOnShafts, model: Model, note: str) -> None:
    """Write a page with plots, and notes on incomplete analyses."""
    from pitchpoint.io.target import write_file
    from pitchpoint.viz.contact_page import contacts_page

    gears = {
        mesh: {name: model.gears[name].geometry for name in model.meshes[mesh].gears} for mesh in found.meshes
    }
    write_file(path, contacts_page(found.meshes, note, gears=gears, omitted=found.omitted))
