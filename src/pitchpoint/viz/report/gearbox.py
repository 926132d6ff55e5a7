# SPDX-License-Identifier: Apache-2.0
"""Section of a report on the gearbox: drawing in section, power flow at constant speed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from typing import Any

from pitchpoint.viz.quantities import printed
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.tables import plain_table, symbol_html

WORDS = (
    *("gears", "driven by", "drives", "section", "bodies"),
    *("power flow", "speeds", "loads", "next to", "elements", "clearance", "axial force", "on its supports"),
)
"""Heads of columns with words."""
SYMBOLS = ("T_1", "T_2", "F_wt", "F_wr", "F_a", "v_w", "f_z")
"""Heads that are symbols."""


@dataclass(frozen=True, kw_only=True)
class GearboxData:
    """Drawing and power flow of a gearbox.

    Attributes
    ----------
    drawing
        SVG drawing; empty without gears on bodies.
    flows
        Power flows as texts: `names` of the scenarios, `summary`, `tables` with `title`, `head`, `rows` and
        `notes`, and `notes`.
    tables
        Further tables: load cases, planetary stages, scissor gears, ring modes, rolling bearings.
    """

    drawing: str = ""
    flows: Sequence[Any] = ()
    tables: Sequence[Any] = ()


def gearbox_section(data: GearboxData) -> Section:
    """Section with the drawing and the tables of the power flow."""
    section = Section("gearbox", "Gearbox")
    if data.drawing:
        words = "Developed section, with the axes unfolded into one plane, and transverse view."
        section.add(f"<figure>{data.drawing}<figcaption>{words}</figcaption></figure>")
    for flow in data.flows:
        names = ", ".join(name for name in flow.names if name)
        section.add(f"<h3>Power flow at constant speed{f': {escape(names)}' if names else ''}</h3>")
        section.add(f"<p>{escape(printed(flow.summary[:1].upper() + flow.summary[1:]))}.</p>")
        for table in flow.tables:
            section.add(f"<h4>{escape(table.title)}</h4>{_table(table)}")
            section.add(f"<p>{_symbols(' '.join(table.notes))}.</p>" if table.notes else "")
        section.add(_notes(flow.notes))
    for table in data.tables:
        section.add(f"<h3>{escape(table.title)}</h3>{_table(table)}{_notes(table.notes)}")
    return section


def _table(table: Any) -> str:
    """Table of texts."""
    texts = [k for k, head in enumerate(table.head) if head in WORDS]
    made = plain_table(table.head, [_row(row, texts) for row in table.rows], words=1, texts=texts)
    for symbol in SYMBOLS:
        made = made.replace(f">{symbol}</th>", f">{symbol_html(symbol)}</th>")
    return made


def _notes(notes: Sequence[str]) -> str:
    """List of notes."""
    items = "".join(f"<li>{escape(printed(note))}</li>" for note in notes)
    return f'<ul class="notes">{items}</ul>' if items else ""


def _row(row: Sequence[str], texts: Sequence[int]) -> str:
    """Row of a table: name, words and numbers."""
    cells = "".join(
        f"<td>{escape(printed(text))}</td>" if k in texts else f'<td class="num">{escape(printed(text))}</td>'
        for k, text in enumerate(row)
        if k
    )
    return f'<tr><th scope="row">{escape(row[0])}</th>{cells}</tr>'


def _symbols(text: str) -> str:
    """Text with the symbols in HTML."""
    found = escape(text)
    for symbol in SYMBOLS:
        found = found.replace(symbol, symbol_html(symbol))
    return found
