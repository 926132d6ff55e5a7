# SPDX-License-Identifier: Apache-2.0
"""Campbell diagrams and bars of modes: names that fit, critical speeds, ranges."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest

from pitchpoint.viz.campbell_plot import ROOM, plot_campbell
from pitchpoint.viz.mode_plot import plot_modes
from pitchpoint.viz.report.build import ReportResults
from pitchpoint.viz.report.campbell import campbell_section
from pitchpoint.viz.report.summary import summary_section
from tests.support.report_data import campbell


def test_names_of_a_campbell_diagram_never_overlap() -> None:
    modes = {f"mode {k}": 100.0 + 0.1 * k for k in range(12)} | {"high": 1000.0}
    orders = {f"{k}× shaft": (float(k), "shaft") for k in (1, 2, 50, 51, 52)}
    figure = plot_campbell(campbell(modes, orders))
    right = [a for a in figure.layout.annotations if a.x == 1 and a.text]
    assert {a.text for a in right} >= set(modes)
    boxes = right_boxes(figure)
    assert all(b[0] >= a[1] - 1e-6 for a, b in zip(boxes, boxes[1:], strict=False))
    assert boxes[0][0] >= -1e-6 and boxes[-1][1] <= ROOM + 1e-6
    above = [a for a in figure.layout.annotations if a.textangle == -90]
    assert len(above) == 3
    at = sorted(560 * a.x + a.xshift for a in above)
    assert np.diff(at).min() >= 14 - 1e-6
    assert figure.layout.margin.r > 60


def test_long_names_above_a_campbell_diagram_are_folded() -> None:
    """Upright, they are blank space above the plot."""
    orders = {"24× rotor (torque motor)": (24.0, "load"), "2× rotor": (30.0, "mesh")}
    figure = plot_campbell(campbell({"high": 100.0}, orders))
    above = [a.text for a in figure.layout.annotations if a.textangle == -90]
    assert sorted(above) == ["24× rotor<br>(torque motor)", "2× rotor"]
    assert figure.layout.margin.t < 34 + 26 + 22 + 15 * 6.3 + 1


def right_boxes(figure: Any) -> list[tuple[float, float]]:
    """Lower and upper ends of the names right of a Campbell diagram [pixels], from the lowest."""
    low, high = figure.layout.yaxis.range
    margin = figure.layout.margin
    assert figure.layout.height - margin.t - margin.b == pytest.approx(ROOM)
    # automatic margins would make the plot lower than the distances of the names assume
    assert figure.layout.xaxis.automargin is False and figure.layout.yaxis.automargin is False
    found = []
    for a in (a for a in figure.layout.annotations if a.x == 1 and a.text):
        middle, half = ROOM * (a.y - low) / (high - low) - a.ay, 7.0 * (1 + a.text.count("<br>"))
        found.append((middle - half, middle + half))
    return sorted(found)


def test_long_names_of_modes_leave_most_of_the_width_to_the_diagram() -> None:
    """Sixteen modes of a planetary set: names of 49 letters in two lines, within the height of the plot."""
    modes = {f"{k}nd translational mode of planetary stage set (b)": 1e3 + 50.0 * k for k in range(16)}
    figure = plot_campbell(campbell(modes))
    assert 680.0 - figure.layout.margin.l - figure.layout.margin.r > 0.55 * 680.0
    boxes = right_boxes(figure)
    assert len(boxes) >= 16 and boxes[0][0] >= -1e-6 and boxes[-1][1] <= ROOM + 1e-6
    assert all(b[0] >= a[1] - 1e-6 for a, b in zip(boxes, boxes[1:], strict=False))


def test_shaft_orders_at_one_place_are_named_by_their_range() -> None:
    """Fourteen orders of seven shafts within a tenth of the height, and one far above them."""
    orders = {f"{n}× shaft_{k}": (n * (1.0 + 0.1 * k), "shaft") for k in range(7) for n in (1, 2)}
    figure = plot_campbell(campbell({"high": 2958.0}, orders | {"20× shaft_0": (20.0, "shaft")}))
    names = [a.text.replace("<br>", " ").replace("\xa0", " ") for a in figure.layout.annotations if a.x == 1]
    assert set(names) == {"high", "14 shaft orders, 1× shaft_0 to 2× shaft_6", "20× shaft_0"}
    assert sum(t.line.dash == "dash" for t in figure.data) == 15, "all lines are drawn"


def test_every_share_of_the_strain_energy_is_in_the_map() -> None:
    """Long names are folded; eleven equal parts."""
    parts = [f"mesh sun-planet_{k}" for k in range(11)]
    share = np.array([np.full(11, 1.0 / 11.0), np.eye(11)[10], np.eye(11)[0]])
    names = ["1st translational mode of planetary stage set (a)", "mesh mode", "rigid rotation"]
    figure = plot_modes(names, [1405.0, 5264.0, 0.0], parts, share)
    assert list(figure.layout.yaxis.ticktext) == [
        "1: 1st translational mode of planetary stage<br>set (a), 1405 Hz",
        "2: mesh mode, 5264 Hz",
        "3: rigid rotation, 0 Hz",
    ]
    cells = figure.data[0]
    assert [row[0] for row in cells.customdata] == parts[:1] * 3
    np.testing.assert_allclose(np.sum(cells.z, axis=1), 100.0)
    assert list(cells.text[1]) == [""] * 10 + ["100"]


def test_components_with_little_energy_are_one_column() -> None:
    share = np.full((2, 40), 0.6 / 39.0)
    share[:, 7] = 0.4
    cells = plot_modes(["a", "b"], [1.0, 2.0], [f"bearing {k}" for k in range(40)], share).data[0]
    assert list(cells.customdata[0]) == ["bearing 7", "others"]
    np.testing.assert_allclose(cells.z, [[40.0, 60.0]] * 2)


def test_every_rank_of_close_critical_speeds_is_shown() -> None:
    """Circles a few pixels apart: the first twelve keep their numbers, clear of each other and of circles."""
    modes = {f"bending {k}": 400.0 + 6.0 * k for k in range(4)} | {"mesh mode": 1200.0, "torsion": 1210.0}
    orders = {"1× a": (8.0, "shaft"), "mesh a": (20.0, "mesh"), "mesh b": (20.5, "mesh")}
    figure = plot_campbell(campbell(modes, orders))
    critical = next(t for t in figure.data if t.name == "critical speeds")
    led = [a for a in figure.layout.annotations if a.x != 1 and a.text and a.textangle is None]
    assert sorted(map(int, [t for t in critical.text if t] + [a.text for a in led])) == list(range(1, 13))
    scale = np.array([560.0, ROOM])
    low = np.array([figure.layout.xaxis.range[0], figure.layout.yaxis.range[0]])
    span = np.array([figure.layout.xaxis.range[1], figure.layout.yaxis.range[1]]) - low
    places = np.array([(np.array([a.x, a.y]) - low) / span * scale + (a.ax, -a.ay) for a in led])
    circles = (np.column_stack([critical.x, critical.y]) - low) / span * scale
    assert len(led) > 6
    for k, place in enumerate(places):
        for others in (circles, np.delete(places, k, axis=0)):
            assert np.abs(others - place).max(axis=1).min() >= 13.0 - 1e-6


def test_a_campbell_diagram_shows_the_speeds_of_the_data() -> None:
    data = campbell({"high": 2000.0}).isel(speed=slice(10, None))
    assert plot_campbell(data).layout.xaxis.range[0] == pytest.approx(200.0 * 30.0 / np.pi)


def test_orders_outside_a_campbell_diagram_are_omitted() -> None:
    orders = {"low": (1.0, "shaft"), "mesh stage": (50.0, "mesh"), "mesh stage + 1× low": (51.0, "sideband")}
    figure = plot_campbell(campbell({"high": 2000.0}, orders), frequency=(1500.0, 2100.0))
    assert not any("low" == a.text for a in figure.layout.annotations)
    lines = [t for t in figure.data if t.line.dash in ("dash", "dot")]
    assert [t.legendgroup for t in lines] == ["orders", "sidebands"]
    assert min(min(t.y) for t in lines) >= 1500.0


def test_campbell_marks_critical_speeds_by_rank_and_the_operating_speed() -> None:
    orders = {"mesh a": (20.0, "mesh"), "2× mesh a": (40.0, "mesh"), "mesh a + 1× b": (21.0, "sideband")}
    figure = plot_campbell(campbell({"1st bending of b (forward)": 1000.0}, orders, operating=(200.0, 250.0)))
    assert figure.layout.xaxis.title.text == "speed of driver [rpm]"
    assert figure.layout.yaxis.title.text == "frequency [Hz]"
    critical = next(t for t in figure.data if t.name == "critical speeds")
    assert list(critical.x) == pytest.approx(
        [3000.0, 1500.0]
    )  # that of the sideband belongs to its mesh order
    assert list(critical.text) == ["1", "2"]
    assert figure.data[0].legendgroup != "forward whirl"
    assert any(t.legendgroup == "forward whirl" for t in figure.data)
    assert figure.layout.shapes[0].x1 == pytest.approx(250.0 * 30.0 / np.pi)


def test_the_legend_names_only_modes_in_the_plot() -> None:
    """A torsional mode above the range, and a diagram without whirl."""
    whirl = {"bending 1 of shaft (forward)": 110.0, "bending 1 of shaft (backward)": 90.0}
    orders = {"1× shaft": (1.0, "shaft")}

    def legend(modes: dict[str, float], highest: float) -> set[str]:
        lines = plot_campbell(campbell(modes, orders), frequency=(0.0, highest)).data
        return {
            x.name for x in lines if x.showlegend is not False and ("mode" in x.name or "whirl" in x.name)
        }

    assert legend({**whirl, "torsion of shaft": 900.0}, 1000.0) == {
        "forward whirl",
        "backward whirl",
        "other modes",
    }
    assert legend({**whirl, "torsion of shaft": 900.0}, 200.0) == {"forward whirl", "backward whirl"}
    assert legend({"torsion of shaft": 900.0}, 1000.0) == {"modes"}


def test_the_table_has_the_critical_speed_that_the_summary_names() -> None:
    """Orders 2 to 30 of a mode at 100 Hz; rank 19 is 0.5 % above the operating speed, 18 within 10 %."""
    crossing = 2.0 * np.pi * 100.0 / 20.0
    data = campbell(
        {"bending": 100.0},
        {f"{k}× shaft": (float(k), "shaft") for k in range(2, 31)},
        operating=(crossing / 1.005, crossing / 1.005),
    )
    words = "".join(summary_section((), ReportResults(campbells={"": data})).parts)
    assert (
        "Critical speeds close to the operating speed 298.5 rpm of driver: 315.8 rpm, 5.8 % above (" in words
    )
    assert "; 300 rpm, 0.5 % above (20× shaft, bending, response" in words
    table = "".join(str(part) for part in campbell_section({"": data}).parts)
    ranks = [int(r) for r in re.findall(r'<th scope="row" class="short">(\d+)</th>', table)]
    assert ranks == [*range(1, 13), 18, 19]
    assert "20× shaft" in table.partition('<th scope="row" class="short">19</th>')[2]
    assert "15 more in the result" in table
