# SPDX-License-Identifier: Apache-2.0
"""Kurtogram: kurtosis as colour over frequency band and level."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.viz import theme
from pitchpoint.viz.quantities import amount, number, scale, span

if TYPE_CHECKING:
    import plotly.graph_objects as go
    import xarray as xr

_SAME = 1e-6
"""Tolerance of band edges of different levels, relative to the highest frequency."""


def plot_kurtogram(result: xr.Dataset, channel: str) -> list[go.Figure]:
    """Map of the kurtosis over frequency and level, with the best band framed.

    Parameters
    ----------
    result
        Result of `kurtogram` of one channel.
    channel
        Name of the channel.
    """
    low, high, level = (result[name].values for name in ("low", "high", "level"))
    pitch = scale("Hz", high)
    edges = np.unique(np.round(np.concatenate([low, high]) / (_SAME * high.max()))) * _SAME * high.max()
    levels = np.unique(level)
    middle = 0.5 * (edges[1:] + edges[:-1])
    values = np.full((levels.size, middle.size), np.nan)
    for bottom, top, at, kurtosis in zip(low, high, level, result["kurtosis"].values, strict=True):
        values[np.searchsorted(levels, at), (middle > bottom) & (middle < top)] = kurtosis
    best = [float(result[name]) for name in ("best_low", "best_high", "best_kurtosis")]
    figure = theme.figure(pitch.title("frequency"), "bandwidth", height=430)
    figure.add_heatmap(
        x=edges * pitch.factor,
        y=np.arange(levels.size),
        z=values.astype(np.float32),
        # a steady tone has -1 and noise 0: values below 0 indicate no impacts
        zmin=0.0,
        zmax=max(best[2], float(np.nanmax(values)), 1e-9),
        colorscale=theme.MAP_SCALE,
        colorbar={"title": {"text": "kurtosis"}, "thickness": 12, "outlinewidth": 0, "x": 1.01, "xpad": 4},
        hovertemplate="%{x:.5g}: %{z:.3g}<extra></extra>",
    )
    is_best = np.isclose(low, best[0]) & np.isclose(high, best[1])
    row = int(np.searchsorted(levels, level[np.flatnonzero(is_best)[0]]))
    figure.add_shape(
        type="rect",
        x0=best[0] * pitch.factor,
        x1=best[1] * pitch.factor,
        y0=row - 0.5,
        y1=row + 0.5,
        line={"color": theme.RED, "width": 2},
    )
    where = span(best[0], best[1])
    figure.update_layout(
        title=theme.title_above(
            f"kurtosis of the envelope, {channel}; largest {number(best[2], 3)} in {where}"
        )
    )
    widths = [amount(float(np.max((high - low)[level == at])), "Hz", 3) for at in levels]
    figure.update_yaxes(
        tickvals=np.arange(levels.size), ticktext=widths, autorange="reversed", showgrid=False
    )
    figure.update_xaxes(showgrid=False, range=[0.0, float(edges[-1]) * pitch.factor])
    return [figure]
