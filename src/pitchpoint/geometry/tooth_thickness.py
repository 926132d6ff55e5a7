# SPDX-License-Identifier: Apache-2.0
"""Tooth thickness on a circle, at the tip and as a chord (ISO 21771, DIN 3960).

Diameters are signed like those of the gear (negative for internal gears); thicknesses are positive.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.involute import inv

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear


def pressure_angle_at(gear: CylindricalGear, d_y: float) -> float:
    """Transverse pressure angle on a circle.

    Parameters
    ----------
    gear
        The gear.
    d_y
        Diameter [m], signed like the gear's.

    Returns
    -------
    float
        α_yt [rad], cos α_yt = d_b / d_y.

    Raises
    ------
    GeometryError
        If the circle lies inside the base circle.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=30, m_n=3e-3)
    >>> round(math.degrees(pressure_angle_at(gear, gear.d)), 9)
    20.0
    """
    if d_y * gear.sign <= 0.0 or not abs(d_y) >= abs(gear.d_b):
        raise GeometryError(
            "lies inside the base circle, where no involute exists",
            where="diameter",
            value=f"{d_y:.6g} m",
            limit=f"{gear.d_b:.6g} m",
        )
    return math.acos(gear.d_b / d_y)


def helix_angle_at(gear: CylindricalGear, d_y: float) -> float:
    """Helix angle on a cylinder.

    Parameters
    ----------
    gear, d_y
        As in `pressure_angle_at`.

    Returns
    -------
    float
        β_y [rad], tan β_y = tan β d_y / d.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> pinion = CylindricalGear(z=24, m_n=0.014, beta=math.radians(10), x=0.48)
    >>> round(math.degrees(helix_angle_at(pinion, pinion.d)), 9)
    10.0
    """
    return math.atan(math.tan(gear.beta) * d_y / gear.d)


def transverse_tooth_thickness(gear: CylindricalGear, d_y: float) -> float:
    """Transverse tooth thickness (arc) on a circle.

    Parameters
    ----------
    gear, d_y
        As in `pressure_angle_at`.

    Returns
    -------
    float
        s_yt = d_y (s_t/d + inv α_t − inv α_yt) [m]; zero or negative if the tooth is pointed below d_y.

    Raises
    ------
    GeometryError
        If the circle lies inside the base circle.

    Notes
    -----
    ISO 21771, tooth thickness at the y-cylinder; valid for internal gears with signed diameters.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=20, m_n=0.003)
    >>> round(transverse_tooth_thickness(gear, gear.d) / gear.m_n, 6)
    1.570796
    """
    return d_y * (gear.psi_b - inv(pressure_angle_at(gear, d_y)))


def normal_tooth_thickness(gear: CylindricalGear, d_y: float) -> float:
    """Normal tooth thickness on a cylinder.

    Parameters
    ----------
    gear, d_y
        As in `pressure_angle_at`.

    Returns
    -------
    float
        s_yn = s_yt cos β_y [m].

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=30, m_n=3e-3)
    >>> round(normal_tooth_thickness(gear, gear.d) * 1e3, 6)
    4.712389
    """
    return transverse_tooth_thickness(gear, d_y) * math.cos(helix_angle_at(gear, d_y))


def normal_space_width(gear: CylindricalGear, d_y: float) -> float:
    """Normal space width on a cylinder, between the involutes (without fillets).

    Parameters
    ----------
    gear, d_y
        As in `pressure_angle_at`.

    Returns
    -------
    float
        e_yn [m].

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=30, m_n=3e-3)
    >>> round(normal_space_width(gear, gear.d) * 1e3, 6)
    4.712389
    """
    transverse = math.pi * d_y / gear.z - transverse_tooth_thickness(gear, d_y)
    return transverse * math.cos(helix_angle_at(gear, d_y))


def tip_thickness(gear: CylindricalGear) -> float:
    """Normal tooth thickness at the tip form cylinder.

    Parameters
    ----------
    gear
        The gear.

    Returns
    -------
    float
        s_an [m]; negative if the flanks cross below the tip.

    Examples
    --------
    Stage 3 of the 5 MW gearbox; the KISSsoft report gives 8.800 mm:

    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> pinion = CylindricalGear(z=24, m_n=0.014, beta=math.radians(10), x=0.48, tip_diameter=0.380747)
    >>> round(tip_thickness(pinion) * 1e3, 3)
    8.8
    """
    return normal_tooth_thickness(gear, gear.d_Fa)


def chordal_thickness(gear: CylindricalGear) -> tuple[float, float]:
    """Normal chordal tooth thickness at the reference cylinder, and chordal height.

    Parameters
    ----------
    gear
        The gear.

    Returns
    -------
    s_c, h_c : float
        Chord and chordal height [m].

    Notes
    -----
    With the curvature diameter d / cos² β of the normal section: s_c = d_c sin(s_n/d_c),
    h_c = (d_a − d)/2 + d_c (1 − cos(s_n/d_c))/2  (DIN 3960).

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> pinion = CylindricalGear(z=24, m_n=0.014, beta=math.radians(10), x=0.48)
    >>> round(chordal_thickness(pinion)[0] * 1e3, 3)
    26.857
    """
    d_c = gear.d / (math.cos(gear.beta) * math.cos(gear.beta))
    angle = gear.s_n / d_c
    return d_c * math.sin(angle), 0.5 * (gear.d_a - gear.d) + 0.5 * d_c * (1.0 - math.cos(angle))
