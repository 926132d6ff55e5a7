# SPDX-License-Identifier: Apache-2.0
"""Flexible rim of an internal gear: bending modes in its plane, and supports around its circumference."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.components.marker import Marker
from pitchpoint.model.keys import component, integer, key, positive, quantities, quantity

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
class RimElements(Component):
    """Finite elements of the rim: z axis of the file along the axis of the gear, origin in its middle."""

    file: str = key(
        "file",
        "matrices of the unsupported rim: a NumPy archive (.npz) with K, M and places, or a Nastran punch "
        "file; in SI units",
    )
    held_nodes: Mapping[str, Marker] = key(
        "components",
        "nodes that are fixed to the body, by name, with positions in the axes of the file",
        of=Marker,
    )
    modes: int = integer(
        "number of modes with these nodes fixed: those with the largest compliance at the teeth, of three "
        "times as many lowest ones",
        12,
        minimum=1,
        maximum=30,
    )
    depth: float = positive(
        "dimensionless",
        "nodes from the tip circle to this depth below the root circle, in modules, follow the teeth",
        1.0,
    )


@dataclass(frozen=True, kw_only=True)
class FlexibleRim(Component):
    """Bending of the rim in modes of n = 2, 3, ... waves around the circumference, or of finite elements."""

    waves: int = integer(
        "largest number of waves n of the modes, two of each n; with finite_elements of their deflection",
        6,
        minimum=2,
        maximum=MAX_WAVES,
    )
    damping_ratio: float = quantity(
        "dimensionless", "damping ratio of every mode", 0.0, minimum=0.0, maximum=1.0
    )
    supports: RimSupports | None = component(
        RimSupports, "springs between the rim and the housing; default: the rim is held only by its body"
    )

    finite_elements: RimElements | None = component(
        RimElements, "modes from finite elements; default: those of a ring in closed form"
    )

    @property
    def coordinates(self) -> int:
        """Number of modes."""
        return 2 * (self.waves - 1) if self.finite_elements is None else self.finite_elements.modes
