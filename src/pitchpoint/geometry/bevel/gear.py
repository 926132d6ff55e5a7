# SPDX-License-Identifier: Apache-2.0
"""Straight or spiral bevel gear with spherical involute flanks: sizes derived from its defining data.

All cones of a gear share its apex. The gear frame has its origin at the apex and its z axis into the gear;
cone angles are measured from that axis. Symbols follow ISO 23509. Lengths in metres, angles in radians;
β_m > 0 is right hand: seen from the apex the teeth curve clockwise from toe to heel.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from pitchpoint.core.errors import GeometryError, Message
from pitchpoint.core.plain_numbers import real_number, whole_number
from pitchpoint.core.short_repr import ShortRepr
from pitchpoint.geometry.bevel.cones import spherical_involute
from pitchpoint.geometry.involute import transverse_pressure_angle
from pitchpoint.geometry.rack import BasicRack


def _number(where: str, value: object, low: float, high: float, limit: str) -> None:
    """Raise for booleans, NaN and numbers outside the open interval."""
    if (number := real_number(value)) is None or not low < number < high:
        raise GeometryError(
            "is not possible", where=where, value=f"{value!r}", limit=limit, remedy="give a number within"
        )


@dataclass(frozen=True, kw_only=True)
class BevelGear(ShortRepr):
    """An external straight or spiral bevel gear of uniform taper.

    Parameters
    ----------
    z
        Number of teeth.
    m_mn
        Mean normal module [m].
    delta
        Pitch cone angle [rad], above 0 and below π/2.
    b
        Face width along the pitch cone [m]; the mean cone distance is its middle.
    alpha_n
        Normal pressure angle [rad].
    beta_m
        Mean spiral angle [rad]; > 0 right hand, < 0 left hand. The teeth are logarithmic spirals.
    x_hm
        Profile shift coefficient [-]; a positive one lengthens the addendum and thickens the tooth.
    x_sm
        Thickness modification coefficient [-].
    rack
        Basic rack of the generating crown gear, in mean normal modules.
    thickness_allowance
        Normal tooth thickness allowance at mid-face [m]; a negative one makes the tooth thinner.

    Raises
    ------
    GeometryError
        If a number is not finite or outside its range. `problems` lists what else makes the gear impossible.

    Examples
    --------
    KHK, technical data of bevel gears: straight, m_et = 3 mm, z = 20/40, 90 degrees.

    >>> gear = BevelGear.of_outer_module(z=20, m_et=3e-3, delta=math.atan(0.5), b=22e-3)
    >>> round(gear.R_e * 1e3, 5), round(math.degrees(gear.delta_a), 5), round(math.degrees(gear.delta_f), 5)
    (67.08204, 29.12569, 23.36545)
    """

    z: int
    m_mn: float
    delta: float
    b: float
    alpha_n: float = field(default=math.radians(20.0))
    beta_m: float = 0.0
    x_hm: float = 0.0
    x_sm: float = 0.0
    rack: BasicRack = field(default_factory=BasicRack)
    thickness_allowance: float = 0.0

    def __post_init__(self) -> None:
        z = whole_number(self.z)
        if z is None or not 3 <= z <= 1_000_000:
            raise GeometryError(
                "is not possible",
                where="number_of_teeth",
                value=f"{self.z!r}",
                limit="a whole number, 3 to 1e6",
            )
        object.__setattr__(self, "z", z)
        _number("mean_normal_module", self.m_mn, 1e-9, 1e3, "above 0 and below 1000 m")
        _number("pitch_cone_angle", self.delta, 1e-6, 0.5 * math.pi, "above 0 and below 90 deg")
        _number("normal_pressure_angle", self.alpha_n, 1e-3, 1.5, "0.001 to 1.5 rad")
        _number("spiral_angle", self.beta_m, -1.5, 1.5, "below 1.5 rad in magnitude")
        _number("profile_shift_coefficient", self.x_hm, -1e3, 1e3, "below 1000 in magnitude")
        _number("thickness_modification_coefficient", self.x_sm, -1e3, 1e3, "below 1000 in magnitude")
        limit = 1e3 * self.m_mn
        _number("tooth_thickness_allowance", self.thickness_allowance, -limit, limit, "below 1000 modules")
        _number("face_width", self.b, 0.0, 2.0 * self.R_m, "above 0, and the teeth end before the apex")

    @classmethod
    def of_outer_module(cls, *, z: int, m_et: float, delta: float, b: float, **others: Any) -> BevelGear:
        """Gear from the transverse module at its outer end.

        Parameters
        ----------
        z
            Number of teeth.
        m_et
            Outer transverse module [m].
        delta
            Pitch cone angle [rad].
        b
            Face width [m].
        **others
            The other fields of the class, unchanged.

        Raises
        ------
        GeometryError
            If a number is outside its range.

        Examples
        --------
        >>> round(BevelGear.of_outer_module(z=20, m_et=3e-3, delta=math.atan(0.5), b=22e-3).m_mn * 1e3, 6)
        2.508065
        """
        if (whole_number(z) or 0) < 3:
            raise GeometryError(
                "is not possible", where="number_of_teeth", value=f"{z!r}", limit="a whole number, 3 to 1e6"
            )
        _number("outer_transverse_module", m_et, 1e-9, 1e3, "above 0 and below 1000 m")
        _number("pitch_cone_angle", delta, 1e-6, 0.5 * math.pi, "above 0 and below 90 deg")
        outer = 0.5 * z * m_et / math.sin(delta)
        _number(
            "face_width", b, 0.0, outer, f"above 0 and below the outer cone distance, {1e3 * outer:.5g} mm"
        )
        mean = 1.0 - 0.5 * b / outer
        return cls(z=z, m_mn=m_et * mean * math.cos(others.get("beta_m", 0.0)), delta=delta, b=b, **others)

    def replace(self, **changes: Any) -> BevelGear:
        """Copy of the gear with some fields changed."""
        return replace(self, **changes)

    @property
    def hand(self) -> str:
        """Hand of the spiral: "right", "left", or "straight"."""
        return "straight" if self.beta_m == 0.0 else ("right" if self.beta_m > 0.0 else "left")

    # --- cone distances, modules, diameters -----------------------------------------------------------
    @cached_property
    def m_mt(self) -> float:
        """Mean transverse module m_mn / cos β_m [m]."""
        return self.m_mn / math.cos(self.beta_m)

    @property
    def m_n(self) -> float:
        """Normal module to which tooth sizes refer, m_mn [m]."""
        return self.m_mn

    @property
    def d_m(self) -> float:
        """Mean pitch diameter z m_mt [m]."""
        return self.z * self.m_mt

    @cached_property
    def R_m(self) -> float:
        """Mean cone distance d_m / (2 sin δ) [m]."""
        return 0.5 * self.z * self.m_mn / (math.cos(self.beta_m) * math.sin(self.delta))

    @property
    def R_e(self) -> float:
        """Outer cone distance R_m + b/2 [m]."""
        return self.R_m + 0.5 * self.b

    @property
    def R_i(self) -> float:
        """Inner cone distance R_m − b/2 [m]."""
        return self.R_m - 0.5 * self.b

    @property
    def d_e(self) -> float:
        """Outer pitch diameter 2 R_e sin δ [m]."""
        return 2.0 * self.R_e * math.sin(self.delta)

    @property
    def m_et(self) -> float:
        """Outer transverse module d_e / z [m]."""
        return self.d_e / self.z

    @property
    def d_ae(self) -> float:
        """Outside diameter d_e + 2 h_ae cos δ [m]."""
        return self.d_e + 2.0 * self.h_ae * math.cos(self.delta)

    @property
    def t_xo(self) -> float:
        """Distance from the apex to the crown (the outer tip) along the axis [m]."""
        return self.R_e * math.cos(self.delta) - self.h_ae * math.sin(self.delta)

    # --- heights and cones ----------------------------------------------------------------------------
    @property
    def h_am(self) -> float:
        """Mean addendum m_mn (h_aP* + x_hm) [m]."""
        return self.m_mn * (self.rack.h_aP_star + self.x_hm)

    @property
    def h_fm(self) -> float:
        """Mean dedendum m_mn (h_fP* − x_hm) [m]."""
        return self.m_mn * (self.rack.h_fP_star - self.x_hm)

    @property
    def h_ae(self) -> float:
        """Outer addendum R_e tan θ_a [m]."""
        return self.R_e * math.tan(self.theta_a)

    @property
    def h_fe(self) -> float:
        """Outer dedendum R_e tan θ_f [m]."""
        return self.R_e * math.tan(self.theta_f)

    @cached_property
    def theta_a(self) -> float:
        """Addendum angle θ_a, tan θ_a = h_am / R_m [rad]."""
        return math.atan(self.h_am / self.R_m)

    @cached_property
    def theta_f(self) -> float:
        """Dedendum angle θ_f, tan θ_f = h_fm / R_m [rad]."""
        return math.atan(self.h_fm / self.R_m)

    @property
    def delta_a(self) -> float:
        """Tip (face) cone angle δ + θ_a [rad]."""
        return self.delta + self.theta_a

    @property
    def delta_f(self) -> float:
        """Root cone angle δ − θ_f [rad]."""
        return self.delta - self.theta_f

    @cached_property
    def alpha_t(self) -> float:
        """Transverse pressure angle at the pitch cone, tan α_t = tan α_n / cos β_m [rad]."""
        return transverse_pressure_angle(self.alpha_n, self.beta_m)

    @cached_property
    def delta_b(self) -> float:
        """Base cone angle, sin δ_b = sin δ cos α_t [rad]."""
        return math.asin(math.sin(self.delta) * math.cos(self.alpha_t))

    @cached_property
    def beta_b(self) -> float:
        """Base spiral angle of the contact lines, tan β_b = tan β_m cos α_t [rad], signed."""
        return math.atan(math.tan(self.beta_m) * math.cos(self.alpha_t))

    @cached_property
    def spiral_rate(self) -> float:
        """Rotation of the tooth trace per unit of ln R, tan β_m / sin δ [rad]: equal on every cone."""
        return math.tan(self.beta_m) / math.sin(self.delta)

    def beta_at(self, delta_y: float) -> float:
        """Spiral angle on the cone δ_y, tan β_y = tan β_m sin δ_y / sin δ [rad]."""
        return math.atan(self.spiral_rate * math.sin(delta_y))

    def sigma_at(self, delta_y: float) -> float:
        """Roll angle at the cone δ_y, cos δ_y = cos δ_b cos σ_y [rad]; 0 below the base cone."""
        leg = math.sin(delta_y + self.delta_b) * math.sin(delta_y - self.delta_b)
        return math.atan2(math.sqrt(max(0.0, leg)), math.cos(delta_y))

    def cone_at(self, sigma: float) -> float:
        """Cone angle at the roll angle σ [rad], inverse of `sigma_at`."""
        return math.acos(math.cos(self.delta_b) * math.cos(sigma))

    @cached_property
    def sigma_p(self) -> float:
        """Base pitch as an angle in the plane of action, 2π sin δ_b / z [rad]."""
        return 2.0 * math.pi * math.sin(self.delta_b) / self.z

    @cached_property
    def sigma_w(self) -> float:
        """Roll angle at the pitch cone [rad]."""
        return self.sigma_at(self.delta)

    @cached_property
    def sigma_a(self) -> float:
        """Roll angle at the tip cone [rad]."""
        return self.sigma_at(self.delta_a)

    @property
    def sigma_Ff(self) -> float:
        """Roll angle at the root form cone [rad]; see `pitchpoint.geometry.bevel.tooth`."""
        from pitchpoint.geometry.bevel.tooth import bevel_tooth

        return bevel_tooth(self).sigma_form

    @property
    def undercut(self) -> bool:
        """True when the crown gear's tip cuts away part of the involute."""
        from pitchpoint.geometry.bevel.tooth import bevel_tooth

        return bevel_tooth(self).undercut

    # --- virtual cylindrical gear (Tredgold) ----------------------------------------------------------
    @property
    def z_v(self) -> float:
        """Virtual number of teeth z / cos δ [-], in general not an integer."""
        return self.z / math.cos(self.delta)

    @property
    def z_vn(self) -> float:
        """Virtual number of teeth in the normal section z_v / (cos² β_b cos β_m) [-]."""
        return self.z_v / (math.cos(self.beta_b) ** 2 * math.cos(self.beta_m))

    # --- tooth thickness ------------------------------------------------------------------------------
    @cached_property
    def s_mn(self) -> float:
        """Mean normal tooth thickness on the pitch cone, allowance included [m]."""
        nominal = self.m_mn * (
            0.5 * math.pi + 2.0 * (self.x_sm + self.x_hm * math.tan(self.alpha_n))
        )  # ISO 23509
        return nominal + self.thickness_allowance

    @property
    def s_mt(self) -> float:
        """Mean transverse tooth thickness s_mn / cos β_m as an arc of the pitch cone [m]."""
        return self.s_mn / math.cos(self.beta_m)

    @cached_property
    def psi_b(self) -> float:
        """Half angle of the tooth at the base cone, s_mt / d_m + θ(σ_w) [rad]."""
        return self.s_mt / self.d_m + spherical_involute(self.sigma_w, self.delta_b)

    def thickness_cause(self) -> tuple[str, str]:
        """Key with the largest effect on the tooth thickness, and its value as text."""
        shares = {
            "profile_shift_coefficient": (2.0 * self.x_hm * math.tan(self.alpha_n), f"{self.x_hm:g}"),
            "thickness_modification_coefficient": (2.0 * self.x_sm, f"{self.x_sm:g}"),
            "tooth_thickness_allowance": (
                self.thickness_allowance / self.m_mn,
                f"{1e3 * self.thickness_allowance:.6g} mm",
            ),
        }
        key = max(shares, key=lambda name: abs(shares[name][0]))
        return key, shares[key][1]

    def half_angle_at(self, delta_y: float) -> float:
        """Half angle of the tooth on the cone δ_y ≥ δ_b, between the involutes [rad]."""
        return self.psi_b - spherical_involute(self.sigma_at(delta_y), self.delta_b)

    def problems(self, where: str = "") -> list[Message]:
        """Everything that makes this gear impossible, each with value, limit and remedy.

        Parameters
        ----------
        where
            Path of the gear in the model, prefix of the key in each message.
        """
        from pitchpoint.geometry.bevel.problems import bevel_gear_problems

        return bevel_gear_problems(self, where)

    def warnings(self, where: str = "") -> list[Message]:
        """Unusual properties of this gear: wide face, thin tip, root radius too large for the tool tip."""
        from pitchpoint.geometry.bevel.problems import bevel_gear_warnings

        return bevel_gear_warnings(self, where)
