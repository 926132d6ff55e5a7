# SPDX-License-Identifier: Apache-2.0
"""One cylindrical involute gear: everything that follows from its defining data (ISO 21771).

External gears have z > 0, internal gears z < 0, and then every diameter is negative too. Lengths in
metres, angles in radians; β > 0 is a right hand.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import GeometryError, Message
from pitchpoint.geometry.form_diameter import root_form_diameter_internal, root_form_diameter_rack
from pitchpoint.geometry.involute import base_helix_angle, inv, transverse_pressure_angle
from pitchpoint.geometry.rack import BasicRack

if TYPE_CHECKING:
    from pitchpoint.geometry.cutter import PinionCutter
    from pitchpoint.geometry.tooth_outline import ToothOutline


def _refuse(where: str, value: object, limit: str, remedy: str | None = None) -> GeometryError:
    return GeometryError("is not possible", where=where, value=f"{value!r}", limit=limit, remedy=remedy)


def _number(where: str, value: object, low: float, high: float, limit: str) -> None:
    """Refuse booleans, NaN and everything outside the open interval."""
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not low < value < high:
        raise _refuse(where, value, limit)


@dataclass(frozen=True, kw_only=True)
class CylindricalGear:
    """An external or internal, spur or helical involute gear.

    Parameters
    ----------
    z
        Number of teeth; negative for an internal gear (see `internal` for positive arguments).
    m_n
        Normal module [m].
    alpha_n
        Normal pressure angle [rad].
    beta
        Helix angle at the reference cylinder [rad]; > 0 right hand, < 0 left hand.
    x
        Profile shift coefficient [-]. For internal gears with ISO 21771's sign: x > 0 makes the tooth
        thicker and moves its tip towards the axis (KHK tables use the opposite sign).
    b
        Face width [m].
    rack
        Basic rack.
    tip_diameter
        Tip diameter [m], signed like z; None takes d + 2 m_n (h_aP* + x) + 2 `tip_alteration`.
    tip_alteration
        Radial lengthening of the tooth, k m_n [m]; negative shortens it, for internal gears too.
    thickness_allowance
        Normal thickness allowance A_sn at the reference circle [m]; negative makes the tooth thinner.
    root_diameter
        Root diameter [m], signed like z; None takes d − 2 m_n (h_fP* − x), or what the cutter leaves.
    cutter
        Pinion-type cutter of an internal gear, or None.
    outline
        Points of a real tooth (`pitchpoint.geometry.tooth_outline`) for drawings, mass and contact, or None
        for the generated one. Everything else, stiffness too, is that of the generated tooth.

    Raises
    ------
    GeometryError
        If a number is not finite or has no meaning (m_n ≤ 0, |β| ≥ π/2 ...). What merely makes a bad gear
        is listed by `problems`.

    Examples
    --------
    >>> gear = CylindricalGear(z=17, m_n=0.008, beta=-math.radians(15.8), x=0.145, b=0.1)
    >>> round(gear.d_b * 1e3, 6), gear.hand
    (132.198569, 'left')
    """

    z: int
    m_n: float
    alpha_n: float = field(default=math.radians(20.0))
    beta: float = 0.0
    x: float = 0.0
    b: float = 0.01
    rack: BasicRack = field(default_factory=BasicRack)
    tip_diameter: float | None = None
    tip_alteration: float = 0.0
    thickness_allowance: float = 0.0
    root_diameter: float | None = None
    cutter: PinionCutter | None = None
    outline: ToothOutline | None = None

    def __post_init__(self) -> None:
        if isinstance(self.z, bool) or not isinstance(self.z, int) or not 1 <= abs(self.z) <= 1_000_000:
            raise _refuse("number_of_teeth", self.z, "a whole number, 1 to 1e6")
        # The outer bounds are far beyond any gear; they only keep floating-point arithmetic meaningful.
        _number("normal_module", self.m_n, 1e-9, 1e3, "above 0 and below 1000 m")
        _number("normal_pressure_angle", self.alpha_n, 1e-3, 1.5, "0.001 to 1.5 rad")
        _number("helix_angle", self.beta, -1.5, 1.5, "below 1.5 rad in magnitude")
        _number("profile_shift_coefficient", self.x, -1e3, 1e3, "below 1000 in magnitude")
        _number("face_width", self.b, 0.0, 1e6, "above 0")
        for where, length in (
            ("tip_alteration", self.tip_alteration),
            ("tooth_thickness_allowance", self.thickness_allowance),
        ):
            _number(where, length, -1e3 * self.m_n, 1e3 * self.m_n, "below 1000 modules in magnitude")
        for where, diameter in (("tip_diameter", self.tip_diameter), ("root_diameter", self.root_diameter)):
            if diameter is None:
                continue
            _number(where, diameter, -1e9, 1e9, "finite")
            if diameter * self.sign <= 0.0:
                raise _refuse(
                    where,
                    diameter,
                    "the sign of z",
                    "give internal gears negative diameters, or use CylindricalGear.internal",
                )

    @classmethod
    def internal(
        cls,
        *,
        z: int,
        m_n: float,
        tip_diameter: float | None = None,
        root_diameter: float | None = None,
        **others: Any,
    ) -> CylindricalGear:
        """Internal gear from a positive number of teeth and positive diameters.

        Parameters
        ----------
        z
            Number of teeth, > 0.
        m_n
            Normal module [m].
        tip_diameter, root_diameter
            Diameters [m], > 0, or None.
        **others
            The other fields of the class, unchanged (x keeps ISO 21771's sign).

        Examples
        --------
        >>> CylindricalGear.internal(z=56, m_n=0.045, x=-0.5013).d
        -2.52
        """
        return cls(
            z=-z,
            m_n=m_n,
            tip_diameter=None if tip_diameter is None else -tip_diameter,
            root_diameter=None if root_diameter is None else -root_diameter,
            **others,
        )

    def replace(self, **changes: Any) -> CylindricalGear:
        """Copy of the gear with some fields changed."""
        return replace(self, **changes)

    # --- kind -----------------------------------------------------------------------------------------
    @property
    def sign(self) -> int:
        """+1 for an external, −1 for an internal gear."""
        return 1 if self.z > 0 else -1

    @property
    def is_internal(self) -> bool:
        """True for an internal gear."""
        return self.z < 0

    @property
    def hand(self) -> str:
        """Hand of the helix: "right", "left", or "spur"."""
        return "spur" if self.beta == 0.0 else ("right" if self.beta > 0.0 else "left")

    # --- angles and pitches ---------------------------------------------------------------------------
    @cached_property
    def alpha_t(self) -> float:
        """Transverse pressure angle α_t [rad]."""
        return transverse_pressure_angle(self.alpha_n, self.beta)

    @cached_property
    def beta_b(self) -> float:
        """Base helix angle β_b [rad], signed like β."""
        return base_helix_angle(self.alpha_n, self.beta)

    @cached_property
    def m_t(self) -> float:
        """Transverse module m_t = m_n / cos β [m]."""
        return self.m_n / math.cos(self.beta)

    @property
    def p_n(self) -> float:
        """Normal pitch π m_n [m]."""
        return math.pi * self.m_n

    @property
    def p_t(self) -> float:
        """Transverse pitch π m_t on the reference circle [m]."""
        return math.pi * self.m_t

    @cached_property
    def p_bt(self) -> float:
        """Transverse base pitch p_t cos α_t [m]."""
        return self.p_t * math.cos(self.alpha_t)

    @property
    def p_et(self) -> float:
        """Transverse pitch on the path of contact, equal to the base pitch [m]."""
        return self.p_bt

    @property
    def p_bn(self) -> float:
        """Normal base pitch p_bt cos β_b = p_n cos α_n [m]."""
        return self.p_n * math.cos(self.alpha_n)

    @property
    def p_z(self) -> float:
        """Lead of the helix, π |d| / tan |β| [m]; infinite for a spur gear."""
        return math.inf if self.beta == 0.0 else math.pi * abs(self.d) / math.tan(abs(self.beta))

    @cached_property
    def z_n(self) -> float:
        """Virtual number of teeth z / (cos² β_b cos β) [-], signed."""
        return self.z / (math.cos(self.beta_b) * math.cos(self.beta_b) * math.cos(self.beta))

    # --- diameters ------------------------------------------------------------------------------------
    @cached_property
    def d(self) -> float:
        """Reference diameter z m_t [m]."""
        return self.z * self.m_t

    @cached_property
    def d_b(self) -> float:
        """Base diameter d cos α_t [m]."""
        return self.d * math.cos(self.alpha_t)

    @property
    def r_b(self) -> float:
        """Base radius d_b / 2 [m]."""
        return 0.5 * self.d_b

    @cached_property
    def d_a(self) -> float:
        """Tip diameter [m]: as given, or d + 2 m_n (h_aP* + x) + 2 `tip_alteration`."""
        if self.tip_diameter is not None:
            return float(self.tip_diameter)
        return self.d + 2.0 * (self.m_n * (self.rack.h_aP_star + self.x) + self.tip_alteration)

    @cached_property
    def d_f(self) -> float:
        """Root diameter [m]: as given, as the cutter leaves it, or d − 2 m_n (h_fP* − x).

        The nominal profile shift counts here; what reducing the tooth thickness adds in depth is in `d_fE`.
        """
        return self._root_diameter(self.x)

    @cached_property
    def d_fE(self) -> float:
        """Root diameter that the tool leaves when it also makes the thickness allowance [m]."""
        return self._root_diameter(self.x_E)

    def _root_diameter(self, x: float) -> float:
        if self.root_diameter is not None:
            return float(self.root_diameter)
        if self.is_internal and self.cutter is not None:
            return self._shaped(x)[1]
        return self.d - 2.0 * self.m_n * (self.rack.h_fP_star - x)

    @cached_property
    def d_Fa(self) -> float:
        """Tip form diameter [m]: the tip; the base circle if an internal tip lies inside it."""
        return min(self.d_a, self.d_b) if self.is_internal else self.d_a

    @property
    def d_Ff(self) -> float:
        """Root form diameter, where the usable involute ends [m].

        External gears are generated by a rack with the tip radius ρ_fP*, undercut included. Internal gears
        are shaped by `cutter`; without one a circular fillet of radius ρ_fP* m_n touches flank and root,
        the cautious limit of a cutter with as many teeth as the gear.
        """
        return self._root_form[0]

    @property
    def undercut(self) -> bool:
        """True when the tool tip cuts away part of the involute."""
        return self._root_form[1]

    @cached_property
    def h_fP_star(self) -> float:
        """Dedendum coefficient in effect: of the rack, or what `root_diameter` makes of it."""
        if self.root_diameter is None:
            return self.rack.h_fP_star
        return (self.d - self.root_diameter) / (2.0 * self.m_n) + self.x_E

    @cached_property
    def x_min(self) -> float:
        """Smallest profile shift without undercut by the rack, h_FfP* − z sin² α_t / (2 cos β) [-]."""
        sin_alpha_t = math.sin(self.alpha_t)
        straight = self.rack.h_FfP_star(self.alpha_n)
        return straight - 0.5 * self.z * sin_alpha_t * sin_alpha_t / math.cos(self.beta)

    @cached_property
    def _root_form(self) -> tuple[float, bool]:
        if self.is_internal:
            return self._shaped(self.x_E, None if self.cutter is not None else self.d_fE)[0], False
        return root_form_diameter_rack(
            z=self.z,
            m_n=self.m_n,
            alpha_n=self.alpha_n,
            beta=self.beta,
            x_E=self.x_E,
            h_fP_star=self.h_fP_star,
            rho_fP_star=self.rack.rho_fP_star,
        )

    def _shaped(self, x: float, d_f: float | None = None) -> tuple[float, float]:
        """Root form and root diameter of an internal gear made with the generating shift x."""
        return root_form_diameter_internal(
            z=self.z,
            m_n=self.m_n,
            alpha_n=self.alpha_n,
            beta=self.beta,
            x_E=x,
            cutter=self.cutter,
            d_f=self.root_diameter if d_f is None else d_f,
            rho_fP_star=self.rack.rho_fP_star,
        )

    # --- tooth thickness ------------------------------------------------------------------------------
    @cached_property
    def x_E(self) -> float:
        """Generating profile shift coefficient x + A_sn / (2 m_n tan α_n) [-]."""
        return self.x + self.thickness_allowance / (2.0 * self.m_n * math.tan(self.alpha_n))

    @cached_property
    def s_n(self) -> float:
        """Normal tooth thickness on the reference cylinder, allowance included [m]."""
        return self.m_n * (0.5 * math.pi + 2.0 * self.x * math.tan(self.alpha_n)) + self.thickness_allowance

    @property
    def s_t(self) -> float:
        """Transverse tooth thickness on the reference circle [m]."""
        return self.s_n / math.cos(self.beta)

    @property
    def e_n(self) -> float:
        """Normal space width on the reference cylinder [m]."""
        return self.p_n - self.s_n

    @property
    def e_t(self) -> float:
        """Transverse space width on the reference circle [m]."""
        return self.p_t - self.s_t

    @cached_property
    def psi_b(self) -> float:
        """Half angle of the tooth at the base circle, s_t/d + inv α_t [rad].

        Signed like d for internal gears, so that d_b ψ_b is the transverse thickness at the base circle.
        """
        return self.s_t / self.d + inv(self.alpha_t)

    # --- judgement ------------------------------------------------------------------------------------
    def problems(self, where: str = "") -> list[Message]:
        """Everything that makes this gear impossible, each with value, limit and remedy.

        Parameters
        ----------
        where
            Place of the gear in its description, put before the name of the offending key.
        """
        from pitchpoint.geometry.problems import gear_problems

        return gear_problems(self, where)

    def warnings(self, where: str = "") -> list[Message]:
        """What is odd about this gear: a root radius without room."""
        from pitchpoint.geometry.problems import gear_warnings

        return gear_warnings(self, where)
