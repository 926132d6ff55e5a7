# SPDX-License-Identifier: Apache-2.0
"""Bevel meshes in model files: what is wrong is told with its place, value, limit and remedy, all at once."""

import math
from pathlib import Path

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.model.remarks.collect import odd_shapes
from pitchpoint.model.schema import json_schema
from tests.support.bevel_files import bevel_file


def told(text):
    """All problems of a file as text."""
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    return str(caught.value)


def test_a_sound_file_has_its_pair_and_backlash():
    model = loads_model(bevel_file(z=(15, 45), shaft=75.0, spiral=35.0))
    pair = model.bevel_pairs["m"]
    assert math.degrees(pair.Sigma) == pytest.approx(75.0)
    assert model.backlash("m") == pytest.approx(0.05e-3 / math.cos(pair.beta_b), rel=1e-12)
    geometry = model.replace("bevel_meshes.m.backlash", None)
    assert geometry.backlash("m") == pytest.approx(pair.R_m * pair.sigma_j, abs=1e-15)
    along = model.replace("bevel_meshes.m.backlash", {"circumferential": "0.1 mm"})
    assert along.backlash("m") == pytest.approx(0.1e-3 * math.cos(pair.alpha_t), rel=1e-12)


@pytest.mark.parametrize(
    "old, new, words",
    [
        ("gears: [a, b]", "gears: [a, c]", ("bevel_meshes.m.gears", "'c'", "there are a, b")),
        ("gears: [a, b]", "gears: [a, a]", ("names a twice",)),
        ("law: constant", "law: energy", ("energy", "din3990", "constant")),
        ("backlash: {normal", "center_distance: 3 mm, backlash: {normal", ("center_distance",)),
        (
            "backlash: {normal",
            "transmission_error: {cosine: [1e-6]}, backlash: {normal",
            ("transmission_error",),
        ),
        ("backlash: {normal", "misalignment: {in_plane: 1e-3}, backlash: {normal", ("misalignment",)),
        (
            "{normal: 0.05 mm}",
            "{normal: 0.05 mm, base_tangent: 1 mm}",
            ("backlash", "normal and base_tangent"),
        ),
        ("backlash: {normal: 0.05 mm}", "damping: {ratio: 0.1, d_in: 3}", ("damping", "d_in and ratio")),
        (
            "backlash: {normal: 0.05 mm}",
            "damping: {pair: 3}",
            ("damping.pair", "describes the whole mesh"),
        ),
        ("backlash: {normal: 0.05 mm}", "shaft_angle: 80 deg", ("pitch cone angles of this shaft angle",)),
        ("position: [-0.0, -0.0, -0.0]", "position: [0, 0.3 mm, 0]", ("0.3 mm apart", "one apex", "first")),
        ("hand: left", "hand: right", ("hands that do not fit an external pair", "opposite hands")),
        (
            "number_of_teeth: 40, mate_teeth: 20",
            "number_of_teeth: 41, mate_teeth: 20",
            ("pitch cone angles",),
        ),
    ],
)
def test_what_is_wrong(old, new, words):
    text = bevel_file(spiral=20.0)
    assert old in text
    message = told(text.replace(old, new, 1))
    for word in words:
        assert word in message, message


def test_apexes_apart_and_axes_askew_are_told_with_how_much():
    text = bevel_file(mounting=(0.02, 0.0)).replace("{a: 0.02}", "{a: 0.021}")
    assert "1 mm apart" in told(text)
    askew = bevel_file(shaft=90.0).replace("axes: {z: [1.0, 0.0, 0.0]", "axes: {z: [1.0, 0.0, 0.01]")
    askew = askew.replace("axes: {z: [1.0, 0.0, 6.123233995736766e-17]", "axes: {z: [1.0, 0.0, 0.01]")
    message = told(askew)
    words = (
        "89.4271 deg is the angle between the axes of a and b, from the apex into the gears, 0.573 deg off"
    )
    assert f"m.gears (line 9): {words} (limit 90 deg, the sum of their pitch cone angles); correct" in message
    given = told(askew.replace("backlash: {", "shaft_angle: 90 deg, backlash: {"))
    assert f"m.shaft_angle (line 9): {words} (limit 90 deg, as given)" in given


def test_opposite_opening_is_an_axis_at_the_wrong_angle():
    message = told(bevel_file(shaft=75.0).replace("opens: +z", "opens: -z", 1))
    assert "105 deg is the angle" in message and "`opens`" in message


def test_faces_beside_each_other_and_wide_ones_are_remarked():
    """Cone distances by hand: R_e = 1.5 mm sqrt(20^2 + 40^2) = 67.082 mm, 10 % more for a module of 3.3 mm;
    the shared part of both widths of 20 mm is 67.082 - (73.790 - 20) = 13.292 mm, 66.5 %."""
    text = bevel_file()
    assert odd_shapes(loads_model(text)) == ()
    (beside,) = odd_shapes(loads_model(text.replace("module: 3 mm", "module: 3.3 mm", 1)))
    assert beside == (
        "bevel_meshes.m.gears: a 53.7902 mm to 73.7902 mm, b 47.082 mm to 67.082 mm from the apex share "
        "66.5 % of the narrower face (limit 95 %); "
        "give both the same outer_transverse_module (3.3 mm and 3 mm now)"
    )
    rounded = text.replace("outer_transverse_module: 3 mm", "mean_normal_module: 2.553 mm", 1)
    assert odd_shapes(loads_model(rounded)) == ()
    wide = text.replace("face_width: 20 mm", "face_width: 22.5 mm")
    assert [w[: w.index(";")] for w in odd_shapes(loads_model(wide))] == [
        f"bevel_gears.{g}.face_width: 22.5 mm is a wide face for a bevel gear (limit 22.3607 mm, a third of "
        "the outer cone distance)"
        for g in "ab"
    ]
    fine = text.replace("number_of_teeth: 20, mate_teeth: 40", "number_of_teeth: 30, mate_teeth: 60")
    fine = fine.replace("number_of_teeth: 40, mate_teeth: 20", "number_of_teeth: 60, mate_teeth: 30")
    fine = fine.replace("face_width: 20 mm", "face_width: 30.5 mm")
    assert "limit 30 mm, ten outer modules" in odd_shapes(loads_model(fine))[0]


def test_gears_of_one_body_and_gears_without_a_body():
    one = (
        bevel_file()
        .replace("bevel_gears: {b: 0.0}", "bevel_gears: {}")
        .replace("{a: 0.0}", "{a: 0.0, b: 0.0}")
    )
    assert "connects two gears of the body first" in told(one)
    none = bevel_file().replace("bevel_gears: {b: 0.0}, ", "").replace("motion: torsion", "motion: fixed")
    assert "no body carries it" in told(none)
    as_cylindrical = bevel_file().replace("bevel_gears: {b: 0.0}", "gears: {b: 0.0}")
    assert "names the gear 'b', which does not exist" in told(as_cylindrical)


def test_carriers_are_refused():
    text = bevel_file(rest="joints:\n  j: {type: revolute, bodies: [first, second], axes: {z: [1, 0, 0]}}\n")
    text = text.replace("axes: {z: [1.0, 0.0, 6.123233995736766e-17], x: [0, 1, 0]}, motion: torsion, ", "")
    message = told(
        text.replace("inertia: 3e-2 kg m^2}", "inertia: 3e-2 kg m^2, axes: {z: [1, 0, 0], x: [0, 1, 0]}}")
    )
    assert "have different parent bodies" in message


def test_teeth_that_stand_in_each_other_are_told():
    text = bevel_file().replace("opens: +z}", "opens: +z, initial_angle: 0 deg}", 1)
    first = loads_model(text).bevel_angles["b"]
    whole = text.replace("opens: +z}", f"opens: +z, initial_angle: {first + 0.01}}}", 1)
    message = told(whole)
    assert "overlap by" in message and "off the middle of the gap" in message


FAULT = "opens: +z, faults: {x: {type: broken_tooth, tooth: 0}}"


def test_faults_need_a_law_of_single_teeth_and_gears_on_one_base():
    text = bevel_file().replace("opens: +z", FAULT, 1)
    message = told(text)
    assert "bevel_gears.a.faults.x (line 3): has no effect in the mesh m, whose law constant" in message
    assert "use din3990 there" in message
    sound = loads_model(text.replace("{law: constant, value: 3e8}", "{law: din3990}"))
    assert sound.bevel_gears["a"].faults["x"].severity == 1.0
    healthy = sound.replace("bevel_gears.a.faults.x.severity", 0.0)
    assert loads_model(dump_model(healthy)) == healthy
    example = Path(__file__).parents[3] / "examples" / "bevel-drive" / "differential.yaml"
    rides = example.read_text(encoding="utf-8").replace("opens: -z", FAULT.replace("+z", "-z"), 1)
    refused = told(rides.replace("{law: constant, value: 2e8}", "{law: din3990}"))
    assert "bevel_gears.left.faults have tooth faults, which are not supported" in refused


def test_names_of_meshes_are_their_own():
    text = bevel_file(rest="meshes:\n  m: {gears: [c, d]}\ngears:\n")
    for name in "cd":
        text += f"  {name}: {{number_of_teeth: 20, normal_module: 3 mm, face_width: 9 mm}}\n"
    assert "has the name of a mesh" in told(text)


def test_scenarios_may_name_bevel_meshes():
    rest = (
        "scenarios:\n  r: {quasi_static: {mesh: m}}\n  s: {sweep: {body: second, mesh: m, speed: [1, 2]}}\n"
    )
    model = loads_model(bevel_file(rest=rest))
    assert model.sweep_mesh("s") == "m"
    assert "names the mesh 'x'" in told(bevel_file(rest=rest.replace("mesh: m", "mesh: x", 1)))


def test_the_schema_knows_the_section():
    found = json_schema()
    assert "bevel_meshes" in found["properties"]
