# SPDX-License-Identifier: Apache-2.0
"""General sections of a report: scene, provenance."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import Any

from pitchpoint.viz.report.page import Section
from pitchpoint.viz.scene.page import scene_fragment

HEIGHT = "clamp(430px, 78vh, 760px)"
"""Height of the scene, with space for scrolling on small screens."""


def scene_section(data: Any) -> Section:
    """Section with the scene, or a sentence if there is none."""
    section = Section("scene", "Scene")
    if data.scene is None:
        section.add(f"<p>{escape(data.words)}</p>" if data.words else "")
        return section
    section.add('<p class="screen"><a class="skip" href="#after-scene">Skip the scene</a></p>')
    section.add(f'<div class="scene">{scene_fragment(data.scene, height=HEIGHT)}</div>')
    section.add('<img id="pp-still" alt="The scene at the selected time" hidden>')
    section.add(f'<p id="after-scene" tabindex="-1">{escape(data.words)}</p>')
    return section


def provenance_section(sources: Sequence[Any]) -> Section:
    """Section with file, fingerprint, solver, options and status of each result."""
    section = Section("provenance", "Provenance")
    for source in sources:
        rows = [
            f'<tr><th scope="row">{escape(key)}</th><td>{escape(text)}</td></tr>' for key, text in source.rows
        ]
        if rows:
            section.add(f"<h3>{escape(source.name)}</h3>")
            section.add(
                f'<div class="scroll"><table class="plain"><tbody>{"".join(rows)}</tbody></table></div>'
            )
    return section
