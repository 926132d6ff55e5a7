# SPDX-License-Identifier: Apache-2.0
"""Analyses of a sweep are those of the state at its lowest speed, with the loads of that speed."""

from __future__ import annotations

import math

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.cli.main import run_command
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.operating_range import speed_range
from pitchpoint.solvers.campbell import follow_modes
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.operating_point import operating_point
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.solvers.sweep_speeds import sweep_range
from pitchpoint.sweep.speed import plan_sweep
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model

RPM = math.pi / 30
RATIO = 24 / 49
LOWEST = 600.0 * RPM
FAN = 60.0 * (LOWEST * RATIO / 77.0) ** 2
"""Torque of the fan at the lowest speed [N m]."""


def gearbox(wave: str = "1", drive: str = "") -> str:
    gear = "normal_module: 2 mm, face_width: 20 mm"
    law = f"60 N m*(speed/(77 rad/s))^2*{wave}"
    # 24 teeth: 240 Hz at 600 rpm
    swept = "body: i, points: 3, settle_periods: 100, measure_periods: 49"
    return f"""
gears:
  p: {{number_of_teeth: 24, {gear}, profile_shift_coefficient: 0.2}}
  w: {{number_of_teeth: 49, {gear}, profile_shift_coefficient: 0}}
bodies:
  i: {{gears: [p], inertia: 2.0e-3 kg m^2}}
  o: {{gears: [w], inertia: 4.0e-2 kg m^2}}
meshes:
  stage:
    gears: [p, w]
    center_distance: 73.5 mm
    stiffness: {{law: hertz}}
    damper: {{value: 2000 N s/m}}
loads:
  d: {{body: i, torque: balance}}
  fan: {{body: o, torque: "{law}"}}
scenarios:
  sw: {{sweep: {{{swept}, speed: [600 rpm, 1800 rpm]}}{drive}}}
  hz: {{sweep: {{{swept}, mesh_frequency: [240 Hz, 720 Hz]}}}}
  st: {{speed: {{i: 600 rpm}}, duration: 1 s}}
"""


def compiled(name: str, **more: str) -> tuple[pp.Model, pp.System]:
    model = loads_model(gearbox(**more))
    return model, compile_model(model, name)


def test_one_range_for_all_callers() -> None:
    """240 Hz to 720 Hz with 24 teeth are 600 rpm to 1800 rpm."""
    for name in ("sw", "hz"):
        model, system = compiled(name)
        scenario = model.scenarios[name]
        wanted = (LOWEST, 3.0 * LOWEST)
        assert sweep_range(system, scenario) == pytest.approx(wanted, rel=1e-12)
        assert plan_sweep(system, scenario).speeds[[0, -1]] == pytest.approx(wanted, rel=1e-12)
        assert speed_range(system, scenario, "i") == pytest.approx(wanted, rel=1e-12)


@pytest.mark.parametrize("name", ["sw", "hz"])
def test_the_operating_point_of_a_sweep_has_the_loads_of_its_lowest_speed(name: str) -> None:
    _, system = compiled(name)
    point = operating_point(system, name)
    row = evaluate.observe(point.system, point.state)
    value = {c.name: row[k] for k, c in enumerate(system.layout.channels)}
    assert value["speed[i]"] == pytest.approx(LOWEST, rel=1e-12)
    assert value["torque[fan]"] == pytest.approx(FAN, rel=1e-12)
    assert value["torque[d]"] == pytest.approx(FAN * RATIO, rel=1e-9)
    assert value["mesh_force[stage]"] == pytest.approx(FAN / (0.049 * math.cos(math.radians(20.0))), rel=1e-9)
    assert "state at 600 rpm of i, the lowest speed of the sweep" in point.notes


def test_a_ripple_of_the_swept_body_does_not_change_its_mean_speed() -> None:
    """Two waves of 1 % each begin at their highest speed, 0.5 % above the mean."""
    _, system = compiled("sw", drive=", drive: {i: {ripple: {two: {order: 2, fluctuation: 1 %}}}}")
    point = operating_point(system, "sw")
    assert point.state.v[system.spin("i")] == pytest.approx(1.005 * LOWEST, rel=1e-9)


def test_modes_and_campbell_diagram_of_a_sweep_are_those_of_its_lowest_speed() -> None:
    """The stiffness of Hertz contact grows with the load, so the mesh mode shows it."""
    found = {}
    for name in ("sw", "st"):
        _, system = compiled(name)
        modes = find_modes(system, name)
        lines = follow_modes(system, [0.0, 2.0 * LOWEST], "i", name)
        assert not [note for note in modes.notes if "no load" in note]
        at = "state at 600 rpm of i, the lowest speed of the sweep"
        assert (at in modes.notes) == (at in lines.notes) == (name == "sw")
        found[name] = np.concatenate([modes.damped_frequency, modes.damping_ratio, lines.frequency.ravel()])
    assert found["sw"] == pytest.approx(found["st"], rel=1e-9, nan_ok=True)


def test_a_slow_roll_keeps_torques_over_angle_and_speed() -> None:
    """At 600 rpm, over the angle of the output: the wave, but not at zero speed."""
    _, system = compiled("st", wave="(1 + 0.1*cos(5*angle))")
    roll = roll_through(system, "st", 8, 5, mesh="stage")
    torque, angle = (roll.rows[:, system.layout.channel(f"{n}")] for n in ("torque[fan]", "angle[o]"))
    assert torque == pytest.approx(FAN * (1.0 + 0.1 * np.cos(5.0 * angle)), rel=1e-5)
    assert np.ptp(torque) > 0.1 * FAN


def test_the_report_of_a_sweep_says_which_state_it_shows(tmp_path) -> None:
    path, page = tmp_path / "model.yaml", tmp_path / "page.html"
    text = gearbox(wave="(1 + 0.1*cos(5*angle))")
    path.write_text("\n".join(row for row in text.splitlines() if not row.startswith("  st:")), "utf-8")
    assert run_command(["report", str(path), "-o", str(page)]) == 0
    html = page.read_text("utf-8")
    assert "carries no load" not in html
    assert "the slow roll has the loads at 600 rpm of i, the lowest speed of the sweep." in html
    assert "loaded state of scenario sw at 600 rpm of i, the lowest speed of the sweep, with mean" in html
