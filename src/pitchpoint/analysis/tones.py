# SPDX-License-Identifier: Apache-2.0
"""Sines of arbitrary frequencies in a sampled record: Fourier sums, and removal by least squares.

Source: Stoica and Moses, Spectral Analysis of Signals (2005), 4.3.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array, Lines, SignalError, as_signal, positive


def multiples(known: ArrayLike, top: float, apart: float) -> Array:
    """Multiples of frequencies up to a highest one, without duplicates, shape (m,).

    Parameters
    ----------
    known
        Frequencies [Hz], shape (n,), may be empty.
    top
        Highest multiple [Hz].
    apart
        Minimum distance of distinct multiples [Hz].

    Examples
    --------
    >>> multiples([2.0, 3.0], 7.0, 0.1)
    array([2., 3., 4., 6.])
    """
    base = [positive(f, "known frequency") for f in np.atleast_1d(np.asarray(known, dtype=np.float64))]
    every = np.sort(np.concatenate([[], *(f * np.arange(1, int(top / f) + 1) for f in base)]))
    return every[np.diff(every, prepend=-np.inf) >= apart]


def without_tones(values: ArrayLike, sample_rate: float, frequencies: ArrayLike) -> Array:
    """Signal less its mean and the least-squares fit of sines of given frequencies.

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
        Residual, shape (n,), in the unit of the signal.

    Raises
    ------
    SignalError
        If a frequency is not positive or not below f_s/2.

    Notes
    -----
    Simultaneous least-squares fit of the mean and all sines over the whole record [1]_, so that sines without
    whole periods are removed completely too. Valid for frequency errors up to a tenth of 1/record; sines
    closer than a quarter of 1/record are treated as one.

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
        raise SignalError(f"frequencies: {f[-1]:.6g} Hz (limit below {0.5 * rate:.6g} Hz); omit it")
    f = f[np.diff(f, prepend=-np.inf) >= 0.25 * rate / x.size]
    nu = np.concatenate([[0.0], f]) / rate
    right = fourier(x, nu)
    # time is relative to the middle: cosines and sines are orthogonal, and the equations are real
    apart, together = overlap(nu, nu, x.size), overlap(nu, -nu, x.size)
    cosines = np.linalg.lstsq(0.5 * (apart + together), right.real, rcond=None)[0]
    sines = np.linalg.lstsq(0.5 * (apart - together), -right.imag, rcond=None)[0]
    return x - _sines(cosines - 1j * sines, nu, x.size)


def fourier(x: Array, nu: Array) -> Lines:
    """Fourier sums at arbitrary frequencies, time relative to the middle of the record.

    Parameters
    ----------
    x
        Samples, shape (n,).
    nu
        Frequencies in cycles per sample, shape (n_line,).
    """
    # a block length of about √n minimises the number of exponentials
    sums, middle = fourier_blocks(x, nu, max(64, int(np.sqrt(x.size))))
    return np.asarray(np.sum(sums * np.exp(-2j * np.pi * np.outer(middle, nu)), axis=0), dtype=np.complex128)


def fourier_blocks(x: Array, nu: Array, length: int) -> tuple[Lines, Array]:
    """Fourier sums of successive blocks, each relative to its middle, and the positions of the middles.

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
        Sums, shape (n_block, n_line), and middles of the blocks relative to the middle of the record
        [samples], shape (n_block,).
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
    """Inner products of complex sines over a record, time relative to its middle, shape (n, m).

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
    """Real part of the sum of complex sines, time relative to the middle of the record."""
    length = min(max(64, int(np.sqrt(samples))), samples)
    count = -(-samples // length)
    within = np.exp(2j * np.pi * np.outer(nu, np.arange(length)))
    start = np.arange(count) * length - 0.5 * (samples - 1)
    sums = (amplitude * np.exp(2j * np.pi * np.outer(start, nu))) @ within
    return np.asarray(sums.real.ravel()[:samples], dtype=np.float64)
