# SPDX-License-Identifier: Apache-2.0
"""Least-squares fit of the period of a comb of lines, and its standard deviation."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.combs import CombLines, Record, turns_in
from pitchpoint.analysis.sampled import Array
from pitchpoint.analysis.tones import fourier_blocks, overlap


def fitted_period(record: Record, period: float, orders: NDArray[np.int64], reach: float) -> float:
    """Period near a trial value for which sines at the multiples of its frequency fit best.

    Parameters
    ----------
    record
        Record from `combs.record_for_combs`.
    period
        Trial period T [s].
    orders
        Multiples of 1/T, shape (n_line,) [-].
    reach
        Maximum relative change of the frequency [-], a fraction of a line at the highest order.

    Returns
    -------
    float
        Period [s].

    Notes
    -----
    Nonlinear least squares: all sines are fitted simultaneously over the whole record, which need not have
    whole periods, together with the mean and the known tones that were removed before. In white noise it has
    minimum variance once the lines exceed the noise [1]_. Estimates from individual lines would be biased by
    leakage if the record has few periods.

    References
    ----------
    .. [1] B. G. Quinn, E. J. Hannan, The Estimation and Tracking of Frequency, Cambridge University Press,
       2001, chapter 2.

    Examples
    --------
    >>> from pitchpoint.analysis.combs import record_for_combs
    >>> t = np.arange(3000) / 200.0
    >>> record = record_for_combs(np.exp(np.cos(2 * np.pi * t / 3.21)), 200.0, 10.0, [])
    >>> round(fitted_period(record, 3.2, np.arange(1, 7), 0.01), 3)
    3.21
    """
    from scipy.optimize import minimize_scalar

    n = record.values.size
    nu = orders / (period * record.rate)
    tones = record.tones[record.tones < 1.2 * record.top] / record.rate
    fixed = np.concatenate([[0.0], tones, -tones])
    inner = np.linalg.pinv(overlap(fixed, fixed, n), hermitian=True)
    # within a block the phase changes little over the reach, so that block sums serve for any frequency
    blocks, middle = fourier_blocks(record.values, nu, max(1, n // 256))

    def misfit(change: float) -> float:
        """Negative energy explained by the comb in addition to the known lines, at a relative change."""
        right = np.sum(blocks * np.exp(-2j * np.pi * np.outer(middle, nu * (1.0 + change))), axis=0)
        right = np.concatenate([right, np.conj(right)])
        both = (1.0 + change) * np.concatenate([nu, -nu])
        across = overlap(both, fixed, n)
        gram = overlap(both, both, n) - across @ inner @ across.T
        return -float(np.real(np.conj(right) @ np.linalg.solve(gram, right)))

    trial: Array = np.linspace(-reach, reach, 33)
    around = float(trial[int(np.argmin([misfit(c) for c in trial]))])
    bounds = (around - reach / 16.0, around + reach / 16.0)
    change = minimize_scalar(misfit, bounds=bounds, method="bounded", options={"xatol": 1e-4 * reach}).x
    return float(period / (1.0 + change))


def period_deviation(record: Record, period: float, comb: CombLines) -> float:
    """Standard deviation of a fitted period due to the noise around its lines.

    Parameters
    ----------
    record
        Record from `combs.record_for_combs`.
    period
        Period T [s].
    comb
        Lines at the multiples of 1/T.

    Returns
    -------
    float
        Standard deviation [s]; infinite if no line exceeds the noise.

    Notes
    -----
    Cramér-Rao bound of sines at multiples k of one frequency f in noise [1]_, with the power ratio r_k of a
    line and the noise: σ_f = √(6/Σ k² r_k)/(2π D) over the duration D, and σ_T = T² σ_f. Valid if most lines
    exceed the noise.

    References
    ----------
    .. [1] A. Nehorai, B. Porat, Adaptive comb filtering for harmonic signal enhancement, IEEE Transactions on
       Acoustics, Speech, and Signal Processing 34(5), 1986, 1124-1138.
    """
    above = np.maximum((comb.amplitude / comb.noise) ** 2 - 1.0, 0.0)
    sharpness = float(np.sum(comb.orders**2 * above))
    if sharpness == 0.0:
        return float("inf")
    return period * float(np.sqrt(6.0 / sharpness)) / (2.0 * np.pi * turns_in(record, period))
