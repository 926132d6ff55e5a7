# SPDX-License-Identifier: Apache-2.0
"""A cylindrical gear in terms of its drawing data, and its conversion to `CylindricalGear` of `geometry`."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from pitchpoint.model.component import Component
from pitchpoint.model.components.flexible_rim import FlexibleRim
from pitchpoint.model.components.gear_faults import SEAT_FAULTS, SeatFault
from pitchpoint.model.components.modifications import Deviations, Modifications
from pitchpoint.model.components.solid import SolidReference
from pitchpoint.model.components.tooth_faults import FAULTS, ToothFault
from pitchpoint.model.components.tooth_profile import ToothProfile
from pitchpoint.model.keys import choice, component, derived, integer, key, positive, quantity

if TYPE_CHECKING:
    from pitchpoint.geometry.cutter import PinionCutter
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    from pitchpoint.geometry.mass_properties import MassProperties, ShaftPiece
    from pitchpoint.geometry.materials import Material


@dataclass(frozen=True, kw_only=True)
class Rack(Component):
    """Basic rack of the gear (counterpart of the cutting rack), in modules."""

    addendum: float = positive("dimensionless", "addendum h_aP*", 1.0, maximum=5.0)
    dedendum: float = positive("dimensionless", "dedendum h_fP*", 1.25, maximum=5.0)
    root_radius: float = quantity(
        "dimensionless", "root fillet radius rho_fP*", 0.38, minimum=0.0, maximum=2.0
    )


@dataclass(frozen=True, kw_only=True)
class Cutter(Component):
    """Pinion-type cutter that generates an internal gear."""

    number_of_teeth: int = integer("number of teeth of the cutter", minimum=3, maximum=10000)
    profile_shift_coefficient: float = quantity(
        "dimensionless", "profile shift coefficient of the cutter", 0.0
    )
    addendum: float = positive("dimensionless", "addendum of the cutter in modules", 1.25, maximum=5.0)
    tip_radius: float = quantity("dimensionless", "tip rounding in modules", 0.38, minimum=0.0, maximum=2.0)


@dataclass(frozen=True, kw_only=True)
class Gear(Component):
    """A cylindrical involute gear.

    Angles in rad, lengths in m. All diameters and the number of teeth are positive, for internal gears too;
    `geometry` has the signs of ISO 21771.
    """

    type: str = choice(("external", "internal"), "teeth outside or inside", "external")
    number_of_teeth: int = integer(
        "number of teeth z, positive for internal gears too", minimum=3, maximum=10000
    )
    normal_module: float = positive("length", "normal module m_n", maximum=1.0)
    normal_pressure_angle: float = quantity(
        "angle",
        "normal pressure angle alpha_n",
        math.radians(20.0),
        minimum=math.radians(5.0),
        maximum=math.radians(45.0),
        display="20 deg",
    )
    helix_angle: float = quantity(
        "angle", "helix angle beta at the reference cylinder", 0.0, minimum=0.0, maximum=math.radians(60.0)
    )
    hand: str | None = choice(("left", "right"), "hand of the helix; required when helix_angle > 0", None)
    profile_shift_coefficient: float | None = quantity(
        "dimensionless",
        "profile shift coefficient x, sign of ISO 21771; one gear of a pair with center_distance may omit it",
        None,
        minimum=-5.0,
        maximum=5.0,
        display="zero backlash at center_distance",
    )
    face_width: float = positive("length", "face width b", maximum=10.0)
    tip_diameter: float | None = positive("length", "tip diameter d_a", None, display="from the rack")
    root_diameter: float | None = positive("length", "root diameter d_f", None, display="from the rack")
    tip_alteration: float = quantity("length", "tip alteration k m_n, < 0 shortens the teeth", 0.0)
    tip_chamfer: float | None = quantity(
        "length",
        "radial height h_K of a 45 deg chamfer of the tip edges; the involute ends at d_Fa = d_a - 2 h_K, on "
        "internal gears at d_a + 2 h_K",
        None,
        minimum=0.0,
        display="sharp tip edges",
        later=True,
    )
    tip_rounding: float | None = quantity(
        "length",
        "radius of rounded tip edges in the transverse section, tangent to flank and tip circle; instead of "
        "tip_chamfer",
        None,
        minimum=0.0,
        display="sharp tip edges",
        later=True,
    )
    tooth_thickness_allowance: float = quantity(
        "length", "normal tooth thickness allowance A_sn at the reference circle, < 0 is thinner", 0.0
    )
    rack: Rack = component(Rack, "basic rack in modules", Rack())
    cutter: Cutter | None = component(Cutter, "pinion-type cutter of an internal gear")
    initial_angle: float | None = quantity(
        "angle",
        "angle from the x axis of the body to the centre of tooth 0 at zero spin",
        None,
        display="assembled in mesh",
    )
    rim_thickness: float | None = positive("length", "rim thickness below the teeth", None, display="solid")
    web_thickness: float | None = positive("length", "web thickness", None, display="face width")
    flexible_rim: FlexibleRim | None = component(
        FlexibleRim,
        "bending modes of the rim of an internal gear; default: the rim is rigid, apart from the compliance "
        "of the teeth",
        later=True,
    )
    bore_diameter: float = quantity(
        "length",
        "bore of an external gear, outside diameter of an internal gear; 0: not given. Of a gear on a shaft "
        "only the part outside the sections of the shaft has mass",
        0.0,
        minimum=0.0,
        display="none; elastic wheel bodies are clamped at half the root diameter, rings behind the rim",
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
        "moment of inertia about a diameter through the centre",
        None,
        minimum=0.0,
        display="from geometry",
    )
    solid: SolidReference | None = component(
        SolidReference, "solid whose mass and inertia replace those from geometry"
    )
    drawing_resolution: int | None = integer(
        "points per flank in drawings and solid models",
        None,
        minimum=5,
        maximum=10000,
        display="20 in files, chords within 1 µm in the scene",
    )
    modifications: Modifications | None = component(Modifications, "flank modifications by side")
    deviations: Deviations | None = component(Deviations, "deviations of single teeth")
    faults: Mapping[str, ToothFault | SeatFault] = key(
        "components",
        "faults of the teeth and of the seat, by label",
        {},
        isolated=True,
        of={**FAULTS, **SEAT_FAULTS},
    )
    tooth_profile: ToothProfile | None = key(
        "tooth_profile", "measured or calculated points of the tooth, from a file", None, of=ToothProfile
    )
    stage: str | None = derived()
    """Planetary stage, or path of the scissor gear, that contains the gear, if any."""
    aligned: tuple[str, float] | None = derived()
    """Gear on the same body that determines its orientation, and the angle from a tooth of it to one of this
    gear, at their mid-faces [rad]; None if its meshes do."""
    x: float | None = derived()
    """Effective profile shift coefficient: as given, or from the centre distance."""

    @property
    def sign(self) -> int:
        """+1 for external, -1 for internal gears."""
        return -1 if self.type == "internal" else 1

    @property
    def beta(self) -> float:
        """Helix angle, > 0 right hand, < 0 left hand [rad]."""
        return -self.helix_angle if self.hand == "left" else self.helix_angle

    @property
    def is_modified(self) -> bool:
        """Whether any flank differs from the nominal involute."""
        return any(v is not None for v in (self.modifications, self.deviations, self.tooth_profile))

    @property
    def tooth_faults(self) -> dict[str, ToothFault]:
        """Faults of the teeth by label, without those of the seat."""
        return {label: fault for label, fault in self.faults.items() if not isinstance(fault, SeatFault)}

    @property
    def teeth_differ(self) -> bool:
        """Whether the teeth may differ from each other."""
        return self.deviations is not None or bool(self.faults)

    @cached_property
    def geometry(self) -> CylindricalGear:
        """ISO 21771 macro-geometry with signs (z < 0 for internal gears, beta > 0 for right hand)."""
        x = self.profile_shift_coefficient if self.x is None else self.x
        return self.with_profile_shift(0.0 if x is None else x)

    @cached_property
    def mass_properties(self) -> MassProperties:
        """Mass and moments of inertia of teeth and blank, by geometry and density."""
        return self.mass_properties_on(())

    def mass_properties_on(self, shaft: Sequence[ShaftPiece]) -> MassProperties:
        """Mass and moments of inertia of the part of teeth and blank outside a shaft.

        Pieces of the shaft as in `pitchpoint.geometry.mass_properties.gear_mass_properties`.
        """
        from pitchpoint.geometry.mass_properties import gear_mass_properties

        return gear_mass_properties(
            self.geometry,
            self.material_data.density,
            rim_thickness=self.rim_thickness,
            web_thickness=self.web_thickness,
            bore_diameter=self.bore_diameter,
            shaft=shaft,
        )

    def with_profile_shift(self, x: float) -> CylindricalGear:
        """Geometry with the profile shift coefficient `x` and the tooth profile, if one is given."""
        from pitchpoint.geometry.cylindrical_gear import CylindricalGear
        from pitchpoint.geometry.rack import BasicRack

        signed = self.sign
        generated = CylindricalGear(
            z=signed * self.number_of_teeth,
            m_n=self.normal_module,
            alpha_n=self.normal_pressure_angle,
            beta=self.beta,
            x=x,
            b=self.face_width,
            rack=BasicRack(
                h_aP_star=self.rack.addendum,
                h_fP_star=self.rack.dedendum,
                rho_fP_star=self.rack.root_radius,
            ),
            tip_diameter=None if self.tip_diameter is None else signed * self.tip_diameter,
            tip_alteration=self.tip_alteration,
            thickness_allowance=self.tooth_thickness_allowance,
            root_diameter=None if self.root_diameter is None else signed * self.root_diameter,
            tip_chamfer=self.tip_chamfer,
            tip_rounding=self.tip_rounding,
            cutter=self._pinion_cutter(),
        )
        profile = self.tooth_profile
        return generated if profile is None else generated.replace(outline=profile.outline(generated))

    def _pinion_cutter(self) -> PinionCutter | None:
        if self.cutter is None:
            return None
        from pitchpoint.geometry.cutter import PinionCutter

        return PinionCutter(
            z_0=self.cutter.number_of_teeth,
            x_0=self.cutter.profile_shift_coefficient,
            h_aP0_star=self.cutter.addendum,
            rho_aP0_star=self.cutter.tip_radius,
        )

    @property
    def material_data(self) -> Material:
        """Material properties, from the library if given by name."""
        from pitchpoint.geometry.materials import Material, material

        return self.material if isinstance(self.material, Material) else material(self.material)

    @property
    def blank_factor(self) -> float:
        """Gear blank factor C_R of ISO 6336-1; 1 for a solid gear."""
        from pitchpoint.contact.stiffness.din3990 import blank_factor

        if self.rim_thickness is None and self.web_thickness is None:
            return 1.0
        web = 1.0 if self.web_thickness is None else self.web_thickness / self.face_width
        rim = 1.0 if self.rim_thickness is None else self.rim_thickness / self.normal_module
        return blank_factor(web, rim)
