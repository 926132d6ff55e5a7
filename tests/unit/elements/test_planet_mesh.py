# SPDX-License-Identifier: Apache-2.0
"""Meshes whose line of centres goes round with a carrier, against the same gears on axes of their own."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.contact.stiffness.din3990 import din3990
from pitchpoint.elements.mesh import record as layout
from pitchpoint.elements.mesh.eccentricity import displaced
from pitchpoint.multibody.bodies import FREE, TORSION, Body
from pitchpoint.system import evaluate
from pitchpoint.system.rules.mesh_laws import MeshLaws
from pitchpoint.system.system import assemble
from tests.support.engine import differences
from tests.support.one_mesh import OneMesh, make_pair


def gears(internal):
    """Record of one mesh with its pool; gear 1 at the origin, gear 2 at the centre distance on x."""
    pair = make_pair(z1=21, z2=60, internal=internal)
    stiffness = din3990(pair, S_R=0.8, T_R=0.3)
    laws = MeshLaws(stiffness=stiffness, k_ref=1e9, d_in=1e4, d_out=1e4, s_0=1e-6)
    return OneMesh(pair, laws, theta=0.0)


OFF_AXIS = np.array([[4e-6, -3e-6, 1e-4, 0.0], [0.0, 5e-6, -1e-4, 2e-4]])
"""Both gears beside the axes of their bodies and askew on them: x, y and the lean of each."""


def two_ways(internal, places=None):
    """Gear 1 on ground and gear 2 on a carrier about gear 1; gear 2 on ground as a free body."""
    mesh = gears(internal)
    if places is not None:
        mesh.rec["displaced"], mesh.rec["seats"] = 1, mesh.pool.size
        mesh.pool = np.append(mesh.pool, displaced(places))
    row = mesh.rec.copy()
    place = (float(mesh.frames["r"][1][0]), 0.0, 0.0)
    numbers = {"mass": 2.0, "polar_inertia": 0.02, "transverse_inertia": 0.015}
    sun = Body(motion=TORSION, name="sun", **numbers)
    carrier = Body(motion=TORSION, name="carrier", polar_inertia=1.0, mass=3.0)
    planet = Body(motion=FREE, position=place, parent=2, name="planet", **numbers)
    row["i"], row["j"] = 1, 3
    pools = {"gear_mesh": mesh.pool}
    hung = assemble([sun, carrier, planet], {"gear_mesh": row}, pools=pools)
    loose = Body(motion=FREE, position=place, name="planet", **numbers)
    row = row.copy()
    row["j"] = 2
    return hung, assemble([sun, loose], {"gear_mesh": row}, pools=pools)


@pytest.mark.parametrize("places", [None, OFF_AXIS])
@pytest.mark.parametrize("internal", [False, True])
@pytest.mark.parametrize("carrier", [0.0, 0.7, 3.0, -3.0])
def test_a_planet_feels_its_mesh_as_it_would_on_ground(internal, carrier, places):
    """The line of centres of the free gear turns by less than half a turn here, so both can be told."""
    hung, loose = two_ways(internal, places)
    r = float(hung.program["body"][3]["pos"][0])
    state = hung.initial_state()
    small = 1e-6 * np.array([3.0, -2.0, 1.0, 4.0, 2.0])
    sun = 21 / 60 * 0.3 * (-1 if internal else 1)
    z2 = -60 if internal else 60
    state.q[hung.layout.coordinate("carrier.spin")] = carrier
    d = hung.layout.coordinate("planet.x")
    state.q[d : d + 5] = small
    spin = -21 / z2 * (sun - carrier) + 3e-4
    state.q[d + 5] = spin
    state.q[hung.layout.coordinate("sun.spin")] = sun
    state.v[:] = 0.0
    state.v[hung.layout.coordinate("carrier.spin")] = 5.0
    state.v[d + 5] = 21 / z2 * 5.0
    evaluate.residual(hung, state)
    fr = hung.workspace.fr.copy()
    observed = evaluate.observe(hung, state)

    same = loose.initial_state()
    e = loose.layout.coordinate("planet.x")
    same.q[e : e + 3] = fr["r"][3] - np.array([r, 0.0, 0.0])
    n = fr["R"][3][:, 2]
    alpha, beta = np.arctan2(-n[1], n[2]), np.arcsin(n[0])
    S = fr["S"][3]
    turned = np.linalg.multi_dot(
        [
            np.array([[np.cos(beta), 0, -np.sin(beta)], [0, 1, 0], [np.sin(beta), 0, np.cos(beta)]]),
            np.array([[1, 0, 0], [0, np.cos(alpha), np.sin(alpha)], [0, -np.sin(alpha), np.cos(alpha)]]),
            S,
        ]
    )
    angle = np.arctan2(turned[1, 0], turned[0, 0])
    angle += 2 * np.pi * np.round((carrier + spin - angle) / (2 * np.pi))
    same.q[e + 3 : e + 6] = alpha, beta, angle
    same.q[loose.layout.coordinate("sun.spin")] = sun
    same.v[e : e + 3] = fr["tw"][3, :3]
    same.v[e + 5] = fr["tw"][3, 5]
    again = evaluate.observe(loose, same)
    for name in ("mesh_force[gear_mesh0]", "transmission_error[gear_mesh0]", "axial_force[gear_mesh0]"):
        one = observed[hung.layout.channel(name)]
        two = again[loose.layout.channel(name)]
        assert one == pytest.approx(two, rel=1e-6, abs=1e-12), name
    assert abs(observed[hung.layout.channel("mesh_force[gear_mesh0]")]) > 100.0
    assert hung.records["gear_mesh"]["carried"][0] == 2


@pytest.mark.parametrize("places", [None, OFF_AXIS])
@pytest.mark.parametrize("internal", [False, True])
def test_turns_of_the_carrier_change_nothing(internal, places):
    """Sun and carrier go round together; then the carrier alone by whole turns that suit the teeth."""
    hung, _ = two_ways(internal, places)
    state = hung.initial_state()
    state.q[:] = 1e-4, 1.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    z2 = -60 if internal else 60
    state.q[hung.layout.coordinate("sun.spin")] = 0.3
    state.q[hung.layout.coordinate("planet.spin")] = -21 / z2 * (0.3 - 1.2) + 3e-4
    before = evaluate.residual(hung, state)
    state.turns[:3] += 7  # ground's does not count
    np.testing.assert_array_equal(evaluate.residual(hung, state), before)
    state.turns[2] += 20
    state.turns[3] += 7 if not internal else -7
    np.testing.assert_array_equal(evaluate.residual(hung, state), before)
    # through the step from pi to -pi of the carrier
    values = []
    for angle in (np.pi - 1e-9, np.pi + 1e-9):
        here = state.copy()
        here.q[hung.layout.coordinate("carrier.spin")] = angle
        here.q[hung.layout.coordinate("planet.spin")] = -21 / z2 * (0.3 - angle) + 3e-4
        values.append(evaluate.observe(hung, here)[hung.layout.channel("mesh_force[gear_mesh0]")])
    assert values[0] == pytest.approx(values[1], rel=1e-6)


def test_tangents_of_a_planet_mesh():
    hung, _ = two_ways(False)
    state = hung.initial_state()
    state.q[hung.layout.coordinate("carrier.spin")] = 0.4
    state.q[hung.layout.coordinate("sun.spin")] = 0.3
    state.q[hung.layout.coordinate("planet.spin")] = -21 / 60 * (0.3 - 0.4) + 3e-4
    _, _, K = evaluate.linearize(hung, state)
    expected = differences(hung, state, "q", 1e-9)
    # the mesh phase is frozen in the tangent: 1 % of the stiffness here
    np.testing.assert_allclose(K, expected, atol=2e-2 * np.abs(expected).max())
    assert layout.RECORD.names[7] == "carried"
