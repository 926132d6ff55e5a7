# SPDX-License-Identifier: Apache-2.0
"""Spectra of sampled signals: amplitudes, power spectral density, orders.

Common convention: one-sided, amplitudes are *peak* values of sines, corrected for the window; the mean is
removed before windowing (otherwise it leaks into the first lines) and returned separately.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array, Lines, SignalError, as_signal, positive

# Coefficients a_k of w(n) = sum_k (-1)^k a_k cos(2 pi k n/N).
WINDOWS: dict[str, tuple[float, ...]] = {
    "rectangular": (1.0,),
    "hann": (0.5, 0.5),
    "blackman": (0.42, 0.5, 0.08),
    "flattop": (0.21557895, 0.41663158, 0.277263158, 0.083578947, 0.006947368),
}


@dataclass(frozen=True)
class Spectrum:
    """One-sided amplitude spectrum.

    Attributes
    ----------
    frequency
        Shape (n_line,). Frequency [Hz], or order [1] for an order spectrum.
    amplitude
        Shape (n_line,). Peak amplitude of the sine at that line, in the unit of the signal; line 0 is |mean|.
    mean
        Mean of the signal, in its unit.
    resolution
        Line spacing, in the unit of `frequency`.
    noise_bandwidth
        Equivalent noise bandwidth of the window, in the unit of `frequency`.
    """

    frequency: Array
    amplitude: Array
    mean: float
    resolution: float
    noise_bandwidth: float


@dataclass(frozen=True)
class Density:
    """One-sided power spectral density: `frequency` [Hz], `density` [unit²/Hz], both shape (n_line,)."""

    frequency: Array
    density: Array
    n_segments: int


def window(name: str, length: int) -> Array:
    """Periodic cosine-sum window.

    Parameters
    ----------
    name
        One of `rectangular`, `hann`, `blackman`, `flattop`.
    length
        Number of samples N [-].

    Returns
    -------
    NDArray
        Window values, shape (length,).

    Raises
    ------
    SignalError
        If the window is unknown.

    Notes
    -----
    w(n) = Σ_k (-1)^k a_k cos(2πkn/N), n = 0 … N-1 [1]_. With the periodic form (not the symmetric one used
    for filters) the lines of a sine with whole periods in the record are exact. Valid for N ≥ 2·(number of
    coefficients).

    References
    ----------
    .. [1] F. J. Harris, On the use of windows for harmonic analysis with the discrete Fourier transform,
       Proceedings of the IEEE 66(1), 1978, 51-83.

    Examples
    --------
    >>> window("hann", 4)
    array([0. , 0.5, 1. , 0.5])
    """
    if name not in WINDOWS:
        raise SignalError(f"window: {name!r} is unknown; use one of {', '.join(WINDOWS)}")
    phase = 2.0 * np.pi * np.arange(length) / length
    values = np.zeros(length)
    for k, a in enumerate(WINDOWS[name]):
        values += (-1.0) ** k * a * np.cos(k * phase)
    return values


def one_sided(transform: Lines, length: int, gain: float) -> Array:
    """Peak amplitudes from |rfft| of one or more windowed records (last axis), `gain` = sum of the window.

    Parameters
    ----------
    transform
        Result of rfft, shape (..., n): records along the leading axes, frequencies along the last.
    length
        Number of samples of one record.
    gain
        Sum of the window.
    """
    amplitude = np.asarray(2.0 * np.abs(transform) / gain, dtype=np.float64)
    # the mean and, for an even record, the line at half the sample rate have no mirror image
    amplitude[..., 0] *= 0.5
    if length % 2 == 0:
        amplitude[..., -1] *= 0.5
    return amplitude


def amplitude_spectrum(values: ArrayLike, sample_rate: float, *, window_name: str = "hann") -> Spectrum:
    """Amplitude spectrum of a uniformly sampled signal, corrected for the window.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Sample rate f_s [Hz].
    window_name
        `hann` separates adjacent lines, `flattop` gives amplitudes between two lines to 0.1 %, `rectangular`
        is exact for whole periods in the record.

    Returns
    -------
    Spectrum
        Lines 0 … f_s/2, peak amplitudes in the unit of the signal.

    Raises
    ------
    SignalError
        If the data are not a finite signal of four or more samples, or the rate is not positive.

    Notes
    -----
    A_k = 2 |Σ w_n (x_n - x̄) exp(-2πikn/N)| / Σ w_n; line 0 is |x̄| [1]_. Valid for stationary signals; the
    amplitude of a sine between two lines is too low by up to 15 % (Hann) or 36 % (rectangular).

    References
    ----------
    .. [1] G. Heinzel, A. Rüdiger, R. Schilling, Spectrum and spectral density estimation by the discrete
       Fourier transform, Max-Planck-Institut für Gravitationsphysik, 2002, sections 8 and 9.

    Examples
    --------
    >>> t = np.arange(1000) / 1000.0
    >>> spectrum = amplitude_spectrum(5.0 + 3.0 * np.sin(2 * np.pi * 40.0 * t), 1000.0)
    >>> round(float(spectrum.amplitude[40]), 9), round(spectrum.mean, 9)
    (3.0, 5.0)
    """
    x = as_signal(values, minimum=4)
    rate = positive(sample_rate, "sample_rate")
    n = x.size
    w = window(window_name, n)
    gain = float(w.sum())
    mean = float(x.mean())
    amplitude = one_sided(np.fft.rfft(w * (x - mean)), n, gain)
    amplitude[0] = abs(mean)
    resolution = rate / n
    return Spectrum(
        frequency=resolution * np.arange(amplitude.size, dtype=np.float64),
        amplitude=amplitude,
        mean=mean,
        resolution=resolution,
        noise_bandwidth=rate * float(np.sum(w * w)) / gain**2,
    )


def order_spectrum(
    values: ArrayLike, samples_per_revolution: float, *, window_name: str = "hann"
) -> Spectrum:
    """Order spectrum of a signal sampled at equal angles.

    Equivalent to `amplitude_spectrum` with revolutions instead of seconds: order 1 is once per revolution of
    the reference shaft. `orders.resample_over_angle` gives such a signal from a record over time.

    Parameters
    ----------
    values
        Samples at equal steps of the angle, shape (n,), any unit.
    samples_per_revolution
        Number of samples per revolution [-].
    window_name
        See `amplitude_spectrum`.

    Returns
    -------
    Spectrum
        `frequency` contains orders [-].

    Raises
    ------
    SignalError
        As `amplitude_spectrum`.

    Notes
    -----
    Order = frequency·2π/ω [1]_. Valid up to half the number of samples per revolution.

    References
    ----------
    .. [1] A. Brandt, Noise and Vibration Analysis, Wiley, 2011, chapter on the analysis of rotating
       machinery.

    Examples
    --------
    >>> angle = 2 * np.pi * np.arange(64 * 10) / 64
    >>> spectrum = order_spectrum(2.0 * np.cos(17 * angle), 64)
    >>> k = int(np.argmax(spectrum.amplitude))
    >>> float(spectrum.frequency[k]), round(float(spectrum.amplitude[k]), 9)
    (17.0, 2.0)
    """
    return amplitude_spectrum(values, samples_per_revolution, window_name=window_name)


def power_spectral_density(
    values: ArrayLike, sample_rate: float, *, segment: int | None = None, window_name: str = "hann"
) -> Density:
    """Power spectral density, averaged over half-overlapping segments.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Sample rate f_s [Hz].
    segment
        Samples per segment L [-]; default an eighth of the record, at least 256 and at most the record.
    window_name
        See `window`.

    Returns
    -------
    Density
        One-sided density [unit²/Hz]; its integral over the frequency is the variance.

    Raises
    ------
    SignalError
        If the data are not a finite signal, or the segment is shorter than 4 samples or longer than the
        record.

    Notes
    -----
    S_k = 2 |Σ w_n (x_n - x̄) exp(-2πikn/L)|² / (f_s Σ w_n²), mean over segments [1]_. Valid for stationary
    signals; the scatter of each line falls with the square root of the number of segments.

    References
    ----------
    .. [1] P. D. Welch, The use of fast Fourier transform for the estimation of power spectra, IEEE
       Transactions on Audio and Electroacoustics 15(2), 1967, 70-73.

    Examples
    --------
    A sine of amplitude 3 has a power of 4.5:

    >>> t = np.arange(4096) / 1024.0
    >>> psd = power_spectral_density(3.0 * np.sin(2 * np.pi * 100.0 * t), 1024.0, segment=1024)
    >>> round(float(psd.density.sum() * (psd.frequency[1] - psd.frequency[0])), 9)
    4.5
    """
    x = as_signal(values, minimum=4)
    rate = positive(sample_rate, "sample_rate")
    length = min(x.size, max(256, x.size // 8)) if segment is None else int(segment)
    if not 4 <= length <= x.size:
        raise SignalError(
            f"segment: {length} samples (limit 4 to {x.size}); choose a length inside the record"
        )
    w = window(window_name, length)
    starts = np.arange(0, x.size - length + 1, max(1, length // 2))
    x = x - x.mean()
    power = np.zeros(length // 2 + 1)
    for start in starts:
        power += np.abs(np.fft.rfft(w * x[start : start + length])) ** 2
    density = 2.0 * power / (starts.size * rate * float(np.sum(w * w)))
    density[0] *= 0.5
    if length % 2 == 0:
        density[-1] *= 0.5
    return Density(np.arange(density.size) * rate / length, density, int(starts.size))


def largest_peaks(spectrum: Spectrum, count: int = 5, *, floor: float = 0.01) -> list[tuple[float, float]]:
    """Highest local maxima of a spectrum without line 0, for labels and tables.

    Parameters
    ----------
    spectrum
        Any amplitude or order spectrum.
    count
        Maximum number of peaks [-].
    floor
        Minimum amplitude relative to the highest line [-].

    Returns
    -------
    list of tuple
        (frequency, amplitude of the line), highest first.

    Notes
    -----
    A line is a peak if it is higher than the line before it and not lower than the line after it. Its
    frequency is that of the vertex of the parabola through the logarithms of the three lines [1]_; for a Hann
    window and a single sine the error is below 2 % of the line spacing. The amplitude is that of the line.

    References
    ----------
    .. [1] J. O. Smith, Spectral Audio Signal Processing, W3K Publishing, 2011, section on quadratic
       interpolation of spectral peaks.

    Examples
    --------
    >>> t = np.arange(500) / 500.0
    >>> s = amplitude_spectrum(np.sin(2 * np.pi * 50 * t) + 0.5 * np.sin(2 * np.pi * 120 * t), 500.0)
    >>> [(round(f, 6), round(a, 6)) for f, a in largest_peaks(s)]
    [(50.0, 1.0), (120.0, 0.5)]
    """
    a = spectrum.amplitude
    if a.size < 3:
        return []
    inner = np.arange(1, a.size - 1)
    tops = inner[(a[inner] > a[inner - 1]) & (a[inner] >= a[inner + 1])]
    tops = tops[a[tops] >= floor * float(a[1:].max())]
    tops = tops[np.argsort(-a[tops], kind="stable")][:count]
    return [
        (float(spectrum.frequency[k]) + _top_of_parabola(a[k - 1 : k + 2]) * spectrum.resolution, float(a[k]))
        for k in tops
    ]


def _top_of_parabola(three: Array) -> float:
    """Vertex of the parabola through the logarithms of three lines, in lines from the middle one."""
    # the lower limit keeps round-off in the neighbours from shifting the vertex
    left, top, right = np.log(np.maximum(three, 1e-4 * float(three[1])))
    return float(0.5 * (left - right) / (left - 2.0 * top + right))
