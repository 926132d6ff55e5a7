# SPDX-License-Identifier: Apache-2.0
"""Plots and page of one analysis: the signal and the result of the tool."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.analysis.tools import TOOLS
from pitchpoint.viz import theme
from pitchpoint.viz.analysis_pictures import PICTURES
from pitchpoint.viz.downsampling import kept_samples
from pitchpoint.viz.quantities import channels, scale
from pitchpoint.viz.report.page import Section, page
from pitchpoint.viz.signals_plot import plot_signals

if TYPE_CHECKING:
    import plotly.graph_objects as go
    import xarray as xr

_POINTS, _MAX_MARKERS, _ROWS = 8000, 50, 12
"""Maximum numbers of points of a curve, of marked points, and of rows with one plot each."""
_LOGARITHMIC = 1e3
"""Ratio of largest to median value above which positive numbers have a logarithmic axis."""


def analysis_page(record: xr.Dataset, result: xr.Dataset, notes: Sequence[str] = ()) -> str:
    """HTML page of one result of `analysis.dataset.analyse`.

    Parameters
    ----------
    record
        Analysed record.
    result
        Result of the analysis.
    notes
        Sentences for the last section.
    """
    about, names = result.attrs, result.attrs["channel"]
    sections = [_signals(record, names.split(", "))]
    for name, one in results_by_channel(result).items():
        section = Section(f"result-{len(sections)}", f"{about['tool'].replace('_', ' ')}, {name}")
        for figure in plot_analysis(one, name):
            section.add_figure(figure)
        sections.append(section)
    if notes:
        items = "".join(f"<li>{escape(note)}</li>" for note in notes)
        sections.append(Section("notes", "Notes", [f"<ul>{items}</ul>"]))
    facts = [
        ("file", str(about.get("source_file", ""))),
        ("format", str(about.get("format", ""))),
        ("SHA-256", str(about.get("sha256", ""))[:16]),
        ("channel", names),
        ("angle", str(about.get("angle", ""))),
        ("options", str(about["options"]) if about["options"] != "{}" else ""),
    ]
    title = f"{about['tool'].replace('_', ' ')} of {names}"
    return page(title, facts, sections, "pitchpoint analyse.")


def results_by_channel(result: xr.Dataset) -> dict[str, xr.Dataset]:
    """Result of each single channel."""
    if "channel" not in result.dims:
        return {str(result.attrs["channel"]): result}
    return {
        str(name): result.isel(channel=k).drop_vars("channel")
        for k, name in enumerate(result["channel"].values)
    }


def plot_analysis(result: xr.Dataset, channel: str) -> list[go.Figure]:
    """Plots of the result of one channel; empty if it contains only single numbers.

    Parameters
    ----------
    result
        Result of `analyse` of one channel, with its attributes.
    channel
        Name in axis titles.
    """
    kind = TOOLS[result.attrs["tool"]].picture
    if kind in PICTURES:
        return PICTURES[kind](result, channel)
    figures = []
    for name, variable in result.data_vars.items():
        if not variable.dims or variable.dtype.kind not in "fiu" or variable.dims[-1] not in result.coords:
            continue
        if variable.ndim == 1:
            figures.append(_curve(result, variable, f"{_words(name)}, {channel}"))
        elif variable.ndim == 2 and variable.shape[0] <= _ROWS:
            first = str(variable.dims[0])
            labels = result[first].values if first in result.coords else range(variable.shape[0])
            figures += [
                _curve(result, variable[k], f"{_words(name)}, {_words(first)} {_label(label)}, {channel}")
                for k, label in enumerate(labels)
            ]
    return figures


def _signals(record: xr.Dataset, names: Sequence[str]) -> Section:
    """Section with the input channels over time."""
    section = Section("signal", "Signal")
    if "time" in record.dims:
        time, found = channels(record)
        for name in dict.fromkeys(names):
            if name in found:
                section.add_figure(plot_signals(time, [found[name]], title=name))
    return section


def _curve(result: xr.Dataset, variable: xr.DataArray, words: str) -> go.Figure:
    """Plot of one row of numbers over its dimension."""
    axis = str(variable.dims[0])
    x, y = (np.asarray(v.values, dtype=np.float64) for v in (result[axis], variable))
    across, unit = scale(str(result[axis].attrs.get("units", "")), x), str(variable.attrs["units"])
    best = scale(unit, y)
    figure = theme.figure(across.title(_words(axis)), best.title(words), height=340)
    kept = kept_samples(y, _POINTS)
    figure.add_scatter(
        x=(x[kept] * across.factor).astype(np.float32),
        y=(y[kept] * best.factor).astype(np.float32),
        # few numbers are drawn as points; a single one would not be visible as a line
        mode="lines" if kept.size > _MAX_MARKERS else "lines+markers",
        name=words,
        line={"color": theme.colour_of(str(variable.name), 0), "width": 1.3, "simplify": False},
    )
    positive = y[y > 0.0]
    if y.size and y.min() >= 0.0 and positive.size and y.max() > _LOGARITHMIC * np.median(positive):
        figure.update_yaxes(type="log", exponentformat="power")
    figure.update_layout(showlegend=False)
    return figure


def _words(name: object) -> str:
    return str(name).replace("_", " ")


def _label(value: object) -> str:
    return f"{value:g}" if isinstance(value, int | float | np.number) else str(value)
