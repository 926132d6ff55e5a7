# SPDX-License-Identifier: Apache-2.0
"""Start of machines with actuators that position a spin: the angle at which they carry the load."""

from __future__ import annotations

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.solvers.initial_state.start import prepare_start

MODEL = """
bodies:
  hub: {{motion: torsion, inertia: 2 kg m^2, position: [0, 0, 0]}}
  blade: {{mass: 1 kg, inertia: 0.5 kg m^2, transverse_inertia: 0.5 kg m^2, position: [0, 0, 0.2],
    axes: {{z: [1, 0, 0], x: [0, 0, 1]}}}}
joints: {{pitch: {{type: revolute, bodies: [hub, blade], axes: {{z: [1, 0, 0], x: [0, 0, 1]}}}}}}
sensors:
  angle: {{type: joint, coordinate: pitch.spin}}
  speed: {{type: joint, coordinate: pitch.spin, derivative: 1}}
{more}
blocks:
  torque: {{{torque}}}
{blocks}
actuators: {{servo: {{type: torque, signal: torque, bodies: [blade, hub]}}}}
loads: {{air: {{body: blade, reaction: hub, torque: 12 N m}}}}
scenarios: {{run: {{speed: {{{speeds}}}, duration: 0.1 s, step: 1 ms, method: adams}}}}
"""
LINEAR = "type: formula, formula: '40*(0.3 - angle) - 2*speed', inputs: [angle, speed]"


def start(torque: str = LINEAR, more: str = "", blocks: str = "", speeds: str = "hub: 5 rad/s"):
    """Start of the run, and the pitch angle there."""
    model = pp.load_model(text=MODEL.format(torque=torque, more=more, blocks=blocks, speeds=speeds))
    system = pp.compile_model(model, "run")
    found = prepare_start(system, system.scenario)
    return found, found.state.q[system.spin("blade")]


@pytest.mark.parametrize(
    "given",
    [
        {},
        {
            "torque": "type: limits, input: free, limits: [-30, 30]",
            "blocks": "  free: {" + LINEAR.replace(", inputs", ", unit: N m, inputs") + "}",
        },
        {"more": "  root: {type: load, at: blade, quantity: moment}"},
    ],
    ids=["linear", "limited", "with a sensor of loads"],
)
def test_a_servo_carries_its_load(given):
    """40 N m/rad about 0.3 rad, and 12 N m: 0.6 rad, where the hub rotates."""
    found, angle = start(**given)
    assert angle == pytest.approx(0.6, abs=1e-9)
    assert found.state.v[found.system.spin("hub")] == 5.0
    assert not any("net torque" in str(text) and "blade" in str(text) for text in found.notes)


@pytest.mark.parametrize(
    "torque",
    [
        "type: formula, formula: '-5*sin(angle)', inputs: [angle]",  # varies in a revolution
        "type: formula, formula: '40*angle', inputs: [angle]",  # drives the blade away
        "type: formula, formula: '-2*speed', inputs: [speed]",
    ],
)
def test_other_torques_do_not_position(torque):
    found, angle = start(torque)
    assert angle == 0.0
    assert any("net torque of 12 N m on blade" in str(text) for text in found.notes)


def test_a_spin_with_a_speed_rotates():
    found, angle = start(speeds="hub: 5 rad/s, blade: 1 rad/s")
    assert angle == 0.0 and found.state.v[found.system.spin("blade")] == pytest.approx(1.0)


def test_the_run_stays_there():
    model = pp.load_model(text=MODEL.format(torque=LINEAR, more="", blocks="", speeds="hub: 5 rad/s"))
    data = pp.solve_time(pp.compile_model(model, "run"))
    np.testing.assert_allclose(data["signal[angle]"], 0.6, atol=1e-9)


FILTERED = """
bodies: {{rotor: {{motion: torsion, inertia: 2 kg m^2}}}}
sensors: {{speed: {{type: joint, coordinate: rotor, derivative: 1}}}}
blocks:
  seen: {{type: filter, input: speed, time_constant: 0.1 s}}
  error: {{type: sum, inputs: {{seen: -1}}, offset: 5}}
  wanted: {{type: pid, input: error, proportional: 3, integral: 2}}
  least: {{type: formula, formula: "max(wanted, 0)", inputs: [wanted]}}
  lag: {{type: {lag}, input: least, time_constant: 50 ms{rate}}}
  torque: {{type: formula, formula: "lag^2", inputs: [lag], unit: N m}}
actuators: {{motor: {{type: torque, signal: torque, bodies: [rotor]}}}}
loads: {{fan: {{body: rotor, torque: -9 N m}}}}
scenarios: {{run: {{speed: {{rotor: 5 rad/s}}, duration: 2 s, step: 5 ms, method: adams}}}}
"""


@pytest.mark.parametrize(("lag", "rate"), [("filter", ""), ("rate_limit", ", rate: 100")])
def test_an_integral_behind_a_filter_and_before_a_lag(lag, rate):
    """At 5 rad/s no state determines the integral: it starts at 3, where the torque is 9 N m, as it ends."""
    model = pp.load_model(text=FILTERED.format(lag=lag, rate=rate))
    data = pp.solve_time(pp.compile_model(model, "run"))
    np.testing.assert_allclose(data["speed[rotor]"], 5.0, atol=1e-7)
    np.testing.assert_allclose(data["signal[torque]"], 9.0, atol=1e-6)
