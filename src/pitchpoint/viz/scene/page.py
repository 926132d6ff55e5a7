# SPDX-License-Identifier: Apache-2.0
"""A scene, or two side by side, as part of a page or as a page of its own: no network, no server."""

from __future__ import annotations

from html import escape

from pitchpoint.viz import theme
from pitchpoint.viz.report.page import POLICY, asset
from pitchpoint.viz.scene.content import Scene
from pitchpoint.viz.scene.file import scene_texts


def scene_elements(*scenes: Scene) -> str:
    """The elements that hold one scene, or two that are compared."""
    parts = []
    for scene, mark in zip(scenes, ("", "-2"), strict=False):
        header, numbers = scene_texts(scene)
        parts.append(f'<script type="application/json" id="pp-scene{mark}">{header}</script>')
        parts.append(f'<script type="text/plain" id="pp-scene-numbers{mark}">{numbers}</script>')
    return "\n".join(parts)


def scene_fragment(*scenes: Scene, height: str = "640px") -> str:
    """A scene for the body of a longer page, which holds no other one.

    Parameters
    ----------
    *scenes
        One scene, or two to compare.
    height
        Height of the viewer in the page, as CSS has it.

    Raises
    ------
    ValueError
        If there are none or more than two, or a number is not finite.
    """
    if not 1 <= len(scenes) <= 2:
        raise ValueError(f"{len(scenes)} scenes do not fit on a page; give one or two")
    colours = "".join(f"--pp-force-{part}:{colour};" for part, colour in theme.FORCE_PARTS.items())
    compare = "true" if len(scenes) == 2 else "false"
    return (
        f'<div id="pp-view" style="{colours}height:{height}"></div>\n{scene_elements(*scenes)}\n'
        f"<script>{asset('viewer.js')}</script>\n"
        f"<script>pitchpointViewer.mount(document.getElementById('pp-view'),{{compare:{compare}}});</script>"
    )


def scene_page(*scenes: Scene) -> str:
    """The complete document.

    Parameters
    ----------
    *scenes
        One scene, or two to compare.

    Raises
    ------
    ValueError
        If there are none or more than two, or a number is not finite.
    """
    title = " and ".join(dict.fromkeys(s.title for s in scenes))
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        '<meta name="generator" content="pitchpoint">'
        f"<title>{escape(title)}</title><style>html,body{{margin:0;height:100%}}</style></head>\n"
        f"<body>{scene_fragment(*scenes, height='100vh')}</body></html>\n"
    )


def scene_frame(*scenes: Scene, height: str = "480px") -> str:
    """A page with a scene as a frame within another document, which may hold several of them.

    It is light or dark as the theme of that document, where it gives its theme, else as the system.

    Parameters
    ----------
    *scenes
        One scene, or two to compare.
    height
        Height of the frame, as CSS has it.
    """
    title = " and ".join(dict.fromkeys(s.title for s in scenes))
    return (
        f"<style>{theme.LIGHT_PAGE} .pp-cell{{color-scheme:light}}"
        f"{theme.DARK_PAGE} .pp-cell{{color-scheme:dark}}</style>"
        f'<iframe class="pp-cell" title="{escape(title)}" sandbox="allow-scripts allow-downloads" '
        f'style="width:100%;height:{height};border:0" srcdoc="{escape(scene_page(*scenes))}"></iframe>'
    )
