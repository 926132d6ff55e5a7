# SPDX-License-Identifier: Apache-2.0
"""Variation of the mesh stiffness over both contact ratios, and the best overlap ratio.

The stiffness of a helical mesh is a moving average of that of a spur pair over eps_beta base pitches. An
average over whole periods is constant, so the variation vanishes at integer overlap ratios (L. Mauer, SIMPACK
User Meeting 2006).

Derivation: docs/theory/stiffness.md, "The mesh".
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from pitchpoint.contact.cycle_pieces import variations
from pitchpoint.contact.stiffness.description import Array, PairShape

STEP = 0.01
"""Step of the search for the best overlap ratio."""
EQUAL = 1e-12
"""Difference of two variations, over c' b, below which they are equal."""


@dataclass(frozen=True)
class OverlapMap:
    """Variation of the mesh stiffness over the contact ratios.

    Parameters
    ----------
    eps_alpha, eps_beta
        Transverse contact ratios, shape (n,), and overlap ratios, shape (m,) [-].
    peak_to_peak
        Maximum less minimum of the stiffness over the mesh cycle, relative to c' b, shape (m, n) [-].
    S_R, T_R
        Stiffness ratio and tip-relief factor [-].
    """

    eps_alpha: Array
    eps_beta: Array
    peak_to_peak: Array
    S_R: float
    T_R: float


class BestOverlap(NamedTuple):
    """Best overlap ratio of a range, and the variation of the stiffness there, relative to c' b [-]."""

    eps_beta: float
    peak_to_peak: float


def overlap_map(eps_alpha: Array, eps_beta: Array, S_R: float = 0.8, T_R: float = 0.0) -> OverlapMap:
    """Compute the variation of the mesh stiffness over both contact ratios.

    Parameters
    ----------
    eps_alpha, eps_beta
        Transverse contact ratios (> 0), shape (n,), and overlap ratios (>= 0), shape (m,) [-].
    S_R, T_R
        Stiffness ratio and tip-relief factor of one tooth pair, both in [0, 1].

    Raises
    ------
    ModelError
        If a number is out of range.

    Notes
    -----
    For S_R = 1, T_R = 0, e = frac(eps_alpha) and f = frac(eps_beta) it is min(e, 1 - e, f, 1 - f)/eps_beta,
    and 1 for eps_beta <= min(e, 1 - e).

    Examples
    --------
    >>> found = overlap_map([1.3], [0.3, 0.7, 1.0], S_R=1.0)
    >>> found.peak_to_peak[:, 0].round(7).tolist()
    [1.0, 0.4285714, 0.0]
    """
    across, up = np.asarray(eps_alpha, dtype=np.float64), np.asarray(eps_beta, dtype=np.float64)
    shape = PairShape(c_prime=1.0, S_R=S_R, T_R=T_R)
    found = np.stack([variations(shape, float(a), up) for a in across], axis=1)
    return OverlapMap(across, up, np.where(found < EQUAL, 0.0, found), S_R, T_R)


def best_overlap(eps_alpha: float, most: float, S_R: float = 0.8, T_R: float = 0.0) -> BestOverlap:
    """Smallest overlap ratio up to a limit with the least variation of the stiffness.

    Parameters
    ----------
    eps_alpha
        Transverse contact ratio (> 0) [-].
    most
        Largest overlap ratio, for example that of the available face width [-].
    S_R, T_R
        Stiffness ratio and tip-relief factor, both in [0, 1].

    Notes
    -----
    Overlap ratios in steps of 0.01, those of the sharp edges and integers are compared.

    Examples
    --------
    >>> best_overlap(1.3, 2.5)
    BestOverlap(eps_beta=1.0, peak_to_peak=0.0)
    >>> best_overlap(1.3, 0.75).eps_beta
    0.75
    """
    edge = eps_alpha - math.floor(eps_alpha)
    whole = np.arange(math.floor(most) + 1)
    tried = np.concatenate([np.arange(0.0, most, STEP), [most], whole, whole + edge, whole + 1.0 - edge])
    tried = np.unique(tried[tried <= most])
    found = overlap_map(np.array([eps_alpha]), tried, S_R, T_R).peak_to_peak[:, 0]
    k = int(np.argmax(found <= found.min() + EQUAL))
    return BestOverlap(float(tried[k]), float(found[k]))
