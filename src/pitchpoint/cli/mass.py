# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint mass`: mass and inertia from geometry, from solids and as given, compared."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import click

from pitchpoint.cli.options import common, model_file
from pitchpoint.cli.output import NOTHING, emit_json, show, shown, table
from pitchpoint.cli.settings import set_option

HEAD = (
    "part",
    "from",
    "mass",
    "polar inertia",
    "transverse inertia",
    "mass",
    "polar",
    "transverse",
    "centre [mm]",
)


@click.command()
@model_file
@set_option
@common
def mass(file: str, as_json: bool, allow_code: bool, quiet: bool) -> None:
    """Compare mass and inertia of gears, shafts and bodies of FILE by geometry, CAD solids and given values.

    Given values take precedence over solids, solids over geometry; of a gear on a shaft the part outside the
    shaft counts. Transverse inertia is about the centre of
    mass; differences are relative to the values used.
    """
    from pitchpoint.cli.reading import read_model
    from pitchpoint.report.masses import masses

    model = read_model(file, allow_code, quiet)
    found = masses(model)
    if as_json:
        emit_json({"masses": found})
        return
    if not found:
        show("no gears, shafts or bodies with mass")
        return
    show_masses(model.title or "Masses", found, quiet=quiet)


def show_masses(title: str, found: Sequence[dict[str, Any]], *, quiet: bool = False) -> None:
    """Print a table of masses.

    Parameters
    ----------
    title
        Title of the table.
    found
        Entries of `pitchpoint.report.masses.masses`.
    quiet
        Omit the notes.
    """
    rows: list[list[str]] = []
    notes = []
    for entry in found:
        sources = entry["sources"]
        for number, (source, numbers) in enumerate(sources.items()):
            gap = entry["differences"].get(source)
            rows.append(
                [
                    f"{entry['part']} {entry['name']}" if number == 0 else "",
                    source,
                    shown(numbers["mass"], "mass", 6),
                    shown(numbers["polar_inertia"], "inertia", 6),
                    shown(numbers["transverse_inertia"], "inertia", 6),
                    *([""] * 3 if gap is None else map(_percent, gap.values())),
                    _place(numbers.get("center")),
                ]
            )
        rows.append([])
        if "file" in entry:
            notes.append(
                f"{entry['part']} {entry['name']}: solid of {entry['file']} in units of {entry['unit']}, "
                f"{entry['density']:g} kg/m^3"
            )
    table(title, HEAD, rows[:-1], () if quiet else notes, keys=2)


def show_shaft_masses(found: Mapping[str, Any]) -> None:
    """Print what sections and gears add to the mass of every shaft.

    Parameters
    ----------
    found
        Data of `pitchpoint.report.masses.masses_of_shafts`.
    """
    rows = [
        [
            name if part == "sections" else "",
            part,
            shown(numbers["mass"], "mass", 5),
            shown(numbers["polar_inertia"], "inertia", 5),
            "" if numbers["alone"] is None else shown(numbers["alone"], "mass", 5),
        ]
        for name, parts in found.items()
        for part, numbers in parts.items()
    ]
    if rows:
        head = ["shaft", "part", "mass", "polar inertia", "gear alone"]
        table("Masses on shafts (of a gear, the part outside the shaft)", head, rows)


def _percent(part: float | None) -> str:
    """Difference in percent.

    Examples
    --------
    >>> _percent(0.01234), _percent(-1e-9), _percent(None)
    ('+1.234 %', '0 %', '–')
    """
    if part is None:
        return NOTHING
    return "0 %" if abs(part) < 5e-7 else f"{100.0 * part:+.4g} %"


def _place(center: Sequence[float] | None) -> str:
    if center is None:
        return ""
    return ", ".join(f"{round(1e3 * c, 6) + 0.0:.6g}" for c in center)
