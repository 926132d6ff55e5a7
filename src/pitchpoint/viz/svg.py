# SPDX-License-Identifier: Apache-2.0
"""SVG elements and common styles for drawings of gears."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape

import numpy as np
from numpy.typing import NDArray

from pitchpoint.viz import theme

Array = NDArray[np.float64]


def _variables(colours: dict[str, str]) -> str:
    return "".join(f"--pp-{name}:{value};" for name, value in colours.items())


STYLE = (
    f".pp-drawing{{{_variables(theme.LIGHT)}font:14px {theme.FONT.replace(chr(39), '')}}}"
    f"@media screen and (prefers-color-scheme:dark){{.pp-drawing{{{_variables(theme.DARK)}}}}}"
    f"{theme.LIGHT_PAGE} .pp-drawing{{{_variables(theme.LIGHT)}}}"
    f"@media screen{{{theme.DARK_PAGE} .pp-drawing{{{_variables(theme.DARK)}}}}}"
    ".pp-paper{fill:var(--pp-paper)}"
    ".pp-gear{fill:var(--pp-gear);stroke:var(--pp-edge);stroke-width:1.1;stroke-linejoin:round;"
    "fill-rule:evenodd}"
    ".pp-mate{fill:var(--pp-mate);fill-opacity:.82}"
    ".pp-thin{fill:none;stroke:var(--pp-soft);stroke-width:1}"
    ".pp-base{stroke-dasharray:7 4}.pp-pitch{stroke-dasharray:10 3 2 3}"
    f".pp-action{{stroke:{theme.RED};stroke-width:1.1;stroke-dasharray:4 3;fill:none}}"
    f".pp-path{{stroke:{theme.RED};stroke-width:3.2;stroke-linecap:round;fill:none}}"
    ".pp-active1,.pp-active2{fill:none;stroke-width:4;stroke-linecap:butt}"
    f".pp-active1{{stroke:{theme.BLUE}}}.pp-active2{{stroke:{theme.ORANGE}}}"
    f".pp-tool{{fill:{theme.OCHRE};fill-opacity:.16;stroke:{theme.OCHRE};stroke-width:1.4}}"
    ".pp-form{stroke-dasharray:2 3}.pp-leader{fill:none;stroke:var(--pp-soft);stroke-width:.8}"
    ".pp-leader-dot{fill:var(--pp-soft)}"
    f".pp-dot{{fill:var(--pp-paper);stroke:{theme.RED};stroke-width:2}}"
    f".pp-pole{{fill:{theme.RED};stroke:{theme.RED};stroke-width:2}}"
    f".pp-good{{stroke:{theme.GREEN};fill:{theme.GREEN}}}.pp-bad{{stroke:{theme.RED};fill:{theme.RED}}}"
    ".pp-good,.pp-bad{stroke-width:1.6}text.pp-good,text.pp-bad{stroke:none;font-size:13px}"
    ".pp-scale{stroke:var(--pp-ink);stroke-width:3}.pp-tiny{font-size:12px;font-weight:400}"
    ".pp-frame{fill:none;stroke:var(--pp-soft);stroke-width:1}.pp-head{fill:var(--pp-ink);font-weight:600}"
    ".pp-text{fill:var(--pp-ink)}.pp-small{font-size:13px;fill:var(--pp-soft)}"
    # a halo in the background colour makes text readable on top of lines
    ".pp-halo{fill:var(--pp-ink);stroke:var(--pp-paper);stroke-width:4;paint-order:stroke;font-weight:600}"
)


def document(width: float, height: float, parts: Iterable[str], title: str) -> str:
    """Complete drawing that fills its width, in the colours of the page theme, else of the system."""
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="pp-drawing" viewBox="0 0 {width:.0f} {height:.0f}" '
        f'role="img" aria-label="{escape(title)}" '
        f'style="width:100%;max-width:{1.5 * width:.0f}px;height:auto">'
        f"<title>{escape(title)}</title><style>{STYLE}</style>"
        f'<rect class="pp-paper" width="100%" height="100%"/>{"".join(parts)}</svg>'
    )


def polygon(points: Array, css: str, hole: Array | None = None) -> str:
    """Filled closed line through `points`, shape (n, 2), in pixels, except for `hole`."""
    rings = [points] if hole is None else [points, hole]
    path = "".join(
        "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in _distinct(ring)) + "Z" for ring in rings if len(ring)
    )
    return f'<path class="{css}" d="{path}"/>'


def polyline(points: Array, css: str) -> str:
    """Open line through `points`, shape (n, 2), in pixels."""
    path = "L".join(f"{x:.2f} {y:.2f}" for x, y in points)
    return f'<path class="{css}" d="M{path}"/>'


def circle(center: Array, radius: float, css: str) -> str:
    """Circle in pixels."""
    return f'<circle class="{css}" cx="{center[0]:.1f}" cy="{center[1]:.1f}" r="{radius:.2f}"/>'


def line(start: Array, end: Array, css: str) -> str:
    """Straight line in pixels."""
    return (
        f'<line class="{css}" x1="{start[0]:.1f}" y1="{start[1]:.1f}" x2="{end[0]:.1f}" y2="{end[1]:.1f}"/>'
    )


def text(x: float, y: float, words: str, css: str = "pp-text", anchor: str = "middle") -> str:
    """One line of text; the position is on the baseline."""
    return f'<text class="{css}" x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{escape(words)}</text>'


def _distinct(points: Array) -> Array:
    """Points that still differ after rounding to a tenth of a pixel."""
    rounded = np.round(points, 1)
    keep = np.ones(len(rounded), dtype=bool)
    keep[1:] = np.any(rounded[1:] != rounded[:-1], axis=1)
    return np.asarray(rounded[keep])


def clip(points: Array, low: Array, high: Array) -> Array:
    """Polygon clipped to a rectangle (Sutherland and Hodgman), shape (m, 2), possibly empty.

    Examples
    --------
    >>> square = np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])
    >>> clip(square, np.array([1.0, 1.0]), np.array([2.0, 9.0])).max(axis=0).tolist()
    [2.0, 4.0]
    """
    ring = points
    for axis in (0, 1):
        for bound, side in ((low[axis], 1.0), (high[axis], -1.0)):
            if not len(ring):
                return ring
            after = np.roll(ring, -1, axis=0)
            here, there = side * (ring[:, axis] - bound), side * (after[:, axis] - bound)
            crosses = (here < 0.0) != (there < 0.0)
            part = np.where(crosses, here / np.where(crosses, here - there, 1.0), 0.0)
            cut = ring + part[:, None] * (after - ring)
            both = np.stack([ring, cut], axis=1).reshape(-1, 2)
            keep = np.stack([here >= 0.0, crosses], axis=1).reshape(-1)
            ring = both[keep]
    return ring
