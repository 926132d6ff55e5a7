# SPDX-License-Identifier: Apache-2.0
"""Tables and solids of bevel gears for `pitchpoint gears`."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from pitchpoint.cli.output import number_rows, shown, table

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


MASS_ROWS = (
    ("mass", "mass", "mass"),
    ("polar_inertia", "polar inertia", "inertia"),
    ("transverse_inertia", "transverse inertia", "inertia"),
)


def export_bevel(model: Model, name: str, target: Path, inputs: Sequence[str | Path], points: int) -> None:
    """Write the solid of one bevel gear as STL.

    Parameters
    ----------
    model
        The model.
    name
        Name of the gear.
    target
        File to write.
    inputs
        Files that must not be replaced.
    points
        Points per flank if the gear does not define them.
    """
    if target.suffix.lower() != ".stl":
        raise click.BadParameter(
            f"{target.name}: {name} is a bevel gear, which can only be written as .stl", param_hint="--export"
        )
    from pitchpoint.io.gear_export import export_bevel_gear
    from pitchpoint.io.target import check_target

    check_target(target, "stl", inputs)
    gear = model.bevel_gears[name]
    export_bevel_gear(
        gear.geometry,
        target,
        n_flank=gear.drawing_resolution or points,
        bore_diameter=gear.bore_diameter,
        rim_thickness=gear.rim_thickness,
    )


def print_bevel_gears(model: Model, only: str | None, *, quiet: bool) -> None:
    """Print the geometry of bevel gears, one per column."""
    from pitchpoint.report.bevel_numbers import BEVEL_GEAR_ROWS, bevel_gear_numbers

    names = [n for n in model.bevel_gears if only in (None, n)]
    if not names:
        return
    numbers = {name: bevel_gear_numbers(model, name) for name in names}
    rows = [
        ["hand", *(shown(numbers[n]["hand"]) for n in names)],
        *number_rows(BEVEL_GEAR_ROWS, numbers),
        [],
        *number_rows(MASS_ROWS, numbers, 5, symbols=False),
        ["centre of mass from the apex", *(shown(numbers[n]["center_of_mass"], "length") for n in names)],
    ]
    notes = [f"{n}: undercut at the root" for n in names if numbers[n]["undercut"]]
    title = "Bevel gears" if model.gears else model.title or "Bevel gears"
    table(title, ["", *names], rows, () if quiet else notes)


def print_bevel_pairs(model: Model, only: str | None, *, quiet: bool) -> None:
    """Print the geometry of bevel meshes, one per column."""
    from pitchpoint.report.bevel_numbers import BEVEL_PAIR_ROWS, BEVEL_STIFFNESS_ROWS, bevel_mesh_numbers
    from pitchpoint.report.number_rows import LAW_ROWS

    names = [n for n, m in model.bevel_meshes.items() if only is None or only in m.gears]
    if not names:
        return
    numbers = {name: bevel_mesh_numbers(model, name) for name in names}
    heads = [f"{n}: {' / '.join(model.bevel_meshes[n].gears)}" for n in names]
    rows = [
        *number_rows(BEVEL_PAIR_ROWS, numbers),
        [],
        *number_rows(LAW_ROWS, numbers, 6, symbols=False),
        [],
        *number_rows(BEVEL_STIFFNESS_ROWS, numbers, 6),
    ]
    notes = []
    for n in names:
        if numbers[n]["j_mt"] < 0.0:
            notes.append(f"{n}: negative backlash, both flanks carry load")
        notes += [f"{n}: {w}" for w in model.bevel_pairs[n].warnings(names=model.bevel_meshes[n].gears)]
    table("Bevel pairs", ["", *heads], rows, () if quiet else notes)
