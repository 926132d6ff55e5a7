# SPDX-License-Identifier: Apache-2.0
"""Map of the variation of the mesh stiffness over the contact ratios."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.viz import theme

if TYPE_CHECKING:
    import plotly.graph_objects as go


def plot_overlap_map(data: Any, marks: Mapping[str, tuple[float, float]] | None = None) -> go.Figure:
    """Map of the variation of the mesh stiffness: dark where it is small.

    Parameters
    ----------
    data
        Anything with `eps_alpha` (n,), `eps_beta` (m,), `peak_to_peak` (m, n), `S_R` and `T_R`.
    marks
        Transverse contact ratio and overlap ratio of gear pairs to mark, by name.
    """
    law = f"stiffness ratio {data.S_R:g}, tip-relief factor {data.T_R:g}"
    across = f"transverse contact ratio ε<sub>α</sub> ({law})"
    figure = theme.figure(across, "overlap ratio ε<sub>β</sub>", height=520)
    figure.add_heatmap(
        x=np.asarray(data.eps_alpha),
        y=np.asarray(data.eps_beta),
        z=np.asarray(data.peak_to_peak, dtype=np.float32),
        colorscale="Viridis",
        colorbar={"title": {"text": "peak to peak [c′·b]", "side": "right"}},
        hovertemplate="ε_α %{x:.3g}, ε_β %{y:.3g}: %{z:.4g}<extra></extra>",
    )
    for k, (name, (x, y)) in enumerate((marks or {}).items()):
        figure.add_scatter(
            x=[x],
            y=[y],
            mode="markers",
            name=name,
            marker={
                "symbol": k % 8,
                "size": 11,
                "color": "white",
                "line": {"color": theme.RED, "width": 2},
            },
        )
    figure.update_layout(showlegend=bool(marks))
    figure.update_xaxes(range=[float(data.eps_alpha[0]), float(data.eps_alpha[-1])], showgrid=False)
    figure.update_yaxes(range=[float(data.eps_beta[0]), float(data.eps_beta[-1])], showgrid=False)
    return figure
