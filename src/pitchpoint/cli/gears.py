# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint gears`: geometry of all gears and pairs of a file, inspection dimensions, drawings."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.bevel_gears import MASS_ROWS, export_bevel, print_bevel_gears, print_bevel_pairs
from pitchpoint.cli.options import common, model_file, one_of, writes
from pitchpoint.cli.output import emit_json, number_rows, show_unless, shown, table
from pitchpoint.cli.settings import set_option

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

MEASURES = (
    ("tip_thickness", "normal tip thickness", "length"),
    ("span_teeth", "teeth (internal: spaces) spanned", "dimensionless"),
    ("span", "span", "length"),
    ("span_measurable", "face wide enough for the span measurement", "dimensionless"),
    ("ball_diameter", "ball diameter (touches at d + 2 x m_n)", "length"),
    ("dimension_over_balls", "dimension over balls", "length"),
)
FORMATS = (".dxf", ".svg", ".stl", ".csv", ".step", ".stp")
SHAFT_FORMATS = (".stl", ".step", ".stp")
POINTS_A_FLANK = 20
"""Points per flank in drawings and solids if the gear does not define them."""


@click.command()
@model_file
@writes(
    "--export",
    "target",
    help="Write a drawing (dxf, svg), points (csv) or a solid (stl, step).",
)
@writes("--preview", help="Draw the teeth with tool, circles and active flanks (svg).")
@click.option("--gear", "only", metavar="NAME", help="Gear to draw or export; default: the only one.")
@click.option("--shaft", metavar="NAME", help="Elastic shaft to export instead (stl, step).")
@set_option
@common
def gears(
    file: str,
    target: str | None,
    preview: str | None,
    only: str | None,
    shaft: str | None,
    as_json: bool,
    allow_code: bool,
    quiet: bool,
) -> None:
    """Show the geometry of gears and pairs of FILE (ISO 21771, bevel gears ISO 23509).

    The mesh stiffness is listed twice: that of the law of the simulation, and that of ISO 6336 (DIN 3990).
    """
    from pitchpoint.cli.reading import read_model

    model = read_model(file, allow_code, quiet)
    if shaft is not None and (target is None or only is not None):
        raise click.BadParameter(
            "requires --export" if target is None else "cannot be combined with --gear", param_hint="--shaft"
        )
    if preview is not None:
        if target is not None:
            raise click.BadParameter(
                "cannot be combined with --export; omit one of them", param_hint="--preview"
            )
        drawn = _chosen(model, only)
        _preview(model, drawn, Path(preview), [file, *_profiles(model, file)])
        if not as_json:
            show_unless(quiet, f"teeth of {drawn} drawn in {preview}")
            return
    elif target is not None:
        inputs: list[str | Path] = [file, *_profiles(model, file)]
        if shaft is not None:
            name = _export_shaft(model, shaft, Path(target), inputs)
        else:
            name = _chosen(model, only)
            if name in model.bevel_gears:
                export_bevel(model, name, Path(target), inputs, POINTS_A_FLANK)
            else:
                _export(model, name, Path(target), inputs)
        if not as_json:
            show_unless(quiet, f"{name} written to {target}")
            return
    elif only is not None:
        _chosen(model, only)
    if as_json:
        from pitchpoint.cli.failure import say
        from pitchpoint.model.remarks.collect import odd_shapes
        from pitchpoint.report.numbers import geometry_of_model

        for text in odd_shapes(model):
            say(f"warning: {text}")
        emit_json(geometry_of_model(model))
        return
    if only is None or only in model.gears:
        _print_gears(model, only, quiet=quiet)
    print_bevel_gears(model, only, quiet=quiet)
    _print_pairs(model, only, quiet=quiet)
    print_bevel_pairs(model, only, quiet=quiet)
    if only is None and model.planetary_stages:
        from pitchpoint.cli.output import show_tables
        from pitchpoint.report.machine_tables import stage_tables
        from pitchpoint.report.planets import stages_of_model

        show_tables(*stage_tables(stages_of_model(model)))


def _chosen(model: Model, name: str | None) -> str:
    """Name of the selected gear."""
    names = [*model.gears, *model.bevel_gears]
    if name is None and len(names) == 1:
        return names[0]
    return one_of(name, names, "gear")


def _profiles(model: Model, file: str) -> list[Path]:
    """Files of measured teeth and solids named in the model file."""
    profiles = [gear.tooth_profile for gear in model.gears.values() if gear.tooth_profile is not None]
    names = [getattr(profile, part).file for profile in profiles for part in profile.given]
    solids = [part.solid for part in model.gears.values()]
    solids += [part.solid for part in model.shafts.values()]
    solids += [part.solid for part in model.bodies.values()]
    return [
        *(Path(file).parent / name for name in names if name),
        *(Path(s.file) for s in solids if s is not None),
    ]


def _export(model: Model, name: str, target: Path, inputs: Sequence[str | Path]) -> None:
    """Write the drawing of one gear in the format of the file extension."""
    if target.suffix.lower() not in FORMATS:
        raise click.BadParameter(
            f"{target.name} has no supported extension; use {', '.join(FORMATS)}", param_hint="--export"
        )
    from pitchpoint.io.gear_export import export_gear
    from pitchpoint.io.target import check_target

    check_target(target, _kind(target), inputs)
    gear = model.gears[name]
    export_gear(
        gear.geometry,
        target,
        n_flank=gear.drawing_resolution or POINTS_A_FLANK,
        bore_diameter=gear.bore_diameter,
        rim_thickness=gear.rim_thickness,
        web_thickness=gear.web_thickness,
    )


def _preview(model: Model, name: str, target: Path, inputs: Sequence[str | Path]) -> None:
    """Draw the teeth of one gear."""
    if name in model.bevel_gears:
        raise click.BadParameter(
            f"{name} is a bevel gear without a plane tooth profile; pitchpoint view shows its teeth",
            param_hint="--preview",
        )
    if target.suffix.lower() != ".svg":
        raise click.BadParameter(f"{target.name} does not end in .svg", param_hint="--preview")
    from pitchpoint.io.target import SVG_MARK, check_target, write_file
    from pitchpoint.viz.tooth_drawing import tooth_svg

    check_target(target, "svg", inputs)
    meshes = {
        mesh: (model.pairs[mesh], 1 + part.gears.index(name))
        for mesh, part in model.meshes.items()
        if name in part.gears
    }
    text = tooth_svg(model.gears[name].geometry, name=name, meshes=meshes)
    write_file(target, text.replace(">", f">{SVG_MARK}", 1))


def _kind(target: Path) -> str:
    """Kind of file for an extension."""
    return target.suffix.lower()[1:].replace("stp", "step")


def _export_shaft(model: Model, name: str, target: Path, inputs: Sequence[str | Path]) -> str:
    """Write the solid of one elastic shaft; return its name."""
    known = one_of(name, list(model.shafts), "shaft")
    if target.suffix.lower() not in SHAFT_FORMATS:
        raise click.BadParameter(
            f"{target.name} has no solid extension; use {', '.join(SHAFT_FORMATS)}", param_hint="--export"
        )
    from pitchpoint.io.gear_export import export_shaft
    from pitchpoint.io.target import check_target

    check_target(target, _kind(target), inputs)
    export_shaft(model.shafts[known].dimensions, target)
    return known


def _print_gears(model: Model, only: str | None, *, quiet: bool) -> None:
    from pitchpoint.report.numbers import EDGE_ROWS, GEAR_ROWS, gear_numbers, measure_numbers

    names = [only] if only is not None else list(model.gears)
    if not names and model.bevel_gears:
        return
    numbers = {name: gear_numbers(model, name) for name in names}
    measures = {name: measure_numbers(model.gears[name].geometry) for name in names}
    edges = [row for row in EDGE_ROWS if any(numbers[n][row[0]] is not None for n in names)]
    rows = [
        ["type", *(numbers[n]["type"] for n in names)],
        ["hand", *(shown(numbers[n]["hand"]) for n in names)],
        *number_rows(GEAR_ROWS, numbers),
        *number_rows(edges, numbers),
        [],
        *number_rows(MASS_ROWS, numbers, 5, symbols=False),
        [],
        *number_rows(MEASURES, measures, symbols=False),
    ]
    notes = [f"{n}: undercut at the root" for n in names if numbers[n]["undercut"]]
    if any(model.body_of(n) in model.shafts for n in names):
        notes.append(
            "mass and inertia are those of the gears alone, including the material in the place of their "
            "shafts; `check` lists what they add to the shafts"
        )
    table(model.title or "Gears", ["", *names], rows, () if quiet else notes)


def _print_pairs(model: Model, only: str | None, *, quiet: bool) -> None:
    from pitchpoint.report.number_rows import LAW_ROWS
    from pitchpoint.report.numbers import PAIR_ROWS, SLIDING_ROWS, STIFFNESS_ROWS, mesh_numbers

    names = [n for n, m in model.meshes.items() if only is None or only in m.gears]
    if not names:
        return
    numbers: dict[str, dict[str, Any]] = {name: mesh_numbers(model, name) for name in names}
    heads = [f"{n}: {' / '.join(model.meshes[n].gears)}" for n in names]
    rows = [
        *number_rows(PAIR_ROWS + SLIDING_ROWS, numbers),
        [],
        *number_rows(LAW_ROWS, numbers, 6, symbols=False),
        [],
        *number_rows(STIFFNESS_ROWS, numbers, 6),
    ]
    notes = []
    for n in names:
        given, needed = numbers[n]["x_sum_given"], numbers[n]["x_sum"]
        if abs(given - needed) > 5e-4:
            notes.append(
                f"{n}: the sum of profile shifts is {given:.4f}; "
                f"for this centre distance without backlash it would be {needed:.4f}"
            )
        if numbers[n]["j_bt"] < 0.0:
            notes.append(f"{n}: negative backlash, both flanks carry load")
        pair = model.pairs[n]
        notes += [f"{n}: {w}" for w in pair.warnings(names=model.meshes[n].gears)]
    table("Pairs", ["", *heads], rows, () if quiet else notes)
