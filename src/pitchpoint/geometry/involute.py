# SPDX-License-Identifier: Apache-2.0
"""Involute function, its inverse, and conversion of angles between normal and transverse section.

All modules take α_t and β_b from here.

Source: ISO 21771; inverse by Newton's method.
"""

from __future__ import annotations

import math

from pitchpoint.core.errors import GeometryError

_SERIES_LIMIT = 0.02


def inv(alpha: float) -> float:
    """Involute function inv α = tan α − α.

    Parameters
    ----------
    alpha
        Pressure angle [rad], |α| < π/2.

    Returns
    -------
    float
        inv α [rad]. Small angles use the series α³/3 + 2α⁵/15 + 17α⁷/315, which avoids cancellation.

    Raises
    ------
    GeometryError
        If the angle is not a finite number below π/2 in magnitude.

    Notes
    -----
    ISO 21771, definition of the involute angle.

    Examples
    --------
    >>> round(inv(math.radians(20.0)), 9)
    0.014904384
    """
    if not abs(alpha) < 0.5 * math.pi:
        raise GeometryError(
            "is not a pressure angle of an involute",
            where="alpha",
            value=f"{alpha!r} rad",
            limit="below pi/2",
        )
    if abs(alpha) < _SERIES_LIMIT:
        square = alpha * alpha
        return alpha * square * (1.0 / 3.0 + square * (2.0 / 15.0 + square * 17.0 / 315.0))
    return math.tan(alpha) - alpha


def inverse_inv(value: float) -> float:
    """Pressure angle whose involute function has the given value.

    Parameters
    ----------
    value
        inv α [rad], ≥ 0.

    Returns
    -------
    float
        α [rad] in [0, π/2), to about 1e-15.

    Raises
    ------
    GeometryError
        If the value is negative or not finite.

    Notes
    -----
    Newton's method on t − atan t = value with t = tan α. The function is convex for t > 0: after one step
    the iterates decrease monotonically to the root and stay in the domain.

    Examples
    --------
    >>> round(math.degrees(inverse_inv(0.014904383867)), 7)
    20.0
    """
    if not 0.0 <= value < math.inf:
        raise GeometryError(
            "no pressure angle has this involute function",
            where="inv alpha",
            value=f"{value!r}",
            limit=">= 0",
            remedy="increase the sum of the profile shift coefficients or the centre distance",
        )
    if value == 0.0:
        return 0.0
    cube_root = (3.0 * value) ** (1.0 / 3.0)
    t = cube_root * (1.0 + 0.2 * cube_root * cube_root) if value < 0.5 else value + 0.5 * math.pi
    for _ in range(60):
        alpha = math.atan(t)
        step = (
            (inv(alpha) - value) * (1.0 + t * t) / (t * t)
            if alpha < _SERIES_LIMIT
            else ((t - alpha - value) * (1.0 + t * t) / (t * t))
        )
        t -= step
        if abs(step) <= 4e-16 * t:
            break
    return math.atan(t)


def transverse_pressure_angle(alpha_n: float, beta: float) -> float:
    """Transverse pressure angle at the reference cylinder, tan α_t = tan α_n / cos β.

    Parameters
    ----------
    alpha_n
        Normal pressure angle [rad], 0 < α_n < π/2.
    beta
        Helix angle at the reference cylinder [rad], |β| < π/2.

    Returns
    -------
    float
        α_t [rad].

    Notes
    -----
    ISO 21771. Even in β: independent of the hand.

    Examples
    --------
    >>> round(math.degrees(transverse_pressure_angle(math.radians(20.0), math.radians(15.8))), 6)
    20.719712
    """
    return math.atan2(math.tan(alpha_n), math.cos(beta))


def base_helix_angle(alpha_n: float, beta: float) -> float:
    """Helix angle at the base cylinder, sin β_b = sin β cos α_n.

    Parameters
    ----------
    alpha_n
        Normal pressure angle [rad].
    beta
        Helix angle at the reference cylinder [rad]; the sign (hand) is kept.

    Returns
    -------
    float
        β_b [rad].

    Notes
    -----
    ISO 21771; the same as tan β_b = tan β cos α_t (not cos α_n).

    Examples
    --------
    >>> round(math.degrees(base_helix_angle(math.radians(20.0), math.radians(15.8))), 6)
    14.824535
    """
    return math.asin(math.sin(beta) * math.cos(alpha_n))


def working_pressure_angle(*, z_sum: int, alpha_n: float, beta: float = 0.0, x_sum: float = 0.0) -> float:
    """Working transverse pressure angle of a pair with given profile shifts at zero backlash.

    Parameters
    ----------
    z_sum
        Sum of the signed numbers of teeth z₁ + z₂ (internal gear negative), not zero.
    alpha_n, beta
        Normal pressure angle and helix angle at the reference cylinder [rad].
    x_sum
        Sum of the profile shift coefficients x₁ + x₂ [-] (ISO 21771 sign for internal gears).

    Returns
    -------
    float
        α_wt [rad].

    Raises
    ------
    GeometryError
        If z₁ + z₂ = 0, or if there is no real solution.

    Notes
    -----
    inv α_wt = inv α_t + 2 (x₁ + x₂) tan α_n / (z₁ + z₂)  (ISO 21771).

    Examples
    --------
    >>> alpha = working_pressure_angle(z_sum=50, alpha_n=math.radians(20.0), x_sum=0.5)
    >>> round(alpha, 9)
    0.396557781
    """
    if z_sum == 0:
        raise GeometryError(
            "the internal gear has as many teeth as its pinion, so there is no pitch point",
            where="number_of_teeth",
            value="z1 + z2 = 0",
            remedy="give the internal gear more teeth",
        )
    alpha_t = transverse_pressure_angle(alpha_n, beta)
    return inverse_inv(inv(alpha_t) + 2.0 * x_sum * math.tan(alpha_n) / z_sum)
