# SPDX-License-Identifier: Apache-2.0
"""Small machines for solver tests, as texts of model files, and how to compile one."""

from __future__ import annotations

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.system.compile import compile_model

GEARS = """\
gears:
  g1: {{number_of_teeth: 30, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0{more}}}
  g2: {{number_of_teeth: 45, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0{less}}}
"""
SPARE = (
    "gears: {spare: {number_of_teeth: 20, normal_module: 1 mm, face_width: 5 mm, "
    "profile_shift_coefficient: 0}}\n"
)
"""A model has at least one gear; this one sits on no body."""
R_B1 = 0.0422861679353659
"""Base radius of gear 1 without helix angle [m]: 0.5 * 30 * 3 mm * cos 20 deg."""


STAGES = """\
gears:
  a: {number_of_teeth: 21, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  b: {number_of_teeth: 57, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  c: {number_of_teeth: 19, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  d: {number_of_teeth: 60, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies: {input: {gears: [a]}, middle: {gears: [b, c]}, output: {gears: [d]}}
meshes:
  first: {gears: [a, b], stiffness: {law: fourier, mean: 4e8 N/m, cosine: [-0.2]}}
  second: {gears: [c, d], direction: 40 deg, stiffness: {law: fourier, mean: 4e8 N/m, cosine: [-0.2]}}
loads: {motor: {body: input, torque: 60 N m}, brake: {body: output, torque: balance}}
"""
"""Two stages in a row; the second repeats after three periods of the first."""


def pair(
    stiffness: str, *, beta: str = "", motion: str = "torsion", torque: str = "200 N m", rest: str = ""
) -> str:
    """A pair 30/45 with driver and driven, loaded by a torque and what balances it."""
    more = f", helix_angle: {beta}, hand: right" if beta else ""
    less = f", helix_angle: {beta}, hand: left" if beta else ""
    inertia = "inertia: 0.002 kg m^2, mass: 2 kg, transverse_inertia: 0.0015 kg m^2"
    wheel = "inertia: 0.01 kg m^2, mass: 4 kg, transverse_inertia: 0.006 kg m^2"
    return (
        GEARS.format(more=more, less=less)
        + "bodies:\n"
        + f"  driver: {{gears: [g1], motion: {motion}, {inertia}}}\n"
        + f"  driven: {{gears: [g2], motion: {motion}, {wheel}}}\n"
        + "meshes:\n  stage: {gears: [g1, g2], backlash: {base_tangent: 0.1 mm}, "
        + f"stiffness: {stiffness}}}\n"
        + "loads:\n"
        + f"  input: {{body: driver, torque: {torque}}}\n"
        + "  output: {body: driven, torque: balance}\n"
        + rest
    )


def chain(inertias: list[float], stiffnesses: list[float]) -> str:
    """Discs on a line of torsional springs."""
    bodies = "".join(f"  b{k}: {{motion: torsion, inertia: {v}}}\n" for k, v in enumerate(inertias, 1))
    springs = "".join(
        f"  c{k}: {{bodies: [b{k}, b{k + 1}], stiffness: {{torsion: {v}}}}}\n"
        for k, v in enumerate(stiffnesses, 1)
    )
    return f"bodies:\n{bodies}couplings:\n{springs}"


def compiled(text: str, scenario: str | None = None):
    """Model and system of a text."""
    model = loads_model(text if "gears:" in text.split("\n", 1)[0] else SPARE + text)
    return model, compile_model(model, scenario)
