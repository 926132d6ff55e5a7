# SPDX-License-Identifier: Apache-2.0
"""Ball on the axis of a conical seat, and in the hole of a ring: contact along a circle, by statics.

With the angle g between the axis and the seat at the circle, the axial force is N sin g of the force N of the
whole circle, and there is none across. For a linear law of stiffness K the mean around the circle gives
K sin(g)^2 along the axis and K cos(g)^2/2 across.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.forces import check_balance, differences

HALF, R, DEPTH, LOAD = math.radians(30.0), 0.01, 10e-6, 500.0
TIP = R / math.sin(HALF)
"""Distance of the centre of a ball that just touches the cone from its tip."""
CONE = "{shape: cone, half_angle: 30 deg, length: 80 mm, hollow: true}"
RING = "{shape: torus, radius: 15 mm, tube: 6 mm}"
RISE = math.sqrt((R + 0.006) ** 2 - 0.015**2)
"""Height of the centre of a ball that just touches the ring, above its plane."""
GUIDES = {
    "slide": "joints: {g: {type: prismatic, bodies: [ground, ball], axes: {z: [0, 0, 1]}}}",
    "springs": "joints: {g: {type: free, bodies: [ground, ball]}}\n"
    "bushings: {b: {ends: [ball, ground],\n"
    "  stiffness: {radial: 1e5 N/m, tilt: 10 N m/rad, torsion: 10 N m/rad}}}",
}


def valve(seat=CONE, place=(0.0, 0.0, -TIP), more=", line: true", guide="slide", exponent=1.5, load=LOAD):
    """Ball with a load along the axis of its seat; the text of the model."""
    return f"""
title: valve
bodies:
  base: {{motion: fixed, position: [0, 0, 0]}}
  ball: {{mass: 0.03 kg, inertia_tensor: [1e-6, 1e-6, 1e-6, 0, 0, 0],
    position: [{place[0]!r} m, {place[1]!r} m, {place[2]!r} m], markers: {{o: {{}}}}}}
{GUIDES[guide]}
surface_contacts:
  seat: {{ends: [ball, base], first: {{shape: sphere, radius: {R} m}}, second: {seat},
    law: {{force: 1 kN, depth: {DEPTH} m, exponent: {exponent}}}{more}}}
loads:
  f: {{body: ball, marker: o, force: [0, 0, {load} N]}}
"""


@pytest.mark.parametrize("guide", GUIDES)
@pytest.mark.parametrize("start", [1e-6, -1e-3])
def test_a_ball_in_a_conical_seat_is_centred(guide, start):
    system = compile_model(loads_model(valve(guide=guide, place=(0.0, 0.0, start - TIP))))
    found = find_equilibrium(system)
    rise = DEPTH / math.sin(HALF) - start  # 500 N / sin(30 deg) is the force of the law
    z = system.layout.coordinate("ball.z")
    assert found.state.q[z] == pytest.approx(rise, rel=1e-6)
    others = np.delete(found.state.q, z)
    np.testing.assert_allclose(others, 0.0, atol=1e-12)
    values = found.observe(system)
    assert values[system.layout.channel("contact_force[seat]")] == pytest.approx(1000.0, rel=1e-7)
    evaluate.residual(system, found.state)
    wrench = system.workspace.fr["F"][system.layout.bodies.index("ball")]
    np.testing.assert_allclose(wrench[:2], 0.0, atol=1e-9 * LOAD)  # 866 N with a single point


def test_a_ball_in_a_ring_is_centred():
    """Centre of the ball above the plane of the ring: sin(g) = z/(R + r) at first contact."""
    system = compile_model(loads_model(valve(RING, (0.0, 0.0, RISE + 1e-4), load=-LOAD)))
    found = find_equilibrium(system)
    z = RISE + 1e-4 + found.state.q[0]
    distance = math.hypot(0.015, z)
    force = 1000.0 * ((R + 0.006 - distance) / DEPTH) ** 1.5
    assert force * z / distance == pytest.approx(LOAD, rel=1e-7)
    values = found.observe(system)
    assert values[system.layout.channel("contact_force[seat]")] == pytest.approx(force, rel=1e-9)
    evaluate.residual(system, found.state)
    np.testing.assert_allclose(system.workspace.fr["F"][2][:2], 0.0, atol=1e-9 * LOAD)


def test_the_seat_holds_the_ball_across_its_axis():
    system = compile_model(
        loads_model(valve(guide="springs", place=(0.0, 0.0, 2e-5 - TIP), exponent=1, load=0.0))
    )
    K = evaluate.linearize(system, system.initial_state())[2]
    at = [system.layout.coordinate(f"ball.{name}") for name in "xyz"]
    stiffness = 1000.0 / DEPTH
    across = 0.5 * stiffness * math.cos(HALF) ** 2 + 1e5
    wanted = np.diag([across, across, stiffness * math.sin(HALF) ** 2])
    np.testing.assert_allclose(K[np.ix_(at, at)], wanted, atol=1e-9 * stiffness)


def test_the_deepest_part_is_at_the_distance_of_the_ball_from_the_cone():
    gaps = []
    for more in ("", ", line: true"):
        system = compile_model(loads_model(valve(place=(5e-4, 0.0, -TIP - 1e-3), more=more)))
        row = evaluate.observe(system, system.initial_state())
        gaps.append(row[system.layout.channel("gap[seat]")])
    assert gaps[1] == pytest.approx(gaps[0], abs=1e-15)


@pytest.mark.parametrize("seat", [CONE, RING])
def test_forces_balance_and_tangents_are_their_derivatives(seat):
    place = (1e-5, -2e-5, 1e-4 - TIP if seat == CONE else RISE - 1e-4)
    rubs = ", line: true, friction: {static: 0.2, dynamic: 0.15, static_speed: 0.1 m/s, slip_speed: 0.5 m/s}"
    system = compile_model(loads_model(valve(seat, place, rubs, "springs", load=0.0)))
    state = system.initial_state()
    rng = np.random.default_rng(7)
    state.q[:3] = 1e-5 * rng.normal(size=3)
    state.q[3:] = 0.3 * rng.normal(size=3)
    state.v[:] = [0.02, -0.01, 0.03, 3.0, -5.0, 8.0]
    check_balance(system, state)
    _, D, K = evaluate.linearize(system, state)
    for found, name, step in ((K, "q", 1e-9), (D, "v", 1e-6)):
        wanted = differences(system, state, name, step)
        np.testing.assert_allclose(found, wanted, atol=2e-6 * np.abs(wanted).max())


@pytest.mark.parametrize(
    ("seat", "place", "more", "words"),
    [
        (CONE, (0.0, 0.0, -TIP), "", "a hollow cone that touch along a circle.*write line: true"),
        (CONE, (1e-6, 0.0, -TIP), "", r"0\.001 mm from the axis.*write line: true"),
        (RING, (0.0, 0.0, RISE), "", "a torus that touch along a circle.*write line: true"),
        ("{shape: cone, half_angle: 30 deg}", (0.02, 0.0, -0.02), ", line: true", "line.*has no effect"),
        ("{shape: cylinder, radius: 9 mm, hollow: true}", (0.0, 0.0, 0.0), "", "does not fit into the bore"),
    ],
)
def test_a_contact_at_an_arbitrary_side_is_refused(seat, place, more, words):
    with pytest.raises(ModelError, match=words):
        loads_model(valve(seat, place, more))


@pytest.mark.parametrize(
    ("seat", "place"),
    [
        (CONE, (1e-3, 0.0, -0.03)),
        ("{shape: torus, radius: 20 mm, tube: 5 mm}", (0.0, 0.0, 0.02)),
        ("{shape: cone, half_angle: 30 deg}", (0.0, 0.0, 0.011)),
        ("{shape: cylinder, radius: 11 mm, hollow: true}", (0.0, 0.0, 0.0)),
    ],
)
def test_other_contacts_of_a_ball_keep_their_single_point(seat, place):
    compile_model(loads_model(valve(seat, place, "")))
