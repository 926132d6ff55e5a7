# SPDX-License-Identifier: Apache-2.0
"""Moments of the mesh stiffness over the face width, by Gauss points between all kinks: an oracle.

The laws of a pair stand here once more, in NumPy, so that nothing of the kernels is shared.
"""

from __future__ import annotations

import numpy as np

NODES, WEIGHTS = np.polynomial.legendre.leggauss(3)


def width_moments(psi, lam, b, eps_alpha, S_R, L):
    """K0, K1, K2 [m, m^2, m^3] of parabolic pairs at mesh phases psi, each of the shape of psi."""
    return _moments(
        lambda p: 1.0 - (1.0 - S_R) * (2.0 * p / eps_alpha - 1.0) ** 2, (), psi, lam, b, eps_alpha, L
    )


def table_width_moments(psi, lam, b, eps_alpha, table, L):
    """The same where the stiffness of a pair is a table over its path of contact."""
    places = np.linspace(0.0, eps_alpha, len(table))
    return _moments(lambda p: np.interp(p, places, table), places, psi, lam, b, eps_alpha, L)


def _moments(law, kinks, psi, lam, b, eps_alpha, L):
    psi = np.asarray(psi, float)
    spread = 0.5 * abs(lam) * b
    first = int(np.floor(-psi.max() - spread))
    last = int(np.ceil(eps_alpha - psi.min() + spread))
    p0 = np.add.outer(psi, np.arange(first, last + 1))
    if spread < 1e-14:
        edges = np.broadcast_to([-0.5 * b, 0.5 * b], (*p0.shape, 2))
    else:
        ends = [0.0, min(L, 0.5 * eps_alpha), max(eps_alpha - L, 0.5 * eps_alpha), eps_alpha, *kinks]
        z = np.clip((ends - p0[..., None]) / lam, -0.5 * b, 0.5 * b)
        sides = np.broadcast_to([-0.5 * b, 0.5 * b], (*p0.shape, 2))
        edges = np.sort(np.concatenate([z, sides], axis=-1), axis=-1)
    half = 0.5 * np.diff(edges)[..., None]
    z = 0.5 * (edges[..., 1:] + edges[..., :-1])[..., None] + half * NODES
    p = p0[..., None, None] + lam * z
    reach = np.minimum(p, eps_alpha - p)
    ramp = np.clip(reach / L, 0.0, 1.0) if L > 0.0 else 1.0
    c = np.where(reach >= 0.0, law(np.clip(p, 0.0, eps_alpha)) * ramp, 0.0)
    return tuple((half * WEIGHTS * c * z**n).sum(axis=(-1, -2, -3)) for n in range(3))
