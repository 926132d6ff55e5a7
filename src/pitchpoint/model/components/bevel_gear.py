# SPDX-License-Identifier: Apache-2.0
"""A bevel gear in terms of its drawing data, and its conversion to `BevelGear` of `geometry`."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from pitchpoint.model.component import Component
from pitchpoint.model.components.gear import Rack
from pitchpoint.model.components.tooth_faults import BEVEL_FAULTS, BevelFault
from pitchpoint.model.keys import choice, component, integer, key, positive, quantity

if TYPE_CHECKING:
    from pitchpoint.geometry.bevel import gear as bevel_gear
    from pitchpoint.geometry.bevel.blank import BevelBlank
    from pitchpoint.geometry.materials import Material


@dataclass(frozen=True, kw_only=True)
class BevelGear(Component):
    """A straight or spiral bevel gear with spherical involute flanks; all its cones share one apex.

    Angles in rad, lengths in m.
    """

    number_of_teeth: int = integer("number of teeth z", minimum=3, maximum=10000)
    mean_normal_module: float | None = positive(
        "length", "normal module m_mn in the middle of the face", None, maximum=1.0, one_of="module"
    )
    outer_transverse_module: float | None = positive(
        "length",
        "transverse module m_et at the outer end, instead of mean_normal_module",
        None,
        maximum=1.0,
        one_of="module",
    )
    pitch_cone_angle: float | None = quantity(
        "angle",
        "pitch cone angle delta, instead of mate_teeth",
        None,
        one_of="cone",
        minimum=math.radians(0.1),
        maximum=math.radians(89.9),
        sample="26.565051 deg",
    )
    mate_teeth: int | None = integer(
        "number of teeth of the mating gear; with shaft_angle it gives the pitch cone angle",
        None,
        one_of="cone",
        minimum=3,
        maximum=10000,
    )
    shaft_angle: float = quantity(
        "angle",
        "shaft angle of the pair, used with mate_teeth",
        math.radians(90.0),
        minimum=math.radians(1.0),
        maximum=math.radians(179.0),
        display="90 deg",
    )
    normal_pressure_angle: float = quantity(
        "angle",
        "normal pressure angle alpha_n",
        math.radians(20.0),
        minimum=math.radians(5.0),
        maximum=math.radians(45.0),
        display="20 deg",
    )
    spiral_angle: float = quantity(
        "angle",
        "spiral angle beta_m in the middle of the face; 0 for straight teeth",
        0.0,
        minimum=0.0,
        maximum=math.radians(60.0),
    )
    hand: str | None = choice(
        ("left", "right"),
        "hand of the spiral; required when spiral_angle > 0. Right: seen from the apex the teeth curve "
        "clockwise from inside to outside",
        None,
    )
    face_width: float = positive("length", "face width b along the pitch cone", maximum=10.0)
    profile_shift_coefficient: float = quantity(
        "dimensionless", "profile shift coefficient x_hm", 0.0, minimum=-5.0, maximum=5.0
    )
    thickness_modification_coefficient: float = quantity(
        "dimensionless", "thickness modification coefficient x_sm", 0.0, minimum=-1.0, maximum=1.0
    )
    tooth_thickness_allowance: float = quantity(
        "length", "normal tooth thickness allowance in the middle of the face, < 0 is thinner", 0.0
    )
    rack: Rack = component(Rack, "basic rack of the crown gear, in mean normal modules", Rack())
    opens: str = choice(
        ("+z", "-z"), "direction in which the pitch cone opens, along the z axis of its body", "+z"
    )
    initial_angle: float | None = quantity(
        "angle",
        "angle from the x axis of the body to the centre of tooth 0 in the middle of the face, at zero spin",
        None,
        display="assembled in mesh",
    )
    faults: Mapping[str, BevelFault] = key(
        "components", "tooth faults, by label", {}, isolated=True, of=BEVEL_FAULTS
    )
    rim_thickness: float | None = positive(
        "length",
        "rim thickness behind the tooth root, along the back cone",
        None,
        display="whole depth of the outer end",
    )
    bore_diameter: float = quantity(
        "length",
        "bore (0: none); of a gear on a shaft only the part outside the sections of the shaft has mass",
        0.0,
        minimum=0.0,
    )
    material: Material | str = key(
        "material", "name in materials or in the library, or the properties", "steel"
    )
    mass: float | None = quantity("mass", "mass of the gear", None, minimum=0.0, display="from geometry")
    polar_inertia: float | None = quantity(
        "inertia", "moment of inertia about the axis", None, minimum=0.0, display="from geometry"
    )
    transverse_inertia: float | None = quantity(
        "inertia",
        "moment of inertia about a diameter through the centre of mass",
        None,
        minimum=0.0,
        display="from geometry",
    )
    drawing_resolution: int | None = integer(
        "points per flank in drawings and solid models",
        None,
        minimum=5,
        maximum=10000,
        display="20 in files, chords within 1 µm in the scene",
    )

    @property
    def tooth_faults(self) -> dict[str, BevelFault]:
        """Faults of the teeth, by label."""
        return dict(self.faults)

    @property
    def teeth_differ(self) -> bool:
        """Whether the teeth may differ from each other."""
        return bool(self.faults)

    @property
    def beta_m(self) -> float:
        """Mean spiral angle, > 0 right hand, < 0 left hand [rad]."""
        return -self.spiral_angle if self.hand == "left" else self.spiral_angle

    @property
    def direction(self) -> float:
        """Direction from the apex into the gear along the z axis of its body, +1 or −1."""
        return -1.0 if self.opens == "-z" else 1.0

    @property
    def delta(self) -> float:
        """Pitch cone angle [rad], as given or from the number of teeth of the mating gear."""
        if self.pitch_cone_angle is not None or self.mate_teeth is None:
            return self.pitch_cone_angle or 0.0
        from pitchpoint.geometry.bevel.cones import pitch_angles

        return pitch_angles(self.number_of_teeth, self.mate_teeth, self.shaft_angle)[0]

    @cached_property
    def geometry(self) -> bevel_gear.BevelGear:
        """Macro-geometry with signs (beta_m > 0 for right hand)."""
        from pitchpoint.geometry.bevel.gear import BevelGear as Geometry
        from pitchpoint.geometry.rack import BasicRack

        sizes = {
            "z": self.number_of_teeth,
            "delta": self.delta,
            "b": self.face_width,
            "alpha_n": self.normal_pressure_angle,
            "beta_m": self.beta_m,
            "x_hm": self.profile_shift_coefficient,
            "x_sm": self.thickness_modification_coefficient,
            "thickness_allowance": self.tooth_thickness_allowance,
            "rack": BasicRack(
                h_aP_star=self.rack.addendum,
                h_fP_star=self.rack.dedendum,
                rho_fP_star=self.rack.root_radius,
            ),
        }
        if self.mean_normal_module is not None:
            return Geometry(m_mn=self.mean_normal_module, **sizes)  # type: ignore[arg-type]
        return Geometry.of_outer_module(m_et=self.outer_transverse_module or 0.0, **sizes)  # type: ignore[arg-type]

    @property
    def blank(self) -> BevelBlank:
        """Blank: the gear body without teeth."""
        from pitchpoint.geometry.bevel.blank import bevel_blank

        return bevel_blank(self.geometry, self.bore_diameter, self.rim_thickness)

    @property
    def material_data(self) -> Material:
        """Material properties, from the library if given by name."""
        from pitchpoint.geometry.materials import Material, material

        return self.material if isinstance(self.material, Material) else material(self.material)
