# SPDX-License-Identifier: Apache-2.0
"""Forces of bearings have axes that do not spin with the outer ring, against statics.

A steady load is at rest in ground, or in the carrier that moves the bearing in a circle, whichever ring
turns.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.elements import rolling_bearing
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.joints import FIXED, FLOATING, FREE, TORSION
from pitchpoint.report.scene.build import scene_of
from pitchpoint.solvers.quasistatic.roll import solve_quasistatic
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from pitchpoint.system.rules.rings import put_rest
from pitchpoint.viz.scene.file import scene_texts
from tests.support.planet_stages import stage_file
from tests.support.scene_reader import Seen

ROLLING = "designation: NU206, clearance: 0, stiffness: 1e9"
PLAIN = "clearance: 20 um, stiffness: 1e9, exponent: 1.5, damping: 5"
WHEEL = """\
gravity: [0, -9.81, 0]
bodies:
  rotor: {motion: free, mass: 10 kg, inertia: 0.05, transverse_inertia: 0.05, position: [0, 0, 0]}
bearings:
  hold: {body: rotor, stiffness: {axial: 1e6, tilt: 1e5}, damping: {radial: 2000, axial: 500, tilt: 20}}
SECTION:
  b: {ends: [ENDS], OWN}
scenarios:
  s: {speed: {rotor: 600 rpm}, duration: 0.25 s, step: 0.5 ms}
"""


def directions(run, name):
    """Direction of the radial force on the inner ring over the second half of a run [deg]."""
    angle = run[f"bearing_force[{name}.direction]"].values
    return np.degrees(np.unwrap(angle))[angle.size // 2 :]


@pytest.mark.parametrize(
    ("section", "own"), [("rolling_bearings", ROLLING), ("plain_bearings", PLAIN)], ids=["rolling", "plain"]
)
@pytest.mark.parametrize(("ends", "down"), [("rotor, ground", 90.0), ("ground, rotor", -90.0)])
def test_weight_of_a_rotor_and_of_a_wheel_on_its_hub(section, own, ends, down):
    """The outer ring of a wheel turns; its weight presses on the inner ring downwards all the time."""
    text = WHEEL.replace("SECTION", section).replace("ENDS", ends).replace("OWN", own)
    model = loads_model(text)
    run = solve_time(compile_model(model, "s"))
    found = directions(run, "b")
    assert found == pytest.approx(down, abs=3.0)
    assert run["bearing_force[b.radial]"].values[-50:].mean() == pytest.approx(98.1, rel=0.02)
    scene = Seen(*scene_texts(scene_of(model, run)))
    for frame in range(len(scene.times) // 2, len(scene.times)):
        x, y, _ = scene.force("b", frame)
        assert math.degrees(math.atan2(y, x)) == pytest.approx(down, abs=3.0)


@pytest.mark.parametrize("exchanged", [False, True], ids=["pin", "shaft"])
def test_tangential_forces_of_planets(exchanged):
    """The planets push the carrier, which the sun drives forwards, along the circle of their pins.

    Over a cycle of the mesh a planet turns by 9.2 degrees relative to the carrier.
    """
    pins = "\nrolling_bearings:\n"
    for k in (1, 2, 3):
        ends = [f"planet_{k}", "carrier"] if exchanged else ["carrier", f"planet_{k}"]
        pins += (
            f"  pin_{k}: {{ends: [{', '.join(ends)}], designation: NU206, clearance: 0, stiffness: 1e9}}\n"
        )
    text = stage_file("planets: 3\nmotion: planar") + pins
    found = solve_quasistatic(compile_model(loads_model(text), "slow"))
    for k in (1, 2, 3):
        seen = np.degrees(found[f"bearing_force[pin_{k}.direction]"].values)
        wanted = 120.0 * (k - 1) + (-90.0 if exchanged else 90.0)
        assert (seen - wanted + 180.0) % 360.0 - 180.0 == pytest.approx(0.0, abs=1.0)


def rest_of(tree, j, point):
    """Body and axes of the results of a bearing whose outer ring is on body j, at a point of it."""
    row = np.zeros(1, rolling_bearing.RECORD)[0]
    row["j"], row["p_j"], row["A_j"] = j, point, np.eye(3)
    put_rest(tree, row)
    return int(row["rest"]), row["A_rest"]


CARRIER = Body(motion=TORSION)
PLANET = Body(motion=FREE, parent=1, position=(0.1, 0.0, 0.0))


@pytest.mark.parametrize(
    ("tree", "point", "rest"),
    [
        ([CARRIER, PLANET], (0.0, 0.0, 0.02), 2),  # in a planet: the carrier takes it along
        ([CARRIER, PLANET], (0.03, 0.0, 0.0), 0),  # beside the axis of the planet: goes round with it
        ([CARRIER, Body(motion=FREE, parent=1)], (0.0, 0.0, 0.1), 1),  # on the axis of both
        ([CARRIER, Body(motion=FIXED, parent=1, position=(0.1, 0.0, 0.0))], (-0.1, 0.0, 0.0), 1),  # welded
        ([CARRIER, Body(motion=FIXED, parent=1, position=(0.1, 0.0, 0.0))], (0.0, 0.0, 0.0), 0),
        ([Body(motion=FIXED)], (0.0, 0.0, 0.0), 0),
        ([Body(motion=FLOATING)], (0.0, 0.0, 0.0), 0),  # a housing has no axis
    ],
)
def test_where_the_axes_of_the_results_are_at_rest(tree, point, rest):
    assert rest_of(tree, len(tree), point)[0] == rest


def test_axes_of_a_turned_ring_are_those_as_assembled():
    """The planet is mounted at 30 degrees: the axes of its ring are not those of its frame."""
    c, s = math.cos(math.pi / 6), math.sin(math.pi / 6)
    turned = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    row = np.zeros(1, rolling_bearing.RECORD)[0]
    row["j"], row["A_j"] = 1, turned
    put_rest([Body(motion=FREE)], row)
    assert row["rest"] == 1
    assert row["A_rest"] == pytest.approx(turned)


def test_a_bearing_across_the_axis_of_its_body_goes_round_with_it():
    row = np.zeros(1, rolling_bearing.RECORD)[0]
    row["j"], row["A_j"] = 1, [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
    put_rest([Body(motion=TORSION)], row)
    assert row["rest"] == 0
