# SPDX-License-Identifier: Apache-2.0
"""Inner geometry of rolling bearings from catalogue data.

The pitch diameter is the mean of bore and outside diameter. Number and size of the rolling elements reproduce
the static load rating exactly and, as closely as possible at the same time, the dynamic load rating and the
usual proportions of the type (weighted least squares). The static load rating follows from geometry alone;
many makers raise the dynamic one for better steel, so it has the weight of one source among three. Sources:
ISO 281:2007, ISO 76:2006; proportions fitted to the ratings of NSK CAT. No. E1102.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.bearings.ratings import (
    BALL_GAMMA,
    ball_dynamic,
    ball_static,
    roller_dynamic,
    roller_static,
)

BALL_TYPES = (
    *("deep_groove_ball", "angular_contact_ball", "double_row_angular_contact_ball"),
    *("self_aligning_ball", "thrust_ball"),
)
NEEDLE_TYPES = ("needle_roller", "needle_roller_on_shaft")
"""Needle roller bearings with inner ring, and without: their rollers run on the shaft, d is F_w."""
ROLLER_TYPES = ("cylindrical_roller", "tapered_roller", "spherical_roller", *NEEDLE_TYPES)
TYPES = (*BALL_TYPES, *ROLLER_TYPES)
GROOVES = (0.52, 0.53)
"""Groove radii of inner and outer ring over the ball diameter: the largest of ISO 281."""
INNER_SPHERE, WASHERS = 0.53, (0.54, 0.54)
"""The same of the inner ring of self-aligning ball bearings, and of thrust bearings (ISO 76)."""
ROW_SPACING = 1.07
"""Distance e of the rows of a double-row angular contact bearing over the ball diameter: with it the distance
of the pressure centres d_m tan(alpha) + e is that of the catalogue within 3.1 %."""
LOOSE_RATING = 0.03
"""Relative deviation of the dynamic load rating with the weight of one standard deviation."""
RATINGS_APART = 0.25
"""Deviation of the dynamic load rating from ISO 281 beyond which the data are refused as contradictory."""
ODD_SIZE = 2.0
"""Ratio, either way, of an estimated element diameter to the usual one of the type beyond which the data are
refused: 0.72 to 1.23 in the whole catalogue."""
LONG = 0.9
"""Largest effective length of all rows over the width of the bearing."""


@dataclass(frozen=True)
class Proportions:
    """Usual proportions of a bearing type, each with its relative standard deviation."""

    section: tuple[float, float]
    """Diameter of an element over D - d."""
    filled: tuple[float, float]
    """Sum of the element diameters over the pitch circle; of deep groove bearings the angle of filling
    2 (Z - 1) asin(D_w/d_m) [rad], by which the balls are inserted."""
    rows: int = 1
    rating: float = 1.1
    """Factor b_m of the dynamic load rating (rollers)."""
    race: str = "groove"
    """Outer raceway of balls, as of `ratings.ball_static`."""


PROPORTIONS = {
    "deep_groove_ball": Proportions((0.30, 0.06), (math.radians(188.0), 0.04)),
    "angular_contact_ball": Proportions((0.31, 0.06), (0.88, 0.06)),
    "double_row_angular_contact_ball": Proportions((0.29, 0.06), (0.58, 0.06), rows=2),
    "self_aligning_ball": Proportions((0.245, 0.06), (0.775, 0.06), rows=2, race="sphere"),
    "thrust_ball": Proportions((0.36, 0.08), (0.90, 0.06), race="washer"),
    "cylindrical_roller": Proportions((0.25, 0.06), (0.80, 0.08)),
    "tapered_roller": Proportions((0.25, 0.06), (0.90, 0.08)),
    "spherical_roller": Proportions((0.25, 0.06), (0.84, 0.08), rows=2, rating=1.15),
    "needle_roller": Proportions((0.20, 0.15), (0.75, 0.12)),
    "needle_roller_on_shaft": Proportions((0.30, 0.15), (0.75, 0.12)),
}


@dataclass(frozen=True)
class InnerGeometry:
    """Rolling elements of a bearing.

    Attributes
    ----------
    elements
        Number of elements of a row.
    element_diameter, pitch_diameter
        Diameters [m]; of tapered rollers in the middle.
    effective_length
        Effective length of a roller [m]; None for balls.
    rows
        Number of rows.
    dynamic
        Dynamic load rating by ISO 281 with this geometry [N].
    """

    elements: int
    element_diameter: float
    pitch_diameter: float
    effective_length: float | None
    rows: int
    dynamic: float


@lru_cache(maxsize=4096)
def inner_geometry(
    kind: str,
    bore: float,
    outside: float,
    width: float,
    dynamic: float,
    static: float,
    angle: float = 0.0,
) -> InnerGeometry:
    """Estimate the rolling elements of a bearing from catalogue data.

    Parameters
    ----------
    kind
        One of `TYPES`.
    bore, outside, width
        Boundary dimensions d, D, B [m]; of tapered bearings the overall width T.
    dynamic, static
        Load ratings C and C_0 [N].
    angle
        Contact angle, without sign [rad].

    Raises
    ------
    GeometryError
        If no set of elements of usual size has these load ratings in these dimensions.

    Examples
    --------
    6205: the bearing of a well-known fault data set has nine balls of 7.94 mm on 39.04 mm.

    >>> found = inner_geometry("deep_groove_ball", 25e-3, 52e-3, 15e-3, 14000.0, 7850.0)
    >>> found.elements, round(1e3 * found.element_diameter, 2), 1e3 * found.pitch_diameter
    (9, 7.95, 38.5)
    """
    usual = PROPORTIONS[kind]
    pitch = 0.5 * (bore + outside)
    best: tuple[float, InnerGeometry] | None = None
    if kind in BALL_TYPES:
        search = _balls(usual, pitch, outside - bore, static, angle)
    else:
        on_shaft = bore if kind == "needle_roller_on_shaft" else None
        search = _rollers(usual, pitch, outside - bore, width, static, angle, on_shaft)
    for found in search:
        pitch = found.pitch_diameter
        spacing = found.elements * found.element_diameter / (math.pi * pitch)
        if kind == "deep_groove_ball":
            spacing = 2.0 * (found.elements - 1) * math.asin(found.element_diameter / pitch)
        score = (math.log(found.dynamic / dynamic) / LOOSE_RATING) ** 2
        for value, (mean, deviation) in (
            (found.element_diameter / (outside - bore), usual.section),
            (spacing, usual.filled),
        ):
            score += (math.log(value / mean) / deviation) ** 2
        if best is None or score < best[0]:
            best = score, found
    if best is None:
        raise GeometryError(
            f"is not the static load rating of a {kind.replace('_', ' ')} bearing of these dimensions",
            where="radial_static_load_rating",
            value=f"{static * 1e-3:.6g} kN",
            remedy="check the units of the dimensions and load ratings, or give elements, element_diameter "
            "and pitch_diameter",
        )
    section, typical = 0.5 * (outside - bore), usual.section[0] * (outside - bore)
    low, high = typical / ODD_SIZE, min(typical * ODD_SIZE, section)
    if not low < best[1].element_diameter < high:
        raise GeometryError(
            f"leads to elements of {best[1].element_diameter * 1e3:.4g} mm in a section "
            f"(D - d)/2 = {1e3 * section:.4g} mm",
            where="radial_static_load_rating",
            value=f"{static:.6g} N",
            limit=f"elements of {1e3 * low:.3g} to {1e3 * high:.3g} mm",
            remedy="load ratings without unit are in N; write kN for those of a catalogue, or check the "
            "dimensions",
        )
    apart = best[1].dynamic / dynamic - 1.0
    if abs(apart) > RATINGS_APART:
        raise GeometryError(
            f"does not fit the static load rating, by which it is {best[1].dynamic * 1e-3:.4g} kN (ISO 281)",
            where="radial_dynamic_load_rating",
            value=f"{dynamic * 1e-3:.6g} kN",
            limit=f"{100 * RATINGS_APART:.0f} % difference",
            remedy="check the type and both load ratings, which are in N without unit, or give elements, "
            "element_diameter and pitch_diameter",
        )
    return best[1]


def _balls(
    usual: Proportions, pitch: float, section: float, static: float, angle: float
) -> Iterator[InnerGeometry]:
    """Every number of balls with the diameter that has the static load rating."""
    end = (pitch, angle, usual.rows, usual.race)
    largest = 0.5 * section
    if usual.race != "washer":
        largest = min(largest, BALL_GAMMA * pitch / math.cos(angle))
    for elements in range(3, 200):
        if ball_static(elements, largest, *end) < static:
            continue
        low, high = 1e-3 * largest, largest
        for _ in range(40):
            size = 0.5 * (low + high)
            low, high = (size, high) if ball_static(elements, size, *end) < static else (low, size)
        if elements * math.asin(size / pitch) > math.pi:
            return
        yield InnerGeometry(elements, size, pitch, None, usual.rows, ball_dynamic(elements, size, *end))


def _rollers(
    usual: Proportions,
    pitch: float,
    section: float,
    width: float,
    static: float,
    angle: float,
    on_shaft: float | None,
) -> Iterator[InnerGeometry]:
    """Numbers and diameters of rollers with the length that has the static load rating.

    `on_shaft`: diameter of the shaft on which the rollers run [m], from which their pitch diameter follows.
    """
    for step in range(141):
        size = (0.10 + 0.002 * step) * section
        if on_shaft is not None:
            pitch = on_shaft + size
        for elements in range(4, int(math.pi / math.asin(size / pitch)) + 1):
            length = static / roller_static(elements, size, 1.0, pitch, angle, usual.rows)
            if length * usual.rows <= LONG * width:
                rating = roller_dynamic(elements, size, length, pitch, angle, usual.rows, usual.rating)
                yield InnerGeometry(elements, size, pitch, length, usual.rows, rating)
