# SPDX-License-Identifier: Apache-2.0
"""Remarks of `check` on numbers without unit, and on parameters without use."""

from __future__ import annotations

import math

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.keys import walk
from pitchpoint.model.model import Model
from pitchpoint.model.reading.bare_numbers import USUAL, is_doubtful
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.remarks.collect import remarks_of_file
from pitchpoint.model.remarks.file import numbers_without_unit
from pitchpoint.model.signal_units import MEANINGS

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


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"SPEED": '"3000"'}, "3000 has no unit and is read as 3000 rad/s = 28648 rpm; write 3000 rpm, or"),
        (
            {"SPEED": "1.5*2000"},
            "1.5*2000 = 3000 has no unit and is read as 3000 rad/s = 28648 rpm; multiply it by 1 rpm, or by "
            "1 rad/s if that is meant",
        ),
        ({"DIRECTION": '"73.5"'}, "73.5 has no unit and is read as 73.5 rad = 4211.2 deg; write 73.5 deg"),
        (
            {"DIRECTION": "phi"},
            "parameter phi = 15 has no unit and is read as 15 rad = 859.44 deg; write phi: ",
        ),
        ({"WIDTH": "4/2"}, "4/2 = 2 has no unit and is read as 2 m = 2000 mm; multiply it by 1 mm"),
    ],
)
def test_texts_formulas_and_parameters_without_unit_are_numbers_too(change, words):
    text = "parameters: {phi: 15}\n" + MODEL
    for name, value in {**PLAIN, **change}.items():
        text = text.replace(name, value)
    found = [str(e) for e in remarks_of_file(loads_model(text)) if "is not used" not in str(e)]
    assert len(found) == 1 and words in found[0]


@pytest.mark.parametrize(
    "change",
    [
        {"SPEED": "2*pi*25"},  # radians by pi
        {"SPEED": "(1.5*2000)*1 rpm"},  # the remedy
        {"SPEED": "n"},
        {"DIRECTION": "2*pi/3"},
        {"DIRECTION": "asin(0.5)*3"},
        {"WIDTH": "2*0.01"},
    ],
)
def test_formulas_in_radians_and_with_units_are_left_alone(change):
    text = "parameters: {n: 300 rpm}\n" + MODEL
    for name, value in {**PLAIN, **change}.items():
        text = text.replace(name, value)
    assert [e for e in remarks_of_file(loads_model(text)) if "is not used" not in e] == []


DRIVEN = MODEL.replace("speed: {a: SPEED}", "drive: {a: {speed: 'SPEED'}}")


def test_a_function_of_time_without_unit():
    def found(speed):
        text = DRIVEN
        for name, value in {**PLAIN, "SPEED": speed}.items():
            text = text.replace(name, value)
        return list(map(str, remarks_of_file(loads_model(text))))

    # its maximum is at t = 0.05 s
    assert found("1500 + 10*sin(2*pi*5*t)") == [
        "scenarios.run.drive.a.speed (line 10): '1500 + 10*sin(2*pi*5*t)' has no unit and is read in rad/s: "
        "up to 1510 rad/s = 14419 rpm in the first second; multiply it by 1 rpm, or by 1 rad/s if that is "
        "meant"
    ]
    assert found("(1500 + 10*sin(2*pi*5*t))*1 rpm") == []
    assert found("1500 rpm + 10 rpm*sin(2*pi*5*t)") == []


def test_the_numbers_of_a_list_have_one_remark():
    text = MODEL.replace("[0, 0, PLACE]", "[10, 20, 30]")
    for name, value in PLAIN.items():
        text = text.replace(name, value)
    [found] = map(str, remarks_of_file(loads_model(text)))
    assert (
        "bodies.a.position[0] (line 6): 10 has no unit and is read as 10 m, like 2 more of its values"
        in found
    )


def test_values_that_are_replaced():
    text = "parameters: {n: 300 rpm}\n" + MODEL
    for name, value in {**PLAIN, "SPEED": "n", "WIDTH": "2"}.items():
        text = text.replace(name, value)
    model = loads_model(text)

    def found(changes):
        return list(map(str, numbers_without_unit(model.replace_all(changes))))

    [width] = found({})
    assert width.startswith("gears.pinion.face_width (line 3): 2 has no unit")
    assert found({"gears.pinion.face_width": 0.02}) == found({"gears.pinion.face_width": "2 mm"}) == []
    assert found({"scenarios.run.speed.a": 300})[1:] == [
        "scenarios.run.speed.a: 300 has no unit and is read as 300 rad/s = 2864.8 rpm; write 300 rpm, or 300 "
        "rad/s if that is meant"
    ]
    assert found({"parameters.n": 300.0})[1:] == [
        "parameters.n: 300 has no unit and is read as 300 rad/s = 2864.8 rpm; write 300 rpm, or 300 rad/s if "
        "that is meant"
    ]
    model = model.replace("parameters.n", 300.0)
    assert found({"parameters.n": "200 rpm"}) == [width]


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (2.5, "m_n: 2.5 has no unit and is read as 2.5 m = 2500 mm; write 2.5 mm"),
        ("2500 mm", "correct the formula; the value is 3 mm, for instance"),
    ],
)
def test_a_parameter_out_of_range_without_unit(value, words):
    text = "parameters: {m_n: 3 mm}\n" + MODEL.replace("3 mm", "m_n")
    for name, number in PLAIN.items():
        text = text.replace(name, number)
    with pytest.raises(ModelError) as error:
        loads_model(text).replace("parameters.m_n", value)
    assert all("is out of range" in p and p.endswith(words) for p in error.value.problems)


@pytest.mark.parametrize(
    ("value", "words"),
    [
        ('"3"', "'3' is out of range (limit > 0 and <= 1000 mm); a bare number is in metres; write 3 mm"),
        (
            "1.5*2",
            "'1.5*2' = 3000 mm is out of range (limit > 0 and <= 1000 mm); a formula without unit is in ",
        ),
        ("3 m", "'3 m' is out of range (limit > 0 and <= 1000 mm); write 3 mm"),
    ],
)
def test_a_text_out_of_range_without_unit(value, words):
    text = MODEL.replace("3 mm", value, 1)
    for name, number in PLAIN.items():
        text = text.replace(name, number)
    with pytest.raises(ModelError) as error:
        loads_model(text)
    assert words in error.value.problems[0]


def test_values_of_text_files_have_no_remark(tmp_path):
    (tmp_path / "pitch.txt").write_text("f_p [um]\n1\n2\n" + "0\n" * 18)
    text = MODEL.replace("hand: right}", "hand: right, deviations: {pitch: pitch.txt}}")
    for name, value in PLAIN.items():
        text = text.replace(name, value)
    model = loads_model(text, file=str(tmp_path / "model.yaml"))
    assert remarks_of_file(model) == ()


def test_an_unused_parameter_is_named():
    text = "parameters: {a: 3 mm, b: 2*a, c: 1 mm}\nbodies: {x: {inertia: 1 kg m^2, position: [b, 0, 0]}}"
    assert list(map(str, remarks_of_file(loads_model(text)))) == [
        "parameters.c (line 1): is not used; use or remove it"
    ]


SIGNALS = """\
bodies: {a: {inertia: 1 kg m^2}, b: {mass: 1 kg}}
joints: {slide: {type: prismatic, bodies: [ground, b], position: [0, 0, 0]}}
sensors:
  p: {type: joint, coordinate: a}
  w: {type: joint, coordinate: a, derivative: 1}
  x: {type: joint, coordinate: slide.z}
blocks:
  command: {type: input, value: 12, unit: rad}
  low: {type: filter, input: p, time_constant: 1 s}
  cut: {type: limits, input: low, limits: [0, 90]}
  drive: {type: rate_limit, input: cut, rate: 8, time_constant: 0.1 s, start: 0.3}
  curve: {type: table, input: w, points: [[0, 0], [100, 5000]], unit: N m}
  error: {type: sum, inputs: {w: -1}, offset: 1500, unit: rad/s}
  slip: {type: friction, input: w, wind_up: 1}
  torque: {type: pid, input: error, proportional: 100, limits: [0, 5000], unit: N m}
  place: {type: limits, input: x, limits: [0, 20]}
  move: {type: rate_limit, input: x, rate: 8, time_constant: 0.1 s}
  right: {type: rate_limit, input: cut, rate: 8 deg/s, time_constant: 0.1 s}
controllers:
  pid: {type: pid, input: error, output: angle, proportional: 3, limits: [-30, "30"], period: 1 ms, unit: rad}
scenarios:
  run: {duration: 1 s, start: assembled, inputs: {command: {points: [[0 s, 0], [1 s, 45]]}}}
"""


def test_numbers_of_signals_are_remarked_in_the_unit_of_their_signal():
    found = [str(each) for each in numbers_without_unit(loads_model(SIGNALS))]
    assert [each.partition(":")[0] for each in found] == [
        "blocks.command.value (line 8)",
        "blocks.cut.limits[1] (line 10)",
        "blocks.drive.rate (line 11)",
        "blocks.curve.points[1][0] (line 12)",
        "blocks.error.offset (line 13)",
        "blocks.slip.wind_up (line 14)",
        "blocks.place.limits[1] (line 16)",
        "controllers.pid.limits[0] (line 20)",
        "scenarios.run.inputs.command.points[1][1] (line 22)",
    ]
    assert "8 has no unit and is read as 8 rad/s = 458.37 deg/s; write 8 deg/s, or 8 rad/s if" in found[2]
    assert "90 has no unit and is read as 90 rad = 5156.6 deg; write 90 deg" in found[1]
    changed = loads_model(SIGNALS).replace("blocks.right.rate", 9)
    assert "blocks.right.rate: 9 has no unit" in str(numbers_without_unit(changed)[-1])


def test_a_curve_from_a_file_has_one_remark(tmp_path):
    (tmp_path / "curve.txt").write_text("0 0\n50 20\n100 30\n")
    text = SIGNALS.replace("[[0, 0], [100, 5000]]", "curve.txt")
    (tmp_path / "model.yaml").write_text(text)
    model = loads_model(text, file=str(tmp_path / "model.yaml"))
    assert sum("blocks.curve" in str(each) for each in numbers_without_unit(model)) == 1


FORMS = {
    "quantity": lambda v, n: v,
    "law": lambda v, n: v,
    "center": lambda v, n: v,
    "quantities": lambda v, n: [v] * n,
    "pitch": lambda v, n: [v] * n,
    "laws": lambda v, n: [v] * n,
    "grid": lambda v, n: [[v]],
    "points": lambda v, n: [[v, v], [v + 1.0, v]],
    "speeds": lambda v, n: {"a": v},
    "gears": lambda v, n: {"a": v},
    "rates": lambda v, n: {"spin": v},
    "displacements": lambda v, n: {"x": v},
    "motions": lambda v, n: {"x": v},
    "orders": lambda v, n: {1: [v, v]},
}
"""Numbers without unit in the form of every kind of key that has a length, an angle or a speed."""
OF_SIGNALS = ("value", "values", "gains", "curve", "records")


def test_no_key_of_a_model_escapes_the_remark_on_numbers_without_unit():
    watched = 0
    for owner, name, key in {
        (owner, name): (owner, name, key) for _, owner, name, key in walk(Model)
    }.values():
        if key.kind in OF_SIGNALS:
            assert (owner, name) in MEANINGS
        elif key.dimension in USUAL or (not key.dimension and key.kind in FORMS):
            dimension = key.dimension or "length"
            value = next((v for v in (7.0, 1.0) if key.allows(v) and is_doubtful(v, dimension)), None)
            if value is None:  # refused by its range
                continue
            reader = Reader()
            reader.keyed(key, FORMS[key.kind](value, max(key.length[0], 1)), (owner.__name__, name))
            assert reader.bare, (owner, name)
            watched += 1
    assert watched > 200
