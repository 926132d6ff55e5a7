# SPDX-License-Identifier: Apache-2.0
"""ISO-EX1, KS-NRELGBX, S1 and the MS-TVMS comparison: single and mesh stiffness by DIN 3990 / ISO 6336-1.

Sources: ISO/TR 6336-30 example 1 (c'_th 17.85584, c' 12.37047, c_gamma_alpha 17.46485, c_gamma_beta 14.84512
N/(mm um)); KISSsoft 03/2017 reports of the 5 MW reference gearbox, method B; S1's camshaft pair. Geometry of
ISO-EX1: tip diameters of the 2022 edition, rack 1.4/0.39, x1 as printed (0.145). Tolerance 1e-6 where the
source has the digits, half of the last printed digit else. Here in N/m^2 = 1e-9 N/(mm um).
"""

from __future__ import annotations

from math import inf, radians

import pytest

from pitchpoint.contact.stiffness.din3990 import (
    blank_factor,
    din3990,
    single_stiffness,
    theoretical_stiffness,
    virtual_teeth,
)
from pitchpoint.core.errors import ModelError, ValidityWarning
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.geometry.rack import BasicRack

RACK = BasicRack(h_fP_star=1.4, rho_fP_star=0.39)


def iso_example_1() -> GearPair:
    pinion = CylindricalGear(
        z=17, m_n=8e-3, beta=-radians(15.8), x=0.145, b=0.1, tip_diameter=0.15966, rack=RACK
    )
    wheel = CylindricalGear(z=103, m_n=8e-3, beta=radians(15.8), b=0.1, tip_diameter=0.87235, rack=RACK)
    return GearPair(pinion, wheel, 0.5)


def stage_3() -> GearPair:
    pinion = CylindricalGear(z=24, m_n=14e-3, beta=radians(10), x=0.48, b=0.36, tip_diameter=0.380747)
    wheel = CylindricalGear(z=95, m_n=14e-3, beta=-radians(10), x=0.6691, b=0.36, tip_diameter=1.395376)
    return GearPair(pinion, wheel, 0.861)


def stage_1() -> tuple[GearPair, GearPair]:
    sun = CylindricalGear(z=19, m_n=45e-3, x=0.617, b=0.491, tip_alteration=-10.861e-3)
    planet = CylindricalGear(z=17, m_n=45e-3, x=0.8021, b=0.491, tip_alteration=-10.861e-3)
    ring = CylindricalGear.internal(z=56, m_n=45e-3, x=-0.5013, b=0.491, rack=BasicRack(rho_fP_star=0.30))
    return GearPair(sun, planet, 0.863), GearPair.at_distance(planet, ring, 0.863)


def test_iso_example_1():
    pair = iso_example_1()
    found = single_stiffness(pair)
    assert found.z_n1 == pytest.approx(18.9051, abs=5e-5)
    assert found.z_n2 == pytest.approx(114.5428, abs=5e-4)
    assert found.C_B == pytest.approx(0.9, abs=1e-12)
    assert (found.C_M, found.C_R, found.modulus_ratio) == (0.8, 1.0, 1.0)
    assert found.c_th / 1e9 == pytest.approx(17.855840, rel=1e-6)
    assert found.c_prime / 1e9 == pytest.approx(12.370472, rel=1e-6)
    assert found.c_gamma_alpha / 1e9 == pytest.approx(17.464850, rel=1e-6)
    assert found.c_gamma_beta / 1e9 == pytest.approx(14.845122, rel=1e-6)
    assert found.c_gamma_alpha * pair.b_w == pytest.approx(1.746485e9, rel=1e-6)


def test_given_root_diameters_make_the_dedendum_of_the_rack():
    """The same gears with the usual rack, but with the root diameters that the dedendum 1.4 makes."""
    pair = iso_example_1()
    gears = (g.replace(rack=BasicRack(), root_diameter=g.d_f) for g in (pair.gear1, pair.gear2))
    found = single_stiffness(GearPair(*gears, 0.5))
    assert found.C_B == pytest.approx(0.9, abs=1e-12)
    assert found.c_prime / 1e9 == pytest.approx(12.370472, rel=1e-6)


def test_seed_rule_for_virtual_teeth():
    found = single_stiffness(iso_example_1(), virtual_teeth_formula="cos3")
    assert found.c_th / 1e9 == pytest.approx(17.88424, rel=1e-6)


def test_order_of_the_gears_does_not_matter():
    pair = iso_example_1()
    swapped = single_stiffness(GearPair(pair.gear2, pair.gear1, 0.5))
    assert swapped.c_prime == single_stiffness(pair).c_prime
    even = GearPair.from_profile_shifts(
        CylindricalGear(z=30, m_n=2e-3, x=0.1), CylindricalGear(z=30, m_n=2e-3)
    )
    odd = GearPair(even.gear2, even.gear1, even.a_w)
    assert single_stiffness(even).c_prime == single_stiffness(odd).c_prime  # and no warning: x1 >= x2


def test_high_speed_stage():
    with pytest.warns(ValidityWarning, match="x₁ = 0.48 "):
        found = single_stiffness(stage_3(), C_R=blank_factor(0.25, 5.0))
    assert found.C_B == pytest.approx(0.975, abs=1e-12)
    assert found.C_R == pytest.approx(0.89800, abs=5e-6)
    assert found.c_prime / 1e9 == pytest.approx(13.8318, abs=5e-5)
    # tip diameters are printed to 1 um, which leaves 2e-4 here
    assert found.c_gamma_alpha / 1e9 == pytest.approx(18.6320, abs=2e-4)
    assert found.c_gamma_beta / 1e9 == pytest.approx(15.8372, abs=2e-4)


def test_planet_stage():
    """The planet (17) is the smaller gear in both meshes; a ring has 1/z_n2 = 0 and x2 as printed."""
    sun_planet, planet_ring = stage_1()
    C_R = blank_factor(0.25, 3.5)
    assert C_R == pytest.approx(0.8623, abs=5e-5)
    outer = single_stiffness(sun_planet, C_R=C_R)
    inner = single_stiffness(planet_ring, C_R=C_R)
    assert virtual_teeth(planet_ring.gear2) == inf
    assert outer.c_prime / 1e9 == pytest.approx(12.362, abs=5e-4)
    assert inner.c_prime / 1e9 == pytest.approx(13.2890, abs=5e-5)
    assert outer.c_gamma_alpha / 1e9 == pytest.approx(13.426, abs=1e-3)
    assert inner.c_gamma_alpha / 1e9 == pytest.approx(16.063, abs=1e-3)


def test_ring_of_the_second_planet_stage():
    """Stage 2 of the same gearbox: planet z 36, x 0.504; ring x2 = 0.117 as printed; 14.0534."""
    c_th = theoretical_stiffness(36, inf, 0.504, 0.117)
    assert c_th * 0.8 * 0.975 * blank_factor(0.25, 3.5) / 1e9 == pytest.approx(14.0534, abs=1e-4)


def test_camshaft_pair_outside_the_range():
    with pytest.warns(ValidityWarning, match="outside the range"):
        assert theoretical_stiffness(59, 68, -0.626, -0.626) / 1e9 == pytest.approx(15.363, abs=5e-4)


def test_comparison_for_the_energy_method():
    gear = CylindricalGear(z=62, m_n=2e-3, b=0.02)
    found = single_stiffness(GearPair(gear, gear, 0.124))
    assert found.c_prime / 1e9 == pytest.approx(14.4718, abs=5e-5)
    assert found.c_gamma_alpha / 1e9 == pytest.approx(23.0439, abs=5e-5)


def test_other_materials():
    pair = iso_example_1()
    steel = single_stiffness(pair).c_prime
    cast = single_stiffness(pair, moduli=(206e9, 118e9))
    assert cast.modulus_ratio == pytest.approx(2 * 118 / (206 + 118))
    assert cast.c_prime == pytest.approx(steel * cast.modulus_ratio)
    assert single_stiffness(pair, moduli=(206e9, 206e9)).c_prime == pytest.approx(steel, rel=1e-14)


def test_blank_factor_is_clamped():
    assert blank_factor(0.05, 3.0) == blank_factor(0.2, 3.0)
    assert blank_factor(3.0, 3.0) == blank_factor(1.2, 3.0) > 1.0
    assert blank_factor(0.5, 0.2) == blank_factor(0.5, 1.0)
    assert blank_factor(1.0, 2.0) == 1.0


def test_source_function_and_options():
    pair = iso_example_1()
    shape = din3990(pair, S_R=0.7, T_R=0.2)
    assert (shape.S_R, shape.T_R, shape.load_limit) == (0.7, 0.2, 0.0)
    assert shape.c_prime == single_stiffness(pair).c_prime
    own = din3990(pair, c_prime=14e9, low_load=True)
    assert own.c_prime == 14e9
    assert own.load_limit == pytest.approx(1e5 / 0.935324, rel=1e-5)  # cos 20.719712 deg
    with pytest.raises(ModelError, match="virtual_teeth"):
        din3990(pair, virtual_teeth_formula="simple")
    with pytest.raises(ModelError, match="stiffness_ratio"):
        din3990(pair, S_R=1.2)
    with pytest.warns(ValidityWarning), pytest.raises(ModelError, match="law"):
        theoretical_stiffness(8, 8, 3.0, 3.5)
