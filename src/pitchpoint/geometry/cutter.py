# SPDX-License-Identifier: Apache-2.0
"""Pinion-type cutter (shaping tool) and the exact root fillet that it generates in an internal gear.

All functions work in the transverse section with positive lengths, also for internal gears; the signs of
ISO 21771 are handled by the gear classes.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.bisection import bisect
from pitchpoint.geometry.involute import inv, inverse_inv, transverse_pressure_angle

FloatArray = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class CutterTeeth:
    """Rounded teeth of a pinion-type cutter, real or virtual.

    Parameters
    ----------
    z_0
        Number of teeth of the cutter [-]; of a virtual cutter any number.
    x_0, h_aP0_star, rho_aP0_star
        As in `PinionCutter`.
    """

    z_0: float
    x_0: float = 0.0
    h_aP0_star: float = 1.25
    rho_aP0_star: float = 0.38

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

    def virtual(self, ratio: float) -> CutterTeeth:
        """Teeth of the virtual cutter with `ratio` times the number of teeth.

        Examples
        --------
        >>> PinionCutter(z_0=20, x_0=0.1).virtual(1.08).z_0
        21.6
        """
        return CutterTeeth(
            z_0=ratio * self.z_0, x_0=self.x_0, h_aP0_star=self.h_aP0_star, rho_aP0_star=self.rho_aP0_star
        )


@dataclass(frozen=True, kw_only=True)
class PinionCutter(CutterTeeth):
    """A pinion-type cutter with rounded tips, as used to shape internal gears.

    Parameters
    ----------
    z_0
        Number of teeth of the cutter [-]; fewer than the gear it cuts.
    x_0
        Profile shift coefficient of the cutter [-]; it decreases with every regrinding.
    h_aP0_star
        Addendum of the cutter's basic rack, h_aP0* [-]: tip radius = m_n (z₀/(2 cos β) + x₀ + h_aP0*).
    rho_aP0_star
        Tip radius, ρ_aP0* [-], a circle in the transverse section. A radius too large for the tooth is
        replaced by full rounding.

    Raises
    ------
    GeometryError
        If a value is not a number of the right type and range.

    Examples
    --------
    >>> PinionCutter(z_0=20).h_aP0_star
    1.25
    """

    z_0: int

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


@dataclass(frozen=True)
class CutterFillet:
    """Fillet of an internal gear: envelope of the cutter's tip rounding, in closed form.

    The parameter `theta` is the angle on the cutter between the radius through the centre of the rounding and
    the normal of the rounding: 0 at the root circle of the gear, `theta_flank` at the end of the involute.

    Parameters
    ----------
    ratio
        z₀/|z₂| [-].
    r_w0, r_w2
        Generating pitch radii of cutter and gear [m]; their difference is the generating centre distance.
    r_c, psi_c
        Polar coordinates of the centre of the rounding, angle from the cutter's tooth centre line [m, rad].
    rho
        Radius of the rounding [m].
    theta_flank
        Angle of the normal at the transition from rounding to cutter flank [rad].
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
        the cutter's pitch circle where sin χ = r_c sin θ / r_w0. The cutter has rotated until this point is
        the pitch point, the gear by z₀/|z₂| of this angle (F. L. Litvin and A. Fuentes, *Gear Geometry and
        Applied Theory*, 2nd ed., ch. 6: planar enveloping).
        """
        theta = np.asarray(theta, dtype=float)
        sine = self.r_c * np.sin(theta) / self.r_w0
        chi = np.arcsin(sine)
        reach = self.r_c * np.cos(theta) + self.rho - self.r_w0 * np.cos(chi)
        across, along = reach * sine, self.r_w2 + reach * np.cos(chi)
        return np.hypot(across, along), np.arctan2(across, along) + (self.psi_c + theta - chi) * self.ratio


def generating_position(
    z: float, z_0: float, r_b: float, space_half_angle_b: float, cutter_half_angle_b: float
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
            "cutter teeth are too many for this internal gear",
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
    z: float, z_0: float, r_b: float, r_a0: float, rho: float, position: tuple[float, float], psi_b0: float
) -> CutterFillet:
    """Root fillet of an internal gear generated by a pinion-type cutter.

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
    reduced to full rounding, ψ_c = 0. With z₀ = z, a₀ = 0 the "cutter" is the tooth space itself and the
    fillet is a circular arc: the fillet of an internal gear without a cutter.
    """
    r_b0 = r_b * z_0 / z

    def centre_angle(radius: float) -> float:
        """Angle ψ_c of the centre of a tip rounding of this radius [rad]."""
        return psi_b0 - radius / r_b0 - inv(math.acos(min(1.0, r_b0 / (r_a0 - radius))))

    if not r_a0 > r_b0 or centre_angle(0.0) <= 0.0:
        pointed = "the cutter's teeth" if z_0 < z else "the tooth space"
        raise GeometryError(
            f"lies beyond the point of {pointed}",
            where="cutter" if z_0 < z else "root_diameter",
            value=f"{'tip diameter ' if z_0 < z else ''}{2e3 * r_a0:.4f} mm",
            limit=f"above the base diameter {2e3 * r_b0:.4f} mm, with flanks that do not meet",
            remedy="use a smaller dedendum (root_diameter), or a cutter with other teeth or profile shift",
        )
    rho = min(rho, 0.999 * (r_a0 - r_b0))
    if centre_angle(rho) < 0.0:
        rho = bisect(centre_angle, 0.0, rho)
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


def shaped_root(
    *,
    z: float,
    m_n: float,
    alpha_n: float,
    beta: float,
    s_n: float,
    r_f: float | None,
    rho: float,
    cutter: CutterTeeth | None,
) -> tuple[CutterFillet, float, float]:
    """Root of an internal gear with the fillet of a pinion-type cutter or a circular fillet.

    Parameters
    ----------
    z
        Number of teeth [-], positive.
    m_n
        Normal module [m].
    alpha_n, beta
        Normal pressure angle and helix angle [rad].
    s_n
        Normal tooth thickness at the reference circle [m].
    r_f
        Root radius [m], to which the cutter's tip circle is set; None = from the cutter's addendum (requires
        a cutter).
    rho
        Fillet radius without a cutter [m].
    cutter
        The tool; None: circular fillet between flank and root, the limit of a cutter with z₀ = z.

    Returns
    -------
    fillet : CutterFillet
    r_Ff, r_f : float
        Root form and root radius [m].

    Raises
    ------
    GeometryError
        If the cutter has too many teeth, does not fit, or is pointed.

    Notes
    -----
    Generation without backlash, see `generating_position`. The involute ends at the roll length
    L = √(r_c² − r_b0²) + ρ of the cutter flank, that is at r_Ff² = r_b² + (L + a₀ sin α_wt0)²  (ISO 21771).

    Examples
    --------
    Ring gear of stage 1 of the 5 MW gearbox; the KISSsoft report gives a root form diameter of 2662.682 mm:

    >>> s_n = 45e-3 * (math.pi / 2 - 2 * 0.5013 * math.tan(math.radians(20)))
    >>> _, r_Ff, r_f = shaped_root(z=56, m_n=45e-3, alpha_n=math.radians(20), beta=0.0, s_n=s_n,
    ...     r_f=1.3388085, rho=0.0, cutter=PinionCutter(z_0=36, rho_aP0_star=0.3))
    >>> round(2e3 * r_Ff, 2)
    2662.68
    """
    alpha_t = transverse_pressure_angle(alpha_n, beta)
    r_b = 0.5 * z * m_n / math.cos(beta) * math.cos(alpha_t)
    space_b = math.pi / z - s_n / (z * m_n) + inv(alpha_t)
    z_0, psi_b0, position = z, space_b, (alpha_t, 0.0)
    if cutter is not None:
        z_0, psi_b0 = cutter.z_0, cutter.base_half_angle(alpha_n, beta)
        rho = cutter.rho_aP0_star * m_n
        position = generating_position(z, z_0, r_b, space_b, psi_b0)
        if r_f is None:
            r_f = cutter.tip_radius(m_n, beta) + position[1]
    assert r_f is not None
    fillet = cutter_fillet(z, z_0, r_b, r_f - position[1], rho, position, psi_b0)
    roll = fillet.r_c * math.cos(fillet.theta_flank) + fillet.rho + position[1] * math.sin(position[0])
    return fillet, math.hypot(r_b, roll), r_f
