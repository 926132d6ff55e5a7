# SPDX-License-Identifier: Apache-2.0
"""Stiffness of one tooth pair by the energy method: teeth as cantilevers, Hertzian contact, gear bodies.

Source: Ma, Song, Pang, Wen, Eng. Fail. Anal. 44 (2014) 179.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from pitchpoint.contact.hertz import half_width, line_approach, line_stiffness, plane_strain_compliance
from pitchpoint.contact.stiffness.description import Array, PairShape, positive, refuse
from pitchpoint.contact.stiffness.tooth_compliance import ToothCompliance, tooth_compliance
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.geometry.tooth_form import tooth_form


@dataclass(frozen=True)
class PairCompliance:
    """All compliances of one tooth pair, at equal steps of the path from A to E.

    Parameters
    ----------
    tooth_1, tooth_2
        Compliances of both teeth and their bodies, per unit face width along the base tangent [m^2/N].
    contact
        Hertzian compliance, per unit face width along the base tangent [m^2/N].
    """

    tooth_1: ToothCompliance
    tooth_2: ToothCompliance
    contact: Array

    @property
    def stiffness(self) -> Array:
        """Stiffness of the pair per unit face width [N/m^2], shape (points,)."""
        return np.asarray(1.0 / (self.tooth_1.total + self.tooth_2.total + self.contact))


def energy_compliance(
    pair: GearPair,
    *,
    points: int = 129,
    moduli: tuple[float, float] = (206.0e9, 206.0e9),
    poisson: tuple[float, float] = (0.3, 0.3),
    bores: tuple[float | None, float | None] = (None, None),
    body: str = "load_line",
    line_load: float = 0.0,
) -> PairCompliance:
    """Compliances of one tooth pair along its path of contact.

    Parameters
    ----------
    pair
        The gear pair, external or internal, spur or helical.
    points
        Number of equally spaced contact points from A to E, at least 2.
    moduli, poisson
        Young's moduli [Pa] and Poisson's ratios of both gears.
    bores
        Bore diameters at which the bodies are clamped [m]; None: half the root diameter.
    body
        Gear body model of Sainsot, Velex and Duverger: "load_line" (their definition of the load height),
        "contact_point" (height of the contact point, as in some programs) or "rigid". Internal gears are
        rigid.
    line_load
        Force along the base tangent per unit face width [N/m] for the load-dependent contact compliance of
        Weber and Banaschek; 0 uses the load-independent one.

    Raises
    ------
    ModelError
        If there are fewer than two points, the body model is unknown, or a modulus is not positive.

    Notes
    -----
    See `tooth_compliance` for the teeth. The contact lines of a helical pair are longer than the face width
    by 1/cos(beta_b) and loaded by F_n = F_bt/cos(beta_b), so the contact compliance is divided by
    cos(beta_b). The body compliance applies to each pair separately: the coupling of neighbouring pairs
    through the common gear body is not modelled.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=62, m_n=2e-3, b=20e-3)
    >>> found = energy_compliance(GearPair(gear, gear, 0.124), points=3)
    >>> (0.02 / found.contact / 1e9).round(4).tolist()              # pi E b/(4 (1 - nu^2))
    [3.5559, 3.5559, 3.5559]
    """
    if body not in ("load_line", "contact_point", "rigid"):
        raise refuse(
            "stiffness.body",
            "is not a model of the gear body",
            body,
            "load_line, contact_point, rigid",
            "choose",
        )
    if points < 2:
        raise refuse("stiffness.points", "is not enough points for a table", points, ">= 2", "use 129")
    E1, E2 = (positive("material.youngs_modulus", E, "Pa") for E in moduli)
    beta, beta_b = pair.gear1.beta, pair.gear1.beta_b
    rho_1 = np.linspace(pair.T1A, pair.T1E, points)
    rho_2 = np.abs(pair.T1T2 - rho_1)
    tooth_1, tooth_2 = (
        tooth_compliance(tooth_form(gear), rho, beta=beta, E=E, nu=nu, bore=bore, body=body)
        for gear, rho, E, nu, bore in zip(
            (pair.gear1, pair.gear2), (rho_1, rho_2), (E1, E2), poisson, bores, strict=True
        )
    )
    soft = [plane_strain_compliance(E, nu) for E, nu in zip((E1, E2), poisson, strict=True)]
    contact = np.full(points, 1.0 / line_stiffness(*soft))
    if line_load > 0.0:
        smallest = 1e-3 * pair.p_et  # finite contact width if the path begins on the base circle
        curvature = 1.0 / np.maximum(rho_1, smallest)
        curvature += math.copysign(1.0, pair.gear2.z) / np.maximum(rho_2, smallest)
        width = half_width(line_load, 1.0 / (curvature * math.cos(beta_b)), *soft)
        approach = line_approach(line_load, tooth_1.depth, width, soft[0], poisson[0])
        approach = approach + line_approach(line_load, tooth_2.depth, width, soft[1], poisson[1])
        contact = approach / line_load
    return PairCompliance(tooth_1, tooth_2, contact / math.cos(beta_b))


def energy(
    pair: GearPair,
    *,
    T_R: float = 0.0,
    points: int = 129,
    moduli: tuple[float, float] = (206.0e9, 206.0e9),
    poisson: tuple[float, float] = (0.3, 0.3),
    bores: tuple[float | None, float | None] = (None, None),
    body: str = "load_line",
    line_load: float = 0.0,
) -> PairShape:
    """Stiffness of one tooth pair by the energy method, as a table along the path of contact.

    Parameters
    ----------
    pair
        The gear pair.
    T_R
        Tip-relief factor of the ramp at both ends, in [0, 1].
    points, moduli, poisson, bores, body, line_load
        See `energy_compliance`.

    Returns
    -------
    PairShape
        c_prime is the maximum stiffness [N/m^2]; the table is relative to it. S_R is minimum over maximum.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=62, m_n=2e-3, b=20e-3)
    >>> shape = energy(GearPair(gear, gear, 0.124), bores=(0.035, 0.035))
    >>> round(shape.c_prime / 1e9, 2)
    12.02
    """
    stiffness = energy_compliance(
        pair, points=points, moduli=moduli, poisson=poisson, bores=bores, body=body, line_load=line_load
    ).stiffness
    top = float(stiffness.max())
    return PairShape(c_prime=top, S_R=float(stiffness.min()) / top, T_R=T_R, table=stiffness / top)
