# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings with individual rolling elements, and plain bearings with clearance."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from pitchpoint.geometry.materials import Material
from pitchpoint.model.components.bearing_fault import BEARING_FAULTS, BearingFault
from pitchpoint.model.keys import choice, integer, key, positive, quantities, quantity

RINGS = "inner and outer ring, each of them ground, a body or BODY.MARKER; the axis is z of the second"


@dataclass(frozen=True, kw_only=True)
class RollingBearing:
    """Rolling bearing with individual rolling elements that orbit with the cage."""

    ends: tuple[str, str] = key("ends", RINGS, length=(2, 2))
    type: str = choice(("ball", "roller"), "ball: point contact; roller: line contact", "ball")
    elements: int = integer("number of rolling elements of one row", minimum=2, maximum=10000)
    element_diameter: float = positive("length", "diameter of a rolling element")
    pitch_diameter: float = positive("length", "pitch diameter of the rolling elements")
    contact_angle: float = quantity(
        "angle",
        "contact angle; > 0 supports an inner ring that is loaded in +z",
        0.0,
        minimum=-1.5,
        maximum=1.5,
    )
    clearance: float = quantity("length", "radial internal clearance; negative for preload", 0.0)
    grooves: tuple[float, float] | None = quantities(
        "dimensionless",
        "ball: groove radius over ball diameter of inner and outer ring, > 0.5",
        None,
        length=(2, 2),
        minimum=0.5,
        above=True,
        sample="[0.52, 0.52]",
    )
    effective_length: float | None = positive("length", "roller: effective (load-carrying) length", None)
    material: Material | str = key("material", "name in the material library, or the properties", "steel")
    stiffness: float | None = positive(
        "dimensionless",
        "contact constant of one element in SI [N/m^1.5, N/m^(10/9)], instead of grooves or effective_length",
        None,
        display="by Hertz (ball) or Palmgren (roller)",
    )
    damping: float = quantity(
        "dimensionless", "damping force over elastic force, per approach velocity [s/m]", 0.0, minimum=0.0
    )
    faults: Mapping[str, BearingFault] = key(
        "components", "faults by name", {}, isolated=True, of=BEARING_FAULTS
    )


@dataclass(frozen=True, kw_only=True)
class PlainBearing:
    """Plain bearing: the journal moves freely within the clearance."""

    ends: tuple[str, str] = key("ends", "journal and bore, as for a rolling bearing", length=(2, 2))
    clearance: float = positive("length", "diametral clearance: bore diameter less journal diameter")
    stiffness: float = positive(
        "dimensionless", "contact constant in SI [N/m^exponent]: force over penetration^exponent"
    )
    exponent: float = quantity("dimensionless", "exponent of the penetration", 1.0, minimum=1.0)
    damping: float = quantity(
        "dimensionless", "damping force over elastic force, per approach velocity [s/m]", 0.0, minimum=0.0
    )
