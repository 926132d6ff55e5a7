# SPDX-License-Identifier: Apache-2.0
"""The exact root fillet that a rack-type tool (hob) with rounded tips generates on an external gear.

Source: Litvin and Fuentes, Gear Geometry and Applied Theory, 2nd ed. (2004), ch. 6.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.bisection import bisect
from pitchpoint.geometry.involute import inv, transverse_pressure_angle

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class RackFillet:
    """Fillet of an external gear: the envelope of the rounded tip of a rack-type tool, in closed form.

    Parameter `theta` is the angle in the normal section between the datum line and the normal of the tip
    rounding: `theta_flank` = α_n at the end of the involute, `theta_root` = π/2 at the root circle.

    Parameters
    ----------
    r
        Generating pitch radius, the reference radius [m].
    depth_c, x_c
        Centre of the rounding [m]: depth below the reference circle, and distance from the middle of the
        tool tooth along the datum line in the normal section.
    rho
        Radius of the rounding in the normal section [m]; in the transverse section it is an ellipse.
    cos_beta
        Cosine of the helix angle [-].
    theta_flank
        α_n [rad].
    """

    r: float
    depth_c: float
    x_c: float
    rho: float
    cos_beta: float
    theta_flank: float

    theta_root: float = 0.5 * math.pi

    def polar(self, theta: FloatArray | float) -> tuple[FloatArray, FloatArray]:
        """Radius [m] and angle from the centre of the space [rad] of fillet points, shapes as `theta`.

        Notes
        -----
        Law of gearing: the transverse normal of the tool at the depth q passes the pitch point when the
        tool point lies q cos β cot θ next to it; the gear has then turned by the rolled length over r
        (F. L. Litvin and A. Fuentes, *Gear Geometry and Applied Theory*, 2nd ed., ch. 6).
        """
        theta = np.asarray(theta, dtype=float)
        depth = self.depth_c + self.rho * np.sin(theta)
        across = depth * self.cos_beta * np.cos(theta) / np.sin(theta)
        rolled = across - (self.x_c + self.rho * np.cos(theta)) / self.cos_beta
        height = self.r - depth
        return np.hypot(across, height), np.arctan2(across, height) - rolled / self.r


def rack_root(
    *, z: float, m_n: float, alpha_n: float, beta: float, s_n: float, depth: float, rho: float
) -> tuple[RackFillet, float, float, bool]:
    """Root of an external tooth as a rack-type tool leaves it.

    Parameters
    ----------
    z
        Number of teeth [-].
    m_n
        Normal module [m].
    alpha_n, beta
        Normal pressure angle and helix angle [rad].
    s_n
        Normal tooth thickness at the reference circle [m]; the tool's space makes it.
    depth
        How far the tool reaches below the reference circle [m].
    rho
        Tip radius of the tool in the normal section [m]; what does not fit is replaced by the full rounding.

    Returns
    -------
    fillet : RackFillet
    theta_form : float
        Parameter of the fillet where the involute begins [rad].
    r_Ff : float
        Radius there [m].
    undercut : bool
        True when the fillet cuts the involute instead of touching it.

    Notes
    -----
    The straight flank of the tool ends at the depth h below the reference circle. It makes the involute down
    to r_Ff² = (h/tan α_t)² + (r − h)², the same as d_Ff² = d_b² + (d sin α_t − 2 h/sin α_t)² of ISO 21771,
    unless it passes the tangent point of the line of action, h > r sin² α_t: then the trochoid of the
    rounding cuts the involute, which begins at their crossing.

    Examples
    --------
    >>> s_n = 14e-3 * (math.pi / 2 + 0.96 * math.tan(math.radians(20)))
    >>> fillet, theta, r_Ff, undercut = rack_root(z=24, m_n=14e-3, alpha_n=math.radians(20),
    ...     beta=math.radians(10), s_n=s_n, depth=10.78e-3, rho=5.32e-3)
    >>> round(2e3 * r_Ff, 3), undercut    # KISSsoft prints 328.991 mm
    (328.991, False)
    """
    alpha_t = transverse_pressure_angle(alpha_n, beta)
    cos_beta = math.cos(beta)
    r = 0.5 * z * m_n / cos_beta
    slope = (1.0 - math.sin(alpha_n)) / math.cos(alpha_n)
    half_tip = 0.5 * (math.pi * m_n - s_n) - depth * math.tan(alpha_n)
    rho = max(0.0, min(rho, half_tip / slope))
    fillet = RackFillet(r, depth - rho, max(0.0, half_tip - rho * slope), rho, cos_beta, alpha_n)
    end = fillet.depth_c + rho * math.sin(alpha_n)
    if end - r * math.sin(alpha_t) ** 2 <= 1e-12 * r:
        return (
            fillet,
            alpha_n,
            max(math.hypot(end / math.tan(alpha_t), r - end), r * math.cos(alpha_t)),
            False,
        )
    psi_b = s_n / (z * m_n) + inv(alpha_t)
    theta, r_Ff = _undercut_crossing(fillet, r * math.cos(alpha_t), psi_b, math.pi / z)
    return fillet, theta, r_Ff, True


def _undercut_crossing(
    fillet: RackFillet, r_b: float, psi_b: float, half_pitch: float
) -> tuple[float, float]:
    """Fillet parameter and radius [m] at which an undercutting trochoid crosses the involute."""

    def clearance(theta: FloatArray | float) -> FloatArray:
        """Angle from the fillet to the involute at the same radius, at parameters of the fillet [rad]."""
        r, delta = fillet.polar(theta)
        roll = np.sqrt(np.maximum(0.0, (r / r_b) ** 2 - 1.0))
        return np.asarray(half_pitch - delta - (psi_b - roll + np.arctan(roll)))

    # The trochoid passes the base circle once. From the end of the tool flank down to there it is first
    # clear of the involute and then, behind the crossing, inside the tooth.
    at_base = bisect(lambda t: float(fillet.polar(t)[0]) - r_b, fillet.theta_flank, fillet.theta_root)
    theta = np.linspace(fillet.theta_flank, at_base, 257)
    first = int(np.argmax(clearance(theta) < 0.0))
    if first == 0:
        # So slight that it ends at the base circle, within round-off of the limit.
        return at_base, r_b
    root = bisect(lambda t: float(clearance(t)), float(theta[first - 1]), float(theta[first]))
    return root, max(r_b, float(fillet.polar(root)[0]))
