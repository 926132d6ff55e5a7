# SPDX-License-Identifier: Apache-2.0
"""Friction of a screw that is driven, held or geared: the torque of the textbook in every route.

A nut that lifts F with the lead angle lam and the friction angle rho at the radius r requires the torque
F r tan(lam + rho), and F r tan(lam - rho) when it lowers F (J. E. Shigley, *Mechanical Engineering
Design*, power screws).
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import JAMMED
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.time import solve_time
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model

R, MU, F, MASS, INERTIA = 0.01, 0.2, 5000.0, 2.0, 1e-3
SPEED = 100.0 * math.pi / 30.0
ROUTES = {
    "drive": "scenarios: {run: {drive: {nut: {speed: SPEED rad/s}}, RUN}}",
    "hold": "scenarios: {run: {hold: [nut], speed: {nut: SPEED rad/s}, RUN}}",
    "ratio": "ratios: {belt: {terms: {motor: 1, nut: -1}}}\n"
    "scenarios: {run: {drive: {motor: {speed: SPEED rad/s}}, RUN}}",
}
CHANNELS = {"drive": "torque[nut]", "hold": "torque[nut]", "ratio": "torque[motor]"}


def lift(lead, way=1.0, tail=ROUTES["drive"], joint="", axis=(0.0, 0.0, 1.0), mu=MU, method=""):
    """Nut on a screw along `axis`, with the force F against it; compiled with the scenario of a route."""
    force = (-F * np.array(axis) / np.linalg.norm(axis)).tolist()
    run = f"duration: 0.2 ms, step: 10 us, start: assembled{method}"
    text = f"""
title: screw
bodies:
  motor: {{motion: torsion, inertia: 0.001 kg m^2, position: [100 mm, 0, 0]}}
  nut: {{mass: {MASS} kg, inertia_tensor: [{INERTIA}, {INERTIA}, {INERTIA}, 0, 0, 0], position: [0, 0, 0],
    markers: {{o: {{}}}}}}
joints:
{joint}  s: {{type: screw, bodies: [ground, nut], lead: {lead!r} m,{CUT if joint else ""}
    axes: {{z: {list(axis)}}}, friction: {{coefficient: {mu}, radius: {R} m}}}}
loads:
  w: {{body: nut, marker: o, force: [{force[0]!r} N, {force[1]!r} N, {force[2]!r} N]}}
{tail.replace("RUN", run).replace("SPEED", repr(way * SPEED))}
"""
    return compile_model(loads_model(text), "run")


CUT = " cut: true,"
FREE = "  hang: {type: cylindrical, bodies: [ground, nut], axes: {z: [0, 0, 1]}}\n"


def textbook(lead, way):
    """Torque of a nut that turns with the sign `way`: it lifts F if `way` has the sign of the lead."""
    lam, rho, hand = math.atan(abs(lead) / (2.0 * math.pi * R)), math.atan(MU), math.copysign(1.0, lead)
    return hand * F * R * math.tan(lam + way * hand * rho)


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("lead", [0.04, -0.04, 0.006])
@pytest.mark.parametrize("route", ROUTES)
def test_a_screw_requires_the_torque_of_the_textbook(route, lead, way):
    """Right- and left-hand, self-locking and not, up and down; power of the motor = lifting power + loss."""
    result = solve_time(lift(lead, way, ROUTES[route]))
    torque = result[CHANNELS[route]].values
    np.testing.assert_allclose(torque, textbook(lead, way), rtol=1e-9)
    loss = result["friction_power[s]"].values
    np.testing.assert_allclose(
        torque * way * SPEED, F * way * SPEED * lead / (2.0 * math.pi) + loss, rtol=1e-9
    )


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_the_same_torque_as_a_load_keeps_the_speed(way):
    tail = f"  t: {{body: nut, torque: {textbook(0.04, way)!r} N m}}\n"
    tail += "scenarios: {run: {speed: {nut: SPEED rad/s}, RUN}}"
    result = solve_time(lift(0.04, way, tail))
    np.testing.assert_allclose(result["speed[nut]"].values, way * SPEED, rtol=1e-9)


def test_a_nut_that_a_drive_accelerates_lifts_its_inertia_as_well():
    """T = I a + (F + m p a) r tan(lam + rho) with the travel p per radian."""
    tail = "scenarios: {run: {drive: {nut: {speed: 100 rpm + 60000 rpm * t / (1 s)}}, RUN}}"
    a, p = 600.0 * math.pi / 30.0 / 0.01, 0.04 / (2.0 * math.pi)
    wanted = INERTIA * a + (F + MASS * p * a) * textbook(0.04, 1.0) / F
    torque = solve_time(lift(0.04, 1.0, tail))["torque[nut]"].values
    np.testing.assert_allclose(torque, wanted, rtol=1e-6)


@pytest.mark.parametrize("method", ["", ", method: rk4"])
@pytest.mark.parametrize("joint", ["", FREE], ids=["tree", "cut"])
def test_methods_and_cut_joints_agree(joint, method):
    system = lift(0.04, 1.0, joint=joint, method=method)
    torque = solve_time(system)["torque[nut]"].values
    np.testing.assert_allclose(torque, textbook(0.04, 1.0), rtol=1e-8)


def test_the_axis_may_have_any_direction():
    torque = solve_time(lift(0.04, 1.0, axis=(1.0, -2.0, 2.0)))["torque[nut]"].values
    np.testing.assert_allclose(torque, textbook(0.04, 1.0), rtol=1e-9)


def test_the_holding_torque_of_an_equilibrium_at_speed_includes_the_friction():
    system = lift(0.04)
    start = system.initial_state()
    spin = system.spin("nut")
    start.v[spin] = SPEED
    found = find_equilibrium(system, start, [spin])
    assert found.reaction[0] == pytest.approx(textbook(0.04, 1.0), rel=1e-9)


def test_a_steep_thread_jams_when_driven_upwards():
    """lam + rho > 90 deg: no torque lifts the load, but the load turns the nut backwards."""
    steep = 2.0 * math.pi * R * math.tan(math.radians(80.0))
    with pytest.raises(SolverError) as failure:
        solve_time(lift(steep, 1.0))
    assert failure.value.status == JAMMED
    assert "joints.s" in str(failure.value)
    torque = solve_time(lift(steep, -1.0))["torque[nut]"].values
    np.testing.assert_allclose(torque, textbook(steep, -1.0), rtol=1e-9)


def test_the_load_rises_smoothly_through_rest():
    """Regularised friction: the force normal to the thread is continuous in the speed."""
    system = lift(0.04, tail="scenarios: {run: {speed: {nut: SPEED rad/s}, RUN}}")
    channel = system.layout.channel("friction_torque[s]")
    state = system.initial_state()
    values = []
    for speed in np.linspace(-3.0, 3.0, 2001):
        state.v[system.spin("nut")] = speed
        values.append(evaluate.observe(system, state)[channel])
    assert np.abs(np.diff(values)).max() < 0.05 * (max(values) - min(values))
