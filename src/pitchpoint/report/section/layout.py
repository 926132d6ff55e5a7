# SPDX-License-Identifier: Apache-2.0
"""Developed section: all axes unfolded into one plane, in the order of the power flow.

Each axis is placed at its true distance from the axis before, or at the true shaft angle through the common
apex of bevel gears, so that the gears of this mesh touch at the pitch line. Of both sides the one is taken on
which less is covered; if both are taken, the axis is drawn apart and the mesh is marked.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from pitchpoint.report.section.axes import Joined, Line
from pitchpoint.viz.label_placement import common_area

Array = NDArray[np.float64]
Box = tuple[float, float, float, float]

COVERED = 0.08
"""Share of the area of an axis that others may cover before it is drawn apart."""
APART = 0.1
"""Gap next to an axis that is drawn apart, relative to the size of the drawing so far."""


@dataclass(frozen=True)
class Frame:
    """Place of an axis in the drawing plane: origin, direction, upper side, and the side it was unfolded
    to."""

    origin: Array
    way: Array
    side: Array
    turned: float = -1.0

    def at(self, z: float, r: float) -> Array:
        """Point of the drawing plane."""
        return np.asarray(self.origin + z * self.way + r * self.side)


def unfold(
    lines: Sequence[Line],
    joined: Sequence[Joined],
    hulls: Mapping[int, Sequence[Box]],
    order: Sequence[int],
    apexes: Mapping[str, Array],
) -> dict[int, Frame]:
    """Frames of the axes.

    Parameters
    ----------
    lines
        The axes.
    joined
        Their connections.
    hulls
        Rectangles (low, high position, inner, outer radius) of the parts of the axes to draw.
    order
        Axes in the order of the power flow; the first one of every train stays.
    apexes
        Common apex of bevel meshes in the world [m].
    """
    frames: dict[int, Frame] = {}
    taken: list[Box] = []
    for root in order:
        if root in frames or root not in hulls:
            continue
        frame = Frame(np.zeros(2), np.array([1.0, 0.0]), np.array([0.0, 1.0]))
        if taken:
            frame = _below(frame, hulls[root], taken)
        frames[root] = frame
        taken += _boxes(frame, hulls[root])
        queue = deque([root])
        while queue:
            here = queue.popleft()
            for each, there in _neighbours(joined, here, order):
                if there in frames or there not in hulls:
                    continue
                frames[there] = _placed(
                    frames[here], (lines[here], lines[there]), each, hulls[there], taken, apexes
                )
                taken += _boxes(frames[there], hulls[there])
                queue.append(there)
    return frames


def _neighbours(joined: Sequence[Joined], here: int, order: Sequence[int]) -> list[tuple[Joined, int]]:
    """Connections of an axis and the axes at their other ends; planets by their carrier, in the order of the
    flow."""
    carried = {each.lines[1] for each in joined if each.kind == "carrier"}
    found = []
    for each in joined:
        if here in each.lines:
            there = each.lines[1 - each.lines.index(here)]
            if each.kind == "mesh" and there in carried:
                continue
            found.append((each, there))
    return sorted(found, key=lambda pair: order.index(pair[1]))


def _placed(
    frame: Frame,
    lines: tuple[Line, Line],
    each: Joined,
    hull: Sequence[Box],
    taken: Sequence[Box],
    apexes: Mapping[str, Array],
) -> Frame:
    """Frame of an axis next to another one."""
    here, there = lines
    sides = (frame.turned, -frame.turned)
    if each.kind == "bevel":
        tried = [_inclined(frame, here, there, apexes[each.name], side) for side in sides]
    else:
        distance = float(np.linalg.norm(there.point - here.point))
        if each.kind == "carrier":
            sides = (1.0, -1.0)
        tried = [
            Frame(frame.origin + side * distance * frame.side, frame.way, frame.side, side) for side in sides
        ]
    size = sum((b[2] - b[0]) * (b[3] - b[1]) for b in _boxes(tried[0], hull))
    covered = [
        sum(common_area(one, other) for one in _boxes(each_frame, hull) for other in taken)
        for each_frame in tried
    ]
    best = min((0, 1), key=lambda k: (round(covered[k] / max(size, 1e-12), 3), k))
    if covered[best] > COVERED * size and each.kind == "mesh":
        return _below(tried[0], hull, taken)
    return tried[best]


def _inclined(frame: Frame, here: Line, there: Line, apex: Array, side: float) -> Frame:
    """Frame of the axis of a bevel gear, turned about the common apex by the angle between the axes."""
    cosine = float(here.way @ there.way)
    sine = float(np.sqrt(max(0.0, 1.0 - cosine**2)))
    way = cosine * frame.way + side * sine * frame.side
    across = np.array([-way[1], way[0]])
    across = across if across @ frame.way <= 0.0 or side > 0.0 else across
    origin = frame.at(float(here.way @ apex), 0.0) - float(there.way @ apex) * way
    return Frame(origin, way, across, side)


def _below(frame: Frame, hull: Sequence[Box], taken: Sequence[Box]) -> Frame:
    """The frame moved below everything drawn so far."""
    boxes = _boxes(frame, hull)
    top, low = max(b[3] for b in boxes), min(b[1] for b in taken)
    size = max(max(b[2] for b in taken) - min(b[0] for b in taken), max(b[3] for b in taken) - low)
    return Frame(frame.origin + np.array([0.0, low - top - APART * size]), frame.way, frame.side, -1.0)


def _boxes(frame: Frame, hull: Sequence[Box]) -> list[Box]:
    """Rectangles of the drawing plane around the parts of an axis."""
    found = []
    for low, high, inner, outer in hull:
        for sign in (1.0, -1.0) if inner > 0.0 else (0.0,):
            radii = (sign * inner, sign * outer) if sign else (-outer, outer)
            corners = np.array([frame.at(z, r) for z in (low, high) for r in radii])
            (x0, y0), (x1, y1) = corners.min(axis=0), corners.max(axis=0)
            found.append((float(x0), float(y0), float(x1), float(y1)))
    return found


def gaps(taken: Sequence[tuple[float, float]], low: float, high: float) -> list[tuple[float, float]]:
    """Parts of an interval that others leave free.

    Examples
    --------
    >>> gaps([(1.0, 2.0), (1.5, 3.0)], 0.0, 4.0)
    [(0.0, 1.0), (3.0, 4.0)]
    """
    joined: list[list[float]] = []
    for start, end in sorted(taken):
        if joined and start <= joined[-1][1]:
            joined[-1][1] = max(joined[-1][1], end)
        else:
            joined.append([start, end])
    edges = [low, *(e for pair in joined for e in pair), high]
    return [(a, b) for a, b in list(pairwise(edges))[::2] if b > a]
