# SPDX-License-Identifier: Apache-2.0
"""Model files of machines with several meshes with contact of tooth surfaces."""

from __future__ import annotations

import math

TWO_STAGES = """
title: two-stage gearbox
gears:
  z1: {number_of_teeth: 23, normal_module: 2.5 mm, helix_angle: 18 deg, hand: left, face_width: 30 mm,
    profile_shift_coefficient: 0.2}
  z2: {number_of_teeth: 71, normal_module: 2.5 mm, helix_angle: 18 deg, hand: right, face_width: 28 mm,
    profile_shift_coefficient: 0}
  z3: {number_of_teeth: 21, normal_module: 4 mm, helix_angle: 12 deg, hand: right, face_width: 50 mm,
    profile_shift_coefficient: 0.2}
  z4: {number_of_teeth: 65, normal_module: 4 mm, helix_angle: 12 deg, hand: left, face_width: 48 mm,
    profile_shift_coefficient: 0}
shafts:
  input: {sections: [{length: 200 mm, diameter: 40 mm}], gears: {z1: 60 mm}, position: [0, 0, 0]}
  middle: {sections: [{length: 200 mm, diameter: 50 mm}], gears: {z2: 60 mm, z3: 130 mm}}
  output: {sections: [{length: 200 mm, diameter: 70 mm}], gears: {z4: 130 mm}}
meshes:
  fast: {gears: [z1, z2], FAST, damping: {ratio: 0.05}}
  slow: {gears: [z3, z4], contact: {level: flexible, planes: 5}, damping: {ratio: 0.05}}
bearings:
  i1: {body: input, position: [0, 0, 10 mm], stiffness: {radial: 3e8 N/m, axial: 1e8 N/m}}
  i2: {body: input, position: [0, 0, 190 mm], stiffness: {radial: 3e8 N/m}}
  m1: {body: middle, position: [0, 0, 10 mm], stiffness: {radial: 5e8 N/m, axial: 2e8 N/m}}
  m2: {body: middle, position: [0, 0, 190 mm], stiffness: {radial: 5e8 N/m}}
  o1: {body: output, position: [0, 0, 10 mm], stiffness: {radial: 8e8 N/m, axial: 3e8 N/m}}
  o2: {body: output, position: [0, 0, 190 mm], stiffness: {radial: 8e8 N/m}}
loads:
  motor: {body: input, torque: 250 N m}
  brake: {body: output, torque: balance, position: [0, 0, 200 mm]}
scenarios:
  slow_roll: {quasi_static: {mesh: slow, points: 3, periods: 2}}
"""


def two_stages(fast: str = "contact: {level: flexible, planes: 5}") -> str:
    """Two helical stages on three shafts; `fast`: contact or stiffness law of the first."""
    return TWO_STAGES.replace("FAST", fast)


def double_helical() -> str:
    """Two meshes of opposite hand on two shafts, symmetric about z = 100 mm; the pinion floats axially."""
    lines = ["title: double helical pair", "gears:"]
    for name, teeth, hands in (("p", 25, ("left", "right")), ("w", 50, ("right", "left"))):
        lines += [
            f"  {name}{k}: {{number_of_teeth: {teeth}, normal_module: 3 mm, helix_angle: 25 deg, "
            f"hand: {hand}, face_width: 30 mm, profile_shift_coefficient: 0}}"
            for k, hand in enumerate(hands)
        ]
    lines.append("shafts:")
    for name, gear, at in (("one", "p", ", position: [0, 0, 0]"), ("two", "w", "")):
        lines.append(
            f"  {name}: {{sections: [{{length: 200 mm, diameter: 50 mm}}], "
            f"gears: {{{gear}0: 60 mm, {gear}1: 140 mm}}{at}}}"
        )
    contact = "contact: {level: flexible, planes: 6}"
    lines += ["meshes:", *(f"  m{k}: {{gears: [p{k}, w{k}], {contact}}}" for k in (0, 1)), "bearings:"]
    for name in ("one", "two"):
        for k, z in enumerate((10, 190)):
            lines.append(
                f"  {name}{k}: {{body: {name}, position: [0, 0, {z} mm], "
                f"stiffness: {{radial: 3e8 N/m, axial: {'1e3' if name == 'one' else '1e8'} N/m}}}}"
            )
    # the torque acts in the plane of symmetry
    lines += [
        "loads:",
        "  motor: {body: one, torque: 500 N m, position: [0, 0, 100 mm]}",
        "  brake: {body: two, torque: balance, position: [0, 0, 100 mm]}",
    ]
    return "\n".join(lines) + "\n"


def planets(pin: float = 0.0, planes: int = 3) -> str:
    """Spur set with three planets on bearings; planet 0 is moved by `pin` [m] along the circle of the pins.

    Sun and carrier cannot move sideways: a pin error is not balanced.
    """
    teeth = "normal_module: 3 mm, face_width: 40 mm, profile_shift_coefficient: 0"
    a, n = 90e-3, 3
    angles = [2.0 * math.pi * k / n + (pin / a if k == 0 else 0.0) for k in range(n)]
    places = [f"[{a * math.cos(t):.12g} m, {a * math.sin(t):.12g} m, 0]" for t in angles]
    contact = f"contact: {{level: flexible, planes: {planes}}}, backlash: {{normal: 0.2 mm}}"
    return "\n".join(
        [
            "title: planetary set",
            "gears:",
            f"  sun: {{number_of_teeth: 21, {teeth}}}",
            f"  ring: {{type: internal, number_of_teeth: 99, {teeth}}}",
            *(f"  p{k}: {{number_of_teeth: 39, {teeth}}}" for k in range(n)),
            "bodies:",
            "  sun: {gears: [sun], motion: torsion, position: [0, 0, 0]}",
            "  ring: {gears: [ring], motion: fixed, position: [0, 0, 0]}",
            "  carrier: {motion: torsion, position: [0, 0, 0], inertia: 0.1 kg m^2, mass: 10 kg}",
            *(f"  b{k}: {{gears: [p{k}], position: {place}}}" for k, place in enumerate(places)),
            "joints:",
            *(f"  j{k}: {{type: shaft, bodies: [carrier, b{k}]}}" for k in range(n)),
            "meshes:",
            *(f"  s{k}: {{gears: [sun, p{k}], {contact}}}" for k in range(n)),
            *(f"  r{k}: {{gears: [p{k}, ring], {contact}}}" for k in range(n)),
            "bearings:",
            *(
                f"  at{k}: {{body: b{k}, housing: carrier, "
                "stiffness: {radial: 5e8 N/m, axial: 1e8 N/m, tilt: 1e6 N m/rad}}"
                for k in range(n)
            ),
            "loads:",
            "  motor: {body: sun, torque: 600 N m}",
            "  brake: {body: carrier, torque: balance}",
            "",
        ]
    )
