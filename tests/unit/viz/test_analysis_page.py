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
        ("amplitude_spectrum", 1, "frequency [Hz]", "amplitude, travel [µm]"),
        ("tracked_spectrum", 1, "order [per revolution]", "amplitude, travel [µm]"),
        ("order_map", 1, "order [per revolution]", "time [ms]"),
        ("time_frequency_map", 1, "time [ms]", "frequency [Hz]"),
        ("power_spectral_density", 1, "frequency [Hz]", "density, travel [m²/Hz]"),
        ("envelope", 1, "time [ms]", "envelope, travel [µm]"),
        ("real_cepstrum", 1, "quefrency [ms]", "cepstrum, travel"),
        # frequency, amplitude, level, background of three harmonics; ratio and index over the harmonics
        ("sideband_table", 14, "sideband", "frequency, harmonic 1, travel [Hz]"),
        ("signal_statistics", 0, "", ""),
    ],
)
def test_pictures_have_axes_with_units(record, tool, count, across, up):
    angle = "turn" if tool in ("order_map", "tracked_spectrum") else None
    result = analyse(record, tool, channel="travel", angle=angle, **OPTIONS.get(tool, {}))
    figures = plot_analysis(result, "travel")
    assert len(figures) == count
    if count:
        axes = figures[0].layout.xaxis.title.text, figures[0].layout.yaxis.title.text
        assert axes == (across, up)
    page = analysis_page(record, result, ["a <note>"])
    assert page.count('<div class="plot"') == count + 1
    assert "&lt;rig&gt;.csv" in page and "a &lt;note&gt;" in page and "<rig>" not in page
