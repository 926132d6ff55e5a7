# SPDX-License-Identifier: Apache-2.0
"""Friction of joints: slides and pins against plain mechanics, cut joints against the same ones in a tree."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.elements import joint_friction
from pitchpoint.elements.closure_rows import cut_joint
from pitchpoint.elements.gravity import gravity_records
from pitchpoint.elements.signal import Pool
from pitchpoint.multibody.bodies import TORSION, Body
from pitchpoint.multibody.joints import FLOATING, PRISMATIC
from pitchpoint.solvers.constraints.assembly import assemble_state
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble

G = 9.81


def friction(bodies, i, j=0, form=joint_friction.TURN, **numbers):
    """One record for the tree joint of body i at its origin, axis along its third axis, with its pool."""
    row, pool = np.zeros(1, joint_friction.RECORD), Pool()
    body = bodies[i - 1]
    row["i"], row["j"], row["form"] = i, j, form
    base = bodies[j - 1] if j else Body()
    row["p_j"] = np.asarray(base.axes).T @ np.subtract(body.position, base.position)
    row["axis"] = np.asarray(base.axes).T @ np.asarray(body.axes)[:, 2]
    beyond = joint_friction.bodies_beyond(bodies, i)
    row["n_beyond"], row["beyond"] = beyond.size, pool.add(beyond.view(np.float64))
    row["ratio"] = 1.0
    for name, value in numbers.items():
        row[name] = value
    return row, pool.array()


def acceleration(system, state):
    evaluate.prepare(system)
    evaluate.load(system, state)
    evaluate.check(system, evaluate.send_request(system.workspace, evaluate.ACCELERATE, 0.0))
    return system.workspace.a.copy()


@pytest.mark.nojit
@pytest.mark.parametrize("direction", [1.0, -1.0])
def test_a_block_on_an_incline(direction):
    """a = -g (sin t + mu cos t sign v) up the slope."""
    t, mu = 0.5, 0.2
    up, across = np.array([np.cos(t), 0.0, np.sin(t)]), np.array([0.0, 1.0, 0.0])
    axes = np.column_stack([across, np.cross(up, across), up])
    block = [Body(motion=PRISMATIC, axes=axes, mass=3.0, inertia=np.eye(3), name="block")]
    row, pool = friction(block, 1, form=joint_friction.WAY, c_r=1.0, mu=mu, v_eps=1e-3)
    system = assemble(
        block,
        {"gravity": gravity_records(block, (0, 0, -G)), "joint_friction": row},
        pools={"joint_friction": pool},
    )
    state = system.initial_state()
    state.v[0] = 2.0 * direction
    assert acceleration(system, state)[0] == pytest.approx(
        -G * (np.sin(t) + mu * np.cos(t) * direction), rel=1e-12
    )
    power = evaluate.observe(system, evaluate.store(system, 0.0))[
        system.layout.channel("friction_power[joint_friction0]")
    ]
    assert power == pytest.approx(mu * 3.0 * G * np.cos(t) * 2.0, rel=1e-9)


@pytest.mark.nojit
def test_event_functions_are_far_from_zero_at_rest_and_tell_the_direction():
    """Signs by slip over slip speed: round-off at rest, creeping, slipping; a reversal changes both."""
    system = pendulum(0.3, 0.08)
    state = system.initial_state()
    held = [(slip, [-1, -1]) for slip in (0.0, 1e-18, -1e-18, 0.9, -0.9)]
    for slip, signs in (*held, (1.1, [1, -1]), (-1.1, [-1, 1]), (2000.0, [1, -1])):
        state.v[0] = slip * 1e-3
        found = evaluate.event_values(system, state)
        np.testing.assert_array_equal(np.sign(found), signs)
        assert np.abs(found).min() > 2e-5  # a quarter of a tenth of the slip speed, 1e-3


def pendulum(mu, radius, cut=False, **numbers):
    """Pendulum of 0.7 m on a pin, in the tree or held by a cut joint."""
    along = np.column_stack([[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0]])
    motion = FLOATING if cut else TORSION
    inertia = np.diag([0.01, 0.05, 0.05])
    bodies = [Body(motion=motion, axes=along, mass=2.0, com=(0.7, 0, 0), inertia=inertia, name="bob")]
    row, pool = friction(bodies, 1, c_r=radius, mu=mu, v_eps=1e-3, **numbers)
    constraints = {}
    if cut:
        constraints["closure"], _ = cut_joint(TORSION, bodies, 1, 0, np.zeros(3), along)
        row["n_beyond"], row["n_rows"], row["rows"] = 0, 5, 0
    banks = {"gravity": gravity_records(bodies, (0, 0, -G)), "joint_friction": row}
    return assemble(bodies, banks, constraints, pools={"joint_friction": pool})


def test_a_pin_with_friction_slows_a_pendulum():
    """The load of the pin depends on the acceleration, which depends on the friction: solved by hand here."""
    mu, r, m, length, inertia = 0.3, 0.08, 2.0, 0.7, 0.05
    system = pendulum(mu, r)
    state = system.initial_state()
    angle, rate = 0.9, 1.7
    state.q[0], state.v[0] = angle, rate
    found = acceleration(system, state)[0]
    about = inertia + m * length**2
    a = 0.0
    for _ in range(200):
        radial = m * (length * rate**2 + G * np.cos(angle))
        tangential = m * (length * a + G * np.sin(angle))
        a = (-m * G * length * np.sin(angle) - mu * r * np.hypot(radial, tangential)) / about
    assert found == pytest.approx(a, rel=1e-12)


def swing(cut, method, h):
    """Attitude and angular velocity a little later, with Stribeck's curve, bending load and preload.

    The pin does not come to rest: in the regularised jump there no step is short enough for its order.
    """
    system = pendulum(0.3, 0.08, cut, ratio=1.5, v_s=0.4, c_m=0.1, preload=0.02)
    state = system.initial_state()
    state.q[system.layout.coordinate("bob.spin")] = 1.2
    state.v[system.layout.coordinate("bob.spin")] = -0.5
    if cut:
        state.v[:] = assemble_state(system, state, keep_rates=[5]).state.v
    run = method(system, state, h)
    assert run.advance(round(0.4 / h)).status == OK
    end = run.state()
    evaluate.residual(system, end)
    fr = system.workspace.fr[1]
    return np.array([*fr["S"][:, 0], *fr["tw"][3:]])


def test_a_cut_joint_rubs_like_one_of_the_tree():
    """Classical Runge-Kutta gives the truth for the implicit scheme, whose error falls with h squared."""
    explicit = [swing(cut, runge_kutta.start_classical, 1e-4) for cut in (False, True)]
    np.testing.assert_allclose(explicit[1], explicit[0], atol=1e-8)
    steps = (2e-4, 1e-4, 5e-5, 2.5e-5)
    for cut in (False, True):
        errors = [np.abs(swing(cut, generalized_alpha.start, h) - explicit[0]).max() for h in steps]
        assert errors[3] < 0.26 * errors[2] < 0.26**2 * errors[1] < 1e-7
        # coarse steps measure the rate of a kept matrix and iterate more often: less error, never more
        assert errors[1] < errors[0] < 4.1 * errors[1]


def test_friction_of_an_inner_joint_feels_the_outer_bodies():
    """Two bars on one pin each: the inner pin carries both weights; bars at rest and held straight down."""
    down = np.column_stack([[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0]])
    bodies = [
        Body(axes=down, mass=1.0, com=(0.5, 0, 0), inertia=0.1 * np.eye(3), name="a"),
        Body(
            axes=down,
            position=(0, 0, -1.0),
            parent=1,
            mass=4.0,
            com=(0.5, 0, 0),
            inertia=0.1 * np.eye(3),
            name="b",
        ),
    ]
    row, pool = friction(bodies, 1, c_r=0.05, mu=0.1, v_eps=1e-9)
    system = assemble(
        bodies,
        {"gravity": gravity_records(bodies, (0, 0, -G)), "joint_friction": row},
        pools={"joint_friction": pool},
    )
    state = system.initial_state()
    state.v[system.layout.coordinate("a.spin")] = 1e-6
    torque = evaluate.observe(system, state)[system.layout.channel("friction_torque[joint_friction0]")]
    assert torque == pytest.approx(-0.1 * 0.05 * 5.0 * G, rel=1e-9)
