# SPDX-License-Identifier: Apache-2.0
"""Periods of repeated impacts: evidence over the period, compared with noise."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.viz import theme
from pitchpoint.viz.downsampling import kept_samples
from pitchpoint.viz.quantities import Array, amount, number, scale

if TYPE_CHECKING:
    import plotly.graph_objects as go
    import xarray as xr

_POINTS = 8000
_MIN_PROBABILITY = 1e-300
_TITLE = "−log₁₀ of the probability in noise"


def plot_search(result: xr.Dataset, channel: str) -> list[go.Figure]:
    """Plot of the evidence of all trial periods, the threshold, and the detected period.

    Parameters
    ----------
    result
        Result of `find_period` of one channel.
    channel
        Its name.
    """
    period, score = result["trial_period"].values, result["trial_score"].values
    clock = scale("s", period)
    threshold = float(np.log10(period.size / float(result["false_alarm"])))
    figure = theme.figure(clock.title("period"), _TITLE, height=380)
    kept = kept_samples(score, _POINTS)
    figure.add_scatter(
        x=period[kept] * clock.factor,
        y=score[kept].astype(np.float32),
        mode="lines",
        line={"color": theme.SERIES[0], "width": 1.3, "simplify": False},
        hovertemplate="%{x:.5g}: %{y:.3g}<extra></extra>",
    )
    chance = max(float(result["p_value"]), _MIN_PROBABILITY)
    shown = f"{number(chance, 2)} (limit {number(float(result['false_alarm']))})"
    words = f"nothing found in {channel}: exact tests of the highest peaks give a probability of {shown}"
    top = max(float(score.max()), threshold)
    if bool(result["found"]):
        found, deviation = float(result["period"]), float(result["deviation"])
        words = (
            f"{channel}: {clock.text(found, 5)}, standard deviation {amount(deviation, 's', 2)}; "
            f"probability in noise {shown}"
        )
        exact = float(np.log10(period.size / chance))
        top = max(top, exact)
        figure.add_scatter(
            x=[found * clock.factor],
            y=[exact],
            mode="markers",
            marker={"color": theme.GREEN, "size": 11, "symbol": "diamond"},
            name="found, exact test",
            hovertemplate="%{x:.6g}: %{y:.3g}<extra></extra>",
        )
    figure.add_scatter(
        x=[period[0] * clock.factor, period[-1] * clock.factor],
        y=[threshold] * 2,
        mode="lines",
        line={"color": theme.RED, "width": 1.3, "dash": "dash"},
        name="threshold of the exact test",
        hoverinfo="skip",
    )
    figure.update_layout(title=theme.title_above(words), margin={"t": 64}, showlegend=True)
    figure.data[0].update(name="approximate score of all trial periods")
    figure.update_yaxes(range=[0.0, 1.1 * top])
    figure.update_xaxes(range=[period[0] * clock.factor, period[-1] * clock.factor])
    return [figure]


def plot_evidence(result: xr.Dataset, channel: str) -> list[go.Figure]:
    """Plot of the evidence of given periods.

    Parameters
    ----------
    result
        Result of `period_evidence` of one channel.
    channel
        Its name.
    """
    known = np.isfinite(result["p_value"].values)
    period = result["period"].values[known]
    score: Array = -np.log10(np.maximum(result["p_value"].values[known], _MIN_PROBABILITY))
    clock = scale("s", result["period"].values)
    figure = theme.figure(f"period, {channel}", _TITLE, height=340, bargap=0.6)
    if not period.size:
        return []
    figure.add_bar(
        x=[clock.text(value, 5) for value in period],
        y=np.abs(score),
        marker={"color": theme.SERIES[0]},
        text=[f"probability {number(float(value), 3)}" for value in result["p_value"].values[known]],
        textposition="outside",
        cliponaxis=False,
        hovertemplate="%{x}: %{y:.3g}<extra></extra>",
    )
    figure.update_xaxes(type="category", showgrid=False)
    return [figure]
