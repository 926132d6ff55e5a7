# SPDX-License-Identifier: Apache-2.0
"""Conversion of plain data to a `StudyPlan`; all problems of the plan itself are collected."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from pitchpoint.core.errors import ModelError
from pitchpoint.core.nearest import hint
from pitchpoint.model.checks.choices import check_keys
from pitchpoint.model.keys import TYPE, Place
from pitchpoint.model.reading.plan import check_mapping, in_order, plan_values
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.show import shown
from pitchpoint.model.study_plan import (
    FACTORIAL,
    INDICES,
    SOBOL,
    Levels,
    PitchDeviations,
    StudyPlan,
    Uniform,
)

VALUES = "values"
MOST_LEVELS = 10_000
"""Maximum number of cases of one factor with levels."""


def read_study(data: Any, reader: Reader, file: str | None = None) -> StudyPlan:
    """Create a plan from the nested mappings of a file.

    Parameters
    ----------
    data
        Mappings, lists, strings and numbers.
    reader
        Reader with the line numbers of the file; its previous problems are reported too.
    file
        Name of the file for messages.

    Raises
    ------
    ModelError
        With all problems of the plan itself, in the order of the file.
    """
    check_mapping(data, reader, file)
    written, levels = _without_values(data.get("factors"))
    values = plan_values(StudyPlan, {**data, "factors": written}, reader)
    if "factors" in values:
        values["factors"] = _with_values(values["factors"], levels, reader)
    for name in ("factors", "results"):
        check_keys(values.get(name, {}), (name,), reader)
        if values.get(name) == {} and not data[name]:
            reader.problem((name,), "is empty", remedy="name at least one")
    _check_sampling(values, reader)
    if reader.problems:
        raise ModelError(in_order(reader.problems), file)
    return StudyPlan(**values, file=file, lines=reader.lines, allow_code=reader.allow_code)


def _without_values(data: Any) -> tuple[Any, dict[str, Any]]:
    """Factors without the values of levels, and these values: texts, numbers and mappings as written."""
    if not isinstance(data, Mapping):
        return data, {}
    levels = {
        name: entry[VALUES]
        for name, entry in data.items()
        if isinstance(entry, Mapping) and entry.get(TYPE) == Levels.form and VALUES in entry
    }
    rest = {
        name: {k: v for k, v in entry.items() if k != VALUES} if name in levels else entry
        for name, entry in data.items()
    }
    return rest, {str(name): values for name, values in levels.items()}


def _with_values(factors: Mapping[str, Any], levels: Mapping[str, Any], reader: Reader) -> dict[str, Any]:
    """Factors with the values of levels, and their checks without a model."""
    found = dict(factors)
    taken: dict[str, str] = {}
    for name, factor in factors.items():
        at: Place = ("factors", name)
        if isinstance(factor, Levels):
            found[name] = replace(factor, values=_levels(levels.get(name), factor, at, reader))
        if isinstance(factor, Uniform) and (factor.low is None) == (factor.plus_minus is None):
            reader.problem(at, "gives neither or both of low and plus_minus", remedy="give exactly one")
        if isinstance(factor, PitchDeviations):
            paths = tuple(f"gears.{gear}.deviations.pitch" for gear in factor.gears)
        else:
            paths = factor.every_path
        for path in paths:
            if (other := taken.setdefault(path, name)) != name:
                what = f"changes {path}, as does {other}"
                reader.problem(at, what, remedy="change it in one factor only", taint=False)
        if double := {path for path in paths if paths.count(path) > 1}:
            what = f"names {', '.join(sorted(double))} twice"
            reader.problem(at, what, remedy="name it once", taint=False)
    return found


def _levels(data: Any, factor: Levels, at: Place, reader: Reader) -> tuple[Any, ...]:
    """Values of a factor with levels."""
    here = (*at, VALUES)
    if data is None:
        reader.problem(here, "is missing: the values", remedy="add values: [VALUE, VALUE, ...]")
        return ()
    if not isinstance(data, list) or not 2 <= len(data) <= MOST_LEVELS:
        limit = f"2 to {MOST_LEVELS} entries"
        reader.problem(
            here,
            "is not a list of values",
            value=shown(data),
            limit=limit,
            remedy="write [VALUE, VALUE, ...]",
        )
        return ()
    if factor.weights is not None:
        if len(factor.weights) != len(data):
            what = f"has {len(factor.weights)} entries for {len(data)} values"
            reader.problem((*at, "weights"), what, remedy="give one weight for each value")
        elif not sum(factor.weights) > 0.0:
            reader.problem((*at, "weights"), "are all zero", remedy="give the value that occurs a weight")
    return tuple(data)


def _check_sampling(values: Mapping[str, Any], reader: Reader) -> None:
    """Check the combination of sampling, sensitivity and correlations."""
    factors: Mapping[str, Any] = values.get("factors", {})
    sampling = values.get("sampling", StudyPlan.sampling)
    correlations = values.get("correlations", ())
    if values.get("sensitivity") == INDICES:
        if sampling != SOBOL:
            remedy = f"write sampling: {SOBOL}, or sensitivity: regression"
            reader.problem(("sensitivity",), f"requires sampling: {SOBOL}", value=INDICES, remedy=remedy)
        if correlations:
            what = (
                "has no meaning with correlated factors: shares of the variance require independent factors"
            )
            reader.problem(("sensitivity",), what, value=INDICES, remedy="write sensitivity: regression")
    if sampling == FACTORIAL:
        if correlations:
            what = "is a grid of independent values: it cannot have correlated factors"
            reader.problem(("sampling",), what, value=FACTORIAL, remedy=f"write sampling: {SOBOL}")
        for name, factor in factors.items():
            if isinstance(factor, Levels) and factor.weights is not None:
                what = "are not used: a full factorial contains every value equally often"
                remedy = "omit them, or use another sampling"
                reader.problem(("factors", name, "weights"), what, remedy=remedy)
    for k, one in enumerate(correlations):
        at: Place = ("correlations", k)
        for name in one.factors:
            if factors and name not in factors and ("factors", name) not in reader.tainted:
                reader.problem((*at, "factors"), f"there is no factor {name!r}", remedy=hint(name, factors))
        if len(set(one.factors)) == 1:
            reader.problem((*at, "factors"), "names the same factor twice", remedy="name two factors")
        if any(set(one.factors) == set(other.factors) for other in correlations[:k]):
            reader.problem((*at, "factors"), "are correlated in an earlier entry", remedy="give them once")
