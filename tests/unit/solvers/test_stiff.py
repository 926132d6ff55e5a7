# SPDX-License-Identifier: Apache-2.0
"""Stiff integrators: order, tolerance, stiffness, samples, events, whole turns, new charts, failures."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pitchpoint import load_model
from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INCONSISTENT, NOT_FINITE, OK
from pitchpoint.elements.signal import LAW, OVER_TIME
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.joints import FLOATING
from pitchpoint.solvers import sampling
from pitchpoint.solvers.constraints.row_notes import redundant_rows
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.solvers.multistep import bdf
from pitchpoint.solvers.time import run_time
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.system import assemble
from pitchpoint.system.workspace import FACTORISATIONS, RECHARTED
from tests.support.engine import couplings, gear_rows, rattle, torques
from tests.support.rod import pendulum
from tests.unit.solvers.test_time_loops import OMEGA, exact, oscillator

CONTROLLED = ("gstiff", "wstiff", "dassl")


def distance(state, t):
    """Error of angle and speed, as an angle."""
    speed = (exact(t + 1e-6) - exact(t - 1e-6)) / 2e-6
    return math.hypot(state.q[0] - exact(t), (state.v[0] - speed) / OMEGA)


@pytest.mark.parametrize("order", range(1, 6))
def test_order_of_equal_steps_on_a_linear_oscillator(order):
    errors = []
    for n in (200, 400):
        system, state = oscillator()
        run = bdf.start(system, state, "constant_bdf", order=order, largest_step=0.031 / n)
        assert run.advance_to(0.031).status == OK
        errors.append(distance(run.state(), 0.031))
    # 130 steps in a period: terms of the next order are a few per cent of the error
    assert math.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.15)


def test_equal_steps_stay_equal_where_forces_round():
    """A rotor of beams: its forces round at the size of the machine, and once cut 60 steps into 8 000."""
    model = load_model(Path(__file__).parents[3] / "examples" / "geared-rotor" / "model.yaml")
    scenario = replace(
        model.scenarios["fast"], method="constant_bdf", step=5e-5, duration=3e-3, settle_time=0.0
    )
    done = run_time(compile_model(model, scenario), scenario)
    assert done.status == OK
    assert done.steps == 100  # 40 of them climb to the step


def test_a_step_of_order_six_is_there():
    """Its region of stability leaves out slightly damped vibration: a decay, then."""
    system = assemble([Body(polar_inertia=1.0)], {"coupling": couplings([(1, 0, 2.0, 3.0, 0.0)])})
    state = system.initial_state()
    state.q[0] = 1.0
    run = bdf.start(system, state, "constant_bdf", order=6, largest_step=0.02)
    assert run.advance_to(2.0).status == OK
    assert run.order == 6
    solution = 2.0 * math.exp(-2.0) - math.exp(-4.0)  # roots -1 and -2
    assert run.state().q[0] == pytest.approx(solution, abs=1e-7)


@pytest.mark.parametrize("kind", CONTROLLED)
def test_error_follows_the_tolerance(kind):
    errors, steps = [], []
    for rtol in (1e-5, 1e-7, 1e-9):
        system, state = oscillator()
        run = bdf.start(system, state, kind, rtol=rtol, atol=1e-2 * rtol)
        chunk = run.advance_to(0.05, sample=1e-3)
        assert chunk.status == OK
        index = 1 + system.layout.channel("angle[disc]")
        errors.append(max(abs(row[index] - exact(row[0])) for row in chunk.rows))
        steps.append(chunk.steps)
        assert chunk.rows.shape[0] == 50
    # a hundred steps and more add what each of them leaves over, up to rtol times the amplitude of 0.01
    for error, rtol in zip(errors, (1e-5, 1e-7, 1e-9), strict=True):
        assert error < 100.0 * rtol
    assert errors[2] < 1e-2 * errors[0]
    # order five needs 10^(2/6) times the steps for a hundredth of the error, lower orders more
    assert 1.8 < steps[1] / steps[0] < 5.0


@pytest.mark.parametrize("kind", CONTROLLED)
def test_steps_follow_the_solution_not_the_stiffness(kind):
    """A spring 1e8 times as stiff as the slow one, damped: explicit steps would be 1e-4 s."""
    bodies = [Body(polar_inertia=1.0, name="slow"), Body(polar_inertia=1e-4, name="fast")]
    springs = couplings([(1, 0, 1.0, 0.0, 0.0), (1, 2, 1e4, 2.0, 0.0)])
    system = assemble(bodies, {"coupling": springs})
    state = system.initial_state()
    state.q[:] = 0.1
    run = bdf.start(system, state, kind, rtol=1e-6)
    chunk = run.advance_to(20.0)
    assert chunk.status == OK
    # both discs swing as one
    assert run.state().q[0] == pytest.approx(0.1 * math.cos(20.0 / math.sqrt(1.0001)), abs=1e-4)
    assert chunk.steps < 1500
    assert system.workspace.clock[FACTORISATIONS] < 0.5 * chunk.steps


@pytest.mark.parametrize("kind", bdf.KINDS)
def test_runs_do_not_depend_on_the_chunks(kind):
    finals = []
    for most in (1_000_000, 7):
        system = rattle()
        state = system.initial_state()
        state.v[:] = 300.0
        run = bdf.start(system, state, kind, largest_step=1e-4)
        rows = []
        while run.t < 0.05:
            chunk = run.advance_to(0.05, sample=1e-3, most=most)
            assert chunk.status == OK
            rows.append(chunk.rows)
        assert len(np.concatenate(rows)) == 50
        finals.append(np.concatenate([run.state().q, run.state().v, np.concatenate(rows).ravel()]))
    np.testing.assert_array_equal(*finals)


@pytest.mark.parametrize("kind", bdf.KINDS)
def test_whole_turns_change_nothing(kind):
    finals = []
    for turns in (0, 100_000):
        system = rattle()
        state = system.initial_state()
        state.v[:] = 300.0
        state.turns[1:] = turns
        run = bdf.start(system, state, kind, largest_step=1e-4)
        assert run.advance_to(0.2).status == OK
        final = run.state()
        finals.append(np.concatenate([final.q, final.v, final.a]))
        assert np.all(np.abs(final.q) <= math.pi)
        angle = evaluate.observe(system, final)[system.layout.channel("angle[a]")]
        assert angle == pytest.approx(300.0 * 0.2 + 2.0 * math.pi * turns, abs=0.01)
    np.testing.assert_array_equal(*finals)


@pytest.mark.parametrize("kind", CONTROLLED)
def test_a_free_body_tumbles_through_its_charts(kind):
    """Torque-free motion about the middle axis, against the same run of an explicit method."""
    body = Body(motion=FLOATING, mass=1.0, inertia=np.diag([0.01, 0.02, 0.025]), name="body")
    found = []
    for method in (kind, "explicit"):
        system = assemble([body], {})
        state = system.initial_state()
        state.v[3:] = (0.05, 6.0, 0.03)
        if method == "explicit":
            run = runge_kutta.start_adaptive(system, state, rtol=1e-11, atol=1e-13, atol_rate=1e-12)
        else:
            run = bdf.start(system, state, method, rtol=1e-8)
        assert run.advance_to(5.0).status == OK
        assert system.workspace.clock[RECHARTED] > 5
        evaluate.residual(system, run.state())
        frame = system.workspace.fr[1]
        found.append(np.concatenate([frame["S"].ravel(), frame["tw"]]))
    # thirty radians of an unstable rotation: what a step leaves over grows a thousandfold
    np.testing.assert_allclose(found[0], found[1], atol=2e-4)


def test_statistics_and_samples_are_of_the_same_times():
    system = rattle()
    run = bdf.start(system, system.initial_state(), "wstiff", largest_step=1e-3)
    sums = sampling.new_statistics(system.sizes["no"])
    chunk = run.advance_to(0.05, sample=1e-4, statistics=sums)
    found = sampling.read_statistics(sums)
    assert found.count == chunk.rows.shape[0] == 500
    np.testing.assert_allclose(found.mean, chunk.rows[:, 1:].mean(axis=0), rtol=1e-9, atol=1e-14)


@pytest.mark.parametrize("form", bdf.FORMS)
@pytest.mark.parametrize("kind", bdf.KINDS)
def test_a_repeated_row_is_flagged_and_harmless(kind, form):
    finals = []
    for rows in (1, 2):
        system, state = pendulum(rows)
        run = bdf.start(system, state, kind, form=form, rtol=1e-6, largest_step=1e-3)
        assert run.advance_to(1.0).status == OK
        finals.append(np.concatenate([run.state().q, run.state().v, [run.state().lam.sum()]]))
    np.testing.assert_allclose(finals[1], finals[0], atol=1e-9)
    assert len(redundant_rows(system)) == 1


@pytest.mark.parametrize("kind", CONTROLLED)
def test_a_row_that_contradicts_another_stops_the_run(kind):
    bodies = [Body(polar_inertia=1.0, name="a"), Body(polar_inertia=4.0, name="b")]
    rows = gear_rows([(1, 2, 20, 40), (1, 2, 10, 20)])
    rows["u0"] = [0.0, 1e-3]
    system = assemble(bodies, {"torque": torques([(1, 3.0)])}, {"ratio": rows})
    assert bdf.start(system, system.initial_state(), kind).advance_to(0.01).status == INCONSISTENT


@pytest.mark.parametrize("form", bdf.FORMS)
def test_positions_and_rates_obey_the_rows(form):
    """The stabilised forms hold both to round-off; index 3 holds the positions only."""
    system, state = pendulum()
    run = bdf.start(system, state, "gstiff", form=form, rtol=1e-6)
    assert run.advance_to(2.0).status == OK
    evaluate.residual(system, run.state())
    w = system.workspace
    assert abs(w.g[0]) < 1e-9  # the share of the tolerance that the iteration may leave over
    drift = abs(float(w.G[0] @ w.v))
    assert drift < 1e-6 if form != "I3" else 1e-9 < drift < 1e-2


def test_a_law_that_returns_nan_stops_the_run_before_it():
    def law(t, x, p):
        return math.nan if t > 0.01 else 1.0

    records = torques([(1, 1.0)])
    records["form"], records["over"] = LAW, OVER_TIME
    system = assemble(
        [Body(polar_inertia=1.0)],
        {"torque": records},
        pools={"torque": np.zeros(1)},
        laws={"torque": [law]},
    )
    run = bdf.start(system, system.initial_state(), "gstiff", largest_step=1e-3)
    chunk = run.advance_to(1.0)
    assert chunk.status == NOT_FINITE
    # steps become shorter in front of it until they end
    assert run.t == pytest.approx(0.01, abs=1e-9)
    assert run.state().v[0] == pytest.approx(run.t, rel=1e-9)
    assert "torque" in evaluate.explain(system, chunk.status)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"kind": "gear"}, "gstiff, wstiff"),
        ({"form": "SI3"}, "I3, SI2, SI1"),
        ({"order": 7}, "1 ... 6"),
        ({"largest_step": 0.0}, "positive"),
        ({"kind": "constant_bdf"}, "finite"),
    ],
)
def test_what_cannot_be_is_refused(arguments, words):
    system, state = oscillator()
    with pytest.raises(SolverError, match=words):
        bdf.start(system, state, **arguments)


@pytest.mark.nojit
@pytest.mark.parametrize("kind", bdf.KINDS)
def test_all_kinds_without_the_compiler(kind):
    system, state = pendulum()
    run = bdf.start(system, state, kind, form="SI1", rtol=1e-4, largest_step=0.02)
    assert run.advance_to(0.2, sample=0.05).rows.shape[0] == 4
    # a fall by 0.2 s: sin of the angle is g t^2 / 2 in first order, 0.1962
    assert run.state().q[1] == pytest.approx(-0.1959, abs=2e-3)
