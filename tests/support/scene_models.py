# SPDX-License-Identifier: Apache-2.0
"""Models whose scenes are known, and their scenes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.scene.build import scene_of
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from pitchpoint.viz.scene.file import scene_texts
from tests.support.scene_reader import Seen

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.system.system import System

PAIR = """\
title: helical pair in bearings
gears:
  a: {{number_of_teeth: 23, normal_module: 3 mm, helix_angle: 15 deg, hand: left, face_width: 30 mm, profile_shift_coefficient: 0.2}}
  b: {{number_of_teeth: 41, normal_module: 3 mm, helix_angle: 15 deg, hand: right, face_width: 30 mm, profile_shift_coefficient: 0}}
bodies:
  first: {{gears: [a], motion: free, axes: {{z: {z}, x: {x}}}, position: [10 mm, 20 mm, 30 mm]}}
  second: {{gears: [b], motion: free}}
meshes:
  m: {{gears: [a, b], direction: 25 deg, stiffness: {{law: din3990}}, damping: {{ratio: 0.1}}, backlash: {{normal: 0.1 mm}}}}
bearings:
  s1: {{body: first, stiffness: {{radial: 2e8 N/m, axial: 1e8 N/m, tilt: 1e6 N m/rad}}, damping: {{ratio: 0.1}}}}
  s2: {{body: second, stiffness: {{radial: 2e8 N/m, axial: 1e8 N/m, tilt: 1e6 N m/rad}}, damping: {{ratio: 0.1}}}}
loads:
  in: {{body: first, torque: 100 N m}}
  out: {{body: second, torque: balance}}
scenarios:
  on: {{speed: {{first: 600 rpm}}, duration: 0.2 s, sample_rate: 2 kHz}}
"""  # noqa: E501

CARRIER = """\
title: planets on a carrier
gears:
  sun: {number_of_teeth: 24, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  p1: {number_of_teeth: 18, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  ring: {type: internal, number_of_teeth: 60, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0, tip_diameter: 118 mm}
bodies:
  sun: {gears: [sun], motion: torsion, position: [0, 0, 0], inertia: 0.01 kg m^2}
  carrier: {motion: torsion, position: [0, 0, 0], inertia: 0.05 kg m^2, mass: 2 kg}
  planet: {gears: [p1], inertia: 0.001 kg m^2, mass: 0.5 kg}
  rim: {gears: [ring], motion: fixed, position: [0, 0, 0]}
joints:
  pin: {type: revolute, bodies: [carrier, planet], position: [42 mm, 0, 0]}
meshes:
  sp: {gears: [sun, p1], stiffness: {law: constant, value: 3e8 N/m}, backlash: {base_tangent: 0.05 mm}, damping: {ratio: 0.05}}
  pr: {gears: [p1, ring], stiffness: {law: constant, value: 3e8 N/m}, backlash: {base_tangent: 0.05 mm}, damping: {ratio: 0.05}}
loads:
  in: {body: sun, torque: 20 N m}
  out: {body: carrier, torque: balance}
scenarios:
  on: {speed: {sun: 300 rpm}, duration: 0.4 s, sample_rate: 1 kHz}
"""  # noqa: E501


def seen(text: str, scenario: str = "on") -> tuple[Seen, System, xr.Dataset]:
    """Scene, system and result of a run."""
    model = loads_model(text)
    system = compile_model(model, scenario)
    result = solve_time(system)
    return Seen(*scene_texts(scene_of(model, result))), system, result
