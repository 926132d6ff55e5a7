# SPDX-License-Identifier: Apache-2.0
"""Campbell diagram: natural frequencies and mesh orders over speed, crossings marked."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.campbell import campbell_crossings
from pitchpoint.viz import theme
from pitchpoint.viz.quantities import scale

if TYPE_CHECKING:
    import plotly.graph_objects as go


MOST_NAMES = 6
"""Modes up to which the legend names them; more are labelled at their lines."""


def plot_campbell(
    speed: ArrayLike,
    mode_frequencies: ArrayLike,
    orders: Mapping[str, float],
    *,
    mode_names: Sequence[str] = (),
    shaft: str = "",
) -> go.Figure:
    """Natural frequencies against excitation orders.

    Parameters
    ----------
    speed
        Speeds of the reference shaft [rad/s], shape (n_speed,).
    mode_frequencies
        Natural frequencies [Hz], shape (n_speed, n_mode) or (n_mode,).
    orders
        Excitations per revolution of the reference shaft, by name (`stage × 1`).
    mode_names
        Names of the modes.
    shaft
        Name of the reference shaft.
    """
    import plotly.graph_objects as go

    omega = np.asarray(speed, dtype=np.float64)
    modes = np.atleast_1d(np.asarray(mode_frequencies, dtype=np.float64))
    if modes.ndim == 1:
        modes = np.broadcast_to(modes, (omega.size, modes.size))
    revolutions = scale("rad/s")
    top = 1.15 * float(np.nanmax(modes)) if modes.size else 1.0
    pitch = scale("Hz", [top])
    figure = go.Figure(
        layout=theme.layout(
            revolutions.title(f"speed of {shaft}" if shaft else "speed"),
            pitch.title("frequency"),
            height=460,
            # room for two rows of order names between picture and legend
            margin={"t": 76},
            legend={"y": 1.1},
        )
    )
    crowded = modes.shape[1] > MOST_NAMES
    for k in range(modes.shape[1]):
        name = mode_names[k] if k < len(mode_names) else f"mode {k + 1}"
        if crowded:
            figure.add_annotation(
                x=float(omega[0]) * revolutions.factor,
                y=float(modes[0, k]) * pitch.factor,
                text=name,
                showarrow=False,
                xanchor="left",
                yanchor="bottom",
                xshift=4 + 24 * (k % 3),
                font={"size": 11},
            )
        figure.add_scatter(
            x=omega * revolutions.factor,
            y=modes[:, k] * pitch.factor,
            mode="lines",
            name=name,
            showlegend=not crowded,
            line={"color": theme.SERIES[k % len(theme.SERIES)], "width": 2},
        )
    for row, (name, order) in enumerate(_distinct(orders)):
        lines = order * omega / (2.0 * np.pi)
        figure.add_scatter(
            x=omega * revolutions.factor,
            y=lines * pitch.factor,
            mode="lines",
            name=name,
            showlegend=False,
            line={"color": theme.GREY, "width": 1, "dash": "dash"},
        )
        # the label sits where the line leaves the picture: at the top or at the right edge
        end = min(float(omega[-1]), 2.0 * np.pi * top / order)
        at_top = end < float(omega[-1])
        figure.add_annotation(
            x=end * revolutions.factor,
            y=order * end / (2.0 * np.pi) * pitch.factor,
            text=name,
            showarrow=False,
            # a label in the middle of its line would be cut at the edge of the picture
            xanchor="center" if end < 0.85 * float(omega[-1]) else "right",
            yanchor="bottom",
            yshift=1 + (13 * (row % 2) if at_top else 0),
            font={"size": 11},
        )
    crossings = (
        campbell_crossings(omega, modes, [order for _, order in _distinct(orders)])
        if modes.size and orders
        else ()
    )
    if crossings:
        figure.add_scatter(
            x=[c.speed * revolutions.factor for c in crossings],
            y=[c.frequency * pitch.factor for c in crossings],
            mode="markers",
            name="crossings",
            marker={"color": theme.RED, "size": 9, "symbol": "circle-open", "line": {"width": 2}},
        )
    figure.update_yaxes(range=[0.0, top * pitch.factor])
    figure.update_xaxes(range=[float(omega[0]) * revolutions.factor, float(omega[-1]) * revolutions.factor])
    figure.update_layout(showlegend=True)
    return figure


def _distinct(orders: Mapping[str, float]) -> list[tuple[str, float]]:
    """Orders in ascending order; those that are equal share a line and a short label."""
    found: list[tuple[list[str], float]] = []
    for name, order in sorted(orders.items(), key=lambda item: item[1]):
        if found and order - found[-1][1] <= 1e-9 * order:
            found[-1][0].append(name)
        else:
            found.append(([name], order))
    return [
        (", ".join(names) if len(names) < 3 else f"{names[0]} and {len(names) - 1} more", order)
        for names, order in found
    ]
