# SPDX-License-Identifier: Apache-2.0
"""Wear distribution over the flanks of a pair: line load times sliding, after Archard.

Source: Archard, J. Appl. Phys. 24 (1953) 981.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.contact.stiffness.description import Array, PairShape
from pitchpoint.geometry.gear_pair import GearPair

SMALLEST_RADIUS = 0.05
"""Lower limit of the radius of curvature in base pitches: the slide-to-roll ratio is unbounded at the base
circle, while a real contact has a finite width."""

_STEPS = 4000


def total_shape(shape: PairShape, eps_alpha: float, overlap: float, psi: ArrayLike) -> Array:
    """Total mesh stiffness over c' b at mesh phases at mid-face.

    Parameters
    ----------
    shape
        Stiffness of one pair.
    eps_alpha
        Transverse contact ratio.
    overlap
        Overlap ratio, advance of a contact line over the face width in base pitches, >= 0.
    psi
        Mesh phases [base pitches], any shape.

    Notes
    -----
    Sum over all pairs of the mean of c/c' along the contact line; for helical gears integrated with 4000
    steps of the path.

    Examples
    --------
    >>> flat = PairShape(c_prime=14e9, S_R=1.0)
    >>> total_shape(flat, 1.25, 0.0, [0.1, 0.5]).tolist()
    [2.0, 1.0]
    >>> total_shape(flat, 1.25, 1.0, [0.1]).round(6).tolist()
    [1.25]
    """
    psi = np.asarray(psi, dtype=np.float64)
    total = np.zeros(psi.shape)
    first = math.floor(-0.5 * overlap - float(psi.max()))
    last = math.ceil(eps_alpha + 0.5 * overlap - float(psi.min()))
    path = np.linspace(0.0, eps_alpha, _STEPS + 1)
    if overlap > 1e-6:
        c = shape.along(path, eps_alpha)
        area = np.concatenate([[0.0], np.cumsum(0.5 * (c[1:] + c[:-1]))]) * eps_alpha / _STEPS
    for q in range(first, last + 1):
        p = psi + q
        if overlap > 1e-6:
            ends = (np.interp(p + side * 0.5 * overlap, path, area) for side in (1.0, -1.0))
            high, low = ends
            total += (high - low) / overlap
        else:
            inside = (p >= 0.0) & (p <= eps_alpha)
            total += np.where(inside, shape.along(np.clip(p, 0.0, eps_alpha), eps_alpha), 0.0)
    return total


def wear_pattern(
    pair: GearPair, shape: PairShape, *, gear: int, z: ArrayLike, roll: ArrayLike, helix: float = 0.0
) -> Array:
    """Wear depth per revolution, normalised by wear coefficient times load per unit face width.

    Parameters
    ----------
    pair
        The gear pair.
    shape
        Stiffness of one pair, which determines the load sharing.
    gear
        Gear whose flank is evaluated, 1 or 2.
    z
        Positions along the face width from the middle of the common width [m], shape (n_z,).
    roll
        Roll lengths of that gear [m], positive, shape (n_roll,).
    helix
        Slope of the contact lines in base pitches per metre of face width; 0 for spur gears.

    Returns
    -------
    ndarray, shape (n_z, n_roll)
        Pattern w b/F |v_g|/v [-]; beyond the path of contact the value at its end.

    Notes
    -----
    Archard: the wear depth at a point of a flank increases by k p |v_g| dt (J. F. Archard, J. Appl. Phys. 24
    (1953) 981). The contact passes the point at the rolling speed v = ω ρ, and the pressure integrates to
    w/v with the line load w: h = k w |v_g|/v per revolution, with |v_g|/v = |1 − ρ_2 z_1/(ρ_1 z_2)| on gear
    1, zero at the pitch point. w is F/b times the load share c/Σ c of the line; without flank deviations
    this is the share of every line.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=40, m_n=3e-3, b=0.02)
    >>> pair = GearPair(gear, gear, 0.12)
    >>> even = PairShape(c_prime=14e9, S_R=1.0)
    >>> at = [pair.T1A, pair.T1C, pair.T1D]
    >>> wear_pattern(pair, even, gear=1, z=[0.0], roll=at).round(4).tolist()
    [[0.5867, 0.0, 0.0582]]
    """
    z = np.atleast_1d(np.asarray(z, dtype=np.float64))
    roll = np.abs(np.atleast_1d(np.asarray(roll, dtype=np.float64)))
    sign = math.copysign(1.0, pair.gear2.z)
    rho_1 = roll if gear == 1 else pair.T1T2 - sign * roll
    eps = pair.eps_alpha
    p = np.clip((rho_1 - pair.T1A) / pair.p_et, 0.0, eps)
    rho_1 = pair.T1A + p * pair.p_et
    rho_2 = np.abs(pair.T1T2 - rho_1)
    least = SMALLEST_RADIUS * pair.p_et
    ratio = abs(pair.gear2.z / pair.gear1.z)
    speed_1, speed_2 = np.maximum(rho_1, least), np.maximum(rho_2, least) / ratio
    slides = np.abs(rho_1 - rho_2 / ratio) / (speed_1 if gear == 1 else speed_2)
    psi = p[None, :] - helix * z[:, None]
    total = total_shape(shape, eps, abs(helix) * pair.b_w, psi)
    return np.asarray(shape.along(p, eps)[None, :] / total * slides)
