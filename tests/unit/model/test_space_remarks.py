# SPDX-License-Identifier: Apache-2.0
"""Gears and bearings of one shaft in the same place, and values far from usual ones."""

from __future__ import annotations

from typing import Any

import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.remarks.collect import remarks_of_file
from pitchpoint.report.bearing_loads import loads_above_ratings

TEXT = """
gears:
  a: {number_of_teeth: 40, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}
  b: {number_of_teeth: 60, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  ring: {type: internal, number_of_teeth: 90, normal_module: 3 mm, face_width: 20 mm,
    profile_shift_coefficient: 0}
  c: {number_of_teeth: 20, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}
shafts:
  s:
    sections: [{length: 200 mm, diameter: 40 mm}]
    gears: {a: 60 mm, b: 100 mm}
    position: [0, 0, 0]
bodies:
  two: {gears: [c], motion: torsion}
rolling_bearings:
  left:
    {body: s, position: [0, 0, 20 mm], designation: 30208, axial_force_absorption: negative, preload: 500 N}
  right:
    {body: s, position: [0, 0, 180 mm], designation: 30208, axial_force_absorption: positive, preload: 500 N}
meshes:
  m: {gears: [a, c], damper: {ratio: 0.05}}
"""
WORDS = ("overlaps", "critical damping", "C0")


def told(changes: dict[str, Any], text: str = TEXT) -> list[str]:
    """Remarks of this file, of the kinds tested here."""
    found = remarks_of_file(loads_model(text, changes=changes))
    return [str(each) for each in found if any(word in each for word in WORDS)]


@pytest.mark.parametrize(
    ("path", "value", "said"),
    [
        ("shafts.s.gears.b", "80 mm", "overlaps a by 5 mm: b extends from 70 to 90 mm, a from 45 to 75 mm"),
        (
            "rolling_bearings.left.position",
            ["0", "0", "45 mm"],
            "overlaps the gear a on s by 9.875 mm: the bearing extends from 35.125 to 54.875 mm, the gear",
        ),
        ("rolling_bearings.left.preload", "400 kN", "400 kN exceeds the static load rating C0 = "),
        ("meshes.m.damper.ratio", 5, "5 is 500 % of the critical damping"),
        ("meshes.m.damping", {"ratio": 1.5}, "1.5 is 150 % of the critical damping"),
    ],
)
def test_what_cannot_be_meant_is_told(path: str, value: Any, said: str) -> None:
    assert told({}) == []
    [message] = told({path: value})
    assert message.startswith(path) and said in message


@pytest.mark.parametrize(
    "changes",
    [
        {"shafts.s.gears.b": "85 mm"},  # halves of a divided gear touch
        {"shafts.s.gears": {"a": "60 mm", "ring": "60 mm"}},  # teeth outside and inside a rim
        {"shafts.s.gears.b": "60 mm", "gears.b.bore_diameter": "130 mm"},  # around the other
        {"gears.a.rim_thickness": "8 mm", "rolling_bearings.left.position": ["0", "0", "45 mm"]},  # D = 80 mm
        {"rolling_bearings.left.preload": "0 N"},
        {"meshes.m.damper.ratio": 0.3},
    ],
)
def test_what_can_be_meant_is_not(changes: dict[str, Any]) -> None:
    assert told(changes) == []


def test_gears_without_positions_and_idlers_on_bearings_are_not_told() -> None:
    """Bodies of models of torsion have all gears at their origin; an idler turns on its bearing."""
    more = "  d: {number_of_teeth: 20, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}"
    text = TEXT.replace("gears: [c]", "gears: [c, d]").replace("shafts:", f"{more}\nshafts:")
    assert told({}, text) == []
    [message] = told({}, text.replace("gears: [c, d]", "gears: {c: 0, d: 5 mm}"))
    assert message.startswith("bodies.two.gears.d") and "overlaps c by 25 mm" in message
    idler = "  idler: {ends: [s.pin, two], designation: NA4908}\nmeshes:"
    pin = "gears: {b: 100 mm}\n    markers: {pin: {position: [0, 0, 60 mm]}}"
    text = TEXT.replace("meshes:", idler).replace("gears: {a: 60 mm, b: 100 mm}", pin)
    text = text.replace("gears: [c], motion: torsion", "gears: [a, c], motion: free, position: [0, 0, 60 mm]")
    assert told({}, text.partition("meshes:")[0]) == []


def test_a_force_above_the_rating_is_noted() -> None:
    model = loads_model(TEXT)
    rating = model.rolling_bearings["left"].geometry.static
    assert rating is not None
    channels = {f"bearing_force[{name}.radial]": {"min": 0.0, "max": 1.2 * rating} for name in ("left",)}
    [message] = loads_above_ratings(model, channels)
    assert message.where == "rolling_bearings.left" and "exceeds the static load rating" in message
    assert loads_above_ratings(model, {name: {"min": 0.0, "max": rating} for name in channels}) == ()
