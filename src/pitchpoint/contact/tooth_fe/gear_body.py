# SPDX-License-Identifier: Apache-2.0
"""Body of a gear below its teeth: clamped circle, rim and web.

Derivation: docs/theory/tooth_fe.md, "Ring".
"""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.contact.compliance.blank import Blank, blank_radii
from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear


@dataclass(frozen=True)
class GearBody:
    """Clamped circle, rim and web, all symmetric to the middle of the face width.

    Parameters
    ----------
    clamped
        Radius of the clamped circle [m].
    rim
        Radius between rim and web [m], or None.
    web
        Thickness of the web [m], or None.
    """

    clamped: float
    rim: float | None = None
    web: float | None = None


def gear_body(gear: CylindricalGear, blank: Blank) -> GearBody:
    """Body of a gear with a blank.

    Parameters
    ----------
    gear
        The gear.
    blank
        Its blank; the circle of `bore_diameter` is clamped.

    Raises
    ------
    GeometryError
        If the sizes do not fit the gear, or the web is wider than the rim.

    Examples
    --------
    >>> gear = CylindricalGear(z=40, m_n=2e-3, b=20e-3)
    >>> body = gear_body(gear, Blank(bore_diameter=30e-3, rim_thickness=6e-3, web_thickness=5e-3))
    >>> body.clamped, round(body.rim, 6), body.web
    (0.015, 0.0315, 0.005)
    """
    radii = blank_radii(gear, blank)
    if radii.web_share == 1.0:
        return GearBody(radii.clamp)
    if radii.web_share > 1.0:
        raise GeometryError(
            "is wider than the rim, which finite elements of teeth do not support",
            where="web_thickness",
            value=f"{1e3 * radii.web_share * gear.b:.6g} mm",
            limit=f"up to the face width {1e3 * gear.b:.6g} mm",
        )
    return GearBody(radii.clamp, radii.rim, radii.web_share * gear.b)
