# SPDX-License-Identifier: Apache-2.0
"""Plots of root stress: one tooth of each gear along the path of contact, and over the face width."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.flank_contact.teeth import MeshTeeth
from pitchpoint.viz import theme
from pitchpoint.viz.contact_plots import mark_path
from pitchpoint.viz.quantities import Array, scale

if TYPE_CHECKING:
    import plotly.graph_objects as go

DASHES = ("solid", "dash")
"""Lines of the methods, in their order; the colour is that of the gear."""


def plot_root_stress(curves: Mapping[str, tuple[ArrayLike, ArrayLike]], teeth: MeshTeeth) -> go.Figure:
    """Plot of the root stress of one tooth of each gear along the path of contact, with A to E.

    Parameters
    ----------
    curves
        Positions of the tooth pair in the middle of the face [base pitches from A], shape (n,), and maxima
        over the face width of gear 1 and 2 [Pa], shape (2, n), by method.
    teeth
        Geometry of the mesh.
    """
    data = {name: (np.asarray(way), np.asarray(values)) for name, (way, values) in curves.items()}
    figure = _figure("position of the tooth pair from A [base pitches]", {n: v for n, (_, v) in data.items()})
    figure.update_layout(margin={"t": 52}, legend={"y": 1.08})
    for k, (name, (way, values)) in enumerate(data.items()):
        _add(figure, k, name, way, values)
    ways = [way[np.nan_to_num(values).any(axis=0)] for way, values in data.values()]
    drawn = np.concatenate([*ways, [0.0, teeth.eps_alpha]])
    edge = 0.03 * float(np.ptp(drawn))
    figure.update_xaxes(range=[float(drawn.min()) - edge, float(drawn.max()) + edge])
    mark_path(figure, teeth)
    return figure


def plot_root_stress_over_width(z: ArrayLike, curves: Mapping[str, ArrayLike]) -> go.Figure:
    """Plot of the largest root stress of both gears over the face width.

    Parameters
    ----------
    z
        Middles of the contact planes [m], shape (n_plane,).
    curves
        Maxima over the mesh cycle of gear 1 and 2 [Pa], shape (2, n_plane), by method.
    """
    across = np.asarray(z, dtype=np.float64)
    unit = scale("m", across)
    data = {name: np.asarray(values) for name, values in curves.items()}
    figure = _figure(unit.title("face width z"), data)
    for k, (name, values) in enumerate(data.items()):
        _add(figure, k, name, across * unit.factor, values)
    figure.update_yaxes(rangemode="tozero")
    return figure


def _figure(horizontal: str, curves: Mapping[str, Array]) -> go.Figure:
    """Empty figure for root stresses."""
    shown = scale("Pa", np.concatenate([np.ravel(values) for values in curves.values()]))
    figure = theme.figure(horizontal, shown.title("root stress"), height=360)
    figure.update_yaxes(zeroline=True)
    return figure


def _add(figure: go.Figure, k: int, method: str, x: Array, values: Array) -> None:
    """Add the curves of both gears by the method number k."""
    for gear in (0, 1):
        if not np.isfinite(values[gear]).any():
            continue
        figure.add_scatter(
            x=x,
            y=values[gear] * scale("Pa", values).factor,
            mode="lines",
            name=f"gear {gear + 1}, {method}",
            connectgaps=False,
            line={"color": theme.SERIES[gear], "dash": DASHES[k], "width": 2, "simplify": False},
        )
