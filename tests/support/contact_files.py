# SPDX-License-Identifier: Apache-2.0
"""Models of one mesh with contact of tooth surfaces."""

from __future__ import annotations

from pitchpoint.io.yaml_model import load_model
from pitchpoint.model.model import Model

FZG = """\
title: FZG type C
gears:
  g1: {{number_of_teeth: 16, normal_module: 4.5 mm, face_width: {b}, profile_shift_coefficient: 0.1817{one}}}
  g2: {{number_of_teeth: 24, normal_module: 4.5 mm, face_width: {b}, profile_shift_coefficient: 0.1715{two}}}
bodies:
  a: {{gears: [g1], motion: torsion}}
  b: {{gears: [g2], motion: torsion}}
meshes:
  stage:
    gears: [g1, g2]
    center_distance: 91.5 mm
    contact: {{{contact}}}
{more}
"""
RIGID = "level: rigid, stiffness: {k} N/m, planes: {n}"

HELICAL = """\
title: helical pair
gears:
  g1: {{number_of_teeth: 25, normal_module: 3 mm, face_width: 40 mm, helix_angle: 18 deg, hand: right,
       profile_shift_coefficient: 0}}
  g2: {{number_of_teeth: 60, normal_module: 3 mm, face_width: 40 mm, helix_angle: 18 deg, hand: left,
       profile_shift_coefficient: 0}}
bodies:
  a: {{gears: [g1], motion: torsion}}
  b: {{gears: [g2], motion: torsion}}
meshes:
  stage: {{gears: [g1, g2], contact: {{{contact}}}}}
"""


def fzg(
    folder,
    *,
    k: float = 2.338e8,
    planes: int = 11,
    b: str = "14 mm",
    gears: tuple[str, str] = ("", ""),
    more: str = "",
) -> Model:
    """FZG gears type C with rigid contact; `gears`: more keys of both gears, `more`: more sections."""
    contact = RIGID.format(k=k, n=planes)
    one, two = (f", {text}" if text else "" for text in gears)
    path = folder / "fzg.yaml"
    path.write_text(FZG.format(b=b, one=one, two=two, contact=contact, more=more), encoding="utf-8")
    return load_model(path)


def helical(folder, *, k: float = 4e8, planes: int = 11) -> Model:
    """Helical pair with rigid contact."""
    path = folder / "helical.yaml"
    path.write_text(HELICAL.format(contact=RIGID.format(k=k, n=planes)), encoding="utf-8")
    return load_model(path)
