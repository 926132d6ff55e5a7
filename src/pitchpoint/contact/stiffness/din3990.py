# SPDX-License-Identifier: Apache-2.0
"""Stiffness of one tooth pair to DIN 3990-1 / ISO 6336-1 method B (Schaefer's polynomial).

The unit of c' in the standard is 1 N/(mm um) = 1e9 N/m^2. All values apply in the transverse plane along the
base tangent.
"""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass

from pitchpoint.contact.stiffness.description import PairShape, positive, refuse
from pitchpoint.core.errors import ValidityWarning
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.gear_pair import GearPair

#: C1..C9 of the polynomial, in mm um/N.
POLYNOMIAL = (0.04723, 0.15551, 0.25791, -0.00635, -0.11654, -0.00193, -0.24188, 0.00529, 0.00182)

#: N/(mm um) in N/m^2.
UNIT = 1.0e9

#: Specific load F_t K_A/b below which the stiffness decreases [N/m] (ISO 6336-1: 100 N/mm).
LOW_LOAD = 1.0e5


@dataclass(frozen=True, kw_only=True)
class SingleStiffness:
    """Single stiffness c' and mesh stiffness with all intermediate values [N/m^2] and factors [-]."""

    c_th: float
    c_prime: float
    c_gamma_alpha: float
    c_gamma_beta: float
    C_M: float
    C_R: float
    C_B: float
    modulus_ratio: float
    z_n1: float
    z_n2: float


def theoretical_stiffness(z_n1: float, z_n2: float, x1: float, x2: float) -> float:
    """Theoretical single stiffness c'_th = 1/q' of two solid disc gears with the standard basic rack [N/m^2].

    Parameters
    ----------
    z_n1, z_n2
        Numbers of teeth of the virtual spur gears; gear 1 is the smaller. ``math.inf`` for an internal gear.
    x1, x2
        Profile shift coefficients; for an internal gear with the sign of ISO 21771.

    Raises
    ------
    ModelError
        If the polynomial is not positive (far outside its range of validity).

    Notes
    -----
    q' = C1 + C2/z_n1 + C3/z_n2 + C4 x1 + C5 x1/z_n1 + C6 x2 + C7 x2/z_n2 + C8 x1^2 + C9 x2^2 [1]_. The
    range of validity is x1 >= x2 and -0.5 <= x1 + x2 <= 2; a ValidityWarning reports values outside it.

    References
    ----------
    .. [1] DIN 3990-1:1987; ISO 6336-1:2006, single stiffness, method B.

    Examples
    --------
    >>> round(theoretical_stiffness(18.9050973, 114.5426482, 0.145, 0.0) / 1e9, 5)
    17.85584
    """
    if x1 < x2 or not -0.5 <= x1 + x2 <= 2.0:
        warnings.warn(
            f"profile shifts x₁ = {x1:.4g} (smaller gear), x₂ = {x2:.4g} lie outside the range of the"
            " DIN 3990 / ISO 6336-1 stiffness polynomial (x₁ >= x₂, -0.5 <= x₁ + x₂ <= 2)",
            ValidityWarning,
            stacklevel=2,
        )
    C1, C2, C3, C4, C5, C6, C7, C8, C9 = POLYNOMIAL
    q = C1 + C2 / z_n1 + C3 / z_n2 + C4 * x1 + C5 * x1 / z_n1 + C6 * x2 + C7 * x2 / z_n2
    q += C8 * x1 * x1 + C9 * x2 * x2
    if not q > 0.0:
        raise refuse(
            "stiffness.law", "is the tooth flexibility of din3990", q, "> 0", "use law: energy or constant"
        )
    return UNIT / q


def basic_rack_factor(h_fP_star: float, alpha_n: float) -> float:
    """Basic rack factor C_B = [1 + 0.5 (1.2 - h_fP*)] [1 - 0.02 (20 - alpha_n/deg)].

    Source: ISO 6336-1, single stiffness.

    Parameters
    ----------
    h_fP_star
        Dedendum of the basic rack in modules, h_fP* [-].
    alpha_n
        Normal pressure angle α_n [rad].

    Examples
    --------
    >>> [round(basic_rack_factor(h, math.radians(20.0)), 12) for h in (1.2, 1.25, 1.4)]
    [1.0, 0.975, 0.9]
    """
    return (1.0 + 0.5 * (1.2 - h_fP_star)) * (1.0 - 0.02 * (20.0 - math.degrees(alpha_n)))


def blank_factor(web_over_width: float, rim_over_module: float) -> float:
    """Gear blank factor C_R = 1 + ln(b_s/b)/(5 exp(s_R/(5 m_n))) for a wheel with web and rim.

    Parameters
    ----------
    web_over_width
        Web thickness over face width, b_s/b; limited to 0.2 ... 1.2.
    rim_over_module
        Rim thickness below the root over normal module, s_R/m_n; limited to values >= 1.

    Notes
    -----
    Source: ISO 6336-1, gear blank factor. Solid gears have C_R = 1.

    Examples
    --------
    >>> round(blank_factor(0.25, 5.0), 4), round(blank_factor(0.25, 3.5), 4)
    (0.898, 0.8623)
    """
    web = min(max(web_over_width, 0.2), 1.2)
    return 1.0 + math.log(web) / (5.0 * math.exp(max(rim_over_module, 1.0) / 5.0))


def virtual_teeth(gear: CylindricalGear, formula: str = "iso") -> float:
    """Number of teeth of the virtual spur gear, z_n; infinite for an internal gear.

    Parameters
    ----------
    gear
        The gear.
    formula
        "iso" for z/(cos² β_b cos β), "cos3" for the older approximation z/cos³ β.

    Raises
    ------
    ModelError
        If the formula is unknown.

    Examples
    --------
    >>> gear = CylindricalGear(z=17, m_n=8e-3, beta=math.radians(15.8), b=0.1)
    >>> round(virtual_teeth(gear), 4), round(virtual_teeth(gear, "cos3"), 4)
    (18.9051, 19.0822)
    """
    if formula not in ("iso", "cos3"):
        raise refuse(
            "stiffness.virtual_teeth",
            "is not a formula for the virtual numbers of teeth",
            formula,
            "iso or cos3",
            "use iso",
        )
    if gear.z < 0:
        return math.inf
    if formula == "cos3":
        return gear.z / math.cos(gear.beta) ** 3
    return gear.z / (math.cos(gear.beta_b) ** 2 * math.cos(gear.beta))


def single_stiffness(
    pair: GearPair,
    *,
    C_M: float = 0.8,
    C_R: float = 1.0,
    moduli: tuple[float, float] | None = None,
    modulus_steel: float = 206.0e9,
    virtual_teeth_formula: str = "iso",
) -> SingleStiffness:
    """Single stiffness and mesh stiffness of a pair with all factors.

    Parameters
    ----------
    pair
        The gear pair in any order; gear 1 of the formula is the one with fewer teeth (for equal numbers of
        teeth, the one with the larger profile shift).
    C_M
        Correction factor between theory and measurement [-].
    C_R
        Gear blank factor [-], see `blank_factor`; use that of the more flexible blank.
    moduli
        Young's moduli of the two gears [Pa]; None means steel on steel.
    modulus_steel
        Young's modulus of the steel on which the polynomial is based [Pa].
    virtual_teeth_formula
        See `virtual_teeth`.

    Returns
    -------
    SingleStiffness
        c'_th, c' = c'_th C_M C_R C_B cos(beta) E/E_steel, c_gamma_alpha = c' (0.75 eps_alpha + 0.25),
        c_gamma_beta = 0.85 c_gamma_alpha [N/m^2], and the factors.

    Notes
    -----
    Source: ISO 6336-1:2006, method B. E = 2 E1 E2/(E1 + E2). C_B is the mean value of both basic racks, with
    the effective dedendum if a root diameter is given. For an internal gear 1/z_n2 = 0 and x2 has the sign
    of ISO 21771.

    Examples
    --------
    Spur pair 62/62, m = 2 mm:

    >>> gear = CylindricalGear(z=62, m_n=2e-3, b=20e-3)
    >>> values = single_stiffness(GearPair(gear, gear, 0.124))
    >>> round(values.c_prime / 1e9, 4), round(values.c_gamma_alpha / 1e9, 4)
    (14.4718, 23.0439)
    """
    one, two = (
        VirtualTooth(virtual_teeth(g, virtual_teeth_formula), g.x, g.h_fP_star, g.alpha_n, g.beta)
        for g in (pair.gear1, pair.gear2)
    )
    return stiffness_of_teeth((one, two), pair.eps_alpha, C_M, C_R, moduli, modulus_steel)


@dataclass(frozen=True)
class VirtualTooth:
    """Tooth of a virtual spur gear: z_n, x, h_fP* [-], alpha_n and helix or spiral angle [rad]."""

    z_n: float
    x: float
    h_fP_star: float
    alpha_n: float
    beta: float


def stiffness_of_teeth(
    teeth: tuple[VirtualTooth, VirtualTooth],
    eps_alpha: float,
    C_M: float = 0.8,
    C_R: float = 1.0,
    moduli: tuple[float, float] | None = None,
    modulus_steel: float = 206.0e9,
) -> SingleStiffness:
    """Single stiffness and mesh stiffness of two teeth of virtual spur gears, see `single_stiffness`.

    Source: ISO 6336-1:2006, method B; bevel gears with the virtual gears of ISO 10300-1 and the mean normal
    module.

    Parameters
    ----------
    teeth
        Teeth of gear 1 and gear 2.
    eps_alpha
        Transverse contact ratio [-].
    C_M, C_R, moduli, modulus_steel
        As in `single_stiffness`.

    Examples
    --------
    >>> tooth = VirtualTooth(62.0, 0.0, 1.25, math.radians(20.0), 0.0)
    >>> round(stiffness_of_teeth((tooth, tooth), 1.7903).c_prime / 1e9, 4)
    14.4718
    """
    first, second = sorted(teeth, key=lambda tooth: (tooth.z_n, -tooth.x))
    c_th = theoretical_stiffness(first.z_n, second.z_n, first.x, second.x)
    C_B = 0.5 * sum(basic_rack_factor(g.h_fP_star, g.alpha_n) for g in (first, second))
    ratio = 1.0
    if moduli is not None:
        E1, E2 = (positive("material.youngs_modulus", E, "Pa") for E in moduli)
        ratio = 2.0 * E1 * E2 / (E1 + E2) / modulus_steel
    c_prime = c_th * C_M * C_R * C_B * math.cos(first.beta) * ratio
    c_gamma_alpha = c_prime * (0.75 * eps_alpha + 0.25)
    return SingleStiffness(
        c_th=c_th,
        c_prime=c_prime,
        c_gamma_alpha=c_gamma_alpha,
        c_gamma_beta=0.85 * c_gamma_alpha,
        C_M=C_M,
        C_R=C_R,
        C_B=C_B,
        modulus_ratio=ratio,
        z_n1=first.z_n,
        z_n2=second.z_n,
    )


def din3990(
    pair: GearPair,
    *,
    S_R: float = 0.8,
    T_R: float = 0.0,
    c_prime: float | None = None,
    low_load: bool = False,
    C_M: float = 0.8,
    C_R: float = 1.0,
    moduli: tuple[float, float] | None = None,
    modulus_steel: float = 206.0e9,
    virtual_teeth_formula: str = "iso",
) -> PairShape:
    """Parabolic stiffness of one tooth pair with c' to DIN 3990 / ISO 6336-1.

    Parameters
    ----------
    pair
        The gear pair.
    S_R, T_R
        Stiffness ratio and tip-relief factor of the parabola, both in [0, 1].
    c_prime
        Given value of c' that replaces the polynomial [N/m^2] (14e9 is a common value for steel).
    low_load
        Reduce the stiffness below the specific load F_t K_A/b = 100 N/mm, c' ~ (F_t K_A/(100 b))^0.25.
    C_M, C_R, moduli, modulus_steel, virtual_teeth_formula
        See `single_stiffness`.

    Notes
    -----
    The load limit is converted to the base tangent: 1e5 N/m / cos(alpha_t).

    Examples
    --------
    >>> gear = CylindricalGear(z=62, m_n=2e-3, b=20e-3)
    >>> round(din3990(GearPair(gear, gear, 0.124)).c_prime / 1e9, 4)
    14.4718
    """
    if c_prime is None:
        c_prime = single_stiffness(
            pair,
            C_M=C_M,
            C_R=C_R,
            moduli=moduli,
            modulus_steel=modulus_steel,
            virtual_teeth_formula=virtual_teeth_formula,
        ).c_prime
    limit = LOW_LOAD / math.cos(pair.gear1.alpha_t) if low_load else 0.0
    return PairShape(c_prime=c_prime, S_R=S_R, T_R=T_R, load_limit=limit)
