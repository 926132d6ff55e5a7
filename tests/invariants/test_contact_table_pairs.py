# SPDX-License-Identifier: Apache-2.0
"""Forces of the tooth pairs with pre-computed contact: those of flexible contact, at every phase."""

import functools
import math

import numpy as np
import pytest

from pitchpoint.elements.mesh.record import N_OUT
from tests.support.flank_levels import N_PAIR, flexible, precomputed
from tests.support.one_mesh import OneMesh, make_pair

HELICAL = dict(beta=0.3)
CYCLE = 2.0 * math.pi / 25


@functools.cache
def made(level):
    return {"flexible": flexible, "precomputed": precomputed}[level](make_pair(**HELICAL))


def pair_forces(level, rolls, flank):
    """Forces of the pairs over the mesh force, shape (n, N_PAIR)."""
    found = np.zeros((len(rolls), N_PAIR))
    for k, roll in enumerate(rolls):
        m = OneMesh(make_pair(**HELICAL), made(level), n_pair=N_PAIR)
        m.frames["phi"] = [roll, -roll * m.row["r_b1"] / m.row["r_b2"]]
        m.press(2e-5, flank)
        found[k] = m.out[N_OUT : N_OUT + N_PAIR] / m.get("mesh_force")
    return found


@pytest.mark.parametrize("flank", [1, -1])
def test_pair_forces_are_those_of_flexible_contact(flank):
    """At random phases of several cycles, and over the end of the table, where the next cycle begins. The
    shares are linear between eight phases: 0.03 at the kink where a pair enters."""
    rng = np.random.default_rng(3)
    rolls = CYCLE * np.concatenate([rng.uniform(-3.0, 9.0, 40), np.linspace(0.0, 1.0, 40)])
    table, exact = (pair_forces(level, rolls, flank) for level in ("precomputed", "flexible"))
    assert abs(table.sum(axis=1) - 1.0).max() < 1e-12
    assert abs(table - exact).max() < 0.05
