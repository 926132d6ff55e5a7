# SPDX-License-Identifier: Apache-2.0
"""Input of the finite elements of one gear: tooth, material, body and resolution."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.contact.compliance.blank import Blank
from pitchpoint.contact.tooth_fe.section_mesh import Density
from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear

FEWEST = 5
"""Smallest number of teeth of the ring."""


@dataclass(frozen=True)
class Resolution:
    """Resolution of the finite elements.

    Parameters
    ----------
    heights
        Number M of polynomials over the height of the flank, 1 to 10.
    widths
        Number P of polynomials over the face width, 1 to 40; None: 6 + 0.6 b/m_n, between 7 and 16.
    fillet_points
        Number of points of the fillet with stress, 1 to 100.
    density
        Mesh of the section.

    Raises
    ------
    GeometryError
        If a number is outside its range.
    """

    heights: int = 6
    widths: int | None = None
    fillet_points: int = 9
    density: Density = Density()

    def __post_init__(self) -> None:
        for where, value, high in (
            ("heights", self.heights, 10),
            ("widths", self.widths if self.widths is not None else 1, 40),
            ("fillet_points", self.fillet_points, 100),
        ):
            if isinstance(value, bool) or not isinstance(value, int) or not 1 <= value <= high:
                raise GeometryError(
                    "is not possible for finite elements of teeth",
                    where=f"resolution.{where}",
                    value=f"{value!r}",
                    limit=f"a whole number, 1 to {high}",
                )

    def polynomials(self, gear: CylindricalGear) -> int:
        """Number of polynomials over the face width of a gear."""
        return self.widths or min(16, max(7, round(6.0 + 0.6 * gear.b / gear.m_n)))


@dataclass(frozen=True, kw_only=True)
class ToothModel:
    """One gear for finite elements.

    Parameters
    ----------
    gear
        External or internal gear, spur or helical. The generated tooth is used, not its `outline`.
    E, nu
        Young's modulus [Pa], Poisson's ratio.
    bore_diameter, rim_thickness, web_thickness
        Blank [m], see `pitchpoint.contact.compliance.blank.Blank`.
    resolution
        Mesh and polynomials.

    Raises
    ------
    GeometryError
        If the material is not possible, or the gear has fewer than five teeth.
    """

    gear: CylindricalGear
    E: float = 206.0e9
    nu: float = 0.3
    bore_diameter: float | None = None
    rim_thickness: float | None = None
    web_thickness: float | None = None
    resolution: Resolution = Resolution()

    @property
    def blank(self) -> Blank:
        """Blank of the gear."""
        return Blank(
            bore_diameter=self.bore_diameter,
            rim_thickness=self.rim_thickness,
            web_thickness=self.web_thickness,
        )

    def __post_init__(self) -> None:
        for where, value, low, high, limit in (
            ("youngs_modulus", self.E, 0.0, 1e15, "above 0"),
            ("poisson_ratio", self.nu, -1e-300, 0.499, "from 0, below 0.499"),
            ("number_of_teeth", abs(self.gear.z), FEWEST - 1, 1e9, f"at least {FEWEST}"),
        ):
            number = isinstance(value, (int, float)) and not isinstance(value, bool)
            if not number or not low < value < high:
                raise GeometryError(
                    "is not possible for finite elements of teeth",
                    where=where,
                    value=f"{value!r}",
                    limit=limit,
                )
