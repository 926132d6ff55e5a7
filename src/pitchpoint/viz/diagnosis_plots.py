# SPDX-License-Identifier: Apache-2.0
"""Plots of a diagnosis: spectra with the lines of machine parts, mean turn of a shaft."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.line_tests import FineSpectrum
from pitchpoint.analysis.mean_turns import MeanTurn
from pitchpoint.analysis.spectra import Spectrum
from pitchpoint.viz import theme
from pitchpoint.viz.downsampling import kept_samples
from pitchpoint.viz.quantities import Array, Channel, scale
from pitchpoint.viz.signals_plot import plot_signals
from pitchpoint.viz.spectrum_plots import plot_spectrum

if TYPE_CHECKING:
    import plotly.graph_objects as go

SYMBOLS = ("circle-open", "diamond-open", "square-open", "triangle-up-open", "cross-open", "hexagon-open")
OCTAVE_POINTS = 500
WIDE = 8.0
"""Ratio of the highest to the lowest fundamental line above which the axis is logarithmic."""
LETTERS = 24
"""Maximum number of labels in one plot without overlap."""
DEPTH = -4.0
"""Range of the amplitude axis below the largest amplitude [decades]."""
LOWEST = -6.0
"""Lowest level that is drawn [dB]: levels of noise between its lines have no meaning."""
ENTRIES = 8
"""Largest number of parts with an entry in the legend of their own; of more, one per group."""


@dataclass(frozen=True)
class Lines:
    """Lines of one part of the machine.

    Attributes
    ----------
    name
        Name in the legend.
    places
        Frequencies [Hz] or orders, rising, shape (n,).
    labels
        Labels, one per line, or empty.
    look
        Number of colour and symbol: a part looks the same in all plots.
    group
        Legend group that is shown and hidden together; empty if none.
    symbol
        Number of the symbol, if it differs from that of the colour.
    """

    name: str
    places: Array
    labels: tuple[str, ...] = ()
    look: int = 0
    group: str = ""
    symbol: int | None = None


def plot_lines(
    spectrum: FineSpectrum,
    lines: Sequence[Lines],
    *,
    unit: str,
    quantity: str,
    over: str = "frequency",
    span: tuple[float, float] | None = None,
) -> go.Figure:
    """Spectrum with marked lines of machine parts.

    Parameters
    ----------
    spectrum
        Amplitudes over frequency [Hz] or order.
    lines
        Marked lines; those outside the axis are omitted.
    unit
        Unit of the amplitudes.
    quantity
        Name of the vertical axis.
    over
        `frequency` or `order`.
    span
        Ends of the horizontal axis [Hz, or orders]; default: range with significant amplitudes. An axis from
        zero is logarithmic if the fundamental lines of the parts are far apart.
    """
    frequency: Array = np.arange(spectrum.amplitude.size, dtype=np.float64) * spectrum.step
    low, high = span or (0.0, _end(spectrum, lines))
    first = [float(part.places[0]) for part in lines if part.places.size]
    wide = bool(low == 0.0 and first and min(first) > 0.0 and high > 4.0 * WIDE * min(first))
    if wide:
        low = 0.3 * min(first)
    shown = (frequency >= low) & (frequency <= high)
    x, y = frequency[shown], np.asarray(spectrum.amplitude[shown], dtype=np.float64)
    if wide:
        kept = _by_octaves(x, y)
        x, y = x[kept], y[kept]
    # the first line of a spectrum is the mean, which is not drawn
    curve = Spectrum(np.r_[0.0, x], np.r_[0.0, y], 0.0, spectrum.resolution, 1.5)
    figure = plot_spectrum({quantity: curve}, unit=unit, quantity=quantity, over=over, highest=high, labels=0)
    figure.data[0].update(name="spectrum", line={"color": theme.GREY, "width": 1.1}, showlegend=False)
    across = scale("Hz", [high]).factor if over == "frequency" else 1.0
    up = scale(unit, [float(y.max())]).factor if y.size else 1.0
    for part in lines:
        _mark(figure, part, spectrum, (low, high), (across, up))
    if wide:
        ticks = [d * 10.0**k for k in range(-6, 7) for d in (1.0, 2.0, 5.0)]
        ticks = [tick for tick in ticks if low * across <= tick <= high * across]
        figure.update_xaxes(
            type="log",
            range=np.log10([low * across, high * across]).tolist(),
            tickvals=ticks,
            ticktext=[f"{tick:g}" for tick in ticks],
        )
    else:
        figure.update_xaxes(range=[low * across, high * across])
    if y.size and float(y.max()) > 0.0:
        # down to the level between the lines, not to single zeros
        floor = float(np.quantile(y, 0.02)) if span else 0.0
        bottom, top = np.log10([max(floor, 10.0**DEPTH * float(y.max())) * up, float(y.max()) * up])
        figure.update_yaxes(range=[bottom - 0.2, top + 0.5])
        # above the curve, clear of all lines
        texts = [(at, text) for part in lines for at, text in zip(part.places, part.labels, strict=False)]
        texts = [(float(at) * across, text) for at, text in texts if text and low <= at <= high]
        for at, text in texts:
            figure.add_annotation(
                x=at, y=1.0, yref="paper", yanchor="top", text=text, showarrow=False, font={"size": 11}
            )
    figure.update_layout(showlegend=bool(lines))
    return figure


def plot_levels(
    places: Array,
    level: Array,
    lines: Sequence[Lines],
    *,
    limit: float,
    over: str = "frequency",
    highest: float,
) -> go.Figure:
    """Levels of spectral lines above their surroundings, with a limit and marked lines of machine parts.

    Parameters
    ----------
    places
        Frequencies [Hz] or orders, rising, shape (n,).
    level
        Levels [dB], shape (n,).
    lines
        Marked lines; those above the end of the axis are omitted.
    limit
        Limit of the levels [dB].
    over
        `frequency` or `order`.
    highest
        End of the horizontal axis [Hz, or orders].
    """
    across = scale("Hz", [highest]) if over == "frequency" else None
    factor = across.factor if across else 1.0
    figure = theme.figure(
        across.title("frequency") if across else "order", "level above the median [dB]", height=380
    )
    shown = places <= highest
    x, y = places[shown], np.maximum(level[shown], LOWEST)
    kept = kept_samples(y, 6000)
    figure.add_scatter(
        x=(x[kept] * factor).astype(np.float32),
        y=y[kept].astype(np.float32),
        mode="lines",
        name="spectrum",
        line={"color": theme.GREY, "width": 1.0},
        showlegend=False,
    )
    figure.add_hline(
        y=limit,
        line={"color": theme.RED, "width": 1.2, "dash": "dash"},
        annotation={
            "text": f"limit {limit:g} dB",
            "font": {"size": 11},
            "xanchor": "right",
            "x": 1.0,
            "yanchor": "bottom",
        },
    )
    for part in lines:
        _mark_levels(figure, part, (x, y), factor, single=len(lines) <= ENTRIES)
    figure.update_xaxes(range=[0.0, highest * factor])
    top = max(limit, float(y.max(initial=0.0)))
    figure.update_yaxes(range=[LOWEST, 1.12 * top + 1.0])
    figure.update_layout(showlegend=bool(lines))
    return figure


def plot_mean_turn(
    turn: MeanTurn,
    *,
    unit: str,
    teeth: int | None,
    zero: float,
    since: str,
    mark: tuple[float, float] | None = None,
) -> go.Figure:
    """Plot of the mean turn of a shaft above its residual, over teeth or degrees.

    Parameters
    ----------
    turn
        The mean turn.
    unit
        Unit of the signal.
    teeth
        Number of teeth; None for an axis in degrees.
    zero
        Angle of the shaft at the first sample [rad].
    since
        Zero of the angle, in words.
    mark
        Middle and width of the tooth that stands out [rad] along the axis; None if there is none.
    """
    angle = np.mod(turn.angle + zero, 2.0 * np.pi)
    order = np.argsort(angle, kind="stable")
    per_turn = float(teeth) if teeth else 360.0
    rows = [
        Channel("mean turn without its mean value", (turn.average - turn.average.mean())[order], unit),
        Channel("residual: without mesh harmonics and the two lowest orders", turn.residual[order], unit),
    ]
    words = "tooth pitches" if teeth else "angle [°]"
    figure = plot_signals(
        angle[order] / (2.0 * np.pi) * per_turn, rows, rows=[[0], [1]], over=f"{words} from {since}"
    )
    figure.update_xaxes(range=[0.0, per_turn])
    if teeth is None:
        figure.update_xaxes(dtick=45)
    elif teeth <= 2 * LETTERS:
        figure.update_xaxes(dtick=1 if teeth <= LETTERS else 2, tick0=0)
    if mark is not None:
        middle, half = (value / (2.0 * np.pi) * per_turn for value in (mark[0], 0.5 * mark[1]))
        for turns in (-per_turn, 0.0, per_turn):
            low, high = max(middle - half + turns, 0.0), min(middle + half + turns, per_turn)
            for row in ("y", "y2") if high > low else ():
                figure.add_shape(
                    type="rect",
                    x0=low,
                    x1=high,
                    y0=0.0,
                    y1=1.0,
                    yref=f"{row} domain",
                    fillcolor=theme.RED,
                    opacity=0.18,
                    line={"width": 0},
                    layer="below",
                )
    return figure


def line_places(first: float, count: int, highest: float) -> Array:
    """First multiples of a frequency below a limit.

    Examples
    --------
    >>> line_places(10.0, 5, 35.0).tolist()
    [10.0, 20.0, 30.0]
    """
    found: Array = first * np.arange(1, count + 1, dtype=np.float64)
    return found[found <= highest]


def in_hertz(spectrum: FineSpectrum, frequency: float) -> FineSpectrum:
    """Spectrum over frequency [Hz] from one over orders; unchanged if the speed is not known (NaN)."""
    if not np.isfinite(frequency):
        return spectrum
    return replace(spectrum, step=spectrum.step * frequency, resolution=spectrum.resolution * frequency)


def _mark_levels(
    figure: go.Figure, part: Lines, curve: tuple[Array, Array], factor: float, *, single: bool
) -> None:
    """Draw marks at the largest level next to each line of a part, with its labels above them."""
    x, y = curve
    inside = part.places <= x[-1]
    if not inside.any():
        return
    at = np.searchsorted(x, part.places[inside])
    near = [slice(max(k - 2, 0), k + 3) for k in at]
    first = single or not any(trace.legendgroup == part.group for trace in figure.data)
    figure.add_scatter(
        x=(part.places[inside] * factor).tolist(),
        y=[float(y[one].max()) for one in near],
        mode="markers+text" if part.labels else "markers",
        text=list(part.labels),
        textposition="top center",
        name=part.name if single or not part.group else part.group,
        legendgroup=part.name if single else part.group,
        showlegend=first,
        marker={
            "color": theme.SERIES[part.look % len(theme.SERIES)],
            "symbol": SYMBOLS[(part.look if part.symbol is None else part.symbol) % len(SYMBOLS)],
            "size": 11 if part.labels else 8,
            "line": {"width": 2.4 if part.labels else 1.4},
        },
        hovertemplate="%{x:.6g}: %{y:.1f} dB<extra>" + part.name + "</extra>",
    )


def _mark(
    figure: go.Figure,
    part: Lines,
    spectrum: FineSpectrum,
    span: tuple[float, float],
    factors: tuple[float, float],
) -> None:
    """Draw marks on the spectrum at the lines of one part."""
    inside = (part.places >= span[0]) & (part.places <= span[1])
    if not inside.any():
        return
    places = part.places[inside]
    first = not any(trace.legendgroup == part.group for trace in figure.data)
    legend = {"name": part.group, "legendgroup": part.group, "showlegend": first} if part.group else {}
    figure.add_scatter(
        x=places * factors[0],
        y=np.maximum(np.sqrt(spectrum.power(places)) * factors[1], 1e-30),
        mode="markers",
        **({"name": part.name} | legend),
        marker={
            "color": theme.SERIES[part.look % len(theme.SERIES)],
            "symbol": SYMBOLS[(part.look if part.symbol is None else part.symbol) % len(SYMBOLS)],
            "size": 9,
            "line": {"width": 1.8},
        },
        hovertemplate="%{x:.6g}: %{y:.4g}<extra>" + part.name + "</extra>",
    )


def _by_octaves(x: Array, y: Array) -> NDArray[np.int64]:
    """Indices of samples for a logarithmic axis: the same number per octave."""
    kept, start = [], 0
    while start < x.size:
        end = max(int(np.searchsorted(x, 2.0 * x[start])), start + 1)
        kept.append(start + kept_samples(y[start:end], OCTAVE_POINTS))
        start = end
    return np.unique(np.concatenate(kept)) if kept else np.empty(0, dtype=np.int64)


def _end(spectrum: FineSpectrum, lines: Sequence[Lines]) -> float:
    """Position of the last significant line, but at least the fundamental line of every part."""
    a = spectrum.amplitude
    seen = np.flatnonzero(a[1:] >= 5e-3 * float(a[1:].max())) if a.size > 1 else np.empty(0)
    last = (int(seen[-1]) + 1) * spectrum.step if seen.size else spectrum.highest
    first = [float(part.places[0]) for part in lines if part.places.size]
    return min(spectrum.highest, 1.25 * max([last, *first]) + 4.0 * spectrum.resolution)
