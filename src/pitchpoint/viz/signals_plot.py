# SPDX-License-Identifier: Apache-2.0
"""Signals over time, with contact states as a band below."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.viz import theme
from pitchpoint.viz.downsampling import bucket_samples
from pitchpoint.viz.quantities import Array, Channel, Scale, channel_scale, scale

if TYPE_CHECKING:
    import plotly.graph_objects as go

STATE_COLOURS = {0: theme.RED, -1: theme.OCHRE, 2: theme.MAGENTA}
STATE_NAMES = {0: "separated", -1: "back flank", 2: "both flanks"}
MAX_BANDS = 120
NOISE = 1e-5
"""Relative variation below which changes are round-off."""
VISIBLE = 0.25
"""Minimum share of an axis for the ripple of a curve; smaller ripple gets a separate axis."""
FLAT = 0.05
"""Share of a row below which the variation of a curve would be flat."""
ONE_ROW, ROW, LINE, GAP, MARGINS = 320, 110, 17, 12, 78
"""Heights [pixels]: figure with one row, axes of one of several rows, line of names, gap, both margins."""
HEAD_WIDTH, HALF_WIDTH = 90, 40
"""Characters per line above a figure, and above one of two next to each other on paper."""


def plot_signals(
    time: Array,
    channels: Sequence[Channel],
    *,
    contact_state: Array | None = None,
    points: int = 8000,
    title: str = "",
    rows: Sequence[Sequence[int]] | None = None,
    over: str = "time",
    half: bool = False,
) -> go.Figure:
    """Plot of channels of one unit over time that preserves all peaks and ripple.

    Parameters
    ----------
    time
        Times [s], or angles [rad] of one turn, shape (n,).
    channels
        One or more channels of the same unit, shape (n,) each.
    contact_state
        State of a mesh at these times: 1 front, 0 separated, -1 back, 2 both; intervals without front contact
        are shaded if they can be resolved.
    points
        Maximum number of points per curve; min/max decimation. Two buckets per pixel of a wide screen avoid
        gaps in dense curves.
    title
        Name of the vertical axis; default the names of the channels.
    rows
        Indices of the channels of each row; default those of `signal_rows`.
    over
        `time`, `angle`, or the title of an axis without unit conversion.
    half
        One of two plots next to each other.

    Raises
    ------
    ValueError
        If there is no channel, or the units differ.
    """
    if len({c.unit for c in channels}) != 1:
        raise ValueError("channels: one or more channels of one unit required; plot other units separately")
    shown = channel_scale(channels[0].name, channels[0].unit, np.concatenate([c.values for c in channels]))
    clocks = {"time": scale("s", time if time.size else [1.0]), "angle": Scale("°", 180.0 / np.pi)}
    clock = clocks.get(over, Scale("", 1.0))
    rows = signal_rows(channels) if rows is None else rows
    y_title = shown.title(title or _common_name(channels))
    figure = theme.figure(clock.title(over), y_title, height=ONE_ROW)
    for k, row in enumerate(rows, start=1):
        for index in row:
            add_curve(figure, channels[index], index, k, time, (clock, shown), points)
    if len(channels) > 1:
        row_title = f"[{shown.unit}]" if shown.unit else y_title
        arrange_rows(figure, channels, rows, row_title, HALF_WIDTH if half else HEAD_WIDTH)
    for k, row in enumerate(rows, start=1):
        values = np.concatenate([channels[index].values for index in row]) * shown.factor
        _keep_noise_small(figure.layout[f"yaxis{k}" if k > 1 else "yaxis"], values)
    if contact_state is not None:
        _shade(figure, time * clock.factor, contact_state, f"y{len(rows) + 1}")
    # curves are named above their row; the legend is used for the contact states
    figure.update_layout(showlegend=len(channels) == 1 and len(figure.data) > 1)
    if over == "time":
        # a page with a scene marks its time on this axis
        figure.update_layout(meta={"clock": clock.factor})
    return figure


def signal_rows(channels: Sequence[Channel]) -> list[list[int]]:
    """Indices of the channels that share an axis: those with overlapping ranges.

    All share one axis if it shows all ripple, or if there is none.

    Examples
    --------
    >>> ripple = np.sin(np.arange(20.0))
    >>> parts = [Channel("a", 300 + ripple), Channel("b", -300 + ripple), Channel("c", 301 + ripple)]
    >>> signal_rows(parts), signal_rows(parts[:1]), signal_rows([parts[0], parts[2]])
    ([[0, 2], [1]], [[0]], [[0, 1]])
    """
    spans = [(float(np.nanmin(c.values)), float(np.nanmax(c.values))) for c in channels if c.values.size]
    if len(spans) < len(channels):
        return [list(range(len(channels)))]
    ripples = [high - low for low, high in spans if high - low > NOISE * max(abs(low), abs(high))]
    whole = max(high for _, high in spans) - min(low for low, _ in spans)
    if not ripples or min(ripples) >= VISIBLE * whole:
        return [list(range(len(channels)))]
    rows: list[list[int]] = []
    top = -np.inf
    for index in sorted(range(len(channels)), key=lambda k: spans[k]):
        low, high = spans[index]
        if low <= top:
            rows[-1].append(index)
        else:
            rows.append([index])
        top = max(top, high)
    return sorted(sorted(part) for row in rows for part in _by_size(row, spans))


def _by_size(row: Sequence[int], spans: Sequence[tuple[float, float]]) -> list[list[int]]:
    """Curves of a row, those that would be flat in it on rows of their own."""
    widths = {index: spans[index][1] - spans[index][0] for index in row}
    tall = [index for index in row if widths[index] >= FLAT * max(widths.values())]
    rest = [index for index in row if index not in tall]
    return [tall, *(_by_size(rest, spans) if rest else [])]


def add_curve(
    figure: go.Figure,
    channel: Channel,
    index: int,
    row: int,
    time: Array,
    units: tuple[Scale, Scale],
    points: int,
) -> None:
    """Add a channel as the curve `index` of a figure, in a row from 1, with the units of both axes."""
    clock, unit = units
    meta, kept = None, np.arange(time.size)
    if time.size > points:
        places, mean = bucket_samples(channel.values, points)
        kept, meta = places.reshape(-1), {"means": (mean * unit.factor).astype(np.float32)}
    figure.add_scatter(
        # single precision is sufficient for any screen and halves the size of a report
        x=(time[kept] * clock.factor).astype(np.float32),
        y=(channel.values[kept] * unit.factor).astype(np.float32),
        yaxis=f"y{row}" if row > 1 else "y",
        mode="lines",
        name=channel.label,
        meta=meta,
        # the decimation of plotly leaves gaps in dense curves; the samples were selected above
        line={"color": theme.colour_of(channel.name, index), "width": 1.3, "simplify": False},
    )


def arrange_rows(
    figure: go.Figure,
    channels: Sequence[Channel],
    rows: Sequence[Sequence[int]],
    row_title: str,
    letters: int = HEAD_WIDTH,
) -> None:
    """Stacked rows, each below the names of its curves in their colours, with so many letters per line."""
    heads = [_head(channels, row, letters) for row in rows]
    height = ONE_ROW - MARGINS if len(rows) == 1 else ROW
    whole = float(sum(height + LINE * len(head) + GAP for head in heads))
    at = whole
    for k, head in enumerate(heads, start=1):
        at -= LINE * len(head) + GAP
        name = f"yaxis{k}" if k > 1 else "yaxis"
        look = theme.axis(row_title, nticks=5) if len(rows) > 1 else {}
        look |= {"domain": [(at - height) / whole, at / whole], "anchor": "x"}
        figure.update_layout({name: look})
        figure.add_annotation(
            x=0,
            y=at / whole,
            xref="paper",
            yref="paper",
            xanchor="left",
            yanchor="bottom",
            align="left",
            text="<br>".join(head),
            showarrow=False,
            font={"size": 12},
        )
        at -= height
    figure.update_layout(height=int(whole) + MARGINS, margin={"t": 8})
    figure.update_xaxes(anchor=f"y{len(rows)}" if len(rows) > 1 else "y")


def _head(channels: Sequence[Channel], row: Sequence[int], letters: int) -> list[str]:
    """Text lines with the names of the channels of a row."""
    lines, width = [""], 0
    for index in row:
        name = channels[index].label
        if width and width + len(name) > letters:
            lines, width = [*lines, ""], 0
        colour = theme.colour_of(channels[index].name, index)
        lines[-1] += f'{"&nbsp;&nbsp; " if width else ""}<span style="color:{colour}">{escape(name)}</span>'
        width += len(name) + 3
    return lines


def plot_force_parts(time: Array, channels: Sequence[Channel], *, points: int = 8000) -> go.Figure:
    """Plot of circumferential, radial and axial component of a tooth force, each in its colour."""
    return plot_signals(time, channels, points=points, title="tooth force")


def _keep_noise_small(axis: go.layout.YAxis, values: Array) -> None:
    """Channel with round-off removed if it is constant."""
    finite = values[np.isfinite(values)]
    if finite.size and np.ptp(finite) < NOISE * float(np.abs(finite).max()):
        middle = float(finite.mean())
        axis.update(range=[middle - 0.01 * abs(middle), middle + 0.01 * abs(middle)])


def _common_name(channels: Sequence[Channel]) -> str:
    names = {c.words for c in channels}
    return names.pop() if len(names) == 1 else "value"


def _shade(figure: go.Figure, time: Array, state: Array, axis: str) -> None:
    """Shade intervals without contact of the front flanks, unless there are too many to resolve."""
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
            yaxis=axis,
            mode="lines",
            fill="toself",
            line={"width": 0},
            opacity=0.22,
            fillcolor=colour,
            name=STATE_NAMES[code],
            hoverinfo="skip",
        )
    figure.update_layout(
        {
            f"yaxis{axis[1:]}": {
                "overlaying": "y",
                "range": [0, 1],
                "visible": False,
                "fixedrange": True,
                "layer": "below traces",
            }
        }
    )
