# SPDX-License-Identifier: Apache-2.0
"""Options of `pitchpoint relief`: variables with bounds, tolerances, the plan."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.solvers.contact_analysis.relief.plan import ReliefPlan

_NUMBER = re.compile(r"\s*[-+]?[\d.]+(?:[eE][-+]?\d+)?\s*")


def length_of(text: str, option: str) -> float:
    """Length [m]; it must have a unit unless it is zero.

    Examples
    --------
    >>> length_of("12.5 um", "--tolerance"), length_of("0", "--vary")
    (1.25e-05, 0.0)
    """
    from pitchpoint.core.errors import UnitError
    from pitchpoint.core.units import parse_quantity

    if _NUMBER.fullmatch(text) and float(text) != 0.0:
        raise click.BadParameter(
            f"{text.strip()} has no unit; write '{text.strip()} um' or 'mm'", param_hint=option
        )
    try:
        return parse_quantity(text, "length")
    except UnitError as error:
        raise click.BadParameter(str(error), param_hint=option) from None


def bounds_of(text: str) -> tuple[float, float]:
    """Bounds LOW:HIGH [m]; a lower bound without unit has that of the upper one.

    Examples
    --------
    >>> bounds_of("0:60 um"), bounds_of("1.5:4 mm"), bounds_of("-10 um:10 um")
    ((0.0, 6e-05), (0.0015, 0.004), (-1e-05, 1e-05))
    """
    parts = text.split(":")
    if len(parts) != 2:
        raise click.BadParameter(f"{text!r} is not of the form LOW:HIGH, such as 0:60um", param_hint="--vary")
    low, high = parts
    if _NUMBER.fullmatch(low):
        low += " " + high[len(match.group()) :] if (match := _NUMBER.match(high)) else ""
    found = length_of(low, "--vary"), length_of(high, "--vary")
    if not found[0] < found[1]:
        raise click.BadParameter(f"{text!r}: the lower bound is not below the upper one", param_hint="--vary")
    return found


def _split(text: str, model: Model, option: str, form: str) -> tuple[str, str]:
    """Path and value of PATH=VALUE."""
    from functools import partial

    from pitchpoint.cli.settings import split_at_path
    from pitchpoint.model.numbers import has_path

    path, sign, value = (part.strip() for part in split_at_path(text, partial(has_path, model)))
    if not sign or not path or not value:
        raise click.BadParameter(f"{text!r} is not of the form {form}", param_hint=option)
    return path, value


def variables_of(texts: tuple[str, ...], model: Model) -> dict[str, tuple[float, float]]:
    """Bounds of all `--vary` by path [m]."""
    found: dict[str, tuple[float, float]] = {}
    for text in texts:
        path, value = _split(text, model, "--vary", "PATH=LOW:HIGH")
        if path in found:
            raise click.BadParameter(f"{path} is varied twice", param_hint="--vary")
        found[path] = bounds_of(value)
    return found


def tolerances_of(texts: tuple[str, ...], model: Model) -> dict[str, float]:
    """Tolerances ± of all `--tolerance` by path [m]."""
    found: dict[str, float] = {}
    for text in texts:
        path, value = _split(text, model, "--tolerance", "PATH=LENGTH")
        if path in found:
            raise click.BadParameter(f"{path} has two tolerances", param_hint="--tolerance")
        found[path] = length_of(value.lstrip("±+- "), "--tolerance")
    return found


def plan_of(model: Model, mesh: str, torques: list[float], flank: int, options: dict[str, Any]) -> ReliefPlan:
    """Plan from the options of the command."""
    from pitchpoint.cli.contact_input import misalignment_of
    from pitchpoint.core.errors import SolverError
    from pitchpoint.solvers.contact_analysis.relief.plan import ReliefPlan

    weights = None
    if options["weights"]:
        try:
            weights = [float(part) for part in options["weights"].split(",")]
        except ValueError:
            raise click.BadParameter("give numbers such as 1,1,0.5", param_hint="--weights") from None
    try:
        return ReliefPlan(
            vary=variables_of(options["vary"], model),
            torques=torques,
            weights=weights,
            mean=options["objective"] == "mean",
            tolerances=tolerances_of(options["tolerance"], model),
            misalignments=[misalignment_of(text, model, mesh) for text in options["misalignment"]],
            max_pressure=options["max_pressure"],
            no_edge_contact=options["no_edge_contact"],
            positions=options["positions"],
            flank=flank,
            analyses=options["analyses"],
            seed=options["seed"],
        )
    except SolverError as error:
        raise click.UsageError(str(error).removeprefix("relief design: ")) from None
