# SPDX-License-Identifier: Apache-2.0
"""Order tracking: signals over the angle of a shaft, and order maps of run-ups.

Gear vibration is periodic in the angle, not in time: a mesh excites z times per revolution at any speed. In a
run-up sampled at equal angles each order is one sharp line, which is smeared in a spectrum over time.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.frames import frame_places, frame_spectra
from pitchpoint.analysis.sampled import (
    Array,
    SignalError,
    as_increasing,
    as_signal,
    one_way,
    positive,
    same_length,
)
from pitchpoint.analysis.spectra import Spectrum, order_spectrum
from pitchpoint.core.units import format_quantity

SAMPLES_PER_ORDER = 2.56
"""Samples per revolution of a grid over the highest order of interest: content above half the grid rate then
aliases to above that order, except for a band that the filter removes."""
FAST = 0.05
"""Relative change of the speed within a frame: the bandwidth of a resonance with 2.5 % damping."""
MAX_OVERSAMPLING = 32
"""Maximum refinement of the angle grid due to a slow start, before filtering and decimation; the refinement
for the mean samples per revolution of a record is not limited."""
FILTER_HALF_LENGTH, FILTER_BETA = 16, 8.0
"""Half length, in samples after decimation, and shape parameter of the Kaiser window of the low-pass filter:
the amplitude error is below 0.02 % up to 0.84 times half the new rate; above 1.16 times, less than 0.01 %
passes."""


@dataclass(frozen=True)
class AngleSignal:
    """Signal at equal steps of a shaft angle.

    Attributes
    ----------
    angle
        Shape (n,). Angle [rad], from the first sample of the record.
    values
        Shape (n,). Signal, in its unit.
    samples_per_revolution
        Number of samples per revolution [-].
    """

    angle: Array
    values: Array
    samples_per_revolution: float


@dataclass(frozen=True)
class OrderMap:
    """Order spectra along a run-up.

    Attributes
    ----------
    time, speed
        Shape (n_frame,). Mid-time of each frame [s], mean speed in the frame [rad/s].
    order
        Shape (n_order,). Order relative to the reference shaft [-].
    amplitude
        Shape (n_frame, n_order). Peak amplitude, in the unit of the signal.
    speed_change
        Shape (n_frame,). Change of the speed within each frame [rad/s]: the resolution of the map in speed.
    """

    time: Array
    speed: Array
    order: Array
    amplitude: Array
    speed_change: Array

    @property
    def is_run_up(self) -> bool:
        """Whether the speed only rises, or only falls."""
        change = np.diff(self.speed)
        return bool(np.all(change > 0.0) or np.all(change < 0.0))

    @property
    def notes(self) -> tuple[str, ...]:
        """Note on frames within which the speed changes so much that resonances are understated."""
        fast = self.speed_change > FAST * self.speed
        if not fast.any():
            return ()
        low, high, most = (
            format_quantity(float(w), "angular_speed", 4)
            for w in (self.speed[fast].min(), self.speed[fast].max(), self.speed_change[fast].max())
        )
        slower = " or a slower run-up" if self.is_run_up else ""
        return (
            f"between {low} and {high} the speed changes by more than {100.0 * FAST:g} % within a frame, by "
            f"up to {most}, so that maxima at narrow resonances are too low there. Use fewer revolutions per "
            f"frame{slower}",
        )


def resample_over_angle(
    values: ArrayLike, angle: ArrayLike, *, samples_per_revolution: float | None = None
) -> AngleSignal:
    """Resample a record at equal steps of a shaft angle.

    Parameters
    ----------
    values
        Samples of the signal, shape (n,), any unit, with any spacing in time.
    angle
        Unwrapped angle of the reference shaft at the same samples [rad], shape (n,), strictly monotonic.
    samples_per_revolution
        Samples per revolution of the result [-]; default: those of the record at the highest speed.

    Returns
    -------
    AngleSignal
        Signal over the angle.

    Raises
    ------
    SignalError
        If the shaft stops or reverses, the channels differ in length, or the record is shorter than three
        steps.

    Notes
    -----
    Cubic spline through (angle, value), evaluated on a grid twice as fine as the record, then low-pass
    filtered and decimated [1]_. Content from 0.84 to 1.16 times half the new rate is in the transition band
    and is partly aliased to just below half the rate: with 2.56 samples per revolution and order, all orders
    up to that order are free of it. Valid if the record has at least four samples per period of the content
    of interest (the spline error is then below 1 %).

    References
    ----------
    .. [1] K. R. Fyfe, E. D. S. Munck, Analysis of computed order tracking, Mechanical Systems and Signal
       Processing 11(2), 1997, 187-205.

    Examples
    --------
    Order 23 of a shaft that accelerates from rest:

    >>> t = np.linspace(1.0, 5.0, 40001)
    >>> angle = 2 * np.pi * t**2
    >>> signal = resample_over_angle(np.cos(23 * angle), angle, samples_per_revolution=128)
    >>> middle = slice(300, -300)
    >>> error = signal.values[middle] - np.cos(23 * signal.angle[middle])
    >>> bool(np.max(np.abs(error)) < 2e-3)
    True
    """
    from scipy.interpolate import CubicSpline

    x = as_signal(values, "values", 8)
    phi = one_way(as_signal(angle, "angle", 8))
    same_length(x, phi, "values, angle")
    steps = np.diff(phi)
    if samples_per_revolution is None:
        rate = 2.0 * np.pi / float(np.quantile(steps, 0.99))
    else:
        rate = positive(samples_per_revolution, "samples_per_revolution")
    factor = _oversampling(steps, rate)
    span = float(phi[-1] - phi[0])
    n = int(np.floor(span * rate / (2.0 * np.pi) * (1.0 + 1e-12))) + 1
    if n < 4:
        raise SignalError(
            f"angle: covers {span:.3g} rad, less than three steps; use a longer record or a finer grid"
        )
    fine = phi[0] + np.arange((n - 1) * factor + 1) * (2.0 * np.pi / (rate * factor))
    data = CubicSpline(phi, x)(np.minimum(fine, phi[-1]))
    if factor > 1:
        data = _thinned_out(data, factor)
    sign = 1.0 if _turns_forward(angle) else -1.0
    grid = phi[0] + np.arange(n) * (2.0 * np.pi / rate)
    return AngleSignal(sign * grid, data[:n], rate)


def highest_resolved_order(angle: ArrayLike) -> float:
    """Highest order that a record resolves: half its samples per revolution at the highest speed [-].

    Parameters
    ----------
    angle
        Unwrapped angle of the reference shaft [rad], shape (n,).

    Notes
    -----
    Half of 2π over the 99 % quantile of the angle steps [1]_. Higher orders are only images of lower ones.

    References
    ----------
    .. [1] C. E. Shannon, Communication in the presence of noise, Proceedings of the IRE 37(1), 1949, 10-21.

    Examples
    --------
    >>> round(highest_resolved_order(2 * np.pi * np.arange(1000) / 100), 9)
    50.0
    """
    steps = np.abs(np.diff(as_signal(angle, "angle", 2)))
    return float(np.pi / max(float(np.quantile(steps, 0.99)), np.finfo(np.float64).tiny))


def tracked_spectrum(
    values: ArrayLike, angle: ArrayLike, *, highest_order: float, window_name: str = "hann"
) -> Spectrum:
    """Order spectrum of a record over time, up to a highest order and free of aliasing.

    Parameters
    ----------
    values, angle
        Signal (any unit) and unwrapped angle of the reference shaft [rad], shape (n,) each.
    highest_order
        Highest order of the spectrum [-], limited to the highest order that the record resolves.
    window_name
        See `spectra.window`.

    Returns
    -------
    Spectrum
        `frequency` contains orders [-]. Records of two or more revolutions are cut to whole revolutions at
        their end, so that whole orders coincide with lines.

    Raises
    ------
    SignalError
        As `resample_over_angle`.

    Notes
    -----
    `resample_over_angle` with 2.56 samples per revolution and order, then `spectra.order_spectrum` [1]_.
    Valid for constant speed, or for amplitudes that do not depend on the speed.

    References
    ----------
    .. [1] K. R. Fyfe, E. D. S. Munck, Analysis of computed order tracking, Mechanical Systems and Signal
       Processing 11(2), 1997, 187-205.

    Examples
    --------
    Orders 200 and 50; in a spectrum up to order 150 nothing of order 200 is left:

    >>> angle = 2 * np.pi * np.arange(20_001) / 2000
    >>> s = tracked_spectrum(2.0 * np.cos(50 * angle) + np.cos(200 * angle), angle, highest_order=150)
    >>> float(s.frequency[-1]), float(s.frequency[np.argmax(s.amplitude)]), round(float(s.amplitude.max()), 3)
    (150.0, 50.0, 2.0)
    >>> bool(s.amplitude[s.frequency > 55].max() < 1e-3)
    True
    """
    top = min(positive(highest_order, "highest_order"), highest_resolved_order(angle))
    rate = int(np.ceil(SAMPLES_PER_ORDER * top))
    turned = resample_over_angle(values, angle, samples_per_revolution=rate)
    # the sample after whole revolutions is the first of the next revolution
    whole = (turned.values.size // rate) * rate
    data = turned.values[-whole:] if whole >= 2 * rate else turned.values
    found = order_spectrum(data, rate, window_name=window_name)
    shown = found.frequency <= top * (1.0 + 1e-12)
    return replace(found, frequency=found.frequency[shown], amplitude=found.amplitude[shown])


def order_map(
    values: ArrayLike,
    angle: ArrayLike,
    time: ArrayLike,
    *,
    highest_order: float,
    revolutions: float = 8.0,
    frames: int = 200,
    window_name: str = "hann",
) -> OrderMap:
    """Order spectra of successive frames of a run-up or run-down.

    Parameters
    ----------
    values, angle, time
        Signal (any unit), unwrapped angle of the reference shaft [rad] and time [s], shape (n,) each.
    highest_order
        Highest order [-]; the angle grid has 2.56 times as many samples per revolution.
    revolutions
        Length of one frame [revolutions]; the line spacing is 1/revolutions. Frames at the ends are shorter,
        see `frames.frame_places`, with wider lines, but have at least one revolution.
    frames
        Maximum number of frames [-]; they overlap as needed.
    window_name
        See `spectra.window`.

    Returns
    -------
    OrderMap
        Amplitudes by frame (rows) and order.

    Raises
    ------
    SignalError
        If the record is shorter than one frame, or an input is unsuitable.

    Notes
    -----
    Frames of equal angle, amplitude spectrum of each as in `spectra.amplitude_spectrum`; the speed of a frame
    is its angle over its duration [1]_. Valid while amplitudes change little within one frame: the amplitude
    is a weighted mean over the speeds in the frame, so that a frame in which the speed changes by more than
    the bandwidth of a resonance, 2 zeta Omega, understates its maximum (`OrderMap.notes`).

    References
    ----------
    .. [1] K. R. Fyfe, E. D. S. Munck, Analysis of computed order tracking, Mechanical Systems and Signal
       Processing 11(2), 1997, 187-205.

    Examples
    --------
    The order of a chirp is constant while its frequency increases ninefold:

    >>> t = np.linspace(1.0, 9.0, 100001)
    >>> angle = 2 * np.pi * t**2
    >>> m = order_map(2.0 * np.sin(17 * angle), angle, t, highest_order=30)
    >>> sorted({float(m.order[k]) for k in np.argmax(m.amplitude, axis=1)})
    [17.0]
    >>> bool(np.all(np.abs(m.amplitude.max(axis=1) - 2.0) < 2e-3))
    True
    """
    clock = as_increasing(time, "time", 8)
    same_length(clock, as_signal(angle, "angle"), "time, angle")
    phi = one_way(angle, clock)
    rate = SAMPLES_PER_ORDER * positive(highest_order, "highest_order")
    # whole samples per frame: orders that fit the frame then coincide with lines
    length = max(8, round(rate * positive(revolutions, "revolutions")))
    signal = resample_over_angle(values, angle, samples_per_revolution=length / revolutions)
    size = signal.values.size
    if size < length:
        turned = (size - 1) / signal.samples_per_revolution
        raise SignalError(
            f"angle: covers {turned:.3g} revolutions (limit {revolutions:g}); use shorter frames"
        )
    # shorter than a revolution, the lines of a frame would be as wide as the distance of low mesh orders
    revolution = max(8, round(signal.samples_per_revolution))
    places = starts, lengths = frame_places(size, length, frames, revolution)
    n_order = int(np.floor(highest_order * revolutions * (1.0 + 1e-12))) + 1
    amplitude = np.empty((starts.size, n_order))
    for row, (mean, lines) in enumerate(frame_spectra(signal.values, places, length, window_name)):
        amplitude[row] = lines[:n_order]
        amplitude[row, 0] = abs(mean)
    step = 2.0 * np.pi / signal.samples_per_revolution
    half = 0.5 * (lengths - 1)
    begin, middle, end = (np.interp(phi[0] + (starts + k * half) * step, phi, clock) for k in range(3))
    speed = 2.0 * half * step / (end - begin)
    # twice the difference of the mean speeds of both halves
    change = 2.0 * half * step * np.abs(1.0 / (end - middle) - 1.0 / (middle - begin))
    orders = np.arange(n_order) / revolutions
    return OrderMap(0.5 * (begin + end), speed, orders, amplitude, change)


def _oversampling(steps: Array, rate: float) -> int:
    """Refinement of the requested grid for interpolation: at least twice as fine as the record.

    The images of a sampled signal are around its rate; on a grid of twice the rate none is aliased.
    """
    # 1 % of the record may be denser than the fine grid, as at the slow start of a run-up
    finest, mean = (2.0 * np.pi / float(step) for step in (np.quantile(steps, 0.01), steps.mean()))
    creeping = min(np.ceil(2.0 * finest / rate), MAX_OVERSAMPLING)
    return int(max(creeping, np.ceil(2.0 * mean / rate), 1))


def _thinned_out(data: Array, factor: int) -> Array:
    """Decimate by a factor after a low-pass filter at half the new rate."""
    from scipy.signal import firwin, upfirdn

    reach = FILTER_HALF_LENGTH * factor
    taps = firwin(2 * reach + 1, 1.0 / factor, window=("kaiser", FILTER_BETA))
    # odd extension at both ends: continuous in value and slope, exact for a straight line
    longer = np.pad(data, reach, mode="reflect", reflect_type="odd")
    filtered: Array = upfirdn(taps, longer, 1, factor)[2 * FILTER_HALF_LENGTH :]
    return filtered[: -(-data.size // factor)]


def _turns_forward(angle: ArrayLike) -> bool:
    data = np.asarray(angle, dtype=np.float64)
    return bool(data[-1] > data[0])
