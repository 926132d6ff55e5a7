# SPDX-License-Identifier: Apache-2.0
"""Lines of envelope spectra in which the families of damaged bearing parts are searched."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.line_prominence import (
    OMITTED,
    levels_of,
    line_ratios,
    prominence_probability,
)
from pitchpoint.analysis.running_median import running_median
from pitchpoint.analysis.sampled import Array
from pitchpoint.analysis.spectral_coherence import LONGEST, spectral_coherence
from pitchpoint.analysis.turning_parts import TurningParts

SPARE = 2
"""Further harmonics, which replace those that coincide with lines of a clearer part."""
HIGHEST_HARMONIC = 5 + SPARE
"""Highest compared harmonic, that of a cage."""
AVERAGES = (1, 3, 9, 27)
"""Numbers of averaged lines that are tried: random slip widens lines with the square of their harmonic. In an
average a single line counts up to its own limit: a widened line has several large ones, and sharp lines of
other parts are anywhere within its width."""
BACKGROUND = 128
"""Minimum number of lines of the running median."""
LEAST = -700.0
"""Least logarithm of a probability that a number can hold."""
MAD = 1.4826
"""Standard deviation over the median of the absolute deviations, for normal values."""


@dataclass(frozen=True)
class LineLevels:
    """Levels above the local median [dB] and probabilities in noise of all lines, shape (n,)."""

    prominence: NDArray[np.float32]
    probability: Array


@dataclass(frozen=True)
class FamilyLines:
    """Lines of an envelope spectrum by number of averaged ones, and their distance [orders]."""

    levels: Mapping[int, LineLevels]
    step: float


def highest_order(parts: TurningParts) -> float:
    """Highest order at which lines of bearing parts are compared, with reserve for slip and sidebands [-].

    Examples
    --------
    >>> from pitchpoint.analysis.turning_parts import Bearing
    >>> round(highest_order(TurningParts((), (), (Bearing("left", {"outer ring": 5.0}),))), 6)
    44.0
    """
    orders = [order for bearing in parts.bearings for order in bearing.orders.values()]
    return 1.2 * HIGHEST_HARMONIC * max(orders, default=1.0) + 2.0


def envelope_lines(values: Array, rate: float, parts: TurningParts, level: float) -> FamilyLines:
    """Lines of a squared envelope over the angle at orders of bearing faults.

    Parameters
    ----------
    values
        Squared envelope, shape (n,), any unit.
    rate
        Samples per revolution of the reference shaft [-].
    parts
        Shafts and bearings.
    level
        Level with which a single line counts at most in an average [dB].

    Notes
    -----
    Levels above the running median [1]_, which covers 128 lines or one order, whichever is more. Valid as
    `line_ratios`.

    References
    ----------
    .. [1] R. B. Randall, Vibration-based Condition Monitoring, Wiley, 2011.
    """
    turns = values.size / rate
    count = background(turns)
    width, most = count / turns, 10.0 ** (0.1 * level)
    averages = [m for m in AVERAGES if 8 * m <= count]
    top = min(highest_order(parts), 0.5 * rate)
    levels, step = {}, 0.0
    for m, power, median, step in line_ratios(values, rate, averages, width=width, highest=top, most=most):
        chance = prominence_probability(power / median, round(width / step), m)
        levels[m] = LineLevels(levels_of(power, median).astype(np.float32), chance)
    return FamilyLines(levels, step)


def background(turns: float) -> int:
    """Number of lines of the running median: 128, or those of one order if they are more.

    Examples
    --------
    >>> background(50.0), background(300.4)
    (128, 300)
    """
    return max(BACKGROUND, round(turns))


def coherence_lines(values: Array, rate: float, parts: TurningParts) -> FamilyLines:
    """Lines of the enhanced envelope spectrum at orders of bearing faults.

    Parameters
    ----------
    values
        Signal over the angle, shape (n,), any unit.
    rate
        Samples per revolution of the reference shaft [-].
    parts
        Shafts and bearings.

    Notes
    -----
    The mean of the coherence over many carriers is normal: the probability of a line follows from its
    distance from the running median in standard deviations, those of the median absolute deviation [1]_, and
    its level is that of an equally probable line of an envelope spectrum. Valid as `spectral_coherence`.

    References
    ----------
    .. [1] F. R. Hampel, The influence curve and its role in robust estimation, Journal of the American
       Statistical Association 69, 1974, 383-393.
    """
    from scipy.stats import norm

    highest = min(highest_order(parts), 0.24 * rate)
    found = spectral_coherence(values, rate, highest_cyclic=highest, segment=min(values.size, LONGEST))
    step = float(found.cyclic_frequency[0])
    count = background(1.0 / step)
    levels = {}
    for m in (m for m in AVERAGES if 8 * m <= count):
        mean = np.convolve(found.enhanced, np.full(m, 1.0 / m), mode="same")
        median = running_median(mean, count)
        spread = np.maximum(MAD * running_median(np.abs(mean - median), count), np.finfo(np.float64).tiny)
        log_chance = norm.logsf((mean - median) / spread)[OMITTED - 1 :]
        level = 10.0 * np.log10(np.maximum(-log_chance / np.log(2.0), 1e-3))
        levels[m] = LineLevels(level.astype(np.float32), np.exp(np.maximum(log_chance, LEAST)))
    return FamilyLines(levels, step)
