# SPDX-License-Identifier: Apache-2.0
"""Rotors with unbalance: the free rotation is a rigid-body mode, and a pendulum only under gravity."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.solvers.campbell import follow_modes
from pitchpoint.solvers.modal import find_modes
from tests.support.machines import compiled

ROTOR = """\
bodies:
  disc: {motion: free, mass: 20 kg, inertia: 0.6 kg m^2, transverse_inertia: 0.32 kg m^2, position: [0, 0, 0],
    axes: {z: [1, 0, 0], x: [0, 0, 1]}}
bearings:
  a: {body: disc, position: [0, 0, -60 mm], stiffness: {radial: 8e6 N/m, axial: 5e7 N/m},
    damping: {radial: 300 N s/m, axial: 50 N s/m}}
  b: {body: disc, position: [0, 0, -260 mm], stiffness: {radial: 1.2e7 N/m}, damping: {radial: 300 N s/m}}
unbalances:
  u: {body: disc, mass: 10 g, position: [100 mm, 0, 0]}
"""
GEARED = (
    """\
gears:
  p: {number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  w: {number_of_teeth: 40, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
meshes: {stage: {gears: [p, w], stiffness: {law: constant, value: 2e8 N/m}}}
"""
    + ROTOR.replace("disc: {", "disc: {gears: [p], ")
    + "loads: {drive: {body: disc, torque: 50 N m}, brake: {body: wheel, torque: balance}}\n"
).replace("bearings:", "  wheel: {gears: [w], motion: torsion, inertia: 2 kg m^2}\nbearings:")
RUN = "scenarios: {s: {speed: {disc: -3000 rpm}, duration: 1 s}}\n"


@pytest.mark.parametrize("text", [ROTOR, GEARED], ids=["rotor", "geared"])
def test_the_free_rotation_of_a_rotor_with_unbalance_has_no_stiffness(text):
    """98.7 N at 3000 rpm pass through the axis."""
    modes = find_modes(compiled(text + RUN, "s")[1], "s")
    assert modes.eigenvalue[0] == 0.0
    assert np.abs(modes.eigenvalue[1:]).min() > 100.0


def test_the_other_modes_are_those_of_the_balanced_rotor():
    """10 g of 20 kg change the frequencies by less than 0.1 %."""
    with_it, without = (
        find_modes(compiled(ROTOR.replace("mass: 10 g", f"mass: {mass}") + RUN, "s")[1], "s").eigenvalue
        for mass in ("10 g", "1 mg")
    )
    np.testing.assert_allclose(with_it[1:], without[1:], rtol=1e-3)


def test_it_has_none_at_any_speed():
    system = compiled(ROTOR + RUN, "s")[1]
    found = follow_modes(system, np.linspace(0.0, 6000.0, 5) * math.pi / 30.0, "disc", "s")
    np.testing.assert_array_equal(found.eigenvalue[:, 0], 0.0)


def test_under_gravity_the_unbalance_is_a_pendulum():
    """sqrt(m r g/J) = 0.1279 rad/s at rest, with 0.6001 kg m^2."""
    modes = find_modes(compiled(ROTOR + "gravity: [0, -9.81 m/s^2, 0]\n")[1])
    expected = math.sqrt(0.01 * 0.1 * 9.81 / 0.6001)
    assert 2.0 * math.pi * modes.frequency[0] == pytest.approx(expected, rel=1e-3)
