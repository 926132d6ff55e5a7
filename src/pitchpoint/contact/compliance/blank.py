# SPDX-License-Identifier: Apache-2.0
"""Blank of a gear: radii of rim, web and bore, and its torsion between the bore and the root circle.

Source: torsion of a disc in its plane, S. P. Timoshenko and J. N. Goodier, Theory of Elasticity, 3rd ed.
(1970). Derivation: docs/theory/flank_compliance.md, "The blank".
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from pitchpoint.contact.stiffness.tooth_compliance import SOLID_RATIO
from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.mass_properties import RIM_OF_RING
from pitchpoint.geometry.tooth_form import tooth_form


@dataclass(frozen=True, kw_only=True)
class Blank:
    """Blank as described by the user.

    Parameters
    ----------
    bore_diameter
        External gear: diameter at which the blank is clamped, bore or shaft [m]; None: half of the root
        diameter. Internal gear: outer diameter, at which it is clamped; None: `rim_thickness`, or 3.5 m_n
        behind the root circle.
    rim_thickness
        Thickness of the rim behind the root circle [m]; None: solid to the bore. Without a web it has no
        effect, except on an internal gear without outer diameter.
    web_thickness
        Axial thickness of the web between rim and bore [m], requires `rim_thickness`; None: face width.
    """

    bore_diameter: float | None = None
    rim_thickness: float | None = None
    web_thickness: float | None = None


@dataclass(frozen=True)
class BlankRadii:
    """Radii of a blank [m]: root circle, inner side of the rim (outer side of a ring), and clamp.

    Parameters
    ----------
    root, rim, clamp
        Radii [m]; rim = clamp without a web, or with one as wide as the face.
    web_share
        Web thickness over face width [-]; 1 without a web.
    """

    root: float
    rim: float
    clamp: float
    web_share: float

    @property
    def depth(self) -> float:
        """Distance from the root circle to the clamp [m]."""
        return abs(self.root - self.clamp)

    def torsion(self, r_b: float, G: float) -> float:
        """Displacement along the base tangent due to torsion of the blank, per unit face width [m²/N].

        Parameters
        ----------
        r_b
            Base radius [m].
        G
            Shear modulus [Pa].

        Notes
        -----
        r_b²/(4 π G) |(b/b_s)(1/r_i² − 1/r_w²) + 1/r_w² − 1/r_f²| with the clamp radius r_i, the rim radius
        r_w, the root radius r_f and the web thickness b_s: the shear stress F r_b/(2 π r² b) in the plane of
        the disc, integrated over the radius (Timoshenko and Goodier, 1970).

        Examples
        --------
        >>> blank = BlankRadii(20.25e-3, 10.125e-3, 10.125e-3, 1.0)
        >>> round(blank.torsion(20.2034e-3, 206e9 / 2.6) * 1e12, 3)      # µm mm/N, times 1e3
        2.999
        """
        web = (self.clamp**-2 - self.rim**-2) / self.web_share
        return r_b * r_b / (4.0 * math.pi * G) * abs(web + self.rim**-2 - self.root**-2)


def blank_radii(gear: CylindricalGear, blank: Blank) -> BlankRadii:
    """Radii of the blank of a gear.

    Parameters
    ----------
    gear
        External or internal gear.
    blank
        Description of the blank.

    Raises
    ------
    GeometryError
        If a length is not positive, the clamp is not behind the root circle, or a web has no rim.

    Examples
    --------
    >>> gear = CylindricalGear(z=43, m_n=1e-3)
    >>> radii = blank_radii(gear, Blank(rim_thickness=3e-3, web_thickness=2e-3, bore_diameter=12e-3))
    >>> [round(1e3 * r, 3) for r in (radii.root, radii.rim, radii.clamp)]
    [20.25, 17.25, 6.0]
    """
    sizes = (
        ("bore_diameter", blank.bore_diameter),
        ("rim_thickness", blank.rim_thickness),
        ("web_thickness", blank.web_thickness),
    )
    for where, value in sizes:
        if value is not None and (isinstance(value, bool) or not (math.isfinite(value) and value > 0.0)):
            raise GeometryError("is not a length", where=where, value=f"{value!r}", limit="above 0")
    if blank.web_thickness is not None and blank.rim_thickness is None:
        raise GeometryError("requires a rim", where="web_thickness", remedy="set rim_thickness too")
    form = tooth_form(gear)
    sign, root = form.sign, form.r_f
    rim = None if blank.rim_thickness is None else root - sign * blank.rim_thickness
    if blank.bore_diameter is not None:
        clamp = 0.5 * blank.bore_diameter
    elif form.is_internal:
        clamp = root + RIM_OF_RING * gear.m_n if rim is None else rim
    else:
        clamp = root / SOLID_RATIO
    if not sign * (root - clamp) > 0.0 or not clamp > 0.0:
        raise GeometryError(
            "leaves no rim behind the teeth",
            where="bore_diameter",
            value=f"{2e3 * clamp:.6g} mm",
            limit=f"{'below' if sign > 0 else 'above'} the root diameter {2e3 * root:.6g} mm",
            remedy="use a smaller bore" if sign > 0 else "use a larger outer diameter",
        )
    share = 1.0 if blank.web_thickness is None else blank.web_thickness / gear.b
    if rim is None or share == 1.0 or sign * (rim - clamp) <= 0.0:
        return BlankRadii(root, clamp, clamp, 1.0)
    return BlankRadii(root, rim, clamp, share)
