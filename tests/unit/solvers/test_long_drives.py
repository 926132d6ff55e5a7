# SPDX-License-Identifier: Apache-2.0
"""Drives that have turned a long way: the row of a driven spin must stay as exact as the spin itself."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pitchpoint import load_model
from pitchpoint.core.status import OK
from pitchpoint.elements import drive
from pitchpoint.multibody.bodies import Body
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.multistep import bdf
from pitchpoint.solvers.time import run_time
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.system import assemble
from tests.support.engine import couplings

SPEED = 3000.0
TWO_PI = 2.0 * math.pi


def driven_rotor(turns):
    """A disc driven at constant speed, a second one behind a shaft; the state after so many turns."""
    drives = np.zeros(1, drive.RECORD)
    drives["i"], drives["speed"] = 1, SPEED
    bodies = [Body(polar_inertia=0.01, name="motor"), Body(polar_inertia=0.02, name="rotor")]
    system = assemble(bodies, {"coupling": couplings([(1, 2, 2e3, 0.5, 0.0)])}, {"drive": drives})
    state = system.initial_state()
    state.t = turns * TWO_PI / SPEED
    state.turns[1:] = turns
    state.q[:] = 0.0, 1e-3
    state.v[:] = SPEED
    return system, state


@pytest.mark.parametrize("turns", [0, 1000, 3_000_000])
def test_the_row_of_a_driven_spin_resolves_the_spin_after_any_number_of_turns(turns):
    """Its derivative by the spin is 1 for a change of 2e-15 rad, which is nothing next to 2e7 rad."""
    system, state = driven_rotor(turns)
    evaluate.prepare(system)
    rows = []
    for change in (0.0, 2e-15, 4e-15):
        state.q[0] = change
        evaluate.load(system, state)
        evaluate.residual(system, state)
        rows.append(float(system.workspace.g[0]))
    # the target itself is rounded at its own size
    assert abs(rows[0]) < 2.0 * np.spacing(turns * TWO_PI) + 1e-15
    assert np.diff(rows) == pytest.approx([2e-15, 2e-15], abs=0.0, rel=0.3)


@pytest.mark.parametrize("form", ["I3", "SI2", "SI1"])
@pytest.mark.parametrize("step", [1e-4, 1e-5, 1e-6])
def test_constant_steps_go_on_after_many_turns(form, step):
    """They once ended as soon as the angle was rounded more coarsely than the iteration must settle it."""
    system, state = driven_rotor(3_000_000)
    run = bdf.start(system, state, "constant_bdf", form=form, largest_step=step)
    assert run.advance_to(state.t + 300.0 * step).status == OK


@pytest.mark.parametrize("form", ["I3", "SI2"])
@pytest.mark.parametrize("step", [1e-4, 1e-6])
def test_generalized_alpha_goes_on_after_many_turns(form, step):
    system, state = driven_rotor(3_000_000)
    run = generalized_alpha.start(system, state, step, form=form)
    assert run.advance(300).status == OK


GEARBOX = Path(__file__).parents[3] / "examples" / "shovel-gearbox" / "paper.yaml"


def gearbox_run(form, step, duration):
    """Constant BDF on the gearbox for which its paper needed this method."""
    model = load_model(GEARBOX)
    scenario = replace(
        model.scenarios["rated"], method="constant_bdf", form=form, step=step, duration=duration
    )
    return run_time(compile_model(model, scenario), scenario)


def test_constant_steps_pass_the_place_where_the_gearbox_of_the_shovel_ended():
    """At 4.716 s, when the input had turned 320 rad."""
    done = gearbox_run("SI2", 5e-5, 4.8)
    assert (done.status, done.t_end) == (OK, 4.8), done.sentence


@pytest.mark.study
@pytest.mark.parametrize("form", ["I3", "SI2", "SI1"])
@pytest.mark.parametrize("step", [1e-5, 5e-5, 1e-4, 2e-4])
def test_constant_steps_carry_the_gearbox_of_the_shovel_through_all_of_its_record(form, step):
    done = gearbox_run(form, step, 15.0)
    assert (done.status, done.t_end) == (OK, 15.0), done.sentence
