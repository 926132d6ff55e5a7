# SPDX-License-Identifier: Apache-2.0
"""Schematic housing in section: walls through the outermost bearing seats, around all gears."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pitchpoint.report.section.boxes import box_line
from pitchpoint.report.section.layout import gaps
from pitchpoint.viz.section_content import SectionAxis

Array = NDArray[np.float64]

ROOM, WALL = 0.07, 0.45
"""Distance of the walls from the gears, relative to the height of the drawing; thickness of the walls,
relative to the narrowest seat."""
PLANE = 1.2
"""Distance of seats, in widths of the narrowest, up to which they are in one wall."""
OPEN = 1.2
"""Radius of the opening for a shaft relative to that of the shaft."""
INSIDE = ("gear", "teeth", "plate", "held")


def walls_of(axes: Sequence[SectionAxis]) -> list[Array]:
    """Cut walls of a housing with seats in two planes; none for axes at an angle.

    Parameters
    ----------
    axes
        The axes in the drawing plane.
    """
    if any(abs(float(axis.way[1])) > 1e-9 for axis in axes):
        return []
    seats = [(axis, piece) for axis in axes for piece in axis.pieces if piece.kind == "seat"]
    places = [_middle(axis, piece.line) for axis, piece in seats]
    if len(seats) < 2:
        return []
    width = min(float(np.ptp(piece.line[:, 0])) for _, piece in seats)
    left, right = min(places), max(places)
    inside = [
        axis.at(piece.line, sign)
        for axis in axes
        for piece in axis.pieces
        if piece.kind in INSIDE
        for sign in (1.0, -1.0)
    ]
    if not inside or right - left < 2.0 * PLANE * width:
        return []
    corners = np.concatenate([*inside, *(axis.at(p.line, sign) for axis, p in seats for sign in (1.0, -1.0))])
    low, high = float(corners[:, 1].min()), float(corners[:, 1].max())
    room, thick = ROOM * (high - low), WALL * width
    low, high = low - room, high + room
    found = []
    edges = []
    for x in (left, right):
        near = [
            (axis, piece)
            for (axis, piece), place in zip(seats, places, strict=True)
            if abs(place - x) < PLANE * width
        ]
        at = float(np.mean([_middle(axis, piece.line) for axis, piece in near]))
        edges.append((at - 0.5 * thick, at + 0.5 * thick))
        taken = []
        for axis in axes:
            reach = [float(piece.line[:, 1].max()) for one, piece in near if one is axis]
            reach += [OPEN * r for r in _shafts_at(axis, at)] if not reach else []
            if reach:
                y = float(axis.origin[1])
                taken.append((y - max(reach), y + max(reach)))
        found += [box_line(*edges[-1], a, b) for a, b in gaps(taken, low, high)]
    across = [(float(c[:, 0].min()), float(c[:, 0].max())) for c in inside]
    if any(a < edge and b > start for start, edge in edges for a, b in across):
        return []  # bearings between gears, such as those of a carrier
    start, end = edges[0][0], edges[1][1]
    return [*found, box_line(start, end, low - thick, low), box_line(start, end, high, high + thick)]


def _middle(axis: SectionAxis, line: Array) -> float:
    return float(axis.at(line)[:, 0].mean())


def _shafts_at(axis: SectionAxis, x: float) -> list[float]:
    """Radii of the shafts of an axis that pass a wall."""
    found = []
    for piece in axis.pieces:
        ends = axis.at(piece.line)[:, 0]
        if piece.kind in ("shaft", "spindle", "flange", "mass", "plate") and ends.min() <= x <= ends.max():
            found.append(float(piece.line[:, 1].max()))
    return found
