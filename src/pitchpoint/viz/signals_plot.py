# SPDX-License-Identifier: Apache-2.0
"""Signals over time; contact states as a band below them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.viz import theme
from pitchpoint.viz.decimation import kept_samples
from pitchpoint.viz.quantities import Array, Channel, scale

if TYPE_CHECKING:
    import plotly.graph_objects as go

STATE_COLOURS = {0: theme.RED, -1: theme.ORANGE, 2: theme.PURPLE}
STATE_NAMES = {0: "separated", -1: "back flank", 2: "both flanks"}
MAX_BANDS = 120


def plot_signals(
    time: Array,
    channels: Sequence[Channel],
    *,
    contact_state: Array | None = None,
    points: int = 8000,
    title: str = "",
) -> go.Figure:
    """Channels of one unit over time, drawn so that no peak is lost.

    Parameters
    ----------
    time
        Times [s], shape (n,).
    channels
        One or more channels of the same unit, shape (n,) each.
    contact_state
        State of a mesh at these times: 1 front, 0 separated, -1 back, 2 both; stretches without front contact
        are shaded as long as they can be told apart.
    points
        Points per line at most; min/max decimation. Two buckets per pixel of a wide screen leave no slits in
        dense lines.
    title
        Name of the vertical axis; default the names of the channels.

    Raises
    ------
    ValueError
        If there is no channel, or their units differ.
    """
    import plotly.graph_objects as go

    if len({c.unit for c in channels}) != 1:
        raise ValueError("channels: need one or more channels of one unit; plot other units on their own")
    shown = scale(channels[0].unit, np.concatenate([c.values for c in channels]))
    clock = scale("s", time if time.size else [1.0])
    figure = go.Figure(
        layout=theme.layout(clock.title("time"), shown.title(title or _common_name(channels)), height=320)
    )
    for index, channel in enumerate(channels):
        kept = kept_samples(channel.values, points)
        figure.add_scatter(
            # single precision is finer than any screen and halves the size of a report
            x=(time[kept] * clock.factor).astype(np.float32),
            y=(channel.values[kept] * shown.factor).astype(np.float32),
            mode="lines",
            name=channel.label,
            # plotly's own thinning leaves gaps in dense lines; the samples were chosen above
            line={"color": theme.colour_of(channel.name, index), "width": 1.3, "simplify": False},
        )
    _keep_noise_small(figure, np.concatenate([c.values for c in channels]) * shown.factor)
    if contact_state is not None:
        _shade(figure, time * clock.factor, contact_state)
    figure.update_layout(showlegend=len(figure.data) > 1)
    return figure


def plot_force_parts(time: Array, channels: Sequence[Channel], *, points: int = 8000) -> go.Figure:
    """Circumferential, radial and axial part of a tooth force, each in its colour."""
    return plot_signals(time, channels, points=points, title="tooth force")


def _keep_noise_small(figure: go.Figure, values: Array) -> None:
    """A channel that is constant up to round-off is drawn as constant, not as a picture of round-off."""
    finite = values[np.isfinite(values)]
    if finite.size and np.ptp(finite) < 1e-5 * float(np.abs(finite).max()):
        middle = float(finite.mean())
        figure.update_yaxes(range=[middle - 0.01 * abs(middle), middle + 0.01 * abs(middle)])


def _common_name(channels: Sequence[Channel]) -> str:
    names = {c.words for c in channels}
    return names.pop() if len(names) == 1 else "value"


def _shade(figure: go.Figure, time: Array, state: Array) -> None:
    """Bands where the front flanks do not touch, unless they are too many to be told apart."""
    codes = np.rint(state).astype(np.int64)
    edges = np.concatenate([[0], np.flatnonzero(np.diff(codes)) + 1, [codes.size]])
    runs = [
        (float(time[a]), float(time[min(b, codes.size - 1)]), int(codes[a]))
        for a, b in zip(edges[:-1], edges[1:], strict=True)
        if int(codes[a]) in STATE_COLOURS
    ]
    if len(runs) > MAX_BANDS:
        return
    for code, colour in STATE_COLOURS.items():
        own = [r for r in runs if r[2] == code]
        if not own:
            continue
        # one filled trace per state on an axis of its own: a thousand shapes would stall the page
        x = [v for a, b, _ in own for v in (a, a, b, b, None)]
        y = [v for _ in own for v in (0, 1, 1, 0, None)]
        figure.add_scatter(
            x=x,
            y=y,
            yaxis="y2",
            mode="lines",
            fill="toself",
            line={"width": 0},
            opacity=0.22,
            fillcolor=colour,
            name=STATE_NAMES[code],
            hoverinfo="skip",
        )
    figure.update_layout(
        yaxis2={
            "overlaying": "y",
            "range": [0, 1],
            "visible": False,
            "fixedrange": True,
            "layer": "below traces",
        }
    )
