# SPDX-License-Identifier: Apache-2.0
"""Weight: potential of the centres of mass, tangents, and a physical pendulum."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.elements.gravity import gravity_records
from pitchpoint.multibody.bodies import TORSION, Body
from pitchpoint.solvers.implicit.generalized_alpha import start
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.forces import along, check_matrices, mechanism, moving, power, wrenches

G = np.array([1.0, 2.0, -9.0])


def height_energy(system, state):
    """Potential of the weights, from the frames."""
    wrenches(system, state)
    fr, total = system.workspace.fr, 0.0
    for k, body in enumerate(system.bodies, start=1):
        axes = fr[k]["S"] if not body.is_round else fr[k]["R"]
        total -= body.mass * G @ (fr[k]["r"] + axes @ body.center_of_mass())
    return total


@pytest.mark.nojit
def test_weights_are_the_gradient_of_their_potential():
    rng = np.random.default_rng(1)
    bodies = mechanism(rng)
    system = assemble(bodies, {"gravity": gravity_records(bodies, G)})
    state = moving(system, rng)
    check_matrices(system, state)
    h = 1e-4
    change = height_energy(system, along(system, state, h)) - height_energy(system, along(system, state, -h))
    assert power(system, state) == pytest.approx(-change / (2.0 * h), rel=1e-6)
    total = sum(body.mass for body in bodies)
    np.testing.assert_allclose(wrenches(system, state)[:, :3].sum(axis=0), total * G, rtol=1e-12)


def test_a_physical_pendulum_has_its_period():
    """m 2 kg, centre at 0.3 m, J 0.4 kg m^2 about the pivot, amplitude 1 rad: complete elliptic integral."""
    from scipy.special import ellipk

    inertia = 0.4 - 2.0 * 0.3**2
    body = Body(
        motion=TORSION,
        axes=np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
        mass=2.0,
        com=(0.0, -0.3, 0.0),
        inertia=np.diag([inertia, 0.5 * inertia, inertia]),
    )
    down = body.axes @ np.array([0.0, -1.0, 0.0])
    system = assemble([body], {"gravity": gravity_records([body], 9.81 * down)})
    state = system.initial_state()
    state.q[0] = 1.0
    period = 4.0 * np.sqrt(0.4 / (2.0 * 9.81 * 0.3)) * ellipk(np.sin(0.5) ** 2)
    run = start(system, state, period / 2000.0, rho_inf=1.0)
    run.advance(2000)
    end = run.state()
    # second order: the error of the angle after a period is of the order (omega h)^2
    assert end.q[0] == pytest.approx(1.0, abs=1e-4)
    assert abs(end.v[0]) < 1e-3
    assert evaluate.residual(system, end).size == 1
