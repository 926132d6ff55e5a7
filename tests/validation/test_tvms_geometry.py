# SPDX-License-Identifier: Apache-2.0
"""MS-TVMS: spur pair 62/62 of petrobras/ross (test_gear_element.py): contact ratio and base radius.

z 62/62, m 2 mm, 20 deg, standard. The contact ratio is printed to eight decimals.
"""

from __future__ import annotations

from pitchpoint.geometry import CylindricalGear, GearPair
from tests.support.printed import printed


def test_contact_ratio_and_base_radius():
    gear = CylindricalGear(z=62, m_n=2e-3, b=20e-3)
    pair = GearPair(gear, gear, 0.124)
    assert pair.eps_alpha == printed("1.78977987", 1.0)
    assert gear.r_b * 1e3 == printed("58.26094")
