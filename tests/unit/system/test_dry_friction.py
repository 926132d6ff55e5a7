# SPDX-License-Identifier: Apache-2.0
"""A brake whose capacity is a signal, against the clutch with the same capacity over time."""

from __future__ import annotations

import numpy as np
import pytest

import pitchpoint as pp

MODEL = """
bodies: {{rotor: {{motion: torsion, inertia: 3 kg m^2}}}}
loads: {{air: {{body: rotor, torque: {{table: [[0 s, 20 N m], [0.5 s, 20 N m], [0.7 s, -25 N m]]}}}}}}
{brake}
scenarios:
  run: {{start: assembled, speed: {{rotor: 6 rad/s}}, duration: 1 s, step: 0.2 ms, settle_time: 0 s,
    sample_rate: 200 Hz, method: {method}{inputs}}}
"""
CLUTCH = "clutches: {brake: {bodies: [rotor], capacity: {table: [[0 s, 0], [0.1 s, 0], [0.2 s, 80 N m]]}}}"
SIGNAL = """
sensors: {speed: {type: joint, coordinate: rotor, derivative: 1}}
blocks:
  command: {type: input}
  friction: {type: friction, input: speed}
  torque: {type: formula, formula: "80*command*friction", inputs: [command, friction], unit: N m}
actuators: {brake: {type: torque, signal: torque, bodies: [rotor]}}
"""
COURSE = ", inputs: {command: {points: [[0 s, 0], [0.1 s, 0], [0.2 s, 1]]}}"


def run(method: str, brake: str, inputs: str = ""):
    """Result of a run."""
    model = pp.load_model(text=MODEL.format(brake=brake, method=method, inputs=inputs))
    return pp.solve_time(pp.compile_model(model, "run"))


@pytest.mark.parametrize("method", ["dassl, tolerance: 1e-9", "generalized_alpha"])
def test_it_is_the_clutch_with_this_capacity(method):
    """Slip, standstill, and sticking while the load changes its sign."""
    one, other = run(method, CLUTCH), run(method, SIGNAL, COURSE)
    speed, torque = one["speed[rotor]"].values, one["torque[brake]"].values
    assert torque.min() == pytest.approx(-80.0, rel=1e-2) and abs(speed[-1]) < 1e-4
    assert torque[-1] == pytest.approx(25.0, rel=1e-2)
    np.testing.assert_allclose(other["speed[rotor]"], speed, atol=1e-7)
    np.testing.assert_allclose(other["signal[torque]"], torque, atol=1e-4)


def test_friction_at_equal_speeds_except_for_rounding_sticks_from_the_start():
    """Against a belt at 0.3 rad/s, with 3*0.1 - 0.3 = 6e-17: a rounding error does not make 80 N m."""
    belt = "slip: {type: formula, formula: 3*speed - 0.3, inputs: [speed]}"
    signal = SIGNAL.replace(
        "friction: {type: friction, input: speed}", f"{belt}\n  friction: {{type: friction, input: slip}}"
    )
    text = MODEL.format(brake=signal, method="generalized_alpha", inputs=", inputs: {command: {value: 1}}")
    model = pp.load_model(text=text.replace("6 rad/s", "0.1 rad/s"))
    found = pp.solve_time(pp.compile_model(model, "run"))
    assert 3.0 * 0.1 - 0.3 != 0.0
    assert abs(float(found["signal[torque]"][0])) < 1e-6


def test_a_brake_closed_on_a_rotating_machine_slips_from_the_start():
    """Assembled at 6 rad/s with 20 - 80 N m on 3 kg m^2: the capacity acts, without a damping peak."""
    closed = "clutches: {brake: {bodies: [rotor], capacity: 80 N m}}"
    slow = SIGNAL.replace("input: speed}", "input: speed, damping_time: 0.1 s}")
    for model, channel, inputs in (
        (SIGNAL, "signal[torque]", ", inputs: {command: {value: 1}}"),
        (slow, "signal[torque]", ", inputs: {command: {value: 1}}"),
        (closed, "torque[brake]", ""),
    ):
        found = run("generalized_alpha", model, inputs)
        assert found[channel].values[:10] == pytest.approx(-80.0, rel=1e-9)
        assert float(found["speed[rotor]"][10]) == pytest.approx(6.0 - 60.0 / 3.0 * 0.05, rel=1e-9)


def test_the_angle_at_the_capacity_must_be_positive():
    wrong = SIGNAL.replace("input: speed}", "input: speed, wind_up: 0}")
    with pytest.raises(pp.ModelError, match=r"blocks.friction.wind_up .*is not positive.*limit > 0"):
        run("generalized_alpha", wrong)
