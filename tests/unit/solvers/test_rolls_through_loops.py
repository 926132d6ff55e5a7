# SPDX-License-Identifier: Apache-2.0
"""Slow rolls whose trains go on through closed loops, with and without drives: virtual work by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.quasistatic.roll import roll_through, solve_quasistatic
from pitchpoint.system.compile import compile_model

TEETH = "normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
SLIDER_CRANK = f"""\
gravity: [0, -9.81 m/s^2, 0]
gears:
  p: {{number_of_teeth: 20, {TEETH}}}
  w: {{number_of_teeth: 40, {TEETH}}}
bodies:
  motor: {{gears: [p]}}
  crank:
    gears: [w]
    position: [0, 0, 0]
    mass: 3 kg
    center_of_mass: [40 mm, 0, 0]
    inertia_tensor: [6e-3, 7e-3, 1.2e-2, 0, 0, 0]
    markers: {{pin: {{position: [100 mm, 0, 0]}}}}
  rod:
    mass: 0.8 kg
    center_of_mass: [120 mm, 0, 0]
    inertia_tensor: [1e-4, 8e-3, 8e-3, 0, 0, 0]
    markers: {{big: {{}}, small: {{position: [300 mm, 0, 0]}}}}
  piston: {{mass: 0.5 kg, markers: {{top: {{}}}}}}
joints:
  main: {{type: revolute, bodies: [ground, crank], position: [0, 0, 0]}}
  crank_pin: {{type: revolute, bodies: [crank.pin, rod.big]}}
  cylinder: {{type: prismatic, bodies: [ground, piston], axes: {{z: [1, 0, 0]}}}}
  piston_pin: {{type: revolute, bodies: [rod.small, piston]}}
meshes:
  stage:
    {{gears: [p, w], direction: 180 deg, stiffness: {{law: din3990}}, backlash: {{base_tangent: 0.1 mm}}}}
loads:
  gas: {{body: piston, marker: top, force: [-500 N, 0, 0]}}
LOADS
scenarios:
  roll: {{DRIVE quasi_static: {{mesh: stage, points: 4, periods: 20}}}}
"""
"""A pinion turns the crank of a slider-crank by half a turn."""


def columns(system, roll, *names):
    return [roll.rows[:, system.layout.channel(name)] for name in names]


def torque_on(system, roll, body):
    """Torque of the drive on a body, or its holding torque."""
    held = roll.holding.get(body)
    return columns(system, roll, f"torque[{body}]")[0] if held is None else held


@pytest.mark.parametrize(
    "drive", ["drive: {motor: {speed: 10 rad/s}},", "drive: {crank: {speed: -10 rad/s}},", ""]
)
@pytest.mark.parametrize("load", ["", "  brake: {body: motor, torque: 5 N m}"])
def test_a_pinion_turns_a_slider_crank(drive, load):
    model = loads_model(SLIDER_CRANK.replace("DRIVE", drive).replace("LOADS", load))
    system = compile_model(model, "roll")
    roll = roll_through(system, "roll")
    assert roll.status == 1 and len(roll.position) == 81
    theta, force, piston = columns(
        system, roll, "angle[crank]", "mesh_force[stage]", "displacement[piston.z]"
    )
    assert abs(theta[-1]) == pytest.approx(math.pi, abs=3e-3)
    # by hand: heights of the masses and way of the piston over the crank angle
    phi = np.arcsin(-np.sin(theta) / 3.0)
    np.testing.assert_allclose(piston, 0.1 * np.cos(theta) + 0.3 * np.cos(phi) - 0.4, atol=1e-12)
    slope = -np.cos(theta) / 3.0 / np.cos(phi)
    moment = 9.81 * (3.0 * 0.04 * np.cos(theta) + 0.8 * (0.1 * np.cos(theta) + 0.12 * np.cos(phi) * slope))
    moment += 500.0 * (-0.1 * np.sin(theta) - 0.3 * np.sin(phi) * slope)
    radius = 0.06 * math.cos(math.radians(20.0))
    # the mesh holds the crank, the motor the mesh: -r_b F on either gear
    size = abs(moment).max()
    np.testing.assert_allclose(-radius * force, moment, atol=1e-7 * size)
    brake = 5.0 if load else 0.0
    np.testing.assert_allclose(
        torque_on(system, roll, "motor"), 0.5 * radius * force - brake, atol=1e-7 * size
    )
    assert roll.meshes["stage"].repeats_after == 1


UNIVERSAL = f"""\
gears:
  a: {{number_of_teeth: 20, {TEETH}}}
  b: {{number_of_teeth: 40, {TEETH}}}
  c: {{number_of_teeth: 30, {TEETH}}}
  d: {{number_of_teeth: 45, {TEETH}}}
bodies:
  one: {{gears: [a], position: [0, 0, 0], axes: {{z: [1, 0, 0], x: [0, 1, 0]}}}}
  two: {{gears: [b], position: [0, 90 mm, 0]}}
  three: {{gears: [c], position: [0, 90 mm, 0], axes: {{z: [4, 3, 0]}}}}
  four: {{gears: [d]}}
joints:
  shaft: {{type: revolute, bodies: [ground, three], axes: {{z: [4, 3, 0]}}}}
  cross: {{type: universal, bodies: [two, three], position: [0, 90 mm, 0], cut: true,
    axes: {{z: [-4, -3, 0], x: [0, 0, 1]}}}}
meshes:
  first: {{gears: [a, b], stiffness: {{law: constant, value: 4e8}}}}
  second: {{gears: [c, d], direction: 90 deg, stiffness: {{law: constant, value: 4e8}}}}
loads:
  motor: {{body: one, torque: 30 N m}}
  brake: {{body: four, torque: BRAKE}}
scenarios:
  roll: {{DRIVE quasi_static: {{mesh: MESH, points: 4, periods: 20}}}}
"""
"""Two trains whose shafts meet at 36.87 degrees in a universal joint."""


@pytest.mark.parametrize("brake", ["balance", "-50 N m"])
@pytest.mark.parametrize(
    ("mesh", "drive"),
    [("first", ""), ("first", "one"), ("first", "four"), ("second", "one"), ("second", "")],
)
def test_trains_go_on_through_a_universal_joint(mesh, drive, brake):
    driven = f"drive: {{{drive}: {{speed: 10 rad/s}}}}," if drive else ""
    text = UNIVERSAL.replace("MESH", mesh).replace("DRIVE", driven).replace("BRAKE", brake)
    system = compile_model(loads_model(text), "roll")
    roll = roll_through(system, "roll")
    assert roll.status == 1 and len(roll.position) == 81
    first, second, two, three = columns(
        system, roll, "mesh_force[first]", "mesh_force[second]", "angle[two]", "angle[three]"
    )
    cosine = 0.8
    np.testing.assert_allclose(three, np.unwrap(np.arctan2(cosine * np.sin(two), np.cos(two))), atol=1e-12)
    # Cardan: speeds, and torques the other way round
    ratio = cosine / (np.cos(two) ** 2 + cosine**2 * np.sin(two) ** 2)
    # what is held takes up what the loads leave over: gear a beside the joint, gear c behind it
    cos_a = math.cos(math.radians(20.0))
    if mesh == "first":
        np.testing.assert_allclose(abs(first) * 0.06, ratio * abs(second) * 0.045, rtol=1e-7)
        np.testing.assert_allclose(torque_on(system, roll, "one"), 0.03 * cos_a * first - 30.0, atol=1e-6)
    else:
        np.testing.assert_allclose(0.03 * cos_a * first, 30.0, rtol=1e-7)
        through = -0.06 * cos_a * first / ratio - 0.045 * cos_a * second
        np.testing.assert_allclose(torque_on(system, roll, "three"), -through, atol=1e-6)
    other = "second" if mesh == "first" else "first"
    assert roll.meshes[other].repeats_after == 0
    assert roll.cycle_notes == (
        f"mesh {other} is driven through a closed loop, and its values are those of this part of the cycle",
    )
    assert np.isfinite(roll.meshes[other].unloaded).all()


def test_what_loops_hold_fast_is_not_rolled():
    text = UNIVERSAL.replace("MESH", "first").replace("DRIVE", "").replace("BRAKE", "-50 N m")
    text = text.replace("  cross:", "  weld: {type: fixed, bodies: [ground, two], cut: true}\n  cross:")
    system = compile_model(loads_model(text), "roll")
    with pytest.raises(SolverError, match=r"one cannot be rotated further: closed loops lock it"):
        solve_quasistatic(system, "roll")
