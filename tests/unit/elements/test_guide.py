# SPDX-License-Identifier: Apache-2.0
"""Joints made of functions: moved frames against the same motion of a joint, paths against plain geometry."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.formula.formula import Formula
from pitchpoint.elements import guide
from pitchpoint.elements.signal import Pool
from pitchpoint.multibody.bodies import FREE, Body
from pitchpoint.multibody.joints import FLOATING, GUIDED, SPHERICAL, TORSION
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import differences
from tests.support.trees import cloud, moving, poses, tree

TIMES = ("0.3*sin(2*t)", "0.2*t^2", "0.1*cos(3*t)", "0.5*sin(t)", "0.4*cos(2*t)", "1.5*t")
PATH = ("cos(t)", "0.5*sin(t)", "0.2*t", "0.3*t", "0.1*t^2", "t")


def records(rows):
    """Records and pool from rows (body, displacement, coordinate, formula of t)."""
    pool = Pool()
    found = np.zeros(len(rows), guide.RECORD)
    seen = set()
    for record, (body, m, k, text) in zip(found, rows, strict=True):
        record["i"], record["m"], record["k"], record["first"] = body, m, k, body not in seen
        seen.add(body)
        guide.set_formula(record, pool, Formula.parse(text, ("t",)))
    return found, pool.array()


def with_guide(bodies, rows, **more):
    found, pool = records(rows)
    return assemble(bodies, {**more, "guide": found}, pools={"guide": pool})


@pytest.mark.nojit
def test_a_moved_frame_moves_like_a_joint_with_the_same_displacements():
    rng = np.random.default_rng(1)
    free, child = tree(rng, (FREE, TORSION), (0, 1))
    moved = Body(**{**free.__dict__, "motion": GUIDED})
    driven = with_guide([moved, child], [(1, m, guide.TIME, text) for m, text in enumerate(TIMES)])
    same = assemble([free, child], {})
    t, h = 0.7, 1e-3
    values = np.array([[f(x) for x in t + h * np.arange(-2, 3)] for f in _plain(TIMES)])
    rates = values @ [1.0, -8.0, 0.0, 8.0, -1.0] / (12 * h)
    seconds = values @ [-1.0, 16.0, -30.0, 16.0, -1.0] / (12 * h * h)
    one, two = driven.initial_state(), same.initial_state()
    one.t = two.t = t
    one.q[0], one.v[0], one.a[0] = 0.4, 1.2, -0.7
    two.q[:], two.v[:], two.a[:] = (
        [*values[:, 2], 0.4],
        [*rates, 1.2],
        [*seconds, -0.7],
    )
    found = evaluate.residual(driven, one)
    expected = evaluate.residual(same, two)
    for name in ("r", "S", "tw", "ac"):
        np.testing.assert_allclose(
            driven.workspace.fr[name], same.workspace.fr[name], rtol=1e-8, atol=1e-8, err_msg=name
        )
    np.testing.assert_allclose(found, expected[6:], rtol=1e-7)


def _plain(texts):
    return [Formula.parse(text, ("t",)) for text in texts]


@pytest.mark.parametrize("parent", [0, 1])
def test_a_path_of_one_coordinate_has_the_inertia_of_point_masses(parent):
    """Kinetic energy along the path against differences of the places that plain functions give."""
    rng = np.random.default_rng(2)
    base, body = tree(rng, (TORSION, FLOATING), (0, parent))
    guided = Body(**{**body.__dict__, "motion": GUIDED, "guided_by": (("s", "rad"),)})
    system = with_guide([base, guided], [(2, m, 0, text) for m, text in enumerate(PATH)])
    shadow = assemble([base, body], {})
    state = moving(system, rng)
    d = system.layout.coordinate("b2.s")
    other = system.layout.coordinate("b1.spin")

    def shadowed(q):
        found = shadow.initial_state()
        found.q[shadow.layout.coordinate("b1.spin")] = q[other]
        dof = shadow.program["body"][2]["dof"]
        found.q[dof : dof + 6] = [f(q[d]) for f in _plain(PATH)]
        return found

    found = evaluate.residual(system, state)

    def places(q):
        at = shadowed(q)
        frames = poses(shadow.bodies, at.q, shadow.program["body"]["dof"][1:], at.charts)[1:]
        return np.concatenate(
            [r + cloud(b)[1] @ S.T for b, (r, S) in zip(shadow.bodies, frames, strict=True)]
        )

    step = 2e-3
    weights = np.repeat([b.mass / 6.0 for b in shadow.bodies], 6)
    path = {k: places(state.q + k * step * state.v + 0.5 * (k * step) ** 2 * state.a) for k in range(-3, 4)}
    second = 270.0 * (path[1] + path[-1]) - 27.0 * (path[2] + path[-2]) + 2.0 * (path[3] + path[-3])
    second = (second - 490.0 * path[0]) / (180.0 * step**2)
    for k in range(2):
        unit = np.zeros(2)
        unit[k] = step
        near, far = (places(state.q + s * unit) - places(state.q - s * unit) for s in (1.0, 2.0))
        expected = np.einsum("p,pi,pi->", weights, second, (8.0 * near - far) / (12.0 * step))
        assert found[k] == pytest.approx(expected, rel=1e-6)


def test_exact_matrices_follow_the_functions():
    rng = np.random.default_rng(3)
    bodies = tree(rng, (SPHERICAL, TORSION, TORSION, TORSION), (0, 1, 2, 3))
    two = {**bodies[1].__dict__, "motion": GUIDED, "guided_by": (("s", "rad"), ("u", "m"))}
    three = {**bodies[2].__dict__, "motion": GUIDED}
    bodies[1], bodies[2] = Body(**two), Body(**three)
    rows = [(2, m, 0, text) for m, text in enumerate(PATH)]
    rows += [(2, m, 1, text) for m, text in enumerate(TIMES)]
    rows += [(3, m, guide.TIME, text) for m, text in enumerate(TIMES)]
    system = with_guide(bodies, rows)
    state = moving(system, rng)
    state.t = 0.4
    for found, key in zip(evaluate.linearize(system, state), "avq", strict=True):
        expected = differences(system, state, key, 1e-5)
        np.testing.assert_allclose(found, expected, atol=1e-7 * max(1.0, np.abs(expected).max()))


def test_tables_are_splines_with_their_own_derivatives():
    x = np.linspace(0.0, 2.0 * np.pi, 41)
    for period in (0.0, 2.0 * np.pi):
        pool, row = Pool(), np.zeros(1, guide.RECORD)
        guide.set_table(row[0], pool, x, np.sin(x), period)
        array = pool.array()
        row["pool"] = array.ctypes.data
        at = np.array([0.3, 1.7, 6.1])
        found = np.array([values(row, a) for a in at])
        np.testing.assert_allclose(found[:, 0], np.sin(at), atol=3e-6)  # h^4/384 of the fourth derivative
        np.testing.assert_allclose(found[:, 1], np.cos(at), atol=2e-4)
        np.testing.assert_allclose(found[:, 2], -np.sin(at), atol=5e-3)
        outside = values(row, 2.0 * np.pi + 0.3)
        expected = (np.sin(0.3), np.cos(0.3), -np.sin(0.3)) if period else (np.sin(x[-1]), 0.0, 0.0)
        np.testing.assert_allclose(outside, expected, atol=5e-3)


def values(row, x):
    """Value and derivatives of the function of a record, through a guided body."""
    probe = row.copy()
    probe["i"], probe["m"], probe["k"], probe["first"] = 1, 0, 0, 1
    body = Body(motion=GUIDED, guided_by=(("s", "m"),), mass=1.0, inertia=np.eye(3))
    system = assemble([body], {"guide": probe})
    state = system.initial_state()
    state.q[0] = x
    evaluate.residual(system, state)
    g = system.workspace.arrays["guides"][0]
    return g["d"][0], g["by"][0, 0], g["by2"][0, 0]


def test_python_functions_are_fitted():
    pool, row = Pool(), np.zeros(1, guide.RECORD)
    guide.set_function(row[0], pool, lambda t: np.sin(40.0 * t), 0.0, 1.0)
    array = pool.array()
    row["pool"] = array.ctypes.data
    found = values(row, 0.321)
    np.testing.assert_allclose(found[:2], (np.sin(12.84), 40.0 * np.cos(12.84)), rtol=1e-6)
    assert found[2] == pytest.approx(-1600.0 * np.sin(12.84), rel=1e-4)
