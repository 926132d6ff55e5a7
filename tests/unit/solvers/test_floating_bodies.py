# SPDX-License-Identifier: Apache-2.0
"""Bodies that float in the clearance of their bearings, where nothing opposes the smallest force."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.linear_system import linearise
from pitchpoint.system.compile import compile_model

STAGE = """\
gears:
  sun: {number_of_teeth: 24, normal_module: 3 mm, face_width: 50 mm, profile_shift_coefficient: 0}
  ring: {type: internal, number_of_teeth: 84, normal_module: 3 mm, face_width: 48 mm,
    profile_shift_coefficient: 0, tip_diameter: 247 mm, bore_diameter: 300 mm}
bodies:
  carrier: {motion: free, mass: 30 kg, inertia: 0.25 kg m^2, transverse_inertia: 0.4 kg m^2,
    position: [0, 0, 0]}
  housing: {gears: [ring], motion: fixed}
shafts:
  quill: {sections: [{length: 410 mm, diameter: 60 mm}], gears: {sun: 0 mm}, position: [0, 0, 0]}
planetary_stages:
  st: {sun: sun, ring: ring, carrier: carrier, planets: 4, motion: planar,
    planet: {number_of_teeth: 30, normal_module: 3 mm, face_width: 48 mm, profile_shift_coefficient: 0,
      bore_diameter: 62 mm}}
rolling_bearings:
  c_fix: {body: carrier, position: [0, 0, -120 mm], designation: 6020}
  c_loose: {body: carrier, position: [0, 0, 90 mm], designation: NU 1020}
  p1: {ends: [carrier, planet_1], designation: NU 2206E}
  p2: {ends: [carrier, planet_2], designation: NU 2206E}
  p3: {ends: [carrier, planet_3], designation: NU 2206E}
  p4: {ends: [carrier, planet_4], designation: NU 2206E}
  q_low: {body: quill, position: [0, 0, 270 mm], designation: 32014, axial_force_absorption: negative,
    preload: 500 N}
  q_high: {body: quill, position: [0, 0, 395 mm], designation: 32014, axial_force_absorption: positive,
    preload: 500 N}
loads:
  wind: {body: carrier, torque: TORQUE}
  gen: {body: quill, torque: balance}
  bend: {body: quill, force: [0, 3 kN, 0], position: [0, 0, 330 mm]}
"""


@pytest.mark.parametrize("torque", ["500 N m", "1000 N m", "2000 N m"])
def test_carrier_without_radial_load(torque):
    """The forces of four equal planets on the carrier cancel, so that it floats in its ball bearing.

    Its axial stiffness is below that of any bearing by six orders. The iterations over the mesh cycle start
    at an equilibrium, and meet rounding forces there (1e-9 N, with 10 kN on every planet).
    """
    found = linearise(compile_model(loads_model(STAGE.replace("TORQUE", torque))))
    z = found.system.layout.coordinates.index("carrier.z")
    assert abs(found.K[z, z]) < 1e3
    assert np.isfinite(found.K).all()
