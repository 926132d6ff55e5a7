# SPDX-License-Identifier: Apache-2.0
"""Spectral coherence: envelope spectra with their thresholds, and the map over both frequencies."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.viz import theme
from pitchpoint.viz.downsampling import kept_samples
from pitchpoint.viz.quantities import scale, span
from pitchpoint.viz.spectrum_plots import reduced_map

if TYPE_CHECKING:
    import plotly.graph_objects as go
    import xarray as xr

_POINTS = 6000


def plot_spectral_coherence(result: xr.Dataset, channel: str) -> list[go.Figure]:
    """Envelope spectra over the cyclic frequency, and map of the coherence.

    Parameters
    ----------
    result
        Result of `spectral_coherence` of one channel.
    channel
        Name of the channel.
    """
    cyclic, carrier = result["cyclic_frequency"].values, result["frequency"].values
    low, high = float(result["low"]), float(result["high"])
    figures = [_spectrum(result, "enhanced", f"enhanced envelope spectrum, {channel}")]
    if (low, high) != (0.0, float(carrier[-1])):
        title = f"improved envelope spectrum of {span(low, high)}, {channel}"
        figures.append(_spectrum(result, "improved", title))
    across, up = scale("Hz", cyclic), scale("Hz", carrier)
    x, y, z = reduced_map(cyclic * across.factor, carrier * up.factor, result["coherence"].values.T)
    figure = theme.figure(across.title("cyclic frequency"), up.title("carrier frequency"), height=430)
    figure.add_heatmap(
        x=x.astype(np.float32),
        y=y.astype(np.float32),
        z=np.round(z, 3).astype(np.float32),
        zmin=float(np.median(result["threshold"].values)),
        zmax=float(z.max()),
        colorscale=theme.MAP_SCALE,
        colorbar={"title": {"text": "coherence"}, "thickness": 12, "outlinewidth": 0, "x": 1.01, "xpad": 4},
        hovertemplate="%{x:.5g}, %{y:.5g}: %{z:.3g}<extra></extra>",
    )
    figure.update_layout(title=theme.title_above(f"spectral coherence above that of noise, {channel}"))
    figure.update_xaxes(showgrid=False)
    figure.update_yaxes(showgrid=False)
    return [*figures, figure]


def _spectrum(result: xr.Dataset, name: str, title: str) -> go.Figure:
    """One envelope spectrum with its threshold."""
    cyclic, values = result["cyclic_frequency"].values, result[name].values
    threshold = result[f"{name}_threshold"].values
    across = scale("Hz", cyclic)
    figure = theme.figure(across.title("cyclic frequency"), "mean coherence", height=340)
    kept = kept_samples(values, _POINTS)
    figure.add_scatter(
        x=(cyclic[kept] * across.factor).astype(np.float32),
        y=values[kept].astype(np.float32),
        mode="lines",
        name="mean coherence",
        line={"color": theme.SERIES[0], "width": 1.3},
    )
    few = np.unique(np.linspace(0, cyclic.size - 1, 200).astype(np.int64))
    figure.add_scatter(
        x=cyclic[few] * across.factor,
        y=threshold[few],
        mode="lines",
        name="exceeded by noise with 1 %",
        line={"color": theme.RED, "width": 1.3, "dash": "dash"},
        hoverinfo="skip",
    )
    figure.update_layout(title=theme.title_above(title), margin={"t": 64}, showlegend=True)
    figure.update_xaxes(range=[0.0, float(cyclic[-1]) * across.factor])
    figure.update_yaxes(range=[0.0, 1.1 * float(max(values.max(), threshold.max()))])
    return figure
