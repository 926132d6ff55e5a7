# SPDX-License-Identifier: Apache-2.0
"""One broken gear is one problem: nothing that merely follows from it is reported."""

from __future__ import annotations

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from tests.support.model_files import gear

REST = """\
meshes:
  first: {gears: [a, b]}
  second: {gears: [b, c]}
bodies:
  driver: {gears: [a], motion: torsion}
  middle: {gears: [b], motion: torsion}
  end: {gears: [c], motion: torsion}
loads: {input: {body: driver, torque: 10 N m}, output: {body: end, torque: balance}}
scenarios:
  sweep: {sweep: {body: driver, mesh_frequency: [10 Hz, 100 Hz], points: 5}}
  roll: {quasi_static: {mesh: first}}
"""


@pytest.mark.parametrize(
    ("line", "place"),
    [
        (gear("a").replace("30", "abc"), "gears.a.number_of_teeth"),
        (gear("a", -3), "gears.a.number_of_teeth"),
        ("  a: 3\n", "gears.a"),
        (gear("a", more="tip_diameter: 20 mm"), "gears.a.tip_diameter"),
        (gear("a", more="helix_angle: 200 deg"), "gears.a.helix_angle"),
        (gear("a", more="rack: 3"), "gears.a.rack"),
    ],
)
def test_one_broken_gear_is_one_problem(line: str, place: str) -> None:
    with pytest.raises(ModelError) as caught:
        loads_model("gears:\n" + line + gear("b") + gear("c") + REST)
    assert [p.where for p in caught.value.problems] == [place]


def test_the_rest_is_still_checked() -> None:
    own = "  idle: {motion: torsion, inertia: 1 kg m^2}\nloads:"
    text = REST.replace("loads:", own).replace("sweep: {body: driver", "sweep: {body: idle")
    with pytest.raises(ModelError) as caught:
        loads_model("gears:\n" + gear("a", -3) + gear("b") + gear("c") + text)
    places = [p.where for p in caught.value.problems]
    assert places == ["gears.a.number_of_teeth", "scenarios.sweep.sweep.body"]
