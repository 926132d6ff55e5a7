# SPDX-License-Identifier: Apache-2.0
"""Fatigue loads in a report: damage-equivalent loads, loads of the teeth, their durations."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape
from typing import Any

from pitchpoint.viz import theme
from pitchpoint.viz.quantities import amount, channel_label
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.tables import plain_table

DRAWN = 8
"""Number of gears whose load duration is drawn, from that with the largest force."""


def add_fatigue(section: Section, found: Mapping[str, Any], name: str) -> None:
    """Add tables of fatigue loads and the pulses of the teeth over their force to a section.

    Parameters
    ----------
    section
        The section of the run.
    found
        As returned by `report.fatigue.fatigue_loads`; without loads there is no section.
    name
        Of the run.
    """
    if not found or not (found["channels"] or found["teeth"]):
        return
    section.add(f"<h4>Fatigue loads</h4><p>{_words(found)}</p>")
    head = ["load", "minimum", "mean", "maximum", *(f"m = {m:g}" for m in found["slopes"])]
    rows = []
    for channel, row in found["channels"].items():
        values = [row["min"], row["mean"], row["max"], *row["equivalent"]]
        cells = "".join(f"<td class=num>{amount(v, row['unit'], 4)}</td>" for v in values)
        rows.append(f'<tr><th scope="row">{escape(channel_label(channel))}</th>{cells}</tr>')
    section.add(plain_table(head, rows, words=1))
    teeth = [(g, f, row) for g, flanks in found["teeth"].items() for f, row in flanks.items()]
    notes = escape(" ".join(f"{note}." for note in found["notes"]))
    if not teeth:
        section.add(f"<p>{notes}</p>" if notes else "")
        return
    head = ["gear", "flank", "pulses per tooth", "largest force", "equivalent, all teeth", "tooth"]
    rows = [
        f'<tr><th scope="row">{escape(gear)}</th><td>{flank}</td>'
        f"<td class=num>{min(row['pulses']):.0f} to {max(row['pulses']):.0f}</td>"
        f"<td class=num>{amount(max(row['largest']), 'N', 4)}</td>"
        f"<td class=num>{amount(min(row['equivalent']), 'N', 4)} to "
        f"{amount(max(row['equivalent']), 'N', 4)}</td>"
        f"<td class=num>{row['worst']}</td></tr>"
        for gear, flank, row in teeth
    ]
    section.add(plain_table(head, rows))
    section.add(
        f"<p>{found['tooth_force'].capitalize()}; equivalent for m = {found['tooth_slope']:g}, as many "
        f"constant pulses as the teeth have in the mean. {notes}</p>"
    )
    figure = theme.figure("force of a tooth [kN]", "share of the pulses above [%]")
    largest = sorted(teeth, key=lambda entry: -max(entry[2]["largest"]))[:DRAWN]
    for k, (gear, flank, row) in enumerate(largest):
        figure.add_scatter(
            x=[1e-3 * level for level in row["levels"]],
            y=[100.0 * share for share in row["exceeded"]],
            name=f"{gear}, {flank}",
            mode="lines",
            line={"color": theme.colour_of("", k)},
        )
    section.add_figure(figure, "Load spectrum of the teeth.", name=f"tooth_spectrum[{name}]")


def _words(found: Mapping[str, Any]) -> str:
    """Conditions of the equivalent loads."""
    return (
        f"Ranges of {found['cycles']:.4g} equal cycles with the same damage as the rain-flow cycles in "
        f"{found['duration']:.4g} s, for Wöhler lines with the exponent m; open cycles count as halves."
    )
