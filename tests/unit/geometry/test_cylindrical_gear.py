# SPDX-License-Identifier: Apache-2.0
"""One gear: defining data, derived quantities, what is refused and what is listed as a problem."""

from __future__ import annotations

import math

import pytest

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry import BasicRack, CylindricalGear, tip_thickness
from pitchpoint.geometry.cutter import PinionCutter
from pitchpoint.geometry.tooth_form import tooth_form


@pytest.mark.parametrize(
    "wrong",
    [
        {"z": 0},
        {"z": 20.5},
        {"z": True},
        {"m_n": 0.0},
        {"m_n": -1e-3},
        {"m_n": math.nan},
        {"m_n": True},
        {"alpha_n": 0.0},
        {"alpha_n": math.pi / 2},
        {"beta": math.pi / 2},
        {"beta": -math.pi / 2},
        {"x": math.inf},
        {"b": 0.0},
        {"tip_diameter": -0.06},
        {"tip_diameter": math.nan},
        {"tip_alteration": math.nan},
        {"thickness_allowance": math.inf},
        {"root_diameter": 0.0},
    ],
)
def test_meaningless_numbers_are_refused(wrong):
    with pytest.raises(GeometryError) as caught:
        CylindricalGear(**{"z": 20, "m_n": 3e-3, **wrong})
    assert caught.value.problem.where and caught.value.problem.value


@pytest.mark.parametrize(
    "wrong", [{"h_aP_star": 0.0}, {"h_fP_star": math.nan}, {"rho_fP_star": -0.1}, {"rho_fP_star": 2.0}]
)
def test_meaningless_racks_are_refused(wrong):
    with pytest.raises(GeometryError, match=r"rack\."):
        BasicRack(**wrong)


def test_hand_follows_the_sign_of_the_helix_angle():
    hands = [CylindricalGear(z=20, m_n=1e-3, beta=b).hand for b in (0.2, -0.2, 0.0)]
    assert hands == ["right", "left", "spur"]


def test_lead_of_a_spur_gear_is_infinite():
    assert CylindricalGear(z=20, m_n=1e-3).p_z == math.inf


def test_tip_diameter_wins_over_the_alteration():
    gear = CylindricalGear(z=20, m_n=3e-3, tip_alteration=-1e-3)
    assert gear.d_a == pytest.approx(64e-3)
    assert gear.replace(tip_diameter=65e-3).d_a == 65e-3


def test_tip_alteration_shortens_internal_teeth_too():
    ring = CylindricalGear.internal(z=60, m_n=3e-3, tip_alteration=-0.5e-3)
    assert ring.d_a == pytest.approx(-(180e-3 - 6e-3 + 1e-3))
    assert ring.d_Fa == ring.d_a


def test_internal_takes_positive_arguments():
    ring = CylindricalGear.internal(z=60, m_n=3e-3, tip_diameter=0.175, root_diameter=0.188, x=0.1)
    assert (ring.z, ring.d_a, ring.d_f, ring.x, ring.is_internal) == (-60, -0.175, -0.188, 0.1, True)


def test_thickness_allowance_acts_normal_to_the_tooth_at_the_reference_circle():
    gear = CylindricalGear(z=30, m_n=4e-3, beta=0.3)
    thin = gear.replace(thickness_allowance=-1e-4)
    assert thin.s_n - gear.s_n == pytest.approx(-1e-4, rel=1e-9)
    assert thin.d_f == gear.d_f
    assert thin.d_fE - gear.d_fE == pytest.approx(-1e-4 / math.tan(gear.alpha_n), rel=1e-9)
    assert thin.x_E - thin.x == pytest.approx(-1e-4 / (2 * 4e-3 * math.tan(gear.alpha_n)), rel=1e-12)


def test_undercut_begins_at_x_min():
    gear = CylindricalGear(z=12, m_n=2e-3, beta=0.2)
    assert gear.x_min > 0.0
    assert gear.replace(x=gear.x_min - 1e-6).undercut
    assert not gear.replace(x=gear.x_min + 1e-6).undercut


@pytest.mark.parametrize("z", [7, 9, 12, 15])
@pytest.mark.parametrize("beta", [0.0, 0.4])
@pytest.mark.parametrize("rho", [0.0, 0.25, 0.38])
def test_undercut_gears_end_where_the_drawn_tooth_does(z, beta, rho):
    """The root form diameter against the trochoid of the tooth form, an independent implementation."""
    gear = CylindricalGear(z=z, m_n=2e-3, beta=beta, rack=BasicRack(rho_fP_star=rho))
    assert gear.undercut or beta > 0.0
    assert gear.d_Ff == pytest.approx(2.0 * tooth_form(gear).r_Ff, rel=1e-9)
    assert gear.d_b <= gear.d_Ff < gear.d_a


@pytest.mark.parametrize(
    "cutter", [None, PinionCutter(z_0=20), PinionCutter(z_0=31, x_0=0.2, rho_aP0_star=0.2)]
)
@pytest.mark.parametrize("beta", [0.0, -0.25])
def test_internal_gears_end_where_the_drawn_tooth_does(cutter, beta):
    gear = CylindricalGear.internal(z=70, m_n=2e-3, beta=beta, x=-0.2, cutter=cutter)
    assert -gear.d_Ff == pytest.approx(2.0 * tooth_form(gear).r_Ff, rel=1e-9)
    assert gear.d_f < gear.d_Ff < gear.d_a < 0.0


def test_a_given_root_diameter_moves_the_form_diameter():
    gear = CylindricalGear(z=30, m_n=2e-3)
    deeper = gear.replace(root_diameter=gear.d_f - 1e-3)
    assert deeper.h_fP_star == pytest.approx(1.5)
    assert deeper.d_Ff == pytest.approx(gear.replace(rack=BasicRack(h_fP_star=1.5)).d_Ff, rel=1e-14)


def test_a_cutter_decides_the_root_of_an_internal_gear():
    ring = CylindricalGear.internal(z=70, m_n=2e-3, cutter=PinionCutter(z_0=20, h_aP0_star=1.25))
    assert ring.d_f == pytest.approx(-(140e-3 + 2 * 1.25 * 2e-3), rel=1e-12)
    assert ring.replace(root_diameter=-0.1446).d_f == -0.1446
    with pytest.raises(GeometryError, match="too many"):
        ring.replace(cutter=PinionCutter(z_0=70)).d_Ff  # noqa: B018


def test_a_fillet_that_does_not_fit_becomes_the_full_rounding():
    rack = BasicRack(rho_fP_star=1.0)
    full = BasicRack(rho_fP_star=rack.rho_fP_star_max(math.radians(20.0)))
    gear = CylindricalGear(z=40, m_n=2e-3, rack=rack)
    assert gear.d_Ff == pytest.approx(gear.replace(rack=full).d_Ff, rel=1e-12)


@pytest.mark.parametrize(
    ("gear", "key", "word"),
    [
        (CylindricalGear(z=20, m_n=3e-3, x=1.4), "profile_shift_coefficient", "tip thickness"),
        (CylindricalGear(z=20, m_n=3e-3, x=-3.0), "profile_shift_coefficient", "no tooth"),
        (CylindricalGear(z=20, m_n=3e-3, x=3.0), "profile_shift_coefficient", "no space"),
        (CylindricalGear(z=2, m_n=3e-3), "root_diameter", "gear body"),
        (CylindricalGear(z=6, m_n=3e-3, tip_diameter=0.0172), "number_of_teeth", "no involute"),
        (CylindricalGear(z=20, m_n=3e-3, tip_diameter=0.05), "tip_diameter", "tooth height"),
        (CylindricalGear(z=20, m_n=3e-3, tip_diameter=0.056), "tip_diameter", "inside the base circle"),
        (CylindricalGear.internal(z=20, m_n=3e-3), "tip_diameter", "inside the base circle"),
        (
            CylindricalGear(z=20, m_n=3e-3, rack=BasicRack(h_fP_star=2.5)),
            "rack.dedendum",
            "point of the tool",
        ),
        (CylindricalGear(z=25, m_n=3e-3, tip_diameter=0.088), "profile_shift_coefficient", "tip thickness"),
    ],
)
def test_impossible_gears_say_why(gear, key, word):
    problem = gear.problems("gears.g1")[0]
    assert problem.where == f"gears.g1.{key}"
    assert word in problem.text
    assert problem.value and problem.limit and problem.remedy


def test_the_remedy_for_a_pointed_tooth_works():
    gear = CylindricalGear(z=20, m_n=3e-3, x=1.4)
    remedy = gear.problems()[0].remedy
    largest = float(remedy.split("use at most ")[1].split()[0])
    assert not gear.replace(x=largest).problems()
    assert tip_thickness(gear.replace(x=largest + 0.01)) < 0.2 * gear.m_n


def test_good_gears_have_no_problems():
    assert not CylindricalGear(z=20, m_n=3e-3).problems()
    assert not CylindricalGear.internal(z=60, m_n=3e-3).problems()
