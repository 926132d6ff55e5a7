# SPDX-License-Identifier: Apache-2.0
"""Sensors against matrices and point masses, blocks against closed forms, tangents against differences."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pitchpoint.core.errors import CompileError, SolverError
from pitchpoint.core.formula.formula import Formula
from pitchpoint.elements import gravity, registry
from pitchpoint.elements.signals import record as sr
from pitchpoint.elements.signals.net import SignalNet
from pitchpoint.multibody.bodies import FREE, TORSION, Body
from pitchpoint.multibody.joints import CYLINDRICAL, PRISMATIC, SCREW, SPHERICAL
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.multistep import bdf
from pitchpoint.system import evaluate
from pitchpoint.system.signals import assemble_controlled
from pitchpoint.system.system import assemble
from tests.support import signals as oracle
from tests.support.engine import couplings
from tests.support.forces import check_balance, check_matrices, mechanism, moved_world, shafts
from tests.support.forces import moving as moving_forces
from tests.support.trees import cloud, moving, poses, tree

ENDS = [(1, 0), (2, 0), (1, 2), (2, 3), (4, 3), (3, 1)]
QUANTITIES = [
    sr.POSITION,
    sr.VELOCITY,
    sr.ACCELERATION,
    sr.DISTANCE,
    sr.DISTANCE_RATE,
    sr.ANGLE,
    sr.ANGULAR_VELOCITY,
    sr.ANGULAR_ACCELERATION,
]


def seen(system, state, name):
    """Value of a signal at a state."""
    return evaluate.observe(system, state)[system.layout.channel(f"signal[{name}]")]


# ------------------------------------------------------------------------------------------------- sensors


@pytest.mark.nojit
@pytest.mark.parametrize(("i", "j"), [(2, 1), (3, 1), (3, 0), (1, 4)])
def test_sensors_see_what_matrices_say(i, j):
    rng = np.random.default_rng(5)
    bodies = tree(rng, (SPHERICAL, CYLINDRICAL, TORSION, FREE), (0, 1, 2, 0))
    axis = rng.normal(size=3)
    axis /= np.linalg.norm(axis)
    points = rng.normal(size=(2, 3))
    net = SignalNet(bodies)
    for k, quantity in enumerate(QUANTITIES):
        if quantity != sr.ANGLE:
            net.sensor(f"s{k}", quantity, i, j, axis=axis, point_i=points[0], point_j=points[1])
    system = assemble_controlled(net, {})
    state = moving(system, rng)
    way = oracle.way(system, state, i, j, points, axis)
    apart = oracle.distance(system, state, i, j, points)
    spin = oracle.relative_spin(system, state, i, j, axis)
    wanted = [
        way(0.0),
        oracle.derivative(way, 1),
        oracle.derivative(way, 2),
        apart(0.0),
        oracle.derivative(apart, 1),
        None,
        spin(0.0),
        oracle.derivative(spin, 1),
    ]
    for k, value in enumerate(wanted):
        if value is not None:
            # sixth-order differences with steps of 2e-3 leave 1e-9, second ones 1e-8 by rounding
            assert seen(system, state, f"s{k}") == pytest.approx(value, rel=1e-7, abs=1e-7), QUANTITIES[k]


@pytest.mark.parametrize(
    ("motion", "coordinate"), [(TORSION, "spin"), (PRISMATIC, "z"), (CYLINDRICAL, "z"), (SCREW, "spin")]
)
def test_joint_coordinates_are_those_of_the_joint(motion, coordinate):
    rng = np.random.default_rng(6)
    bodies = tree(rng, (SPHERICAL, motion), (0, 1))
    net = SignalNet(bodies)
    for order in range(3):
        net.joint_sensor(f"s{order}", 2, coordinate, order)
    system = assemble_controlled(net, {})
    state = moving(system, rng)
    at = system.layout.coordinate(f"b2.{coordinate}")
    for order, value in enumerate((state.q[at], state.v[at], state.a[at])):
        assert seen(system, state, f"s{order}") == pytest.approx(value, rel=1e-12, abs=1e-12)


def test_joint_turns_are_counted():
    rng = np.random.default_rng(7)
    bodies = tree(rng, (SPHERICAL, TORSION), (0, 1))
    net = SignalNet(bodies)
    net.joint_sensor("s", 2, "spin")
    system = assemble_controlled(net, {})
    state = moving(system, rng)
    state.turns[2] = -3
    for angle in (-3.1, -1.0, 0.5, 3.1):
        state.q[system.spin("b2")] = angle
        assert seen(system, state, "s") == pytest.approx(angle - 6.0 * np.pi, abs=1e-12)


def test_relative_turns_on_a_carrier():
    rng = np.random.default_rng(8)
    bodies = shafts(rng)  # carrier 2 with planets 3 and, upside down, 4
    net = SignalNet(bodies)
    net.sensor("planet", sr.ANGLE, 3, 0)
    net.sensor("pair", sr.ANGLE, 3, 4)
    system = assemble_controlled(net, {})
    state = system.initial_state()
    state.q[[system.spin(n) for n in ("carrier", "planet", "other")]] = 0.3, 0.5, 0.7
    state.turns[1:] = 5, -2, 3, 1
    turn = 2.0 * np.pi
    assert seen(system, state, "planet") == pytest.approx(0.8 + turn * 1, abs=1e-13)
    # seen from the planet that stands upside down, everything turns the other way
    assert seen(system, state, "pair") == pytest.approx(-(0.5 + 0.7) - turn * 4, abs=1e-13)


def test_a_joint_reaction_is_what_moves_the_bodies_beyond_it():
    """Newton and Euler for the point masses of all bodies beyond the joint."""
    rng = np.random.default_rng(9)
    bodies = tree(rng, (SPHERICAL, TORSION, SPHERICAL, PRISMATIC), (0, 1, 2, 2))
    axis, point = rng.normal(size=3), rng.normal(size=3)
    axis /= np.linalg.norm(axis)
    net = SignalNet(bodies)
    net.reaction("f", 2, axis=axis, axis_on=1, point=point)
    net.reaction("m", 2, moment=True, axis=axis, axis_on=1, point=point)
    system = assemble_controlled(net, {})
    state = moving(system, rng)

    def masses(time):
        frames = oracle.placed(system, state, time)
        return np.concatenate(
            [r + cloud(b)[1] @ S.T for b, (r, S) in zip(bodies[1:], frames[2:], strict=True)]
        )

    weights = np.repeat([b.mass / 6.0 for b in bodies[1:]], 6)
    change = weights[:, None] * oracle.derivative(masses, 2)
    frames = oracle.placed(system, state, 0.0)
    place = frames[2][0] + frames[2][1] @ point
    e = frames[1][1] @ axis
    moment = np.cross(masses(0.0) - place, change).sum(axis=0)
    assert seen(system, state, "f") == pytest.approx(e @ change.sum(axis=0), rel=1e-7)
    assert seen(system, state, "m") == pytest.approx(e @ moment, rel=1e-7)


def test_observations_of_other_elements_can_be_heard():
    bodies = [Body(polar_inertia=1.0, name="a"), Body(polar_inertia=2.0, name="b")]
    net = SignalNet(bodies)
    net.listen("felt", "torque[shaft]", "N m")
    net.low_pass("measured", "felt", 0.1)
    bank = couplings([(1, 2, 50.0, 0.0, 0.0)])
    system = assemble_controlled(net, {"coupling": bank}, names={"coupling": ["shaft"]})
    state = system.initial_state()
    state.q[system.spin("a")] = 0.2
    state.v[system.spin("state.measured")] = 3.0
    found = evaluate.residual(system, state)
    torque = evaluate.observe(system, state)[system.layout.channel("torque[shaft]")]
    assert abs(torque) == pytest.approx(10.0)
    assert found[system.spin("state.measured")] == pytest.approx(-(torque - 3.0) / 0.1)
    assert seen(system, state, "felt") == torque


# ------------------------------------------------------------------------------------- tangents and balance


def bent(t, x, p):
    return x + p[0] * x * x


def closed(bodies, quantity, i, j, rng, blocks=True):
    """A sensor, some of every block, and all actuators between bodies i and j, and others."""
    net = SignalNet(bodies)
    way = {"axis": rng.normal(size=3), "point_i": rng.normal(size=3), "point_j": rng.normal(size=3)}
    net.sensor("sensed", quantity, i, j, **way)
    net.sensor("other", sr.VELOCITY, 3, 0, **way)
    net.linear("sum", {"sensed": 0.7, "other": -0.4, "memory": 0.5}, 0.3)
    if blocks:
        net.saturation("kept", "sum", -80.0, 80.0)
        net.table("curve", "kept", [-100.0, 0.0, 100.0], [-90.0, 3.0, 140.0])
        net.formula("mixed", Formula.parse("x + 0.1*sin(y)*t", ("x", "y", "t")), ("curve", "memory", "t"))
        net.law("bent", "mixed", bent, (0.01,))
        net.low_pass("memory", "bent", 0.5)
        last = "bent"
    else:
        net.low_pass("memory", "sum", 0.5)
        last = "sum"
    net.torque("turning", last, 4, 3)
    net.strut("pushing", last, 2, 3, point_i=way["point_j"], point_j=way["point_i"])
    for axes in (sr.WORLD, sr.BODY_I, sr.BODY_J):
        net.force(f"pulling{axes}", last, i, j, load=rng.normal(size=6), axes=axes, point=way["point_i"])
    return net


@pytest.mark.nojit
@pytest.mark.parametrize("quantity", QUANTITIES)
@pytest.mark.parametrize(("i", "j"), ENDS)
def test_tangents_are_exact_from_sensor_to_actuator(i, j, quantity):
    rng = np.random.default_rng(10)
    blocks = quantity not in (sr.ACCELERATION, sr.ANGULAR_ACCELERATION)
    system = assemble_controlled(closed(mechanism(rng), quantity, i, j, rng, blocks), {})
    state = moving_forces(system, rng)
    state.t = 0.7
    check_matrices(system, state, 2e-7)
    check_balance(system, state)


@pytest.mark.parametrize("quantity", QUANTITIES)
def test_nothing_depends_on_where_the_world_is(quantity):
    rng = np.random.default_rng(11)
    bodies = mechanism(rng)
    net = closed(bodies, quantity, 2, 3, np.random.default_rng(1), False)
    moved, _, _ = moved_world(bodies, rng)
    again = closed(moved, quantity, 2, 3, np.random.default_rng(1), False)
    for both in (net, again):  # what points in axes of the world, or senses ground, is another thing after it
        del both.nodes["pulling0"]
        both.nodes["other"].fields["j"] = 1
    one, two = assemble_controlled(net, {}), assemble_controlled(again, {})
    state = moving_forces(one, rng)
    np.testing.assert_allclose(evaluate.residual(two, state), evaluate.residual(one, state), atol=2e-11)


def test_whole_turns_change_nothing_but_the_angle():
    rng = np.random.default_rng(12)
    net = SignalNet(shafts(rng))
    net.sensor("way", sr.VELOCITY, 3, 1, point_i=(0.1, 0.2, 0.0))
    net.torque("m", "way", 2, 1)
    system = assemble_controlled(net, {})
    state = moving_forces(system, rng, 0.3, 0.05)
    before = evaluate.residual(system, state)
    state.turns[1:5] = 5, -7, 1_000_003, 2
    np.testing.assert_array_equal(evaluate.residual(system, state), before)


def test_an_actuator_works_with_the_rate_that_it_is_paired_with():
    """Power of a strut is its force times the rate of the distance of its points."""
    rng = np.random.default_rng(13)
    points = rng.normal(size=(2, 3))
    net = SignalNet(mechanism(rng))
    net.linear("push", {}, 3.0)
    net.sensor("rate", sr.DISTANCE_RATE, 2, 3, point_i=points[0], point_j=points[1])
    net.strut("act", "push", 2, 3, point_i=points[0], point_j=points[1])
    system = assemble_controlled(net, {})
    state = moving_forces(system, rng)
    evaluate.residual(system, state)
    fr = system.workspace.fr
    bare = assemble(net.bodies, {})
    work = sum((fr["F"][k] @ fr["tw"][k]) for k in range(1, 5))
    evaluate.residual(bare, state)
    fr = bare.workspace.fr
    work -= sum((fr["F"][k] @ fr["tw"][k]) for k in range(1, 5))
    assert work == pytest.approx(3.0 * seen(system, state, "rate"), rel=1e-11)


# -------------------------------------------------------------------------------------------------- blocks


def one_mass(J=1.0):
    return [Body(polar_inertia=J, name="rotor")]


def reach(system, t_end, method="wstiff"):
    """State at a time by a method with tight tolerances."""
    state = system.initial_state()
    if method == "rk":
        run = runge_kutta.start_adaptive(system, state, rtol=1e-11, atol=1e-13, atol_rate=1e-13)
    else:
        run = bdf.start(system, state, method, rtol=1e-9, atol=1e-13, atol_rate=1e-11)
    run.advance_to(t_end)
    return run.state()


@pytest.mark.nojit
def test_step_responses_of_filters():
    net = SignalNet(one_mass())
    net.linear("one", {}, 1.0)
    net.low_pass("first", "one", 0.2)
    net.second_order("second", "one", 9.0, 0.3)
    net.transfer_function("lead", "one", [2.0, 1.0], [0.5, 1.0])
    net.integrator("ramp", "one", 0.25)
    system = assemble_controlled(net, {})
    state = system.initial_state()
    run = generalized_alpha.start(system, state, 1e-4, rho_inf=1.0)
    for t in (0.05, 0.1):
        run.advance(500)
        damped = 9.0 * np.sqrt(1.0 - 0.09)
        decay = np.exp(-0.3 * 9.0 * t)
        wanted = {
            "first": 1.0 - np.exp(-t / 0.2),
            "second": 1.0 - decay * (np.cos(damped * t) + 2.7 / damped * np.sin(damped * t)),
            "lead": 1.0 + 3.0 * np.exp(-2.0 * t),
            "ramp": 0.25 + t,
        }
        for name, value in wanted.items():
            # second order: (9 h)^2 / 12 t is below 1e-8
            assert seen(system, run.state(), name) == pytest.approx(value, abs=1e-7), name


def pendulum(limits=None, kd=3.0):
    """Pendulum of mass 2 kg at 0.5 m with a PID controller of its angle, set to 0.8 rad."""
    body = Body(
        motion=TORSION,
        axes=np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]),
        mass=2.0,
        com=(0.5, 0.0, 0.0),
        inertia=np.diag([0.01, 0.06, 0.05]),
        name="arm",
    )
    net = SignalNet([body])
    net.joint_sensor("angle", 1, "spin")
    net.linear("error", {"angle": -1.0}, 0.8)
    net.pid("u", "error", kp=40.0, ki=30.0, kd=kd, filter_time=0.01, limits=limits)
    net.torque("motor", "u", 1)
    weight = np.zeros(1, gravity.RECORD)
    weight["i"], weight["weight"], weight["com"] = 1, (0.0, 0.0, -2.0 * 9.81), (0.5, 0.0, 0.0)
    return net, weight


def pendulum_rates(t, y, limits, kd, sense):
    angle, speed, filtered, integral = y
    e = 0.8 - angle
    free = 40.0 * e + integral + kd * (e - filtered) / 0.01
    u = free if limits is None else min(max(free, limits[0]), limits[1])
    track = np.sqrt(40.0 / 30.0 * kd / 40.0)
    gain = 30.0 * e + (0.0 if limits is None else (u - free) / track)
    J = 0.05 + 2.0 * 0.25
    return [speed, (u + sense * 2.0 * 9.81 * 0.5 * np.cos(angle)) / J, (e - filtered) / 0.01, gain]


@pytest.mark.parametrize("limits", [None, (-15.0, 15.0)])
@pytest.mark.parametrize("method", ["wstiff", "gstiff", "dassl", "rk"])
def test_a_position_controller_against_an_independent_integration(method, limits):
    net, weight = pendulum(limits)
    system = assemble_controlled(net, {"gravity": weight})
    # which way gravity turns the arm
    bare = assemble(net.bodies, {"gravity": weight})
    sense = -np.sign(evaluate.residual(bare, bare.initial_state())[0])
    wanted = solve_ivp(
        pendulum_rates,
        (0.0, 1.0),
        np.zeros(4),
        "DOP853",
        args=(limits, 3.0, sense),
        rtol=1e-12,
        atol=1e-12,
        max_step=1e-3,
    ).y[:, -1]
    state = reach(system, 1.0, method)
    # the knee of the limits costs digits: the steps of the methods are not cut there
    most = 1e-6 if limits is None else 2e-5
    assert state.q[system.spin("arm")] == pytest.approx(wanted[0], abs=most)
    assert state.v[system.spin("arm")] == pytest.approx(wanted[1], abs=20.0 * most)
    assert state.v[system.spin("state.u.integral")] == pytest.approx(wanted[3], abs=20.0 * most)


def test_poles_of_the_closed_loop_are_the_roots_of_its_polynomial():
    """A rotor with PID: (J s^2) s (T s + 1) + (kp s + ki)(T s + 1) + kd s^2 for a filtered derivative."""
    J, kp, ki, kd, T = 0.7, 40.0, 30.0, 3.0, 0.05
    net = SignalNet(one_mass(J))
    net.sensor("angle", sr.ANGLE, 1)
    net.linear("error", {"angle": -1.0}, 0.2)
    net.pid("u", "error", kp=kp, ki=ki, kd=kd, filter_time=T)
    net.torque("motor", "u", 1)
    system = assemble_controlled(net, {})
    M, D, K = evaluate.linearize(system, system.initial_state())
    n = len(M)
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(M, K), -np.linalg.solve(M, D)]])
    found = np.linalg.eigvals(A)
    assert np.sum(np.abs(found) < 1e-6) == 2  # integrals of both states, on which nothing depends
    found = found[np.abs(found) > 1e-6]
    wanted = np.roots(np.polyadd([J * T, J, kp * T + kd, kp + ki * T, ki], [0.0]))
    np.testing.assert_allclose(np.sort_complex(found), np.sort_complex(wanted), rtol=1e-8)


def test_the_iteration_converges_for_a_stiff_loop():
    """A gain of 1e9 between sensor and another body: Newton needs the whole chain."""
    bodies = [Body(polar_inertia=1.0, name="a"), Body(polar_inertia=1.0, name="b")]
    net = SignalNet(bodies)
    net.sensor("twist", sr.ANGLE, 1, 2)
    net.sensor("rate", sr.ANGULAR_VELOCITY, 1, 2)
    net.linear("pull", {"twist": -1e9, "rate": -1e5})
    net.torque("clutch", "pull", 1, 2)
    system = assemble_controlled(net, {})
    state = system.initial_state()
    state.v[:] = 1.0, 3.0
    run = generalized_alpha.start(system, state, 1e-3)
    chunk = run.advance(1000)
    assert chunk.status == 1
    np.testing.assert_allclose(run.state().v, 2.0, atol=1e-6)  # momentum is kept
    assert system.workspace.clock[3] < 4 * 1000  # iterations per step


def test_acceleration_feedback_is_added_inertia():
    """u = -m a of the body itself doubles its inertia, in one solution and without iteration."""
    net = SignalNet(one_mass(2.0))
    net.sensor("acc", sr.ANGULAR_ACCELERATION, 1)
    net.linear("u", {"acc": -2.0}, 6.0)
    net.torque("m", "u", 1)
    system = assemble_controlled(net, {})
    assert list(system.records) == ["signal_flow"]
    assert reach(system, 0.5, "rk").v[system.spin("rotor")] == pytest.approx(0.75, rel=1e-9)


def test_acceleration_through_a_bend_needs_the_later_channel():
    """The same with limits that bind: then the torque is constant."""
    net = SignalNet(one_mass(2.0))
    net.sensor("acc", sr.ANGULAR_ACCELERATION, 1)
    net.saturation("kept", "acc", -1.0, 1.0)
    net.linear("u", {"kept": -1.0}, 6.0)
    net.torque("m", "u", 1)
    system = assemble_controlled(net, {})
    assert list(system.records) == ["signal_of_loads"]
    assert reach(system, 0.5, "rk").v[system.spin("rotor")] == pytest.approx(0.5 * 5.0 / 2.0, rel=1e-8)


def test_speed_controller_of_a_drive_train_with_two_masses():
    """Turbine, shaft and generator with a PI law of its filtered speed, against SciPy."""
    bodies = [Body(polar_inertia=50.0, name="turbine"), Body(polar_inertia=4.0, name="generator")]
    net = SignalNet(bodies)
    net.sensor("speed", sr.ANGULAR_VELOCITY, 2)
    net.low_pass("measured", "speed", 0.02)
    net.linear("error", {"measured": -1.0}, 10.0)
    net.pid("u", "error", kp=30.0, ki=60.0)
    net.torque("generator", "u", 2)
    net.formula("wind", Formula.parse("200 + 50*sin(3*t)", ("t",)), ("t",))
    net.torque("rotor", "wind", 1)
    system = assemble_controlled(net, {"coupling": couplings([(1, 2, 900.0, 3.0, 0.0)])})

    def rates(t, y):
        twist, w1, w2, m, c = y
        shaft = 900.0 * twist + 3.0 * (w1 - w2)
        e = 10.0 - m
        wind = 200.0 + 50.0 * np.sin(3.0 * t)
        return [w1 - w2, (wind - shaft) / 50.0, (shaft + 30.0 * e + c) / 4.0, (w2 - m) / 0.02, 60.0 * e]

    wanted = solve_ivp(rates, (0.0, 3.0), np.zeros(5), "DOP853", rtol=1e-12, atol=1e-12).y[:, -1]
    for method in ("wstiff", "rk"):
        state = reach(system, 3.0, method)
        names = ("turbine", "generator", "state.measured", "state.u.integral")
        found = [state.v[system.spin(name)] for name in names]
        # states count as angles of 0.05 m: their tolerance is that of large speeds
        np.testing.assert_allclose(found, wanted[1:], rtol=3e-6)


@pytest.mark.parametrize("method", ["wstiff", "dassl", "rk"])
def test_units_of_states_do_not_matter_for_the_steps(method):
    """The same loop with inertia and gains a million times larger: what its integral is worth is relative."""
    steps, speeds = [], []
    for scale in (1.0, 1e6):
        net = SignalNet(one_mass(50.0 * scale))
        net.sensor("speed", sr.ANGULAR_VELOCITY, 1)
        net.low_pass("measured", "speed", 0.02)
        net.linear("error", {"measured": -1.0}, 10.0)
        net.pid("u", "error", kp=30.0 * scale, ki=60.0 * scale)
        net.torque("generator", "u", 1)
        system = assemble_controlled(net, {})
        state = system.initial_state()
        if method == "rk":
            run = runge_kutta.start_adaptive(system, state, rtol=1e-7, atol=1e-11, atol_rate=1e-7)
        else:
            run = bdf.start(system, state, method, rtol=1e-7)
        run.advance_to(3.0)
        steps.append(run.steps)
        speeds.append(run.state().v[system.spin("rotor")])
    assert steps[1] < 2 * steps[0]
    assert speeds[1] == pytest.approx(speeds[0], rel=1e-5)


# --------------------------------------------------------------------------------------------- bad input


def test_an_algebraic_loop_is_refused_with_its_names():
    net = SignalNet(one_mass())
    net.linear("a", {"b": 1.0})
    net.linear("b", {"c": 1.0})
    net.saturation("c", "a", -1.0, 1.0)
    with pytest.raises(CompileError, match="a <- b <- c <- a form an algebraic loop"):
        assemble_controlled(net, {})


def test_a_reaction_must_not_drive_what_it_carries():
    net = SignalNet(one_mass())
    net.reaction("load", 1)
    net.linear("u", {"load": 1.0})
    net.torque("m", "u", 1)
    with pytest.raises(CompileError, match="algebraic loop"):
        assemble_controlled(net, {})


def test_names_that_do_not_exist_are_refused():
    net = SignalNet(one_mass())
    net.sensor("angle", sr.ANGLE, 1)
    net.linear("u", {"angel": 1.0})
    with pytest.raises(CompileError, match="'angel' is not a signal; did you mean angle"):
        assemble_controlled(net, {})
    with pytest.raises(CompileError, match="already in use"):
        net.linear("angle", {})


@pytest.mark.parametrize("what", ["raise", "nan"])
def test_a_law_that_fails_is_named(what):
    def law(t, x, p):
        if what == "raise":
            raise ValueError("no such speed")
        return float("nan")

    net = SignalNet(one_mass())
    net.sensor("speed", sr.ANGULAR_VELOCITY, 1)
    net.law("u", "speed", law)
    net.torque("m", "u", 1)
    system = assemble_controlled(net, {})
    said = "raised ValueError: no such speed" if what == "raise" else "returned nan"
    with pytest.raises(SolverError, match=rf"signal 'u': .*law {said} \(t = 0 s, x = 0\)"):
        evaluate.residual(system, system.initial_state())


def test_both_kinds_are_the_same_code():
    assert registry.find("signal_flow").module == registry.find("signal_of_loads").module


def test_frames_of_the_oracle_are_those_of_the_engine():
    rng = np.random.default_rng(1)
    bodies = tree(rng, (SPHERICAL, TORSION), (0, 1))
    system = assemble(bodies, {})
    state = moving(system, rng)
    evaluate.residual(system, state)
    frames = poses(bodies, state.q, system.program["body"]["dof"][1:], state.charts)
    np.testing.assert_allclose(system.workspace.fr["r"][2], frames[2][0], atol=1e-13)
