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

from pitchpoint.geometry import (
    CylindricalGear,
    GearPair,
    loss_factor_integral,
    loss_factor_ohlendorf,
    tip_thickness,
)
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.remarks.collect import odd_shapes
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


def test_type_a_is_thin_at_the_tip_and_can_be_made():
    """ISO 14635-1, type A: x 0.8532/-0.5, tip diameters 88.77/112.5, a 91.5 mm."""
    g1 = CylindricalGear(z=16, m_n=4.5e-3, x=0.8532, b=20e-3, tip_diameter=88.77e-3)
    g2 = CylindricalGear(z=24, m_n=4.5e-3, x=-0.5, b=20e-3, tip_diameter=112.5e-3)
    pair = GearPair(g1, g2, 91.5e-3)
    assert 1e3 * pair.d_w1 == printed("73.2") and 1e3 * pair.d_w2 == printed("109.8")
    assert pair.problems() == []
    assert tip_thickness(g1) / g1.m_n == pytest.approx(0.13, abs=0.01)
    (thin,) = g1.warnings("pinion")
    assert thin.where == "pinion.profile_shift_coefficient" and thin.limit == "0.2 m_n"
    assert "tip thickness of 0.13 m_n" in thin.text
    model = loads_model(
        "gears:\n"
        "  pinion: {number_of_teeth: 16, normal_module: 4.5 mm, face_width: 20 mm,\n"
        "    profile_shift_coefficient: 0.8532, tip_diameter: 88.77 mm}\n"
        "  wheel: {number_of_teeth: 24, normal_module: 4.5 mm, face_width: 20 mm,\n"
        "    profile_shift_coefficient: -0.5, tip_diameter: 112.5 mm}\n"
        "meshes: {stage: {gears: [pinion, wheel], center_distance: 91.5 mm}}\n"
    )
    (told,) = odd_shapes(model)
    assert told.startswith("gears.pinion.tip_diameter: 88.77 mm leaves a tip thickness of 0.13 m_n")
    assert "use at most 8" in told
