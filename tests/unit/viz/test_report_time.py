# SPDX-License-Identifier: Apache-2.0
"""Curves by meaning, bearing forces and variants of a report, against numbers known in advance."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from pitchpoint.viz.quantities import Channel
from pitchpoint.viz.report.bearing_forces import bearing_forces, bearing_table, with_resultants
from pitchpoint.viz.report.build import TimeRun
from pitchpoint.viz.report.compare import compare_section
from pitchpoint.viz.report.time import distinct, time_section
from pitchpoint.viz.signals_plot import signal_rows

TIME = np.linspace(0.0, 1.0, 1001)
WAVE = np.sin(2.0 * np.pi * 10.0 * TIME)


def named(values: dict[str, tuple[Any, str]]) -> dict[str, Channel]:
    return {n: Channel(n, np.broadcast_to(v, TIME.shape).astype(float), u) for n, (v, u) in values.items()}


def test_a_steady_force_has_its_direction_and_a_rotating_one_none() -> None:
    """3-4-5 triangle with 10 % ripple; a rotating force of 7 N; the axial force is that of fz."""
    found = with_resultants(
        named(
            {
                "bearing_force[a.fx]": (-3.0 * (1.0 + 0.1 * WAVE), "N"),
                "bearing_force[a.fy]": (4.0 * (1.0 + 0.1 * WAVE), "N"),
                "bearing_force[a.fz]": (-2.0 + WAVE, "N"),
                "bearing_force[b.fx]": (7.0 * np.cos(2.0 * np.pi * TIME), "N"),
                "bearing_force[b.fy]": (7.0 * np.sin(2.0 * np.pi * TIME), "N"),
                "bearing_force[b.mx]": (0.3, "N m"),
                "bearing_force[b.my]": (0.4, "N m"),
                "bearing_force[idle.fx]": (0.0, "N"),
                "bearing_force[idle.fy]": (0.0, "N"),
            }
        )
    )
    rows = bearing_forces(TIME, found, TIME >= 0.0)
    assert list(rows) == ["a", "b"]
    a, b = rows["a"], rows["b"]
    assert (a.mean, a.maximum) == (pytest.approx(5.0, rel=1e-3), pytest.approx(5.5, rel=1e-3))
    assert a.rms == pytest.approx(0.5 / np.sqrt(2.0), rel=1e-3)
    assert np.degrees(a.direction) == pytest.approx(126.87, abs=0.01)
    assert (a.axial_mean, a.axial_maximum) == (pytest.approx(-2.0, abs=2e-3), pytest.approx(3.0, rel=1e-3))
    assert np.isnan(b.direction) and b.moment == pytest.approx(0.5)
    table = bearing_table(rows)
    assert ">127<" in table and ">rotates<" in table and "<b>b</b>" in table
    assert "Largest radial force: 7 N, b." in table
    assert bearing_table({}) == ""


def test_rigidly_geared_speeds_are_one_curve_with_its_ratio() -> None:
    run_up = 100.0 * TIME
    found = named(
        {
            "speed[in]": (run_up, "rad/s"),
            "speed[out]": (-0.25 * run_up, "rad/s"),
            "speed[other]": (run_up + 20.0 * WAVE, "rad/s"),
            "speed[fan]": (10.0, "rad/s"),
        }
    )
    drawn, constant, words = distinct(list(found.values()))
    assert [c.name for c in drawn] == ["speed[in]", "speed[other]"]
    assert constant == ["speed, fan: 95.49 rpm"]
    text = " ".join(words)
    assert "Equal curves are drawn once: out as in times −0.25." in text


def test_forces_are_equal_only_with_the_factor_one_and_many_are_cut() -> None:
    forces = named({f"mesh_force[{k}]": (WAVE * (1.0 + k), "N") for k in range(12)})
    drawn, _, words = distinct(list(forces.values()))
    assert [c.name for c in drawn] == [f"mesh_force[{k}]" for k in range(4, 12)]
    assert "4 more channels are in the result." in " ".join(words)
    mirrored = named({"mesh_force[l]": (WAVE, "N"), "mesh_force[r]": (-WAVE, "N")})
    assert len(distinct(list(mirrored.values()))[0]) == 1


def test_a_slow_output_has_its_own_axis() -> None:
    found = named({"speed[in]": (740.0 * TIME, "rad/s"), "speed[out]": (-5.4 * TIME + 0.1 * WAVE, "rad/s")})
    assert signal_rows(list(found.values())) == [[0], [1]]


def test_groups_set_titles_and_round_off_is_not_drawn() -> None:
    data = {"time": TIME} | named(
        {
            "bearing_force[a.fx]": (300.0 + WAVE, "N"),
            "bearing_force[a.fy]": (0.0, "N"),
            "bearing_force[a.fz]": (1e-8 * WAVE, "N"),
        }
    )
    groups = [("Bearings", ["bearing_force[a.radial]", "bearing_force[a.axial]"])]
    html = "".join(time_section({"r": TimeRun(data=data, groups=groups)}).parts)
    assert "<h4>Bearings</h4>" in html and "<h4>Bearing forces</h4>" in html
    assert html.count('<div class="plot"') == 1  # ten periods: no magnified end
    assert "axial" not in html


@pytest.mark.parametrize(("radial", "axial"), [(300.0, 0.1), (0.1, 300.0)])
def test_the_larger_component_of_bearing_forces_is_drawn_first(radial: float, axial: float) -> None:
    """Whatever the order of the channels; other quantities stay where they are."""
    data = {"time": TIME} | named(
        {
            "mesh_force[s]": (10.0 + WAVE, "N"),
            "bearing_force[a.axial]": (axial * (1.0 + WAVE), "N"),
            "bearing_force[a.radial]": (radial * (1.0 + 0.1 * WAVE), "N"),
        }
    )
    groups = [("", ["mesh_force[s]", "bearing_force[a.axial]", "bearing_force[a.radial]"])]
    figures = time_section({"r": TimeRun(data=data, groups=groups)}).figures
    names = [figure.data[0].name for figure in figures.values()]
    words = ["axial bearing force, a", "radial bearing force, a"]
    assert names == ["mesh force, s", *(words if axial > radial else words[::-1])]


def test_variants_share_a_picture_and_equal_curves_are_said() -> None:
    runs = {
        gap: TimeRun(
            data={"time": TIME}
            | named({"mesh_force[s]": (size * WAVE, "N"), "transmission_error[s]": (1e-6 * WAVE, "m")})
        )
        for gap, size in (("0.1 mm", 1.0), ("0.2 mm", 2.0))
    }
    results = SimpleNamespace(runs=runs, sweeps={})
    html = "".join(compare_section([("steady", {gap: gap for gap in runs})], results).parts)
    assert html.count('<div class="plot"') == 2  # the force over time, and its spectrum
    assert "0.1 mm" in html and "Equal in all results: transmission error, s." in html
