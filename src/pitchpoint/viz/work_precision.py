# SPDX-License-Identifier: Apache-2.0
"""Work-precision diagram: error of integrators over processor time, one line per method and form."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from pitchpoint.viz import theme

if TYPE_CHECKING:
    import plotly.graph_objects as go

SYMBOLS = {"": "circle", "I3": "circle", "SI2": "square", "SI1": "triangle-up"}
DASHES = {"": "solid", "I3": "solid", "SI2": "dash", "SI1": "dot"}


def plot_work_precision(rows: Sequence[Mapping[str, Any]], title: str = "") -> go.Figure:
    """Plot of the error over processor time, both logarithmic: lower left is better.

    Parameters
    ----------
    rows
        Runs: `method`, `form`, `setting`, `value`, `cpu_s` [s], `error` (None or NaN: not drawn), `steps`.
    title
        Title.
    """
    figure = theme.figure(
        "processor time [ms]",
        "error relative to the alternating part",
        height=560,
        margin={"t": 64},
        legend={"orientation": "v", "x": 1.02, "y": 1.0, "yanchor": "top"},
        title={"text": title, "x": 0.0, "xref": "paper", "xanchor": "left"},
    )
    groups: dict[tuple[str, str], list[Mapping[str, Any]]] = {}
    for row in rows:
        if row["error"] is not None and row["error"] > 0.0:
            groups.setdefault((row["method"], row["form"]), []).append(row)
    colours = {name: k for k, name in enumerate(dict.fromkeys(method for method, _ in groups))}
    for (method, form), points in groups.items():
        figure.add_scatter(
            x=[1e3 * p["cpu_s"] for p in points],
            y=[p["error"] for p in points],
            mode="lines+markers",
            name=f"{method} {form}".strip(),
            line={
                "color": theme.SERIES[colours[method] % len(theme.SERIES)],
                "width": 1.6,
                "dash": DASHES.get(form, "solid"),
            },
            marker={"symbol": SYMBOLS.get(form, "circle"), "size": 8},
            text=[f"{p['setting']} {p['value']:.3g}, {p['steps']} steps" for p in points],
        )
    figure.update_xaxes(type="log", dtick="D2", tickformat="~g")
    figure.update_yaxes(type="log", dtick=1, exponentformat="power")
    figure.update_layout(showlegend=True)
    return figure
