# SPDX-License-Identifier: Apache-2.0
"""Section of a report with extremes: mean, rms, minimum and maximum of the channels, and their times."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape
from typing import Any

import numpy as np

from pitchpoint.analysis.statistics import signal_statistics
from pitchpoint.viz.quantities import Array, Channel, Scale, channels, number, scale, window_words
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.run_record import FORCE_PARTS, TIME_QUANTITIES, channel_word, listed, settled_part
from pitchpoint.viz.tables import MAX_ROWS, plain_table


def extreme_section(runs: Mapping[str, Any], seen: str = "") -> Section:
    """Section with tables of extremes.

    Parameters
    ----------
    runs
        Time responses by name.
    seen
        Run displayed in the scene of the page: its times set the time of the scene.
    """
    section = Section("extremes", "Extremes")
    for name, run in runs.items():
        time, found = channels(run.data)
        if time.size < 2 or not found:
            continue
        section.add(f"<h3>{escape(name)}</h3>" if len(runs) > 1 else "")
        settled = settled_part(time, run.settle_time)
        _add_table(section, time[settled], found, settled, linked=name == seen)
        begin, end = time[settled][[0, -1]]
        window = window_words(float(begin), float(end)).capitalize()
        words = f"{window}; times are those of the nearest stored sample."
        section.add(f"<p>{escape(words)}{' Click a time to set the scene.' if name == seen else ''}</p>")
    return section


def _add_table(
    section: Section, time: Array, found: Mapping[str, Channel], settled: np.ndarray, linked: bool
) -> None:
    """Table of the main channels, and a sentence about all others."""
    wanted = [
        c
        for quantity in (*TIME_QUANTITIES, *FORCE_PARTS)
        for c in found.values()
        if listed(c, quantity) and np.all(np.isfinite(c.values))
    ]
    moving = [c for c in wanted if np.any(c.values != 0.0)]
    clock = scale("s", time)
    table = [(c, c.statistics or vars(signal_statistics(c.values[settled], time))) for c in moving]
    extent: dict[str, list[float]] = {}
    for channel, values in table:
        extent.setdefault(channel.unit, []).extend((values["min"], values["max"]))
    rows = []
    for channel, values in table:
        shown = scale(channel.unit, extent[channel.unit])
        moments = [float(time[k(channel.values[settled])]) for k in (np.argmin, np.argmax)]
        rows.append(_row(channel, values, shown, [_time(t, clock, linked) for t in moments]))
    if rows:
        at = f"at [{clock.unit}]"
        head = ("channel", "unit", "mean", "rms (alternating)", "minimum", at, "maximum", at)
        section.add(plain_table(head, rows[:MAX_ROWS]))
        more = rows[MAX_ROWS:]
        folded = f"<details><summary>{len(more)} more channels</summary>{plain_table(head, more)}</details>"
        section.add(folded if more else "")
    zeros, others = len(wanted) - len(moving), len(found) - len(wanted)
    words = [f"{zeros} {channel_word(zeros)} zero throughout"] if zeros else []
    words += [f"{others} {channel_word(others)} of other quantities"] if others else []
    if words:
        section.add(f"<p>Not listed, but in the result: {' and '.join(words)}.</p>")


def _row(channel: Channel, values: Mapping[str, float], shown: Scale, moments: list[str]) -> str:
    # the alternating part of a constant is round-off, not a result
    noise = 1e-10 * max(abs(values["min"]), abs(values["max"]))
    known = {**values, "rms": values["rms"] if values["rms"] > noise else 0.0}
    mean, rms, low, high = (number(known[key] * shown.factor) for key in ("mean", "rms", "min", "max"))
    constant = values["max"] - values["min"] <= noise
    at_low, at_high = ("–", "–") if constant else moments
    cells = "".join(f'<td class="num">{cell}</td>' for cell in (mean, rms, low, at_low, high, at_high))
    return f'<tr><th scope="row">{escape(channel.label)}</th><td class="unit">{shown.unit}</td>{cells}</tr>'


def _time(moment: float, clock: Scale, linked: bool) -> str:
    """Time; for the run in the scene a button that sets the time of the scene."""
    text = number(moment * clock.factor, 5)
    if not linked:
        return text
    words = f"show the scene at {text} {clock.unit}"
    return f'<button type="button" class="when" data-time="{moment!r}" title="{words}">{text}</button>'
