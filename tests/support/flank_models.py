# SPDX-License-Identifier: Apache-2.0
"""Model files of a helical pair with contact of tooth surfaces."""

PAIR = """
title: helical pair
gears:
  pinion: {{number_of_teeth: 25, normal_module: 3 mm, helix_angle: 15 deg, hand: left, face_width: 30 mm,
    profile_shift_coefficient: 0.1, modifications: {{both: {{tip_relief: {{amount: 15 um, length: 2 mm}},
    lead_crowning: 5 um}}}}}}
  wheel: {{number_of_teeth: 60, normal_module: 3 mm, helix_angle: 15 deg, hand: right, face_width: {width},
    profile_shift_coefficient: -0.1}}
bodies:
  a: {{gears: [pinion], motion: free}}
  b: {{gears: [wheel], motion: free}}
bearings:
  at_a: {{body: a, stiffness: {{radial: 3e8 N/m, axial: 1e8 N/m, tilt: 1e6 N m/rad}}}}
  at_b: {{body: b, stiffness: {{radial: 5e8 N/m, axial: 1e8 N/m, tilt: 1e6 N m/rad}}}}
loads:
  drive: {{body: a, torque: {torque}}}
  brake: {{body: b, torque: balance}}
meshes:
  stage:
    gears: [pinion, wheel]
    center_distance: 132.1 mm
    damping: {{ratio: 0.05}}
    contact: {contact}
scenarios:
  run: {{duration: 1 ms, speed: {{a: 1500 rpm}}, step: 2 us}}
  slow: {{quasi_static: {{mesh: stage, points: 8}}}}
"""


def pair_text(contact="{level: flexible, planes: 5}", width="30 mm", torque="300 N m"):
    """Text of the model."""
    return PAIR.format(contact=contact, width=width, torque=torque)
