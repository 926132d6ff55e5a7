# SPDX-License-Identifier: Apache-2.0
"""Angle and speed of a shaft from tacho pulses, or from an angle channel of a simulation or an encoder.

A tacho gives the angle at its pulses only. Pulses may be missing or doubled, and each such error shifts all
later angles. The pulses are therefore compared with the local speed first: missing and surplus pulses are
corrected and reported, and a channel that is not a pulse train is rejected.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.analysis.angle_spline import angle_between, edge_uncertainty
from pitchpoint.analysis.sampled import (
    Array,
    SignalError,
    as_increasing,
    as_signal,
    one_way,
    same_length,
    whole,
)

HYSTERESIS = 0.25
"""Hysteresis of the trigger below the middle of the range, over the range."""
WINDOW = 9
"""Number of pulse intervals from which the local speed is estimated."""
MIN_PULSES = 4
SHORT, LONG = 0.7, 1.5
"""Angle of an interval, in pulse pitches, below which a pulse may be surplus, above which one is missing."""
LONGEST_GAP = 4
"""Longest interval that is bridged, in pulse pitches; for longer gaps the number of pulses is uncertain."""
LARGEST_MISFIT = 0.2
"""Maximum share of missing, surplus or displaced pulses of a pulse train."""


@dataclass(frozen=True)
class ShaftAngle:
    """Angle and speed of a shaft over the part of a record for which they are known.

    Attributes
    ----------
    time, angle, speed
        Shape (n,). Times of the samples [s], unwrapped angle [rad], speed [rad/s]. From a tacho the angle is
        zero at the first pulse.
    first_sample
        Index of the first of these samples in the record [-]; the samples of another channel at these times
        are `values[first_sample : first_sample + n]`.
    pulse_time, pulse_angle
        Shape (n_pulse,). Times [s] and angles [rad] of the pulses used; empty for an angle channel.
    missing
        Shape (n_missing,). Times of missing pulses [s].
    doubled
        Shape (n_doubled,). Times of surplus edges that were omitted [s].
    """

    time: Array
    angle: Array
    speed: Array
    first_sample: int
    pulse_time: Array
    pulse_angle: Array
    missing: Array
    doubled: Array


def rising_edges(values: ArrayLike, time: ArrayLike, *, hysteresis: float = HYSTERESIS) -> Array:
    """Times at which a pulse signal rises through the middle of its range.

    Parameters
    ----------
    values, time
        Tacho signal (any unit) and times [s], shape (n,) each.
    hysteresis
        Distance below the middle, over the range, to which the signal must fall before the next edge [-],
        0 ... 0.5.

    Returns
    -------
    NDArray
        Times of the edges [s], shape (n_edge,), by linear interpolation between samples.

    Raises
    ------
    SignalError
        If the signal is constant, or the channels are unsuitable.

    Notes
    -----
    Comparator with hysteresis after O. H. Schmitt [1]_. Valid for pulses of at least two samples; a two-level
    signal without a sample on the slope gives times to half a sample.

    References
    ----------
    .. [1] O. H. Schmitt, A thermionic trigger, Journal of Scientific Instruments 15(1), 1938, 24-26.

    Examples
    --------
    >>> rising_edges([0.0, 0.2, 1.0, 1.0, 0.4, 0.6, 0.0, 0.0, 1.0], np.arange(9.0)).round(4)
    array([1.375, 7.5  ])
    """
    return _edges(values, time, hysteresis)[0]


def _edges(values: ArrayLike, time: ArrayLike, hysteresis: float) -> tuple[Array, float]:
    """Times of rising edges, and their standard deviation [s]."""
    x = as_signal(values, "tacho")
    clock = as_increasing(time, "time")
    same_length(x, clock, "tacho, time")
    if not 0.0 <= hysteresis < 0.5:
        raise SignalError(f"hysteresis: {hysteresis} (limit 0 to below 0.5)")
    low, high = float(x.min()), float(x.max())
    if high <= low:
        raise SignalError(
            f"tacho: is constant at {low:g}, it has no pulses; check the channel and its sensor"
        )
    middle = 0.5 * (low + high)
    above, below = x >= middle, x < middle - hysteresis * (high - low)
    decided = np.flatnonzero(above | below)
    rises = decided[1:][above[decided[1:]] & below[decided[:-1]]]
    step = (middle - x[rises - 1]) / (x[rises] - x[rises - 1])
    edges: Array = clock[rises - 1] + step * (clock[rises] - clock[rises - 1])
    if not rises.size:
        return edges, 0.0
    sample = float(np.median(np.diff(clock)))
    return edges, edge_uncertainty(x[rises - 1], x[rises], low, high, sample)


def tacho_angle(
    values: ArrayLike, time: ArrayLike, *, pulses_per_revolution: int, hysteresis: float = HYSTERESIS
) -> ShaftAngle:
    """Angle and speed of a shaft from a tacho with evenly spaced pulses.

    Parameters
    ----------
    values, time
        Tacho signal (any unit) and times [s], shape (n,) each.
    pulses_per_revolution
        Pulses per revolution of the shaft [-].
    hysteresis
        See `rising_edges`.

    Returns
    -------
    ShaftAngle
        For the samples between the first and the last pulse.

    Raises
    ------
    SignalError
        If there are fewer than four pulses, a gap is longer than four pulses (the shaft was at rest or the
        sensor failed), or more than a fifth of the pulses do not fit an even train.

    Notes
    -----
    Expected speed of an interval: line through (midpoint, 1/duration) of nine intervals around it by the
    median of all slopes [1]_, which is exact for constant acceleration and insensitive to single bad pulses.
    The number of pulses of an interval is speed × duration, rounded. At either end of the record a gap cannot
    be distinguished from a slow start: intervals that do not fit are cut off there. Angle: cubic spline
    through the pulses, within the uncertainty of their edges (see `angle_spline.angle_between`); speed: its
    derivative [2]_. Valid if the speed changes little from pulse to pulse; variations within one interval are
    not resolved.

    References
    ----------
    .. [1] P. K. Sen, Estimates of the regression coefficient based on Kendall's tau, Journal of the American
       Statistical Association 63, 1968, 1379-1389.
    .. [2] K. R. Fyfe, E. D. S. Munck, Analysis of computed order tracking, Mechanical Systems and Signal
       Processing 11(2), 1997, 187-205.

    Examples
    --------
    Ten revolutions per second, four pulses per revolution, one of them missing:

    >>> t = np.arange(20_000) / 10_000.0
    >>> pulses = np.clip(3.0 * np.sin(80 * np.pi * t), -1.0, 1.0)
    >>> pulses[(t > 0.74) & (t < 0.76)] = -1.0
    >>> shaft = tacho_angle(pulses, t, pulses_per_revolution=4)
    >>> shaft.missing.round(4), round(float(shaft.angle[-1] / (2 * np.pi)), 3)
    (array([0.75]), 19.5)
    >>> bool(np.abs(shaft.speed - 20 * np.pi).max() < 1e-6)
    True
    """
    ppr = whole(pulses_per_revolution, "pulses_per_revolution")
    edges, uncertainty = _edges(values, time, hysteresis)
    if edges.size < MIN_PULSES:
        raise SignalError(
            f"tacho: has {edges.size} pulses (limit {MIN_PULSES}); use a longer record or check the channel"
        )
    pulses, doubled = _without_doubles(edges)
    pulses, share = _without_bad_ends(pulses)
    _refuse_no_train(pulses, share, edges.size)
    # a short interval without a surplus pulse is one pulse
    counts = np.maximum(np.rint(share), 1.0)
    number = np.concatenate(([0.0], np.cumsum(counts)))
    gaps = [
        np.linspace(pulses[i], pulses[i + 1], int(counts[i]) + 1)[1:-1] for i in np.flatnonzero(counts > 1.0)
    ]
    pulse_angle = 2.0 * np.pi / ppr * number
    clock = as_increasing(time, "time")
    inside = np.flatnonzero((clock >= pulses[0]) & (clock <= pulses[-1]))
    if inside.size < 2:
        raise SignalError("tacho: has fewer than two samples between its pulses; raise the sample rate")
    angle, speed = angle_between(pulses, pulse_angle, clock[inside], uncertainty=uncertainty)
    return ShaftAngle(
        time=clock[inside],
        angle=angle,
        speed=speed,
        first_sample=int(inside[0]),
        pulse_time=pulses,
        pulse_angle=pulse_angle,
        missing=np.concatenate(gaps) if gaps else np.empty(0),
        doubled=doubled,
    )


def angle_channel(angle: ArrayLike, time: ArrayLike) -> ShaftAngle:
    """Angle and speed from an angle channel, simulated or from an encoder.

    Parameters
    ----------
    angle, time
        Angle [rad] and times [s], shape (n,) each. An angle within one revolution is treated as wrapped.

    Returns
    -------
    ShaftAngle
        For every sample of the record.

    Raises
    ------
    SignalError
        If the angle is constant, or the channels are unsuitable.

    Notes
    -----
    Speed by finite differences of second order, for any spacing [1]_. Valid for more than two samples per
    revolution.

    References
    ----------
    .. [1] A. Quarteroni, R. Sacco, F. Saleri, Numerical Mathematics, Springer, 2007, section 10.10.

    Examples
    --------
    >>> t = np.arange(1000) / 1000.0
    >>> shaft = angle_channel(np.mod(2 * np.pi * 30 * t, 2 * np.pi), t)
    >>> round(float(shaft.angle[-1]), 6), round(float(shaft.speed[500] / (2 * np.pi)), 6)
    (188.307064, 30.0)
    """
    phi = as_signal(angle, "angle", 3)
    clock = as_increasing(time, "time", 3)
    same_length(phi, clock, "angle, time")
    span = float(np.ptp(phi))
    if span == 0.0:
        raise SignalError(f"angle: is constant at {phi[0]:g} rad; the shaft does not rotate")
    # unwrapping a record within one revolution changes a sawtooth only
    if span <= 2.0 * np.pi * (1.0 + 1e-9):
        phi = np.unwrap(phi)
    none = np.empty(0)
    return ShaftAngle(clock, phi, np.gradient(phi, clock, edge_order=2), 0, none, none, none, none)


def pulse_train(angle: ArrayLike, *, pulses_per_revolution: int) -> Array:
    """Tacho signal of a shaft angle, as from a sensor with an anti-aliasing filter.

    Parameters
    ----------
    angle
        Unwrapped angle [rad], shape (n,), strictly monotonic.
    pulses_per_revolution
        Pulses per revolution [-]; each is high over the first half of its pitch.

    Returns
    -------
    NDArray
        Signal between 0 and 1, shape (n,).

    Raises
    ------
    SignalError
        If the shaft stops, reverses, or rotates more than half a pulse pitch within one sample.

    Notes
    -----
    A sample is the mean of the pulse signal over the angle from half-way to the preceding sample to half-way
    to the next (box filter [1]_), so that the position of an edge between two samples can be recovered.

    References
    ----------
    .. [1] A. V. Oppenheim, R. W. Schafer, Discrete-Time Signal Processing, Prentice Hall, 1999, chapter 4.

    Examples
    --------
    >>> pulse_train(2 * np.pi * np.arange(9) / 8, pulses_per_revolution=1).round(3)
    array([0.5, 1. , 1. , 1. , 0.5, 0. , 0. , 0. , 0.5])
    """
    phi = as_signal(angle, "angle", 3)
    ppr = whole(pulses_per_revolution, "pulses_per_revolution")
    steps = np.diff(phi)
    if float(np.diff(one_way(phi)).max()) * ppr > np.pi:
        raise SignalError(
            f"angle: rotates more than half a pitch of {ppr} pulses per revolution within one sample; "
            "raise the sample rate or use fewer pulses"
        )
    half = 0.5 * steps
    ends = np.concatenate(([phi[0] - half[0]], phi[:-1] + half, [phi[-1] + half[-1]])) * ppr / (2.0 * np.pi)
    pitches = np.floor(ends)
    # integral of a pulse train of unit pitch that is high over the first half
    integral = 0.5 * pitches + np.minimum(ends - pitches, 0.5)
    signal: Array = np.diff(integral) / np.diff(ends)
    return signal


def _pulses_in(edges: Array) -> Array:
    """Expected number of pulses of each interval from the local speed [-]."""
    duration = np.diff(edges)
    middle, speed = edges[:-1] + 0.5 * duration, 1.0 / duration
    size = min(WINDOW, duration.size)
    first = np.clip(np.arange(duration.size) - size // 2, 0, duration.size - size)
    around = first[:, None] + np.arange(size)
    a, b = np.triu_indices(size, 1)
    v, m = speed[around], middle[around] - middle[:, None]
    slope = np.median((v[:, b] - v[:, a]) / (m[:, b] - m[:, a]), axis=1)
    expected: Array = np.median(v - slope[:, None] * m, axis=1) * duration
    return expected


def _without_doubles(edges: Array) -> tuple[Array, Array]:
    """Edges without surplus ones that split an interval in two, and the surplus edges."""
    left_out: list[Array] = []
    while edges.size > MIN_PULSES:
        share, duration = _pulses_in(edges), np.diff(edges)
        inner = duration[1:-1]
        # of a split interval, the longer part may fit by chance, the shorter part does not
        short = (share[1:-1] < SHORT) & (inner <= duration[:-2]) & (inner <= duration[2:])
        surplus = _surplus_edges(share, np.flatnonzero(short) + 1)
        if surplus.size == 0:
            break
        left_out.append(edges[surplus])
        edges = np.delete(edges, surplus)
    return edges, np.sort(np.concatenate(left_out)) if left_out else np.empty(0)


def _surplus_edges(share: Array, short: NDArray[np.intp]) -> NDArray[np.intp]:
    """Surplus edge of each short interval: start or end, whichever removal fits the neighbours best."""
    found: list[int] = []
    for i in short:
        if found and i - found[-1] < WINDOW // 2:
            continue  # checked again after removal of the preceding one
        before, here, after = (float(share[k]) for k in (i - 1, i, i + 1))
        start = _misfit(before + here) + _misfit(after)
        end = _misfit(before) + _misfit(here + after)
        # remove the edge only if it halves the total misfit
        if min(start, end) < 0.5 * (_misfit(before) + _misfit(here) + _misfit(after)):
            found.append(int(i) if start <= end else int(i) + 1)
    return np.array(found, dtype=np.intp)


def _misfit(share: float) -> float:
    """Distance from a whole number of pulses."""
    return abs(share - max(1.0, round(share)))


def _without_bad_ends(pulses: Array) -> tuple[Array, Array]:
    """Pulses without unsuitable intervals at either end, and the number of pulses of each interval."""
    share = _pulses_in(pulses)
    good = np.flatnonzero((share >= SHORT) & (share <= LONG))
    if good.size:
        pulses, share = pulses[good[0] : good[-1] + 2], share[good[0] : good[-1] + 1]
    return pulses, share


def _refuse_no_train(pulses: Array, share: Array, edges: int) -> None:
    """Raise for long gaps, and for channels that are not an even train of pulses."""
    # surplus, cut off at the ends, or in an interval that is too long or too short
    wrong = edges - pulses.size + int(np.count_nonzero(np.abs(share - 1.0) > 1.0 - SHORT))
    if wrong > max(1.0, LARGEST_MISFIT * edges) or pulses.size < MIN_PULSES - 1:
        raise SignalError(
            f"tacho: {wrong} of {edges} pulses are missing, doubled or displaced "
            f"(limit {LARGEST_MISFIT:.0%}): this is not an even train of pulses; check channel and threshold"
        )
    gap = int(np.argmax(share))
    if share[gap] > LONGEST_GAP + 0.5:
        raise SignalError(
            f"tacho: no pulse from {pulses[gap]:.6g} s to {pulses[gap + 1]:.6g} s, where {share[gap]:.3g} "
            f"were expected (limit {LONGEST_GAP}): the shaft was at rest or the sensor failed; "
            "cut the record there"
        )
