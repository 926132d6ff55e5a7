# SPDX-License-Identifier: Apache-2.0
"""Cut joints: what the joint leaves free, derivatives against differences, motion as in a tree."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.elements.closure_rows import cut_joint, rod
from pitchpoint.multibody.bodies import FREE, TORSION, Body
from pitchpoint.multibody.joints import (
    AXES,
    CYLINDRICAL,
    FIXED,
    FLOATING,
    PLANAR,
    PRISMATIC,
    SCREW,
    SPHERICAL,
    UNIVERSAL,
)
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import differences, frame
from tests.support.trees import moving, tree

CUT = (FIXED, TORSION, PLANAR, PRISMATIC, CYLINDRICAL, UNIVERSAL, SPHERICAL, SCREW)


def looped(rng, motion, motions=(FLOATING, FLOATING), parents=(0, 0)):
    """Bodies in a tree, the last one held to the one before by a cut joint or a rod at a random place."""
    bodies = tree(rng, motions, parents)
    i = len(bodies)
    if motion == "rod":
        records = rod(bodies, i, i - 1, rng.normal(size=3), rng.normal(size=3))
    else:
        records, words = cut_joint(motion, bodies, i, i - 1, rng.normal(size=3), frame(rng), 0.1)
        assert len(words) == 6 - len(AXES[motion])
    return assemble(bodies, {}, {"closure": records})


def rows(system, state):
    evaluate.residual(system, state)
    return system.workspace.g.copy()


@pytest.mark.parametrize("motion", [*CUT, "rod"])
def test_rows_hold_in_the_assembled_place(motion):
    system = looped(np.random.default_rng(1), motion)
    np.testing.assert_allclose(rows(system, system.initial_state()), 0.0, atol=1e-14)


@pytest.mark.nojit
@pytest.mark.parametrize("motion", [*CUT, "rod"])
def test_rows_are_the_derivatives_of_g(motion):
    rng = np.random.default_rng(2)
    system = looped(rng, motion)
    state = moving(system, rng)
    state.q *= 0.3
    n, h = system.sizes["nd"], 1e-6
    found = evaluate.constraint_jacobian(system, state)
    for k in range(n):
        ends = []
        for sign in (1.0, -1.0):
            moved = state.copy()
            moved.q[k] += sign * h
            ends.append(rows(system, moved))
        np.testing.assert_allclose(found[:, k], (ends[0] - ends[1]) / (2 * h), atol=3e-9)
    # second derivative along a motion of constant rates: gtt at a = 0
    state.a[:] = 0.0
    evaluate.residual(system, state)
    gtt = system.workspace.gtt.copy()
    h = 1e-3
    path = {}
    for s in (-2, -1, 0, 1, 2):
        moved = state.copy()
        moved.q = state.q + s * h * state.v
        path[s] = rows(system, moved)
    second = (16 * (path[1] + path[-1]) - path[2] - path[-2] - 30 * path[0]) / (12 * h * h)
    np.testing.assert_allclose(gtt, second, atol=1e-7 * (1.0 + np.abs(second).max()))


@pytest.mark.parametrize("motion", [*CUT, "rod"])
def test_tangents_of_the_constraint_forces_are_exact(motion):
    rng = np.random.default_rng(3)
    system = looped(rng, motion, (FREE, SPHERICAL, FLOATING), (0, 1, 0))
    state = moving(system, rng)
    state.q *= 0.5
    state.lam = rng.normal(size=state.lam.size)
    _, D, K = evaluate.linearize(system, state)
    for found, key in ((D, "v"), (K, "q")):
        expected = differences(system, state, key, 1e-5)
        np.testing.assert_allclose(found, expected, atol=3e-8 * max(1.0, np.abs(expected).max()))


def accelerated(system, state):
    """Frames with the accelerations that follow from a state."""
    evaluate.prepare(system)
    evaluate.load(system, state)
    evaluate.check(system, evaluate.send_request(system.workspace, evaluate.ACCELERATE, 0.0))
    evaluate.residual(system, evaluate.store(system, 0.0))
    return system.workspace.fr.copy()


@pytest.mark.parametrize("motion", CUT)
def test_a_cut_joint_accelerates_like_the_same_joint_of_a_tree(motion):
    rng = np.random.default_rng(4)
    one, two = tree(rng, (FLOATING, motion), (0, 1))
    hung = assemble([one, two], {})
    state = moving(hung, rng)
    state.q *= 0.5
    fr = accelerated(hung, state)

    loose = Body(**{**two.__dict__, "motion": FLOATING, "parent": 0, "lead": 0.0})
    records, _ = cut_joint(motion, [one, loose], 2, 1, two.position, two.axes, two.lead)
    cut = assemble([one, loose], {}, {"closure": records})
    same = cut.initial_state()
    same.q[:6], same.v[:6] = state.q[:6], state.v[:6]
    # put the second body where the tree has it: its attitude into the chart, rates as components of its twist
    axes = np.asarray(two.axes)
    same.charts[1] = axes.T @ fr["S"][2]
    same.q[6:9], same.v[6:9] = axes.T @ (fr["r"][2] - two.position), axes.T @ fr["tw"][2, :3]
    same.v[9:] = fr["S"][2].T @ fr["tw"][2, 3:]
    np.testing.assert_allclose(rows(cut, same), 0.0, atol=1e-13)
    np.testing.assert_allclose(cut.workspace.G @ same.v, 0.0, atol=1e-12)
    np.testing.assert_allclose(accelerated(cut, same)["ac"], fr["ac"], rtol=1e-9, atol=1e-9)


def test_redundant_rows_do_no_harm():
    """A door on two hinges: the second takes two directions that the first leaves, and repeats the rest."""
    door = Body(motion=TORSION, mass=1.0, com=(0.4, 0.0, 0.0), inertia=0.1 * np.eye(3), name="door")
    records, _ = cut_joint(TORSION, [door], 1, 0, (0.0, 0.0, 1.0), np.eye(3))
    system = assemble([door], {}, {"closure": records})
    state = system.initial_state()
    state.v[0] = 2.0
    accelerated(system, state)
    np.testing.assert_allclose(system.workspace.a, 0.0, atol=1e-12)
    assert not system.workspace.arrays["used"].any()


def test_a_screw_counts_its_turns_by_the_way_along_its_axis():
    bodies = [Body(motion=FREE, mass=1.0, inertia=np.eye(3) * 0.1, name="nut")]
    records, _ = cut_joint(SCREW, bodies, 1, 0, np.zeros(3), np.eye(3), 0.01)
    system = assemble(bodies, {}, {"closure": records})
    state = system.initial_state()
    state.q[2], state.q[5], state.turns[1] = 0.01 * (7 * 2 * np.pi + 1.0), 1.0, 7
    np.testing.assert_allclose(rows(system, state), 0.0, atol=1e-14)
