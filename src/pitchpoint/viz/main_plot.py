# SPDX-License-Identifier: Apache-2.0
"""Main channels of a run over time: one row per quantity, with a common time axis."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.viz import theme
from pitchpoint.viz.quantities import Array, Channel, channel_scale, scale
from pitchpoint.viz.signals_plot import add_curve, arrange_rows

if TYPE_CHECKING:
    import plotly.graph_objects as go

MAX_ROWS, MAX_LINES = 6, len(theme.SERIES)
"""Maximum number of rows, and of curves in a row."""


def plot_main_channels(time: Array, channels: Sequence[Channel]) -> go.Figure:
    """Plot of channels of several units over time, the first quantities in rows below each other.

    Parameters
    ----------
    time
        Times [s], shape (n,).
    channels
        Channels in the order of importance, shape (n,) each; further quantities and curves are omitted.
    """
    groups: dict[tuple[str, str], list[Channel]] = {}
    for channel in channels:
        groups.setdefault((channel.quantity, channel.unit), []).append(channel)
    shown = [group[:MAX_LINES] for group in groups.values()][:MAX_ROWS]
    drawn = [channel for group in shown for channel in group]
    clock = scale("s", time if time.size else [1.0])
    figure = theme.figure(clock.title("time"), "")
    rows, titles = [], []
    for k, group in enumerate(shown, start=1):
        unit = channel_scale(group[0].name, group[0].unit, np.concatenate([c.values for c in group]))
        rows.append([len(figure.data) + n for n in range(len(group))])
        titles.append(f"[{unit.unit}]" if unit.unit else "")
        for index, channel in zip(rows[-1], group, strict=True):
            add_curve(figure, channel, index, k, time, (clock, unit), 5000)
    arrange_rows(figure, drawn, rows, "")
    for k, title in enumerate(titles, start=1):
        figure.update_layout({f"yaxis{k}" if k > 1 else "yaxis": {"title": {"text": title}}})
    figure.update_layout(showlegend=False, meta={"clock": clock.factor})
    return figure
