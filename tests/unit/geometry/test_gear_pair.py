# SPDX-License-Identifier: Apache-2.0
"""A pair: centre distance in both directions, path of contact, backlash, and why a pair is impossible."""

from __future__ import annotations

import math

import pytest

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry import (
    CylindricalGear,
    GearPair,
    loss_factor_integral,
    loss_factor_ohlendorf,
    sliding_factor_at,
    specific_sliding_at,
)

G50 = CylindricalGear(z=50, m_n=3e-3, b=20e-3)
RING = CylindricalGear.internal(z=70, m_n=3e-3)


@pytest.mark.parametrize("a_w", [0.0, math.nan, math.inf, -0.15, True])
def test_meaningless_centre_distances_are_refused(a_w):
    with pytest.raises(GeometryError, match="center_distance"):
        GearPair(G50, G50, a_w)


def test_internal_centre_distance_is_negative_inside_and_positive_outside():
    pinion = CylindricalGear(z=20, m_n=3e-3)
    assert GearPair.at_distance(pinion, RING, 0.075) == GearPair(pinion, RING, -0.075)
    assert GearPair.from_profile_shifts(pinion, RING).a_w == pytest.approx(-0.075, rel=1e-12)
    for wrong in (0.075, math.nan):
        with pytest.raises(GeometryError):
            GearPair(pinion, RING, wrong)
    with pytest.raises(GeometryError):
        GearPair.at_distance(pinion, RING, -0.075)


def test_standard_pair_has_no_backlash_and_symmetric_path():
    pair = GearPair.from_profile_shifts(G50, G50)
    assert pair.a_w == pytest.approx(0.15, rel=1e-14)
    assert pair.j_bt == pytest.approx(0.0, abs=1e-16)
    assert pair.T1A == pytest.approx(pair.T1T2 - pair.T1E, rel=1e-14)
    assert pair.g_f == pytest.approx(pair.g_a, rel=1e-12)
    assert (pair.T1D - pair.T1A, pair.T1E - pair.T1B) == (pytest.approx(pair.p_et), pytest.approx(pair.p_et))
    assert pair.d_Na1 == pytest.approx(G50.d_a) and pair.d_Na2 == pytest.approx(G50.d_a)


def test_thinner_teeth_make_backlash_in_the_three_directions():
    beta = 0.3
    right = CylindricalGear(z=30, m_n=4e-3, beta=beta, thickness_allowance=-50e-6)
    left = CylindricalGear(z=40, m_n=4e-3, beta=-beta, thickness_allowance=-70e-6)
    pair = GearPair.from_profile_shifts(right, left)
    # On the reference circle, normal to the flank, thinner teeth leave 120 um along the pitch line.
    assert pair.j_bn == pytest.approx(120e-6 * math.cos(right.alpha_n), rel=1e-12)
    assert pair.j_bt == pytest.approx(pair.j_bn / math.cos(right.beta_b), rel=1e-14)
    assert pair.j_wt == pytest.approx(pair.j_bt / math.cos(pair.alpha_wt), rel=1e-14)


def test_internal_backlash_grows_when_the_axes_approach():
    pinion = CylindricalGear(z=20, m_n=3e-3)
    pair = GearPair.at_distance(pinion, RING, 0.075)
    assert pair.backlash(-0.0749).j_bt > 0.0 > pair.backlash(-0.0751).j_bt


def test_virtual_contact_lines_of_a_spur_pair_count_whole_teeth():
    pair = GearPair(G50, G50, 0.15)
    assert pair.l_min == math.floor(pair.eps_alpha) * 20e-3


def test_contact_lines_of_an_integer_overlap_are_constant():
    beta = 0.25
    b = 3 * math.pi * 3e-3 / math.sin(beta)
    gears = [CylindricalGear(z=30, m_n=3e-3, beta=s * beta, b=b) for s in (1, -1)]
    pair = GearPair.from_profile_shifts(*gears)
    assert pair.eps_beta == pytest.approx(3.0, rel=1e-12)
    assert pair.l_min == pytest.approx(pair.eps_alpha * b / math.cos(pair.gear1.beta_b), rel=1e-9)


def test_sliding_vanishes_at_the_pitch_point_and_is_infinite_at_the_base_circle():
    pair = GearPair(CylindricalGear(z=20, m_n=3e-3), CylindricalGear(z=40, m_n=3e-3), 0.09)
    assert specific_sliding_at(pair, pair.T1C) == (pytest.approx(0.0, abs=1e-12),) * 2
    assert sliding_factor_at(pair, pair.T1C) == 0.0
    assert specific_sliding_at(pair, 0.0)[0] == -math.inf
    assert specific_sliding_at(pair, pair.T1T2)[1] == -math.inf


def test_loss_factor_formula_refuses_a_pitch_point_outside_the_path():
    pinion = CylindricalGear(z=20, m_n=3e-3, x=1.2, tip_diameter=0.0690)
    pair = GearPair(pinion, CylindricalGear(z=40, m_n=3e-3, x=-1.2), 0.09)
    assert pair.T1A > pair.T1C
    with pytest.raises(GeometryError, match="pitch point"):
        loss_factor_ohlendorf(pair)
    assert loss_factor_integral(pair) > 0.0


def test_loss_factor_of_gears_that_do_not_touch_is_zero():
    assert loss_factor_integral(GearPair(G50, G50, 0.157)) == 0.0


def helical(beta, **others):
    return CylindricalGear(z=50, m_n=3e-3, beta=beta, **others)


SMALL = CylindricalGear(z=9, m_n=3e-3)
IMPOSSIBLE = {
    "base circles": (GearPair(G50, G50, 0.140), "center_distance", "no common tangent"),
    "tips apart": (GearPair(G50, G50, 0.160), "center_distance", "tips apart"),
    "internal tips apart": (
        GearPair.at_distance(CylindricalGear(z=20, m_n=3e-3), RING, 0.067),
        "center_distance",
        "no common tangent",
    ),
    "tip in root": (GearPair(G50, G50, 0.1491), "center_distance", "tip clearance"),
    "interference": (GearPair.from_profile_shifts(SMALL, G50), "gears", "interferes with the root of g1"),
    "tips cut each other": (
        GearPair.from_profile_shifts(
            CylindricalGear(z=60, m_n=3e-3, x=0.0), CylindricalGear.internal(z=63, m_n=3e-3, x=0.0)
        ),
        "gears",
        "cut each other",
    ),
    "equal hands": (GearPair(helical(0.2), helical(0.2), 0.154), "gears", "hands that do not fit"),
    "opposite hands inside": (
        GearPair(helical(0.2), CylindricalGear.internal(z=90, m_n=3e-3, beta=-0.2), -0.0615),
        "gears",
        "hands that do not fit",
    ),
    "helix against spur": (GearPair(helical(0.2), G50, 0.152), "gears", "unequal helix angles"),
    "modules": (GearPair(G50, CylindricalGear(z=50, m_n=2e-3), 0.15), "gears", "unequal normal modules"),
    "pressure angles": (GearPair(G50, G50.replace(alpha_n=0.4), 0.15), "gears", "unequal normal pressure"),
    "ring too small": (GearPair(G50, CylindricalGear.internal(z=45, m_n=3e-3), -0.01), "gears", "not larger"),
    "ring as large": (GearPair(G50, CylindricalGear.internal(z=50, m_n=3e-3), -0.01), "gears", "not larger"),
    "two rings": (GearPair(RING, RING, -0.1), "gears", "both internal"),
    "ring first": (GearPair(RING, G50, -0.03), "gears", "as gear 1"),
}


@pytest.mark.parametrize("case", IMPOSSIBLE)
def test_impossible_pairs_say_why(case):
    pair, key, word = IMPOSSIBLE[case]
    problems = pair.problems("meshes.stage", ("g1", "g2"))
    matching = [p for p in problems if p.where == f"meshes.stage.{key}" and word in p.text]
    assert matching, [str(p) for p in problems]
    assert matching[0].value and matching[0].limit and matching[0].remedy
    assert pair.warnings() == []


def test_problems_of_the_gears_can_be_left_to_them():
    pointed = CylindricalGear(z=20, m_n=3e-3, x=1.4)
    pair = GearPair.from_profile_shifts(pointed, G50)
    assert [p.where for p in pair.problems()] == ["gear 1.profile_shift_coefficient"]
    assert pair.problems(gears=False) == []


def test_numbers_without_meaning_raise_instead_of_lying():
    with pytest.raises(GeometryError):
        GearPair(G50, G50, 0.14).alpha_wt  # noqa: B018
    with pytest.raises(GeometryError):
        GearPair(G50, CylindricalGear.internal(z=50, m_n=3e-3), -0.01).j_bt  # noqa: B018


def test_undercut_shortens_what_the_involutes_cover():
    """Catalogue gears, 14 and 60 teeth unshifted: they run, with less contact than their tips promise."""
    pair = GearPair.from_profile_shifts(CylindricalGear(z=14, m_n=3e-3), CylindricalGear(z=60, m_n=3e-3))
    assert pair.gear1.undercut and pair.T1A < 0.0
    assert pair.problems() == []
    assert pair.eps_alpha_form == pytest.approx(1.4587, abs=1e-4)
    assert pair.eps_alpha == pytest.approx(1.6237, abs=1e-4)
    assert ["contact ratio left is 1.459" in str(p) for p in pair.warnings()] == [True]


def test_a_contact_ratio_below_one_is_told():
    """Two spur gears 20/20 of module 3 mm pulled apart to 65.9 mm: the tips hardly overlap."""
    gear = CylindricalGear(z=20, m_n=3e-3, b=0.02)
    (told,) = GearPair(gear, gear, a_w=65.9e-3).warnings()
    assert told.text == "leaves moments without a tooth pair in contact"
    assert told.value == "total contact ratio 0.02177"
    assert GearPair(gear, gear, a_w=60e-3).warnings() == []
    helical = CylindricalGear(z=20, m_n=3e-3, beta=0.3, b=0.05)
    mate = CylindricalGear(z=20, m_n=3e-3, beta=-0.3, b=0.05)
    assert GearPair(helical, mate, a_w=65.9e-3).warnings() == []  # the overlap carries on
