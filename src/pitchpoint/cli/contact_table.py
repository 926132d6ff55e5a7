# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint contact-table`: pre-computed contact of a mesh, a table of its elastic potential."""

from __future__ import annotations

import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.contact_input import mesh_option, mesh_with_contact, misalignment_of, refused_input
from pitchpoint.cli.options import common, model_file, output, quantity
from pitchpoint.cli.output import emit_json, show, show_notes, shown, table

if TYPE_CHECKING:
    from pitchpoint.contact.potential_fit import PotentialTable
    from pitchpoint.model.model import Model

LISTED = {
    "force": "force",
    "travel_force": "force by the motion of the contact",
    "tilting_moment": "tilting moment",
    "centre_force": "force by the centre distance",
    "friction_force": "friction force",
}
"""Errors shown in the terminal, with their names."""


@click.command("contact-table")
@model_file
@mesh_option
@quantity("--torque", "torque", "Highest torque on gear 1, such as '300 N m'.")
@click.option(
    "--misalignment",
    metavar="QUANTITY",
    help="Largest misalignment in the plane of action, either sign: length over the common face width, or "
    "angle; default: misalignment of the mesh.",
)
@quantity("--centre-distance", "length", "Largest change of the centre distance, either sign; default: 0.")
@output("Contact table; default: MODEL-MESH.gcp.h5.")
@common
def contact_table(file: str, as_json: bool, allow_code: bool, quiet: bool, **options: Any) -> int:
    """Compute the contact table of a mesh of FILE for `contact: {level: precomputed}`.

    The error of the table against flexible contact is measured at random states and stored with it.
    """
    from pitchpoint.cli.failure import OK
    from pitchpoint.cli.reading import read_model
    from pitchpoint.contact.potential_accuracy import inaccuracy
    from pitchpoint.io.contact_table import SUFFIX, write_contact_table
    from pitchpoint.io.target import check_target
    from pitchpoint.model.contact_inputs import contact_inputs

    if options["torque"] is None:
        raise click.UsageError(
            "--torque is required: the highest torque on gear 1, such as --torque '300 N m'"
        )
    model = read_model(file, allow_code, quiet)
    mesh = mesh_with_contact(model, options["mesh"], ("flexible",))
    target = options["output"] or f"{Path(file).with_suffix('')}-{mesh}{SUFFIX}"
    check_target(target, "contact", [file])
    began = time.perf_counter()
    with refused_input():
        tables = compute(model, mesh, options, quiet or as_json)
    written = write_contact_table(target, tables, contact_inputs(model, mesh, model.meshes[mesh].contact))
    poor = inaccuracy({flank: found.errors for flank, found in tables.items()})
    summary = {
        "mesh": mesh,
        "file": str(written),
        "bytes": written.stat().st_size,
        "wall_s": time.perf_counter() - began,
        "flanks": {flank: _summary(found) for flank, found in tables.items()},
        "notes": [] if poor is None else [poor.changed(where=f"contact table of {mesh}")],
    }
    if as_json:
        emit_json(summary)
    else:
        _print(summary)
    return OK


def compute(model: Model, mesh: str, options: dict[str, Any], quiet: bool) -> dict[str, PotentialTable]:
    """Tables of both flanks on all cores; those of the back flanks follow the front ones."""
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.solvers.contact_analysis.precompute import TableRequest, contact_table
    from pitchpoint.sweep.threads import on_all_cores

    tilt = options["misalignment"]
    request = TableRequest(
        torque=options["torque"],
        misalignment=None if tilt is None else abs(misalignment_of(tilt, model, mesh)),
        centre_distance=options["centre_distance"] or 0.0,
    )
    found = {}
    for name, flank in (("front", 1), ("back", -1)):
        with ProgressDisplay(f"{mesh}: {name} flanks", "states", quiet=quiet) as progress:
            found[name] = contact_table(model, mesh, request, flank, run=on_all_cores, progress=progress)
    return found


def _summary(found: PotentialTable) -> dict[str, Any]:
    """Axes and measured errors of a table."""
    return {
        "axes": {
            axis.name: {"points": axis.count, "range": [float(end) for end in axis.range]}
            for axis in found.axes
        },
        "errors": {
            name: {"rms": sizes[0], "max": sizes[1], "rms_of_quantity": sizes[2]}
            for name, sizes in found.errors.items()
        },
    }


def _print(summary: dict[str, Any]) -> None:
    """Print range and errors of both tables."""
    front = summary["flanks"]["front"]
    units = {"approach": "length", "misalignment": "angle", "centre_distance": "length"}
    rows = [
        [
            name.replace("_", " "),
            str(axis["points"]),
            *(shown(v, units.get(name, "dimensionless"), 5) for v in axis["range"]),
        ]
        for name, axis in front["axes"].items()
    ]
    table(f"Contact table of {summary['mesh']}", ["axis", "points", "from", "to"], rows)
    rows = [
        [
            words,
            *(
                f"{100.0 * summary['flanks'][flank]['errors'][name][size]:.3f} %"
                for flank in ("front", "back")
                for size in ("rms", "max")
            ),
        ]
        for name, words in LISTED.items()
    ]
    head = ["error over the nominal value", "front, rms", "front, max", "back, rms", "back, max"]
    table("Errors against flexible contact at random states", head, rows)
    show_notes(summary["notes"])
    size = summary["bytes"] / 1e6
    show(f"written to {summary['file']}, {size:.1f} MB, in {summary['wall_s']:.1f} s")
