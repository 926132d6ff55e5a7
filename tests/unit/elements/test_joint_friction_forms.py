# SPDX-License-Identifier: Apache-2.0
"""Friction of all joints with sliding surfaces, from the model file, against plain mechanics."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.constraints.assembly import assemble_state
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.forces import check_balance, differences

G, MASS, INERTIA, MU, RADIUS = 9.81, 3.0, 0.02, 0.15, 0.04
RUBS = f"friction: {{coefficient: {MU}, radius: {RADIUS} m, slip_speed: 1e-6 m/s}}"


def machine(joint, place="[0, 0, 0]", gravity="[0, 0, -9.81 m/s^2]", more=""):
    """One body of isotropic inertia on a joint to ground at the origin; compiled."""
    text = f"""
title: joint friction
gravity: {gravity}
bodies:
  block: {{mass: {MASS} kg, inertia_tensor: [{INERTIA}, {INERTIA}, {INERTIA}, 0, 0, 0], position: {place}}}
joints:
  j: {{bodies: [ground, block], position: [0, 0, 0], {joint}}}
{more}"""
    return compile_model(loads_model(text))


def moving(system, **rates):
    """Initial state with rates of the coordinates of the joint."""
    state = system.initial_state()
    for name, value in rates.items():
        state.v[system.layout.coordinate(f"block.{name}")] = value
    return state


def accelerations(system, state, *names):
    evaluate.prepare(system)
    evaluate.load(system, state)
    evaluate.check(system, evaluate.send_request(system.workspace, evaluate.ACCELERATE, 0.0))
    return [system.workspace.a[system.layout.coordinate(f"block.{name}")] for name in names]


def channel(system, state, name):
    evaluate.prepare(system)
    evaluate.load(system, state)
    evaluate.check(system, evaluate.send_request(system.workspace, evaluate.ACCELERATE, 0.0))
    row = evaluate.observe(system, evaluate.store(system, 0.0))
    return float(row[system.layout.channel(name)])


def test_a_pin_that_turns_and_slides_rubs_against_its_surface_velocity():
    """Horizontal: N = m g; F = -mu N v_z/|v|, M = -mu N r (r omega)/|v| with |v| = hypot(v_z, r omega)."""
    system = machine(f"type: cylindrical, axes: {{z: [1, 0, 0]}}, {RUBS}")
    way, turn = 0.3, -5.0
    state = moving(system, z=way, spin=turn)
    speed = math.hypot(way, RADIUS * turn)
    found = accelerations(system, state, "z", "spin")
    limit = MU * MASS * G
    assert found[0] == pytest.approx(-limit * way / speed / MASS, rel=1e-10)
    assert found[1] == pytest.approx(-limit * RADIUS * RADIUS * turn / speed / INERTIA, rel=1e-10)
    assert channel(system, state, "friction_power[j]") == pytest.approx(limit * speed, rel=1e-9)
    assert channel(system, state, "friction_force[j]") == pytest.approx(-limit * way / speed, rel=1e-9)
    assert channel(system, state, "friction_torque[j]") == pytest.approx(
        -limit * RADIUS**2 * turn / speed, rel=1e-9
    )


def test_a_ball_rubs_against_its_rotation():
    """Centre of mass in the ball: the reaction is the weight; the torque mu R m g is opposite to omega."""
    system = machine(f"type: spherical, {RUBS}")
    omega = np.array([2.0, -1.0, 3.0])
    state = moving(system, alpha=omega[0], beta=omega[1], spin=omega[2])
    found = accelerations(system, state, "alpha", "beta", "spin")
    w = system.workspace.fr[1]["tw"][3:].copy()  # the rates of angles are not quite the angular velocity
    torque = -MU * RADIUS * MASS * G * w / np.linalg.norm(w)
    system.workspace.fr[1]
    np.testing.assert_allclose(system.workspace.fr[1]["ac"][3:], torque / INERTIA, rtol=1e-9)
    assert np.all(np.isfinite(found))
    assert channel(system, state, "friction_torque[j]") == pytest.approx(MU * RADIUS * MASS * G, rel=1e-9)


def test_a_block_on_a_plane_slides_and_turns():
    """N = m g; -mu N (v_x, v_y, r^2 omega)/|(v_x, v_y, r omega)| by the ellipsoid of limit loads."""
    system = machine(f"type: planar, {RUBS}")
    vx, vy, turn = 0.2, -0.1, 4.0
    state = moving(system, x=vx, y=vy, spin=turn)
    speed = math.sqrt(vx**2 + vy**2 + (RADIUS * turn) ** 2)
    found = accelerations(system, state, "x", "y", "spin")
    np.testing.assert_allclose(found[:2], -MU * G * np.array([vx, vy]) / speed, rtol=1e-9)
    assert found[2] == pytest.approx(-MU * MASS * G * RADIUS**2 * turn / speed / INERTIA, rel=1e-9)


@pytest.mark.parametrize(("share", "way"), [(0.5, -1.0), (1.0, -1.0), (1.6, -1.0), (1.6, 1.0)])
def test_a_screw_is_self_locking_when_its_lead_angle_is_below_the_friction_angle(share, way):
    """Nut under its weight, tan(lead angle) = share mu.

    (m p^2 + I) a = -m g p - mu N s r/cos(lam), N = |cos(lam) m (g + p a) - sin(lam) I a/r|, s = sign of the
    speed; downwards it keeps its speed exactly at share = 1, is braked below and accelerates above.
    """
    lead = share * MU * RADIUS
    system = machine(f"type: screw, lead: {2 * math.pi * lead!r} m, {RUBS}")
    state = moving(system, spin=2.0 * way)
    [found] = accelerations(system, state, "spin")
    lam = math.atan2(lead, RADIUS)
    # N is linear in a here: cos(lam) m (g + p a) - sin(lam) I a / r = c0 + c1 a > 0
    c0 = math.cos(lam) * MASS * G
    c1 = math.cos(lam) * MASS * lead - math.sin(lam) * INERTIA / RADIUS
    arm = MU * way * RADIUS / math.cos(lam)
    expected = (-MASS * G * lead - arm * c0) / (MASS * lead**2 + INERTIA + arm * c1)
    assert c0 + c1 * expected > 0.0
    assert found == pytest.approx(expected, rel=1e-9, abs=1e-9)
    if way < 0.0:  # positive acceleration brakes the falling nut
        assert found == pytest.approx(0.0, abs=1e-9) if share == 1.0 else (found > 0.0) == (share < 1.0)


def test_both_pins_of_a_cross_rub():
    """Weight across both horizontal pins: mu r m g about each, opposite to its own rate."""
    system = machine(f"type: universal, {RUBS}")
    state = moving(system, alpha=1e-3, beta=-2e-3)
    limit = MU * RADIUS * MASS * G
    found = [channel(system, state, f"friction_torque[j.{name}]") for name in ("alpha", "beta")]
    np.testing.assert_allclose(found, [-limit, limit], rtol=1e-9)
    np.testing.assert_allclose(
        accelerations(system, state, "alpha", "beta"), np.array(found) / INERTIA, rtol=1e-3
    )


JOINTS = {
    "cylindrical": "type: cylindrical, axes: {z: [1, 2, 2]}",
    "spherical": "type: spherical",
    "universal": "type: universal, axes: {z: [2, 1, 2]}",
    "planar": "type: planar, axes: {z: [1, 2, -2]}",
    "screw": "type: screw, lead: 40 mm, axes: {z: [1, 2, 2]}",
}
SOFT = "friction: {coefficient: 0.2, radius: 40 mm, slip_speed: 0.3 m/s, preload: 50 N, static_ratio: 1.4, "
SOFT += "stribeck_speed: 0.2 m/s}"


@pytest.mark.parametrize("joint", JOINTS)
def test_tangents_balance_and_loss(joint):
    """At constant load (preload only) the damping matrix is exact; forces balance; the power is a loss."""
    system = machine(f"{JOINTS[joint]}, {SOFT}", gravity="[0, 0, 0]")
    rng = np.random.default_rng(5)
    for size in (0.05, 1.0, 6.0):
        state = system.initial_state()
        state.q[:] = 0.2 * rng.normal(size=state.q.size)
        state.v[:] = size * rng.normal(size=state.v.size)
        check_balance(system, state)
        free = machine(JOINTS[joint], gravity="[0, 0, 0]")
        evaluate.residual(system, state)
        rubbed = system.workspace.fr["F"][1].copy()
        evaluate.residual(free, state)
        own = rubbed - free.workspace.fr["F"][1]
        assert own @ system.workspace.fr["tw"][1] < 0.0
    light = machine(f"{JOINTS[joint]}, {SOFT}", gravity="[0, 0, 0]")
    light.records["joint_friction"]["c_r"] = 0.0
    light.records["joint_friction"]["c_a"] = 0.0
    state = light.initial_state()
    state.v[:] = 0.7 * rng.normal(size=state.v.size)
    wanted = differences(light, state, "v", 1e-6)
    np.testing.assert_allclose(evaluate.linearize(light, state)[1], wanted, atol=1e-7 * np.abs(wanted).max())


@pytest.mark.parametrize("joint", JOINTS)
def test_a_cut_joint_rubs_like_one_of_the_tree(joint):
    """The block on a free joint of six coordinates, with the joint as a closure: the same motion."""
    free = "  hang: {type: free, bodies: [ground, block], position: [0, 0, 0], axes: AXES}\n"
    axes = JOINTS[joint].partition("axes: ")[2] or "{z: [0, 0, 1]}"
    place = "[30 mm, 50 mm, -20 mm]"
    joint_text = f"{JOINTS[joint]}, {SOFT}"
    ends = []
    for cut in (False, True):
        more = free.replace("AXES", axes) if cut else ""
        system = machine(joint_text + (", cut: true" if cut else ""), place, more=more)
        state = system.initial_state()
        rng = np.random.default_rng(3)
        own = list(machine(JOINTS[joint], place).layout.coordinates)
        rates = dict(zip(own, 0.8 * rng.normal(size=len(own)), strict=True))
        for name, value in rates.items():
            state.v[system.layout.coordinate(name)] = value
        if cut:
            if joint == "screw":
                lead = 0.04 / (2.0 * math.pi)
                state.v[system.layout.coordinate("block.z")] = lead * rates["block.spin"]
            keep = [system.layout.coordinate(name) for name in own]
            state.v[:] = assemble_state(system, state, keep_rates=keep).state.v
        run = runge_kutta.start_classical(system, state, 2e-4)
        assert run.advance(500).status == 1
        end = run.state()
        evaluate.residual(system, end)
        frame = system.workspace.fr[1]
        ends.append(np.concatenate([frame["r"], frame["S"].ravel(), frame["tw"]]))
    np.testing.assert_allclose(ends[1], ends[0], atol=2e-7)


@pytest.mark.parametrize(
    ("joint", "keys", "words"),
    [
        ("free", "coefficient: 0.1", "has no meaning for a joint of type free"),
        ("spherical", "coefficient: 0.1", "the radius of the ball"),
        ("screw, lead: 5 mm", "coefficient: 0.1", "the radius of the thread"),
        (
            "spherical",
            "coefficient: 0.1, radius: 5 mm, length: 5 mm",
            "has no effect on a joint of type spherical",
        ),
        ("prismatic", "coefficient: 0.1, radius: 5 mm", "has no effect on a joint of type prismatic"),
    ],
)
def test_keys_of_other_joints_are_refused(joint, keys, words):
    with pytest.raises(ModelError, match=words):
        machine(f"type: {joint}, friction: {{{keys}}}")
