# SPDX-License-Identifier: Apache-2.0
"""The two model files that the command line must read verbatim, and how to run a command on them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from pitchpoint.cli.main import run_command

ISO_EX1 = """\
title: ISO/TR 6336-30 example 1
gears:
  pinion: {number_of_teeth: 17, normal_module: 8 mm, normal_pressure_angle: 20 deg, helix_angle: 15.8 deg, hand: left,
           profile_shift_coefficient: 0.145, face_width: 100 mm, tip_diameter: 159.66 mm, rack: {addendum: 1.0, dedendum: 1.4, root_radius: 0.39}}
  wheel:  {number_of_teeth: 103, normal_module: 8 mm, normal_pressure_angle: 20 deg, helix_angle: 15.8 deg, hand: right,
           profile_shift_coefficient: 0.0, face_width: 100 mm, tip_diameter: 872.35 mm, rack: {addendum: 1.0, dedendum: 1.4, root_radius: 0.39}}
meshes:
  stage: {gears: [pinion, wheel], center_distance: 500 mm, stiffness: {law: din3990, stiffness_ratio: 0.8, tip_relief_factor: 0.0}}
"""  # noqa: E501 - verbatim

TORSION = """\
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
"""  # noqa: E501 - verbatim


def written(folder: Path, text: str, name: str = "model.yaml") -> str:
    """Write a model file and return its path."""
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return str(path)


def json_of(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> Any:
    """Run a command with --json and return what it prints; stdout must be JSON and nothing else."""
    code = run_command([*arguments, "--json"])
    captured = capsys.readouterr()
    assert code == 0, captured.err
    return json.loads(captured.out)
