# SPDX-License-Identifier: Apache-2.0
"""Amplitudes and exact frequencies of lines near known frequencies: harmonics of shafts and meshes.

The lines of a spectrum have a spacing of 1/T. A steady tone between two lines is determined exactly by
interpolation, because the line shape of the window is known.

Source: Grandke, IEEE Trans. Instrum. Meas. 32 (1983) 350.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array, SignalError, as_signal, positive, whole
from pitchpoint.analysis.spectra import Spectrum, amplitude_spectrum

APART = 4
"""Minimum spacing of two tones, in lines, at which the main lobes of the Hann window do not overlap."""
AROUND = 32
"""Number of lines on either side of a tone whose median is its background."""


@dataclass(frozen=True)
class Tones:
    """Lines of a signal near expected frequencies.

    Attributes
    ----------
    expected, frequency
        Shape (n,). Expected and found frequency [Hz].
    amplitude
        Shape (n,). Peak amplitude, in the unit of the signal.
    background
        Shape (n,). Median amplitude of the surrounding lines, in the unit of the signal.
    is_peak
        Shape (n,). Whether there is a local maximum within reach; otherwise frequency and amplitude are those
        of the highest line within reach.
    resolution
        Line spacing [Hz].
    """

    expected: Array
    frequency: Array
    amplitude: Array
    background: Array
    is_peak: np.ndarray
    resolution: float


@dataclass(frozen=True)
class HarmonicTable:
    """Harmonics of one frequency.

    Attributes
    ----------
    harmonic
        Shape (n,). Numbers of the harmonics, from 1 [-].
    frequency
        Shape (n,). Frequencies found [Hz].
    amplitude
        Shape (n,). Peak amplitudes, in the unit of the signal.
    background
        Shape (n,). Median amplitude of the surrounding lines, in the unit of the signal.
    fundamental
        Fundamental frequency that fits all harmonics best [Hz]; NaN if none of them is a peak.
    lost
        Number of requested harmonics above half the sample rate [-].
    """

    harmonic: Array
    frequency: Array
    amplitude: Array
    background: Array
    fundamental: float
    lost: int


def read_tones(values: ArrayLike, sample_rate: float, expected: ArrayLike, *, reach: ArrayLike) -> Tones:
    """Frequency and amplitude of the highest lines near given frequencies, by interpolation.

    Parameters
    ----------
    values
        Samples, shape (n_sample,), any unit.
    sample_rate
        Sample rate f_s [Hz].
    expected
        Frequencies [Hz], shape (n,), above 0 and below f_s/2.
    reach
        Search range on either side of each frequency [Hz], a number or shape (n,); at least one line.

    Returns
    -------
    Tones
        One line per frequency, however small.

    Raises
    ------
    SignalError
        If a frequency is outside the spectrum, or an input is unsuitable.

    Notes
    -----
    With a Hann window a line a_k and its higher neighbour a_(k±1) = α a_k are due to a tone at
    δ = (2α - 1)/(α + 1) lines from k, with the amplitude a_k πδ (1 - δ²)/sin πδ [1]_. Exact for a steady tone
    at least four lines away from others and from 0.

    References
    ----------
    .. [1] T. Grandke, Interpolation algorithms for discrete Fourier transforms of weighted signals, IEEE
       Transactions on Instrumentation and Measurement 32(2), 1983, 350-355.

    Examples
    --------
    A line spacing of 0.5 Hz and a tone between two lines:

    >>> t = np.arange(2000) / 1000.0
    >>> found = read_tones(3.0 * np.cos(2 * np.pi * 135.667 * t), 1000.0, [135.0], reach=2.0)
    >>> round(float(found.frequency[0]), 4), round(float(found.amplitude[0]), 4)
    (135.667, 3.0)
    """
    spectrum = amplitude_spectrum(values, sample_rate)
    wanted = as_signal(expected, "expected", 1)
    top = 0.5 * float(sample_rate)
    outside = np.flatnonzero((wanted <= 0.0) | (wanted >= top))
    if outside.size:
        raise SignalError(
            f"expected: {wanted[outside[0]]:g} Hz is outside the spectrum (limit 0 to {top:g} Hz, half the "
            "sample rate); increase the sampling rate or request fewer"
        )
    far = np.broadcast_to(np.asarray(reach, dtype=np.float64), wanted.shape)
    rows = [_near(spectrum, float(f), float(w)) for f, w in zip(wanted, far, strict=True)]
    frequency, amplitude, background, is_peak = (np.array(column) for column in zip(*rows, strict=True))
    return Tones(wanted, frequency, amplitude, background, is_peak.astype(bool), spectrum.resolution)


def harmonic_table(
    values: ArrayLike, sample_rate: float, fundamental: float, *, harmonics: int = 5, tolerance: float = 0.01
) -> HarmonicTable:
    """Harmonics of an approximately known frequency, and the fundamental that fits them.

    Parameters
    ----------
    values
        Samples, shape (n_sample,), any unit.
    sample_rate
        Sample rate f_s [Hz].
    fundamental
        Approximate frequency of the first harmonic [Hz].
    harmonics
        Number of harmonics [-].
    tolerance
        Relative tolerance of the fundamental [-].

    Returns
    -------
    HarmonicTable
        One row per harmonic below f_s/2.

    Raises
    ------
    SignalError
        If no harmonic is below f_s/2, or the record has fewer than four periods.

    Notes
    -----
    `read_tones` at k f_0; the fundamental is Σ A_k² k f_k/Σ A_k² k² over the peaks [1]_. Valid for constant
    speed; resample a record of varying speed over the angle first.

    References
    ----------
    .. [1] T. Grandke, Interpolation algorithms for discrete Fourier transforms of weighted signals, IEEE
       Transactions on Instrumentation and Measurement 32(2), 1983, 350-355.

    Examples
    --------
    Two seconds of a mesh frequency of 20.0988 Hz, with 20 Hz as the approximate value:

    >>> t = np.arange(2000) / 1000.0
    >>> x = np.cos(2 * np.pi * 20.0988 * t) + 0.5 * np.cos(2 * np.pi * 40.1976 * t)
    >>> table = harmonic_table(x, 1000.0, 20.0, harmonics=2)
    >>> round(table.fundamental, 4), table.amplitude.round(3).tolist()
    (20.0988, [1.0, 0.5])
    """
    x = as_signal(values, minimum=4)
    rate, first = positive(sample_rate, "sample_rate"), positive(fundamental, "fundamental")
    slack = positive(tolerance, "tolerance")
    number, lost = kept_harmonics(first, rate, harmonics)
    resolution = rate / x.size
    require_resolved(first, resolution, "fundamental")
    reach = np.minimum(slack * number * first, 0.5 * first)
    found = read_tones(x, rate, number * first, reach=reach)
    weight = np.where(found.is_peak, found.amplitude, 0.0) ** 2
    total = float(np.sum(weight * number**2))
    return HarmonicTable(
        harmonic=number,
        frequency=found.frequency,
        amplitude=found.amplitude,
        background=found.background,
        fundamental=float(np.sum(weight * number * found.frequency)) / total if total > 0.0 else float("nan"),
        lost=lost,
    )


def kept_harmonics(fundamental: float, sample_rate: float, harmonics: int) -> tuple[Array, int]:
    """Numbers of the harmonics below half the sample rate, shape (n,), and the number of those above it.

    Parameters
    ----------
    fundamental
        Frequency of the first harmonic [Hz].
    sample_rate
        Sample rate f_s [Hz].
    harmonics
        Requested number of harmonics [-].

    Raises
    ------
    SignalError
        If the first harmonic is not below f_s/2.
    """
    wanted = whole(harmonics, "harmonics")
    kept = min(wanted, int(np.ceil(0.5 * sample_rate / fundamental)) - 1)
    if kept < 1:
        raise SignalError(
            f"sample_rate: {sample_rate:g} Hz is too low for any harmonic of {fundamental:g} Hz "
            f"(limit > {2.0 * fundamental:g} Hz); sample faster"
        )
    return np.arange(1.0, kept + 1.0), wanted - kept


def require_resolved(distance: float, resolution: float, name: str) -> None:
    """Raise if a record is too short to resolve two tones.

    Parameters
    ----------
    distance
        Distance between two tones [Hz].
    resolution
        Line spacing of the spectrum [Hz].
    name
        Name of the distance in error messages.

    Raises
    ------
    SignalError
        If the distance is below `APART` lines.
    """
    if distance < APART * resolution:
        raise SignalError(
            f"{name}: {distance:g} Hz is not resolved by the line spacing of {resolution:.3g} Hz (limit "
            f"{APART} lines); use a record of {APART / distance:.3g} s or longer"
        )


def _near(spectrum: Spectrum, expected: float, reach: float) -> tuple[float, float, float, bool]:
    """Frequency, amplitude and background of the highest line near a frequency, and whether it is a peak."""
    a, step = spectrum.amplitude, spectrum.resolution
    middle = expected / step
    half = max(reach / step, 1.0)
    low, high = max(1, int(np.ceil(middle - half))), min(a.size - 2, int(np.floor(middle + half)))
    low, high = min(low, a.size - 2), max(high, low)
    k = low + int(np.argmax(a[low : high + 1]))
    background = float(np.median(a[max(1, k - AROUND) : k + AROUND + 1]))
    # a higher line just outside the search range belongs to another tone
    if max(a[k - 1], a[k + 1]) > a[k] or a[k] == 0.0:
        return k * step, float(a[k]), background, False
    side = 1 if a[k + 1] >= a[k - 1] else -1
    alpha = float(a[k + side] / a[k])
    delta = max((2.0 * alpha - 1.0) / (alpha + 1.0), 0.0)
    scale = 1.0 if delta == 0.0 else np.pi * delta * (1.0 - delta**2) / np.sin(np.pi * delta)
    return (k + side * delta) * step, float(a[k] * scale), background, True
