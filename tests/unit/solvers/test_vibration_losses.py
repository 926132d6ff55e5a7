# SPDX-License-Identifier: Apache-2.0
"""Flank friction of vibrating teeth: the balancing torque includes it, and the mean speed holds."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.time import run_time, solve_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.solvers.vibration_losses import with_vibration_losses
from pitchpoint.system.compile import compile_model
from tests.unit.solvers.test_mean_balance import FRICTION, INERTIA, gearbox

LAW = "{law: din3990, tip_relief_factor: 0.3}"


def torques(text):
    """Balancing torque of slow rotation and that of the run, the start of the latter, scenario and system."""
    model = loads_model(text)
    scenario = model.scenarios["run"]
    system = compile_model(model, scenario)
    slow = prepare_start(system, scenario)
    start = with_vibration_losses(slow, scenario, run_time)
    return (*(float(s.system.records["torque"]["value"][0]) for s in (slow, start)), start, scenario, system)


def drift(system, scenario, start):
    """Slope of the speed of the driver [rad/s^2], from its means over whole mesh cycles of 2 ms."""
    memory = Memory()
    place = [system.layout.channel("speed[driver]")]
    run_time(system, replace(scenario, sample_rate=None), sink=memory, start=start, channels=place)
    speed = np.concatenate(memory.rows)[:-1, 0].reshape(-1, 100).mean(axis=1)[20:]
    return float(np.polyfit(np.arange(speed.size) * 2e-3, speed, 1)[0])


@pytest.mark.parametrize("load", ["100 N m", "-100 N m"])
def test_the_mean_speed_of_a_train_with_friction_holds(load):
    """The slope of slow rotation is the torque that vibration adds; with it 5 % of the slope are left."""
    slow, found, start, scenario, system = torques(gearbox(load, LAW, FRICTION))
    left = drift(system, scenario, start)
    before = drift(system, scenario, prepare_start(system, scenario))
    assert abs(INERTIA * before) > 1e-4
    assert found - slow == pytest.approx(-INERTIA * before, rel=0.05)
    assert abs(left) < 0.05 * abs(before)


def test_pulsating_loads_do_not_disturb_the_measurement():
    plain = torques(gearbox("100 N m", LAW, FRICTION))
    wave = torques(gearbox('"100*(1 + 0.3*sin(2*angle))"', LAW, FRICTION))
    assert wave[1] - wave[0] == pytest.approx(plain[1] - plain[0], rel=0.05)


SAME = {
    "no friction": gearbox("100 N m", LAW),
    "a short run": gearbox("100 N m", LAW, FRICTION).replace("duration: 0.24 s", "duration: 0.05 s"),
    "a drive": gearbox("100 N m", LAW, FRICTION, more=", drive: {driven: {speed: -500 rpm}}"),
}


@pytest.mark.parametrize("name", SAME)
def test_torques_of_other_runs_are_unchanged(name):
    slow, found, *_ = torques(SAME[name])
    assert found == slow


def test_a_run_uses_the_corrected_torque():
    text = gearbox("100 N m", LAW, FRICTION)
    found = solve_time(compile_model(loads_model(text), "run"))["torque[in]"].values
    assert found[0] == pytest.approx(torques(text)[1], rel=1e-12)
    assert float(np.ptp(found)) == 0.0
