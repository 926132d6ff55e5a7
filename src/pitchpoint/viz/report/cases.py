# SPDX-License-Identifier: Apache-2.0
"""Section of a report with independent cases: tables, and results over the varied numbers."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.status import OK
from pitchpoint.viz import theme
from pitchpoint.viz.quantities import Scale, number, printed, scale
from pitchpoint.viz.report.case_results import CaseQuantity, case_quantities
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.tables import plain_table

if TYPE_CHECKING:
    import plotly.graph_objects as go

MAX_ROWS = 100
MAX_VARIED = 2
"""Number of varied values up to which results are drawn."""
MAX_COLUMNS = 5
"""Columns with results in one table."""
MAX_OWNERS = 8
"""Components with a column of their own: those with the largest values."""
MAX_LINES = 6
"""Curves up to which every component has its own; of more, the largest value is drawn."""
WIDE = 30.0
"""Ratio of two values from which an axis is logarithmic."""


def case_section(tables: Mapping[str, Any]) -> Section:
    """Section with independent cases: varied values, and results of meshes, planets and bearings."""
    section = Section("cases", "Cases")
    for name, table in tables.items():
        if not table.cases:
            continue
        section.add_name(name, tables)
        paths = list(dict.fromkeys(path for case in table.cases for path in case["values"]))
        found = case_quantities(table.cases)
        for html in _tables(table.cases, paths, found):
            section.add(html)
        if len(table.cases) > MAX_ROWS:
            section.add(f"<p>{len(table.cases) - MAX_ROWS} more cases are in the result file.</p>")
        numeric = [p for p in paths if len({c["numbers"].get(p) for c in table.cases}) > 1]
        if 0 < len(numeric) <= MAX_VARIED:
            for quantity in found:
                figure = _figure(table, numeric, quantity)
                if figure is not None:
                    section.add_figure(figure, name=quantity.name)
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


def _tables(
    cases: Sequence[Mapping[str, Any]], paths: Sequence[str], found: Sequence[CaseQuantity]
) -> list[str]:
    """Tables of varied values, status and results; results of several components have their own tables."""
    together: list[tuple[str, Scale, Sequence[float]]] = []
    apart = []
    for quantity in found:
        if len(quantity.owners) > 1:
            apart.append(quantity)
        else:
            named = quantity.name.endswith("bearing_force")  # the only loaded one of several
            title = f"{quantity.title}, {quantity.owners[0]}" if named else quantity.title
            together.append((quantity.scale.title(title), quantity.scale, quantity.values[:, 0].tolist()))
    states = [str(case["sentence"]) for case in cases]
    html = [
        _table(cases, paths, together[k : k + MAX_COLUMNS], [] if k else states)
        for k in range(0, max(len(together), 1), MAX_COLUMNS)
    ]
    for quantity in apart:
        sizes = np.nanmax(np.abs(quantity.values), axis=0)
        most = sorted(np.argsort(-sizes, kind="stable")[:MAX_OWNERS].tolist())
        columns = [(quantity.owners[k], quantity.scale, quantity.values[:, k].tolist()) for k in most]
        more = len(quantity.owners) - len(most)
        note = f"<p>{more} more with smaller values are in the result file.</p>" if more else ""
        title = f"<h4>{escape(quantity.scale.title(_upper(quantity.title)))}</h4>"
        html.append(f"{title}{_table(cases, paths, columns, [])}{note}")
    return html


def _upper(title: str) -> str:
    return title[:1].upper() + title[1:]


def _table(
    cases: Sequence[Mapping[str, Any]],
    paths: Sequence[str],
    columns: Sequence[tuple[str, Scale, Sequence[float]]],
    states: Sequence[str],
) -> str:
    """Varied values, status if given, and columns with title, scale and values."""
    head = [*(short_path(path, paths) for path in paths), *(["status"] if states else [])]
    body = []
    for k, case in enumerate(cases[:MAX_ROWS]):
        # no line break between number and unit
        given = [escape(printed(case["values"].get(p, "–")).replace(" ", "\u00a0")) for p in paths]
        cells = [f'<th scope="row">{text}</th>' for text in given[:1]]
        cells += [f"<td>{text}</td>" for text in (*given[1:], *(escape(s) for s in states[k : k + 1]))]
        cells += [
            f'<td class="num">{number(values[k] * shown.factor) if math.isfinite(values[k]) else "–"}</td>'
            for _, shown, values in columns
        ]
        body.append(f"<tr>{''.join(cells)}</tr>")
    return plain_table([*head, *(title for title, _, _ in columns)], body, words=len(head))


def _figure(table: Any, paths: Sequence[str], quantity: CaseQuantity) -> go.Figure | None:
    """Plot of one result over the varied number with most values; a line per component and other value."""
    sizes = {path: len({c["numbers"].get(path) for c in table.cases}) for path in paths}
    path = max(paths, key=lambda p: sizes[p])
    others = math.prod(sizes[p] for p in paths if p != path)
    single = len(quantity.owners) == 1 or len(quantity.owners) * others > MAX_LINES
    owners = ("",) if single else quantity.owners
    results = quantity.largest[:, None] if single else quantity.values
    lines: dict[str, list[tuple[float, float]]] = {}
    for case, row in zip(table.cases, results.tolist(), strict=True):
        x = case["numbers"].get(path, math.nan)
        other = [f"{short_path(p, paths)} {case['values'].get(p, '–')}" for p in paths if p != path]
        for owner, y in zip(owners, row, strict=True):
            if case["status"] == OK and math.isfinite(x) and math.isfinite(y):
                lines.setdefault(", ".join([*filter(None, [owner]), *other]), []).append((x, y))
    lines = {label: sorted(points) for label, points in lines.items() if len(points) > 1}
    if not any(y for points in lines.values() for _, y in points):
        return None
    values = [x for points in lines.values() for x, _ in points]
    across, up = _scale(table, path, values), quantity.scale
    title = quantity.title + (", largest" if single and len(quantity.owners) > 1 else "")
    figure = theme.figure(across.title(short_path(path, paths)), up.title(title), height=340)
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


def _scale(table: Any, path: str, values: Sequence[float]) -> Scale:
    """Display unit of a varied number; per cent where all values are given in per cent."""
    if all(str(case["values"].get(path, "%")).endswith("%") for case in table.cases):
        return Scale("%", 100.0)
    return scale(table.units.get(path, ""), values)
