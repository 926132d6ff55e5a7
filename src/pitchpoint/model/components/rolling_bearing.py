# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings with individual rolling elements, and plain bearings with clearance."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from pitchpoint.geometry.bearings.clearance import ALL_CLASSES
from pitchpoint.geometry.bearings.inner import TYPES
from pitchpoint.geometry.materials import Material
from pitchpoint.model.component import Component
from pitchpoint.model.components.bearing_fault import BEARING_FAULTS, BearingFault
from pitchpoint.model.components.bearing_geometry import ABSORPTION, GIVEN, BearingGeometry, bearing_geometry
from pitchpoint.model.keys import choice, derived, end, integer, key, positive, quantities, quantity, text

RINGS = (
    "inner and outer ring, each of them ground, a body or BODY.MARKER; the axis is z of the second. A ring "
    "on ground, or on the carrier of the other body, is where the other ring is. Instead of body"
)
BODY = "body whose shaft is in the bearing, instead of ends"
POSITION = (
    "centre of the bearing relative to the origin of body, on its axis: [0, 0, z]. With ends, for a ring on "
    "the carrier or on ground: relative to the other end"
)
HOUSING = "housing instead of ground: BODY, or BODY.MARKER at the bearing, such as a node of an elastic body"


@dataclass(frozen=True, kw_only=True)
class RollingBearing(Component):
    """Rolling bearing with individual rolling elements that orbit with the cage.

    Give a designation, or type and catalogue data, or type and rolling elements.
    """

    body: str | None = text(BODY, None, names="bodies", one_of="rings", later=True)
    position: tuple[float, float, float] = quantities(
        "length", POSITION, (0.0, 0.0, 0.0), length=(3, 3), later=True
    )
    housing: str | None = end(HOUSING, None, needs="body", later=True)
    ends: tuple[str, str] | None = key("ends", RINGS, None, length=(2, 2), one_of="rings")
    designation: str | None = text(
        "designation with suffixes, such as 6308-2RS/C3 or NU 208 ECP; `pitchpoint check` lists the data",
        None,
        later=True,
    )
    type: str | None = choice(
        (*GIVEN, *TYPES),
        "ball, roller: given rolling elements with point or line contact; the others: catalogue data",
        None,
        display="that of designation, otherwise ball",
    )
    inner_diameter: float | None = positive("length", "bore diameter d", None, also=("d",), later=True)
    outer_diameter: float | None = positive("length", "outside diameter D", None, also=("D",), later=True)
    width: float | None = positive(
        "length", "width B; tapered bearings: overall width T", None, also=("B", "T"), later=True
    )
    radial_dynamic_load_rating: float | None = positive(
        "force", "dynamic load rating C", None, also=("C", "C_r", "Cr"), later=True
    )
    radial_static_load_rating: float | None = positive(
        "force", "static load rating C0", None, also=("C0", "C_0", "C0r", "C_0r"), later=True
    )
    axial_clearance: float | None = quantity(
        "length",
        "axial play of a cylindrical roller bearing with flanges: total (NUP), or displacement until the "
        "flange touches (NJ)",
        None,
        minimum=0.0,
        display="middle of the range of the catalogue (NUP), 0 (NJ)",
        later=True,
    )
    flange_stiffness: float | None = positive(
        "stiffness",
        "axial stiffness of the flange contact of a cylindrical roller bearing",
        None,
        display="estimate from the rollers",
        later=True,
    )
    axial_force_absorption: str | None = choice(
        ABSORPTION,
        "axial force on the shaft that the bearing supports, along z of the bearing; no_direction: floating "
        "bearing. Angular contact, tapered and thrust bearings, NJ: positive or negative",
        None,
        display="both_directions; NU, N, needles and cylindrical rollers by data: no_direction; with given "
        "elements by the sign of contact_angle",
        later=True,
    )
    elements: int | None = integer("number of rolling elements of one row", None, minimum=2, maximum=10000)
    element_diameter: float | None = positive("length", "diameter of a rolling element", None)
    pitch_diameter: float | None = positive("length", "pitch diameter of the rolling elements", None)
    contact_angle: float | None = quantity(
        "angle",
        "contact angle; > 0 supports an inner ring that is loaded in +z; of catalogue bearings without sign. "
        "Tapered, spherical, self-aligning: arctan(e/1.5) of the catalogue",
        None,
        minimum=-1.5,
        maximum=1.5,
        display="that of designation, otherwise 0",
    )
    clearance: float | None = quantity(
        "length",
        "radial internal clearance (diametral) in operation; negative for preload",
        None,
        display="middle of clearance_class, 0 without a class",
    )
    clearance_class: str | None = choice(
        ALL_CLASSES,
        "class of the radial internal clearance before mounting: C2 to C4 of ISO 5753-1; deep groove ball "
        "bearings: MC1 to MC6 below a bore of 10 mm, CM (motors) from 10 to 80 mm",
        None,
        display="that of designation, otherwise CN: all but angular contact, tapered and thrust bearings",
        later=True,
    )
    preload: float | None = quantity(
        "force",
        "axial preload: axial force of the bearing as assembled, with the shaft in position; 0: adjusted "
        "without play",
        None,
        minimum=0.0,
        later=True,
    )
    preload_distance: float | None = quantity(
        "length",
        "axial preload: displacement of the outer ring towards the shaft's load, with clearance < 0",
        None,
        later=True,
    )
    grooves: tuple[float, float] | None = quantities(
        "dimensionless",
        "ball: groove radius over ball diameter of inner and outer ring, > 0.5",
        None,
        length=(2, 2),
        minimum=0.5,
        above=True,
        sample="[0.52, 0.52]",
        display="[0.52, 0.53] for catalogue bearings; thrust 0.54 each; self-aligning 0.53 and the sphere",
    )
    effective_length: float | None = positive("length", "roller: effective (load-carrying) length", None)
    slices: int = integer(
        "number of slices of a roller with an effective length, for tilting and load distribution",
        21,
        minimum=1,
        maximum=1000,
        later=True,
    )
    material: Material | str = key(
        "material", "name in materials or in the library, or the properties", "steel"
    )
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
    given: Any = derived()
    """The bearing as given, if its housing is that of the model."""

    @property
    def former_values(self) -> dict[str, str | float]:
        """Values of empty keys before there were bearings of a catalogue, for the hash of the model."""
        given = self.designation is None and self.type in (None, *GIVEN)
        return {"type": "ball", "contact_angle": 0.0, "clearance": 0.0} if given else {}

    @cached_property
    def geometry(self) -> BearingGeometry:
        """Complete geometry: as given, of the catalogue and estimated.

        Raises
        ------
        GeometryError
            With the first problem, at the key of the component.
        """
        return bearing_geometry(self)


@dataclass(frozen=True, kw_only=True)
class PlainBearing(Component):
    """Plain bearing: the journal moves freely within the clearance."""

    body: str | None = text(BODY, None, names="bodies", one_of="rings", later=True)
    position: tuple[float, float, float] = quantities(
        "length", POSITION, (0.0, 0.0, 0.0), length=(3, 3), later=True
    )
    housing: str | None = end(HOUSING, None, needs="body", later=True)
    ends: tuple[str, str] | None = key(
        "ends", "journal and bore, as for a rolling bearing", None, length=(2, 2), one_of="rings"
    )
    clearance: float = positive("length", "diametral clearance: bore diameter less journal diameter")
    stiffness: float = positive(
        "dimensionless", "contact constant in SI [N/m^exponent]: force over penetration^exponent"
    )
    exponent: float = quantity("dimensionless", "exponent of the penetration", 1.0, minimum=1.0)
    damping: float = quantity(
        "dimensionless", "damping force over elastic force, per approach velocity [s/m]", 0.0, minimum=0.0
    )
    given: Any = derived()
    """The bearing as given, if its housing is that of the model."""
