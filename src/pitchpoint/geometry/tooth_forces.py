# SPDX-License-Identifier: Apache-2.0
"""Components of the tooth force at the operating pitch circle, from the torque on gear 1, without friction.

Cylindrical gears (ISO 21771 quantities): F_wt = 2 T_1/d_w1, F_wr = F_wt tan alpha_wt, F_a = F_wt tan beta_w.
The trace of a right-handed tooth on the pitch cylinder is r phi = z tan beta_w. The force is normal to it: an
counter-clockwise F_wt comes with the axial force -F_wt tan beta_w, on both flanks.

Bevel gears at the mean cone distance (ISO 23509 quantities): F_mt = 2 T_1/d_m1. The component normal to the
pitch cone is F_mt tan alpha_n/cos beta_m, that along its generator F_mt tan beta_m; the pitch angle resolves
both.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pitchpoint.geometry.bevel.pair import BevelPair
    from pitchpoint.geometry.gear_pair import GearPair


@dataclass(frozen=True)
class ToothForce:
    """Force on a gear at the operating pitch point.

    Attributes
    ----------
    tangential
        Anticlockwise about the axis of the gear [N].
    radial
        Away from the mating gear: towards the axis of an external gear [N].
    axial
        Along z of a cylindrical gear; away from the apex of a bevel gear [N].
    """

    tangential: float
    radial: float
    axial: float

    @property
    def normal(self) -> float:
        """Resultant [N]."""
        return math.sqrt(self.tangential**2 + self.radial**2 + self.axial**2)


def tooth_force(pair: GearPair, T_1: float) -> ToothForce:
    """Force on gear 1 of a cylindrical pair; that on gear 2 is opposite.

    Parameters
    ----------
    pair
        The pair at its centre distance.
    T_1
        Torque of the mesh on gear 1 [N m], counter-clockwise positive.

    Examples
    --------
    A spur pair: F_r = F_t tan 20 deg.

    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> one, two = CylindricalGear(z=20, m_n=5e-3), CylindricalGear(z=40, m_n=5e-3)
    >>> force = tooth_force(GearPair.at_distance(one, two, 0.15), -100.0)
    >>> round(force.tangential, 6), round(force.radial, 4), force.axial
    (-2000.0, 727.9405, 0.0)
    """
    F_wt = 2.0 * T_1 / abs(pair.d_w1)
    F_wr = abs(F_wt) * math.tan(pair.alpha_wt)
    return ToothForce(F_wt, F_wr, -F_wt * math.tan(pair.beta_w) + 0.0)


def bevel_force(pair: BevelPair, T_1: float, *, gear: int = 1) -> ToothForce:
    """Force on a gear of a bevel pair at the mean cone distance.

    Parameters
    ----------
    pair
        The pair.
    T_1
        Torque of the mesh on gear 1 [N m], counter-clockwise seen from the direction into which its pitch
        cone opens.
    gear
        1 or 2.

    Examples
    --------
    Straight teeth at 90 deg: the axial force on gear 1 is the radial force on gear 2.

    >>> from pitchpoint.geometry.bevel.cones import pitch_angles
    >>> from pitchpoint.geometry.bevel.gear import BevelGear
    >>> from pitchpoint.geometry.bevel.pair import BevelPair
    >>> delta1, delta2 = pitch_angles(20, 40, math.radians(90.0))
    >>> one, two = (
    ...     BevelGear.of_outer_module(z=z, m_et=3e-3, delta=delta, b=22e-3)
    ...     for z, delta in ((20, delta1), (40, delta2)))
    >>> pair = BevelPair(one, two, math.radians(90.0))
    >>> on_1, on_2 = (bevel_force(pair, 100.0, gear=k) for k in (1, 2))
    >>> abs(on_1.axial / on_2.radial - 1.0) < 1e-12, abs(on_1.radial / on_2.axial - 1.0) < 1e-12
    (True, True)
    """
    F_mt = 2.0 * T_1 / pair.gear1.d_m
    one = pair.gear1 if gear == 1 else pair.gear2
    across = abs(F_mt) * math.tan(one.alpha_n) / math.cos(one.beta_m)
    # both gears turn about axes that point into them from the common apex: the torques have equal signs
    tangential = F_mt
    along = -tangential * math.tan(one.beta_m)
    return ToothForce(
        tangential,
        across * math.cos(one.delta) - along * math.sin(one.delta),
        across * math.sin(one.delta) + along * math.cos(one.delta),
    )
