# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint frequencies`: kinematic frequencies of shafts, teeth, planets and rolling bearings."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.options import common, model_file
from pitchpoint.cli.output import NOTHING, emit_json, show_notes, shown, table
from pitchpoint.cli.settings import set_option

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

BEARING = (("ftf", "FTF"), ("bpfo", "BPFO"), ("bpfi", "BPFI"), ("bsf", "BSF"), ("bsf_double", "2 BSF"))
ROUND_OFF = 1e-9
"""Deviation from equal spacing that counts as none [rad]."""


def _given(_: click.Context, __: click.Parameter, texts: tuple[str, ...]) -> dict[str, float]:
    """Speeds by body in rad/s."""
    from pitchpoint.cli.settings import say_bare_option
    from pitchpoint.core.errors import UnitError
    from pitchpoint.core.units import parse_quantity

    speeds = {}
    for text in texts:
        body, equals, quantity = text.partition("=")
        if not equals or not body or not quantity:
            raise click.BadParameter(f"{text!r} is not BODY=QUANTITY, such as motor=1500 rpm")
        try:
            speeds[body] = parse_quantity(quantity, "angular_speed")
        except UnitError as error:
            raise click.BadParameter(f"{body}: {error}") from None
        say_bare_option(quantity, "angular_speed", f"--speed {body}")
    return speeds


@click.command()
@model_file
@click.option("--scenario", "-s", metavar="NAME", help="Scenario with the speeds; default: the only one.")
@click.option(
    "--speed",
    "given",
    metavar="BODY=QUANTITY",
    multiple=True,
    callback=_given,
    help="Speed of a body, such as motor=1500rpm, instead of a scenario; may be repeated.",
)
@set_option
@common
def frequencies(
    file: str, scenario: str | None, given: Mapping[str, float], as_json: bool, allow_code: bool, quiet: bool
) -> None:
    """Show the frequencies of shafts, meshes, planetary gear sets and rolling bearings of FILE.

    Specify speeds by a scenario, --load-case or --speed; the other speeds follow from the gear ratios.
    """
    from pitchpoint.cli.reading import read_model
    from pitchpoint.model.load_cases import speeds_in_effect
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.report.frequencies import (
        frequencies_of,
        scenario_speeds,
        turning_speeds,
        undetermined_speeds,
    )

    model = read_model(file, allow_code, quiet)
    remarks: list[str] = []
    speeds = dict(given) or ({} if scenario is not None else speeds_in_effect(model))
    if given and scenario is not None:
        raise click.UsageError("--speed replaces a scenario; omit one of the two")
    chosen = Scenario()
    if not speeds:
        scenario = _scenario(model, scenario)
        speeds, remarks = scenario_speeds(model, scenario)
        chosen = model.scenarios[scenario]
    spins = turning_speeds(model, speeds, chosen)
    if not any(spins.values()):
        where = f"scenario {scenario}: nothing rotates" if scenario else "nothing rotates"
        raise click.UsageError(f"{where}; give a speed, such as --speed {next(iter(model.bodies))}=1500rpm")
    remarks += undetermined_speeds(model, [*speeds, *chosen.hold], chosen.engaged)
    found = {"scenario": scenario, **frequencies_of(model, spins), "remarks": remarks}
    if as_json:
        emit_json(found)
    else:
        _print(model, found, quiet=quiet)


def _scenario(model: Model, name: str | None) -> str:
    """Scenario that defines the speeds."""
    from pitchpoint.cli.results import known_scenario

    if not model.bodies:
        raise click.UsageError("the file has no bodies, so nothing rotates; add bodies for the gears")
    if name is None and len(model.scenarios) == 1:
        return next(iter(model.scenarios))
    if name is None:
        listed = ", ".join(model.scenarios) or "none"
        raise click.UsageError(f"choose a --scenario (there are: {listed}), or give --speed BODY=QUANTITY")
    return known_scenario(model, name)


def _print(model: Model, found: Mapping[str, Any], *, quiet: bool) -> None:
    """Print the data as tables."""
    rows = [
        [name, ", ".join(row["gears"]), _speed(row["speed"]), _hertz(row["frequency"])]
        for name, row in found["shafts"].items()
    ]
    table(f"{model.title or 'Model'}: shafts", ["body", "gears", "absolute speed", "frequency"], rows)
    rows = [
        [
            name,
            " / ".join(f"{gear} ({z})" for gear, z in zip(row["gears"], row["teeth"], strict=True)),
            *([row["carrier"] or ""] if found["planet_sets"] else []),
            *(_hertz(row[key]) for key in ("frequency", "assembly_phase", "hunting_tooth")),
        ]
        for name, row in found["meshes"].items()
    ]
    if rows:
        carried = ["carried by"] if found["planet_sets"] else []
        heads = ["mesh", "gears (teeth)", *carried, "mesh frequency", "assembly phase", "hunting tooth"]
        table("Meshes", heads, rows)
        table("Contacts of one tooth", ["gear", "with each mate", "mates", "with all mates"], _teeth(found))
    _print_planets(found["planet_sets"])
    rows = [
        [
            name,
            _speed(row["speed_inner"]),
            _speed(row["speed_outer"]),
            *(_hertz(row[key]) for key, _ in BEARING),
        ]
        for name, row in found["rolling_bearings"].items()
    ]
    if rows:
        table("Rolling bearings", ["bearing", "inner ring", "outer ring", *(h for _, h in BEARING)], rows)
    if not quiet:
        show_notes(found["remarks"])


def _teeth(found: Mapping[str, Any]) -> list[list[str]]:
    """Rows of contact frequencies of a tooth with its mates."""
    rows = []
    for name, row in found["gears"].items():
        rates = list(row["tooth_meets"].values())
        alike = max(rates) - min(rates) <= 1e-9 * max(rates)
        each = _hertz(rates[0]) if alike else ", ".join(_hertz(rate) for rate in rates)
        rows.append([name, each, str(len(rates)), _hertz(row["tooth_meets_all"])])
    return rows


def _print_planets(sets: Mapping[str, Any]) -> None:
    """Print carriers and the phases of their planets."""
    rows = [
        [name, ", ".join(row["planets"]), _hertz(row["frequency"]), _hertz(row["planet_pass"])]
        for name, row in sets.items()
    ]
    if not rows:
        return
    table("Planet sets", ["carrier", "planets", "rotation", "planet passing"], rows)
    rows = [
        [
            f"{gear} on {name}",
            ", ".join(f"{phase:.4g}" for phase in row["phases"].values()),
            ", ".join(row["excites"]) if row["excites"] else NOTHING,
        ]
        for name, entry in sets.items()
        for gear, row in entry["central"].items()
    ]
    notes = [
        f"planets on {name} are up to {shown(row['spacing_error'], 'angle', 2)} off equal spacing; up to "
        f"{shown(row['spacing_limit'], 'angle', 2)} the harmonics are those of equal spacing"
        for name, entry in sets.items()
        for row in list(entry["central"].values())[:1]
        if row["spacing_error"] > ROUND_OFF
    ]
    heads = ["central gear", "phases [mesh cycles]", "excited by harmonics 1, 2, 3"]
    table("Mesh phases", heads, rows, notes)


def _hertz(frequency: float) -> str:
    return NOTHING if frequency == 0.0 else shown(frequency, "frequency", 7)


def _speed(speed: float) -> str:
    return "at rest" if speed == 0.0 else f"{round(speed * 30.0 / math.pi, 9) + 0.0:.7g} rpm"
