# SPDX-License-Identifier: Apache-2.0
"""Plots of a contact analysis: what they show, their units, the points A to E; section and page."""

from __future__ import annotations

import re

import numpy as np
import pytest
import xarray as xr

from pitchpoint.analysis.flank_contact.contact_pattern import contact_pattern
from pitchpoint.analysis.flank_contact.numbers import contact_numbers
from pitchpoint.analysis.flank_contact.root_stress import root_stress_of_tooth
from pitchpoint.analysis.flank_contact.teeth import mesh_teeth
from pitchpoint.solvers.contact_analysis.solve import solve_contact
from pitchpoint.viz.contact_page import contacts_page
from pitchpoint.viz.contact_plots import (
    plot_along_path,
    plot_flank_pattern,
    plot_harris_map,
    plot_load_over_width,
    plot_path_pattern,
    plot_stiffness,
    repeated,
)
from pitchpoint.viz.contact_table import contact_words
from pitchpoint.viz.report.contact import chosen_torques, contact_result, contact_section
from pitchpoint.viz.root_stress_plots import plot_root_stress
from tests.support.contact_files import fzg, helical


@pytest.fixture(scope="module")
def spur(tmp_path_factory: pytest.TempPathFactory) -> xr.Dataset:
    model = fzg(tmp_path_factory.mktemp("spur"))
    return solve_contact(model, torque=[100.0, 302.0], positions=32)


@pytest.fixture(scope="module")
def slanted(tmp_path_factory: pytest.TempPathFactory) -> xr.Dataset:
    model = helical(tmp_path_factory.mktemp("helical"))
    return solve_contact(model, torque=list(np.linspace(100.0, 800.0, 8)), positions=32, misalignment=2e-4)


def titles(figure: object) -> tuple[str, str]:
    return figure.layout.xaxis.title.text, figure.layout.yaxis.title.text  # type: ignore[attr-defined]


def test_pattern_over_the_path(spur: xr.Dataset) -> None:
    """Contact of tip edges lies outside A and E; the second axis has the diameters of the five points."""
    figure = plot_path_pattern(contact_pattern(spur, 1), "line_load")
    assert titles(figure) == ("face width z [mm]", "roll angle of gear 1 on the path [°]")
    field = figure.data[0]
    assert field.colorbar.title.text == "line load [N/mm]"
    assert field.zmax == pytest.approx(302.0 / (0.036 * np.cos(np.radians(20.0))) / 14.0, rel=1e-5)
    assert (field.x[0], field.x[-1]) == pytest.approx((-7.0, 7.0))
    assert np.asarray(field.z).shape == (field.y.size, field.x.size - 1)
    marks = dict(zip(figure.layout.yaxis2.ticktext, figure.layout.yaxis2.tickvals, strict=True))
    assert [text.split()[0] for text in marks] == ["A", "B", "C", "D", "E"]
    assert "E  82.64" in marks
    places = list(marks.values())
    assert field.y[0] < places[0] < places[-1] < field.y[-1]
    low, high = figure.layout.yaxis.range
    assert low < field.y[0] < field.y[-1] < high
    assert figure.layout.yaxis2.range == figure.layout.yaxis.range


@pytest.mark.parametrize("gear", [1, 2])
def test_pattern_on_a_flank(spur: xr.Dataset, gear: int) -> None:
    figure = plot_flank_pattern(contact_pattern(spur, 1), "any_pressure", gear)
    assert titles(figure)[1] == f"roll angle of gear {gear} [°]"
    assert figure.data[0].colorbar.title.text == "pressure [MPa]"
    texts = [text.split()[0] for text in figure.layout.yaxis2.ticktext]
    assert texts == (["A", "B", "C", "D", "E"] if gear == 1 else ["E", "D", "C", "B", "A"])
    assert np.isfinite(np.asarray(figure.data[0].z)).all()


def test_points_next_to_each_other_share_a_label(spur: xr.Dataset) -> None:
    """At a transverse contact ratio of 1 the points D and E coincide."""
    data = spur.copy()
    marks = data["mark_roll"].values.copy()
    marks[:, 3] = marks[:, 4]
    data["mark_roll"] = ("gear", "mark"), marks
    figure = plot_path_pattern(contact_pattern(data), "line_load")
    assert list(figure.layout.yaxis2.ticktext)[-1].startswith("D, E  ")
    curve = plot_along_path({"x": ([0.0, 1.0], [1.0, 1.0])}, mesh_teeth(data), "pressure", "Pa")
    assert [note.text for note in curve.layout.annotations] == ["A", "B", "C", "D, E"]


def test_curves_along_the_path(spur: xr.Dataset) -> None:
    teeth = mesh_teeth(spur)
    way = np.linspace(-1.0, 3.0, 41)
    share = np.where((way >= 0.0) & (way <= 1.4), 0.5, 0.0)
    figure = plot_along_path({"100 N m": (way, share)}, teeth, "load share", "%")
    assert titles(figure) == ("position of the tooth pair from A [base pitches]", "load share [%]")
    assert max(figure.data[0].y) == 50.0
    assert -0.2 < figure.layout.xaxis.range[0] < 0.0
    assert 1.46 < figure.layout.xaxis.range[1] < 1.6
    assert [note.text for note in figure.layout.annotations] == ["A", "B", "C", "D", "E"]
    assert "on the path" in titles(plot_along_path({}, teeth, "pressure", "Pa", of_pair=False))[0]


def test_load_over_the_width_in_steps_of_the_planes() -> None:
    figure = plot_load_over_width([-0.005, 0.005], {"100 N m": [2e5, 1e5]}, [0.01, 0.01])
    assert titles(figure) == ("face width z [mm]", "line load over the width [N/mm]")
    assert list(figure.data[0].x) == pytest.approx([-10.0, 0.0, 0.0, 10.0])
    assert list(figure.data[0].y) == pytest.approx([200.0, 200.0, 100.0, 100.0])


def test_stiffness_and_harris_map() -> None:
    figure = plot_stiffness([0.0, 0.5], [4e8, 2e8], [3e8, 2e8])
    assert [trace.name for trace in figure.data] == ["tangent (mean 300 N/µm)", "secant (mean 250 N/µm)"]
    assert list(figure.data[0].x) == [0.0, 0.5, 1.0, 1.5, 2.0]
    ways = plot_harris_map([200.0, 100.0], [2e-6, 1e-6], [[1e-6, 5e-7], [4e-7, 1e-7]])
    assert titles(ways) == ("torque on gear 1 [N m]", "transmission error [µm]")
    assert list(ways.data[0].x) == [100.0, 200.0]
    assert list(ways.data[0].y) == pytest.approx([1.0, 2.0])
    assert [trace.name for trace in ways.data] == ["peak to peak", "order 1", "order 2"]
    assert repeated([0.25, 0.75], [1.0, 2.0], 2)[0].tolist() == [0.25, 0.75, 1.25, 1.75, 2.25]


def test_section_with_all_plots(slanted: xr.Dataset) -> None:
    section = contact_section({"stage": contact_result(slanted, "This run is not complete.")})
    text = "".join(section.parts)
    assert text.count('<div class="plot"') == 11
    assert "This run is not complete." in text
    assert "misalignment 0.01146 deg" in text
    widths = [head.count("<th") for head in re.findall("<thead>.*?</thead>", text)]
    assert sum(widths) > 12 and max(widths) <= 11  # results that are wider than the page take two tables
    assert "level rigid, 11 contact planes" in text
    assert "Maximum over mean, K_Hβ, at 800 N m" in text
    assert "<h3>" not in text
    assert "<h3>b</h3>" in "".join(
        contact_section({"a": contact_result(slanted), "b": contact_result(slanted)}).parts
    )
    assert not contact_section({}).parts


def test_a_single_torque_has_no_harris_map(spur: xr.Dataset) -> None:
    section = contact_section({"stage": contact_result(spur.isel(torque=[0]))})
    assert "".join(section.parts).count('<div class="plot"') == 10


def test_root_stress_of_both_gears_by_method(spur: xr.Dataset) -> None:
    """Gears without a result have no curve; the second method is dashed, in the colour of its gear."""
    way, stress = root_stress_of_tooth(spur, 1)
    teeth, half = mesh_teeth(spur), np.stack([stress[0], np.full(way.size, np.nan)])
    figure = plot_root_stress({"30° tangent": (way, stress), "finite elements": (way, half)}, teeth)
    assert titles(figure) == ("position of the tooth pair from A [base pitches]", "root stress [MPa]")
    assert [curve.name for curve in figure.data] == [
        "gear 1, 30° tangent",
        "gear 2, 30° tangent",
        "gear 1, finite elements",
    ]
    assert [curve.line.dash for curve in figure.data] == ["solid", "solid", "dash"]
    assert figure.data[0].line.color == figure.data[2].line.color != figure.data[1].line.color
    assert np.nanmax(figure.data[1].y) == pytest.approx(1e-6 * contact_numbers(spur)["root_stress_2"][1])
    low, high = figure.layout.xaxis.range
    assert low < 0.0 < teeth.eps_alpha < high


def test_many_torques_share_few_curves() -> None:
    assert chosen_torques(np.arange(20.0)) == [0, 5, 10, 14, 19]


def test_page(spur: xr.Dataset) -> None:
    text = contacts_page({"stage": spur}, "failed: no contact state", gears={"stage": {}})
    assert "<title>FZG type C: tooth contact</title>" in text
    assert 'role="note">failed: no contact state' in text


def test_description_of_the_contact() -> None:
    options = {
        "level": "flexible",
        "planes": 21,
        "body": "weber_banaschek",
        "clamp": 0.5235987756,
        "overlap": "small",
    }
    words = "level flexible, 21 contact planes, body weber banaschek, clamp 30 deg, contact overlap small"
    assert contact_words(options) == words
