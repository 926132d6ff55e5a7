# SPDX-License-Identifier: Apache-2.0
"""Time loops: order of convergence, statistics, samples, events, reproducibility, failures."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INCONSISTENT, NOT_FINITE, OK
from pitchpoint.elements import drive
from pitchpoint.elements.signal import LAW, OVER_TIME, Pool, set_table
from pitchpoint.elements.speed_profile import straight_pieces
from pitchpoint.multibody.bodies import Body
from pitchpoint.solvers import sampling
from pitchpoint.solvers.constraints.row_notes import explain, redundant_rows, row_notes
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.time import solve_time
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import couplings, gear_rows, rattle, torques
from tests.support.machines import compiled, pair

OMEGA = 2.0 * math.pi * 50.0


def oscillator(damping=0.02):
    """Disc on a torsion spring, 50 Hz."""
    inertia = 0.01
    k, d = inertia * OMEGA**2, 2.0 * damping * inertia * OMEGA
    system = assemble(
        [Body(polar_inertia=inertia, name="disc")], {"coupling": couplings([(1, 0, k, d, 0.0)])}
    )
    state = system.initial_state()
    state.q[0] = 0.01
    return system, state


def exact(t, damping=0.02):
    decay, omega = damping * OMEGA, OMEGA * math.sqrt(1.0 - damping**2)
    return 0.01 * math.exp(-decay * t) * (math.cos(omega * t) + decay / omega * math.sin(omega * t))


def error(method, n):
    system, state = oscillator()
    t = 0.031
    if method == "implicit":
        run = generalized_alpha.start(system, state, t / n, rho_inf=0.9, tolerance=1e-15)
    else:
        begin = runge_kutta.start_adams if method == "adams" else runge_kutta.start_classical
        run = begin(system, state, t / n)
    assert run.advance(n).status == OK
    return abs(run.state().q[0] - exact(t))


@pytest.mark.parametrize(
    ("method", "order", "n"), [("implicit", 2, 400), ("classical", 4, 150), ("adams", 4, 600)]
)
def test_order_of_convergence_on_a_linear_oscillator(method, order, n):
    found = math.log2(error(method, n) / error(method, 2 * n))
    assert found == pytest.approx(order, abs=0.15)


def test_adams_keeps_its_order_where_the_step_changes():
    """The past lies an old step apart: it says nothing about a step of another length, such as the last."""
    errors = []
    for n in (300, 600):
        system, state = oscillator()
        h = 0.031 / n
        run = runge_kutta.start_adams(system, state, h)
        for _ in range(10):
            assert run.advance(n // 20).status == OK
            run.change_step(0.37 * h)
            assert run.advance(1).status == OK
            run.change_step(h)
        errors.append(abs(run.state().q[0] - exact(run.t)))
    assert math.log2(errors[0] / errors[1]) > 3.5


@pytest.mark.parametrize(("damping", "limit"), [(0.0, math.sqrt(2.0)), (0.1, 0.8965)])
def test_adams_is_stable_as_far_as_the_roots_of_its_difference_equation_say(damping, limit):
    """They lie on the unit circle at h omega = 1.414 without damping, at 0.8968 with a tenth of critical."""
    reached = []
    for share in (0.99, 1.01):
        system, state = oscillator(damping)
        run = runge_kutta.start_adams(system, state, share * limit / OMEGA)
        assert run.advance(4000).status == OK
        reached.append(abs(run.state().q[0]) / 0.01)
    assert reached[0] < 1.0 < 1e3 < reached[1]


@pytest.mark.parametrize("order", [5, 8])
def test_adaptive_method_follows_its_tolerance_and_its_dense_output_is_accurate(order):
    errors = []
    for rtol in (1e-5, 1e-8):
        system, state = oscillator()
        run = runge_kutta.start_adaptive(
            system, state, rtol=rtol, atol=rtol * 1e-3, atol_rate=rtol * 1e-1, order=order
        )
        chunk = run.advance_to(0.05, sample=1e-3)
        assert chunk.status == OK
        assert chunk.rows.shape[0] == 50
        index = 1 + system.layout.channel("angle[disc]")
        errors.append(max(abs(row[index] - exact(row[0])) for row in chunk.rows))
    assert errors[0] < 1e-6
    assert errors[1] < 1e-9
    assert run.state().q[0] == pytest.approx(exact(0.05), abs=1e-9)


@pytest.mark.parametrize(("order", "expected"), [(5, 5.0), (8, 8.0)])
def test_a_step_of_an_adaptive_method_has_its_order(order, expected):
    errors = []
    for h in (2e-3, 1e-3):
        system, state = oscillator()
        run = runge_kutta.start_adaptive(system, state, rtol=1.0, atol=1e6, atol_rate=1e6, order=order)
        for k in range(1, round(0.032 / h) + 1):
            system.workspace.arrays["real"][runge_kutta.STEP_SIZE] = h
            assert run.advance_to(k * h).steps == 1
        errors.append(abs(run.state().q[0] - exact(0.032)))
    assert math.log2(errors[0] / errors[1]) == pytest.approx(expected, abs=0.3)


def test_statistics_need_no_stored_series_and_agree_with_one():
    system = rattle()
    run = generalized_alpha.start(system, system.initial_state(), 5e-6)
    sums = sampling.new_statistics(system.sizes["no"])
    chunk = run.advance(2000, every=1, statistics=sums)
    found = sampling.read_statistics(sums)
    series = chunk.rows[:, 1:]
    assert chunk.rows.shape[0] == found.count == 2000
    np.testing.assert_allclose(found.mean, series.mean(axis=0), rtol=1e-9, atol=1e-14)
    np.testing.assert_allclose(found.rms, series.std(axis=0), rtol=1e-7, atol=1e-13)
    np.testing.assert_array_equal(found.least, series.min(axis=0))
    np.testing.assert_array_equal(found.most, series.max(axis=0))
    np.testing.assert_allclose(found.share_negative, (series < 0.0).mean(axis=0))
    np.testing.assert_allclose(found.share_zero, (series == 0.0).mean(axis=0))


def test_same_input_gives_the_same_bits_whatever_the_chunks():
    finals = []
    for chunks in ([3000], [1000, 1, 1999]):
        system = rattle()
        run = generalized_alpha.start(system, system.initial_state(), 5e-6)
        for n in chunks:
            assert run.advance(n).status == OK
        finals.append(np.concatenate([run.state().q, run.state().v, run.state().a]))
    np.testing.assert_array_equal(*finals)


@pytest.mark.parametrize("order", [5, 8])
def test_adaptive_steps_do_not_depend_on_the_chunks(order):
    finals = []
    for most in (1_000_000, 7):
        system = rattle()
        state = system.initial_state()
        state.v[:] = 300.0
        run = runge_kutta.start_adaptive(system, state, order=order, largest_step=1e-3)
        rows = []
        while run.t < 0.05:
            chunk = run.advance_to(0.05, sample=1e-3, most=most)
            assert chunk.status == OK
            rows.append(chunk.rows)
        assert len(np.concatenate(rows)) == 50
        finals.append(np.concatenate([run.state().q, run.state().v, np.concatenate(rows).ravel()]))
    np.testing.assert_array_equal(*finals)


def test_no_step_is_longer_than_allowed():
    """A load that comes and goes within a millisecond, long after everything has come to rest."""
    records = torques([(1, 1.0)])
    pool = Pool()
    set_table(records[0], pool, [0.0, 5.0, 5.0005, 5.001, 10.0], [0.0, 0.0, 4.0, 0.0, 0.0])
    system = assemble([Body(polar_inertia=1.0)], {"torque": records}, pools={"torque": pool.array()})
    run = runge_kutta.start_adaptive(system, system.initial_state(), largest_step=1e-3)
    assert run.advance_to(10.0).status == OK
    assert run.state().v[0] == pytest.approx(0.002, rel=2e-3)


def test_round_off_does_not_grow_with_revolutions():
    accelerations = []
    for turns in (0, 100_000):
        system = rattle()
        state = system.initial_state()
        state.v[:] = 300.0
        state.turns[1:] = turns
        run = generalized_alpha.start(system, state, 5e-6)
        assert run.advance(20000).status == OK
        final = run.state()
        accelerations.append(np.concatenate([final.q, final.v, final.a]))
        assert np.all(np.abs(final.q) <= math.pi)
        assert final.turns[1] - turns == round(300.0 * 0.1 / (2.0 * math.pi))
        angle = evaluate.observe(system, final)[system.layout.channel("angle[a]")]
        assert angle == pytest.approx(300.0 * 0.1 + 2.0 * math.pi * turns, abs=0.01)
    np.testing.assert_array_equal(*accelerations)


def test_a_redundant_constraint_row_is_flagged_and_harmless():
    bodies = [Body(polar_inertia=1.0, name="a"), Body(polar_inertia=4.0, name="b")]
    finals = []
    for rows in ([(1, 2, 20, 40)], [(1, 2, 20, 40), (1, 2, 10, 20)]):
        system = assemble(bodies, {"torque": torques([(1, 3.0)])}, {"ratio": gear_rows(rows)})
        run = generalized_alpha.start(system, system.initial_state(), 1e-3)
        assert run.advance(1000).status == OK
        finals.append(run.state().q)
        # rigid gears: acceleration of a is T / (i_a + i_b (z1/z2)^2), with z2/z1 = 2
        assert run.state().a[0] == pytest.approx(3.0 / (1.0 + 4.0 / 4.0), rel=1e-7)
        assert np.abs(system.workspace.g).max() < 1e-12
    assert list(system.workspace.arrays["used"]) == [1, 0]
    assert redundant_rows(system) == ("ratio ratio1",)
    assert "ratio1: redundant with other" in row_notes(system)[0]
    np.testing.assert_allclose(finals[1], finals[0], rtol=1e-12)


@pytest.mark.parametrize("method", ["implicit", "classical", "adaptive"])
def test_a_row_that_contradicts_another_stops_the_run_by_name(method):
    bodies = [Body(polar_inertia=1.0, name="a"), Body(polar_inertia=4.0, name="b")]
    rows = gear_rows([(1, 2, 20, 40), (1, 2, 10, 20)])
    rows["u0"] = [0.0, 1e-3]
    system = assemble(bodies, {"torque": torques([(1, 3.0)])}, {"ratio": rows}, names={"ratio": "xy"})
    if method == "implicit":
        chunk = generalized_alpha.start(system, system.initial_state(), 1e-3).advance(10)
    elif method == "classical":
        chunk = runge_kutta.start_classical(system, system.initial_state(), 1e-3).advance(10)
    else:
        chunk = runge_kutta.start_adaptive(system, system.initial_state()).advance_to(0.01)
    assert chunk.status == INCONSISTENT
    assert "ratio y is off by 0.001" in explain(system, chunk.status)


def test_a_repeated_row_needs_no_second_iteration_to_hold():
    """A drive that speeds up: the prediction of a step is off by more than the rows may be."""
    bodies = [Body(polar_inertia=1.0, name="a"), Body(polar_inertia=4.0, name="b")]
    drives = np.zeros(2, drive.RECORD)
    drives["i"] = 1
    pool = Pool()
    for record in drives:
        pieces = straight_pieces(np.linspace(0.0, 1.0, 101), np.linspace(0.0, 10.0, 101) ** 2)
        drive.set_speed_pieces(record, pool, pieces)
    system = assemble(bodies, {}, {"drive": drives}, pools={"drive": pool.array()})
    run = generalized_alpha.start(system, system.initial_state(), 1e-4)
    assert run.advance(5000).status == OK
    assert len(redundant_rows(system)) == 1


def test_explicit_methods_hold_constraints_too():
    bodies = [Body(polar_inertia=1.0, name="a"), Body(polar_inertia=4.0, name="b")]
    banks = {"torque": torques([(1, 3.0)])}
    system = assemble(bodies, banks, {"ratio": gear_rows([(1, 2, 20, 40)])})
    run = runge_kutta.start_classical(system, system.initial_state(), 1e-3)
    assert run.advance(1000).status == OK
    assert run.state().v[0] == pytest.approx(1.5, rel=1e-9)
    assert 2.0 * run.state().v[1] == pytest.approx(-1.5, rel=1e-9)


def test_a_law_that_returns_nan_stops_the_run_with_its_status_and_place():
    def law(t, x, p):
        return math.nan if t > 0.01 else 1.0

    records = torques([(1, 1.0)])
    records["form"], records["over"] = LAW, OVER_TIME
    bodies = [Body(polar_inertia=1.0, name="a")]
    pools = {"torque": np.zeros(1)}
    system = assemble(bodies, {"torque": records}, pools=pools, laws={"torque": [law]})
    run = generalized_alpha.start(system, system.initial_state(), 1e-3)
    chunk = run.advance(100)
    assert chunk.status == NOT_FINITE
    assert 9 <= chunk.steps <= 10
    # the state is that of the last finished step
    assert run.state().v[0] == pytest.approx(chunk.steps * 1e-3, rel=1e-12)
    assert run.state().a[0] == pytest.approx(1.0, rel=1e-12)
    assert "torque" in evaluate.explain(system, chunk.status)
    with pytest.raises(SolverError, match="not a number"):
        evaluate.check(system, chunk.status, run.state())


def test_step_must_be_positive():
    system, state = oscillator()
    with pytest.raises(SolverError, match="positive"):
        generalized_alpha.start(system, state, 0.0)


@pytest.mark.parametrize("torque", ["0", "1000*t", "100*sin(2*pi*10*t)"])
@pytest.mark.parametrize("speed", [0.0, 300.0])
def test_a_machine_without_load_at_the_start_starts_in_its_gap(torque, speed):
    damped = "{law: din3990}, damper: {ratio: 0.02}"
    scenario = f"scenarios:\n  turn: {{speed: {{driver: {speed}}}, duration: 1 ms}}\n"
    system = compiled(pair(damped, torque=torque, rest=scenario), "turn")[1]
    found = solve_time(system)
    assert found.attrs["status"] == OK
    assert found["mesh_force[stage]"].values[0] == pytest.approx(0.0, abs=1e-9)
    assert found["contact_state[stage]"].values[0] == 0.0


@pytest.mark.parametrize("method", ["generalized_alpha", "adams"])
def test_statistics_over_samples_are_those_of_the_stored_rows_and_change_no_bit_of_them(method):
    damped = "{law: din3990}, damper: {ratio: 0.02}"
    times = "duration: 4.01 ms, settle_time: 1 ms, step: 10 us, sample_rate: 5 kHz"
    scenario = f"scenarios:\n  turn: {{speed: {{driver: 300}}, {times}, method: {method}, statistics: %s}}\n"
    text = pair(damped, rest=scenario)
    steps, samples = (solve_time(compiled(text % word, "turn")[1]) for word in ("steps", "samples"))
    for name in steps.data_vars:
        np.testing.assert_array_equal(samples[name].values, steps[name].values)
    force = samples["mesh_force[stage]"]
    inside = force.values[force["time"].values > 1.0e-3 + 1e-9]
    np.testing.assert_allclose(
        force.attrs["statistics"], [inside.mean(), inside.std(), inside.min(), inside.max()], rtol=1e-9
    )
    mean, rms, least, most = steps["mesh_force[stage]"].attrs["statistics"]
    assert least < inside.min() < inside.max() < most
    resolutions = [found["contact_state[stage]"].attrs["resolution"] for found in (steps, samples)]
    np.testing.assert_allclose(resolutions, [1e-5, 2e-4], rtol=1e-9)
