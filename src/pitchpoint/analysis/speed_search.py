# SPDX-License-Identifier: Apache-2.0
"""Speed of a machine from the lines of its record, near a nominal speed.

Mesh lines are the most accurate; without gears, the harmonics of the shafts. Each line counts with its level
above the surroundings up to a limit, so that one strong line of another source does not decide.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.line_tests import FineSpectrum
from pitchpoint.analysis.sampled import Array, positive
from pitchpoint.analysis.turning_parts import TurningParts

MESH_HARMONICS, SHAFT_HARMONICS = 3, 10
LIMIT = float(np.log(1e6))
"""Largest contribution of one line: that of a probability of 1 in 1 000 000, too little for a single line."""
CHANCE = 1e-4
"""Probability of noise alone below which lines determine the speed."""
BEYOND = 1.1
"""Searched range over the tolerance: nominal speeds are rounded, and so are their tolerances."""
FEWEST = 3
"""Smallest number of shaft harmonics, each with a probability below 1 %: fewer may be of other machines."""
MAINS, MAINS_HARMONICS = (50.0, 60.0), 10
"""Frequencies of the mains [Hz], and their harmonics that may be in a vibration."""
MAINS_DRIFT, MAINS_LINES = 1e-3, 2.0
"""Largest relative deviation of the mains [-], and half width of a line [lines of the record]."""


@dataclass(frozen=True)
class FoundSpeed:
    """Speed of the reference shaft.

    Attributes
    ----------
    frequency
        Rotation frequency [Hz].
    tolerance
        Relative tolerance that remains [-]: 0 if lines determine the speed, else that of the nominal speed.
    lines
        Orders of the lines above the noise that determine the speed, relative to the reference shaft [-].
    what
        `mesh` or `shaft`, whose lines determine the speed; empty if none do.
    chance
        Probability that noise alone has such lines anywhere within the tolerance [-].
    mains
        Clear lines at harmonics of the mains that could also be harmonics of a shaft [Hz], if no other lines
        determine the speed.
    """

    frequency: float
    tolerance: float
    lines: tuple[float, ...] = ()
    what: str = ""
    chance: float = 1.0
    mains: tuple[float, ...] = ()


def speed_from_lines(
    spectra: Sequence[FineSpectrum], parts: TurningParts, frequency: float, tolerance: float
) -> FoundSpeed:
    """Speed within the tolerance of a nominal one at which the lines of the machine are strongest.

    Parameters
    ----------
    spectra
        Spectra of the channels, over frequency [Hz].
    parts
        Rotating parts; orders refer to the reference shaft.
    frequency
        Nominal rotation frequency of the reference shaft [Hz].
    tolerance
        Its relative tolerance [-].

    Returns
    -------
    FoundSpeed
        The speed, and the lines that determine it.

    Notes
    -----
    For a line with the power P over noise of the mean power N, noise alone has exp(-P/N); the sum of the
    negative logarithms over all lines and channels is compared with its gamma distribution [1]_ times the
    number of independent speeds within the tolerance. Each term is limited, which only lowers the sum. Mesh
    lines are tried first, then shaft harmonics. Shaft harmonics at harmonics of 50 and 60 Hz do not count: an
    induction motor is slower than its field, so that lines there are those of the mains. Neither do
    lines that are all multiples of one of them: a faster shaft, or twice the supply frequency, has them, too.
    Valid for a steady speed.

    References
    ----------
    .. [1] R. A. Fisher, Statistical Methods for Research Workers, 4th edition, Oliver and Boyd, 1932,
    section 21.1.

    Examples
    --------
    >>> from pitchpoint.analysis.line_tests import fine_spectrum
    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> t = np.arange(40_000) / 5000.0
    >>> noise = np.random.default_rng(1).standard_normal(t.size)
    >>> x = sum(np.cos(2 * np.pi * 29.7 * 21 * k * t) for k in (1, 2, 3)) + noise
    >>> found = speed_from_lines([fine_spectrum(x, 5000.0)], train_parts([(21, 40)]), 30.0, 0.02)
    >>> round(found.frequency, 3), found.what, found.tolerance
    (29.7, 'mesh', 0.0)
    """
    nominal, reach = positive(frequency, "frequency"), BEYOND * float(tolerance)
    if reach <= 0.0:
        return FoundSpeed(nominal, 0.0)
    meshes = sorted({parts.mesh_order(mesh) for mesh in parts.meshes})
    turns = sorted({float(shaft.order) for shaft in parts.shafts})
    for what, steps, harmonics in (("mesh", meshes, MESH_HARMONICS), ("shaft", turns, SHAFT_HARMONICS)):
        orders = np.unique([k * step for step in steps for k in range(1, harmonics + 1)])
        # near the speed of the field, lines of the mains also agree with lines of the shaft
        for mains in (True, False):
            found = _search(spectra, orders, nominal, reach, mains=mains)
            if found is None or found[2] >= CHANCE:
                break
            speed, seen, chance = found
            own = seen[~at_mains(seen * speed, spectra[0].resolution)]
            if what == "mesh" or _of_a_shaft(own, turns):
                return FoundSpeed(speed, 0.0, tuple(seen.tolist()), what, chance)
    lines = _mains_lines(spectra, turns, nominal, reach)
    return FoundSpeed(nominal, reach, mains=lines)


def _of_a_shaft(seen: Array, turns: Sequence[float]) -> bool:
    """Whether enough lines are seen, and not only every second, third, ... harmonic of each shaft."""
    numbers = [np.rint(seen / turn) for turn in turns]
    own = [row[np.abs(row * turn - seen) < 1e-9] for row, turn in zip(numbers, turns, strict=True)]
    return seen.size >= FEWEST and any(np.gcd.reduce(row.astype(int)) == 1 for row in own if row.size)


def at_mains(frequency: Array, resolution: float) -> NDArray[np.bool_]:
    """Whether frequencies are at a harmonic of the mains, 50 or 60 Hz.

    Parameters
    ----------
    frequency
        Frequencies, shape (n,) [Hz].
    resolution
        Distance of the lines of the record [Hz].

    Notes
    -----
    Within two lines of the record, and 0.1 % of the frequency [1]_. Valid for the first ten harmonics.

    References
    ----------
    .. [1] EN 50160, Voltage characteristics of electricity supplied by public electricity networks, 2010,
       section 4.2.1.

    Examples
    --------
    >>> at_mains(np.array([59.9, 100.0, 107.0]), 0.1).tolist()
    [True, True, False]
    """
    found = np.zeros(np.shape(frequency), dtype=np.bool_)
    for mains in MAINS:
        nearest = np.clip(np.rint(frequency / mains), 1, MAINS_HARMONICS) * mains
        found |= np.abs(frequency - nearest) <= MAINS_DRIFT * nearest + MAINS_LINES * resolution
    return found


def _mains_lines(
    spectra: Sequence[FineSpectrum], turns: Sequence[float], frequency: float, reach: float
) -> tuple[float, ...]:
    """Clear lines at harmonics of the mains that a shaft would have within the range of its speed [Hz]."""
    near = {k * turn * frequency for turn in turns for k in range(1, SHAFT_HARMONICS + 1)}
    harmonics = {k * mains for mains in MAINS for k in range(1, MAINS_HARMONICS + 1)}
    return tuple(
        mains
        for mains in sorted(harmonics)
        if any(abs(mains - line) <= reach * line for line in near)
        and any(
            mains < 0.9 * one.highest and one.power(mains) > LIMIT * _noise(one, 1.0, mains, 0.0)
            for one in spectra
        )
    )


def _search(
    spectra: Sequence[FineSpectrum], orders: Array, frequency: float, reach: float, *, mains: bool
) -> tuple[float, Array, float] | None:
    """Best speed, orders of its lines above the noise, and the probability of their sum under noise.

    Lines of the mains count only if `mains` is true.
    """
    from scipy.stats import gamma

    spectrum = spectra[0]
    orders = orders[orders * frequency * (1.0 + reach) + 40.0 * spectrum.resolution < 0.95 * spectrum.highest]
    orders = orders[orders * frequency * (1.0 - reach) > 4.0 * spectrum.resolution]
    if not orders.size:
        return None
    step = 0.25 * spectrum.resolution / float(orders.max())
    count = int(np.ceil(reach * frequency / step))
    tried = frequency + step * np.arange(-count, count + 1)
    gain, level = np.zeros((orders.size, tried.size)), np.zeros(tried.size)
    for one in spectra:
        for row, order in enumerate(orders):
            ratio = one.power(order * tried) / _noise(one, order, frequency, reach)
            if not mains:
                ratio = np.where(at_mains(order * tried, one.resolution), 0.0, ratio)
            gain[row] += np.minimum(ratio, LIMIT)
            level += np.log1p(ratio)
    # levels rank the speeds, since many of them may reach the limit of every line
    total, best = gain.sum(axis=0), int(np.argmax(level))
    independent = max(2.0 * reach * frequency * float(orders.max()) / spectrum.resolution, 1.0)
    chance = float(gamma.sf(total[best], orders.size * len(spectra)))
    seen = orders[gain[:, best] > gamma.isf(0.01, len(spectra))]
    return _refined(spectra, seen, float(tried[best])), seen, min(1.0, independent * chance)


def _refined(spectra: Sequence[FineSpectrum], orders: Array, frequency: float) -> float:
    """Weighted mean of the rotation frequencies of all lines, each from a parabola through its maximum."""
    found, weight = [], []
    for one in spectra:
        reach = round(0.5 * one.resolution / one.step)
        for order in orders:
            middle = round(order * frequency / one.step)
            top = middle - reach + int(np.argmax(one.amplitude[middle - reach : middle + reach + 1]))
            left, peak, right = np.log(
                np.maximum(one.amplitude[top - 1 : top + 2].astype(np.float64), 1e-300)
            )
            if not (left < peak >= right):
                continue
            shift = 0.5 * (left - right) / (left - 2.0 * peak + right)
            found.append((top + shift) * one.step / order)
            # the variance of a frequency is inversely proportional to the power of its line
            power = float(one.amplitude[top]) ** 2
            weight.append(order**2 * power / _noise(one, order, frequency, 0.0))
    return float(np.average(found, weights=weight)) if found else frequency


def _noise(spectrum: FineSpectrum, order: float, frequency: float, reach: float) -> float:
    """Mean power of the noise about a line: median of the surroundings over ln 2."""
    wide = order * frequency * reach + 40.0 * spectrum.resolution
    low, high = max(order * frequency - wide, spectrum.resolution), order * frequency + wide
    around = spectrum.power(np.arange(low, high, spectrum.resolution))
    return max(float(np.median(around)) / np.log(2.0), 1e-300)
