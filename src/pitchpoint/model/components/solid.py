# SPDX-License-Identifier: Apache-2.0
"""A solid from a file of a CAD program, which gives a gear, a shaft or a body its mass and inertia."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from pitchpoint.model.components.marker import Axes, Triple
from pitchpoint.model.keys import component, key, positive, quantities, text

if TYPE_CHECKING:
    from pitchpoint.geometry.materials import Material
    from pitchpoint.geometry.solid_mass import RoundInertia, Solid


@dataclass(frozen=True, kw_only=True)
class SolidReference:
    """A closed solid in an STL or STEP file; STEP needs the extra `cad`."""

    file: str = key("file", "the file, .step, .stp, .stl or .npy", sample="gear.step")
    unit: float | None = positive(
        "length", "STL: length of one unit of the file; STEP files contain theirs", None, sample="1 mm"
    )
    part: str | None = text("STEP: name of the solid in a file with several", None)
    material: Material | str | None = key(
        "material",
        "name in the library or its properties",
        None,
        display="that of the gear or shaft, or steel",
    )
    density: float | None = positive("density", "instead of a material", None)
    axes: Axes | None = component(
        Axes,
        "directions in the file of the axes of the body; of gears and shafts z is the axis, which is found "
        "if omitted",
    )
    origin: Triple | None = quantities(
        "length", "bodies: place in the file of the origin of the body", None, length=(3, 3)
    )

    def density_for(self, own: Material | str = "steel") -> float:
        """Density in force [kg/m^3], with `own` where neither density nor material is given."""
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
        """Its moments of inertia about the axis of a gear or a shaft, and across."""
        from pitchpoint.geometry.solid_mass import round_inertia

        return round_inertia(self.solid(), None if self.axes is None else self.axes.z)
