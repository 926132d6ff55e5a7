# SPDX-License-Identifier: Apache-2.0
"""Two bevel gears in mesh: plane of action, path of contact, contact ratios, backlash.

Both gears share one apex and roll on their pitch cones. The plane of action goes through the apex and is
tangent to both base cones. The angle σ of a ray in this plane is measured from the tangent ray of base
cone 1. Contact runs from A on the tip cone of gear 2 to E on the tip cone of gear 1. Contact lines of
straight teeth are rays; those of spiral teeth are logarithmic spirals, σ = σ₀ ± tan β_b1 ln(R/R_m), with +
on the left (counter-clockwise) flanks of gear 1 and − on the right flanks.

Derivation: docs/theory/bevel_gears.md, "A pair".
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

from pitchpoint.core.errors import GeometryError, Message
from pitchpoint.core.short_repr import ShortRepr
from pitchpoint.geometry.bevel.gear import BevelGear


@dataclass(frozen=True)
class BevelPair(ShortRepr):
    """A pair of bevel gears whose apexes coincide.

    Parameters
    ----------
    gear1, gear2
        The gears.
    Sigma
        Shaft angle Σ [rad], between the directions from the apex into both gears.

    Raises
    ------
    GeometryError
        If the shaft angle is not between 0 and π. `problems` lists what else makes the pair impossible.

    Examples
    --------
    >>> from pitchpoint.geometry.bevel.cones import pitch_angles
    >>> delta1, delta2 = pitch_angles(20, 40, math.radians(90.0))
    >>> one, two = (
    ...     BevelGear.of_outer_module(z=z, m_et=3e-3, delta=delta, b=22e-3)
    ...     for z, delta in ((20, delta1), (40, delta2)))
    >>> pair = BevelPair(one, two, math.radians(90.0))
    >>> round(pair.eps_alpha, 4), abs(pair.sigma_w - one.sigma_w) < 1e-15, pair.problems()
    (1.7137, True, [])
    """

    gear1: BevelGear
    gear2: BevelGear
    Sigma: float

    def __post_init__(self) -> None:
        if (
            isinstance(self.Sigma, bool)
            or not isinstance(self.Sigma, (int, float))
            or not 0.0 < self.Sigma < math.pi
        ):
            raise GeometryError(
                "is not possible",
                where="shaft_angle",
                value=f"{self.Sigma!r} rad",
                limit="above 0 and below 180 deg",
            )

    # --- common sizes ---------------------------------------------------------------------------------
    @property
    def u(self) -> float:
        """Gear ratio z₂ / z₁ [-]."""
        return self.gear2.z / self.gear1.z

    @property
    def R_m(self) -> float:
        """Mean cone distance of gear 1, to which the plane of action refers [m]."""
        return self.gear1.R_m

    @property
    def R_i(self) -> float:
        """Inner cone distance of the common face [m]."""
        return max(self.gear1.R_i, self.gear2.R_i)

    @property
    def R_e(self) -> float:
        """Outer cone distance of the common face [m]."""
        return min(self.gear1.R_e, self.gear2.R_e)

    @property
    def b(self) -> float:
        """Common face width [m]."""
        return max(0.0, self.R_e - self.R_i)

    @property
    def alpha_t(self) -> float:
        """Transverse pressure angle at the pitch cones [rad]."""
        return self.gear1.alpha_t

    @property
    def beta_b(self) -> float:
        """Base spiral angle of gear 1 [rad], signed; that of gear 2 is its negative."""
        return self.gear1.beta_b

    # --- path of contact, angles in the plane of action from the tangent ray of base cone 1 ------------
    @property
    def sigma_p(self) -> float:
        """Base pitch 2π sin δ_b1 / z₁ = 2π sin δ_b2 / z₂ [rad]."""
        return self.gear1.sigma_p

    @property
    def sigma_T(self) -> float:
        """Angle between the tangent rays of both base cones [rad]."""
        return self.gear1.sigma_w + self.gear2.sigma_w

    @property
    def sigma_w(self) -> float:
        """Angle of the pitch ray C [rad]."""
        return self.gear1.sigma_w

    @property
    def sigma_A(self) -> float:
        """Start of contact, on the tip cone of gear 2 [rad]; below 0 tip 2 reaches past the tangent ray."""
        return self.sigma_T - self.gear2.sigma_a

    @property
    def sigma_E(self) -> float:
        """End of contact, on the tip cone of gear 1 [rad]."""
        return self.gear1.sigma_a

    @property
    def eps_alpha(self) -> float:
        """Transverse contact ratio (σ_E − σ_A) / σ_p [-]; 0 without a path of contact."""
        return max(0.0, self.sigma_E - self.sigma_A) / self.sigma_p

    @property
    def eps_alpha_form(self) -> float:
        """Transverse contact ratio of the path A-E limited by the root form cones [-]."""
        low = max(self.sigma_A, self.gear1.sigma_Ff)
        high = min(self.sigma_E, self.sigma_T - self.gear2.sigma_Ff)
        return max(0.0, high - low) / self.sigma_p

    @property
    def eps_beta(self) -> float:
        """Overlap ratio tan |β_b| ln(R_e/R_i) / σ_p [-]."""
        if self.beta_b == 0.0 or self.b == 0.0:
            return 0.0
        return math.tan(abs(self.beta_b)) * math.log(self.R_e / self.R_i) / self.sigma_p

    @property
    def eps_gamma(self) -> float:
        """Total contact ratio ε_α + ε_β [-]."""
        return self.eps_alpha + self.eps_beta

    # --- backlash -------------------------------------------------------------------------------------
    @cached_property
    def sigma_j(self) -> float:
        """Backlash as an angle in the plane of action [rad]; negative if both flanks interfere."""
        thick = self.gear1.s_mt / self.gear1.R_m + self.gear2.s_mt / self.gear2.R_m
        pitch = 2.0 * math.pi * math.sin(self.gear1.delta) / self.gear1.z
        return (pitch - thick) * math.cos(self.alpha_t)

    @property
    def j_mt(self) -> float:
        """Mean circumferential backlash on the pitch cones [m]."""
        return self.R_m * self.sigma_j / math.cos(self.alpha_t)

    @property
    def j_mn(self) -> float:
        """Mean backlash normal to the flanks [m]."""
        return self.R_m * self.sigma_j * math.cos(self.beta_b)

    def mate_angle(self, angle1: float, ray1: float, ray2: float) -> float:
        """Azimuth of a tooth of gear 2 with equal backlash on both sides.

        Parameters
        ----------
        angle1
            Azimuth of a tooth of gear 1, on its pitch cone at its R_m [rad].
        ray1, ray2
            Azimuths of the pitch ray in the frames of both gears [rad].

        Returns
        -------
        float
            Azimuth of the tooth of gear 2 nearest to `ray2`, on its pitch cone at its own R_m [rad].

        Notes
        -----
        A tooth of gear 1 on the pitch ray is in a tooth space of gear 2. z₁ dθ₁ = −z₂ dθ₂, because both axes
        point away from the apex.

        Examples
        --------
        >>> miter = BevelGear(z=20, m_mn=2e-3, delta=0.25 * math.pi, b=5e-3)
        >>> pair = BevelPair(miter, miter, 0.5 * math.pi)
        >>> round(pair.mate_angle(0.1, 0.1, 0.0) * 20 / math.pi, 12)
        1.0
        """
        z1, z2 = self.gear1.z, self.gear2.z
        phase = math.remainder(math.pi - z1 * (angle1 - ray1), 2.0 * math.pi)
        # the azimuth of a spiral tooth depends on the cone distance
        return ray2 + phase / z2 + self.gear2.spiral_rate * math.log(self.gear2.R_m / self.gear1.R_m)

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
        from pitchpoint.geometry.bevel.problems import bevel_pair_problems

        return bevel_pair_problems(self, where, names, gears)

    def warnings(self, where: str = "", names: tuple[str, str] = ("gear 1", "gear 2")) -> list[Message]:
        """Unusual properties of a pair that can run: faces offset, tips below the mate's involute."""
        from pitchpoint.geometry.bevel.problems import bevel_pair_warnings

        return bevel_pair_warnings(self, where, names)
