# SPDX-License-Identifier: Apache-2.0
"""Distributions of factors: numbers of the plan in SI, the distribution of SciPy, its range in the model."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

from pitchpoint.core.errors import UnitError
from pitchpoint.core.units import parse_quantity
from pitchpoint.model.keys import BAD, Key
from pitchpoint.model.model import Model
from pitchpoint.model.numbers import amount_at, unit_without_number
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.study_plan import Lognormal, Normal, Tolerance, Triangular, Uniform

OUTSIDE = 1e-9
"""Probability of impossible values above which a distribution is rejected."""


class Amounts:
    """Quantities of a factor in SI units; problems are reported at their keys.

    Parameters
    ----------
    name, factor
        Factor of the plan.
    model, path
        The model, and the path whose dimension the quantities have.
    report
        Collects the problems.
    """

    def __init__(self, name: str, factor: Any, model: Model, path: str, report: Reader) -> None:
        self.at, self.factor, self.model = ("factors", name), factor, model
        self.path, self.report = path, report

    def __call__(self, key: str, default: float, entry: int | None = None) -> float:
        """Quantity of a key, or of an entry of its list; the default if it is not given; NaN if invalid."""
        written = getattr(self.factor, key)
        if written is None:
            return default
        place = (*self.at, key) if entry is None else (*self.at, key, entry)
        text = str(written if entry is None else written[entry])
        try:
            if self.factor.apply == "multiply":
                return parse_quantity(text, "dimensionless")
            return amount_at(self.model, self.path, text)
        except UnitError as error:
            message, _, wanted = str(error).partition("; expected ")
            self.report.problem(place, message, remedy=f"write {wanted}" if wanted else None)
            return math.nan

    def wrong(self, key: str, what: str, remedy: str) -> Any:
        """Report the value of a key."""
        value = getattr(self.factor, key)
        shown = ", ".join(value) if isinstance(value, tuple) else str(value)
        return self.report.problem((*self.at, key), what, value=shown, remedy=remedy)


def nominal_of(apply: str, numbers: Mapping[str, float]) -> float:
    """Value of a factor that does not change the model; NaN if its numbers differ."""
    if apply != "absolute":
        return 1.0 if apply == "multiply" else 0.0
    return next(iter(numbers.values())) if len(set(numbers.values())) == 1 else math.nan


def distribution_of(factor: Any, nominal: float, amounts: Amounts) -> Any:
    """Frozen distribution of the values of a factor; BAD with problems.

    Parameters
    ----------
    factor
        Factor of the plan with a continuous distribution.
    nominal
        Value that does not change the model.
    amounts
        Reads its quantities.
    """
    before = len(amounts.report.problems)
    made = _MAKERS[type(factor)](factor, nominal, amounts)
    return BAD if len(amounts.report.problems) > before else made


def _centre(key: str, nominal: float, amounts: Amounts) -> float:
    """Mean or median, by default the number of the model."""
    if getattr(amounts.factor, key) is None:
        _one_number(nominal, amounts)
    return amounts(key, nominal)


def _one_number(nominal: float, amounts: Amounts) -> None:
    """Report a factor about the number of the model at several paths with different numbers."""
    if math.isnan(nominal):
        what = "varies about the number of the model, but the numbers at its paths differ"
        remedy = "write apply: add or apply: multiply, or absolute values"
        if unit_without_number(amounts.model, amounts.path) is not None:
            what = f"varies about the number of the model, but the model does not give {amounts.path}"
            remedy = "give it in the model, or write absolute values"
        amounts.report.problem(amounts.at, what, remedy=remedy)


def _normal(factor: Normal, nominal: float, amounts: Amounts) -> Any:
    mean, deviation = _centre("mean", nominal, amounts), amounts("deviation", math.nan)
    low, high = amounts("low", -math.inf), amounts("high", math.inf)
    if deviation <= 0.0:
        return amounts.wrong("deviation", "is not a standard deviation", "give a positive deviation")
    return _truncated(mean, deviation, low, high, "high" if factor.high is not None else "low", amounts)


def _truncated(mean: float, deviation: float, low: float, high: float, key: str, amounts: Amounts) -> Any:
    """Normal distribution between two limits."""
    from scipy import stats

    if low >= high:
        return amounts.wrong(key, "gives an upper limit below the lower limit", "give low < high")
    whole = stats.norm(mean, deviation)
    if math.isinf(low) and math.isinf(high):
        return whole
    if not math.isnan(mean) and whole.cdf(high) - whole.cdf(low) < OUTSIDE:
        return amounts.wrong(key, "excludes practically all values", "give limits around the mean")
    return stats.truncnorm((low - mean) / deviation, (high - mean) / deviation, loc=mean, scale=deviation)


def _uniform(factor: Uniform, nominal: float, amounts: Amounts) -> Any:
    from scipy import stats

    if factor.plus_minus is not None:
        half = amounts("plus_minus", math.nan)
        if half <= 0.0:
            return amounts.wrong("plus_minus", "is not a range", "give a positive number")
        _one_number(nominal, amounts)
        return stats.uniform(nominal - half, 2.0 * half)
    low, high = amounts("low", math.nan), amounts("high", math.nan)
    if low >= high:
        return amounts.wrong("high", "is not above the lower limit", "give low < high")
    return stats.uniform(low, high - low)


def _triangular(factor: Triangular, nominal: float, amounts: Amounts) -> Any:
    from scipy import stats

    low, high = amounts("low", math.nan), amounts("high", math.nan)
    mode = amounts("mode", 0.5 * (low + high))
    if low >= high:
        return amounts.wrong("high", "is not above the lower limit", "give low < high")
    if not low <= mode <= high and not math.isnan(low + mode + high):
        return amounts.wrong("mode", "is not between the limits", "give a mode between low and high")
    return stats.triang((mode - low) / (high - low), loc=low, scale=high - low)


def _lognormal(factor: Lognormal, nominal: float, amounts: Amounts) -> Any:
    from scipy import stats

    if factor.apply == "add":
        return amounts.wrong(
            "apply", "is not possible: the values have one sign", "write multiply or absolute"
        )
    median = _centre("median", nominal, amounts)
    if median <= 0.0:
        remedy = "give a positive median, or use another distribution"
        what = "has a median that is not positive"
        return amounts.report.problem(amounts.at, what, value=f"{median:g}", remedy=remedy)
    return stats.lognorm(factor.deviation, scale=median)


def _tolerance(factor: Tolerance, nominal: float, amounts: Amounts) -> Any:
    low, high = amounts("limits", math.nan, 0), amounts("limits", math.nan, 1)
    if low >= high:
        return amounts.wrong("limits", "are not in ascending order", "give [lower limit, upper limit]")
    mean = amounts("mean", 0.5 * (low + high))
    deviation = (high - low) / (6.0 * factor.capability)
    if not factor.inspected:
        return _truncated(mean, deviation, -math.inf, math.inf, "limits", amounts)
    return _truncated(mean, deviation, low, high, "limits", amounts)


_MAKERS: dict[type, Callable[[Any, float, Amounts], Any]] = {
    Normal: _normal,
    Uniform: _uniform,
    Triangular: _triangular,
    Lognormal: _lognormal,
    Tolerance: _tolerance,
}


def outside(distribution: Any, apply: str, number: float, key: Key) -> float:
    """Probability that the value of a factor gives a number outside the permitted range of a key.

    Parameters
    ----------
    distribution, apply
        Of the factor.
    number
        Number of the model.
    key
        Key of the number.
    """
    low, high = key.minimum, key.maximum
    if apply == "add":
        low, high = low - number, high - number
    elif apply == "multiply":
        if number == 0.0:
            return 0.0
        low, high = sorted((low / number, high / number))
    below, above = distribution.cdf(low), distribution.sf(high)
    return float(below + above)
