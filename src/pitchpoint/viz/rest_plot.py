# SPDX-License-Identifier: Apache-2.0
"""Equilibrium: forces and torques as bars."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.viz import theme
from pitchpoint.viz.quantities import Channel, scale

if TYPE_CHECKING:
    import plotly.graph_objects as go

MAX_BARS = 40
LINE, MARGINS = 22, 96
"""Height of a bar and of both margins [pixels]."""


def plot_rest(channels: Sequence[Channel]) -> go.Figure:
    """Bars of single values, the first at the top.

    Parameters
    ----------
    channels
        Channels of one unit with one value each.
    """
    shown = list(channels)[:MAX_BARS]
    values = np.array([float(c.values) for c in shown])
    unit = scale(shown[0].unit if shown else "", values)
    words = {c.quantity.replace("_", " ") for c in shown}
    title = unit.title(words.pop() if len(words) == 1 else "force" if unit.unit.endswith("N") else "value")
    figure = theme.figure(title, "", height=MARGINS + LINE * max(len(shown), 2))
    figure.add_bar(
        y=[c.label for c in shown],
        x=values * unit.factor,
        orientation="h",
        marker={"color": theme.SERIES[0]},
        hovertemplate="%{y}: %{x:.5g}<extra></extra>",
    )
    figure.update_layout(
        showlegend=False,
        bargap=0.35,
        yaxis={"autorange": "reversed", "ticks": "", "showgrid": False, "dtick": 1},
    )
    return figure
