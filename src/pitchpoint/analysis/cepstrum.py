# SPDX-License-Identifier: Apache-2.0
"""Cepstra, in which families of equally spaced lines and echoes appear as single peaks; whitening."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array, SignalError, as_signal, positive, same_length, whole
from pitchpoint.analysis.spectra import window


@dataclass(frozen=True)
class Cepstrum:
    """Cepstrum of a signal.

    Attributes
    ----------
    quefrency
        Shape (n,). Quefrency [s], from 0 to half the length of the record.
    cepstrum
        Shape (n,). Value [-].
    """

    quefrency: Array
    cepstrum: Array


@dataclass(frozen=True)
class Rahmonics:
    """Peaks of a cepstrum at multiples of a quefrency.

    Attributes
    ----------
    number
        Shape (n,). Numbers of the rahmonics, from 1 [-].
    quefrency
        Shape (n,). Quefrencies found [s].
    value
        Shape (n,). Values of the cepstrum there [-].
    background
        Shape (n,). RMS of the cepstrum around the peak, without the peak [-].
    """

    number: Array
    quefrency: Array
    value: Array
    background: Array


@dataclass(frozen=True)
class WhitenedSignal:
    """Signal whose spectral lines have equal amplitudes.

    Attributes
    ----------
    values
        Shape (n,). Whitened samples, with a mean square of about 1 [-].
    """

    values: Array


def real_cepstrum(
    values: ArrayLike, sample_rate: float, *, window_name: str = "hann", floor: float = 1e-6
) -> Cepstrum:
    """Real cepstrum: inverse transform of the logarithm of the amplitude spectrum.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit; the mean is removed.
    sample_rate
        Sample rate f_s [Hz].
    window_name
        See `spectra.window`; `rectangular` for echoes within the record, else `hann`.
    floor
        Lower limit of the amplitudes relative to the highest one, for the logarithm [-].

    Returns
    -------
    Cepstrum
        From quefrency 0; a family of lines with a spacing of f_0 has peaks at 1/f_0 and its multiples.

    Raises
    ------
    SignalError
        If the signal is constant, or an input is unsuitable.

    Notes
    -----
    c = F⁻¹ ln |F x| [1]_. An echo a x(t - τ) adds -(-a)^k/(2 k) at k τ. Valid for stationary signals; a
    family of lines is detected if the record resolves the lines.

    References
    ----------
    .. [1] R. B. Randall, A history of cepstrum analysis and its application to mechanical problems,
       Mechanical Systems and Signal Processing 97, 2017, 3-19.

    Examples
    --------
    An impact and its echo of 60 % after 20 samples:

    >>> x = np.zeros(4096)
    >>> x[100], x[120] = 1.0, 0.6
    >>> found = real_cepstrum(x, 1000.0, window_name="rectangular")
    >>> found.cepstrum[[20, 40, 60]].round(3).tolist()
    [0.3, -0.09, 0.036]
    """
    x = as_signal(values, minimum=8)
    rate = positive(sample_rate, "sample_rate")
    least = positive(floor, "floor")
    size = np.abs(np.fft.rfft(window(window_name, x.size) * (x - x.mean())))
    top = float(size.max())
    if top <= 0.0 or float(np.ptp(x)) == 0.0:
        raise SignalError("values: are constant; the logarithm of their spectrum does not exist")
    # without the mean line 0 is zero, and its logarithm would offset the whole cepstrum
    size[0] = size[1]
    cepstrum = np.fft.irfft(np.log(np.maximum(size, least * top)), x.size)[: x.size // 2 + 1]
    return Cepstrum(np.arange(cepstrum.size) / rate, cepstrum)


def power_cepstrum(
    values: ArrayLike, sample_rate: float, *, window_name: str = "hann", floor: float = 1e-6
) -> Cepstrum:
    """Power cepstrum: square of the inverse transform of the logarithm of the power spectrum.

    Parameters
    ----------
    values, sample_rate, window_name, floor
        See `real_cepstrum`.

    Returns
    -------
    Cepstrum
        Nonnegative; same shape as that of `real_cepstrum`.

    Raises
    ------
    SignalError
        As `real_cepstrum`.

    Notes
    -----
    C = (F⁻¹ ln |F x|²)² = 4 c² with the real cepstrum c [1]_. Valid as `real_cepstrum`.

    References
    ----------
    .. [1] B. P. Bogert, M. J. R. Healy, J. W. Tukey, The quefrency alanysis of time series for echoes, in:
       Proceedings of the Symposium on Time Series Analysis, Wiley, 1963, 209-243.

    Examples
    --------
    >>> x = np.zeros(4096)
    >>> x[100], x[120] = 1.0, 0.6
    >>> found = power_cepstrum(x, 1000.0, window_name="rectangular")
    >>> round(float(found.cepstrum[20]), 3)
    0.36
    """
    found = real_cepstrum(values, sample_rate, window_name=window_name, floor=floor)
    return Cepstrum(found.quefrency, 4.0 * found.cepstrum**2)


def rahmonics(cepstrum: Cepstrum, quefrency: float, *, count: int = 3, tolerance: float = 0.01) -> Rahmonics:
    """Peaks of a cepstrum at multiples of a quefrency: the period of a shaft, or of a fault.

    Parameters
    ----------
    cepstrum
        A real or a power cepstrum.
    quefrency
        Approximate period [s].
    count
        Number of multiples [-].
    tolerance
        Relative tolerance of the quefrency [-].

    Returns
    -------
    Rahmonics
        One row per multiple within the cepstrum.

    Raises
    ------
    SignalError
        If the first multiple is outside the cepstrum.

    Notes
    -----
    Maximum within the tolerance of k τ, at least one sample to either side [1]_. Valid for families of ten or
    more lines.

    References
    ----------
    .. [1] R. B. Randall, Vibration-based Condition Monitoring, Wiley, 2011, section on the cepstrum.

    Examples
    --------
    Harmonics of 12.5 Hz are at 80 ms:

    >>> t = np.arange(8000) / 1000.0
    >>> x = sum(np.cos(2 * np.pi * 12.5 * k * t + k**2) for k in range(1, 40))
    >>> noise = 0.05 * np.random.default_rng(0).normal(size=t.size)
    >>> found = rahmonics(real_cepstrum(x + noise, 1000.0), 0.0797, count=2)
    >>> found.quefrency.tolist(), bool(found.value[0] > 5 * found.background[0])
    ([0.08, 0.16], True)
    """
    c, axis = cepstrum.cepstrum, cepstrum.quefrency
    same_length(c, axis, "cepstrum, quefrency")
    step, period = float(axis[1]), positive(quefrency, "quefrency")
    slack = positive(tolerance, "tolerance")
    rows = []
    for k in range(1, whole(count, "count") + 1):
        middle, half = k * period / step, max(slack * k * period / step, 1.0)
        low, high = max(1, int(np.ceil(middle - half))), int(np.floor(middle + half))
        if high >= c.size:
            break
        top = low + int(np.argmax(c[low : high + 1]))
        around = np.arange(max(1, top - 32), min(c.size, top + 33))
        around = around[np.abs(around - top) > 2]
        rows.append((k, axis[top], c[top], np.sqrt(np.mean(c[around] ** 2))))
    if not rows:
        raise SignalError(f"quefrency: {period:g} s (limit below {float(axis[-1]):g} s, half the record)")
    number, place, value, background = np.array(rows).T
    return Rahmonics(number, place, value, background)


def cepstral_whitening(values: ArrayLike) -> WhitenedSignal:
    """Cepstrum pre-whitening: all spectral lines get the same amplitude and keep their phases.

    Parameters
    ----------
    values
        Signal, shape (n,), any unit.

    Returns
    -------
    WhitenedSignal
        Samples without a unit.

    Raises
    ------
    SignalError
        If the signal is constant.

    Notes
    -----
    The real cepstrum is set to zero, except for its mean [1]_. Gear meshes and other tones lose their weight;
    impacts, which fill a band, keep it. Valid for impacts that fill a band with many lines.

    References
    ----------
    .. [1] P. Borghesani, P. Pennacchi, R. B. Randall, N. Sawalhi, R. Ricci, Application of cepstrum
       pre-whitening for the diagnosis of bearing faults under variable speed conditions, Mechanical Systems
       and Signal Processing 36(2), 2013, 370-384.

    Examples
    --------
    A tone 1000 times as large as white noise is no longer visible:

    >>> t = np.arange(1000)
    >>> noise = np.random.default_rng(1).standard_normal(t.size)
    >>> lines = np.abs(np.fft.rfft(cepstral_whitening(1000 * np.sin(0.2 * np.pi * t) + noise).values))[1:]
    >>> round(float(lines.min()), 6), round(float(lines.max()), 6)
    (31.622777, 31.622777)
    """
    x = as_signal(values)
    if float(np.ptp(x)) == 0.0:
        raise SignalError("values: are constant; there is nothing to whiten")
    return WhitenedSignal(whitened(x) * np.sqrt(x.size))


def whitened(values: ArrayLike) -> Array:
    """Whitened signal: spectral lines of unit amplitude with their original phases.

    Parameters
    ----------
    values
        Signal, shape (n,), any unit.

    Notes
    -----
    Cepstrum pre-whitening [1]_: meshes and their sidebands are few lines and lose their weight, impacts fill
    a band and keep it. Valid for impacts that fill a band with many lines.

    References
    ----------
    .. [1] P. Borghesani, P. Pennacchi, R. B. Randall, N. Sawalhi, R. Ricci, Application of cepstrum
       pre-whitening for the diagnosis of bearing faults under variable speed conditions, Mechanical Systems
       and Signal Processing 36(2), 2013, 370-384.

    Examples
    --------
    A single pulse is already white:

    >>> pulse = np.zeros(8)
    >>> pulse[3] = 2.0
    >>> (np.abs(whitened(pulse) + 1 / 8) > 1e-9).tolist().index(True)
    3
    """
    lines = np.fft.rfft(as_signal(values))
    lines[0] = 0.0
    size = np.abs(lines)
    lines /= np.where(size > 0.0, size, 1.0)
    return np.asarray(np.fft.irfft(lines, np.size(values)), dtype=np.float64)
