# SPDX-License-Identifier: Apache-2.0
"""Remarks of `check` on numbers without unit, and on parameters without use."""

from __future__ import annotations

import math

import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.reading.bare_numbers import is_doubtful
from pitchpoint.model.remarks.collect import remarks_of_file

MODEL = """\
gears:
  pinion: {number_of_teeth: 20, normal_module: 3 mm, face_width: WIDTH, helix_angle: HELIX, hand: right}
  wheel: {number_of_teeth: 40, normal_module: 3 mm, face_width: 20 mm, helix_angle: 15 deg, hand: left,
    profile_shift_coefficient: 0}
bodies:
  a: {gears: [pinion], inertia: 0.01 kg m^2, position: [0, 0, PLACE]}
  b: {gears: [wheel], inertia: 0.01 kg m^2}
meshes:
  stage: {gears: [pinion, wheel], center_distance: 93.2 mm, direction: DIRECTION, stiffness: {law: din3990}}
scenarios: {run: {speed: {a: SPEED}, duration: 1 s}}
"""
PLAIN = {"WIDTH": "0.02", "HELIX": "0.2617993877991494", "PLACE": "0.5", "DIRECTION": "1.5", "SPEED": "0"}


def remarks(**changes):
    text = MODEL
    for name, value in {**PLAIN, **changes}.items():
        text = text.replace(name, value)
    return [str(each) for each in remarks_of_file(loads_model(text))]


def test_a_bare_speed_is_stated_in_both_units():
    assert remarks(SPEED="3000") == [
        "scenarios.run.speed.a (line 10): 3000 has no unit and is read as 3000 rad/s = 28648 rpm; "
        "write 3000 rpm, or 3000 rad/s if that is meant"
    ]
    assert remarks(SPEED="3000 rad/s") == remarks(SPEED="3000 rpm") == []


def test_bare_lengths_and_angles_that_are_rarely_meant():
    assert remarks(WIDTH="2") == [
        "gears.pinion.face_width (line 2): 2 has no unit and is read as 2 m = 2000 mm; "
        "write 2 mm, or 2 m if that is meant"
    ]
    [found] = remarks(DIRECTION="30")
    assert "meshes.stage.direction (line 9): 30 has no unit and is read as 30 rad = 1718.9 deg" in found
    assert "write 30 deg" in found
    [found] = remarks(PLACE="20")  # in a list
    assert "bodies.a.position[2] (line 6): 20 has no unit and is read as 20 m" in found


def test_numbers_that_are_plausible_in_si_are_left_alone():
    assert remarks() == []


@pytest.mark.parametrize(
    ("value", "dimension", "doubtful"),
    [
        (0.0, "angular_speed", False),
        (12.566, "angular_speed", True),
        (0.999, "length", False),
        (-1.0, "length", True),
        (1.0, "angle", True),
        (math.pi / 2, "angle", False),
        (6.5, "angle", True),
        (3000.0, "stiffness", False),
    ],
)
def test_what_is_doubtful(value, dimension, doubtful):
    assert is_doubtful(value, dimension) is doubtful


def test_values_of_python_and_of_text_files_have_no_remark(tmp_path):
    (tmp_path / "pitch.txt").write_text("f_p [um]\n1\n2\n" + "0\n" * 18)
    text = MODEL.replace("hand: right}", "hand: right, deviations: {pitch: pitch.txt}}")
    for name, value in PLAIN.items():
        text = text.replace(name, value)
    model = loads_model(text, file=str(tmp_path / "model.yaml"))
    assert remarks_of_file(model.replace("scenarios.run.speed.a", 100.0)) == ()


def test_an_unused_parameter_is_named():
    text = "parameters: {a: 3 mm, b: 2*a, c: 1 mm}\nbodies: {x: {inertia: 1 kg m^2, position: [b, 0, 0]}}"
    assert list(map(str, remarks_of_file(loads_model(text)))) == [
        "parameters.c (line 1): is not used; use or remove it"
    ]
