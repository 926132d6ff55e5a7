# SPDX-License-Identifier: Apache-2.0
"""Approach of two bodies in line contact at any width of the contact, with its energy and derivatives.

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


@dataclass(frozen=True)
class LineApproach:
    """Approach of a line contact with its derivatives and energy, arrays of the shape of the arguments.

    Attributes are described in `line_contact`.
    """

    approach: FloatArray
    tangent: FloatArray
    energy: FloatArray
    energy_by_radius: FloatArray
    energy_by_depth: tuple[FloatArray, FloatArray]


def line_contact(
    load: ArrayLike, radius: ArrayLike, depths: tuple[ArrayLike, ArrayLike], bodies: LineContact
) -> LineApproach:
    """Approach of two bodies in line contact, its derivative, and its complementary energy.

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
    LineApproach
        approach : h(q) [m], shape of the arguments broadcast against each other;
        tangent : dh/dq [m²/N], infinite at q = 0;
        energy : Ψ(q) = ∫₀^q h dq [N];
        energy_by_radius : ∂Ψ/∂R [N/m];
        energy_by_depth : ∂Ψ/∂t of both bodies [N/m].

    Notes
    -----
    With u = b_H² = k q, w = √(t² + u), κ = ν/(1 − ν) and A = 2 δ/π, a body contributes

    * dh/dq = A [asinh(t/b_H) − κ t/(w + t) − t/(2 w) + κ t (w − t)/(2 w (w + t))]
    * Ψ = A/k² [u²/2 asinh(t/b_H) + t/6 (w − t)² (w + 2 t) − κ t/3 (w − t)² (2 w + t)]
    * ∂Ψ/∂t = A/k² [2/3 (w − t)² (w + 2 t) − 2/3 κ (w − t)³]

    and, because Ψ k² depends on k q alone, ∂Ψ/∂R = (q h − 2 Ψ)/R.

    Examples
    --------
    Steel, gears 17/43 of module 1 mm at the pitch point, depths 1 mm, 300 N/mm; both bodies are equal, one
    has the approach h/q in 1e-3 µm mm/N:

    >>> steel = LineContact((206e9, 206e9), (0.3, 0.3))
    >>> found = line_contact(300e3, 2.0834727e-3, (1e-3, 1e-3), steel)
    >>> round(0.5 * float(found.approach) / 300e3 * 1e12, 5)
    8.32341
    """
    q, R = np.asarray(load, dtype=np.float64), np.asarray(radius, dtype=np.float64)
    first, second = bodies.compliances
    k = 4.0 * R * (first + second) / math.pi
    u = k * q
    approach, tangent, energy = (np.zeros(()) for _ in range(3))
    by_depth = []
    for compliance, nu, depth in zip((first, second), bodies.poisson, depths, strict=True):
        t = np.asarray(depth, dtype=np.float64)
        A, kappa = 2.0 * compliance / math.pi, nu / (1.0 - nu)
        w = np.sqrt(t * t + u)
        below = u / (w + t)  # w - t without cancellation
        with np.errstate(divide="ignore"):
            log = np.where(u > 0.0, np.arcsinh(t / np.sqrt(u)), np.inf)
        first_power = np.where(u > 0.0, q * np.where(u > 0.0, log, 0.0), 0.0)
        approach = approach + A * (first_power - kappa * q * t / (w + t))
        tangent = tangent + A * (
            log - kappa * t / (w + t) - 0.5 * t / w + 0.5 * kappa * t * below / (w * (w + t))
        )
        square = below * below
        rest = (0.5 * (w + 2.0 * t) - kappa * (2.0 * w + t)) * t / 3.0
        energy = energy + A * (0.5 * q * first_power + rest * square / k**2)
        by_depth.append(A * 2.0 / 3.0 * square * (w + 2.0 * t - kappa * below) / k**2)
    by_radius = (q * approach - 2.0 * energy) / R
    values = [np.asarray(v) for v in (approach, tangent, energy, by_radius, *by_depth)]
    return LineApproach(values[0], values[1], values[2], values[3], (values[4], values[5]))
