# SPDX-License-Identifier: Apache-2.0
"""Tests for lines and combs of lines in a spectrum, with a stated false alarm probability.

The only assumption is that the noise density changes slowly along the spectrum: a line is compared with the
points next to it, a comb with the points between its lines. Frequencies are in Hz or in shaft orders.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.analysis.sampled import Array, as_signal, positive

PADDING, PADDING_OF_LONG = 4, 2
"""Points per line of the record: a tone between two points loses less than 1 % of its amplitude, 4 % in a
long record."""
BLOCK = 16
"""Lines of a comb that are ranked together: the noise may change from block to block."""
LONG = 1 << 21
"""Number of samples above which a record is transformed in `PARTS` parts, to limit memory: a single
transform of 10 million samples takes 1.5 GB."""
PARTS, TOGETHER, AT_ONCE = 64, 4, 1 << 17
"""Number of parts, of parts computed at once, and of points for which samples are added up at once."""


@dataclass(frozen=True)
class FineSpectrum:
    """Zero-padded amplitude spectrum of a record with a Hann window.

    Attributes
    ----------
    amplitude
        Shape (n,). Peak amplitudes, in the unit of the signal; in single precision for more than `LONG`
        samples.
    step
        Spacing of the points [Hz, or orders].
    resolution
        Reciprocal of the length of the record [Hz, or orders].
    """

    amplitude: NDArray[np.floating[Any]]
    step: float
    resolution: float

    def power(self, frequency: ArrayLike) -> Array:
        """Squared amplitudes at the points nearest to the frequencies, shape of `frequency`."""
        at = np.rint(np.asarray(frequency, dtype=np.float64) / self.step).astype(np.int64)
        found = self.amplitude[np.clip(at, 0, self.amplitude.size - 1)]
        return np.asarray(found, dtype=np.float64) ** 2

    @property
    def highest(self) -> float:
        """Highest frequency of the spectrum."""
        return float(self.step * (self.amplitude.size - 1))


def fine_spectrum(values: ArrayLike, sample_rate: float) -> FineSpectrum:
    """Amplitude spectrum with points between its lines.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Samples per second [Hz], or per revolution.

    Returns
    -------
    FineSpectrum
        From zero to half the sample rate.

    Notes
    -----
    Hann window and zero padding; tones at least two lines apart are separated [1]_. Valid for steady tones.

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
    padding = PADDING if parts == 1 else PADDING_OF_LONG
    size = int(next_fast_len(-(-padding * x.size // parts), real=True))
    amplitude = hann_transform(x, size, parts, np.float64 if parts == 1 else np.float32)
    amplitude *= 4.0 / x.size  # twice over the sum of a Hann window, half its length
    return FineSpectrum(amplitude, rate / (parts * size), rate / x.size)


def hann_transform(x: Array, size: int, parts: int, kind: type[Any] = np.float64) -> NDArray[Any]:
    """Magnitudes of the Fourier transform of a record with a Hann window and zero padding.

    Parameters
    ----------
    x
        Samples, shape (n,), any unit; their mean is removed.
    size
        Points of the transform of every part [-], at least n/parts.
    parts
        Number of parts [-]: 1, or an even number, such as `PARTS` for more than `LONG` samples.
    kind
        Type of the magnitudes.

    Returns
    -------
    NDArray
        Magnitudes at the points 0 ... parts·size/2, shape (parts·size/2 + 1,), in the unit of the samples.

    Notes
    -----
    Decimation in frequency [1]_: the points r, r + parts, r + 2 parts ... are one transform of `size` points,
    of samples that are `size` apart added with their phases. Besides the result it requires the memory of
    `TOGETHER` + 1 parts. Valid for any number of samples.

    References
    ----------
    .. [1] W. M. Gentleman, G. Sande, Fast Fourier transforms for fun and profit, Proceedings of the AFIPS
       Fall Joint Computer Conference 29, 1966, 563-578.

    Examples
    --------
    The sum of the window, half the number of samples, times half of the amplitude:

    >>> x = np.cos(2 * np.pi * 10 * np.arange(64) / 64)
    >>> round(float(hann_transform(x, 64, 1)[10]), 9), round(float(hann_transform(x, 16, 4)[10]), 9)
    (16.0, 16.0)
    """
    from scipy.fft import fft, rfft

    length, mean = parts * size, float(x.mean())
    if parts == 1:
        return np.abs(rfft(_windowed(x, 0, x.size, mean), size)).astype(kind, copy=False)
    found = np.empty(length // 2 + 1, kind)
    rows = -(-x.size // size)
    for first in range(0, parts // 2 + 1, TOGETHER):
        chosen = np.arange(first, min(first + TOGETHER, parts // 2 + 1))
        phase = np.exp(-2j * np.pi / parts * np.outer(chosen, np.arange(rows)))
        lines = np.empty((chosen.size, size), np.complex128)
        for start in range(0, size, AT_ONCE):
            stop = min(start + AT_ONCE, size)
            block = np.zeros((rows, stop - start))
            for row in range(rows):
                own = _windowed(x, row * size + start, row * size + stop, mean)
                block[row, : own.size] = own
            turn = np.exp(np.outer(chosen, np.arange(start, stop)) * (-2j * np.pi / length))
            lines[:, start:stop] = (phase.real @ block + 1j * (phase.imag @ block)) * turn
        for row, r in enumerate(chosen.tolist()):
            own = np.abs(fft(lines[row], overwrite_x=True))
            found[r::parts] = own[: found[r::parts].size]
            if 0 < r < parts // 2:  # the transform of real samples repeats mirrored
                mirrored = found[parts - r :: parts]
                mirrored[:] = own[::-1][: mirrored.size]
    return found


def _windowed(x: Array, start: int, stop: int, mean: float) -> Array:
    """Part of a record less the mean, times the Hann window of the record; short at the end of the record."""
    own = x[start:stop] - mean
    own *= 0.5 - 0.5 * np.cos(np.arange(start, start + own.size) * (2.0 * np.pi / x.size))
    return own


def line_probability(ratio: float, points: int, rank: int) -> float:
    """Probability that noise alone exceeds the adjacent points by a ratio.

    Parameters
    ----------
    ratio
        Power at the frequency over the `rank`-th smallest of the adjacent powers [-].
    points
        Number of adjacent points [-].
    rank
        Rank of the reference among them, from the smallest [-].

    Returns
    -------
    float
        Probability [-].

    Notes
    -----
    Π (M - j + 1)/(M - j + 1 + t), j = 1 ... r: the detector of [1]_ with an order statistic as reference, so
    that a few other lines among the M points have no effect. Valid for complex Gaussian noise of equal level
    over the points.

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
    """Ratio of powers that noise alone exceeds with a probability [-], inverse of `line_probability`.

    Parameters
    ----------
    probability
        Probability of false alarm [-].
    points, rank
        As in `line_probability` [-].

    Notes
    -----
    Root of the decreasing function in logarithms by Brent's method [1]_. Valid for probabilities above 1e-12.

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
        """Logarithm of the probability at a ratio over the required probability [-]."""
        return float(np.log(line_probability(np.exp(log_ratio), points, rank) / probability))

    return float(np.exp(brentq(excess, -30.0, 60.0)))


def comb_score(lines: ArrayLike, between: ArrayLike, block: ArrayLike, block_between: ArrayLike) -> float:
    """Normal score of the lines of a comb against the points between them.

    Parameters
    ----------
    lines
        Powers at the frequencies of the comb, shape (n,).
    between
        Powers at points between them, shape (m,).
    block, block_between
        Block number of each line and point, shapes (n,) and (m,) [-]; comparisons are within blocks.

    Returns
    -------
    float
        Standard normal score [-]; 0 if nothing can be compared.

    Notes
    -----
    Rank sums within blocks, summed over the blocks with equal weight of all lines [1]_. Independent of the
    distribution of the noise and insensitive to a single line. Valid if lines and points of a block are
    exchangeable without a comb; the normal approximation holds for three blocks or sixteen lines or more.

    References
    ----------
    .. [1] P. van Elteren, On the combination of independent two-sample tests of Wilcoxon, Bulletin of the
       International Statistical Institute 37, 1960, 351-361.

    Examples
    --------
    Four lines larger than four points: the rank sum is 26 with a mean of 18 and a variance of 12.

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
        # number of pairs with a larger line, ties by half: the rank sum less n (n + 1)/2
        larger = two.searchsorted(one, "left").sum() + two.searchsorted(one, "right").sum()
        excess += 0.5 * float(larger - n * m)
        variance += n * m * (n + m + 1) / 12.0
    return excess / float(np.sqrt(variance)) if variance > 0.0 else 0.0


def neighbours(powers: Array, frequency: Array, wanted: float, points: int) -> tuple[Array, Array]:
    """Powers at the nearest points left and right of a frequency, at most `points` each.

    Parameters
    ----------
    powers, frequency
        Powers and their frequencies in increasing order, shape (n,) each.
    wanted
        Frequency [Hz, or orders].
    points
        Maximum number of points on either side [-].

    Notes
    -----
    The sides are separate, because on a slope only the higher side is a valid reference [1]_.

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
