# SPDX-License-Identifier: Apache-2.0
"""Mass and inertia of gears against printed values and elementary solids."""

from __future__ import annotations

import math

import pytest

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.mass_properties import gear_mass_properties
from pitchpoint.geometry.rack import BasicRack

RING = BasicRack(rho_fP_star=0.30)

# KISSsoft 03/2017 reports of the 5 MW reference gearbox: bore (ring: outer) diameter, mass, polar inertia.
# They count the toothed part as a cylinder of diameter (d_a + d_f)/2 of 7830 kg/m³; the printed diameters are
# rounded to 0.01 mm, which is 1e-5 of the mass.
REPORT = [
    (
        CylindricalGear(z=19, m_n=45e-3, x=0.6170, b=0.491, tip_diameter=0.978808),
        0.48233,
        1680.788,
        214.70593,
    ),
    (
        CylindricalGear(z=17, m_n=45e-3, x=0.8021, b=0.491, tip_diameter=0.905470),
        0.40899,
        1500.937,
        156.02820,
    ),
    (CylindricalGear(z=-56, m_n=45e-3, x=-0.5013, b=0.491, rack=RING), 2.99424, 7028.746, 13708.8116),
]
HELICAL = {"m_n": 14e-3, "beta": math.radians(10.0), "b": 0.36}
REPORT_3 = [
    (CylindricalGear(z=24, x=0.4800, tip_diameter=0.380747, **HELICAL), 0.17910, 3.87681),
    (CylindricalGear(z=95, x=0.6691, tip_diameter=1.395376, **HELICAL), 1.19332, 399.02862),
]


@pytest.mark.parametrize(("gear", "bore", "mass", "inertia"), REPORT, ids=["sun", "planet", "ring"])
def test_printed_masses_of_stage_1(gear: CylindricalGear, bore: float, mass: float, inertia: float) -> None:
    rule = gear_mass_properties(gear, 7830.0, bore_diameter=bore, profile="mean_cylinder")
    assert rule.mass == pytest.approx(mass, rel=1e-5)
    assert rule.polar_inertia == pytest.approx(inertia, rel=1e-5)
    exact = gear_mass_properties(gear, 7830.0, bore_diameter=bore)
    assert 1.01 < exact.mass / mass < 1.03


@pytest.mark.parametrize(("gear", "bore", "inertia"), REPORT_3, ids=["pinion", "wheel"])
def test_printed_inertias_of_stage_3(gear: CylindricalGear, bore: float, inertia: float) -> None:
    rule = gear_mass_properties(gear, 7830.0, bore_diameter=bore, profile="mean_cylinder")
    assert rule.polar_inertia == pytest.approx(inertia, rel=1e-5)
    exact = gear_mass_properties(gear, 7830.0, bore_diameter=bore)
    assert 1.01 < exact.polar_inertia / inertia < 1.05


def test_printed_mass_of_the_energy_method_pair() -> None:
    """MS-TVMS: z 62, m 2 mm, b 20 mm, bore 35 mm, 7810 kg/m³; a cylinder of the reference diameter."""
    gear = CylindricalGear(z=62, m_n=2e-3, b=0.02)
    rule = gear_mass_properties(gear, 7810.0, bore_diameter=0.035, profile="reference_cylinder")
    assert rule.mass == pytest.approx(1.736033, rel=5e-7)
    assert rule.polar_inertia == pytest.approx(3.602486e-3, rel=5e-7)
    assert rule.transverse_inertia == pytest.approx(1.859111e-3, rel=5e-7)
    exact = gear_mass_properties(gear, 7810.0, bore_diameter=0.035)
    assert exact.mass == pytest.approx(rule.mass, rel=5e-3)


def test_rim_and_web_are_rings() -> None:
    gear = CylindricalGear(z=60, m_n=2e-3, b=0.03)
    blank = {"bore_diameter": 0.02, "rim_thickness": 0.008, "web_thickness": 0.01}
    thin, solid = (gear_mass_properties(gear, 7800.0, **k) for k in (blank, {"bore_diameter": 0.02}))
    r_rim, r_bore, gap = 0.5 * gear.d_f - 0.008, 0.01, 0.02
    mass = 7800.0 * math.pi * (r_rim**2 - r_bore**2) * gap
    polar = 7800.0 * 0.5 * math.pi * (r_rim**4 - r_bore**4) * gap
    axial = 7800.0 * math.pi * (r_rim**2 - r_bore**2) * (0.03**3 - 0.01**3) / 12.0
    assert solid.mass - thin.mass == pytest.approx(mass, rel=1e-12)
    assert solid.polar_inertia - thin.polar_inertia == pytest.approx(polar, rel=1e-12)
    assert solid.transverse_inertia - thin.transverse_inertia == pytest.approx(0.5 * polar + axial, rel=1e-12)


def test_given_values_win() -> None:
    gear = CylindricalGear(z=20, m_n=1e-3)
    computed = gear_mass_properties(gear, 7800.0)
    mixed = gear_mass_properties(gear, 7800.0, mass=3.0, transverse_inertia=0.5)
    assert (mixed.mass, mixed.transverse_inertia) == (3.0, 0.5)
    assert mixed.polar_inertia == computed.polar_inertia


@pytest.mark.parametrize(
    ("values", "where"),
    [
        ({"bore_diameter": 0.05}, "bore_diameter"),
        ({"web_thickness": 0.01}, "web_thickness"),
        ({"rim_thickness": -0.01}, "rim_thickness"),
        ({"mass": math.nan}, "mass"),
        ({"profile": "disc"}, "profile"),
    ],
)
def test_impossible_blanks_are_refused(values: dict[str, object], where: str) -> None:
    with pytest.raises(GeometryError) as caught:
        gear_mass_properties(CylindricalGear(z=20, m_n=1e-3), 7800.0, **values)  # type: ignore[arg-type]
    assert caught.value.problem.where == where


def test_ring_needs_an_outer_diameter_outside_its_root() -> None:
    ring = CylindricalGear(z=-60, m_n=1e-3)
    with pytest.raises(GeometryError, match="bore_diameter"):
        gear_mass_properties(ring, 7800.0, bore_diameter=0.06)
    by_rim = gear_mass_properties(ring, 7800.0, rim_thickness=4e-3)
    by_outer = gear_mass_properties(ring, 7800.0, bore_diameter=abs(ring.d_fE) + 8e-3)
    assert by_rim.mass == pytest.approx(by_outer.mass, rel=1e-13)
