# SPDX-License-Identifier: Apache-2.0
"""Spectral coherence: periodic modulation over cyclic and carrier frequency, and its envelope spectra.

Derivation: docs/theory/signals.md, "Cyclostationary signals".
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.analysis.envelope import checked_band
from pitchpoint.analysis.sampled import Array, Lines, SignalError, as_signal, positive, whole
from pitchpoint.analysis.spectra import window

LONGEST = 1 << 18
"""Default maximum number of samples of a segment; it limits memory and the number of cyclic frequencies."""
LOBE = 4
"""Lines on either side to which the squared window spreads a modulation."""
CORRELATED = 4
"""Distance of carrier frequencies from which their coherences are independent, in lines."""
FALSE_ALARM = 0.01
"""Probability that stationary noise exceeds a threshold at one cyclic frequency."""
MIN_FRAMES = 64
MIRROR = 2.0
"""Distance from f = α/2 within which f and f - α are mirrored lines of a real signal: not in mean values."""
AT_ONCE = 1 << 14
"""Frames, and cyclic frequencies, processed at once."""


@dataclass(frozen=True)
class SpectralCoherence:
    """Spectral coherence of a signal and its envelope spectra.

    Attributes
    ----------
    cyclic_frequency
        Shape (n_cyclic,). Cyclic frequencies, those of the modulation [Hz].
    frequency
        Shape (n_carrier,). Carrier frequencies [Hz].
    coherence
        Shape (n_cyclic, n_carrier). Magnitude of the spectral coherence, root mean square of the segments
        [-].
    threshold
        Shape (n_cyclic,). Magnitude that stationary noise exceeds with a probability of 1 % at one pair of
        frequencies [-].
    density
        Shape (n_carrier,). Two-sided power spectral density [unit²/Hz].
    enhanced
        Shape (n_cyclic,). Enhanced envelope spectrum: mean of the coherence over all carrier frequencies [-].
    enhanced_threshold
        Shape (n_cyclic,). Value that stationary noise exceeds with a probability of 1 % [-].
    improved
        Shape (n_cyclic,). Improved envelope spectrum: mean over the band [-].
    improved_threshold
        Shape (n_cyclic,). As `enhanced_threshold` [-].
    low, high
        Edges of the band of the improved envelope spectrum [Hz].
    segments
        Number of segments [-].
    """

    cyclic_frequency: Array
    frequency: Array
    coherence: Array
    threshold: Array
    density: Array
    enhanced: Array
    enhanced_threshold: Array
    improved: Array
    improved_threshold: Array
    low: float
    high: float
    segments: int

    @property
    def correlation(self) -> Array:
        """Magnitude of the spectral correlation [unit²/Hz], shape (n_cyclic, n_carrier)."""
        below = np.abs(self.frequency - self.cyclic_frequency[:, None])
        return np.asarray(
            self.coherence * np.sqrt(self.density * np.interp(below, self.frequency, self.density))
        )


def spectral_coherence(
    values: ArrayLike,
    sample_rate: float,
    *,
    highest_cyclic: float | None = None,
    window_length: int = 256,
    segment: int | None = None,
    band: tuple[float, float] | None = None,
) -> SpectralCoherence:
    """Fast spectral coherence, enhanced and improved envelope spectrum.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Sample rate f_s [Hz].
    highest_cyclic
        Highest cyclic frequency [Hz]; default a tenth of the sample rate.
    window_length
        Samples of the window N_w [-]; the carrier frequencies are f_s/N_w apart.
    segment
        Samples of a segment [-], whose reciprocal length is the resolution of the cyclic frequency; default
        the whole record, at most 262144. Longer records are averaged over segments.
    band
        Edges of the band of the improved envelope spectrum [Hz]; default the whole range.

    Returns
    -------
    SpectralCoherence
        Cyclic frequencies from the resolution upwards.

    Raises
    ------
    SignalError
        If the record is too short for 64 frames, constant, or a frequency is out of range.

    Notes
    -----
    S(α, f) is the mean over the frames i of X(i, f) X*(i, f - α) exp(-2πiα t_i), X the short-time Fourier
    transform. X*(i, f - α) is replaced by the sum over the lines f - p Δf, and the result divided by
    Σ_p R_w(α - p Δf), the transform of the squared window [1]_; the sum is formed before the transform over
    the frames [2]_. With X of unit power, it is the coherence. The envelope spectra are mean values over f.
    For stationary noise the squared magnitude has an exponential distribution, whose mean follows from the
    overlap of the frames. Valid for random carriers, modulated by frequencies up to a tenth of the sample
    rate; tones and their products appear as coherent, too.

    References
    ----------
    .. [1] J. Antoni, G. Xin, N. Hamzaoui, Fast computation of the spectral correlation, Mechanical Systems
       and Signal Processing 92, 2017, 248-277.
    .. [2] P. Borghesani, J. Antoni, A faster algorithm for the calculation of the fast spectral correlation,
       Mechanical Systems and Signal Processing 111, 2018, 113-118.

    Examples
    --------
    White noise with the amplitude 1 + 0.5 cos has the coherence 0.5/(1 + 0.5²/2) = 0.444:

    >>> t = np.arange(20_000) / 1000.0
    >>> x = (1 + 0.5 * np.cos(2 * np.pi * 20 * t)) * np.random.default_rng(1).standard_normal(t.size)
    >>> found = spectral_coherence(x, 1000.0, window_length=64)
    >>> k = int(np.argmax(found.enhanced))
    >>> round(float(found.cyclic_frequency[k]), 1), abs(float(found.enhanced[k]) - 0.444) < 0.03
    (20.0, True)
    """
    x = as_signal(values, minimum=MIN_FRAMES)
    rate = positive(sample_rate, "sample_rate")
    length = whole(window_length, "window_length", 16)
    length += length % 2
    top = 0.1 * rate if highest_cyclic is None else positive(highest_cyclic, "highest_cyclic")
    if top > 0.25 * rate:
        raise SignalError(
            f"highest_cyclic: {top:g} Hz (limit {0.25 * rate:g} Hz, a quarter of the sample rate)"
        )
    size = min(x.size, LONGEST) if segment is None else whole(segment, "segment", length)
    lags = _Lags.of(rate, length, top)
    frames = (min(size, x.size) - length) // lags.hop + 1
    if size > x.size or frames < MIN_FRAMES:
        least = max(size if segment else 0, (MIN_FRAMES - 1) * lags.hop + length)
        raise SignalError(
            f"values: {x.size} samples (limit {least}); use a longer record or a shorter window"
        )
    frames = _fast_length(frames)
    step = rate / (lags.hop * frames)
    cyclic = np.arange(1, int(top / step) + 1, dtype=np.float64) * step
    low, high = (0.0, 0.5 * rate) if band is None else checked_band(band, rate)
    frequency = np.arange(length // 2 + 1, dtype=np.float64) * (rate / length)
    inside = (frequency >= low) & (frequency <= high)
    if not inside.any():
        raise SignalError(
            f"band: {low:g} to {high:g} Hz contains no line (spacing {rate / length:.3g} Hz); widen it"
        )
    square = np.zeros((cyclic.size, frequency.size))
    density = np.zeros(frequency.size)
    starts = np.linspace(0, x.size - size, -(-x.size // size) if x.size > size else 1).astype(np.int64)
    for start in starts:
        power = _add_segment(square, x[start : start + size] - x.mean(), lags, frames)
        density += power / (starts.size * rate)
    gain, variance, related = lags.noise(cyclic.size, frames)
    square /= starts.size * gain[:, None] ** 2
    coherence = np.sqrt(square, out=square)
    sigma = np.sqrt(variance / frames)
    enhanced, enhanced_limit = _mean(coherence, cyclic, frequency, starts.size, related)
    improved, improved_limit = _mean(coherence[:, inside], cyclic, frequency[inside], starts.size, related)
    return SpectralCoherence(
        cyclic_frequency=cyclic,
        frequency=frequency,
        coherence=coherence,
        threshold=sigma * _point_quantile(starts.size),
        density=density,
        enhanced=enhanced,
        enhanced_threshold=sigma * enhanced_limit,
        improved=improved,
        improved_threshold=sigma * improved_limit,
        low=low,
        high=high,
        segments=starts.size,
    )


@dataclass(frozen=True)
class _Lags:
    """Window, distance of the frames in samples, and number of lines whose sum replaces X(f - α)."""

    window: Array
    hop: int
    lines: int

    @classmethod
    def of(cls, rate: float, length: int, top: float) -> _Lags:
        """For cyclic frequencies up to `top`: their products with the side lobes must not be aliased."""
        own = top / rate
        hop = max(1, min(length // 4, int(1.0 / (own + 2.0 * LOBE / length))))
        return cls(window("hann", length), hop, int(np.ceil(own * length)) + LOBE // 2)

    @property
    def summed(self) -> Lines:
        """Window of the summed lines."""
        angle = 2.0 * np.pi / self.window.size * (np.arange(self.window.size) - self.window.size // 2)
        total: Lines = self.window * np.exp(1j * np.arange(self.lines + 1)[:, None] * angle).sum(axis=0)
        return total

    def noise(self, count: int, frames: int) -> tuple[Array, Array, Array]:
        """Gain, variance for noise times number of frames, and squared correlation of carriers.

        Shape (count,): at the first cyclic frequencies, which are 1/(hop frames) of the sample rate apart;
        the correlation is that of carriers one line apart and further.
        """
        w, v = self.window, self.summed
        n, power = w.size, float(np.sum(w**2))
        middle = np.arange(n) - n // 2
        shifts = np.arange(0, n, self.hop)
        gain = _transform(w * v, -middle, count, self.hop * frames) / power
        products = np.empty((CORRELATED, 2 * shifts.size - 1), np.complex128)
        steps = np.concatenate([-shifts[:0:-1], shifts])
        for j in range(CORRELATED):
            turn = np.exp(2j * np.pi * j * middle / n)
            for k, s in enumerate(steps):
                late, early = slice(max(s, 0), n + min(s, 0)), slice(max(-s, 0), n - max(s, 0))
                one = np.sum(w[late] * w[early] * turn[early])
                two = np.sum(v[late].conj() * v[early] * turn[early].conj())
                products[j, k] = one * two / power**2
        sums = [_transform(row, steps // self.hop, count, frames) for row in products]
        variance = np.maximum(sums[0].real, 1e-30)
        related = [float(np.mean(np.abs(one / variance) ** 2)) for one in sums[1:]]
        return np.abs(gain), variance / np.abs(gain) ** 2, np.array(related)


def _transform(values: Lines, at: NDArray[np.int64], count: int, period: int) -> Lines:
    """Sums of values times exp(2πi at·k/period), k = 1 ... count: a Fourier transform, shape (count,)."""
    turned = np.zeros(period, np.complex128)
    np.add.at(turned, at % period, values)
    return np.fft.ifft(turned, norm="forward")[1 : count + 1]


def _fast_length(count: int) -> int:
    """Largest number up to `count` whose Fourier transform is fast."""
    from scipy.fft import next_fast_len

    while next_fast_len(count) != count:
        count -= 1
    return count


def _add_segment(square: Array, x: Array, lags: _Lags, frames: int) -> Array:
    """Add squared magnitudes of the coherence of one segment, times the gain; return its power per line."""
    n, lines = lags.window.size, lags.window.size // 2 + 1
    cut = np.lib.stride_tricks.sliding_window_view(x, n)[:: lags.hop][:frames]
    spectra = np.empty((lines, frames), np.complex128)
    for first in range(0, frames, AT_ONCE):
        part = slice(first, min(first + AT_ONCE, frames))
        spectra[:, part] = np.fft.rfft(cut[part] * lags.window, axis=1).T
    # phases refer to the middle of the frame
    spectra[1::2] *= -1.0
    power = np.mean(np.abs(spectra) ** 2, axis=1)
    if not power.any():
        raise SignalError("values: are constant; there is nothing to analyse")
    spectra /= np.sqrt(np.maximum(power, 1e-30 * power.max()))[:, None]

    def line(k: int) -> Lines:
        """Line of either sign of a real signal."""
        found: Lines = spectra[k] if k >= 0 else spectra[-k].conj()
        return found

    total = sum((line(-p) for p in range(1, lags.lines + 1)), np.zeros(frames, np.complex128))
    for k in range(lines):
        total += line(k)
        if k > 0:
            total -= line(k - 1 - lags.lines)
        found = np.fft.fft(spectra[k] * total.conj())[1 : square.shape[0] + 1]
        square[:, k] += np.abs(found / frames) ** 2
    return np.asarray(power / np.sum(lags.window**2))


def _point_quantile(segments: int) -> float:
    """Value exceeded by the root mean square of exponential powers of unit mean with the false alarm rate."""
    from scipy.special import gammaincinv

    return float(np.sqrt(gammaincinv(segments, 1.0 - FALSE_ALARM) / segments))


def _mean(
    coherence: Array, cyclic: Array, frequency: Array, segments: int, related: Array
) -> tuple[Array, float]:
    """Mean over the carriers, shape (n_cyclic,), and its quantile for noise over the standard deviation."""
    reach = MIRROR * (frequency[1] - frequency[0]) if frequency.size > 1 else 0.0
    counted = np.abs(frequency - 0.5 * cyclic[:, None]) > reach
    counted[counted.sum(axis=1) < 0.5 * frequency.size] = True
    number = counted.sum(axis=1)
    mean = np.einsum("ij,ij->i", coherence, counted) / number
    return mean, _quantile(segments, related, int(number.min()))


def _quantile(segments: int, related: Array, carriers: int) -> float:
    """Value exceeded by the mean of such root mean squares over correlated carriers.

    A gamma distribution of the same mean and variance.
    """
    from scipy.special import gammaincinv, gammaln

    mean = float(np.exp(gammaln(segments + 0.5) - gammaln(segments)) / np.sqrt(segments))
    apart = np.arange(1, min(carriers, CORRELATED))
    spread = 1.0 + 2.0 * float(np.sum((1.0 - apart / carriers) * related[apart - 1]))
    variance = (1.0 - mean**2) * spread / carriers
    shape = mean**2 / variance
    return float(gammaincinv(shape, 1.0 - FALSE_ALARM) * variance / mean)
