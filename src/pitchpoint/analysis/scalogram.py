# SPDX-License-Identifier: Apache-2.0
"""Scalograms: amplitudes over time and frequency by the continuous wavelet transform."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.analysis.sampled import Array, SignalError, as_signal, positive
from pitchpoint.analysis.wavelets import check_extension, unknown

NUMBERED = {"cmor": "cmor1.5-1.0", "shan": "shan1.5-1.0", "fbsp": "fbsp2-1-1.5"}
"""Continuous families with numbers in their names, each with an example."""

PER_OCTAVE = 12
"""Default rows per octave; the amplitude of the complex Morlet wavelet drops to half within 0.28 octaves."""
MAX_AMPLITUDES = 30_000_000
"""Maximum number of amplitudes of one map: 0.24 GB."""


@dataclass(frozen=True)
class Scalogram:
    """Amplitudes of the continuous wavelet transform over time and frequency.

    Attributes
    ----------
    time
        Shape (n,). Time [s], from `start`.
    frequency
        Shape (n_line,). Frequencies of the rows [Hz].
    amplitude
        Shape (n_line, n). Peak amplitude of the sine of that frequency, in the unit of the signal.
    edge
        Shape (n_line,). Time from either end of the record [s] affected by the extension: half width of the
        central interval with 95 % of the area under |psi|.
    wavelet, extension
        Wavelet and extension used.
    """

    time: Array
    frequency: Array
    amplitude: Array
    edge: Array
    wavelet: str
    extension: str


def scalogram(
    values: ArrayLike,
    sample_rate: float,
    frequencies: ArrayLike | None = None,
    *,
    wavelet: str = "cmor1.5-1.0",
    extension: str = "symmetric",
    start: float = 0.0,
) -> Scalogram:
    """Continuous wavelet transform as a map of amplitudes over time and frequency.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit; their mean is removed.
    sample_rate
        Sample rate f_s [Hz].
    frequencies
        Frequencies of the rows [Hz], shape (n_line,), above 1/record and below f_s/2; default 12 per octave
        from 4/record, below which the extension affects the whole record.
    wavelet
        Name of a continuous wavelet, such as `cmor1.5-1.0` (complex Morlet, bandwidth 1.5, centre 1),
        `mexh`, `gaus4`, `shan1.5-1.0`. A complex wavelet gives a smooth amplitude, a real one oscillates.
    extension
        Extension of the record beyond its ends, see `wavelets`.
    start
        Time of the first sample [s].

    Returns
    -------
    Scalogram
        One row per frequency.

    Raises
    ------
    SignalError
        If a frequency is out of range, or wavelet or extension are unknown.

    Notes
    -----
    W(f, t) = Σ_k x_k psi*((t_k - t)/s)/G with s = f_c/f [1]_. G is the response of the sampled wavelet to a
    sine of the frequency f (half of it for a complex wavelet, which responds to one of its two lines only),
    so that a steady sine has its peak amplitude in its row. Valid between the `edge` times.

    References
    ----------
    .. [1] C. Torrence, G. P. Compo, A practical guide to wavelet analysis, Bulletin of the American
       Meteorological Society 79(1), 1998, 61-78.

    Examples
    --------
    One octave above the sine the response of this wavelet is exp(-1.5 (π/2)²) = 2.5 %:

    >>> t = np.arange(4000) / 1000.0
    >>> found = scalogram(3.0 * np.sin(2 * np.pi * 50.0 * t), 1000.0, [25.0, 50.0, 100.0])
    >>> [round(float(a), 3) for a in found.amplitude[:, 2000]]
    [0.0, 3.0, 0.074]
    """
    import pywt
    from scipy.signal import fftconvolve

    x = as_signal(values, minimum=16)
    rate = positive(sample_rate, "sample_rate")
    low, high = rate / x.size, 0.5 * rate
    lines = _octaves(4.0 * low, high) if frequencies is None else as_signal(frequencies, "frequencies", 1)
    wrong = lines[(lines < low) | (lines >= high)]
    if wrong.size:
        raise SignalError(
            f"frequencies: {wrong[0]:.6g} Hz (limit {low:.6g} to below {high:.6g} Hz); use a longer record "
            "or a higher sample rate"
        )
    if lines.size * x.size > MAX_AMPLITUDES:
        raise SignalError(
            f"frequencies: {lines.size} rows of {x.size} samples (limit {MAX_AMPLITUDES // x.size} rows); "
            "request fewer frequencies, or use a shorter or slower record"
        )
    family = _continuous(wavelet)
    check_extension(extension)
    psi, support = family.wavefun(level=12)
    centre = pywt.central_frequency(family, precision=12)
    half_area = _half_width(np.abs(psi), support)
    x = x - x.mean()
    amplitude = np.empty((lines.size, x.size))
    edge = np.empty(lines.size)
    for row, f in enumerate(lines):
        scale = centre * rate / f
        half = int(np.ceil(scale * float(np.max(np.abs(support)))))
        kernel = _sampled(psi, support, np.arange(-half, half + 1) / scale)
        turning = np.exp(2j * np.pi * f / rate * np.arange(-half, half + 1))
        # some complex families have the opposite sense of rotation
        gain = max(abs(np.sum(kernel * turning)), abs(np.sum(kernel * np.conj(turning))))
        gain *= 0.5 if np.iscomplexobj(psi) else 1.0
        extended = pywt.pad(x, half, extension)
        amplitude[row] = np.abs(fftconvolve(extended, np.conj(kernel[::-1]), mode="valid")) / gain
        edge[row] = half_area * scale / rate
    return Scalogram(
        time=start + np.arange(x.size) / rate,
        frequency=lines,
        amplitude=amplitude,
        edge=edge,
        wavelet=wavelet,
        extension=extension,
    )


def _octaves(low: float, high: float) -> Array:
    """Frequencies from `low` to below `high`, `PER_OCTAVE` per octave."""
    steps = int(np.ceil(PER_OCTAVE * np.log2(high / low)))
    return np.asarray(low * 2.0 ** (np.arange(steps) / PER_OCTAVE), dtype=np.float64)


def _continuous(name: str) -> Any:
    """Continuous wavelet of a name; raises if it is unknown or lacks its numbers."""
    import pywt

    letters = name.rstrip("0123456789.-")
    if letters in NUMBERED:
        if name == letters:
            raise SignalError(f"wavelet: {name!r} lacks its numbers; write such as {NUMBERED[name]!r}")
    elif name not in pywt.wavelist(kind="continuous"):
        raise unknown("wavelet", name, pywt.wavelist(kind="continuous"))
    try:
        return pywt.ContinuousWavelet(name)
    except ValueError as error:
        raise SignalError(f"wavelet: {name!r} is unknown; write such as {NUMBERED[letters]!r}") from error


def _sampled(psi: NDArray[Any], support: Array, at: Array) -> NDArray[Any]:
    """Tabulated wavelet interpolated at other points, zero beyond its support."""
    real = np.interp(at, support, psi.real, left=0.0, right=0.0)
    if not np.iscomplexobj(psi):
        return real
    return real + 1j * np.interp(at, support, psi.imag, left=0.0, right=0.0)


def _half_width(weight: Array, support: Array) -> float:
    """Half width of the interval about zero with 95 % of the area under a curve."""
    order = np.argsort(np.abs(support))
    share = np.cumsum(weight[order]) / weight.sum()
    return float(np.abs(support[order][np.searchsorted(share, 0.95)]))
