# SPDX-License-Identifier: Apache-2.0
"""States of elements at rest: what they settle to, and that nobody sees the bodies that hold them."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.elements import friction_clutch, maxwell
from pitchpoint.multibody.bodies import Body
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.gear_trains import free_spins
from pitchpoint.system.system import assemble
from tests.support.engine import couplings, torques


def test_bodies_that_hold_states_are_neither_seen_nor_turned():
    """A disc on a clutch with bristles: the clutch is no hold at rest, since nothing has bent it yet."""
    row = np.zeros(1, friction_clutch.RECORD)
    row["i"], row["j"], row["k"], row["sticking"] = 1, 0, 2, friction_clutch.BRISTLE
    row["value"], row["ratio"] = 50.0, 1.0
    row["stiffness"], row["onset"] = 1e4, 0.9
    bodies = [Body(polar_inertia=0.1, name="disc"), Body(polar_inertia=1.0, name="clutch.state", state=True)]
    system = assemble(bodies, {"friction_clutch": row, "torque": torques([(1, 20.0)])})
    assert [c.name for c in system.layout.channels if "state" in c.name] == []
    assert free_spins(system) == (0,)
    found = find_equilibrium(system, None, [0])
    assert found.reaction[0] == pytest.approx(-20.0, rel=1e-9)


def test_a_maxwell_element_relaxes_at_rest():
    row = np.zeros(1, maxwell.RECORD)
    row["i"], row["k"], row["p_i"], row["p_j"] = 1, 2, (0.2, 0, 0), (0.2, 0.3, 0)
    row["stiffness"], row["damping"] = 1e3, 50.0
    bodies = [Body(polar_inertia=0.1, name="disc"), Body(polar_inertia=1.0, name="m.state", state=True)]
    banks = {
        "maxwell": row,
        "coupling": couplings([(1, 0, 100.0, 1.0, 0.0)]),
        "torque": torques([(1, 5.0)]),
    }
    system = assemble(bodies, banks)
    start = system.initial_state()
    start.v[system.states] = 7.0  # a tension that no rest can have
    found = find_equilibrium(system, start)
    assert found.state.q[0] == pytest.approx(0.05, rel=1e-9)
    assert found.state.v[system.states[0]] == pytest.approx(0.0, abs=1e-9)
