# SPDX-License-Identifier: Apache-2.0
"""The chance that noise alone looks like a comb of lines.

Source: Fisher (1932); limit and groups are own.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.combs import CombLines
from pitchpoint.analysis.sampled import Array

CLIP = float(np.log(100.0))
"""The most that one line adds to the evidence: as much as a chance of 1 in 100."""
FEWEST_LINES = 3
"""Fewer lines than these are tones, not a comb."""
SHARES = (1, 2, 4)
"""All lines are asked, the slower half and the slowest quarter: a broad dip has no fast lines."""
CELLS = 150
"""Steps of the lattice up to the limit of one line."""

Group = tuple[int, int]
"""Lines of a comb that share their noise, and how many lines measured it."""


def chance_of_comb(comb: CombLines, part: NDArray[np.bool_] | None = None) -> float:
    """Chance that noise alone gives so much in a comb, where no line counts for more than 1 in 100.

    Parameters
    ----------
    comb
        Lines with their single chances.
    part
        Which of the lines, shape (n_line,); omitted, all.

    Returns
    -------
    float
        Chance [-]; 1 for a comb of fewer than three lines or a part of fewer than two.

    Notes
    -----
    S = Σ min(-ln p_k, ln 100). Under noise every -ln p is exponentially distributed; were they independent
    and unlimited, 2S would be chi-square with 2n degrees of freedom [1]_. Lines that share the measure of
    their noise are independent only for a given error of that measure, which is gamma-distributed: the
    distribution of a group is an integral over it, that of all groups a convolution. Right to 1 % of the
    chance. Valid down to about 100^-n.

    References
    ----------
    .. [1] R. A. Fisher, Statistical Methods for Research Workers, 4th edition, Oliver and Boyd, 1932, section
       21.1; the limit on a single line and the groups are ours.
    """
    use = np.ones(comb.orders.size, dtype=np.bool_) if part is None else part
    if np.count_nonzero(use) < 2 or comb.orders.size < FEWEST_LINES:
        return 1.0
    total = float(np.minimum(-np.log(np.maximum(comb.p_value[use], 1e-300)), CLIP).sum())
    _, first, size = np.unique(comb.group[use], return_index=True, return_counts=True)
    shared = comb.noise_lines[use][first]
    return limited_sum_chance(
        total, tuple(sorted((int(g), int(m)) for g, m in zip(size, shared, strict=True)))
    )


def evidence_of_comb(comb: CombLines, harmonics: int) -> tuple[float, float, int]:
    """Chance of a comb as broad as it turns out to be, and chance of its lines that no shorter period has.

    Parameters
    ----------
    comb
        Lines with their single chances.
    harmonics
        Highest multiple that was requested [-].

    Returns
    -------
    tuple
        The smallest chance of all lines, of the slower half and of the slowest quarter, times three for the
        choice; for these lines the largest chance of those that are not multiples of some prime: where it is
        not small, the comb may belong to a part of the period; and the highest multiple among these lines.
    """
    chances = [(chance_of_comb(comb, comb.orders <= harmonics // k), harmonics // k) for k in SHARES]
    chance, highest = min(chances)
    primes = [q for q in range(2, highest + 1) if all(q % d for d in range(2, q))]
    within = comb.orders <= highest
    own = max((chance_of_comb(comb, within & (comb.orders % q != 0)) for q in primes), default=1.0)
    return min(1.0, len(SHARES) * chance), own, highest


def limited_sum_chance(total: float, groups: tuple[Group, ...]) -> float:
    """Chance that the evidence of some groups of lines reaches a value under noise.

    Parameters
    ----------
    total
        Sum of -ln p over the lines, each limited to ln 100 [-].
    groups
        Lines in each group, and lines that measured its noise [-].

    Examples
    --------
    Ten independent lines that add up to 15; without the limit on each, it would be 0.070:

    >>> round(limited_sum_chance(15.0, 10 * ((1, 8),)), 3)
    0.058
    """
    logs = _log_tail(groups)
    return float(np.exp(np.interp(total * CELLS / CLIP + 0.5, np.arange(logs.size), logs)))


@lru_cache(maxsize=512)
def _log_tail(groups: tuple[Group, ...]) -> Array:
    """Log of the chance that a sum reaches i - 1/2 steps of the lattice."""
    mass = np.ones(1)
    for group in groups:
        # all terms are positive: the far end keeps its relative precision
        mass = np.convolve(mass, _mass_of_group(*group))
    return np.log(np.clip(np.cumsum(mass[::-1])[::-1], 1e-300, 1.0))


@lru_cache(maxsize=128)
def _mass_of_group(size: int, shared: int) -> Array:
    """Chances of the sums of one group, on the lattice."""
    from scipy.special import gammaln

    edges = np.concatenate([[0.0], (np.arange(CELLS) + 0.5) / CELLS * CLIP])
    # error s of the measured noise, gamma-distributed about 1, by the trapezoidal rule in ln s
    log_s = np.linspace(np.log(1e-5), np.log(30.0), 240)
    density = shared * (np.log(shared) + log_s - np.exp(log_s)) - gammaln(shared)
    weight = np.exp(density) * (log_s[1] - log_s[0])
    # a line reaches y if its power is above s m (exp(y/m) - 1)
    beyond = np.exp(-np.outer(np.exp(log_s), shared * np.expm1(edges / shared)))
    single = np.concatenate([beyond[:, :-1] - beyond[:, 1:], beyond[:, -1:]], axis=1)
    length = size * CELLS + 1
    sums = np.fft.irfft(np.fft.rfft(single, 2 * length, axis=1) ** size, 2 * length, axis=1)[:, :length]
    return np.maximum(weight @ sums, 0.0)
