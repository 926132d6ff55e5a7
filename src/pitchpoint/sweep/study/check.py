# SPDX-License-Identifier: Apache-2.0
"""Check of the plan of a study against its model: distributions of factors, units of results."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from pitchpoint.core.errors import ModelError, UnitError
from pitchpoint.core.formula.dimension import of_number, si_unit
from pitchpoint.core.nearest import hint
from pitchpoint.core.units import natural_quantity
from pitchpoint.model.keys import BAD, Place
from pitchpoint.model.model import Model
from pitchpoint.model.reading.plan import in_order
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.study_plan import (
    RUN,
    STATISTICS,
    StudyPlan,
    StudyResult,
)
from pitchpoint.sweep.study.check_factors import made_factor
from pitchpoint.sweep.study.factors import StudyFactor
from pitchpoint.sweep.study.quantities import Quantity, available

LISTED = 5
"""Number of similar names in a message."""


@dataclass(frozen=True)
class Wanted:
    """A result of the study.

    Parameters
    ----------
    name, channel, statistic
        As in the plan.
    unit, words
        SI unit and description.
    low, high
        Permitted range in SI units; infinite without a limit.
    """

    name: str
    channel: str
    statistic: str | None
    unit: str
    words: str
    low: float = -math.inf
    high: float = math.inf

    @property
    def limited(self) -> bool:
        """Whether the result has a permitted range."""
        return math.isfinite(self.low) or math.isfinite(self.high)


@dataclass(frozen=True)
class Study:
    """A checked plan with its model.

    Parameters
    ----------
    plan, model
        Plan and model.
    scenario
        Name of the scenario; None: at rest.
    factors, results
        Factors and results in the order of the plan.
    """

    plan: StudyPlan
    model: Model
    scenario: str | None
    factors: tuple[StudyFactor, ...]
    results: tuple[Wanted, ...]


def check_study(plan: StudyPlan, model: Model) -> Study:
    """Check a plan against its model.

    Parameters
    ----------
    plan, model
        The plan and its model.

    Raises
    ------
    ModelError
        With all problems, in the order of the file.
    """
    report = Reader(lines=plan.lines, allow_code=plan.allow_code)
    factors = [made_factor(name, one, model, report) for name, one in plan.factors.items()]
    _correlations(plan, report)
    scenario = _scenario(plan, model, report)
    results: list[Wanted] = []
    if scenario is not BAD:
        known = _known(plan, model, scenario, report)
        for name, one in plan.results.items():
            if known is not None and (wanted := _result(name, one, known, report)) is not BAD:
                results.append(wanted)
    if report.problems:
        raise ModelError(in_order(report.problems), plan.file)
    return Study(plan, model, scenario, tuple(factors), tuple(results))


def _scenario(plan: StudyPlan, model: Model, report: Reader) -> Any:
    """Name of the scenario; BAD with a problem."""
    names = list(model.scenarios)
    if plan.scenario is not None:
        if plan.scenario in model.scenarios:
            return plan.scenario
        what = f"there is no scenario {plan.scenario!r}"
        return report.problem(("scenario",), what, remedy=hint(plan.scenario, names))
    if plan.evaluate != RUN:
        return None
    if len(names) == 1:
        return names[0]
    listed = ", ".join(names) or "none"
    return report.problem(("scenario",), "is missing", remedy=f"name a scenario; there are: {listed}")


def _known(
    plan: StudyPlan, model: Model, scenario: str | None, report: Reader
) -> Mapping[str, Quantity] | None:
    """Results that the evaluation gives; None with a problem."""
    from pitchpoint.core.errors import PitchpointError

    try:
        return available(model, scenario, plan.evaluate)
    except ModelError:
        raise
    except PitchpointError as error:
        report.problem(("model",), f"cannot be evaluated: {error}", remedy="check the model by itself")
        return None


def _correlations(plan: StudyPlan, report: Reader) -> None:
    """Report coefficients that contradict each other."""
    if len(plan.correlations) > 1:
        least = float(np.linalg.eigvalsh(correlation_matrix(plan))[0])
        if least <= 0.0:
            what = "contradict each other: their matrix has the eigenvalue"
            remedy = "give smaller coefficients, or those of all pairs"
            report.problem(("correlations",), f"{what} {least:.3g}", limit="> 0", remedy=remedy)


def correlation_matrix(plan: StudyPlan) -> Any:
    """Correlation coefficients of the factors, shape (n, n)."""
    names = list(plan.factors)
    matrix = np.eye(len(names))
    for one in plan.correlations:
        i, j = (names.index(name) for name in one.factors)
        matrix[i, j] = matrix[j, i] = one.coefficient
    return matrix


def _result(name: str, result: StudyResult, known: Mapping[str, Quantity], report: Reader) -> Any:
    """One result with its unit and limits; BAD with problems."""
    at: Place = ("results", name)
    found = known.get(result.channel)
    if found is None:
        remedy = hint(result.channel, known, LISTED)
        return report.problem((*at, "channel"), f"there is no result {result.channel!r}", remedy=remedy)
    if found.single and result.statistic is not None:
        what = f"{result.channel} is a single number"
        report.problem((*at, "statistic"), what, value=result.statistic, remedy="omit statistic")
    if not found.single and result.statistic is None:
        remedy = f"write one of {', '.join(STATISTICS)}"
        report.problem((*at, "statistic"), f"is missing: {result.channel} varies with time", remedy=remedy)
    low = _limit(result.low, -math.inf, found, (*at, "low"), report)
    high = _limit(result.high, math.inf, found, (*at, "high"), report)
    if low > high:
        what = "is below low"
        report.problem(
            (*at, "high"), what, value=str(result.high), limit=f">= {result.low}", remedy="swap them"
        )
    if at in report.tainted:
        return BAD
    statistic = (result.statistic or "").replace("_", " ")
    words = ", ".join(filter(None, (found.words or result.channel, statistic)))
    return Wanted(name, result.channel, result.statistic, found.unit, words, low, high)


def _limit(written: str | None, default: float, found: Quantity, at: Place, report: Reader) -> float:
    """Limit of a result in SI units."""
    if written is None:
        return default
    own = "" if found.unit == "1" else found.unit
    try:
        value, unit = natural_quantity(written)
        wanted = si_unit(of_number(1.0, own)) if own else ""
        if unit and si_unit(of_number(1.0, unit)) != wanted:
            remedy = f"write a quantity in {own}" if own else "write a plain number"
            report.problem(at, "has another unit than the result", value=written, remedy=remedy)
            return default
        return value
    except UnitError as error:
        report.problem(at, str(error))
        return default
