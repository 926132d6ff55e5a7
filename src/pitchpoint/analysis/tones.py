# SPDX-License-Identifier: Apache-2.0
"""Sines of any frequency in a sampled record: how much of them there is, and the record without them.

Source: Stoica and Moses, Spectral Analysis of Signals (2005), 4.3.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array, Lines, SignalError, as_signal, positive


def multiples(known: ArrayLike, top: float, apart: float) -> Array:
    """All multiples of some frequencies up to a highest one, rising and each only once, shape (m,).

    Parameters
    ----------
    known
        Frequencies [Hz], shape (n,), may be empty.
    top
        Highest multiple [Hz].
    apart
        Frequencies closer than this count as one [Hz].

    Examples
    --------
    >>> multiples([2.0, 3.0], 7.0, 0.1)
    array([2., 3., 4., 6.])
    """
    base = [positive(f, "known frequency") for f in np.atleast_1d(np.asarray(known, dtype=np.float64))]
    every = np.sort(np.concatenate([[], *(f * np.arange(1, int(top / f) + 1) for f in base)]))
    return every[np.diff(every, prepend=-np.inf) >= apart]


def without_tones(values: ArrayLike, sample_rate: float, frequencies: ArrayLike) -> Array:
    """The signal less its mean and the sines of given frequencies that fit it best.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Sample rate f_s [Hz].
    frequencies
        Frequencies of the sines [Hz], shape (n_tone,), below f_s/2.

    Returns
    -------
    NDArray
        What is left, shape (n,), in the unit of the signal.

    Raises
    ------
    SignalError
        If a frequency is not positive or not below f_s/2.

    Notes
    -----
    Least squares over the whole record [1]_, all sines and the mean at once, so sines that do not fit the
    record leave nothing behind either. Valid while no frequency is wrong by more than a tenth of 1/record;
    sines closer to each other than a quarter of that are taken out as one.

    References
    ----------
    .. [1] P. Stoica, R. Moses, Spectral Analysis of Signals, Prentice Hall, 2005, section 4.3.

    Examples
    --------
    >>> t = np.arange(1000) / 100.0
    >>> rest = without_tones(5.0 + np.sin(2 * np.pi * 3.251 * t), 100.0, [3.251])
    >>> bool(np.abs(rest).max() < 1e-12)
    True
    """
    x = as_signal(values)
    rate = positive(sample_rate, "sample_rate")
    f = np.sort([positive(v, "frequency of a tone") for v in np.atleast_1d(np.asarray(frequencies, float))])
    if f.size and f[-1] >= 0.5 * rate:
        raise SignalError(f"frequencies: {f[-1]:.6g} Hz (limit below {0.5 * rate:.6g} Hz); leave it out")
    f = f[np.diff(f, prepend=-np.inf) >= 0.25 * rate / x.size]
    nu = np.concatenate([[0.0], f]) / rate
    right = fourier(x, nu)
    # time is counted from the middle: cosines and sines have nothing in common, and all is real
    apart, together = overlap(nu, nu, x.size), overlap(nu, -nu, x.size)
    cosines = np.linalg.lstsq(0.5 * (apart + together), right.real, rcond=None)[0]
    sines = np.linalg.lstsq(0.5 * (apart - together), -right.imag, rcond=None)[0]
    return x - _sines(cosines - 1j * sines, nu, x.size)


def fourier(x: Array, nu: Array) -> Lines:
    """Fourier sums at any frequencies, time counted from the middle of the record.

    Parameters
    ----------
    x
        Samples, shape (n,).
    nu
        Frequencies in cycles per sample, shape (n_line,).
    """
    # blocks of about the square root: fewest exponentials to compute
    sums, middle = fourier_blocks(x, nu, max(64, int(np.sqrt(x.size))))
    return np.asarray(np.sum(sums * np.exp(-2j * np.pi * np.outer(middle, nu)), axis=0), dtype=np.complex128)


def fourier_blocks(x: Array, nu: Array, length: int) -> tuple[Lines, Array]:
    """Fourier sums of successive blocks, each about its own middle, and where the middles are.

    Parameters
    ----------
    x
        Samples, shape (n,).
    nu
        Frequencies in cycles per sample, shape (n_line,).
    length
        Samples per block [-].

    Returns
    -------
    tuple
        Sums, shape (n_block, n_line), and middles of the blocks from the middle of the record on [samples],
        shape (n_block,).
    """
    length = min(length, x.size)
    count = -(-x.size // length)
    padded = np.zeros(count * length)
    padded[: x.size] = x
    within = np.arange(length) - 0.5 * (length - 1)
    sums = padded.reshape(count, length) @ np.exp(-2j * np.pi * np.outer(within, nu))
    middle = np.arange(count) * length + 0.5 * (length - x.size)
    return np.asarray(sums, dtype=np.complex128), np.asarray(middle, dtype=np.float64)


def overlap(first: Array, second: Array, samples: int) -> Array:
    """Inner products of complex sines over a record, time counted from its middle, shape (n, m).

    Parameters
    ----------
    first
        Frequencies in cycles per sample, shape (n,).
    second
        Frequencies in cycles per sample, shape (m,).
    samples
        Number of samples [-].
    """
    theta = np.pi * (first[:, None] - second[None, :])
    below = np.sin(theta)
    same = np.abs(below) < 1e-12
    return np.where(same, float(samples), np.sin(samples * theta) / np.where(same, 1.0, below))


def _sines(amplitude: Lines, nu: Array, samples: int) -> Array:
    """Real part of the sum of complex sines, time counted from the middle of the record."""
    length = min(max(64, int(np.sqrt(samples))), samples)
    count = -(-samples // length)
    within = np.exp(2j * np.pi * np.outer(nu, np.arange(length)))
    start = np.arange(count) * length - 0.5 * (samples - 1)
    sums = (amplitude * np.exp(2j * np.pi * np.outer(start, nu))) @ within
    return np.asarray(sums.real.ravel()[:samples], dtype=np.float64)
