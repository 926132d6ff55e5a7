# SPDX-License-Identifier: Apache-2.0
"""A sheet of paper for drawings of gears: metres in, SVG out."""

from __future__ import annotations

import math
from html import escape
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry import GearPair
from pitchpoint.geometry.placement import mesh_outlines
from pitchpoint.viz.theme import FONT, LIGHT, RED

Array = NDArray[np.float64]
INK, SOFT, EDGE = LIGHT["ink"], LIGHT["soft"], LIGHT["edge"]
FILLS = (LIGHT["gear"], LIGHT["mate"])


class Sheet:
    """A drawing in pixels: `middle` [m] lies in its centre, y points up, `scale` is pixels per metre."""

    def __init__(self, width: float, height: float, middle: Any, scale: float) -> None:
        self.size = np.array([width, height])
        self.middle = np.asarray(middle, dtype=np.float64)
        self.scale = scale
        self.parts: list[str] = []

    def at(self, points: Any) -> Array:
        """Pixels of points [m]."""
        away = (np.asarray(points, dtype=np.float64) - self.middle) * self.scale
        return 0.5 * self.size + away * np.array([1.0, -1.0])

    def line(self, points: Any, colour: str = INK, width: float = 1.2, more: str = "") -> None:
        """Open line, or with `fill` in `more` a filled one."""
        path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in self.at(points))
        fill = "" if "fill" in more else 'fill="none"'
        self.parts.append(f'<path d="{path}" {fill} stroke="{colour}" stroke-width="{width}" {more}/>')

    def area(self, points: Any, fill: str, colour: str = EDGE, more: str = "") -> None:
        """Closed line, filled."""
        path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in self.at(points)) + "Z"
        self.parts.append(f'<path d="{path}" fill="{fill}" stroke="{colour}" stroke-width="1.1" {more}/>')

    def arc(
        self, centre: Any, r: float, ends: tuple[float, float], colour: str = SOFT, more: str = ""
    ) -> None:
        """Part of a circle between two angles [rad]."""
        angles = np.linspace(*ends, 80)
        points = np.asarray(centre) + r * np.column_stack([np.cos(angles), np.sin(angles)])
        self.line(points, colour, 1.2, more)

    def arrow(self, start: Any, end: Any, colour: str = INK, width: float = 2.0, head: float = 9.0) -> None:
        """Straight arrow."""
        a, b = self.at(start), self.at(end)
        along = (b - a) / max(float(np.hypot(*(b - a))), 1e-9)
        side = np.array([-along[1], along[0]])
        foot = b - head * along
        corners = [b, foot + 0.42 * head * side, foot - 0.42 * head * side]
        tip = " ".join(f"{x:.1f},{y:.1f}" for x, y in corners)
        self.parts.append(
            f'<path d="M{a[0]:.1f} {a[1]:.1f}L{foot[0]:.1f} {foot[1]:.1f}" stroke="{colour}" '
            f'stroke-width="{width}"/>'
            f'<polygon points="{tip}" fill="{colour}"/>'
        )

    def turn(self, centre: Any, r: float, ends: tuple[float, float], colour: str) -> None:
        """Arc with an arrow at its second end."""
        self.arc(centre, r, ends, colour, 'stroke-opacity="1"')
        # the head follows the chord of the last few degrees, so that it looks along the arc
        back = ends[1] - math.copysign(6.0 / (r * self.scale), ends[1] - ends[0])
        points = [np.asarray(centre) + r * np.array([math.cos(t), math.sin(t)]) for t in (back, ends[1])]
        self.arrow(points[0], points[1], colour, 2.0, 10.0)

    def dot(self, point: Any, colour: str = RED, fill: str = "#fff") -> None:
        """Small circle."""
        x, y = self.at(point)
        self.parts.append(
            f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.6" fill="{fill}" stroke="{colour}" stroke-width="2"/>'
        )

    def out(self, point: Any, colour: str = INK) -> None:
        """Arrow that comes out of the paper."""
        x, y = self.at(point)
        self.parts.append(
            f'<circle cx="{x:.1f}" cy="{y:.1f}" r="7" fill="#fff" stroke="{colour}" stroke-width="2"/>'
            f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.2" fill="{colour}"/>'
        )

    def text(self, point: Any, words: str, shift: tuple[float, float] = (0, 0), **look: str) -> None:
        """Words at a point, shifted by pixels (right, up); `anchor`, `colour` and `weight` of the letters."""
        x, y = self.at(point) + np.array([shift[0], -shift[1]])
        anchor, colour = look.get("anchor", "middle"), look.get("colour", INK)
        weight = look.get("weight", "500")
        self.parts.append(
            f'<text x="{x:.1f}" y="{y + 5:.1f}" text-anchor="{anchor}" fill="{colour}" '
            f'font-weight="{weight}" stroke="#fff" stroke-width="4" paint-order="stroke" '
            f'stroke-linejoin="round">{escape(words)}</text>'
        )

    def gears(self, pair: GearPair, phi1: float, phi2: float | None = None) -> None:
        """Both gears of a pair in mesh; a ring keeps its hole."""
        one, two = mesh_outlines(pair, phi1, 30, phi2=phi2)
        if pair.is_internal:
            rim = 1.13 * float(np.max(np.hypot(*(two - [pair.a_w, 0.0]).T)))
            angles = np.linspace(0.0, 2.0 * math.pi, 200)
            outer = [pair.a_w, 0.0] + rim * np.column_stack([np.cos(angles), np.sin(angles)])
            paths = [
                "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in self.at(ring)) + "Z" for ring in (outer, two)
            ]
            self.parts.append(
                f'<path d="{"".join(paths)}" fill="{FILLS[1]}" fill-rule="evenodd" stroke="{EDGE}" '
                f'stroke-width="1.1"/>'
            )
        else:
            self.area(two, FILLS[1])
        self.area(one, FILLS[0])

    def save(self, path: Path, title: str) -> None:
        """Write the drawing."""
        width, height = self.size
        font = FONT.replace("'", "")
        path.write_text(
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" '
            f'width="{width:.0f}" height="{height:.0f}" font-family="{font}" font-size="15" role="img">'
            f"<title>{escape(title)}</title>"
            f'<rect width="100%" height="100%" fill="#fff"/>{"".join(self.parts)}</svg>\n',
            encoding="utf-8",
        )
