# SPDX-License-Identifier: Apache-2.0
"""The period of a comb of lines between the steps of a search, and how well it is known."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.combs import CombLines, Record, turns_in
from pitchpoint.analysis.sampled import Array
from pitchpoint.analysis.tones import fourier_blocks, overlap


def fitted_period(record: Record, period: float, orders: NDArray[np.int64], reach: float) -> float:
    """The period near a trial for which sines at multiples of its frequency fit best.

    Parameters
    ----------
    record
        What `combs.record_for_combs` made.
    period
        Trial period T [s].
    orders
        Multiples of 1/T, shape (n_line,) [-].
    reach
        Largest relative change of the frequency [-], some fraction of a line at the highest order.

    Returns
    -------
    float
        Period [s].

    Notes
    -----
    All sines are fitted at once over the whole record, whole periods or not, next to the mean and the known
    tones that were taken out before: nonlinear least squares, which has the smallest variance possible in
    white noise once the lines stand out of it [1]_. Reading the lines one by one would be biased by what each
    leaks into the others where the record holds a few periods only.

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
    # within a block the phase changes little over the reach; sums over blocks follow any change of frequency
    blocks, middle = fourier_blocks(record.values, nu, max(1, n // 256))

    def misfit(change: float) -> float:
        """Less the energy that the comb explains next to the known lines, all its lines moved by a share."""
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
    """Standard deviation of a period that the noise next to its lines represents.

    Parameters
    ----------
    record
        What `combs.record_for_combs` made.
    period
        Period T [s].
    comb
        Its lines.

    Returns
    -------
    float
        Standard deviation [s]; infinite if no line stands out of the noise.

    Notes
    -----
    Cramér-Rao bound of sines at multiples k of one frequency f in noise [1]_, with the power ratio r_k of a
    line and the noise there: σ_f = √(6/Σ k² r_k)/(2π D) over the duration D, and σ_T = T² σ_f. Valid where
    most lines stand out of the noise.

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
