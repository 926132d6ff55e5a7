# SPDX-License-Identifier: Apache-2.0
"""Hertzian line contact of two flanks: half width, pressure and approach.

All values per unit length of the contact line, in SI units. Arrays broadcast.

Source: Johnson, Contact Mechanics (1985), 4.2; approach Weber and Banaschek (1953).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatArray = NDArray[np.float64]


def plane_strain_compliance(youngs_modulus: float, poisson_ratio: float) -> float:
    """Plane-strain compliance of a body, (1 - nu^2)/E [1/Pa].

    Parameters
    ----------
    youngs_modulus
        Young's modulus E [Pa].
    poisson_ratio
        Poisson's ratio ν [-].

    Examples
    --------
    >>> round(plane_strain_compliance(206.0e9, 0.3) * 1e12, 9)
    4.417475728
    """
    return (1.0 - poisson_ratio * poisson_ratio) / youngs_modulus


def line_stiffness(compliance_1: float, compliance_2: float) -> float:
    """Load-independent stiffness of a Hertzian line contact per unit length [N/m^2].

    Parameters
    ----------
    compliance_1, compliance_2
        (1 - nu^2)/E of both bodies [1/Pa].

    Notes
    -----
    pi/(2 (compliance_1 + compliance_2)); for equal bodies pi E/(4 (1 - nu^2)). D. C. H. Yang and Z. S. Sun,
    "A rotary model for spur gear dynamics", J. Mech. Transm. Autom. Des. 107 (1985). An approximation: the
    true approach of a line contact increases slightly less than linearly with the load, see `line_approach`.

    Examples
    --------
    >>> steel = plane_strain_compliance(206.0e9, 0.3)
    >>> round(line_stiffness(steel, steel) * 0.02 / 1e9, 7)
    3.5558686
    """
    return math.pi / (2.0 * (compliance_1 + compliance_2))


def half_width(load: ArrayLike, radius: ArrayLike, compliance_1: float, compliance_2: float) -> FloatArray:
    """Contact half width, b_H = sqrt(4 q R (compliance_1 + compliance_2)/pi) [m], shape of q R.

    Parameters
    ----------
    load
        Normal force per unit length of the contact line, q [N/m].
    radius
        Reduced radius of curvature, 1/R = 1/rho_1 + 1/rho_2 [m].
    compliance_1, compliance_2
        (1 - nu^2)/E of both bodies [1/Pa].

    Notes
    -----
    K. L. Johnson, *Contact Mechanics*, ch. 4.2.

    Examples
    --------
    >>> steel = plane_strain_compliance(206.0e9, 0.3)
    >>> rho_1, rho_2 = 13.97239e-3, 20.95858e-3                # FZG gears type C at the pitch point
    >>> R = rho_1 * rho_2 / (rho_1 + rho_2)
    >>> round(float(half_width(6370.7 / 0.04, R, steel, steel)) * 1e6, 2)
    122.56
    """
    q = np.asarray(load, dtype=np.float64)
    return np.sqrt(4.0 * q * np.asarray(radius) * (compliance_1 + compliance_2) / math.pi)


def flank_radius(T1Y: ArrayLike, T1T2: ArrayLike, beta_b: float) -> FloatArray:
    """Reduced radius of curvature of two involute flanks, normal to their contact line [m], shape of T1Y
    T1T2.

    Parameters
    ----------
    T1Y
        Position on the path of contact, from the tangent point T1 on the base circle of gear 1 [m].
    T1T2
        Signed length of the common base tangent [m]; negative for an internal gear. For bevel gears the sum
        of both geodesic radii.
    beta_b
        Base helix angle [rad].

    Notes
    -----
    In the transverse section the radii are T1Y and T1T2 - T1Y. Contact lines are inclined by β_b to the
    axes, so the normal radii are larger by 1/cos β_b.

    Examples
    --------
    >>> round(float(flank_radius(0.01, 0.04, 0.0)), 12)
    0.0075
    """
    rho = np.asarray(T1Y, dtype=np.float64)
    whole = np.asarray(T1T2, dtype=np.float64)
    return np.asarray(rho * (whole - rho) / (whole * math.cos(beta_b)))


def peak_pressure(load: ArrayLike, width: ArrayLike) -> FloatArray:
    """Maximum Hertzian pressure, p_0 = 2 q/(pi b_H) [Pa], shape of q b_H.

    Parameters
    ----------
    load
        Load per unit length q [N/m].
    width
        Half width of the contact b_H [m].

    Examples
    --------
    >>> round(float(peak_pressure(6370.7 / 0.04, 122.559e-6)) / 1e6, 1)
    827.3
    """
    return 2.0 * np.asarray(load, dtype=np.float64) / (math.pi * np.asarray(width))


def line_approach(
    load: ArrayLike, depth: ArrayLike, width: ArrayLike, compliance: float, nu: float
) -> FloatArray:
    """Approach of a point at depth h to the contact point in one body [m], shape of q h b_H.

    Parameters
    ----------
    load
        Normal force per unit length, q [N/m].
    depth
        Distance of the point from the contact along the normal, h [m]; for a tooth, to its centre line.
    width
        Half width of the contact, b_H [m].
    compliance
        (1 - nu^2)/E of the body [1/Pa].
    nu
        Poisson's ratio of the body.

    Notes
    -----
    2 q (1 - nu^2)/(pi E) [ln(2 h/b_H) - nu/(2 (1 - nu))], valid for h >> b_H. C. Weber and K. Banaschek,
    *Formaenderung und Profilruecknahme bei gerad- und schraegverzahnten Raedern*, 1953.

    Examples
    --------
    >>> steel = plane_strain_compliance(206.0e9, 0.3)
    >>> round(float(line_approach(1.6e5, 3.0e-3, 122.6e-6, steel, 0.3)) * 1e6, 4)
    1.6542
    """
    q = np.asarray(load, dtype=np.float64)
    log = np.log(2.0 * np.asarray(depth) / np.asarray(width))
    return 2.0 * q * compliance / math.pi * (log - nu / (2.0 * (1.0 - nu)))
