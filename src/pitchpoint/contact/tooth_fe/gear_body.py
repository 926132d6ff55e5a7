# SPDX-License-Identifier: Apache-2.0
"""Body of a gear below its teeth: clamped circle, rim and web."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.solid import blank_section
from pitchpoint.geometry.tooth_form import tooth_form

SOLID_RATIO = 0.5
"""Clamped radius of a gear without bore relative to its root radius."""


@dataclass(frozen=True)
class GearBody:
    """Clamped circle, rim and web, all symmetric to the middle of the face width.

    Parameters
    ----------
    clamped
        Radius of the clamped circle [m]: bore, or outside of an internal gear.
    rim
        Radius between rim and web [m], or None.
    web
        Thickness of the web [m], or None.
    """

    clamped: float
    rim: float | None = None
    web: float | None = None


def gear_body(
    gear: CylindricalGear,
    bore_diameter: float | None = None,
    rim_thickness: float | None = None,
    web_thickness: float | None = None,
) -> GearBody:
    """Body from the sizes of a blank.

    Parameters
    ----------
    gear
        The gear.
    bore_diameter
        Diameter of the bore, of an internal gear the outer diameter [m]. None: half the root diameter; for an
        internal gear a rim of 3.5 m_n.
    rim_thickness, web_thickness
        Radial thickness of the rim below the root circle and axial thickness of the web [m]; None: full disc.

    Raises
    ------
    GeometryError
        If the sizes do not fit the gear, or the web is wider than the rim.

    Examples
    --------
    >>> gear_body(CylindricalGear(z=40, m_n=2e-3)).clamped    # half of the root radius 37.5 mm
    0.01875
    """
    bore = 0.5 * (bore_diameter or 0.0)
    section, _ = blank_section(gear, bore, rim_thickness, web_thickness)
    if gear.is_internal:
        return GearBody(section[-1][0])
    clamped = bore if bore > 0.0 else SOLID_RATIO * tooth_form(gear).r_f
    if web_thickness is None or len(section) < 2 or section[0][0] <= clamped:
        return GearBody(clamped)
    if not 0.0 < web_thickness < gear.b:
        raise GeometryError(
            "is not a web inside the rim",
            where="web_thickness",
            value=f"{1e3 * web_thickness:.6g} mm",
            limit=f"above 0, up to the face width {1e3 * gear.b:.6g} mm",
        )
    return GearBody(clamped, section[0][0], web_thickness)
