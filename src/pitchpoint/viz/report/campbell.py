# SPDX-License-Identifier: Apache-2.0
"""Section of a report with Campbell diagrams and ranked critical speeds."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.analysis.campbell_ranking import (
    LARGE,
    NO_CRITICAL_SPEED,
    STEP,
    RankedSpeed,
    UnstableRange,
    ranked_speeds,
    unstable_ranges,
)
from pitchpoint.core.errors import split_notes
from pitchpoint.viz.campbell_plot import plot_campbell
from pitchpoint.viz.quantities import amount, damping_words, number, scale, span
from pitchpoint.viz.report.page import Section, keep_height
from pitchpoint.viz.tables import plain_table

if TYPE_CHECKING:
    import xarray as xr

LISTED = 12
"""Number of critical speeds in the table, in addition to those that the summary names."""
MOVERS = 3
"""Number of stiffnesses and masses listed for each critical speed."""
CLOSE = 0.1
"""Distance from the operating range, over its speed, up to which a critical speed is close."""
MAX_CRITICAL = 3
"""Maximum number of critical speeds that the summary names."""


SHOWN_NOTES = ("no equilibrium at", "modes of")
"""First words of notes on the diagram: speeds that are omitted, coordinates of rotors."""


def campbell_section(diagrams: Mapping[str, xr.Dataset | str]) -> Section:
    """Campbell diagrams, and tables of critical speeds; a sentence for those that there are not."""
    section = Section("campbell", "Campbell diagram")
    for name, data in diagrams.items():
        if isinstance(data, str):
            section.add_name(name, diagrams)
            section.add(f"<p>{escape(data)}</p>")
            continue
        if not data["frequency"].size or data.sizes["speed"] < 2:
            continue
        section.add_name(name, diagrams)
        section.add(f"<p>{escape(_conditions(data))}</p>")
        for text in split_notes(str(data.attrs.get("notes", ""))):
            if text.startswith(SHOWN_NOTES):
                section.add(f"<p>{escape(text[:1].upper() + text[1:])}.</p>")
        ranked = ranked_speeds(data)
        words = f"Critical speeds are {data.attrs.get('ranking', 'ranked')}."
        caption = words if ranked else f"Critical speeds: {NO_CRITICAL_SPEED} in this range."
        drawn = plot_campbell(data)
        keep_height(drawn)
        section.add_figure(drawn, caption, name="campbell")
        if ranked:
            listed = sorted({*range(min(LISTED, len(ranked))), *named_speeds(ranked)})
            section.add(_table(ranked, listed, "crossing_separation" in data))
            more = len(ranked) - len(listed)
            section.add(f"<p>{more} more in the result of pitchpoint campbell.</p>" if more > 0 else "")
            section.add(_movers_table(ranked, listed))
        unstable = unstable_ranges(data)
        if unstable:
            without = "; the model has no damping" if data.attrs.get("dissipation") == "none" else ""
            section.add(f"<p>Unstable modes grow without excitation{without}:</p>{_unstable_table(unstable)}")
    return section


def named_speeds(ranked: Sequence[RankedSpeed]) -> list[int]:
    """Places of the critical speeds that the summary names, in the ranking.

    Those with a large response that are within the operating range, else the nearest one and those close to
    the range.
    """
    known = [k for k, c in enumerate(ranked) if np.isfinite(c.separation) and c.response >= LARGE]
    inside = [k for k in known if ranked[k].separation == 0.0]
    if inside:
        return inside[:MAX_CRITICAL]
    nearest = sorted(known, key=lambda k: abs(ranked[k].separation))[:1]
    close = [k for k in known if abs(ranked[k].separation) <= CLOSE]
    return sorted({*close[: MAX_CRITICAL - 1], *nearest})


def _conditions(data: xr.Dataset) -> str:
    """Scenario, prescribed motions and operating range of a diagram, in words."""
    body, held = data.attrs.get("body", ""), data.attrs.get("held", "")
    names = data.attrs.get("scenario", "")
    words = f"Speed of {body}" if body else ""
    if names:
        words += f"{'; scenarios' if ', ' in names else '; scenario'} {names}"
        words += f", prescribed motion: {held}" if held else ""
    operating = data.attrs.get("operating_speed")
    if operating is not None and len(operating):
        words += f"; operating {range_words(operating)}"
    words = words.removeprefix("; ")
    return f"{words[:1].upper()}{words[1:]}." if words else ""


def range_words(speeds: Sequence[float]) -> str:
    """Operating speed or range, in words.

    Parameters
    ----------
    speeds
        Lowest and highest speed [rad/s].

    Examples
    --------
    >>> range_words([62.83185307, 188.4955592]), range_words([188.4955592, 188.4955592])
    ('range 600 to 1800 rpm', 'speed 1800 rpm')
    """
    low, high = sorted(abs(float(x)) for x in speeds)
    if amount(low, "rad/s") == amount(high, "rad/s"):
        return f"speed {amount(high, 'rad/s')}"
    return f"range {span(low, high, 'rad/s')}"


def _movers_table(ranked: tuple[RankedSpeed, ...], listed: Sequence[int]) -> str:
    """What moves critical speeds; those of one mode with the same changes are one row."""
    ranks: dict[str, list[int]] = {}
    for k in listed:
        words = ", ".join(
            f"{label} {_signed(100.0 * STEP * value, 1)}" for label, value in ranked[k].moved_by[:MOVERS]
        )
        if words:
            ranks.setdefault(words, []).append(k)
    if not ranks:
        return ""
    rows = [
        f'<tr><th scope="row">{", ".join(str(k + 1) for k in which)}</th><td>{escape(words)}</td></tr>'
        for words, which in ranks.items()
    ]
    heads = ("rank", f"change of the critical speed for +{100.0 * STEP:g} % of stiffness or mass")
    return plain_table(heads, rows, words=1, texts=(1,))


def _signed(percent: float, digits: int) -> str:
    """Percentage with its sign."""
    return f"{percent:+.{digits}f} %".replace("-", "−")


def _unstable_table(listed: tuple[UnstableRange, ...]) -> str:
    """Table of unstable modes."""
    rows = []
    for u in listed:
        low, high = (scale("rad/s").text(x) for x in (u.low, u.high))
        damping = damping_words(u.damping_ratio)
        cells = [f'<td class="num">{x}</td>' for x in (f"{low} – {high}", damping)]
        cells.append(f"<td>{escape(u.source or '–')}</td>")
        rows.append(f'<tr><th scope="row">{escape(u.mode)}</th>{"".join(cells)}</tr>')
    return plain_table(("mode", "speed", "lowest damping", "driven by"), rows)


def _table(ranked: tuple[RankedSpeed, ...], listed: Sequence[int], apart: bool) -> str:
    """Table of some critical speeds."""
    rows = []
    for k in listed:
        c = ranked[k]
        damping = damping_words(c.damping_ratio)
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
            number(c.response, 3),
        ]
        if apart:
            known = np.isfinite(c.separation)
            cells.append(
                "in range"
                if c.separation == 0.0
                else _signed(100.0 * c.separation, 0 if abs(c.separation) >= 0.095 else 1)
                if known
                else "–"
            )
        body = "".join(f'<td class="{"num" if n not in TEXTS else ""}">{x}</td>' for n, x in enumerate(cells))
        rows.append(f'<tr><th scope="row" class="short">{k + 1}</th>{body}</tr>')
    heads = ["rank", "speed", "frequency", "damping", "order", "mode", "driven by"]
    heads += ["amplification", "response", *(["from operation"] if apart else [])]
    return plain_table(heads, rows, words=1, texts=[k + 1 for k in TEXTS])


TEXTS = (3, 4, 5)
"""Columns of text after the rank."""
