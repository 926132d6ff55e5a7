# SPDX-License-Identifier: Apache-2.0
"""BEAM-1: one free-free round steel bar, diameter 50 mm, length 1 m, as a single consistent-mass element.

Source: Shaft test of the public Drivetrain toolbox (gfsReboucas/Drivetrain): E 206 GPa, rho 7830 kg/m^3.
Printed: 273.81 Hz (twice), 935.24 Hz (twice), 1753.8 Hz (torsion), 2827.9 Hz (axial). They belong to the
element without shear deflection and without rotary inertia in bending; torsion and axial are sqrt(12)/(2
pi) c/L, and torsion gives nu = 0.3. Tolerance: half a unit of the last printed digit. With shear and rotary
inertia the same bar, refined, meets the frequency equation of the Timoshenko continuum.
"""

from __future__ import annotations

import dataclasses
import math
from itertools import pairwise

import numpy as np
import pytest
from scipy.optimize import brentq

from pitchpoint.multibody.beam_section import Beam, tube
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.beams import nodes, shaft
from tests.support.engine import frequencies

E, NU, RHO, LENGTH = 206e9, 0.3, 7830.0, 1.0
G = E / (2.0 * (1.0 + NU))
ROUND = tube(0.05, nu=NU)


def bar(n, section=ROUND):
    """Frequencies above the rigid modes [Hz] of the bar in n pieces."""
    beams = [Beam(section=section, length=LENGTH / n, E=E, G=G, rho=RHO)] * n
    records = shaft(beams)
    if section.kappa_1 == 0.0:  # Euler's beam: without the rotary inertia of bending
        records["M"][:, 2:, 2:] = euler_mass(beams[0])
    system = assemble(nodes(np.linspace(0.0, LENGTH, n + 1)), {"shaft_beam": records})
    M, _, K = evaluate.linearize(system, system.initial_state())
    return frequencies(M, K)[6:]


def euler_mass(beam):
    """The part of the record's mass that is there without rotary inertia."""
    thin = dataclasses.replace(beam.section, I_1=0.0, I_2=0.0)
    return shaft([dataclasses.replace(beam, section=thin)])["M"][0][2:, 2:]


def test_single_element():
    thin = dataclasses.replace(ROUND, kappa_1=0.0, kappa_2=0.0)
    f = bar(1, thin)
    assert f[0] == pytest.approx(273.81, abs=0.005)
    assert f[1] == pytest.approx(273.81, abs=0.005)
    assert f[2] == pytest.approx(935.24, abs=0.005)
    assert f[3] == pytest.approx(935.24, abs=0.005)
    assert f[4] == pytest.approx(1753.8, abs=0.05)
    assert f[5] == pytest.approx(2827.9, abs=0.05)


def continuum():
    """First free-free bending frequency of the Timoshenko bar [Hz], symmetric mode.

    Han, Benaroya, Wei, J. Sound Vib. 225 (1999) 935-988: w and psi as cos and cosh with the wave numbers a
    and b of the coupled equations; at the free ends psi' = 0 and w' = psi.
    """
    A, second, shear = ROUND.A, ROUND.I_1, ROUND.kappa_1 * ROUND.A * G

    def determinant(omega):
        # k^4 EI - k^2 omega^2 (rho I + rho A EI / kAG) + omega^4 rho^2 A I / kAG - rho A omega^2 = 0
        p = omega**2 * (RHO * second + RHO * A * E * second / shear)
        r = omega**4 * RHO**2 * A * second / shear - RHO * A * omega**2
        root = math.sqrt(p**2 - 4.0 * E * second * r)
        a = math.sqrt((p + root) / (2.0 * E * second))
        b = math.sqrt((root - p) / (2.0 * E * second))
        # shear: kAG (w'' - psi') = -rho A omega^2 w
        pa = a - RHO * A * omega**2 / (shear * a)  # psi = -pa sin for w = cos(a x)
        pb = b + RHO * A * omega**2 / (shear * b)  # psi = pb sinh for w = cosh(b x)
        x = 0.5 * LENGTH
        moment = -pa * a * math.cos(a * x), pb * b * math.cosh(b * x)
        force = (pa - a) * math.sin(a * x), (b - pb) * math.sinh(b * x)
        return moment[0] * force[1] - moment[1] * force[0]

    near = 2.0 * math.pi * 226.0
    return brentq(determinant, 0.97 * near, 1.03 * near, xtol=1e-10) / (2.0 * math.pi)


def test_refinement_reaches_the_continuum():
    exact = continuum()
    errors = [bar(n)[0] / exact - 1.0 for n in (2, 4, 8, 16, 32)]
    assert all(e > f > 0.0 for e, f in pairwise(errors))  # a Ritz method comes from above
    # the shear strain is constant in each piece, so the order of its share is 2
    assert errors[3] / errors[4] == pytest.approx(4.0, rel=0.15)
    assert bar(32)[0] == pytest.approx(exact, rel=1e-5)
    assert exact < 228.3  # the Euler bar
