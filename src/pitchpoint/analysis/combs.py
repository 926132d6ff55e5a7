# SPDX-License-Identifier: Apache-2.0
"""Combs of lines: spectral lines at the multiples of one frequency, tested against the adjacent noise.

A short event once per period T has lines at all multiples of 1/T. Over exactly N periods these fall on every
N-th line of the Fourier transform, and the N - 1 lines between them are not periodic in T: they measure the
noise. Each line of the comb gives an F test. The tests are combined so that no single line decides: a single
strong line is a tone, not a repeated impact.

Source: Thomson, Proc. IEEE 70 (1982) 1055.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.analysis.sampled import Array, SignalError, as_signal, positive
from pitchpoint.analysis.tones import multiples, without_tones

NEIGHBOURS = 8
"""Maximum number of lines on either side of a comb line that are used to estimate its noise."""
NOISE_LINES, LARGEST_GROUP = 8, 4
"""Adjacent comb lines share a noise estimate until it uses that many lines, or that many lines share it."""
CLEARANCE = 0.75
"""Distance from a known tone, in lines, below which a line is omitted."""
MIN_LINES = 3
"""Minimum number of lines of a comb; fewer are tones."""
OVERSAMPLING = 8.0
"""Sample rate of a record over the highest comb frequency: N periods then end on a sample to 1/16 of a period
of the highest line."""


@dataclass(frozen=True)
class Record:
    """Signal prepared for comb tests: mean and known tones removed, decimated.

    Attributes
    ----------
    values
        Shape (n,). Samples, in the unit of the signal.
    rate
        Sample rate [Hz].
    tones
        Shape (n_tone,). Frequencies of the known tones [Hz], increasing.
    top
        Highest frequency of a line [Hz].
    floor
        Round-off power of one line, in the unit of the signal squared.
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
        Shape (n_line,). Multiples used [-].
    frequency
        Shape (n_line,). Their frequencies [Hz].
    amplitude
        Shape (n_line,). Peak amplitudes, in the unit of the signal.
    noise
        Shape (n_line,). RMS of the peak amplitude of noise alone, in the unit of the signal.
    p_value
        Shape (n_line,). Probability that noise alone reaches the amplitude of the line [-].
    group
        Shape (n_line,). Number of the group; lines of one group share a noise estimate [-].
    noise_lines
        Shape (n_line,). Number of lines used for the noise estimate [-].
    """

    orders: NDArray[np.int64]
    frequency: Array
    amplitude: Array
    noise: Array
    p_value: Array
    group: NDArray[np.int64]
    noise_lines: NDArray[np.int64]


def record_for_combs(values: ArrayLike, sample_rate: float, top: float, known: ArrayLike) -> Record:
    """Remove mean and known tones from a signal and decimate it.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Sample rate f_s [Hz].
    top
        Highest frequency of a comb line [Hz].
    known
        Frequencies [Hz] whose multiples are known tones, shape (n_known,), may be empty.

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
    # a trend is not removed: whole periods would no longer be periodic, and its lines decay smoothly
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
        Record from `record_for_combs`.
    period
        Period T [s].
    harmonics
        Highest multiple of 1/T [-]; lines above `record.top` or at known tones are omitted.

    Returns
    -------
    CombLines
        Empty if the record has less than two periods.

    Notes
    -----
    The first N whole periods have lines at k/(N T). Every N-th is a comb line; up to 8 lines on either side
    of it give the noise, each used for one comb line only. If a record has few periods, up to four comb lines
    share their neighbours. For Gaussian noise of equal density at a line and at its m neighbours, the ratio F
    of its power to their mean has the distribution F(2, 2m), so p = (1 + F/m)^-m for any density [1]_. A
    noise density that is curved over the neighbours makes F smaller rather than larger.

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
    # for an even number of periods one line is half-way; it is assigned to the comb line below it
    offsets += [half + 1] if turns % 2 == 0 and half < NEIGHBOURS else []
    line = orders[:, None] * turns + np.array(offsets)
    frequency = line / (turns * period)
    # one chirp z-transform gives all lines
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
    """Number of whole periods in a record; one missing sample at the end is tolerated.

    Parameters
    ----------
    record
        Record from `record_for_combs`.
    period
        Period T [s].
    """
    return int((record.values.size + 1) / (record.rate * period))


def is_clear(frequency: Array, tones: Array, distance: float) -> NDArray[np.bool_]:
    """Mask of frequencies farther than a distance [Hz] from every tone.

    Parameters
    ----------
    frequency
        Frequencies [Hz], any shape.
    tones
        Frequencies of the tones [Hz], increasing, shape (n_tone,).
    distance
        Minimum distance [Hz].
    """
    walls = np.concatenate([[-np.inf], tones, [np.inf]])
    right = np.searchsorted(walls, frequency)
    return np.minimum(frequency - walls[right - 1], walls[right] - frequency) > distance
