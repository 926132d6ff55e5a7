# SPDX-License-Identifier: Apache-2.0
"""Steps in which Newton's method fails are taken in parts, and the run goes on with its own step."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pitchpoint import compile_model, load_model
from pitchpoint.core.status import OK
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.implicit.step import alpha_step, bring_step, divided_step
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.time import run_time
from pitchpoint.system.workspace import REJECTED

SHOVEL = Path(__file__).parents[3] / "examples" / "shovel-gearbox" / "model.yaml"

PAIR = """
gears:
  pinion: {number_of_teeth: 20, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}
  wheel: {number_of_teeth: 40, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}
bodies: {motor: {gears: [pinion]}, drum: {gears: [wheel]}}
meshes:
  stage:
    gears: [pinion, wheel]
    stiffness: {law: fourier, mean: 4e8 N/m, cosine: [-0.2]}
    damper: {ratio: 0.05}
loads: {motor: {body: motor, torque: 50 N m}, drum: {body: drum, torque: 100 N m}}
scenarios: {steady: {speed: {motor: 600 rpm}, duration: 2 ms, step: 10 us}}
"""


def started(tmp_path, h):
    file = tmp_path / "pair.yaml"
    file.write_text(PAIR)
    model = load_model(file)
    start = prepare_start(compile_model(model, "steady"), model.scenarios["steady"])
    return generalized_alpha.start(start.system, start.state, h)


@pytest.mark.nojit
@pytest.mark.study
def test_a_divided_step_is_the_same_way_in_shorter_steps(tmp_path):
    """Four parts of a step against four steps of a quarter: the same to round-off, and so is what follows;
    against the whole step the difference is its own error, of third order in h."""
    h, ends = 2e-5, {}
    for kind in ("divided", "quarters", "whole"):
        run = started(tmp_path, h)
        run.advance(10)
        if kind == "quarters":
            run.change_step(h / 4)
            run.advance(4)
        else:
            at = run.system.workspace.at
            how = (run.t + h, h, run.rho_inf, run.left(), 0, 0)
            assert alpha_step(at, *how, 1) == OK
            if kind == "divided":
                assert divided_step(at, *how) == OK
        ends[kind] = run.system.workspace.q.copy()
    moved = np.abs(ends["quarters"]).max()
    assert ends["divided"] == pytest.approx(ends["quarters"], rel=1e-13)
    assert 1e-12 * moved < np.abs(ends["divided"] - ends["whole"]).max() < 1e-5 * moved


@pytest.mark.nojit
def test_a_step_is_brought_back_entirely(tmp_path):
    run = started(tmp_path, 2e-5)
    run.advance(10)
    w = run.system.workspace
    names = ("al", "ap", "lp")
    before = [w.q.copy(), w.v.copy(), w.a.copy(), w.lam.copy(), *(w.arrays[n].copy() for n in names)]
    assert alpha_step(w.at, run.t + run.h, run.h, run.rho_inf, run.left(), 0, 0, 1) == OK
    bring_step(w.at)
    after = [w.q, w.v, w.a, w.lam, *(w.arrays[n] for n in names)]
    assert all(np.array_equal(x, y) for x, y in zip(before, after, strict=True))


def test_falling_friction_near_rest_is_passed_and_told():
    """Gears that set off from rest under load pass the falling branch of their friction: 25 us are too long
    for some steps there. The mean force of the third stage is that of steps of 5 us to 1e-3 all the same."""
    model = load_model(SHOVEL)
    means = []
    for h in (25e-6, 5e-6):
        times = {"scenarios.rated.duration": 0.06, "scenarios.rated.settle_time": 0.02}
        done = run_time(compile_model(model.replace_all({**times, "scenarios.rated.step": h}), "rated"))
        assert done.status == OK, done.sentence
        means.append(done.channels["mesh_force[stage_3]"]["mean"])
        if h == 25e-6:
            assert any("were divided where Newton's method failed" in note for note in done.notes)
    assert means[0] == pytest.approx(means[1], rel=1e-3)


def test_a_run_without_failures_divides_nothing(tmp_path):
    run = started(tmp_path, 1e-5)
    run.advance(200)
    assert run.system.workspace.clock[REJECTED] == 0
