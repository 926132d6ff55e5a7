# SPDX-License-Identifier: Apache-2.0
"""Critical section of tooth roots: internal gears, ends of the flank, factors and their limits."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.compliance.blank import Blank
from pitchpoint.contact.root_section import helix_factor, rim_factor, rim_ratio, root_section
from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.cutter import PinionCutter
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.rack import BasicRack
from pitchpoint.geometry.tooth_form import tooth_form, virtual_tooth_form

RING = CylindricalGear.internal(z=70, m_n=3e-3, cutter=PinionCutter(z_0=25))


@pytest.mark.parametrize("gear", [CylindricalGear(z=25, m_n=3e-3, x=0.2), RING], ids=["external", "internal"])
def test_the_virtual_gear_of_a_spur_gear_is_the_gear(gear: CylindricalGear) -> None:
    real, virtual = tooth_form(gear), virtual_tooth_form(gear)
    theta = np.linspace(real.fillet.theta_root, real.theta_form, 9)
    assert virtual.z == real.z
    for one, two in zip(real.fillet_polar(theta), virtual.fillet_polar(theta), strict=True):
        assert two == pytest.approx(one, rel=1e-14)


@pytest.mark.parametrize("gear", [CylindricalGear(z=25, m_n=3e-3, x=0.2), RING], ids=["external", "internal"])
def test_a_small_helix_angle_changes_little(gear: CylindricalGear) -> None:
    """Virtual teeth, virtual cutter included: sizes of the section change with β²."""
    sizes = []
    for beta in (0.0, 0.02, -0.02, 0.04):
        section = root_section(gear.replace(beta=beta))
        sizes.append([section.chord, section.fillet_radius, *section.load(0.5 * gear.d_b * 0.35)])
    size, one, other, double = map(np.array, sizes)
    assert other == pytest.approx(one, rel=1e-12)
    assert double - size == pytest.approx(4.0 * (one - size), rel=0.02)
    assert one == pytest.approx(size, rel=2e-3)


def test_a_circular_fillet_has_its_radius() -> None:
    ring = CylindricalGear.internal(z=60, m_n=3e-3, rack=BasicRack(rho_fP_star=0.3))
    assert root_section(ring).fillet_radius == pytest.approx(0.9e-3, rel=1e-5)


@pytest.mark.parametrize("gear", [CylindricalGear(z=25, m_n=3e-3), RING], ids=["external", "internal"])
def test_higher_forces_bend_more(gear: CylindricalGear) -> None:
    """From root to tip the stress increases; beyond the tip it is that of the tip."""
    section, form = root_section(gear), tooth_form(gear)
    low, high = (math.sqrt(max(0.0, r * r - form.r_b**2)) for r in (form.r_Ff, form.r_Fa))
    stress = section.stress(1e5, np.linspace(low, high, 30))
    assert (stress > 0.0).all()
    assert stress[-1] > 2.0 * stress[0]
    beyond = high + math.copysign(1e-3, high - low)
    assert section.stress(1e5, beyond) == pytest.approx(stress[-1], rel=1e-12)


def test_factors_end_at_their_limits() -> None:
    """Y_β stays beyond 30° and ε_β = 1; Y_B begins at 1.2 h_t, and at 3.5 m_n of internal gears."""
    assert helix_factor(math.radians(-40.0), 3.0) == pytest.approx(0.75)
    assert helix_factor(math.radians(20.0), 0.5) == pytest.approx(1.0 - 0.5 / 6.0)
    gear = CylindricalGear(z=40, m_n=2e-3)
    for share, factor in ((1.21, 1.0), (1.19, 1.6 * math.log(2.242 / 1.19)), (0.5, 1.6 * math.log(4.484))):
        blank = Blank(rim_thickness=share * 4.5e-3, web_thickness=5e-3)
        assert rim_ratio(gear, blank) == pytest.approx(share)
        assert rim_factor(gear, blank) == pytest.approx(factor)
    assert rim_factor(gear, Blank(rim_thickness=0.5 * 4.5e-3)) == 1.0  # without a web the gear is solid
    for share, factor in ((3.51, 1.0), (2.0, 1.15 * math.log(4.162))):
        assert rim_factor(RING, Blank(rim_thickness=share * 3e-3)) == pytest.approx(factor)


def test_no_tangent_at_the_angle() -> None:
    sharp = CylindricalGear.internal(z=70, m_n=3e-3, rack=BasicRack(rho_fP_star=0.0))
    with pytest.raises(GeometryError, match="root_fillet_radius: has no tangent at 60° to the centre line"):
        root_section(sharp)
