# SPDX-License-Identifier: Apache-2.0
"""The time step that a run chooses by itself where shafts are made of finite elements."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.step_choice import choose_step, shortest_period
from pitchpoint.solvers.step_modes import counted_frequency
from pitchpoint.solvers.time import run_time
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.residual import NEWTON
from tests.support.machines import compiled, pair

EXAMPLES = Path(__file__).parents[3] / "examples"
CASES = {"geared-rotor/model.yaml": "fast", "camshaft-drive/shafts.yaml": "engine"}


def fastest(start):
    """Highest natural frequency [Hz]."""
    M = evaluate.matrix(start.system, start.state, 1.0, 0.0, 0.0, NEWTON)
    K = evaluate.matrix(start.system, start.state, 0.0, 0.0, 1.0, NEWTON)
    return float(np.sqrt(np.linalg.eigvals(np.linalg.solve(M, K)).real.max()) / (2.0 * np.pi))


@pytest.mark.filterwarnings("ignore:profile shifts")
@pytest.mark.parametrize("file", CASES)
def test_modes_of_shafts_that_nothing_excites_do_not_count(file):
    """93 and 161 kHz, where the meshes bend shafts at 5.6 and 1.5 kHz most."""
    model = load_model(EXAMPLES / file)
    scenario = replace(model.scenarios[CASES[file]], step=None)
    start = prepare_start(compile_model(model, scenario), scenario)
    assert 1.0 / shortest_period(start, scenario) < 0.06 * fastest(start)
    assert 1000.0 < counted_frequency(start) < 4500.0
    # an explicit method would be unstable with such steps
    assert 1.0 / shortest_period(start, replace(scenario, method="rk4")) == pytest.approx(fastest(start))


def test_without_finite_elements_all_modes_count():
    scenario = "scenarios:\n  on: {speed: {driver: 500 rpm}, duration: 1 s}\n"
    model, system = compiled(pair("{law: constant, value: 3e8 N/m}", rest=scenario), "on")
    start = prepare_start(system, model.scenarios["on"])
    assert counted_frequency(start) == pytest.approx(fastest(start), rel=1e-12)


@pytest.mark.filterwarnings("ignore:profile shifts")
def test_steps_that_leave_the_highest_modes_out_are_small_enough():
    """Rattling gears of a camshaft train; 200 steps in a period leave 3e-4 of the rms, impacts some more."""
    model = load_model(EXAMPLES / "camshaft-drive/shafts.yaml")
    found = []
    for share in (1.0, 0.25):
        scenario = replace(model.scenarios["engine"], step=None, duration=0.01, settle_time=0.002)
        start = prepare_start(compile_model(model, scenario), scenario)
        scenario = replace(scenario, step=share * choose_step(start, scenario)[0])
        done = run_time(start.system, scenario, start=start)
        assert done.status == OK
        found.append([done.channels[f"mesh_force[stage_{k}]"]["rms"] for k in (1, 2)])
    np.testing.assert_allclose(found[0], found[1], rtol=2e-3)
