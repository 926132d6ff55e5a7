# SPDX-License-Identifier: Apache-2.0
"""Faults of how a gear sits on its body: eccentric or wobbling."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, TypeAlias

from pitchpoint.model.keys import quantity

SEVERITY = "share of the fault that is there: 0 is healthy"


@dataclass(frozen=True, kw_only=True)
class Eccentricity:
    """Teeth whose axis is offset from the axis of rotation; the mass of the body stays where it is."""

    form: ClassVar[str] = "eccentricity"
    amount: float = quantity(
        "length", "distance of both axes, half the runout; severity scales it", minimum=0.0
    )
    phase: float = quantity("angle", "where to, from the centre of tooth 0", 0.0)
    severity: float = quantity("dimensionless", SEVERITY, 1.0, minimum=0.0, maximum=1.0)


@dataclass(frozen=True, kw_only=True)
class Wobble:
    """Teeth whose axis is tilted against the axis of rotation, both through the middle of the face."""

    form: ClassVar[str] = "wobble"
    amount: float = quantity("angle", "angle between both axes; severity scales it", minimum=0.0, maximum=0.1)
    phase: float = quantity("angle", "direction of the tilt on the way up z, from the centre of tooth 0", 0.0)
    severity: float = quantity("dimensionless", SEVERITY, 1.0, minimum=0.0, maximum=1.0)


SeatFault: TypeAlias = Eccentricity | Wobble

SEAT_FAULTS: dict[str, type] = {c.form: c for c in (Eccentricity, Wobble)}
