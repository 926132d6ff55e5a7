# SPDX-License-Identifier: Apache-2.0
"""Placement of labels of a drawing: each close to its place, none over another one or over a block."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from pitchpoint.viz.svg import text

LINE = 16.0
"""Distance of lines [pixels]."""
LETTER = {"pp-halo": 8.4, "pp-small": 7.0}
"""Mean width of a letter by style [pixels]."""
STEPS, SHORT, STEP = 400, 40, 2.0
"""Maximum number of the trial shifts up and down, of those to avoid lines, and their length [pixels]."""
FAR = 1e6
"""Distance beyond all drawings [pixels]."""
MARGIN = 2.0
"""Minimum distance of labels [pixels]."""

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
