# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint export`: a model as a functional mock-up unit (FMU) for other simulation programs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.options import common, model_file, quantity, scenario, with_suffix, writes
from pitchpoint.cli.output import emit_json, show, shown
from pitchpoint.cli.settings import set_option
from pitchpoint.cli.tunable_numbers import input_option, parameter_option, ranges_of, show_settable

if TYPE_CHECKING:
    from pitchpoint.io.fmu.model import FmuModel


@click.command()
@model_file
@scenario
@writes("--fmu", "fmu", metavar="OUT.fmu", help="FMU to write.")
@click.option(
    "--fmi", "version", type=click.Choice(["2", "3"]), default="3", show_default=True, help="Version of FMI."
)
@click.option(
    "--platforms",
    metavar="NAME,...",
    help="x86_64-linux, aarch64-linux, x86_64-windows, aarch64-darwin; default: that of this computer.",
)
@quantity("--step", "time", "Time step instead of that of the scenario, as in '5 us'.")
@parameter_option
@input_option
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
    """Write a scenario of FILE as an FMU for other programs, with the compiled model and its solver inside.

    An FMU needs neither Python nor pitchpoint. Constant loads and speeds of drives are inputs, all channels
    outputs. `pitchpoint view FILE --live` writes the same as a page.
    """
    from pitchpoint.cli.reading import read_model
    from pitchpoint.cli.results import choose_scenario
    from pitchpoint.io.fmu.linking import check_linker
    from pitchpoint.io.fmu.writing import fmu_bytes
    from pitchpoint.io.target import check_target, write_file
    from pitchpoint.report.exported_model import begin_export, fmu_model

    if how["fmu"] is None:
        raise click.UsageError("name a file to write: --fmu OUT.fmu")
    target = check_target(with_suffix(how["fmu"], ".fmu", "--fmu"), "fmu", [file])
    platforms = _platforms(how["platforms"])
    for each in platforms:
        check_linker(each)
    model = read_model(file, allow_code, quiet)
    name = choose_scenario(model, scenario, "time")
    if how["step"] is not None:
        model = model.replace(f"scenarios.{name}.step", how["step"])
    run, tunable = begin_export(model, name, ranges_of(model, how["parameters"]), how["more_inputs"])
    version = int(how["version"])
    unit = fmu_model(run, tunable, target.stem, model.title or name)
    data, sizes = fmu_bytes(unit, version, platforms)
    write_file(target, data)
    if as_json:
        emit_json(_summary(unit, str(target), version, sizes))
        return
    if not quiet:
        show_settable(run, tunable)
    listed = ", ".join(f"{each} {size / 1000:.0f} kB" for each, size in sizes.items())
    outputs = f"{len(run.system.layout.channels)} outputs, time step {shown(run.h, 'time', 4)}"
    show(f"written to {target}: FMI {version}.0, {listed}, {outputs}")


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
