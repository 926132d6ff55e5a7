# SPDX-License-Identifier: Apache-2.0
"""Load-deflection law of balls and rollers between two raceways, Q = K delta^n.

n is 3/2 for balls and 10/9 for rollers; delta is the approach of the raceways.

Source: Harris, Rolling Bearing Analysis, 4th ed. (2001), ch. 6; rollers Palmgren (1959); ISO/TS 16281:2008.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.bisection import bisect

POINT = 1.5
"""Exponent of a point contact."""
LINE = 10.0 / 9.0
"""Exponent of a line contact (Palmgren)."""


def curvature(
    ball_diameter: float, pitch_diameter: float, groove: float, angle: float
) -> tuple[float, float]:
    """Curvature sum [1/m] and difference [-] of a ball in a groove.

    Parameters
    ----------
    ball_diameter
        Ball diameter D [m].
    pitch_diameter
        Pitch diameter d_m [m]; positive for the inner raceway, negative for the outer one.
    groove
        Groove radius over ball diameter, f > 0.5.
    angle
        Contact angle [rad].

    Notes
    -----
    With g = D cos(angle)/d_m: sum = (4 - 1/f + 2 g/(1 - g))/D, difference = (1/f + 2 g/(1 - g))/(D sum). T.
    A. Harris, *Rolling Bearing Analysis*, 4th ed., ch. 2; his example, bearing 209, gives 0.202/mm and
    0.9399 for the inner, 0.138/mm and 0.9120 for the outer raceway.

    Examples
    --------
    >>> inner, outer = (curvature(12.7e-3, d, 0.52, 0.0) for d in (65e-3, -65e-3))
    >>> [round(x, 4) for x in (inner[0] * 1e-3, inner[1], outer[0] * 1e-3, outer[1])]
    [0.2018, 0.94, 0.1378, 0.9121]
    """
    g = ball_diameter * math.cos(angle) / pitch_diameter
    ring = 2.0 * g / (1.0 - g)
    total = 4.0 - 1.0 / groove + ring
    return total / ball_diameter, (1.0 / groove + ring) / total


def ellipse(difference: float) -> tuple[float, float, float]:
    """Dimensionless semi-axes and approach a*, b*, delta* of a Hertzian point contact.

    Parameters
    ----------
    difference
        Curvature difference F(rho), |F| from 0 (circle) to below 1 (line). F is negative if the major axis
        is in the rolling direction, as on a raceway without groove; only |F| matters here.

    Raises
    ------
    ValueError
        If |F| is 1 or more.

    Notes
    -----
    The ratio k = a/b solves F = ((k^2 + 1) E - 2 K)/((k^2 - 1) E) with the complete elliptic integrals K and
    E of modulus sqrt(1 - 1/k^2); a* = (2 k^2 E/pi)^(1/3), b* = (2 E/(pi k))^(1/3), delta* = (2 K/pi)
    (pi/(2 k^2 E))^(1/3). Harris, ch. 6; his table gives 3.233, 0.4499, 0.6636 at 0.90999.

    Examples
    --------
    >>> a, b, approach = ellipse(0.90999)
    >>> round(a, 3), round(b, 4), round(approach, 4)
    (3.233, 0.4499, 0.6636)
    >>> ellipse(0.0)
    (1.0, 1.0, 1.0)
    """
    size = abs(difference)
    if not size < 1.0:
        raise ValueError(f"the curvature difference must be between -1 and 1, not {difference!r}")
    if size < 1e-9:
        return 1.0, 1.0, 1.0
    from scipy.optimize import brentq
    from scipy.special import ellipe, ellipkm1

    def integrals(log_k: float) -> tuple[float, float]:
        """Complete elliptic integrals K and E for the axis ratio e^log_k, accurate near the circle."""
        return float(ellipkm1(math.exp(-2.0 * log_k))), float(ellipe(-math.expm1(-2.0 * log_k)))

    def mismatch(log_k: float) -> float:
        """Curvature difference for the axis ratio e^log_k minus the given one [-]."""
        first, second = integrals(log_k)
        squared = math.exp(2.0 * log_k)
        return ((squared + 1.0) * second - 2.0 * first) / ((squared - 1.0) * second) - size

    near_circle = size < 1e-4  # F = 3/4 ln k + O(ln^3 k), where the difference of the integrals cancels
    log_k = size / 0.75 if near_circle else float(brentq(mismatch, 1e-4, 30.0, xtol=1e-13))
    first, second = integrals(log_k)
    k = math.exp(log_k)
    a = (2.0 * k * k * second / math.pi) ** (1.0 / 3.0)
    return a, a / k, 2.0 * first / (math.pi * a)


def point_stiffness(curvature_sum: float, difference: float, compliance: float) -> float:
    """Constant K of one point contact, Q = K delta^(3/2) [N/m^1.5].

    Parameters
    ----------
    curvature_sum, difference
        Curvature sum [1/m] and difference [-] of the two bodies.
    compliance
        Sum of (1 - nu^2)/E of both bodies [1/Pa].

    Notes
    -----
    K = (4 sqrt(2)/3)/(compliance sqrt(sum) delta*^(3/2)), H. Hertz 1881. For steel Harris rounds this to
    2.15e5 sum^(-1/2) delta*^(-3/2) in N and mm.

    Examples
    --------
    A ball of 10 mm on a plane, (4/3) E* sqrt(R):

    >>> steel = 2.0 * 0.91 / 207e9
    >>> round(point_stiffness(4.0 / 0.01, 0.0, steel) * steel * 0.75 / math.sqrt(0.005), 12)
    1.0
    >>> round(point_stiffness(1e3, 0.0, steel) * 1e-3**1.5)  # N/mm^1.5 at a sum of 1/mm
    214463
    """
    return (
        4.0 * math.sqrt(2.0) / (3.0 * compliance * math.sqrt(curvature_sum) * ellipse(difference)[2] ** 1.5)
    )


def roller_stiffness(length: float, compliance: float) -> float:
    """Constant K of one roller on one raceway, Q = K delta^(10/9) [N/m^(10/9)].

    Parameters
    ----------
    length
        Effective length of the roller [m].
    compliance
        Sum of (1 - nu^2)/E of both bodies [1/Pa].

    Notes
    -----
    A. Palmgren, *Ball and Roller Bearing Engineering*, 1959: delta = 3.81 (Q compliance/pi)^0.9/length^0.8,
    in N and mm 3.84e-5 Q^0.9/length^0.8 for steel. The equation is dimensionally consistent.

    Examples
    --------
    >>> approach = 1e3 * (1000.0 / roller_stiffness(10e-3, 2.0 * 0.91 / 206e9)) ** 0.9
    >>> round(approach / (1000.0**0.9 / 10.0**0.8) * 1e5, 2)
    3.85
    """
    return float(length ** (8.0 / 9.0) * math.pi / (3.81**LINE * compliance))


def in_series(inner: float, outer: float, exponent: float) -> float:
    """Constant K of a rolling element between two raceways: both contacts in series.

    Parameters
    ----------
    inner, outer
        Constants of the contacts with the inner and the outer raceway [N/m^n].
    exponent
        Exponent n.

    Examples
    --------
    >>> round(in_series(8.0, 8.0, 1.5), 9)  # 8/2^1.5
    2.828427125
    """
    return float((inner ** (-1.0 / exponent) + outer ** (-1.0 / exponent)) ** -exponent)


def ball_bearing_stiffness(
    ball_diameter: float,
    pitch_diameter: float,
    grooves: tuple[float, float],
    angle: float,
    compliance: float,
) -> float:
    """Constant K of one ball between both raceways, Q = K delta^(3/2) [N/m^1.5].

    Parameters
    ----------
    ball_diameter, pitch_diameter
        Ball diameter D and pitch diameter d_m [m].
    grooves
        Groove radii of the inner and outer raceway over D.
    angle
        Contact angle [rad].
    compliance
        Sum of (1 - nu^2)/E of ball and ring [1/Pa].

    Examples
    --------
    Bearing 209 (Harris), steel:

    >>> K = ball_bearing_stiffness(12.7e-3, 65e-3, (0.52, 0.52), 0.0, 2.0 * 0.91 / 207e9)
    >>> round(K * 1e-9, 2)
    11.71
    """
    inner, outer = (
        point_stiffness(*curvature(ball_diameter, sign * pitch_diameter, groove, angle), compliance)
        for sign, groove in zip((1.0, -1.0), grooves, strict=True)
    )
    return in_series(inner, outer, POINT)


def flange_stiffness(elements: int, diameter: float, rating: float, compliance: float) -> float:
    """Estimated axial stiffness of the flanges of a cylindrical roller bearing [N/m].

    Parameters
    ----------
    elements
        Number of rollers.
    diameter
        Roller diameter D_we [m].
    rating
        Dynamic load rating C [N].
    compliance
        Sum of (1 - nu^2)/E of roller and ring [1/Pa].

    Notes
    -----
    Each roller end is in line contact (`roller_stiffness`) over 0.2 D_we with a flange of either ring. Secant
    at an axial force of 0.1 C, about the largest that catalogues permit continuously. An order of magnitude:
    it depends on the form of the roller ends and on the flange angle.

    Examples
    --------
    NJ 308 E, steel [N/um]:

    >>> round(flange_stiffness(13, 14.2e-3, 93e3, 2.0 * 0.91 / 207e9) * 1e-6)
    755
    """
    end = roller_stiffness(0.2 * diameter, compliance)
    force = 0.1 * rating
    return force / (force / (elements * in_series(end, end, LINE))) ** (1.0 / LINE)


def roller_profile(
    xi: NDArray[np.float64], length: float, diameter: float, *, tapered: bool = False
) -> NDArray[np.float64]:
    """Profile P of a roller: by how much its radius is smaller than in the middle [m], shape as xi.

    Parameters
    ----------
    xi
        Positions from the middle of the roller, |xi| < length/2 [m], any shape.
    length, diameter
        Effective length L_we and diameter D_we, of tapered rollers in the middle [m].
    tapered
        Whether the roller is a cone.

    Notes
    -----
    Reference profile of ISO/TS 16281:2008, eq. 42 to 44, P = k D_we ln(1/(1 - u^2)). With u = 2 xi/L_we, k is
    0.00035 for cylindrical and 0.00045 for tapered rollers. Cylindrical rollers longer than 2.5 D_we have k =
    0.0005, u = (2 |xi| - L_we)/(2.5 D_we) + 1, and P = 0 in the middle, where u < 0.

    Examples
    --------
    >>> ends = np.array([4e-3, 24e-3])
    >>> (1e6 * roller_profile(ends[:1], 10e-3, 10e-3)).round(3).tolist()
    [3.576]
    >>> (1e6 * roller_profile(ends, 50e-3, 10e-3)).round(3).tolist()
    [0.0, 9.367]
    """
    reach = 2.5 * diameter
    if length > reach and not tapered:
        factor, u = 0.0005, np.maximum((2.0 * np.abs(xi) - length) / reach + 1.0, 0.0)
    else:
        factor, u = 0.00045 if tapered else 0.00035, 2.0 * xi / length
    return -factor * diameter * np.log1p(-(u**2))


def roller_slices(
    length: float, diameter: float, count: int, *, tapered: bool = False
) -> NDArray[np.float64]:
    """Slices of a roller: position from its middle and profile of both contacts [m], shape (count, 2).

    Parameters
    ----------
    length, diameter
        Effective length L_we and diameter D_we [m].
    count
        Number of slices of equal width.
    tapered
        Whether the roller is a cone.

    Notes
    -----
    The raceways are straight. The approach of the rings is the sum of both contacts, each of which has the
    gap P, so that a slice loses 2 P (ISO/TS 16281, eq. 41).

    Examples
    --------
    >>> (1e6 * roller_slices(10e-3, 10e-3, 5)[-1]).round(3).tolist()
    [4000.0, 7.152]
    """
    xi = length * ((np.arange(count) + 0.5) / count - 0.5)
    return np.column_stack([xi, 2.0 * roller_profile(xi, length, diameter, tapered=tapered)])


@dataclass(frozen=True)
class Raceways:
    """Contact of one row of rolling elements.

    Attributes
    ----------
    elements
        Number of elements.
    stiffness, exponent
        Constants of Q = K delta^n of one element between both raceways [N/m^n].
    angle
        Initial contact angle, > 0 [rad]; 0 for a deep groove.
    gap
        Half of the radial internal clearance [m].
    grooves
        Distance of the groove centres [m]; 0 for a constant contact angle.
    slices
        Slices of a roller as of `roller_slices`; None for one point.
    """

    elements: int
    stiffness: float
    exponent: float
    angle: float
    gap: float = 0.0
    grooves: float = 0.0
    slices: NDArray[np.float64] | None = None

    def thrust(self, shift: float) -> float:
        """Axial force of concentric rings displaced by `shift` [m] along the axis [N]."""
        c, s = math.cos(self.angle), math.sin(self.angle)
        if self.grooves > 0.0:
            p, q = self.grooves * c - self.gap, self.grooves * s + shift
            depth = math.hypot(p, q) - self.grooves
            s = q / math.hypot(p, q)
        else:
            depth = shift * s - self.gap * c
        profile = np.zeros(1) if self.slices is None else self.slices[:, 1]
        load = self.stiffness * float(np.mean(np.maximum(depth - profile, 0.0) ** self.exponent))
        return self.elements * load * s

    def shift_for(self, force: float) -> float:
        """Axial displacement of concentric rings under an axial force [m].

        Parameters
        ----------
        force
            Axial force [N]; 0 takes up the clearance.

        Examples
        --------
        Closed form without clearance at constant angle, Z sin(a) K (x sin(a))^1.5:

        >>> row = Raceways(16, 1e10, 1.5, 0.5)
        >>> x = row.shift_for(1000.0)
        >>> round(16 * math.sin(0.5) * 1e10 * (x * math.sin(0.5)) ** 1.5, 6)
        1000.0
        >>> round(Raceways(16, 1e10, 1.5, 0.5, gap=1e-5).shift_for(0.0) * 1e6, 3)  # gap / tan(a)
        18.305
        """
        from scipy.optimize import brentq

        def excess(shift: float) -> float:
            """Axial force less the wanted one [N]."""
            return self.thrust(shift) - force

        high = 1e-6
        while excess(high) <= 0.0:
            high *= 2.0
        if force == 0.0:
            return bisect(self.thrust, 0.0, high)
        return float(brentq(excess, 0.0, high, xtol=1e-16, rtol=1e-14))
