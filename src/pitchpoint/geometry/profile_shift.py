# SPDX-License-Identifier: Apache-2.0
"""Relations between profile shift coefficients and centre distance.

Centre distances are signed as in ISO 21771: negative for a pair with an internal gear.
"""

from __future__ import annotations

import math

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.involute import inv, transverse_pressure_angle, working_pressure_angle


def reference_center_distance(z_sum: int, m_n: float, beta: float = 0.0) -> float:
    """Centre distance at which the reference circles touch.

    Parameters
    ----------
    z_sum
        Sum of the signed numbers of teeth.
    m_n
        Normal module [m].
    beta
        Helix angle [rad].

    Returns
    -------
    float
        a_d = (z₁ + z₂) m_n / (2 cos β) [m].

    Examples
    --------
    >>> round(reference_center_distance(61, 3.5e-3, math.radians(21)) * 1e3, 6)
    114.344728
    """
    return 0.5 * z_sum * m_n / math.cos(beta)


def center_distance_for_profile_shift(
    *, z_sum: int, m_n: float, alpha_n: float, beta: float = 0.0, x_sum: float = 0.0
) -> float:
    """Centre distance of zero backlash for given profile shifts.

    Parameters
    ----------
    z_sum
        Sum of the signed numbers of teeth.
    m_n, alpha_n, beta
        Normal module [m], normal pressure angle and helix angle [rad].
    x_sum
        Sum of the profile shift coefficients [-].

    Returns
    -------
    float
        a_w [m], signed like z_sum.

    Raises
    ------
    GeometryError
        If no such distance exists (profile shift too negative, or z_sum = 0).

    Notes
    -----
    a_w = a_d cos α_t / cos α_wt  (ISO 21771).

    Examples
    --------
    Pair 1 of the camshaft thesis, 497 mm nominal:

    >>> a_w = center_distance_for_profile_shift(z_sum=127, m_n=8e-3, alpha_n=math.radians(20), x_sum=-1.252)
    >>> round(a_w * 1e3, 4)
    497.0071
    """
    alpha_t = transverse_pressure_angle(alpha_n, beta)
    alpha_wt = working_pressure_angle(z_sum=z_sum, alpha_n=alpha_n, beta=beta, x_sum=x_sum)
    return reference_center_distance(z_sum, m_n, beta) * math.cos(alpha_t) / math.cos(alpha_wt)


def pressure_angle_at_center_distance(
    *, z_sum: int, m_n: float, alpha_n: float, beta: float = 0.0, a_w: float
) -> float:
    """Working transverse pressure angle at an imposed centre distance, cos α_wt = a_d cos α_t / a_w.

    Parameters
    ----------
    z_sum, m_n, alpha_n, beta
        As in `center_distance_for_profile_shift`.
    a_w
        Working centre distance [m], signed like z_sum.

    Returns
    -------
    float
        α_wt [rad].

    Raises
    ------
    GeometryError
        If the base circles have no common tangent, so that no line of action exists.

    Examples
    --------
    >>> alpha_wt = pressure_angle_at_center_distance(z_sum=120, m_n=8e-3, alpha_n=math.radians(20),
    ...     beta=math.radians(15.8), a_w=0.5)
    >>> round(math.degrees(alpha_wt), 6)
    21.0661
    """
    base = reference_center_distance(z_sum, m_n, beta) * math.cos(transverse_pressure_angle(alpha_n, beta))
    if base == 0.0 or not base / a_w < 1.0 or base / a_w <= 0.0:
        raise GeometryError(
            "leaves no common tangent of the base circles",
            where="center_distance",
            value=f"{abs(a_w):.6g} m",
            limit=f"above {abs(base):.6g} m",
            remedy="increase the centre distance",
        )
    return math.acos(base / a_w)


def profile_shift_for_center_distance(
    *, z_sum: int, m_n: float, alpha_n: float, beta: float = 0.0, a_w: float
) -> float:
    """Sum of the profile shift coefficients for zero backlash at a centre distance.

    Parameters
    ----------
    z_sum, m_n, alpha_n, beta, a_w
        As in `pressure_angle_at_center_distance`.

    Returns
    -------
    float
        x₁ + x₂ [-] (ISO 21771 sign for internal gears).

    Raises
    ------
    GeometryError
        If the base circles have no common tangent at that distance.

    Notes
    -----
    Σx = (z₁ + z₂)(inv α_wt − inv α_t)/(2 tan α_n)  (ISO 21771).

    Examples
    --------
    >>> x_sum = profile_shift_for_center_distance(z_sum=61, m_n=3.5e-3, alpha_n=math.radians(20),
    ...     beta=math.radians(21), a_w=0.1165)
    >>> round(x_sum, 7)
    0.6518771
    """
    alpha_wt = pressure_angle_at_center_distance(z_sum=z_sum, m_n=m_n, alpha_n=alpha_n, beta=beta, a_w=a_w)
    alpha_t = transverse_pressure_angle(alpha_n, beta)
    return 0.5 * z_sum * (inv(alpha_wt) - inv(alpha_t)) / math.tan(alpha_n)


def missing_profile_shift(
    *, z_sum: int, m_n: float, alpha_n: float, beta: float = 0.0, a_w: float, x_known: float
) -> float:
    """Profile shift coefficient of one gear for zero backlash at a centre distance, that of the other known.

    Parameters
    ----------
    z_sum, m_n, alpha_n, beta, a_w
        As in `profile_shift_for_center_distance`.
    x_known
        Known profile shift coefficient of the other gear [-].

    Returns
    -------
    float
        The missing coefficient [-].

    Examples
    --------
    >>> x = missing_profile_shift(z_sum=120, m_n=8e-3, alpha_n=math.radians(20), beta=math.radians(15.8),
    ...     a_w=0.5, x_known=0.0)
    >>> round(x, 5)
    0.14522
    """
    x_sum = profile_shift_for_center_distance(z_sum=z_sum, m_n=m_n, alpha_n=alpha_n, beta=beta, a_w=a_w)
    return x_sum - x_known
