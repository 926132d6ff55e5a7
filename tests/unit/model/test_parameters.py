# SPDX-License-Identifier: Apache-2.0
"""Parameters and constant formulas in model files: reading, replacing, writing."""

from __future__ import annotations

import math
import pickle

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.core.provenance import content_hash, plain_data
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.model.components.law import Constant, FormulaLaw
from pitchpoint.model.components.parameter import Parameter
from pitchpoint.model.numbers import has_path, number_at
from pitchpoint.model.write import model_text

MODEL = """\
title: pair
parameters:
  width: {value: 20 * m_n / 3, text: common face width}
  m_n: 3 mm
  gap: 40 um
  n: 1500 rpm
  z: 20
  f: 25 Hz
  M: 150 N m
gears:
  pinion: {number_of_teeth: z, normal_module: m_n, face_width: width, profile_shift_coefficient: 0}
  wheel: {number_of_teeth: 2*z, normal_module: m_n, face_width: width - 2 mm, profile_shift_coefficient: 0}
bodies:
  a: {gears: [pinion], inertia: 0.01 kg m^2, position: [302.585 mm * cos(120 deg), 10*m_n, 0]}
  b: {gears: [wheel], inertia: 0.01 kg m^2}
meshes:
  stage: {gears: [pinion, wheel], backlash: {normal: gap/2}, stiffness: {law: constant, value: 4e8 N/m}}
loads:
  drive: {body: a, torque: M * (1 + 0.1*sin(2*pi*f*t))}
  brake: {body: b, torque: -2*M}
scenarios:
  run: {speed: {a: n}, duration: 1 s, sample_rate: 10*n*z/(1 rev)}
"""


@pytest.fixture(scope="module")
def model():
    return loads_model(MODEL)


def problems_of(text):
    with pytest.raises(ModelError) as found:
        loads_model(text)
    return [str(problem) for problem in found.value.problems]


def refusal(model, path, value):
    with pytest.raises(ModelError) as found:
        model.replace(path, value)
    return "\n".join(map(str, found.value.problems))


def test_values_follow_from_formulas_and_parameters(model):
    assert model.gears["pinion"].face_width == pytest.approx(0.02, rel=1e-15)
    assert model.gears["wheel"].face_width == pytest.approx(0.018, rel=1e-15)
    assert (model.gears["pinion"].number_of_teeth, model.gears["wheel"].number_of_teeth) == (20, 40)
    assert model.bodies["a"].position == pytest.approx((-0.1512925, 0.03, 0.0), rel=1e-12)
    assert model.meshes["stage"].backlash.normal == 2e-5
    assert model.scenarios["run"].speed["a"] == 50.0 * math.pi
    assert model.scenarios["run"].sample_rate == pytest.approx(5000.0)
    assert model.loads["brake"].torque == Constant(-300.0)


def test_formulas_of_laws_contain_the_values_in_si(model):
    law = model.loads["drive"].torque
    assert law == FormulaLaw("(150.0) * (1 + 0.1*sin(2*pi*(25.0)*t))")


def test_a_plain_quantity_is_the_same_number_as_a_parameter_and_as_a_value():
    for written in ("159.66 mm", "20.1 mm", "900 mil"):
        text = MODEL.replace("face_width: width,", f"face_width: {written},")
        alone = loads_model(text).gears["pinion"].face_width
        named = loads_model(
            MODEL.replace("gap/2", "20 um")
            .replace("gap: 40 um", f"gap: {written}")
            .replace("face_width: width,", "face_width: gap,")
        )
        named = named.gears["pinion"].face_width
        assert alone == named


def test_a_changed_parameter_changes_all_that_depends_on_it(model):
    changed = model.replace("parameters.m_n", "6 mm")
    assert changed.gears["pinion"].normal_module == 0.006
    assert changed.gears["wheel"].face_width == pytest.approx(0.038)  # through another parameter
    assert changed.bodies["a"].position[1] == pytest.approx(0.06)  # in a list
    assert changed.meshes["stage"].backlash == model.meshes["stage"].backlash
    assert changed.parameters["width"] == model.parameters["width"]
    assert content_hash(changed) == content_hash(loads_model(MODEL.replace("m_n: 3 mm", "m_n: 6 mm")))


def test_laws_follow_a_parameter(model):
    changed = model.replace("parameters.M", "10 N m")
    assert changed.loads["drive"].torque.text.startswith("(10.0) *")
    assert changed.loads["brake"].torque == Constant(-20.0)


def test_a_replaced_value_no_longer_follows_and_its_neighbours_do(model):
    both = model.replace_all({"parameters.n": "300 rpm", "scenarios.run.sample_rate": "1 kHz"})
    assert both.scenarios["run"].sample_rate == 1000.0
    assert both.scenarios["run"].speed["a"] == pytest.approx(10.0 * math.pi)
    two = model.replace("scenarios.run.speed.b", "-n/2").replace("parameters.n", 10.0)
    assert two.scenarios["run"].speed == {"a": 10.0, "b": -5.0}
    cut = two.replace("scenarios.run.speed.b", "-5 rad/s").replace("meshes.stage.backlash.normal", "1 um")
    assert cut.replace("parameters.gap", 1e-4).meshes["stage"].backlash.normal == 1e-6
    assert cut.origin.sources["scenarios", "run", "speed"].data == {"a": "n", "b": "-5 rad/s"}


def test_a_new_value_may_use_parameters(model):
    changed = model.replace("meshes.stage.backlash.normal", "gap/4").replace("parameters.gap", "80 um")
    assert changed.meshes["stage"].backlash.normal == 2e-5
    whole = model.replace("meshes.stage.damper", {"ratio": "z/1000"}).replace("parameters.z", 30)
    assert whole.meshes["stage"].damper.ratio == 0.03
    assert whole.gears["wheel"].number_of_teeth == 60


def test_a_number_has_the_unit_of_the_parameter(model):
    changed = model.replace("parameters.n", 100.0)
    assert changed.parameters["n"].value == "100.0 rad/s"
    assert number_at(changed, "parameters.n") == (100.0, "rad/s")
    assert number_at(model, "parameters.gap") == (4e-5, "m")
    assert has_path(model, "parameters.gap") and not has_path(model, "parameters.slot")


@pytest.mark.parametrize(
    ("path", "value", "words"),
    [
        (
            "parameters.gap",
            "3 N",
            "has the unit N, but the value in the file has the unit m; give",
        ),
        ("parameters.gap", "gap + 1 um", "depends on itself: gap -> gap"),
        ("parameters.gp", "3 mm", "does not exist; did you mean gap?"),
        ("meshes.stage.backlash.normal", "gp/2", "unknown name 'gp'; did you mean gap?"),
        ("meshes.stage.backlash.normal", "M", "M has the unit N m; that of a length"),
        ("meshes.stage.backlash.normal", "2*M", "its units give N m, not m (a length such as 3 mm)"),
        ("meshes.stage.backlash.normal", "z", "z has no unit; that of a length"),
        ("meshes.stage.backlash.normal", "gap*t/(1 s)", "cannot depend on t"),
        ("gears.pinion.face_width", "m_n - 20 mm", "'m_n - 20 mm' = -17 mm is out of range (limit > 0"),
        ("gears.pinion.number_of_teeth", "z/3", "'z/3' = 6.66667 is not a whole number"),
        ("scenarios.run.sample_rate", "2*n", "write n/(1 rev) for the frequency of a speed n"),
        ("scenarios.run.speed.a", "2*f", "write 2*pi*50 Hz"),
        ("parameters.m_n", "-3 mm", "gears.pinion.normal_module: 'm_n' = -3 mm is out of range"),
    ],
)
def test_wrong_values_are_refused_with_place_limit_and_remedy(model, path, value, words):
    assert words in refusal(model, path, value)


def test_parameter_of_an_angular_speed_as_frequency_is_read_like_a_quantity(model):
    assert model.replace("scenarios.run.sample_rate", "n").scenarios["run"].sample_rate == pytest.approx(25.0)
    assert model.replace("scenarios.run.speed.a", "f").scenarios["run"].speed["a"] == 50.0 * math.pi


def test_cycles_are_reported_with_their_path_and_nothing_else():
    found = problems_of(MODEL.replace("m_n: 3 mm", "m_n: width/7 + gap"))
    assert found == [
        "parameters.width (line 3): depends on itself: width -> m_n -> width; give one of them a number"
    ]


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("gap: 40 um", "mm: 40 um", "parameters.mm (line 5): is the symbol of a unit"),
        ("gap: 40 um", "t: 40 um", "is a variable of formulas"),
        ("gap: 40 um", "sin: 40 um", "is a function or constant of formulas"),
        ("gap: 40 um", "slot-1: 40 um", "is not a name that a formula can use"),
        ("gap: 40 um", "gap: 40 umm", "unknown unit 'umm'"),
        ("gap: 40 um", "gap: [1, 2]", "is neither a number nor a formula"),
        ("gap: 40 um", "gap: {valu: 1}", "did you mean value?"),
        ("n: 1500 rpm", "n: 1500 1/min", "does not state what is counted; write rpm"),
        ("gap: 40 um", "gap: sqrt(1 mm)", "has a unit with a fractional power"),
        ("gap: 40 um", "gap: 40 um + 3 N", "'+' joins m and N"),
        (
            "gap: 40 um",
            "gap: pi/60 rad",
            "division by an angle at character 3, near 'pi/60 rad'; write pi/60 * 1 rad",
        ),
        ("gap: 40 um", "gap: 180/60 deg", "write 180/60 * 1 deg, or 180/(60 deg) for a value per angle"),
    ],
)
def test_wrong_parameters_are_refused(old, new, words):
    found = problems_of(MODEL.replace(old, new))
    assert any(words in problem for problem in found), found


def test_an_unreadable_parameter_is_reported_once():
    assert len(problems_of(MODEL.replace("gap: 40 um", "gap: 40 umm"))) == 1


def test_a_model_is_written_with_its_formulas(model):
    for text in (dump_model(model), model_text(model)):
        again = loads_model(text)
        assert content_hash(again) == content_hash(model)
        assert again.origin.sources == model.origin.sources
    changed = dump_model(model.replace("gears.wheel.face_width", "18 mm").replace("parameters.gap", "30 um"))
    assert "normal: gap/2" in changed and "gap: 30 um" in changed
    assert "face_width: 18 mm" in changed and "width - 2 mm" not in changed


def test_a_model_with_parameters_can_be_pickled(model):
    again = pickle.loads(pickle.dumps(model))
    assert again.replace("parameters.gap", "20 um").meshes["stage"].backlash.normal == 1e-5


def test_a_model_without_parameters_retains_its_hash():
    text = "bodies: {a: {inertia: 0.01 kg m^2, position: [10*3 mm, 0, 0]}}"
    plain = loads_model(text)
    assert plain.bodies["a"].position[0] == 0.03
    assert "parameters" not in plain_data(plain) and "parameters" not in dump_model(plain)
    assert not any(s.names for s in plain.origin.sources.values()) and plain.others == {}


def test_parameters_made_in_python_are_checked(model):
    more = {**model.parameters, "slot": Parameter("2*gap")}
    assert model.replace("parameters", more).amounts["slot"].value == 8e-5
    with pytest.raises(ModelError, match="is the symbol of a unit"):
        model.replace("parameters", {**model.parameters, "mm": Parameter("2*gap")})


def test_matrices_terms_and_signals_may_contain_parameters():
    text = """
parameters: {k: 2e8 N/m, radius: 30 mm, ratio: 2, gain: 3 N m s/rad}
bodies:
  motor: {inertia: 0.02 kg m^2, position: [0, 0, 0]}
  fan: {inertia: 0.02 kg m^2, position: [0, 1 m, 0]}
  block: {mass: 1 kg, inertia: 1e-3 kg m^2, transverse_inertia: 1e-3 kg m^2, motion: free,
    position: [1 m, 0, 0]}
bearings:
  b: {body: block, stiffness: {matrix: [[k,0,0,0,0,0],[0,k,0,0,0,0],[0,0,2*k,0,0,0],
     [0,0,0,100,0,0],[0,0,0,0,100,0],[0,0,0,0,0,100]]}}
ratios:
  belt: {terms: {motor: radius, fan: -2*radius}}
sensors: {speed: {type: joint, coordinate: motor, derivative: 1}}
blocks:
  wanted: {type: formula, formula: gain*(100 - w), inputs: [w], unit: N m}
  w: {type: sum, inputs: {speed: ratio}, unit: rad/s}
actuators: {m: {type: torque, signal: wanted, bodies: [motor]}}
"""
    model = loads_model(text)
    assert [row[i] for i, row in enumerate(model.bearings["b"].stiffness.matrix)] == [
        2e8,
        2e8,
        4e8,
        100,
        100,
        100,
    ]
    assert model.ratios["belt"].terms == {"motor": 0.03, "fan": -0.06}
    assert model.blocks["w"].inputs == {"speed": 2.0}
    assert model.blocks["wanted"].formula == "(3.0)*(100 - w)"
    changed = model.replace_all({"parameters.gain": "6 N m s/rad", "parameters.k": "1e8 N/m"})
    assert changed.blocks["wanted"].formula == "(6.0)*(100 - w)"
    assert changed.bearings["b"].stiffness.matrix[2][2] == 2e8
