# SPDX-License-Identifier: Apache-2.0
"""The exact root fillet that a rack-type tool (hob) with rounded tips generates on an external gear."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

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
        tool point stands q cos β cot θ beside it; the gear has then turned by the rolled length over r
        (F. L. Litvin and A. Fuentes, *Gear Geometry and Applied Theory*, 2nd ed., ch. 6).
        """
        theta = np.asarray(theta, dtype=float)
        depth = self.depth_c + self.rho * np.sin(theta)
        across = depth * self.cos_beta * np.cos(theta) / np.sin(theta)
        rolled = across - (self.x_c + self.rho * np.cos(theta)) / self.cos_beta
        height = self.r - depth
        return np.hypot(across, height), np.arctan2(across, height) - rolled / self.r


def undercut_crossing(fillet: RackFillet, r_b: float, psi_b: float, half_pitch: float) -> tuple[float, float]:
    """Fillet parameter and radius [m] at which an undercutting trochoid crosses the involute.

    Parameters
    ----------
    fillet
        Fillet of an undercut gear.
    r_b
        Base radius [m].
    psi_b
        Half tooth angle at the base circle [rad].
    half_pitch
        π/z [rad].

    Returns
    -------
    theta, r_Ff : float
        The involute remains from r_Ff outwards.
    """
    from scipy.optimize import brentq

    def clearance(theta: float) -> float:
        r, delta = (float(value) for value in fillet.polar(theta))
        roll = math.sqrt(max(0.0, (r / r_b) ** 2 - 1.0))
        return half_pitch - delta - (psi_b - roll + math.atan(roll))

    # The trochoid passes the base circle once. From the end of the tool flank down to there it is first
    # clear of the involute and then, behind the crossing, inside the tooth.
    at_base = float(brentq(lambda t: float(fillet.polar(t)[0]) - r_b, fillet.theta_flank, fillet.theta_root))
    theta = np.linspace(fillet.theta_flank, at_base, 257)
    cut = np.array([clearance(t) for t in theta]) < 0.0
    first = int(np.argmax(cut))
    if first == 0:
        # So slight that it ends at the base circle, within round-off of the limit.
        return at_base, r_b
    root = float(brentq(clearance, theta[first - 1], theta[first], xtol=1e-15, rtol=1e-14))
    return root, float(fillet.polar(root)[0])
