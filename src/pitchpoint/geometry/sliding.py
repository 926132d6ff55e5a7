# SPDX-License-Identifier: Apache-2.0
"""Sliding of the flanks: specific sliding, sliding factors, tooth loss factor H_V.

Gear 1 drives; path coordinates T1Y run along the line of action from the foot of gear 1's base tangent.

Source: ISO 21771; tooth loss factor Ohlendorf (1958) as used by Niemann and Winter.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

from pitchpoint.core.errors import GeometryError

if TYPE_CHECKING:
    from pitchpoint.geometry.gear_pair import GearPair


class SpecificSliding(NamedTuple):
    """Specific sliding of both gears [-] at the ends of their active profiles (a tip, f root)."""

    zeta_a1: float
    zeta_a2: float
    zeta_f1: float
    zeta_f2: float


class SlidingFactors(NamedTuple):
    """Sliding velocity over pitch line velocity [-] at the tip of gear 1 (E) and of gear 2 (A)."""

    K_ga1: float
    K_ga2: float


def specific_sliding_at(pair: GearPair, T1Y: float) -> tuple[float, float]:
    """Specific sliding of gear 1 and gear 2 at a point of the path of contact.

    Parameters
    ----------
    pair
        The pair.
    T1Y
        Path coordinate [m].

    Returns
    -------
    zeta_1, zeta_2 : float
        (v_1 − v_2)/v_1 and (v_2 − v_1)/v_2 with the rolling velocities v of the two flanks [-]; −inf at zero
        rolling velocity (at the base circle).

    Notes
    -----
    ζ₁ = 1 − ρ₂/(u ρ₁), ζ₂ = 1 − u ρ₁/ρ₂ with ρ₁ = T1Y, ρ₂ = T1T2 − T1Y, all signed  (ISO 21771).

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> pair = GearPair(CylindricalGear(z=20, m_n=3e-3), CylindricalGear(z=40, m_n=3e-3), 0.09)
    >>> abs(specific_sliding_at(pair, pair.T1C)[0]) < 1e-12
    True
    """
    rolling_1, rolling_2 = T1Y, (pair.T1T2 - T1Y) / pair.u
    zeta_1 = 1.0 - rolling_2 / rolling_1 if rolling_1 > 0.0 else -math.inf
    zeta_2 = 1.0 - rolling_1 / rolling_2 if rolling_2 > 0.0 else -math.inf
    return zeta_1, zeta_2


def specific_sliding(pair: GearPair) -> SpecificSliding:
    """Specific sliding at the tips and roots of the active profiles.

    Parameters
    ----------
    pair
        The pair.

    Returns
    -------
    SpecificSliding
        ζ_a1 (at E), ζ_a2 (at A), ζ_f1 (at A), ζ_f2 (at E).

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> gear = CylindricalGear(z=30, m_n=2e-3)
    >>> s = specific_sliding(GearPair(gear, gear, 0.06))
    >>> round(s.zeta_a1, 4), round(s.zeta_f1, 4)
    (0.6447, -1.8149)
    """
    at_A, at_E = specific_sliding_at(pair, pair.T1A), specific_sliding_at(pair, pair.T1E)
    return SpecificSliding(at_E[0], at_A[1], at_A[0], at_E[1])


def sliding_factor_at(pair: GearPair, T1Y: float) -> float:
    """Sliding velocity over pitch line velocity at a point of the path of contact.

    Parameters
    ----------
    pair
        The pair.
    T1Y
        Path coordinate [m].

    Returns
    -------
    float
        K_g = v_g/v_tw = (T1Y − T1C)(2/d_w1 + 2/d_w2) [-]; positive beyond the pitch point (recess with gear 1
        driving).

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> pair = GearPair(CylindricalGear(z=20, m_n=3e-3), CylindricalGear(z=40, m_n=3e-3), a_w=0.09)
    >>> round(sliding_factor_at(pair, pair.T1C), 12), round(sliding_factor_at(pair, pair.T1E), 4)
    (0.0, 0.3447)
    """
    return (T1Y - pair.T1C) * (2.0 / pair.d_w1 + 2.0 / pair.d_w2)


def sliding_factors(pair: GearPair) -> SlidingFactors:
    """Sliding factors at the two tips.

    Parameters
    ----------
    pair
        The pair.

    Returns
    -------
    SlidingFactors
        K_ga1 at E and K_ga2 at A [-], both positive.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> gear = CylindricalGear(z=30, m_n=2e-3)
    >>> round(sliding_factors(GearPair(gear, gear, 0.06)).K_ga1, 4)
    0.3254
    """
    return SlidingFactors(sliding_factor_at(pair, pair.T1E), -sliding_factor_at(pair, pair.T1A))


def loss_factor_ohlendorf(pair: GearPair) -> float:
    """Tooth loss factor H_V by Ohlendorf's formula.

    Parameters
    ----------
    pair
        Pair with 1 ≤ ε_α ≤ 2.

    Returns
    -------
    float
        H_V [-]; mean power loss = μ_m P H_V.

    Raises
    ------
    GeometryError
        If the pitch point is outside the path of contact, where the formula is not valid.

    Notes
    -----
    H_V = π (u + 1)/(z₁ u cos β_b) (1 − ε_α + ε₁² + ε₂²)  (Ohlendorf 1958, as used by Niemann and Winter),
    with u negative for internal pairs. The load is shared equally by two pairs in contact, the coefficient
    of friction is constant.

    Examples
    --------
    FZG type C gears, published value 0.1986:

    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> pair = GearPair(CylindricalGear(z=16, m_n=4.5e-3, x=0.1817, tip_diameter=0.082636),
    ...                 CylindricalGear(z=24, m_n=4.5e-3, x=0.1715, tip_diameter=0.118544), 0.0915)
    >>> round(loss_factor_ohlendorf(pair), 4)
    0.1986
    """
    _pitch_point_inside(pair)
    eps_1, eps_2 = pair.eps_1, pair.eps_2
    factor = math.pi * (pair.u + 1.0) / (pair.gear1.z * pair.u * math.cos(pair.gear1.beta_b))
    return factor * (1.0 - pair.eps_alpha + eps_1 * eps_1 + eps_2 * eps_2)


def _pitch_point_inside(pair: GearPair) -> None:
    if not pair.T1A <= pair.T1C <= pair.T1E:
        raise GeometryError(
            "lies outside the path of contact, where this formula does not hold",
            where="pitch point",
            value=f"T1C = {pair.T1C:.6g} m",
            limit=f"{pair.T1A:.6g} to {pair.T1E:.6g} m",
            remedy="use loss_factor_integral",
        )


def loss_factor_integral(pair: GearPair) -> float:
    """Tooth loss factor H_V by integration over the path of contact.

    Parameters
    ----------
    pair
        Any pair; the load is shared equally by the tooth pairs in contact in the transverse section.

    Returns
    -------
    float
        H_V [-].

    Notes
    -----
    H_V = 1/(p_et cos β_b cos α_wt) ∫_A^E (F/F_b) |v_g|/v_tw dy with F/F_b = 1/(number of pairs in contact).
    The integrand is piecewise linear with breaks at the pitch point and where that number changes, so that
    the integration is exact. For 1 ≤ ε_α ≤ 2 and the pitch point in the range of single contact the result
    is that of `loss_factor_ohlendorf`.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> gear = CylindricalGear(z=30, m_n=2e-3)
    >>> pair = GearPair(gear, gear, 0.06)
    >>> abs(loss_factor_integral(pair) - loss_factor_ohlendorf(pair)) < 1e-12
    True
    """
    start, end, p_et = pair.T1A, pair.T1E, pair.p_et
    length = end - start
    if length <= 0.0:
        return 0.0
    full = math.floor(length / p_et)
    kinks = {start, end, min(max(pair.T1C, start), end)}
    for i in range(1, full + 1):
        kinks.update((start + i * p_et, end - i * p_et))
    points = sorted(kinks)
    total = 0.0
    for left, right in zip(points, points[1:], strict=False):
        middle = 0.5 * (left + right)
        sharing = 1 + math.floor((middle - start) / p_et) + math.floor((end - middle) / p_et)
        total += (right - left) * abs(sliding_factor_at(pair, middle)) / sharing
    return total / (p_et * math.cos(pair.gear1.beta_b) * math.cos(pair.alpha_wt))
