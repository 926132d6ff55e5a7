# SPDX-License-Identifier: Apache-2.0
"""The pinion-type cutter (shaping tool) and the exact root fillet that it leaves in an internal gear.

Everything here takes plain numbers and lives in the transverse section; lengths are positive also for
internal gears. The signs of ISO 21771 stay with the gear classes.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.involute import inv, inverse_inv, transverse_pressure_angle

FloatArray = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class PinionCutter:
    """A pinion-type cutter with rounded tips, as used to shape internal gears.

    Parameters
    ----------
    z_0
        Number of teeth of the cutter [-]; fewer than the gear it cuts.
    x_0
        Profile shift coefficient of the cutter [-]; it falls with every regrinding.
    h_aP0_star
        Addendum of the cutter's basic rack, h_aP0* [-]: tip radius = m_n (z₀/(2 cos β) + x₀ + h_aP0*).
    rho_aP0_star
        Tip radius, ρ_aP0* [-], a circle in the transverse section. What does not fit on the tooth is
        replaced by the full rounding.

    Raises
    ------
    GeometryError
        If a value is no such number.

    Examples
    --------
    >>> PinionCutter(z_0=20).h_aP0_star
    1.25
    """

    z_0: int
    x_0: float = 0.0
    h_aP0_star: float = 1.25
    rho_aP0_star: float = 0.38

    def __post_init__(self) -> None:
        limits = {
            "z_0": (1, 100_000, "number_of_teeth"),
            "x_0": (-10.0, 10.0, "profile_shift_coefficient"),
            "h_aP0_star": (1e-3, 100.0, "addendum"),
            "rho_aP0_star": (0.0, 100.0, "tip_radius"),
        }
        for name, (low, high, words) in limits.items():
            value = getattr(self, name)
            kinds = (int,) if name == "z_0" else (int, float)
            if isinstance(value, bool) or not isinstance(value, kinds) or not low <= value <= high:
                raise GeometryError(
                    "is not possible for a pinion-type cutter",
                    where=f"cutter.{words}",
                    value=f"{value!r}",
                    limit=f"{low:g} to {high:g}",
                )

    def tip_radius(self, m_n: float, beta: float = 0.0) -> float:
        """Tip circle radius r_a0 [m].

        Examples
        --------
        >>> PinionCutter(z_0=20, x_0=0.1).tip_radius(m_n=2e-3)
        0.0227
        """
        return m_n * (self.z_0 / (2.0 * math.cos(beta)) + self.x_0 + self.h_aP0_star)

    def base_half_angle(self, alpha_n: float, beta: float = 0.0) -> float:
        """Half tooth angle at the base circle, ψ_b0 = (π/2 + 2 x₀ tan α_n)/z₀ + inv α_t [rad].

        Examples
        --------
        >>> round(PinionCutter(z_0=20).base_half_angle(math.radians(20.0)), 9)
        0.0934442
        """
        alpha_t = transverse_pressure_angle(alpha_n, beta)
        return (0.5 * math.pi + 2.0 * self.x_0 * math.tan(alpha_n)) / self.z_0 + inv(alpha_t)


@dataclass(frozen=True)
class CutterFillet:
    """Fillet of an internal gear: the envelope of the cutter's tip rounding, in closed form.

    Parameter `theta` is the angle on the cutter between the radius through the centre of the rounding and
    the normal of the rounding: 0 at the root circle of the gear, `theta_flank` at the end of the involute.

    Parameters
    ----------
    ratio
        z₀/|z₂| [-].
    r_w0, r_w2
        Generating pitch radii of cutter and gear [m]; their difference is the generating centre distance.
    r_c, psi_c
        Polar coordinates of the centre of the rounding from the cutter's tooth centre line [m, rad].
    rho
        Radius of the rounding [m].
    theta_flank
        Angle of the normal where rounding and cutter flank touch [rad].
    """

    ratio: float
    r_w0: float
    r_w2: float
    r_c: float
    psi_c: float
    rho: float
    theta_flank: float

    theta_root: float = 0.0

    def polar(self, theta: FloatArray | float) -> tuple[FloatArray, FloatArray]:
        """Radius [m] and angle from the centre of the space [rad] of fillet points, shapes as `theta`.

        Notes
        -----
        Law of gearing: the common normal passes through the pitch point. A normal at the angle θ meets
        the cutter's pitch circle where sin χ = r_c sin θ / r_w0; the cutter has then turned so that this
        point is the pitch point, and the gear by z₀/|z₂| of that (F. L. Litvin and A. Fuentes, *Gear
        Geometry and Applied Theory*, 2nd ed., ch. 6: planar enveloping).
        """
        theta = np.asarray(theta, dtype=float)
        sine = self.r_c * np.sin(theta) / self.r_w0
        chi = np.arcsin(sine)
        reach = self.r_c * np.cos(theta) + self.rho - self.r_w0 * np.cos(chi)
        across, along = reach * sine, self.r_w2 + reach * np.cos(chi)
        return np.hypot(across, along), np.arctan2(across, along) + (self.psi_c + theta - chi) * self.ratio


def generating_position(
    z: int, z_0: int, r_b: float, space_half_angle_b: float, cutter_half_angle_b: float
) -> tuple[float, float]:
    """Generating pressure angle α_wt0 [rad] and centre distance |a₀| [m] of cutter and internal gear.

    Parameters
    ----------
    z, z_0
        Numbers of teeth of gear and cutter [-], both positive, z > z₀.
    r_b
        Base radius of the gear [m].
    space_half_angle_b
        Half angle of the tooth space extended to the base circle, η_b = π/|z| − |ψ| + inv α_t [rad].
    cutter_half_angle_b
        Half tooth angle of the cutter at its base circle, ψ_b0 [rad].

    Raises
    ------
    GeometryError
        If the cutter does not have fewer teeth, or its tooth is too thin for the space at any distance.

    Notes
    -----
    Generation without backlash: z₀ (ψ_b0 − inv α) = |z| (η_b − inv α) on the pitch circles, so
    inv α_wt0 = (|z| η_b − z₀ ψ_b0)/(|z| − z₀); then |a₀| = (r_b − r_b0)/cos α_wt0.

    Examples
    --------
    >>> from pitchpoint.geometry.involute import inv
    >>> i20 = inv(math.radians(20.0))
    >>> eta_b, psi_b0 = 0.5 * math.pi / 60 + i20, 0.5 * math.pi / 20 + i20
    >>> a, distance = generating_position(60, 20, 0.0563815572, eta_b, psi_b0)
    >>> round(math.degrees(a), 6), round(distance, 9)
    (20.0, 0.04)
    """
    if not z_0 < z:
        raise GeometryError(
            "teeth of the cutter are too many for this internal gear",
            where="cutter.number_of_teeth",
            value=f"{z_0}",
            limit=f"below {z}",
            remedy="use a cutter with fewer teeth",
        )
    value = (z * space_half_angle_b - z_0 * cutter_half_angle_b) / (z - z_0)
    if value < 0.0:
        raise GeometryError(
            "the cutter's teeth do not fit the tooth space at any centre distance",
            where="cutter",
            value=f"inv alpha_wt0 = {value:.4g}",
            limit=">= 0",
            remedy="use a cutter with a smaller profile shift or fewer teeth",
        )
    alpha = inverse_inv(value)
    return alpha, r_b * (1.0 - z_0 / z) / math.cos(alpha)


def cutter_fillet(
    z: int, z_0: int, r_b: float, r_a0: float, rho: float, position: tuple[float, float], psi_b0: float
) -> CutterFillet:
    """Fillet that a pinion-type cutter leaves in an internal gear.

    Parameters
    ----------
    z, z_0
        Numbers of teeth of gear and cutter [-], positive.
    r_b
        Base radius of the gear [m].
    r_a0, rho
        Tip radius and radius of the tip rounding of the cutter [m], transverse section.
    position
        Generating pressure angle [rad] and centre distance [m] of `generating_position`.
    psi_b0
        Half tooth angle of the cutter at its base circle [rad].

    Raises
    ------
    GeometryError
        If the cutter's tooth is pointed below its tip circle.

    Notes
    -----
    The centre of the rounding lies on the involute shifted inwards by ρ, which is an involute of the same
    base circle: ψ_c = ψ_b0 − ρ/r_b0 − inv α_c with cos α_c = r_b0/(r_a0 − ρ). If ψ_c is negative, ρ is
    reduced to the full rounding, ψ_c = 0. With z₀ = z, a₀ = 0 the "cutter" is the tooth space itself and
    the fillet a plain circular arc: that is how the fillet of an internal gear without a cutter is made.
    """
    r_b0 = r_b * z_0 / z
    if r_a0 <= r_b0 or psi_b0 - inv(math.acos(r_b0 / r_a0)) <= 0.0:
        raise GeometryError(
            "the cutter that makes this root circle has pointed teeth",
            where="cutter",
            value=f"tip diameter {2e3 * r_a0:.4f} mm",
            remedy="use a smaller dedendum (root_diameter) or a cutter with other teeth",
        )

    def centre_angle(radius: float) -> float:
        return psi_b0 - radius / r_b0 - inv(math.acos(min(1.0, r_b0 / (r_a0 - radius))))

    rho = min(rho, 0.999 * (r_a0 - r_b0))
    if centre_angle(rho) < 0.0:
        from scipy.optimize import brentq

        rho = float(brentq(centre_angle, 0.0, rho, xtol=1e-18))
    alpha_wt0, a_0 = position
    r_c = r_a0 - rho
    r_w0 = r_b0 / math.cos(alpha_wt0)
    return CutterFillet(
        ratio=z_0 / z,
        r_w0=r_w0,
        r_w2=r_w0 + a_0,
        r_c=r_c,
        psi_c=max(0.0, centre_angle(rho)),
        rho=rho,
        theta_flank=math.asin(r_b0 / r_c),
    )
