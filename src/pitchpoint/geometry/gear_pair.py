# SPDX-License-Identifier: Apache-2.0
"""Two gears in mesh: working geometry, path of contact, contact ratios, backlash (ISO 21771).

Gear 1 is external. With an internal gear 2 the centre distance and the diameters of gear 2 are negative.
Path coordinates start at T1, the foot of gear 1's base tangent; contact runs from its root A to its tip E.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from numbers import Real

from pitchpoint.core.errors import GeometryError, Message
from pitchpoint.core.short_repr import ShortRepr
from pitchpoint.geometry.backlash import Backlash, backlash_at
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.involute import inv
from pitchpoint.geometry.profile_shift import (
    center_distance_for_profile_shift,
    pressure_angle_at_center_distance,
    reference_center_distance,
)


def _leg(diameter: float, d_b: float) -> float:
    """Length of the base tangent up to a circle, ½ √(d² − d_b²); zero below the base circle [m]."""
    return 0.5 * math.sqrt(max(0.0, diameter * diameter - d_b * d_b))


@dataclass(frozen=True)
class GearPair(ShortRepr):
    """A pair of cylindrical gears on parallel axes at a given centre distance.

    Parameters
    ----------
    gear1
        Pinion (external).
    gear2
        Wheel; external, or internal with z < 0.
    a_w
        Working centre distance [m]; negative with an internal gear (see `at_distance` for a positive one).

    Raises
    ------
    GeometryError
        If the centre distance is not finite, is zero or has the wrong sign. `problems` lists what else makes
        the pair impossible; properties that are then undefined raise GeometryError.

    Examples
    --------
    ISO/TR 6336-30, example 1:

    >>> from math import radians
    >>> from pitchpoint.geometry.rack import BasicRack
    >>> rack = BasicRack(h_fP_star=1.4, rho_fP_star=0.39)
    >>> pinion = CylindricalGear(
    ...     z=17, m_n=8e-3, beta=-radians(15.8), x=0.145, b=0.1, tip_diameter=0.15966, rack=rack)
    >>> wheel = CylindricalGear(
    ...     z=103, m_n=8e-3, beta=radians(15.8), x=0.0, b=0.1, tip_diameter=0.87235, rack=rack)
    >>> pair = GearPair(pinion, wheel, 0.5)
    >>> round(pair.eps_alpha, 6), round(pair.eps_beta, 6), round(pair.j_bt * 1e6, 3)
    (1.54909, 1.083369, 1.257)
    """

    gear1: CylindricalGear
    gear2: CylindricalGear
    a_w: float

    def __post_init__(self) -> None:
        a_w = self.a_w
        if isinstance(a_w, bool) or not isinstance(a_w, Real) or not 1e-12 < abs(a_w) < 1e9:
            limit, size = "finite, not zero", f"{a_w!r} m"
            raise GeometryError("is not possible", where="center_distance", value=size, limit=limit)
        if a_w * self._sign <= 0.0:
            at, limit = "center_distance", "negative with an internal gear, positive otherwise"
            remedy = "GearPair.at_distance takes it positive"
            raise GeometryError(
                "has the wrong sign", where=at, value=f"{a_w!r} m", limit=limit, remedy=remedy
            )

    @classmethod
    def at_distance(cls, gear1: CylindricalGear, gear2: CylindricalGear, distance: float) -> GearPair:
        """Pair at a centre distance given as a positive length [m], whether gear 2 is internal or not.

        Raises
        ------
        GeometryError
            If the distance is not above 0.

        Examples
        --------
        >>> sun, ring = CylindricalGear(z=16, m_n=3e-3), CylindricalGear.internal(z=24, m_n=3e-3, x=-0.5)
        >>> GearPair.at_distance(sun, ring, 0.0131683).a_w
        -0.0131683
        """
        if isinstance(distance, bool) or not distance > 0.0:
            raise GeometryError("is not above 0", where="center_distance", value=f"{distance!r} m")
        internal = gear1.is_internal or gear2.is_internal
        return cls(gear1, gear2, -distance if internal else distance)

    @classmethod
    def from_profile_shifts(cls, gear1: CylindricalGear, gear2: CylindricalGear) -> GearPair:
        """Pair at the centre distance of zero backlash for the nominal profile shifts.

        Thickness allowances are not included; they give the backlash at this distance. GeometryError if the
        shifts are too negative for any centre distance.

        Examples
        --------
        >>> pair = GearPair.from_profile_shifts(
        ...     CylindricalGear(z=12, m_n=3e-3, x=0.6), CylindricalGear(z=24, m_n=3e-3, x=0.36))
        >>> round(pair.a_w * 1e3, 4)
        56.4999
        """
        g, x_sum = gear1, gear1.x + gear2.x
        a_w = center_distance_for_profile_shift(
            z_sum=g.z + gear2.z, m_n=g.m_n, alpha_n=g.alpha_n, beta=g.beta, x_sum=x_sum
        )
        return cls(gear1, gear2, a_w)

    def at_center_distance(self, a: float) -> GearPair:
        """The same gears at another (signed) centre distance [m]."""
        return replace(self, a_w=a)

    @property
    def _sign(self) -> int:
        return -1 if self.gear1.is_internal or self.gear2.is_internal else 1

    @property
    def is_internal(self) -> bool:
        """True when gear 2 is internal."""
        return self.gear2.is_internal

    @property
    def z_sum(self) -> int:
        """z₁ + z₂, signed."""
        return self.gear1.z + self.gear2.z

    @property
    def u(self) -> float:
        """Gear ratio z₂/z₁ [-]; negative with an internal gear."""
        return self.gear2.z / self.gear1.z

    @cached_property
    def a_d(self) -> float:
        """Reference centre distance [m]."""
        return reference_center_distance(self.z_sum, self.gear1.m_n, self.gear1.beta)

    @cached_property
    def alpha_wt(self) -> float:
        """Working transverse pressure angle at `a_w` [rad]."""
        return self.working_pressure_angle(self.a_w)

    def working_pressure_angle(self, a: float) -> float:
        """Transverse pressure angle at another centre distance (signed) [rad]."""
        g = self.gear1
        return pressure_angle_at_center_distance(
            z_sum=self.z_sum, m_n=g.m_n, alpha_n=g.alpha_n, beta=g.beta, a_w=a
        )

    @cached_property
    def inv_alpha_w0(self) -> float:
        """inv α_w0 at zero backlash for the given profile shifts, without thickness allowances.

        Raises
        ------
        GeometryError
            If an internal gear has as many teeth as its pinion.
        """
        if self.z_sum == 0:
            raise GeometryError(
                "have the same number of teeth",
                where="gears",
                value="pinion and internal gear",
                limit="z2 above z1",
                remedy="give the internal gear more teeth",
            )
        g = self.gear1
        return inv(g.alpha_t) + 2.0 * self.x_sum_given * math.tan(g.alpha_n) / self.z_sum

    @cached_property
    def x_sum(self) -> float:
        """Sum of the profile shifts for zero backlash at `a_w` [-]."""
        g = self.gear1
        return 0.5 * self.z_sum * (inv(self.alpha_wt) - inv(g.alpha_t)) / math.tan(g.alpha_n)

    @property
    def x_sum_given(self) -> float:
        """Sum of the profile shifts of the gears [-]."""
        return self.gear1.x + self.gear2.x

    @cached_property
    def d_w1(self) -> float:
        """Working pitch diameter of gear 1, d_b1 / cos α_wt [m]."""
        return self.gear1.d_b / math.cos(self.alpha_wt)

    @cached_property
    def d_w2(self) -> float:
        """Working pitch diameter of gear 2, d_b2 / cos α_wt [m], signed."""
        return self.gear2.d_b / math.cos(self.alpha_wt)

    @property
    def beta_w(self) -> float:
        """Helix angle at the working pitch cylinder of gear 1 [rad]."""
        return math.atan(math.tan(self.gear1.beta_b) / math.cos(self.alpha_wt))

    @property
    def b_w(self) -> float:
        """Common face width of two gears mounted without offset [m]."""
        return min(self.gear1.b, self.gear2.b)

    @property
    def p_et(self) -> float:
        """Transverse pitch on the path of contact [m]."""
        return self.gear1.p_bt

    @cached_property
    def T1T2(self) -> float:
        """Signed length of the common base tangent, a_w sin α_wt [m]; negative with an internal gear."""
        return self.a_w * math.sin(self.alpha_wt)

    @cached_property
    def T1A(self) -> float:
        """Start of contact A, at the tip circle of gear 2 [m].

        Only the tip circles count, as in the standard; for root form circles see `eps_alpha_form`.
        """
        return self.T1T2 - self.gear2.sign * _leg(self.gear2.d_Fa, self.gear2.d_b)

    @cached_property
    def T1E(self) -> float:
        """End of contact E, at the tip circle of gear 1 [m]."""
        return _leg(self.gear1.d_Fa, self.gear1.d_b)

    @cached_property
    def T1A_form(self) -> float:
        """Lowest path coordinate on the involute of gear 1, at its root form circle [m]."""
        return _leg(self.gear1.d_Ff, self.gear1.d_b)

    @cached_property
    def T1E_form(self) -> float:
        """Highest path coordinate on the involute of gear 2, at its root form circle [m]."""
        return self.T1T2 - self.gear2.sign * _leg(self.gear2.d_Ff, self.gear2.d_b)

    @property
    def T1B(self) -> float:
        """Point B, T1E − p_et [m]: single contact starts, as the preceding tooth pair leaves at E."""
        return self.T1E - self.p_et

    @cached_property
    def T1C(self) -> float:
        """Pitch point, r_b1 tan α_wt [m]."""
        return self.gear1.r_b * math.tan(self.alpha_wt)

    @property
    def T1D(self) -> float:
        """Point D, T1A + p_et [m]: single contact ends, as the next tooth pair enters at A."""
        return self.T1A + self.p_et

    @property
    def g_alpha(self) -> float:
        """Length of the path of contact A-E [m]; 0 without contact."""
        return max(0.0, self.T1E - self.T1A)

    @property
    def g_f(self) -> float:
        """Path of approach A-C with gear 1 driving [m]."""
        return self.T1C - self.T1A

    @property
    def g_a(self) -> float:
        """Path of recess C-E with gear 1 driving [m]."""
        return self.T1E - self.T1C

    @property
    def d_Nf1(self) -> float:
        """Root diameter of gear 1's active profile [m]."""
        return math.hypot(self.gear1.d_b, 2.0 * max(0.0, self.T1A))

    @property
    def d_Nf2(self) -> float:
        """Root diameter of gear 2's active profile [m], signed."""
        leg = self.T1T2 - self.T1E if self.is_internal else max(0.0, self.T1T2 - self.T1E)
        return self.gear2.sign * math.hypot(self.gear2.d_b, 2.0 * leg)

    @property
    def d_Na1(self) -> float:
        """Tip diameter of gear 1's active profile [m]."""
        return math.hypot(self.gear1.d_b, 2.0 * self.T1E)

    @property
    def d_Na2(self) -> float:
        """Tip diameter of gear 2's active profile [m], signed."""
        return self.gear2.sign * math.hypot(self.gear2.d_b, 2.0 * (self.T1T2 - self.T1A))

    @property
    def eps_alpha(self) -> float:
        """Transverse contact ratio g_α / p_et [-]."""
        return self.g_alpha / self.p_et

    @property
    def eps_alpha_form(self) -> float:
        """Transverse contact ratio of the path A-E limited by the root form circles [-]."""
        usable = min(self.T1E, self.T1E_form) - max(self.T1A, self.T1A_form)
        return max(0.0, usable) / self.p_et

    @property
    def eps_beta(self) -> float:
        """Overlap ratio b_w sin |β| / (π m_n) [-]."""
        return self.b_w * math.sin(abs(self.gear1.beta)) / self.gear1.p_n

    @property
    def eps_gamma(self) -> float:
        """Total contact ratio ε_α + ε_β [-]."""
        return self.eps_alpha + self.eps_beta

    @property
    def eps_1(self) -> float:
        """Addendum contact ratio of gear 1, g_a / p_et [-]."""
        return self.g_a / self.p_et

    @property
    def eps_2(self) -> float:
        """Addendum contact ratio of gear 2, g_f / p_et [-]."""
        return self.g_f / self.p_et

    @property
    def l_min(self) -> float:
        """Smallest total length of the contact lines over a mesh cycle [m].

        The number of teeth in contact, averaged over ε_β base pitches, is at least ε_α less n_α n_β / ε_β
        or (1 − n_α)(1 − n_β) / ε_β, with n the fractional parts (ISO/TR 13989, KISSsoft's Lmin).
        """
        eps_alpha, eps_beta = self.eps_alpha, self.eps_beta
        n_alpha = eps_alpha - math.floor(eps_alpha)
        if eps_beta == 0.0:
            return math.floor(eps_alpha) * self.b_w
        n_beta = eps_beta - math.floor(eps_beta)
        lost = n_alpha * n_beta if n_alpha + n_beta <= 1.0 else (1.0 - n_alpha) * (1.0 - n_beta)
        return self.b_w * (eps_alpha - lost / eps_beta) / math.cos(self.gear1.beta_b)

    def backlash(self, a: float) -> Backlash:
        """Backlash at another centre distance, signed like `a_w` [m]; see `backlash_at`."""
        return backlash_at(self, a)

    @cached_property
    def _backlash(self) -> Backlash:
        return self.backlash(self.a_w)

    @property
    def j_bt(self) -> float:
        """Backlash along the base tangent, transverse [m]."""
        return self._backlash.j_bt

    @property
    def j_wt(self) -> float:
        """Circumferential backlash on the working pitch circles [m]."""
        return self._backlash.j_wt

    @property
    def j_bn(self) -> float:
        """Normal backlash [m]."""
        return self._backlash.j_bn

    @property
    def c_1(self) -> float:
        """Tip clearance of gear 1 against the root of gear 2 (nominal root diameter) [m]."""
        return self.a_w - 0.5 * (self.gear1.d_a + self.gear2.d_f)

    @property
    def c_2(self) -> float:
        """Tip clearance of gear 2 against the root of gear 1 (nominal root diameter) [m]."""
        return self.a_w - 0.5 * (self.gear2.d_a + self.gear1.d_f)

    def problems(
        self, where: str = "", names: tuple[str, str] = ("gear 1", "gear 2"), gears: bool = True
    ) -> list[Message]:
        """Everything that makes this pair impossible, each with value, limit and remedy.

        Parameters
        ----------
        where
            Path of the pair in the model, prefix of the key in each message.
        names
            Names of the gears in the messages.
        gears
            Also list the problems of each gear alone.
        """
        from pitchpoint.geometry.problems import pair_problems

        return pair_problems(self, where, names, gears)

    def warnings(self, where: str = "", names: tuple[str, str] = ("gear 1", "gear 2")) -> list[Message]:
        """Unusual properties of a pair that can run, such as tips below the mate's root form circle."""
        from pitchpoint.geometry.problems import pair_warnings

        return pair_warnings(self, where, names)
