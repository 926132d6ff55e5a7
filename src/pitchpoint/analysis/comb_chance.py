# SPDX-License-Identifier: Apache-2.0
"""Probability that noise alone looks like a comb of lines.

Source: Fisher (1932); the limit per line and the groups of lines are original to this module.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.combs import CombLines
from pitchpoint.analysis.sampled import Array

CLIP = float(np.log(100.0))
"""Maximum contribution of one line to the evidence, that of a probability of 1 in 100."""
MIN_LINES = 3
"""Minimum number of lines of a comb; fewer are tones."""
SHARES = (1, 2, 4)
"""All lines, the lower half and the lowest quarter are tested: a broad dip has no high harmonics."""
CELLS = 150
"""Steps of the lattice up to the limit of one line."""

Group = tuple[int, int]
"""Number of comb lines that share a noise estimate, and number of lines used for the estimate."""


def chance_of_comb(comb: CombLines, part: NDArray[np.bool_] | None = None) -> float:
    """Probability of the evidence of a comb under noise alone, with a limit on the weight of a single line.

    Parameters
    ----------
    comb
        Lines with their individual p-values.
    part
        Mask of the lines to use, shape (n_line,); default all.

    Returns
    -------
    float
        Probability [-]; 1 for a comb of fewer than three lines or a part of fewer than two.

    Notes
    -----
    S = Σ min(-ln p_k, ln 100). Under noise every -ln p is exponentially distributed; if they were independent
    and unlimited, 2S would be chi-square with 2n degrees of freedom [1]_. Lines that share a noise estimate
    are independent only for a given error of the estimate, which is gamma-distributed: the distribution of a
    group is an integral over this error, that of all groups a convolution. Accurate to 1 % of the
    probability. Valid down to about 100^-n.

    References
    ----------
    .. [1] R. A. Fisher, Statistical Methods for Research Workers, 4th edition, Oliver and Boyd, 1932, section
       21.1; the limit on a single line and the groups are additions.
    """
    use = np.ones(comb.orders.size, dtype=np.bool_) if part is None else part
    if np.count_nonzero(use) < 2 or comb.orders.size < MIN_LINES:
        return 1.0
    total = float(np.minimum(-np.log(np.maximum(comb.p_value[use], 1e-300)), CLIP).sum())
    _, first, size = np.unique(comb.group[use], return_index=True, return_counts=True)
    shared = comb.noise_lines[use][first]
    return limited_sum_chance(
        total, tuple(sorted((int(g), int(m)) for g, m in zip(size, shared, strict=True)))
    )


def evidence_of_comb(comb: CombLines, harmonics: int) -> tuple[float, float, int]:
    """Probabilities of a comb over its best bandwidth, and of the lines that exclude a shorter period.

    Parameters
    ----------
    comb
        Lines with their individual p-values.
    harmonics
        Highest requested multiple [-].

    Returns
    -------
    tuple
        Smallest probability of all lines, of the lower half and of the lowest quarter, times three for the
        choice; for these lines the largest probability of those that are not multiples of some prime (if it
        is not small, the true period may be a fraction of the tested one); highest multiple of these lines.
    """
    chances = [(chance_of_comb(comb, comb.orders <= harmonics // k), harmonics // k) for k in SHARES]
    chance, highest = min(chances)
    primes = [q for q in range(2, highest + 1) if all(q % d for d in range(2, q))]
    within = comb.orders <= highest
    own = max((chance_of_comb(comb, within & (comb.orders % q != 0)) for q in primes), default=1.0)
    return min(1.0, len(SHARES) * chance), own, highest


def limited_sum_chance(total: float, groups: tuple[Group, ...]) -> float:
    """Probability that the evidence of groups of lines reaches a value under noise.

    Parameters
    ----------
    total
        Sum of -ln p over the lines, each limited to ln 100 [-].
    groups
        Number of lines in each group, and number of lines used for its noise estimate [-].

    Examples
    --------
    Ten independent lines with a sum of 15; without the limit per line it would be 0.070:

    >>> round(limited_sum_chance(15.0, 10 * ((1, 8),)), 3)
    0.058
    """
    logs = _log_tail(groups)
    return float(np.exp(np.interp(total * CELLS / CLIP + 0.5, np.arange(logs.size), logs)))


@lru_cache(maxsize=512)
def _log_tail(groups: tuple[Group, ...]) -> Array:
    """Log of the probability that the sum reaches i - 1/2 steps of the lattice."""
    mass = np.ones(1)
    for group in groups:
        # all terms are positive: the tail keeps its relative precision
        mass = np.convolve(mass, _mass_of_group(*group))
    return np.log(np.clip(np.cumsum(mass[::-1])[::-1], 1e-300, 1.0))


@lru_cache(maxsize=128)
def _mass_of_group(size: int, shared: int) -> Array:
    """Probability mass of the sum of one group, on the lattice."""
    from scipy.special import gammaln

    edges = np.concatenate([[0.0], (np.arange(CELLS) + 0.5) / CELLS * CLIP])
    # error s of the noise estimate, gamma-distributed about 1, by the trapezoidal rule in ln s
    log_s = np.linspace(np.log(1e-5), np.log(30.0), 240)
    density = shared * (np.log(shared) + log_s - np.exp(log_s)) - gammaln(shared)
    weight = np.exp(density) * (log_s[1] - log_s[0])
    # a line reaches y if its power is above s m (exp(y/m) - 1)
    beyond = np.exp(-np.outer(np.exp(log_s), shared * np.expm1(edges / shared)))
    single = np.concatenate([beyond[:, :-1] - beyond[:, 1:], beyond[:, -1:]], axis=1)
    length = size * CELLS + 1
    sums = np.fft.irfft(np.fft.rfft(single, 2 * length, axis=1) ** size, 2 * length, axis=1)[:, :length]
    return np.maximum(weight @ sums, 0.0)
