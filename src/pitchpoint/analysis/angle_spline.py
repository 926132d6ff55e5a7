# SPDX-License-Identifier: Apache-2.0
"""Angle and speed between tacho pulses by splines that are smoothed to the accuracy of the pulse times."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array, SignalError, as_increasing, as_signal, same_length


def angle_between(
    pulses: ArrayLike, angle: ArrayLike, clock: ArrayLike, *, uncertainty: float = 0.0
) -> tuple[Array, Array]:
    """Angle and speed of a shaft at given times between its pulses.

    Parameters
    ----------
    pulses, angle
        Times [s], increasing, and angles [rad] of the pulses, shape (n,), at least four.
    clock
        Requested times [s], shape (m,).
    uncertainty
        Standard deviation of the pulse times [s]; 0 if they are exact.

    Returns
    -------
    tuple
        Angle [rad] and speed [rad/s], shape (m,) each.

    Raises
    ------
    SignalError
        If there are too few pulses, or channels are unsuitable.

    Notes
    -----
    Exact pulses: interpolating cubic spline. Otherwise the smoothing spline with the fewest knots whose mean
    squared deviation from the pulses agrees with their uncertainty [1]_. The edges of a two-level tacho are
    late by up to a sample, periodic with the beat of pulse rate and sample rate: an interpolating spline
    would modulate the angle with that beat and give every mesh line false sidebands. If the speed of the
    spline changes sign, a monotonic cubic through the pulses is used.

    References
    ----------
    .. [1] C. H. Reinsch, Smoothing by spline functions, Numerische Mathematik 10, 1967, 177-183.

    Examples
    --------
    Pulses sampled on a grid of 1 ms, of a shaft at 10.037 revolutions per second:

    >>> exact = np.arange(500) / 100.37
    >>> read = np.ceil(exact * 1000.0) / 1000.0
    >>> turned, _ = angle_between(read, 0.2 * np.pi * np.arange(500), exact, uncertainty=1e-3 / 12**0.5)
    >>> late = turned - 0.2 * np.pi * np.arange(500)
    >>> bool(np.std(late) < 0.1 * 63.1 * 1e-3 / 12**0.5)
    True
    """
    from scipy.interpolate import CubicSpline, PchipInterpolator, UnivariateSpline

    at, turned, asked = (
        as_increasing(pulses, "pulses"),
        as_signal(angle, "angle"),
        as_signal(clock, "clock", 1),
    )
    same_length(at, turned, "pulses, angle")
    if at.size < 4:
        raise SignalError(f"pulses: are {at.size} (limit 4); use a longer record")
    if uncertainty > 0.0:
        mean_speed = (turned[-1] - turned[0]) / (at[-1] - at[0])
        weight = np.full(at.size, 1.0 / (uncertainty * mean_speed))
        # squared uniform deviations have mean 1 and variance 0.8; allow three standard deviations of the sum
        misfit = at.size + 3.0 * math.sqrt(0.8 * at.size)
        curve = UnivariateSpline(at, turned, w=weight, k=3, s=misfit)
        found, speed = curve(asked), curve(asked, 1)
    else:
        smooth = CubicSpline(at, turned)
        found, speed = smooth(asked), smooth(asked, 1)
    if float(np.min(speed)) > 0.0:
        return np.asarray(found), np.asarray(speed)
    forward = PchipInterpolator(at, turned)
    return np.asarray(forward(asked)), np.asarray(forward(asked, 1))


def edge_uncertainty(before: ArrayLike, after: ArrayLike, low: float, high: float, step: float) -> float:
    """Standard deviation of edge times from linear interpolation between two samples.

    Parameters
    ----------
    before, after
        Last sample below and first sample above the trigger level at every edge, shape (n,), any unit.
    low, high
        Minimum and maximum of the channel, same unit.
    step
        Sampling interval [s].

    Returns
    -------
    float
        Standard deviation [s]: 0 if most edges have a sample on the slope, at least a tenth of the range from
        either end; otherwise that of a uniform distribution between two samples, step/sqrt(12) [1]_.

    References
    ----------
    .. [1] B. Widrow, I. Kollár, Quantization Noise, Cambridge University Press, 2008.

    Examples
    --------
    >>> edge_uncertainty([0.0, 0.0], [1.0, 1.0], 0.0, 1.0, 1e-3) == 1e-3 / 12**0.5
    True
    >>> edge_uncertainty([0.2, 0.3], [1.0, 1.0], 0.0, 1.0, 1e-3)
    0.0
    """
    tenth = 0.1 * (high - low)
    on_flank = (as_signal(before, "before", 1) >= low + tenth) | (
        as_signal(after, "after", 1) <= high - tenth
    )
    return 0.0 if 2 * int(on_flank.sum()) >= on_flank.size else step / math.sqrt(12.0)
