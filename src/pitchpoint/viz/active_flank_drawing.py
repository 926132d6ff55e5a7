# SPDX-License-Identifier: Apache-2.0
"""Drawing of a tooth whose flank is filled between start and end of contact under load."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from pitchpoint.viz import svg
from pitchpoint.viz.gear_drawing import CHORD, View, body, points_for
from pitchpoint.viz.labels import spread
from pitchpoint.viz.quantities import number
from pitchpoint.viz.svg import Array

FIELD, COLUMN, STEP = 430.0, 330.0, 19.0
"""Widths of the drawing and of the column of labels, distance of the labels [pixels]."""
HALF = 0.62
"""Half of the visible width, in pitches."""
LOADED = ("contact, root side", "contact, tip side")
"""Ends of the flank in contact: it begins at the tip of a driven gear."""
UNDEFORMED = ("d_Nf, undeformed", "d_Na, undeformed")
"""The same of undeformed gears."""
_POINTS = 60

Circle = tuple[float, float, str, str]
"""Diameter [m], roll angle [rad], words, and style."""


def active_flank_svg(gear: Any, loaded: Any, *, name: str, words: str) -> str:
    """Drawing of one tooth, filled where its flanks are in contact.

    Parameters
    ----------
    gear
        A `CylindricalGear`.
    loaded
        Flank in contact under load, as of `analysis.flank_contact.active_flank`.
    name
        Name of the gear.
    words
        Load case.

    Notes
    -----
    The fill ends at the root form circle, where the involute ends; contact below it is interference.
    """
    low, high = _window(gear)
    scale = FIELD / float(high[0] - low[0])
    height = scale * float(high[1] - low[1])
    view = View(low, scale, height)
    circles = [
        (abs(gear.d_a), _roll_angle(gear, gear.d_a), "tip dₐ", "pp-thin"),
        *_ends(loaded.diameter, loaded.roll_angle, LOADED, "pp-path"),
        *_ends(loaded.geometric_diameter, loaded.geometric_roll_angle, UNDEFORMED, "pp-thin"),
        (abs(gear.d_Ff), _roll_angle(gear, gear.d_Ff), "root form d_Ff", "pp-thin pp-form"),
    ]
    inner = [_tooth(gear, view, (low, high)), _fill(gear, loaded, view)]
    inner += [
        svg.circle(view([0.0, 0.0]), 0.5 * d * scale, css) for d, _, _, css in circles if css != "pp-path"
    ]
    top = 34.0
    parts = [
        svg.text(10.0, 22.0, f"{name}: flank in contact, {words}", "pp-head", "start"),
        f'<svg x="0" y="{top:.0f}" width="{FIELD:.0f}" height="{height:.1f}">{"".join(inner)}</svg>',
        f'<rect class="pp-frame" x="0.5" y="{top:.1f}" width="{FIELD - 1:.0f}" height="{height:.1f}"/>',
        *_labels(gear, view, circles, top, height),
    ]
    return svg.document(FIELD + COLUMN, top + height + 10.0, parts, f"flank of {name} in contact")


def _ends(diameters: Array, rolls: Array, words: tuple[str, str], css: str) -> list[Circle]:
    """Circles of both ends of a flank."""
    return [(float(d), float(roll), text, css) for d, roll, text in zip(diameters, rolls, words, strict=True)]


def _roll_angle(gear: Any, diameter: float) -> float:
    """Roll angle of a diameter [rad], 0 inside the base circle."""
    return math.sqrt(max((diameter / abs(gear.d_b)) ** 2 - 1.0, 0.0))


def _window(gear: Any) -> tuple[Array, Array]:
    """Lower left and upper right corner of the visible field [m]: one tooth, the axis below."""
    r_a, r_f = 0.5 * abs(gear.d_a), 0.5 * abs(gear.d_fE)
    half = min(HALF * gear.p_t, 0.4 * abs(gear.d))
    inner, outer = min(r_a, r_f), max(r_a, r_f)
    drop = inner - math.sqrt(max(0.0, inner * inner - half * half))
    bottom = max(inner - 0.6 * drop - 0.4 * gear.m_n, 0.0)
    return np.array([-half, bottom]), np.array([half, outer + 0.4 * gear.m_n])


def _upwards(points: Any) -> Array:
    """Points x + iy with the tooth on the x axis, in the plane of the drawing."""
    turned = 1j * np.asarray(points)
    return np.column_stack([turned.real, turned.imag])


def _tooth(gear: Any, view: View, window: tuple[Array, Array]) -> str:
    """The tooth and parts of its neighbours."""
    from pitchpoint.geometry.tooth_form import gear_outline

    outline = gear_outline(gear, points_for(gear, CHORD / view.scale), rotation=0.5 * math.pi)
    low, high = window
    more = 0.1 * (high - low)
    clipped = svg.clip(outline, low - more, high + more)
    return body(gear, view, clipped, "pp-gear", window=(low - more, high + more))


def _fill(gear: Any, loaded: Any, view: View) -> str:
    """Tooth between start and end of contact, with its flanks in colour."""
    from pitchpoint.geometry.tooth_form import tooth_form

    form = tooth_form(gear)
    low, high = np.clip(np.sort(loaded.diameter), *sorted((abs(gear.d_Ff), abs(gear.d_Fa))))
    r = 0.5 * np.linspace(float(low), float(high), _POINTS)
    half = np.asarray(form.involute_half_angle(r))
    flank = r * np.exp(1j * half)
    arcs = [r[k] * np.exp(1j * np.linspace(half[k], -half[k], _POINTS)) for k in (-1, 0)]
    ring = np.concatenate([flank, arcs[0], np.conj(flank[::-1]), arcs[1][::-1]])
    return svg.polygon(view(_upwards(ring)), "pp-tool") + "".join(
        svg.polyline(view(_upwards(side)), "pp-active1") for side in (flank, np.conj(flank))
    )


def _labels(gear: Any, view: View, circles: list[Circle], top: float, height: float) -> list[str]:
    """Diameters and roll angles in a column, with leader lines to their circles."""
    right = view.low[0] + FIELD / view.scale
    ordered = sorted(circles, key=lambda item: -item[0])
    starts = []
    for diameter, _, _, css in ordered:
        r = 0.5 * diameter
        x = right
        if css == "pp-path":
            from pitchpoint.geometry.tooth_form import tooth_form

            inside = float(np.clip(r, *sorted((0.5 * abs(gear.d_Ff), 0.5 * abs(gear.d_Fa)))))
            x = r * math.sin(abs(float(tooth_form(gear).involute_half_angle(np.array([inside]))[0])))
        spot = view([x, math.sqrt(max(r * r - x * x, 0.0))])
        starts.append((float(spot[0]), float(spot[1]) + top))
    places = spread([y for _, y in starts], STEP, top + 8.0, top + height - 8.0)
    parts = []
    for (x, y), at, (diameter, roll, words, css) in zip(starts, places, ordered, strict=True):
        text = f"{words}: {number(1e3 * diameter, 6)} mm, roll {number(math.degrees(roll), 4)}°"
        bend = np.array([[x, y], [FIELD + 6.0, y], [FIELD + 24.0, at], [FIELD + 30.0, at]])
        parts.append(svg.polyline(bend, "pp-leader"))
        parts.append(svg.circle(np.array([x, y]), 2.5, "pp-leader-dot"))
        style = "pp-text pp-tiny" if css == "pp-path" else "pp-small"
        parts.append(svg.text(FIELD + 35.0, float(at) + 4.5, text, style, "start"))
    return parts
