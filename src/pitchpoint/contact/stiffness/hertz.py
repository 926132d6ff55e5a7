# SPDX-License-Identifier: Apache-2.0
"""Tooth pair as a Hertzian point contact: force K delta^1.5 with the curvatures at the pitch point.

Source: Hertz's theory in Johnson, Contact Mechanics (1985), 4.2.
"""

from __future__ import annotations

import math

from pitchpoint.contact.stiffness.description import PairShape, positive, refuse
from pitchpoint.geometry.gear_pair import GearPair

#: Diameters on which the curvatures can be based.
DIAMETERS = ("reference", "operating")


def equivalent_radius(pair: GearPair, diameter: str = "reference") -> float:
    """Equivalent radius R of curvature of a pair at its pitch point, normal to the flanks [m].

    Parameters
    ----------
    pair
        The gear pair; internal gears have z < 0.
    diameter
        Diameter d_1 of gear 1 that is multiplied by cos alpha_t. "reference" gives r_b1 tan alpha_wt, the
        exact radius of curvature of the flank. "operating" uses the working pitch diameter, which gives a
        radius too large by cos alpha_t/cos alpha_wt.

    Raises
    ------
    ModelError
        If the diameter is neither "reference" nor "operating".

    Notes
    -----
    R = i d_1 cos(alpha_t) tan(alpha_wt)/(2 (1 + i) cos(beta_b)), i = z_2/z_1 with its sign. The reference
    diameter is exact: with rho_1 = r_b1 tan(alpha_wt)/cos(beta_b) and rho_2 = i rho_1, 1/R = 1/rho_1 +
    1/rho_2.

    Examples
    --------
    Second stage of a crawler gearbox, z 12/68, m_n 16 mm, beta 12 deg, a 665 mm [mm]:

    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> beta = math.radians(12.0)
    >>> one = CylindricalGear(z=12, m_n=16e-3, beta=beta, x=0.45, b=0.21)
    >>> two = CylindricalGear(z=68, m_n=16e-3, beta=-beta, x=0.256365, b=0.20)
    >>> pair = GearPair(one, two, 0.665)
    >>> round(1e3 * equivalent_radius(pair), 2), round(1e3 * equivalent_radius(pair, "operating"), 2)
    (33.45, 33.99)
    """
    if diameter not in DIAMETERS:
        raise refuse(
            "stiffness.diameter",
            "is not a known diameter",
            diameter,
            " or ".join(DIAMETERS),
            "use one of them",
        )
    z1, z2 = pair.gear1.z, pair.gear2.z
    d_1 = pair.gear1.d if diameter == "reference" else 2.0 * pair.a_w * z1 / (z1 + z2)
    tangent = math.cos(pair.gear1.alpha_t) * math.tan(pair.alpha_wt) / (2.0 * math.cos(pair.gear1.beta_b))
    return float(d_1 * tangent * z2 / (z1 + z2))


def hertz_constant(
    pair: GearPair,
    moduli: tuple[float, float],
    poisson: tuple[float, float],
    diameter: str = "reference",
) -> float:
    """Constant K of a tooth pair, normal force F_n = K delta^1.5 [N/m^1.5].

    Parameters
    ----------
    pair
        The gear pair.
    moduli, poisson
        Young's moduli [Pa] and Poisson's ratios of both gears.
    diameter
        See `equivalent_radius`.

    Notes
    -----
    K = (4/3) sqrt(R) E*, 1/E* = sum of (1 - nu^2)/E: two spheres with the curvature of the flanks (H. Hertz,
    1881), as used for whole tooth pairs in a study of a mining shovel's crawler gearbox, eq. 3. K is
    independent of the face width.

    Examples
    --------
    Same stage, pinion 210 GPa, wheel 175 GPa [1e5 N/mm^1.5]; Table 4 of that study gives 8.102:

    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> beta = math.radians(12.0)
    >>> one = CylindricalGear(z=12, m_n=16e-3, beta=beta, x=0.45, b=0.21)
    >>> two = CylindricalGear(z=68, m_n=16e-3, beta=-beta, x=0.256365, b=0.20)
    >>> steel = (210e9, 175e9), (0.29, 0.29)
    >>> K = [hertz_constant(GearPair(one, two, 0.665), *steel, d) for d in ("reference", "operating")]
    >>> [round(k / 1e3**1.5 / 1e5, 4) for k in K]
    [8.0363, 8.1018]
    """
    compliance = sum(
        (1.0 - nu * nu) / positive("material.youngs_modulus", E, "Pa")
        for E, nu in zip(moduli, poisson, strict=True)
    )
    return 4.0 / 3.0 * math.sqrt(equivalent_radius(pair, diameter)) / compliance


def hertz(
    pair: GearPair,
    *,
    moduli: tuple[float, float],
    poisson: tuple[float, float],
    diameter: str = "reference",
    constant: float | None = None,
    exponent: float = 1.5,
    T_R: float = 0.0,
) -> PairShape:
    """Tooth pair with the normal force K delta^exponent, constant along the path of contact.

    Parameters
    ----------
    pair
        The gear pair.
    moduli, poisson, diameter
        See `hertz_constant`.
    constant
        Given constant K of the pair [N/m^exponent]; replaces the Hertzian value.
    exponent
        Exponent of the force.
    T_R
        Tip-relief factor in [0, 1]: ramps at both ends of the path.

    Notes
    -----
    K applies to a contact line over the whole common face width and is distributed uniformly along it: a
    pair in contact over half of its line has K/2. Along the base tangent F_bt = F_n cos(beta_b) and delta =
    u_bt cos(beta_b), so the constant there is K cos(beta_b)^(1 + exponent).

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=62, m_n=2e-3, b=20e-3)
    >>> law = hertz(GearPair(gear, gear, 0.124), moduli=(206e9, 206e9), poisson=(0.3, 0.3))
    >>> round(law.c_prime * 20e-3 / 1e10, 4), law.power
    (1.554, 1.5)
    """
    if constant is None:
        constant = hertz_constant(pair, moduli, poisson, diameter)
    k = positive("stiffness.force", constant, "N") * math.cos(pair.gear1.beta_b) ** (1.0 + exponent)
    return PairShape(c_prime=k / pair.b_w, S_R=1.0, T_R=T_R, power=exponent)
