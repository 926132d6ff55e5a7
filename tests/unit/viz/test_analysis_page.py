# SPDX-License-Identifier: Apache-2.0
"""Pages of analyses: every tool whose result has a curve or a map gets pictures with units."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from pitchpoint.analysis.dataset import analyse
from pitchpoint.viz.analysis_page import analysis_page, plot_analysis

TIME = np.arange(4096) / 4096.0
ANGLE = 2 * np.pi * 20.0 * TIME
OPTIONS = {
    "order_map": {"highest_order": 30, "revolutions": 2},
    "tracked_spectrum": {"highest_order": 30},
    "sideband_table": {"mesh": 340.0, "spacing": 20.0},
    "harmonic_table": {"fundamental": 340.0},
    "find_period": {"shortest": 0.02, "longest": 0.3},
    "period_evidence": {"periods": [0.05, 0.9]},
    "gear_signals": {"teeth": 17},
    "tones": {"expected": [340.0], "reach": 5.0},
}


@pytest.fixture(scope="module")
def record():
    force = 1e-6 * (3.0 + np.cos(17 * ANGLE) * (1 + 0.3 * np.cos(ANGLE)))
    return xr.Dataset(
        {"travel": ("time", force, {"units": "m"}), "turn": ("time", ANGLE, {"units": "rad"})},
        coords={"time": TIME},
        attrs={"source_file": "<rig>.csv", "sha256": "0" * 64, "format": "CSV"},
    )


@pytest.mark.parametrize(
    "tool, count, across, up",
    [
        ("amplitude_spectrum", 1, "frequency [Hz]", "amplitude [µm]"),
        ("tracked_spectrum", 1, "order [–]", "amplitude [µm]"),
        ("order_map", 1, "order [–]", "time [ms]"),
        ("time_frequency_map", 1, "time [ms]", "frequency [Hz]"),
        ("power_spectral_density", 1, "frequency [Hz]", "density, travel [m²/Hz]"),
        ("envelope", 1, "time [ms]", "envelope, travel [µm]"),
        ("real_cepstrum", 1, "quefrency [ms]", "cepstrum, travel"),
        # frequency, amplitude, level, background of three harmonics; ratio and index over the harmonics
        ("sideband_table", 14, "sideband", "frequency, harmonic 1, travel [Hz]"),
        ("signal_statistics", 0, "", ""),
        ("wavelet_levels", 1, "time [ms]", "[µm]"),
        ("wavelet_packets", 2, "frequency [Hz]", "share of the energy, travel [%]"),
        ("scalogram", 1, "time [ms]", "frequency [Hz]"),
        ("find_period", 1, "period [ms]", "−log₁₀ of the probability in noise"),
        ("period_evidence", 1, "period, travel", "−log₁₀ of the probability in noise"),
        ("kurtogram", 1, "frequency [Hz]", "bandwidth"),
        ("spectral_coherence", 2, "cyclic frequency [Hz]", "mean coherence"),
        ("line_prominence", 1, "frequency [Hz]", "above the median [dB]"),
        ("gear_signals", 1, "angle [°]", "[µm]"),
        ("tones", 1, "frequency [Hz]", "amplitude [µm]"),
    ],
)
def test_pictures_have_axes_with_units(record, tool, count, across, up):
    angle = "turn" if tool in ("order_map", "tracked_spectrum", "gear_signals") else None
    result = analyse(record, tool, channel="travel", angle=angle, **OPTIONS.get(tool, {}))
    figures = plot_analysis(result, "travel")
    assert len(figures) == count
    if count:
        axes = figures[0].layout.xaxis.title.text, figures[0].layout.yaxis.title.text
        assert axes == (across, up)
    page = analysis_page(record, result, ["a <note>"])
    assert page.count('<div class="plot"') == count + 1
    assert "&lt;rig&gt;.csv" in page and "a &lt;note&gt;" in page and "<rig>" not in page


def picture(record, tool, **options):
    result = analyse(record, tool, channel="travel", **options)
    return result, plot_analysis(result, "travel")[0]


def test_levels_are_named_with_band_and_share(record):
    result, figure = picture(record, "wavelet_levels", levels=3)
    heads = [note.text for note in figure.layout.annotations]
    assert len(figure.data) == len(heads) == 4
    share = 100.0 * float(result["energy_share"].sel(level="d3"))
    assert f"d3:  256 to 512 Hz,  {share:.1f} % of the energy" in heads[1]


def test_scalogram_is_drawn_from_low_to_high_with_its_edges(record):
    result, figure = picture(record, "scalogram", frequencies=[400.0, 100.0, 200.0])
    shown, left, right = figure.data
    assert list(shown.y) == [100.0, 200.0, 400.0]
    edge = result["edge"].values[[1, 2, 0]]
    np.testing.assert_allclose(left.x, 1e3 * edge)
    np.testing.assert_allclose(right.x, 1e3 * (TIME[-1] - edge))
    # the tone of 340 Hz is nearest to the row of 400 Hz
    assert np.asarray(shown.z)[:, 180].argmax() == 2
    assert figure.layout.yaxis.type is None
    assert picture(record, "scalogram")[1].layout.yaxis.type == "log"


def test_one_row_of_a_scalogram_has_a_picture(record):
    assert picture(record, "scalogram", frequencies=[340.0])[1].data[0].type == "heatmap"


def test_kurtogram_shows_every_band_and_frames_the_best(record):
    result, figure = picture(record, "kurtogram", levels=2)
    values = np.asarray(figure.data[0].z)
    assert values.shape == (np.unique(result["level"]).size, len(figure.data[0].x) - 1)
    assert not np.isnan(values).any()
    np.testing.assert_allclose(np.unique(values), np.unique(result["kurtosis"].values.astype("f4")))
    frame = figure.layout.shapes[0]
    np.testing.assert_allclose([frame.x0, frame.x1], [float(result["best_low"]), float(result["best_high"])])


def test_search_shows_the_period_or_that_there_is_none(record):
    noise = np.random.default_rng(1).standard_normal(TIME.size)
    dips = noise - 6.0 * (np.mod(TIME, 0.0937) < 0.005)
    both = xr.Dataset({"noise": ("time", noise), "dips": ("time", dips)}, coords={"time": TIME})
    shown = {}
    for name in ("noise", "dips"):
        result = analyse(both, "find_period", channel=name, shortest=0.03, longest=0.3)
        (shown[name],) = plot_analysis(result, name)
    assert shown["noise"].layout.title.text.startswith("nothing found in noise")
    assert len(shown["noise"].data) == 2
    marker, threshold = shown["dips"].data[1:]
    assert marker.x[0] == pytest.approx(93.7, abs=0.3) and marker.y[0] > threshold.y[0]
    assert "93." in shown["dips"].layout.title.text
