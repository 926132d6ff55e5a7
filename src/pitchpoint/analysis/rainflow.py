# SPDX-License-Identifier: Apache-2.0
"""Rain-flow cycles of a load, its damage-equivalent load, and its duration over levels."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.analysis.sampled import Array, SignalError, as_signal, positive, same_length, whole
from pitchpoint.core.kernel import kernel

RESIDUES = ("half", "repeated")
"""Open cycles at the end: each range of the residue is half a cycle (ASTM E1049), or the residue is repeated,
so that all of its ranges close (loads that recur)."""

ROUNDING = 1e-14
"""Width of a class over the largest value below which its limits are not distinct."""


@kernel
def _count(values, points, n, cycles):
    """Continue the count: open turning points `points[:n]`, closed (first, last) into `cycles`; n, number."""
    found = 0
    for value in values:
        if n > 0 and value == points[n - 1]:
            continue
        if n > 1 and (value > points[n - 1]) == (points[n - 1] > points[n - 2]):
            points[n - 1] = value  # the same direction continues
        else:
            points[n] = value
            n += 1
        while n > 3:
            inner = abs(points[n - 2] - points[n - 3])
            if inner > abs(points[n - 3] - points[n - 4]) or inner > abs(points[n - 1] - points[n - 2]):
                break
            cycles[found, 0] = points[n - 3]
            cycles[found, 1] = points[n - 2]
            found += 1
            points[n - 3] = points[n - 1]
            n -= 2
    return n, found


class RainflowCounter:
    """Rain-flow count of a load that arrives in parts, by the four-point method.

    A cycle closes when its range is not larger than those before and after it. Open turning points remain
    until later parts close them.

    Examples
    --------
    >>> counter = RainflowCounter()
    >>> for part in ([-2, 1, -3, 5], [-1, 3, -4, 4, -2]):
    ...     counter.add(part)
    >>> counter.closed
    array([[-1.,  3.]])
    >>> counter.open
    array([-2.,  1., -3.,  5., -4.,  4., -2.])
    """

    def __init__(self) -> None:
        self.open: Array = np.zeros(0)
        """Open turning points; the last one may still move."""
        self._closed: list[Array] = []

    def add(self, values: ArrayLike) -> None:
        """Count further samples.

        Parameters
        ----------
        values
            Shape (n,). Samples that follow those counted before.

        Raises
        ------
        SignalError
            If a value is not finite.
        """
        x = as_signal(values, minimum=1)
        points = np.concatenate([self.open, np.empty(x.size)])
        cycles = np.empty((points.size // 2 + 1, 2))
        n, found = _count(x, points, self.open.size, cycles)
        self.open = points[:n].copy()
        self._closed.append(cycles[:found].copy())

    @property
    def closed(self) -> Array:
        """Both turning points of every closed cycle, shape (n, 2), in the order of closing."""
        return np.concatenate(self._closed) if self._closed else np.zeros((0, 2))


@dataclass(frozen=True)
class Rainflow:
    """Cycles of a load.

    Attributes
    ----------
    range
        Shape (n,). Ranges, maximum less minimum, increasing, in the unit of the load.
    mean
        Shape (n,). Mean of maximum and minimum of each cycle.
    count
        Shape (n,). Number of cycles: 1, or 0.5 for an open one.
    equivalent
        Damage-equivalent load: the range of the equivalent constant cycles.
    """

    range: Array
    mean: Array
    count: Array
    equivalent: float


def rainflow(
    values: ArrayLike, slope: float = 4.0, cycles: float | None = None, residue: str = "half"
) -> Rainflow:
    """Rain-flow cycles of a load and its damage-equivalent load.

    Parameters
    ----------
    values
        Shape (n,). Samples of the load, any unit.
    slope
        Exponent m of the Wöhler line: life is proportional to 1/range^m [-].
    cycles
        Number of the equivalent constant cycles; default: that of the counted ones [-].
    residue
        `half`: every range of the residue is half a cycle, as in ASTM E1049; `repeated`: the record recurs,
        and the cycles of the residue close.

    Returns
    -------
    Rainflow

    Raises
    ------
    SignalError
        If a value is not finite, or an option is out of range.

    References
    ----------
    .. [1] ASTM E1049-85, Standard practices for cycle counting in fatigue analysis, 5.4.4.
    .. [2] C. Amzallag, J. P. Gerey, J. L. Robert, J. Bahuaud, Standardization of the rainflow counting method
       for fatigue analysis, International Journal of Fatigue 16, 1994, 287-293 (four-point method).

    Examples
    --------
    The series of ASTM E1049:

    >>> found = rainflow([-2, 1, -3, 5, -1, 3, -4, 4, -2])
    >>> {float(r): float(found.count[found.range == r].sum()) for r in found.range}
    {3.0: 0.5, 4.0: 1.5, 6.0: 0.5, 8.0: 1.0, 9.0: 0.5}
    """
    if residue not in RESIDUES:
        raise SignalError(f"residue: {residue!r} is not one of {', '.join(RESIDUES)}")
    counter = RainflowCounter()
    counter.add(as_signal(values))
    ends, rest = counter.closed, counter.open
    weights = np.ones(len(ends))
    if residue == "repeated" and rest.size > 1:
        again = RainflowCounter()
        again.add(np.concatenate([rest, rest]))
        ends = np.concatenate([ends, again.closed])
        weights = np.ones(len(ends))
    else:
        ends = np.concatenate([ends, np.column_stack([rest[:-1], rest[1:]])])
        weights = np.concatenate([weights, np.full(len(ends) - weights.size, 0.5)])
    ranges = np.abs(ends[:, 1] - ends[:, 0])
    order = np.argsort(ranges, kind="stable")
    ranges, count = ranges[order], weights[order]
    number = float(count.sum()) if cycles is None else positive(cycles, "cycles")
    load = equivalent_load(ranges, count, slope, number) if ranges.size else 0.0
    return Rainflow(ranges, ends[order].mean(axis=1), count, load)


def equivalent_load(ranges: ArrayLike, count: ArrayLike, slope: float, cycles: float) -> float:
    """Range of constant cycles with the same damage as counted ones, by the rule of Palmgren and Miner.

    Parameters
    ----------
    ranges
        Shape (n,). Ranges of the cycles, any unit.
    count
        Shape (n,). Number of cycles of each of them [-].
    slope
        Exponent m of the Wöhler line [-].
    cycles
        Number N of the equivalent cycles [-].

    Notes
    -----
    (Σ n_i R_i^m / N)^(1/m) [1]_; means are not considered.

    References
    ----------
    .. [1] M. A. Miner, Cumulative damage in fatigue, Journal of Applied Mechanics 12, 1945, A159-A164.

    Examples
    --------
    A sine of amplitude 3 with 1000 cycles, over 100 reference cycles:

    >>> round(equivalent_load([6.0], [1000.0], 4.0, 100.0), 6) == round(6.0 * 10**0.25, 6)
    True
    """
    m, n = positive(slope, "slope"), positive(cycles, "cycles")
    r, c = np.asarray(ranges, float), np.asarray(count, float)
    same_length(r, c, "ranges and count")
    largest = float(r.max(initial=0.0))
    if largest == 0.0:
        return 0.0
    return largest * float((c * (r / largest) ** m).sum() / n) ** (1.0 / m)


@dataclass(frozen=True)
class LoadDuration:
    """Duration of a load over its levels.

    Attributes
    ----------
    level
        Shape (bins,). Middle of each class, in the unit of the load.
    share
        Shape (bins,). Share of the whole in each class [-].
    exceeded
        Shape (bins,). Share above the lower limit of each class [-].
    """

    level: Array
    share: Array
    exceeded: Array


def load_duration(values: ArrayLike, weight: ArrayLike | None = None, bins: int = 50) -> LoadDuration:
    """Distribution of a load over classes of equal width between its minimum and maximum.

    Parameters
    ----------
    values
        Shape (n,). Samples of the load, any unit.
    weight
        Shape (n,). Weight of each sample: the time step for a load-duration distribution, the revolutions in
        it for a load-revolution distribution; default: equal weights.
    bins
        Number of classes.

    Examples
    --------
    >>> load_duration([5.0, 5.0, 5.0], bins=4).share
    array([0., 0., 1., 0.])
    >>> load_duration([1.0, 2.0, 3.0, 4.0], [1, 1, 2, 4], bins=2).exceeded
    array([1.  , 0.75])
    """
    x = as_signal(values, minimum=1)
    w = np.ones(x.size) if weight is None else as_signal(weight, "weight", 1)
    same_length(x, w, "values and weight")
    number: NDArray[np.float64]
    number, edges = np.histogram(x, whole(bins, "bins"), _limits(x, bins), weights=w)
    share = number / number.sum()
    return LoadDuration(0.5 * (edges[1:] + edges[:-1]), share, np.cumsum(share[::-1])[::-1])


def _limits(x: Array, bins: int) -> tuple[float, float]:
    """Smallest and largest value; wider for a load that is constant except for rounding."""
    low, high = float(x.min()), float(x.max())
    size = max(abs(low), abs(high))
    if high - low > ROUNDING * bins * size:
        return low, high
    middle, half = 0.5 * (low + high), max(0.5, ROUNDING * bins * size)
    return middle - half, middle + half
