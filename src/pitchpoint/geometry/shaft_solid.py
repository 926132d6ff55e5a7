# SPDX-License-Identifier: Apache-2.0
"""Solid of a stepped, hollow shaft: mass properties, half-section outline and triangulated surface.

Sections are (length, diameter, bore) [m] in order along the z axis from z = 0.

Derivation: docs/theory/geometry.md, "Mass and inertia".
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import GeometryError

FloatArray = NDArray[np.float64]
Section = tuple[float, float, float]

ROUND = 180
"""Corners of a triangulated circle: the area of the inscribed polygon is 2·10⁻⁴ too small."""


@dataclass(frozen=True)
class RoundMass:
    """Mass, centre of mass and central moments of inertia of a body of revolution.

    Parameters
    ----------
    mass
        Mass [kg].
    center
        Centre of mass along the axis, from the start of a shaft or the apex of a bevel gear [m].
    polar_inertia
        About the axis [kg m²].
    transverse_inertia
        About any diameter through the centre of mass [kg m²].
    """

    mass: float
    center: float
    polar_inertia: float
    transverse_inertia: float


def shaft_mass_properties(sections: Sequence[Section], density: float) -> RoundMass:
    """Mass, centre of mass and central moments of inertia of a stepped, hollow shaft.

    Parameters
    ----------
    sections
        (length, diameter, bore) of each [m].
    density
        Density [kg/m³].

    Raises
    ------
    GeometryError
        If the sections do not form a shaft (see `shaft_outline`).

    Notes
    -----
    Hollow cylinders: m = ρ π/4 (D² − d²) l, J_p = m (D² + d²)/8, J_t = J_p/2 + m l²/12 about the centre of
    each, transferred to the common centre of mass by the parallel axis theorem.

    Examples
    --------
    >>> rod = shaft_mass_properties([(0.3, 0.02, 0.0)], 7830.0)
    >>> round(rod.mass, 5), rod.center, round(rod.polar_inertia * 1e6, 3)
    (0.73796, 0.15, 36.898)
    """
    shaft_outline(sections)
    parts, start = [], 0.0
    for length, outer, bore in sections:
        m = density * math.pi / 4.0 * (outer**2 - bore**2) * length
        j = m / 8.0 * (outer**2 + bore**2)
        parts.append((m, start + 0.5 * length, j, 0.5 * j + m * length**2 / 12.0))
        start += length
    mass = math.fsum(m for m, _, _, _ in parts)
    center = math.fsum(m * z for m, z, _, _ in parts) / mass if mass > 0.0 else 0.5 * start
    polar = math.fsum(j for _, _, j, _ in parts)
    across = math.fsum(t + m * (z - center) ** 2 for m, z, _, t in parts)
    return RoundMass(mass, center, polar, across)


def shaft_outline(sections: Sequence[Section]) -> list[tuple[float, float]]:
    """Corners (radius, z) of the half section of a shaft.

    Parameters
    ----------
    sections
        (length, diameter, bore) of each [m].

    Returns
    -------
    list
        Along the outside to the end, then back along the bore, or along the axis without a bore. Adjacent
        corners differ, and no three successive corners are collinear.

    Raises
    ------
    GeometryError
        If a section has no material, or two adjacent sections do not touch.

    Examples
    --------
    >>> shaft_outline([(0.1, 0.04, 0.0), (0.1, 0.06, 0.0)])
    [(0.02, 0.0), (0.02, 0.1), (0.03, 0.1), (0.03, 0.2), (0.0, 0.2), (0.0, 0.0)]
    """
    if not sections:
        raise GeometryError("has no sections", where="sections", remedy="give one section at least")
    outside, inside, z = [], [], 0.0
    for k, (length, outer, bore) in enumerate(sections):
        if not (0.0 < length < math.inf and 0.0 <= bore < outer < math.inf):
            raise GeometryError(
                "is not a piece of a shaft",
                where=f"sections.{k}",
                value=f"length {length:g} m, diameter {outer:g} m, bore {bore:g} m",
                limit="length above 0, bore below the diameter",
            )
        if k and not max(bore, sections[k - 1][2]) < min(outer, sections[k - 1][1]):
            raise GeometryError(
                "does not touch the preceding section",
                where=f"sections.{k}",
                value=f"bores and diameters {1e3 * bore:g}/{1e3 * outer:g} mm and "
                f"{1e3 * sections[k - 1][2]:g}/{1e3 * sections[k - 1][1]:g} mm",
                remedy="make one bore smaller than the other diameter",
            )
        outside += [(0.5 * outer, z), (0.5 * outer, z + length)]
        inside += [(0.5 * bore, z), (0.5 * bore, z + length)]
        z += length
    ring = [inside[0], *outside, *inside[::-1]]
    corners = [p for p, before in zip(ring, [ring[-1], *ring[:-1]], strict=True) if p != before]
    around = zip([corners[-1], *corners[:-1]], corners, [*corners[1:], corners[0]], strict=True)
    return [b for a, b, c in around if not (a[0] == b[0] == c[0] or a[1] == b[1] == c[1])]


def shaft_solid(sections: Sequence[Section], n_round: int = ROUND) -> FloatArray:
    """Closed triangulated surface of a shaft.

    Parameters
    ----------
    sections
        (length, diameter, bore) of each [m].
    n_round
        Corners of a circle, at least 3. They are on the circle, so that mass and polar inertia are too small
        by the factors (n/2π) sin(2π/n) and (n/2π) sin(2π/n) (2 + cos(2π/n))/3.

    Returns
    -------
    ndarray, shape (n, 3, 3)
        Triangles, corners counter-clockwise seen from outside [m]; axis z, start at z = 0.

    Raises
    ------
    GeometryError
        If the sections do not form a shaft, or `n_round` is below 3.

    Examples
    --------
    >>> shaft_solid([(0.1, 0.04, 0.0)], 6).shape
    (24, 3, 3)
    """
    if n_round < 3:
        raise GeometryError("corners are too few", where="n_round", value=f"{n_round}", limit="at least 3")
    corners = shaft_outline(sections)
    angle = 2.0 * math.pi / n_round * np.arange(n_round)
    x, y = np.cos(angle), np.sin(angle)
    faces = []
    for (r, z), (s, h) in zip(corners, [*corners[1:], corners[0]], strict=True):
        low = np.column_stack([r * x, r * y, np.full(n_round, z)])
        high = np.column_stack([s * x, s * y, np.full(n_round, h)])
        if r > 0.0:
            faces.append(np.stack([low, np.roll(low, -1, axis=0), high], axis=1))
        if s > 0.0:
            faces.append(np.stack([np.roll(low, -1, axis=0), np.roll(high, -1, axis=0), high], axis=1))
    return np.concatenate(faces)
