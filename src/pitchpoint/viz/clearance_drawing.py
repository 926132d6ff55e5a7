# SPDX-License-Identifier: Apache-2.0
"""Drawing of the smallest clearances of a gear pair: one magnified panel per location."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pitchpoint.viz import svg
from pitchpoint.viz.gear_drawing import View, body
from pitchpoint.viz.quantities import amount
from pitchpoint.viz.svg import Array

PANEL, GAP, COLUMNS = 224.0, 16.0, 4
CAPTION, HEAD = 62.0, 34.0
WIDTH = COLUMNS * PANEL + (COLUMNS + 1) * GAP
LETTERS = 34
"""Characters per line below a panel."""
ZOOM = 6.0
"""Half of the field of a panel, in multiples of the distance."""
NEAREST, FARTHEST = 0.04, 1.2
"""Limits of the half field, in modules."""
OVERVIEW = 2.6
"""Half of the field of the first panel, in modules."""


@dataclass(frozen=True)
class Place:
    """One clearance to draw.

    Attributes
    ----------
    words
        The two parts, in words.
    distance, limit
        Distance and its minimum [m].
    fine
        Whether the distance is within its limit.
    where
        A `Clearance`: mesh position and the two nearest points.
    """

    words: str
    distance: float
    limit: float
    fine: bool
    where: Any


def clearances_svg(meshes: Mapping[str, tuple[Any, Sequence[Place]]]) -> str:
    """Drawing of the clearances of all meshes, one block per mesh.

    Parameters
    ----------
    meshes
        `GearPair` and its clearances, by title.
    """
    parts: list[str] = []
    top = 0.0
    for title, (pair, places) in meshes.items():
        parts.append(_head(title, top))
        top += HEAD
        panels = [_overview(pair, places), *(_detail(pair, k, one) for k, one in enumerate(places, start=1))]
        for k, panel in enumerate(panels):
            x = GAP + (k % COLUMNS) * (PANEL + GAP)
            y = top + (k // COLUMNS) * (PANEL + CAPTION)
            parts.append(f'<svg x="{x:.0f}" y="{y:.0f}" width="{PANEL:.0f}" height="{PANEL + CAPTION:.0f}">')
            parts.append(f"{panel}</svg>")
        top += -(-len(panels) // COLUMNS) * (PANEL + CAPTION) + GAP
    return svg.document(WIDTH, max(top, HEAD), parts, "smallest clearances of the teeth")


def _head(title: str, top: float) -> str:
    """Name of the mesh and legend of the colours."""
    parts = [svg.text(GAP, top + 22.0, title, "pp-head", "start")]
    x = WIDTH - GAP - 150.0
    for css, words in (("pp-gear pp-mate", "gear 1"), ("pp-gear", "gear 2")):
        parts.append(f'<rect class="{css}" x="{x:.0f}" y="{top + 11:.0f}" width="18" height="12"/>')
        parts.append(svg.text(x + 24.0, top + 22.0, words, "pp-small", "start"))
        x += 80.0
    return "".join(parts)


def _outlines(pair: Any, phi1: float, phi2: float) -> tuple[Array, Array]:
    """Outlines of both gears in their mesh position [m], as fine as for the distances."""
    from pitchpoint.geometry.outline_distance import gear_line
    from pitchpoint.geometry.placement import mesh_offset

    found = []
    for gear, turn, axis in (
        (pair.gear1, phi1, 0.0),
        (pair.gear2, mesh_offset(pair) + phi2, pair.a_w),
    ):
        line = gear_line(gear)
        teeth = np.exp(1j * (turn + 2.0 * math.pi / line.z * np.arange(line.z)))
        ring = (axis + teeth[:, None] * line.pitch[None, :]).ravel()
        found.append(np.column_stack([ring.real, ring.imag]))
    return found[0], found[1]


def _teeth(pair: Any, middle: Array, half: float, phi: tuple[float, float]) -> tuple[View, list[str]]:
    """Both gears around a point."""
    view = View(middle - half, PANEL / (2.0 * half), PANEL)
    low, high = middle - half, middle + half
    one, two = _outlines(pair, *phi)
    parts = [
        body(pair.gear2, view, svg.clip(two, low, high), "pp-gear", window=(low, high)),
        body(pair.gear1, view, svg.clip(one, low, high), "pp-gear pp-mate", window=(low, high)),
    ]
    return view, parts


def _overview(pair: Any, places: Sequence[Place]) -> str:
    """Panel with the mesh in the middle of its backlash and the numbered locations on gear 1."""
    middle = np.array([0.5 * pair.d_w1, 0.0])
    ends = [_on_gear_1(pair, one.where) for one in places]
    reach = max([float(np.abs(end - middle).max()) for end in ends], default=0.0)
    half = max(OVERVIEW * pair.gear1.m_n, 1.15 * reach)
    view, parts = _teeth(pair, middle, half, (0.0, 0.0))
    taken: list[Array] = []
    for k, (one, end) in enumerate(zip(places, ends, strict=True), start=1):
        css = "pp-good" if one.fine else "pp-bad"
        spot = view(end)
        parts.append(svg.circle(spot, 2.6, css))
        at = _free(spot, taken)
        taken.append(at)
        parts.append(svg.text(at[0], at[1] + 5.0, str(k), "pp-halo"))
    parts.append(_frame())
    parts.append(_bar(view))
    parts.append(svg.text(0.0, PANEL + 16.0, "locations on the teeth of gear 1", "pp-text", "start"))
    parts.append(svg.text(0.0, PANEL + 34.0, "minimum over one pitch of rotation", "pp-small", "start"))
    return "".join(parts)


def _on_gear_1(pair: Any, where: Any) -> Array:
    """Location on gear 1 in the position of the first panel, on the tooth in mesh there."""
    pitch = 2.0 * math.pi / pair.gear1.z
    place = complex(*where.place1) * np.exp(-1j * where.phi1)
    place *= np.exp(-1j * pitch * round(float(np.angle(place)) / pitch))
    return np.array([place.real, place.imag])


def _free(spot: Array, taken: Sequence[Array]) -> Array:
    """Position of a number next to a location, clear of the others and inside the panel."""
    best, room = spot, -1.0
    for radius in (14.0, 24.0, 36.0):
        for angle in np.arange(12) * math.pi / 6.0:
            at = spot + radius * np.array([math.cos(angle), math.sin(angle)])
            if np.any(at < 12.0) or np.any(at > PANEL - 12.0):
                continue
            free = min((float(np.abs(at - other).max()) for other in taken), default=99.0)
            if free > 16.0:
                return at
            if free > room:
                best, room = at, free
    return np.asarray(best)


def _detail(pair: Any, count: int, one: Place) -> str:
    """Magnified panel of one location."""
    ends = np.array([one.where.place1, one.where.place2])
    m_n = pair.gear1.m_n
    half = min(max(ZOOM * abs(one.distance), NEAREST * m_n), FARTHEST * m_n)
    view, parts = _teeth(pair, ends.mean(axis=0), half, (one.where.phi1, one.where.phi2))
    css = "pp-good" if one.fine else "pp-bad"
    parts.append(_gap(view(ends[0]), view(ends[1]), css))
    parts.append(_frame())
    parts.append(_bar(view))
    lines = _lines(f"{count}  {one.words}")
    parts += [
        svg.text(0.0, PANEL + 16.0 + 16.0 * k, line, "pp-text", "start") for k, line in enumerate(lines)
    ]
    judged = "OK" if one.fine else "overlap" if one.distance < 0.0 else "below the limit"
    words = f"{length(one.distance)}, limit {length(one.limit)}: {judged}"
    parts.append(svg.text(0.0, PANEL + 18.0 + 16.0 * len(lines), words, css, "start"))
    return "".join(parts)


def length(value: float) -> str:
    """Distance in a customary unit; less than a nanometre is 0.

    Examples
    --------
    >>> length(3.0001e-5), length(-2e-10), length(5e-4)
    ('30 µm', '0 µm', '0.5 mm')
    """
    return "0 µm" if abs(value) < 1e-9 else amount(value, "m")


def _gap(start: Array, end: Array, css: str) -> str:
    """Distance as a line between two dots; a short one between two arrows."""
    parts = [svg.circle(start, 2.4, css), svg.circle(end, 2.4, css)]
    apart = end - start
    size = float(np.hypot(*apart))
    if size > 1e-6:
        along = apart / size
        if size >= 16.0:
            parts.append(svg.line(start, end, css))
        else:
            for spot, way in ((start, -along), (end, along)):
                parts.append(_arrow(spot + 34.0 * way, spot + 4.0 * way, css))
    return "".join(parts)


def _arrow(start: Array, tip: Array, css: str) -> str:
    along = (tip - start) / float(np.hypot(*(tip - start)))
    across = np.array([-along[1], along[0]])
    head = np.array([tip, tip - 8.0 * along + 3.0 * across, tip - 8.0 * along - 3.0 * across])
    return svg.line(start, tip - 7.0 * along, css) + svg.polygon(head, css)


def _frame() -> str:
    return f'<rect class="pp-frame" x="0.5" y="0.5" width="{PANEL - 1:.0f}" height="{PANEL - 1:.0f}"/>'


def _bar(view: View) -> str:
    """Scale bar of a round length in the lower left corner."""
    most = 0.36 * PANEL / view.scale
    power = 10.0 ** math.floor(math.log10(most))
    size = next(k * power for k in (5.0, 2.0, 1.0) if k * power <= most)
    y, end = PANEL - 12.0, 12.0 + size * view.scale
    line = svg.line(np.array([12.0, y]), np.array([end, y]), "pp-scale")
    return line + svg.text(12.0, y - 5.0, length(size), "pp-halo pp-tiny", "start")


def _lines(words: str) -> list[str]:
    """Text in at most two lines; longer text is truncated."""
    lines = [""]
    for word in words.split(" "):
        if len(lines[-1]) + 1 + len(word) > LETTERS and lines[-1]:
            lines.append("")
        lines[-1] = f"{lines[-1]} {word}" if lines[-1] else word
    if len(lines) > 2:
        lines = [lines[0], " ".join(lines[1:])]
    return [line if len(line) <= LETTERS else f"{line[: LETTERS - 1]}…" for line in lines]
