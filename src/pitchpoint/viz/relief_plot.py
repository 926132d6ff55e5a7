# SPDX-License-Identifier: Apache-2.0
"""Picture of a relief design: Harris map before and after, with the band of the tolerances."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.viz import theme
from pitchpoint.viz.quantities import Scale, scale

if TYPE_CHECKING:
    import plotly.graph_objects as go
    import xarray as xr

BEFORE, AFTER = "start", "rounded"
_BAND = 0.22
"""Opacity of the band of the tolerances."""


def plot_relief(data: xr.Dataset) -> go.Figure:
    """Transmission error over mesh phase and torque, before and after; peak-to-peak error over torque.

    Parameters
    ----------
    data
        Result of `design_relief`.

    Returns
    -------
    plotly.graph_objects.Figure
        Left and middle: transmission error over the mesh phase for each torque (Harris map) of the model and
        of the rounded design. Right: peak-to-peak error over the torque of both, with the band of tolerances
        and misalignments of the rounded design; the torques of the search are marked.
    """
    curves = data["transmission_error"].isel(misalignment=0)
    error = scale("m", curves.values)
    torque = scale("N m", data["map_torque"].values)
    figure = theme.figure("mesh phase [base pitches]", error.title("transmission error"), height=420)
    figure.update_layout(
        margin={"t": 84},
        legend={"y": 1.1},
        xaxis={"domain": [0.0, 0.27]},
        xaxis2=theme.axis("mesh phase [base pitches]", domain=[0.32, 0.59], anchor="y2"),
        yaxis2=theme.axis("", matches="y", anchor="x2", showticklabels=False),
        xaxis3=theme.axis(torque.title("torque"), domain=[0.69, 1.0], anchor="y3", rangemode="tozero"),
        yaxis3=theme.axis(error.title("peak-to-peak error"), anchor="x3", rangemode="tozero"),
    )
    for design, axes in ((BEFORE, ""), (AFTER, "2")):
        _add_curves(figure, curves.sel(design=design), axes, (error, torque))
        _title(figure, design, axes)
    for design, colour, dash in ((BEFORE, theme.GREY, "dash"), (AFTER, theme.SERIES[0], "solid")):
        _add_map(figure, data.sel(design=design), (colour, dash), (error, torque))
    return figure


def _add_curves(figure: go.Figure, curves: xr.DataArray, axes: str, scales: tuple[Scale, Scale]) -> None:
    """Add one curve for each torque; the legend names the torques once."""
    error, torque = scales
    phase = curves["mesh_phase_position"].values
    for k, value in enumerate(curves["torque"].values):
        figure.add_scatter(
            x=phase,
            y=curves.values[k] * error.factor,
            xaxis=f"x{axes}",
            yaxis=f"y{axes}",
            mode="lines",
            name=torque.text(float(value), 4),
            legendgroup=f"torque {k}",
            showlegend=axes == "",
            line={"color": theme.SERIES[k % len(theme.SERIES)], "width": 1.8, "simplify": False},
        )


def _title(figure: go.Figure, design: str, axes: str) -> None:
    """Name of a design above its axes."""
    figure.add_annotation(
        text=design, showarrow=False, x=0.5, y=1.0, xref=f"x{axes} domain", yref="paper", yanchor="bottom"
    )


def _add_map(figure: go.Figure, data: xr.Dataset, look: tuple[str, str], scales: tuple[Scale, Scale]) -> None:
    """Add the peak-to-peak error of a design over the torque, with its band."""
    error, torque = scales
    colour, dash = look
    x = data["map_torque"].values * torque.factor
    low, high = (data[f"map_{end}"].values * error.factor for end in ("min", "max"))
    axes = {"xaxis": "x3", "yaxis": "y3"}
    name = str(data["design"].values)
    if name == AFTER and np.any(high > low):
        figure.add_scatter(
            x=np.concatenate([x, x[::-1]]),
            y=np.concatenate([high, low[::-1]]),
            fill="toself",
            fillcolor=colour,
            opacity=_BAND,
            mode="lines",
            line={"width": 0.0},
            name=f"{name}, tolerances",
            hoverinfo="skip",
            **axes,
        )
    figure.add_scatter(
        x=x,
        y=data["map_peak_to_peak"].values * error.factor,
        mode="lines",
        name=name,
        line={"color": colour, "width": 2, "dash": dash, "simplify": False},
        **axes,
    )
    figure.add_scatter(
        x=data["torque"].values * torque.factor,
        y=data["peak_to_peak"].max("misalignment").values * error.factor,
        mode="markers",
        name=f"{name}, torques of the search",
        showlegend=False,
        marker={"color": colour, "size": 7},
        **axes,
    )
