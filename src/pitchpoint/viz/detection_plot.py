# SPDX-License-Identifier: Apache-2.0
"""Detection rates over the signal-to-noise ratio, one line per detector."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.viz import theme

if TYPE_CHECKING:
    import plotly.graph_objects as go

    from pitchpoint.analysis.detection import DetectionCurves

SYMBOLS = ("circle", "square", "triangle-up", "diamond", "cross", "x")


def plot_detection(curves: DetectionCurves) -> go.Figure:
    """Plot of the detected share of faulty signals with confidence intervals, and the allowed false alarms.

    Parameters
    ----------
    curves
        Result of `detection_curves`.
    """
    figure = theme.figure(
        "signal-to-noise ratio [dB]", "detected [%]", height=400, yaxis={"range": [-3, 103]}
    )
    order = np.argsort(curves.snr)
    snr = curves.snr[order]
    for index, name in enumerate(curves.detectors):
        rate, low, high = (100.0 * a[index, order] for a in (curves.rate, curves.rate_low, curves.rate_high))
        figure.add_scatter(
            x=snr,
            y=rate,
            mode="lines+markers",
            name=name,
            line={"color": theme.SERIES[index % len(theme.SERIES)], "width": 1.6},
            marker={"symbol": SYMBOLS[index % len(SYMBOLS)], "size": 8},
            error_y={
                "type": "data",
                "symmetric": False,
                "array": high - rate,
                "arrayminus": rate - low,
                "thickness": 1,
                "width": 2,
            },
        )
    figure.add_hline(y=100.0 * curves.false_alarm, line={"color": theme.GREY, "width": 1, "dash": "dash"})
    figure.add_annotation(
        x=float(snr[-1]),
        y=100.0 * curves.false_alarm,
        text="allowed false alarms",
        showarrow=False,
        xanchor="right",
        yanchor="bottom",
        font={"size": 11, "color": theme.GREY},
    )
    return figure
