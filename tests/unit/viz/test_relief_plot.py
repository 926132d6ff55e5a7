# SPDX-License-Identifier: Apache-2.0
"""Picture of a relief design: curves of every torque before and after, map with the band of tolerances."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.report.write import write_report
from pitchpoint.solvers.contact_analysis.relief.design import design_relief
from pitchpoint.viz.relief_plot import plot_relief
from pitchpoint.viz.report.relief import relief_section
from tests.support.relief_models import TIP, pair, plan, reliefs

FORCES = (1500.0, 2200.0, 3000.0)


def result(**more):
    model = pair()
    vary = reliefs(length=(1e-3, 8e-3))
    return design_relief(model, None, plan(model, FORCES, vary, analyses=200, positions=8, **more))


def test_curves_and_map():
    data = result(tolerances={TIP.format("pinion", "amount"): 2e-6})
    figure = plot_relief(data)
    lines = [trace for trace in figure.data if trace.mode == "lines" and not trace.fill]
    assert len(lines) == 2 * len(FORCES) + 2
    before, after = lines[-2:]
    assert (before.name, after.name) == ("start", "rounded")
    for trace, design in ((before, "start"), (after, "rounded")):
        assert np.asarray(trace.y) == pytest.approx(1e6 * data["map_peak_to_peak"].sel(design=design).values)
    (band,) = (trace for trace in figure.data if trace.fill)
    assert band.name == "rounded, tolerances"
    assert np.asarray(band.y).max() == pytest.approx(1e6 * float(data["map_max"].sel(design="rounded").max()))
    assert figure.layout.yaxis.title.text == "transmission error [µm]"
    assert figure.layout.xaxis3.title.text == "torque [N m]"


def test_section_of_a_report(tmp_path):
    """Modifications and errors in tables, and the picture."""
    data = result()
    section = relief_section({"stage": data})
    html = "".join(section.parts)
    assert "pinion.modifications.both.tip_relief.amount" in html
    assert html.count("<tr>") == 2 + 4 + len(FORCES)
    page = write_report(pair(), tmp_path / "page.html", data)
    assert "Relief design" in page.read_text("utf-8")


def test_no_band_without_tolerances():
    figure = plot_relief(result())
    assert not any(trace.fill for trace in figure.data)
