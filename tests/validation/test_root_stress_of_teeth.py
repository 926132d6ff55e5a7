# SPDX-License-Identifier: Apache-2.0
"""Stress of the fillet by finite elements against the form and stress correction factors of ISO 6336-3.

Source: ISO 6336-3:2006, 6.2 and 7.2, force at the tip (Y_Fa, Y_Sa): sigma = F_t/(b m) Y_Fa Y_Sa at the 30°
tangent. The factors are those of a bent beam with a fitted notch factor, 5 to 7 % above the maximum stress
of a plane tooth. Tolerance: 8 %.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.tooth_fe.loads import flank_cases
from pitchpoint.contact.tooth_fe.root_stress import stress_cases
from pitchpoint.contact.tooth_fe.section_mesh import Density
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.involute import inv
from tests.support.plane_teeth import FINE, PlaneTooth

TANGENTS = np.radians([25.0, 30.0, 35.0, 40.0, 45.0, 50.0, 60.0])


def factors(gear):
    """Y_Fa and Y_Sa of a spur gear with the tip radius of its rack, lengths in modules."""
    z, x, alpha, rack = gear.z, gear.x, gear.alpha_n, gear.rack
    rho, depth = rack.rho_fP_star, rack.h_fP_star
    E = math.pi / 4.0 - depth * math.tan(alpha) - (1.0 - math.sin(alpha)) * rho / math.cos(alpha)
    G = rho - depth + x
    H = 2.0 / z * (math.pi / 2.0 - E) - math.pi / 3.0
    theta = math.pi / 6.0
    for _ in range(50):
        theta = 2.0 * G / z * math.tan(theta) - H
    s_F = z * math.sin(math.pi / 3.0 - theta) + math.sqrt(3.0) * (G / math.cos(theta) - rho)
    rho_F = rho + 2.0 * G * G / (math.cos(theta) * (z * math.cos(theta) ** 2 - 2.0 * G))
    d_a = gear.d_a / gear.m_n
    alpha_a = math.acos(gear.d_b / gear.d_a)
    gamma = (0.5 * math.pi + 2.0 * x * math.tan(alpha)) / z + inv(alpha) - inv(alpha_a)
    load = alpha_a - gamma
    h_F = 0.5 * (
        (math.cos(gamma) - math.sin(gamma) * math.tan(load)) * d_a
        - z * math.cos(math.pi / 3.0 - theta)
        - (G / math.cos(theta) - rho)
    )
    Y_Fa = 6.0 * h_F * math.cos(load) / (s_F * s_F * math.cos(alpha))
    L, q_s = s_F / h_F, s_F / (2.0 * rho_F)
    return Y_Fa, (1.2 + 0.13 * L) * q_s ** (1.0 / (1.21 + 2.3 / L))


def tip_stress(tooth):
    """Stress along the profile at points of the fillet by a force at the tip, times m b/F_bt."""
    rho = tooth.contour.roll[1]
    cases = flank_cases(tooth.solid, tooth.contour, np.array([rho]), np.eye(1))
    cases += stress_cases(tooth.solid, tooth.contour, TANGENTS, 1)
    found = tooth.displacements(cases)[0, :, 0, 0]
    # shear is no load case in plane strain: two stresses for each point
    return found[1:].reshape(TANGENTS.size, -1)[:, 0] * tooth.gear.m_n


@pytest.mark.parametrize(("z", "x"), [(17, 0.0), (25, 0.3), (43, 0.0), (100, 0.0)])
def test_stress_at_the_critical_section(z, x):
    gear = CylindricalGear(z=z, m_n=1e-3, x=x)
    Y_Fa, Y_Sa = factors(gear)
    stress = tip_stress(PlaneTooth(gear))
    assert stress.max() == pytest.approx(math.cos(gear.alpha_t) * Y_Fa * Y_Sa, rel=0.08)
    # the largest stress is near the 30° tangent, and the stress there hardly smaller
    assert 25.0 <= math.degrees(TANGENTS[int(np.argmax(stress))]) <= 35.0
    assert stress[1] > 0.97 * stress.max()


@pytest.mark.parametrize("z", [10, 17, 43, 100])
def test_stress_of_the_usual_mesh(z):
    """Against a mesh with twice as many elements of higher order: 1.2 % of the largest stress."""
    gear = CylindricalGear(z=z, m_n=1e-3, x=0.4 if z == 10 else 0.0)
    fine = Density(
        order=6, across=FINE.across, flank=(0.0, 0.3, 0.6, 1.0), fillet=3, root=3, body=(0.0, 0.2, 0.5, 1.0)
    )
    usual, finer = tip_stress(PlaneTooth(gear)), tip_stress(PlaneTooth(gear, fine))
    assert usual / finer.max() == pytest.approx(finer / finer.max(), abs=0.012)
