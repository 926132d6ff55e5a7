# SPDX-License-Identifier: Apache-2.0
"""Plots as data of a page: a quarter of the size, and nothing that the eye or a logarithm would miss."""

from __future__ import annotations

import base64
import json

import numpy as np
import plotly.graph_objects as go
import pytest

from pitchpoint.viz.figure_file import figure_json

X = np.linspace(0.0, 15.0, 4000)
Y = 861e3 + 50.0 * np.random.default_rng(3).standard_normal(X.size)


def read(trace: dict, letter: str) -> np.ndarray:
    """Numbers of a line, as the script of the page reads them."""
    values = trace[letter]
    raw = np.frombuffer(base64.b64decode(values["bdata"]), values["dtype"])
    if letter not in trace.get("meta", {}).get("steps", {}):
        return raw
    offset, step = trace["meta"]["steps"][letter]
    return offset + step * raw


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_long_lines_are_as_exact_as_16_bits_of_their_range(kind: type) -> None:
    figure = go.Figure(go.Scatter(x=X.astype(kind), y=Y.astype(kind)))
    (trace,) = json.loads(figure_json(figure))["data"]
    for letter, truth in (("x", X.astype(kind)), ("y", Y.astype(kind))):
        assert np.abs(read(trace, letter) - truth).max() <= 0.5001 * np.ptp(truth) / 65535
        # two bytes each, a third more in base 64
        assert len(trace[letter]["bdata"]) <= 2 * X.size * 4 / 3 + 3
    # the plot itself is as it was
    assert np.array_equal(figure.data[0].y, Y.astype(kind))


def test_logarithms_short_lines_and_gaps_keep_their_digits() -> None:
    layout = {"yaxis": {"type": "log"}, "xaxis2": {"type": "log"}}
    falling = np.exp(-X)
    figure = go.Figure(
        [
            go.Scatter(x=X, y=falling),
            go.Scatter(x=X + 1.0, y=Y, xaxis="x2", yaxis="y2"),
            go.Scatter(x=X[:50], y=Y[:50], yaxis="y2"),
            go.Scatter(x=X, y=np.where(X < 1.0, np.nan, Y), yaxis="y2"),
            go.Scatter(x=X, y=0.0 * Y, yaxis="y2"),
        ],
        layout,
    )
    spectrum, other, short, gaps, constant = json.loads(figure_json(figure))["data"]
    assert np.array_equal(read(spectrum, "y"), falling) and set(spectrum["meta"]["steps"]) == {"x"}
    assert np.array_equal(read(other, "x"), X + 1.0) and set(other["meta"]["steps"]) == {"y"}
    assert np.array_equal(read(short, "y"), Y[:50]) and "meta" not in short
    assert "y" not in gaps["meta"]["steps"]
    assert not read(constant, "y").any()
