# SPDX-License-Identifier: Apache-2.0
"""Every integrator and form on the same machines: gear pairs with and without drives, a slider crank."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INTERRUPTED, OK
from pitchpoint.io.yaml_model import load_model
from pitchpoint.model.scenario import FORMS, METHODS, STIFF_METHODS
from pitchpoint.multibody.bodies import TORSION, Body
from pitchpoint.multibody.joints import PRISMATIC
from pitchpoint.solvers.compare import TOLERANCES, cases_of, compare_solvers
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.solvers.multistep import bdf
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system.compile import compile_model
from pitchpoint.system.system import assemble
from tests.support.closures import pins
from tests.support.engine import bearings
from tests.support.machines import compiled, pair

EXAMPLES = Path(__file__).parents[3] / "examples"
ALL = [(method, form) for method in STIFF_METHODS for form in FORMS] + [("generalized_alpha", "SI2")]
LAWS = {
    "constant": ("{law: constant, value: 3e8 N/m}, damper: {ratio: 0.05}", 1e-5),
    # pairs of teeth come and go with kinks; equal steps of 1/200 period meet them to one per cent
    "teeth": ("{law: din3990}, damper: {ratio: 0.05}", 0.02),
    # and with jumps, at which a sample just before or after differs by the whole of it
    "jumps": ("{law: rectangular, high: 4e8 N/m, low: 3e8 N/m, duty: 0.6}, damper: {ratio: 0.05}", 0.05),
}
MOTIONS = {"free": "speed: {driver: 300}", "driven": "drive: {driver: {speed: 300}}"}


def response(law, motion, method, form="", more=""):
    """Mesh force at 50 kHz, and what the run said."""
    choice = f", form: {form}" if form else ""
    scenario = (
        f"scenarios:\n  turn: {{{MOTIONS[motion]}, duration: 10 ms, sample_rate: 50 kHz, method: {method}"
        f"{choice}{more}, events: [pair_entry]}}\n"
    )
    system = compiled(pair(LAWS[law][0], rest=scenario), "turn")[1]
    memory = Memory()
    done = run_time(system, sink=memory)
    index = system.layout.channel("mesh_force[stage]")
    return np.concatenate(memory.times), np.concatenate(memory.rows)[:, index], done


@pytest.fixture(scope="module")
def truth():
    return {
        (law, motion): response(law, motion, "runge_kutta", more=", tolerance: 1e-9")
        for law in LAWS
        for motion in MOTIONS
    }


@pytest.mark.parametrize(("method", "form"), ALL)
@pytest.mark.parametrize("motion", MOTIONS)
@pytest.mark.parametrize("law", LAWS)
def test_gear_pairs(law, motion, method, form, truth):
    times, force, known = truth[law, motion]
    t, found, done = response(law, motion, method, form)
    assert done.status == OK
    np.testing.assert_allclose(t, times, rtol=1e-14)
    error = np.sqrt(np.mean((found - force) ** 2)) / np.abs(force).max()
    assert error < LAWS[law][1]
    assert len(done.events) == len(known.events) == 14  # 300 rad/s, 30 teeth, 10 ms
    # located within a step on its polynomial, with equal steps of generalised-alpha on a chord
    np.testing.assert_allclose(done.events[:, 0], known.events[:, 0], atol=2e-7)


@pytest.mark.parametrize(("method", "form"), [(m, f) for m, f in ALL if f != "SI1"])
@pytest.mark.parametrize(
    ("file", "name", "allowed"),
    [
        ("backlash-oscillator/tip-relief", "steady", 2e-3),
        # flanks that hammer: the instants of impacts, not their forces, are what is left over
        ("camshaft-drive/train", "engine", 0.05),
        ("nearly-driven/internal", "walk", 1e-9),
    ],
)
@pytest.mark.filterwarnings("ignore:profile shifts")
def test_examples(file, name, allowed, method, form):
    model = load_model(EXAMPLES / f"{file}.yaml")
    found = []
    for chosen in (("generalized_alpha", None), (method, form)):
        scenario = replace(
            model.scenarios[name],
            duration=0.02,
            settle_time=0.0,
            sample_rate=20000.0,
            method=chosen[0],
            form=chosen[1],
        )
        system = compile_model(model, scenario)
        memory = Memory()
        assert run_time(system, scenario, sink=memory).status == OK
        rows = [k for k, c in enumerate(system.layout.channels) if c.name.startswith("mesh_force")]
        found.append(np.concatenate(memory.rows)[:, rows])
    error = np.sqrt(np.mean((found[1] - found[0]) ** 2))
    assert error <= allowed * np.abs(found[0]).max()


def crank(stiffness):
    """Crank 0.1 m, rod 0.3 m, piston; the rod is tied to it by a stiff damped spring across."""
    along = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    across = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])
    tensor = np.diag([1e-3, 1e-3, 1e-3])
    bodies = [
        Body(motion=TORSION, mass=1.0, com=(0.05, 0.0, 0.0), inertia=tensor, name="crank"),
        Body(
            motion=TORSION, parent=1, position=(0.1, 0.0, 0.0), mass=0.5, com=(0.15, 0.0, 0.0),
            inertia=5.0 * tensor, name="rod",
        ),
        Body(motion=PRISMATIC, position=(0.4, 0.0, 0.0), axes=along, mass=1.0, name="piston"),
        Body(
            motion=PRISMATIC, parent=3, position=(0.4, 0.0, 0.0), axes=across, mass=0.01,
            inertia=1e-6 * np.eye(3), name="pin",
        ),
    ]  # fmt: skip
    K = np.zeros((6, 6))
    K[1, 1] = stiffness
    D = np.zeros((6, 6))
    D[1, 1] = 2.0 * math.sqrt(0.01 * stiffness)
    held = bearings([(4, 0, K, D)])
    held["B"] = np.eye(3)
    system = assemble(
        bodies,
        {"bearing": held},
        {"pin_in_plane": pins([(2, (0.3, 0.0, 0.0), 4, (0.0, 0.0, 0.0))])},
    )
    state = system.initial_state()
    state.v[:2] = 20.0, -20.0 * (1.0 + 0.1 / 0.3)  # the far end of the rod stands still
    return system, state


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("kind", ["gstiff", "wstiff", "dassl"])
def test_a_stiff_spring_in_a_slider_crank_costs_little(kind, form):
    """A guide of 1e10 N/m gives way by less than a micrometre: the motion is that of a rigid one."""
    found, steps = [], []
    for stiffness in (1e7, 1e10):
        system, state = crank(stiffness)
        run = bdf.start(system, state, kind, form=form, rtol=1e-6)
        chunk = run.advance_to(1.0)
        assert chunk.status == OK
        final = run.state()
        found.append(final.v[0])
        steps.append(chunk.steps)
        assert abs(final.q[3]) < 1e-4
    assert steps[1] < 2.0 * steps[0]
    assert found[1] == pytest.approx(found[0], rel=2e-3)  # by the softness of the first one


def test_the_stiff_slider_crank_is_right():
    speeds = []
    for kind in ("explicit", "gstiff"):
        system, state = crank(1e7)
        if kind == "explicit":
            run = runge_kutta.start_adaptive(system, state, rtol=1e-8, atol=1e-11, atol_rate=1e-8)
        else:
            run = bdf.start(system, state, kind, rtol=1e-8)
        assert run.advance_to(0.2).status == OK
        speeds.append(run.state().v)
    np.testing.assert_allclose(speeds[1], speeds[0], atol=1e-4)


def test_every_method_and_form_is_compared():
    names = {(case.method, case.form) for case in cases_of(2, 1e-3)}
    assert {method for method, _ in names} == set(METHODS) - {"kinematics"}  # which integrates nothing
    assert {form for method, form in names if method == "gstiff"} == set(FORMS)
    assert ("dassl", "I3") in names
    assert {form for _, form in {(c.method, c.form) for c in cases_of(0, 1e-3)}} == {""}


def test_comparison_on_a_driven_pair():
    scenario = "scenarios:\n  turn: {drive: {driver: {speed: 300}}, duration: 5 ms}\n"
    model, system = compiled(pair(LAWS["teeth"][0], rest=scenario), "turn")
    seen = []
    found = compare_solvers(system, model.scenarios["turn"], progress=lambda *state: seen.append(state))
    assert {run.status for run in found.attempts} == {OK}
    assert len(seen) == len(found.attempts) + 2
    assert found.doubt < 1e-4
    by_method = {}
    for run in found.attempts:
        by_method.setdefault((run.method, run.form), []).append(run)
        assert run.cpu_s > 0.0
        assert run.channel
    for (method, form), runs in by_method.items():
        finest = runs[-1]
        # multipliers, here the torque of the drive, are not controlled in I3
        assert finest.error < (0.1 if form == "I3" else 0.02), (method, form)
        if finest.setting == "tolerance":
            assert [run.value for run in runs] == list(TOLERANCES)
        else:
            assert finest.error < 0.5 * runs[0].error


def test_a_run_that_takes_too_long_is_stopped_and_says_so(monkeypatch):
    scenario = "scenarios:\n  turn: {drive: {driver: {speed: 300}}, duration: 20 ms, step: 20 ns}\n"
    model, system = compiled(pair(LAWS["constant"][0], rest=scenario), "turn")
    few = [case for case in cases_of(1, 20e-9) if case.method == "rk4"][-1:]
    monkeypatch.setattr("pitchpoint.solvers.compare.cases_of", lambda rows, step: few)
    found = compare_solvers(system, model.scenarios["turn"], limit_s=0.3)
    (stopped,) = found.attempts
    assert stopped.status == INTERRUPTED
    assert "stopped after 0.3 s at t = " in stopped.sentence
    assert 0.0 < stopped.t_end < 0.02
    assert math.isnan(stopped.error)


def test_ctrl_c_ends_a_comparison_also_when_the_time_of_its_run_is_up_meanwhile(monkeypatch):
    """A run that Ctrl-C ends before it looks at the clock was ended by the user, however late it is then."""
    rest = "scenarios:\n  turn: {speed: {driver: 300}, duration: 20 ms, step: 20 us}\n"
    model, system = compiled(pair(LAWS["constant"][0], rest=rest), "turn")

    def interrupted(system, scenario, **more):
        """A run that Ctrl-C ends, which says so by its status."""
        raise SolverError("interrupted", INTERRUPTED)

    monkeypatch.setattr("pitchpoint.solvers.compare.run_time", interrupted)
    with pytest.raises(KeyboardInterrupt):
        compare_solvers(system, model.scenarios["turn"], limit_s=0.0)
