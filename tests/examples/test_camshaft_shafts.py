# SPDX-License-Identifier: Apache-2.0
"""The example `camshaft-drive` on elastic shafts: means, period and twist of the hammering train."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system.compile import compile_model
from tests.support.scripts import script

FOLDER = Path(__file__).parents[2] / "examples" / "camshaft-drive"
BASE_RADIUS = 0.2494884  # of the cam gear [m]
CYLINDERS = 6


@pytest.fixture(scope="module")
def torques():
    """The script of the example."""
    return script(FOLDER / "torques.py")


def test_tables_are_those_of_the_script_and_their_means_the_work(torques):
    """Springs do no work in a revolution; the pump does p A times the stroke in the delivery."""
    train, rigid = (load_model(FOLDER / name) for name in ("shafts.yaml", "cylinders.yaml"))
    for model, load, name in (
        (train, "pump_1", "pump.csv"),
        (train, "valves_1", "valves.csv"),
        (rigid, "cylinders", "cylinders.csv"),
    ):
        law, (angle, torque) = model.loads[load].torque, torques.TABLES[name]
        assert np.degrees(law.abscissa) == pytest.approx(angle)
        assert law.values == pytest.approx(torque, abs=6e-3)  # printed with two decimals
    shift = train.loads["pump_5"].torque.abscissa[0]
    assert math.degrees(shift) == pytest.approx(60.0)  # fires after cylinder 1
    angle, torque = torques.TABLES["valves.csv"]
    assert np.trapezoid(torque, angle) / 360.0 == pytest.approx(0.0, abs=1e-9)
    low, high = torques.DELIVERY
    # the pressure rises and falls within 2 deg: the stroke between the middles of both
    ends = torques.lift(torques.PUMP, np.array([low, high]) + 0.5 * torques.RISE * np.array([1.0, -1.0]))[0]
    work = torques.PRESSURE * math.pi / 4.0 * torques.PLUNGER**2 * np.diff(ends)[0]
    angle, torque = torques.TABLES["pump.csv"]
    assert np.trapezoid(torque, np.radians(angle)) == pytest.approx(-work, rel=5e-3)
    assert np.trapezoid(*reversed(torques.TABLES["cylinders.csv"])) / 60.0 == pytest.approx(
        CYLINDERS * np.trapezoid(torque, angle) / 360.0, rel=1e-9
    )


# the study's profile shifts lie outside the range of the stiffness polynomial, and the model says so
@pytest.mark.filterwarnings("ignore::pitchpoint.core.errors.ValidityWarning")
def test_hammering_train():
    model = load_model(FOLDER / "shafts.yaml").replace("scenarios.engine.step", "0.02 ms")
    system = compile_model(model, "engine")
    memory = Memory()
    run_time(system, sink=memory)
    t, rows = np.concatenate(memory.times), np.concatenate(memory.rows)
    late = t > 0.16 + 1e-9  # three revolutions of the camshaft

    def channel(name):
        return rows[late, system.layout.channel(name)]

    law = model.loads["pump_1"].torque
    pump = np.trapezoid(law.values, law.abscissa) / math.tau
    mean = CYLINDERS * pump
    assert mean == pytest.approx(-540.1, abs=0.1)
    speed = 750.0 * 59.0 / 68.0 * 34.0 / 59.0 * math.pi / 30.0  # of the camshaft
    # no period is quite like the other: what the train gains from one end of the window to the other
    assert np.mean(channel("speed[camshaft]")) == pytest.approx(speed, rel=2e-3)
    assert np.mean(channel("mesh_force[stage_2]")) == pytest.approx(mean / BASE_RADIUS, rel=0.03)
    power = np.mean(channel("torque[crankshaft]")) * 750.0 * math.pi / 30.0
    assert power == pytest.approx(-mean * speed, rel=0.03)
    # gears hammer with the pumps, six times a turn of the camshaft
    force = channel("mesh_force[stage_2]")
    size = np.abs(np.fft.rfft(force - np.mean(force)))
    frequency = np.fft.rfftfreq(force.size, t[1] - t[0])
    slow = frequency < 100.0
    assert frequency[slow][np.argmax(size[slow])] == pytest.approx(3.0 * speed / math.pi, abs=0.1)
    largest = -min(script_torque for script_torque in model.loads["pump_1"].torque.values) / BASE_RADIUS
    assert np.abs(force).max() > 5.0 * largest
    for mesh in ("stage_1", "stage_2"):
        state = channel(f"contact_state[{mesh}]")
        assert {-1.0, 0.0, 1.0} <= set(state)
    rigidity = 206e9 / 2.6 * math.pi / 32.0 * (0.1**4 - 0.03**4)
    twist = pump * (6.0 * 0.355 + (5.0 + 4.0 + 3.0 + 2.0 + 1.0) * 0.35) / rigidity
    seen = np.mean(channel("angle[camshaft.11]") - channel("angle[camshaft.2]"))
    assert twist == pytest.approx(-0.861e-3, abs=1e-6)
    assert seen == pytest.approx(twist, rel=0.04)
