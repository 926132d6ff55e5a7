# SPDX-License-Identifier: Apache-2.0
"""Names of the parts of a gearbox in section, with leader lines where they are away from their parts."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.words import shortened
from pitchpoint.viz import svg
from pitchpoint.viz.label_placement import FAR, LINE, Label, Rectangle, common_area, search
from pitchpoint.viz.section_content import Piece, Section, SectionAxis

Array = NDArray[np.float64]
View = Callable[[Array], Array]

AXIS_END = 16.0
"""Length of centre lines beyond the parts [pixels]."""
LEADER, ASIDE = 20.0, 6.0
"""Distance of a label from its part from which it has a leader line, and of its middle from the edge of a
narrow part [pixels]."""
BLOCKS = (
    *(
        "gear",
        "teeth",
        "outer",
        "linear",
        "plate",
        "mass",
        "flange",
        "seat",
        "pedestal",
        "held",
        "lining",
        "ground",
    ),
    *("shaft", "spindle"),
)
"""Kinds of parts that labels avoid."""
TOUCH = 0.06
"""Relative difference of radii, and distance in widths, up to which gears are halves of one."""
RANGE, LONG = " … ", 24
"""Separator of the first and last name of a range, and the length [letters] from which it ends a line."""
LONGEST, WIDEST = 22, 38
"""Letters of a name up to which it is complete, and of a line with names of an axis."""
NAMES, OTHERS = "pp-name", "pp-sub"
"""Styles of the names of gears and carriers, and of all others."""


@dataclass(frozen=True)
class _Wanted:
    """Label at its preferred place, the point that it marks and the rectangle of its part."""

    label: Label
    spot: Array
    part: Rectangle


def section_labels(
    view: View, section: Section, room: tuple[float, float, float]
) -> tuple[list[Label], list[str]]:
    """Names of gears, bearings, couplings and masses, and of inclined axes; and leader lines.

    Parameters
    ----------
    view
        Transformation from the drawing plane [m] to pixels.
    section
        The section.
    room
        Left edge, top and right edge of the drawing [pixels].
    """
    blocks = [
        _box(view(axis.at(p.line, s)))
        for axis in section.axes
        for p in axis.pieces
        if p.kind in BLOCKS
        for s in (1.0, -1.0)
    ]
    wanted = [
        _wanted(view, axis, piece, blocks)
        for axis in section.axes
        for piece in axis.pieces
        if piece.name and piece.kind != "pitch"
    ]
    wanted.sort(key=lambda each: each.label.lines[0][1] == OTHERS)
    inclined = (axis for axis in section.axes if axis.name and abs(float(axis.way[1])) >= 1e-9)
    wanted = [*(_of_axis(view, axis) for axis in inclined), *wanted]
    for link in section.apart:
        x, y = view(0.5 * (link.start + link.end))
        label = Label(float(x), float(y), "middle", ((shortened(link.words, LONGEST), OTHERS),))
        wanted.append(_Wanted(label, np.array([x, y]), label.box))
    outside = [(-FAR, -FAR, room[0], FAR), (room[2], -FAR, FAR, FAR)]  # names of axes, dimensions
    labels = search([(_inside(each.label, room), each.spot) for each in wanted], blocks, outside)
    leaders = []
    for label, each in zip(labels, wanted, strict=True):
        left, top, right, bottom = label.box
        away = max(each.part[0] - right, left - each.part[2], each.part[1] - bottom, top - each.part[3])
        aside = abs(0.5 * (left + right - each.part[0] - each.part[2])) - 0.5 * (each.part[2] - each.part[0])
        narrow = each.part[2] - each.part[0] < 0.5 * (right - left)
        if away > LEADER or (narrow and aside > ASIDE):
            near = np.array([min(max(each.spot[0], left), right), min(max(each.spot[1], top), bottom)])
            leaders.append(
                svg.line(near, each.spot, "pp-leader") + svg.circle(each.spot, 2.0, "pp-leader-dot")
            )
    return labels, leaders


def axis_lines(axis: SectionAxis) -> list[tuple[str, str]]:
    """Name and numbers of an axis, by style."""
    if not axis.name:
        return []
    names = shortened(axis.name, LONGEST)
    lines = textwrap.wrap(names, WIDEST, break_long_words=False, break_on_hyphens=False)
    return [
        *((line, "pp-halo") for line in lines),
        *((shortened(words, LONGEST), "pp-small") for words in axis.words),
    ]


def reach(axis: SectionAxis) -> tuple[float, float]:
    """Ends of the parts of an axis [m]."""
    ends = np.concatenate([piece.line[:, 0] for piece in axis.pieces])
    return float(ends.min()), float(ends.max())


def _of_axis(view: View, axis: SectionAxis) -> _Wanted:
    """Label of an inclined axis above its upper end."""
    ends = view(axis.at(np.array([(z, 0.0) for z in reach(axis)])))
    top = ends[int(np.argmin(ends[:, 1]))]
    lines = tuple(axis_lines(axis))
    y = float(top[1]) - AXIS_END - 6.0 - LINE * (len(lines) - 1)
    label = Label(float(top[0]), y, "middle", lines)
    return _Wanted(label, top, label.box)


def _wanted(view: View, axis: SectionAxis, piece: Piece, blocks: Sequence[Rectangle]) -> _Wanted:
    """Label of a part above or below it, where fewer other parts are."""
    named = piece.kind in ("teeth", "plate")
    name = shortened(piece.name, LONGEST)
    words = f"{name} ({piece.words})" if piece.words and piece.kind == "teeth" else name
    start, dots, rest = words.partition(RANGE if len(words) > LONG else "\n")
    lines = tuple((text, NAMES if named else OTHERS) for text in (start + dots, rest) if text)
    tried = []
    for sign in (1.0, -1.0):
        box = _box(view(axis.at(piece.line, sign)))
        middle = 0.5 * (box[0] + box[2])
        level = abs(float(axis.way[1])) < 0.5
        upper = box[1] <= float(view(axis.origin)[1]) if level else sign > 0.0
        y = box[1] - 9.0 - LINE * (len(lines) - 1) if upper else box[3] + 17.0
        side = _neighbour(axis, piece)
        label = Label(middle, y, "middle", lines)
        if side and level:  # both halves of a scissor gear: names to both sides
            label = Label(box[0] if side < 0.0 else box[2], y, "start" if side < 0.0 else "end", lines)
        tried.append(_Wanted(label, np.array([middle, 0.5 * (box[1] + box[3])]), box))
    covered = [sum(common_area(each.label.box, block) for block in blocks) for each in tried]
    return tried[int(covered[1] < covered[0])]


def _neighbour(axis: SectionAxis, piece: Piece) -> float:
    """Side in the drawing (1 right, -1 left) on which a gear of the same size touches a gear, such as the
    other half of a scissor gear; 0 without."""
    if piece.kind != "teeth":
        return 0.0
    (low, _), (high, top) = piece.line.min(axis=0), piece.line.max(axis=0)
    for other in axis.pieces:
        if other.kind == "teeth" and other is not piece and other.name:
            (start, _), (end, outer) = other.line.min(axis=0), other.line.max(axis=0)
            near = TOUCH * (high - low + end - start)
            touches = min(abs(start - high), abs(end - low)) < near
            if touches and abs(outer - top) < TOUCH * top:
                return float(np.sign((start - low) * axis.way[0]))
    return 0.0


def _inside(label: Label, room: tuple[float, float, float]) -> Label:
    """Label moved sideways into the drawing."""
    left, _, right, _ = label.box
    return replace(label, x=label.x + max(room[0] - left, 0.0) - max(right - room[2], 0.0))


def _box(points: Array) -> Rectangle:
    (x0, y0), (x1, y1) = points.min(axis=0), points.max(axis=0)
    return float(x0), float(y0), float(x1), float(y1)
