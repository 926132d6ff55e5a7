# SPDX-License-Identifier: Apache-2.0
"""The example `camshaft-train`: means, period and twist of the hammering train on elastic shafts."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system.compile import compile_model

FILE = Path(__file__).parents[2] / "examples" / "camshaft-train" / "train.yaml"
BASE_RADIUS = 0.2494884  # of the cam gear [m]
ANGLES = [0.0, 14.0, 24.0, 30.0, 40.0, 50.0, 60.0]
TORQUES = [-100.0, -866.7, -1000.0, 400.0, 233.3, -100.0, -100.0]  # of one pair of pumps


# the study's profile shifts lie outside the range of the stiffness polynomial, and the model says so
@pytest.mark.filterwarnings("ignore::pitchpoint.core.errors.ValidityWarning")
def test_hammering_train():
    system = compile_model(load_model(FILE), "engine")
    memory = Memory()
    run_time(system, sink=memory)
    t, rows = np.concatenate(memory.times), np.concatenate(memory.rows)
    late = t > 0.24 + 1e-9  # nine periods of the pumps

    def channel(name):
        return rows[late, system.layout.channel(name)]

    mean = 3.0 * np.trapezoid(TORQUES, ANGLES) / 60.0
    assert mean == pytest.approx(-753.3, abs=0.1)
    speed = 750.0 * 59.0 / 68.0 * 34.0 / 59.0 * math.pi / 30.0  # of the camshaft
    # no period is quite like the other: what the train gains from one end of the window to the other
    assert np.mean(channel("speed[camshaft]")) == pytest.approx(speed, rel=1e-3)
    assert np.mean(channel("mesh_force[stage_2]")) == pytest.approx(mean / BASE_RADIUS, rel=0.01)
    power = np.mean(channel("torque[crankshaft]")) * 750.0 * math.pi / 30.0
    assert power == pytest.approx(-mean * speed, rel=0.02)
    # gears hammer with the pumps, six times a turn of the camshaft
    force = channel("mesh_force[stage_2]")
    size = np.abs(np.fft.rfft(force - np.mean(force)))
    frequency = np.fft.rfftfreq(force.size, t[1] - t[0])
    assert frequency[np.argmax(size)] == pytest.approx(3.0 * speed / math.pi, abs=0.1)
    for mesh in ("stage_1", "stage_2"):
        state = channel(f"contact_state[{mesh}]")
        assert {-1.0, 0.0, 1.0} <= set(state)
    rigidity = 206e9 / 2.6 * math.pi / 32.0 * (0.1**4 - 0.03**4)
    twist = mean / 3.0 * (3.0 * 0.53 + 2.0 * 0.7 + 0.7) / rigidity
    seen = np.mean(channel("angle[camshaft.8]") - channel("angle[camshaft.2]"))
    assert twist == pytest.approx(-1.201e-3, abs=1e-6)
    assert seen == pytest.approx(twist, rel=0.02)
