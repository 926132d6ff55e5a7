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
        Shape (n_band,). Kurtosis of the envelope [-]: 0 for Gaussian noise, -1 for a steady tone, large for
        impacts.
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
) -> Kurtogram:
    """Kurtosis of the envelope in bands split into halves and thirds, and the band of the largest kurtosis.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Sample rate f_s [Hz].
    levels
        Number of times that bands are halved [-]; default: as many as leave 128 samples per band.
    band
        Edges within which the best band is chosen [Hz]; default all.

    Returns
    -------
    Kurtogram
        Bands of the levels 0, 1, log2(3), 2, 1 + log2(3), 3 ...; `(best_low, best_high)` is the band for
        `envelope.band_envelope`.

    Raises
    ------
    SignalError
        If the record is shorter than 256 samples or constant, is too short for the levels, or no band is
        inside `band`.

    Notes
    -----
    K = mean |c|⁴/(mean |c|²)² - 2 of the complex envelope c of a band [1]_, over the tiling of [2]_: 2^k
    bands and 3·2^(k-1) bands at the levels k and k - 1 + log2(3). Instead of a filter bank, bands are cut out
    of the Fourier transform of the record and transformed back at a rate equal to their width: no delay and
    no redundancy. For Gaussian noise the standard deviation of K is 2/√m with m samples of c. Valid for
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
    most = int(np.log2(x.size / (2.0 * MIN_SAMPLES))) if levels is None else whole(levels, "levels", 0)
    if x.size < 2 ** (most + 4):
        raise SignalError(
            f"levels: {most} leave {x.size / 2 ** (most + 1):.3g} samples to a band (limit 8); request fewer"
        )
    if float(np.ptp(x)) == 0.0:
        raise SignalError("values: are constant; there is no band to choose")
    lines = np.fft.rfft((x - x.mean()) * window("hann", x.size))
    rows = []
    for level, count in _tiling(most):
        edges = np.round(np.linspace(0.0, lines.size, count + 1)).astype(np.int64)
        kurtosis_of, spread_of = _level(lines, edges)
        ends = edges / lines.size * 0.5 * rate
        rows += [(level, *row, spread_of) for row in zip(ends[:-1], ends[1:], kurtosis_of, strict=True)]
    table = np.array(rows)
    level_of, lows, highs, kurtosis, spread = table.T
    allowed = np.full(lows.size, True)
    if band is not None:
        slack = 0.5 * rate / lines.size
        allowed = (lows >= band[0] - slack) & (highs <= band[1] + slack)
        if not allowed.any():
            raise SignalError(f"band: {band[0]:g} to {band[1]:g} Hz contains no kurtogram band; widen it")
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


def _level(lines: Lines, edges: NDArray[np.int64]) -> tuple[Array, float]:
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
    mean = power.mean(axis=1)
    # an empty band has no impacts
    mean[mean == 0.0] = np.inf
    # correlation of adjacent noise samples, for the number of independent samples
    rho = np.abs(np.fft.ifft(weight**2, size))
    rho /= rho[0]
    spread = 2.0 * float(np.sqrt(np.sum(rho**4) / power.shape[1]))
    return np.where(np.isinf(mean), -1.0, (power**2).mean(axis=1) / mean**2 - 2.0), spread
