# SPDX-License-Identifier: Apache-2.0
"""Long steps with sampled controllers, schedules of inputs and events; what has no long steps."""

from __future__ import annotations

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.core.errors import ModelError, ValidityWarning
from pitchpoint.solvers.exported_run import export_run
from tests.unit.solvers.test_long_step import MODEL

LAW = "def law(t, inputs, state, parameters):\n    return (-0.4*(inputs[0] - 50.0),)\n"
SAMPLED = """
sensors: {speed: {type: joint, coordinate: motor, derivative: 1}}
blocks: {demand: {type: sum, inputs: {torque: 1}, unit: N m}}
controllers:
  law: {type: python, function: "law.py:law", period: 5 ms, inputs: [speed], outputs: [torque]}
actuators: {drive: {type: torque, signal: demand, bodies: [motor]}}
"""
SCHEDULE = """
blocks: {demand: {type: input, value: 0, unit: N m}}
actuators: {drive: {type: torque, signal: demand, bodies: [motor]}}
"""
POINTS = "{demand: {points: [[0.02 s, 0], [0.04 s, 30 N m]]}}"
RUB = """
clutches:
  rub: {bodies: [blade, hub], capacity: 30 N m, static_ratio: 1, law: smooth, slip_speed: 0.02 rad/s}
"""


def differences(folder, text, *steps, **changes):
    """Largest differences of the speeds at 1 kHz from those of equal steps, for long steps [ms]."""
    (folder / "law.py").write_text(LAW)
    runs = []
    for step in (None, *steps):
        more = ", sample_rate: 1 kHz" + (f", long_step: {step} ms" if step else "")
        file = folder / "model.yaml"
        file.write_text(text.replace("MORE", more + changes.get("more", "")).replace("SHAFT", "3000"))
        runs.append(pp.solve_time(pp.compile_model(pp.load_model(file, allow_code=True), "run")))
    return np.array(
        [
            [np.abs(r[f"speed[{b}]"].values - runs[0][f"speed[{b}]"].values).max() for b in ("hub", "motor")]
            for r in runs[1:]
        ]
    )


def test_a_sampled_controller_keeps_the_second_order(tmp_path):
    """Jumps of its outputs do not restart the run: that has 3.4 times the error at 1 ms."""
    one, half = differences(tmp_path, MODEL + SAMPLED, 1, 0.5)
    assert (np.log2(one / half) > 1.8).all()
    assert one[1] < 3.5e-3


def test_a_schedule_of_an_input(tmp_path):
    """Torque on the gear train: its signal has new values in long steps, and is extrapolated in them."""
    one, half = differences(tmp_path, MODEL + SCHEDULE, 1, 0.5, more=f", inputs: {POINTS}")
    assert (one / half > 3.0).all()
    assert one[0] < 2.5e-3 and one[1] < 0.07  # 0.022 and 0.27 with the signal of the start of the long step


def test_events_of_other_bodies_are_located_within_the_long_step():
    """Slip of the blade, by linear interpolation over 1 ms; the first one is before the motions differ."""
    text = (MODEL + RUB).replace("loads:\n", "loads:\n  wave: {body: blade, torque: 60*sin(150*t)}\n")
    found = []
    for more in ("", ", long_step: 1 ms"):
        whole = text.replace("MORE", more + ", events: [stick_slip]").replace("SHAFT", "3000")
        data = pp.solve_time(pp.compile_model(pp.load_model(text=whole), "run"))
        found.append(data["event_time"].values)
    assert len(found[0]) == len(found[1]) > 10
    assert found[1][0] == pytest.approx(found[0][0], abs=2e-4)
    assert (found[1] % 1e-3).min() < 3e-4  # not within the last short step
    assert np.abs(found[1] - found[0]).max() < 1.5e-3


def test_what_has_no_long_steps_names_the_key():
    model = pp.load_model(text=MODEL.replace("MORE", ", long_step: 1 ms").replace("SHAFT", "3000"))
    system = pp.compile_model(model, "run")
    with pytest.warns(ValidityWarning, match="long_step: an exported model takes the same step"):
        export_run(system)
    with pytest.warns(ValidityWarning, match="long_step: a Stepper takes the same step"):
        pp.Stepper(model, "run").close()
    sweep = "scenarios:\n  run: {sweep: {body: motor, speed: [1 rpm, 2 rpm], points: 2}, long_step: 1 ms}"
    with pytest.raises(ModelError, match="long_step .*is not available with a scenario with sweep"):
        pp.load_model(text=MODEL.split("scenarios:")[0].replace("SHAFT", "3000") + sweep)
