# SPDX-License-Identifier: Apache-2.0
"""Sections of a report with tables: modes, signals, independent cases."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING, Any

from pitchpoint.core.status import OK
from pitchpoint.viz import theme
from pitchpoint.viz.mode_plot import plot_modes
from pitchpoint.viz.quantities import channel_label, number, printed, scale
from pitchpoint.viz.report.page import Section, keep_height
from pitchpoint.viz.tables import plain_table

if TYPE_CHECKING:
    import plotly.graph_objects as go

MAX_ROWS = 100
MAX_MODES = 20
QUANTITIES = (("deflection", "rms"), ("mesh_force", "max"))
WORDS = {"rms": "rms (alternating)", "max": "maximum"}


def mode_section(modes: Any) -> Section:
    """Section with natural frequencies and damping about the loaded state."""
    section = Section("modes", "Modes")
    if modes is None or not len(modes.names):
        return section
    body = []
    rows = zip(modes.names, modes.frequency, modes.damping_ratio, strict=True)
    for k, (name, frequency, ratio) in enumerate(rows, start=1):
        known = math.isfinite(ratio) and frequency > 0.0
        damping = f"{number(100.0 * ratio, 3)} %" if known else "–"
        if known and abs(ratio) == 1.0:
            damping = "overdamped" if ratio > 0.0 else "unstable"
        body.append(
            f'<tr><th scope="row">{k}</th><td>{escape(name)}</td>'
            f'<td class="num">{number(frequency)} Hz</td><td class="num">{damping}</td></tr>'
        )
    held = f"; motion prescribed by the scenario: {escape(', '.join(modes.held))}" if modes.held else ""
    section.add(f"<p>Linearised about the loaded state with mean mesh stiffness{held}.</p>")
    section.add(plain_table(("mode", "name", "natural frequency at rest", "damping ratio"), body[:MAX_MODES]))
    if len(modes.components):
        drawn = plot_modes(
            modes.names, modes.frequency, modes.damping_ratio, modes.components, modes.strain_share
        )
        keep_height(drawn)
        section.add_figure(
            drawn,
            "Shares of the components in the strain energy of the lowest modes.",
            name="modes",
        )
    total = max(modes.total, len(body))
    if total > MAX_MODES:
        section.add(f"<p>The lowest {MAX_MODES} of {total} modes; use pitchpoint modes for all.</p>")
    return section


def signal_section(lines: Sequence[Sequence[str]]) -> Section:
    """Section with sensors, blocks, controllers and actuators."""
    section = Section("signals", "Signals and control")
    if lines:
        rows = [f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in line)}</tr>" for line in lines]
        head = ("signal", "type", "inputs", "used by")
        section.add(plain_table(head, rows[:MAX_ROWS], numbers=False))
    return section


def parameter_section(lines: Sequence[Sequence[str]]) -> Section:
    """Section with the parameters of the model; without formulas and descriptions, only their values."""
    section = Section("parameters", "Parameters")
    table = [(name, *map(printed, (written, value)), words) for name, written, value, words in lines]
    head = ("parameter", "as written", "value", "description")
    plain = all(written == value for _, written, value, _ in table)
    kept = [k for k in range(4) if not (k == 1 and plain) and any(line[k] for line in table)]
    rows = [f"<tr>{''.join(f'<td>{escape(line[k])}</td>' for k in kept)}</tr>" for line in table]
    section.add(plain_table([head[k] for k in kept], rows, numbers=False) if rows else "")
    return section


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
        if len(numeric) == 1:
            for quantity, statistic in QUANTITIES:
                figure = _figure(table, numeric[0], quantity, statistic)
                if figure is not None:
                    section.add_figure(figure, name=quantity)
    return section


def _table(cases: Sequence[Mapping[str, Any]], paths: Sequence[str]) -> str:
    names = [n for n in _channels(cases) if n.partition("[")[0] in dict(QUANTITIES)]
    wanted = [(n, dict(QUANTITIES)[n.partition("[")[0]]) for n in names]
    head = [*paths, "status"]
    scales = []
    for name, statistic in wanted:
        values = [c["channels"][name][statistic] for c in cases if name in c["channels"]]
        units = [c["channels"][name]["unit"] for c in cases if name in c["channels"]]
        scales.append(scale(units[0], values))
        head.append(f"{channel_label(name)}, {WORDS[statistic]} [{scales[-1].unit}]")
    body = []
    for case in cases[:MAX_ROWS]:
        cells = [f'<th scope="row">{escape(case["values"].get(paths[0], "–"))}</th>'] if paths else []
        cells += [f"<td>{escape(case['values'].get(p, '–'))}</td>" for p in paths[1:]]
        cells.append(f"<td>{escape(case['sentence'])}</td>")
        for (name, statistic), shown in zip(wanted, scales, strict=True):
            value = case["channels"].get(name, {}).get(statistic, math.nan)
            cells.append(
                f'<td class="num">{number(value * shown.factor) if math.isfinite(value) else "–"}</td>'
            )
        body.append(f"<tr>{''.join(cells)}</tr>")
    return plain_table(head, body)


def _figure(table: Any, path: str, quantity: str, statistic: str) -> go.Figure | None:
    """Plot of one statistic over the single varied number, one line per mesh."""
    names = [n for n in _channels(table.cases) if n.partition("[")[0] == quantity]
    lines: dict[str, tuple[list[float], list[float]]] = {}
    unit = ""
    for name in names:
        points = sorted(
            (c["numbers"][path], c["channels"][name][statistic])
            for c in table.cases
            if c["status"] == OK and name in c["channels"] and math.isfinite(c["numbers"].get(path, math.nan))
        )
        if len(points) > 1:
            unit = next(c["channels"][name]["unit"] for c in table.cases if name in c["channels"])
            lines[name] = [p[0] for p in points], [p[1] for p in points]
    if not lines:
        return None
    across = scale(table.units.get(path, ""), [x for xs, _ in lines.values() for x in xs])
    up = scale(unit, [y for _, ys in lines.values() for y in ys])
    words = f"{quantity.replace('_', ' ')}, {WORDS[statistic]}"
    figure = theme.figure(across.title(path), up.title(words), height=340)
    for k, (name, (x, y)) in enumerate(lines.items()):
        figure.add_scatter(
            x=[v * across.factor for v in x],
            y=[v * up.factor for v in y],
            mode="lines+markers",
            name=name.partition("[")[2].rstrip("]"),
            line={"color": theme.SERIES[k % len(theme.SERIES)], "width": 2},
        )
    return figure


def _channels(cases: Sequence[Mapping[str, Any]]) -> list[str]:
    return list(dict.fromkeys(name for case in cases for name in case["channels"]))
