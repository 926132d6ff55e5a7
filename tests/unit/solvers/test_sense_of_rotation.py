# SPDX-License-Identifier: Apache-2.0
"""Linear analyses of shafts that rotate in the negative direction: closed form, and one machine."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.multibody.bodies import FREE, Body
from pitchpoint.solvers.frequency_response import find_response
from pitchpoint.solvers.initial_state.speeds import body_rates
from pitchpoint.solvers.mesh_response import find_mesh_response
from pitchpoint.system.system import assemble
from tests.support.engine import bearings
from tests.support.machines import compiled

RPM = math.pi / 30.0
PAIR = """\
gears:
  p: {number_of_teeth: 30, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  w: {number_of_teeth: 60, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  a: {gears: [p], motion: free, mass: 2 kg, inertia: 0.002, transverse_inertia: 0.0015, position: [0, 0, 0]}
  b: {gears: [w], motion: free, position: [90 mm, 0, 0], mass: 8 kg, inertia: 0.2, transverse_inertia: 0.11}
  lid: {mass: 1 kg, inertia: 0.004, transverse_inertia: 0.003}
joints: {bolts: {type: fixed, bodies: [b, lid], position: [90 mm, 0, 50 mm]}}
bearings:
  a: {body: a, stiffness: {radial: 2e8, axial: 1e8, tilt: 3e5}, damping: {radial: 1000, tilt: 20}}
  b: {body: b, position: [0, 0, 100 mm], stiffness: {radial: 4e7, axial: 2e7, tilt: 4e5},
      damping: {radial: 800, axial: 800, tilt: 30}}
meshes:
  st: {gears: [p, w], stiffness: {law: constant, value: 3e8}, damping: {ratio: 0.05},
       transmission_error: {cosine: [1 um]}}
loads: {m: {body: a, torque: 50 N m}, l: {body: b, torque: balance}}
scenarios: {s: {speed: {a: SPEED rad/s}, duration: 0.1 s}, rest: {duration: 0.1 s}}
"""


def pair(speed: float = 600.0):
    """The pair with an overhung wheel, compiled with the speed of its pinion [rad/s]."""
    return compiled(PAIR.replace("SPEED", repr(speed)), "s")[1]


@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_unbalance_of_an_overhung_disc(sense: float):
    """Forward whirl with z = x + i y, tilt t, distance l of the bearing: in either direction of rotation

    (k - M w^2) z + k l t = U w^2, k l z + (k l^2 + c - (I_t - I_p) w^2) t = 0.
    """
    M, I_p, I_t, k, c, lever = 12.0, 0.2, 0.11, 6e7, 4e5, -0.2
    K = np.diag([k, k, 1e7, c + k * lever**2, c + k * lever**2, 0.0])
    K[0, 4] = K[4, 0] = k * lever
    K[1, 3] = K[3, 1] = -k * lever
    body = Body(motion=FREE, mass=M, polar_inertia=I_p, transverse_inertia=I_t, name="disc")
    system = assemble([body], {"bearing": bearings([(1, 0, K, np.zeros((6, 6)))])})
    start = system.initial_state()
    start.v[system.spin("disc")] = sense * 700.0
    hertz = np.array([60.0, 130.0, 190.0, 260.0])
    found = find_response(
        system, ["unbalance[disc]"], ["disc.ux", "disc.uy"], hertz, synchronous="disc", start=start
    )
    w = 2.0 * np.pi * hertz
    tilt = k * lever**2 + c - (I_t - I_p) * w**2
    expected = w**2 / (k - M * w**2 - (k * lever) ** 2 / tilt)
    assert found.response[:, 0, 0] == pytest.approx(expected, rel=1e-8)
    assert found.response[:, 1, 0] == pytest.approx(-1j * sense * expected, rel=1e-8)


@pytest.mark.parametrize("speed", [600.0, -600.0])
@pytest.mark.parametrize("body", ["a", "b", "lid"])
def test_the_synchronous_response_is_that_at_the_speeds_of_the_scenario(speed: float, body: str):
    """At the rotational frequency of the body in the scenario, the speeds are those of the scenario."""
    system = pair(speed)
    hertz = [abs(speed) / (2.0 * math.pi) * (1.0 if body == "a" else 0.5)]
    inputs, outputs = [f"unbalance[{body}]"], ["a.ux", "b.ux", "b.uy", "b.ry"]
    one = find_response(system, inputs, outputs, hertz, "s")
    two = find_response(system, inputs, outputs, hertz, "s", synchronous=body)
    assert two.response == pytest.approx(one.response, rel=1e-9)


def test_at_rest_the_synchronous_body_rotates_in_the_positive_direction():
    """The unbalance of a wheel of equal size then rotates in the negative direction.

    The deflection of the shafts, at which forces act, is that at rest: a difference of 1e-4.
    """
    text = PAIR.replace("teeth: 60", "teeth: 30").replace("SPEED", "600").replace("90 mm", "60 mm")
    system, inputs, outputs = compiled(text, "s")[1], ["unbalance[b]"], ["b.ux", "b.uy"]
    rest = find_response(system, inputs, outputs, [95.0], "rest", synchronous="a").response[0, :, 0]
    turning = find_response(system, inputs, outputs, [600.0 / math.tau], "s").response[0, :, 0]
    assert rest[1] / rest[0] == pytest.approx(1j, abs=0.05)
    rest = find_response(system, inputs, outputs, [600.0 / math.tau], "rest", synchronous="a").response[
        0, :, 0
    ]
    assert rest == pytest.approx(turning, rel=1e-3)


def test_unbalance_of_a_shaft_with_another_speed_is_refused():
    with pytest.raises(
        ModelError, match=r"unbalance\[b\]: excites at 0.5 times the frequency of a"
    ) as caught:
        find_response(pair(), ["unbalance[b]"], ["b.ux"], [40.0], "s", synchronous="a")
    assert "choose b as the synchronous body" in str(caught.value)


@pytest.mark.parametrize("speed", [600.0, -600.0])
def test_the_mesh_response_does_not_depend_on_the_body_of_the_speed(speed: float):
    outputs = ["bearing_force[b.fx]", "bearing_force[a.fy]", "b.ry"]
    speeds = np.array([1500.0, 4000.0]) * RPM
    system = pair(speed)
    one = find_mesh_response(system, outputs, "a", speeds, "s", harmonics=1).response
    for two in (("b", 0.5 * speeds), ("b", -0.5 * speeds), ("lid", 0.5 * speeds), ("a", -speeds)):
        found = find_mesh_response(system, outputs, *two, "s", harmonics=1).response
        assert found == pytest.approx(one, rel=1e-9)


def test_speeds_of_a_train_have_the_direction_of_the_scenario():
    """A body that is fixed to a shaft has the speed of the shaft."""
    for speed in (600.0, -600.0):
        system = pair(speed)
        state = system.model.start_speeds("s")
        for name in ("a", "b", "lid"):
            rates = body_rates(system, name, system.model.scenarios["s"])
            assert rates[system.spin("b")] / rates[system.spin("a")] == -0.5
            assert np.sign(rates[system.spin("a")]) == np.sign(state["a"])
            assert abs(rates[system.spin(name)]) == pytest.approx(1.0)
