# SPDX-License-Identifier: Apache-2.0
"""Average of a signal over the turns of a shaft.

What repeats with every turn of the shaft stays in the average; noise, other shafts and bearings fall with the
number of turns. The average is one exact period, so every order of the shaft is one line of its Fourier
series, without leakage: `gear_signals` takes orders out of it exactly.

What stays of another shaft is exact too: with shaft ratio p/q in lowest terms (q turns of the averaged shaft
hold p turns of the other), the other's orders that are multiples of q are orders of this shaft as well. Mesh
orders always are, and with a whole-number ratio a fault of the slow wheel's mate never leaves the average of
the slow wheel. All others cancel exactly over whole multiples of q turns.

Planets of a planetary set are beyond this module: they pass the sensor only once per turn of the carrier, so
their average needs windows about these passages. Suns, rings and carriers are shafts like any other, but for
the modulation by the passing planets.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.orders import highest_resolved_order, one_way
from pitchpoint.analysis.sampled import Array, SignalError, as_signal, same_length, whole

AT_ONCE = 1 << 20
"""Points of the grid for which one spline is made: that of a long record would take most of the memory."""
AROUND = 40
"""Samples around them that it needs: the influence of a sample falls by 2 - sqrt(3) with each, to 1e-23."""


@dataclass(frozen=True)
class SynchronousAverage:
    """One mean turn of a shaft.

    Attributes
    ----------
    angle
        Shape (n,). Angle of the averaged shaft [rad], 0 to below 2π, in its sense of rotation; zero where the
        reference angle is.
    values
        Shape (n,). Mean of the signal over the turns, in its unit.
    averages
        Number of turns [-].
    scatter
        Rms of what single turns differ from the average by, in the unit of the signal; what does not repeat
        is still in the average with scatter/√averages.
    highest_order
        Highest order of the averaged shaft that the record resolved where it turned fastest [-].
    """

    angle: Array
    values: Array
    averages: int
    scatter: float
    highest_order: float


def shaft_ratio(*stages: tuple[int, int]) -> Fraction:
    """Turns of the last shaft of a gear train in one turn of the first.

    Parameters
    ----------
    stages
        For each mesh on the way the tooth counts (driving, driven) as they follow each other.

    Returns
    -------
    Fraction
        Π z1/z2, without sign: each shaft counts its turns in its own sense of rotation.

    Raises
    ------
    SignalError
        If a tooth count is not a positive whole number.

    Notes
    -----
    i = z2/z1 for one stage [1]_. Valid for trains with fixed axes.

    References
    ----------
    .. [1] ISO 21771-1:2024, gear ratio.

    Examples
    --------
    Two stages 32/96 and 48/80:

    >>> shaft_ratio((32, 96), (48, 80))
    Fraction(1, 5)
    """
    ratio = Fraction(1)
    for z1, z2 in stages:
        ratio *= Fraction(whole(z1, "tooth count"), whole(z2, "tooth count"))
    return ratio


def synchronous_average(
    values: ArrayLike,
    angle: ArrayLike,
    *,
    ratio: Fraction | int = 1,
    samples_per_turn: int | None = None,
) -> SynchronousAverage:
    """Mean turn of a shaft.

    Parameters
    ----------
    values, angle
        Signal (any unit) and unwrapped angle of the reference shaft [rad], shape (n,) each; the angle is
        strictly monotonic.
    ratio
        Turns of the averaged shaft per turn of the reference shaft, exact: see `shaft_ratio`.
    samples_per_turn
        Samples of the result [-]; default the power of two next above what the record holds in a turn where
        it turns fastest, so that nothing that it resolves is lost.

    Returns
    -------
    SynchronousAverage
        The average and how far it can be trusted.

    Raises
    ------
    SignalError
        If the record holds no whole turn, the shaft stops or turns back, or an input is unsuitable.

    Notes
    -----
    x̄(φ) = (1/N) Σ_k x(φ + 2πk), a comb filter that lets the orders of the shaft through [1]_. Cubic spline
    through (angle, value) on a grid at least twice as fine as the record [2]_; of the average only the
    orders below half of `samples_per_turn` are kept, exactly. As many whole turns as the record holds.
    Valid where the signal has four or more samples per period (spline error below 1 %); the rate of noise is
    1/√N.

    References
    ----------
    .. [1] P. D. McFadden, A revised model for the extraction of periodic waveforms by time domain averaging,
       Mechanical Systems and Signal Processing 1(1), 1987, 83-95.
    .. [2] P. D. McFadden, Interpolation techniques for time domain averaging of gear vibration, Mechanical
       Systems and Signal Processing 3(1), 1989, 87-97.

    Examples
    --------
    Order 17 of the shaft stays, order 3.7 falls:

    >>> angle = np.linspace(0.0, 2 * np.pi * 100, 100 * 256 + 1)
    >>> mean = synchronous_average(np.cos(17 * angle) + np.cos(3.7 * angle), angle)
    >>> mean.averages, mean.values.size
    (100, 256)
    >>> bool(np.abs(mean.values - np.cos(17 * mean.angle)).max() < 2e-3)
    True
    """
    from scipy.interpolate import CubicSpline

    x = as_signal(values, "values", 8)
    phi = as_signal(angle, "angle", 8)
    same_length(x, phi, "values, angle")
    turns_per_reference = _exact(ratio)
    phi = one_way(phi) * float(turns_per_reference)
    highest = highest_resolved_order(phi)
    n = _samples(samples_per_turn, highest)
    # images of a sampled signal lie about its own rate: a grid of twice the rate takes none of them in
    fine = n * int(np.ceil(4.0 * highest / n))
    first = int(np.ceil(phi[0] / (2.0 * np.pi) * fine - 1e-6))
    last = int(np.floor(phi[-1] / (2.0 * np.pi) * fine + 1e-6))
    turns = (last - first + 1) // fine
    if turns < 1:
        raise SignalError(
            f"angle: the shaft turns {(phi[-1] - phi[0]) / (2.0 * np.pi):.3g} revolutions "
            "(limit 1 whole turn); use a longer record"
        )
    total, squares = np.zeros(fine), 0.0
    together = max(AT_ONCE // fine, 1)
    for turn in range(turns):
        grid = np.arange(first + turn * fine, first + (turn + 1) * fine) * (2.0 * np.pi / fine)
        grid = np.clip(grid, phi[0], phi[-1])
        if turn % together == 0:  # a spline through the samples of the next turns and some around them
            end = grid[0] + 2.0 * np.pi * min(together, turns - turn)
            begin, stop = np.searchsorted(phi, [grid[0], end])
            near = slice(max(begin - AROUND, 0), stop + AROUND)
            curve = CubicSpline(phi[near], x[near])
        one = curve(grid)
        total += one
        squares += float(one @ one)
    # sample 0 belongs to the angle zero, wherever the record begins
    mean = np.roll(total / turns, first % fine)
    scatter = np.sqrt(max(squares / (turns * fine) - float(mean @ mean) / fine, 0.0))
    return SynchronousAverage(
        angle=np.arange(n, dtype=np.float64) * (2.0 * np.pi / n),
        values=_band_limited(mean, n),
        averages=turns,
        scatter=float(scatter),
        highest_order=highest,
    )


def hunting_turns(z1: int, z2: int) -> int:
    """Turns of the gear with `z1` teeth until the same teeth meet again [-].

    Parameters
    ----------
    z1, z2
        Tooth counts of the gear and of its mate [-].

    Notes
    -----
    z2/gcd(z1, z2) [1]_. Over whole multiples of so many turns the mate leaves nothing in the average of this
    gear but orders of the mesh.

    References
    ----------
    .. [1] G. Maitra, Handbook of Gear Design, Tata McGraw-Hill, 1994, hunting tooth.

    Examples
    --------
    >>> hunting_turns(17, 38), hunting_turns(32, 96)
    (38, 3)
    """
    return shaft_ratio((z1, z2)).denominator


def _exact(ratio: Fraction | int) -> Fraction:
    """The ratio as a fraction; a rounded decimal number would let the phase drift away."""
    if isinstance(ratio, bool) or not isinstance(ratio, (int, Fraction)) or ratio <= 0:
        raise SignalError(f"ratio: {ratio!r} (limit a fraction above 0); build it from tooth counts")
    return Fraction(ratio)


def _samples(wanted: int | None, highest: float) -> int:
    if wanted is None:
        return int(2 ** np.ceil(np.log2(max(2.0 * highest * (1.0 - 1e-9), 8.0))))
    return whole(wanted, "samples_per_turn", 8)


def _band_limited(period: Array, n: int) -> Array:
    """One period on fewer samples, its orders below n/2 unchanged."""
    if n == period.size:
        return period
    lines = np.fft.rfft(period)[: n // 2 + 1]
    if n % 2 == 0:
        lines[-1] = 0.0  # half the rate: a line without a phase
    return np.asarray(np.fft.irfft(lines, n) * (n / period.size), dtype=np.float64)
