# SPDX-License-Identifier: Apache-2.0
"""Approach of two bodies in line contact at any width of the contact.

Per unit length of the contact line, with the half width b_H² = k q of Hertz, k = 4 R (δ_1 + δ_2)/π and
δ = (1 − ν²)/E. The displacement of a point at the depth t below the middle of a Hertzian pressure is, without
the assumption t ≫ b_H of `pitchpoint.contact.hertz.line_approach`,

    h(q) = Σ 2 δ q/π [asinh(t/b_H) − ν/(1 − ν) t/(√(t² + b_H²) + t)].

Source: stresses on the axis of a Hertzian line contact, K. L. Johnson, Contact Mechanics (1985), 4.2,
integrated from the surface to the depth t. Derivation: docs/theory/flank_compliance.md, "Local approach".
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.contact.hertz import plane_strain_compliance

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class LineContact:
    """Two bodies in line contact: their elastic constants.

    Parameters
    ----------
    moduli
        Young's moduli of both bodies [Pa].
    poisson
        Poisson's ratios of both bodies.
    """

    moduli: tuple[float, float]
    poisson: tuple[float, float]

    @property
    def compliances(self) -> tuple[float, float]:
        """(1 − ν²)/E of both bodies [1/Pa]."""
        (E1, E2), (nu1, nu2) = self.moduli, self.poisson
        return plane_strain_compliance(E1, nu1), plane_strain_compliance(E2, nu2)


def line_contact(
    load: ArrayLike, radius: ArrayLike, depths: tuple[ArrayLike, ArrayLike], bodies: LineContact
) -> FloatArray:
    """Approach of two bodies in line contact.

    Parameters
    ----------
    load
        Normal force per unit length of the contact line, q ≥ 0 [N/m].
    radius
        Reduced radius of curvature, 1/R = 1/ρ_1 + 1/ρ_2 [m].
    depths
        Distances t of the reference points from the contact along its normal, body 1 and body 2 [m]; for a
        tooth, to its centre line.
    bodies
        Elastic constants of both bodies.

    Returns
    -------
    NDArray
        h(q) [m], shape of the arguments broadcast against each other.

    Examples
    --------
    Steel, gears 17/43 of module 1 mm at the pitch point, depths 1 mm, 300 N/mm; both bodies are equal, one
    has the approach h/q in 1e-3 µm mm/N:

    >>> steel = LineContact((206e9, 206e9), (0.3, 0.3))
    >>> h = line_contact(300e3, 2.0834727e-3, (1e-3, 1e-3), steel)
    >>> round(0.5 * float(h) / 300e3 * 1e12, 5)
    8.32341
    """
    q, R = np.asarray(load, dtype=np.float64), np.asarray(radius, dtype=np.float64)
    first, second = bodies.compliances
    k = 4.0 * R * (first + second) / math.pi
    u = k * q
    approach = np.zeros(())
    for compliance, nu, depth in zip((first, second), bodies.poisson, depths, strict=True):
        t = np.asarray(depth, dtype=np.float64)
        A, kappa = 2.0 * compliance / math.pi, nu / (1.0 - nu)
        w = np.sqrt(t * t + u)
        with np.errstate(divide="ignore"):
            log = np.where(u > 0.0, np.arcsinh(t / np.sqrt(u)), 0.0)
        approach = approach + A * (q * log - kappa * q * t / (w + t))
    return np.asarray(approach)
