# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint contact-levels`: cost and error of all levels of contact, and a fitted stiffness law."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.contact_input import mesh_option, torque_of_loads
from pitchpoint.cli.options import common, model_file, one_of, quantity
from pitchpoint.cli.output import emit_json, show, shown, table

if TYPE_CHECKING:
    from pitchpoint.solvers.contact_analysis.law_fit import LawFit
    from pitchpoint.solvers.contact_analysis.levels import Levels

NAMES = {
    "rigid": "rigid",
    "flexible": "flexible",
    "precomputed": "pre-computed",
    "law": "law din3990",
}
"""Levels as shown in the terminal."""
SMALL = (32, 12)
"""Phases and approaches of a small table."""


@click.command("contact-levels")
@model_file
@mesh_option
@quantity("--torque", "torque", "Torque on gear 1; default: constant torque of the loads on its body.")
@click.option(
    "--table",
    "size",
    type=click.Choice(["small", "default"]),
    default="default",
    show_default=True,
    help="Size of the table, if the mesh has no pre-computed contact.",
)
@common
def contact_levels(
    file: str,
    mesh: str | None,
    torque: float | None,
    size: str,
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
    from pitchpoint.solvers.contact_analysis.levels import compare_levels
    from pitchpoint.sweep.threads import on_all_cores

    model = read_model(file, allow_code, quiet)
    names = list(model.meshes)
    name = names[0] if mesh is None and len(names) == 1 else one_of(mesh, names, "mesh")
    load = torque_of_loads(model, name) if torque is None else torque
    small = TableSize(phase=SMALL[0], approach=SMALL[1]) if size == "small" else None
    with ProgressDisplay(name, "levels", quiet=quiet or as_json) as progress:
        found = compare_levels(model, name, torque=abs(load), size=small, run=on_all_cores, progress=progress)
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


def _print(found: Levels, *, quiet: bool) -> None:
    """Print the comparison, and both fits as parts of a model file."""
    fit = found.fit
    rows = []
    for level, one in found.numbers.items():
        exact = level == "flexible"
        rows.append(
            [
                NAMES[level],
                shown(one.setup_s, "time", 3),
                shown(one.evaluation_s, "time", 3),
                shown(one.te_mean, "length", 4),
                shown(one.te_pp, "length", 4),
                shown(one.stiffness, "stiffness", 4),
                *("–" if exact else percent(v) for v in (one.force_rms, one.force_max)),
            ]
        )
    head = ["level", "set-up", "evaluation", "TE mean", "TE p–p", "k tangent", "force, rms", "force, max"]
    table(f"{fit.mesh} at {shown(fit.torque, 'torque', 5)}: levels of contact", head, rows)
    if not quiet:
        origin = "computed for this comparison" if found.table == "computed" else found.table
        show("force: difference from flexible contact at random phases and approaches over the mesh force")
        show(f"table of the pre-computed contact: {origin}")
    show("")
    for line in blocks(fit):
        show(line)


def percent(value: float) -> str:
    """A share in per cent.

    Examples
    --------
    >>> percent(0.01234), percent(0.0)
    ('1.23 %', '0 %')
    """
    return f"{100.0 * value:.3g} %"


def blocks(fit: LawFit) -> list[str]:
    """Law and rigid contact as lines of a model file, with their errors as comments."""
    from pitchpoint.core.units import format_quantity

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
