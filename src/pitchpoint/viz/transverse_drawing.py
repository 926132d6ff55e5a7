# SPDX-License-Identifier: Apache-2.0
"""Transverse view of a gear train: operating pitch circles, centre distances, directions of rotation."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.viz import svg, theme
from pitchpoint.viz.label_placement import Label, Rectangle, search
from pitchpoint.viz.wheel_labels import column_labels, wheel_labels

Array = NDArray[np.float64]

FIELD, TALLEST = 460.0, 620.0
"""Largest width and height of the circles [pixels]."""
MARGIN, HEAD = 46.0, 34.0
FOOT = 34.0
"""Radius around a foot or mount with its name [pixels]."""
ARROW, SPAN = 0.78, 1.1
"""Radius of an arrow of rotation relative to the pitch circle, and its angle [rad]."""
STYLE = (
    "<style>"
    f".pp-roll{{fill:none;stroke:{theme.BLUE};stroke-width:1.8}}"
    f".pp-rollhead{{fill:{theme.BLUE};stroke:none}}"
    ".pp-wheel{fill:var(--pp-gear);fill-opacity:.55;stroke:none}"
    ".pp-wheelring{fill:none;stroke:var(--pp-gear);stroke-opacity:.8}"
    f".pp-pitchcircle{{fill:none;stroke:{theme.RED};stroke-width:1.2;stroke-dasharray:12 3 3 3}}"
    ".pp-tip{fill:none;stroke:var(--pp-edge);stroke-width:1}"
    f".pp-foot{{fill:{theme.OCHRE};fill-opacity:.35;stroke:{theme.OCHRE};stroke-width:1.2}}"
    ".pp-tname{fill:var(--pp-ink);stroke:var(--pp-paper);stroke-width:3.5;paint-order:stroke;font-size:13px;"
    "font-weight:600}"
    ".pp-tsub{fill:var(--pp-soft);stroke:var(--pp-paper);stroke-width:3;paint-order:stroke;font-size:11.5px}"
    "</style>"
)


@dataclass(frozen=True, kw_only=True)
class Wheel:
    """Gears in the transverse plane that look alike.

    Attributes
    ----------
    centre
        Position, shape (2,), y upwards [m].
    pitch, tip, root
        Radii of pitch, tip and root circle [m]; the tip of an internal gear is inside.
    name
        Names of the gears with teeth.
    speed
        Speed, counter-clockwise positive; None if not known [rad/s].
    group
        Names of all gears of a group such as planets, for the first of them where there is no room for single
        names; empty for single gears.
    first
        Whether it is the first of its group.
    """

    centre: Array
    pitch: float
    tip: float
    root: float
    name: str
    speed: float | None = None
    group: str = ""
    first: bool = True


@dataclass(frozen=True, kw_only=True)
class Transverse:
    """Transverse view of the gears on parallel axes.

    Attributes
    ----------
    wheels
        The gears.
    distances
        Lines of centres: both ends, shape (2,) [m], and their text.
    supports
        Feet or mounts of the housing: place, shape (2,) [m], and names.
    """

    wheels: Sequence[Wheel]
    distances: Sequence[tuple[Array, Array, str]] = ()
    supports: Sequence[tuple[Array, str]] = ()


def transverse_parts(view: Transverse, field: float = FIELD) -> tuple[float, float, list[str]]:
    """Width, height and SVG elements of the transverse view.

    Parameters
    ----------
    view
        Its contents.
    field
        Largest width of the circles [pixels].
    """
    reach = np.array([max(w.tip, w.root) for w in view.wheels])
    centres = np.array([w.centre for w in view.wheels])
    feet = [place for place, _ in view.supports]
    low = np.min([*(centres - reach[:, None]), *feet], axis=0)
    high = np.max([*(centres + reach[:, None]), *feet], axis=0)
    wide, tall = high - low
    scale = min(field / wide, TALLEST / tall)

    def at(point: Array) -> Array:
        """Pixels of a point."""
        x, y = point
        return np.array([MARGIN + (x - low[0]) * scale, HEAD + MARGIN + (high[1] - y) * scale])

    head = [STYLE, svg.text(10.0, 22.0, "Transverse view, +z towards the reader", "pp-head", "start")]
    parts: list[str] = []
    for wheel in sorted(view.wheels, key=lambda w: -max(w.tip, w.root)):
        parts += _wheel(wheel, at, scale)
    wanted: list[tuple[Label, Array]] = []
    for start, end, words in view.distances:
        parts.append(svg.line(at(start), at(end), "pp-thin"))
        middle = at(0.5 * (start + end))
        wanted.append(
            (Label(float(middle[0]), float(middle[1]) - 4.0, "middle", ((words, "pp-sub"),)), middle)
        )
    parts += [line for wheel in view.wheels for line in _axis(wheel, at)]
    inside, outside = wheel_labels(view.wheels, at, scale)
    wanted = [*((label, np.array([label.x, label.y])) for label in inside), *wanted]
    for place, names in view.supports:
        parts.append(_support(at(place)))
        x, y = at(place)
        wanted.append((Label(float(x), float(y) + 30.0, "middle", ((names, "pp-sub"),)), at(place)))
    blocks: list[Rectangle] = [
        (float(p[0]) - 7.0, float(p[1]) - 7.0, float(p[0]) + 7.0, float(p[1]) + 7.0) for p in map(at, centres)
    ]
    labels = search(wanted, blocks)
    circles = [(*map(float, at(w.centre)), scale * max(w.tip, w.root)) for w in view.wheels]
    circles += [(*map(float, at(place)), FOOT) for place in feet]
    columns, leaders = column_labels(outside, circles)
    for label in (*labels, *columns):
        leaders.append(label.svg().replace("pp-name", "pp-tname").replace("pp-sub", "pp-tsub"))
    labels += columns
    left = max([0.0, *(8.0 - label.box[0] for label in labels)])
    right = max([2.0 * MARGIN + wide * scale, 330.0, *(label.box[2] + 8.0 for label in labels)])
    bottom = max([HEAD + 2.0 * MARGIN + tall * scale, *(label.box[3] + 12.0 for label in labels)])
    moved = f'<g transform="translate({left:.1f} 0)">{"".join([*parts, *leaders])}</g>'
    return right + left, bottom, [*head, moved]


def _wheel(wheel: Wheel, at: object, scale: float) -> list[str]:
    """Circles of a gear, and its direction of rotation."""
    centre = at(wheel.centre)  # type: ignore[operator]
    parts = []
    if wheel.tip > wheel.root:
        parts.append(svg.circle(centre, wheel.tip * scale, "pp-wheel"))
    parts += [svg.circle(centre, r * scale, "pp-tip") for r in (wheel.tip, wheel.root)]
    parts.append(svg.circle(centre, wheel.pitch * scale, "pp-pitchcircle"))
    if wheel.speed:
        parts.append(
            _turn(centre, ARROW * min(wheel.tip, wheel.root) * scale, math.copysign(1.0, wheel.speed))
        )
    return parts


def _axis(wheel: Wheel, at: object) -> list[str]:
    """Centre of a gear."""
    centre = at(wheel.centre)  # type: ignore[operator]
    ways = (np.array([6.0, 0.0]), np.array([0.0, 6.0]))
    return [svg.line(centre - way, centre + way, "pp-frame") for way in ways]


def _support(place: Array) -> str:
    """A foot or mount: triangle on hatched ground."""
    base = place + np.array([(-8.0, 11.0), (8.0, 11.0)])
    ticks = [
        svg.line(place + np.array([x, 11.0]), place + np.array([x - 4.0, 15.0]), "pp-thin")
        for x in (-6.0, -2.0, 2.0, 6.0, 10.0)
    ]
    triangle = svg.polygon(np.array([place, *base]), "pp-foot")
    return triangle + svg.line(base[0] - (3.0, 0.0), base[1] + (3.0, 0.0), "pp-frame") + "".join(ticks)


def _turn(centre: Array, radius: float, way: float) -> str:
    """Arc with an arrow head around the bottom of a gear; counter-clockwise for `way` 1."""
    middle = -0.5 * math.pi
    ends = [middle - 0.5 * SPAN * way, middle + 0.5 * SPAN * way]
    angles = np.linspace(ends[0], ends[1], 24)
    line = centre + radius * np.column_stack([np.cos(angles), -np.sin(angles)])
    along = line[-1] - line[-2]
    along /= max(float(np.hypot(*along)), 1e-9)
    across = np.array([-along[1], along[0]])
    size = min(9.0, 0.5 * radius)
    head = np.array(
        [line[-1] + size * along, line[-1] + 0.45 * size * across, line[-1] - 0.45 * size * across]
    )
    return svg.polyline(line, "pp-roll") + svg.polygon(head, "pp-rollhead")
