# SPDX-License-Identifier: Apache-2.0
"""Accuracy of integrators against their processor time, one line per method and form."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from pitchpoint.viz import theme

if TYPE_CHECKING:
    import plotly.graph_objects as go

SYMBOLS = {"": "circle", "I3": "square", "SI2": "diamond", "SI1": "triangle-up"}


def plot_work_precision(rows: Sequence[Mapping[str, Any]], title: str = "") -> go.Figure:
    """Error over processor time, both logarithmic: lower and further left is better.

    Parameters
    ----------
    rows
        Runs: `method`, `form`, `setting`, `value`, `cpu_s` [s], `error` (None or NaN: not drawn), `steps`.
    title
        Heading.
    """
    import plotly.graph_objects as go

    layout = theme.layout("processor time [s]", "error, share of the alternating part", height=480)
    figure = go.Figure(layout=layout)
    groups: dict[tuple[str, str], list[Mapping[str, Any]]] = {}
    for row in rows:
        if row["error"] is not None and row["error"] > 0.0:
            groups.setdefault((row["method"], row["form"]), []).append(row)
    colours = {name: k for k, name in enumerate(dict.fromkeys(method for method, _ in groups))}
    for (method, form), points in groups.items():
        figure.add_scatter(
            x=[p["cpu_s"] for p in points],
            y=[p["error"] for p in points],
            mode="lines+markers",
            name=f"{method} {form}".strip(),
            line={"color": theme.SERIES[colours[method] % len(theme.SERIES)], "width": 1.6},
            marker={"symbol": SYMBOLS.get(form, "circle"), "size": 8},
            text=[f"{p['setting']} {p['value']:.3g}, {p['steps']} steps" for p in points],
        )
    figure.update_xaxes(type="log")
    figure.update_yaxes(type="log", exponentformat="power")
    figure.update_layout(showlegend=True, title=title or None)
    return figure
