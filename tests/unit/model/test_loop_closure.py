# SPDX-License-Identifier: Apache-2.0
"""A loop of meshes that does not close: the message has positions with which it does."""

from __future__ import annotations

import math
import re

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model

SPLIT = """
gears:
  p: {number_of_teeth: 24, normal_module: 3 mm, face_width: 25 mm, profile_shift_coefficient: 0}
  i1: {number_of_teeth: 36, normal_module: 3 mm, face_width: 25 mm, profile_shift_coefficient: 0}
  i2: {number_of_teeth: 36, normal_module: 3 mm, face_width: 25 mm, profile_shift_coefficient: 0}
  w: {number_of_teeth: 60, normal_module: 3 mm, face_width: 25 mm, profile_shift_coefficient: 0}
bodies:
  pin: {gears: [p], position: [0, 0, 0]}
  id1: {gears: [i1], position: [X1 mm, Y1 mm, 0]}
  id2: {gears: [i2], position: [X1 mm, -Y1 mm, 0]}
  whl: {gears: [w], position: [D mm, 0, 0]}
meshes:
  p1: {gears: [p, i1]}
  p2: {gears: [p, i2]}
  w1: {gears: [i1, w]}
  w2: {gears: [i2, w]}
"""
RING = """
gears:
  s: {number_of_teeth: 24, normal_module: 3 mm, face_width: 25 mm, profile_shift_coefficient: 0}
  p1: {number_of_teeth: 18, normal_module: 3 mm, face_width: 25 mm, profile_shift_coefficient: 0}
  p2: {number_of_teeth: 18, normal_module: 3 mm, face_width: 25 mm, profile_shift_coefficient: 0}
  r: {type: internal, tip_diameter: 177 mm, number_of_teeth: 60, normal_module: 3 mm, face_width: 25 mm,
    profile_shift_coefficient: 0}
bodies:
  sun: {gears: [s], position: [0, 0, 0]}
  one: {gears: [p1], position: [63 mm, 0, 0]}
  two: {gears: [p2], position: [X mm, Y mm, 0]}
  ring: {gears: [r], position: [0, 0, 0]}
meshes:
  s1: {gears: [s, p1]}
  s2: {gears: [s, p2]}
  r1: {gears: [p1, r]}
  r2: {gears: [p2, r]}
"""
PLACE = re.compile(r"(\w+) at \[([^,]+), ([^,]+), 0\] mm")


def split(d: float) -> str:
    """Pinion, two idlers at 90 mm from it and 144 mm from the wheel, at a distance d [mm]."""
    x = (90.0**2 - 144.0**2 + d**2) / (2.0 * d)
    y = math.sqrt(90.0**2 - x**2)
    return SPLIT.replace("X1", f"{x:.12g}").replace("Y1", f"{y:.12g}").replace("D", f"{d:.12g}")


def placed(text: str) -> tuple[list[str], str]:
    """Bodies that the message moves, and the file with their new positions."""
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    [problem] = caught.value.problems
    assert "overlap by" in problem.text
    assert "with the same centre distances it closes with" in str(problem.remedy)
    found = PLACE.findall(str(problem.remedy))
    for body, x, y in found:
        text = re.sub(rf"({body}: .*position: )\[.*?\]", rf"\1[{x} mm, {y} mm, 0]", text)
    return [body for body, _, _ in found], text


@pytest.mark.parametrize("d", [138.0, 140.4, 143.0])
def test_a_pair_of_idlers(d: float) -> None:
    """Centre distances are checked by the model, which reads them from the positions."""
    moved, text = placed(split(d))
    model = loads_model(text)
    assert moved == ["id2", "whl"]
    assert max(map(abs, model.phasing.offset.values())) < 1e-6
    assert [abs(model.meshes[m].a_w or 0.0) for m in ("p2", "w2")] == pytest.approx([0.09, 0.144], abs=2e-8)


@pytest.mark.parametrize("degrees", [124.5, 126.0])
def test_a_planet_between_sun_and_ring_swings_alone(degrees: float) -> None:
    """To a whole multiple of 360 deg/(24 + 60), the assembly condition of planetary sets."""
    angle = math.radians(degrees)
    text = RING.replace("X", f"{63 * math.cos(angle):.12g}").replace("Y", f"{63 * math.sin(angle):.12g}")
    moved, text = placed(text)
    assert moved == ["two"]
    x, y, _ = loads_model(text).bodies["two"].origin or (0.0, 0.0, 0.0)
    turns = math.degrees(math.atan2(y, x)) / (360.0 / 84.0)
    assert turns == pytest.approx(29.0, abs=1e-4)


def test_a_closed_loop_has_no_message() -> None:
    """The distance of the split path found by hand in advance."""
    assert max(map(abs, loads_model(split(149.34655173399418)).phasing.offset.values())) < 1e-9
