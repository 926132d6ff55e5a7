# SPDX-License-Identifier: Apache-2.0
"""Assembly from numbers: faults, layout, copies, pickles, threads."""

from __future__ import annotations

import math
import pickle
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from pitchpoint.core.errors import CompileError
from pitchpoint.core.formula.formula import Formula
from pitchpoint.core.nomenclature import unit
from pitchpoint.core.status import OK
from pitchpoint.elements import drive, torque
from pitchpoint.elements.signal import OVER_ANGLE, OVER_SPEED, Pool, set_formula, set_law, set_table
from pitchpoint.elements.speed_profile import straight_pieces
from pitchpoint.multibody.bodies import FREE, PLANAR, Body
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.model_damping import modal_damping
from pitchpoint.system import evaluate
from pitchpoint.system.layout import group
from pitchpoint.system.requests import WRAP, send_request
from pitchpoint.system.system import assemble
from tests.support.engine import bearings, chain, couplings, damping_records, differences, rattle, torques


def test_all_faults_of_the_bodies_come_at_once():
    bad = [
        Body(name="a"),
        Body(motion=PLANAR, polar_inertia=1.0, name="b"),
        Body(motion=5, name="c"),
        Body(motion=FREE, polar_inertia=1.0, mass=1.0, axes=np.zeros((3, 3)), name="c"),
    ]
    with pytest.raises(CompileError) as caught:
        assemble(bad, {})
    text = str(caught.value)
    for part in (
        "a: polar_inertia",
        "b: mass",
        "c: motion 5",
        "right-handed",
        "transverse",
        "must be unique",
    ):
        assert part in text


def test_records_must_fit_their_kind_and_name_existing_bodies():
    body = Body(polar_inertia=1.0, name="a")
    with pytest.raises(CompileError, match="does not exist"):
        assemble([body], {"coupling": couplings([(1, 2, 1.0, 0.0, 0.0)])})
    with pytest.raises(CompileError, match="do not have the dtype"):
        assemble([body], {"coupling": torques([(1, 1.0)])})
    with pytest.raises(CompileError, match="'spring' is not an element kind"):
        assemble([body], {"spring": torques([(1, 1.0)])})


def test_small_neighbours_share_a_node():
    assert group([0, 1, 1, 1], {(1, 2), (2, 3)}) == [[1, 2, 3]]
    assert group([0, 6, 6], {(1, 2)}) == [[1], [2]]
    assert group([0] + [1] * 8, {(k, k + 1) for k in range(1, 8)}) == [[1, 2, 3, 4, 5, 6], [7, 8]]
    assert group([0, 1, 1], set()) == [[1], [2]]


def test_names_of_coordinates_and_channels():
    system = assemble([Body(motion=PLANAR, mass=1.0, polar_inertia=1.0, name="gear")], {})
    assert system.layout.coordinates == ("gear.x", "gear.y", "gear.spin")
    names = [c.name for c in system.layout.channels]
    assert names == ["displacement[gear.x]", "displacement[gear.y]", "angle[gear]", "speed[gear]"]


def test_initial_angle_becomes_remainder_and_turns():
    system = assemble([Body(polar_inertia=1.0, angle=20.0, name="a")], {})
    state = system.initial_state()
    assert state.turns[1] == 3
    assert state.q[0] == pytest.approx(20.0 - 6.0 * math.pi)
    assert evaluate.observe(system, state)[0] == pytest.approx(20.0)


def run(system, n=500):
    going = generalized_alpha.start(system, system.initial_state(), 5e-6)
    assert going.advance(n).status == OK
    return going.state().q


def test_copies_pickles_and_threads_give_the_same_bits():
    system = rattle()
    expected = run(system)
    np.testing.assert_array_equal(run(system.copy()), expected)
    np.testing.assert_array_equal(run(pickle.loads(pickle.dumps(system))), expected)
    with ThreadPoolExecutor(2) as pool:
        for found in pool.map(run, [system.copy() for _ in range(4)]):
            np.testing.assert_array_equal(found, expected)


def test_with_params_changes_numbers_not_topology():
    system = rattle()
    records = system.records["torque"].copy()
    records["value"] *= 2.0
    other = system.with_params({"torque": records})
    assert np.abs(evaluate.residual(other, other.initial_state())[0]) == pytest.approx(200.0)
    assert np.abs(evaluate.residual(system, system.initial_state())[0]) == pytest.approx(100.0)
    records["i"] = 2
    with pytest.raises(CompileError, match="'i'"):
        system.with_params({"torque": records})
    with pytest.raises(CompileError, match="number"):
        system.with_params({"torque": records[:1]})


def loads(fill, laws=()):
    pool = Pool()
    records = np.zeros(1, torque.RECORD)
    records["i"] = 1
    fill(records[0], pool)
    body = Body(motion=FREE, mass=1.0, polar_inertia=0.3, transverse_inertia=0.2, name="a")
    return assemble([body], {"torque": records}, pools={"torque": pool.array()}, laws={"torque": list(laws)})


def brake(t, x, p):
    return -p[0] * x * x


@pytest.mark.parametrize("case", ["formula", "angle table", "speed table", "law"])
def test_torque_of_every_form_has_value_and_tangents(case):
    formula = Formula.parse("3 + 2*sin(4*angle) - 0.1*speed*t", ("t", "angle", "speed"))
    fills = {
        "formula": lambda r, p: set_formula(r, p, formula),
        "angle table": lambda r, p: set_table(r, p, [0, 3, 2 * math.pi], [1, 4, 1], OVER_ANGLE, 2 * math.pi),
        "speed table": lambda r, p: set_table(r, p, [-50.0, 50.0], [5.0, -5.0], OVER_SPEED),
        "law": lambda r, p: set_law(r, p, [0.25]),
    }
    expected = {
        "formula": 3.0 + 2.0 * math.sin(4.8) - 0.1 * 7.0 * 2.0,
        "angle table": 1.0 + 1.2,
        "speed table": -0.7,
        "law": -0.25 * 49.0,
    }
    system = loads(fills[case], [brake] if case == "law" else [])
    state = system.initial_state()
    state.t = 2.0
    state.q[5], state.v[5] = 1.2, 7.0
    assert evaluate.observe(system, state)[0] == pytest.approx(expected[case], rel=1e-12)
    state.q[3:5], state.v[3:5] = [1e-3, -2e-3], [0.1, 0.2]
    _, D, K = evaluate.linearize(system, state)
    scale = np.abs(D).max() + np.abs(K).max()
    np.testing.assert_allclose(D, differences(system, state, "v"), atol=1e-7 * scale)
    # the angle of a tilted body is taken along its axis: equal to first order in the tilt
    np.testing.assert_allclose(K, differences(system, state, "q"), atol=5e-3 * scale)


@pytest.mark.parametrize("form", ["speed", "table", "formula"])
def test_drives_prescribe_the_spin(form):
    pool = Pool()
    records = np.zeros(1, drive.RECORD)
    records["i"] = 1
    if form == "speed":
        records["speed"] = 30.0
    elif form == "table":
        drive.set_speed_pieces(records[0], pool, straight_pieces([0.0, 0.1, 1.0], [0.0, 30.0, 30.0]))
    else:
        drive.set_angle_formula(records[0], pool, Formula.parse("100*t^2", ("t",)))
    expected = {"speed": (6.0, 30.0), "table": (4.5, 30.0), "formula": (4.0, 40.0)}[form]
    system = assemble(
        [Body(polar_inertia=2.0, name="a")], {}, {"drive": records}, pools={"drive": pool.array()}
    )
    state = system.initial_state()
    state.v[0] = 30.0 if form == "speed" else 0.0
    going = generalized_alpha.start(system, state, 1e-4)
    assert going.advance(2000).status == OK
    row = evaluate.observe(system, going.state())
    assert row[system.layout.channel("angle[a]")] == pytest.approx(expected[0], abs=1e-9)
    assert row[system.layout.channel("speed[a]")] == pytest.approx(expected[1], abs=1e-3)
    if form == "formula":  # torque = inertia x 200 rad/s^2
        assert row[system.layout.channel("torque[drive0]")] == pytest.approx(400.0, rel=1e-3)


def test_modal_damping_gives_every_mode_its_ratio_and_leaves_the_spin_alone():
    inertias, springs = [0.01, 0.02, 0.03], [1e4, 2e4]
    plain = chain(inertias, springs)
    M, _, K = evaluate.linearize(plain, plain.initial_state())
    dofs = [(int(b["dof"]), int(b["joint"])) for b in plain.program["body"]]
    records = damping_records(modal_damping(M, K, np.eye(3), np.ones((1, 3)), 0.03), dofs)
    system = chain(inertias, springs, damping=records)
    _, D, _ = evaluate.linearize(system, system.initial_state())
    A = np.block([[np.zeros((3, 3)), np.eye(3)], [-np.linalg.solve(M, K), -np.linalg.solve(M, D)]])
    values = np.linalg.eigvals(A)
    elastic = values[np.abs(values) > 1.0]
    np.testing.assert_allclose(-elastic.real / np.abs(elastic), 0.03, rtol=1e-9)
    np.testing.assert_allclose(D @ np.ones(3), 0.0, atol=1e-9)


def test_bearing_between_bodies_is_in_the_matrix_of_both():
    bodies = [
        Body(motion=FREE, mass=1.0, polar_inertia=1.0, transverse_inertia=1.0, name=n) for n in ("a", "b")
    ]
    K = np.diag([2.0, 3.0, 4.0, 5.0, 6.0, 7.0])
    system = assemble(bodies, {"bearing": bearings([(1, 2, K, 0.1 * K)])})
    _, D, found = evaluate.linearize(system, system.initial_state())
    expected = np.block([[K, -K], [-K, K]])
    np.testing.assert_allclose(found, expected, atol=1e-12)
    np.testing.assert_allclose(D, 0.1 * expected, atol=1e-12)


def test_forces_between_bodies_are_those_of_a_coupling():
    bodies = [
        Body(motion=FREE, mass=1.0, polar_inertia=1.0, transverse_inertia=1.0, name=n) for n in ("a", "b")
    ]
    K = np.eye(6)
    system = assemble(
        bodies,
        {"bearing": bearings([(1, 2, K, K), (1, 0, K, K)])},
        names={"bearing": ("shaft", "front")},
    )
    found = {c.name: c for c in system.layout.channels}
    assert [n for n in found if n.startswith("coupling")] == [
        f"coupling_force[shaft.{k}]" for k in ("fx", "fy", "fz", "mx", "my", "mz")
    ]
    assert "bearing_force[front.mz]" in found
    assert found["coupling_force[shaft.fx]"].long_name == "force on the first body, x"
    for name, channel in found.items():
        assert unit(name) == channel.unit


@pytest.mark.parametrize("spin", [1e13, 1e300, math.inf, -math.inf, math.nan])
def test_a_spin_that_runs_away_cannot_stop_the_wrapping(spin):
    system = chain([1.0], [])
    evaluate.prepare(system)
    evaluate.load(system, system.initial_state())
    system.workspace.q[0] = spin
    send_request(system.workspace, WRAP)
    assert system.workspace.q[0] == pytest.approx(spin, nan_ok=True)
    system.workspace.q[0] = 1e6 + 0.25
    send_request(system.workspace, WRAP)
    assert abs(system.workspace.q[0]) <= math.pi
    turns = int(system.workspace.fr["turns"][1])
    assert system.workspace.q[0] + 2.0 * math.pi * turns == pytest.approx(1e6 + 0.25, rel=1e-12)
