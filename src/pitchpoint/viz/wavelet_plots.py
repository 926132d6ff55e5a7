# SPDX-License-Identifier: Apache-2.0
"""Plots of wavelet analyses: levels, packet energies, scalograms."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.viz import theme
from pitchpoint.viz.quantities import Array, Channel, number, scale, span
from pitchpoint.viz.signals_plot import plot_signals
from pitchpoint.viz.spectrum_plots import amplitude_map

if TYPE_CHECKING:
    import plotly.graph_objects as go
    import xarray as xr

_WIDE = 8.0
"""Ratio of highest to lowest frequency above which a scalogram has a logarithmic axis."""
_POINTS = 4000
_RANGE_DB = 40.0
"""Dynamic range of maps with broad lines."""


def plot_levels(result: xr.Dataset, channel: str) -> list[go.Figure]:
    """Plot of the components of a signal in all levels over time, with band and energy share.

    Parameters
    ----------
    result
        Result of `wavelet_levels` of one channel.
    channel
        Name of the channel, shown above the plot.
    """
    unit = str(result["signals"].attrs["units"])
    parts = [
        Channel(f"{name}:  {span(*band)},  {number(round(100.0 * share, 1), 4)} % of the energy", row, unit)
        for name, band, share, row in zip(
            *(result[n].values for n in ("level", "band", "energy_share", "signals")), strict=True
        )
    ]
    rows = [[k] for k in range(len(parts))]
    return [plot_signals(result["time"].values, parts, rows=rows, points=_POINTS)]


def plot_packets(result: xr.Dataset, channel: str) -> list[go.Figure]:
    """Plots of the energy shares over frequency, and of the coefficients over time and frequency.

    Parameters
    ----------
    result
        Result of `wavelet_packets` of one channel.
    channel
        Its name.
    """
    band, unit = result["band"].values, str(result["coefficients"].attrs["units"])
    pitch, clock = scale("Hz", band), scale("s", result["time"].values)
    middle, width = band.mean(axis=1) * pitch.factor, np.diff(band, axis=1)[:, 0] * pitch.factor
    bars = theme.figure(pitch.title("frequency"), f"share of the energy, {channel} [%]", height=340, bargap=0)
    bars.add_bar(
        x=middle,
        y=100.0 * result["energy_share"].values,
        width=width,
        marker={"color": theme.SERIES[0], "line": {"color": theme.LIGHT["paper"], "width": 0.5}},
        customdata=[span(*edges) for edges in band],
        hovertemplate="%{customdata}: %{y:.3g} %<extra></extra>",
    )
    moving = result["coefficients"].values.copy()
    # a large mean would dominate the map
    moving[0] -= moving[0].mean()
    bars.update_xaxes(range=[0.0, band[-1, 1] * pitch.factor])
    times = amplitude_map(
        result["time"].values * clock.factor,
        middle,
        np.abs(moving),
        clock.title("time"),
        pitch.title("frequency"),
        unit,
        f"coefficients without the mean, {channel}",
    )
    times.data[0].zmin = -_RANGE_DB
    return [bars, times]


def plot_scalogram(result: xr.Dataset, channel: str) -> list[go.Figure]:
    """Map of amplitudes over time and frequency; dashed lines limit the edge effects.

    Parameters
    ----------
    result
        Result of `scalogram` of one channel.
    channel
        Its name.
    """
    order = np.argsort(result["frequency"].values, kind="stable")
    frequency, time = result["frequency"].values[order], result["time"].values
    pitch, clock = scale("Hz", frequency), scale("s", time)
    figure = amplitude_map(
        time * clock.factor,
        frequency * pitch.factor,
        result["amplitude"].values[order],
        clock.title("time"),
        pitch.title("frequency"),
        str(result["amplitude"].attrs["units"]),
        f"amplitude, {channel}",
    )
    edge = np.minimum(result["edge"].values[order], 0.5 * (time[-1] - time[0]))
    for side in (time[0] + edge, time[-1] - edge):
        figure.add_scatter(
            x=side * clock.factor,
            y=frequency * pitch.factor,
            mode="lines",
            line={"color": "#ffffff", "width": 1.2, "dash": "dash"},
            hoverinfo="skip",
        )
    figure.data[0].zmin = -_RANGE_DB
    figure.update_layout(showlegend=False)
    figure.update_xaxes(range=[time[0] * clock.factor, time[-1] * clock.factor])
    if frequency[-1] > _WIDE * frequency[0]:
        bounds = _bounds(frequency * pitch.factor)
        ticks = [d * 10.0**k for k in range(-6, 7) for d in (1.0, 2.0, 5.0)]
        ticks = [tick for tick in ticks if bounds[0] <= tick <= bounds[1]]
        figure.update_yaxes(
            type="log", range=np.log10(bounds), tickvals=ticks, ticktext=[f"{v:g}" for v in ticks]
        )
    return [figure]


def _bounds(frequency: Array) -> Array:
    """Lowest and highest frequency, extended by half a row."""
    ratio = np.sqrt(frequency[1] / frequency[0]), np.sqrt(frequency[-1] / frequency[-2])
    return np.array([frequency[0] / ratio[0], frequency[-1] * ratio[1]])
