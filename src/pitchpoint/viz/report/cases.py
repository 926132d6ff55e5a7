# SPDX-License-Identifier: Apache-2.0
"""Section of a report with independent cases: table, and results over the varied numbers."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING, Any

from pitchpoint.core.status import OK
from pitchpoint.viz import theme
from pitchpoint.viz.quantities import Scale, channel_label, number, printed, scale
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.tables import plain_table

if TYPE_CHECKING:
    import plotly.graph_objects as go

MAX_ROWS = 100
MAX_VARIED = 2
"""Number of varied values up to which results are drawn."""
WIDE = 30.0
"""Ratio of two values from which an axis is logarithmic."""
WORDS = {
    "rms": "rms of the {}",
    "max": "maximum {}",
    "contact_loss_share": "time without contact",
    "contact_frequency": "frequency of the contacts",
}
"""Results in words."""
RESULTS = (
    ("deflection", "rms"),
    ("mesh_force", "max"),
    ("contact_state", "contact_loss_share"),
    ("contact_state", "contact_frequency"),
)
"""Quantity and statistic of each column and picture."""
FREE = "contact_frequency"
"""Result that exists only if contact begins repeatedly."""
UNITS = {"contact_loss_share": "1", "contact_frequency": "Hz"}


def case_section(tables: Mapping[str, Any]) -> Section:
    """Section with independent cases: varied values, and results of the meshes."""
    section = Section("cases", "Cases")
    for name, table in tables.items():
        if not table.cases:
            continue
        section.add(f"<h3>{escape(name)}</h3>" if len(tables) > 1 else "")
        paths = list(dict.fromkeys(path for case in table.cases for path in case["values"]))
        section.add(_table(table.cases, paths))
        if len(table.cases) > MAX_ROWS:
            section.add(f"<p>{len(table.cases) - MAX_ROWS} more cases are in the result file.</p>")
        numeric = [p for p in paths if len({c["numbers"].get(p) for c in table.cases}) > 1]
        if 0 < len(numeric) <= MAX_VARIED:
            for quantity, statistic in RESULTS:
                figure = _figure(table, numeric, quantity, statistic)
                if figure is not None:
                    section.add_figure(figure, name=statistic if statistic in UNITS else quantity)
    return section


def short_path(path: str, paths: Sequence[str]) -> str:
    """End of a path in words, as short as it differs from the other paths.

    Examples
    --------
    >>> short_path("parameters.torque", ["parameters.torque"]), short_path("a.x", ["a.x", "b.x"])
    ('torque', 'a x')
    """
    parts = path.split(".")
    ends = (parts[-k:] for k in range(1, len(parts) + 1))
    short = next(e for e in ends if sum(p.split(".")[-len(e) :] == e for p in paths) == 1)
    return " ".join(short).replace("_", " ")


def _table(cases: Sequence[Mapping[str, Any]], paths: Sequence[str]) -> str:
    """Varied values, status and results of every case; results that are zero in all cases are omitted."""
    head = [*(short_path(path, paths) for path in paths), "status"]
    columns: list[tuple[str, str, Scale]] = []
    for quantity, statistic in RESULTS:
        for name in _channels(cases, quantity):
            values = [v for case in cases if (v := _value(case, name, statistic)) is not None]
            if statistic in UNITS and not any(values):
                continue
            shown = _scale(cases, name, statistic, values)
            columns.append((name, statistic, shown))
            head.append(shown.title(_words(name, statistic)))
    body = []
    for case in cases[:MAX_ROWS]:
        # no line break between number and unit
        given = [escape(printed(case["values"].get(p, "–")).replace(" ", "\u00a0")) for p in paths]
        cells = [f'<th scope="row">{text}</th>' for text in given[:1]]
        cells += [f"<td>{text}</td>" for text in given[1:]]
        cells.append(f"<td>{escape(case['sentence'])}</td>")
        for name, statistic, shown in columns:
            value = _value(case, name, statistic)
            cells.append(f'<td class="num">{"–" if value is None else number(value * shown.factor)}</td>')
        body.append(f"<tr>{''.join(cells)}</tr>")
    return plain_table(head, body, words=len(paths) + 1)


def _figure(table: Any, paths: Sequence[str], quantity: str, statistic: str) -> go.Figure | None:
    """Plot of one result over the varied number with most values; a line per mesh and other value."""
    sizes = {path: len({c["numbers"].get(path) for c in table.cases}) for path in paths}
    path = max(paths, key=lambda p: sizes[p])
    names = _channels(table.cases, quantity)
    lines: dict[str, list[tuple[float, float]]] = {}
    for name in names:
        for case in table.cases:
            x, y = case["numbers"].get(path, math.nan), _value(case, name, statistic)
            # an oscillation that does not occur has no frequency
            if case["status"] != OK or y is None or not math.isfinite(x) or (y == 0.0 and statistic == FREE):
                continue
            others = [f"{short_path(p, paths)} {case['values'].get(p, '–')}" for p in paths if p != path]
            mesh = [name.partition("[")[2].rstrip("]")] if len(names) > 1 or not others else []
            lines.setdefault(", ".join([*mesh, *others]), []).append((x, y))
    lines = {label: sorted(points) for label, points in lines.items() if len(points) > 1}
    if not any(y for points in lines.values() for _, y in points):
        return None
    values = [x for points in lines.values() for x, _ in points]
    across = scale(table.units.get(path, ""), values)
    up = _scale(table.cases, names[0], statistic, [y for points in lines.values() for _, y in points])
    title = up.title(_words(quantity, statistic))
    figure = theme.figure(across.title(short_path(path, paths)), title, height=340)
    for k, (label, points) in enumerate(lines.items()):
        figure.add_scatter(
            x=[x * across.factor for x, _ in points],
            y=[y * up.factor for _, y in points],
            mode="lines+markers",
            name=printed(label),
            line={"color": theme.SERIES[k % len(theme.SERIES)], "width": 2},
        )
    if min(values) > 0.0 and max(values) > WIDE * min(values):
        figure.update_xaxes(type="log", dtick="D2", tickformat="~g")
    figure.update_layout(showlegend=any(lines) and len(lines) > 1)
    return figure


def _value(case: Mapping[str, Any], name: str, statistic: str) -> float | None:
    """Result of a case in SI; None if it is not known."""
    value = case["channels"].get(name, {}).get(statistic, math.nan)
    return float(value) if math.isfinite(value) else None


def _scale(cases: Sequence[Mapping[str, Any]], name: str, statistic: str, values: Sequence[float]) -> Scale:
    """Display unit of a result."""
    if UNITS.get(statistic) == "1":
        return Scale("%", 100.0)
    unit = UNITS.get(statistic) or next(c["channels"][name]["unit"] for c in cases if name in c["channels"])
    return scale(unit, values)


def _words(name: str, statistic: str) -> str:
    """Result in words, with its mesh if the name has one."""
    quantity, _, mesh = name.partition("[")
    words = WORDS[statistic].format(channel_label(quantity))
    return f"{words}, {mesh.rstrip(']')}" if mesh else words


def _channels(cases: Sequence[Mapping[str, Any]], quantity: str) -> list[str]:
    """Channels of a quantity in any case."""
    found = dict.fromkeys(name for case in cases for name in case["channels"])
    return [name for name in found if name.partition("[")[0] == quantity]
