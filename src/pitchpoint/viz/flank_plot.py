# SPDX-License-Identifier: Apache-2.0
"""Side view of a flank with missing material."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.viz import theme
from pitchpoint.viz.quantities import scale

if TYPE_CHECKING:
    import plotly.graph_objects as go

THERE, MISSING = theme.TEAL, theme.RED


def plot_missing(z: ArrayLike, diameter: ArrayLike, level: ArrayLike) -> go.Figure:
    """Plot of a flank over face width and diameter, with missing material in a second colour.

    Parameters
    ----------
    z
        Positions along the face width [m], shape (n_z,), ascending.
    diameter
        Diameters [m], shape (n_d,), ascending.
    level
        Missing material [m] where positive, shape (n_z, n_d) (`tooth_faults.break_level`).
    """
    across, up = np.asarray(z, dtype=np.float64), np.asarray(diameter, dtype=np.float64)
    gone = np.asarray(level, dtype=np.float64).T > 0.0
    wide, high = scale("m", across), scale("m", up)
    figure = theme.figure(wide.title("face width z"), high.title("diameter"), height=300)
    figure.add_heatmap(
        x=(across * wide.factor).astype(np.float32),
        y=(up * high.factor).astype(np.float32),
        z=gone.astype(np.int8),
        zmin=0,
        zmax=1,
        colorscale=[[0.0, THERE], [1.0, MISSING]],
        showscale=False,
        hovertemplate="%{x:.4g}, %{y:.4g}<extra></extra>",
    )
    for name, colour in (("flank", THERE), ("missing", MISSING)):
        figure.add_scatter(
            x=[None], y=[None], mode="markers", name=name, marker={"symbol": "square", "color": colour}
        )
    figure.update_xaxes(showgrid=False)
    figure.update_yaxes(showgrid=False)
    return figure
