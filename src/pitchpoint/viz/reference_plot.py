# SPDX-License-Identifier: Apache-2.0
"""Plots of the comparison with healthy records: distances with their limit, deviations of bands."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.viz import theme
from pitchpoint.viz.quantities import Array

if TYPE_CHECKING:
    import plotly.graph_objects as go

NAMED = 40
"""Largest number of records with names on the axis."""
ACROSS = 120
"""Largest number of letters next to each other below the axis."""


def plot_distances(
    names: Sequence[str],
    distances: Array,
    healthy: Sequence[bool],
    limit: float,
    *,
    trend: bool = False,
    left: int | None = None,
) -> go.Figure:
    """Plot of the distances of records from healthy ones, with the limit.

    Parameters
    ----------
    names
        Names of the records, in order.
    distances
        Their distances [-], shape (n,).
    healthy
        Whether each record is one of the healthy ones.
    limit
        Limit of the distance [-].
    trend
        Whether the records are in the order of time.
    left
        Number of the record at which a trend left the healthy range; None if it did not.
    """
    figure = theme.figure("record", "distance", height=360)
    number = np.arange(len(names))
    own = np.asarray(healthy, dtype=bool)
    if trend:
        figure.add_scatter(
            x=number,
            y=distances,
            mode="lines",
            line={"color": theme.GREY, "width": 1},
            showlegend=False,
            hoverinfo="skip",
        )
    looks = (
        ("healthy, compared with the others", own, theme.GREEN, "circle"),
        ("below the limit", ~own & (distances <= limit), theme.TEAL, "diamond"),
        ("above the limit", ~own & (distances > limit), theme.RED, "triangle-up"),
    )
    for label, which, colour, symbol in looks:
        if which.any():
            figure.add_scatter(
                x=number[which],
                y=distances[which],
                mode="markers",
                name=label,
                marker={"color": colour, "symbol": symbol, "size": 10},
                text=[names[k] for k in number[which]],
                hovertemplate="%{text}: %{y:.3g}<extra></extra>",
            )
    figure.add_hline(
        y=limit,
        line={"color": theme.GREY, "width": 1.2, "dash": "dash"},
        annotation={"text": "limit", "font": {"size": 11}, "xanchor": "right", "x": 1.0},
    )
    if left is not None:
        figure.add_vline(x=left - 0.5, line={"color": theme.RED, "width": 1, "dash": "dot"})
        figure.add_annotation(
            x=left - 0.5,
            y=1.0,
            yref="paper",
            text="left the healthy range",
            showarrow=False,
            xanchor="right" if left > len(names) / 2 else "left",
            xshift=-4 if left > len(names) / 2 else 4,
            yanchor="top",
            font={"size": 11},
        )
    if len(names) <= NAMED:
        short = [name.partition(".")[0] or name for name in names]
        slanted = sum(len(name) + 2 for name in short) > ACROSS
        figure.update_xaxes(tickvals=number.tolist(), ticktext=short, tickangle=-45 if slanted else 0)
    figure.update_xaxes(range=[-0.6, len(names) - 0.4], title={"text": ""})
    figure.update_yaxes(range=[0.0, 1.12 * max(float(np.max(distances)), limit)])
    return figure


def plot_band_changes(
    middles: Array, changes: Mapping[str, tuple[Array, Array | None]], *, over: str
) -> go.Figure:
    """Plot of the deviations of band levels from healthy records.

    Parameters
    ----------
    middles
        Middle frequencies [Hz] or orders of the bands, rising, shape (n,).
    changes
        By channel: deviations [dB], and their spread for healthy records [dB] or None, shape (n,) each.
    over
        `frequency` or `order`.
    """
    title = "frequency [Hz]" if over == "frequency" else "order"
    figure = theme.figure(title, "deviation from healthy records [dB]", height=400)
    # the channels next to each other within each band
    many = len(changes)
    apart = float(np.diff(np.log10(middles)).min()) if middles.size > 1 else 0.1
    for k, (channel, (deviation, spread)) in enumerate(changes.items()):
        shift = 10.0 ** (apart * 0.7 * ((k + 0.5) / many - 0.5))
        error = (
            None if spread is None else {"type": "data", "array": 2.0 * spread, "thickness": 1, "width": 2}
        )
        figure.add_scatter(
            x=middles * shift,
            y=deviation,
            mode="markers",
            name=channel,
            error_y=error,
            marker={"color": theme.SERIES[k % len(theme.SERIES)], "size": 7},
            hovertemplate="%{x:.4g}: %{y:+.1f} dB<extra>" + channel + "</extra>",
        )
    figure.add_hline(y=0.0, line={"color": theme.GREY, "width": 1})
    low, high = float(middles[0]) / 10.0**apart, float(middles[-1]) * 10.0**apart
    ticks = [d * 10.0**k for k in range(-3, 7) for d in (1.0, 2.0, 5.0)]
    ticks = [tick for tick in ticks if low <= tick <= high]
    figure.update_xaxes(
        type="log",
        range=np.log10([low, high]).tolist(),
        tickvals=ticks,
        ticktext=[f"{tick:g}" for tick in ticks],
    )
    return figure
