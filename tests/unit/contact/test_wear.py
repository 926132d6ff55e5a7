# SPDX-License-Identifier: Apache-2.0
"""Wear patterns against load and sliding worked out point by point."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.mesh_cycle import pair_cycle
from pitchpoint.contact.stiffness.description import PairShape
from pitchpoint.contact.wear import total_shape, wear_pattern
from pitchpoint.geometry.sliding import specific_sliding_at
from tests.support.one_mesh import make_pair

PAIRS = {"external": dict(beta=0.0), "internal": dict(beta=0.0, z2=70, internal=True)}
SHAPES = {
    "even": PairShape(c_prime=14e9, S_R=1.0),
    "parabola": PairShape(c_prime=14e9, S_R=0.7, T_R=0.5),
    "table": PairShape(c_prime=14e9, table=np.array([0.5, 1.0, 0.9, 0.7])),
}


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("gear", [1, 2])
def test_share_of_the_load_times_specific_sliding(pair, shape, gear):
    pair, law = make_pair(**PAIRS[pair]), SHAPES[shape]
    eps = pair.eps_alpha
    for p in np.linspace(0.02, eps - 0.02, 23):
        T1Y = pair.T1A + p * pair.p_et
        others = [p + q for q in (-2, -1, 1, 2) if 0.0 <= p + q <= eps]
        share = law.along(p, eps) / (law.along(p, eps) + sum(law.along(o, eps) for o in others))
        sliding = abs(specific_sliding_at(pair, T1Y)[gear - 1])
        roll = T1Y if gear == 1 else abs(pair.T1T2 - T1Y)
        found = wear_pattern(pair, law, gear=gear, z=[0.0, 0.01], roll=[roll])
        assert found[:, 0] == pytest.approx(float(share) * sliding, rel=1e-9)
    assert wear_pattern(pair, law, gear=1, z=[0.0], roll=[pair.T1C])[0, 0] < 1e-12


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("overlap", [0.0, 0.3, 1.7])
def test_total_is_that_of_the_mesh_cycle(shape, overlap):
    cycle = pair_cycle(SHAPES[shape], 1.37, overlap, n=48)
    away = [min(abs(x - jump) for jump in (*cycle.jumps, -1.0)) > 1e-9 for x in cycle.phase]
    found = total_shape(SHAPES[shape], 1.37, overlap, cycle.phase)
    assert found[away] == pytest.approx(cycle.stiffness_ratio[away], abs=2e-6)
    assert sum(away) > 40


def test_lines_of_a_helical_pair_wear_the_same_where_the_total_is_even():
    """With a whole overlap the load of a line is F/(b eps_alpha) everywhere."""
    pair = make_pair(beta=0.3, b=0.03)
    helix = 1.0 / pair.b_w  # as if one pitch of overlap
    roll = np.linspace(pair.T1A, pair.T1E, 9)
    found = wear_pattern(pair, SHAPES["even"], gear=1, z=[-0.01, 0.0, 0.01], roll=roll, helix=helix)
    sliding = [abs(specific_sliding_at(pair, x)[0]) for x in roll]
    assert found == pytest.approx(np.tile(np.array(sliding) / pair.eps_alpha, (3, 1)), rel=1e-3)


def test_flanks_near_the_base_circle_do_not_wear_without_bound():
    pair = make_pair(z1=18, beta=0.0)
    found = wear_pattern(pair, SHAPES["even"], gear=1, z=[0.0], roll=np.linspace(0.0, pair.T1E, 50))
    assert np.isfinite(found).all() and found.max() < 40.0
    assert math.isclose(
        found[0, 0], wear_pattern(pair, SHAPES["even"], gear=1, z=[0.0], roll=[pair.T1A])[0, 0]
    )
