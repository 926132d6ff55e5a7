# SPDX-License-Identifier: Apache-2.0
"""Bodies that are connected to no other begin a run where they are; loads require `start: assembled`."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model

STONE = """\
bodies:
  stone: {mass: 2 kg, inertia_tensor: [0.01, 0.02, 0.025, 0, 0, 0], position: [0, 0, 0]}
joints:
  fly: {type: free, bodies: [ground, stone], speed: {alpha: 0.05, beta: 6.0, spin: 0.03}}
loads: {}
scenarios:
  on: {duration: 0.5 s, step: 1 ms, settle_time: 0 s}
"""
PUSHED = STONE.replace("loads: {}", "loads: {push: {body: stone, force: [3 N, 0, 0]}}")


def test_a_tumbling_body_starts_in_its_given_position_without_notes():
    """Its gyroscopic moments would turn it to an equilibrium at the singular position beta = pi/2."""
    system = compile_model(loads_model(STONE), "on")
    start = prepare_start(system, system.model.scenarios["on"])
    assert np.array_equal(start.state.q, np.zeros(6))
    assert start.notes == ()


@pytest.mark.parametrize("load", ["push", "gravity"])
def test_a_loaded_free_body_has_no_equilibrium_and_the_message_names_the_start(load):
    text = PUSHED if load == "push" else STONE.replace("loads: {}", "gravity: [0, 0, -9.81]")
    model = loads_model(text)
    with pytest.raises(SolverError, match="nothing holds stone .*`start: assembled` in the scenario"):
        solve_time(compile_model(model, "on"))


def test_the_named_start_moves_the_body_by_its_load():
    """x = F t^2/(2 m) = 3 N 0.25 s^2/(4 kg)."""
    text = PUSHED.replace("duration: 0.5 s", "start: assembled, duration: 0.5 s")
    run = solve_time(compile_model(loads_model(text), "on"))
    assert float(run["displacement[stone.x]"][-1]) == pytest.approx(0.1875, rel=1e-6)
