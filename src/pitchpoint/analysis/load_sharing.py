# SPDX-License-Identifier: Apache-2.0
"""Load sharing of one tooth pair over the path of contact, assembled from one period of a slow roll.

During a roll several pairs are in contact simultaneously, each on a part of the path of contact. Pairs use a
fixed number of slots in rotation; the share of each slot, at the position of its pair, is part of one curve.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

TOLERANCE = 0.02
"""Tolerated share outside the zone of contact."""


@dataclass(frozen=True)
class LoadSharing:
    """Load share of one tooth pair over its travel along the path of contact.

    Parameters
    ----------
    way
        Travel since the start of contact at mid-face [base pitches], shape (m,), increasing; empty if the
        slots do not match a sequence of pairs.
    share
        Load share [-], shape (m,).
    offset
        Lag of the given phase behind the start of contact [base pitches].
    """

    way: NDArray[np.float64]
    share: NDArray[np.float64]
    offset: float = 0.0


def share_along_path(
    phase: ArrayLike, share: ArrayLike, eps_alpha: float, eps_beta: float = 0.0, *, other_flank: bool = False
) -> LoadSharing:
    """Load share of one tooth pair over its travel along the path of contact.

    Parameters
    ----------
    phase
        Mesh phase [base pitches], shape (n,): travel since the last pair started contact at mid-face.
    share
        Share of every slot [-], shape (n, n_slot); pairs move by one slot when the phase wraps.
    eps_alpha, eps_beta
        Transverse contact ratio and overlap ratio: a pair is in contact from -eps_beta/2 to
        eps_alpha + eps_beta/2.
    other_flank
        True if the phase is that of the unloaded flank; the start of contact is then identified from the
        shares, with the resolution of the points.

    Examples
    --------
    Two pairs in contact for half of the time, a single pair otherwise:

    >>> s = share_along_path([0.1, 0.4, 0.6, 0.9], [[0.5, 0.5], [0.5, 0.5], [1, 0], [1, 0]], 1.5)
    >>> [(float(a), float(b)) for a, b in zip(s.way, s.share)]
    [(0.1, 0.5), (0.4, 0.5), (0.6, 1.0), (0.9, 1.0), (1.1, 0.5), (1.4, 0.5)]
    """
    psi = np.asarray(phase, dtype=np.float64)
    shares = np.atleast_2d(np.asarray(share, dtype=np.float64))
    n_slot = shares.shape[1] if shares.size else 0
    nothing = LoadSharing(np.zeros(0), np.zeros(0))
    if psi.size == 0 or n_slot == 0:
        return nothing
    best = (TOLERANCE, nothing)
    for offset in np.concatenate([[0.0], psi + 1e-9]) if other_flank else (0.0,):
        moved = (psi - offset) % 1.0
        for first in range(n_slot):
            for turn in (1, -1):
                wrong, found = _fit(moved, shares, (eps_alpha, eps_beta), first, turn)
                if wrong < best[0] - 1e-12:
                    best = wrong, LoadSharing(*found, float(offset))
    return best[1]


def _fit(
    psi: NDArray[np.float64],
    shares: NDArray[np.float64],
    ratios: tuple[float, float],
    first: int,
    turn: int,
) -> tuple[float, tuple[NDArray[np.float64], NDArray[np.float64]]]:
    """Curve for the last pair in slot `first`, preceded by the maximum share outside the zone of contact."""
    low, high = -0.5 * ratios[1], ratios[0] + 0.5 * ratios[1]
    wraps = -np.concatenate([[0], np.cumsum(np.round(np.diff(psi)).astype(int))])
    ages = np.arange(int(np.floor(low)) - 1, int(np.ceil(high)) + 1)
    slot = (first + turn * (wraps[:, None] - ages[None, :])) % shares.shape[1]
    way = psi[:, None] + ages[None, :]
    value = np.take_along_axis(shares, slot, axis=1)
    inside = (way >= low - 1e-9) & (way <= high + 1e-9)
    # shares outside the zone of contact do not fit
    wrong = float(np.abs(np.where(inside, value, 0.0).sum(axis=1) - shares.sum(axis=1)).max())
    order = np.argsort(way[inside], kind="stable")
    return wrong, (way[inside][order], value[inside][order])
