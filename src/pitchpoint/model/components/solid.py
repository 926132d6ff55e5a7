# SPDX-License-Identifier: Apache-2.0
"""A solid from a CAD file that supplies mass and inertia of a gear, a shaft or a body."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from pitchpoint.model.component import Component
from pitchpoint.model.components.marker import Axes, Triple
from pitchpoint.model.keys import component, key, positive, quantities, text

if TYPE_CHECKING:
    from pitchpoint.geometry.materials import Material
    from pitchpoint.geometry.solid_mass import RoundInertia, Solid


@dataclass(frozen=True, kw_only=True)
class SolidReference(Component):
    """A closed solid in an STL or STEP file; STEP requires the extra `cad`."""

    file: str = key("file", "file, .step, .stp, .stl or .npy", sample="gear.step")
    unit: float | None = positive(
        "length", "STL: length of one unit of the file; STEP files contain theirs", None, sample="1 mm"
    )
    part: str | None = text("STEP: name of the solid in a file with several solids", None)
    material: Material | str | None = key(
        "material",
        "name in materials or in the library, or the properties",
        None,
        display="that of the gear or shaft, or steel",
    )
    density: float | None = positive("density", "instead of a material", None)
    axes: Axes | None = component(
        Axes,
        "directions of the axes of the body in the file; for gears and shafts z is the axis of rotation, "
        "default: the axis of symmetry of the solid",
    )
    origin: Triple | None = quantities(
        "length", "bodies: position of the origin of the body in the file", None, length=(3, 3)
    )

    def density_for(self, own: Material | str = "steel") -> float:
        """Effective density [kg/m^3]; that of the material `own` if neither density nor material is given."""
        from pitchpoint.geometry.materials import Material, material

        if self.density is not None:
            return self.density
        chosen = self.material if self.material is not None else own
        return chosen.density if isinstance(chosen, Material) else material(chosen).density

    def solid(self) -> Solid:
        """The solid of the file."""
        from pitchpoint.geometry.solid_file import read_solids

        return read_solids(self.file, self.unit).part(self.part)

    def about_axis(self) -> RoundInertia:
        """Polar and transverse moments of inertia about the axis of a gear or a shaft."""
        from pitchpoint.geometry.solid_mass import round_inertia

        return round_inertia(self.solid(), None if self.axes is None else self.axes.z)
