# SPDX-License-Identifier: Apache-2.0
"""Natural frequencies and damping ratios of a turbine over the wind speed, with orders of its rotor."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.viz import theme

if TYPE_CHECKING:
    import plotly.graph_objects as go
    import xarray as xr

DASHES = ("solid", "dot", "dash", "dashdot")
"""Lines of modes beyond the number of colours."""
HEIGHT, GAP = 860, 0.08
"""Height of the figure [pixels], and part of it between the two plots."""


def plot_wind_campbell(diagram: xr.Dataset) -> go.Figure:
    """Natural frequencies with the orders of the rotor, and damping ratios below them, over the wind speed.

    Parameters
    ----------
    diagram
        Dataset of `solve_wind_campbell`.
    """
    wind = np.asarray(diagram["wind_speed"].values, dtype=np.float64)
    frequency = np.asarray(diagram["frequency"].values, dtype=np.float64)
    ratio = 100.0 * np.asarray(diagram["damping_ratio"].values, dtype=np.float64)
    middle = 0.5 - 0.5 * GAP
    figure = theme.figure("wind speed [m/s]", "natural frequency [Hz]", height=HEIGHT)
    high = 1.05 * float(frequency.max(initial=0.1))
    for k, name in enumerate(map(str, diagram["name"].values)):
        line = {
            "color": theme.colour_of(name, k),
            "width": 2,
            "dash": DASHES[k // len(theme.SERIES) % len(DASHES)],
        }
        moving = np.where(frequency[:, k] > 0.0, 1.0, np.nan)
        for values, axis, unit in ((frequency[:, k], "y", "Hz"), (ratio[:, k], "y2", "%")):
            figure.add_scatter(
                x=wind,
                y=values * moving,
                yaxis=axis,
                mode="lines",
                name=name,
                legendgroup=name,
                showlegend=axis == "y",
                line=line,
                hovertemplate=f"{name}<br>%{{x:.4g}} m/s, %{{y:.4g}} {unit}<extra></extra>",
            )
    for name, line in zip(map(str, diagram["order"].values), diagram["order_frequency"].values, strict=True):
        inside = np.flatnonzero(line <= high)
        if not inside.size:
            continue
        figure.add_scatter(
            x=wind[inside],
            y=line[inside],
            mode="lines",
            name="orders of the rotor",
            legendgroup="orders",
            showlegend=name == "1P",
            line={"color": theme.GREY, "width": 1.2, "dash": "dash"},
            hovertemplate=f"{name}<extra></extra>",
        )
        figure.add_annotation(
            x=wind[inside[-1]],
            y=line[inside[-1]],
            text=name,
            showarrow=False,
            xanchor="left",
            yanchor="bottom",
        )
    figure.update_layout(
        yaxis={"domain": [1.0 - middle, 1.0], "range": [0.0, high]},
        yaxis2=theme.axis("damping ratio [%]", domain=[0.0, middle], anchor="x", rangemode="tozero"),
        xaxis={"anchor": "y2"},
        legend={"orientation": "v", "x": 1.02, "y": 1.0, "xanchor": "left", "yanchor": "top"},
        margin={"r": 240},
    )
    return figure
