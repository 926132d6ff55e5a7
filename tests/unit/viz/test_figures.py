# SPDX-License-Identifier: Apache-2.0
"""Every plot function: the traces it should have, units in the axis titles, colours that mean something."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from pitchpoint.analysis.orders import order_map
from pitchpoint.analysis.spectra import amplitude_spectrum
from pitchpoint.analysis.time_frequency import time_frequency_map
from pitchpoint.viz import theme
from pitchpoint.viz.mesh_cycle_plot import plot_load_sharing, plot_mesh_stiffness, plot_transmission_error
from pitchpoint.viz.quantities import Channel, channels, number, scale
from pitchpoint.viz.report.build import TimeRun
from pitchpoint.viz.report.spectra import spectrum_section
from pitchpoint.viz.signals_plot import plot_force_parts, plot_signals
from pitchpoint.viz.spectrum_plots import Shafts, plot_order_map, plot_spectrum, plot_time_frequency
from pitchpoint.viz.sweep_plot import plot_contact_shares, plot_sweep
from pitchpoint.viz.tables import quantity_table
from tests.support.report_data import cycle, sweep

TIME = np.arange(20_000) / 1e5


def titles(figure: object) -> tuple[str, str]:
    return figure.layout.xaxis.title.text, figure.layout.yaxis.title.text  # type: ignore[attr-defined]


def test_mesh_stiffness_over_two_cycles() -> None:
    figure = plot_mesh_stiffness(cycle(), name="stage")
    assert titles(figure) == ("mesh phase ψ [base pitches]", "mesh stiffness [c′·b]")
    assert figure.data[0].x[0] == 0.0
    assert figure.data[0].x[-1] == 2.0
    assert figure.data[1].name == "mean 1.2"


def test_transmission_error_in_micrometres() -> None:
    phase = np.linspace(0.0, 1.0, 11)
    figure = plot_transmission_error(
        phase, {"unloaded": 2e-6 * phase * (1 - phase), "loaded": 5e-6 + 0 * phase}
    )
    assert titles(figure)[1] == "transmission error<br>− mean [µm]"
    assert [t.name for t in figure.data] == ["unloaded (mean 0.3 µm)", "loaded (mean 5 µm)"]
    assert max(figure.data[0].y) == pytest.approx(0.2)
    assert max(figure.data[1].y) == pytest.approx(0.0)


def test_longer_curves_are_drawn_once() -> None:
    phase = np.linspace(0.0, 3.0, 31)
    figure = plot_transmission_error(phase, {"loaded": 1e-6 * np.sin(2 * np.pi * phase / 3)}, cycles=3)
    assert list(figure.data[0].x) == list(phase)
    once = plot_transmission_error([0.0, 0.5, 1.0], {"loaded": [0.0, 1e-6, 2e-6]}, cycles=1)
    assert list(once.data[0].x) == [0.0, 0.5, 1.0]
    law = plot_mesh_stiffness(cycle(), loaded=(phase, np.ones(31)), cycles=3)
    assert law.data[0].x[-1] == law.data[1].x[-1] == 3.0


def test_load_sharing_in_per_cent() -> None:
    figure = plot_load_sharing([0.0, 0.5, 1.5], [0.5, 1.0, 0.5])
    assert titles(figure)[1] == "load share [%]"
    assert list(figure.data[0].y) == [50.0, 100.0, 50.0]


def test_signals_keep_peaks_and_show_units() -> None:
    force = 1e4 * np.ones(TIME.size)
    force[7777] = 9e4
    figure = plot_signals(TIME, [Channel("mesh_force[stage]", force, "N", "mesh force")], points=500)
    assert titles(figure) == ("time [ms]", "mesh force [kN]")
    assert max(figure.data[0].y) == pytest.approx(90.0)
    assert len(figure.data[0].x) <= 500


def test_contact_is_shaded_unless_it_cannot_be_told_apart() -> None:
    channel = Channel("mesh_force[stage]", np.ones(TIME.size), "N")
    state = np.where(TIME < 0.1, 1.0, 0.0)
    state[-100:] = -1.0
    names = [t.name for t in plot_signals(TIME, [channel], contact_state=state).data]
    assert names == ["mesh force, stage", "separated", "back flank"]
    rattling = np.where(np.arange(TIME.size) % 10 < 5, 1.0, 0.0)
    assert len(plot_signals(TIME, [channel], contact_state=rattling).data) == 1


def speeds() -> list[Channel]:
    ripple = np.sin(2 * np.pi * 500 * TIME)
    values = (345.0 + ripple, -345.0 + ripple, 345.5 + ripple)
    return [Channel(f"speed[{name}]", v, "rad/s") for name, v in zip("abc", values, strict=True)]


def test_lines_far_apart_have_axes_of_their_own() -> None:
    """Two shafts at ±3300 rpm with a ripple of ±10 rpm: each axis shows its ripple."""
    figure = plot_signals(TIME, speeds())
    assert [t.yaxis for t in figure.data] == ["y", "y", "y2"]
    assert [t.name for t in figure.data] == ["speed, a", "speed, c", "speed, b"]
    upper, lower = figure.layout.yaxis.domain, figure.layout.yaxis2.domain
    assert 0.0 <= lower[0] < lower[1] < upper[0] < upper[1] <= 1.0
    assert figure.layout.xaxis.anchor == "y2"
    assert figure.layout.yaxis2.title.text == "[rpm]"
    assert not figure.layout.showlegend
    names = [a.text for a in figure.layout.annotations]
    assert "speed, a" in names[0]
    assert "speed, c" in names[0]
    assert "speed, b" in names[1]


def test_lines_that_overlap_share_an_axis_and_are_named_above_it() -> None:
    figure = plot_signals(TIME, [speeds()[0], speeds()[2]])
    assert {t.yaxis for t in figure.data} == {"y"}
    assert titles(figure)[1] == "speed [rpm]"
    assert theme.SERIES[0] in figure.layout.annotations[0].text


def test_names_of_many_lines_have_room_above_them() -> None:
    names = [f"displacement[a_shaft_with_a_long_name_{k}.rx]" for k in range(8)]
    many = [Channel(name, np.sin(300 * TIME + k), "rad") for k, name in enumerate(names)]
    for half, count in ((False, 4), (True, 8)):
        figure = plot_signals(TIME, many, half=half)
        (head,) = figure.layout.annotations
        lines = head.text.count("<br>") + 1
        assert lines == count
        room = (1.0 - figure.layout.yaxis.domain[1]) * (figure.layout.height - 78)
        assert room >= 16 * lines


def test_tilts_are_shown_in_microradians_and_axes_without_powers_of_ten() -> None:
    figure = plot_signals(TIME, [Channel("displacement[a.rx]", 2e-5 * np.sin(300 * TIME), "rad")])
    assert titles(figure)[1] == "displacement [µrad]"
    assert figure.layout.yaxis.exponentformat == "none"
    assert figure.layout.separators == "."


def test_a_constant_with_round_off_is_drawn_as_constant() -> None:
    values = 3120.0 + 1e-9 * np.random.default_rng(0).normal(size=TIME.size)
    low, high = plot_signals(TIME, [Channel("speed[a]", values, "rad/s")]).layout.yaxis.range
    assert high - low > 1.0


def test_channels_of_different_units_do_not_share_an_axis() -> None:
    with pytest.raises(ValueError, match="one unit"):
        plot_signals(TIME, [Channel("a", TIME, "m"), Channel("b", TIME, "N")])
    with pytest.raises(ValueError, match="one or more"):
        plot_signals(TIME, [])


def test_force_parts_have_their_colours() -> None:
    parts = [Channel(f"{part}_force[stage]", TIME, "N") for part in theme.FORCE_PARTS]
    figure = plot_force_parts(TIME, parts)
    assert [t.line.color for t in figure.data] == list(theme.FORCE_PARTS.values())
    assert not set(theme.SERIES) & set(theme.FORCE_PARTS.values())


def test_spectrum_axes_and_labels() -> None:
    x = 3e-6 * np.sin(2 * np.pi * 1000 * TIME) + 1e-6 * np.sin(2 * np.pi * 4000 * TIME)
    figure = plot_spectrum({"u": amplitude_spectrum(x, 1e5)}, unit="m", quantity="deflection")
    assert titles(figure) == ("frequency [Hz]", "deflection [µm]")
    assert figure.layout.yaxis.type == "log"
    assert {a.text for a in figure.layout.annotations} == {"1000", "4000"}
    assert max(figure.data[0].y) == pytest.approx(3.0, rel=1e-5)


def test_numbers_at_peaks_do_not_overlap_in_a_narrow_plot() -> None:
    """Peaks of four digits a tenth of the axis apart; one of two plots on paper has an axis of 240 pixels."""
    hertz = (1230, 1630, 1800, 2085, 2500, 2960)
    x = sum((1.0 + 0.1 * k) * np.sin(2 * np.pi * f * TIME) for k, f in enumerate(hertz))
    figure = plot_spectrum({"": amplitude_spectrum(x, 1e5)}, unit="N", highest=3000.0)
    ends = []
    for a in figure.layout.annotations:
        at, wide = 240.0 * a.x / 3000.0, 6.2 * len(a.text)
        left = at - {"left": 0.0, "center": 0.5, "right": 1.0}[a.xanchor] * wide
        ends.append((left, left + wide))
    ends.sort()
    assert len(ends) >= 3 and ends[-1][1] <= 242.0
    assert all(b[0] >= a[1] + 3.0 for a, b in zip(ends, ends[1:], strict=False))
    # as many ticks as there is room for
    assert not figure.layout.xaxis.nticks


@pytest.mark.parametrize("way", [1.0, -1.0], ids=["up", "down"])
def test_mesh_frequencies_are_curves_with_names_in_a_map_over_time(way: float) -> None:
    """Chirps of two meshes: the named curves are on the ridges of the map, and the names apart."""
    speed = 20.0 + 1000.0 * (TIME if way > 0.0 else TIME[-1] - TIME)
    angle = 2 * np.pi * np.cumsum(speed) * 1e-5
    x = np.sin(10 * angle) + np.sin(11 * angle)
    data = time_frequency_map(x, 1e5, frame=1024, highest_frequency=3000.0)
    at = np.interp(data.time, TIME, speed)
    meshes = {"stage_1": 10.0 * at, "stage_2": 11.0 * at, "twin": 11.0 * at, "beyond": 400.0 * at}
    figure = plot_time_frequency(data, unit="N", meshes=meshes)
    curves = {t.name: t for t in figure.data if t.type == "scatter"}
    first = {"stage_1", "stage_2, twin"}
    assert set(curves) == first | {f"{k} × {name}" for k in (2, 3) for name in first}
    assert titles(figure) == ("time [ms]", "frequency [Hz]")
    # the ridge half-way through the map is at the curves
    cells = figure.data[0]
    column = np.asarray(cells.z, float)[:, len(cells.x) // 2]
    ridge = float(cells.y[int(column.argmax())])
    low, high = (float(np.interp(cells.x[len(cells.x) // 2], 1e3 * TIME, f * speed)) for f in (9.0, 12.0))
    assert low < ridge < high
    names = [a for a in figure.layout.annotations if a.name == "frequency"]
    assert [a.text for a in names] == list(curves)
    top = float(data.frequency[-1])
    for height in (260.0, 350.0):  # on paper and on the screen
        middles = []
        for a in names:
            middles.append(height * (1.0 - a.y / top) + a.ay)
            assert 7.0 <= middles[-1] <= height
            assert a.text not in first or a.xanchor == ("right" if way > 0.0 else "left")
        assert abs(middles[1] - middles[0]) >= 14.0


def test_maps_have_axes_with_units_and_no_more_cells_than_a_screen() -> None:
    angle = 2 * np.pi * (20 * TIME + 500 * TIME**2)
    x = np.sin(10 * angle)
    waterfall = plot_time_frequency(time_frequency_map(x, 1e5, frame=2048), unit="N", quantity="force")
    assert titles(waterfall) == ("time [ms]", "frequency [kHz]")
    cells = np.asarray(waterfall.data[0].z)
    assert cells.shape[0] <= 300
    assert cells.shape[1] <= 360
    assert cells.max() == 0
    orders = plot_order_map(order_map(x, angle, TIME, highest_order=20, revolutions=2), unit="N")
    assert titles(orders) == ("order [–]", "speed [rpm]")
    # lines of the shorter frames at the ends are wider
    column = np.asarray(orders.data[0].z, dtype=float).mean(axis=0)
    assert float(orders.data[0].x[column.argmax()]) == 10.0


def test_harmonics_of_a_mesh_are_named_in_an_order_map_where_there_is_room() -> None:
    angle = 2 * np.pi * (20 * TIME + 500 * TIME**2)
    data = order_map(np.sin(10 * angle), angle, TIME, highest_order=40, revolutions=2)
    meshes = {"stage": 10.0, "fast": 19.5}
    figure = plot_order_map(data, unit="N", shafts=Shafts("in", {}, meshes))
    assert sorted(line.x0 for line in figure.layout.shapes) == [10.0, 19.5, 20.0, 30.0, 39.0, 40.0]
    names = {a.text: a for a in figure.layout.annotations if a.name == "frequency"}
    assert {"stage", "fast", "3 × stage"} <= set(names)
    # below the name of the other mesh there is no line of text, so 2 x stage is not named
    assert "2 × stage" not in names
    assert {a.yshift for a in names.values()} == {0}


def test_a_record_over_time_is_not_called_a_run_up() -> None:
    """Speed with ripple: the caption speaks of time, and the axis ends with the orders of the mesh."""
    time = np.linspace(0.0, 4.0, 40_001)
    angle = 2 * np.pi * (10.0 * time - 0.4 * np.cos(4.0 * time))
    channels = {
        "angle[a]": ((("time",), angle, {"units": "rad"})),
        "mesh_force[m]": ((("time",), 100.0 * np.cos(20 * angle), {"units": "N"})),
    }
    data = xr.Dataset(channels, coords={"time": time})
    run = TimeRun(data=data, mesh_frequencies={"m": 200.0})
    section = spectrum_section({"": run}, 160.0, {"m": "a"}, ("mesh_force[m]",))
    html = "".join(section.parts)
    drawn = section.figures["order_map[mesh_force[m]]"]
    assert drawn.layout.yaxis.title.text == "time [s]"
    assert 60.0 < max(drawn.data[0].x) < 65.0
    assert "orders are vertical lines, also where the speed changes" in html
    assert "hyperbolas" not in html and "slower" not in html


def test_sweep_is_green_upwards_and_red_downwards() -> None:
    data = sweep()
    figure = plot_sweep(data["points"], data["jumps"])
    assert titles(figure) == ("mesh frequency [Hz]", "rms of deflection [µm]")
    assert [(t.name, t.line.color) for t in figure.data] == [
        ("speed up", theme.GREEN),
        ("speed down", theme.RED),
    ]
    arrows = [a for a in figure.layout.annotations if a.showarrow]
    assert [(a.x, a.arrowcolor) for a in arrows] == [(2350.0, theme.GREEN), (1750.0, theme.RED)]
    assert arrows[0].y > arrows[0].ay
    assert arrows[1].y < arrows[1].ay
    assert (
        titles(plot_sweep(data["points"], quantity="mesh_force", statistic="max"))[1]
        == "max of mesh force [N]"
    )


def test_contact_shares_without_back_contact_have_no_line_for_it() -> None:
    figure = plot_contact_shares(sweep()["points"])
    assert titles(figure)[1] == "share of time [%]"
    assert [t.name for t in figure.data] == ["contact loss, up", "contact loss, down"]
    assert max(figure.data[0].y) == pytest.approx(40.0)


def test_rows_of_one_letter_share_a_unit() -> None:
    text = quantity_table(("j_bt", "j_wt", "j_bn", "a_w"), {"m": {"j_bt": 7e-5, "j_wt": 2e-4, "a_w": 0.09}})
    assert text.count(">mm<") == 3
    assert ">0.07<" in text


def test_round_off_is_no_transmission_error() -> None:
    figure = plot_transmission_error([0.0, 0.5, 1.0], {"without load": [1e-13, 1e-13, 1e-13]})
    assert titles(figure)[1] == "transmission error<br>− mean [µm]"
    assert figure.data[0].name == "without load (mean 0 µm)"


def test_units_of_axes() -> None:
    assert scale("N m", [20.0]).title("torque") == "torque [N m]"
    assert scale("", [1.0]).title("share") == "share"
    assert scale("m", []).unit == "mm"
    assert scale("N", [float("nan")]).unit == "N"


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (1e-9, "1·10⁻⁹"),
        (999999.6, "1·10⁶"),
        (0.00012345678, "0.00012346"),
        (1200.0, "1200"),
        (float("inf"), "inf"),
    ],
)
def test_numbers_for_tables(value: float, shown: str) -> None:
    assert number(value) == shown


def test_channels_of_a_dataset() -> None:
    import xarray as xr

    data = xr.Dataset(
        {
            "mesh_force[stage]": (
                "time",
                np.ones(5),
                {"units": "N", "long_name": "mesh force", "symbol": "F"},
            ),
            "pair_force": (("time", "pair"), np.ones((5, 2))),
        },
        coords={"time": np.arange(5.0)},
    )
    time, found = channels(data)
    assert time.tolist() == [0.0, 1.0, 2.0, 3.0, 4.0]
    assert list(found) == ["mesh_force[stage]"]
    assert found["mesh_force[stage]"].unit == "N"
    assert found["mesh_force[stage]"].label == "mesh force, stage"
