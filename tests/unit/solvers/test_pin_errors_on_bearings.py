# SPDX-License-Identifier: Apache-2.0
"""Pin errors larger than the backlash, with clearance in the bearings of the carrier or of the planets."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.system.compile import compile_model

STAGE = """\
gears:
  sun: {number_of_teeth: 21, normal_module: 1.5 mm, face_width: 24 mm, profile_shift_coefficient: 0,
    tooth_thickness_allowance: -25 um}
  ring: {type: internal, number_of_teeth: 75, normal_module: 1.5 mm, face_width: 22 mm,
    profile_shift_coefficient: 0, tooth_thickness_allowance: -25 um}
bodies:
  shaft: {gears: [sun], motion: planar, mass: 0.8 kg, inertia: 4e-4 kg m^2, position: [0, 0, 0]}
  housing: {gears: [ring], motion: fixed}
  carrier: {inertia: 4e-3 kg m^2, mass: 4 kg, motion: planar}
planetary_stages:
  ps: {sun: sun, ring: ring, carrier: carrier, planets: 3, motion: planar,
    planet: {number_of_teeth: 27, normal_module: 1.5 mm, face_width: 22 mm, profile_shift_coefficient: 0,
      tooth_thickness_allowance: -25 um, bore_diameter: 22 mm},
    pin_errors: {planet_2: {tangential: ERROR}}, PLANETS
    sun_mesh: {stiffness: {law: din3990}}, ring_mesh: {stiffness: {law: din3990}}}
bearings: {spline: {body: shaft, stiffness: {radial: 2e6 N/m}} CARRIER}
rolling_bearings: {ROLLING}
loads: {motor: {body: shaft, torque: 40 N m}, mill: {body: carrier, torque: balance}}
"""
PIN = "bearing: {stiffness: {radial: 2e8 N/m}},"
STIFF = ", K: {body: carrier, stiffness: {radial: 1e9 N/m}}"
BALL = "K: {body: carrier, position: [0, 0, 0], designation: 6009, axial_force_absorption: no_direction}"
NEEDLES = ", ".join(f"n{k}: {{ends: [carrier, planet_{k}], designation: NA4901}}" for k in (1, 2, 3))


@pytest.mark.parametrize("error", [40, -60, 100, 160])
@pytest.mark.parametrize(
    ("planets", "carrier", "rolling"), [(PIN, "", BALL), ("", STIFF, NEEDLES)], ids=["carrier", "planets"]
)
def test_mesh_forces_balance_the_torque_of_the_sun(planets, carrier, rolling, error):
    """Sum of the mesh forces times the base radius; a lagging pin unloads its planet."""
    text = STAGE.replace("ERROR", f"{error} um").replace("PLANETS", planets)
    system = compile_model(loads_model(text.replace("CARRIER", carrier).replace("ROLLING", rolling)))
    found = solve_equilibrium(system)
    forces = [found[f"mesh_force[sun-planet_{k}]"].item() for k in (1, 2, 3)]
    base_radius = 0.5 * 21 * 1.5e-3 * math.cos(math.radians(20.0))
    assert sum(forces) * base_radius == pytest.approx(40.0, rel=1e-6)
    assert np.argmin(forces) == 1 if error > 0 else np.argmax(forces) == 1
