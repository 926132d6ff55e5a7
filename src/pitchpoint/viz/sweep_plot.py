# SPDX-License-Identifier: Apache-2.0
"""Response of a speed sweep over mesh frequency: up green, down red, with jumps and contact loss."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.analysis.jumps import branch
from pitchpoint.viz import theme
from pitchpoint.viz.quantities import channel_scale, number, scale

if TYPE_CHECKING:
    import plotly.graph_objects as go

UNITS = {"mesh_force": "N"}  # of the quantities of a sweep; all others are lengths along the line of action


def plot_sweep(
    points: Sequence[Mapping[str, Any]],
    jumps: Sequence[Mapping[str, Any]] = (),
    *,
    quantity: str = "deflection",
    statistic: str = "rms",
) -> go.Figure:
    """Plot of one statistic of one quantity along a sweep.

    Parameters
    ----------
    points
        Points in the order of computation: `direction`, `mesh_frequency` [Hz] and, under `quantity`, its
        statistics in SI.
    jumps
        `direction` and `mesh_frequency` [Hz] of each jump.
    quantity, statistic
        Plotted data: `deflection`, `transmission_error`, `mesh_force`; `rms`, `min`, `max`, `mean`.
    """
    branches = {d: branch(points, d, quantity, statistic) for d in theme.SWEEP}
    levels = np.concatenate([level for _, level in branches.values()])
    pitch = scale("Hz", np.concatenate([f for f, _ in branches.values()]))
    shown = channel_scale(quantity, UNITS.get(quantity, "m"), levels)
    title = f"{statistic} of {quantity.replace('_', ' ')}"
    figure = theme.figure(pitch.title("mesh frequency"), shown.title(title), height=400)
    for direction, (colour, symbol) in theme.SWEEP.items():
        frequency, level = branches[direction]
        if frequency.size:
            figure.add_scatter(
                x=frequency * pitch.factor,
                y=level * shown.factor,
                mode="lines+markers",
                name=f"speed {direction}",
                line={"color": colour, "width": 1.6},
                marker={"symbol": symbol, "size": 6},
            )
    _mark_jumps(figure, branches, jumps, pitch.factor, shown.factor)
    if levels.size:
        figure.update_xaxes(range=_padded(np.concatenate([f for f, _ in branches.values()]), pitch.factor))
    figure.update_yaxes(rangemode="tozero" if statistic == "rms" else "normal")
    figure.update_layout(showlegend=True)
    return figure


def plot_contact_shares(points: Sequence[Mapping[str, Any]]) -> go.Figure:
    """Plot of the shares of time without contact and with contact on the back flank, along a sweep."""
    all_frequencies = [float(p["mesh_frequency"]) for p in points]
    pitch = scale("Hz", all_frequencies)
    figure = theme.figure(pitch.title("mesh frequency"), "share of time [%]", height=300)
    words = {"contact_loss_share": ("contact loss", "solid"), "back_contact_share": ("back contact", "dot")}
    for key, (name, dash) in words.items():
        for direction, (colour, _) in theme.SWEEP.items():
            rows = [
                (float(p["mesh_frequency"]) * pitch.factor, 100.0 * float(p[key]))
                for p in points
                if p["direction"] == direction and p.get(key) is not None
            ]
            # back flanks without contact would only add a flat line and a legend entry
            if rows and (key == "contact_loss_share" or any(share > 0.0 for _, share in rows)):
                x, y = zip(*rows, strict=True)
                figure.add_scatter(
                    x=x,
                    y=y,
                    mode="lines",
                    name=f"{name}, {direction}",
                    line={"color": colour, "width": 1.6, "dash": dash},
                )
    if all_frequencies:
        figure.update_xaxes(range=_padded(all_frequencies, pitch.factor))
    figure.update_yaxes(rangemode="tozero")
    figure.update_layout(showlegend=True)
    return figure


def _padded(frequencies: Sequence[float] | np.ndarray, factor: float) -> list[float]:
    """Set a common horizontal range for all plots of one sweep."""
    low, high = float(np.min(frequencies)) * factor, float(np.max(frequencies)) * factor
    room = 0.03 * (high - low) or 0.05 * abs(high) or 1.0
    return [low - room, high + room]


def _mark_jumps(
    figure: go.Figure,
    branches: Mapping[str, tuple[np.ndarray, np.ndarray]],
    jumps: Sequence[Mapping[str, Any]],
    x_factor: float,
    y_factor: float,
) -> None:
    """Draw an arrow from the old to the new level with the frequency, in the colour of the direction."""
    for jump in jumps:
        direction, middle = str(jump["direction"]), float(jump["mesh_frequency"])
        frequency, level = branches[direction]
        if frequency.size < 2:
            continue
        forward = frequency if frequency[-1] > frequency[0] else -frequency
        after = int(
            np.clip(
                np.searchsorted(forward, middle if frequency[-1] > frequency[0] else -middle),
                1,
                level.size - 1,
            )
        )
        colour = theme.SWEEP[direction][0]
        low, high = level[after - 1] * y_factor, level[after] * y_factor
        figure.add_annotation(
            x=middle * x_factor,
            y=high,
            ax=middle * x_factor,
            ay=low,
            axref="x",
            ayref="y",
            text="",
            showarrow=True,
            arrowhead=2,
            arrowsize=1.2,
            arrowwidth=1.8,
            arrowcolor=colour,
        )
        figure.add_annotation(
            x=middle * x_factor,
            y=max(low, high),
            text=number(middle * x_factor),
            showarrow=False,
            yshift=10,
            xanchor="right" if direction == "down" else "left",
            font={"size": 11, "color": colour},
        )
