# SPDX-License-Identifier: Apache-2.0
"""Section of a report with extremes: mean, rms, minimum and maximum of the channels, and their times."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from typing import Any

import numpy as np

from pitchpoint.analysis.statistics import signal_statistics
from pitchpoint.viz.quantities import (
    Array,
    Channel,
    Scale,
    channel_scale,
    channels,
    number,
    scale,
    window_words,
)
from pitchpoint.viz.report.bearing_forces import QUANTITY as BEARINGS
from pitchpoint.viz.report.bearing_forces import with_resultants
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.report.time import ROUND_OFF, groups_of
from pitchpoint.viz.run_record import (
    FORCE_PARTS,
    TIME_QUANTITIES,
    channel_word,
    listed,
    settled_part,
    statistics_window,
)
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
        section.add_name(name, runs)
        settled = settled_part(time, run.settle_time)
        found = with_resultants(found)
        main = [n for _, names in groups_of(run, found) for n in names]
        _add_table(section, time[settled], found, main, settled, linked=name == seen)
        window = window_words(*statistics_window(time, found, run.settle_time)).capitalize()
        words = f"{window}; times are those of the nearest stored sample."
        hint = ' <span class="screen">Click a time to set the scene.</span>' if name == seen else ""
        section.add(f"<p>{escape(words)}{hint}</p>")
    return section


def _add_table(
    section: Section,
    time: Array,
    found: Mapping[str, Channel],
    main: Sequence[str],
    settled: np.ndarray,
    linked: bool,
) -> None:
    """Table of the main channels, a folded one of others, and a sentence about the rest."""
    parts = [c.name for q in FORCE_PARTS for c in found.values() if c.quantity == q]
    others = [c.name for q in TIME_QUANTITIES for c in found.values() if listed(c, q)]
    # bearing forces have a table of their own
    main = [n for n in main if not n.startswith(BEARINGS)]
    order = [n for n in dict.fromkeys((*main, *parts, *others)) if n in found]
    wanted = [
        found[n]
        for n in order
        if found[n].quantity != "contact_state" and np.all(np.isfinite(found[n].values))
    ]
    sizes: dict[str, float] = {}
    for c in wanted:
        sizes[c.unit] = max(sizes.get(c.unit, 0.0), float(np.abs(c.values).max()))
    moving = [c for c in wanted if float(np.abs(c.values).max()) > ROUND_OFF * sizes[c.unit]]
    clock = scale("s", time)
    table = [(c, c.statistics or vars(signal_statistics(c.values[settled], time))) for c in moving]
    extent: dict[tuple[str, str], list[float]] = {}
    for channel, values in table:
        # the components of one quantity, and its values at all elements, have one unit
        extent.setdefault((channel.quantity, channel.unit), []).extend((values["min"], values["max"]))
    rows = []
    for channel, values in table:
        sizes_of = np.array(extent[channel.quantity, channel.unit])
        shown = channel_scale(channel.name, channel.unit, sizes_of)
        moments = [float(time[k(channel.values[settled])]) for k in (np.argmin, np.argmax)]
        rows.append(_row(channel, values, shown, [_time(t, clock, linked) for t in moments]))
    if rows:
        at = f"at [{clock.unit}]"
        head = ("channel", "unit", "mean", "rms (alternating)", "minimum", at, "maximum", at)
        mine = len([c for c in moving if c.name in {*main, *parts}])
        first = min(max(mine, 1), MAX_ROWS)
        section.add(plain_table(head, rows[:first]))
        more = rows[first:]
        # on paper, long lists of displacements hide the results
        css = ' class="screen"' if len(more) > MAX_ROWS else ""
        title = f"{len(more)} more {channel_word(len(more))}"
        folded = f"<details{css}><summary>{title}</summary>{plain_table(head, more)}</details>"
        section.add(folded if more else "")
    zeros, rest = len(wanted) - len(moving), len(found) - len(wanted)
    words = [f"{zeros} {channel_word(zeros)} zero throughout"] if zeros else []
    words += [f"{rest} {channel_word(rest)} of other quantities"] if rest else []
    if words:
        section.add(f"<p>Not listed, but in the result: {' and '.join(words)}.</p>")


def _row(channel: Channel, values: Mapping[str, float], shown: Scale, moments: list[str]) -> str:
    # the alternating part of a constant is round-off, not a result
    noise = 1e-10 * max(abs(values["min"]), abs(values["max"]))
    known = {**values, "rms": values["rms"] if values["rms"] > noise else 0.0}
    mean, rms, low, high = (number(known[key] * shown.factor, 4) for key in ("mean", "rms", "min", "max"))
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
