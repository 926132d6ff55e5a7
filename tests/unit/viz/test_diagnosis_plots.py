# SPDX-License-Identifier: Apache-2.0
"""Pictures of a diagnosis: marks sit on the spectrum, wide axes lose no line, teeth wrap around."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.line_tests import fine_spectrum
from pitchpoint.analysis.mean_turns import mean_turn
from pitchpoint.analysis.turning_parts import train_parts
from pitchpoint.viz.diagnosis_plots import Lines, in_hertz, plot_lines, plot_mean_turn

TIME = np.arange(20_000) / 2000.0


def spectrum_of(*tones: tuple[float, float]):
    return fine_spectrum(sum(a * np.sin(2 * np.pi * f * TIME) for f, a in tones), 2000.0)


def test_marks_lie_on_the_spectrum_and_beyond_the_axis_nothing() -> None:
    spectrum = spectrum_of((100.0, 2.0), (200.0, 0.5))
    lines = Lines("mesh", np.array([100.0, 200.0, 300.0]), ("1", "2", "3"))
    figure = plot_lines(spectrum, [lines], unit="m/s^2", quantity="amplitude", span=(50.0, 250.0))
    curve, marks = figure.data
    assert figure.layout.yaxis.title.text == "amplitude [m/s²]"
    assert list(marks.x) == [100.0, 200.0]
    assert marks.y == pytest.approx([2.0, 0.5], rel=1e-3)
    assert [note.text for note in figure.layout.annotations] == ["1", "2"]
    assert min(curve.x) >= 50.0 and max(curve.x) <= 250.0
    assert tuple(figure.layout.xaxis.range) == (50.0, 250.0)


def test_lines_far_apart_get_a_logarithmic_axis_that_keeps_every_peak() -> None:
    """Lines at 3, 20 and 700 Hz of 1, 0.3 and 0.1 m/s²: all of them are in the drawn curve."""
    tones = [(3.0, 1.0), (20.0, 0.3), (700.0, 0.1)]
    lines = [Lines(f"mesh {f:g}", np.array([f])) for f, _ in tones]
    figure = plot_lines(spectrum_of(*tones), lines, unit="m/s^2", quantity="amplitude")
    assert figure.layout.xaxis.type == "log"
    low, high = 10.0 ** np.array(figure.layout.xaxis.range)
    assert low == pytest.approx(0.9, rel=1e-9) and high > 700.0
    x, y = np.array(figure.data[0].x), np.array(figure.data[0].y)
    for f, a in tones:
        assert y[np.abs(x - f) < 0.05].max() == pytest.approx(a, rel=1e-2)
    assert x.size < 6000


def test_orders_stay_orders_where_the_speed_is_not_known() -> None:
    spectrum = spectrum_of((100.0, 1.0))
    assert in_hertz(spectrum, float("nan")) is spectrum
    assert in_hertz(spectrum, 10.0).step == pytest.approx(10.0 * spectrum.step)


def test_a_tooth_at_the_end_of_the_turn_is_marked_on_both_sides() -> None:
    """Tooth 0 of 20 in the middle of its pitch, counted from a quarter of a pitch later: 19.75 and 0.25."""
    turned = np.arange(40_000) / 400.0
    noise = np.random.default_rng(1).standard_normal(turned.size)
    x = np.cos(2 * np.pi * 20 * turned) + 2.0 * (turned % 1 < 0.02) + 0.2 * noise
    parts = train_parts([(20, 31)])
    turn = mean_turn(x, 400.0, parts, parts.shafts[0], 20)
    pitch = 2 * np.pi / 20
    figure = plot_mean_turn(turn, unit="m", teeth=20, zero=-0.5 * pitch, since="a pulse", mark=(0.0, pitch))
    sides = sorted((s.x0, s.x1) for s in figure.layout.shapes if s.yref == "y domain")
    assert sides == [pytest.approx((0.0, 0.5)), pytest.approx((19.5, 20.0))]
    assert figure.layout.xaxis.title.text == "tooth pitches from a pulse"
    place = np.array(figure.data[1].x)
    assert np.all(np.diff(place) > 0.0)
    # the impact lasts 0.4 pitches from the start of the record, half a pitch before the pulse
    largest = place[np.argmax(np.abs(figure.data[1].y))]
    assert 19.4 < largest < 20.0
