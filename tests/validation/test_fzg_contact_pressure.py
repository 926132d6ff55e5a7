# SPDX-License-Identifier: Apache-2.0
"""EF-FZG: tooth forces and Hertzian pressure along the path of contact of FZG gears type C.

Source: cfernandesFEUP/GEARpie reports. FZG-C: m 4.5 mm, z 16/24, x 0.1817/0.1715, a 91.5 mm, 20 deg, steel
206 GPa, 0.3. C40: b 40 mm, 40 623.2 W at 1800 rpm (printed as 215.5 N m); C14: b 14 mm, 200 N m. The reports
let one pair carry all the load between B and D and half of it outside. Tolerance 1e-5 for forces (six printed
digits), 2e-4 for pressures and widths (their last digit is cut, 885.48 is printed as 885.4).
"""

from __future__ import annotations

import math

import pytest

from pitchpoint.contact.hertz import flank_radius, half_width, peak_pressure, plane_strain_compliance
from pitchpoint.geometry import CylindricalGear, GearPair

PAIR = GearPair(
    CylindricalGear(z=16, m_n=4.5e-3, x=0.1817), CylindricalGear(z=24, m_n=4.5e-3, x=0.1715), 91.5e-3
)
STEEL = plane_strain_compliance(206e9, 0.3)
OMEGA = 1800.0 * math.pi / 30.0
T_C40 = 40623.2 / OMEGA


def contact(torque: float, b: float, T1Y: float, share: float) -> tuple[float, float]:
    """Peak pressure [MPa] and half width [um] at a path coordinate, with a share of the load."""
    line_load = share * torque / PAIR.gear1.r_b / b
    width = float(half_width(line_load, flank_radius(T1Y, PAIR.T1T2, 0.0), STEEL, STEEL))
    return float(peak_pressure(line_load, width)) * 1e-6, width * 1e6


def along_path(torque: float, b: float) -> list[float]:
    """Pressures at the ends of the three ranges, where the extremes lie."""
    ends = [
        (PAIR.T1A, 0.5),
        (PAIR.T1B, 0.5),
        (PAIR.T1B, 1.0),
        (PAIR.T1D, 1.0),
        (PAIR.T1D, 0.5),
        (PAIR.T1E, 0.5),
    ]
    return [contact(torque, b, y, share)[0] for y, share in ends]


def test_forces_and_speed_of_c40():
    F_t = T_C40 / (0.5 * PAIR.d_w1)
    assert F_t == pytest.approx(5888.3, rel=1e-5)
    assert F_t * math.tan(PAIR.alpha_wt) == pytest.approx(2431.7, rel=2e-5)
    assert T_C40 / PAIR.gear1.r_b == pytest.approx(6370.7, rel=1e-5)
    assert 0.5 * PAIR.d_w1 * OMEGA == pytest.approx(6.90, abs=5e-3)
    assert 200.0 / PAIR.gear1.r_b == pytest.approx(5912.1, rel=1e-5)


@pytest.mark.parametrize(
    ("torque", "b", "p_0", "b_H"), [(T_C40, 0.040, 827.4, 122.559), (200.0, 0.014, 1347.3, 199.567)]
)
def test_contact_at_the_pitch_point(torque, b, p_0, b_H):
    assert contact(torque, b, PAIR.T1C, 1.0) == pytest.approx((p_0, b_H), rel=2e-4)


def test_extremes_along_the_path():
    """C14's 1442.5 MPa is 4e-4 more than C40's 885.4 scaled by its own pitch point pressures gives."""
    found = along_path(T_C40, 0.040)
    assert max(found) == pytest.approx(885.4, rel=2e-4)
    assert min(found) == pytest.approx(573.2, rel=2e-4)
    assert max(along_path(200.0, 0.014)) == pytest.approx(1442.5, rel=6e-4)
