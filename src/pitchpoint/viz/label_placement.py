# SPDX-License-Identifier: Apache-2.0
"""Placement of labels of a drawing: each close to its place, none over another one or over a block."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.viz.svg import text

LINE = 16.0
"""Distance of lines [pixels]."""
LETTER = {"pp-halo": 8.4, "pp-small": 7.0, "pp-name": 8.0, "pp-sub": 6.7}
"""Mean width of a letter by style [pixels]."""
STEPS, SHORT, STEP = 400, 40, 2.0
"""Maximum number of the trial shifts up and down, of those to avoid lines, and their length [pixels]."""
FAR = 1e6
"""Distance beyond all drawings [pixels]."""
MARGIN, SIDE = 2.0, 7.0
"""Minimum distance of labels above and next to each other [pixels]."""
POINTS, SHORTEST = 12, 14.0
"""Number of points along a leader line in the search for crossings; length of the shortest one [pixels]."""

WIDE_STEP, TALL_STEP = 12.0, 9.0
"""Steps of a search sideways, up and down [pixels]."""
LABEL_COST, DISTANCE_COST, CROSSING_COST = 6.0, 6.0, 150.0
"""Cost of covering a label, relative to a block, of a distance [pixels], and of each point of a leader line
in a label [pixels^2]."""

Rectangle = tuple[float, float, float, float]
"""Left, top, right, bottom [pixels]."""


@dataclass(frozen=True)
class Label:
    """Lines of text: x of the anchor and y of the first baseline [pixels], anchor, (text, style) each."""

    x: float
    y: float
    anchor: str
    lines: tuple[tuple[str, str], ...]

    @property
    def box(self) -> Rectangle:
        """Rectangle of the text.

        Examples
        --------
        >>> Label(10.0, 20.0, "start", (("1 W", "pp-small"),)).box
        (10.0, 8.0, 31.0, 24.0)
        """
        width = max(len(words) * LETTER[style] for words, style in self.lines)
        left = self.x - {"start": 0.0, "middle": 0.5 * width, "end": width}[self.anchor]
        return left, self.y - 12.0, left + width, self.y + LINE * (len(self.lines) - 1) + 4.0

    def svg(self) -> str:
        """SVG elements of the label."""
        return "".join(
            text(self.x, self.y + LINE * k, words, style, self.anchor)
            for k, (words, style) in enumerate(self.lines)
        )


def placed(
    labels: Sequence[Label], blocks: Iterable[Rectangle], lines: Iterable[Rectangle] = ()
) -> list[Label]:
    """Labels shifted up or down as little as possible, so that none covers another one or a block.

    Labels at the same place keep their order from top to bottom. A label without room nearby stays.

    Parameters
    ----------
    labels
        Labels at their preferred places.
    blocks
        Rectangles to avoid.
    lines
        Rectangles along lines, which are avoided where a short shift is enough.

    Examples
    --------
    >>> one = Label(0.0, 20.0, "start", (("1 W", "pp-small"),))
    >>> [label.y for label in placed([one, one], [])]
    [20.0, 38.0]
    """
    taken, crossed = list(blocks), list(lines)
    found: dict[int, Label] = {}
    for k in sorted(range(len(labels)), key=lambda k: labels[k].y):
        label = labels[k]
        near = _first(label, [*taken, *crossed], SHORT) if crossed else None
        found[k] = near or _first(label, taken, STEPS) or label
        taken.append(found[k].box)
    return [found[k] for k in range(len(labels))]


def search(
    labels: Sequence[tuple[Label, NDArray[np.float64]]],
    blocks: Sequence[Rectangle],
    also: Sequence[Rectangle] = (),
) -> list[Label]:
    """Labels moved in both directions to places nearby where they cover least.

    The cost of a place is the covered area of other labels and of blocks, the distance from the preferred
    place, and crossings of leader lines with labels; the first labels choose first.

    Parameters
    ----------
    labels
        Labels at their preferred places, and the points that they mark [pixels].
    blocks
        Rectangles to avoid.
    also
        Rectangles to avoid as other labels.

    Examples
    --------
    >>> one = Label(0.0, 20.0, "middle", (("1 W", "pp-small"),))
    >>> [(label.x, label.y) for label in search([(one, np.zeros(2))] * 2, [])]
    [(0.0, 20.0), (0.0, 2.0)]
    """
    steps = np.array([(x * WIDE_STEP, y * TALL_STEP) for x in range(-12, 13) for y in range(-14, 15)])
    avoided = np.array(list(blocks)).reshape(-1, 4)
    reach = steps.max(axis=0)
    taken = list(also)
    found = []
    drawn: list[NDArray[np.float64]] = []
    for label, spot in labels:
        left, top, right, bottom = label.box
        near = (
            (avoided[:, 0] < right + reach[0])
            & (avoided[:, 2] > left - reach[0])
            & (avoided[:, 1] < bottom + reach[1])
            & (avoided[:, 3] > top - reach[1])
        )
        boxes = np.column_stack(
            [left + steps[:, 0], top + steps[:, 1], right + steps[:, 0], bottom + steps[:, 1]]
        )
        cost = _covered(boxes, avoided[near]) + LABEL_COST * _covered(
            boxes, np.array(taken).reshape(-1, 4), SIDE, MARGIN
        )
        cost += DISTANCE_COST * np.hypot(steps[:, 0], steps[:, 1])
        lines = _leaders(boxes, spot)
        long = np.hypot(*(lines[:, 0] - lines[:, -1]).T) > SHORTEST
        crossed = _inside(lines, np.array(taken).reshape(-1, 4)).sum(axis=(1, 2))
        cost += CROSSING_COST * np.where(long, crossed, 0)
        cost += CROSSING_COST * _inside(np.array(drawn).reshape(1, -1, 2), boxes).sum(axis=(0, 1))
        best = int(np.argmin(cost))
        drawn += [lines[best]] if long[best] else []
        dx, dy = steps[best]
        found.append(replace(label, x=label.x + float(dx), y=label.y + float(dy)))
        taken.append(found[-1].box)
    return found


def _leaders(boxes: NDArray[np.float64], spot: NDArray[np.float64]) -> NDArray[np.float64]:
    """Points along the leader line from each box to a point, shape (boxes, points, 2) [pixels]."""
    near = np.clip(spot, boxes[:, :2], boxes[:, 2:])
    along = np.linspace(0.0, 1.0, POINTS)[None, :, None]
    return np.asarray(near[:, None, :] + along * (spot - near)[:, None, :])


def _inside(points: NDArray[np.float64], boxes: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Whether points are in boxes, shape (lines, points, boxes)."""
    at = points[:, :, None, :]
    return np.asarray(((at > boxes[:, :2]) & (at < boxes[:, 2:])).all(axis=-1))


def _covered(
    boxes: NDArray[np.float64], others: NDArray[np.float64], side: float = 0.0, margin: float = 0.0
) -> NDArray[np.float64]:
    """Area of each box that others cover [pixels^2]."""
    if not len(others):
        return np.zeros(len(boxes))
    room = np.array([side, margin])
    low = np.maximum(boxes[:, None, :2], others[None, :, :2] - room)
    high = np.minimum(boxes[:, None, 2:], others[None, :, 2:] + room)
    return np.asarray(np.prod(np.maximum(high - low, 0.0), axis=2).sum(axis=1))


def common_area(a: Rectangle, b: Rectangle) -> float:
    """Common area of two rectangles.

    Examples
    --------
    >>> common_area((0.0, 0.0, 3.0, 2.0), (1.0, 1.0, 4.0, 4.0))
    2.0
    """
    wide, high = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
    return max(wide, 0.0) * max(high, 0.0)


def outside(height: float) -> list[Rectangle]:
    """Rectangles above and below a plot of some height [pixels], in which labels would be cut off."""
    return [(-FAR, -FAR, FAR, 0.0), (-FAR, height, FAR, FAR)]


def _first(label: Label, others: Sequence[Rectangle], steps: int) -> Label | None:
    """Label after the shortest shift that keeps it clear of others; None without one."""
    # down first: the labels above are in place
    shifts = (side * STEP * n for n in range(steps) for side in ((1.0, -1.0) if n else (1.0,)))
    moved = (replace(label, y=label.y + shift) for shift in shifts)
    return next((m for m in moved if not any(_meet(m.box, other) for other in others)), None)


def _meet(a: Rectangle, b: Rectangle) -> bool:
    """Whether two rectangles overlap or are closer than the margin."""
    return a[0] < b[2] + MARGIN and b[0] < a[2] + MARGIN and a[1] < b[3] + MARGIN and b[1] < a[3] + MARGIN
