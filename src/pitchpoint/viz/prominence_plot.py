# SPDX-License-Identifier: Apache-2.0
"""Levels of spectral lines above the running median, with those that are improbable in noise."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.viz import theme
from pitchpoint.viz.downsampling import kept_samples
from pitchpoint.viz.quantities import number, scale
from pitchpoint.viz.spectrum_plots import known_part

if TYPE_CHECKING:
    import plotly.graph_objects as go
    import xarray as xr

FALSE_ALARM = 0.01
"""Probability that noise alone has any marked line."""
_POINTS, _LABELS, _APART = 6000, 6, 0.07
"""Points of the curve, labels, and their distance over the width of the plot."""


def plot_line_prominence(result: xr.Dataset, channel: str) -> list[go.Figure]:
    """Levels over the frequency.

    Parameters
    ----------
    result
        Result of `line_prominence` of one channel.
    channel
        Name of the channel.
    """
    return _plot(result, channel, "frequency")


def plot_order_prominence(result: xr.Dataset, channel: str) -> list[go.Figure]:
    """Levels over the order.

    Parameters
    ----------
    result
        Result of `order_prominence` of one channel.
    channel
        Name of the channel.
    """
    return _plot(result, channel, "order")


def _plot(result: xr.Dataset, channel: str, over: str) -> list[go.Figure]:
    """Curve of the levels and markers of the lines that are improbable in noise."""
    at, level = result[over].values, result["prominence"].values
    pitch = scale("Hz", at) if over == "frequency" else None
    factor = pitch.factor if pitch else 1.0
    figure = theme.figure(
        pitch.title("frequency") if pitch else "order [–]", "above the median [dB]", height=340
    )
    kept = kept_samples(level, _POINTS)
    figure.add_scatter(
        x=(at[kept] * factor).astype(np.float32),
        y=np.maximum(level[kept], 0.0).astype(np.float32),
        mode="lines",
        name="all lines",
        line={"color": theme.SERIES[0], "width": 1.3},
    )
    top = np.r_[True, level[1:] >= level[:-1]] & np.r_[level[:-1] > level[1:], True]
    clear = np.flatnonzero(top & (result["probability"].values * at.size <= FALSE_ALARM))
    clear = clear[np.argsort(-level[clear], kind="stable")][:_POINTS]
    figure.add_scatter(
        x=at[clear] * factor,
        y=level[clear],
        mode="markers",
        name="in noise at most 1 % for all lines together",
        marker={"color": theme.RED, "size": 4},
        hovertemplate="%{x:.6g}: %{y:.3g} dB<extra></extra>",
    )
    taken: list[float] = []
    for k in clear:
        place = float(at[k]) * factor
        if len(taken) == _LABELS or any(abs(place - other) < _APART * at[-1] * factor for other in taken):
            continue
        taken.append(place)
        words = number(known_part(float(at[k]), float(result["resolution"])) * factor, 5)
        figure.add_annotation(x=place, y=level[k], text=words, showarrow=False, yshift=11, font={"size": 11})
    figure.update_layout(
        title=theme.title_above(f"lines above the background, {channel}"), margin={"t": 64}, showlegend=True
    )
    figure.update_xaxes(range=[0.0, float(at[-1]) * factor])
    figure.update_yaxes(range=[0.0, 1.1 * max(float(level.max()), 10.0) + 3.0])
    return [figure]
