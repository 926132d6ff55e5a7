# SPDX-License-Identifier: Apache-2.0
"""Factors of a plan with the numbers of the model: their distributions, checked against permitted ranges."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from pitchpoint.core.errors import ModelError, UnitError
from pitchpoint.core.nearest import hint
from pitchpoint.core.units import natural_quantity
from pitchpoint.geometry.flank_tolerances import single_pitch_tolerance
from pitchpoint.model.keys import BAD, Place
from pitchpoint.model.model import Model
from pitchpoint.model.numbers import (
    amount_at,
    has_path,
    key_at,
    number_at,
    unit_without_number,
    with_defaults,
)
from pitchpoint.model.planetary_stages import place_of_gear
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.show import limit_text, shown
from pitchpoint.model.study_plan import Levels, PitchDeviations, Varied
from pitchpoint.sweep.study.distributions import OUTSIDE, Amounts, distribution_of, nominal_of, outside
from pitchpoint.sweep.study.factors import Choice, Number, Pitch


def made_factor(name: str, factor: Any, model: Model, report: Reader) -> Any:
    """One factor with its distribution; BAD with problems.

    Parameters
    ----------
    name, factor
        Factor of the plan.
    model
        The model.
    report
        Reader with the lines of the plan; collects the problems.
    """
    if isinstance(factor, PitchDeviations):
        return _pitch(name, factor, model, report)
    model = with_defaults(model, factor.every_path)
    free = isinstance(factor, Levels) and factor.apply == "absolute"
    numbers: dict[str, float] = {}
    units: dict[str, str] = {}
    for path in factor.every_path:
        found = number_at(model, path)
        key = key_at(model, path)
        if key is not None and key.kind == "integer" and not isinstance(factor, Levels):
            remedy = "write type: levels with whole values"
            report.problem(
                _at(name, factor, path), "is a whole number of the model", value=path, remedy=remedy
            )
        elif found is None and factor.apply == "absolute" and (unit := unit_without_number(model, path)):
            numbers[path], units[path] = math.nan, unit
        elif found is None and not free:
            _no_number(name, factor, path, model, report)
        elif found is not None:
            numbers[path], units[path] = found
        else:
            numbers[path] = math.nan
    if ("factors", name) in report.tainted:
        return BAD
    if len(set(units.values())) > 1 and factor.apply != "multiply":
        listed = ", ".join(f"{path} [{unit}]" for path, unit in units.items())
        remedy = "write apply: multiply, or make two factors"
        return report.problem(("factors", name), f"has paths of different units: {listed}", remedy=remedy)
    unit = "1" if factor.apply == "multiply" else next(iter(units.values()), "")
    nominal = nominal_of(factor.apply, numbers)
    if isinstance(factor, Levels):
        return _choice(name, factor, numbers, unit, model, report)
    distribution = distribution_of(
        factor, nominal, Amounts(name, factor, model, factor.every_path[0], report)
    )
    if distribution is BAD:
        return BAD
    made = Number(name, unit, numbers, factor.apply, distribution, nominal)
    return _within_range(made, factor, model, report)


def _at(name: str, factor: Varied, path: str) -> Place:
    """Place of a path in the plan."""
    if factor.path is not None:
        return ("factors", name, "path")
    return ("factors", name, "paths", factor.every_path.index(path))


def _no_number(name: str, factor: Varied, path: str, model: Model, report: Reader) -> None:
    """Report a path without a number, with the problem of the model if it does not exist."""
    at = _at(name, factor, path)
    if not has_path(model, path):
        try:
            model.replace_all({path: 1.0})
        except ModelError as error:
            first = error.problems[0]
            report.problem(at, f"{first.where} {first.text}", remedy=first.remedy)
            return
    remedy = "name a key with one number, which the model gives; a number in a formula can be a parameter"
    report.problem(at, "is not a number of the model", value=path, remedy=remedy)


def _within_range(factor: Number, planned: Varied, model: Model, report: Reader) -> Any:
    """Check that the values of a factor are possible, and that the model accepts the middle one."""
    for path, number in factor.numbers.items():
        key = key_at(model, path)
        share = outside(factor.distribution, factor.apply, number, key) if key is not None else 0.0
        if share > OUTSIDE:
            what = f"{100.0 * share:.2g} % of the values are not permitted for {path}"
            remedy = "give low or high, or a smaller deviation"
            at: Place = ("factors", factor.name)
            return report.problem(at, what, limit=limit_text(key) if key else None, remedy=remedy)
    middle = float(factor.values(np.array([0.5]))[0])
    return _accepted(factor, factor.changes(0.5, middle), ("factors", factor.name), model, report)


def _accepted(factor: Any, changes: Mapping[str, Any], at: Place, model: Model, report: Reader) -> Any:
    """Report the problems of the model with new values; the factor if there are none."""
    try:
        model.replace_all(changes, allow_code=report.allow_code)
    except ModelError as error:
        for problem in error.problems:
            limits = f" (limit {problem.limit})" if problem.limit else ""
            value = f"{problem.value} " if problem.value else ""
            what = f"is rejected: {problem.where}: {value}{problem.text}{limits}"
            report.problem(at, what, remedy=problem.remedy, taint=False)
        return BAD
    return factor


def _choice(
    name: str,
    factor: Levels,
    numbers: Mapping[str, float],
    unit: str,
    model: Model,
    report: Reader,
) -> Any:
    """A factor with levels; each value is tried in the model."""
    at: Place = ("factors", name, "values")
    amounts: list[float] = []
    for k, value in enumerate(factor.values):
        try:
            if factor.apply == "multiply":
                amounts.append(natural_quantity(str(value))[0])
            elif not isinstance(value, bool) and not any(map(math.isnan, numbers.values())):
                amounts.append(amount_at(model, factor.every_path[0], str(value)))
        except UnitError as error:
            if factor.apply != "absolute":
                report.problem((*at, k), "is not a number", value=shown(value), remedy=str(error))
    weights = factor.weights or (1.0,) * len(factor.values)
    numeric = tuple(amounts) if len(amounts) == len(factor.values) else None
    nominal = nominal_of(factor.apply, numbers) if numeric is not None else math.nan
    made = Choice(
        name,
        unit if numeric is not None else "",
        numbers,
        factor.apply,
        factor.values,
        numeric,
        weights,
        nominal,
    )
    total, upper = sum(weights), np.cumsum(weights)
    for k, weight in enumerate(weights):
        if weight > 0.0:
            u = float((upper[k] - 0.5 * weight) / total)
            value = float(made.values(np.array([u]))[0])
            _accepted(made, made.changes(u, value), (*at, k), model, report)
    return made


def _pitch(name: str, factor: PitchDeviations, model: Model, report: Reader) -> Any:
    """Random pitch deviations of gears of the model."""
    teeth: dict[str, int] = {}
    deviation: dict[str, float] = {}
    paths: dict[str, str] = {}
    kept: dict[str, tuple[tuple[float, ...], tuple[float, ...]]] = {}
    for k, gear in enumerate(factor.gears):
        at: Place = ("factors", name, "gears", k)
        own = model.gears.get(gear)
        if own is None:
            report.problem(at, f"there is no cylindrical gear {gear!r}", remedy=hint(gear, model.gears, 3))
            continue
        geometry = own.geometry
        teeth[gear] = abs(geometry.z)
        deviation[gear] = factor.deviation or (
            single_pitch_tolerance(geometry.d, geometry.m_n, factor.tolerance_class or 1) / 3.0
        )
        paths[gear] = ".".join((*place_of_gear(model, gear), "deviations", "pitch"))
        given = own.deviations
        kept[gear] = (given.pitch_of("left"), given.pitch_of("right")) if given is not None else ((), ())
        _accepted(factor, {paths[gear]: [0.0] * teeth[gear]}, at, model, report)
    return Pitch(name, teeth, deviation, factor.flanks, paths, kept)
