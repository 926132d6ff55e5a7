# SPDX-License-Identifier: Apache-2.0
"""Angle and speed between the pulses of a tacho: a curve no rougher than their times are known."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array, SignalError, as_increasing, as_signal, same_length


def angle_between(
    pulses: ArrayLike, angle: ArrayLike, clock: ArrayLike, *, uncertainty: float = 0.0
) -> tuple[Array, Array]:
    """Angle and speed of a shaft at any times between its pulses.

    Parameters
    ----------
    pulses, angle
        Times [s], increasing, and angles [rad] of the pulses, shape (n,), four at least.
    clock
        Times that are requested [s], shape (m,).
    uncertainty
        Standard deviation of the times of the pulses [s]; 0 if they are exact.

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
    Exact pulses: cubic spline through them. Else the cubic spline with the fewest knots whose mean squared
    distance from the pulses is what their uncertainty explains [1]_. A tacho of two levels is late by up to a
    sample, and by how much repeats with the beat of both rates: a spline through such pulses turns the shaft
    to and fro in that beat, and every mesh line gets sidebands that no machine has. Where a spline would turn
    back, a monotonic cubic through the pulses.

    References
    ----------
    .. [1] C. H. Reinsch, Smoothing by spline functions, Numerische Mathematik 10, 1967, 177-183.

    Examples
    --------
    Pulses that are read on a grid of 1 ms, of a shaft that makes 10.037 turns per second:

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
        # squares of a uniform distribution: mean 1 and variance 0.8, three deviations of their sum allowed
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
    """How far the times of edges may be off that a straight line between two samples gives.

    Parameters
    ----------
    before, after
        Last sample below and first sample above the middle at every edge, shape (n,), any unit.
    low, high
        Least and largest value of the channel, same unit.
    step
        Distance of samples [s].

    Returns
    -------
    float
        Standard deviation [s]: 0 where most edges have a sample on the flank, a tenth of the range or more
        from either end; else that of anywhere between two samples, step/sqrt(12) [1]_.

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
