# SPDX-License-Identifier: Apache-2.0
"""Planet sets whose places are left open: what is placed where nobody wants it is told."""

from __future__ import annotations

import re

import pytest

from pitchpoint.core.errors import ModelError, ValidityWarning
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.remarks.collect import warn_of_remarks
from pitchpoint.model.remarks.places import places_left_open

GEAR = "normal_module: 4 mm, face_width: 40 mm, profile_shift_coefficient: 0"
SET = f"""
gears:
  sun: {{number_of_teeth: 21, {GEAR}}}
  ring: {{number_of_teeth: 99, {GEAR}, type: internal}}
  p0: {{number_of_teeth: 39, {GEAR}}}
  p1: {{number_of_teeth: 39, {GEAR}}}
bodies:
  sun: {{gears: [sun], position: [0, 0, 0]}}
  ring: {{gears: [ring], motion: fixed, position: [0, 0, 0]}}
  b0: {{gears: [p0], position: [120 mm, 0, 0]}}
  b1: {{gears: [p1], position: [-120 mm, 0, 0]}}
  carrier: {{inertia: 0.5 kg m^2, mass: 10 kg, position: [0, 0, 0]}}
joints:
  pin0: {{type: revolute, bodies: [carrier, b0]}}
  pin1: {{type: revolute, bodies: [carrier, b1]}}
meshes:
  s0: {{gears: [sun, p0]}}
  r0: {{gears: [p0, ring]}}
  s1: {{gears: [sun, p1]}}
  r1: {{gears: [p1, ring]}}
"""


def told(text: str) -> tuple[str, ...]:
    return places_left_open(loads_model(text))


def test_nothing_is_said_where_places_are_given() -> None:
    assert told(SET) == ()


def test_a_carrier_without_a_place_would_turn_about_a_pin() -> None:
    text = SET.replace("mass: 10 kg, position: [0, 0, 0]", "mass: 10 kg").partition("meshes:")[0]
    (sentence,) = told(text)
    assert sentence == (
        "bodies.carrier: has no position and takes that of joints.pin0, [120 mm, 0 mm, 0 mm], so that it "
        "rotates about an axis there; for another axis, give position: [x, y, z]"
    )
    with pytest.warns(ValidityWarning, match="takes that of joints.pin0"):
        warn_of_remarks(loads_model(text))


def test_a_carrier_beside_the_axis_of_the_sun() -> None:
    """The pins would go round another axis than that of sun and ring: an error, or as small as 20 µm said."""
    with pytest.raises(ModelError) as caught:
        loads_model(SET.replace("mass: 10 kg, position: [0, 0, 0]", "mass: 10 kg, position: [5 mm, 0, 0]"))
    assert str(caught.value).splitlines()[1].strip() == (
        "bodies.carrier.position (line 12): has its axis 5 mm off that of sun, so that the centre "
        "distance of s0 varies by 10 mm in a revolution of the carrier (limit 0.4 mm, a tenth of a module); "
        "give carrier the position of sun"
    )
    near = SET.replace("mass: 10 kg, position: [0, 0, 0]", "mass: 10 kg, position: [0, 20 um, 0]")
    assert told(near)[0].startswith("bodies.carrier.position: has its axis 20 µm off that of sun")
    assert told(SET.replace("mass: 10 kg, position: [0, 0, 0]", "mass: 10 kg, position: [0, 1 um, 0]")) == ()


def test_planets_without_directions_stand_in_each_other() -> None:
    bare = re.sub(r"(b\d: .*), position: \[[^]]*\]", r"\1", SET)
    (sentence,) = told(bare)
    assert sentence.startswith("bodies.b1: p1 overlaps with p0 of b0, on the same axis")
    turned = bare.replace("s1: {gears: [sun, p1]}", "s1: {gears: [sun, p1], direction: 180 deg}")
    assert told(turned) == ()


@pytest.mark.parametrize(("offset", "heard"), [("39.9 mm", 1), ("40.1 mm", 0)])
def test_gears_side_by_side_on_one_axis_are_none_in_each_other(offset: str, heard: int) -> None:
    """Face widths of 40 mm; the second sun's planet lies on the axis of the first, further along."""
    text = f"""
gears:
  a: {{number_of_teeth: 20, {GEAR}}}
  b: {{number_of_teeth: 30, {GEAR}}}
bodies:
  one: {{gears: [a], position: [0, 0, 0]}}
  two: {{gears: [b], position: [0, 0, {offset}]}}
couplings:
  joint: {{bodies: [one, two], stiffness: {{torsion: 1e5}}}}
"""
    assert len(told(text)) == heard


@pytest.mark.parametrize(("at", "seen"), [("-60 mm", False), ("140 mm", True), ("260 mm", True)])
def test_torques_at_the_start_of_a_shaft_from_a_body_at_its_end(at: str, seen: bool) -> None:
    text = f"""
shafts:
  out: {{sections: [{{length: 200 mm, diameter: 50 mm}}], position: [0, 0, 0]}}
bodies:
  load: {{position: [0, 0, {at}], inertia: 0.5 kg m^2, mass: 20 kg}}
torsion_springs:
  coupling: {{bodies: [out, load], stiffness: 50000 N m/rad}}
  brake: {{bodies: [load], stiffness: 1 N m/rad}}
"""
    found = [str(sentence) for sentence in told(text)]
    assert len(found) == seen
    if seen:
        assert found[0].startswith(
            "torsion_springs.coupling: acts at the start of the shaft out, but load is nearer to its end"
        )


SHAFTS = """
bodies:
  motor: {inertia: 0.1 kg m^2, motion: torsion, position: [0, 0, 0], axes: {z: [0.6, 0, 0.8]}}
  pump: {inertia: 0.1 kg m^2, motion: torsion, position: [PLACE], axes: {z: [0.6, 0, 0.8]}}
SECTION
"""
TURNING = {
    "couplings": "{bodies: [motor, pump], stiffness: {torsion: 1e4 N m/rad}}",
    "torsion_springs": "{bodies: [motor, pump], stiffness: 1e4 N m/rad}",
    "clutches": "{bodies: [motor, pump], capacity: 100 N m}",
}


@pytest.mark.parametrize("group", TURNING)
def test_a_torsional_connection_of_distant_axes_is_told_with_the_distance(group: str) -> None:
    text = SHAFTS.replace("SECTION", f"{group}:\n  joint: {TURNING[group]}")
    (sentence,) = told(text.replace("PLACE", "600 mm, 120 mm, 800 mm"))
    assert sentence == (
        f"{group}.joint.bodies: motor and pump have parallel axes 120 mm apart, and the torque between them "
        "acts without a force; correct the positions, or connect them by a mesh or a ratio"
    )
    assert told(text.replace("PLACE", "600 mm, 5 mm, 800 mm")) == ()  # a misalignment
