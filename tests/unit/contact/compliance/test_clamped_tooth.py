# SPDX-License-Identifier: Apache-2.0
"""Clamped tooth: influence by adaptive quadrature, clamp, helical and spur, refusals."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad

from pitchpoint.contact.compliance.clamped_tooth import clamped_tooth
from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.cutter import PinionCutter
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.rack import BasicRack
from pitchpoint.geometry.tooth_form import tooth_form

E, NU = 206e9, 0.3
GEARS = {
    "undercut": CylindricalGear(z=12, m_n=1e-3),
    "pinion": CylindricalGear(z=17, m_n=1e-3, x=0.3),
    "wheel": CylindricalGear(z=101, m_n=2e-3, x=-0.4),
    "full radius": CylindricalGear(z=30, m_n=1e-3, rack=BasicRack(h_fP_star=1.4, rho_fP_star=0.4)),
    "ring": CylindricalGear.internal(z=60, m_n=1e-3),
    "shaped ring": CylindricalGear.internal(z=81, m_n=4e-3, x=-0.3, cutter=PinionCutter(z_0=25)),
}


def by_quadrature(gear, tooth, rho, rho_load):
    """Weber and Banaschek's integrals over the section, found by bisection of the exact tooth."""
    form = tooth_form(gear)
    sign = form.sign
    start = form.fillet.theta_root + tooth.start * (form.theta_form - form.fillet.theta_root)

    def fillet(theta):
        r, angle = (float(v) for v in form.fillet_polar(theta))
        return r * math.sin(angle), sign * (r * math.cos(angle) - tooth.distance)

    def involute(roll):
        r, psi = form.r_b * math.hypot(1.0, roll), form.psi_b - sign * (roll - math.atan(roll))
        return r * math.sin(psi), sign * (r * math.cos(psi) - tooth.distance)

    def half(y):
        """Half thickness at a height above the clamp."""
        curve, low, high = fillet, start, form.theta_form
        if y > fillet(form.theta_form)[1]:
            curve = involute
            low, high = (math.sqrt(max(0.0, (r / form.r_b) ** 2 - 1.0)) for r in (form.r_Ff, form.r_Fa))
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if curve(middle)[1] < y else (low, middle)
        return curve(0.5 * (low + high))[0]

    def load(length):
        roll = length / form.r_b
        alpha = roll - sign * form.psi_b
        return sign * (form.r_b / math.cos(alpha) - tooth.distance), math.cos(alpha), math.sin(alpha)

    (y, c, s), (y2, c2, s2) = load(rho), load(rho_load)
    top = min(y, y2)
    if top <= 0.0:
        return 0.0
    points = sorted({min(max(fillet(form.theta_form)[1], 1e-9), top * 0.999)})

    def integral(f):
        return quad(f, 0.0, top, points=points, limit=200, epsrel=1e-9)[0]

    bending = 12.0 * c * c2 * integral(lambda h: (y - h) * (y2 - h) / (2.0 * half(h)) ** 3)
    area = integral(lambda h: 0.5 / half(h))
    return (1.0 - NU**2) / E * (bending + (2.4 / (1.0 - NU) * c * c2 + s * s2) * area)


@pytest.mark.parametrize("name", GEARS)
def test_influence_by_quadrature(name):
    gear = GEARS[name]
    tooth = clamped_tooth(gear)
    low, high = tooth.roll
    rho = low + (high - low) * np.array([0.25, 0.6, 1.0])
    found = tooth.influence(rho[:, None], rho[None], E, NU)
    assert found == pytest.approx(found.T, rel=1e-12, abs=1e-12 * found.max())
    for i in range(3):
        for j in range(i + 1):
            oracle = by_quadrature(gear, tooth, rho[i], rho[j])
            assert found[i, j] == pytest.approx(oracle, rel=1e-7, abs=1e-9 * found.max())


@pytest.mark.parametrize("name", GEARS)
@pytest.mark.parametrize("clamp", [None, math.radians(45.0), math.radians(70.0)])
def test_tangent_at_the_clamp(name, clamp):
    """By differences of the outline; 30° or 60° by default."""
    tooth = clamped_tooth(GEARS[name], clamp)
    span = np.array([tooth.start - 1e-6, tooth.start + 1e-6])
    thickness, height, _ = tooth.outline(span)
    angle = math.degrees(math.atan2(0.5 * (thickness[0] - thickness[1]), height[1] - height[0]))
    default = 60.0 if GEARS[name].is_internal else 30.0
    assert angle == pytest.approx(default if clamp is None else math.degrees(clamp), abs=1e-3)


@pytest.mark.parametrize("name", GEARS)
def test_influence_is_positive_semidefinite(name):
    tooth = clamped_tooth(GEARS[name])
    rho = np.linspace(*tooth.roll, 15)
    values = np.linalg.eigvalsh(tooth.influence(rho[:, None], rho[None], E, NU))
    assert values[0] > -1e-12 * values[-1]


def test_deeper_clamp_is_softer():
    rho = 2.5e-3
    angles = [20.0, 30.0, 45.0, 60.0]
    found = [clamped_tooth(GEARS["pinion"], math.radians(a)).influence(rho, rho, E, NU) for a in angles]
    assert np.all(np.diff(found) > 0.0)


def test_small_helix_angle_meets_the_spur_tooth():
    spur, almost = (CylindricalGear(z=31, m_n=1e-3, x=0.2, beta=beta) for beta in (0.0, 1e-5))
    rho = 5e-3
    found = [clamped_tooth(g).influence(rho, rho, E, NU) for g in (spur, almost)]
    assert found[1] == pytest.approx(found[0], rel=1e-8)


def test_hand_does_not_matter():
    found = [
        clamped_tooth(CylindricalGear(z=31, m_n=1e-3, beta=beta)).influence(5e-3, 5e-3, E, NU)
        for beta in (0.3, -0.3)
    ]
    assert found[0] == found[1]


def test_helical_tooth_is_near_its_virtual_spur_gear():
    """Normal section: m_n with z_n teeth, per length of the trace and normal force.

    The transverse section stretched by cos β differs from that of the virtual gear by the curvature of the
    cylinder: 3 % of the compliance at 25°.
    """
    gear = CylindricalGear(z=40, m_n=1e-3, beta=math.radians(25.0))
    virtual = CylindricalGear(z=round(gear.z_n), m_n=1e-3)
    tooth, other = clamped_tooth(gear), clamped_tooth(virtual)
    share = (0.5, 0.95)
    found = [tooth.roll[0] + s * (tooth.roll[1] - tooth.roll[0]) for s in share]
    ours = [float(tooth.influence(r, r, E, NU)) for r in found]
    roll = [other.roll[0] + s * (other.roll[1] - other.roll[0]) for s in share]
    factor = math.cos(gear.beta) / math.cos(gear.beta_b) ** 2
    theirs = [factor * float(other.influence(r, r, E, NU)) for r in roll]
    assert ours == pytest.approx(theirs, rel=0.05)


def test_clamp_outside_the_fillet_is_refused():
    with pytest.raises(GeometryError, match=r"clamp: 5 deg .*limit .* deg"):
        clamped_tooth(GEARS["wheel"], math.radians(5.0))
    with pytest.raises(GeometryError, match="clamp"):
        clamped_tooth(GEARS["wheel"], math.nan)
