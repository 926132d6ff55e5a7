# SPDX-License-Identifier: Apache-2.0
"""Live page of a model: one HTML file in which the compiled model runs, with sliders, curves and scene."""

from __future__ import annotations

import base64
import json
from collections.abc import Mapping, Sequence
from html import escape
from typing import Any

from pitchpoint.viz import theme
from pitchpoint.viz.report.page import POLICY as PAGE_POLICY
from pitchpoint.viz.report.page import asset
from pitchpoint.viz.scene.content import Scene
from pitchpoint.viz.scene.page import scene_elements

POLICY = PAGE_POLICY.replace("script-src 'unsafe-inline'", "script-src 'unsafe-inline' 'wasm-unsafe-eval'")
CURVES = 3
"""Number of curves."""
FIRST = (
    *("rotor_thrust", "aerodynamic_power", "mesh_force", "deflection"),
    *("speed", "torque", "angle", "displacement", "signal"),
)
"""Quantities that are shown first, in this order."""


def live_page(
    title: str,
    code: bytes,
    *,
    token: str,
    settable: Sequence[Mapping[str, Any]],
    outputs: Sequence[Mapping[str, Any]],
    start: float,
    sample: float,
    scene: Scene | None = None,
    follow: Mapping[str, Any] | None = None,
) -> str:
    """Complete HTML document; it needs no network and no server.

    Parameters
    ----------
    title
        Title of the page.
    code
        Module of the model (`io.fmu.web.web_assembly`).
    token
        Identifier of the model.
    settable, outputs
        Variables with `name`, `reference`, the `unit` in which they are shown and its `factor`; outputs also
        with the `size` of their value at the start, those that can be set with `start`, and with `least` and
        `most` if they have limits.
    start, sample
        Start time and time between two samples [s].
    scene, follow
        Scene of the model, and how its bodies and forces follow (`report.scene.live`); None: no scene.
    """
    data = {
        "token": token,
        "settable": list(settable),
        "outputs": list(outputs),
        "start": start,
        "sample": sample,
        "shown": first_channels({str(each["name"]): float(each["size"]) for each in outputs}),
        "follow": follow,
    }
    variables = {
        mode: "".join(f"--pp-{key}:{value};" for key, value in colours.items())
        for mode, colours in (("light", theme.LIGHT), ("dark", theme.DARK))
    }
    style = (
        f":root{{color-scheme:light dark;--pp-font:{theme.FONT};--pp-curve:{theme.TEAL};"
        f"{variables['light']}}}@media(prefers-color-scheme:dark){{:root{{{variables['dark']}}}}}"
        f"{asset('live.css')}"
    )
    packed = base64.b64encode(code).decode("ascii")
    described = json.dumps(data).replace("<", "\\u003c")
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        '<meta name="generator" content="pitchpoint">'
        f"<title>{escape(title)}</title><style>{style}</style></head>\n<body>"
        f'<header><h1>{escape(title)}</h1><div class="bar"><button id="run">Pause</button>'
        '<button id="reset">Reset</button><label title="simulated time per second">Time scale '
        '<input id="pace" type="range" min="-5" max="0" step="0.1"> <output id="scale"></output></label>'
        '<span id="status" role="status"></span></div></header>\n'
        f'<main><div id="controls"></div><div id="picture">{_view(scene)}<div id="plots"></div></div>'
        "</main>\n"
        f'<script type="application/json" id="pp-model">{described}</script>\n'
        f'<script type="text/plain" id="pp-code">{packed}</script>\n'
        f"<script>{asset('live.js')}</script></body></html>\n"
    )


def _view(scene: Scene | None) -> str:
    """Element of the scene with its data and script; empty without a scene."""
    if scene is None:
        return ""
    colours = "".join(f"--pp-force-{part}:{colour};" for part, colour in theme.FORCE_PARTS.items())
    script = f"<script>{asset('viewer.js')}</script>"
    return f'<div id="scene" style="{colours}"></div>{scene_elements(scene)}{script}'


def first_channels(sizes: Mapping[str, float]) -> list[int]:
    """Indices of the channels of the curves at the start: by the order of `FIRST`, the largest of each.

    Examples
    --------
    >>> first_channels({"angle[a]": 0.0, "speed[a]": 5.0, "mesh_force[m]": 3.0, "speed[b]": 9.0})
    [2, 3, 0]
    """
    names = list(sizes)
    chosen = []
    for word in FIRST:
        known = [k for k, name in enumerate(names) if name.partition("[")[0] == word]
        chosen += [max(known, key=lambda k: sizes[names[k]])] if known else []
    return (chosen + [k for k in range(len(names)) if k not in chosen])[:CURVES]
