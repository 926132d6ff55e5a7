# SPDX-License-Identifier: Apache-2.0
"""Steps that end at events cost what they must, and no more of them than asked for or needed."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from pitchpoint.core.kernel import invoke
from pitchpoint.core.status import OK
from pitchpoint.elements import gear_mesh
from pitchpoint.elements.mesh.record import EVENTS
from pitchpoint.multibody.bodies import Body
from pitchpoint.solvers.event_watch import EventWatch, bending
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.multistep import bdf
from pitchpoint.solvers.multistep.events import keep_past, take_back
from pitchpoint.solvers.multistep.order_control import PAST
from pitchpoint.solvers.multistep.step import step
from pitchpoint.solvers.time import run_time
from pitchpoint.system.system import assemble
from tests.support.engine import couplings, torques
from tests.support.machines import compiled, pair

CONTROLLED = ("gstiff", "wstiff", "dassl")
CONSTANT = "{law: constant, value: 3e6 N/m}, damper: {ratio: 0.02}"
PASSAGES = "[pair_entry, pair_exit, sliding_reversal]"


@pytest.mark.nojit
@pytest.mark.parametrize("kind", [*CONTROLLED, "constant_bdf"])
@pytest.mark.parametrize("share", [0.9, 0.3, 1e-6])
def test_a_step_taken_back_leaves_no_trace(kind: str, share: float) -> None:
    """gstiff moves its past to the grid of the shorter step, and drops what is older than its order."""
    bodies = [Body(polar_inertia=1.0, name="one"), Body(polar_inertia=1.0, name="two")]
    springs = couplings([(1, 2, 100.0, 0.2, 0.0), (1, 0, 40.0, 0.4, 0.0)])
    system = assemble(bodies, {"coupling": springs, "torque": torques([(2, 3.0)])})
    more = {"largest_step": 1e-2} if kind == "constant_bdf" else {}
    run = bdf.start(system, system.initial_state(), kind, rtol=1e-7, **more)
    assert run.advance_to(0.4).status == OK
    at, where = system.workspace.at, run.past.ctypes.data
    points = int(run.past[0]["points"])
    history = [a for a in run.keep if a.shape in ((8, 4), (8,))][:2]  # rows and their times
    run.past[0]["limit"] = run.t + share * float(run.past[0]["h"])
    before, rows, state = run.past.copy(), [a[:points].copy() for a in history], run.state()
    keep_past(at, where)
    assert invoke(step, at, where, 0) == OK
    assert run.past[0]["t"] == run.past[0]["limit"]
    assert not np.array_equal(history[0][:points], rows[0])
    take_back(at, where)
    assert all(run.past[0][name] == before[0][name] for name in PAST.names)
    for now, then in zip(history, rows, strict=True):
        np.testing.assert_array_equal(now[:points], then)
    for name in ("q", "v", "a"):
        np.testing.assert_array_equal(getattr(run.state(), name), getattr(state, name))


def vibration(method: str, tolerance: float, events: str = "[]"):
    """System and result of a pair of constant stiffness under a torque that swings, always in contact.

    It starts at rest in the mean deflection, so that it also vibrates freely. Nothing depends on where the
    pairs are: they pass their path and change nothing.
    """
    rest = (
        "scenarios:\n  on: {speed: {driver: 300 rpm}, duration: 0.02 s, settle_time: 0 s, "
        f"sample_rate: 1 kHz, method: {method}, tolerance: {tolerance}, events: {events}}}\n"
    )
    text = pair(CONSTANT, torque='"200 N m + 50 N m*sin(2*pi*t/(2 ms))"', rest=rest)
    text = text.replace("torque: balance", "torque: 300 N m")
    model, system = compiled(text, "on")
    start = prepare_start(system, model.scenarios["on"])
    done = run_time(system, start=replace(start, state=start.mean))
    assert done.status == OK, done.sentence
    return system, done


@pytest.mark.parametrize("kind", CONTROLLED)
def test_events_that_change_nothing_leave_accuracy_and_steps(kind: str) -> None:
    """An event may add the error of one step, the tolerance, and some steps: fewer than a start at order 1.

    A step is cut short, the order climbs from 3 to 5, and the step doubles a few times on its way back; a
    start at order 1 takes 10 to 20 (decision 0014). Steps double or stay, so the counts of single tolerances
    scatter by 15 % either way.
    """
    _, exact = vibration("runge_kutta", 1e-12)
    size = np.abs(exact.state.v).max()
    surplus, count = 0, 0
    for tolerance in (1e-5, 1e-6, 1e-7, 1e-8):
        done = [vibration(kind, tolerance, events)[1] for events in ("[]", PASSAGES)]
        errors = [np.abs(d.state.v - exact.state.v).max() / size for d in done]
        number = len(done[1].events)
        assert number == 9
        assert errors[1] < errors[0] + number * tolerance
        surplus += done[1].steps - done[0].steps
        count += number
    assert surplus < 10 * count


def test_an_explicit_run_ends_no_steps_where_nothing_bends_and_nobody_asked() -> None:
    """Flanks never part here, and pairs that pass change nothing: the same steps as without events."""
    _, plain = vibration("runge_kutta", 1e-7)
    _, watched = vibration("runge_kutta", 1e-7, "[contact]")
    assert len(watched.events) == 0
    assert watched.steps == plain.steps
    np.testing.assert_array_equal(watched.state.q, plain.state.q)
    _, asked = vibration("runge_kutta", 1e-7, PASSAGES)
    assert len(asked.events) == 9


@pytest.mark.parametrize("asked", [PASSAGES, "[pair_exit]", "[pair_entry, contact]"])
def test_an_explicit_run_finds_the_events_that_it_finds_where_all_end_steps(asked: str) -> None:
    """Places differ by what the runs differ, 1e-7 of the speed of the mesh phase at most."""
    system, done = vibration("runge_kutta", 1e-7, asked)
    begun = prepare_start(system, system.scenario)
    run = runge_kutta.start_adaptive(begun.system, begun.mean, atol=1e-11, atol_rate=1e-7)
    chunk = run.advance_to(0.02, events=1000, restart=True)
    assert chunk.status == OK
    expected = EventWatch(system, system.scenario).pick(chunk.events)
    assert len(chunk.events) > len(expected) or asked == PASSAGES
    np.testing.assert_array_equal(done.events[:, 1:], expected[:, 1:])
    np.testing.assert_allclose(done.events[:, 0], expected[:, 0], atol=1e-8)


def test_an_explicit_run_still_ends_steps_where_the_stiffness_jumps() -> None:
    """A rectangular wave, events of contact asked for: a step over a jump is of no order.

    Reference: the run that asks for the pairs, too.
    """
    law = "{law: rectangular, high: 4e8 N/m, low: 3e8 N/m}, damper: {ratio: 0.05}"
    steps = []
    for events in ("[]", "[contact]", "[contact, pair_entry, pair_exit]"):
        rest = (
            "scenarios:\n  on: {speed: {driver: 500 rpm}, duration: 0.02 s, method: runge_kutta, "
            f"tolerance: 1e-8, events: {events}, sample_rate: 1 kHz}}\n"
        )
        done = run_time(compiled(pair(law, rest=rest), "on")[1])
        assert done.status == OK, done.sentence
        steps.append((done.steps, done.state.q))
    assert steps[1][0] == steps[2][0] != steps[0][0]
    np.testing.assert_array_equal(steps[1][1], steps[2][1])


@pytest.mark.parametrize(
    "law, more, smooth",
    [
        (CONSTANT, "", {"turning", "pair", "sliding"}),
        ("{law: fourier, mean: 4e8 N/m, cosine: [-0.2]}", "", {"turning", "pair", "sliding"}),
        ("{law: rectangular, high: 4e8 N/m, low: 3e8 N/m}", "", {"turning", "sliding"}),
        ("{law: din3990}", "", {"turning", "sliding"}),
        ("{law: din3990}", ", friction: {mu: 0.05}", set()),
    ],
)
def test_event_functions_where_forces_of_a_mesh_bend(law: str, more: str, smooth: set[str]) -> None:
    system = compiled(pair(law + more))[1]
    flags = bending(system)
    names = [event.name.partition("[")[0] for event in system.layout.events]
    assert names == [name for name, _ in EVENTS]
    for name, flag in zip(names, flags, strict=True):
        assert flag == (name.removeprefix("back_").partition("_")[0] not in smooth or "gap" in name)
    assert set(gear_mesh.bends(system.records["gear_mesh"][0])) == {
        n for n, f in zip(names, flags, strict=True) if f
    }
