# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint clearance`: clearances between assembled gears, in numbers and pictures."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from pitchpoint.cli.options import common, model_file, one_of, output
from pitchpoint.cli.output import emit_json, show, shown, table
from pitchpoint.cli.settings import set_option

if TYPE_CHECKING:
    from pitchpoint.report.clearances import Room, Stage


@click.command()
@model_file
@output("Picture to write (svg): every place, magnified, where the teeth come nearest.")
@click.option("--mesh", "only", metavar="NAME", help="Mesh; default: all.")
@set_option
@common
def clearance(
    file: str, output: str | None, only: str | None, as_json: bool, allow_code: bool, quiet: bool
) -> None:
    """Check the clearances between the assembled gears of FILE.

    Flanks, tips, roots and fillets of every mesh are rolled through one pitch, flanks with their
    modifications, deviations and misalignment. Gears that do not mesh, and shafts next to gears, are treated
    as cylinders.
    """
    from pitchpoint.cli.reading import read_model
    from pitchpoint.io.target import check_target
    from pitchpoint.report.clearances import clearance_numbers, neighbours, stage_of

    model = read_model(file, allow_code, quiet)
    names = list(model.meshes) if only is None else [one_of(only, list(model.meshes), "mesh")]
    if output is not None and Path(output).suffix.lower() != ".svg":
        raise click.BadParameter(f"{Path(output).name} does not end in .svg", param_hint="--output")
    target = None if output is None else check_target(output, "svg", [file])
    stages = {name: stage_of(model, name) for name in names}
    others = neighbours(model) if only is None else []
    if target is not None:
        _draw(stages, target)
    if as_json:
        emit_json(clearance_numbers(stages, others))
        return
    for name, stage in stages.items():
        _print(
            f"Mesh {name}: {' / '.join(stage.gears)}",
            list(stage.rooms.values()),
            () if quiet else stage.notes,
        )
    if others:
        _print("Parts that do not mesh", others)
    if not stages and not others:
        show(f"{file}: no meshes of cylindrical gears and no adjacent cylindrical gears")
    tight = [room for stage in stages.values() for room in stage.rooms.values() if not room.fine]
    tight += [room for room in others if not room.fine]
    hit = sum(room.distance < -room.slack for room in tight)
    if tight:
        show(f"{len(tight)} distances below their limits, of which {hit} overlap")
    if target is not None and not quiet:
        show(f"picture written to {target}")


def _draw(stages: dict[str, Stage], target: Path) -> None:
    """Write the drawings of all meshes into one picture."""
    from pitchpoint.io.target import SVG_MARK, write_file
    from pitchpoint.viz.clearance_drawing import Place, clearances_svg

    places = {
        f"{name}: {' / '.join(stage.gears)}": (
            stage.pair,
            [
                Place(room.words, room.distance, room.limit, room.fine, room.where)
                for room in stage.rooms.values()
                if room.where is not None
            ],
        )
        for name, stage in stages.items()
    }
    text = clearances_svg(places)
    write_file(target, text.replace(">", f">{SVG_MARK}", 1))


def _print(title: str, rooms: list[Room], notes: tuple[str, ...] = ()) -> None:
    rows = []
    for room in rooms:
        small = abs(room.distance) <= room.slack
        judged = "OK" if room.fine else "overlap" if room.distance < 0.0 else "below the limit"
        distance = "0 µm" if small else shown(room.distance, "length", 5)
        limit = "0 µm" if room.limit == 0.0 else shown(room.limit, "length", 5)
        rows.append([room.words, distance, limit, judged])
    table(title, ["between", "distance", "limit", "judged"], rows, notes)
