# SPDX-License-Identifier: Apache-2.0
"""Levels of the response to transmission errors: order cuts over speed, map over speed and frequency."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.levels import level, reference_of
from pitchpoint.viz import theme
from pitchpoint.viz.label_placement import Label, outside, placed
from pitchpoint.viz.quantities import Array, channel_label, scale

if TYPE_CHECKING:
    import plotly.graph_objects as go

ROW, GAP, TOP, BOTTOM = 330, 80, 60, 50
"""Height of a row, gap between rows, and margins [pixels]."""
MAX_LABELS, MOST = 4, 12
"""Resonances with a label, per order and in one plot."""
WIDTH = 330.0
"""Width of the axis of the order cuts where the picture is smallest [pixels]."""
BASELINE, BELOW, ABOVE = 5.0, 0.04, 0.12
"""Distance of the baseline of a label above its peak [pixels]; room below and above the curves [-]."""
LEADER = 14.0
"""Shift of a label from which a line connects it to its peak [pixels]."""


def plot_mesh_response(
    speed: ArrayLike,
    frequency: ArrayLike,
    amplitude: ArrayLike,
    orders: Sequence[str],
    outputs: Sequence[str],
    units: Sequence[str],
    *,
    modes: ArrayLike = (),
    shaft: str = "",
) -> go.Figure:
    """Order cuts on the left, map on the right; one row per output.

    Parameters
    ----------
    speed
        Speeds [rad/s], shape (n_speed,).
    frequency
        Excitation frequencies [Hz], shape (n_speed, n_order).
    amplitude
        Peak amplitudes, SI, shape (n_speed, n_order, n_output).
    orders
        Names of the orders, such as `2 x stage`.
    outputs, units
        Channels and their SI units.
    modes
        Natural frequencies [Hz], drawn as lines in the map.
    shaft
        Name of the body of the speed.
    """
    omega, hertz = np.asarray(speed, dtype=np.float64), np.asarray(frequency, dtype=np.float64)
    size = np.asarray(amplitude, dtype=np.float64) / np.sqrt(2.0)
    turning, pitch = scale("rad/s", omega), scale("Hz", [float(hertz.max())])
    words = turning.title(f"speed of {shaft}" if shaft else "speed")
    count = len(outputs)
    total = TOP + BOTTOM + count * ROW + (count - 1) * GAP
    figure = theme.figure(words, "", height=total, margin={"l": 76, "r": 20, "t": TOP, "b": BOTTOM})
    inside = total - TOP - BOTTOM
    top = float(hertz.max())
    lines = [f for f in np.asarray(modes, dtype=np.float64) if 0.0 < f <= top]
    for row, (name, unit) in enumerate(zip(outputs, units, strict=True)):
        ends = [1.0 - (row * (ROW + GAP) + part) / inside for part in (ROW, 0)]
        ends[0] = max(ends[0], 0.0)
        left, right = (2 * row + 1, 2 * row + 2)
        reference = reference_of(unit)[1]
        decibels = level(size[:, :, row], unit)
        _add_axes(figure, left, ends, (0.0, 0.46), words, f"{channel_label(name)}<br>[dB re {reference}]")
        _add_axes(figure, right, ends, (0.56, 0.9), words, pitch.title("frequency"))
        for k, order in enumerate(orders):
            figure.add_scatter(
                x=omega * turning.factor,
                y=decibels[:, k],
                mode="lines",
                name=order,
                legendgroup=order,
                showlegend=row == 0,
                line={"color": theme.SERIES[k % len(theme.SERIES)], "width": 1.8},
                xaxis=f"x{left}",
                yaxis=f"y{left}",
            )
        _label_peaks(figure, omega * turning.factor, decibels, hertz, left)
        _add_map(figure, (omega * turning.factor, hertz * pitch.factor, decibels), right, ends)
        for k, order in enumerate(orders):
            figure.add_annotation(
                x=float(omega[-1] * turning.factor),
                y=float(hertz[-1, k] * pitch.factor),
                xref=f"x{right}",
                yref=f"y{right}",
                text=order,
                showarrow=False,
                xanchor="right",
                xshift=-8,
                yshift=9,
                font={"size": 11},
            )
        for mode in lines:
            figure.add_shape(
                type="line",
                x0=float(omega.min() * turning.factor),
                x1=float(omega.max() * turning.factor),
                y0=mode * pitch.factor,
                y1=mode * pitch.factor,
                xref=f"x{right}",
                yref=f"y{right}",
                line={"color": theme.GREY, "width": 1, "dash": "dot"},
            )
    figure.update_layout(showlegend=True, legend={"y": 1.0 + 12.0 / inside})
    return figure


def _add_axes(
    figure: go.Figure, number: int, ends: Sequence[float], sides: tuple[float, float], x: str, y: str
) -> None:
    """Add one pair of axes; the first pair has no number in plotly, but 1 is accepted."""
    suffix = "" if number == 1 else str(number)
    figure.update_layout(
        {
            f"xaxis{suffix}": theme.axis(x, domain=list(sides), anchor=f"y{suffix}"),
            f"yaxis{suffix}": theme.axis(y, domain=list(ends), anchor=f"x{suffix}"),
        }
    )


def _add_map(figure: go.Figure, data: tuple[Array, Array, Array], number: int, ends: Sequence[float]) -> None:
    """Orders over speed and frequency, coloured by their level."""
    speed, frequency, decibels = data
    top = float(decibels[np.isfinite(decibels)].max(initial=0.0))
    figure.add_scatter(
        x=np.repeat(speed, frequency.shape[1]),
        y=frequency.ravel(),
        mode="markers",
        showlegend=False,
        marker={
            "color": decibels.ravel(),
            "colorscale": theme.MAP_SCALE,
            "cmin": top - theme.MAP_RANGE_DB,
            "cmax": top,
            "size": 6,
            "colorbar": {
                "x": 0.92,
                "y": 0.5 * (ends[0] + ends[1]),
                "len": ends[1] - ends[0],
                "thickness": 12,
                "title": {"text": "dB"},
            },
        },
        xaxis=f"x{number}",
        yaxis=f"y{number}",
    )


def _label_peaks(figure: go.Figure, speed: Array, decibels: Array, frequency: Array, number: int) -> None:
    """Mark the highest resonances of all curves of a plot with their frequencies, in their colours.

    Labels cover neither each other nor, where a short shift is enough, a curve.
    """
    known = decibels[np.isfinite(decibels)]
    low, high = float(known.min(initial=np.inf)), float(known.max(initial=-np.inf))
    if not (np.ptp(speed) > 0.0 and high > low):
        return
    low, high = low - BELOW * (high - low), high + ABOVE * (high - low)
    suffix = "" if number == 1 else str(number)
    figure.layout[f"xaxis{suffix}"].range = [float(speed.min()), float(speed.max())]
    figure.layout[f"yaxis{suffix}"].range = [low, high]
    across = WIDTH * (speed - speed.min()) / np.ptp(speed)
    down = ROW * (high - decibels) / (high - low)
    few = max(1, min(MAX_LABELS, MOST // decibels.shape[1]))
    marks = [(order, k) for order in range(decibels.shape[1]) for k in peaks(decibels[:, order])[:few]]
    wanted = [
        _label(float(across[k]), float(down[k, order]) - BASELINE, f"{frequency[k, order]:.0f} Hz")
        for order, k in marks
    ]
    curves = [box for one in down.T for box in _along(across, one)]
    for (order, k), first, label in zip(marks, wanted, placed(wanted, outside(ROW), curves), strict=True):
        colour = theme.SERIES[order % len(theme.SERIES)]
        moved = abs(label.y - first.y) >= LEADER
        figure.add_annotation(
            x=float(speed[k]),
            y=float(decibels[k, order]),
            xref=f"x{suffix}",
            yref=f"y{suffix}",
            text=label.lines[0][0],
            font={"size": 10, "color": colour},
            xanchor={"start": "left", "middle": "center", "end": "right"}[label.anchor],
            showarrow=moved,
            # from the baseline to the middle of the text
            **(
                {"ax": 0, "ay": label.y - 4.0 - float(down[k, order])} | {"arrowhead": 0, "arrowwidth": 0.8}
                if moved
                else {"yshift": float(down[k, order]) - label.y + 4.0}
            ),
            arrowcolor=colour,
        )


def _label(x: float, y: float, words: str) -> Label:
    """Label centred above a peak; at the ends of the axis to one side of it."""
    label = Label(x, y, "middle", ((words, "pp-small"),))
    left, _, right, _ = label.box
    return replace(label, anchor="start" if left < 0.0 else "end" if right > WIDTH else "middle")


def _along(x: Array, y: Array) -> list[tuple[float, float, float, float]]:
    """Rectangles along a curve [pixels]."""
    pieces = zip(x[:-1], x[1:], y[:-1], y[1:], strict=True)
    return [
        (float(a), float(min(c, d)), float(b), float(max(c, d)))
        for a, b, c, d in pieces
        if np.isfinite(c) and np.isfinite(d)
    ]


def peaks(decibels: ArrayLike) -> list[int]:
    """Maxima of a curve of levels, highest first, at least 6 dB above the higher of the minima on both sides.

    Parameters
    ----------
    decibels
        Levels [dB], shape (n,).

    Examples
    --------
    >>> peaks([0.0, 10.0, 1.0, 3.0, 2.0, 20.0, 4.0])
    [5, 1]
    """
    from scipy.signal import find_peaks

    values = np.asarray(decibels, dtype=np.float64)
    found, _ = find_peaks(np.where(np.isfinite(values), values, -1e3), prominence=6.0)
    return [int(k) for k in found[np.argsort(-values[found], kind="stable")]]


def order_names(meshes: Iterable[object], harmonics: Iterable[float]) -> list[str]:
    """Names of the orders, such as `2 × stage`.

    Examples
    --------
    >>> order_names(["stage"], [2.0])
    ['2 × stage']
    """
    return [f"{int(h)} × {m}" for m, h in zip(meshes, harmonics, strict=True)]
