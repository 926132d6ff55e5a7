# SPDX-License-Identifier: Apache-2.0
"""Names of the gears of a transverse view: in the gear where there is room, else in columns beside the view."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.words import shortened
from pitchpoint.viz import svg
from pitchpoint.viz.label_placement import LETTER, LINE, Label
from pitchpoint.viz.labels import spread

if TYPE_CHECKING:
    from pitchpoint.viz.transverse_drawing import Wheel

Array = NDArray[np.float64]

STYLE = "pp-name"
LONGEST, WIDEST = 24, 28
"""Letters of a name up to which it is complete, and of a line."""
ROOM = 4.0
"""Least distance of a name from the circles around it [pixels]."""
COLUMN = 26.0
"""Distance of a column of names from the view [pixels]."""
STEP = LINE + 3.0
"""Distance of the names of a column [pixels]."""
STEEP = 65.0
"""Largest angle between the horizontal and the points at which leader lines end on a pitch circle [deg]."""


@dataclass(frozen=True)
class Outside:
    """A name beside the view.

    Attributes
    ----------
    lines
        Lines of the name.
    centre
        Centre of the gear [pixels].
    radius
        Radius of its pitch circle [pixels].
    """

    lines: tuple[tuple[str, str], ...]
    centre: Array
    radius: float


def wheel_labels(
    wheels: Sequence[Wheel], at: Callable[[Array], Array], scale: float
) -> tuple[list[Label], list[Outside]]:
    """Names in the gears, and those without room there.

    Parameters
    ----------
    wheels
        The gears.
    at
        Transformation from the transverse plane [m] to pixels.
    scale
        Pixels per metre.
    """
    inside: list[Label] = []
    outside: list[Outside] = []
    for wheel in wheels:
        centre = at(wheel.centre)
        coaxial = [w for w in wheels if w is not wheel and np.hypot(*(w.centre - wheel.centre)) * scale < 4.0]
        smaller = [w.tip for w in coaxial if w.tip > w.root and w.pitch < wheel.pitch]
        free = scale * max(smaller, default=0.0)
        root = scale * min(wheel.tip, wheel.root)
        fitting = (
            label
            for lines in (_lines(wheel.name, 2 * len(wheel.name)), _lines(wheel.name, WIDEST // 2))
            if (label := _within(centre, lines, free, root)) is not None
        )
        label = next(fitting, None) if wheel.tip > wheel.root else None
        if label is not None:
            inside.append(label)
        elif wheel.first:
            outside.append(Outside(_lines(wheel.group or wheel.name, WIDEST), centre, wheel.pitch * scale))
    return inside, outside


def _lines(words: str, widest: int) -> tuple[tuple[str, str], ...]:
    """Lines of a name."""
    parts = textwrap.wrap(shortened(words, LONGEST), widest, break_long_words=False, break_on_hyphens=False)
    return tuple((part, STYLE) for part in parts)


def _within(centre: Array, lines: tuple[tuple[str, str], ...], free: float, root: float) -> Label | None:
    """Name in the upper half of a gear between two circles; None without room."""
    tall = LINE * len(lines)
    height = 0.5 * (free + root) if free else max(0.45 * root, 0.5 * tall + ROOM)
    label = Label(
        float(centre[0]), float(centre[1]) - height - 0.5 * tall + LINE - 4.0, "middle", lines
    )
    left, top, right, _ = label.box
    corner = math.hypot(0.5 * (right - left), centre[1] - top)
    return label if corner < root and root - free > tall + ROOM else None


def column_labels(
    names: Sequence[Outside], edges: tuple[float, float, float, float]
) -> tuple[list[Label], list[str]]:
    """Names in columns left and right of the view, and their leader lines to the pitch circles.

    Parameters
    ----------
    names
        The names.
    edges
        Left, right, top and bottom edge of the circles [pixels].
    """
    left, right, top, bottom = edges
    labels: list[Label] = []
    leaders: list[str] = []
    counts = {-1.0: 0, 1.0: 0}
    sides: list[float] = []
    for name in names:
        from_middle = (name.centre[0] - 0.5 * (left + right)) / max(right - left, 1.0)
        side = math.copysign(1.0, from_middle)
        if abs(from_middle) < 0.1:  # near the middle: the emptier side
            side = min(counts, key=lambda s: counts[s])
        sides.append(side)
        counts[side] += 1
    for side in (-1.0, 1.0):
        own = [name for name, s in zip(names, sides, strict=True) if s == side]
        spots = _spots(own, side)
        steps = [STEP + LINE * (len(name.lines) - 1) for name in own]
        middles = spread([float(p[1]) for p in spots], steps, top, max(bottom, top + sum(steps))) if own else []
        x = left - COLUMN if side < 0.0 else right + COLUMN
        for name, spot, y in zip(own, spots, middles, strict=True):
            first = float(y) + 4.0 - 0.5 * LINE * (len(name.lines) - 1)
            labels.append(Label(x, first, "end" if side < 0.0 else "start", name.lines))
            start = np.array([x - 4.0 * side, float(y)])
            leaders.append(svg.line(start, spot, "pp-leader") + svg.circle(spot, 2.2, "pp-leader-dot"))
    return labels, leaders


def _spots(names: Sequence[Outside], side: float) -> list[Array]:
    """Points on the pitch circles towards a side; those of coaxial gears at different angles."""
    found = []
    for name in names:
        mates = [n for n in names if np.hypot(*(n.centre - name.centre)) < 4.0]
        mates.sort(key=lambda n: -n.radius)
        place = mates.index(name)
        angle = math.radians(STEEP * (1.0 - 2.0 * (place + 0.5) / len(mates)))
        found.append(name.centre + name.radius * np.array([side * math.cos(angle), -math.sin(angle)]))
    return found
