# SPDX-License-Identifier: Apache-2.0
"""Inspection dimensions: span measurement, dimensions over balls and pins (ISO 21771, DIN 3960).

Diameters are signed like those of the gear (negative for internal gears); the dimensions are positive.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from pitchpoint.core.errors import GeometryError
from pitchpoint.core.plain_numbers import whole_number
from pitchpoint.geometry.bisection import bisect
from pitchpoint.geometry.involute import inverse_inv
from pitchpoint.geometry.tooth_thickness import pressure_angle_at

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear


def span_tooth_count(gear: CylindricalGear) -> int:
    """Number of teeth (internal: spaces) to span for contact of the anvils near d + 2 x m_n.

    Parameters
    ----------
    gear
        The gear.

    Returns
    -------
    int
        k, at least 1.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> span_tooth_count(CylindricalGear(z=24, m_n=0.014, beta=math.radians(10), x=0.48))
    4
    """
    d_y = gear.d + 2.0 * gear.x * gear.m_n
    if abs(d_y) < abs(gear.d_b) or d_y * gear.sign <= 0.0:
        d_y = gear.d
    wanted = math.sqrt(d_y * d_y - gear.d_b * gear.d_b) / math.cos(gear.beta_b)
    return max(1, round((wanted - _base_first(gear)) / gear.p_bn + 1.0))


def _base_first(gear: CylindricalGear) -> float:
    """Normal base thickness of one tooth (internal: base width of one space), the span for k = 1 [m]."""
    tooth = gear.d_b * gear.psi_b * math.cos(gear.beta_b)
    return gear.p_bn - tooth if gear.is_internal else tooth


def span(gear: CylindricalGear, k: int) -> float:
    """Base tangent length over k teeth (internal: over k spaces).

    Parameters
    ----------
    gear
        The gear; its thickness allowance is included.
    k
        Number of teeth or spaces spanned, ≥ 1.

    Returns
    -------
    float
        W_k [m].

    Raises
    ------
    GeometryError
        If k is not a whole number of at least 1.

    Notes
    -----
    W_k = (k − 1) p_bn + s_bn, the same as m_n cos α_n ((k − 0.5) π + z inv α_t) + 2 x m_n sin α_n for an
    external gear (ISO 21771). For an internal gear the base space width replaces s_bn: |z| and −x in the
    formula. Measurable on a helical gear only if b > W_k sin |β_b|.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> pinion = CylindricalGear(z=24, m_n=0.014, beta=math.radians(10), x=0.48)
    >>> round(span(pinion, 4) * 1e3, 3)
    154.167
    """
    if (whole_number(k) or 0) < 1:
        limit = "a whole number, at least 1"
        raise GeometryError("teeth cannot be spanned", where="k", value=f"{k!r}", limit=limit)
    return (k - 1) * gear.p_bn + _base_first(gear)


def span_contact_diameter(gear: CylindricalGear, k: int) -> float:
    """Contact diameter of the anvils in a span measurement.

    Parameters
    ----------
    gear
        The gear.
    k
        Number of teeth or spaces spanned.

    Returns
    -------
    float
        √(d_b² + (W_k cos β_b)²) [m], signed like the gear's diameters.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> pinion = CylindricalGear(z=24, m_n=0.014, beta=math.radians(10), x=0.48)
    >>> round(span_contact_diameter(pinion, 4) * 1e3, 3)
    354.332
    """
    return gear.sign * math.hypot(gear.d_b, span(gear, k) * math.cos(gear.beta_b))


def ball_center_angle(gear: CylindricalGear, D_M: float) -> float:
    """Transverse pressure angle at the centre of a ball in contact with both flanks of a space.

    Parameters
    ----------
    gear
        The gear; its thickness allowance is included.
    D_M
        Diameter of the ball or pin [m], > 0.

    Returns
    -------
    float
        α_Kt [rad].

    Raises
    ------
    GeometryError
        If the ball would not touch the usable flanks: a ball too small touches the fillets, one too large
        the tips.

    Notes
    -----
    inv α_Kt = s_t/d + inv α_t − π/z + D_M/(d_b cos β_b)  (ISO 21771, signed d_b and z).

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> pinion = CylindricalGear(z=24, m_n=0.014, beta=math.radians(10), x=0.48)
    >>> round(math.degrees(ball_center_angle(pinion, 0.028)), 4)
    29.9326
    """
    if not 0.0 < D_M < math.inf:
        raise GeometryError("is not a ball diameter", where="D_M", value=f"{D_M!r} m", limit="above 0")
    value = gear.psi_b - math.pi / gear.z + D_M / (gear.d_b * math.cos(gear.beta_b))
    # There is no flank inside the base circle: the root of an external gear, the tips of an internal one.
    at_root, at_tip = not gear.is_internal, gear.is_internal
    alpha, contact = 0.0, 0.0
    if value >= 0.0:
        alpha = inverse_inv(value)
        reach = math.tan(alpha) - D_M * math.cos(gear.beta_b) / gear.d_b
        if reach >= 0.0:
            contact = gear.d_b * math.hypot(1.0, reach)
            # signed diameters increase from root to tip, for internal gears too
            slack = 1e-9 * abs(gear.d)
            at_root, at_tip = contact < gear.d_Ff - slack, contact > gear.d_Fa + slack
    if at_root or at_tip:
        low, high = sorted((abs(gear.d_Ff), abs(gear.d_Fa)))
        raise GeometryError(
            "does not touch the usable flanks",
            where="D_M",
            value=f"{1e3 * D_M:.6g} mm",
            limit=f"contact between diameters of {1e3 * low:.6g} and {1e3 * high:.6g} mm",
            remedy=f"use a {'larger' if at_root else 'smaller'} ball",
        )
    return alpha


def radial_dimension_over_ball(gear: CylindricalGear, D_M: float) -> float:
    """Radial single-ball dimension.

    Parameters
    ----------
    gear, D_M
        As in `ball_center_angle`.

    Returns
    -------
    float
        M_rK [m]; for an internal gear from the axis to the inner side of the ball.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> pinion = CylindricalGear(z=24, m_n=0.014, beta=math.radians(10), x=0.48)
    >>> round(radial_dimension_over_ball(pinion, 0.028) * 1e3, 3)
    198.642
    """
    return 0.5 * abs(gear.d_b / math.cos(ball_center_angle(gear, D_M)) + D_M)


def dimension_over_balls(gear: CylindricalGear, D_M: float) -> float:
    """Diametral dimension over (internal: between) two balls.

    Parameters
    ----------
    gear, D_M
        As in `ball_center_angle`.

    Returns
    -------
    float
        M_dK [m].

    Notes
    -----
    M_dK = d_K + D_M for even z, d_K cos(π/(2z)) + D_M for odd z, with d_K = d_b / cos α_Kt (ISO 21771).

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> pinion = CylindricalGear(z=24, m_n=0.014, beta=math.radians(10), x=0.48)
    >>> round(dimension_over_balls(pinion, 0.028) * 1e3, 3)
    397.284
    """
    d_K = gear.d_b / math.cos(ball_center_angle(gear, D_M))
    if gear.z % 2:
        d_K *= math.cos(0.5 * math.pi / gear.z)
    return abs(d_K + D_M)


def dimension_over_pins(gear: CylindricalGear, D_M: float) -> float:
    """Diametral dimension over (internal: between) two pins.

    Pins in opposite spaces of a helical gear slide along the helix until they face each other, so that an odd
    number of teeth needs no correction; on a spur gear the dimension is that over balls (DIN 3960).

    Parameters
    ----------
    gear, D_M
        As in `ball_center_angle`.

    Returns
    -------
    float
        M_dR [m].

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> pinion = CylindricalGear(z=24, m_n=0.014, beta=math.radians(10), x=0.48)
    >>> round(dimension_over_pins(pinion, 0.028) * 1e3, 3)
    397.284
    """
    if gear.beta == 0.0:
        return dimension_over_balls(gear, D_M)
    return 2.0 * radial_dimension_over_ball(gear, D_M)


def ball_contact_diameter(gear: CylindricalGear, D_M: float) -> float:
    """Contact diameter of a ball on the flanks.

    Parameters
    ----------
    gear, D_M
        As in `ball_center_angle`.

    Returns
    -------
    float
        d_M [m], signed like the gear's: tan α_Mt = tan α_Kt − D_M cos β_b / d_b.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> pinion = CylindricalGear(z=24, m_n=0.014, beta=math.radians(10), x=0.48)
    >>> round(ball_contact_diameter(pinion, 0.028) * 1e3, 3)
    356.305
    """
    reach = math.tan(ball_center_angle(gear, D_M)) - D_M * math.cos(gear.beta_b) / gear.d_b
    return math.copysign(math.hypot(gear.d_b, gear.d_b * reach), gear.d_b)


def ideal_ball_diameter(gear: CylindricalGear) -> float:
    """Diameter of the ball that touches the flanks at d + 2 x m_n.

    Parameters
    ----------
    gear
        The gear.

    Returns
    -------
    float
        D_M [m]; in practice the nearest standard ball is used.

    Raises
    ------
    GeometryError
        If d + 2 x m_n lies inside the base circle.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> sun = CylindricalGear(z=19, m_n=0.045, x=0.617)
    >>> round(ideal_ball_diameter(sun) * 1e3, 2)    # the KISSsoft report prints 94.950 mm
    94.95
    """
    tan_v = math.tan(pressure_angle_at(gear, gear.d + 2.0 * gear.x * gear.m_n))
    cos2 = math.cos(gear.beta_b) * math.cos(gear.beta_b)
    offset = gear.psi_b - math.pi / gear.z

    # Contact geometry gives tan α_K − tan α_v = D cos β_b / d_b, the involute gives inv α_K. Elimination of D
    # leaves one equation in tan α_K with a monotonically decreasing residual.
    def residual(t: float) -> float:
        """Residual of the equation in t = tan α_K [rad]."""
        return t - math.atan(t) - offset - (t - tan_v) / cos2

    low, high = (0.0, tan_v) if gear.is_internal else (tan_v, tan_v + 10.0)
    return gear.d_b * (bisect(residual, low, high) - tan_v) / math.cos(gear.beta_b)
