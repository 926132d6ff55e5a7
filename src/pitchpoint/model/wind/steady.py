# SPDX-License-Identifier: Apache-2.0
"""Steady wind: speed at hub height, profile over the height, directions.

Frame of all wind: x downwind at direction 0, y to the left for a view downwind, z upward from the ground.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from pitchpoint.model.wind.ranges import Ranges

PROFILES = ("uniform", "power", "logarithmic")


@dataclass(frozen=True, kw_only=True)
class SteadyWind:
    """Wind that depends on the height only.

    The speed is V(z) = V_hub (z/z_hub)^alpha for the power law and V(z) = V_hub ln(z/z_0)/ln(z_hub/z_0) for
    the logarithmic law (IEC 61400-1:2005, 6.3.1.2 and 11.2); it is zero at and below the ground.

    Parameters
    ----------
    speed
        Speed at hub height V_hub [m/s].
    hub_height
        Height of the hub z_hub [m].
    profile
        "power", "logarithmic" or "uniform".
    exponent
        Exponent of the power law; 0.2 in the normal wind profile of IEC 61400-1.
    roughness_length
        Roughness length of the logarithmic law z_0 [m].
    inflow_angle
        Angle of the wind above the horizontal plane [rad], the same at all heights.
    direction
        Direction of the wind at hub height [rad], from x towards y, counter-clockwise seen from above.
    veer
        Change of the direction with the height [rad/m].

    Examples
    --------
    >>> wind = SteadyWind(speed=12.0, hub_height=90.0, profile="logarithmic", roughness_length=0.03)
    >>> wind.profile
    'logarithmic'
    """

    speed: float
    hub_height: float
    profile: str = "power"
    exponent: float = 0.2
    roughness_length: float = 0.03
    inflow_angle: float = 0.0
    direction: float = 0.0
    veer: float = 0.0

    def __post_init__(self) -> None:
        found = Ranges("steady wind")
        found.choice("profile", self.profile, PROFILES)
        found.within("speed", self.speed, 0.0, 150.0, "m/s")
        hub = found.within("hub_height", self.hub_height, 1.0, 1000.0, "m")
        found.within("exponent", self.exponent, -1.0, 1.0, "")
        highest = 0.5 * self.hub_height if hub else 10.0
        found.within("roughness_length", self.roughness_length, 1e-6, highest, "m")
        found.within("inflow_angle", self.inflow_angle, -0.5, 0.5, "rad")
        found.within("direction", self.direction, -2.0 * math.pi, 2.0 * math.pi, "rad")
        found.within("veer", self.veer, -0.1, 0.1, "rad/m")
        found.finish()
