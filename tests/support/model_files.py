# SPDX-License-Identifier: Apache-2.0
"""Model files that several tests read: the two contract files and builders of small variations."""

from __future__ import annotations

ISO_EXAMPLE = """\
title: ISO/TR 6336-30 example 1
gears:
  pinion: {number_of_teeth: 17, normal_module: 8 mm, normal_pressure_angle: 20 deg, helix_angle: 15.8 deg, hand: left,
           profile_shift_coefficient: 0.145, face_width: 100 mm, tip_diameter: 159.66 mm, rack: {addendum: 1.0, dedendum: 1.4, root_radius: 0.39}}
  wheel:  {number_of_teeth: 103, normal_module: 8 mm, normal_pressure_angle: 20 deg, helix_angle: 15.8 deg, hand: right,
           profile_shift_coefficient: 0.0, face_width: 100 mm, tip_diameter: 872.35 mm, rack: {addendum: 1.0, dedendum: 1.4, root_radius: 0.39}}
meshes:
  stage: {gears: [pinion, wheel], center_distance: 500 mm, stiffness: {law: din3990, stiffness_ratio: 0.8, tip_relief_factor: 0.0}}
"""  # noqa: E501

TORSIONAL_PAIR = """\
title: torsional pair through its resonance
gears:
  g1: {number_of_teeth: 50, normal_module: 3 mm, normal_pressure_angle: 20 deg, face_width: 20 mm, profile_shift_coefficient: 0}
  g2: {number_of_teeth: 50, normal_module: 3 mm, normal_pressure_angle: 20 deg, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  driver: {gears: [g1], motion: torsion, inertia: 0.0115 kg m^2}
  driven: {gears: [g2], motion: torsion, inertia: 0.0115 kg m^2}
meshes:
  stage:
    gears: [g1, g2]
    center_distance: 150 mm
    backlash: {normal: 0.1 mm}
    stiffness: {law: fourier, mean: 4.0e8 N/m, cosine: [-0.2, -0.1, -0.05]}        # k(psi) along the base tangent, relative to the mean
    damper: {ratio: 0.05}                                                           # mesh damper, also inside the gap; of critical at the mean stiffness
    transmission_error: {cosine: [1.0e-6, 0.5e-6]}                                  # e(psi) [m]: spring and damper act on u_bt - e
loads:
  input:  {body: driver, torque: 150 N m}
  output: {body: driven, torque: 150 N m}      # counter-clockwise positive: the driven gear turns clockwise, so this resists
scenarios:
  steady: {speed: {driver: 1500 rpm}, duration: 0.5 s, sample_rate: 100 kHz}
  sweep:  {sweep: {body: driver, mesh_frequency: [1000 Hz, 5000 Hz], points: 81, direction: both, settle_periods: 200, measure_periods: 50}}
"""  # noqa: E501


def gear(name: str, z: int = 30, x: float | None = 0.0, more: str = "") -> str:
    """One line of a `gears` section, 3 mm module and 20 mm wide."""
    shift = "" if x is None else f", profile_shift_coefficient: {x}"
    extra = f", {more}" if more else ""
    return f"  {name}: {{number_of_teeth: {z}, normal_module: 3 mm, face_width: 20 mm{shift}{extra}}}\n"


def pair(first: str, second: str, mesh: str = "", rest: str = "") -> str:
    """A file with two gears a and b (lines 2 and 3) and the mesh m (line 5)."""
    keys = f", {mesh}" if mesh else ""
    return f"gears:\n{first}{second}meshes:\n  m: {{gears: [a, b]{keys}}}\n{rest}"


CONTROLLED_PAIR = """\
gears:
  g1: {number_of_teeth: 20, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}
  g2: {number_of_teeth: 40, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}
bodies:
  driver: {gears: [g1], motion: torsion, inertia: 0.02 kg m^2, markers: {rim: {position: [30 mm, 0, 0]}}}
  driven: {gears: [g2], motion: torsion, inertia: 0.4 kg m^2}
meshes:
  stage: {gears: [g1, g2], stiffness: {law: constant, value: 4e8 N/m}, damper: {ratio: 0.05}}
sensors:
  speed: {type: joint, coordinate: driver, derivative: 1}
  place: {type: frames, quantity: position, ends: [driver.rim, driven], axis: y}
  load: {type: load, at: driven, quantity: force, axis: x, seen_from: driver}
  force: {type: observation, channel: "mesh_force[stage]"}
blocks:
  error: {type: sum, inputs: {speed: -1}, offset: 100 rad/s, unit: rad/s}
  kept: {type: limits, input: error, limits: [-20, 20 rad/s]}
  curve: {type: table, input: kept, points: [[-10, -5], [0, 0], [10, 8]]}
  mixed: {type: formula, formula: "2 * curve + sin(t)", inputs: [curve, t]}
  total: {type: integrator, input: error, start: 1}
  calm: {type: filter, input: mixed, time_constant: 1 ms, damping_ratio: 0.5}
  shaped: {type: transfer_function, input: calm, numerator: [1], denominator: [0.01, 1]}
  u: {type: pid, input: error, proportional: 2 N m s, integral: 10, derivative: 0.1, filter_time: 1 ms,
    limits: [-9, 9]}
  heard: {type: filter, input: force, time_constant: 2 ms}
controllers:
  loop: {type: pid, input: heard, output: w, proportional: 1e-3, integral: 2, period: 1 ms, delay: 0.5 ms}
actuators:
  motor: {type: torque, signal: u, bodies: [driver]}
  brake: {type: torque, signal: w, bodies: [driven, driver]}
  push: {type: force, signal: shaped, ends: [driver.rim, ground], axis: y, along: first}
  jack: {type: strut, signal: calm, ends: [driver.rim, driven]}
loads:
  load: {body: driven, torque: 40 N m}
scenarios:
  run: {speed: {driver: 100 rad/s}, duration: 5 ms, step: 0.1 ms, settle_time: 0 s}
"""
