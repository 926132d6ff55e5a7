# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings with their rolling elements, and plain bearings with clearance."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from pitchpoint.geometry.materials import Material
from pitchpoint.model.components.bearing_fault import BEARING_FAULTS, BearingFault
from pitchpoint.model.keys import choice, integer, key, positive, quantities, quantity

RINGS = "inner and outer ring, each of them ground, a body or BODY.MARKER; the axis is z of the second"


@dataclass(frozen=True, kw_only=True)
class RollingBearing:
    """Rolling bearing whose elements are carried round between its rings."""

    ends: tuple[str, str] = key("ends", RINGS, length=(2, 2))
    type: str = choice(("ball", "roller"), "ball: point contact; roller: line contact", "ball")
    elements: int = integer("number of rolling elements of one row", minimum=2, maximum=10000)
    element_diameter: float = positive("length", "diameter of a rolling element")
    pitch_diameter: float = positive("length", "diameter of the circle of their centres")
    contact_angle: float = quantity(
        "angle",
        "contact angle; positive carries an inner ring that is pushed along z",
        0.0,
        minimum=-1.5,
        maximum=1.5,
    )
    clearance: float = quantity("length", "radial internal clearance; negative for a preload", 0.0)
    grooves: tuple[float, float] | None = quantities(
        "dimensionless",
        "ball: radii of the grooves of inner and outer ring over the ball diameter, > 0.5",
        None,
        length=(2, 2),
        minimum=0.5,
        above=True,
        sample="[0.52, 0.52]",
    )
    effective_length: float | None = positive("length", "roller: length that carries", None)
    material: Material | str = key("material", "name in the library or its properties", "steel")
    stiffness: float | None = positive(
        "dimensionless",
        "force of one element at one metre of approach in SI [N/m^1.5, N/m^(10/9)], instead of grooves or "
        "effective_length",
        None,
        display="by Hertz (ball) or Palmgren (roller)",
    )
    damping: float = quantity(
        "dimensionless", "share of the force per speed of approach [s/m]", 0.0, minimum=0.0
    )
    faults: Mapping[str, BearingFault] = key(
        "components", "its faults by name", {}, isolated=True, of=BEARING_FAULTS
    )


@dataclass(frozen=True, kw_only=True)
class PlainBearing:
    """Plain bearing whose journal is free inside its clearance."""

    ends: tuple[str, str] = key("ends", "journal and bore, as for a rolling bearing", length=(2, 2))
    clearance: float = positive("length", "diameter of the bore less that of the journal")
    stiffness: float = positive(
        "dimensionless", "force at one metre beyond the clearance in SI [N/m^exponent]"
    )
    exponent: float = quantity("dimensionless", "exponent of the force", 1.0, minimum=1.0)
    damping: float = quantity(
        "dimensionless", "share of the force per speed of approach [s/m]", 0.0, minimum=0.0
    )
