# SPDX-License-Identifier: Apache-2.0
"""Ratios of mesh damping: the mass on the line of action has all that turns with the gears."""

from __future__ import annotations

import math

import pytest

from pitchpoint.solvers.modal import find_modes
from pitchpoint.system import evaluate
from pitchpoint.system.rules.turning_inertia import turning_inertia
from tests.support.machines import R_B1, compiled

PAIR = """\
gears:
  g1: {number_of_teeth: 30, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  g2: {number_of_teeth: 45, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  driver:
    {gears: [g1], position: [0, 0, 0], inertia: 0.002 kg m^2,
     markers: {pin: {position: [120 mm, 0, 50 mm]}}}
  driven: {gears: [g2], inertia: 0.01 kg m^2}
  arm:
    mass: 0.5 kg
    center_of_mass: [30 mm, 0, -160 mm]
    inertia_tensor: [2e-3, 3e-3, 1e-3, 0, 0, 0]
joints:
  pin: {type: JOINT, bodies: [driver.pin, arm], axes: {z: [0, 1, 0]}}
meshes:
  stage: {gears: [g1, g2], stiffness: {law: constant, value: 3e8 N/m}, damping: {ratio: 0.03}}
loads: {input: {body: driver, torque: 50 N m}, output: {body: driven, torque: balance}}
"""
ARM = 1e-3 + 0.5 * 0.15**2
"""Of the arm about the axis of the driver: its own moment about z, and its mass at 150 mm [kg m^2]."""


@pytest.mark.parametrize("joint", ["fixed", "revolute"])
def test_an_arm_counts_with_its_gear(joint):
    """d = 2 zeta sqrt(k m), 1/m = r_1^2/J_1 + r_2^2/J_2. A hinge across the axis couples nothing at rest: J
    is the diagonal of the mass matrix."""
    model, system = compiled(PAIR.replace("JOINT", joint))
    assert turning_inertia(model, "driver") == pytest.approx(0.002 + ARM, rel=1e-12)
    M = evaluate.matrix(system, system.initial_state(), 1.0, 0.0, 0.0)
    spin = system.layout.coordinate("driver.spin")
    assert M[spin, spin] == pytest.approx(0.002 + ARM, rel=1e-12)
    mass = 1.0 / (R_B1**2 / (0.002 + ARM) + (1.5 * R_B1) ** 2 / 0.01)
    expected = 2.0 * 0.03 * math.sqrt(3e8 * mass)
    assert system.records["gear_mesh"]["contact"]["d_in"][0] == pytest.approx(expected, rel=1e-9)


def test_the_mode_of_the_mesh_has_the_ratio():
    """With the arm fixed to the driver the pair has one elastic mode, damped as the file says."""
    _, system = compiled(PAIR.replace("JOINT", "fixed"))
    assert find_modes(system).damping_ratio[-1] == pytest.approx(0.03, rel=1e-6)


def test_a_gear_fixed_to_a_beam_turns_with_its_twist():
    """The wheel stands on a pin between ground and a free tip: d = 2 zeta sqrt(k m) as with a free wheel."""
    pin = """beams:
  pin: {ends: [ground, tip], section: {diameter: 30 mm}, pieces: 4}
joints:
  on: {type: fixed, bodies: [pin.3, driven]}
"""
    text = (
        PAIR[: PAIR.index("  arm:\n")].replace(
            "driven: {gears: [g2], inertia: 0.01 kg m^2}",
            "driven: {gears: [g2], inertia: 0.01 kg m^2, mass: 2 kg, transverse_inertia: 0.01 kg m^2}\n"
            "  tip: {motion: free, mass: 1 g, inertia_tensor: [1e-6, 1e-6, 1e-6, 0, 0, 0], "
            "position: [112.5 mm, 0, 0.4 m]}",
        )
        + pin.replace("[ground, tip]", "[foot, tip]")
        + PAIR[PAIR.index("meshes:") :].replace("torque: balance", "torque: 75 N m")
    )
    text = text.replace(
        "  tip:", "  foot: {motion: fixed, mass: 1 kg, inertia: 1, position: [112.5 mm, 0, -0.4 m]}\n  tip:"
    )
    text = text.replace(",\n     markers: {pin: {position: [120 mm, 0, 50 mm]}}}", "}")
    model, system = compiled(text)
    assert turning_inertia(model, "driven") == pytest.approx(0.01, rel=1e-12)
    mass = 1.0 / (R_B1**2 / 0.002 + (1.5 * R_B1) ** 2 / 0.01)
    expected = 2.0 * 0.03 * math.sqrt(3e8 * mass)
    assert system.records["gear_mesh"]["contact"]["d_in"][0] == pytest.approx(expected, rel=1e-9)


def test_a_gear_on_a_body_that_is_fixed_to_another():
    """The rim with the gear is screwed to a hub on a joint to ground: both turn with the arm."""
    hub = """  hub: {inertia: 0.004 kg m^2, position: [0, 0, 0], mass: 1 kg, transverse_inertia: 0.003 kg m^2}
  arm:
"""
    screws = """joints:
  axle: {type: revolute, bodies: [ground, hub]}
  screws: {type: fixed, bodies: [hub, driver]}
"""
    text = PAIR.replace("JOINT", "revolute")
    text = (
        text.replace("  arm:\n", hub)
        .replace("joints:\n", screws)
        .replace(
            "inertia: 0.002 kg m^2,", "inertia: 0.002 kg m^2, mass: 1 kg, transverse_inertia: 0.001 kg m^2,"
        )
    )
    model, _ = compiled(text)
    assert turning_inertia(model, "driver") == pytest.approx(0.004 + 0.002 + ARM, rel=1e-12)
    held = text.replace("type: revolute, bodies: [ground, hub]", "type: fixed, bodies: [ground, hub]")
    held = held.replace("loads: {input: {body: driver, torque: 50 N m}, output", "loads: {output")
    assert (
        turning_inertia(compiled(held.replace("torque: balance", "torque: 1 N m"))[0], "driver") == math.inf
    )
