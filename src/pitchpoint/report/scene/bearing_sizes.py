# SPDX-License-Identifier: Apache-2.0
"""Dimensions of rolling bearings in a scene, and the cross-sections of their rings and rolling elements.

Rolling bearings of a model have the number, diameter, pitch diameter and contact angle of their elements;
other dimensions follow from these in the proportions of catalogue bearings. Linear bearings have stiffnesses
only: they get the boundary dimensions of the dimension series 02 of ISO 15 for the shaft that carries them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.model.components.rolling_bearing import RollingBearing
from pitchpoint.report.scene import shapes

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
SHOULDER = 0.3
"""Depth of the shoulders inside the pitch circle of balls, relative to their diameter."""
GROOVE = 0.52
"""Radius of a drawn groove relative to the diameter of a ball."""
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
    angle = known.contact_angle if known.rows == 1 else 0.0
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
    )


def size_on(shaft: float, axial: bool) -> BearingSize:
    """Dimensions of a bearing of the series 02 of ISO 15 on a shaft, for linear bearings.

    Parameters
    ----------
    shaft
        Radius of the shaft [m].
    axial
        Whether it supports axial loads: a deep groove ball bearing, else a cylindrical roller bearing.

    Examples
    --------
    >>> found = size_on(25e-3, True)
    >>> round(found.outside, 4), round(found.width, 4), found.count
    (0.09, 0.02, 10)
    """
    bores, outsides, widths = SERIES_02.T
    at = math.log(2e3 * shaft)
    outside = 2.0 * shaft * float(np.interp(at, np.log(bores), outsides / bores))
    width = 2.0 * shaft * float(np.interp(at, np.log(bores), widths / bores))
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


def ring(size: BearingSize, inner: bool, sides: int = 48) -> shapes.Surface:
    """Surface of a ring with its raceway, about the third axis, the middle of the elements at the origin.

    Parameters
    ----------
    size
        Dimensions of the bearing.
    inner
        The inner one.
    sides
        Number of corners of a circle.
    """
    h = 0.5 * size.width
    seat = 0.5 * (size.bore if inner else size.outside)
    race = raceway(size, inner)
    ends = [(seat, -h), (seat, h)]
    # counter-clockwise in the section: the seat of an inner ring is on the left
    line = [ends[0], *race, ends[1]] if inner else [*ends, *race[::-1]]
    return shapes.turned_profile([*line, line[0]], sides)


def raceway(size: BearingSize, inner: bool) -> Array:
    """Radius and height along the inside of a ring from its lower to its upper face, shape (n, 2) [m]."""
    h, sign = 0.5 * size.width, -1.0 if inner else 1.0
    middle, thin = 0.5 * size.pitch, THINNEST * size.element
    seat = 0.5 * (size.bore if inner else size.outside)
    if size.type == "ball":
        # low shoulder on the side where balls with a contact angle are not supported
        radius = GROOVE * size.element
        bottom = middle + sign * 0.5 * size.element
        centre = bottom - sign * radius
        found = []
        for side in (-1.0, 1.0):
            open_side = size.angle * side * sign < 0.0
            edge = middle + sign * (0.42 if open_side else SHOULDER) * size.element
            most = math.acos(min(1.0, abs(edge - centre) / radius))
            angles = np.linspace(0.0, most, 5)
            arc = [(centre + sign * radius * math.cos(a), side * radius * math.sin(a)) for a in angles]
            found.append([*arc, (edge, side * h)])
        line = np.array([*found[0][::-1], *found[1][1:]])
    else:
        (r0, z0), (r1, z1) = roller_line(size, sign)
        slope = (r1 - r0) / (z1 - z0)
        line = np.array([(r0 + slope * (z - z0), z) for z in (-h, z0, z1, h)])
        if not inner and size.angle == 0.0:
            # ribs guide the rollers
            rib = middle + 0.3 * size.element
            line = np.array([(rib, -h), (rib, z0), (r0, z0), (r1, z1), (rib, z1), (rib, h)])
    limit = seat - sign * thin
    line[:, 0] = np.minimum(line[:, 0], limit) if not inner else np.maximum(line[:, 0], limit)
    return line


def roller_line(size: BearingSize, sign: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """Ends of the contact line of a roller with the inner (-1) or outer (1) ring, lower end first: (r, z).

    The cone of a roller and both raceways have a common apex on the axis of the bearing, as for pure rolling.
    """
    ends = []
    for place in (-0.5 * size.rows, 0.5 * size.rows):
        half = 0.5 * size.element * (1.0 - 2.0 * place * size.length / size.pitch * math.sin(size.angle))
        r = 0.5 * size.pitch - place * size.length * math.sin(size.angle) + sign * half * math.cos(size.angle)
        ends.append((r, place * size.length * math.cos(size.angle) + sign * half * math.sin(size.angle)))
    return ends[0], ends[1]


def element_surface(size: BearingSize, sides: int, row: int = 0) -> shapes.Surface:
    """Surface of a ball or roller of a row, above the first axis."""
    size_of_row = size.length if size.type == "roller" else size.element
    place = (0.5 * size.pitch, 0.0, 1.04 * (row - 0.5 * (size.rows - 1)) * size_of_row)
    if size.type == "ball":
        return shapes.ball(0.5 * size.element, place, sides)
    low, high = (
        0.5 * size.element * (1.0 - 2.0 * s * size.length / size.pitch * math.sin(size.angle))
        for s in (-0.5, 0.5)
    )
    edge, h = 0.04 * size.element, 0.5 * size.length
    line = [(0.0, -h), (low - edge, -h), (low, edge - h), (high, h - edge), (high - edge, h), (0.0, h)]
    direction = (-math.sin(size.angle), 0.0, math.cos(size.angle))
    return shapes.moved(shapes.turned_profile(line, sides), place, shapes.across(direction))


def spall(size: BearingSize, inner: bool, half: float, sides: int = 12) -> shapes.Surface:
    """Patch over the width of a track around the first axis, over the angle 2 `half` [rad]."""
    line = raceway(size, inner)
    track = line[np.abs(line[:, 1]) <= 0.5 * (size.length if size.type == "roller" else 0.9 * size.element)]
    if not inner:
        track = track[track[:, 0] > 0.5 * size.pitch + 0.4 * size.element * math.cos(size.angle)]
    raised = track[:, 0] - (-1.0 if inner else 1.0) * 0.015 * size.element
    angles = np.linspace(-half, half, sides + 1)
    rows, wide = sides + 1, len(track)
    points = np.array(
        [
            (r * math.cos(a), r * math.sin(a), z)
            for a in angles
            for r, z in zip(raised, track[:, 1], strict=True)
        ]
    )
    k = np.array([i * wide + j for i in range(rows - 1) for j in range(wide - 1)])
    faces = np.concatenate([np.c_[k, k + wide, k + 1], np.c_[k + 1, k + wide, k + wide + 1]])
    return points, faces if inner else faces[:, ::-1]
