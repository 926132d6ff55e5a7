# SPDX-License-Identifier: Apache-2.0
"""An elastic shaft: sections in a row, along its spin axis z."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from pitchpoint.core.errors import Problem
from pitchpoint.model.keys import key, positive, quantities, quantity

if TYPE_CHECKING:
    from pitchpoint.geometry.materials import Material


@dataclass(frozen=True, kw_only=True)
class ShaftSection:
    """A piece of a shaft with constant diameters."""

    length: float = positive("length", "length")
    diameter: float = positive("length", "outer diameter")
    bore: float = quantity(
        "length", "inner diameter", 0.0, minimum=0.0, range_words="from 0, below the diameter"
    )


@dataclass(frozen=True, kw_only=True)
class Shaft:
    """An elastic round shaft that bends, twists and stretches; gears, bearings and loads sit at places
    along it."""

    sections: dict[str, ShaftSection] = key(
        "components", "pieces in the order in which they follow along the spin axis", of=ShaftSection
    )
    material: Material | str = key("material", "name in the library or its properties", "steel")
    gears: dict[str, float] = key(
        "gears", "names of the gears, with the places of their mid-faces from the start of the shaft [m]", {}
    )
    position: tuple[float, float, float] | None = quantities(
        "length", "start of the shaft [x, y, z]", None, length=(3, 3), display="from the meshes"
    )
    largest_piece: float | None = positive(
        "length", "longest piece that is reckoned as one beam", None, display="two diameters"
    )
    internal_damping: float = quantity(
        "time",
        "damping per stiffness, in axes that spin with the shaft: the ratio of a mode is half of it times "
        "its angular frequency",
        0.0,
        minimum=0.0,
    )

    @property
    def length(self) -> float:
        """Length of all sections [m]."""
        return sum(s.length for s in self.sections.values())

    @property
    def material_data(self) -> Material:
        """Properties of the material, looked up in the library when it is named."""
        from pitchpoint.geometry.materials import Material, material

        return self.material if isinstance(self.material, Material) else material(self.material)

    def problems(self, where: str) -> list[Problem]:
        """Say what makes the shaft impossible; empty if nothing does.

        Parameters
        ----------
        where
            Path of the shaft in the model, for instance ``shafts.input``.
        """
        found = []
        if not self.sections:
            found.append(Problem(f"{where}.sections", "is empty", remedy="give one section at least"))
        for name, section in self.sections.items():
            if section.bore >= section.diameter:
                found.append(
                    Problem(
                        f"{where}.sections.{name}.bore",
                        "leaves nothing of the shaft",
                        value=f"{section.bore:g} m",
                        limit=f"below the diameter {section.diameter:g} m",
                        remedy="diameters, not radii, are asked for",
                    )
                )
        for name, place in self.gears.items():
            if not 0.0 <= place <= self.length * (1.0 + 1e-9):
                found.append(
                    Problem(
                        f"{where}.gears.{name}",
                        "is no place on the shaft",
                        value=f"{place:g} m",
                        limit=f"0 to {self.length:g} m",
                        remedy="places count from the start of the first section",
                    )
                )
        return found
