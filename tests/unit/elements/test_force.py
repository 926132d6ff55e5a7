# SPDX-License-Identifier: Apache-2.0
"""Forces at points of bodies: axes, reaction, laws over angle and speed, tangents, power."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.formula.formula import Formula
from pitchpoint.elements import force
from pitchpoint.elements import signal as sig
from pitchpoint.elements.force import BODY, WORLD
from pitchpoint.system.system import assemble
from tests.support.forces import check_balance, check_matrices, mechanism, moving, shafts, wrenches


def one(rng, i, j, axes, text=""):
    record, pool = np.zeros(1, force.RECORD), sig.Pool()
    record["i"], record["j"], record["axes"], record["value"] = i, j, axes, 1.0
    record["F"], record["p"], record["z"] = rng.normal(size=6), 0.3 * rng.normal(size=3), 0.1
    if text:
        sig.set_formula(record[0], pool, Formula.parse(text, ("t", "angle", "speed")))
    return record, pool.array()


@pytest.mark.nojit
@pytest.mark.parametrize("axes", [WORLD, BODY])
@pytest.mark.parametrize(("i", "j"), [(1, 0), (3, 0), (1, 2), (2, 3), (4, 3), (1, 4)])
def test_a_law_over_time_angle_and_speed(i, j, axes):
    rng = np.random.default_rng(9)
    record, pool = one(rng, i, j, axes, "2 + sin(2*angle) - 0.3*speed + t")
    system = assemble(shafts(rng), {"force": record}, pools={"force": pool})
    state = moving(system, rng, 0.4, 0.05)
    check_matrices(system, state)
    check_balance(system, state)


@pytest.mark.parametrize("axes", [WORLD, BODY])
@pytest.mark.parametrize(("i", "j"), [(1, 0), (3, 0), (1, 2), (2, 3), (4, 3)])
def test_a_constant_force_on_a_tumbling_body(i, j, axes):
    rng = np.random.default_rng(3)
    record, pool = one(rng, i, j, axes)
    bodies = mechanism(rng)
    system = assemble(bodies, {"force": record}, pools={"force": pool})
    state = moving(system, rng)
    check_matrices(system, state)
    check_balance(system, state)
    F = wrenches(system, state)[i]
    frame = system.workspace.fr[i]
    c, s = np.cos(frame["phi"]), np.sin(frame["phi"])
    S = frame["R"] @ np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    A = S if axes == BODY else np.eye(3)
    arm = S @ (record["p"][0] + [0.0, 0.0, 0.1])
    np.testing.assert_allclose(F[:3], A @ record["F"][0, :3], atol=1e-13)
    np.testing.assert_allclose(F[3:], A @ record["F"][0, 3:] + np.cross(arm, F[:3]), atol=1e-13)


def test_the_law_sees_the_turn_between_both_bodies():
    """A planet against its carrier: the spin of its own joint; against ground: that of the carrier too."""
    rng = np.random.default_rng(3)
    for j, angle in ((2, 0.5 - 4.0 * np.pi), (0, 0.5 - 4.0 * np.pi + 0.3 + 2.0 * np.pi)):
        record, pool = one(rng, 3, j, WORLD, "angle")
        system = assemble(shafts(rng), {"force": record}, pools={"force": pool})
        state = system.initial_state()
        state.q[[system.spin("carrier"), system.spin("planet")]] = 0.3, 0.5
        state.turns[2:4] = 1, -2
        np.testing.assert_allclose(wrenches(system, state)[3, :3], angle * record["F"][0, :3], rtol=1e-13)
