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
    return np.unique(bucket_samples(values, limit)[0])


def bucket_samples(values: Array, limit: int) -> tuple[NDArray[np.int64], Array]:
    """Drawn samples of every bucket of a long record, and the mean of all its samples.

    Parameters
    ----------
    values
        Samples, shape (n,).
    limit
        Maximum number of kept samples; at least 4 and less than n.

    Returns
    -------
    tuple of NDArray
        Ascending indices of the first, minimum, maximum and last sample of the buckets, shape (k, 4), with
        repetitions, and the means of the samples that are not NaN, shape (k,).

    Examples
    --------
    >>> kept, mean = bucket_samples(np.array([0.0, 3.0, 1.0, 0.0, 5.0, 5.0, 6.0, 8.0]), 8)
    >>> kept.tolist(), mean.tolist()
    ([[0, 0, 1, 3], [4, 4, 7, 7]], [1.0, 6.0])
    """
    edges = np.linspace(0, values.size, limit // 4 + 1).round().astype(np.int64)
    starts, ends = edges[:-1], edges[1:]
    low = np.where(np.isnan(values), np.inf, values)
    high = np.where(np.isnan(values), -np.inf, values)
    least = [a + int(np.argmin(low[a:b])) for a, b in zip(starts, ends, strict=True)]
    most = [a + int(np.argmax(high[a:b])) for a, b in zip(starts, ends, strict=True)]
    known = np.add.reduceat(np.isfinite(values).astype(np.float64), starts)
    mean = np.add.reduceat(np.nan_to_num(values, nan=0.0), starts) / np.where(known > 0.0, known, np.nan)
    return np.sort(np.column_stack([starts, least, most, ends - 1]), axis=1), mean
