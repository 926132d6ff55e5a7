# SPDX-License-Identifier: Apache-2.0
"""Summary of a study: spread, yield and sensitivities of each result over the samples of its factors."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.study.bootstrap import Array
from pitchpoint.analysis.study.sensitivity import Indices, Regression, regression, sobol_indices
from pitchpoint.analysis.study.statistics import Estimate, Spread, share_with_interval, spread_of

ROUNDING = 1e-12
"""Range over the magnitude up to which values are equal."""
POOR = 0.7
"""Share of the variance explained by the regression below which its coefficients do not describe a result."""


@dataclass(frozen=True)
class FactorSample:
    """Values of a factor in all cases.

    Parameters
    ----------
    name, words, unit
        Name, description and SI unit.
    values
        Numbers in SI, or indices of the labels, shape (n,).
    labels
        Values that are not numbers; empty for numbers.
    nominal
        Value of the model without changes; NaN if there is none.
    """

    name: str
    words: str
    unit: str
    values: Array
    labels: tuple[str, ...] = ()
    nominal: float = math.nan

    @property
    def columns(self) -> Array:
        """Values for a regression: numbers, shape (n,), or indicators of labels 2 to k, shape (n, k - 1)."""
        if not self.labels:
            return self.values
        return np.asarray(self.values[:, None] == np.arange(1, len(self.labels)), np.float64)


@dataclass(frozen=True)
class ResultSample:
    """Values of a result in all cases.

    Parameters
    ----------
    name, words, unit
        Name, description and SI unit.
    values
        Values in SI, NaN where a case failed or has no such number, shape (n,).
    nominal
        Value of the model without changes.
    low, high
        Permitted range; infinite without a limit.
    """

    name: str
    words: str
    unit: str
    values: Array
    nominal: float
    low: float = -math.inf
    high: float = math.inf


@dataclass(frozen=True)
class ResultSummary:
    """Statistics of one result.

    Parameters
    ----------
    sample
        Its values.
    spread
        Mean, standard deviation, quantiles.
    within
        Share of the samples within the permitted range; None without a limit.
    linear
        Regression; None for a study with Sobol' indices.
    first, total
        Sobol' indices; None for a study with regression.
    """

    sample: ResultSample
    spread: Spread
    within: Estimate | None
    linear: Regression | None
    first: Indices | None = None
    total: Indices | None = None

    @property
    def sensitivity(self) -> Indices:
        """Sensitivities by which the factors are ranked: total indices, or shares of the regression."""
        if self.total is not None:
            return self.total
        assert self.linear is not None
        return self.linear.share


@dataclass(frozen=True)
class StudySummary:
    """Statistics of all results.

    Parameters
    ----------
    factors
        Factors in the order of the plan.
    results
        Results in the order of the plan.
    counted
        Cases of the statistics; the mixed cases of Sobol' indices are not among them, shape (n,).
    finished
        Cases with a result, shape (n,).
    confidence
        Level of all intervals.
    notes
        Remarks on the statistics.
    """

    factors: tuple[FactorSample, ...]
    results: tuple[ResultSummary, ...]
    counted: NDArray[np.bool_]
    finished: NDArray[np.bool_]
    confidence: float
    notes: tuple[str, ...] = ()


def summary_of(
    factors: Sequence[FactorSample],
    results: Sequence[ResultSample],
    groups: NDArray[np.intp],
    finished: NDArray[np.bool_],
    *,
    confidence: float = 0.95,
    indices: bool = False,
) -> StudySummary:
    """Compute all statistics of a study.

    Parameters
    ----------
    factors, results
        Values of all cases; of Sobol' indices in the order of points, with all groups of each.
    groups
        Group of each case for Sobol' indices: 0 first sample, 1 second sample, 2 + k first sample with factor
        k from the second, shape (n,).
    finished
        Cases with a result, shape (n,).
    confidence
        Level of the intervals.
    indices
        Compute Sobol' indices in place of a regression.
    """
    counted = groups < 2 if indices else np.ones(len(groups), bool)
    found = []
    for result in results:
        spread = spread_of(result.values[counted], confidence)
        within = None
        if math.isfinite(result.low) or math.isfinite(result.high):
            known = result.values[counted & np.isfinite(result.values)]
            inside = int(np.count_nonzero((known >= result.low) & (known <= result.high)))
            within = share_with_interval(inside, known.size, confidence)
        if indices:
            blocks = result.values.reshape(-1, len(factors) + 2)
            first, total = sobol_indices(blocks[:, 0], blocks[:, 1], blocks[:, 2:], confidence)
            found.append(ResultSummary(result, spread, within, None, first, total))
        else:
            linear = regression([f.columns for f in factors], result.values, confidence)
            found.append(ResultSummary(result, spread, within, linear))
    made = StudySummary(tuple(factors), tuple(found), counted, finished, confidence)
    return StudySummary(made.factors, made.results, counted, finished, confidence, _notes(made))


def is_constant(values: NDArray[np.float64]) -> bool:
    """Whether values, shape (n,), are equal up to rounding.

    Examples
    --------
    >>> is_constant(np.array([0.3, 0.1 + 0.2])), is_constant(np.array([1.0, 1.001]))
    (True, False)
    """
    return not values.size or bool(np.ptp(values) <= ROUNDING * np.abs(values).max())


def _notes(summary: StudySummary) -> tuple[str, ...]:
    """Remarks on failed cases, missing numbers and poor regressions."""
    notes = []
    failed = int(np.count_nonzero(~summary.finished))
    if failed:
        notes.append(
            f"{failed} of {len(summary.finished)} cases failed; the statistics are those of the others"
        )
    for one in summary.results:
        absent = int(np.count_nonzero(summary.finished & ~np.isfinite(one.sample.values)))
        if absent:
            notes.append(
                f"{one.sample.name}: {absent} finished cases have no such number and are not counted"
            )
    for one in summary.results:
        values = one.sample.values[summary.counted & np.isfinite(one.sample.values)]
        if values.size > 1 and is_constant(values):
            notes.append(f"{one.sample.name} is equal in all cases: no factor has an influence on it")
    poor = [
        f"{one.sample.name} {100.0 * one.linear.determination:.0f} %"
        for one in summary.results
        if one.linear is not None and one.linear.determination < POOR
    ]
    if poor:
        notes.append(
            f"the regression explains only a part of the variance ({', '.join(poor)}): results are curved, "
            "factors interact, or the response is chaotic; sensitivity: sobol_indices includes curvature and "
            "interactions"
        )
    return tuple(notes)
