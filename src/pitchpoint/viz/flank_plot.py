# SPDX-License-Identifier: Apache-2.0
"""A flank seen from the side: what is there of it and what is missing."""

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
    """Flank over face width and diameter, in one colour where there is material, in another where not.

    Parameters
    ----------
    z
        Places along the face width [m], shape (n_z,), rising.
    diameter
        Diameters [m], shape (n_d,), rising.
    level
        What is missing [m], shape (n_z, n_d): nothing where it is not positive (`tooth_faults.break_level`).
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
