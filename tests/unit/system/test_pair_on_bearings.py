# SPDX-License-Identifier: Apache-2.0
"""A helical pair on catalogue bearings of all types: sums of the bearing forces."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.system.compile import compile_model

PAIR = """\
gears:
  pinion: {number_of_teeth: 23, normal_module: 3 mm, face_width: 30 mm, helix_angle: 15 deg, hand: right,
    profile_shift_coefficient: 0.2}
  wheel: {number_of_teeth: 47, normal_module: 3 mm, face_width: 30 mm, helix_angle: 15 deg, hand: left,
    profile_shift_coefficient: 0.1}
shafts:
  input: {sections: [{length: 140 mm, diameter: 30 mm}], gears: {pinion: 70 mm}AXES}
  output: {sections: [{length: 140 mm, diameter: 40 mm}], gears: {wheel: 70 mm}}
meshes: {stage: {gears: [pinion, wheel]}}
gravity: [0, 0, -9.81]
loads: {motor: {body: input, torque: 200 N m}, brake: {body: output, torque: balance}}
rolling_bearings:
"""
WEIGHTS = {"input": 15.41, "output": 49.31}
"""Weights of the shafts with their gears as of `pitchpoint check` [N]."""


@pytest.mark.parametrize("axes", ["", ", position: [0, 0, 0], axes: {z: [1, 0, 0]}"])
@pytest.mark.parametrize(
    ("fixed", "floating"),
    [
        ("63{}", "NU 2{} E"),
        ("NUP 2{} E", "NU 2{} E"),
        ("32{}", "NA49{}"),
        ("12{}", "12{}, axial_force_absorption: no_direction"),
        ("222{}", "222{}, axial_force_absorption: no_direction"),
    ],
)
def test_bearing_forces_of_a_helical_pair(fixed, floating, axes):
    """Vertical and horizontal shafts: the axial force of the mesh is on the fixed bearing.

    Sums over both bearings of a shaft, as vectors with its weight: T/r_b in the transverse plane of action
    and F_a = T/r_b tan(beta_b) along the axis.
    """
    text = PAIR.replace("AXES", axes)
    for shaft, size in (("input", "06"), ("output", "08")):
        for name, place, kind in (("fixed", 20, fixed), ("floating", 120, floating)):
            text += f"  {shaft}_{name}: {{body: {shaft}, position: [0, 0, {place} mm], "
            text += f"designation: {kind.format(size)}}}\n"
    system = compile_model(loads_model(text))
    seen = solve_equilibrium(system)
    alpha_t = math.atan(math.tan(math.radians(20.0)) / math.cos(math.radians(15.0)))
    base_radius = 0.5 * 23 * 3e-3 / math.cos(math.radians(15.0)) * math.cos(alpha_t)
    normal = 200.0 / base_radius  # in the transverse plane of action
    axial = normal * math.tan(math.radians(15.0)) * math.cos(alpha_t)
    for k, (shaft, sign) in enumerate((("input", 1.0), ("output", -1.0))):
        turned = system.records["rolling_bearing"][2 * k]["A_j"]  # axes of the outer ring in the world
        down = np.array([0.0, 0.0, -WEIGHTS[shaft]]) @ turned
        assert seen[f"bearing_force[{shaft}_floating.axial]"].item() == 0.0
        held = np.array(
            [
                sum(seen[f"bearing_force[{shaft}_{name}.{way}]"].item() for name in ("fixed", "floating"))
                for way in ("fx", "fy", "fz")
            ]
        )
        mesh = -(held + down)
        assert abs(down[2]) == pytest.approx(0.0 if axes else WEIGHTS[shaft], abs=1e-9)
        assert mesh[2] == pytest.approx(sign * axial, rel=2e-3)
        assert math.hypot(*mesh[:2]) == pytest.approx(normal, rel=2e-3)
