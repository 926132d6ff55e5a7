# SPDX-License-Identifier: Apache-2.0
"""Bootstrap of statistics that are functions of means, such as variances and correlations."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]
RESAMPLES = 1000
"""Number of samples of a bootstrap."""
CHUNK = 4_000_000
"""Maximum number of weights in memory."""


def resampled_means(columns: Array) -> Array:
    """Means of columns over random samples with replacement; the random numbers are always the same.

    Source: B. Efron, R. Tibshirani, An Introduction to the Bootstrap, 1993, chapter 6.

    Parameters
    ----------
    columns
        Quantities of each sample, shape (n, k).

    Returns
    -------
    ndarray
        Means, shape (`RESAMPLES`, k).

    Examples
    --------
    >>> means = resampled_means(np.arange(100.0)[:, None])
    >>> means.shape, round(float(means.mean()), 1), round(float(means.std()), 1)
    ((1000, 1), 49.5, 2.9)
    """
    n = len(columns)
    random = np.random.default_rng(0)
    found = []
    rows = max(1, min(RESAMPLES, CHUNK // n))
    for start in range(0, RESAMPLES, rows):
        count = min(rows, RESAMPLES - start)
        drawn = random.integers(0, n, (count, n)) + n * np.arange(count)[:, None]
        weights = np.bincount(drawn.ravel(), minlength=count * n).reshape(count, n)
        found.append(weights @ columns / n)
    return np.concatenate(found)


def limits(sampled: Array, confidence: float) -> tuple[Array, Array]:
    """Limits between which the share `confidence` of resampled statistics lies (percentiles).

    Parameters
    ----------
    sampled
        Statistics, shape (`RESAMPLES`, ...); NaN where a statistic has no value: then the limits are NaN.
    confidence
        Level of the interval.

    Examples
    --------
    >>> [round(float(x), 6) for x in limits(np.arange(1001.0), 0.9)]
    [50.0, 950.0]
    """
    unknown = np.isnan(sampled).any(axis=0)
    low, high = np.quantile(
        np.where(unknown, 0.0, sampled), [0.5 - 0.5 * confidence, 0.5 + 0.5 * confidence], axis=0
    )
    return np.where(unknown, np.nan, low), np.where(unknown, np.nan, high)
