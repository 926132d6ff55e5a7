# SPDX-License-Identifier: Apache-2.0
"""Scenarios of kinematics, and what implicit integration makes of the same motion."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model

TEXT = """
gravity: [0, -9.81, 0]
bodies:
  crank: {mass: 1 kg, center_of_mass: [40 mm, 0, 0], inertia_tensor: [2e-4, 1.1e-3, 1.2e-3, 0, 0, 0],
    markers: {pin: {position: [100 mm, 0, 0]}}}
  rod: {mass: 0.8 kg, center_of_mass: [120 mm, 0, 0], inertia_tensor: [1e-4, 8e-3, 8e-3, 0, 0, 0],
    markers: {big: {}, small: {position: [300 mm, 0, 0]}}}
  piston: {mass: 0.5 kg}
joints:
  main: {type: revolute, bodies: [ground, crank], position: [0, 0, 0]}
  crank_pin: {type: revolute, bodies: [crank.pin, rod.big]}
  cylinder: {type: prismatic, bodies: [ground, piston], axes: {z: [1, 0, 0]}}
  piston_pin: {type: revolute, bodies: [rod.small, piston]}
scenarios:
  driven: {drive: {crank: {speed: 300 rpm}}, duration: 0.25 s, step: 0.2 ms, settle_time: 0 s, method: METHOD}
"""


def torque(method, text=TEXT):
    found = solve_time(compile_model(loads_model(text.replace("METHOD", method)), "driven"))
    return found["torque[crank]"].values


def test_forces_of_a_driven_mechanism_by_every_way():
    """Inverse dynamics is the truth; index 3 carries the ripple of its multipliers, SI2 the tolerance."""
    expected = torque("kinematics")
    assert expected.size == 1251
    size = np.abs(expected).max()
    np.testing.assert_allclose(torque("wstiff"), expected, atol=1e-4 * size)
    np.testing.assert_allclose(torque("generalized_alpha"), expected, atol=2e-2 * size)
    assert abs(np.abs(torque("generalized_alpha")).max() - size) < 2e-3 * size


def test_a_motion_with_freedom_left_is_refused():
    text = TEXT.replace("drive: {crank: {speed: 300 rpm}}, ", "").replace("METHOD", "kinematics")
    with pytest.raises(SolverError, match="drives and loops leave 1 degree of freedom"):
        solve_time(compile_model(loads_model(text), "driven"))
