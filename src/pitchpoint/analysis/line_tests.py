# SPDX-License-Identifier: Apache-2.0
"""Is there a line, is there a comb of lines? Tests with a stated probability of false alarm.

Nothing is known of the noise but that it changes slowly along the spectrum: a line is compared with points
next to it, a comb with points between its teeth. Frequencies may be in Hz or in orders of a shaft.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array, as_signal, positive

PADDING = 4
"""Points per line of the record: between them a tone loses less than 1 % of its amplitude."""
BLOCK = 16
"""Lines of a comb that are ranked together: the noise may change from block to block."""
LONG = 1 << 21
"""Samples above which a record is transformed in `PARTS` parts, whose result is combined `AT_ONCE` points at
a time: 300 MB of text are 10 million samples, whose transform in one piece takes 1.5 GB."""
PARTS, AT_ONCE = 16, 1 << 18


@dataclass(frozen=True)
class FineSpectrum:
    """Amplitudes of a record under a Hann window, finer than its lines.

    Attributes
    ----------
    amplitude
        Shape (n,). Peak amplitudes, in the unit of the signal.
    step
        Distance of the points [Hz, or orders].
    resolution
        Reciprocal of the length of the record [Hz, or orders].
    """

    amplitude: Array
    step: float
    resolution: float

    def power(self, frequency: ArrayLike) -> Array:
        """Squares of the amplitudes at the points next to these frequencies, shape of `frequency`."""
        at = np.rint(np.asarray(frequency, dtype=np.float64) / self.step).astype(np.int64)
        found: Array = self.amplitude[np.clip(at, 0, self.amplitude.size - 1)] ** 2
        return found

    @property
    def highest(self) -> float:
        """End of the spectrum."""
        return float(self.step * (self.amplitude.size - 1))


def fine_spectrum(values: ArrayLike, sample_rate: float) -> FineSpectrum:
    """Amplitude spectrum that can be read between its lines.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Samples per second [Hz], or per turn.

    Returns
    -------
    FineSpectrum
        From zero to half the sample rate.

    Notes
    -----
    Hann window and zeros behind the record; tones two lines apart do not see each other [1]_. Valid for
    steady tones.

    References
    ----------
    .. [1] F. J. Harris, On the use of windows for harmonic analysis with the discrete Fourier transform,
       Proceedings of the IEEE 66(1), 1978, 51-83.

    Examples
    --------
    >>> t = np.arange(1000) / 1000.0
    >>> spectrum = fine_spectrum(3.0 * np.cos(2 * np.pi * 40.5 * t), 1000.0)
    >>> round(float(np.sqrt(spectrum.power(40.5))), 2)
    3.0
    """
    from scipy.fft import next_fast_len

    x = as_signal(values, minimum=16)
    rate = positive(sample_rate, "sample_rate")
    parts = PARTS if x.size > LONG else 1
    size = int(next_fast_len(-(-PADDING * x.size // parts), real=True))
    amplitude = _transform(x, size, parts)
    amplitude *= 4.0 / x.size  # twice over the sum of a Hann window, half its length
    return FineSpectrum(amplitude, rate / (parts * size), rate / x.size)


def _transform(x: Array, size: int, parts: int) -> Array:
    """Magnitudes of the Fourier transform of a record with a Hann window and zeros behind it.

    Decimation in time: one transform of `size` points for every `parts`-th sample, combined by blocks. With
    one part it is the usual transform; with more, a long record needs a third of the memory.
    """
    from scipy.fft import rfft

    length, mean = parts * size, float(x.mean())
    lines = np.empty((parts, size // 2 + 1), np.complex128)
    for p in range(parts):
        own = x[p::parts] - mean
        own *= 0.5 - 0.5 * np.cos(np.arange(p, x.size, parts) * (2.0 * np.pi / x.size))
        lines[p] = rfft(own, size)
    found = np.empty(length // 2 + 1)
    for first in range(0, found.size, AT_ONCE):
        k = np.arange(first, min(first + AT_ONCE, found.size))
        m = k % size
        beyond = m > size // 2  # the transform of real samples repeats mirrored
        at = np.where(beyond, size - m, m)
        turn = np.exp(k * (-2j * np.pi / length))
        total = np.zeros(k.size, np.complex128)
        for p in range(parts - 1, -1, -1):
            one = lines[p, at]
            total = total * turn + np.where(beyond, one.conj(), one)
        found[first : first + k.size] = np.abs(total)
    return found


def line_probability(ratio: float, points: int, rank: int) -> float:
    """Probability that noise alone rises so far above the points next to it.

    Parameters
    ----------
    ratio
        Power at the frequency over the `rank`-th smallest of the powers next to it [-].
    points
        Number of points next to it [-].
    rank
        Which of them, counted from the smallest one [-].

    Returns
    -------
    float
        Probability [-].

    Notes
    -----
    Π (M - j + 1)/(M - j + 1 + t), j = 1 ... r: the detector of [1]_, whose threshold is an order statistic,
    so
    that a few other lines among the M points do no harm. Valid where the lines of the noise are complex
    Gaussian and of one level over the points.

    References
    ----------
    .. [1] H. Rohling, Radar CFAR thresholding in clutter and multiple target situations, IEEE Transactions on
       Aerospace and Electronic Systems 19(4), 1983, 608-621.

    Examples
    --------
    >>> round(line_probability(1.0, 1, 1), 3), round(line_probability(20.0, 16, 12), 7)
    (0.5, 1.5e-06)
    """
    left = points - np.arange(rank)
    return float(np.prod(left / (left + max(ratio, 0.0))))


def line_threshold(probability: float, points: int, rank: int) -> float:
    """Ratio of powers that noise alone exceeds with this probability [-]; the inverse of `line_probability`.

    Parameters
    ----------
    probability
        Probability of false alarm [-].
    points, rank
        As in `line_probability` [-].

    Notes
    -----
    Root of the falling function by bisection of its logarithm [1]_. Valid for probabilities above 1e-12.

    References
    ----------
    .. [1] R. P. Brent, Algorithms for Minimization without Derivatives, Prentice-Hall, 1973.

    Examples
    --------
    >>> round(line_threshold(0.5, 1, 1), 6)
    1.0
    """
    from scipy.optimize import brentq

    def excess(log_ratio: float) -> float:
        """Logarithm of the chance of a line so far above its neighbours, over the chance wanted [-]."""
        return float(np.log(line_probability(np.exp(log_ratio), points, rank) / probability))

    return float(np.exp(brentq(excess, -30.0, 60.0)))


def comb_score(lines: ArrayLike, between: ArrayLike, block: ArrayLike, block_between: ArrayLike) -> float:
    """How far the teeth of a comb are above the points between them.

    Parameters
    ----------
    lines
        Powers at the frequencies of the comb, shape (n,).
    between
        Powers at points between them, shape (m,).
    block, block_between
        Number of the block that each of them belongs to, shapes (n,) and (m,): only points of one block are
        compared with each other [-].

    Returns
    -------
    float
        Standard normal score [-]; 0 if nothing can be compared.

    Notes
    -----
    Rank sum within blocks, summed over them with equal weight of all lines [1]_. It needs no distribution
    of the noise, and one single line does not move it. Valid where lines and points of a block are
    exchangeable if there is no comb; the normal score is right from three blocks or sixteen lines on.

    References
    ----------
    .. [1] P. van Elteren, On the combination of independent two-sample tests of Wilcoxon, Bulletin of the
       International Statistical Institute 37, 1960, 351-361.

    Examples
    --------
    Four lines that are larger than four points: the rank sum is 26 of a mean of 18, its variance 12.

    >>> zero = np.zeros(4)
    >>> round(comb_score([5, 6, 7, 8], [1, 2, 3, 4], zero, zero), 4)
    2.3094
    """
    above, inside = np.asarray(lines, dtype=np.float64), np.asarray(between, dtype=np.float64)
    first, second = np.asarray(block), np.asarray(block_between)
    excess = variance = 0.0
    for number in np.unique(first):
        one, two = above[first == number], np.sort(inside[second == number])
        n, m = one.size, two.size
        if m < 2:
            continue
        # pairs in which the line is larger, equal ones by half: the rank sum less n (n + 1)/2
        larger = two.searchsorted(one, "left").sum() + two.searchsorted(one, "right").sum()
        excess += 0.5 * float(larger - n * m)
        variance += n * m * (n + m + 1) / 12.0
    return excess / float(np.sqrt(variance)) if variance > 0.0 else 0.0


def neighbours(powers: Array, frequency: Array, wanted: float, points: int) -> tuple[Array, Array]:
    """Powers at the nearest points left and right of a frequency, at most `points` each.

    Parameters
    ----------
    powers, frequency
        Powers and their frequencies in rising order, shape (n,) each.
    wanted
        Frequency [Hz, or orders].
    points
        Most points on either side [-].

    Notes
    -----
    Both sides apart, as on a slope only the higher one is a fair neighbour [1]_.

    References
    ----------
    .. [1] V. G. Hansen, J. H. Sawyers, Detectability loss due to greatest of selection in a cell-averaging
       CFAR, IEEE Transactions on Aerospace and Electronic Systems 16(1), 1980, 115-118.

    Examples
    --------
    >>> left, right = neighbours(np.array([1.0, 2.0, 3.0, 4.0]), np.array([1.0, 2.0, 3.0, 4.0]), 2.5, 1)
    >>> left.tolist(), right.tolist()
    ([2.0], [3.0])
    """
    at = int(np.searchsorted(frequency, wanted))
    return powers[max(at - points, 0) : at], powers[at : at + points]
