# SPDX-License-Identifier: Apache-2.0
"""Names of the gears of a transverse view: in the gear where there is room, else in columns next to it."""

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
from pitchpoint.viz.label_placement import LINE, Label, common_area
from pitchpoint.viz.labels import spread

if TYPE_CHECKING:
    from pitchpoint.viz.transverse_drawing import Wheel

Array = NDArray[np.float64]

STYLE = "pp-name"
LONGEST, WIDEST = 22, 28
"""Letters of a name up to which it is complete, and of a line."""
ROOM = 4.0
"""Least distance of a name from the circles around it [pixels]."""
COLUMN = 22.0
"""Distance of a name next to the view from the circles [pixels]."""
MIDDLE = 0.03
"""Distance of a gear from the middle of the view, relative to its width, up to which both sides are equal."""
STEP = LINE + 3.0
"""Distance of the names of a column [pixels]."""
STEEP, SINGLE = 65.0, 0.25
"""Largest angle between the horizontal and the points at which leader lines end on a pitch circle [deg];
place of a single point from the upper to the lower one, not on a line of centres."""


@dataclass(frozen=True)
class Outside:
    """A name next to the view.

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
    """Names in the gears or right above or below them, and those without room there.

    Parameters
    ----------
    wheels
        The gears.
    at
        Transformation from the transverse plane [m] to pixels.
    scale
        Pixels per metre.
    """
    found: list[tuple[Wheel, Label | None]] = []
    placed: list[Label] = []
    for wheel in sorted(wheels, key=lambda w: -w.pitch):
        label = _near(wheel, wheels, placed, at, scale)
        found.append((wheel, label))
        placed += [] if label is None else [label]
    together = {wheel.group for wheel, label in found if wheel.group and label is None}
    inside = [label for wheel, label in found if label is not None and wheel.group not in together]
    outside = [
        Outside(_lines(wheel.group or wheel.name, WIDEST), at(wheel.centre), wheel.pitch * scale)
        for wheel, label in found
        if wheel.first and (label is None or wheel.group in together)
    ]
    return inside, outside


def _near(
    wheel: Wheel,
    wheels: Sequence[Wheel],
    placed: Sequence[Label],
    at: Callable[[Array], Array],
    scale: float,
) -> Label | None:
    """Name in a gear, or right above or below it; None without room."""
    centre = at(wheel.centre)
    coaxial = [w for w in wheels if w is not wheel and np.hypot(*(w.centre - wheel.centre)) * scale < 4.0]
    smaller = [w.tip for w in coaxial if w.tip > w.root and w.pitch < wheel.pitch]
    free = scale * max(smaller, default=0.0)
    over = [
        (at(w.centre), scale * w.tip)
        for w in wheels
        if w.tip > w.root and w.pitch < wheel.pitch and all(w is not one for one in coaxial)
    ]
    if wheel.tip > wheel.root:
        for lines in (_lines(wheel.name, 2 * len(wheel.name)), _lines(wheel.name, WIDEST // 2)):
            label = _within(centre, lines, free, scale * wheel.root)
            if label is not None and not any(
                math.hypot(*(c - (label.x, label.y - 4.0))) < r for c, r in over
            ):
                return label
    larger = [w for w in coaxial if w.tip > w.root and w.pitch > wheel.pitch]
    room = scale * min((w.root for w in larger), default=0.0)
    others = [w for w in wheels if all(w is not one for one in larger)]
    circles = [(at(w.centre), scale * max(w.tip, w.root)) for w in others]
    own = (centre, scale * max(wheel.tip, wheel.root))
    return _over(own, room, _lines(wheel.name, WIDEST), circles, placed)


def _lines(words: str, widest: int) -> tuple[tuple[str, str], ...]:
    """Lines of a name."""
    together = shortened(words, LONGEST).replace(" (", "\u00a0(")  # the number of teeth stays with a name
    parts = textwrap.wrap(together, widest, break_long_words=False, break_on_hyphens=False)
    return tuple((part.replace("\u00a0", " "), STYLE) for part in parts)


def _within(centre: Array, lines: tuple[tuple[str, str], ...], free: float, root: float) -> Label | None:
    """Name in the upper half of a gear between two circles; None without room."""
    tall = LINE * len(lines)
    height = 0.5 * (free + root) if free else max(0.45 * root, 0.5 * tall + ROOM)
    label = Label(float(centre[0]), float(centre[1]) - height - 0.5 * tall + LINE - 4.0, "middle", lines)
    left, top, right, _ = label.box
    corner = math.hypot(0.5 * (right - left), centre[1] - top)
    return label if corner < root and root - free > tall + ROOM else None


def _over(
    own: tuple[Array, float],
    room: float,
    lines: tuple[tuple[str, str], ...],
    circles: Sequence[tuple[Array, float]],
    others: Sequence[Label],
) -> Label | None:
    """Name above or below a gear, within the root circle of a larger coaxial one if there is one; None if
    another gear or name is there."""
    centre, radius = own
    x, tall = float(centre[0]), LINE * len(lines)
    for first in (centre[1] - radius - 7.0 - tall + LINE, centre[1] + radius + LINE):
        label = Label(x, float(first), "middle", lines)
        left, top, right, bottom = label.box
        near = [np.clip(at, (left, top), (right, bottom)) - at for at, _ in circles]
        clear = all(math.hypot(*gap) > r + 1.0 for gap, (_, r) in zip(near, circles, strict=True))
        corner = math.hypot(0.5 * (right - left), max(abs(centre[1] - top), abs(bottom - centre[1])))
        if (
            clear
            and (not room or corner < room)
            and not any(common_area(label.box, other.box) for other in others)
        ):
            return label
    return None


def column_labels(
    names: Sequence[Outside], circles: Sequence[tuple[float, float, float]]
) -> tuple[list[Label], list[str]]:
    """Names in columns left and right of the view, and their leader lines to the pitch circles.

    Parameters
    ----------
    names
        The names.
    circles
        Centres (x, y) and radii of all circles and other parts to avoid [pixels].
    """
    left, right = min(x - r for x, _, r in circles), max(x + r for x, _, r in circles)
    top, bottom = min(y - r for _, y, r in circles), max(y + r for _, y, r in circles)
    labels: list[Label] = []
    leaders: list[str] = []
    counts = {-1.0: 0, 1.0: 0}
    sides: list[float] = []
    for name in names:
        from_middle = (name.centre[0] - 0.5 * (left + right)) / max(right - left, 1.0)
        side = math.copysign(1.0, from_middle)
        if abs(from_middle) < MIDDLE:  # near the middle: the emptier side
            side = min(counts, key=lambda s: counts[s])
        sides.append(side)
        counts[side] += 1
    for side in (-1.0, 1.0):
        own = [name for name, s in zip(names, sides, strict=True) if s == side]
        spots = _spots(own, side)
        steps = [STEP + LINE * (len(name.lines) - 1) for name in own]
        middles = spread([float(p[1]) for p in spots], steps, top, max(bottom, top + sum(steps)))
        for name, spot, y in zip(own, spots, middles, strict=True):
            x = side * (_edge(float(y), 0.5 * LINE * len(name.lines) + ROOM, side, circles) + COLUMN)
            first = float(y) + 4.0 - 0.5 * LINE * (len(name.lines) - 1)
            labels.append(Label(x, first, "end" if side < 0.0 else "start", name.lines))
            start = np.array([x - 4.0 * side, float(y)])
            leaders.append(svg.line(start, spot, "pp-leader") + svg.circle(spot, 2.2, "pp-leader-dot"))
    return labels, leaders


def _edge(y: float, half: float, side: float, circles: Sequence[tuple[float, float, float]]) -> float:
    """Outermost point of circles towards a side over a height around y, positive to this side [pixels]."""
    found = [-math.inf]
    for x, at, r in circles:
        away = max(abs(y - at) - half, 0.0)
        if away < r:
            found.append(side * x + math.sqrt(r**2 - away**2))
    nearest = max(found)
    return nearest if math.isfinite(nearest) else max(side * x for x, _, _ in circles)


def _spots(names: Sequence[Outside], side: float) -> list[Array]:
    """Points on the pitch circles towards a side; those of coaxial gears at different angles."""
    found = []
    for name in names:
        mates = [n for n in names if np.hypot(*(n.centre - name.centre)) < 4.0]
        mates.sort(key=lambda n: -n.radius)
        place = mates.index(name)
        share = (place + 0.5) / len(mates) if len(mates) > 1 else SINGLE
        angle = math.radians(STEEP * (1.0 - 2.0 * share))
        found.append(name.centre + name.radius * np.array([side * math.cos(angle), -math.sin(angle)]))
    return found
