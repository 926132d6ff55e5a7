# SPDX-License-Identifier: Apache-2.0
"""An elastic shaft: cylindrical sections along its spin axis z."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from pitchpoint.model.component import Component
from pitchpoint.model.components.marker import Axes, Marker
from pitchpoint.model.components.solid import SolidReference
from pitchpoint.model.keys import component, key, positive, quantities, quantity

if TYPE_CHECKING:
    from pitchpoint.geometry.mass_properties import ShaftPiece
    from pitchpoint.geometry.materials import Material


@dataclass(frozen=True, kw_only=True)
class ShaftSection(Component):
    """A shaft section with constant diameters."""

    length: float = positive("length", "length")
    diameter: float = positive("length", "outer diameter")
    bore: float = quantity(
        "length",
        "inner diameter",
        0.0,
        minimum=0.0,
        range_words="from 0, below the diameter",
        also=("bore_diameter", "inner_diameter"),
    )


@dataclass(frozen=True, kw_only=True)
class Shaft(Component):
    """An elastic round shaft in bending, torsion and tension, along its z axis."""

    sections: tuple[ShaftSection, ...] = key(
        "list",
        "shaft sections in their order along the spin axis",
        of=ShaftSection,
        length=(1, 1000),
        sample="[{length: 100 mm, diameter: 40 mm}]",
    )
    material: Material | str = key(
        "material", "name in materials or in the library, or the properties", "steel"
    )
    solid: SolidReference | None = component(
        SolidReference,
        "solid without gears; its mass is distributed over the sections in proportion to theirs",
    )
    gears: dict[str, float] = key(
        "gears",
        "names of the gears with the positions of their mid-faces, from the start of the shaft [m]",
        {},
    )
    bevel_gears: dict[str, float] = key(
        "gears",
        "names of the bevel gears with the positions of their apexes, from the start of the shaft [m]; also "
        "beyond its ends",
        {},
        later=True,
    )
    position: tuple[float, float, float] | None = quantities(
        "length",
        "start of the shaft [x, y, z]; the shaft extends along its z axis",
        None,
        length=(3, 3),
        display="from meshes and couplings",
    )
    axes: Axes | None = component(
        Axes,
        "directions of its axes in the world; default: those of a body that its gears mesh with, else those "
        "of the world",
    )
    markers: Mapping[str, Marker] = key(
        "components",
        "points with axes of their own, by name; positions from the start of the shaft",
        {},
        of=Marker,
    )
    largest_piece: float | None = positive(
        "length", "maximum length of a beam element", None, display="two diameters"
    )
    internal_damping: float = quantity(
        "time",
        "internal (rotating) damping over stiffness: the damping ratio of a mode is half of it times the "
        "angular frequency",
        0.0,
        minimum=0.0,
    )

    @property
    def length(self) -> float:
        """Length of all sections [m]."""
        return sum(s.length for s in self.sections)

    @property
    def material_data(self) -> Material:
        """Material properties, from the library if given by name."""
        from pitchpoint.geometry.materials import Material, material

        return self.material if isinstance(self.material, Material) else material(self.material)

    @property
    def dimensions(self) -> list[tuple[float, float, float]]:
        """Length, diameter and bore of every section [m]."""
        return [(s.length, s.diameter, s.bore) for s in self.sections]

    def pieces_from(self, origin: float) -> list[ShaftPiece]:
        """Start and end from `origin`, diameter and bore of every section [m]."""
        ends = list(itertools.accumulate((s.length for s in self.sections), initial=-origin))
        return [
            (a, b, s.diameter, s.bore) for a, b, s in zip(ends[:-1], ends[1:], self.sections, strict=True)
        ]

    @cached_property
    def density(self) -> float:
        """Effective density [kg/m^3]: of the material, or such that the sections have the mass of the
        solid."""
        own = self.material_data.density
        if self.solid is None:
            return own
        from pitchpoint.geometry.shaft_solid import shaft_mass_properties

        volume = shaft_mass_properties(self.dimensions, 1.0).mass
        return self.solid.density_for(self.material) * self.solid.solid().volume / volume

    def pieces(self) -> list[tuple[float, float, float, float]]:
        """Mass [kg], polar and transverse inertia about the centre [kg m^2] and position of the centre [m] of
        every section."""
        found, start, density = [], 0.0, self.density
        for s in self.sections:
            mass = density * math.pi / 4.0 * (s.diameter**2 - s.bore**2) * s.length
            polar = mass / 8.0 * (s.diameter**2 + s.bore**2)
            found.append((mass, polar, 0.5 * polar + mass * s.length**2 / 12.0, start + 0.5 * s.length))
            start += s.length
        return found
