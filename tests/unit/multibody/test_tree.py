# SPDX-License-Identifier: Apache-2.0
"""Trees of bodies with every joint, against rigid clouds of point masses moved by plain matrices.

A body is replaced by point masses of equal mass, centre and inertia; their accelerations come from
differences of positions along q + v t + a t^2/2, and virtual displacements from differences over q. Nothing
of this knows frames, twists, columns or gyroscopic terms.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import CompileError
from pitchpoint.multibody.bodies import FREE, PLANAR, TORSION, Body
from pitchpoint.multibody.joints import (
    AXES,
    CYLINDRICAL,
    FIXED,
    FLOATING,
    PRISMATIC,
    SCREW,
    SPHERICAL,
    UNIVERSAL,
)
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import differences, frame
from tests.support.trees import accelerated, cloud, moving, reference_residual, tree, turning

JOINTS = (
    FIXED,
    TORSION,
    PLANAR,
    FREE,
    PRISMATIC,
    CYLINDRICAL,
    UNIVERSAL,
    SPHERICAL,
    SCREW,
    FLOATING,
)


CHAINS = [((j, k), (0, 1)) for j in JOINTS if j != FIXED for k in JOINTS]
BUSHES = [
    ((SPHERICAL, FIXED, TORSION, UNIVERSAL, SCREW, FLOATING), (0, 1, 2, 2, 1, 4)),
    ((FREE, TORSION, PRISMATIC, CYLINDRICAL, PLANAR, SPHERICAL), (0, 1, 2, 2, 4, 5)),
]


@pytest.mark.parametrize(("motions", "parents"), CHAINS + BUSHES)
def test_inertia_forces_are_those_of_point_masses(motions, parents):
    rng = np.random.default_rng(3)
    bodies = tree(rng, motions, parents)
    system = assemble(bodies, {})
    state = moving(system, rng)
    found = evaluate.residual(system, state)
    np.testing.assert_allclose(found, reference_residual(system, state), atol=3e-7 * np.abs(found).max())


@pytest.mark.nojit
def test_inertia_forces_without_the_compiler():
    test_inertia_forces_are_those_of_point_masses(*BUSHES[1])


@pytest.mark.parametrize(("motions", "parents"), CHAINS + BUSHES)
def test_exact_matrices_are_differences_of_the_residual(motions, parents):
    rng = np.random.default_rng(4)
    system = assemble(tree(rng, motions, parents), {})
    state = moving(system, rng)
    for found, key in zip(evaluate.linearize(system, state), "avq", strict=True):
        expected = differences(system, state, key, 1e-5)
        np.testing.assert_allclose(found, expected, atol=2e-8 * max(1.0, np.abs(expected).max()))


def test_a_round_body_on_ground_moves_as_in_a_tree():
    rng = np.random.default_rng(5)
    for motion in (TORSION, PLANAR, FREE):
        numbers = {"position": rng.normal(size=3), "axes": frame(rng), "mass": 2.0}
        center = 0.2 if motion == FREE else 0.0
        round_one = Body(
            motion=motion, polar_inertia=0.3, transverse_inertia=0.2, center=center, name="a", **numbers
        )
        general = Body(
            motion=motion, com=(0.0, 0.0, center), inertia=np.diag([0.2, 0.2, 0.3]), name="a", **numbers
        )
        systems = [assemble([body], {}) for body in (round_one, general)]
        state = moving(systems[0], rng)
        one, two = (evaluate.residual(s, state) for s in systems)
        np.testing.assert_allclose(two, one, rtol=1e-12, atol=1e-13)
        for a, b in zip(*(evaluate.linearize(s, state) for s in systems), strict=True):
            np.testing.assert_allclose(b, a, rtol=1e-11, atol=1e-12)


@pytest.mark.parametrize("motion", [SPHERICAL, FLOATING])
def test_a_tumbling_body_goes_on_alike_in_a_new_chart(motion):
    rng = np.random.default_rng(6)
    system = assemble(tree(rng, (motion, TORSION), (0, 1)), {})
    state = moving(system, rng)
    d = system.layout.coordinate("b1.beta")
    state.q[d] = 1.1
    before = accelerated(system, state)
    w = system.workspace
    evaluate.send_request(w, evaluate.WRAP)
    after = evaluate.store(system, 0.0)
    assert after.q[d] == 0.0
    np.testing.assert_allclose(after.charts[0] @ after.charts[0].T, np.eye(3), atol=1e-14)
    evaluate.residual(system, after)
    for name in ("r", "S", "tw", "ac"):
        np.testing.assert_allclose(w.fr[name], before[name], rtol=1e-12, atol=1e-12)
    solved = accelerated(system, after)
    np.testing.assert_allclose(solved["ac"], before["ac"], rtol=1e-11, atol=1e-11)


def test_a_child_on_a_spinning_parent_counts_its_turns():
    bodies = [
        Body(polar_inertia=1.0, name="carrier"),
        Body(parent=1, position=(1.0, 0.0, 0.0), mass=1.0, polar_inertia=0.1, name="planet"),
        Body(parent=1, axes=turning(np.pi, 0), mass=1.0, polar_inertia=0.1, name="upside down"),
    ]
    system = assemble(bodies, {})
    state = system.initial_state()
    state.q[:] = 0.4
    state.turns[1] = 3
    evaluate.residual(system, state)
    fr = system.workspace.fr
    assert fr["base"].tolist() == [0.0, 0.0, 0.4, -0.4]
    assert fr["base_turns"].tolist() == [0, 0, 3, -3]


def test_bodies_that_cannot_be():
    with pytest.raises(CompileError, match="b1: the parent, body 2, is not among the 0 bodies before it"):
        assemble(tree(np.random.default_rng(1), (TORSION, TORSION), (2, 0)), {})
    with pytest.raises(CompileError, match="inertia must be physical"):
        assemble([Body(inertia=np.diag([1.0, 1.0, 3.0]), mass=1.0)], {})
    with pytest.raises(CompileError, match="a screw joint requires a lead"):
        assemble([Body(motion=SCREW, mass=1.0, inertia=np.eye(3))], {})
    with pytest.raises(CompileError, match="mass and inertia must not be negative"):
        assemble([Body(parent=0, mass=-1.0, inertia=np.eye(3))], {})


def test_clouds_have_the_mass_they_stand_for():
    rng = np.random.default_rng(2)
    body = tree(rng, (TORSION,), (0,))[0]
    masses, points = cloud(body)
    assert masses.sum() == pytest.approx(body.mass)
    np.testing.assert_allclose(masses @ points, body.mass * np.asarray(body.com), atol=1e-12)
    second = np.einsum("k,ki,kj->ij", masses, points, points)
    np.testing.assert_allclose(np.trace(second) * np.eye(3) - second, body.tensor(), atol=1e-12)
    assert all(len(AXES[j]) <= 6 for j in JOINTS)
