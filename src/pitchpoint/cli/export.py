# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint export`: a model as a functional mock-up unit (FMU) for other simulation programs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.options import common, model_file, quantity, scenario, writes
from pitchpoint.cli.output import emit_json, show, shown, table
from pitchpoint.cli.settings import set_option

if TYPE_CHECKING:
    from pitchpoint.io.fmu.model import FmuModel
    from pitchpoint.model.model import Model
    from pitchpoint.solvers.exported_run import ExportedRun
    from pitchpoint.solvers.input_places import Place


@click.command()
@model_file
@scenario
@writes("--fmu", "fmu", metavar="OUT.fmu", help="FMU to write.")
@writes(
    "--live",
    "live",
    metavar="OUT.html",
    help="Page to write in which the model runs, with sliders and curves.",
)
@click.option(
    "--fmi", "version", type=click.Choice(["2", "3"]), default="3", show_default=True, help="Version of FMI."
)
@click.option(
    "--platforms",
    metavar="NAME,...",
    help="x86_64-linux, aarch64-linux, x86_64-windows, aarch64-darwin; default: that of this computer.",
)
@quantity("--step", "time", "Time step instead of that of the scenario, as in '5 us'.")
@click.option(
    "--parameter",
    "parameters",
    multiple=True,
    metavar="PATH[=LOW:HIGH]",
    help="Number of the model file as a tunable parameter, with its range: meshes.stage.backlash.normal, "
    "'meshes.stage.center_distance=149.8 mm:150.2 mm'; repeatable.",
)
@click.option(
    "--input",
    "more_inputs",
    multiple=True,
    metavar="PATH",
    help="Number of the model file as a further input: blocks.error.offset; repeatable.",
)
@set_option
@common
def export(
    file: str,
    scenario: str | None,
    as_json: bool,
    allow_code: bool,
    quiet: bool,
    **how: Any,
) -> None:
    """Write a scenario of FILE for other programs, with the compiled model and its solver inside.

    An FMU needs neither Python nor pitchpoint; a live page runs in any browser, without a server. Constant
    loads are inputs, all channels outputs.
    """
    from pitchpoint.cli.reading import read_model
    from pitchpoint.cli.results import choose_scenario
    from pitchpoint.report.exported_model import begin_export

    targets = _targets(file, how)
    model = read_model(file, allow_code, quiet)
    name = choose_scenario(model, scenario, "time")
    if how["step"] is not None:
        model = model.replace(f"scenarios.{name}.step", how["step"])
    run, tunable = begin_export(model, name, _ranges(model, how["parameters"]), how["more_inputs"])
    title = model.title or name
    written = [_write(way, target, run, tunable, title, how) for way, target in targets.items()]
    if as_json:
        emit_json({key: value for each, _ in written for key, value in each.items()})
        return
    if not quiet:
        rows = [[p.name, f"{p.start:.6g} {p.unit}", _meaning(p)] for p in (*run.inputs, *run.drives, *tunable)]
        if rows:
            table("inputs and parameters", ["name", "start", "meaning"], rows)
    for _, sentence in written:
        show(f"{sentence}, {len(run.system.layout.channels)} outputs, time step {shown(run.h, 'time', 4)}")


def _meaning(place: Place) -> str:
    """Description of an input or parameter, with its range if it has one."""
    if place.most == math.inf:
        return place.text
    return f"{place.text}, {place.least:.6g} to {place.most:.6g} {place.unit}"


def _ranges(model: Model, texts: Sequence[str]) -> dict[str, tuple[float, float] | None]:
    """Paths of `--parameter` with their ranges in SI units."""
    from pitchpoint.core.errors import UnitError
    from pitchpoint.model.numbers import amount_at

    found: dict[str, tuple[float, float] | None] = {}
    for text in texts:
        path, sign, limits = text.partition("=")
        low, colon, high = limits.partition(":")
        if sign and not (colon and low.strip() and high.strip()):
            raise click.BadParameter(f"{text!r} is not of the form PATH=LOW:HIGH", param_hint="--parameter")
        try:
            found[path] = (amount_at(model, path, low), amount_at(model, path, high)) if sign else None
        except UnitError as error:
            raise click.BadParameter(f"{text}: {error}", param_hint="--parameter") from error
    return found


def _targets(file: str, how: dict[str, Any]) -> dict[str, Path]:
    """Files to write, checked before the computation."""
    from pitchpoint.io.fmu.linking import check_linker
    from pitchpoint.io.fmu.web import check_web
    from pitchpoint.io.target import check_target

    kinds = {"fmu": "fmu", "live": "page"}
    found = {way: check_target(how[way], kind, [file]) for way, kind in kinds.items() if how[way]}
    if not found:
        raise click.UsageError("name a file to write: --fmu OUT.fmu or --live OUT.html")
    if "fmu" in found:
        how["platforms"] = _platforms(how["platforms"])
        for each in how["platforms"]:
            check_linker(each)
    if "live" in found:
        check_web()
    return found


def _write(
    way: str, target: Path, run: ExportedRun, tunable: Sequence[Place], title: str, how: dict[str, Any]
) -> tuple[dict[str, Any], str]:
    """Write a file; returns its summary and a sentence."""
    from pitchpoint.io.fmu.writing import fmu_bytes
    from pitchpoint.io.target import write_file
    from pitchpoint.report.exported_model import fmu_model, live_text

    if way == "live":
        page, size = live_text(run, tunable, title)
        write_file(target, page)
        sentence = f"written to {target}: live page, {len(page) / 1000:.0f} kB"
        return {"page": str(target), "code": size}, sentence
    version = int(how["version"])
    unit = fmu_model(run, tunable, target.stem, title)
    data, sizes = fmu_bytes(unit, version, how["platforms"])
    write_file(target, data)
    listed = ", ".join(f"{each} {size / 1000:.0f} kB" for each, size in sizes.items())
    return _summary(unit, str(target), version, sizes), f"written to {target}: FMI {version}.0, {listed}"


def _platforms(text: str | None) -> list[str]:
    """Platforms of the option."""
    from pitchpoint.core.fmi.fmu_file import own_platform
    from pitchpoint.core.nearest import hint
    from pitchpoint.io.fmu.linking import PLATFORMS

    names = [own_platform()] if text is None else [part.strip() for part in text.split(",")]
    for name in names:
        if name not in PLATFORMS:
            problem = f"no library can be made for {name!r}; {hint(name, list(PLATFORMS))}"
            raise click.BadParameter(problem, param_hint="--platforms")
    return list(dict.fromkeys(names))


def _summary(unit: FmuModel, file: str, version: int, sizes: dict[str, int]) -> dict[str, Any]:
    """Contents of the unit for --json."""
    from pitchpoint.io.fmu.model import CAUSALITIES

    listed = [
        {
            "name": v.name,
            "unit": v.unit,
            "causality": CAUSALITIES[v.kind],
            **({"start": v.start} if v.is_set else {}),
        }
        for v in unit.variables
    ]
    return {
        "output": file,
        "fmi": f"{version}.0",
        "identifier": unit.token,
        "step": unit.reals["h"],
        "libraries": sizes,
        "variables": listed,
    }
