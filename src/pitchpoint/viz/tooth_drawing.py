# SPDX-License-Identifier: Apache-2.0
"""Drawing of a tooth space with the generating tool, named circles and active flanks.

The axis is below, the space points upwards; the teeth of an internal gear then point downwards.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from pitchpoint.viz import svg
from pitchpoint.viz.gear_drawing import CHORD, View, active_diameters, body, points_for
from pitchpoint.viz.labels import spread
from pitchpoint.viz.quantities import number
from pitchpoint.viz.svg import Array

FIELD, COLUMN = 520.0, 300.0
"""Widths of the drawing and of the column of labels."""
STEP = 19.0
MARGIN = 0.5
"""Margin beyond tip and root, in modules."""
PITCHES = 1.05
"""Half of the visible width, in pitches."""


def tooth_svg(gear: Any, *, name: str = "gear", meshes: Mapping[str, tuple[Any, int]] | None = None) -> str:
    """Drawing of the teeth of a gear.

    Parameters
    ----------
    gear
        A `CylindricalGear`.
    name
        Title of the drawing.
    meshes
        By name of the mesh: its `GearPair`, and 1 or 2 for this gear in it, for the active parts of the
        flanks; the first mesh is drawn on the right side of the space.

    Notes
    -----
    The tool, if known, is the rack of an external gear or the cutter of an internal one, in the position that
    includes the thickness allowance. Measured teeth are drawn unchanged; the tool is that of the generated
    teeth.
    """
    low, high = _window(gear)
    scale = FIELD / (high[0] - low[0])
    height = scale * float(high[1] - low[1])
    view = View(low, scale, height)
    inner = [_teeth(gear, view, (low, high)), _tool(gear, view)]
    circles = _circles(gear)
    inner += [svg.circle(view([0.0, 0.0]), 0.5 * d * scale, css) for d, _, css in circles]
    lines, active = [], dict(list((meshes or {}).items())[:2])
    for k, (mesh, (pair, which)) in enumerate(active.items()):
        inner.append(_active(gear, view, pair, which, k))
        lines.append((f"pp-active{k + 1}", _active_words(gear, mesh, pair, which)))
    top = 34.0
    parts = [
        svg.text(
            10.0, 22.0, f"{name}: z = {abs(gear.z)}, mₙ = {number(1e3 * gear.m_n, 6)} mm", "pp-head", "start"
        ),
        f'<svg x="0" y="{top:.0f}" width="{FIELD:.0f}" height="{height:.1f}">{"".join(inner)}</svg>',
        f'<rect class="pp-frame" x="0.5" y="{top:.1f}" width="{FIELD - 1:.0f}" height="{height:.1f}"/>',
        *_labels(gear, view, circles, top, height),
    ]
    entries = [*lines, *_tool_words(gear)]
    for k, (css, words) in enumerate(entries):
        y = top + height + 22.0 + 20.0 * k
        parts.append(svg.line(np.array([12.0, y - 5.0]), np.array([46.0, y - 5.0]), css))
        parts.append(svg.text(56.0, y, words, "pp-small", "start"))
    total = top + height + 14.0 + 20.0 * len(entries)
    return svg.document(FIELD + COLUMN, total, parts, f"teeth of {name}")


def _window(gear: Any) -> tuple[Array, Array]:
    """Lower left and upper right corner of the visible field [m]: a space and the adjacent teeth."""
    r_a, r_f = 0.5 * abs(gear.d_a), 0.5 * abs(gear.d_fE)
    half = min(PITCHES * gear.p_t, 0.8 * 0.5 * abs(gear.d))
    inner, outer = min(r_a, r_f), max(r_a, r_f)
    # circles bend down towards the sides
    drop = inner - math.sqrt(max(0.0, inner * inner - half * half))
    bottom = max(inner - 0.6 * drop - MARGIN * gear.m_n, 0.0)
    return np.array([-half, bottom]), np.array([half, outer + MARGIN * gear.m_n])


def _upwards(points: Any) -> Array:
    """Points x + iy with the space on the x axis, in the plane of the drawing."""
    turned = 1j * np.asarray(points)
    return np.column_stack([turned.real, turned.imag])


def _teeth(gear: Any, view: View, window: tuple[Array, Array]) -> str:
    from pitchpoint.geometry.tooth_form import gear_outline

    turn = 0.5 * math.pi - math.pi / abs(gear.z)
    outline = gear_outline(gear, points_for(gear, CHORD / view.scale), rotation=turn)
    low, high = window
    # clipped beyond the edges, so that the clipping line is not visible
    more = 0.1 * (high - low)
    return body(
        gear, view, svg.clip(outline, low - more, high + more), "pp-gear", window=(low - more, high + more)
    )


def _tool(gear: Any, view: View) -> str:
    """Outline of the tool tooth in the space and its neighbours."""
    from pitchpoint.geometry.tool_outline import RACK, tool_tooth

    tool = tool_tooth(gear)
    if tool is None:
        return ""
    # counter-clockwise order along the x axis: the next tooth comes first
    line = np.concatenate([tool.at(0.0, tooth) for tooth in (-1, 0, 1)])
    if tool.kind == RACK:
        far = complex(float(line.real.max()) + gear.m_n, 0.0)
        ends = [far + 1j * line.imag[-1], far + 1j * line.imag[0]]
    else:
        ends = [complex(tool.axis, 0.0)]
    return svg.polygon(view(_upwards(np.append(line, ends))), "pp-tool")


def _tool_words(gear: Any) -> list[tuple[str, str]]:
    from pitchpoint.geometry.tool_outline import RACK, tool_tooth

    tool = tool_tooth(gear)
    if tool is None:
        return [("pp-thin", "no cutter given: the fillet is a circular arc")]
    if tool.kind == RACK:
        words = f"rack: dedendum {number(gear.h_fP_star)} mₙ, tip radius {number(gear.rack.rho_fP_star)} mₙ"
        shift = f"generating shift x_E = {number(gear.x_E)}"
        return [("pp-tool", f"{words}, {shift}{', undercut' if gear.undercut else ''}")]
    cutter = gear.cutter
    return [("pp-tool", f"cutter: {cutter.z_0} teeth, x₀ = {number(cutter.x_0)}, tip radius "
             f"{number(cutter.rho_aP0_star)} mₙ")]  # fmt: skip


def _circles(gear: Any) -> list[tuple[float, str, str]]:
    """Diameter [m], name and style of the circles; equal circles are merged."""
    named = [
        (abs(gear.d_a), "tip dₐ", "pp-thin"),
        (abs(gear.d_Fa), "tip form d_Fa", "pp-thin"),
        (abs(gear.d), "reference d", "pp-thin pp-pitch"),
        (abs(gear.d_b), "base d_b", "pp-thin pp-base"),
        (abs(gear.d_Ff), "root form d_Ff", "pp-thin pp-form"),
        (abs(gear.d_fE), "root d_fE" if gear.d_fE != gear.d_f else "root d_f", "pp-thin"),
    ]
    found: list[tuple[float, str, str]] = []
    for diameter, words, css in named:
        same = next((k for k, one in enumerate(found) if abs(one[0] - diameter) < 1e-9), None)
        if same is None:
            found.append((diameter, words, css))
        elif words != "tip form d_Fa":
            found[same] = (found[same][0], f"{found[same][1]}, {words}", found[same][2])
    return found


def _labels(
    gear: Any, view: View, circles: list[tuple[float, str, str]], top: float, height: float
) -> list[str]:
    """Names and diameters in a column, with leader lines to their circles at the edge of the drawing."""
    right = view.low[0] + FIELD / view.scale
    starts = []
    for diameter, _, _ in circles:
        r = 0.5 * diameter
        y = math.sqrt(r * r - right * right) if r > right else -1.0
        bottom = view.low[1] + 0.02 * height / view.scale
        x = right
        if y < bottom:
            # the circle leaves the drawing at the bottom: its last visible point
            y, x = bottom, math.sqrt(max(0.0, r * r - bottom * bottom))
        spot = view([x, y])
        starts.append((float(spot[0]), float(spot[1]) + top))
    places = spread([y for _, y in starts], STEP, top + 8.0, top + height - 8.0)
    parts = []
    for (x, y), at, (diameter, words, _) in zip(starts, places, circles, strict=True):
        text = f"{words} = {number(1e3 * diameter, 6)} mm"
        if 0.5 * diameter > view.low[1]:
            bend = np.array([[x, y], [FIELD + 6.0, y], [FIELD + 24.0, at], [FIELD + 30.0, at]])
            parts.append(svg.polyline(bend, "pp-leader"))
            parts.append(svg.circle(np.array([x, y]), 2.0, "pp-leader-dot"))
        else:
            text += ", below"
        parts.append(svg.text(FIELD + 35.0, float(at) + 4.5, text, "pp-small", "start"))
    return parts


def _active(gear: Any, view: View, pair: Any, which: int, count: int) -> str:
    """Active part of the flank on one side of the space."""
    from pitchpoint.geometry.tooth_form import tooth_form

    form = tooth_form(gear)
    r = 0.5 * np.linspace(*active_diameters(pair, which), 60)
    # from the middle of the space; the first mesh on the right in the drawing
    angle = (form.half_pitch_angle - form.involute_half_angle(r)) * (-1.0 if count == 0 else 1.0)
    return svg.polyline(view(_upwards(r * np.exp(1j * angle))), f"pp-active{count + 1}")


def _active_words(gear: Any, mesh: str, pair: Any, which: int) -> str:
    """Diameters and roll angles at the start and end of the active profile, in words."""
    root, tip = active_diameters(pair, which)
    rolls = [math.degrees(math.sqrt(max(0.0, (d / gear.d_b) ** 2 - 1.0))) for d in (root, tip)]
    where = f"d {number(1e3 * root, 6)} (SAP) to {number(1e3 * tip, 6)} mm (EAP)"
    return f"active in {mesh}: {where}, roll {number(rolls[0], 4)}° to {number(rolls[1], 4)}°"
