# SPDX-License-Identifier: Apache-2.0
"""Bevel gears in model files: what the keys mean, writing and reading back, inertia, what is refused."""

from __future__ import annotations

import math

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.geometry.bevel.blank import bevel_mass
from pitchpoint.io.yaml_model import dump_model, loads_model
from tests.support.bevel_teeth import PAIR
from tests.support.model_files import gear as cylindrical

ALONE = """\
bevel_gears:
  a: {number_of_teeth: 20, mean_normal_module: 2.5 mm, pitch_cone_angle: 30 deg, face_width: 12 mm,
    opens: %s%s}
bodies:
  one: {bevel_gears: {a: 50 mm}, motion: free}
"""


def test_the_file_means_what_it_says():
    model = loads_model(PAIR)
    pinion, wheel = (model.bevel_gears[n].geometry for n in ("pinion", "wheel"))
    assert (pinion.z, pinion.beta_m, wheel.beta_m) == (17, -math.radians(30.0), math.radians(30.0))
    assert pinion.delta + wheel.delta == pytest.approx(math.radians(75.0), abs=1e-15)
    assert pinion.m_et == pytest.approx(3e-3)
    assert [model.bevel_gears[n].direction for n in ("pinion", "wheel")] == [1.0, -1.0]
    assert model.body_of("wheel") == "two"
    shifted = model.replace("bevel_gears.pinion.profile_shift_coefficient", 0.0)
    assert shifted.bevel_gears["pinion"] == model.bevel_gears["pinion"]


def test_writing_and_reading_back_changes_nothing():
    model = loads_model(PAIR)
    assert loads_model(dump_model(model)) == model


@pytest.mark.parametrize(("opens", "way"), [("+z", 1.0), ("-z", -1.0)])
def test_inertia_is_that_of_the_geometry_at_its_place(opens, way):
    """The apex lies 50 mm from the origin, the centre of mass from there in the direction of the cone."""
    model = loads_model(ALONE % (opens, ""))
    found = model.body_inertia("one")
    gear = model.bevel_gears["a"]
    exact = bevel_mass(gear.geometry, gear.material_data.density)
    assert found.mass == pytest.approx(exact.mass)
    assert found.polar == pytest.approx(exact.polar_inertia)
    assert found.central == pytest.approx(exact.transverse_inertia)
    assert found.center == pytest.approx(0.05 + way * exact.center)


def test_given_mass_takes_the_place_of_that_of_the_geometry():
    model = loads_model(ALONE % ("+z", ", mass: 2 kg, polar_inertia: 3e-4, transverse_inertia: 4e-4"))
    found = model.body_inertia("one")
    assert (found.mass, found.polar) == (2.0, 3e-4)
    assert found.central == pytest.approx(4e-4)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (
            "pitch_cone_angle: 30 deg, ",
            "",
            "bevel_gears.a (line 2): gives none of pitch_cone_angle, mate_teeth; give",
        ),
        ("pitch_cone_angle", "mate_teeth: 20, pitch_cone_angle", "pitch_cone_angle and mate_teeth together"),
        ("mean_normal_module: 2.5 mm, ", "", "gives none of mean_normal_module, outer_transverse_module"),
        ("face_width", "spiral_angle: 30 deg, face_width", "a spiral bevel gear is left or right handed"),
        ("face_width", "shaft_angle: 80 deg, face_width", "shaft_angle (line 2): requires mate_teeth"),
        ("face_width: 12 mm", "face_width: 120 mm", "face_width"),
        (
            "face_width",
            "bore_diameter: 60 mm, face_width",
            "bore_diameter (line 2): 60 mm does not fit",
        ),
        ("face_width", "profile_shift_coefficient: 1.3, face_width", "leaves no dedendum"),
        ("{a: 50 mm}", "{b: 50 mm}", "names the bevel gear 'b', which does not exist"),
        ("bevel_gears: {a: 50 mm}", "gears: [a]", "names the gear 'a', which does not exist"),
        ("opens: +z", "opens: up", "opens"),
        ("opens", "helix_angle: 3 deg, opens", "helix_angle"),
        ("opens", "faults: {x: {type: broken_tooth, tooth: 20}}, opens", "(line 3): 20 is not a tooth"),
        ("opens", "faults: {x: {type: broken_tooth, tooth: 0, width: 13 mm}}, opens", "limit 12 mm"),
        ("opens", "faults: {x: {type: broken_tooth, tooth: 0, height: 1 mm}}, opens", "height"),
        ("opens", "faults: {x: {type: pitch_error, tooth: 0, amount: 5}}, opens", "limit 2.5 mm"),
        ("opens", "faults: {x: {type: root_crack, tooth: 0}}, opens", "broken_tooth, pitch_error"),
    ],
)
def test_what_is_wrong_is_told_at_its_key(old, new, words):
    with pytest.raises(ModelError) as caught:
        loads_model((ALONE % ("+z", "")).replace(old, new))
    assert len(caught.value.problems) == 1
    assert words in str(caught.value)


def test_a_gear_sits_on_one_body_and_has_a_name_of_its_own():
    with pytest.raises(ModelError, match="carries a, which is already on one"):
        loads_model(ALONE % ("+z", "") + "  two: {bevel_gears: [a]}\n")
    with pytest.raises(ModelError, match="has the name of a gear"):
        loads_model("gears:\n" + cylindrical("a") + ALONE % ("+z", ""))
