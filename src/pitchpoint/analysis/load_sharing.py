# SPDX-License-Identifier: Apache-2.0
"""Load sharing of one tooth pair on its way through the mesh, put together from a roll through one period.

During a roll several pairs are in contact at once, each seen on a part of its way. Pairs take turns in a
fixed number of slots; each slot's share, moved to the place of its pair, is a piece of one and the same curve.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

TOLERANCE = 0.02
"""Share that may lie outside the zone of contact before the pieces count as not fitting."""


def share_along_path(
    phase: ArrayLike, share: ArrayLike, eps_alpha: float, eps_beta: float = 0.0
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Share of one tooth pair in the load over its way.

    Parameters
    ----------
    phase
        Mesh phase [base pitches], shape (n,): the last pair began contact at mid-face this long ago.
    share
        Share of every slot, shape (n, n_slot); the pairs move on by one slot when the phase wraps.
    eps_alpha, eps_beta
        Transverse contact ratio and overlap ratio: a pair carries from -eps_beta/2 to
        eps_alpha + eps_beta/2.

    Returns
    -------
    tuple
        Way since the beginning of contact at mid-face [base pitches] and share, shape (m,), ascending; empty
        if the slots fit no succession of pairs.

    Examples
    --------
    Two pairs, each alone half of the time:

    >>> p, s = share_along_path([0.1, 0.4, 0.6, 0.9], [[0.5, 0.5], [0.5, 0.5], [1, 0], [1, 0]], 1.5)
    >>> [(float(a), float(b)) for a, b in zip(p, s)]
    [(0.1, 0.5), (0.4, 0.5), (0.6, 1.0), (0.9, 1.0), (1.1, 0.5), (1.4, 0.5)]
    """
    psi = np.asarray(phase, dtype=np.float64)
    shares = np.atleast_2d(np.asarray(share, dtype=np.float64))
    n_slot = shares.shape[1] if shares.size else 0
    if psi.size == 0 or n_slot == 0:
        return np.zeros(0), np.zeros(0)
    wraps = np.concatenate([[0], np.cumsum(np.round(np.diff(psi)).astype(int))])
    low, high = -0.5 * eps_beta, eps_alpha + 0.5 * eps_beta
    ages = np.arange(int(np.floor(low)) - 1, int(np.ceil(high)) + 1)
    best: tuple[float, NDArray[np.float64], NDArray[np.float64]] | None = None
    for first in range(n_slot):
        for turn in (1, -1):
            slot = (first - turn * wraps[:, None] - turn * ages[None, :]) % n_slot
            way = psi[:, None] + ages[None, :]
            value = np.take_along_axis(shares, slot, axis=1)
            inside = (way >= low - 1e-9) & (way <= high + 1e-9)
            # what the slots hold beyond the zone of contact, or do not show inside it, does not fit
            wrong = float(np.abs(np.where(inside, value, 0.0).sum(axis=1) - shares.sum(axis=1)).max())
            if best is None or wrong < best[0] - 1e-12:
                best = wrong, way[inside], value[inside]
    if best is None or best[0] > TOLERANCE:
        return np.zeros(0), np.zeros(0)
    order = np.argsort(best[1], kind="stable")
    return best[1][order], best[2][order]
