# SPDX-License-Identifier: Apache-2.0
"""Section of a report with Campbell diagrams and ranked critical speeds."""

from __future__ import annotations

import math
from collections.abc import Mapping
from html import escape
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.analysis.campbell_ranking import RankedSpeed, UnstableRange, ranked_speeds, unstable_ranges
from pitchpoint.viz.campbell_plot import plot_campbell
from pitchpoint.viz.quantities import number, scale
from pitchpoint.viz.report.page import Section, keep_height
from pitchpoint.viz.tables import plain_table

if TYPE_CHECKING:
    import xarray as xr

LISTED = 12
"""Maximum number of critical speeds in the table."""


def campbell_section(diagrams: Mapping[str, xr.Dataset]) -> Section:
    """Campbell diagrams, and tables of critical speeds."""
    section = Section("campbell", "Campbell diagram")
    for name, data in diagrams.items():
        if not data["frequency"].size or data.sizes["speed"] < 2:
            continue
        section.add(f"<h3>{escape(name)}</h3>" if name else "")
        ranked = ranked_speeds(data)
        words = f"Critical speeds are {data.attrs.get('ranking', 'ranked')}."
        caption = words if ranked else "No critical speed in this range."
        drawn = plot_campbell(data)
        keep_height(drawn)
        section.add_figure(drawn, caption, name="campbell")
        if ranked:
            section.add(_table(ranked, "crossing_separation" in data))
            more = len(ranked) - LISTED
            section.add(f"<p>{more} more in the result of pitchpoint campbell.</p>" if more > 0 else "")
        unstable = unstable_ranges(data)
        if unstable:
            section.add("<p>Unstable modes grow without excitation:</p>" + _unstable_table(unstable))
    return section


def _unstable_table(listed: tuple[UnstableRange, ...]) -> str:
    """Table of unstable modes."""
    rows = []
    for u in listed:
        low, high = (scale("rad/s").text(x) for x in (u.low, u.high))
        damping = f"{number(100.0 * u.damping_ratio, 3)} %".replace("-", "−")
        cells = [f'<td class="num">{x}</td>' for x in (f"{low} – {high}", damping)]
        cells.append(f"<td>{escape(u.source or '–')}</td>")
        rows.append(f'<tr><th scope="row">{escape(u.mode)}</th>{"".join(cells)}</tr>')
    return plain_table(("mode", "speed", "lowest damping", "driven by"), rows)


def _table(ranked: tuple[RankedSpeed, ...], apart: bool) -> str:
    """Table of the first critical speeds."""
    rows = []
    for rank, c in enumerate(ranked[:LISTED], start=1):
        damping = f"{number(100.0 * c.damping_ratio, 3)} %".replace("-", "−")
        cells = [
            scale("rad/s").text(c.speed),
            scale("Hz", [c.frequency]).text(c.frequency),
            damping,
            escape(c.order),
            escape(c.mode),
            f"{escape(c.source)} {number(100.0 * c.participation, 3)} %",
            number(c.amplification, 3)
            if math.isfinite(c.amplification)
            else ("unstable" if c.damping_ratio < 0.0 else "∞"),
        ]
        if apart:
            known = np.isfinite(c.separation)
            cells.append(
                "in range"
                if c.separation == 0.0
                else f"{100.0 * c.separation:+.0f} %".replace("-", "−")
                if known
                else "–"
            )
        body = "".join(f'<td class="{"num" if k not in TEXTS else ""}">{x}</td>' for k, x in enumerate(cells))
        rows.append(f'<tr><th scope="row">{rank}</th>{body}</tr>')
    heads = ["rank", "speed", "frequency", "damping", "order", "mode", "driven by", "amplification"]
    heads += ["from operation"] if apart else []
    return plain_table(heads, rows, words=1, texts=[k + 1 for k in TEXTS])


TEXTS = (3, 4, 5)
"""Columns of text after the rank."""
