# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint contact`: loaded tooth contact of a mesh over mesh phase and torque."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.options import common, model_file, one_of, output, quantity, writes
from pitchpoint.cli.output import emit_json, show, show_notes, shown, table

if TYPE_CHECKING:
    from pathlib import Path

    import xarray as xr

    from pitchpoint.model.model import Model

CURVES = ("transmission_error", "unloaded_transmission_error", "mesh_stiffness", "secant_stiffness")
"""Curves over the mesh phase in the output of `--json`."""
NEEDED = "give the mesh one, such as `contact: {level: rigid}`"
MOST = 500
"""Maximum number of torques."""


@click.command()
@model_file
@click.option("--mesh", "-m", metavar="NAME", help="Mesh; default: the only one.")
@click.option(
    "--torque",
    "-t",
    "torques",
    multiple=True,
    metavar="QUANTITY",
    help="Torque on gear 1, repeatable; or a range FIRST:LAST:COUNT, such as '50 N m:400 N m:8'. "
    "Default: constant torque of the loads on the body of gear 1.",
)
@click.option(
    "--positions",
    type=click.IntRange(4, 100_000),
    default=64,
    show_default=True,
    help="Number of mesh phases over one base pitch.",
)
@click.option(
    "--misalignment",
    metavar="QUANTITY",
    help="Gap between the flanks in the plane of action, increasing towards +z: length over the common face "
    "width, or angle.",
)
@click.option(
    "--flank",
    type=click.Choice(["front", "back"]),
    help="Flanks in contact; default: by the sign of the default torque, else front.",
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
@output("Result file (netCDF-4/HDF5); default: none.")
@common
def contact(file: str, as_json: bool, allow_code: bool, quiet: bool, **options: Any) -> int:
    """Analyse the loaded tooth contact of a mesh of FILE, which has `contact`.

    Transmission error, stiffness, pressure, load distribution and losses for each torque; with --speed also
    oil film and flash temperature. The axes of the gears are fixed; --misalignment tilts the flanks.
    """
    from pitchpoint.cli.failure import OK, exit_code_of
    from pitchpoint.cli.reading import read_model
    from pitchpoint.cli.results import result_path, unless_it_cannot_begin
    from pitchpoint.io.target import check_target

    model = read_model(file, allow_code, quiet)
    mesh = _chosen(model, options["mesh"])
    options["torques"], options["flank"] = _loads(model, mesh, options["torques"], options["flank"])
    options["operation"] = _operation(model, mesh, options)
    options["misalignment"] = _angle(options["misalignment"], model, mesh)
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


def _chosen(model: Model, name: str | None) -> str:
    """Name of the mesh: the given one, or the only one with contact of tooth surfaces."""
    touching = [key for key, mesh in model.meshes.items() if mesh.contact is not None]
    if name is None and len(touching) == 1:
        return touching[0]
    if name is None and not touching:
        raise click.UsageError(f"no mesh has a contact of tooth surfaces; {NEEDED}")
    chosen = one_of(name, touching if name is None else list(model.meshes), "mesh")
    if chosen not in touching:
        raise click.BadParameter(f"{chosen} has a stiffness law; {NEEDED}", param_hint="--mesh")
    return chosen


def _loads(model: Model, mesh: str, texts: tuple[str, ...], side: str | None) -> tuple[list[float], int]:
    """Torques [N m] and flank, 1 or -1."""
    if texts:
        torques = [value for text in texts for value in torques_of(text)]
        if len(torques) > MOST:
            raise click.BadParameter(f"{len(torques)} torques (limit {MOST})", param_hint="--torque")
        return torques, -1 if side == "back" else 1
    found = default_torque(model, mesh)
    if found is None:
        raise click.UsageError(
            f"gear 1 of {mesh} ({model.meshes[mesh].gears[0]}) has no constant torque in loads:; "
            "give --torque, such as --torque '200 N m'"
        )
    sign = 1 if found > 0.0 else -1
    return [abs(found)], {"front": 1, "back": -1, None: sign}[side]


def torques_of(text: str) -> list[float]:
    """Torques of one option [N m]: a quantity, or a range with first, last and count.

    Examples
    --------
    >>> torques_of("0.2 kN m"), torques_of("50 N m:200:4")
    ([200.0], [50.0, 100.0, 150.0, 200.0])
    """
    parts = [part.strip() for part in text.split(":")]
    if len(parts) == 1:
        return [_quantity(text, "torque", "--torque")]
    if len(parts) != 3 or not parts[2].isdigit() or int(parts[2]) < 2:
        raise click.BadParameter(
            f"{text!r} is not a range FIRST:LAST:COUNT with a count of 2 or more, such as '50 N m:400 N m:8'",
            param_hint="--torque",
        )
    first, last = (_quantity(part, "torque", "--torque") for part in parts[:2])
    count = int(parts[2])
    if count > MOST:
        raise click.BadParameter(f"{count} torques (limit {MOST})", param_hint="--torque")
    return [first + (last - first) * k / (count - 1) for k in range(count)]


def _quantity(text: str, dimension: str, option: str) -> float:
    """Positive SI value of the text of an option; a number without unit is in SI."""
    from pitchpoint.core.errors import UnitError
    from pitchpoint.core.units import parse_quantity

    try:
        value: str | float = float(text)
    except ValueError:
        value = text
    try:
        return parse_quantity(value, dimension, positive=True)
    except UnitError as error:
        raise click.BadParameter(str(error), param_hint=option) from None


def default_torque(model: Model, mesh: str) -> float | None:
    """Sum of the constant torques of the loads on the body of gear 1 [N m]; None without any."""
    from pitchpoint.model.components.law import Constant

    body = model.body_of(model.meshes[mesh].gears[0])
    laws = [load.torque for load in model.loads.values() if load.body == body and load.torque is not None]
    values = [law.value for law in laws if isinstance(law, Constant)]
    return sum(values) if values and len(values) == len(laws) and sum(values) != 0.0 else None


def _angle(text: str | None, model: Model, mesh: str) -> float:
    """Misalignment in the plane of action [rad] from a length over the common face width, or an angle."""
    from pitchpoint.core.errors import UnitError
    from pitchpoint.core.units import parse_quantity

    if text is None:
        return 0.0
    hint = "--misalignment"
    try:
        float(text)
    except ValueError:
        pass
    else:
        raise click.BadParameter(f"{text} has no unit; write '{text} um' or '{text} deg'", param_hint=hint)
    try:
        return parse_quantity(text, "length") / model.pairs[mesh].b_w
    except UnitError:
        pass
    try:
        return parse_quantity(text, "angle")
    except UnitError:
        raise click.BadParameter(
            f"{text!r} is neither a length nor an angle; write '20 um' or '0.05 deg'", param_hint=hint
        ) from None


def _operation(model: Model, mesh: str, options: dict[str, Any]) -> dict[str, Any]:
    """Operating conditions; friction from the mesh if it is not given."""
    for name in ("viscosity", "pressure_viscosity"):
        needed = "speed" if name == "viscosity" else "viscosity"
        if options[name] is not None and options[needed] is None:
            raise click.UsageError(f"--{name.replace('_', '-')} requires --{needed}")
    own = model.meshes[mesh].friction
    friction = options["friction"] if options["friction"] is not None or own is None else own.mu
    found = {"friction": friction, **{n: options[n] for n in ("speed", "viscosity", "pressure_viscosity")}}
    return {name: value for name, value in found.items() if value is not None}


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
    from pitchpoint.solvers.contact_analysis.solve import solve_contact

    begun = time.perf_counter()
    failure: SolverError | None = None
    try:
        with ProgressDisplay("contact", "torques", quiet=quiet) as progress:
            data = solve_contact(
                model,
                mesh,
                torque=options["torques"],
                positions=options["positions"],
                misalignment=options["misalignment"],
                flank=options["flank"],
                progress=progress,
            )
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
        _draw(options["picture"], data, model)
    summary = {
        "status": status,
        "sentence": sentence,
        "wall_s": time.perf_counter() - begun,
        "output": None if target is None else str(target),
        "notes": [],
        **numbers(data),
    }
    return summary, failure


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


def _draw(path: Path, data: xr.Dataset, model: Model) -> None:
    """Write a page with plots."""
    from pitchpoint.io.target import write_file
    from pitchpoint.viz.contact_page import contact_page

    gears = {name: model.gears[name].geometry for name in model.meshes[str(data.attrs["mesh"])].gears}
    write_file(path, contact_page(data, gears=gears))


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
    show(f"{contact_words(options)}; {len(summary['mesh_phase'])} mesh phases, {_where(options)}")
    show_notes(summary["notes"])
    if summary["output"] is not None:
        show(f"written to {summary['output']}")


def _where(options: dict[str, Any]) -> str:
    """Flank, misalignment and operating conditions in words."""
    from pitchpoint.viz.contact_table import operation_words

    words = ["back flanks" if options.get("flank") == -1 else "front flanks"]
    angle = float(options.get("misalignment", 0.0))
    words += [f"misalignment {shown(angle, 'angle', 4)}"] if angle else []
    return ", ".join([*words, *operation_words(options)])
