# SPDX-License-Identifier: Apache-2.0
"""Steady motion of a rigid train under pulsating loads, against its equation of motion solved by SciPy."""

from __future__ import annotations

import re

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pitchpoint.core.errors import split_notes
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.load_cycle import LoadCycle
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from tests.unit.solvers.test_mean_balance import INERTIA, RPM, begun, gearbox

MEAN = -500.0 * RPM
"""Speed of the driven gear; it turns backwards at a third of the speed of the driver."""


def integrated(start, load, time, **more):
    """Angle and speed of the driven gear from the start: J w' = load(t, angle, w) - 3 times the torque."""
    torque = 3.0 * float(start.system.records["torque"]["value"][0])
    speed = float(start.state.v[start.system.spin("driven")])
    # the gears turn in opposite senses: a positive torque on the driver drives the driven gear backwards

    def rates(t, y):
        return [y[1], (load(t, y[0], y[1]) - torque) / (9.0 * INERTIA)]

    return solve_ivp(
        rates, (0.0, time), [0.0, speed], method="DOP853", rtol=1e-10, atol=1e-10, dense_output=True, **more
    )


LOADS = {
    "a fan and a slow wave": (
        '"360*(speed/50)^2 + 30*sin(2*pi*2 Hz*t)"',
        lambda t, a, w: 360.0 * (w / 50.0) ** 2 + 30.0 * np.sin(4.0 * np.pi * t),
        0.5,
    ),
    "an order and a slow wave": (
        '"360*(1 + 0.2*sin(angle)) - 20*(1 - cos(2*pi*0.5 Hz*t))"',
        lambda t, a, w: 360.0 * (1.0 + 0.2 * np.sin(a)) - 20.0 * (1.0 - np.cos(np.pi * t)),
        6.0,
    ),
    "several orders and a fan": (
        '"200*(1 + 0.5*sin(3*angle) + 0.2*cos(angle/4)) + 400*(speed/50)^2"',
        lambda t, a, w: 200.0 * (1.0 + 0.5 * np.sin(3 * a) + 0.2 * np.cos(a / 4)) + 400.0 * (w / 50.0) ** 2,
        0.48,
    ),
    "a wave over eight revolutions": (
        '"100 + 90*sin(angle/8)"',
        lambda t, a, w: 100.0 + 90.0 * np.sin(a / 8.0),
        0.96,
    ),
    "a wave over 31 revolutions": (
        '"100 + 90*sin(angle/31)"',
        lambda t, a, w: 100.0 + 90.0 * np.sin(a / 31.0),
        3.72,
    ),
    "a falling characteristic": (
        '"100 + 40*sin(angle) + 2*speed"',
        lambda t, a, w: 100.0 + 40.0 * np.sin(a) + 2.0 * w,
        0.12,
    ),
}


@pytest.mark.parametrize("name", LOADS)
def test_a_rigid_train_returns_after_the_period_with_the_mean_speed_of_the_scenario(name):
    """Both from the speed of the start and the balancing torque alone. 2e-4: trapezoidal rule."""
    law, load, period = LOADS[name]
    start = begun(gearbox(law))
    assert start.cycle.steady
    assert start.cycle.period == pytest.approx(period, rel=1e-9)
    found = integrated(start, load, period)
    speeds = found.sol(np.linspace(0.0, period, 20001))[1]
    least, most = float(speeds.min()), float(speeds.max())
    assert found.y[0, -1] / period == pytest.approx(MEAN, rel=2e-4)
    assert found.y[1, -1] == pytest.approx(found.y[1, 0], abs=2e-3 * (most - least))
    spin = start.system.spin("driven")
    ripple = MEAN + np.array([start.cycle.lowest[spin], start.cycle.highest[spin]])
    np.testing.assert_allclose(ripple, [least, most], atol=2e-3 * (most - least))
    (note,) = start.notes
    said = re.search(r"for a mean speed of 1500 rpm \(rigid train: from (\S+) rpm to (\S+) rpm\)", note)
    told = -np.array([float(value) for value in said.groups()]) * RPM / 3.0
    np.testing.assert_allclose(told, [most, least], atol=2e-3 * (most - least))


def test_waves_without_a_common_period_leave_the_mean_speed_of_a_rigid_train():
    """20 N m at 23.7 Hz times order sqrt(2) beat at 12 Hz; 1 %: the mean over 5 s contains parts of waves."""
    start = begun(gearbox('"60*(1 + 0.4*sin(angle)^2) + 20*sin(2*pi*23.7 Hz*t)*cos(sqrt(2)*angle)"'))
    assert start.cycle.steady
    assert start.cycle.period == 0.0

    def load(t, a, w):
        return 60.0 * (1.0 + 0.4 * np.sin(a) ** 2) + 20.0 * np.sin(47.4 * np.pi * t) * np.cos(2.0**0.5 * a)

    for time in (1.0, 5.0):
        mean = integrated(start, load, time).y[0, -1] / time
        allowed = start.cycle.allowance(start.system.spin("driven"), time)
        assert abs(mean - MEAN) <= 1.05 * allowed
        assert allowed < 0.01 * abs(MEAN)
    assert "no common period; estimated error" in start.notes[0]


def test_a_run_under_a_fan_and_a_slow_wave_keeps_the_mean_speed():
    text = gearbox(LOADS["a fan and a slow wave"][0]).replace("0.24 s", "0.5 s")
    found = solve_time(compile_model(loads_model(text), "run"))
    assert found["speed[driver]"].values[:-1].mean() == pytest.approx(1500.0 * RPM, rel=1e-4)
    (note,) = split_notes(found.attrs["notes"])
    assert note.startswith("in balances the mean torque of out over its period of 500 ms: driver starts at")


HEAVY = '"100 - 3000*sin(angle/31)"'


def test_without_a_steady_motion_the_note_says_when_the_loads_stop_the_train():
    """For its mean speed the train would have to pass the top of 186 kJ at 2e-11 rad/s."""
    start = begun(gearbox(HEAVY))
    assert not start.cycle.steady

    def load(t, a, w):
        return 100.0 - 3000.0 * np.sin(a / 31.0)

    def still(t, y):
        return y[1]

    still.terminal = True
    assert start.state.v[start.system.spin("driver")] == pytest.approx(1500.0 * RPM)
    found = integrated(start, load, 3.72, events=still)
    assert start.cycle.stops == {"driven": pytest.approx(found.t[-1], abs=2.0 * 3.72 / 4096)}
    assert "no steady motion under these loads was found" in start.notes[1]
    said = re.search(r"started at constant speed, would stop driven after (\S+) ms", start.notes[1])
    assert float(said.group(1)) == pytest.approx(1e3 * found.t[-1], abs=2.0)


def test_a_run_without_a_steady_motion_says_so():
    """Momentum over time, reduced to the driver, is the net torque that changed the speed."""
    found = solve_time(compile_model(loads_model(gearbox(HEAVY)), "run"))
    (said,) = [note for note in split_notes(found.attrs["notes"]) if "of the scenario" in note]
    assert "no steady motion under the loads was found" in said
    last = float(found["speed[driver]"][-1])
    net = INERTIA * (last - 1500.0 * RPM) / 0.24
    assert f"net torque on driver {net:.3g} N m" in said
    assert f"{last / RPM:.4g} rpm at the end" in said


def test_the_mean_over_a_window_deviates_by_the_part_of_a_wave_it_contains():
    """A sine of amplitude A and period T: 2 A/w over the window, T/(pi window) of A, and A for none."""
    rates = 2.0 * np.pi / 0.1
    one = np.array([3.0])
    cycle = LoadCycle({}, 0.1, 0.1, 0.0, 0.0 * one, -one, one, 2.0 * one / rates)
    assert cycle.allowance(0, 0.5) == pytest.approx(3.0 * 0.1 / (np.pi * 0.5))
    assert cycle.allowance(0, 0.0) == 3.0


@pytest.mark.parametrize("wave", ["sin(angle)", "sin(sqrt(2)*angle)"])
def test_jumps_of_a_load_do_not_fall_on_points_in_every_wave(wave):
    """A sawtooth from 0 to 10 N m counts with 5 N m; the waves over the angle have zero mean: 65 N m."""
    start = begun(gearbox(f'"60 + 10*mod(64*t, 1) + 2*{wave}"'))
    torque = float(start.system.records["torque"]["value"][0])
    assert 3.0 * torque == pytest.approx(65.0, abs=3e-3)
