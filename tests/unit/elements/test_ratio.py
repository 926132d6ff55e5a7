# SPDX-License-Identifier: Apache-2.0
"""Fixed ratios of joint coordinates: rack, belt, planet set."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.elements.ratio import RECORD, SPIN
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.joints import PRISMATIC
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import torques


def accelerations(system, state):
    evaluate.prepare(system)
    evaluate.load(system, state)
    evaluate.check(system, evaluate.send_request(system.workspace, evaluate.ACCELERATE, 0.0))
    return system.workspace.a.copy()


@pytest.mark.nojit
def test_a_rack_moves_by_the_pitch_radius_per_radian():
    """T = J a + r m (r a): the pinion feels the mass of the rack as m r^2."""
    r, J, m = 0.05, 0.02, 3.0
    bodies = [
        Body(polar_inertia=J, name="pinion"),
        Body(motion=PRISMATIC, mass=m, inertia=np.eye(3), name="rack"),
    ]
    row = np.zeros(1, RECORD)
    row["i"], row["j"], row["q_i"], row["c_i"], row["c_j"] = 1, 2, SPIN, r, -1.0
    system = assemble(bodies, {"torque": torques([(1, 2.0)])}, {"ratio": row})
    state = system.initial_state()
    state.q[:], state.turns[1] = (0.5, r * (0.5 + 2.0 * np.pi * 3)), 3
    a = accelerations(system, state)
    assert a[0] == pytest.approx(2.0 / (J + m * r * r), rel=1e-12)
    assert a[1] == pytest.approx(r * a[0], rel=1e-12)
    assert system.workspace.g[0] == pytest.approx(0.0, abs=1e-14)


def test_a_planet_set_follows_willis():
    """Sun on ground, planet on the carrier: z_s (spin_s - spin_c) + z_p spin_p = 0, spin_p on the carrier."""
    z_s, z_p = 21, 39
    bodies = [
        Body(polar_inertia=1.0, name="sun"),
        Body(polar_inertia=2.0, name="carrier"),
        Body(parent=2, position=(0.3, 0.0, 0.0), mass=4.0, polar_inertia=0.5, name="planet"),
    ]
    row = np.zeros(1, RECORD)
    for end, body, c in (("i", 1, z_s), ("j", 3, z_p), ("k", 2, -z_s)):
        row[end], row[f"q_{end}"], row[f"c_{end}"] = body, SPIN, c
    system = assemble(bodies, {"torque": torques([(1, 5.0)])}, {"ratio": row})
    state = system.initial_state()
    state.turns[1], state.turns[2], state.turns[3] = 39 + 7, 7, -21
    a = accelerations(system, state)
    assert system.workspace.g[0] == 0.0
    assert z_s * (a[0] - a[1]) + z_p * a[2] == pytest.approx(0.0, abs=1e-12)
    # two degrees of freedom: sun and carrier; kinetic energy with the planet turning at w_c + spin_p
    k = z_s / z_p
    arm = 2.0 + 4.0 * 0.3**2
    M = np.array([[1.0 + 0.5 * k * k, -0.5 * k * (1 + k)], [-0.5 * k * (1 + k), arm + 0.5 * (1 + k) ** 2]])
    np.testing.assert_allclose(a[:2], np.linalg.solve(M, [5.0, 0.0]), rtol=1e-12)
