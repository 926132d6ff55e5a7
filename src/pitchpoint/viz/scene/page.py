# SPDX-License-Identifier: Apache-2.0
"""One scene, or two next to each other, as part of a page or as a self-contained page."""

from __future__ import annotations

import json
from dataclasses import dataclass
from html import escape
from typing import Any

from pitchpoint.viz import theme
from pitchpoint.viz.report.page import POLICY, asset
from pitchpoint.viz.scene.content import Scene
from pitchpoint.viz.scene.file import scene_texts


@dataclass(frozen=True, kw_only=True)
class SceneStart:
    """Initial view of a scene.

    Attributes
    ----------
    view
        Standard view: axis, side, top or iso.
    parallel
        Parallel instead of central projection.
    section
        Normal of a section plane through the middle: x, y, z or axis; empty without section.
    """

    view: str = "iso"
    parallel: bool = False
    section: str = ""

    def words(self) -> dict[str, str]:
        """The same in the form of the address of the page.

        Examples
        --------
        >>> SceneStart(view="axis", parallel=True).words()
        {'view': 'axis', 'projection': 'parallel'}
        """
        found = {
            "view": self.view,
            "projection": "parallel" if self.parallel else "",
            "section": self.section,
        }
        return {key: value for key, value in found.items() if value}


def scene_elements(*scenes: Scene) -> str:
    """HTML elements with one scene, or two scenes for comparison."""
    parts = []
    for scene, mark in zip(scenes, ("", "-2"), strict=False):
        header, numbers = scene_texts(scene)
        parts.append(f'<script type="application/json" id="pp-scene{mark}">{header}</script>')
        parts.append(f'<script type="text/plain" id="pp-scene-numbers{mark}">{numbers}</script>')
    return "\n".join(parts)


def scene_fragment(*scenes: Scene, height: str = "640px", start: SceneStart | None = None) -> str:
    """HTML of a scene for the body of a longer page; one per page.

    Parameters
    ----------
    *scenes
        One scene, or two to compare.
    height
        Height of the viewer in the page, in CSS notation.
    start
        Initial view.

    Raises
    ------
    ValueError
        If there are none or more than two, or a number is not finite.
    """
    if not 1 <= len(scenes) <= 2:
        raise ValueError(f"{len(scenes)} scenes in a page (limit 2); give one or two")
    colours = "".join(f"--pp-force-{part}:{colour};" for part, colour in theme.FORCE_PARTS.items())
    options: dict[str, Any] = {"compare": len(scenes) == 2}
    if start is not None:
        options["start"] = start.words()
    how = json.dumps(options, separators=(",", ":"))
    return (
        f'<div id="pp-view" style="{colours}height:{height}"></div>\n{scene_elements(*scenes)}\n'
        f"<script>{asset('viewer.js')}</script>\n"
        f"<script>pitchpointViewer.mount(document.getElementById('pp-view'),{how});</script>"
    )


def scene_page(*scenes: Scene, start: SceneStart | None = None) -> str:
    """Complete HTML document.

    Parameters
    ----------
    *scenes
        One scene, or two to compare.
    start
        Initial view.

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
        f"<body>{scene_fragment(*scenes, height='100vh', start=start)}</body></html>\n"
    )


def scene_frame(*scenes: Scene, height: str = "480px") -> str:
    """Page with a scene as a frame within another document, which may contain several.

    Its colours follow the theme of that document, if known, else the system.

    Parameters
    ----------
    *scenes
        One scene, or two to compare.
    height
        Height of the frame, in CSS notation.
    """
    return cell_frame(" and ".join(dict.fromkeys(s.title for s in scenes)), scene_page(*scenes), height)


def cell_frame(title: str, document: str, height: str) -> str:
    """Complete HTML document as a frame within another one; colours follow the theme of that document."""
    return (
        f"<style>{theme.LIGHT_PAGE} .pp-cell{{color-scheme:light}}"
        f"{theme.DARK_PAGE} .pp-cell{{color-scheme:dark}}</style>"
        f'<iframe class="pp-cell" title="{escape(title)}" sandbox="allow-scripts allow-downloads" '
        f'style="width:100%;height:{height};border:0" srcdoc="{escape(document)}"></iframe>'
    )
