# SPDX-License-Identifier: Apache-2.0
"""Kurtogram: frequency band in which a signal is most impulsive."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.analysis.sampled import Array, Lines, SignalError, as_signal, positive, whole
from pitchpoint.analysis.spectra import window

LEFT_OUT = 0.1
"""Share of the record at either end that is not evaluated, because a cut-off looks like an impact in every
band. A window is applied to the record before it is divided into bands, and removed from the envelopes."""
SLOPE = 0.25
"""Width of the transition at either edge of a band over the bandwidth: with sharp edges a tone next to the
band would leak far into it."""
MIN_SAMPLES = 128
"""Default minimum number of envelope samples of a band: with fewer, the kurtosis of noise is large."""
MIN_BLOCK = 40
"""Default minimum number of envelope samples of a band in each block."""


@dataclass(frozen=True)
class Kurtogram:
    """Spectral kurtosis of bands of all widths, in order from the widest, and upwards within a level.

    Attributes
    ----------
    level
        Shape (n_band,). Level of the band [-]; its width is f_s/2 over 2^level. The levels k - 1 + log2(3)
        are bands split into three.
    low, high
        Shape (n_band,). Edges of the band [Hz].
    kurtosis
        Shape (n_band,). Kurtosis of the envelope, median of the blocks [-]: 0 for Gaussian noise, -1 for a
        steady tone, large for impacts.
    spread
        Shape (n_band,). Standard deviation of the kurtosis of Gaussian noise in this band [-].
    best_low, best_high
        Edges of the band with the largest kurtosis [Hz].
    best_kurtosis, best_spread
        Kurtosis and spread of that band [-].
    """

    level: Array
    low: Array
    high: Array
    kurtosis: Array
    spread: Array
    best_low: float
    best_high: float
    best_kurtosis: float
    best_spread: float


def kurtogram(
    values: ArrayLike,
    sample_rate: float,
    *,
    levels: int | None = None,
    band: tuple[float, float] | None = None,
    least_width: float = 0.0,
    blocks: int = 1,
) -> Kurtogram:
    """Kurtosis of the envelope in bands split into halves and thirds, and the band of the largest kurtosis.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Sample rate f_s [Hz].
    levels
        Number of times that bands are halved [-]; default: as many as leave 128 samples per band, and 40 per
        block.
    band
        Edges within which the best band is chosen [Hz]; default all.
    least_width
        Minimum width of the best band [Hz]: three times the highest fault frequency, for three harmonics in
        the envelope spectrum.
    blocks
        Number of equal parts of the record [-] whose median kurtosis counts: with 8 or more, single shocks
        have no effect. Each part must contain several impacts.

    Returns
    -------
    Kurtogram
        Bands of the levels 0, 1, log2(3), 2, 1 + log2(3), 3 ...; `(best_low, best_high)` is the band for
        `envelope.band_envelope`.

    Raises
    ------
    SignalError
        If the record is shorter than 256 samples or constant, is too short for the levels or blocks, or no
        band is inside `band` and wide enough.

    Notes
    -----
    K = mean |c|⁴/(mean |c|²)² - 2 of the complex envelope c of a band [1]_, over the tiling of [2]_: 2^k
    bands and 3·2^(k-1) bands at the levels k and k - 1 + log2(3). Instead of a filter bank, bands are cut out
    of the Fourier transform of the record and transformed back at a rate equal to their width: no delay and
    no redundancy. For Gaussian noise the standard deviation of K is 2/√m with m samples of c; that of the
    median of blocks is √(π/2) times as large at most, and its mean -4/m of a block is corrected. Valid for
    impacts that repeat many times within the record and decay between each other, with tones up to 40 dB
    above the noise: stronger tones within ten lines of the edge of an otherwise empty band look like impacts.

    References
    ----------
    .. [1] J. Antoni, The spectral kurtosis: a useful tool for characterising non-stationary signals,
       Mechanical Systems and Signal Processing 20(2), 2006, 282-307.
    .. [2] J. Antoni, Fast computation of the kurtogram for the detection of transient faults, Mechanical
       Systems and Signal Processing 21(1), 2007, 108-124.

    Examples
    --------
    Impacts that ring at 3 kHz, in noise:

    >>> t = np.arange(20000) / 20000.0
    >>> noise = np.random.default_rng(1).normal(size=t.size)
    >>> x = 0.5 * noise + 4 * np.exp(-800 * (t % 0.02)) * np.sin(2 * np.pi * 3000 * (t % 0.02))
    >>> k = kurtogram(x, 20000.0)
    >>> k.best_low < 3000 < k.best_high, k.best_kurtosis > 20 * k.best_spread
    (True, True)
    """
    x = as_signal(values, minimum=2 * MIN_SAMPLES)
    rate = positive(sample_rate, "sample_rate")
    parts = whole(blocks, "blocks")
    samples = max(MIN_SAMPLES, MIN_BLOCK * parts) if parts > 1 else MIN_SAMPLES
    most = int(np.log2(max(x.size / (2.0 * samples), 1.0))) if levels is None else whole(levels, "levels", 0)
    least = 8 if parts == 1 else 16 * parts
    if x.size < 2 ** (most + 1) * least:
        raise SignalError(
            f"levels: {most} leave {x.size / 2 ** (most + 1):.3g} samples to a band (limit {least}); request "
            f"fewer{' levels or blocks' if parts > 1 else ''}"
        )
    if float(np.ptp(x)) == 0.0:
        raise SignalError("values: are constant; there is no band to choose")
    lines = np.fft.rfft((x - x.mean()) * window("hann", x.size))
    rows = []
    for level, count in _tiling(most):
        edges = np.round(np.linspace(0.0, lines.size, count + 1)).astype(np.int64)
        kurtosis_of, spread_of = _level(lines, edges, parts)
        ends = edges / lines.size * 0.5 * rate
        rows += [(level, *row, spread_of) for row in zip(ends[:-1], ends[1:], kurtosis_of, strict=True)]
    table = np.array(rows)
    level_of, lows, highs, kurtosis, spread = table.T
    slack = 0.5 * rate / lines.size
    low, high = (0.0, 0.5 * rate) if band is None else band
    allowed = (lows >= low - slack) & (highs <= high + slack) & (highs - lows >= least_width - slack)
    if not allowed.any():
        wide = f", at least {least_width:g} Hz wide" if least_width > 0.0 else ""
        raise SignalError(f"band: {low:g} to {high:g} Hz contains no kurtogram band{wide}; widen it")
    best = int(np.argmax(np.where(allowed, kurtosis, -np.inf)))
    return Kurtogram(
        level=level_of,
        low=lows,
        high=highs,
        kurtosis=kurtosis,
        spread=spread,
        best_low=float(lows[best]),
        best_high=float(highs[best]),
        best_kurtosis=float(kurtosis[best]),
        best_spread=float(spread[best]),
    )


def _tiling(levels: int) -> list[tuple[float, int]]:
    """Levels and their numbers of bands, the widest bands first."""
    found = [(0.0, 1)]
    for k in range(1, levels + 1):
        found.append((float(k), 2**k))
        if k < levels:
            found.append((k - 1.0 + float(np.log2(3.0)), 3 * 2 ** (k - 1)))
    return found


def _level(lines: Lines, edges: NDArray[np.int64], blocks: int) -> tuple[Array, float]:
    """Kurtosis of the complex envelopes of the bands of one level, and its standard deviation for noise."""
    from scipy.fft import next_fast_len

    half = max(1, round(0.5 * SLOPE * lines.size / (edges.size - 1)))
    size = next_fast_len(int(np.diff(edges).max()) + 2 * half)
    rise = np.sqrt(0.5 + 0.5 * np.sin(0.5 * np.pi * np.arange(-half + 0.5, half) / half))
    cut = np.zeros((edges.size - 1, size), dtype=np.complex128)
    for row, (first, last) in enumerate(zip(edges[:-1], edges[1:], strict=True)):
        low, high = max(0, first - half), min(lines.size, last + half)
        weight = np.ones(high - low)
        weight[: 2 * half] = rise
        weight[high - low - 2 * half :] *= rise[::-1]
        cut[row, : high - low] = weight * lines[low:high]
    counted = slice(int(np.ceil(LEFT_OUT * size)), int((1.0 - LEFT_OUT) * size))
    c = np.fft.ifft(cut)[:, counted] / window("hann", size)[counted]
    power = np.abs(c) ** 2
    # correlation of adjacent noise samples, for the number of independent samples
    rho = np.abs(np.fft.ifft(weight**2, size))
    rho /= rho[0]
    if blocks == 1:
        return _kurtosis(power), 2.0 * float(np.sqrt(np.sum(rho**4) / power.shape[1]))
    length = power.shape[1] // blocks
    own = 2.0 * float(np.sqrt(np.sum(rho**4) / length))
    each = [_kurtosis(power[:, k * length : (k + 1) * length]) for k in range(blocks)]
    return np.median(each, axis=0) + own**2, own * float(np.sqrt(0.5 * np.pi / blocks))


def _kurtosis(power: Array) -> Array:
    """Kurtosis of complex envelopes from their squared magnitudes, shape (n_band,)."""
    mean = power.mean(axis=1)
    # an empty band has no impacts
    mean[mean == 0.0] = np.inf
    return np.where(np.isinf(mean), -1.0, (power**2).mean(axis=1) / mean**2 - 2.0)
