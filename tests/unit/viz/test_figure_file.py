# SPDX-License-Identifier: Apache-2.0
"""Plots as data of a page: a quarter of the size, and nothing that the eye or a logarithm would miss."""

from __future__ import annotations

import json

import numpy as np
import plotly.graph_objects as go
import pytest

from pitchpoint.viz.figure_file import figure_json
from tests.support.report_data import numbers_of as read

X = np.linspace(0.0, 15.0, 4000)
Y = 861e3 + 50.0 * np.random.default_rng(3).standard_normal(X.size)


def size_of(entry: dict) -> int:
    """Letters of packed or plain numbers."""
    return len(entry.get("packed") or entry["bdata"])


def test_smooth_lines_and_means_are_packed() -> None:
    """A wave needs a third of the size of noise; every four numbers have a mean."""
    wave, means = np.sin(X), np.cos(X[::4])
    figure = go.Figure(go.Scatter(x=X, y=wave, meta={"means": means}))
    (trace,) = json.loads(figure_json(figure))["data"]
    assert np.abs(read(trace, "y") - wave).max() <= 0.5001 * np.ptp(wave) / 65535
    assert np.abs(read(trace, "means") - means).max() <= 0.5001 * np.ptp(means) / 65535
    assert size_of(trace["y"]) < 0.4 * 2 * X.size * 4 / 3


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_long_lines_are_as_exact_as_16_bits_of_their_range(kind: type) -> None:
    figure = go.Figure(go.Scatter(x=X.astype(kind), y=Y.astype(kind)))
    (trace,) = json.loads(figure_json(figure))["data"]
    for letter, truth in (("x", X.astype(kind)), ("y", Y.astype(kind))):
        assert np.abs(read(trace, letter) - truth).max() <= 0.5001 * np.ptp(truth) / 65535
    # even instants need no numbers; two bytes for each of the others, a third more in base 64
    assert trace["x"] is None
    assert size_of(trace["y"]) <= 2 * X.size * 4 / 3 + 3
    # the plot itself is as it was
    assert np.array_equal(figure.data[0].y, Y.astype(kind))


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_chosen_samples_of_a_record_are_where_they_were(kind: type) -> None:
    """One byte each states how many samples are omitted; more than 250 in a row take two, and instants that
    single precision blurs."""
    random = np.random.default_rng(5)
    for most, size in ((20, 1), (250, 1 if kind is np.float64 else 2), (400, 2)):
        kept = np.cumsum(np.append([0, 1], random.integers(1, most + 1, 3000)))
        truth = (3.0 + 1e-4 * kept).astype(kind)
        (trace,) = json.loads(figure_json(go.Figure(go.Scatter(x=truth, y=Y[: truth.size]))))["data"]
        assert np.abs(read(trace, "x") - truth).max() <= 0.5001 * np.ptp(truth) / 65535
        assert size_of(trace["x"]) <= size * truth.size * 4 / 3 + 3


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
