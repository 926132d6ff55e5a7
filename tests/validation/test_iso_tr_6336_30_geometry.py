# SPDX-License-Identifier: Apache-2.0
"""ISO-EX1 and CONV: geometry and backlash of example 1 of ISO/TR 6336-30 (case-carburised helical pair).

Inputs as in the report: z 17/103, m_n 8 mm, 20 deg, 15.8 deg with a left-hand pinion, b 100 mm, a 500 mm, x1
0.145 (0.14522 from the centre distance), x2 0, tip diameters 159.66/872.35 mm, basic rack 1.0/1.4/0.39. The
expected numbers are the report's, carried to six decimals by independent code; tolerance half a unit of the
last digit. The backlash (CONV) is a closed form of the same data.
"""

from __future__ import annotations

import math

import pytest

from pitchpoint.geometry import BasicRack, CylindricalGear, GearPair
from tests.support.printed import printed

RACK = BasicRack(h_aP_star=1.0, h_fP_star=1.4, rho_fP_star=0.39)


@pytest.fixture
def pair():
    common = {"m_n": 8e-3, "alpha_n": math.radians(20.0), "b": 0.1, "rack": RACK}
    beta = math.radians(15.8)
    pinion = CylindricalGear(z=17, beta=-beta, x=0.145, tip_diameter=0.15966, **common)
    wheel = CylindricalGear(z=103, beta=beta, x=0.0, tip_diameter=0.87235, **common)
    return GearPair(pinion, wheel, 0.5)


def test_angles(pair):
    assert math.degrees(pair.gear1.alpha_t) == printed("20.719712")
    assert math.degrees(pair.alpha_wt) == printed("21.066100")
    assert math.degrees(pair.gear2.beta_b) == printed("14.824535")
    assert math.degrees(pair.gear1.beta_b) == printed("-14.824535")


def test_diameters(pair):
    g1, g2 = pair.gear1, pair.gear2
    for value, text in (
        (g1.d, "141.340113"),
        (g2.d, "856.354803"),
        (g1.d_b, "132.198569"),
        (g2.d_b, "800.967802"),
        (pair.d_w1, "141.666667"),
        (pair.d_w2, "858.333333"),
        (pair.d_Nf1, "132.92069"),
        (pair.d_Nf2, "845.22524"),
    ):
        assert value * 1e3 == printed(text)


def test_path_of_contact(pair):
    assert pair.p_et * 1e3 == printed("24.430238")
    assert pair.g_alpha * 1e3 == printed("37.844640")
    assert pair.eps_alpha == printed("1.549090")
    assert pair.eps_beta == printed("1.083369")
    assert pair.T1T2 * 1e3 == printed("179.722372")
    assert pair.eps_gamma == pair.eps_alpha + pair.eps_beta


def test_profile_shift_and_virtual_teeth(pair):
    assert pair.x_sum == printed("0.14522")
    assert pair.x_sum_given == 0.145
    assert pair.gear1.z_n == printed("18.9051")
    assert pair.gear2.z_n == printed("114.5428")


def test_pair_has_no_problems(pair):
    assert pair.problems() == [] and pair.warnings() == []


def test_backlash_at_the_actual_centre_distance(pair):
    """CONV: j_bt from the given x; 1e-6 of the printed numbers, which is their last digit."""
    assert pair.j_bt * 1e6 == printed("1.25722")
    apart = pair.backlash(0.5001)
    assert apart.j_bt * 1e6 == printed("73.1946")
    assert apart.j_wt * 1e6 == printed("78.4525")
    assert apart.j_bn * 1e6 == printed("70.7582")
    moved = pair.at_center_distance(0.5001)
    assert (moved.j_bt, moved.j_wt, moved.j_bn) == apart


def test_backlash_grows_with_twice_the_sine_of_the_working_pressure_angle(pair):
    h = 1e-6
    slope = (pair.backlash(0.5 + h).j_bt - pair.backlash(0.5 - h).j_bt) / (2.0 * h)
    assert slope == pytest.approx(2.0 * math.sin(pair.alpha_wt), rel=1e-8)
