# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint contact-levels`: cost and error of all levels of contact, and a fitted stiffness law."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.contact_input import (
    flank_option,
    loads_of,
    mesh_option,
    misalignment_help,
    misalignment_of,
    refused_input,
    side_of,
)
from pitchpoint.cli.options import common, model_file, one_of, quantity, writes
from pitchpoint.cli.output import emit_json, show, shown, table
from pitchpoint.cli.settings import set_option

if TYPE_CHECKING:
    from pitchpoint.solvers.contact_analysis.law_fit import LawFit
    from pitchpoint.solvers.contact_analysis.levels import Levels

SIDES = {1: "front", -1: "back"}
"""Flanks in words."""
SMALL = (32, 12)
"""Phases and approaches of a small table."""


@click.command("contact-levels")
@model_file
@mesh_option
@quantity("--torque", "torque", "Torque on gear 1; default: constant torque of the loads on its body.")
@flank_option
@click.option(
    "--table",
    "size",
    type=click.Choice(["small", "default"]),
    default="default",
    show_default=True,
    help="Size of the table, if the mesh has no pre-computed contact.",
)
@click.option("--misalignment", metavar="QUANTITY", help=misalignment_help)
@writes("--picture", metavar="HTML", help="Write an HTML page with the patterns of all levels.")
@set_option
@common
def contact_levels(
    file: str,
    mesh: str | None,
    torque: float | None,
    flank: str | None,
    size: str,
    misalignment: str | None,
    picture: str | None,
    as_json: bool,
    allow_code: bool,
    quiet: bool,
) -> int:
    """Compare rigid, flexible and pre-computed contact and a stiffness law for the gears of a mesh of FILE.

    Stiffness of the rigid contact and the law are fitted to flexible contact at the torque and printed for a
    model file. All errors refer to flexible contact.
    """
    from pitchpoint.cli.failure import OK
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.cli.reading import read_model
    from pitchpoint.contact.potential_range import TableSize
    from pitchpoint.io.target import write_file
    from pitchpoint.report.figure_picture import check_picture
    from pitchpoint.solvers.contact_analysis.levels import compare_levels
    from pitchpoint.sweep.threads import on_all_cores

    model = read_model(file, allow_code, quiet)
    names = list(model.meshes)
    name = names[0] if mesh is None and len(names) == 1 else one_of(mesh, names, "mesh")
    if torque is None:
        (torque,), side = loads_of(model, name, (), flank)
    else:
        side = side_of(flank)
    tilt = None if misalignment is None else misalignment_of(misalignment, model, name)
    page = None if picture is None else check_picture(picture, [file], (".html",))
    small = TableSize(phase=SMALL[0], approach=SMALL[1]) if size == "small" else None
    with refused_input(), ProgressDisplay(name, "levels", quiet=quiet or as_json) as progress:
        found = compare_levels(
            model,
            name,
            torque=torque,
            flank=side,
            misalignment=tilt,
            size=small,
            run=on_all_cores,
            progress=progress,
        )
    if page is not None:
        write_file(page, _page(found, model.title or file))
    if as_json:
        emit_json(summary(found))
        return OK
    _print(found, quiet=quiet)
    return OK


def summary(found: Levels) -> dict[str, Any]:
    """Output of `contact-levels --json`, in SI units."""
    fit = found.fit
    return {
        "mesh": fit.mesh,
        "torque": fit.torque,
        "flank": fit.flank,
        "misalignment": found.misalignment,
        "table": found.table,
        "levels": {level: vars(numbers) for level, numbers in found.numbers.items()},
        "law": fit.law,
        "rigid": {"level": "rigid", "stiffness": fit.rigid_stiffness},
        "errors": {
            "pair_force_rms": fit.pair_error,
            "law_force": {"rms": fit.mesh_error[0], "max": fit.mesh_error[1]},
            "rigid_force": {"rms": fit.rigid_error[0], "max": fit.rigid_error[1]},
        },
    }


def _page(found: Levels, title: str) -> str:
    """Page with the patterns and curves of all levels."""
    from pitchpoint.viz.contact_levels_page import contact_levels_page

    facts = [
        ("mesh", found.fit.mesh),
        ("torque on gear 1", shown(found.fit.torque, "torque", 5)),
        ("flanks", SIDES[found.fit.flank]),
    ]
    if found.misalignment:
        facts.append(("misalignment", shown(found.misalignment, "angle", 4)))
    curves = found.phase, found.transmission_error
    return contact_levels_page(title, facts, summary(found)["levels"], found.analyses, curves)


def _print(found: Levels, *, quiet: bool) -> None:
    """Print the comparison, and both fits as parts of a model file."""
    from pitchpoint.viz.contact_levels_page import HEAD, level_rows

    fit = found.fit
    rows = level_rows(summary(found)["levels"], found.analyses)
    about = f"{fit.mesh} at {shown(fit.torque, 'torque', 5)}, {SIDES[fit.flank]} flanks"
    table(f"{about}: levels of contact", list(HEAD), rows)
    if not quiet:
        origin = "computed for this comparison" if found.table == "computed" else found.table
        show("force: difference from flexible contact at random phases and approaches over the mesh force")
        show(f"table of the pre-computed contact: {origin}")
    show("")
    for line in blocks(fit):
        show(line)


def blocks(fit: LawFit) -> list[str]:
    """Law and rigid contact as lines of a model file, with their errors as comments."""
    from pitchpoint.core.units import format_quantity
    from pitchpoint.viz.contact_levels_page import percent

    single = format_quantity(fit.c_prime, "stiffness_per_width", 6)
    ratios = f"stiffness_ratio: {fit.S_R:.6g}, tip_relief_factor: {fit.T_R:.6g}"
    law = f"stiffness: {{law: din3990, single_stiffness: {single}, {ratios}}}"
    rms, most = (percent(v) for v in fit.mesh_error)
    rigid_rms, rigid_most = (percent(v) for v in fit.rigid_error)
    return [
        f"# force of a tooth pair {percent(fit.pair_error)} rms; mesh force {rms} rms, {most} maximum",
        law,
        f"# mesh force {rigid_rms} rms, {rigid_most} maximum",
        f"contact: {{level: rigid, stiffness: {format_quantity(fit.rigid_stiffness, 'stiffness', 6)}}}",
    ]
