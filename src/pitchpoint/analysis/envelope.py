# SPDX-License-Identifier: Apache-2.0
"""Envelope of a frequency band and its spectrum: demodulation of impacts that excite a resonance."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.cepstrum import cepstral_whitening
from pitchpoint.analysis.decimation import PASS, decimated
from pitchpoint.analysis.line_tests import LONG
from pitchpoint.analysis.sampled import Array, SignalError, as_signal, positive
from pitchpoint.analysis.spectra import Spectrum, amplitude_spectrum

AT_ONCE = 1 << 20
"""Samples of a part of a long record."""
LARGEST = 1000
"""Largest factor of decimation, whose filter is shorter than the last part of a record can be."""


@dataclass(frozen=True)
class Envelope:
    """Envelope of a band of a signal.

    Attributes
    ----------
    envelope
        Shape (n,). Amplitude of the band over time, in the unit of the signal, at the samples of the signal.
    low, high
        Edges of the band [Hz].
    """

    envelope: Array
    low: float
    high: float


def band_envelope(
    values: ArrayLike, sample_rate: float, *, band: tuple[float, float] | None = None, whiten: bool = False
) -> Envelope:
    """Hilbert envelope of a band of a signal.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Sample rate f_s [Hz].
    band
        Lower and upper edge [Hz]; default: the whole signal without its mean. `kurtogram.kurtogram` finds a
        suitable band.
    whiten
        Whether to use the whitened signal, without a unit, see `cepstrum.cepstral_whitening`.

    Returns
    -------
    Envelope
        Envelope of the same length as the signal, with end effects over about 1/bandwidth at both ends.

    Raises
    ------
    SignalError
        If the band is empty, has no line of the spectrum, or is not between 0 and f_s/2.

    Notes
    -----
    |x_a| of the analytic signal x_a, whose spectrum is twice that of the signal inside the band and zero
    outside [1]_. Valid if the band is narrow compared with its centre frequency, or has a single carrier.

    References
    ----------
    .. [1] D. Ho, R. B. Randall, Optimisation of bearing diagnostic techniques using simulated and actual
       bearing fault signals, Mechanical Systems and Signal Processing 14(5), 2000, 763-788.

    Examples
    --------
    A carrier of 200 Hz with an amplitude modulation of 8 Hz, and a stronger tone:

    >>> t = np.arange(1000) / 1000.0
    >>> swing = 1 + 0.5 * np.cos(2 * np.pi * 8 * t)
    >>> x = swing * np.cos(2 * np.pi * 200 * t) + 5.0 * np.cos(2 * np.pi * 30 * t)
    >>> found = band_envelope(x, 1000.0, band=(150.0, 250.0))
    >>> bool(np.abs(found.envelope - swing).max() < 1e-12)
    True
    """
    x = as_signal(values, minimum=8)
    if whiten:
        x = cepstral_whitening(x).values
    rate = positive(sample_rate, "sample_rate")
    low, high = (0.0, 0.5 * rate) if band is None else checked_band(band, rate)
    lines = np.fft.rfft(x - x.mean())
    frequency = np.arange(lines.size) * rate / x.size
    inside = (frequency >= low * (1.0 - 1e-12)) & (frequency <= high * (1.0 + 1e-12))
    if not inside.any():
        raise SignalError(
            f"band: {low:g} to {high:g} Hz contains no line (line spacing {rate / x.size:.3g} Hz); "
            "widen it or use a longer record"
        )
    analytic = np.zeros(x.size, dtype=np.complex128)
    analytic[: lines.size] = np.where(inside, 2.0 * lines, 0.0)
    # the lines at 0 and f_s/2 have no mirror image, for which the factor 2 accounts
    analytic[0] *= 0.5
    if x.size % 2 == 0:
        analytic[lines.size - 1] *= 0.5
    return Envelope(np.abs(np.fft.ifft(analytic)), float(low), float(high))


def envelope_spectrum(
    values: ArrayLike,
    sample_rate: float,
    *,
    band: tuple[float, float] | None = None,
    squared: bool = False,
    whiten: bool = False,
    window_name: str = "hann",
) -> Spectrum:
    """Amplitude spectrum of the envelope of a band, or of the squared envelope.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Sample rate f_s [Hz].
    band
        Lower and upper edge of the band [Hz]; default: the whole signal.
    squared
        Whether to use the squared envelope, which has no harmonics caused by the square root.
    whiten
        Whether to use the whitened signal, without a unit, see `cepstrum.cepstral_whitening`. With `squared`
        and the whole band this is the usual spectrum for bearings next to gears.
    window_name
        See `spectra.window`; windows that end at zero suppress the end effects of the envelope.

    Returns
    -------
    Spectrum
        Peak amplitudes in the unit of the signal, or its square; the mean is separate.

    Raises
    ------
    SignalError
        As `band_envelope`.

    Notes
    -----
    Spectrum of |x_a| or |x_a|² [1]_. Valid up to the width of the band.

    References
    ----------
    .. [1] R. B. Randall, J. Antoni, Rolling element bearing diagnostics - a tutorial, Mechanical Systems and
       Signal Processing 25(2), 2011, 485-520.

    Examples
    --------
    The square of 1 + 0.5 cos is 1.125 + cos + 0.125 cos of twice the frequency:

    >>> t = np.arange(1000) / 1000.0
    >>> x = (1 + 0.5 * np.cos(2 * np.pi * 8 * t)) * np.cos(2 * np.pi * 200 * t)
    >>> s = envelope_spectrum(x, 1000.0, squared=True)
    >>> round(s.mean, 6), round(float(s.amplitude[8]), 6), round(float(s.amplitude[16]), 6)
    (1.125, 1.0, 0.125)
    """
    found = band_envelope(values, sample_rate, band=band, whiten=whiten).envelope
    return amplitude_spectrum(found**2 if squared else found, sample_rate, window_name=window_name)


def square_in_parts(
    values: Array, sample_rate: float, highest: float, square: Callable[[Array], Array]
) -> tuple[Array, float]:
    """Squared envelope of a signal; that of a long record in parts and at a lower rate.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Sample rate [Hz], or samples per revolution.
    highest
        Highest frequency of the squared envelope that is required [Hz, or orders].
    square
        Squared envelope of a part, shape (m,) of samples of shape (m,).

    Returns
    -------
    NDArray
        Squared envelope.
    float
        Its sample rate [Hz, or samples per revolution].

    Notes
    -----
    Records above `LONG` samples are processed in parts that overlap by a fifth, of which the tenth at either
    end is not used, because the ends of a part look like impacts; the squared envelope is decimated with an
    anti-aliasing filter [1]_. This requires a tenth of the memory of one transform. Valid up to 0.4 of the
    lower rate, which is above `highest`.

    References
    ----------
    .. [1] A. V. Oppenheim, R. W. Schafer, Discrete-Time Signal Processing, Prentice-Hall, 1989, 7.5.3.

    Examples
    --------
    >>> noise = np.random.default_rng(1).standard_normal(1000)
    >>> found, rate = square_in_parts(noise, 100.0, 10.0, np.square)
    >>> found.size, rate
    (1000, 100.0)
    """
    rate = positive(sample_rate, "sample_rate")
    if values.size <= LONG:
        return square(values), rate
    factor = min(max(int(PASS * rate / positive(highest, "highest")), 1), LARGEST)
    reach = AT_ONCE // 10
    found: list[Array] = []
    left = np.empty(0)
    for start in range(0, values.size, AT_ONCE):
        first, stop = max(start - reach, 0), min(start + AT_ONCE + reach, values.size)
        if values.size - start <= reach:
            break  # the last samples are too few for a part of their own
        left = np.concatenate([left, square(values[first:stop])[start - first : start - first + AT_ONCE]])
        if factor == 1:
            found.append(left)
            left = np.empty(0)
        else:
            found.append(decimated(left, factor))
            left = left[found[-1].size * factor :]
    return np.concatenate(found), rate / factor


def checked_band(band: tuple[float, float], sample_rate: float) -> tuple[float, float]:
    """Check that a band is between zero and half the sample rate, and return it.

    Parameters
    ----------
    band
        Lower and upper edge [Hz].
    sample_rate
        Sample rate [Hz].

    Raises
    ------
    SignalError
        If the edges are not increasing or not between 0 and half the sample rate.
    """
    low, high = (float(edge) for edge in band)
    top = 0.5 * sample_rate
    if not 0.0 <= low < high <= top * (1.0 + 1e-12):
        raise SignalError(f"band: {low:g} to {high:g} Hz (limit 0 to {top:g} Hz, rising); choose one inside")
    return low, high
