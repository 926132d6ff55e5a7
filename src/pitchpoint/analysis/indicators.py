# SPDX-License-Identifier: Apache-2.0
"""Level and impulsiveness of a signal: RMS, peak, kurtosis, crest, shape and impulse factor.

All indicators are those of the alternating part: the mean is removed first. Samples have equal weight, so the
record must be sampled uniformly over time or angle. `statistics` uses time weights instead.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array, SignalError, as_signal

ROUND_OFF = 1e-13
"""Alternating part relative to the largest value below which it is only round-off."""


@dataclass(frozen=True)
class SignalIndicators:
    """Level and shape indicators of a signal without its mean.

    Attributes
    ----------
    rms, peak, peak_to_peak
        RMS, maximum magnitude, and range, in the unit of the signal.
    kurtosis
        Fourth moment over the square of the second [-]: 3 for Gaussian noise, 1.5 for a sine.
    crest_factor
        peak/rms [-].
    shape_factor
        rms over mean magnitude [-].
    impulse_factor
        peak over mean magnitude [-].
    """

    rms: float
    peak: float
    peak_to_peak: float
    kurtosis: float
    crest_factor: float
    shape_factor: float
    impulse_factor: float


def signal_indicators(values: ArrayLike) -> SignalIndicators:
    """Level and shape indicators of a signal.

    Parameters
    ----------
    values
        Uniform samples, shape (n,), any unit.

    Returns
    -------
    SignalIndicators
        Levels in the unit of the signal, dimensionless shape factors.

    Raises
    ------
    SignalError
        If the signal is constant, or not finite.

    Notes
    -----
    With y = x - x̄: rms² = mean(y²), kurtosis = mean(y⁴)/mean(y²)² [1]_; crest, shape and impulse factor
    as in [2]_. Valid for whole periods, or for records much longer than a period.

    References
    ----------
    .. [1] D. Dyer, R. M. Stewart, Detection of rolling element bearing damage by statistical vibration
       analysis, Journal of Mechanical Design 100(2), 1978, 229-235.
    .. [2] R. B. Randall, Vibration-based Condition Monitoring, Wiley, 2011, chapter 5.

    Examples
    --------
    A sine has crest √2, shape π/(2√2), impulse factor π/2:

    >>> s = signal_indicators(5.0 + np.cos(2 * np.pi * np.arange(10_000) / 10_000))
    >>> [round(v, 6) for v in (s.rms, s.kurtosis, s.crest_factor, s.shape_factor, s.impulse_factor)]
    [0.707107, 1.5, 1.414214, 1.110721, 1.570796]
    """
    y = alternating_part(values, "values")
    magnitude = np.abs(y)
    rms = float(np.sqrt(np.mean(y * y)))
    peak, mean = float(magnitude.max()), float(magnitude.mean())
    return SignalIndicators(
        rms=rms,
        peak=peak,
        peak_to_peak=float(np.ptp(y)),
        kurtosis=standardised_moment(values, 4),
        crest_factor=peak / rms,
        shape_factor=rms / mean,
        impulse_factor=peak / mean,
    )


def standardised_moment(values: ArrayLike, order: int) -> float:
    """Central moment of a signal over the same power of its standard deviation [-].

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    order
        Order k of the moment [-], even; 4 is the kurtosis (FM4 of a difference signal), 6 is M6A, 8 is M8A.

    Returns
    -------
    float
        m_k/m_2^(k/2).

    Raises
    ------
    SignalError
        If the signal is constant, or the order is not an even number of at least 4.

    Notes
    -----
    m_k = mean((x - x̄)^k) [1]_. Gaussian noise: (k - 1)!! = 3, 15, 105; sine: 1.5, 2.5, 35/8; one impulse in
    n samples, with p = 1/n: (1 - p)((1 - p)^(k-1) + p^(k-1)) p/(p (1 - p))^(k/2). Valid for any signal; high
    moments have a large scatter in short records.

    References
    ----------
    .. [1] H. R. Martin, Statistical moment analysis as a means of surface damage detection, Proceedings of
       the 7th International Modal Analysis Conference, 1989, 1016-1021.

    Examples
    --------
    >>> sine = np.sin(2 * np.pi * np.arange(64) / 64)
    >>> [round(standardised_moment(sine, k), 9) for k in (4, 6, 8)]
    [1.5, 2.5, 4.375]
    """
    if order != int(order) or order < 4 or order % 2:
        raise SignalError(f"order: {order} (limit an even number from 4 on)")
    y = alternating_part(values, "values")
    # scale by the maximum first: eighth powers of small values would underflow
    squares = (y / np.abs(y).max()) ** 2
    return float(np.mean(squares ** (int(order) // 2)) / np.mean(squares) ** (int(order) // 2))


def alternating_part(values: ArrayLike, name: str) -> Array:
    """Signal without its mean; raises if the signal is constant.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    name
        Name of the signal in error messages.

    Raises
    ------
    SignalError
        If the signal is constant, or not a finite vector.

    Examples
    --------
    >>> alternating_part([1.0, 3.0], "values")
    array([-1.,  1.])
    """
    x = as_signal(values, name)
    y = x - x.mean()
    if float(np.abs(y).max()) <= ROUND_OFF * float(np.abs(x).max()):
        raise SignalError(f"{name}: is constant at {x[0]:g}, it has no shape; check the channel")
    return y
