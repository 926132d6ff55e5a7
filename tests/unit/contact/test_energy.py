# SPDX-License-Identifier: Apache-2.0
"""Energy method: order of the gears, helical and internal pairs, convergence, load dependence."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad

from pitchpoint.contact.stiffness.din3990 import single_stiffness
from pitchpoint.contact.stiffness.energy import energy, energy_compliance
from pitchpoint.core.errors import ValidityWarning
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.geometry.tooth_form import tooth_form


def helical(beta):
    m_n = 3e-3
    first = CylindricalGear(z=31, m_n=m_n, beta=beta, x=0.2, b=0.03)
    second = CylindricalGear(z=60, m_n=m_n, beta=-beta, b=0.03)
    return GearPair.from_profile_shifts(first, second)


def ring():
    planet = CylindricalGear(z=29, m_n=4e-3, x=0.4, b=0.05)
    return GearPair.from_profile_shifts(planet, CylindricalGear.internal(z=81, m_n=4e-3, x=-0.3, b=0.05))


def test_swapping_external_gears_mirrors_the_table():
    pair = helical(0.2)
    there = energy_compliance(pair, points=21, bores=(0.03, 0.06), line_load=3e5)
    back = energy_compliance(
        GearPair(pair.gear2, pair.gear1, pair.a_w), points=21, bores=(0.06, 0.03), line_load=3e5
    )
    assert back.stiffness == pytest.approx(there.stiffness[::-1], rel=1e-12)


@pytest.mark.parametrize("pair", [helical(0.0), helical(0.3), ring()], ids=["spur", "helical", "internal"])
def test_steps_do_not_matter(pair):
    coarse, fine = (energy_compliance(pair, points=n, line_load=2e5).stiffness for n in (9, 1001))
    assert coarse == pytest.approx(fine[::125], rel=2e-5)
    assert np.all(fine > 0.0)
    shape = energy(pair, points=33)
    assert shape.table.max() == 1.0
    assert pytest.approx(shape.table.min()) == shape.S_R


def test_mirrored_helix_changes_nothing():
    left, right = (energy_compliance(helical(beta), points=9).stiffness for beta in (0.25, -0.25))
    assert left == pytest.approx(right, rel=1e-12)


def test_small_helix_angle_meets_the_spur_gear():
    spur, almost = (energy_compliance(helical(beta), points=9).stiffness for beta in (0.0, 1e-6))
    assert almost == pytest.approx(spur, rel=1e-9)


def test_helix_weakens_like_the_standard():
    """c' of the standard falls with cos(beta) and the virtual teeth; so do our teeth on rigid bodies."""
    ours = [energy(helical(beta), body="rigid").c_prime for beta in (0.0, 0.35)]
    standard = [single_stiffness(helical(beta)).c_prime for beta in (0.0, 0.35)]
    assert ours[1] / ours[0] == pytest.approx(standard[1] / standard[0], rel=0.05)


def test_internal_tooth_against_quadrature():
    """Bending of a ring tooth by adaptive quadrature over the exact tooth, in its own frame."""
    pair = ring()
    form = tooth_form(pair.gear2)
    found = energy_compliance(pair, points=5).tooth_2
    r_root, psi_root = (float(v) for v in form.fillet_polar(form.fillet.theta_root))
    root = r_root * math.cos(psi_root)

    def involute(r):
        psi = float(form.involute_half_angle(r))
        return r * math.sin(psi), root - r * math.cos(psi)

    def fillet(theta):
        r, psi = (float(v) for v in form.fillet_polar(theta))
        return r * math.sin(psi), root - r * math.cos(psi)

    for i, rho in enumerate(np.linspace(pair.T1A, pair.T1E, 5)):
        r_c = math.hypot(form.r_b, pair.T1T2 - rho)
        x_c, eta_c = involute(r_c)
        angle = math.acos(form.r_b / r_c) + math.asin(x_c / r_c)
        c, s = math.cos(angle), math.sin(angle)

        def integrand(t, curve, step, c=c, s=s, x_c=x_c, eta_c=eta_c):
            x, eta = curve(t)
            slope = (curve(t + step)[1] - curve(t - step)[1]) / (2 * step)
            return (c * (eta_c - eta) - s * x_c) ** 2 * 1.5 / x**3 / 206e9 * slope

        expected = quad(integrand, form.fillet.theta_root, form.theta_form, args=(fillet, 1e-6), epsrel=1e-9)[
            0
        ]
        expected += quad(integrand, form.r_Ff, r_c, args=(involute, 1e-7), epsrel=1e-9)[0]
        assert found.bending[i] == pytest.approx(expected, rel=1e-6)
    assert np.all(found.body == 0.0)


def test_parts_move_as_they_should():
    pair = helical(0.0)
    parts = energy_compliance(pair, points=41).tooth_1
    for part in (parts.bending, parts.shear, parts.body):
        assert part[-1] > part[0]  # gear 1 is loaded from root to tip
        assert np.all(np.diff(part[20:]) > 0.0)
    soft = energy(pair, bores=(0.03, 0.05)).c_prime
    assert soft < energy(pair).c_prime < energy(pair, body="rigid").c_prime
    cast = energy(pair, moduli=(206e9, 118e9)).c_prime
    assert cast < energy(pair).c_prime
    twice = energy(pair, moduli=(412e9, 412e9)).c_prime
    assert twice == pytest.approx(2 * energy(pair).c_prime, rel=1e-12)


def test_contact_stiffens_with_the_load():
    pair = helical(0.2)
    stiffness = [energy(pair, line_load=q).c_prime for q in (1e4, 1e5, 1e6)]
    assert stiffness[0] < stiffness[1] < stiffness[2]


def test_body_formula_says_where_it_ends():
    pair = helical(0.0)
    with pytest.warns(ValidityWarning, match="root radius over bore radius h = "):
        energy(pair, bores=(0.005, None))
    small = CylindricalGear(z=17, m_n=3e-3, x=0.3, b=0.03)
    with pytest.warns(ValidityWarning, match=r"half tooth angle at the root circle theta_f \[rad\] = "):
        energy(GearPair.from_profile_shifts(small, CylindricalGear(z=40, m_n=3e-3, b=0.03)))
