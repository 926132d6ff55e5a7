# SPDX-License-Identifier: Apache-2.0
"""Air around a rotor, and the parts of blade-element momentum theory that are used."""

from __future__ import annotations

import math
from dataclasses import dataclass

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.geometry.rotor.tower import Tower

TOWER_SECTORS = 72
"""Number of azimuths over which the readers of files average the loads of a rotor with tower."""


@dataclass(frozen=True, kw_only=True)
class RotorFlow:
    """Air and options of the theory.

    Parameters
    ----------
    density
        Density of the air [kg/m³].
    shear_exponent
        Exponent of the power law of wind over height.
    yaw
        Angle of the rotor axis from the wind, positive counter-clockwise seen from above [rad].
    axial_induction, tangential_induction
        Whether the momentum of the air is balanced in these directions.
    drag_in_axial_induction, drag_in_tangential_induction
        Whether the drag contributes to this balance; `AIDrag` and `TIDrag` of AeroDyn.
    tip_loss, hub_loss
        Whether Prandtl's losses are used.
    skewed_wake
        Whether induction varies over the azimuth of a tilted or yawed rotor (Pitt and Peters).
    tower
        Tower whose potential flow changes the wind at the blades; None without.
    sectors
        Number of azimuths over which the loads are averaged; 1 is sufficient for axial flow,
        at least 36 are required with a tower. In models the azimuth is that of the blades, and it has no
        effect.

    Raises
    ------
    ModelError
        If a value is out of range.
    """

    density: float = 1.225
    shear_exponent: float = 0.0
    yaw: float = 0.0
    axial_induction: bool = True
    tangential_induction: bool = True
    drag_in_axial_induction: bool = True
    drag_in_tangential_induction: bool = True
    tip_loss: bool = True
    hub_loss: bool = True
    skewed_wake: bool = True
    tower: Tower | None = None
    sectors: int = 12

    def __post_init__(self) -> None:
        problems = []
        if not 0.0 < self.density < math.inf:
            problems.append(Message("flow.density", "is out of range", f"{self.density:g} kg/m^3", "> 0"))
        if not abs(self.yaw) <= math.pi:
            problems.append(Message("flow.yaw", "is out of range", f"{self.yaw:g} rad", "-pi to pi"))
        if not 0.0 <= self.shear_exponent < 1.0:
            shown = f"{self.shear_exponent:g}"
            problems.append(Message("flow.shear_exponent", "is out of range", shown, "0 to 1"))
        least = 1 if self.tower is None else 36
        if self.sectors < least:
            problems.append(Message("flow.sectors", "is out of range", str(self.sectors), f">= {least}"))
        if problems:
            raise ModelError(problems)
