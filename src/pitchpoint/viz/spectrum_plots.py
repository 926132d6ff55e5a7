# SPDX-License-Identifier: Apache-2.0
"""Spectra over frequency or order, order maps and time-frequency maps."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.analysis.orders import OrderMap
from pitchpoint.analysis.spectra import Spectrum, largest_peaks
from pitchpoint.analysis.time_frequency import TimeFrequencyMap
from pitchpoint.viz import theme
from pitchpoint.viz.downsampling import kept_samples
from pitchpoint.viz.frequency_marks import (
    GAP,
    LETTER,
    NARROW,
    mark_curves,
    mark_frequencies,
)
from pitchpoint.viz.quantities import Array, number, scale

if TYPE_CHECKING:
    import plotly.graph_objects as go

MAP_COLUMNS, MAP_ROWS = 360, 300
HARMONICS = 3
"""Number of harmonics of a mesh frequency that are marked in a spectrum."""
MAP_HARMONICS = 5
"""The same in a map over orders, whose axis ends with the content."""


@dataclass(frozen=True)
class Shafts:
    """Shafts that orders may refer to.

    Attributes
    ----------
    chosen
        Reference shaft of the orders.
    speeds
        Mean speeds [rad/s] of it and of all shafts with a constant ratio to it, by name; orders of another
        shaft are the given ones times the ratio of the speeds.
    meshes
        Orders of the meshes relative to the chosen shaft, by name; marked in the plot.
    """

    chosen: str
    speeds: Mapping[str, float] = field(default_factory=dict)
    meshes: Mapping[str, float] = field(default_factory=dict)


def plot_spectrum(
    spectra: Mapping[str, Spectrum],
    *,
    unit: str,
    quantity: str = "amplitude",
    over: str = "frequency",
    highest: float | None = None,
    labels: int = 4,
    shafts: Shafts | None = None,
    meshes: Mapping[str, float] | None = None,
) -> go.Figure:
    """Plot of amplitude spectra on a logarithmic axis, with labels at the highest peaks of the first.

    Parameters
    ----------
    spectra
        Spectra by name, shown above the plot; a single one may be unnamed.
    unit
        SI unit of the signal.
    quantity
        Name of the vertical axis.
    over
        `frequency` [Hz] or `order`.
    highest
        End of the horizontal axis; default: position of the last peak above 0.5 % of the maximum.
    labels
        Number of peaks with a label.
    shafts
        Reference shafts of the orders; in a report the reader can select another one.
    meshes
        Mesh frequencies [Hz] by name, marked with their harmonics.
    """
    tallest = max(
        (float(s.amplitude[1:].max()) for s in spectra.values() if s.amplitude.size > 1), default=0.0
    )
    shown = scale(unit, [tallest])
    end = highest or max((last_peak(s) for s in spectra.values()), default=1.0)
    across = scale("Hz", [end]) if over == "frequency" else None
    factor = across.factor if across else 1.0
    figure = theme.figure(
        across.title("frequency") if across else _order_title(shafts),
        shown.title(quantity),
        height=340,
    )
    for index, (name, spectrum) in enumerate(spectra.items()):
        kept = kept_samples(spectrum.amplitude[1:], 6000) + 1
        kept = kept[spectrum.frequency[kept] <= end]
        figure.add_scatter(
            x=(spectrum.frequency[kept] * factor).astype(np.float32),
            y=np.maximum(spectrum.amplitude[kept] * shown.factor, 1e-30).astype(np.float32),
            mode="lines",
            name=name,
            line={"color": theme.SERIES[index % len(theme.SERIES)], "width": 1.3},
        )
    if spectra:
        first = next(iter(spectra.values()))
        _label_peaks(figure, first, end, factor, shown.factor, labels)
    known = (shafts.meshes if shafts else {}) if across is None else meshes or {}
    figure.update_xaxes(range=[0.0, end * factor])
    figure.update_layout(showlegend=any(spectra))
    lines = mark_frequencies(figure, known, harmonics=HARMONICS, factor=factor)
    if tallest > 0.0:
        # the names of the marks have their lines of text above the highest peak
        top, room = float(np.log10(tallest * shown.factor)), 0.6 + 0.45 * lines
        figure.update_yaxes(type="log", range=[top - 4.2, top + room], dtick=1, exponentformat="power")
    if across is None:
        _offer(figure, shafts)
    return figure


def plot_order_map(
    data: OrderMap, *, unit: str, quantity: str = "amplitude", shafts: Shafts | None = None
) -> go.Figure:
    """Map of the amplitude over order and speed of a run-up, in decibels below the maximum."""
    # run-ups are drawn over the speed, other records over time
    over_speed = data.is_run_up
    axis = scale("rad/s", data.speed) if over_speed else scale("s", data.time)
    vertical = (data.speed if over_speed else data.time) * axis.factor
    speed = f"speed of {shafts.chosen}" if shafts else "speed"
    # order 0 is the mean: it would set the scale of the whole map
    figure = amplitude_map(
        data.order[1:],
        vertical,
        data.amplitude[:, 1:],
        _order_title(shafts),
        axis.title(speed if over_speed else "time"),
        unit,
        quantity,
    )
    if shafts is not None:
        mark_frequencies(figure, shafts.meshes, harmonics=MAP_HARMONICS, over_map=True)
    _offer(figure, shafts, over_speed=over_speed)
    return figure


def _order_title(shafts: Shafts | None) -> str:
    return f"order of {shafts.chosen} [–]" if shafts else "order [–]"


def _offer(figure: go.Figure, shafts: Shafts | None, *, over_speed: bool = False) -> None:
    """Store the other shafts in the figure for the script of the page."""
    if shafts is not None and len(shafts.speeds) > 1:
        meta = {"shaft": shafts.chosen, "speeds": dict(shafts.speeds), "overSpeed": over_speed}
        figure.update_layout(meta={"orders": meta})


def plot_time_frequency(
    data: TimeFrequencyMap,
    *,
    unit: str,
    quantity: str = "amplitude",
    meshes: Mapping[str, Array] | None = None,
) -> go.Figure:
    """Map of the amplitude over time and frequency, in decibels below the maximum.

    Parameters
    ----------
    data
        The map.
    unit
        SI unit of the signal.
    quantity
        Name in the title.
    meshes
        Mesh frequencies [Hz] at the times of the map by name, drawn as curves.
    """
    clock, pitch = scale("s", data.time), scale("Hz", data.frequency)
    figure = amplitude_map(
        data.time * clock.factor,
        data.frequency * pitch.factor,
        data.amplitude.T,
        clock.title("time"),
        pitch.title("frequency"),
        unit,
        quantity,
    )
    curves = {name: hertz * pitch.factor for name, hertz in (meshes or {}).items()}
    top = float(data.frequency[-1]) * pitch.factor
    mark_curves(figure, data.time * clock.factor, curves, top, harmonics=HARMONICS)
    return figure


def amplitude_map(
    x: Array, y: Array, amplitude: Array, x_title: str, y_title: str, unit: str, quantity: str
) -> go.Figure:
    """Map in decibels below its maximum.

    Parameters
    ----------
    x, y
        Axes as drawn, shapes (n,) and (m,).
    amplitude
        Shape (m, n), in SI.
    x_title, y_title
        Titles with units.
    unit
        SI unit of the amplitude.
    quantity
        Name in the title.
    """
    x, y, z = reduced_map(x, y, amplitude)
    largest = float(z.max())
    level = 20.0 * np.log10(np.maximum(z, 1e-12 * largest) / largest) if largest > 0.0 else np.zeros_like(z)
    shown = scale(unit, [largest])
    figure = theme.figure(x_title, y_title, height=430)
    figure.add_heatmap(
        x=x.astype(np.float32),
        y=y.astype(np.float32),
        # integer decibels in one byte each: 0.1 MB instead of 1.2 MB per map
        z=np.clip(np.round(level), -100, 0).astype(np.int8),
        zmin=-theme.MAP_RANGE_DB,
        zmax=0.0,
        colorscale=theme.MAP_SCALE,
        colorbar={"title": {"text": "dB"}, "thickness": 12, "outlinewidth": 0, "x": 1.01, "xpad": 4},
        hovertemplate="%{x:.5g}, %{y:.5g}: %{z} dB<extra></extra>",
    )
    figure.update_layout(title=theme.title_above(f"{quantity}, 0 dB = {shown.text(largest)}"))
    figure.update_xaxes(showgrid=False)
    figure.update_yaxes(showgrid=False)
    return figure


def reduced_map(x: Array, y: Array, z: Array) -> tuple[Array, Array, Array]:
    """Map reduced to the resolution of the screen; merged cells have their maximum amplitude."""
    for dimension, limit in ((1, MAP_COLUMNS), (0, MAP_ROWS)):
        n = z.shape[dimension]
        if n <= limit:
            continue
        edges = np.linspace(0, n, limit + 1).round().astype(np.int64)
        z = np.maximum.reduceat(z, edges[:-1], axis=dimension)
        axis = x if dimension == 1 else y
        middle = np.add.reduceat(axis, edges[:-1]) / np.diff(edges)
        x, y = (middle, y) if dimension == 1 else (x, middle)
    return x, y, z


def last_peak(spectrum: Spectrum) -> float:
    """Highest frequency with significant amplitudes, plus a quarter."""
    a = spectrum.amplitude
    if a.size < 2 or not a[1:].max() > 0.0:
        return float(spectrum.frequency[-1])
    last = int(np.flatnonzero(a[1:] >= 5e-3 * float(a[1:].max()))[-1]) + 1
    return float(min(spectrum.frequency[-1], 1.25 * spectrum.frequency[last] + 4.0 * spectrum.resolution))


def _label_peaks(
    figure: go.Figure, spectrum: Spectrum, end: float, factor: float, gain: float, count: int
) -> None:
    """Numbers at the highest peaks, none over another one in a plot of half the width of a page."""
    taken: list[tuple[float, float]] = []
    for frequency, amplitude in largest_peaks(spectrum, 4 * count):
        if frequency > end or len(taken) >= count:
            continue
        shown = known_part(frequency, spectrum.resolution) * factor
        words = number(shown, 4)
        at, width = NARROW * frequency / end, LETTER * len(words)
        # at the ends a centred label would cover the numbers of the axis or leave the plot
        anchor = "left" if at < 0.5 * width else "right" if at > NARROW - 0.5 * width else "center"
        left = at - {"left": 0.0, "center": 0.5, "right": 1.0}[anchor] * width
        if any(left < right + GAP and begin < left + width + GAP for begin, right in taken):
            continue
        taken.append((left, left + width))
        figure.add_annotation(
            x=shown,
            y=float(np.log10(amplitude * gain)),
            text=words,
            showarrow=False,
            xanchor=anchor,
            yshift=9,
            font={"size": 11},
        )


def known_part(frequency: float, resolution: float) -> float:
    """Frequency or order of a peak, rounded according to the line spacing.

    Examples
    --------
    >>> known_part(49.9978, 1 / 11), known_part(699.83, 3.33), known_part(0.704, 0.5)
    (50.0, 700.0, 0.7)
    """
    return round(frequency, -int(np.ceil(np.log10(0.1 * resolution))))


def plot_tones(frequency: Array, amplitude: Array, background: Array, *, unit: str, name: str) -> go.Figure:
    """Plot of tones as bars at their frequencies, and of the background amplitudes.

    Parameters
    ----------
    frequency
        Frequencies [Hz], shape (n,).
    amplitude, background
        Amplitudes of the tones and of the background, in SI, shape (n,).
    unit
        SI unit of the amplitudes.
    name
        Name of the signal, above the plot.
    """
    across, shown = scale("Hz", frequency), scale(unit, amplitude)
    figure = theme.figure(across.title("frequency"), shown.title("amplitude"), height=340)
    x = frequency * across.factor
    figure.add_scatter(
        x=np.repeat(x, 3),
        y=[value for a in amplitude * shown.factor for value in (0.0, float(a), None)],
        mode="lines",
        name=f"{name}, tones",
        line={"color": theme.TEAL, "width": 2.5},
    )
    figure.add_scatter(
        x=x,
        y=background * shown.factor,
        mode="markers",
        name="background",
        marker={"color": theme.OCHRE, "size": 7, "symbol": "line-ew-open", "line": {"width": 2}},
    )
    for place, height in zip(x, amplitude * shown.factor, strict=True):
        look = {"showarrow": False, "yshift": 9, "font": {"size": 11}}
        anchor = "left" if place < 0.05 * x.max() else "center"
        figure.add_annotation(x=place, y=height, text=number(place, 6), xanchor=anchor, **look)
    figure.update_xaxes(rangemode="tozero")
    figure.update_yaxes(range=[0.0, 1.15 * float(max(amplitude.max(), background.max())) * shown.factor])
    return figure
