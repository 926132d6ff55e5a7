# SPDX-License-Identifier: Apache-2.0
"""Combs of lines: what a signal holds at the multiples of one frequency, against the noise next to them.

Something that happens once per period T, however short, has lines at all multiples of 1/T. Over a stretch of
exactly N periods these fall on every N-th line of the Fourier transform, and what lies on the N - 1 lines
between them is not periodic in T: it measures the noise there. Each line of the comb gives an F test on its
own. The tests are joined so that no single line can decide: a strong line is a tone, not a repeated impact.

Source: Thomson, Proc. IEEE 70 (1982) 1055.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.analysis.sampled import Array, SignalError, as_signal, positive
from pitchpoint.analysis.tones import multiples, without_tones

NEIGHBOURS = 8
"""Lines on either side that measure the noise at a line of the comb, where there are so many."""
NOISE_LINES, LARGEST_GROUP = 8, 4
"""Neighbouring lines of a comb share their noise until it is measured by so many lines, or so many share."""
CLEARANCE = 0.75
"""Distance from a known tone, in lines, below which a line is omitted."""
FEWEST_LINES = 3
"""Fewer lines than these are tones, not a comb."""
OVERSAMPLING = 8.0
"""Sample rate that a record keeps, by the highest frequency of the combs: N periods then end on a sample to
1/16 of a period of the fastest line."""


@dataclass(frozen=True)
class Record:
    """A signal made ready for combs: without mean and known tones, and no faster than it must be.

    Attributes
    ----------
    values
        Shape (n,). Samples, in the unit of the signal.
    rate
        Sample rate [Hz].
    tones
        Shape (n_tone,). Frequencies of the known tones [Hz], rising.
    top
        Highest frequency of a line [Hz].
    floor
        Power of round-off in one line, in the unit of the signal squared.
    """

    values: Array
    rate: float
    tones: Array
    top: float
    floor: float

    @property
    def duration(self) -> float:
        """Length of the record [s]."""
        return self.values.size / self.rate


@dataclass(frozen=True)
class CombLines:
    """Lines at the multiples of one frequency.

    Attributes
    ----------
    orders
        Shape (n_line,). Multiples that were used [-].
    frequency
        Shape (n_line,). Their frequencies [Hz].
    amplitude
        Shape (n_line,). Peak amplitudes, in the unit of the signal.
    noise
        Shape (n_line,). Peak amplitude that noise alone has there (root mean square), in that unit.
    p_value
        Shape (n_line,). Chance that noise alone gives so much at this line [-].
    group
        Shape (n_line,). Number of the group; lines of one group share the measure of their noise [-].
    noise_lines
        Shape (n_line,). How many lines measured the noise [-].
    """

    orders: NDArray[np.int64]
    frequency: Array
    amplitude: Array
    noise: Array
    p_value: Array
    group: NDArray[np.int64]
    noise_lines: NDArray[np.int64]


def record_for_combs(values: ArrayLike, sample_rate: float, top: float, known: ArrayLike) -> Record:
    """Take mean and known tones out of a signal and thin it out.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Sample rate f_s [Hz].
    top
        Highest frequency of any line of a comb [Hz].
    known
        Frequencies [Hz] of which all multiples are known, shape (n_known,), may be empty.

    Raises
    ------
    SignalError
        If the signal is too short or constant, or the sample rate too low for the highest line.
    """
    from scipy.signal import resample_poly

    x = as_signal(values, minimum=16)
    rate = positive(sample_rate, "sample_rate")
    if top >= 0.5 * rate:
        raise SignalError(
            f"sample_rate: {rate:.6g} Hz for lines up to {top:.6g} Hz (limit above {2.0 * top:.6g} Hz); use "
            "fewer harmonics, a lower highest_frequency or longer periods"
        )
    largest = float(np.abs(x).max())
    # a slope stays: without it whole periods would no longer be periodic, and its lines fall off smoothly
    x = x - x.mean()
    thin = int(rate / (OVERSAMPLING * top))
    if thin > 1:
        x = resample_poly(x, 1, thin)
        rate /= thin
    tones = multiples(known, 0.499 * rate, 0.25 * rate / x.size)
    x = without_tones(x, rate, tones)
    floor = x.size * (64.0 * np.finfo(np.float64).eps * largest) ** 2
    return Record(values=np.asarray(x, dtype=np.float64), rate=rate, tones=tones, top=top, floor=floor)


def comb_lines(record: Record, period: float, harmonics: int) -> CombLines:
    """F test of every line of a comb against its neighbours.

    Parameters
    ----------
    record
        What `record_for_combs` made.
    period
        Period T [s].
    harmonics
        Highest multiple of 1/T [-]; lines above `record.top` or at known tones are omitted.

    Returns
    -------
    CombLines
        Empty if the record holds less than two periods.

    Notes
    -----
    The first N whole periods have lines at k/(N T); every N-th belongs to the comb, up to 8 on either side of
    it to the noise, none of them to two lines of the comb. Where a record has few turns, up to four lines of
    the comb share their neighbours. Where the noise is Gaussian with the same density at a line and at its m
    neighbours, the ratio F of its power to their mean is distributed as F(2, 2m), so p = (1 + F/m)^-m,
    whatever the density is [1]_. Noise that is curved over the neighbours makes F smaller rather than larger.

    References
    ----------
    .. [1] D. J. Thomson, Spectrum estimation and harmonic analysis, Proceedings of the IEEE 70(9), 1982,
       1055-1096, section XIII.
    """
    from scipy.signal import czt

    turns = turns_in(record, period) if period > 0.0 else 0
    orders = np.arange(1, min(harmonics, int(record.top * period * (1.0 + 1e-9))) + 1)
    if turns < 2 or not orders.size:
        none, nothing = np.zeros(0, dtype=np.int64), np.zeros(0)
        return CombLines(none, nothing, nothing, nothing, nothing, none, none)
    n = min(record.values.size, round(turns * period * record.rate))
    half = min((turns - 1) // 2, NEIGHBOURS)
    offsets = [0, *range(-half, 0), *range(1, half + 1)]
    # between an even number of turns one line lies half-way; it goes to the comb line below it
    offsets += [half + 1] if turns % 2 == 0 and half < NEIGHBOURS else []
    line = orders[:, None] * turns + np.array(offsets)
    frequency = line / (turns * period)
    # the lines lie as closely as the record allows: one chirp transform has them all
    turning = np.exp(-2j * np.pi / (turns * period * record.rate))
    power = np.abs(czt(record.values[:n], int(line.max()) + 1, turning)[line]) ** 2
    clear = is_clear(frequency, record.tones, CLEARANCE / (turns * period))
    group: NDArray[np.int64] = (orders - 1) // min(LARGEST_GROUP, -(-NOISE_LINES // (len(offsets) - 1)))
    count = np.bincount(group, clear[:, 1:].sum(axis=1))[group].astype(np.int64)
    sums = np.bincount(group, np.sum(power[:, 1:] * clear[:, 1:], axis=1))[group]
    noise = sums / np.maximum(count, 1) + record.floor
    used = clear[:, 0] & (count > 0)
    p_value = (1.0 + power[:, 0] / (noise * np.maximum(count, 1))) ** -count.astype(np.float64)
    return CombLines(
        orders=orders[used],
        frequency=frequency[used, 0],
        amplitude=2.0 / n * np.sqrt(power[used, 0]),
        noise=2.0 / n * np.sqrt(noise[used]),
        p_value=p_value[used],
        group=group[used],
        noise_lines=count[used],
    )


def turns_in(record: Record, period: float) -> int:
    """Whole periods in a record; a sample that is missing at the end does not count.

    Parameters
    ----------
    record
        What `record_for_combs` made.
    period
        Period T [s].
    """
    return int((record.values.size + 1) / (record.rate * period))


def is_clear(frequency: Array, tones: Array, distance: float) -> NDArray[np.bool_]:
    """Which frequencies lie further than a distance [Hz] from every tone.

    Parameters
    ----------
    frequency
        Frequencies [Hz], any shape.
    tones
        Rising frequencies [Hz], shape (n_tone,).
    distance
        Least distance [Hz].
    """
    walls = np.concatenate([[-np.inf], tones, [np.inf]])
    right = np.searchsorted(walls, frequency)
    return np.minimum(frequency - walls[right - 1], walls[right] - frequency) > distance
