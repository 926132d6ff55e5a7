# SPDX-License-Identifier: Apache-2.0
"""Elastic beams between points of two bodies."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from pitchpoint.model.component import Component
from pitchpoint.model.keys import REQUIRED, component, integer, key, positive, quantities, quantity

if TYPE_CHECKING:
    from pitchpoint.geometry.materials import Material

SHAPES = (("diameter",), ("width", "height"), ("area", "bending", "torsion"))
"""Keys that define a section: round, rectangular, general."""


@dataclass(frozen=True, kw_only=True)
class BeamSection(Component):
    """Cross-section: round (diameter, bore), rectangular (width, height), or general."""

    diameter: float | None = positive("length", "round: outer diameter", None)
    bore: float = quantity(
        "length", "round: inner diameter", 0.0, minimum=0.0, range_words="from 0, below the diameter"
    )
    width: float | None = positive("length", "rectangular: side along axis 1", None)
    height: float | None = positive("length", "rectangular: side along axis 2", None)
    area: float | None = positive("area", "general: area", None)
    bending: tuple[float, ...] = quantities(
        "second_moment_of_area",
        "general: second moments of area for bending in the direction of axis 1 and axis 2",
        (),
        minimum=0.0,
        above=True,
        sample="[2.5 cm^4, 1.2 cm^4]",
    )
    torsion: float | None = positive("second_moment_of_area", "general: torsion constant", None)
    shear: tuple[float, float] = quantities(
        "dimensionless",
        "general: shear factors for axis 1 and 2; 0: no shear deflection",
        (0.0, 0.0),
        length=(2, 2),
        minimum=0.0,
        maximum=1.0,
    )

    @property
    def given(self) -> tuple[str, ...]:
        """Names of the given keys of `SHAPES`."""
        return tuple(k for shape in SHAPES for k in shape if getattr(self, k) not in (None, ()))


@dataclass(frozen=True, kw_only=True)
class Beam(Component):
    """Timoshenko beam between two points, clamped to both bodies, for large rotations and deflections."""

    ends: tuple[str, str] = key(
        "ends",
        "the two ends: ground, a body, BODY.MARKER or a station of another beam; free of load in "
        "the initial position",
        length=(2, 2),
    )
    section: BeamSection = component(BeamSection, "constant cross-section", REQUIRED)
    axis: tuple[float, float, float] | None = quantities(
        "dimensionless",
        "direction of axis 1 of the section, in the world",
        None,
        length=(3, 3),
        display="x of the world, or y for a beam along x",
    )
    material: Material | str = key(
        "material", "name in materials or in the library, or the properties", "steel"
    )
    pieces: int = integer(
        "number of beam elements of equal length; between them are the stations BEAM.2, BEAM.3, ..., which "
        "can be named where BODY.MARKER can",
        4,
        minimum=1,
        maximum=1000,
    )
    internal_damping: float = quantity(
        "time",
        "internal damping over stiffness, in axes that rotate with the beam: the damping ratio of a mode is "
        "half of it times the angular frequency",
        0.0,
        minimum=0.0,
    )

    @cached_property
    def stations(self) -> dict[str, float]:
        """Positions of the stations between the elements by number, over the length of the beam [-].

        The ends, 1 and `pieces` + 1, belong to the bodies there.

        Examples
        --------
        >>> Beam(ends=("ground", "tip"), section=BeamSection(diameter=0.02), pieces=4).stations
        {'2': 0.25, '3': 0.5, '4': 0.75}
        """
        return {str(k + 1): k / self.pieces for k in range(1, self.pieces)}

    @property
    def material_data(self) -> Material:
        """Material properties, from the library if given by name."""
        from pitchpoint.geometry.materials import Material, material

        return self.material if isinstance(self.material, Material) else material(self.material)
