# SPDX-License-Identifier: Apache-2.0
"""Exact tooth of a bevel gear: spherical involutes and the fillet that the crown gear's teeth leave.

All teeth of all cone distances are similar, so one tooth on the unit sphere is enough. Its points are
described by the polar angle δ_y and the half angle of the tooth there; `placed` puts them into space, along
the logarithmic spiral of the gear.

Derivation: docs/theory/bevel_gears.md, "Generation by the crown gear".
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.bevel.cones import spherical_involute
from pitchpoint.geometry.bisection import bisect

if TYPE_CHECKING:
    from pitchpoint.geometry.bevel.gear import BevelGear

FloatArray = NDArray[np.float64]
_SCAN = 400
"""Points of a fillet among which the one is sought where it cuts an involute."""


@dataclass(frozen=True)
class CrownTool:
    """Tooth tip of the crown gear that makes the spaces of a bevel gear, on the unit sphere.

    Parameters
    ----------
    rho
        Angular radius of the rounded tip [rad], at most that of full rounding.
    polar, half_angle
        Polar angle of its centre about the crown gear's axis, and half angle between the centres [rad].
    sigma
        Roll on the crown gear where the round tip leaves its involute [rad].
    half_space
        Half angle of the crown gear's tooth on its pitch plane [rad].
    """

    rho: float
    polar: float
    half_angle: float
    sigma: float
    half_space: float


@dataclass(frozen=True)
class BevelTooth:
    """One tooth of a bevel gear on the unit sphere.

    Parameters
    ----------
    gear
        The gear.
    tool
        Tip of the crown gear that leaves the fillet.
    sigma_form
        Roll at which the usable involute begins [rad].
    tau_root, tau_form
        Parameters of the fillet at the root cone and where it meets the involute: azimuths of the pitch ray
        about the crown gear's axis [rad].
    undercut
        Whether the tool cuts away part of the involute.
    """

    gear: BevelGear
    tool: CrownTool
    sigma_form: float
    tau_root: float
    tau_form: float
    undercut: bool

    @property
    def root_half_angle(self) -> float:
        """Half angle of the tooth where the fillet meets the root cone [rad]."""
        return math.pi / self.gear.z - self.tool.half_angle / math.sin(self.gear.delta)

    @property
    def tip_half_angle(self) -> float:
        """Half angle of the tooth on the tip cone [rad]."""
        return self.gear.half_angle_at(self.gear.delta_a)

    def fillet(self, tau: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Points of the fillet.

        Parameters
        ----------
        tau
            Parameters between `tau_root` and `tau_form` [rad], shape (n,).

        Returns
        -------
        polar, half_angle : ndarray
            Polar angles and half angles of the tooth [rad], shape (n,).

        Notes
        -----
        Crown gear and gear turn about the pitch ray P at every moment. So the normal of the tip's small
        circle (centre C, angular radius ρ) goes through P: the fillet's point lies on the great circle from
        P through C, ρ beyond C. Turning back by τ / sin δ brings it into the gear.
        """
        return _generated(self.tool, self.gear, np.asarray(tau, float))

    def involute(self, sigma: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Points of the involute: polar and half angles of the tooth [rad] at rolls σ, shapes (n,)."""
        gear = self.gear
        s, c = math.sin(gear.delta_b), math.cos(gear.delta_b)
        polar = np.arctan2(np.hypot(s * np.cos(sigma), np.sin(sigma)), c * np.cos(sigma))
        angle = sigma / s - np.arctan2(np.sin(sigma), np.cos(sigma) * s)
        return polar, gear.psi_b - angle

    def flank(self, n_involute: int, n_fillet: int) -> tuple[FloatArray, FloatArray]:
        """Points from the root cone over fillet and involute to the tip cone.

        Parameters
        ----------
        n_involute, n_fillet
            Numbers of points of both, the common one counted with the involute.

        Returns
        -------
        polar, half_angle : ndarray,
            shape (n_fillet + n_involute,) [rad].
        """
        tau = np.linspace(self.tau_root, self.tau_form, n_fillet + 1)[:-1]
        sigma = np.linspace(self.sigma_form, self.gear.sigma_a, n_involute)
        (low, wide), (high, thin) = self.fillet(tau), self.involute(sigma)
        return np.append(low, high), np.append(wide, thin)


def crown_tool(gear: BevelGear) -> CrownTool:
    """Tip of the crown gear that makes a bevel gear.

    Parameters
    ----------
    gear
        The gear; its root radius is made smaller where the tip of the crown gear has no room for it.

    Raises
    ------
    GeometryError
        If the crown gear's teeth are pointed above the root cone.

    Examples
    --------
    >>> from pitchpoint.geometry.bevel.gear import BevelGear
    >>> tool = crown_tool(BevelGear(z=20, m_mn=2.5e-3, delta=math.atan(0.5), b=0.02))
    >>> round(math.degrees(tool.rho), 4), round(math.degrees(tool.polar), 4)
    (0.9737, 92.2259)

    Notes
    -----
    The crown gear has δ = 90° and δ_b = 90° − α_t; its teeth are as thick as the spaces of the gear. A curve
    parallel to a spherical involute is one too, turned by ρ / sin δ_b.
    """
    base = 0.5 * math.pi - gear.alpha_t
    s = math.sin(base)
    half_space = 0.5 * (2.0 * math.pi * math.sin(gear.delta) / gear.z - gear.s_mt / gear.R_m)
    at_pitch = spherical_involute(0.5 * math.pi, base)

    def center(rho: float, theta_f: float = gear.theta_f) -> tuple[float, float, float]:
        """Polar angle, roll and half angle of the centre of a tip with radius ρ at a dedendum angle [rad]."""
        polar = 0.5 * math.pi + theta_f - rho
        reach = math.sin(polar + base) * math.sin(polar - base)
        if not reach > 0.0:
            raise GeometryError(
                "reaches beyond the flanks of the crown gear",
                where="rack.dedendum",
                value=f"{gear.rack.h_fP_star:g}",
                limit=f"a dedendum angle below alpha_t = {math.degrees(gear.alpha_t):.5g} deg",
                remedy="use more teeth or a smaller dedendum",
            )
        sigma = math.atan2(math.sqrt(reach), math.cos(polar))
        return polar, sigma, half_space + at_pitch - spherical_involute(sigma, base) - rho / s

    rho = gear.rack.rho_fP_star * gear.m_mn / gear.R_m
    if abs(rho - gear.theta_f) < 1e-6 * rho:
        rho *= 1.0 - 1e-6  # the great circle from the pitch ray through a centre on it has no direction
    if not center(0.0)[2] > 0.0:
        deepest = bisect(lambda theta: center(0.0, theta)[2], 0.0, gear.theta_f)
        raise GeometryError(
            "modules end beyond the point of the tool",
            where="rack.dedendum",
            value=f"{gear.rack.h_fP_star:g}",
            limit=f"{gear.R_m / gear.m_mn * math.tan(deepest) + gear.x_hm:.4g}",
            remedy="use a smaller dedendum",
        )
    if center(rho)[2] < 0.0:
        rho = bisect(lambda r: center(r)[2], 0.0, rho)
    polar, sigma, half = center(rho)
    return CrownTool(rho, polar, max(0.0, half), sigma + rho, half_space)


def _generated(tool: CrownTool, gear: BevelGear, tau: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Polar angle and half angle of the tooth of points that the tool's round tip leaves [rad]."""
    # frame of the crown gear, turned so that the pitch ray is its first axis
    turn = -tool.half_angle - tau
    s, c = math.sin(tool.polar), math.cos(tool.polar)
    x, y = s * np.cos(turn), s * np.sin(turn)
    beside = np.hypot(y, c)
    # from a centre on the other side of the pitch plane the tip lies towards the pitch ray
    a, b = math.cos(tool.rho), math.copysign(math.sin(tool.rho), -c) / beside
    x, y, z = a * x - b * beside**2, (a + b * x) * y, (a + b * x) * c
    # frame of the gear, whose axis lies beyond the pitch plane
    s, c = math.sin(gear.delta), math.cos(gear.delta)
    radial, axial = s * x + c * z, c * x - s * z
    azimuth = np.arctan2(-y, radial) - tau / s
    return np.arctan2(np.hypot(radial, y), axial), math.pi / gear.z - azimuth


@lru_cache(maxsize=256)
def bevel_tooth(gear: BevelGear) -> BevelTooth:
    """Exact tooth of a bevel gear.

    Parameters
    ----------
    gear
        The gear.

    Returns
    -------
    BevelTooth

    Raises
    ------
    GeometryError
        If there is no such tooth.

    Notes
    -----
    The straight part of the tool ends at the roll σ_Q of the crown gear; contact there lies σ_Q − 90° past
    the pitch ray, so the gear's involute begins at σ_w − (σ_Q − 90°). Where that is below 0 the tool
    undercuts, and fillet and involute cross.

    Examples
    --------
    >>> import math
    >>> from pitchpoint.geometry.bevel.gear import BevelGear
    >>> tooth = bevel_tooth(BevelGear(z=20, m_mn=2.5e-3, delta=math.atan(0.5), b=0.02))
    >>> tooth.undercut, round(math.degrees(tooth.sigma_form), 4), round(math.degrees(tooth.gear.sigma_w), 4)
    (False, 2.21, 9.7043)
    """
    pitch = 2.0 * math.pi * gear.R_m * math.sin(gear.delta) / gear.z
    if not 0.0 < gear.s_mt < pitch:
        key, value = gear.thickness_cause()
        raise GeometryError(
            f"leaves no {'tooth' if gear.s_mt <= 0.0 else 'space'} on the pitch cone",
            where=key,
            value=value,
            limit=f"a mean transverse thickness of 0 to {1e3 * pitch:.6g} mm, it is {1e3 * gear.s_mt:.6g} mm",
            remedy="take a smaller magnitude",
        )
    tool = crown_tool(gear)
    sigma = gear.sigma_w - (tool.sigma - 0.5 * math.pi)
    root = -tool.half_angle
    form = -tool.half_space + (tool.sigma - 0.5 * math.pi) / math.cos(gear.alpha_t)
    if sigma >= 0.0:
        return BevelTooth(gear, tool, sigma, root, form, False)
    return _undercut(gear, tool, root, form)


def _undercut(gear: BevelGear, tool: CrownTool, root: float, form: float) -> BevelTooth:
    """Tooth whose fillet crosses its involute above the base cone."""

    def wider(tau: float) -> float:
        """How much wider than the involute the tooth is at a point of the fillet [rad]."""
        polar, half = (float(v[0]) for v in _generated(tool, gear, np.array([tau])))
        return half - gear.half_angle_at(max(polar, gear.delta_b))

    scan = np.linspace(root, form, _SCAN + 1)
    polar, _ = _generated(tool, gear, scan)
    for low, high in zip(
        scan[:-1][polar[1:] > gear.delta_b], scan[1:][polar[1:] > gear.delta_b], strict=True
    ):
        if wider(float(low)) > 0.0 >= wider(float(high)) or wider(float(high)) > 0.0 >= wider(float(low)):
            found = bisect(wider, float(low), float(high))
            at = float(_generated(tool, gear, np.array([found]))[0][0])
            return BevelTooth(gear, tool, gear.sigma_at(at), root, found, True)
    raise GeometryError(
        "leaves no involute between root fillet and tip",
        where="number_of_teeth",
        value=f"{gear.z}",
        limit="a tip cone above the fillet",
        remedy="use a larger profile shift, more teeth or a smaller dedendum",
    )


def placed(gear: BevelGear, polar: FloatArray, azimuth: FloatArray, R: FloatArray | float) -> FloatArray:
    """Points in the frame of the gear.

    Parameters
    ----------
    gear
        The gear.
    polar, azimuth
        Polar angles, and azimuths in the middle of the face [rad].
    R
        Distances from the apex [m].

    Returns
    -------
    ndarray, shape (..., 3)
        Points, turned by tan β_m / sin δ · ln(R/R_m) [m].

    Examples
    --------
    >>> from pitchpoint.geometry.bevel.gear import BevelGear
    >>> gear = BevelGear(z=20, m_mn=2.5e-3, delta=math.atan(0.5), b=0.02, beta_m=0.5)
    >>> [round(float(c), 6) for c in placed(gear, np.array(gear.delta), np.array(0.0), gear.R_m)]
    [0.028487, 0.0, 0.056975]
    """
    polar, azimuth, R = np.broadcast_arrays(polar, azimuth, R)
    turned = azimuth + gear.spiral_rate * np.log(R / gear.R_m)
    across = R * np.sin(polar)
    return np.stack([across * np.cos(turned), across * np.sin(turned), R * np.cos(polar)], axis=-1)


def at_cone(gear: BevelGear, polar: FloatArray, R: float) -> FloatArray:
    """Distances from the apex of points on the cone that is perpendicular to the pitch cone.

    Parameters
    ----------
    gear
        The gear.
    polar
        Polar angles of the points [rad], shape (n,).
    R
        Distance from the apex at which the cone crosses the pitch cone [m].

    Returns
    -------
    ndarray
        [m].

    Examples
    --------
    >>> from pitchpoint.geometry.bevel.gear import BevelGear
    >>> gear = BevelGear(z=20, m_mn=2.5e-3, delta=math.atan(0.5), b=0.02)
    >>> at_cone(gear, np.array([gear.delta]), 0.06).tolist()
    [0.06]
    """
    return np.asarray(R / np.cos(polar - gear.delta))
