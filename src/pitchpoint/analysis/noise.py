# SPDX-License-Identifier: Apache-2.0
"""Reproducible white noise at a given level or signal-to-noise ratio."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.indicators import alternating_part
from pitchpoint.analysis.sampled import Array, SignalError, as_signal, finite


@dataclass(frozen=True)
class NoisySignal:
    """Signal with added noise.

    Attributes
    ----------
    values, noise
        Shape (n,). Signal with noise, and the noise alone, in the unit of the signal.
    signal_rms
        RMS of the alternating part of the signal, in its unit.
    noise_deviation
        Standard deviation of the noise distribution, in the unit of the signal.
    """

    values: Array
    noise: Array
    signal_rms: float
    noise_deviation: float


def white_noise(size: int, *, deviation: float, seed: int | Sequence[int]) -> Array:
    """Draw Gaussian white noise of a given level.

    Parameters
    ----------
    size
        Number of samples, at least 0.
    deviation
        Standard deviation of the distribution, any unit.
    seed
        Nonnegative whole number, or several (case, channel, ...).

    Returns
    -------
    numpy.ndarray
        Noise, shape (size,), in the unit of the deviation.

    Raises
    ------
    SignalError
        If the deviation is not finite or negative, or the seed is not a nonnegative whole number.

    Notes
    -----
    Independent normal samples of PCG64, see `with_white_noise`.

    Examples
    --------
    >>> noise = white_noise(100_000, deviation=0.5, seed=1)
    >>> noise.shape, round(float(noise.std()), 2)
    ((100000,), 0.5)
    """
    level = finite(deviation, "deviation")
    if level < 0.0:
        raise SignalError(f"deviation: {level:g} is negative (limit >= 0)")
    seeds = np.atleast_1d(np.asarray(seed, dtype=object)).tolist()
    for one in seeds:
        if isinstance(one, bool) or not isinstance(one, (int, np.integer)) or one < 0:
            raise SignalError(f"seed: {one!r} (limit a whole number from 0 on)")
    generator = np.random.Generator(np.random.PCG64([int(one) for one in seeds]))
    return np.asarray(level * generator.standard_normal(size), float)


def with_white_noise(values: ArrayLike, *, signal_to_noise: float, seed: int | Sequence[int]) -> NoisySignal:
    """Add Gaussian white noise to a signal.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    signal_to_noise
        Signal-to-noise ratio over the whole bandwidth up to half the sample rate [dB]: mean square of the
        alternating part of the signal over the variance of the noise.
    seed
        Nonnegative whole number, or several (case, channel, ...).

    Returns
    -------
    NoisySignal
        Signal with noise, and the noise alone.

    Raises
    ------
    SignalError
        If the signal is constant (its level is zero), the ratio is not finite, or the seed is not a
        nonnegative whole number.

    Notes
    -----
    σ = rms(x - x̄)·10^(-SNR/20); independent normal samples of the permuted congruential generator PCG64
    [1]_. σ is the parameter of the distribution: the RMS of n samples deviates from it by about 1/√(2n),
    relative. The same seed gives identical noise with one version of NumPy on one type of machine. Valid for
    any record; at another sample rate the same ratio is another noise density.

    References
    ----------
    .. [1] M. E. O'Neill, PCG: A family of simple fast space-efficient statistically good algorithms for
       random number generation, Harvey Mudd College HMC-CS-2014-0905, 2014.

    Examples
    --------
    A sine of amplitude √2 at 20 dB: the noise is a tenth of its RMS:

    >>> x = 7.0 + np.sqrt(2.0) * np.sin(2 * np.pi * np.arange(100_000) / 100)
    >>> noisy = with_white_noise(x, signal_to_noise=20.0, seed=1)
    >>> round(noisy.signal_rms, 9), round(noisy.noise_deviation, 9), round(float(noisy.noise.std()), 2)
    (1.0, 0.1, 0.1)
    """
    x = as_signal(values)
    ratio = finite(signal_to_noise, "signal_to_noise")
    rms = float(np.sqrt(np.mean(alternating_part(x, "values") ** 2)))
    deviation = rms * float(10.0 ** (-ratio / 20.0))
    noise = white_noise(x.size, deviation=deviation, seed=seed)
    return NoisySignal(x + noise, noise, rms, deviation)
