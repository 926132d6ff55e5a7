# SPDX-License-Identifier: Apache-2.0
"""Common period of pulsating loads, the points over it, and the harmonics of the loads."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from pitchpoint.solvers.load_cycle import PulsatingLoad

Array = NDArray[np.float64]

TURNS = 2.0 * math.pi
SAME = 1e-9
"""Relative difference up to which rates, torques or speeds count as equal."""
POINTS = 64
"""Points per period of the fastest argument: the mean is exact for harmonics of lower order."""
LEAST = 4096
"""Least number of points in a common period, for tables and formulas with kinks."""
GOLDEN = 0.5 * (5.0**0.5 - 1.0)
"""Added to a number of points per period, so that they have different phases in all periods."""
MAX_CYCLES = 2048
"""Periods of the fastest argument: the longest common period, and the longest mean without one."""
SMALL, MAX_WAVES = 1e-3, 64
"""Amplitude of a harmonic over that of the largest one above which it counts, and the number that count."""


@dataclass(frozen=True)
class Wave:
    """Harmonic of a load: torques Re(torque e^(i rate t)) since the beginning.

    Parameters
    ----------
    rate
        Circular frequency [rad/s].
    torque
        Complex amplitudes on all coordinates, shape (nd,).
    """

    rate: float
    torque: NDArray[np.complex128]


def waves_of(loads: Sequence[PulsatingLoad], values: Mapping[int, Array], period: float) -> tuple[Wave, ...]:
    """Largest harmonics of the loads.

    Parameters
    ----------
    loads
        The loads.
    values
        Their values over the common period [N m]; without one, each load counts at constant speed.
    period
        The common period [s].
    """
    found = []
    for load in loads:
        if not load.rates:
            continue
        over, time = values.get(load.number), period
        if over is None:
            h, points, time = grid_of(np.array(sorted({abs(rate) for rate in load.rates})))
            rest = np.zeros((load.share.size, points))
            over = load.over(np.linspace(0.0, h * (points - 1), points), rest, rest)[0]
        if time > 0.0:
            sizes = 2.0 * np.fft.rfft(over)[1 : (over.size + 1) // 2] / over.size
            found += [(abs(size), TURNS * k / time, size, load.row) for k, size in enumerate(sizes, 1)]
    least = SMALL * max((entry[0] for entry in found), default=0.0)
    found = sorted((entry for entry in found if entry[0] > least), key=lambda entry: -entry[0])
    return tuple(Wave(rate, size * row) for _, rate, size, row in found[:MAX_WAVES])


def grid_of(rates: Array) -> tuple[float, int, float]:
    """Distance [s] and number of points for rates [rad/s] of arguments, and their common period [s] or 0.

    No argument has the same phase at two points: the mean of a load with jumps is then as accurate as that of
    a single period on all points.
    """
    base = common_rate(rates)
    if base > 0.0 and rates[-1] / base <= MAX_CYCLES:
        cycles = [round(float(rate / base)) for rate in rates]
        n = math.ceil(max(LEAST, POINTS * rates[-1] / base))
        while any(math.gcd(n, count) > 1 for count in cycles):
            n += 1
        period = TURNS / base
        return period / n, n, period
    return TURNS / float(rates[-1]) / (POINTS // 2 + GOLDEN), POINTS // 2 * MAX_CYCLES, 0.0


def common_rate(rates: Array) -> float:
    """Rate of the common period of positive rates in increasing order; 0 if their ratios are not rational.

    Examples
    --------
    >>> round(common_rate(np.array([2.0, 5.0])), 12), common_rate(np.array([1.0, 2.0**0.5]))
    (1.0, 0.0)
    """
    multiples = []
    for rate in rates / rates[0]:
        near = Fraction(float(rate)).limit_denominator(MAX_CYCLES)
        if abs(float(near) - rate) > SAME * rate:
            return 0.0
        multiples.append(near.denominator)
    return float(rates[0]) / math.lcm(*multiples)
