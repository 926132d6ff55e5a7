# SPDX-License-Identifier: Apache-2.0
"""The example `flexible-slider-crank`: bend of the rod against beam theory, piston against a stiff rod."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system.compile import compile_model
from tests.support.scripts import script

FOLDER = Path(__file__).parents[2] / "examples" / "flexible-slider-crank"


def piston_of(file):
    system = compile_model(load_model(FOLDER / f"{file}.yaml"), "driven")
    memory = Memory()
    run_time(system, sink=memory)
    rows = np.concatenate(memory.rows)
    return np.concatenate(memory.times), rows[:, system.layout.channel("displacement[piston.z]")]


def test_bend_and_travel():
    rod = script(FOLDER / "flexible.py")
    t, angle, deflection, travel = rod.bend(turns=2.0)
    slow, whole = rod.theory(t)
    assert np.max(np.abs(angle - rod.SPEED * t)) < 1e-4  # the crank of 1e4 kg m^2 keeps its speed
    # beam theory takes the rod as straight and pushed by nothing: 800 N along it are 4 % of Euler's load of
    # 19.6 kN, which shift the natural frequency by 2 % and the phase of 25 vibrations a little
    assert np.max(np.abs(deflection - whole)) < 0.03 * np.max(np.abs(whole))
    assert np.max(np.abs(slow)) == pytest.approx(0.435e-3, abs=1e-6)
    assert np.max(np.abs(deflection)) == pytest.approx(0.497e-3, abs=2e-6)
    times, stiff = piston_of("rigid")
    exact = 0.1 * np.cos(rod.SPEED * times) + np.sqrt(0.09 - (0.1 * np.sin(rod.SPEED * times)) ** 2) - 0.4
    assert np.max(np.abs(stiff - exact)) < 1e-9
    # 0.3 m of 160 mm^2 give 9 nm/N: 730 N of the piston, put on at once, make 13 um, the rod itself 4 um
    assert np.max(np.abs(travel - np.interp(t, times, stiff))) < 20e-6
    # the rod from its file: it is stretched as much, but its vibration along itself begins otherwise
    times, elastic = piston_of("elastic")
    exact = 0.1 * np.cos(rod.SPEED * times) + np.sqrt(0.09 - (0.1 * np.sin(rod.SPEED * times)) ** 2) - 0.4
    assert 5e-6 < np.max(np.abs(elastic - exact)) < 20e-6
