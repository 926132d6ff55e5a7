# SPDX-License-Identifier: Apache-2.0
"""Campbell diagram: natural frequencies and mesh orders over speed, crossings marked."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.campbell import campbell_crossings
from pitchpoint.viz import theme
from pitchpoint.viz.quantities import Array, scale

if TYPE_CHECKING:
    import plotly.graph_objects as go


MAX_NAMES = 6
"""Maximum number of modes with names in the legend; more modes are labelled at their lines."""
HEIGHT, TOP, MARGINS, TEXT_HEIGHT = 460, 76, 124, 13
"""Height of the figure, its margin above, both margins and a line of text [pixels]."""


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
    omega = np.asarray(speed, dtype=np.float64)
    modes = np.atleast_1d(np.asarray(mode_frequencies, dtype=np.float64))
    if modes.ndim == 1:
        modes = np.broadcast_to(modes, (omega.size, modes.size))
    revolutions = scale("rad/s")
    top = 1.15 * float(np.nanmax(modes)) if modes.size else 1.0
    pitch = scale("Hz", [top])
    figure = theme.figure(
        revolutions.title(f"speed of {shaft}" if shaft else "speed"),
        pitch.title("frequency"),
        height=HEIGHT,
        # room for two rows of order names between plot and legend
        margin={"t": TOP},
        legend={"y": 1.1},
    )
    crowded = modes.shape[1] > MAX_NAMES
    names = [mode_names[k] if k < len(mode_names) else f"mode {k + 1}" for k in range(modes.shape[1])]
    for k, name in enumerate(names):
        figure.add_scatter(
            x=omega * revolutions.factor,
            y=modes[:, k] * pitch.factor,
            mode="lines",
            name=name,
            showlegend=not crowded,
            line={"color": theme.SERIES[k % len(theme.SERIES)], "width": 2},
        )
    # names are placed next to and above the plot, outside circles and lines
    room = _beside(figure, names, modes[-1] * pitch.factor, top * pitch.factor) if crowded else 0
    leaving = _draw_orders(figure, omega, orders, top)
    room = _beside(figure, list(leaving), np.array([*leaving.values()]), top * pitch.factor, room)
    figure.update_layout(margin={"r": 16 + room})
    if modes.size and orders:
        _mark_crossings(figure, omega, modes, orders, top)
    figure.update_yaxes(range=[0.0, top * pitch.factor])
    figure.update_xaxes(range=[float(omega[0]) * revolutions.factor, float(omega[-1]) * revolutions.factor])
    figure.update_layout(showlegend=True)
    return figure


def _draw_orders(
    figure: go.Figure, omega: Array, orders: Mapping[str, float], top: float
) -> dict[str, float]:
    """Draw the lines of the orders; return names and ends of those that reach the right edge."""
    revolutions, pitch = scale("rad/s"), scale("Hz", [top])
    leaving: dict[str, float] = {}
    for row, (name, order) in enumerate(_distinct(orders)):
        figure.add_scatter(
            x=omega * revolutions.factor,
            y=order * omega / (2.0 * np.pi) * pitch.factor,
            mode="lines",
            name=name,
            showlegend=False,
            line={"color": theme.GREY, "width": 1, "dash": "dash"},
        )
        end = 2.0 * np.pi * top / order
        if end < float(omega[-1]):
            _above(figure, name, end * revolutions.factor, row)
        else:
            leaving[name] = order * float(omega[-1]) / (2.0 * np.pi) * pitch.factor
    return leaving


def _mark_crossings(
    figure: go.Figure, omega: Array, modes: Array, orders: Mapping[str, float], top: float
) -> None:
    """Circles at the crossings of orders and modes."""
    crossings = campbell_crossings(omega, modes, [order for _, order in _distinct(orders)])
    if not crossings:
        return
    revolutions, pitch = scale("rad/s"), scale("Hz", [top])
    figure.add_scatter(
        x=[c.speed * revolutions.factor for c in crossings],
        y=[c.frequency * pitch.factor for c in crossings],
        mode="markers",
        name="crossings",
        marker={"color": theme.RED, "size": 9, "symbol": "circle-open", "line": {"width": 2}},
    )


def _above(figure: go.Figure, name: str, at: float, row: int) -> None:
    """Label of a line that leaves through the top of the plot; neighbours on two levels."""
    figure.add_annotation(
        x=at,
        y=1,
        yref="paper",
        text=name,
        showarrow=False,
        xanchor="center",
        yanchor="bottom",
        yshift=1 + 13 * (row % 2),
        font={"size": 11},
    )


def _beside(figure: go.Figure, names: Sequence[str], ends: Array, top: float, room: int = 0) -> int:
    """Labels at the right ends of lines, `room` from the plot; those closer than a text line are merged.

    Returns
    -------
    int
        Width used by the labels [pixels].
    """
    closest = TEXT_HEIGHT / (HEIGHT - MARGINS) * top
    groups: list[list[int]] = []
    for k in sorted((k for k in range(len(names)) if np.isfinite(ends[k])), key=lambda k: float(ends[k])):
        if groups and ends[k] - np.mean(ends[groups[-1]]) < closest:
            groups[-1].append(k)
        else:
            groups.append([k])
    texts = [_together([names[k] for k in group]) for group in groups]
    for group, text in zip(groups, texts, strict=True):
        figure.add_annotation(
            x=1,
            xref="paper",
            y=float(np.mean(ends[group])),
            text=text,
            showarrow=False,
            xanchor="left",
            yanchor="middle",
            xshift=4 + room,
            font={"size": 11},
        )
    return room + max((8 + 7 * len(text) for text in texts), default=0)


def _together(names: Sequence[str]) -> str:
    """Merged label of adjacent lines: a range of numbers, or all names.

    Examples
    --------
    >>> _together(["3"]), _together(["3", "4", "5"]), _together(["3", "5"]), _together(["a", "b"])
    ('3', '3–5', '3, 5', 'a, b')
    """
    if len(names) > 1 and all(name.isdigit() for name in names):
        numbers = sorted(map(int, names))
        if numbers[-1] - numbers[0] == len(numbers) - 1:
            return f"{numbers[0]}–{numbers[-1]}"
        return ", ".join(map(str, numbers))
    return ", ".join(names)


def _distinct(orders: Mapping[str, float]) -> list[tuple[str, float]]:
    """Orders in ascending order; equal ones share a line and a short label."""
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
