# SPDX-License-Identifier: Apache-2.0
"""Statistics of a random sample with confidence intervals: mean, deviation, quantiles, yield.

Intervals are those of independent random samples. Latin hypercubes and Sobol' sequences estimate means better
than that, so that their intervals are on the safe side.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pitchpoint.analysis.study.bootstrap import Array, limits, resampled_means

QUANTILES = (0.01, 0.05, 0.5, 0.95, 0.99)
"""Probabilities of the quantiles."""


@dataclass(frozen=True)
class Estimate:
    """A number with its confidence interval; NaN where there is no limit."""

    value: float
    low: float
    high: float


@dataclass(frozen=True)
class Spread:
    """Statistics of the finite values of a sample.

    Parameters
    ----------
    count
        Number of finite values.
    mean, deviation
        Mean, and standard deviation with the divisor n - 1.
    minimum, maximum
        Extremes.
    quantiles
        Quantiles at `QUANTILES`.
    """

    count: int
    mean: Estimate
    deviation: Estimate
    minimum: float
    maximum: float
    quantiles: tuple[Estimate, ...]


def spread_of(values: Array, confidence: float = 0.95) -> Spread:
    """Statistics of a sample.

    The interval of the mean is that of Student's t distribution, the one of the deviation by bootstrap
    (percentiles), those of the quantiles are distribution-free (order statistics, binomial distribution).
    Source: W. J. Conover, Practical Nonparametric Statistics, 3rd ed., 1999, 3.2.

    Parameters
    ----------
    values
        Sample, shape (n,); values that are not finite are omitted.
    confidence
        Level of the intervals.

    Examples
    --------
    >>> spread = spread_of(np.arange(1.0, 100.0))
    >>> spread.mean.value, round(spread.deviation.value, 4), spread.quantiles[2]
    (50.0, 28.7228, Estimate(value=50.0, low=40.0, high=60.0))
    """
    from scipy import stats

    known = np.sort(values[np.isfinite(values)])
    n = known.size
    nan = float("nan")
    if n == 0:
        none = Estimate(nan, nan, nan)
        return Spread(0, none, none, nan, nan, (none,) * len(QUANTILES))
    mean = float(known.mean())
    deviation = float(known.std(ddof=1)) if n > 1 else nan
    half = float(stats.t.ppf(0.5 + 0.5 * confidence, n - 1)) * deviation / np.sqrt(n) if n > 1 else nan
    quantiles = tuple(_quantile(known, p, confidence) for p in QUANTILES)
    return Spread(
        n,
        Estimate(mean, mean - half, mean + half),
        _interval_of_deviation(known, deviation, confidence),
        float(known[0]),
        float(known[-1]),
        quantiles,
    )


def _interval_of_deviation(known: Array, deviation: float, confidence: float) -> Estimate:
    """Standard deviation with its bootstrap interval."""
    n = known.size
    if n < 3:
        return Estimate(deviation, float("nan"), float("nan"))
    centred = known - known.mean()
    means = resampled_means(np.column_stack([centred, centred**2]))
    variance = np.maximum(means[:, 1] - means[:, 0] ** 2, 0.0) * n / (n - 1.0)
    low, high = limits(np.sqrt(variance), confidence)
    return Estimate(deviation, float(low), float(high))


def _quantile(known: Array, p: float, confidence: float) -> Estimate:
    """Quantile of sorted values with its distribution-free interval."""
    from scipy import stats

    n, tail = known.size, 0.5 - 0.5 * confidence
    value = float(np.quantile(known, p))
    # ranks: the number of values below the quantile is binomial
    below = int(stats.binom.ppf(tail, n, p))
    above = int(stats.binom.ppf(1.0 - tail, n, p)) + 1
    low = float(known[below - 1]) if below >= 1 else float("nan")
    high = float(known[above - 1]) if above <= n else float("nan")
    return Estimate(value, low, high)


def share_with_interval(inside: int, count: int, confidence: float = 0.95) -> Estimate:
    """Share of successes in independent trials with its exact interval.

    Source: C. J. Clopper, E. S. Pearson, The use of confidence or fiducial limits illustrated in the case of
    the binomial, Biometrika 26 (1934) 404-413.

    Parameters
    ----------
    inside, count
        Number of successes and of trials.
    confidence
        Level of the interval.

    Examples
    --------
    >>> found = share_with_interval(10, 10)
    >>> found.value, round(found.low, 4), found.high
    (1.0, 0.6915, 1.0)
    """
    from scipy import stats

    if count == 0:
        return Estimate(float("nan"), 0.0, 1.0)
    interval = stats.binomtest(inside, count).proportion_ci(confidence, method="exact")
    return Estimate(inside / count, float(interval.low), float(interval.high))
