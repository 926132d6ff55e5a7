# SPDX-License-Identifier: Apache-2.0
"""Beam matrices against rigid motion, closed forms of statics, and frequencies of the continuum."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.linalg import eigh

from pitchpoint.multibody.beam_section import Beam, Section, rectangle, tube
from tests.support.beam_modes import tension_stiffness

STEEL = {"E": 206e9, "G": 206e9 / 2.6, "rho": 7830.0}
ROUND = Beam(section=tube(0.05, 0.02), length=0.4, **STEEL)
FLAT = Beam(section=rectangle(0.06, 0.02), length=0.4, **STEEL)


def rigid(length):
    """Six rigid motions of an element about its first end, columns."""
    found = np.zeros((12, 6))
    for k in range(3):
        found[[k, 6 + k], k] = 1.0
        turn = np.eye(3)[k]
        found[3:6, 3 + k] = found[9:12, 3 + k] = turn
        found[6:9, 3 + k] = np.cross(turn, [0.0, 0.0, length])
    return found


def line(beam, n, matrix):
    """Assemble n equal elements in a row."""
    whole = np.zeros((6 * n + 6, 6 * n + 6))
    for k in range(n):
        whole[6 * k : 6 * k + 12, 6 * k : 6 * k + 12] += matrix(beam)
    return whole


@pytest.mark.parametrize("beam", [ROUND, FLAT])
def test_rigid_motion_needs_no_force_and_has_the_mass_of_the_rod(beam):
    R = rigid(beam.length)
    np.testing.assert_allclose(beam.stiffness() @ R, 0.0, atol=1e-6)  # of 1e8
    got = R.T @ beam.consistent_mass() @ R
    m, h, s = beam.mass, beam.length, beam.section
    about = [m * h**2 / 3 + beam.rho * h * s.I_2, m * h**2 / 3 + beam.rho * h * s.I_1]
    about += [beam.rho * h * (s.I_1 + s.I_2)]
    np.testing.assert_allclose(np.diag(got), [m, m, m, *about], rtol=1e-12)


@pytest.mark.parametrize("plane", [1, 2])
def test_cantilever_deflects_by_bending_and_shear(plane):
    beam, s = FLAT, FLAT.section
    free = np.linalg.inv(beam.stiffness()[6:, 6:])
    second, kappa = (s.I_1, s.kappa_1) if plane == 1 else (s.I_2, s.kappa_2)
    expected = beam.length**3 / (3 * beam.E * second) + beam.length / (kappa * s.A * beam.G)
    assert free[plane - 1, plane - 1] == pytest.approx(expected, rel=1e-12)


def test_gyration_of_a_rigid_rod():
    # moment of a spinning rod whose axis turns about axis 1 with rate a: I_p Omega a about axis 2
    R = rigid(ROUND.length)
    moment = -(R.T @ ROUND.gyroscopic() @ R)[3:, 3:]
    polar = ROUND.rho * ROUND.length * ROUND.section.J
    expected = np.zeros((3, 3))
    for c in range(3):  # -d/dt(I_p Omega n) = -I_p Omega (rate x n)
        expected[:, c] = -polar * np.cross(np.eye(3)[c], [0.0, 0.0, 1.0])
    np.testing.assert_allclose(moment, expected, atol=1e-12 * polar)


def free_beam(beam, length, mode):
    """Frequency of a long free-free Euler beam [Hz]: (lambda/L)^2 sqrt(EI/(rho A))/2 pi."""
    root = (4.730040744862704, 7.853204624095838)[mode]
    s = beam.section
    return (root / length) ** 2 * math.sqrt(beam.E * s.I_1 / (beam.rho * s.A)) / (2 * math.pi)


def test_refinement_reaches_the_continuum():
    """Slender free-free beam without shear deflection; rotary inertia matters by (r/L)^2 = 1e-8 only."""
    thin = Section(A=1e-4, I_1=1e-12, I_2=1e-12, J=2e-12, kappa_1=0.0, kappa_2=0.0)
    found = []
    for n in (4, 8, 16):
        beam = Beam(section=thin, length=1.0 / n, **STEEL)
        K, M = line(beam, n, Beam.stiffness), line(beam, n, Beam.consistent_mass)
        plane = np.sort([*range(0, 6 * n + 6, 6), *range(4, 6 * n + 6, 6)])
        values = eigh(K[np.ix_(plane, plane)], M[np.ix_(plane, plane)], eigvals_only=True)
        bending = np.sqrt(values[2:]) / (2 * np.pi)
        found.append(bending[0] / free_beam(beam, 1.0, 0) - 1.0)
    assert found[0] > found[1] > found[2] > -1e-7  # from above, as Ritz demands
    assert found[0] / found[1] == pytest.approx(16.0, rel=0.3)  # order 4
    assert abs(found[2]) < 1e-5


def test_tension_raises_and_euler_load_buckles():
    n, beam = 8, Beam(section=tube(0.02), length=0.125, E=2e11, G=8e10, rho=7850.0)
    np.testing.assert_allclose(tension_stiffness(beam) @ rigid(0.125)[:, [0, 1, 2, 5]], 0.0, atol=1e-12)
    K, K_g = line(beam, n, Beam.stiffness), line(beam, n, tension_stiffness)
    held = [0, 1, 2, 5, 6 * n, 6 * n + 1]
    free = np.setdiff1d(np.arange(6 * n + 6), held)
    values = eigh(K_g[np.ix_(free, free)], K[np.ix_(free, free)], eigvals_only=True)
    load = 1.0 / values[-1]
    euler = math.pi**2 * beam.E * beam.section.I_1
    sheared = euler / (1.0 + euler / (beam.section.kappa_1 * beam.section.A * beam.G))
    assert load == pytest.approx(sheared, rel=2e-4)  # shape functions without shear, 8 elements
