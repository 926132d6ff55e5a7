# SPDX-License-Identifier: Apache-2.0
"""Inputs with courses by scenario, and lags with limited rate: closed forms, start, messages."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model

TEXT = """\
bodies: {rotor: {motion: torsion, inertia: 10 kg m^2}}
sensors: {speed: {type: joint, coordinate: rotor, derivative: 1}}
blocks:
  demand: {type: input, value: 40 N m, unit: N m}
  grid: {type: input, value: 1}
  torque: {type: rate_limit, input: demand, rate: 150, time_constant: 50 ms, start: 40 N m}
  fed: {type: formula, formula: "-torque*grid", inputs: [torque, grid], unit: N m}
  power: {type: formula, formula: "0.944*torque*speed*grid", inputs: [torque, speed, grid], unit: W}
actuators: {generator: {type: torque, signal: fed, bodies: [rotor]}}
loads: {air: {body: rotor, torque: 40 N m}}
scenarios:
  steady: {speed: {rotor: 100 rad/s}, duration: 0.1 s, step: 1 ms, settle_time: 0 s}
  up: {speed: {rotor: 100 rad/s}, duration: 1 s, step: 1 ms, settle_time: 0 s,
    inputs: {demand: {points: [[0 s, 40], [0.1 s, 40], [0.100001 s, 90]]}}}
  dip: {speed: {rotor: 100 rad/s}, duration: 1 s, step: 1 ms, settle_time: 0 s,
    inputs: {grid: {formula: "1 - 0.8*(min(max((t - 0.2)/1e-6, 0), 1) - min(max((t - 0.35)/1e-6, 0), 1))"}}}
  half: {start: assembled, speed: {rotor: 100 rad/s}, duration: 0.1 s, step: 1 ms, settle_time: 0 s,
    inputs: {grid: {value: 0.5}}}
"""


def solved(scenario, text=TEXT):
    data = solve_time(compile_model(loads_model(text), scenario))
    return data, data["time"].values


def test_values_of_the_model_and_of_the_scenario():
    data, _ = solved("steady")
    np.testing.assert_allclose(data["signal[torque]"], 40.0, rtol=1e-12)
    np.testing.assert_allclose(data["speed[rotor]"], 100.0, rtol=1e-12)
    np.testing.assert_allclose(data["signal[power]"], 0.944 * 4000.0, rtol=1e-12)
    assert "no steady state" not in data.attrs["notes"]
    assert (data["signal[torque]"].attrs["units"], data["signal[power]"].attrs["units"]) == ("N m", "W")
    data, t = solved("half")
    np.testing.assert_allclose(data["speed[rotor]"], 100.0 + 2.0 * t, rtol=1e-9)


def test_a_step_rises_at_the_largest_rate_and_then_exponentially():
    """y = y0 + R t up to R T below the demand, then exponentially with T: 43 % of the step is the ramp."""
    more = "sample_rate: 1 kHz, method: runge_kutta, tolerance: 1e-9"
    data, t = solved("up", TEXT.replace("1 s, step: 1 ms", f"1 s, {more}"))
    rate, lag, step = 150.0, 0.05, 50.0
    ramp = step / rate - lag
    s = np.maximum(t - 0.1, 0.0)
    exact = 40.0 + np.where(s < ramp, rate * s, step - rate * lag * np.exp(-(s - ramp) / lag))
    # the demand takes 1 us to rise, in which the ramp could rise by 150 uN m
    np.testing.assert_allclose(data["signal[torque]"], exact, atol=2e-4)
    assert np.diff(data["signal[torque]"]).max() == pytest.approx(rate * 1e-3, rel=1e-6)


def test_a_grid_fault_accelerates_the_rotor():
    data, t = solved("dip")
    gained = 40.0 * 0.8 * 0.15 / 10.0  # missing torque times duration over inertia
    assert data["speed[rotor]"].values[-1] == pytest.approx(100.0 + gained, abs=40.0 * 0.8 * 1e-3 / 10.0)
    inside = (t > 0.202) & (t < 0.348)
    np.testing.assert_allclose(data["signal[fed]"].values[inside], -8.0, rtol=1e-12)


def test_files_are_written_again_and_old_hashes_stay():
    model = loads_model(TEXT)
    assert loads_model(dump_model(model)) == model


@pytest.mark.parametrize(
    ("old", "new", "where", "words"),
    [
        ("{grid: {value", "{gird: {value", "scenarios.half.inputs.gird", "did you mean grid?"),
        ("{grid: {value", "{power: {value", "scenarios.half.inputs.power", "inputs are demand, grid"),
        ("{value: 0.5}", "{value: 0.5, formula: t}", "scenarios.half.inputs.grid", "formula"),
        ("{value: 0.5}", "{}", "scenarios.half.inputs.grid", "value"),
        ("{value: 0.5}", "{formula: '2*speed'}", "scenarios.half.inputs.grid.formula", "t, pi"),
        ("rate: 150", "rate: -1", "blocks.torque.rate", "> 0"),
        ("time_constant: 50 ms", "time_constant: 0 s", "blocks.torque.time_constant", "> 0"),
    ],
)
def test_wrong_inputs(old, new, where, words):
    assert old in TEXT
    with pytest.raises(ModelError) as found:
        loads_model(TEXT.replace(old, new))
    said = [str(p) for p in found.value.problems if p.where.startswith(where)]
    assert said and words in said[0], found.value
