# SPDX-License-Identifier: Apache-2.0
"""Moments of the mesh stiffness over the face width, summed over all pairs in contact.

Meshes add the pairs up themselves, each with its own load; tests want the sum of nominal pairs.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.contact.width_integral import first_pair, last_pair, pair_moments
from pitchpoint.contact.width_table import table_pair_moments


def _summed(pair, psi, lam, b, eps_alpha, *law):
    """Sum over the pairs in contact at the mesh phase psi."""
    spread = 0.5 * abs(lam) * b
    pairs = range(first_pair(psi, spread), last_pair(psi, spread, eps_alpha) + 1)
    sums = np.array([pair(psi + j, lam, b, eps_alpha, *law) for j in pairs]).reshape(-1, 3).sum(axis=0)
    return tuple(float(value) for value in sums)


def width_moments(psi, lam, b, eps_alpha, S_R, L, order=0):
    """K0, K1, K2 [m, m^2, m^3], or with order 1 their derivatives by psi; a jump of a spur mesh has none."""
    return _summed(pair_moments, psi, lam, b, eps_alpha, S_R, L, order)


def table_width_moments(psi, lam, b, eps_alpha, n, table, L, order):
    """The same where the stiffness of a pair is a table over its path of contact."""
    return _summed(table_pair_moments, psi, lam, b, eps_alpha, n, table, L, order)
