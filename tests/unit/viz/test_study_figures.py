# SPDX-License-Identifier: Apache-2.0
"""What a study is told with: compared numbers, marked spectra, missing flanks, wavelet levels, detection."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from pitchpoint.analysis.detection import detection_curves
from pitchpoint.analysis.spectra import amplitude_spectrum
from pitchpoint.analysis.wavelets import wavelet_levels
from pitchpoint.viz.compared_table import Compared, compared_table, sourced_table
from pitchpoint.viz.detection_plot import plot_detection
from pitchpoint.viz.flank_plot import plot_missing
from pitchpoint.viz.frequency_marks import mark_frequencies
from pitchpoint.viz.frequency_response_plot import plot_frequency_response
from pitchpoint.viz.level_plot import plot_signal_and_levels
from pitchpoint.viz.mesh_response_plot import plot_mesh_response
from pitchpoint.viz.spectrum_plots import plot_spectrum


def cells(html: str) -> list[list[str]]:
    return [re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", line) for line in re.findall(r"<tr>(.*?)</tr>", html)]


def test_compared_numbers_stand_beside_each_other_with_their_source() -> None:
    rows = [
        Compared("force", 101.0, "run a: F", "kN", 100.0),
        Compared("law", "Hertz <3/2>", "file", "", "Hertz"),
        Compared("other", 2.0, "run b"),
    ]
    assert cells(compared_table(rows, published="paper")) == [
        ["quantity", "unit", "here", "paper", "difference", "source"],
        ["force", "kN", "101", "100", "1 %", "run a: F"],
        ["law", "", "Hertz &lt;3/2&gt;", "Hertz", "", "file"],
        ["other", "", "2", "", "", "run b"],
    ]
    assert math.isnan(rows[1].difference)


def test_without_published_numbers_there_is_no_column_for_them() -> None:
    table = cells(compared_table([Compared("force", 1.0, "run")]))
    assert table == [["quantity", "unit", "here", "source"], ["force", "", "1", "run"]]
    assert cells(compared_table([Compared("force", math.nan, "run")]))[1][2] == "–"


def test_sourced_table_escapes_words() -> None:
    assert cells(sourced_table(("what", "unit", "n"), [("a<b", "m", "1", "f(x) > 0")]))[1] == [
        "a&lt;b",
        "m",
        "1",
        "f(x) &gt; 0",
    ]


def test_marks_stand_at_the_frequencies_and_their_harmonics() -> None:
    t = np.arange(4000) / 1000.0
    spectrum = amplitude_spectrum(np.sin(2 * np.pi * 100.0 * t), 1000.0)
    figure = plot_spectrum({"x": spectrum}, unit="N", highest=250.0, labels=0)
    mark_frequencies(figure, {"mesh": 100.0, "near": 105.0, "beyond": 300.0}, harmonics=4)
    assert sorted(line.x0 for line in figure.layout.shapes) == [100.0, 105.0, 200.0, 210.0]
    names = {a.text: a for a in figure.layout.annotations}
    assert set(names) == {"mesh", "near"}
    # names that would overlap are below each other
    assert names["near"].yshift < names["mesh"].yshift == 0


def test_meshes_of_equal_frequency_have_one_line() -> None:
    """Three planets mesh with the sun at one frequency."""
    figure = plot_spectrum(
        {"a": amplitude_spectrum(np.sin(np.arange(400.0)), 400.0)}, unit="N", highest=199.0
    )
    mark_frequencies(figure, {"sun_1": 50.0, "sun_2": 50.0, "ring": 80.0})
    assert [line.x0 for line in figure.layout.shapes] == [50.0, 80.0]
    assert [a.text for a in figure.layout.annotations if a.name] == ["sun_1, sun_2", "ring"]


def test_responses_are_named_in_words() -> None:
    """Channels and loads as words, in levels over speed as in amplitudes over frequency."""
    speed, hertz = np.linspace(10.0, 100.0, 5), np.linspace(20.0, 200.0, 5)
    channel = "bearing_force[output_low.radial]"
    levels = plot_mesh_response(
        speed, hertz[:, None], np.ones((5, 1, 1)), ["1 × stage"], [channel], ["N"], shaft="input"
    )
    assert levels.layout.yaxis.title.text == "radial bearing force, output_low<br>[dB re 1 µN]"
    inputs = ["shaft.2.fx", "shaft.mz", "transmission_error[stage]"]
    bode = plot_frequency_response(hertz, np.ones((5, 1, 3), complex), [channel], inputs, ["N/N"] * 3)
    assert list(dict.fromkeys(t.name for t in bode.data)) == [
        f"radial bearing force, output_low by {cause}"
        for cause in ("force x, shaft.2", "moment z, shaft", "transmission error, stage")
    ]


def test_labels_of_resonances_are_apart_and_have_the_colour_of_their_order() -> None:
    """Orders 2 and 3 meet modes at 1000 and 1520 Hz near the same speed."""
    speed = np.linspace(20.0, 420.0, 801)
    hertz = speed[:, None] * np.array([4.0, 8.0, 12.0])
    modes = np.array([1000.0, 1520.0])
    size = (1.0 / np.abs(1.0 - (hertz[..., None] / modes) ** 2 + 0.02j)).sum(axis=2)
    figure = plot_mesh_response(
        speed, hertz, size[..., None], ["1 × m", "2 × m", "3 × m"], ["mesh_force[m]"], ["N"], shaft="in"
    )
    labels = [a for a in figure.layout.annotations if a.text.endswith(" Hz")]
    assert len(labels) >= 5
    lines = {t.name: t.line.color for t in figure.data if t.mode == "lines"}
    xaxis, yaxis = figure.layout.xaxis, figure.layout.yaxis
    boxes = []
    for label in labels:
        rpm = label.x
        order = int(
            np.argmin([abs(float(label.text[:-3]) - f * rpm * math.pi / 30.0) for f in (4.0, 8.0, 12.0)])
        )
        assert label.font.color == lines[f"{order + 1} × m"]
        # in the smallest picture: an axis of 330 by 330 pixels and letters of 6 pixels
        x = 330.0 * (label.x - xaxis.range[0]) / (xaxis.range[1] - xaxis.range[0])
        y = 330.0 * (label.y - yaxis.range[0]) / (yaxis.range[1] - yaxis.range[0])
        y += -label.ay if label.showarrow else label.yshift
        x -= {"left": 0.0, "center": 0.5, "right": 1.0}[label.xanchor] * 6.0 * len(label.text)
        boxes.append((x, x + 6.0 * len(label.text), y - 5.0, y + 5.0))
    for k, (left, right, low, high) in enumerate(boxes):
        assert left >= -1.0 and right <= 331.0
        for a, b, c, d in boxes[:k]:
            assert right < a or b < left or high < c or d < low


def test_missing_part_of_a_flank_is_where_the_level_is_positive() -> None:
    z, d = np.linspace(-0.1, 0.1, 5), np.linspace(0.30, 0.40, 3)
    level = np.where(z[:, None] > 0.0, 1e-3, -1e-3) * np.ones(3)
    figure = plot_missing(z, d, level)
    assert np.asarray(figure.data[0].z).tolist() == [[0, 0, 0, 1, 1]] * 3
    assert figure.layout.xaxis.title.text == "face width z [mm]"
    assert figure.data[0].x[-1] == pytest.approx(100.0)


def test_levels_stand_below_the_signal_and_add_up_to_it() -> None:
    rng = np.random.default_rng(0)
    values = rng.normal(size=1024)
    levels = wavelet_levels(values, 400.0, levels=3)
    figure = plot_signal_and_levels(np.arange(1024) / 400.0, values, levels, unit="N", name="S")
    assert len(figure.data) == 5
    assert len({trace.yaxis for trace in figure.data}) == 5
    assert np.allclose(sum(np.asarray(t.y) for t in figure.data[1:]), figure.data[0].y, atol=1e-5)
    words = " ".join(a.text for a in figure.layout.annotations)
    assert "a3: 0 to 25 Hz" in words
    assert "d1: 100 to 200 Hz" in words


def test_detection_rises_with_the_ratio_in_per_cent() -> None:
    t = np.arange(200) / 10.0
    found = detection_curves(0.0 * t, np.sin(t), {"power": np.var}, snr=[10.0, -30.0], seeds=20)
    figure = plot_detection(found)
    assert list(figure.data[0].x) == [-30.0, 10.0]
    assert figure.data[0].y[1] == 100.0 > figure.data[0].y[0]
    assert figure.data[0].error_y.array[1] == 0.0
    assert figure.layout.shapes[0].y0 == pytest.approx(100.0 * found.false_alarm)


@pytest.mark.parametrize("place", [0.02, 0.45, 0.9])
def test_names_of_marks_do_not_overlap_in_a_narrow_plot(place: float) -> None:
    """Three meshes within a tenth of the axis; the axis of one of two plots on paper has 240 pixels."""
    figure = plot_spectrum(
        {"a": amplitude_spectrum(np.sin(np.arange(400.0)), 400.0)}, unit="N", highest=200.0, labels=0
    )
    names = {f"stage_{k}, stage_{k}_right": 200.0 * (place + 0.03 * k) for k in range(3)}
    mark_frequencies(figure, names)
    boxes = []
    for a in (a for a in figure.layout.annotations if a.name == "frequency"):
        at, width = 240.0 * a.x / 200.0 + a.xshift, 6.0 * len(a.text)
        left = at if a.xanchor == "left" else at - width
        assert left > -10.0 and left + width < 250.0
        boxes.append((left, left + width, a.yshift))
    assert len(boxes) == 3
    for k, (left, right, line) in enumerate(boxes):
        assert all(line != other or right <= begin or end <= left for begin, end, other in boxes[k + 1 :])
