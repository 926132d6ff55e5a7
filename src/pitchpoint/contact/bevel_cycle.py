# SPDX-License-Identifier: Apache-2.0
"""Total stiffness of a bevel mesh over one mesh cycle.

A tooth slice at cone distance R acts on the gear with lever arm R, so its stiffness is weighted with R².
Along a contact line of spiral teeth the path position varies linearly with ln R. Straight teeth touch along
rays through the apex; their cycle is that of spur gears.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.contact.mesh_cycle import MeshCycle, pair_cycle
from pitchpoint.contact.stiffness.description import Array, PairShape

STRAIGHT = 1e-9
"""Overlap ratio below which teeth are treated as straight."""
EXTREMES = 4000
"""Number of phases sampled for the extremes of spiral teeth."""

_X, _W = np.polynomial.legendre.leggauss(5)


def bevel_cycle(
    shape: PairShape, eps_alpha: float, rate: float, face: tuple[float, float], n: int = 401
) -> MeshCycle:
    """Mesh cycle of bevel gears, in units of c' times the integral of (R/R_m)² over the face.

    Parameters
    ----------
    shape
        Stiffness of one pair.
    eps_alpha
        Transverse contact ratio [-].
    rate
        Advance of a contact line in base pitches per ln R [-]: tan β_b1 / σ_p on front flanks, its negative
        on back flanks; 0 for straight teeth.
    face
        Inner and outer end of the common face width, R_i/R_m and R_e/R_m [-].
    n
        Number of sampled phases, both ends included.

    Returns
    -------
    MeshCycle
        The phase is zero when a pair starts contact at R_m. The mean is exact; the extremes of spiral teeth
        are taken from 4000 phases.

    Notes
    -----
    k(ψ) = Σ_q ∫ c(ψ + q + rate y) e^{3y} dy / ∫ e^{3y} dy over y = ln(R/R_m): c (R/R_m)² over R.

    Examples
    --------
    >>> cycle = bevel_cycle(PairShape(c_prime=14e9, S_R=0.8), 1.3, 5.0, (0.85, 1.15))
    >>> round(cycle.mean, 7), bool(cycle.minimum < cycle.mean < cycle.maximum)
    (1.2133333, True)
    """
    low, high = (math.log(end) for end in face)
    spur = pair_cycle(shape, eps_alpha, 0.0, n)
    if abs(rate) * (high - low) < STRAIGHT:
        return spur
    found = _spiral(shape, eps_alpha, rate, (low, high), np.linspace(0.0, 1.0, EXTREMES + 1))
    least, greatest = float(found.min()), float(found.max())
    return MeshCycle(
        phase=spur.phase,
        stiffness_ratio=_spiral(shape, eps_alpha, rate, (low, high), spur.phase),
        mean=spur.mean,
        minimum=least,
        maximum=greatest,
        peak_to_peak=greatest - least,
        breakpoints=np.empty(0),
        jumps=(),
    )


def _spiral(
    shape: PairShape, eps_alpha: float, rate: float, ends: tuple[float, float], phase: Array
) -> Array:
    """Sum over all pairs at the given phases; five Gauss points between kinks of a contact line."""
    L = min(shape.ramp_length(eps_alpha), 0.5 * eps_alpha)
    inner = () if shape.table is None else np.linspace(0.0, eps_alpha, shape.table.size)
    kinks = np.unique([0.0, L, eps_alpha - L, eps_alpha, *inner])
    reach = sorted(rate * end for end in ends)
    pairs = np.arange(math.floor(-1.0 - reach[1]), math.ceil(eps_alpha - reach[0]) + 1)
    start = (phase[:, None] + pairs)[..., None]  # path position at R_m
    a = np.maximum(kinks[:-1], start + reach[0])[..., None]
    half = 0.5 * np.maximum(np.minimum(kinks[1:], start + reach[1])[..., None] - a, 0.0)
    p = a + half * (1.0 + _X)
    weight = half * _W * np.exp(3.0 * (p - start[..., None]) / rate) / abs(rate)
    total = (weight * shape.along(np.clip(p, 0.0, eps_alpha), eps_alpha)).sum(axis=(1, 2, 3))
    return np.asarray(total * 3.0 / (math.exp(3.0 * ends[1]) - math.exp(3.0 * ends[0])))
