# SPDX-License-Identifier: Apache-2.0
"""Faults of the gear seat: eccentric and wobbling gears."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, TypeAlias

from pitchpoint.model.component import Component
from pitchpoint.model.keys import quantity

SEVERITY = "severity: 0 healthy, 1 the given size"


@dataclass(frozen=True, kw_only=True)
class Eccentricity(Component):
    """Eccentric gear: tooth axis offset from the axis of rotation; the mass of the body is not displaced."""

    form: ClassVar[str] = "eccentricity"
    amount: float = quantity(
        "length",
        "distance between the axes, half the runout; scaled by severity",
        minimum=0.0,
        sample="0.02 mm",
    )
    phase: float = quantity("angle", "direction of the offset, measured from the centre of tooth 0", 0.0)
    severity: float = quantity("dimensionless", SEVERITY, 1.0, minimum=0.0, maximum=1.0)


@dataclass(frozen=True, kw_only=True)
class Wobble(Component):
    """Wobbling gear: tooth axis tilted relative to the axis of rotation, about the middle of the face."""

    form: ClassVar[str] = "wobble"
    amount: float = quantity(
        "angle", "angle between the axes; scaled by severity", minimum=0.0, maximum=0.1, sample="0.05 deg"
    )
    phase: float = quantity(
        "angle", "direction of the tilt towards positive z, measured from the centre of tooth 0", 0.0
    )
    severity: float = quantity("dimensionless", SEVERITY, 1.0, minimum=0.0, maximum=1.0)


SeatFault: TypeAlias = Eccentricity | Wobble

SEAT_FAULTS: dict[str, type] = {c.form: c for c in (Eccentricity, Wobble)}
