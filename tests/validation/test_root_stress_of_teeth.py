# SPDX-License-Identifier: Apache-2.0
"""Root stress: factors of ISO 6336-3 from the generated contour, and finite elements against them.

Source: ISO 6336-3:2006, 6.2 and 7.2. Its closed formulas for a force at the tip of a spur gear are those of
the contour: 1e-6. Numbers of a helical pair: KISSsoft 03/2017, stage 3 of the 5 MW reference gearbox
(gfsReboucas/Drivetrain, stage_03.rtf), geometry as in KS-NRELGBX. Tolerance: half a unit of the last digit
for the section and Y_F; angle and lever arm of the force, and with them Y_S, are printed for another tooth
thickness (0.02°, 0.2 %, 0.3 %).

Finite elements with a force at the tip: sigma = F_t/(b m) Y_Fa Y_Sa at the 30° tangent. The factors are those
of a bent beam with a fitted notch factor, 5 to 7 % above the maximum stress of a plane tooth. Tolerance: 8 %.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.root_section import helix_factor, root_section
from pitchpoint.contact.tooth_fe.loads import flank_cases, roll_at
from pitchpoint.contact.tooth_fe.root_stress import stress_cases
from pitchpoint.contact.tooth_fe.section_mesh import Density
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.involute import inv
from tests.support.plane_teeth import FINE, PlaneTooth
from tests.support.printed import printed
from tests.validation.test_nrel_gearbox_geometry import helical_stage

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


@pytest.mark.parametrize(("z", "x"), [(17, 0.0), (25, 0.3), (100, -0.2)])
def test_factors_of_the_contour(z, x):
    """Closed formulas of the standard against the generated tooth, in any module."""
    for m_n in (1e-3, 4e-3):
        gear = CylindricalGear(z=z, m_n=m_n, x=x)
        section, tip = root_section(gear), math.sqrt((0.5 * gear.d_a) ** 2 - gear.r_b**2)
        found = tuple(map(float, section.factors(tip)))
        assert found == pytest.approx(factors(gear), rel=1e-6)
        stress = 1e5 * math.cos(gear.alpha_t) / m_n * math.prod(factors(gear))
        assert float(section.stress(1e5, tip)) == pytest.approx(stress, rel=1e-6)


def test_stage_3_of_the_5_mw_gearbox():
    """Force at d_en, the outer point of single pair contact of the virtual gears: p_bn (ε_αn - 1) from the
    tip, on the path of contact of the helical gears cos β_b times as far."""
    pair = helical_stage()
    cos_b = math.cos(pair.gear1.beta_b)
    below = cos_b * pair.gear1.p_bn * (pair.eps_alpha / cos_b**2 - 1.0)
    rolls = pair.T1E - below, pair.T1T2 - pair.T1A - below
    rows = (
        (pair.gear1, rolls[0], "31.18", "5.95", "2.620", "1.18", (23.89, 14.06, 2.28)),
        (pair.gear2, rolls[1], "32.75", "5.39", "3.036", "1.24", (22.20, 16.11, 2.35)),
    )
    stress = []
    for gear, rho, chord, radius, notch, form, (angle, arm, correction) in rows:
        section = root_section(gear)
        assert 1e3 * section.chord == printed(chord)
        assert 1e3 * section.fillet_radius == printed(radius)
        assert section.notch_parameter == printed(notch)
        assert float(section.factors(rho)[0]) == printed(form)
        alpha, h_F = section.load(rho)
        assert math.degrees(alpha) == pytest.approx(angle, abs=0.02)
        assert 1e3 * float(h_F) == pytest.approx(arm, rel=2e-3)
        assert float(section.factors(rho)[1]) == pytest.approx(correction, rel=3e-3)
        line_load = 240064.4 / math.cos(gear.alpha_t) / 0.36  # F_t of the report on the reference circle
        stress.append(1e-6 * float(section.stress(line_load, rho)))
    Y_beta = helix_factor(pair.gear1.beta, pair.eps_beta)
    assert Y_beta == printed("0.917")
    assert Y_beta * np.array(stress) == pytest.approx([117.92, 127.69], rel=2e-3)


@pytest.mark.parametrize(("z", "x"), [(17, 0.0), (25, 0.3), (43, 0.0), (100, 0.0)])
def test_stress_at_the_critical_section(z, x):
    gear = CylindricalGear(z=z, m_n=1e-3, x=x)
    Y_Fa, Y_Sa = factors(gear)
    stress = tip_stress(PlaneTooth(gear))
    assert stress.max() == pytest.approx(math.cos(gear.alpha_t) * Y_Fa * Y_Sa, rel=0.08)
    # the largest stress is near the 30° tangent, and the stress there hardly smaller
    assert 25.0 <= math.degrees(TANGENTS[int(np.argmax(stress))]) <= 35.0
    assert stress[1] > 0.97 * stress.max()


@pytest.mark.parametrize(
    ("z", "x", "ratios"),
    [
        (17, 0.0, [1.15, 1.07, 0.99, 0.95, 0.94]),
        (25, 0.3, [1.16, 1.01, 0.93, 0.91, 0.93]),
        (43, 0.0, [1.18, 1.04, 0.96, 0.94, 0.94]),
        (100, 0.0, [1.13, 1.00, 0.93, 0.92, 0.94]),
        (-60, 0.0, [1.00, 0.90, 0.91, 0.93, 0.96]),
    ],
)
def test_finite_elements_over_the_standard(z, x, ratios):
    """The table of the theory, by the height of the force; 1.5 % is the error of the mesh."""
    tooth, heights = PlaneTooth(CylindricalGear(z=z, m_n=1e-3, x=x)), np.array([-0.3, 0.0, 0.3, 0.6, 1.0])
    rho, n = roll_at(tooth.contour, heights), heights.size
    tangents = np.radians(np.arange(30 if z > 0 else 40, 61, 3.0))
    cases = flank_cases(tooth.solid, tooth.contour, rho, np.eye(n))
    cases += stress_cases(tooth.solid, tooth.contour, tangents, n)
    stress = tooth.displacements(cases)[0, n:, 0, :n].reshape(tangents.size, -1, n)[:, 0]
    assert stress.max(axis=0) / root_section(tooth.gear).stress(1.0, rho) == pytest.approx(ratios, abs=0.015)


@pytest.mark.parametrize("z", [10, 17, 43, 100])
def test_stress_of_the_usual_mesh(z):
    """Against a mesh with twice as many elements of higher order: 1.2 % of the largest stress."""
    gear = CylindricalGear(z=z, m_n=1e-3, x=0.4 if z == 10 else 0.0)
    fine = Density(
        order=6, across=FINE.across, flank=(0.0, 0.3, 0.6, 1.0), fillet=3, root=3, body=(0.0, 0.2, 0.5, 1.0)
    )
    usual, finer = tip_stress(PlaneTooth(gear)), tip_stress(PlaneTooth(gear, fine))
    assert usual / finer.max() == pytest.approx(finer / finer.max(), abs=0.012)
