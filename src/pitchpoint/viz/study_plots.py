# SPDX-License-Identifier: Apache-2.0
"""Plots of a study: distribution of a result, result over the factors, sensitivities, convergence."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.analysis.study.sensitivity import Indices, sobol_indices
from pitchpoint.analysis.study.summary import FactorSample, ResultSummary, StudySummary, is_constant
from pitchpoint.viz import theme
from pitchpoint.viz.quantities import Array, Scale, channel_scale

if TYPE_CHECKING:
    import plotly.graph_objects as go

MAX_BINS = 40
PANELS = 4
"""Panels of a row."""
MAX_PANELS = 12
"""Factors over which a result is drawn: the most influential ones."""
_GAP, _ROW = 0.05, 190
STEPS = 60
"""Points of a curve of convergence."""
FEWEST = 8
"""Samples from which a curve of convergence begins."""


def result_scale(one: ResultSummary) -> Scale:
    """Display unit of a result."""
    values = one.sample.values[np.isfinite(one.sample.values)]
    quantity = one.sample.words.partition(",")[0].replace(" ", "_")
    if one.sample.unit == "1" and one.sample.words.startswith("share"):
        return Scale("%", 100.0)
    return channel_scale(quantity, one.sample.unit, values)


def factor_scale(factor: FactorSample) -> Scale:
    """Display unit of a factor."""
    return channel_scale("displacement", factor.unit, factor.values) if not factor.labels else Scale("", 1.0)


def _known(summary: StudySummary, one: ResultSummary) -> Array:
    """Values of the statistics in their order."""
    values = one.sample.values[summary.counted]
    return values[np.isfinite(values)]


def plot_distribution(summary: StudySummary, one: ResultSummary) -> go.Figure:
    """Histogram of a result with the value without changes and the limits."""
    shown, values = result_scale(one), _known(summary, one)
    figure = theme.figure(shown.title(one.sample.name), "number of cases", height=330)
    if not is_constant(values):
        edges = np.histogram_bin_edges(values, bins="auto")
        count = min(max(len(edges) - 1, 5), MAX_BINS)
        heights, edges = np.histogram(values, bins=count)
        figure.add_bar(
            x=(0.5 * (edges[1:] + edges[:-1]) * shown.factor).tolist(),
            y=heights.tolist(),
            width=float((edges[1] - edges[0]) * shown.factor),
            marker={"color": theme.TEAL, "line": {"width": 0}},
            opacity=0.75,
            name="cases",
            showlegend=False,
        )
        _mark(figure, one, shown, float(heights.max()))
    return figure


def plot_cumulative(summary: StudySummary, one: ResultSummary) -> go.Figure:
    """Empirical distribution function of a result, and the normal one of equal mean and deviation."""
    from scipy.special import ndtr

    shown, values = result_scale(one), np.sort(_known(summary, one))
    figure = theme.figure(shown.title(one.sample.name), "share of the cases below [%]", height=330)
    if not is_constant(values):
        share = 100.0 * np.arange(1, values.size + 1) / values.size
        x = np.linspace(values[0], values[-1], STEPS)
        normal = 100.0 * ndtr((x - one.spread.mean.value) / one.spread.deviation.value)
        figure.add_scatter(
            x=(x * shown.factor).tolist(),
            y=normal.tolist(),
            mode="lines",
            line={"color": theme.GREY, "width": 1.5, "dash": "dot"},
            name="normal distribution",
        )
        figure.add_scatter(
            x=(values * shown.factor).tolist(),
            y=share.tolist(),
            mode="lines",
            line={"color": theme.TEAL, "width": 2, "shape": "hv"},
            name="cases",
        )
        _mark(figure, one, shown, 100.0)
    figure.update_yaxes(range=[0, 103])
    return figure


def _mark(figure: go.Figure, one: ResultSummary, shown: Scale, top: float) -> None:
    """Vertical lines at the value without changes and at the limits."""
    marks = [("without changes", one.sample.nominal, theme.ORANGE, "solid")]
    limits = [("limit", one.sample.low), ("limit", one.sample.high)]
    marks += [(name, x, theme.RED, "dash") for name, x in limits]
    seen = set()
    for name, x, colour, dash in marks:
        if math.isfinite(x):
            figure.add_scatter(
                x=[x * shown.factor] * 2,
                y=[0.0, top],
                mode="lines",
                line={"color": colour, "width": 2, "dash": dash},
                name=name,
                showlegend=name not in seen,
            )
            seen.add(name)


def plot_over_factors(summary: StudySummary, one: ResultSummary) -> go.Figure:
    """Result over the most influential factors, one panel for each."""
    ranked = np.nan_to_num(one.sensitivity.value, nan=-1.0)
    chosen = sorted(np.argsort(-ranked, kind="stable")[:MAX_PANELS].tolist())
    rows = math.ceil(len(chosen) / PANELS)
    shown = result_scale(one)
    figure = theme.figure("", "", height=_ROW * rows + 90)
    layout: dict[str, Any] = {}
    columns = min(PANELS, len(chosen))
    width = (1.0 - _GAP * (columns - 1)) / columns
    height = (1.0 - 0.28 * (rows - 1)) / rows if rows > 1 else 1.0
    for panel, k in enumerate(chosen):
        row, column = divmod(panel, PANELS)
        end = "" if panel == 0 else str(panel + 1)
        factor = summary.factors[k]
        left, top = column * (width + _GAP), 1.0 - row * (height + 0.28)
        across = factor_scale(factor)
        title = across.title(factor.name)
        layout[f"xaxis{end}"] = theme.axis(
            title, domain=[left, min(left + width, 1.0)], anchor=f"y{end}", nticks=4, automargin=False
        )
        layout[f"yaxis{end}"] = theme.axis(
            shown.title(one.sample.name) if column == 0 else "",
            domain=[max(top - height, 0.0), top],
            anchor=f"x{end}",
            matches="y" if panel else None,
            showticklabels=column == 0,
        )
        _points(figure, layout, summary, one, k, end)
    figure.update_layout(**layout, showlegend=False)
    return figure


def _points(
    figure: go.Figure, layout: dict[str, Any], summary: StudySummary, one: ResultSummary, k: int, end: str
) -> None:
    """Values of a result over one factor."""
    factor, shown = summary.factors[k], result_scale(one)
    use = summary.counted & np.isfinite(one.sample.values)
    x = factor.values[use] * factor_scale(factor).factor
    if factor.labels:
        layout[f"xaxis{end}"] |= {
            "tickvals": list(range(len(factor.labels))),
            "ticktext": list(factor.labels),
        }
    figure.add_scatter(
        x=x.tolist(),
        y=(one.sample.values[use] * shown.factor).tolist(),
        mode="markers",
        marker={"color": theme.TEAL, "size": 5, "opacity": 0.6},
        xaxis=f"x{end}",
        yaxis=f"y{end}",
        name=factor.name,
    )
    if math.isfinite(factor.nominal) and math.isfinite(one.sample.nominal) and not factor.labels:
        figure.add_scatter(
            x=[factor.nominal * factor_scale(factor).factor],
            y=[one.sample.nominal * shown.factor],
            mode="markers",
            marker={"color": theme.ORANGE, "size": 10, "symbol": "diamond"},
            xaxis=f"x{end}",
            yaxis=f"y{end}",
            name="without changes",
        )


def plot_sensitivities(summary: StudySummary, one: ResultSummary) -> go.Figure:
    """Bars of the sensitivities of a result with their confidence intervals, the largest at the top."""
    order = np.argsort(np.nan_to_num(one.sensitivity.value, nan=-1.0), kind="stable")
    names = [summary.factors[k].name for k in order]
    if one.first is not None and one.total is not None:
        sets = [("first-order index", one.first, theme.OCHRE), ("total index", one.total, theme.TEAL)]
    else:
        sets = [("share of the variance", one.sensitivity, theme.TEAL)]
    figure = theme.figure("share of the variance [%]", "", height=110 + 34 * len(names) * len(sets))
    for name, found, colour in sets:
        figure.add_bar(**_bars(names, found, order, 100.0), name=name, marker={"color": colour})
    figure.update_layout(showlegend=len(sets) > 1, barmode="group", bargap=0.3)
    figure.update_xaxes(rangemode="tozero")
    return figure


def plot_coefficients(summary: StudySummary, one: ResultSummary) -> go.Figure | None:
    """Bars of the standardised regression coefficients with their confidence intervals."""
    if one.linear is None:
        return None
    order = np.argsort(np.nan_to_num(one.sensitivity.value, nan=-1.0), kind="stable")
    order = order[np.isfinite(one.linear.coefficient.value[order])]
    names = [summary.factors[k].name for k in order]
    figure = theme.figure("standardised regression coefficient", "", height=110 + 34 * len(names))
    found = one.linear.coefficient
    figure.add_bar(**_bars(names, found, order, 1.0), name="coefficient", marker={"color": theme.OCHRE})
    return figure


def _bars(names: list[str], found: Indices, order: Any, factor: float) -> dict[str, Any]:
    """Horizontal bars with error bars."""
    value, low, high = (factor * part[order] for part in (found.value, found.low, found.high))
    return {
        "x": value.tolist(),
        "y": names,
        "orientation": "h",
        "error_x": {
            "type": "data",
            "symmetric": False,
            "array": np.maximum(high - value, 0.0).tolist(),
            "arrayminus": np.maximum(value - low, 0.0).tolist(),
            "color": theme.GREY,
            "thickness": 1.5,
            "width": 4,
        },
    }


def plot_convergence(summary: StudySummary, one: ResultSummary) -> go.Figure:
    """Mean and its confidence interval over the number of samples."""
    from scipy import stats

    shown, values = result_scale(one), _known(summary, one)
    figure = theme.figure("number of cases", shown.title(f"mean of {one.sample.name}"), height=320)
    n = _numbers(values.size)
    if not n.size:
        return figure
    sums, squares = np.cumsum(values), np.cumsum((values - values[0]) ** 2)
    mean = sums[n - 1] / n
    variance = (squares[n - 1] - n * (mean - values[0]) ** 2) / (n - 1)
    half = stats.t.ppf(0.5 + 0.5 * summary.confidence, n - 1) * np.sqrt(np.maximum(variance, 0.0) / n)
    _band(figure, n, mean * shown.factor, half * shown.factor, "mean", summary.confidence)
    return figure


def plot_convergence_of_deviation(summary: StudySummary, one: ResultSummary) -> go.Figure:
    """Standard deviation over the number of samples, or total indices over the number of points."""
    if one.total is not None:
        return _convergence_of_indices(summary, one)
    shown, values = result_scale(one), _known(summary, one)
    title = shown.title(f"standard deviation of {one.sample.name}")
    figure = theme.figure("number of cases", title, height=320)
    n = _numbers(values.size)
    deviation = [float(values[:k].std(ddof=1)) * shown.factor for k in n]
    figure.add_scatter(
        x=n.tolist(), y=deviation, mode="lines", line={"color": theme.TEAL, "width": 2}, name="deviation"
    )
    figure.update_layout(showlegend=False)
    return figure


def _convergence_of_indices(summary: StudySummary, one: ResultSummary) -> go.Figure:
    """Total indices over the number of points of the design."""
    figure = theme.figure("number of points", "total index [%]", height=320)
    blocks = one.sample.values.reshape(-1, len(summary.factors) + 2)
    n = _numbers(len(blocks), 20)
    rows = [sobol_indices(*_parts(blocks[:k]), intervals=False)[1].value for k in n]
    for k, factor in enumerate(summary.factors):
        figure.add_scatter(
            x=n.tolist(),
            y=[100.0 * float(row[k]) for row in rows],
            mode="lines",
            line={"color": theme.SERIES[k % len(theme.SERIES)], "width": 2},
            name=factor.name,
        )
    return figure


def _parts(blocks: Array) -> tuple[Array, Array, Array]:
    return blocks[:, 0], blocks[:, 1], blocks[:, 2:]


def _numbers(count: int, steps: int = STEPS) -> Any:
    """Numbers of samples at which an estimate is drawn."""
    if count < FEWEST:
        return np.zeros(0, int)
    return np.unique(np.round(np.geomspace(FEWEST, count, steps)).astype(int))


def _band(figure: go.Figure, x: Array, y: Array, half: Array, name: str, confidence: float) -> None:
    """Curve with a band."""
    around = np.concatenate([y + half, (y - half)[::-1]])
    figure.add_scatter(
        x=np.concatenate([x, x[::-1]]).tolist(),
        y=around.tolist(),
        mode="lines",
        fill="toself",
        fillcolor="rgba(34,150,160,0.2)",
        line={"width": 0},
        name=f"{100.0 * confidence:g} % interval",
        hoverinfo="skip",
    )
    figure.add_scatter(
        x=x.tolist(), y=y.tolist(), mode="lines", line={"color": theme.TEAL, "width": 2}, name=name
    )
