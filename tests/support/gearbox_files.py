# SPDX-License-Identifier: Apache-2.0
"""A gear pair in a housing on feet, as a model file: bodies that are not round, one of them on a joint."""

from __future__ import annotations

GEARBOX = """\
gears:
  g1: {number_of_teeth: 30, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  g2: {number_of_teeth: 45, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  driver:
    {gears: [g1], motion: free, position: [0, 0, 0], inertia: 0.002 kg m^2, mass: 2 kg,
     transverse_inertia: 0.0015 kg m^2,
     markers: {l: {position: [0, 0, -30 mm]}, r: {position: [0, 0, 30 mm]}}}
  driven:
    {gears: [g2], motion: free, position: [112.5 mm, 0, 0], inertia: 0.01 kg m^2, mass: 4 kg,
     transverse_inertia: 0.006 kg m^2, markers: {l: {position: [0, 0, -30 mm]}, r: {position: [0, 0, 30 mm]}}}
  housing:
    position: [60 mm, 10 mm, 0]
    mass: 20 kg
    center_of_mass: [5 mm, -8 mm, 3 mm]
    inertia_tensor: [0.2, 0.35, 0.4, 0.02, 0.01, -0.015]
    markers:
      foot1: {position: [-80 mm, -100 mm, 20 mm]}
      foot2: {position: [80 mm, -100 mm, -20 mm]}
      knee: {position: [0, 100 mm, 0]}
      stop: {position: [-60 mm, 100 mm, 0]}
      s1l: {position: [-60 mm, -10 mm, -30 mm]}
      s1r: {position: [-60 mm, -10 mm, 30 mm]}
      s2l: {position: [52.5 mm, -10 mm, -30 mm]}
      s2r: {position: [52.5 mm, -10 mm, 30 mm]}
  absorber: {mass: 0.8 kg, inertia_tensor: [1e-3, 2e-3, 1.5e-3, 0, 0, 0], position: [60 mm, 110 mm, 0]}
joints:
  base: {type: free, bodies: [ground, housing]}
  rail: {type: prismatic, bodies: [housing.knee, absorber], axes: {z: [1, 0, 0]}}
springs:
  tuned: {ends: [housing.stop, absorber], stiffness: 4e5 N/m, damping: 10 N s/m}
bushings:
  left: {ends: [housing.foot1, ground], FOOT}
  right: {ends: [housing.foot2, ground], FOOT}
  b1l: {ends: [driver.l, housing.s1l], SEAT}
  b1r: {ends: [driver.r, housing.s1r], SEAT}
  b2l: {ends: [driven.l, housing.s2l], SEAT}
  b2r: {ends: [driven.r, housing.s2r], SEAT}
meshes:
  stage:
    {gears: [g1, g2], backlash: {base_tangent: 0.1 mm}, damping: {ratio: 0.05},
     stiffness: {law: fourier, mean: 3e8 N/m, cosine: [-0.15]}}
loads: {input: {body: driver, torque: 50 N m}, output: {body: driven, torque: balance}}
scenarios: {run: {speed: {driver: 2000 rpm}, duration: 10 ms, step: 10 us}}
""".replace(
    "FOOT",
    "stiffness: {radial: 3e6 N/m, axial: 2e6 N/m, tilt: 2e4, torsion: 2e4}, "
    "damping: {radial: 300, axial: 300, tilt: 3, torsion: 3}",
).replace("SEAT", "stiffness: {radial: 1e8 N/m, axial: 5e7 N/m}, damping: {radial: 500, axial: 500}")
"""Two gears on bushings for bearings in a housing on two feet, with a tuned absorber on a rail."""

TAILS = """\
gears:
  a: {number_of_teeth: 25, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}
  b: {number_of_teeth: 40, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}
shafts:
  input: {sections: [{length: 200 mm, diameter: 40 mm}], gears: {a: 100 mm}, position: [0, 0, 0]}
bodies:
  wheel: {gears: [b], inertia: 0.01 kg m^2}
  fan: {motion: torsion, inertia: 0.05 kg m^2, position: [0, 0, 300 mm]}
  rack:
    {motion: free, mass: 5 kg, inertia_tensor: [0.05, 0.05, 0.05, 0, 0, 0], position: [0, 200 mm, 0]}
  base: {motion: fixed, position: [0, 200 mm, -100 mm]}
couplings:
  c: {bodies: [input, fan], position: [0, 0, 200 mm], stiffness: {torsion: 2e4 N m/rad}}
bearings:
  b1: {body: input, position: [0, 0, 10 mm], stiffness: {radial: 2e8 N/m, axial: 1e8 N/m}}
  b2: {body: input, position: [0, 0, 190 mm], stiffness: {radial: 2e8 N/m}}
springs: {r: {ends: [rack, base], stiffness: 1e6 N/m}}
meshes: {m: {gears: [a, b], stiffness: {law: din3990}}}
loads: {t: {body: fan, torque: 100 N m}, q: {body: wheel, torque: balance}}
scenarios: {run: {speed: {input: 1500 rpm}, duration: 20 ms, step: 2 us}}
"""
"""A shaft that drives a gear and a fan, which stay, and a free body on one spring: five motions are loose."""
