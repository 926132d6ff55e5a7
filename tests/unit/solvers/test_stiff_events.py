# SPDX-License-Identifier: Apache-2.0
"""Stiff methods at jumps and bends of the forces: where steps end, how they go on, what that is worth."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.multibody.bodies import Body
from pitchpoint.solvers.event_watch import EventWatch
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.multistep import bdf
from pitchpoint.solvers.time import run_time
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from pitchpoint.system.workspace import REJECTED
from tests.support.engine import couplings, torques
from tests.support.machines import compiled, pair
from tests.unit.elements.test_friction_clutch import belt
from tests.validation import test_free_gap

CONTROLLED = ("gstiff", "wstiff", "dassl")
LOAD, GAP, END = 5.0, 0.15, 1.3
LAUNCH = """\
bodies:
  engine: {motion: torsion, inertia: 0.2 kg m^2, position: [0, 0, 0]}
  load: {motion: torsion, inertia: 0.2 kg m^2, position: [0, 0, 100 mm]}
clutches: {clutch: {bodies: [engine, load], capacity: 300 N m, slip_speed: SLIP rad/s}}
loads: {drive: {body: engine, torque: 50 N m}}
scenarios:
  go: {start: assembled, speed: {engine: 1000 rpm}, duration: 1 s, method: METHOD, tolerance: TOLERANCE,
    events: [stick_slip], sample_rate: 1 kHz}
"""


@pytest.fixture(scope="module")
def gap(tmp_path_factory):
    """A gear in its backlash, let go at its static deflection: system, start, contacts, state at the end.

    Reference: the explicit method at 1e-13, which begins anew at the contacts.
    """
    folder = tmp_path_factory.mktemp("gap")

    def system(torque):
        text = test_free_gap.MODEL.format(torque=torque, gap=GAP).replace(" * (1 - step(t - 0.1))", "")
        (folder / "gear.yaml").write_text(text)
        model = test_free_gap.load_model(folder / "gear.yaml", allow_code=False)
        return test_free_gap.compile_model(model, "adaptive")

    loaded, free = system(LOAD), system(0.0)
    begin = prepare_start(loaded, loaded.scenario).state
    run = runge_kutta.start_adaptive(free, begin, rtol=1e-13, atol=1e-17, atol_rate=1e-13)
    done = run.advance_to(END, events=100, restart=True)
    watch = EventWatch(free, free.scenario)
    return free, begin, watch.pick(done.events), run.state()


def vibrate(gap, kind, rtol, restart):
    """Run, events, and the error of the place at the end over the gap."""
    system, begin, _, end = gap
    run = bdf.start(system, begin, kind, rtol=rtol)
    watch = EventWatch(system, system.scenario)
    run.watch(watch.functions)
    done = run.advance_to(END, events=100, restart=restart)
    assert done.status == OK
    error = abs(run.state().q[-1] - end.q[-1]) * system.weight[-1] / (GAP * 1e-3)
    return run, watch.pick(done.events), error


@pytest.mark.parametrize("kind", CONTROLLED)
def test_vibration_through_a_gap_gets_better_with_the_tolerance(gap, kind):
    """Thirty contacts. Without ends of steps there each leaves what a bend within a step does.

    Between 1e-6 and 1e-9 methods of order 5 gain three decades, and so does the vibration in its gap now; the
    errors with and without were 7e-10 and 1.8e-8 m at 1e-7 (median of the kinds), a factor of 20.
    """
    errors = {}
    for rtol in (1e-5, 1e-7, 1e-9):
        run, events, errors[rtol] = vibrate(gap, kind, rtol, restart=True)
        assert run.restarts == len(events) == len(gap[2])
        np.testing.assert_array_equal(events[:, 1:], gap[2][:, 1:])
        # a phase error grows with the time; the last contact is where it is largest
        assert np.abs(events[:, 0] - gap[2][:, 0]).max() < 1e3 * rtol
    assert errors[1e-7] < 0.1 * errors[1e-5]
    assert errors[1e-9] < 0.2 * errors[1e-7]
    _, _, without = vibrate(gap, kind, 1e-7, restart=False)
    assert errors[1e-7] < 0.2 * without


def test_steps_at_contacts_are_not_rejected_time_and_again(gap):
    counts = []
    for restart in (True, False):
        run, _, _ = vibrate(gap, "gstiff", 1e-7, restart)
        counts.append((run.steps, int(gap[0].workspace.clock[REJECTED])))
    (with_ends, few), (without, many) = counts
    # 757 and 1100 steps, 16 and 126 rejected when this was written
    assert with_ends < 0.8 * without
    assert few < 0.3 * many


def test_equal_steps_go_on_from_a_contact_in_their_length(gap):
    system, begin, contacts, end = gap
    run = bdf.start(system, begin, "constant_bdf", largest_step=1e-3)
    run.watch(EventWatch(system, system.scenario).functions)
    done = run.advance_to(END, events=100, restart=True)
    assert done.status == OK
    assert run.restarts == len(contacts)
    # one step more per contact, and the climb at the start
    assert run.steps < END / 1e-3 + 2 * len(contacts) + 100
    # order 2: (omega h)^2/12 of the period, over the 15 periods
    assert abs(run.state().q[-1] - end.q[-1]) * system.weight[-1] < 0.02 * GAP * 1e-3


@pytest.mark.parametrize("kind", CONTROLLED)
def test_stick_and_slip_end_steps(kind):
    """A disc on a belt: it sticks, bristles yield, it slips and sticks again; reference rtol 1e-11."""
    system, begin = belt(0.1, 100.0, 10.0, 1.5, 1e6, 6e-4, 2e-3)
    disc = system.spin("disc")
    ends = []
    for rtol in (1e-5, 1e-7, 1e-11):
        run = bdf.start(system, begin, kind, rtol=rtol)
        done = run.advance_to(2.0, events=100, restart=True)
        assert done.status == OK
        assert run.restarts == 4  # yields, slips back as the spring wins, sticks: its bristles unload, turn
        ends.append(run.state().q[disc])
    # one slip of 0.1 rad; how far off the moment of slip is goes with the root of what a step errs by
    assert abs(ends[0] - ends[2]) < 1e-4
    assert abs(ends[1] - ends[2]) < 3e-6


def launch(kind, rtol, slip):
    """Run of two discs that a clutch brings to one speed, and their speeds at the end."""
    text = LAUNCH.replace("METHOD", kind).replace("TOLERANCE", rtol).replace("SLIP", slip)
    system = compiled(text, "go")[1]
    done = run_time(system)
    assert done.status == OK, done.sentence
    # angular momentum: half of that of the engine, and that of the torque on both
    speed = (0.2 * 1000.0 * math.pi / 30.0 + 50.0 * 1.0) / 0.4
    state = done.state
    for body in ("engine", "load"):
        assert state.v[system.spin(body)] == pytest.approx(speed, rel=max(10.0 * float(rtol), 1e-7))
    return done


@pytest.mark.parametrize("kind", CONTROLLED)
@pytest.mark.parametrize("rtol", ["1e-5", "1e-6", "1e-7", "1e-8", "1e-9"])
def test_a_clutch_that_sticks_has_no_events_of_round_off(kind, rtol):
    """It slips from the start; slip turns back, the bristles hold, swing back once; then nothing happens."""
    done = launch(kind, rtol, "0.1")
    np.testing.assert_array_equal(done.events[:, 1:], [[0, -1], [1, -1], [0, 1]])
    # 100/3 pi rad/s of slip at (300 - 50 + 300) N m / 0.2 kg m^2, and bristles that bend after it
    assert done.events[0, 0] == pytest.approx(0.038, abs=0.002)


@pytest.mark.parametrize("rtol", ["1e-7", "1e-8", "1e-9"])
def test_events_of_round_off_end_no_run(rtol):
    """A slip speed of nothing lets reversals within rounding count, and very short steps end at them."""
    assert launch("gstiff", rtol, "1e-12").events.shape[0] >= 4


def test_tooth_pairs_whose_stiffness_jumps():
    """A rectangular wave of stiffness: the force jumps where a pair enters, and steps end there."""
    scenario = (
        "scenarios:\n  on: {{speed: {{driver: 500 rpm}}, duration: 0.02 s, method: {}, tolerance: {}, "
        "events: [pair_entry, pair_exit], sample_rate: 100 kHz}}\n"
    )
    law = "{law: rectangular, high: 4e8 N/m, low: 3e8 N/m}, damper: {ratio: 0.05}"
    found = []
    for method, tolerance in (("runge_kutta", 1e-10), ("gstiff", 1e-8), ("wstiff", 1e-8), ("dassl", 1e-8)):
        system = compiled(pair(law, rest=scenario.format(method, tolerance)), "on")[1]
        done = run_time(system)
        assert done.status == OK, done.sentence
        force = done.channels["mesh_force[stage]"]
        found.append((done.events, force["mean"], force["rms"]))
    events, mean, rms = found[0]
    for others, other_mean, other_rms in found[1:]:
        np.testing.assert_array_equal(others[:, 1:], events[:, 1:])
        np.testing.assert_allclose(others[:, 0], events[:, 0], atol=1e-8)
        assert other_mean == pytest.approx(mean, rel=1e-5)
        assert other_rms == pytest.approx(rms, rel=1e-3)


def switched(stiffness, damping):
    """Two rotors on a stiff coupling, one of them under a torque."""
    bodies = [Body(polar_inertia=1.0, name="one"), Body(polar_inertia=1.0, name="two")]
    springs = couplings([(1, 2, stiffness, damping, 0.0), (1, 0, 40.0, 0.4, 0.0)])
    return assemble(bodies, {"coupling": springs, "torque": torques([(2, 3.0)])})


@pytest.mark.parametrize("stiffness", [1e2, 1e6, 1e12])
def test_going_on_after_a_jump_works_for_slow_and_stiff_modes(stiffness):
    """A torque is switched from 3 to -3 N m between two calls; the reference begins afresh there.

    At 1e12 N m/rad the differences of the new side say nothing, and the method begins at order 1.
    """
    system = switched(stiffness, 2e-3 * stiffness)
    ends = []
    for afresh in (False, True):
        system.records["torque"]["value"] = 3.0
        run = bdf.start(system, system.initial_state(), "gstiff", rtol=1e-7)
        assert run.advance_to(0.4).status == OK
        before = run.state()
        system.records["torque"]["value"] = -3.0
        if afresh:
            run = bdf.start(system, before, "gstiff", rtol=1e-10)
        else:
            evaluate.load(system, before)
            assert run.go_on() == OK
        assert run.advance_to(0.8).status == OK
        ends.append(run.state())
    assert np.abs(ends[0].q - ends[1].q).max() < 1e-6
    assert np.abs(ends[0].v - ends[1].v).max() < 1e-5
    assert math.isfinite(ends[0].a.sum())
