# SPDX-License-Identifier: Apache-2.0
"""Sensitivities of a result to independent factors: Sobol' indices and linear regression, with intervals.

Intervals are percentiles of a bootstrap over the samples, of rank correlations with the ranks of the sample.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.study.bootstrap import Array, limits, resampled_means

LEAST = 1e-12
"""Variance relative to the square of the largest value below which a result is constant."""


@dataclass(frozen=True)
class Indices:
    """Estimates for each factor with limits of their intervals, each of shape (n_factor,)."""

    value: Array
    low: Array
    high: Array


@dataclass(frozen=True)
class Regression:
    """Linear regression of a result over all factors.

    Parameters
    ----------
    coefficient
        Standardised regression coefficients: change of the result in its standard deviations for one standard
        deviation of the factor.
    rank
        Rank correlations (Spearman).
    share
        Share of the variance that the regression loses without the factor, corrected for chance.
    determination
        Share R^2 of the variance that the regression explains.
    count
        Number of samples.
    """

    coefficient: Indices
    rank: Indices
    share: Indices
    determination: float
    count: int


def sobol_indices(
    first: Array, second: Array, mixed: Array, confidence: float = 0.95, *, intervals: bool = True
) -> tuple[Indices, Indices]:
    """First-order and total Sobol' indices from the design of Saltelli.

    S_i = mean(f_B (f_ABi - f_A)) / V with values of which the common mean is subtracted, and
    S_Ti = mean((f_A - f_ABi)^2) / (2 V), V the variance of f_A and f_B together. Source: A. Saltelli et al.,
    Computer Physics Communications 181 (2010) 259-270, table 2 (b) and (f).

    Parameters
    ----------
    first, second
        Values of two independent samples A and B, shape (n,). Points with a value that is not finite are
        omitted, with all their values.
    mixed
        Values of A with factor i from B, shape (n, n_factor).
    confidence
        Level of the intervals.
    intervals
        False: without intervals (NaN).

    Returns
    -------
    tuple of Indices
        First-order and total indices; NaN for a constant result.

    Examples
    --------
    >>> x = np.random.default_rng(1).standard_normal((2, 4096, 2))
    >>> first, second = 2.0 * x[..., 0] + x[..., 1]
    >>> mixed = np.column_stack([2.0 * x[1, :, 0] + x[0, :, 1], 2.0 * x[0, :, 0] + x[1, :, 1]])
    >>> [np.round(i.value, 1).tolist() for i in sobol_indices(first, second, mixed)]
    [[0.8, 0.2], [0.8, 0.2]]
    """
    good = np.isfinite(first) & np.isfinite(second) & np.isfinite(mixed).all(axis=1)
    a, b, ab = first[good], second[good], mixed[good]
    n, factors = ab.shape
    both = np.concatenate([a, b])
    if n < 2 or _constant(both):
        nothing = Indices(*(np.full(factors, np.nan),) * 3)
        return nothing, nothing
    a, b, ab = a - both.mean(), b - both.mean(), ab - both.mean()
    terms = [a + b, a * a + b * b, ab - a[:, None], b[:, None] * (ab - a[:, None]), (ab - a[:, None]) ** 2]
    columns = np.column_stack(terms)
    values = _indices(columns.mean(axis=0), factors)
    if intervals:
        low, high = limits(_indices(resampled_means(columns), factors), confidence)
    else:
        low = high = np.full((2, factors), np.nan)
    return Indices(values[0], low[0], high[0]), Indices(values[1], low[1], high[1])


def _indices(means: Array, factors: int) -> Array:
    """First-order and total indices from the means of their terms, shape (..., 2, n_factor)."""
    mean, square = 0.5 * means[..., :1], 0.5 * means[..., 1:2]
    change, product, total = (means[..., 2 + k * factors : 2 + (k + 1) * factors] for k in range(3))
    with np.errstate(divide="ignore", invalid="ignore"):
        variance = square - mean**2
        return np.stack([(product - mean * change) / variance, 0.5 * total / variance], axis=-2)


def regression(columns: list[Array], result: Array, confidence: float = 0.95) -> Regression:
    """Standardised regression coefficients, rank correlations and shares of the variance.

    The share of a factor is (SS - k MSE) / SS_total, with the sum of squares SS that the regression loses
    without its k columns and the mean square MSE of the residuals: it is zero on average for a factor without
    influence. Source: J. Cohen et al., Applied Multiple Regression, 3rd ed., 2003, 5.3 (squared semipartial
    correlation, shrunken).

    Parameters
    ----------
    columns
        Values of each factor, shape (n,); the indicators of a factor without numbers, shape (n, k), of which
        coefficient and rank correlation are NaN.
    result
        Values of the result, shape (n,); those that are not finite are omitted.
    confidence
        Level of the intervals.

    Examples
    --------
    >>> x = [axis.ravel() for axis in np.meshgrid(np.arange(10.0), np.arange(10.0))]
    >>> found = regression(x, 3.0 * x[0] - 4.0 * x[1])
    >>> np.round(found.coefficient.value, 6).tolist(), np.round(found.share.value, 6).tolist()
    ([0.6, -0.8], [0.36, 0.64])
    """
    good = np.isfinite(result)
    blocks = [np.asarray(c, np.float64).reshape(len(result), -1)[good] for c in columns]
    widths = [block.shape[1] for block in blocks]
    plain = np.array([c.ndim == 1 for c in map(np.asarray, columns)])
    y, x = result[good], np.hstack(blocks) if blocks else np.zeros((int(good.sum()), 0))
    n = len(y)
    if n < x.shape[1] + 3 or _constant(y):
        nothing = Indices(*(np.full(len(columns), np.nan),) * 3)
        return Regression(nothing, nothing, nothing, float("nan"), n)
    ends = np.cumsum([0, *widths])
    edges = [slice(a, b) for a, b in zip(ends[:-1], ends[1:], strict=True)]
    z = np.column_stack([_standard(x), _standard(y)])
    ranks = np.column_stack([*(_standard(_ranks(c)) for c in x.T), _standard(_ranks(y))])
    moments = [z, _products(z), ranks, _products(ranks)]
    joint = np.hstack(moments)
    values, determination = _fit(joint.mean(axis=0), n, edges, plain)
    low, high = limits(_fit(resampled_means(joint), n, edges, plain)[0], confidence)
    parts = [Indices(values[k], low[k], high[k]) for k in range(3)]
    return Regression(parts[0], parts[1], parts[2], float(determination), n)


def _standard(values: Array) -> Array:
    """Values with mean zero and standard deviation one; zero where they do not vary."""
    centred = values - values.mean(axis=0)
    scale = centred.std(axis=0)
    varies = scale > LEAST * np.maximum(np.abs(values).max(axis=0), 1e-300)
    return np.asarray(np.where(varies, centred / np.where(varies, scale, 1.0), 0.0))


def _products(columns: Array) -> Array:
    """Products of all pairs of columns, shape (n, k * k)."""
    return np.asarray((columns[:, :, None] * columns[:, None, :]).reshape(len(columns), -1))


def _correlations(means: Array, products: Array) -> Array:
    """Correlation matrices from means (..., k) and mean products (..., k * k); zero where nothing varies."""
    k = means.shape[-1]
    covariance = products.reshape(*means.shape[:-1], k, k) - means[..., :, None] * means[..., None, :]
    size = np.sqrt(np.maximum(np.diagonal(covariance, axis1=-2, axis2=-1), 0.0))
    scale = size[..., :, None] * size[..., None, :]
    return np.asarray(np.where(scale > LEAST, covariance / np.where(scale > LEAST, scale, 1.0), 0.0))


def _fit(means: Array, n: int, edges: list[slice], plain: NDArray[np.bool_]) -> tuple[Array, Array]:
    """Coefficients, rank correlations, shares, shape (..., 3, n_factor), and R^2 from means of moments."""
    k = edges[-1].stop + 1
    parts = np.split(means, np.cumsum([k, k * k, k]), axis=-1)
    matrix, ranks = _correlations(parts[0], parts[1]), _correlations(parts[2], parts[3])
    inverse = np.linalg.pinv(matrix[..., :-1, :-1], hermitian=True)
    beta = (inverse @ matrix[..., :-1, -1:])[..., 0]
    fitted = np.sum(beta * matrix[..., :-1, -1], axis=-1)
    residual = np.maximum(1.0 - fitted, 0.0) / max(n - k, 1)
    found = np.full((*beta.shape[:-1], 3, len(edges)), np.nan)
    for j, edge in enumerate(edges):
        own = beta[..., edge]
        lost = np.linalg.pinv(inverse[..., edge, edge], hermitian=True) @ own[..., None]
        found[..., 2, j] = np.sum(own * lost[..., 0], axis=-1) - (edge.stop - edge.start) * residual
        if plain[j]:
            found[..., 0, j] = beta[..., edge.start]
            found[..., 1, j] = ranks[..., edge.start, -1]
    return found, fitted


def _ranks(values: Array) -> Array:
    """Ranks, of equal values their mean."""
    _, index, count = np.unique(values, return_inverse=True, return_counts=True)
    last = np.cumsum(count)
    return np.asarray((last - 0.5 * (count - 1))[index], np.float64)


def _constant(values: Array) -> bool:
    """Whether a result does not vary."""
    size = float(np.abs(values).max()) if values.size else 0.0
    return not float(values.var()) > LEAST**2 * max(size * size, 1e-300)
