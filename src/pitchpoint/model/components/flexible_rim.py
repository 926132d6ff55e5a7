# SPDX-License-Identifier: Apache-2.0
"""Flexible rim of an internal gear: bending modes in its plane, and supports around its circumference."""

from __future__ import annotations

import math
from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.keys import component, integer, quantities, quantity

MAX_WAVES = 16
"""Largest number of waves of a ring mode."""


@dataclass(frozen=True, kw_only=True)
class RimSupports(Component):
    """Equal springs between the rim and its housing: bolts, pins, splines or a press fit."""

    number: int | None = integer(
        "number of supports, at equal angles", None, minimum=1, maximum=1000, one_of="places"
    )
    first_angle: float = quantity(
        "angle", "with number: angle of the first support from the x axis of the body", 0.0
    )
    angles: tuple[float, ...] | None = quantities(
        "angle",
        "angles of the supports from the x axis of the body, counter-clockwise",
        None,
        length=(1, 1000),
        one_of="places",
        sample="[0 deg, 90 deg, 180 deg, 270 deg]",
    )
    radial: float = quantity("stiffness", "radial stiffness of one support", 0.0, minimum=0.0)
    tangential: float = quantity("stiffness", "tangential stiffness of one support", 0.0, minimum=0.0)

    @property
    def places(self) -> tuple[float, ...]:
        """Angles of all supports [rad]."""
        if self.angles is not None:
            return self.angles
        count = self.number or 0
        return tuple(self.first_angle + math.tau * k / count for k in range(count))


@dataclass(frozen=True, kw_only=True)
class FlexibleRim(Component):
    """Bending of the rim in its plane, in modes of n = 2, 3, ... waves around the circumference."""

    waves: int = integer(
        "largest number of waves n of the modes; each n has two modes", 6, minimum=2, maximum=MAX_WAVES
    )
    damping_ratio: float = quantity(
        "dimensionless", "damping ratio of every mode", 0.0, minimum=0.0, maximum=1.0
    )
    supports: RimSupports | None = component(
        RimSupports, "springs between the rim and the housing; default: the rim is held only by its body"
    )

    @property
    def coordinates(self) -> int:
        """Number of modes."""
        return 2 * (self.waves - 1)
