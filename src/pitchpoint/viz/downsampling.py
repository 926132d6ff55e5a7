# SPDX-License-Identifier: Apache-2.0
"""Downsampling of curves for plots that preserves all peaks.

A curve of a million points is drawn on a thousand pixels. Every thousandth point alone would hide impacts of
a few samples; here every bucket of samples keeps its first, minimum, maximum and last sample, in order.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def kept_samples(values: Array, limit: int = 8000) -> NDArray[np.int64]:
    """Indices of the drawn samples.

    Parameters
    ----------
    values
        Samples, shape (n,); NaN is a gap, whose first sample is kept.
    limit
        Maximum number of kept samples; at least 4.

    Returns
    -------
    NDArray
        Increasing indices, all of them if n ≤ limit. They contain the first and last sample and, for every
        bucket, its minimum and maximum.

    Notes
    -----
    The line through the kept samples covers the same pixels as the full line if every bucket is at most one
    pixel wide [1]_.

    References
    ----------
    .. [1] U. Jugel, Z. Jerzak, G. Hackenbroich, V. Markl, M4: a visualization-oriented time series data
    aggregation,
       Proceedings of the VLDB Endowment 7(10), 2014, 797-808.

    Examples
    --------
    >>> x = np.zeros(100_000)
    >>> x[54_321] = 1.0
    >>> kept = kept_samples(x, 400)
    >>> kept.size <= 400, 54_321 in kept
    (True, True)
    """
    n = values.size
    limit = max(4, int(limit))
    if n <= limit:
        return np.arange(n, dtype=np.int64)
    buckets = limit // 4
    edges = np.linspace(0, n, buckets + 1).round().astype(np.int64)
    low = np.where(np.isnan(values), np.inf, values)
    high = np.where(np.isnan(values), -np.inf, values)
    kept = np.empty((buckets, 4), dtype=np.int64)
    for k in range(buckets):
        first, end = edges[k], edges[k + 1]
        kept[k] = first, first + np.argmin(low[first:end]), first + np.argmax(high[first:end]), end - 1
    return np.unique(kept)
