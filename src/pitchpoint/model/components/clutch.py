# SPDX-License-Identifier: Apache-2.0
"""Clutches between two bodies and brakes on ground."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.components.law import Law
from pitchpoint.model.keys import ends, key, positive, quantity


@dataclass(frozen=True, kw_only=True)
class Clutch:
    """Dry friction about the common axis of two bodies, smooth at the change of its sense."""

    bodies: tuple[str, str] = ends("two bodies; with ground as the second: a brake", length=(2, 2))
    capacity: Law = key(
        "law",
        "torque of fast sliding, >= 0: a quantity, or a formula, table or function as for a torque; 0: open",
        dimension="torque",
    )
    static_ratio: float = quantity("dimensionless", "static over sliding friction", 1.0, minimum=1.0)
    stribeck_speed: float = positive(
        "angular_speed", "speed over which friction falls from static to sliding", 1.0
    )
    slip_speed: float = positive(
        "angular_speed", "speed at which friction is fully there; what should stick creeps slower", 0.1
    )
