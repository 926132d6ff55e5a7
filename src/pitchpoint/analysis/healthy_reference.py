# SPDX-License-Identifier: Apache-2.0
"""Comparison of a record with few healthy records of the same machine: deviations, a distance and its limit.

Equations: docs/theory/signals.md, "Statistical tests".
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array, SignalError

LEAST = 0.01
"""Smallest standard deviation of a feature [dB]: identical records of a simulation have none."""
FEWEST = 3
"""Smallest number of healthy records with a limit, without operating points."""


@dataclass(frozen=True)
class Deviations:
    """Deviations of one record from the healthy records.

    Attributes
    ----------
    expected, deviation
        Shape (m,). Healthy value at the operating point of the record, and difference of the record [dB].
    spread
        Shape (m,). Standard deviation of the difference of a further healthy record [dB]; NaN if unknown.
    score
        Shape (m,). Deviation over spread [-].
    probability
        Shape (m,). Probability that a single feature of a healthy record deviates as much [-].
    freedom
        Degrees of freedom of the spread [-].
    distance
        Root mean square of all scores [-]: about 1 for a healthy record.
    """

    expected: Array
    deviation: Array
    spread: Array
    score: Array
    probability: Array
    freedom: float
    distance: float


@dataclass(frozen=True)
class HealthyRange:
    """Distances of the healthy records, each from the others.

    Attributes
    ----------
    distances
        Shape (n,). Distances [-].
    limit
        The largest of them [-].
    rate
        Maximum probability that a further healthy record exceeds it [-]: 1/(n + 1).
    """

    distances: Array
    limit: float
    rate: float

    def probability(self, distance: float) -> float:
        """Probability that a healthy record is as far from the others as this [-], not below `rate`.

        Examples
        --------
        >>> HealthyRange(np.array([0.8, 1.2, 1.0]), 1.2, 0.25).probability(1.1)
        0.5
        """
        return float(1 + np.count_nonzero(self.distances >= distance)) * self.rate


def deviations(
    healthy: ArrayLike, record: ArrayLike, points: ArrayLike | None = None, point: ArrayLike | None = None
) -> Deviations:
    """Deviations of the features of a record from those of healthy records.

    Parameters
    ----------
    healthy
        Features of the healthy records [dB], shape (n, m).
    record
        Features of the record [dB], shape (m,).
    points
        Operating points of the healthy records, such as load and speed, any unit, shape (n, c).
    point
        Operating point of the record, shape (c,).

    Returns
    -------
    Deviations
        Deviations of all features; without spread if n ≤ c + 1.

    Raises
    ------
    SignalError
        If the shapes do not match, a value is not finite, or the points do not determine a plane.

    Notes
    -----
    Healthy value by a regression linear in the operating point, residual variance s² with ν = n - 1 - c
    degrees of freedom, variance of the difference s² (1 + h) with the leverage h of the new point [1]_: also
    valid beyond the healthy points, with growing spread. With few records s² is uncertain: it is moderated
    to (ν₀ s₀² + ν s²)/(ν₀ + ν), with ν₀ and s₀² from the distribution of s² over all features [2]_; the
    score then has the t distribution with ν₀ + ν degrees of freedom. Valid for features of equal unit that
    scatter like Gaussian variables. The distance is defined with more features than records; it has no known
    distribution, as features are correlated: see `healthy_range`.

    References
    ----------
    .. [1] N. R. Draper, H. Smith, Applied Regression Analysis, 3rd edition, Wiley, 1998, section 3.
    .. [2] G. K. Smyth, Linear models and empirical Bayes methods for assessing differential expression in
       microarray experiments, Statistical Applications in Genetics and Molecular Biology 3(1), 2004, 3.

    Examples
    --------
    One feature: mean 2, standard deviation 1, n = 3; (5 - 2)/√(1 + 1/3), two degrees of freedom:

    >>> found = deviations([[1.0], [2.0], [3.0]], [5.0])
    >>> found.score.round(4).tolist(), found.probability.round(4).tolist()
    ([2.5981], [0.1217])
    """
    from scipy.stats import t

    y, x = _checked(healthy, record, points, point)
    design = np.c_[np.ones(y.shape[0] - 1), x[:-1]]
    new = np.r_[1.0, x[-1]]
    count, columns = design.shape
    if np.linalg.matrix_rank(design) < columns:
        raise SignalError(
            f"operating points: {count} healthy records do not determine {columns - 1} slopes; omit the "
            "operating points, or add healthy records at others"
        )
    slopes = np.linalg.lstsq(design, y[:-1], rcond=None)[0]
    expected = new @ slopes
    deviation = y[-1] - expected
    nu = count - columns
    if nu < 1:
        nothing = np.full(deviation.size, np.nan)
        return Deviations(expected, deviation, nothing, nothing, nothing, 0.0, float("nan"))
    variance = np.sum((y[:-1] - design @ slopes) ** 2, axis=0) / nu
    moderated, freedom = _moderated(np.maximum(variance, LEAST**2), nu)
    leverage = float(new @ np.linalg.solve(design.T @ design, new))
    spread = np.sqrt(moderated * (1.0 + leverage))
    score = deviation / spread
    probability = 2.0 * t.sf(np.abs(score), freedom)
    distance = float(np.sqrt(np.mean(score**2)))
    return Deviations(expected, deviation, spread, score, probability, freedom, distance)


def healthy_range(healthy: ArrayLike, points: ArrayLike | None = None) -> HealthyRange | None:
    """Limit of the distance from each healthy record compared with the others.

    Parameters
    ----------
    healthy, points
        As in `deviations`, shapes (n, m) and (n, c).

    Returns
    -------
    HealthyRange or None
        Distances and limit; None if the records without one of them have no spread: n < 3 + c.

    Raises
    ------
    SignalError
        As in `deviations`; also if the points do not determine a plane without one of the records.

    Notes
    -----
    If the healthy records and a further one are equivalent, each of the n + 1 is the most distant with equal
    probability, so that the largest of n distances is exceeded in 1/(n + 1) of the cases [1]_, independent of
    the distribution and the correlation of the features. The distances of the healthy records are from n - 1
    others, those of a further one from n; fewer records lead to larger distances, so that the actual rate is
    lower. Valid if the healthy records differ from each other as much as later ones: records of one day do
    not contain changes of temperature, or of the mounting of the sensors.

    References
    ----------
    .. [1] V. Vovk, A. Gammerman, G. Shafer, Algorithmic Learning in a Random World, Springer, 2005.

    Examples
    --------
    >>> found = healthy_range([[0.0], [1.0], [3.0]])
    >>> found.distances.round(3).tolist(), found.rate
    ([1.155, 0.192, 2.887], 0.25)
    """
    y = np.asarray(healthy, dtype=np.float64)
    x = np.empty((y.shape[0], 0)) if points is None else np.asarray(points, dtype=np.float64)
    count = y.shape[0]
    if count < FEWEST + x.shape[1]:
        return None
    distances = []
    for k in range(count):
        others = np.arange(count) != k
        distances.append(deviations(y[others], y[k], x[others], x[k]).distance)
    found: Array = np.array(distances)
    return HealthyRange(found, float(found.max()), 1.0 / (count + 1))


def left_at(distances: ArrayLike, limit: float) -> int | None:
    """Number of the first of two consecutive records above a limit; None if there are none.

    Parameters
    ----------
    distances
        Distances of the records in order [-], shape (n,).
    limit
        Limit [-].

    Notes
    -----
    A run rule [1]_: a single record above a limit with a false-alarm rate of some percent is not evidence.
    Valid for records in the order in which they were made.

    References
    ----------
    .. [1] Western Electric, Statistical Quality Control Handbook, 1956.

    Examples
    --------
    >>> left_at([1.0, 2.1, 1.2, 2.2, 2.5, 2.4], 2.0)
    3
    """
    above = np.asarray(distances, dtype=np.float64) > limit
    both = np.flatnonzero(above[:-1] & above[1:])
    return int(both[0]) if both.size else None


def _checked(
    healthy: ArrayLike, record: ArrayLike, points: ArrayLike | None, point: ArrayLike | None
) -> tuple[Array, Array]:
    """Features and operating points of all records, the record last."""
    y, own = np.asarray(healthy, dtype=np.float64), np.asarray(record, dtype=np.float64)
    if y.ndim != 2 or own.shape != y.shape[1:] or not own.size or not y.shape[0]:
        raise SignalError(
            f"features: shapes {y.shape} and {own.shape} (limit (n, m) and (m,), at least one record and one "
            "feature); use the same features of all records"
        )
    x = np.empty((y.shape[0], 0)) if points is None else np.asarray(points, dtype=np.float64)
    at = np.empty(0) if point is None else np.atleast_1d(np.asarray(point, dtype=np.float64))
    if x.ndim != 2 or x.shape[0] != y.shape[0] or at.shape != x.shape[1:]:
        raise SignalError(
            f"operating points: shapes {x.shape} and {at.shape} (limit ({y.shape[0]}, c) and (c,)); "
            "give the points of all records"
        )
    every, where = np.vstack([y, own]), np.vstack([x, at])
    if not (np.isfinite(every).all() and np.isfinite(where).all()):
        raise SignalError("features: contain NaN or infinite values (limit: finite); omit these features")
    # equal scales of all coordinates
    scale = np.ptp(where, axis=0)
    return every, (where - where.mean(axis=0)) / np.where(scale > 0.0, scale, 1.0)


def _moderated(variance: Array, nu: int) -> tuple[Array, float]:
    """Moderated variances and their degrees of freedom, from the moments of the logarithms."""
    from scipy.special import digamma, polygamma

    if variance.size < 2:
        return variance, float(nu)
    logs = np.log(variance) - digamma(0.5 * nu) + np.log(0.5 * nu)
    beyond = float(logs.var(ddof=1) - polygamma(1, 0.5 * nu))
    if beyond <= 1e-6:
        # equal scatter of all features
        return np.full(variance.size, variance.mean()), float(nu * variance.size)
    prior = 2.0 * _trigamma_inverse(beyond)
    common = float(np.exp(logs.mean() + digamma(0.5 * prior) - np.log(0.5 * prior)))
    return (prior * common + nu * variance) / (prior + nu), prior + nu


def _trigamma_inverse(value: float) -> float:
    """Root x of ψ'(x) = value by Newton's method on 1/ψ', which is convex."""
    from scipy.special import polygamma

    x = 0.5 + 1.0 / value
    for _ in range(50):
        now = float(polygamma(1, x))
        step = now * (1.0 - now / value) / float(polygamma(2, x))
        x += step
        if -step < 1e-10 * x:
            break
    return x
