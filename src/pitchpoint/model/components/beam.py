# SPDX-License-Identifier: Apache-2.0
"""Elastic beams between two places on bodies."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from pitchpoint.model.keys import REQUIRED, component, integer, key, positive, quantities, quantity

if TYPE_CHECKING:
    from pitchpoint.geometry.materials import Material

SHAPES = (("diameter",), ("width", "height"), ("area", "bending", "torsion"))
"""What a section may be given by: round, rectangular, or any other."""


@dataclass(frozen=True, kw_only=True)
class BeamSection:
    """Cross-section: diameter and bore, or width and height, or the numbers of any other one."""

    diameter: float | None = positive("length", "round: outer diameter", None)
    bore: float = quantity(
        "length", "round: inner diameter", 0.0, minimum=0.0, range_words="from 0, below the diameter"
    )
    width: float | None = positive("length", "rectangular: side along axis 1", None)
    height: float | None = positive("length", "rectangular: side along axis 2", None)
    area: float | None = positive("area", "any other: area", None)
    bending: tuple[float, ...] = quantities(
        "second_moment_of_area",
        "any other: second moments against bending towards axis 1 and 2",
        (),
        minimum=0.0,
        above=True,
        sample="[2.5 cm^4, 1.2 cm^4]",
    )
    torsion: float | None = positive("second_moment_of_area", "any other: torsion constant", None)
    shear: tuple[float, float] = quantities(
        "dimensionless",
        "any other: shear factors for axis 1 and 2; zeros leave shear deflection out",
        (0.0, 0.0),
        length=(2, 2),
        minimum=0.0,
        maximum=1.0,
    )

    @property
    def given(self) -> tuple[str, ...]:
        """Names of the shape's keys that have a value."""
        return tuple(k for shape in SHAPES for k in shape if getattr(self, k) not in (None, ()))


@dataclass(frozen=True, kw_only=True)
class Beam:
    """Timoshenko beam between two places, clamped to both bodies; it may bend and turn by any angle."""

    ends: tuple[str, str] = key(
        "ends",
        "its two ends, each of them ground, a body or BODY.MARKER; it has no force as placed",
        length=(2, 2),
    )
    section: BeamSection = component(BeamSection, "cross-section, the same all along", REQUIRED)
    axis: tuple[float, float, float] | None = quantities(
        "dimensionless",
        "direction in the world towards which axis 1 of the section points",
        None,
        length=(3, 3),
        display="x of the world, or y for a beam along x",
    )
    material: Material | str = key("material", "name in the library or its properties", "steel")
    pieces: int = integer(
        "number of beams in series that represent it; bodies with six coordinates lie between them",
        4,
        minimum=1,
        maximum=1000,
    )
    internal_damping: float = quantity(
        "time",
        "damping per stiffness, in axes that turn with the beam: the ratio of a mode is half of it times its "
        "angular frequency",
        0.0,
        minimum=0.0,
    )

    @property
    def material_data(self) -> Material:
        """Properties of the material, looked up in the library when it is named."""
        from pitchpoint.geometry.materials import Material, material

        return self.material if isinstance(self.material, Material) else material(self.material)
