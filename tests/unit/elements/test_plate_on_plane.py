# SPDX-License-Identifier: Apache-2.0
"""Contact of a rectangular plate with a plane: the rigid footing on an elastic foundation (Winkler).

S. Timoshenko, Strength of Materials, Part II: eccentric load on a rectangular section that cannot carry
tension. Inside the core (e < a/6) the penetration is F/K (1 + 12 e x/a^2); outside it the contact is 3 (a/2 -
e) long, and the penetration at the loaded edge 2 F a/(3 K (a/2 - e)).
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.report.scene.rest import rest_scene
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.system.compile import compile_model
from pitchpoint.system.evaluate import observe, residual

pytestmark = pytest.mark.nojit
SIDE, OTHER, STIFF, LOAD = 0.08, 0.04, 1e8, 5e3


def block(eccentricity=0.0, *, ends=("block.foot", "floor"), surfaces=None):
    """A block on the floor, pressed at a distance from its middle."""
    first, second = surfaces or (f"{{shape: plane, size: [{SIDE}, {OTHER}]}}", "{shape: plane}")
    return f"""\
bodies:
  floor: {{motion: fixed, mass: 1 kg, markers: {{wall: {{position: [100 mm, 0, 10 mm]}}}}}}
  block:
    mass: 1 kg
    inertia_tensor: [1e-3, 1e-3, 1e-3, 0, 0, 0]
    position: [0, 0, 10 mm]
    markers:
      foot: {{position: [0, 0, -10 mm], axes: {{z: [0, 0, -1], x: [1, 0, 0]}}}}
      pressed: {{position: [{eccentricity}, 0, -10 mm]}}
joints:
  flat: {{type: planar, bodies: [ground, block], axes: {{z: [0, 1, 0], x: [0, 0, 1]}}}}
springs:
  stop: {{ends: [block, floor.wall], stiffness: 1 N/m}}
surface_contacts:
  patch:
    ends: [{", ".join(ends)}]
    first: {first}
    second: {second}
    law: {{force: {STIFF * 1e-3} N, depth: 1 mm, exponent: 1}}
loads:
  press: {{body: block, marker: pressed, force: [0, 0, {-LOAD} N]}}
"""


def at_rest(text):
    """Heights of both edges of the foot in equilibrium [m], and the channels there."""
    system = compile_model(loads_model(text))
    state = find_equilibrium(system).state
    row = observe(system, state)
    return system, row, state


def edges(text):
    system, _, state = at_rest(text)
    names = system.layout.coordinates
    height, tilt = (float(state.q[names.index(f"block.{c}")]) for c in ("x", "spin"))
    height += 0.01 * (1.0 - math.cos(tilt))  # of the foot under the centre of the block
    return np.array([height + s * 0.5 * SIDE * math.sin(tilt) for s in (-1.0, 1.0)])


def test_a_load_inside_the_core_tilts_the_plate_as_a_beam_section():
    e = SIDE / 10
    found = edges(block(e))
    expected = [LOAD / STIFF * (1.0 + s * 6.0 * e / SIDE) for s in (-1.0, 1.0)]
    assert np.sort(-found) == pytest.approx(np.sort(expected), rel=1e-6)


@pytest.mark.parametrize("share", [0.2, 0.3, 0.4])
def test_a_load_outside_the_core_lifts_the_far_edge(share):
    e = share * SIDE
    found = edges(block(e))
    deepest = 2.0 * LOAD * SIDE / (3.0 * STIFF * (0.5 * SIDE - e))
    assert np.max(-found) == pytest.approx(deepest, rel=1e-2)  # 16 points along the side
    assert np.max(found) > 0.0


def test_the_order_of_the_surfaces_does_not_matter():
    one = at_rest(block(0.3 * SIDE))[1]
    plate = f"{{shape: plane, size: [{SIDE}, {OTHER}]}}"
    turned = block(0.3 * SIDE, ends=("floor", "block.foot"), surfaces=("{shape: plane}", plate))
    other = at_rest(turned)[1]
    assert one == pytest.approx(other, rel=1e-9, abs=1e-12)


def test_a_turning_plate_rubs_with_the_mean_radius_of_a_square():
    # mean distance of the points of a square of side a from its middle: a (sqrt 2 + ln(1 + sqrt 2))/6
    text = f"""\
bodies:
  block: {{mass: 1 kg, inertia_tensor: [1e-3, 1e-3, 1e-3, 0, 0, 0], position: [0, 0, 0],
          markers: {{foot: {{axes: {{z: [0, 0, -1], x: [1, 0, 0]}}}}}}}}
joints:
  on: {{type: cylindrical, bodies: [ground, block], axes: {{z: [0, 0, 1]}}, speed: {{spin: 1 rad/s}},
        start: {{z: -50 um}}}}
surface_contacts:
  patch:
    ends: [block.foot, ground]
    first: {{shape: plane, size: [{SIDE}, {SIDE}]}}
    second: {{shape: plane}}
    law: {{force: 1 kN, depth: 10 um, exponent: 1}}
    friction: {{static: 0.2, dynamic: 0.2, static_speed: 1e-7 m/s, slip_speed: 2e-7 m/s}}
"""
    system = compile_model(loads_model(text))
    state = system.initial_state()
    torque = abs(residual(system, state)[system.layout.coordinates.index("block.spin")])
    mean = SIDE * (math.sqrt(2.0) + math.log(1.0 + math.sqrt(2.0))) / 6.0
    assert torque == pytest.approx(0.2 * 5e3 * mean, rel=1e-3)


def test_the_scene_has_the_plate_at_its_size():
    scene = rest_scene(loads_model(block()))
    spans = [np.sort(np.ptp(solid.points, axis=0))[1:] for solid in scene.solids if "patch" in solid.name]
    assert any(span == pytest.approx([OTHER, SIDE]) for span in spans)


def test_a_plate_is_written_as_it_was_read():
    model = loads_model(block())
    assert loads_model(dump_model(model)) == model


@pytest.mark.parametrize(
    ("first", "second", "foot", "where", "words"),
    [
        ("{shape: plane}", "{shape: plane}", "[0, 0, -1]", "patch", "without limits; give the plate"),
        (
            "{shape: plane, size: [1, 1]}",
            "{shape: plane, size: [2, 2]}",
            "[0, 0, -1]",
            "patch",
            "two planes of limited size; give the size of the smaller one only",
        ),
        (
            "{shape: plane, size: [1, 1]}",
            "{shape: plane}",
            "[0, 0, 1]",
            "patch.ends",
            "have planes that face the same way, with 0 deg between their z axes (limit > 90 deg)",
        ),
        (
            "{shape: sphere, radius: 5 mm}",
            "{shape: plane, size: [1, 1]}",
            "[0, 0, -1]",
            "patch.second.size",
            "has no effect: it is for two planes",
        ),
        ("{shape: plane, size: [1, 0]}", "{shape: plane}", "[0, 0, -1]", "patch.first.size", "> 0"),
    ],
)
def test_planes_that_cannot_touch_are_refused_with_a_remedy(first, second, foot, where, words):
    text = block(surfaces=(first, second)).replace("z: [0, 0, -1]", f"z: {foot}")
    with pytest.raises(ModelError) as error:
        loads_model(text)
    assert f"surface_contacts.{where}" in str(error.value)
    assert words in str(error.value)
