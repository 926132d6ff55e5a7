# SPDX-License-Identifier: Apache-2.0
"""GE-KHK: worked pairs of the KHK / SDP-SI reference tables, as quoted in bolsover/UtilitiesForAlibre.

Signs: KHK counts the profile shift of an internal gear opposite to ISO 21771, so its x2 = +0.5 is our -0.5.
Tips: for external pairs KHK shortens both teeth by k m_n with k = y - (x1 + x2), y the centre distance
increment; we give that as `tip_alteration`. KHK cuts some numbers instead of rounding them; those are
compared to one unit of the last digit.
"""

from __future__ import annotations

import math

import pytest

from pitchpoint.geometry import CylindricalGear, GearPair, inv, profile_shift_for_center_distance
from tests.support.printed import printed


@pytest.fixture
def spur():
    y = (56.4999e-3 - 54e-3) / 3e-3
    shortened = {"m_n": 3e-3, "tip_alteration": (y - 0.96) * 3e-3}
    gears = CylindricalGear(z=12, x=0.6, **shortened), CylindricalGear(z=24, x=0.36, **shortened)
    return GearPair(*gears, 56.4999e-3)


def test_spur_pair(spur):
    g1, g2 = spur.gear1, spur.gear2
    assert spur.x_sum == printed("0.9600")
    assert (spur.a_w - spur.a_d) / g1.m_n == printed("0.83329", 1.0)
    assert inv(spur.alpha_wt) == printed("0.034316")
    assert math.degrees(spur.alpha_wt) == printed("26.0886")
    assert 0.5e3 * (g1.d_a - g1.d_f) == printed("6.369", 1.0)
    assert (g1.d_b * 1e3, g2.d_b * 1e3) == (printed("33.82893"), printed("67.65787"))
    assert (g1.d_a * 1e3, g2.d_a * 1e3) == (printed("44.8398", 1.0), printed("79.3998", 1.0))
    assert (spur.d_w1 * 1e3, spur.d_w2 * 1e3) == (printed("37.6666"), printed("75.3332"))
    assert spur.eps_alpha == printed("1.2021")
    assert not spur.problems()


def test_backlash_as_change_of_the_profile_shift_sum(spur):
    """0.1 mm circumferential backlash is worth -0.0437 (cut, not rounded) in the sum of the shifts."""
    per_shift = spur.gear1.replace(x=0.6 - 0.0437)
    pair = GearPair(per_shift, spur.gear2, spur.a_w)
    change = -0.1e-3 / (pair.j_wt - spur.j_wt) * 0.0437
    assert change == printed("-0.0437", 1.0)


def test_internal_spur_pair():
    pinion = CylindricalGear(z=16, m_n=3e-3)
    ring = CylindricalGear.internal(z=24, m_n=3e-3, x=-0.5)
    pair = GearPair.at_distance(pinion, ring, 13.1683e-3)
    assert pair.a_d == pytest.approx(-12e-3, rel=1e-14)
    assert (pair.a_w - pair.a_d) / 3e-3 == printed("-0.38943", 1.0)
    assert inv(pair.alpha_wt) == printed("0.060401", 2.0)  # from a' printed to 0.1 um: 1.2e-6
    assert math.degrees(pair.alpha_wt) == printed("31.0938", 2.0)
    assert pair.x_sum == printed("-0.50002")
    assert (pinion.d_a * 1e3, ring.d_a * 1e3) == (pytest.approx(54.0), pytest.approx(-69.0))
    assert (pinion.d_f * 1e3, ring.d_f * 1e3) == (pytest.approx(46.5 - 6.0), pytest.approx(-82.5))
    assert (pair.d_w1 * 1e3, pair.d_w2 * 1e3) == (printed("52.673"), printed("-79.010"))
    assert pair.eps_alpha == printed("1.6795")
    assert not pair.problems()


def test_internal_contact_ratio_holds_for_the_tip_circles_only():
    """The pinion is undercut by its rack, which KHK's 1.6795 leaves out; 1.645 is what the involutes do."""
    ring = CylindricalGear.internal(z=24, m_n=3e-3, x=-0.5)
    pair = GearPair.at_distance(CylindricalGear(z=16, m_n=3e-3), ring, 13.1683e-3)
    assert pair.gear1.undercut and pair.gear1.x_min > 0.0
    assert pair.eps_alpha_form == pytest.approx(1.6452, abs=1e-4)
    assert len(pair.warnings()) == 1 and "undercut" in pair.warnings()[0].text


def test_helical_pair_of_the_calculation_sheet():
    """ISO 21771 sheet, 9 digits: m_n 3.5, z 31/30, 21 deg, a 116.5 mm."""
    beta = math.radians(21.0)
    pair = GearPair(
        CylindricalGear(z=31, m_n=3.5e-3, beta=beta), CylindricalGear(z=30, m_n=3.5e-3, beta=-beta), 0.1165
    )
    assert pair.a_d * 1e3 == printed("114.344728")
    assert math.degrees(pair.gear1.alpha_t) == printed("21.2990643")
    assert math.degrees(pair.alpha_wt) == printed("23.8707610")
    assert inv(pair.alpha_wt) == printed("0.0259052382")
    assert inv(pair.gear1.alpha_t) == printed("0.0181260949")
    assert pair.x_sum == printed("0.6518771")
    x_sum = profile_shift_for_center_distance(
        z_sum=61, m_n=3.5e-3, alpha_n=math.radians(20.0), beta=beta, a_w=0.1165
    )
    assert x_sum == pytest.approx(pair.x_sum, rel=1e-14)
