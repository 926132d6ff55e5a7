# SPDX-License-Identifier: Apache-2.0
"""EF-FZG: FZG test gears, geometry and tooth loss factor (cfernandesFEUP/GEARpie reports and library).

FZG-C: m 4.5 mm, z 16/24, x 0.1817/0.1715, a 91.5 mm, 20 deg; S30: m 2 mm, z 30/30, a 60 mm. Printed digits
are the tolerance. H_V by Ohlendorf's formula is printed as 0.1986 and 0.1494 and was carried to six digits
by independent code, for type C at the centre distance without backlash (91.50008 mm); at 91.5 mm it is 2e-6
more. The direct integral must give the same (identity). The reports also print an integrated value, 0.1984;
how they integrate is not stated, so nothing is compared with it.
"""

from __future__ import annotations

import pytest

from pitchpoint.geometry import CylindricalGear, GearPair, loss_factor_integral, loss_factor_ohlendorf
from tests.support.printed import printed


@pytest.fixture
def type_c():
    gears = CylindricalGear(z=16, m_n=4.5e-3, x=0.1817), CylindricalGear(z=24, m_n=4.5e-3, x=0.1715)
    return GearPair(*gears, 91.5e-3)


def test_radii_of_type_c(type_c):
    g1, g2 = type_c.gear1, type_c.gear2
    for diameter, text in (
        (g1.d_f, "31.193"),
        (g2.d_f, "49.147"),
        (g1.d_b, "33.829"),
        (g2.d_b, "50.743"),
        (type_c.d_w1, "36.6"),
        (type_c.d_w2, "54.9"),
        (g1.d_a, "41.318"),
        (g2.d_a, "59.272"),
    ):
        assert 0.5e3 * diameter == printed(text)


def test_path_of_type_c(type_c):
    assert type_c.p_et * 1e3 == printed("13.285")
    assert type_c.eps_alpha == printed("1.46")
    assert type_c.T1T2 * 1e3 == printed("34.93")
    start = type_c.T1A
    for point, text in (
        (type_c.T1B, "6.14"),
        (type_c.T1C, "9.68"),
        (type_c.T1D, "13.28"),  # one base pitch, 13.2848: the report cut it
        (type_c.T1E, "19.43"),
    ):
        assert (point - start) * 1e3 == printed(text, 1.0)


def test_loss_factor_of_type_c(type_c):
    tight = GearPair.from_profile_shifts(type_c.gear1, type_c.gear2)
    assert tight.a_w * 1e3 == printed("91.50008")
    assert loss_factor_ohlendorf(tight) == printed("0.198620")
    assert loss_factor_ohlendorf(type_c) == pytest.approx(0.198620, abs=3e-6)
    assert loss_factor_integral(type_c) == pytest.approx(loss_factor_ohlendorf(type_c), rel=1e-12)


def test_loss_factor_of_s30():
    gear = CylindricalGear(z=30, m_n=2e-3)
    pair = GearPair(gear, gear, 60e-3)
    assert pair.eps_alpha == printed("1.65")
    assert loss_factor_ohlendorf(pair) == printed("0.149443", 1.0)
    assert loss_factor_integral(pair) == pytest.approx(loss_factor_ohlendorf(pair), rel=1e-12)
