# SPDX-License-Identifier: Apache-2.0
"""Dimensions of rolling bearings in a scene; their surfaces are in `bearing_sections`.

Rolling bearings of a model have the number, diameter, pitch diameter and contact angle of their elements;
other dimensions follow from these in the proportions of catalogue bearings. Linear bearings have stiffnesses
only: they get the boundary dimensions of the dimension series 02 of ISO 15 for the shaft that carries them,
or smaller ones within the root circle of their gear.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.model.components.bearing_geometry import NEGATIVE, POSITIVE, BearingGeometry
from pitchpoint.model.components.rolling_bearing import RollingBearing

Array = NDArray[np.float64]

SERIES_02 = np.array(
    [
        (10, 30, 9),
        (20, 47, 14),
        (30, 62, 16),
        (40, 80, 18),
        (50, 90, 20),
        (60, 110, 22),
        (80, 140, 26),
        (100, 180, 34),
        (120, 215, 40),
        (150, 270, 45),
        (200, 360, 58),
        (300, 540, 85),
    ],
    dtype=float,
)
"""Bore, outside diameter and width of bearings 6200 to 6260 [mm]: ISO 15, dimension series 02."""
BALL, ROLLER = 0.31, 0.27
"""Diameter of an element relative to the difference of both diameters: 6210 has 0.32, NU 210 0.28."""
GAP = {"ball": 1.75, "roller": 1.25}
"""Spacing of the elements on the pitch circle relative to their diameter: 6210 has 10, NU 210 17."""
RIM = {"ball": 0.29, "roller": 0.4}
"""Thickness of a ring behind its raceway, relative to the diameter of an element."""
THINNEST = 0.06
"""Minimum thickness of a ring behind its raceway, relative to the diameter of an element."""


@dataclass(frozen=True, kw_only=True)
class BearingSize:
    """Dimensions of a bearing.

    Attributes
    ----------
    type
        ball or roller.
    bore, outside, width
        Boundary dimensions d, D, B [m].
    pitch, element, length
        Pitch diameter, diameter of an element and length of a roller [m].
    angle
        Contact angle; positive supports an inner ring that is loaded along +z [rad].
    count, rows
        Number of elements of a row, and of rows next to each other.
    form
        plain; sphere: outer raceway about the centre of the bearing; apart: two rows with pressure centres
        outside; thrust.
    flanges
        Cylindrical rollers: whether the inner ring has a flange at its lower and upper end.
    bare
        Without inner ring: the elements run on the shaft.
    """

    type: str
    bore: float
    outside: float
    width: float
    pitch: float
    element: float
    length: float
    angle: float
    count: int
    rows: int = 1
    form: str = "plain"
    flanges: tuple[bool, bool] = (False, False)
    bare: bool = False

    @property
    def cage_ratio(self) -> float:
        """Rotation of the cage per rotation of the inner ring relative to the outer ring, in pure rolling."""
        return 0.5 * (1.0 - self.element / self.pitch * math.cos(self.angle))


def size_of(part: RollingBearing, shaft: float | None) -> BearingSize:
    """Dimensions of a rolling bearing.

    Parameters
    ----------
    part
        The bearing.
    shaft
        Radius of the shaft in it [m]; None if unknown.

    Examples
    --------
    Elements of a bearing 6210 (d = 50 mm, D = 90 mm, B = 20 mm):

    >>> part = RollingBearing(ends=("a", "ground"), elements=10, element_diameter=12.7e-3,
    ...                       pitch_diameter=70e-3, grooves=(0.52, 0.52))
    >>> found = size_of(part, None)
    >>> [round(1e3 * x, 1) for x in (found.bore, found.outside, found.width)]
    [49.9, 90.1, 19.9]
    """
    known = part.geometry
    kind = "ball" if known.is_ball else "roller"
    d, pitch = known.element_diameter, known.pitch_diameter
    length = known.effective_length or d
    angle = known.contact_angle
    along, across = abs(math.sin(angle)), math.cos(angle)
    half = 0.5 * d if known.is_ball else 0.5 * (d * across + length * along)
    rim = RIM[kind] * d
    bore, outside = pitch - 2.0 * (half + rim), pitch + 2.0 * (half + rim)
    wide = d if known.is_ball else known.rows * length * across + d * along
    width = 1.57 * d if known.is_ball else wide + 0.8 * d
    if known.bore and known.outside and known.width:  # catalogue data
        bore, outside, width = known.bore, known.outside, known.width
    elif shaft is not None and pitch - 2.0 * half - 4.0 * rim < 2.0 * shaft < pitch - 2.0 * (
        half + THINNEST * d
    ):
        bore = 2.0 * shaft
    flanged = known.axial_clearance is not None
    return BearingSize(
        type=kind,
        bore=max(bore, 0.1 * pitch),
        outside=outside,
        width=width,
        pitch=pitch,
        element=d,
        length=length,
        angle=angle,
        count=known.elements,
        rows=known.rows,
        form=_form(known),
        flanges=(flanged and known.absorbs != NEGATIVE, flanged and known.absorbs != POSITIVE),
        bare=known.kind == "needle_roller_on_shaft",
    )


def _form(known: BearingGeometry) -> str:
    """Form of the raceways, as of `BearingSize`."""
    if known.aligns:
        return "sphere"
    return "thrust" if known.kind == "thrust_ball" else "apart" if known.row_distance > 0.0 else "plain"


def size_on(shaft: float, axial: bool, most: float = math.inf) -> BearingSize:
    """Dimensions of a bearing of the series 02 of ISO 15 on a shaft, for linear bearings.

    Parameters
    ----------
    shaft
        Radius of the shaft [m].
    axial
        Whether it supports axial loads: a deep groove ball bearing, else a cylindrical roller bearing.
    most
        Largest outside diameter [m]; a smaller bearing is narrower in proportion to its section height, as in
        lighter series.

    Examples
    --------
    >>> found = size_on(25e-3, True)
    >>> round(found.outside, 4), round(found.width, 4), found.count
    (0.09, 0.02, 10)
    >>> found = size_on(25e-3, True, 70e-3)
    >>> round(found.outside, 4), round(found.width, 4)
    (0.07, 0.01)
    """
    bores, outsides, widths = SERIES_02.T
    at = math.log(2e3 * shaft)
    outside = 2.0 * shaft * float(np.interp(at, np.log(bores), outsides / bores))
    width = 2.0 * shaft * float(np.interp(at, np.log(bores), widths / bores))
    lighter = min(1.0, (most - 2.0 * shaft) / (outside - 2.0 * shaft))
    outside, width = 2.0 * shaft + lighter * (outside - 2.0 * shaft), lighter * width
    kind = "ball" if axial else "roller"
    pitch = 0.5 * (2.0 * shaft + outside)
    element = (BALL if axial else ROLLER) * (outside - 2.0 * shaft)
    return BearingSize(
        type=kind,
        bore=2.0 * shaft,
        outside=outside,
        width=width,
        pitch=pitch,
        element=element,
        length=0.62 * width,
        angle=0.0,
        count=int(math.pi * pitch / (GAP[kind] * element)),
    )
