# SPDX-License-Identifier: Apache-2.0
"""Options of commands that write a running model: numbers of the model file that can be changed in it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import click

from pitchpoint.cli.output import table

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.solvers.exported_run import ExportedRun
    from pitchpoint.solvers.input_places import Place

parameter_option = click.option(
    "--parameter",
    "parameters",
    multiple=True,
    metavar="PATH[=LOW:HIGH]",
    help="Number of the model file as a tunable parameter, with its range: meshes.stage.backlash.normal, "
    "'meshes.stage.center_distance=149.8 mm:150.2 mm'; repeatable.",
)
input_option = click.option(
    "--input",
    "more_inputs",
    multiple=True,
    metavar="PATH",
    help="Number of the model file as a further input: blocks.error.offset; repeatable.",
)


def ranges_of(model: Model, texts: Sequence[str]) -> dict[str, tuple[float, float] | None]:
    """Paths of `--parameter` with their ranges in SI units.

    Parameters
    ----------
    model
        The model, for the units.
    texts
        Values of the option.
    """
    from pitchpoint.core.errors import UnitError
    from pitchpoint.model.numbers import amount_at

    found: dict[str, tuple[float, float] | None] = {}
    for text in texts:
        path, sign, limits = (part.strip() for part in text.partition("="))
        low, colon, high = limits.partition(":")
        if sign and not (colon and low.strip() and high.strip()):
            raise click.BadParameter(f"{text!r} is not of the form PATH=LOW:HIGH", param_hint="--parameter")
        try:
            found[path] = (amount_at(model, path, low), amount_at(model, path, high)) if sign else None
        except UnitError as error:
            raise click.BadParameter(f"{text}: {error}", param_hint="--parameter") from error
    return found


def show_settable(run: ExportedRun, tunable: Sequence[Place]) -> None:
    """Print a table of all inputs and parameters."""
    places = (*run.inputs, *run.drives, *tunable)
    if places:
        rows = [[p.name, f"{p.start:.6g} {p.unit}", _meaning(p)] for p in places]
        table("inputs and parameters", ["name", "start", "meaning"], rows)


def _meaning(place: Place) -> str:
    """Description of an input or parameter, with its range if it has one."""
    least, most = (f"{limit:.6g}" if math.isfinite(limit) else "" for limit in (place.least, place.most))
    if not least and not most:
        return place.text
    words = f"{least} to {most}" if least and most else f">= {least}" if least else f"<= {most}"
    return f"{place.text}, {words} {place.unit}"
