# SPDX-License-Identifier: Apache-2.0
"""SEED-CAM: crankshaft-idler-camshaft train of a ship engine (NTNU thesis, 2015).

Inputs are printed: modules 8 and 9 mm, 59/68 and 34/59 teeth, coefficients -0.626 and -0.082 on both gears,
centre distances 497 and 417 mm, 20 deg. The tool is not given. With the usual rack (dedendum 1.25, root
radius 0.38) the tips of pair 1 reach below the root form circles; its printed wave of two and three pairs in
contact needs the contact ratio of the tip circles alone, so a tool with a longer straight flank must have
been meant. The last test shows both readings.
"""

from __future__ import annotations

import math

import pytest

from pitchpoint.geometry import BasicRack, CylindricalGear, GearPair
from tests.support.printed import printed

PAIRS = {1: (59, 68, 8e-3, -0.626, 0.497), 2: (34, 59, 9e-3, -0.082, 0.417)}


def pair_of(number, **others):
    z1, z2, m_n, x, a_w = PAIRS[number]
    gears = [CylindricalGear(z=z, m_n=m_n, x=x, **others) for z in (z1, z2)]
    return GearPair(*gears, a_w)


@pytest.mark.parametrize(
    ("number", "d_b", "a_from_x", "alpha_w", "x_sum"),
    [
        (1, ("443.5349", "511.1928"), "497.0071", "16.1595", "-1.252722"),
        (2, ("287.5459", "498.9768"), "417.0035", "19.4258", "-0.164383"),
    ],
)
def test_working_geometry(number, d_b, a_from_x, alpha_w, x_sum):
    pair = pair_of(number)
    assert pair.gear1.d_b * 1e3 == printed(d_b[0])
    assert pair.gear2.d_b * 1e3 == printed(d_b[1])
    assert GearPair.from_profile_shifts(pair.gear1, pair.gear2).a_w * 1e3 == printed(a_from_x)
    assert math.degrees(pair.alpha_wt) == printed(alpha_w)
    assert pair.x_sum == printed(x_sum)
    assert pair.x_sum_given == pytest.approx(2.0 * PAIRS[number][3], rel=1e-15)


def test_contact_ratios():
    assert pair_of(1).eps_alpha == printed("2.2107")
    assert pair_of(1, tip_alteration=-0.123 * 8e-3).eps_alpha == printed("1.9832")
    assert pair_of(2).eps_alpha == printed("1.7709")


def test_pair_one_needs_another_tool_than_the_usual_one():
    usual = pair_of(1)
    assert not usual.problems()
    assert len(usual.warnings()) == 2
    assert usual.eps_alpha_form == pytest.approx(1.7208, abs=1e-4)
    deeper = pair_of(1, rack=BasicRack(h_fP_star=1.4, rho_fP_star=0.2))
    assert not deeper.warnings()
    assert deeper.eps_alpha_form == deeper.eps_alpha == printed("2.2107")
