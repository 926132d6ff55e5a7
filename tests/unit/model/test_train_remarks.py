# SPDX-License-Identifier: Apache-2.0
"""Contradictory ratios in a loop, and shafts that nothing connects: where, value, limit, remedy."""

from __future__ import annotations

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.remarks.collect import remarks_of_file
from pitchpoint.model.remarks.trains import contradictory_loops, unconnected_shafts
from tests.unit.model.test_torque_balance import GRC, PATHS, RAVIGNEAUX

GEAR = "normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0"
LOOP = f"""
gears:
  a: {{number_of_teeth: 20, {GEAR}}}
  b: {{number_of_teeth: 40, {GEAR}}}
  c: {{number_of_teeth: 25, {GEAR}}}
  d: {{number_of_teeth: 35, {GEAR}}}
bodies:
  one: {{gears: {{a: 0 mm, c: 40 mm}}, position: [0, 0, 0]}}
  two: {{gears: {{b: 0 mm, d: 40 mm}}}}
meshes:
  ab: {{gears: [a, b]}}
  cd: {{gears: [c, d]}}
loads: {{motor: {{body: one, torque: 10 N m}}, out: {{body: two, torque: balance}}}}
"""
RUN = "scenarios: {run: {speed: {one: 1000 rpm}, duration: 1 s}}\n"


def test_a_loop_with_two_ratios_cannot_be_given_a_speed() -> None:
    with pytest.raises(ModelError) as found:
        loads_model(LOOP + RUN)
    text = str(found.value)
    for words in ("scenarios.run.speed.one", "meshes.cd", "two/one = -0.7142857", "-0.5 through meshes.ab"):
        assert words in text
    assert "correct a number of teeth" in text


def test_at_rest_it_is_a_remark() -> None:
    (found,) = contradictory_loops(loads_model(LOOP))
    assert "meshes.cd" in str(found)
    assert "two/one = -0.7142857, but -0.5 through meshes.ab" in str(found)


def test_ratios_that_contradict_a_planetary_set() -> None:
    """Sun, carrier and ring have one relation of their own; one more ratio is fine, two lock them."""
    text = GRC.replace("ring: {gears: [ring], motion: fixed}", "ring: {gears: [ring]}").partition(
        "scenarios:"
    )[0]
    first, second = "first: {terms: {carrier: 1, ring: -2}}", "second: {terms: {carrier: 1, low: -3}}"
    assert not list(contradictory_loops(loads_model(f"{text}ratios: {{{first}}}\n")))
    (found,) = contradictory_loops(loads_model(f"{text}ratios: {{{first}, {second}}}\n"))
    # with ring = carrier/2: sun = (120 - 99/2)/21 carrier
    assert "low/carrier = 0.3333333, but 3.357143 through" in str(found)


@pytest.mark.parametrize("text", [GRC, PATHS, RAVIGNEAUX], ids=["planetary", "split", "ravigneaux"])
def test_sound_trains_have_no_remark(text: str) -> None:
    model = loads_model(text)
    assert not list(contradictory_loops(model)) and not list(unconnected_shafts(model))


def test_a_shaft_without_mesh_and_load_is_named() -> None:
    text = (LOOP + RUN).replace("  cd: {gears: [c, d]}\n", "")
    text = text.replace("bodies:\n", "bodies:\n  three: {gears: [e], position: [0, 0.3, 0]}\n")
    text = text.replace("gears:\n", f"gears:\n  e: {{number_of_teeth: 30, {GEAR}}}\n", 1)
    found = [each for each in remarks_of_file(loads_model(text)) if "not connected" in str(each)]
    assert [(each.where, each.line) for each in found] == [("bodies.three", 9)]
    loaded = text.replace("loads: {", "loads: {brake: {body: three, torque: 0 N m}, ")
    assert not list(unconnected_shafts(loads_model(loaded)))
