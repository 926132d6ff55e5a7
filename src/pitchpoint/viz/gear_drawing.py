# SPDX-License-Identifier: Apache-2.0
"""SVG drawings of a gear, of two gears in mesh and of their mesh zone.

Lengths from `geometry` are in metres; the drawing scales them to pixels with the second axis downwards.
Gear 1 is at the origin, gear 2 at (a_w, 0), as in the transverse plane of the mesh; gear 1 drives
counter-clockwise, so contact moves along the line of action from A to E.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import cos, pi, sin
from typing import Any

import numpy as np

from pitchpoint.viz import svg
from pitchpoint.viz.quantities import number
from pitchpoint.viz.svg import Array

WIDTH = 480.0
CHORD = 0.15
"""Maximum distance of chords from the tooth, invisible and with small files [pixels]."""
MIN_POINTS = 8
_TRIED = 24
# Radial thickness of the ring drawn around an internal gear without a known rim, in modules below the root
# circle.
RIM_MODULES = 2.5


@dataclass(frozen=True)
class View:
    """Transformation from metres in the transverse plane to pixels."""

    low: Array
    scale: float
    height: float

    def __call__(self, points: Any) -> Array:
        p = np.asarray(points, dtype=np.float64)
        x = (p[..., 0] - self.low[0]) * self.scale
        y = self.height - (p[..., 1] - self.low[1]) * self.scale
        return np.stack([x, y], axis=-1)


@lru_cache(maxsize=256)
def points_for(gear: Any, chord: float) -> int:
    """Number of points per flank, at most 400, for a maximum distance of chords from the tooth.

    Parameters
    ----------
    gear
        A `CylindricalGear`.
    chord
        Maximum distance [m].

    Notes
    -----
    The deviation of chords is proportional to the square of their length, which gives an approximate number
    of points; it is increased until the points of a fine tooth are within the distance. Points of a measured
    tooth are not changed.
    """
    from pitchpoint.geometry.outline_distance import N_FLANK, gear_line

    if gear.outline is not None:
        return MIN_POINTS
    fine = gear_line(gear).pitch

    def error(n: int) -> float:
        """Maximum distance of the fine tooth from a tooth with this number of points."""
        return float(np.abs(gear_line(gear, n).nearest(fine).distance).max())

    n = int(np.clip(_TRIED * np.sqrt(error(_TRIED) / chord), MIN_POINTS, N_FLANK))
    while n < N_FLANK and error(n) > chord:
        n = min(int(np.ceil(1.15 * n)), N_FLANK)
    return n


def gear_svg(gear: Any, *, name: str = "gear") -> str:
    """Drawing of one gear.

    Parameters
    ----------
    gear
        A `CylindricalGear`.
    name
        Text below the drawing.
    """
    from pitchpoint.geometry.tooth_form import gear_outline

    reach = _outer_radius(gear)
    view = View(np.array([-reach, -reach]) * 1.04, WIDTH / (2.08 * reach), WIDTH)
    outline = gear_outline(gear, points_for(gear, CHORD / view.scale))
    middle = view([0.0, 0.0])
    parts = [
        body(gear, view, outline, "pp-gear"),
        svg.circle(middle, abs(gear.d) / 2.0 * view.scale, "pp-thin pp-pitch"),
        _cross(middle),
        svg.text(WIDTH / 2.0, WIDTH + 18.0, _caption(gear, name)),
    ]
    return svg.document(WIDTH, WIDTH + 30.0, parts, name)


def pair_svg(pair: Any, *, names: tuple[str, str] = ("gear 1", "gear 2")) -> str:
    """Drawing of both gears of a pair in mesh, seen along their axes.

    Parameters
    ----------
    pair
        A `GearPair`.
    names
        Names of gear 1 and gear 2.
    """
    r1, r2 = _outer_radius(pair.gear1), _outer_radius(pair.gear2)
    low = np.array([min(-r1, pair.a_w - r2), -max(r1, r2)])
    high = np.array([max(r1, pair.a_w + r2), max(r1, r2)])
    size = high - low
    drawn = WIDTH / (1.06 * size[0])
    one, two = _outlines(pair, CHORD / drawn)
    height = 1.06 * size[1] * drawn
    view = View(low - 0.03 * size, drawn, height)
    parts = [
        body(pair.gear2, view, two, "pp-gear"),
        body(pair.gear1, view, one, "pp-gear pp-mate"),
        svg.line(view([0.0, 0.0]), view([pair.a_w, 0.0]), "pp-thin pp-pitch"),
    ]
    for x, d_w in ((0.0, pair.d_w1), (pair.a_w, pair.d_w2)):
        parts.append(svg.circle(view([x, 0.0]), abs(d_w) / 2.0 * drawn, "pp-thin pp-pitch"))
        parts.append(_cross(view([x, 0.0])))
    left, right = (names[0], pair.gear1), (names[1], pair.gear2)
    first, second = (left, right) if pair.a_w > 0.0 else (right, left)
    parts.append(svg.text(6.0, height + 16.0, _caption(first[1], first[0]), anchor="start"))
    parts.append(svg.text(WIDTH - 6.0, height + 16.0, _caption(second[1], second[0]), anchor="end"))
    distance = f"centre distance {number(abs(pair.a_w) * 1e3, 6)} mm"
    parts.append(svg.text(WIDTH / 2.0, height + 36.0, distance, "pp-small"))
    return svg.document(WIDTH, height + 46.0, parts, f"{names[0]} and {names[1]} in mesh")


def mesh_zone_svg(pair: Any) -> str:
    """Drawing of the mesh zone: flanks with active parts, circles, line of action, path of contact A to E.

    Parameters
    ----------
    pair
        A `GearPair` with a contact ratio above zero.
    """
    along = np.array([sin(pair.alpha_wt), cos(pair.alpha_wt)])
    pole = np.array([pair.d_w1 / 2.0, 0.0])
    foot = pole - pair.T1C * along
    where = {name: foot + getattr(pair, f"T1{name}") * along for name in "ABCDE"}
    middle = 0.5 * (where["A"] + where["E"])
    half = max(0.72 * abs(pair.g_alpha), 1.9 * pair.gear1.m_t)
    view = View(middle - half, WIDTH / (2.0 * half), WIDTH)
    one, two = _outlines(pair, CHORD / view.scale)
    low, high = middle - 1.05 * half, middle + 1.05 * half
    parts = [
        body(pair.gear2, view, svg.clip(two, low, high), "pp-gear", window=(low, high)),
        body(pair.gear1, view, svg.clip(one, low, high), "pp-gear pp-mate", window=(low, high)),
    ]
    for x, gear, d_w in ((0.0, pair.gear1, pair.d_w1), (pair.a_w, pair.gear2, pair.d_w2)):
        center = view([x, 0.0])
        parts.append(svg.circle(center, abs(gear.d_b) / 2.0 * view.scale, "pp-thin pp-base"))
        parts.append(svg.circle(center, abs(d_w) / 2.0 * view.scale, "pp-thin pp-pitch"))
    for number_of, flank in enumerate(_active_flanks(pair), start=1):
        parts.append(svg.polyline(view(flank), f"pp-active{number_of}"))
    end = foot + pair.T1T2 * along
    parts.append(svg.line(view(foot), view(end), "pp-action"))
    for tangent, name in ((foot, "T1"), (end, "T2")):
        spot = view(tangent)
        if np.all((spot > 12.0) & (spot < WIDTH - 12.0)):
            parts.append(svg.circle(spot, 3.0, "pp-dot"))
            parts.append(svg.text(spot[0] - 10.0, spot[1] + 5.0, name, "pp-halo", "end"))
    parts.append(svg.line(view(where["A"]), view(where["E"]), "pp-path"))
    parts.extend(_marks(view, where, along))
    parts.append(_legend(WIDTH, pair))
    return svg.document(WIDTH, WIDTH + 92.0, parts, "mesh zone with path of contact")


def _outlines(pair: Any, chord: float) -> tuple[Array, Array]:
    """Both outlines [m] in one plane, rotated so that the front flanks just touch."""
    from pitchpoint.geometry.tooth_form import gear_outline

    first, second = (points_for(gear, chord) for gear in (pair.gear1, pair.gear2))
    touch = 0.5 * pair.j_bt / (0.5 * pair.gear1.d_b)
    one = gear_outline(pair.gear1, first, rotation=touch)
    # a space of gear 2 faces tooth 0 of gear 1: on its left side for an external pair, on its right for a
    # ring
    facing = 0.0 if pair.a_w < 0.0 else pi
    two = gear_outline(pair.gear2, second, rotation=facing + pi / abs(pair.gear2.z))
    return one, two + np.array([pair.a_w, 0.0])


def active_diameters(pair: Any, which: int) -> tuple[float, float]:
    """Diameters at the start and end of the active profile of a gear [m], positive.

    Parameters
    ----------
    pair
        A `GearPair` with a contact ratio above zero.
    which
        1 or 2.

    Notes
    -----
    From d_Nf to d_Na, limited by the root form circle, where the involute ends.
    """
    gear = pair.gear1 if which == 1 else pair.gear2
    root, tip = (pair.d_Nf1, pair.d_Na1) if which == 1 else (pair.d_Nf2, pair.d_Na2)
    return abs(max(root, gear.d_Ff)), abs(tip)


def _active_flanks(pair: Any) -> tuple[Array, Array]:
    """Active parts of the two flanks in contact in the drawing [m]."""
    from pitchpoint.geometry.tooth_form import tooth_form

    found = []
    inside = pair.a_w < 0.0
    # the left flank of tooth 0 of gear 1 mates with a left flank of an external gear, a right one of a ring
    touch, next_tooth = 0.5 * pair.j_bt / (0.5 * pair.gear1.d_b), pi / abs(pair.gear2.z)
    places = ((pair.gear1, touch, 1.0, 0.0), (pair.gear2, pi - next_tooth, 1.0, pair.a_w))
    if inside:
        places = (places[0], (pair.gear2, next_tooth, -1.0, pair.a_w))
    for which, (gear, turn, side, axis) in enumerate(places, start=1):
        r = 0.5 * np.linspace(*active_diameters(pair, which), 40)
        angle = turn + side * tooth_form(gear).involute_half_angle(r)
        found.append(np.column_stack([axis + r * np.cos(angle), r * np.sin(angle)]))
    return found[0], found[1]


def _outer_radius(gear: Any) -> float:
    if gear.z > 0:
        return abs(gear.d_a) / 2.0
    return abs(gear.d_f) / 2.0 + RIM_MODULES * gear.m_n


def body(gear: Any, view: View, outline: Array, css: str, window: tuple[Array, Array] | None = None) -> str:
    """Cross section of a gear: inside its outline, or for an internal gear between outline and rim.

    Parameters
    ----------
    gear
        A `CylindricalGear`.
    view
        Transformation to pixels.
    outline
        Outline of the gear, shape (n, 2) [m].
    css
        CSS class of the shape.
    window
        Lower left and upper right corner of the visible field, to which the outline is clipped [m].
    """
    if gear.z > 0:
        return svg.polygon(view(outline), css)
    if window is None:
        angle = np.linspace(0.0, 2.0 * pi, 361)
        middle = 0.5 * (outline.min(axis=0) + outline.max(axis=0))
        around = middle + _outer_radius(gear) * np.column_stack([np.cos(angle), np.sin(angle)])
    else:
        (x0, y0), (x1, y1) = window
        around = np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]])
    return svg.polygon(view(around), css, hole=view(outline))


def _cross(center: Array) -> str:
    return "".join(
        svg.line(center - step, center + step, "pp-thin")
        for step in (np.array([7.0, 0.0]), np.array([0.0, 7.0]))
    )


def _caption(gear: Any, name: str) -> str:
    return f"{name}: z = {abs(gear.z)}"


def _marks(view: View, where: dict[str, Array], along: Array) -> list[str]:
    """Points of the path of contact, A, C, E labelled on one side, B and D on the other."""
    down = np.array([along[0], -along[1]])
    across = np.array([-down[1], down[0]])
    parts: list[str] = []
    spots = {name: view(point) for name, point in where.items()}
    # B and D may almost coincide: their letters are then moved apart along the line
    gap = float((spots["D"] - spots["B"]) @ down)
    apart = max(0.0, 18.0 - abs(gap)) / 2.0 * (1.0 if gap >= 0.0 else -1.0)
    shift = {"B": -apart, "D": apart}
    for name, spot in spots.items():
        parts.append(svg.circle(spot, 4.0, "pp-pole" if name == "C" else "pp-dot"))
        side = -18.0 if name in "BD" else 18.0
        at = spot + side * across + shift.get(name, 0.0) * down
        parts.append(svg.text(at[0], at[1] + 5.0, name, "pp-halo"))
    return parts


def _legend(top: float, pair: Any) -> str:
    """Legend of the lines, with the diameters of the active flanks."""
    # larger than its place: remains of lines would shine through at its edges
    parts = [f'<rect class="pp-paper" x="-4" y="{top:.0f}" width="{WIDTH + 8.0:.0f}" height="96"/>']
    entries = [
        ("pp-path", "path of contact A to E"),
        ("pp-action", "line of action"),
        ("pp-thin pp-base", "base circles"),
        ("pp-thin pp-pitch", "working pitch circles"),
    ]
    for which in (1, 2):
        root, tip = (number(1e3 * d, 6) for d in active_diameters(pair, which))
        entries += [
            (f"pp-active{which}", f"active flank, gear {which}"),
            ("", f"diameters {root} to {tip} mm"),
        ]
    for k, (css, words) in enumerate(entries):
        x, y = 14.0 + (k % 2) * 0.5 * WIDTH, top + 18.0 + (k // 2) * 20.0
        if css:
            parts.append(svg.line(np.array([x, y - 4.0]), np.array([x + 34.0, y - 4.0]), css))
        parts.append(svg.text(x + (44.0 if css else 0.0), y, words, "pp-small", "start"))
    return "".join(parts)
