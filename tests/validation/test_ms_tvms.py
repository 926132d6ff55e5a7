# SPDX-License-Identifier: Apache-2.0
"""MS-TVMS: spur pair 62/62 by the potential-energy method.

Source: test of the gear element of the open rotor code ROSS; method of Ma et al. 2014 with the gear body of
Sainsot, Velex and Duverger 2004. Inputs: m 2 mm, b 20 mm, alpha 20 deg, E 206 GPa, nu 0.3, bore 35 mm, rack
1.0/1.25/0.38. Published: eps_alpha 1.78977987, Hertz term 3.5558686e9 N/m, "mean" 4.0966e8 N/m, table from
3.96623e8, 3.96739e8 N/m on. Both pairs carry their own body compliance there and here; bodies do not couple
them.

The source takes the height of the contact point for the height u_f of the load. With that reading the table's
start follows to 0.3 %; the printed mean then agrees to 0.2 % with ours over the double-contact part of the
cycle, while ours over the whole cycle is 9.5 % lower. Sainsot's own definition, up to the crossing of load
line and centre line, is this package's default; its mean over the whole cycle is 4.7 % below the printed one,
inside the 5 % by which such methods differ.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad

from pitchpoint.contact.mesh_cycle import pair_cycle
from pitchpoint.contact.stiffness.energy import energy, energy_compliance
from pitchpoint.contact.stiffness.tooth_compliance import body_coefficients
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.gear_pair import GearPair

B, E, NU = 0.02, 206e9, 0.3
GEAR = CylindricalGear(z=62, m_n=2e-3, b=B)
PAIR = GearPair(GEAR, GEAR, 0.124)
BORES = (0.035, 0.035)


def test_contact_ratio_and_base_circle():
    assert PAIR.eps_alpha == pytest.approx(1.78977987, abs=1e-8)
    assert GEAR.r_b == pytest.approx(58.26094e-3, abs=5e-9)


def test_hertz_term():
    found = energy_compliance(PAIR, points=3)
    assert B / found.contact == pytest.approx(np.full(3, 3.5558686e9), rel=1e-8)
    assert B / found.contact[0] == pytest.approx(math.pi * E * B / (4 * (1 - NU**2)), rel=1e-12)


def cycle_parts(body):
    """Mean over the cycle, mean over its double-contact part, start of the table and its first step [N/m]."""
    shape = energy(PAIR, points=1001, bores=BORES, body=body)
    unit = shape.c_prime * B
    p = np.linspace(0.0, PAIR.eps_alpha, 1001)
    psi = np.linspace(0.0, PAIR.eps_alpha - 1.0, 4001)
    double = np.interp(psi, p, shape.table) + np.interp(psi + 1.0, p, shape.table)
    return unit * pair_cycle(shape, PAIR.eps_alpha).mean, unit * double.mean(), unit * double


def test_default_mean():
    mean, _, _ = cycle_parts("load_line")
    assert mean == pytest.approx(4.0966e8, rel=0.05)
    assert 0.0465 < 1.0 - mean / 4.0966e8 < 0.0475


def test_reading_of_the_source():
    _, double_mean, double = cycle_parts("contact_point")
    assert double[0] == pytest.approx(3.96623e8, rel=3e-3)
    assert double[1] > double[0]
    assert double_mean == pytest.approx(4.0966e8, rel=2e-3)


def test_standard_is_stiffer():
    """ISO 6336 gives 4.6088e8 N/m for the same pair; the methods differ, and neither is tuned."""
    mean, _, _ = cycle_parts("load_line")
    assert 1.1 < 4.6088e8 / mean < 1.2


def outline(gear):
    """Half thickness and height of fillet and involute from the rack, as functions of their parameters.

    Written for this test: rolls the rounded tip of the rack over the pitch circle, no code of the package.
    """
    m, alpha, r = gear.m_n, math.radians(20), gear.m_n * gear.z / 2
    r_b, rho, depth = r * math.cos(alpha), 0.38 * m, 1.25 * m
    psi_b = math.pi / (2 * gear.z) + math.tan(alpha) - alpha
    centre = math.pi * m / 4 + depth * math.tan(alpha) + rho * (1 - math.sin(alpha)) / math.cos(alpha)
    below = depth - rho

    def fillet(gamma):  # angle of the rounding's normal against the datum line, alpha to pi/2
        phi = (below / math.tan(gamma) + centre) / r
        length = below / math.sin(gamma) + rho
        return r * math.sin(phi) - length * math.cos(gamma - phi), r * math.cos(phi) - length * math.sin(
            gamma - phi
        )

    def involute(roll):
        s, psi = r_b * math.hypot(1, roll), psi_b - (roll - math.atan(roll))
        return s * math.sin(psi), s * math.cos(psi)

    first = (r_b * math.tan(alpha) - (depth - rho * (1 - math.sin(alpha))) / math.sin(alpha)) / r_b
    return fillet, involute, first, psi_b, r_b


def brute_force(gear, rho):
    """Bending, shear, axial compliance at one contact point: adaptive quadrature of textbook integrals."""
    fillet, involute, first, psi_b, r_b = outline(gear)
    roll = rho / r_b
    x_c, y_c = involute(roll)
    angle = roll - psi_b
    c, s = math.cos(angle), math.sin(angle)
    G = E / (2 * (1 + NU))

    def parts(x, y):
        moment = c * (y_c - y) - s * x_c
        return moment**2 / (E * 2 / 3 * x**3), 1.2 * c * c / (G * 2 * x), s * s / (E * 2 * x)

    def total(k):
        def integrand(curve):
            def f(t):
                h = 1e-6
                return parts(*curve(t))[k] * (curve(t + h)[1] - curve(t - h)[1]) / (2 * h)

            return f

        root = quad(integrand(fillet), math.pi / 2, math.radians(20), epsrel=1e-10)[0]
        return root + quad(integrand(involute), first, roll, epsrel=1e-10)[0]

    return [total(k) for k in range(3)]


@pytest.mark.parametrize("z", [24, 62])
def test_one_tooth_against_quadrature(z):
    gear = CylindricalGear(z=z, m_n=2e-3, b=B)
    pair = GearPair(gear, gear, z * 2e-3)
    found = energy_compliance(pair, points=9, body="rigid").tooth_1
    for i, rho in enumerate(np.linspace(pair.T1A, pair.T1E, 9)):
        bending, shear, axial = brute_force(gear, rho)
        assert found.bending[i] == pytest.approx(bending, rel=2e-7)
        assert found.shear[i] == pytest.approx(shear, rel=2e-7)
        assert found.axial[i] == pytest.approx(axial, rel=2e-7)


def test_body_formula():
    """Sainsot's polynomial with the printed coefficients, at the load line's crossing height."""
    found = energy_compliance(PAIR, points=5, bores=BORES).tooth_1.body
    # middle of the tool tip's rounding, in modules from the middle of the tool tooth
    tan, sin, cos = (f(math.radians(20)) for f in (math.tan, math.sin, math.cos))
    x_c = math.pi / 4 - 1.25 * tan - 0.38 * (1 - sin) / cos
    theta_f = (math.pi - 2 * x_c) / 62
    r_f = GEAR.d_f / 2
    L, M, P, Q = body_coefficients(theta_f, r_f / 0.0175)
    psi_b = math.pi / 124 + math.tan(math.radians(20)) - math.radians(20)
    for value, rho in zip(found, np.linspace(PAIR.T1A, PAIR.T1E, 5), strict=True):
        a = rho / GEAR.r_b - psi_b
        u = (GEAR.r_b / math.cos(a) - r_f) / (2 * r_f * theta_f)
        expected = math.cos(a) ** 2 / E * (L * u**2 + M * u + P * (1 + Q * math.tan(a) ** 2))
        assert value == pytest.approx(expected, rel=1e-10)
