# SPDX-License-Identifier: Apache-2.0
"""Box of wind: velocities at its centre over time, and the longitudinal velocity over its plane."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.viz import theme
from pitchpoint.viz.quantities import Channel
from pitchpoint.viz.signals_plot import plot_signals

if TYPE_CHECKING:
    import plotly.graph_objects as go

    from pitchpoint.model.wind.box import WindBox

COMPONENTS = ("u, downwind", "v, to the left", "w, upward")
_WIDTH = 600
"""Width of the plane with its colour bar at equal scales [pixels]."""


def plot_wind_over_time(box: WindBox) -> go.Figure:
    """Velocities at the middle of the grid, one row for each component.

    Parameters
    ----------
    box
        The box.
    """
    middle = box.velocity[:, box.velocity.shape[1] // 2, box.velocity.shape[2] // 2].astype(float)
    channels = [Channel(name, middle[:, k], "m/s") for k, name in enumerate(COMPONENTS)]
    return plot_signals(box.time, channels, rows=[[0], [1], [2]], points=4000)


def plot_wind_plane(box: WindBox, time: float = 0.0) -> go.Figure:
    """Longitudinal velocity over the plane at the sample nearest to a time.

    Parameters
    ----------
    box
        The box.
    time
        Time [s].
    """
    sample = int(np.clip(round(time / box.time_step), 0, len(box.velocity) - 1))
    figure = theme.figure("y [m]", "z [m]", height=460)
    figure.add_heatmap(
        x=box.y.astype(np.float32),
        y=box.z.astype(np.float32),
        z=np.round(box.velocity[sample, :, :, 0], 2),
        colorscale=theme.MAP_SCALE,
        colorbar={"title": {"text": "u [m/s]"}, "thickness": 12, "outlinewidth": 0},
        hovertemplate="y %{x:.4g} m, z %{y:.4g} m: %{z:.3g} m/s<extra></extra>",
    )
    title = f"longitudinal velocity at {sample * box.time_step:.5g} s, view upwind"
    figure.update_layout(title=theme.title_above(title), margin={"t": 44}, width=_WIDTH)
    figure.update_xaxes(showgrid=False, constrain="domain")
    figure.update_yaxes(showgrid=False, scaleanchor="x", constrain="domain")
    return figure
