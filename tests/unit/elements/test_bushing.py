# SPDX-License-Identifier: Apache-2.0
"""Bushings: rotation vector, energy, tangents, balance, invariance, large turns."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from pitchpoint.elements import bushing
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.joints import FLOATING
from pitchpoint.solvers.implicit.generalized_alpha import start
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import frame, positive
from tests.support.forces import (
    ENDS,
    along,
    check_balance,
    check_matrices,
    markers,
    mechanism,
    moved_world,
    moving,
    power,
    wrenches,
)


def made(rng, i, j, symmetric=True):
    record = np.zeros(1, bushing.RECORD)
    record["i"], record["j"] = i, j
    record["p_i"], record["p_j"] = 0.2 * rng.normal(size=(2, 3))
    record["A_i"], record["A_j"] = frame(rng), frame(rng)
    record["K"], record["D"] = positive(rng), 0.2 * positive(rng)
    record["x0"] = 0.1 * rng.normal(size=6)
    return record


def displacement(system, record, state):
    """Displacement of marker i in the axes of marker j, rotation vector from SciPy."""
    r, A = markers(system, record, state)
    s = Rotation.from_matrix(A[1].T @ A[0]).as_rotvec()
    return np.concatenate([A[1].T @ (r[0] - r[1]), s]) - record["x0"][0]


@pytest.mark.nojit
@pytest.mark.parametrize(("i", "j"), ENDS)
def test_energy_balance_and_tangents_anywhere_in_a_tree(i, j):
    rng = np.random.default_rng(10 * i + j)
    record = made(rng, i, j)
    system = assemble(mechanism(rng), {"bushing": record})
    state = moving(system, rng)
    check_matrices(system, state)
    check_balance(system, state)
    h = 1e-4
    near, far = (displacement(system, record, along(system, state, s * h)) for s in (-1.0, 1.0))
    x, rate = displacement(system, record, state), (far - near) / (2.0 * h)
    lost = rate @ record["D"][0] @ rate
    stored = (far @ record["K"][0] @ far - near @ record["K"][0] @ near) / (4.0 * h)
    assert power(system, state) == pytest.approx(-stored - lost, rel=1e-6)
    found = evaluate.observe(system, state)
    first = system.layout.channel("bushing_force[bushing0.fx]")
    np.testing.assert_allclose(
        found[first : first + 3], -(record["K"][0] @ x + record["D"][0] @ rate)[:3], rtol=1e-6, atol=1e-6
    )


def test_a_bushing_moves_with_the_world():
    rng = np.random.default_rng(6)
    bodies, record = mechanism(rng), made(rng, 3, 0)
    one = assemble(bodies, {"bushing": record})
    state = moving(one, rng)
    moved, turn, shift = moved_world(bodies, rng)
    other = record.copy()
    other["p_j"], other["A_j"] = turn @ record["p_j"][0] + shift, turn @ record["A_j"][0]
    two = assemble(moved, {"bushing": other})
    np.testing.assert_allclose(evaluate.residual(two, state), evaluate.residual(one, state), atol=1e-11)


@pytest.mark.parametrize("angle", [0.0, 1e-9, 1e-5, 0.05, 0.1999, 0.2001, 1.0, 2.0, 3.0, 3.1, np.pi - 1e-6])
def test_torsion_of_any_size_is_the_angle(angle):
    """A turn by any angle about any axis: moment = stiffness times angle, from zero to half a turn."""
    rng = np.random.default_rng(3)
    for axis in (*np.eye(3), frame(rng)[0]):
        record = np.zeros(1, bushing.RECORD)
        bushing.defaults(record[0])
        record["i"], record["K"] = 1, 7.0 * np.eye(6)
        record["A_j"] = Rotation.from_rotvec(-angle * axis).as_matrix()
        system = assemble([Body(motion=FLOATING, mass=1.0, inertia=np.eye(3))], {"bushing": record})
        state = system.initial_state()
        F = wrenches(system, state)[1, 3:]
        np.testing.assert_allclose(F, -7.0 * angle * axis, atol=1e-8)
        if angle < 3.1:
            K = evaluate.linearize(system, state)[2]
            assert np.all(np.isfinite(K))


def test_energy_of_a_tumbling_body_is_kept():
    """Large rotations up to 2 rad on a soft bushing with a full matrix: energy to the order of the scheme."""
    rng = np.random.default_rng(2)
    record = made(rng, 1, 0)
    record["A_i"], record["A_j"], record["x0"], record["D"] = np.eye(3), np.eye(3), 0.0, 0.0
    record["p_i"] = record["p_j"] = 0.0
    record["K"][0, 3:] *= 0.3
    record["K"][0] = 0.5 * (record["K"][0] + record["K"][0].T) + 2.0 * np.eye(6)
    body = Body(motion=FLOATING, mass=1.0, inertia=np.diag([1.0, 0.8, 0.6]))
    system = assemble([body], {"bushing": record})
    state = system.initial_state()
    state.v[:] = 0.5, -0.4, 0.2, 2.0, -1.5, 1.0

    def energy(state):
        x = displacement(system, record, state)
        M = evaluate.matrix(system, state, 1.0, 0.0, 0.0)
        return 0.5 * x @ record["K"][0] @ x + 0.5 * state.v @ M @ state.v, np.linalg.norm(x[3:])

    before, errors, largest = energy(state)[0], [], 0.0
    for h in (2e-3, 1e-3):
        run, worst = start(system, state, h, rho_inf=1.0), 0.0
        for _ in range(40):
            run.advance(round(0.05 / h))
            value, turn = energy(run.state())
            worst, largest = max(worst, abs(value - before)), max(largest, turn)
        errors.append(worst / before)
    assert largest > 1.0
    # second order: halving the step takes the error to a quarter
    assert errors[1] < 1e-4
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.3)
