# SPDX-License-Identifier: Apache-2.0
"""One HTML file around a scene, or two side by side: it needs no network, no server, nothing else."""

from __future__ import annotations

from html import escape

from pitchpoint.viz import theme
from pitchpoint.viz.report_page import POLICY, asset
from pitchpoint.viz.scene import Scene
from pitchpoint.viz.scene_file import scene_texts


def scene_elements(*scenes: Scene) -> str:
    """The elements that hold one scene, or two that are compared."""
    parts = []
    for scene, mark in zip(scenes, ("", "-2"), strict=False):
        header, numbers = scene_texts(scene)
        parts.append(f'<script type="application/json" id="pp-scene{mark}">{header}</script>')
        parts.append(f'<script type="text/plain" id="pp-scene-numbers{mark}">{numbers}</script>')
    return "\n".join(parts)


def scene_page(*scenes: Scene) -> str:
    """The complete document.

    Parameters
    ----------
    scenes
        One scene, or two to compare.

    Raises
    ------
    ValueError
        If there are none or more than two, or a number is not finite.
    """
    if not 1 <= len(scenes) <= 2:
        raise ValueError(f"{len(scenes)} scenes do not fit on a page; give one or two")
    title = " and ".join(dict.fromkeys(s.title for s in scenes))
    colours = "".join(f"--pp-force-{part}:{colour};" for part, colour in theme.FORCE_PARTS.items())
    compare = "true" if len(scenes) == 2 else "false"
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        '<meta name="generator" content="pitchpoint">'
        f"<title>{escape(title)}</title>"
        f"<style>:root{{{colours}}}html,body{{margin:0;height:100%}}#pp-view{{height:100vh}}</style></head>\n"
        f'<body><div id="pp-view"></div>\n{scene_elements(*scenes)}\n'
        f"<script>{asset('viewer.js')}</script>\n"
        f"<script>pitchpointViewer.mount(document.getElementById('pp-view'),{{compare:{compare}}});</script>"
        "</body></html>\n"
    )
