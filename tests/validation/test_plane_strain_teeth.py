# SPDX-License-Identifier: Apache-2.0
"""FC-1: finite elements of teeth in plane strain, spur 17/43, m 1, rack 1.25/0.38/1.0, E 206 GPa.

Source: finite elements of an open gear contact program, three meshes within 0.06 %. The displacement is that
of the intersection of the line of force with the centre line of the tooth, along the line of force. The bore
r_f/1.4 is clamped. c' at the pitch point adds the approach of Weber and Banaschek (1953) at 300 N/mm.
Tolerance: twice the sum of the spread of the source and half a unit of the last printed digit (0.06 %
and 0.03 %).

Hertzian pressure on a refined mesh is the reference for the way in which the local indentation is replaced.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.hertz import half_width, plane_strain_compliance
from pitchpoint.contact.tooth_fe.section_mesh import Density
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from tests.support.plane_teeth import FINE, NU, E, PlaneTooth, approach

TOOTH = {z: PlaneTooth(CylindricalGear(z=z, m_n=1e-3), FINE) for z in (17, 43)}
PITCH = {17: 8.5e-3, 43: 21.5e-3}
SOFT = plane_strain_compliance(E, NU)
Q = 300.0e3


def contact_width():
    """Half width of the contact at the pitch point."""
    rho = [TOOTH[z].roll(PITCH[z]) for z in (17, 43)]
    return float(half_width(Q, rho[0] * rho[1] / sum(rho), SOFT, SOFT))


def centre_displacement(z, radius):
    """Displacement of the centre line by a force on the flank, µm per N/mm."""
    tooth = TOOTH[z]
    rho = tooth.roll(radius)
    found = tooth.displacements([*tooth.flank([rho]), tooth.at_centre(rho, 1)])
    return 1e9 * float(found[0, 1, 0, 0])


@pytest.mark.parametrize(
    ("z", "radius", "published"),
    [(17, 8.0023e-3, 0.01626), (17, 8.5e-3, 0.02226), (43, 21.5e-3, 0.02085), (43, 22.4434e-3, 0.05411)],
)
def test_displacement_of_the_centre_line(z, radius, published):
    assert centre_displacement(z, radius) == pytest.approx(published, rel=2e-3)


def test_stiffness_at_the_pitch_point():
    b = contact_width()
    compliance = sum(
        centre_displacement(z, PITCH[z]) + 1e9 * approach(TOOTH[z].depth(TOOTH[z].roll(PITCH[z])), b)
        for z in (17, 43)
    )
    assert 1.0 / compliance == pytest.approx(17.06, rel=1e-3)


def graded(at, low, high, step):
    """Borders that grow by 2.2 away from a position, between two ends; the first ones are `step` long."""
    found = [low, at, high]
    for sign, end in ((1.0, high), (-1.0, low)):
        position, size = at, step
        while sign * (end - position) > 1.5 * size:
            position += sign * size
            found.append(position)
            size *= 2.2
    return np.unique(found)


def under_hertzian_pressure(tooth, rho, b):
    """Displacement of the middle of the contact by Hertzian pressure, per force per length [m²/N]."""
    contour = tooth.contour
    first, last = (r * r for r in contour.roll)
    length = abs(last - first) / (2.0 * contour.form.r_b)  # of the involute
    at = (rho * rho - first) / (last - first)
    flank = graded(at, 0.0, 1.0, b / length)
    thickness = float(contour.involute(np.array([rho]))[0].imag)
    across = 1.0 - graded(0.0, 0.0, 1.0, b / thickness)[::-1]
    density = Density(order=6, across=tuple(across), flank=tuple(flank), fillet=2, root=2, growth=1.7)
    fine = PlaneTooth(tooth.gear, density)
    angle, weight = np.polynomial.legendre.leggauss(60)
    angle, weight = 0.5 * math.pi * angle, 0.5 * math.pi * weight
    # p = 2/(pi b) sqrt(1 - s²/b²) with s = b sin(angle)
    shares = 2.0 / math.pi * np.cos(angle) ** 2 * weight
    assert shares.sum() == pytest.approx(1.0)
    points = np.sqrt(rho * rho + 2.0 * contour.form.r_b * b * np.sin(angle))
    weights = np.zeros((2, angle.size + 1))
    weights[0, :-1], weights[1, -1] = shares, 1.0
    cases = fine.flank([*points.tolist(), rho], weights)
    return float(fine.displacements(cases)[0, 1, 0, 0])


@pytest.mark.parametrize(
    ("z", "radius"),
    [
        (17, 8.5e-3),
        (17, 9.2e-3),
        pytest.param(43, 20.9e-3, marks=pytest.mark.study),
        pytest.param(43, 21.5e-3, marks=pytest.mark.study),
        (-60, 29.3e-3),
        pytest.param(-60, 30.0e-3, marks=pytest.mark.study),
    ],
)
def test_indentation_is_that_of_hertzian_pressure(z, radius):
    """Own oracle: pressure on a mesh with elements of the contact width, against the replaced indentation.

    The half-plane has a straight surface and the tooth a curved one: 0.25 % of the total.
    """
    gear = CylindricalGear(z=z, m_n=1e-3) if z > 0 else CylindricalGear.internal(z=-z, m_n=1e-3)
    tooth = PlaneTooth(gear)
    rho, b = tooth.roll(radius), 50e-6
    total = float(tooth.without_indentation([rho])[0]) + approach(tooth.depth(rho), b)
    assert total == pytest.approx(under_hertzian_pressure(tooth, rho, b), rel=2.5e-3)


def test_stiffness_at_the_pitch_point_under_hertzian_pressure():
    """The published method neglects the free surfaces of the tooth near the contact: it is 3 % stiffer."""
    b = contact_width()
    reference = sum(under_hertzian_pressure(TOOTH[z], TOOTH[z].roll(PITCH[z]), b) for z in (17, 43))
    found = 0.0
    for z in (17, 43):
        tooth = PlaneTooth(TOOTH[z].gear)
        rho = tooth.roll(PITCH[z])
        found += float(tooth.without_indentation([rho])[0]) + approach(tooth.depth(rho), b)
    assert 1e-9 / found == pytest.approx(1e-9 / reference, rel=2e-3)
    assert 1e-9 / reference == pytest.approx(16.6, abs=0.1)


@pytest.mark.parametrize("z", [17, 43, 100, -60])
def test_depth_of_the_clamp_does_not_matter(z):
    """Clamp at 0.7 and 1.3 times the depth of the centre line, depth of the contact unchanged: 0.5 %."""
    gear = CylindricalGear(z=z, m_n=1e-3) if z > 0 else CylindricalGear.internal(z=-z, m_n=1e-3)
    tooth = PlaneTooth(gear, FINE)
    low, high = tooth.contour.roll
    rho = (low + (high - low) * np.array([0.1, 0.5, 0.9])).tolist()
    local = np.array([approach(tooth.depth(r), 50e-6) for r in rho])
    middle, shallow, deep = (tooth.without_indentation(rho, c) + local for c in (0.0, 0.3, -0.3))
    assert shallow == pytest.approx(middle, rel=5e-3)
    assert deep == pytest.approx(middle, rel=5e-3)
