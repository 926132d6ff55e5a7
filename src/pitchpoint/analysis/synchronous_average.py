# SPDX-License-Identifier: Apache-2.0
"""Synchronous (time domain) average of a signal over the revolutions of a shaft.

Components that are periodic in the shaft revolution remain in the average; noise, other shafts and bearings
decrease with the number of revolutions. The average is one exact period, and every order of the shaft is one
line of its Fourier series without leakage: `gear_signals` removes orders exactly.

The remainder of another shaft is known: with the shaft ratio p/q in lowest terms (p revolutions of the other
shaft in q of the averaged one), the other's orders that are multiples of q are also orders of this shaft.
Mesh orders always are; with a whole-number ratio a fault of the pinion is never removed from the average of
the wheel. All others cancel exactly over multiples of q revolutions.

Planets are not supported: they pass the sensor once per carrier revolution, so that their average requires
windows around these passages. Suns, ring gears and carriers are averaged like other shafts, apart from the
modulation by planet passage.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.orders import highest_resolved_order
from pitchpoint.analysis.sampled import Array, SignalError, as_signal, one_way, same_length, whole

AT_ONCE = 1 << 20
"""Maximum number of grid points per spline, to limit memory for long records."""
AROUND = 40
"""Additional samples of a spline on either side; the influence of a sample decreases by a factor of
2 - sqrt(3) per sample, to 1e-23."""


@dataclass(frozen=True)
class SynchronousAverage:
    """Mean revolution of a shaft.

    Attributes
    ----------
    angle
        Shape (n,). Angle of the averaged shaft [rad], 0 to below 2π, in its sense of rotation; zero at the
        zero of the reference angle.
    values
        Shape (n,). Mean of the signal over the revolutions, in its unit.
    averages
        Number of revolutions [-].
    scatter
        RMS deviation of single revolutions from the average, in the unit of the signal; non-periodic
        components remain in the average with scatter/√averages.
    highest_order
        Highest order of the averaged shaft that the record resolves at the highest speed [-].
    """

    angle: Array
    values: Array
    averages: int
    scatter: float
    highest_order: float


def shaft_ratio(*stages: tuple[int, int]) -> Fraction:
    """Revolutions of the last shaft of a gear train per revolution of the first.

    Parameters
    ----------
    stages
        Numbers of teeth (driving, driven) of each mesh in sequence.

    Returns
    -------
    Fraction
        Π z1/z2, unsigned: each shaft is positive in its own sense of rotation.

    Raises
    ------
    SignalError
        If a number of teeth is not a positive whole number.

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
    """Synchronous average of a signal over the revolutions of a shaft.

    Parameters
    ----------
    values, angle
        Signal (any unit) and unwrapped angle of the reference shaft [rad], shape (n,) each; the angle is
        strictly monotonic.
    ratio
        Revolutions of the averaged shaft per revolution of the reference shaft, exact: see `shaft_ratio`.
    samples_per_turn
        Samples of the result [-]; default: next power of two above the samples per revolution of the record
        at the highest speed, which keeps its full bandwidth.

    Returns
    -------
    SynchronousAverage
        Average with scatter and bandwidth.

    Raises
    ------
    SignalError
        If the record has no whole revolution, the shaft stops or reverses, or an input is unsuitable.

    Notes
    -----
    x̄(φ) = (1/N) Σ_k x(φ + 2πk), a comb filter that passes the orders of the shaft [1]_. Cubic spline through
    (angle, value) on a grid at least twice as fine as the record [2]_; the orders below half of
    `samples_per_turn` are kept exactly. All whole revolutions of the record are used. Valid for at least four
    samples per period of the signal (spline error below 1 %); noise decreases by 1/√N.

    References
    ----------
    .. [1] P. D. McFadden, A revised model for the extraction of periodic waveforms by time domain averaging,
       Mechanical Systems and Signal Processing 1(1), 1987, 83-95.
    .. [2] P. D. McFadden, Interpolation techniques for time domain averaging of gear vibration, Mechanical
       Systems and Signal Processing 3(1), 1989, 87-97.

    Examples
    --------
    Order 17 of the shaft remains, order 3.7 is attenuated:

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
    # images of a sampled signal are around its rate: none is aliased on a grid of twice the rate
    fine = n * int(np.ceil(4.0 * highest / n))
    first = int(np.ceil(phi[0] / (2.0 * np.pi) * fine - 1e-6))
    last = int(np.floor(phi[-1] / (2.0 * np.pi) * fine + 1e-6))
    turns = (last - first + 1) // fine
    if turns < 1:
        raise SignalError(
            f"angle: covers {(phi[-1] - phi[0]) / (2.0 * np.pi):.3g} revolutions of the averaged shaft "
            "(limit 1 revolution); use a longer record"
        )
    total, squares = np.zeros(fine), 0.0
    together = max(AT_ONCE // fine, 1)
    for turn in range(turns):
        grid = np.arange(first + turn * fine, first + (turn + 1) * fine) * (2.0 * np.pi / fine)
        grid = np.clip(grid, phi[0], phi[-1])
        if turn % together == 0:  # a spline through the samples of the next revolutions and some around them
            end = grid[0] + 2.0 * np.pi * min(together, turns - turn)
            begin, stop = np.searchsorted(phi, [grid[0], end])
            near = slice(max(begin - AROUND, 0), stop + AROUND)
            curve = CubicSpline(phi[near], x[near])
        one = curve(grid)
        total += one
        squares += float(one @ one)
    # shift so that sample 0 is at the angle zero
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
    """Revolutions of the gear with `z1` teeth until the same teeth meet again [-].

    Parameters
    ----------
    z1, z2
        Numbers of teeth of the gear and of its mate [-].

    Notes
    -----
    z2/gcd(z1, z2) [1]_. Over multiples of this number of revolutions only mesh orders of the mate remain in
    the average of this gear.

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
    """Check that a ratio is an exact fraction; with a rounded decimal the phase would drift."""
    if isinstance(ratio, bool) or not isinstance(ratio, (int, Fraction)) or ratio <= 0:
        raise SignalError(f"ratio: {ratio!r} (limit a fraction above 0); build it from tooth counts")
    return Fraction(ratio)


def _samples(wanted: int | None, highest: float) -> int:
    if wanted is None:
        return int(2 ** np.ceil(np.log2(max(2.0 * highest * (1.0 - 1e-9), 8.0))))
    return whole(wanted, "samples_per_turn", 8)


def _band_limited(period: Array, n: int) -> Array:
    """Resample one period to fewer samples, with unchanged orders below n/2."""
    if n == period.size:
        return period
    lines = np.fft.rfft(period)[: n // 2 + 1]
    if n % 2 == 0:
        lines[-1] = 0.0  # half the rate: a line without a phase
    return np.asarray(np.fft.irfft(lines, n) * (n / period.size), dtype=np.float64)
