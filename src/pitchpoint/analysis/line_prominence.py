# SPDX-License-Identifier: Apache-2.0
"""Levels of spectral lines above the running median of the spectrum, with their probability in noise."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.line_tests import LONG, PARTS, hann_transform
from pitchpoint.analysis.running_median import running_median
from pitchpoint.analysis.sampled import Array, SignalError, as_signal, positive, whole

OMITTED = 2
"""Lines at zero frequency that the removed mean affects through the Hann window."""
MIN_BACKGROUND = 32
"""Minimum number of lines of the running median."""
DEFAULT_BACKGROUND = 128
"""Default number of lines of the running median."""
APART = 2
"""Distance of averaged lines: with a Hann window their noise powers are almost independent."""
HANN_POWER = 1.0 / 36.0
"""Correlation of the noise powers of lines two apart with a Hann window [-]; of lines one apart 4/9, further
ones 0."""


@dataclass(frozen=True)
class LineProminence:
    """Lines of a spectrum relative to their background.

    Attributes
    ----------
    frequency
        Shape (n,). Frequencies [Hz], or orders [-], from the third line up to below half the sample rate.
    amplitude
        Shape (n,). Peak amplitudes, root mean square of the averaged lines, in the unit of the signal.
    background
        Shape (n,). Median amplitude of the neighbourhood, in the unit of the signal.
    prominence
        Shape (n,). Level of the lines above the background [dB].
    probability
        Shape (n,). Probability that noise alone reaches the prominence, of each line by itself [-].
    resolution
        Distance of the lines [Hz, or orders], the reciprocal of the length of the record.
    """

    frequency: Array
    amplitude: Array
    background: Array
    prominence: Array
    probability: Array
    resolution: float


def line_prominence(
    values: ArrayLike,
    sample_rate: float,
    *,
    width: float | None = None,
    average: int = 1,
    highest: float | None = None,
) -> LineProminence:
    """Level of every spectral line above the median of its neighbourhood, and its probability in noise.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Sample rate f_s [Hz].
    width
        Width of the running median [Hz]; default 128 lines.
    average
        Number of adjacent lines whose powers are averaged [-]: for lines with a varying frequency.
    highest
        Highest frequency of the result [Hz]; default half the sample rate.

    Returns
    -------
    LineProminence
        One value per line.

    Raises
    ------
    SignalError
        If the record has fewer lines than the median, the median has fewer than 32 lines or fewer than eight
        times the averaged ones, or the range is empty.

    Notes
    -----
    The power of a line of Gaussian noise has an exponential distribution, the mean of m lines two apart a
    gamma distribution with the shape d = m/(1 + (1 - 1/m)/18): with a Hann window their correlation is 1/36
    [1]_. The median of the neighbourhood over that of the gamma distribution, q, estimates the mean with a
    relative variance 1/ν = 1/(4 M f(q)² q²), with M independent values, taken as half of the lines over m.
    The ratio t of power and mean then has a Fisher distribution with 2d and 2ν degrees of freedom [2]_.
    Simulated rates of false alarm are 0.04 to 1.4 times the stated ones, the low values with few lines.
    Valid for Gaussian noise whose density varies little over the width, and lines that fill less than a
    quarter of it.

    References
    ----------
    .. [1] F. J. Harris, On the use of windows for harmonic analysis with the discrete Fourier transform,
       Proceedings of the IEEE 66(1), 1978, 51-83.
    .. [2] N. L. Johnson, S. Kotz, N. Balakrishnan, Continuous Univariate Distributions, vol. 2, Wiley, 1995,
       ch. 27.

    Examples
    --------
    A tone of amplitude 1 in white noise of unit variance: its power is n/6 = 2667 times the mean power of
    the noise lines, and the median is ln 2 times that mean: 35.8 dB.

    >>> t = np.arange(16000) / 1000.0
    >>> x = np.cos(2 * np.pi * 100.0 * t) + np.random.default_rng(5).standard_normal(t.size)
    >>> found = line_prominence(x, 1000.0)
    >>> k = int(np.argmax(found.prominence))
    >>> round(float(found.frequency[k]), 3), abs(float(found.prominence[k]) - 35.8) < 1.0
    (100.0, True)
    """
    merged = whole(average, "average")
    ((_, mean, median, step),) = line_ratios(values, sample_rate, (merged,), width=width, highest=highest)
    count = _count(width, step)
    return LineProminence(
        frequency=np.arange(OMITTED, OMITTED + mean.size, dtype=np.float64) * step,
        amplitude=np.sqrt(np.maximum(mean, 0.0)),
        background=np.sqrt(median),
        prominence=levels_of(mean, median),
        probability=prominence_probability(mean / median, count, merged),
        resolution=step,
    )


def levels_of(power: Array, median: Array) -> Array:
    """Levels of powers above a median.

    Parameters
    ----------
    power, median
        Powers and their medians, shape (n,) each, in one unit.

    Returns
    -------
    NDArray
        Levels [dB], shape (n,); at least -300 dB.

    Notes
    -----
    10 lg(P/P_median) [1]_. Valid for medians above zero.

    References
    ----------
    .. [1] IEC 60027-3:2002, Letter symbols to be used in electrical technology - Part 3: Logarithmic and
       related quantities, and their units.

    Examples
    --------
    >>> levels_of(np.array([1.0, 10.0]), np.array([1.0, 1.0])).tolist()
    [0.0, 10.0]
    """
    level = power / median
    np.maximum(level, 1e-30, out=level)
    np.log10(level, out=level)
    level *= 10.0
    return level


def line_ratios(
    values: ArrayLike,
    sample_rate: float,
    averages: Sequence[int],
    *,
    width: float | None = None,
    highest: float | None = None,
    most: float = np.inf,
) -> Iterator[tuple[int, Array, Array, float]]:
    """Powers of spectral lines and their medians, for several numbers of averaged lines in turn.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Sample rate f_s [Hz].
    averages
        Odd numbers of lines whose powers are averaged [-].
    width
        Width of the running median [Hz]; default 128 lines.
    highest
        Highest frequency of the result [Hz]; default half the sample rate.
    most
        Power over its median with which a single line counts at most in the average of several [-]: a mean of
        lines is then large only if several of them are, and not because of a single sharp one.

    Returns
    -------
    iterator of tuple
        Number of averaged lines; squared amplitudes and their running medians, shape (n,) each, from the line
        `OMITTED`, in the squared unit of the signal; distance of the lines [Hz].

    Raises
    ------
    SignalError
        As `line_prominence`.

    Notes
    -----
    As `line_prominence` [1]_, from one transform. Valid as there.

    References
    ----------
    .. [1] F. J. Harris, On the use of windows for harmonic analysis with the discrete Fourier transform,
       Proceedings of the IEEE 66(1), 1978, 51-83.

    Examples
    --------
    >>> noise = np.random.default_rng(5).standard_normal(4096)
    >>> [bool((power / median).max() > 6.0) for _, power, median, _ in line_ratios(noise, 1.0, (1, 9))]
    [True, False]
    """
    from scipy.fft import next_fast_len

    x = as_signal(values, minimum=2 * MIN_BACKGROUND)
    rate = positive(sample_rate, "sample_rate")
    even = [m for m in averages if m % 2 == 0]
    if even:
        raise SignalError(f"average: {even[0]} lines (limit: an odd number); choose {even[0] + 1}")
    parts = PARTS if x.size > LONG else 1
    size = int(next_fast_len(-(-x.size // parts), real=True))
    step = rate / (parts * size)
    last = (x.size - 1) // 2
    top = last if highest is None else min(last, int(positive(highest, "highest") / step))
    count = _count(width, step)
    least = max(MIN_BACKGROUND, 8 * max(averages))
    if count < least:
        raise SignalError(f"width: {count} lines (limit {least}); widen the median or use a longer record")
    power = (hann_transform(x, size, parts)[OMITTED : min(last, top + count) + 1] * (4.0 / x.size)) ** 2
    if power.size < count or top <= OMITTED:
        raise SignalError(
            f"values: {power.size} lines (limit {count}, those of the median); use a longer record"
        )
    limited = power
    if np.isfinite(most) and max(averages) > 1:
        limited = np.minimum(power, most * running_median(power, count))
    return ((m, *_with_median(limited if m > 1 else power, count, m, top), step) for m in averages)


def _count(width: float | None, step: float) -> int:
    """Number of lines of the running median."""
    return DEFAULT_BACKGROUND if width is None else int(round(positive(width, "width") / step))


def _with_median(power: Array, count: int, average: int, top: int) -> tuple[Array, Array]:
    """Averaged powers and their running medians up to a line."""
    mean = _averaged(power, average)
    kept = slice(0, top + 1 - OMITTED)
    return mean[kept], np.maximum(running_median(mean, count)[kept], np.finfo(np.float64).tiny)


def order_prominence(
    values: ArrayLike,
    samples_per_revolution: float,
    *,
    width: float | None = None,
    average: int = 1,
    highest: float | None = None,
) -> LineProminence:
    """Level of every order above the median of its neighbourhood, and its probability in noise.

    Parameters
    ----------
    values
        Signal over equal steps of the shaft angle, shape (n,), any unit.
    samples_per_revolution
        Samples per revolution [-].
    width
        Width of the running median [orders]; default 128 lines.
    average
        Number of adjacent lines whose powers are averaged [-].
    highest
        Highest order of the result [-]; default half the samples per revolution.

    Returns
    -------
    LineProminence
        `frequency` contains orders [-].

    Raises
    ------
    SignalError
        As `line_prominence`.

    Notes
    -----
    `line_prominence` of a signal over the angle [1]_. Valid as there.

    References
    ----------
    .. [1] A. Brandt, Noise and Vibration Analysis, Wiley, 2011, chapter on the analysis of rotating
       machinery.

    Examples
    --------
    >>> angle = 2 * np.pi * np.arange(6400) / 64
    >>> x = np.cos(17 * angle) + np.random.default_rng(5).standard_normal(angle.size)
    >>> found = order_prominence(x, 64)
    >>> round(float(found.frequency[np.argmax(found.prominence)]), 9)
    17.0
    """
    return line_prominence(values, samples_per_revolution, width=width, average=average, highest=highest)


def prominence_probability(ratio: ArrayLike, points: int, average: int = 1) -> Array:
    """Probability that the mean power of adjacent noise lines reaches a multiple of the median around it.

    Parameters
    ----------
    ratio
        Power over the median of its neighbourhood [-], any shape.
    points
        Number of lines of the median [-].
    average
        Number of adjacent lines that are averaged [-].

    Returns
    -------
    NDArray
        Probabilities [-], shape of `ratio`.

    Notes
    -----
    P = I_x(ν, d), x = ν/(ν + d t), the upper tail of the Fisher distribution with 2d and 2ν degrees of
    freedom [1]_; d, ν and t as in `line_prominence`. Valid for 32 points or more.

    References
    ----------
    .. [1] N. L. Johnson, S. Kotz, N. Balakrishnan, Continuous Univariate Distributions, vol. 2, Wiley, 1995,
       ch. 27.

    Examples
    --------
    With many points it is exp(-t ln 2) of a single line:

    >>> round(float(prominence_probability(10.0, 10**7)) * 2.0**10, 3)
    1.0
    """
    from scipy.special import betainc, gammainccinv, gammaln

    shape = average / (1.0 + 2.0 * HANN_POWER * (1.0 - 1.0 / average))
    middle = float(gammainccinv(shape, 0.5))
    density = np.exp(shape * np.log(middle) - middle - gammaln(shape))  # f(q) q
    free = points / (2.0 * average) * 4.0 * density**2
    scaled = np.asarray(ratio, dtype=np.float64) * (middle / shape)
    return np.asarray(betainc(free, shape, free / (free + shape * scaled)), dtype=np.float64)


def _averaged(power: Array, count: int) -> Array:
    """Mean over `count` lines two apart, centred at each line; beyond the ends the spectrum is mirrored."""
    if count == 1:
        return power
    from scipy.ndimage import uniform_filter1d

    # alternate lines by themselves
    mean = np.empty_like(power)
    for first in range(APART):
        mean[first::APART] = uniform_filter1d(power[first::APART], count, mode="reflect")
    return mean
