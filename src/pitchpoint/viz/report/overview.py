# SPDX-License-Identifier: Apache-2.0
"""General sections of a report: scene, provenance."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from typing import Any

from pitchpoint.viz.report.page import Section
from pitchpoint.viz.scene.page import scene_fragment
from pitchpoint.viz.tables import plain_table

MAX_SOURCES = 4
"""Results next to each other in the table of provenance."""
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
    section.add(f'<p id="after-scene" tabindex="-1">{escape(data.words)}{_screen(data.hint)}</p>')
    return section


def _screen(text: str) -> str:
    """Sentence about a control of the page, which is not printed."""
    return f' <span class="screen">{escape(text)}</span>' if text else ""


def provenance_section(sources: Sequence[Any]) -> Section:
    """Section with file, fingerprint, solver, options and status of the results, one column each."""
    section = Section("provenance", "Provenance")
    known = {source.name: dict(source.rows) for source in sources if source.rows}
    for part in batched(known.items(), MAX_SOURCES):
        columns = dict(part)
        body = []
        for key in dict.fromkeys(key for rows in columns.values() for key in rows):
            cells = "".join(f"<td>{escape(rows.get(key, '–'))}</td>" for rows in columns.values())
            body.append(f'<tr><th scope="row">{escape(key)}</th>{cells}</tr>')
        section.add(plain_table(("result", *columns), body, numbers=False))
    return section


def batched(items: Iterable[Any], size: int) -> list[tuple[Any, ...]]:
    """Items in groups of at most `size`.

    Examples
    --------
    >>> batched("abcde", 2)
    [('a', 'b'), ('c', 'd'), ('e',)]
    """
    given = list(items)
    return [tuple(given[k : k + size]) for k in range(0, len(given), size)]
