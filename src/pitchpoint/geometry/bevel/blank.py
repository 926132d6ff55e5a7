# SPDX-License-Identifier: Apache-2.0
"""Blank of a bevel gear, and mass and moments of inertia of blank and teeth.

Gear frame: apex at the origin, z axis into the gear. The teeth end on two cones perpendicular to the pitch
cone: the back cone at R_e and the inner complementary cone at R_i.

Derivation: docs/theory/bevel_gears.md, "Solid and mass".
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.bevel.tooth import bevel_tooth
from pitchpoint.geometry.mass_properties import ShaftPiece
from pitchpoint.geometry.shaft_solid import RoundMass

if TYPE_CHECKING:
    from pitchpoint.geometry.bevel.gear import BevelGear

FloatArray = NDArray[np.float64]
_NODES = 48
"""Gauss points each for fillet and involute: both are analytic, the error is at round-off level. It is below
1e-3 for the part of the teeth inside a shaft."""
_NOTHING = 1e-12
"""Fraction of the volume up to which a gear is completely inside its shaft."""


@dataclass(frozen=True)
class BevelBlank:
    """Half section of the blank: corners as (radius, height) in the gear frame [m].

    Parameters
    ----------
    toe, heel
        Ends of the root cone at R_i and R_e.
    back
        End of the back cone, `rim_thickness` below the root.
    bore
        Radius of the bore [m], 0 for none.
    """

    toe: tuple[float, float]
    heel: tuple[float, float]
    back: tuple[float, float]
    bore: float

    @property
    def corners(self) -> list[tuple[float, float]]:
        """Corners of the section, counter-clockwise with the radius to the right and the height upwards."""
        return [self.toe, self.heel, self.back, (self.bore, self.back[1]), (self.bore, self.toe[1])]


def bevel_blank(gear: BevelGear, bore_diameter: float, rim_thickness: float | None) -> BevelBlank:
    """Blank of a bevel gear.

    Parameters
    ----------
    gear
        The gear.
    bore_diameter
        Bore [m], 0 for none.
    rim_thickness
        Thickness below the root at the outer end, along the back cone [m]; None: the whole depth there.

    Raises
    ------
    GeometryError
        If bore or rim do not fit the gear.

    Notes
    -----
    The front plane goes through the inner end of the root cone, the rear plane through the end of the back
    cone. A rim as thick as the whole depth is the minimum of usual practice.

    Examples
    --------
    >>> from pitchpoint.geometry.bevel.gear import BevelGear
    >>> gear = BevelGear.of_outer_module(z=20, m_et=3e-3, delta=math.atan(0.5), b=22e-3)
    >>> [round(1e3 * x, 4) for x in bevel_blank(gear, 0.01, None).back]
    [20.6085, 64.6957]
    """
    delta, delta_f = gear.delta, gear.delta_f
    if rim_thickness is None:
        rim_thickness = gear.h_ae + gear.h_fe
    if not 0.0 < rim_thickness < math.inf:
        raise GeometryError(
            "is not possible", where="rim_thickness", value=f"{rim_thickness!r} m", limit="above 0"
        )

    def root(R: float) -> tuple[float, float]:
        """Point of the root cone at the cone distance R."""
        r = R / math.cos(gear.theta_f)
        return r * math.sin(delta_f), r * math.cos(delta_f)

    toe, heel = root(gear.R_i), root(gear.R_e)
    back = heel[0] - rim_thickness * math.cos(delta), heel[1] + rim_thickness * math.sin(delta)
    if back[0] < 0.0:
        raise GeometryError(
            "reaches beyond the axis",
            where="rim_thickness",
            value=f"{1e3 * rim_thickness:.6g} mm",
            limit=f"{1e3 * heel[0] / math.cos(delta):.6g} mm",
            remedy="make it thinner",
        )
    # chords connect the tooth roots of the triangulated solid; the bore must not cross them
    limit = min(toe[0] * math.cos(math.pi / gear.z), back[0])
    if not 0.0 <= bore_diameter < 2.0 * limit:
        raise GeometryError(
            "does not fit the gear",
            where="bore_diameter",
            value=f"{1e3 * bore_diameter:.6g} mm",
            limit=f"below {2e3 * limit:.6g} mm",
            remedy="use a smaller bore" + ("" if limit < back[0] else ", or a thinner rim"),
        )
    return BevelBlank(toe, heel, back, 0.5 * bore_diameter)


def revolved(corners: list[tuple[float, float]]) -> FloatArray:
    """Volume integrals of the solid of revolution of a polygon.

    Parameters
    ----------
    corners
        Corners (radius, height) [m], counter-clockwise with the radius to the right; none: all zero.

    Returns
    -------
    ndarray, shape (4,)
        Volume [m³] and the volume integrals of z [m⁴], z² [m⁵] and x² + y² [m⁵].

    Notes
    -----
    Every edge generates a conical frustum. By Gauss's theorem the integrals are 2π times those of r²/2,
    r² z/2, r² z²/2 and r⁴/4 over dz along the edges: polynomials of degree 4, exact with three Gauss points.

    Examples
    --------
    Cone: volume π r² h / 3, centre of mass h/4 above the base.

    >>> volume, moment, _, _ = revolved([(0.0, 0.0), (1.0, 0.0), (0.0, 3.0)])
    >>> round(float(volume / math.pi), 12), round(float(moment / volume), 12)
    (1.0, 0.75)
    """
    nodes, weights = np.polynomial.legendre.leggauss(3)
    total = np.zeros(4)
    for (r_1, z_1), (r_2, z_2) in zip(corners, [*corners[1:], *corners[:1]], strict=True):
        r = 0.5 * (r_1 + r_2) + 0.5 * (r_2 - r_1) * nodes
        z = 0.5 * (z_1 + z_2) + 0.5 * (z_2 - z_1) * nodes
        terms = np.stack([0.5 * r**2, 0.5 * r**2 * z, 0.5 * r**2 * z**2, 0.25 * r**4])
        total += math.pi * (z_2 - z_1) * (terms @ weights)
    return total


def toothed(gear: BevelGear, within: ShaftPiece | None = None) -> FloatArray:
    """Volume integrals, as in `revolved`, of the teeth of a bevel gear above the root cone.

    Parameters
    ----------
    gear
        The gear.
    within
        Cylinder that contains the part of the teeth wanted: start and end from the apex, diameter, and bore,
        which has no effect [m]; None: all.

    Returns
    -------
    ndarray, shape (4,)
        [m³, m⁴, m⁵, m⁵].

    Notes
    -----
    At the polar angle δ_y the tooth has the angular width 2ψ(δ_y) and extends from the distance
    R_i / cos(δ_y − δ) to R_e / cos(δ_y − δ). ∫ r^(k+2) dr is in closed form, the integral over the polar
    angle is by Gauss's rule over fillet and involute. A spiral only rotates the sections, which does not
    change the integrals. In a cylinder the distances are also limited by its ends z / cos δ_y and by its
    radius over sin δ_y.

    Examples
    --------
    >>> from pitchpoint.geometry.bevel.gear import BevelGear
    >>> volume = toothed(BevelGear(z=20, m_mn=2.5e-3, delta=math.atan(0.5), b=0.02))[0]
    >>> round(1e9 * float(volume), 3)
    8771.885
    """
    tooth = bevel_tooth(gear)
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    series = np.polynomial.chebyshev
    total = np.zeros(4)
    for low, high, curve in (
        (tooth.tau_root, tooth.tau_form, tooth.fillet),
        (tooth.sigma_form, gear.sigma_a, tooth.involute),
    ):
        at = series.chebpts1(_NODES)
        slope = series.chebder(
            series.chebfit(at, curve(0.5 * (low + high) + 0.5 * (high - low) * at)[0], _NODES - 1)
        )
        polar, half = curve(0.5 * (low + high) + 0.5 * (high - low) * nodes)
        across = 2.0 * gear.z * half * np.sin(polar) * series.chebval(nodes, slope) * weights
        ends = np.stack([gear.R_i / np.cos(polar - gear.delta), gear.R_e / np.cos(polar - gear.delta)])
        if within is not None:
            start, end, outer, _ = within
            ends = np.clip(ends, start / np.cos(polar), end / np.cos(polar))
            ends = np.minimum(ends, 0.5 * outer / np.sin(polar))
        third, fourth, fifth = ((ends[1] ** k - ends[0] ** k) / k for k in (3, 4, 5))
        c, s = np.cos(polar), np.sin(polar)
        total += np.stack([third, fourth * c, fifth * c**2, fifth * s**2]) @ across
    return total


def in_cylinder(corners: list[tuple[float, float]], cylinder: ShaftPiece) -> list[tuple[float, float]]:
    """Part of a section inside a cylinder.

    Parameters
    ----------
    corners
        Corners of the section (radius, height) [m].
    cylinder
        Start and end along the axis, diameter, and bore, which has no effect [m].

    Returns
    -------
    list
        Corners of the part, in the same order; lines traversed both ways may connect separate parts. Empty
        if there is none.

    Notes
    -----
    I. E. Sutherland, G. W. Hodgman, "Reentrant polygon clipping", Communications of the ACM 17 (1974),
    32-42: by one straight line after the other.

    Examples
    --------
    >>> in_cylinder([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)], (1.0, 3.0, 2.0, 0.0))
    [(0.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)]
    """
    start, end, outer, _ = cylinder
    for axis, limit, sign in ((1, start, -1.0), (1, end, 1.0), (0, 0.5 * outer, 1.0)):
        kept = []
        for k, corner in enumerate(corners):
            before = corners[k - 1]
            one, two = sign * (before[axis] - limit), sign * (corner[axis] - limit)
            if (one > 0.0) != (two > 0.0):
                part = one / (one - two)
                crossing = [b + part * (c - b) for b, c in zip(before, corner, strict=True)]
                crossing[axis] = limit
                kept.append((crossing[0], crossing[1]))
            if two <= 0.0:
                kept.append(corner)
        corners = kept
    return corners


def bevel_mass(
    gear: BevelGear,
    density: float,
    bore_diameter: float = 0.0,
    rim_thickness: float | None = None,
    *,
    shaft: Sequence[ShaftPiece] = (),
) -> RoundMass:
    """Mass and moments of inertia of a bevel gear, blank and teeth, or of the part of it outside a shaft.

    Parameters
    ----------
    gear
        The gear.
    density
        Density [kg/m³].
    bore_diameter, rim_thickness
        Size of the blank, as in `bevel_blank` [m].
    shaft
        Pieces of the shaft through the gear, whose material is not part of the gear: start and end from the
        apex along the gear, diameter and bore of each [m]. The gear has no material in the bore of the shaft.

    Returns
    -------
    RoundMass

    Raises
    ------
    GeometryError
        If the tooth or the blank is not possible.

    Notes
    -----
    With three or more equal teeth all transverse moments of inertia are equal: about the apex
    J_t = ∫ z² + ½ ∫ (x² + y²), transferred to the centre of mass by the parallel axis theorem.

    Examples
    --------
    >>> from pitchpoint.geometry.bevel.gear import BevelGear
    >>> gear = BevelGear.of_outer_module(z=20, m_et=3e-3, delta=math.atan(0.5), b=22e-3)
    >>> mass = bevel_mass(gear, 7830.0, bore_diameter=0.01)
    >>> round(mass.mass, 4), round(1e3 * mass.center, 3)
    (0.3537, 53.822)
    """
    if not 0.0 <= density < math.inf:
        raise GeometryError(
            "is not possible", where="density", value=f"{density!r} kg/m^3", limit="finite, >= 0"
        )
    blank = bevel_blank(gear, bore_diameter, rim_thickness)
    whole = revolved(blank.corners) + toothed(gear)
    less = [revolved(in_cylinder(blank.corners, piece)) for piece in shaft]
    less += [toothed(gear, piece) for piece in shaft if 0.5 * piece[2] > blank.toe[0]]
    volume, moment, axial, polar = (float(v) for v in whole - sum(less, np.zeros(4)))
    if not volume > _NOTHING * float(whole[0]):
        return RoundMass(0.0, float(whole[1] / whole[0]), 0.0, 0.0)
    center = moment / volume
    about = axial + 0.5 * polar - volume * center * center
    return RoundMass(density * volume, center, density * polar, density * about)
