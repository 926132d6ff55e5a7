# SPDX-License-Identifier: Apache-2.0
"""Nominal bending stress at the 30° tangent of the root fillet (internal gears 60°), for any place of load.

Source: ISO 6336-3:2006, method B. Derivation: docs/theory/root_stress.md, "Tangent".
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.contact.compliance.blank import Blank, blank_radii
from pitchpoint.contact.compliance.clamped_tooth import ClampedTooth, clamped_form
from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.tooth_form import virtual_tooth_form

Array = NDArray[np.float64]

NOTCH_RANGE = (1.0, 8.0)
"""Range of the notch parameter q_s in which Y_S is stated."""
RIM_RANGES = {1: (0.5, 1.2), -1: (1.75, 3.5)}
"""Rim thickness between which Y_B applies, by the sign of z: over the tooth depth, internal over m_n."""
_LEAST = 1e-6
"""Least bending lever arm over the normal module: the line of force crosses the section itself."""


@dataclass(frozen=True)
class RootSection:
    """Critical section of a tooth root, in the virtual spur gear of the normal section.

    Parameters
    ----------
    gear
        The gear.
    tooth
        Its virtual tooth, clamped at the critical section.
    """

    gear: CylindricalGear
    tooth: ClampedTooth

    @property
    def chord(self) -> float:
        """Tooth root normal chord s_Fn [m]."""
        return self.tooth.chord

    @property
    def fillet_radius(self) -> float:
        """Radius of the root fillet at the critical section ρ_F [m]."""
        return self.tooth.fillet_radius

    @property
    def notch_parameter(self) -> float:
        """q_s = s_Fn/(2 ρ_F) [-]."""
        return 0.5 * self.chord / self.fillet_radius

    def load(self, rho: ArrayLike) -> tuple[Array, Array]:
        """Load direction angle and bending lever arm of forces on the flank.

        Parameters
        ----------
        rho
            Lengths of roll in the transverse section [m], any shape; beyond the tip: at the tip. Negative:
            force along the base tangent when the involute would touch it inside the base circle.

        Returns
        -------
        alpha_Fn, h_F : ndarray, shape of rho
            Angle to the perpendicular of the tooth centre line [rad], lever arm [m]. A force that passes
            below the section has the lever arm 0.

        Notes
        -----
        On the path of contact a place is 1/cos β_b times as far from the tip in the virtual gear, whose flank
        has 1/cos β_b times the radius of curvature. The tip is that of the standard.
        """
        gear, form = self.gear, self.tooth.form
        tip, tip_n = (
            math.sqrt(max(0.0, r_a * r_a - r_b * r_b))
            for r_a, r_b in ((0.5 * gear.d_a, gear.r_b), (form.r_a, form.r_b))
        )
        below = gear.sign * (tip - np.asarray(rho, dtype=np.float64)) / math.cos(gear.beta_b)
        rho_n = tip_n - gear.sign * np.maximum(below, 0.0)
        return self.tooth.load_angle(rho_n), np.maximum(self.tooth.arms(rho_n)[0], _LEAST * gear.m_n)

    def factors(self, rho: ArrayLike) -> tuple[Array, Array]:
        """Form factor Y_F and stress correction factor Y_S of forces on the flank, shape of rho each.

        Parameters
        ----------
        rho
            As for `load`.

        Notes
        -----
        Y_F = 6 (h_F/m_n) cos α_Fn/((s_Fn/m_n)² cos α_n), ISO 6336-3:2006, 6.2.

        Y_S = (1.2 + 0.13 L) q_s^(1/(1.21 + 2.3/L)) with L = s_Fn/h_F, 7.2, stated for 1 ≤ q_s < 8.
        """
        alpha, h_F = self.load(rho)
        L, gear = self.chord / h_F, self.gear
        Y_F = 6.0 * h_F * gear.m_n * np.cos(alpha) / (self.chord**2 * math.cos(gear.alpha_n))
        return Y_F, (1.2 + 0.13 * L) * self.notch_parameter ** (1.0 / (1.21 + 2.3 / L))

    def stress(self, line_load: ArrayLike, rho: ArrayLike) -> Array:
        """Nominal root stress with notch factor, F_t/(b m_n) Y_F Y_S [Pa].

        Parameters
        ----------
        line_load
            Force along the transverse base tangent per face width [N/m], broadcast against rho.
        rho
            Lengths of roll [m].

        Returns
        -------
        ndarray, shape of the arguments broadcast

        Notes
        -----
        F_t = F_bt cos α_t acts on the reference circle.
        """
        tangential = np.asarray(line_load, dtype=np.float64) * math.cos(self.gear.alpha_t)
        Y_F, Y_S = self.factors(rho)
        return np.asarray(tangential / self.gear.m_n * Y_F * Y_S)


def root_section(gear: CylindricalGear) -> RootSection:
    """Critical section of the root of a generated tooth: its fillet has a tangent at 30°, internal gears 60°.

    Parameters
    ----------
    gear
        External or internal gear.

    Raises
    ------
    GeometryError
        If the tooth is not possible, or its fillet does not have this tangent.

    Examples
    --------
    >>> section = root_section(CylindricalGear(z=24, m_n=14e-3, beta=math.radians(10.0), x=0.48))
    >>> round(1e3 * section.chord, 2), round(1e3 * section.fillet_radius, 2)      # KISSsoft prints both
    (31.18, 5.95)
    """
    form = virtual_tooth_form(gear)
    try:
        return RootSection(gear, clamped_form(form, 0.0))
    except GeometryError:
        angle = 60 if gear.is_internal else 30
        message = f"has no tangent at {angle}° to the centre line of the tooth, the critical section"
        raise GeometryError(message, where="root_fillet_radius") from None


def helix_factor(beta: float, eps_beta: float) -> float:
    """Helix angle factor of root stress Y_β [-].

    Parameters
    ----------
    beta
        Helix angle at the reference cylinder [rad].
    eps_beta
        Overlap ratio.

    Notes
    -----
    1 − ε_β β/120° with ε_β ≤ 1 and β ≤ 30° (ISO 6336-3:2006, 8).

    Examples
    --------
    >>> round(helix_factor(math.radians(10.0), 1.421), 3)
    0.917
    """
    return 1.0 - min(eps_beta, 1.0) * min(math.degrees(abs(beta)), 30.0) / 120.0


def rim_ratio(gear: CylindricalGear, blank: Blank) -> float:
    """Rim thickness s_R over the tooth depth h_t, of internal gears over the normal module.

    Parameters
    ----------
    gear
        The gear.
    blank
        Its blank; a solid one has a rim down to the bore.

    Raises
    ------
    GeometryError
        If the blank is not possible.

    Examples
    --------
    >>> round(rim_ratio(CylindricalGear(z=40, m_n=2e-3), Blank(rim_thickness=4.5e-3, web_thickness=5e-3)), 9)
    1.0
    """
    radii = blank_radii(gear, blank)
    return abs(radii.root - radii.rim) / (gear.m_n if gear.is_internal else 0.5 * (gear.d_a - gear.d_fE))


def rim_factor(gear: CylindricalGear, blank: Blank) -> float:
    """Rim thickness factor Y_B [-].

    Parameters
    ----------
    gear, blank
        As for `rim_ratio`.

    Raises
    ------
    GeometryError
        If the blank is not possible.

    Notes
    -----
    External gears 1.6 ln(2.242 h_t/s_R) below s_R = 1.2 h_t, internal gears 1.15 ln(8.324 m_n/s_R) below
    3.5 m_n, else 1 (ISO 6336-3:2006, 9). Stated above 0.5 h_t or 1.75 m_n.

    Examples
    --------
    >>> gear = CylindricalGear(z=40, m_n=2e-3)
    >>> round(rim_factor(gear, Blank(rim_thickness=4.5e-3, web_thickness=5e-3)), 4), rim_factor(gear, Blank())
    (1.2918, 1.0)
    """
    ratio = rim_ratio(gear, blank)
    factor, scale = (1.15, 8.324) if gear.is_internal else (1.6, 2.242)
    return 1.0 if ratio >= RIM_RANGES[gear.sign][1] else factor * math.log(scale / ratio)
