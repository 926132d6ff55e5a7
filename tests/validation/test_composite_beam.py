# SPDX-License-Identifier: Apache-2.0
"""WT-COMPOSITE: beams whose bending and torsion are coupled by the layup, at rest, vibrating and rotating.

Sources: Q. Wang, M. A. Sprague, J. Jonkman, N. Johnson, B. Jonkman, BeamDyn: a high-fidelity wind turbine
blade solver in the FAST modular framework, Wind Energy 20 (2017) 1439-1462: composite box beam; the converged
tip displacement of BeamDyn to 15 digits is in the documentation of Kynema (NREL), "Static bending of a
straight composite beam". Its axes 1, 2, 3 are our z, x, y; inches and pounds are entered as metres and
newtons. Independent references: tests/support/section_beams.py.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model
from tests.support.section_beams import (
    BOX,
    BOX_LENGTH,
    BOX_MASS,
    cantilever_text,
    exact_frequencies,
    exact_tip,
    matrices,
)

WANG = (-6.47488486259037e-02, 1.22973648292371, -9.02726627566302e-02)
"""Displacements of the tip along our x, y, z under 150 lb along y [in]."""
WORDS = ("x", "y", "z", "alpha", "beta", "spin")


def tip(properties, pieces, force=(0.0, 0.0, 0.0), speed=0.0, length=BOX_LENGTH):
    """Displacement and rotation of the tip at equilibrium."""
    system = compile_model(loads_model(cantilever_text(properties, length, pieces, force)))
    state = system.initial_state()
    state.v[system.layout.coordinate("hub.spin")] = speed
    state = find_equilibrium(system, state).state
    return np.array([state.q[system.layout.coordinate(f"tip.{word}")] for word in WORDS])


def test_large_deflection_of_the_box_beam() -> None:
    """Eight pieces have the tip of BeamDyn to 0.1 % along and in the direction of the force and to 1.2 %
    across, where it moves by the twist alone; 16 pieces to 0.02 % and 0.3 %: second order."""
    box = matrices(BOX, BOX_MASS)
    coarse, fine = (tip(box, n, (0.0, 150.0, 0.0))[:3] for n in (8, 16))
    np.testing.assert_allclose(coarse, WANG, rtol=0.012)
    np.testing.assert_allclose(fine[1:], WANG[1:], rtol=3e-4)
    np.testing.assert_allclose(fine[0], WANG[0], rtol=4e-3)
    np.testing.assert_allclose((4.0 * fine - coarse) / 3.0, WANG, rtol=3e-4)


def test_reference_is_that_of_the_paper() -> None:
    """The independent integration of the exact equations has the digits of BeamDyn."""
    np.testing.assert_allclose(exact_tip(BOX, BOX_LENGTH, (0.0, 150.0, 0.0))[0], WANG, rtol=1e-7)


def test_small_deflection_is_the_closed_form() -> None:
    """With the compliance S = K^-1: w = F (S_22 L + S_44 L^3/3), slope -F S_44 L^2/2, twist -F S_46 L^2/2,
    for any number of pieces."""
    S, L = np.linalg.inv(BOX), BOX_LENGTH
    for pieces in (1, 3):
        found = tip(matrices(BOX, BOX_MASS), pieces, (0.0, 1e-3, 0.0)) / 1e-3
        assert found[1] == pytest.approx(S[1, 1] * L + S[3, 3] * L**3 / 3.0, rel=1e-6)
        assert found[3] == pytest.approx(-S[3, 3] * L**2 / 2.0, rel=1e-6)
        assert found[5] == pytest.approx(-S[3, 5] * L**2 / 2.0, rel=1e-6)
    assert abs(S[3, 5]) > 0.2 * S[3, 3]


def with_mass_off_the_axis():
    """Mass matrix with the centre at (0.3, -0.5) in, turned principal axes, J_1 and J_2 different."""
    M, m, x, y = BOX_MASS.copy(), BOX_MASS[0, 0], 0.3, -0.5
    M[0, 5] = M[5, 0] = -m * y
    M[1, 5] = M[5, 1] = m * x
    M[2, 3] = M[3, 2] = m * y
    M[2, 4] = M[4, 2] = -m * x
    M[3, 4] = M[4, 3] = 0.002 - m * x * y
    M[3, 3] += m * y * y
    M[4, 4] += m * x * x
    M[5, 5] = M[3, 3] + M[4, 4]
    return M


@pytest.mark.parametrize("off_axis", [False, True])
def test_frequencies_are_those_of_the_transfer_matrix(off_axis) -> None:
    """Bending in both directions and torsion, coupled by stiffness and by mass: 16 pieces to 0.6 % for six
    modes, the first two to 1e-4, from above; the error is of second order in their length."""
    mass = with_mass_off_the_axis() if off_axis else BOX_MASS
    found = [frequencies(matrices(BOX, mass), n) for n in (8, 16)]
    exact = exact_frequencies(BOX, mass, BOX_LENGTH, found[1])
    off = [f / exact - 1.0 for f in found]
    assert (off[1] > 0.0).all() and (off[1] < 6e-3).all()
    assert (off[1][:2] < 1e-4).all()
    np.testing.assert_allclose(np.log2(off[0] / off[1]), 2.0, atol=0.1)


def clamped(properties, pieces, length=BOX_LENGTH):
    """System of a beam on a fixed hub."""
    text = cantilever_text(properties, length, pieces)
    text = text.replace("{mass: 1 kg, inertia_tensor: [1, 1, 1, 0, 0, 0],", "{motion: fixed,")
    return compile_model(loads_model(text.replace(text[text.index("  shaft:") : text.index("  free:")], "")))


def frequencies(properties, pieces, count=6):
    """Natural frequencies of the clamped beam [Hz]."""
    return np.asarray(find_modes(clamped(properties, pieces), count=count).frequency)


def test_rotating_beam_is_that_of_the_exact_equations() -> None:
    """At 10 rad/s about x the mass off the axis bends and twists the beam, and the tension stiffens it:
    elongation, deflection and rotation of the tip to 0.3 % with 16 pieces, the limit of 8 and 16 to 3e-4."""
    mass = with_mass_off_the_axis()
    moved, turn = exact_tip(BOX, BOX_LENGTH, inertia=mass, speed=10.0)
    angles = np.arctan2(-turn[1, 2], turn[2, 2]), np.arcsin(turn[0, 2]), np.arctan2(-turn[0, 1], turn[0, 0])
    exact = np.r_[moved, angles]
    coarse, fine = (tip(matrices(BOX, mass), n, speed=10.0) for n in (8, 16))
    np.testing.assert_allclose(fine, exact, rtol=3e-3)
    np.testing.assert_allclose((4.0 * fine - coarse) / 3.0, exact, rtol=4e-4)


def test_tension_twists_a_beam_with_coupled_extension() -> None:
    """Rotation alone: N = m Omega^2 (L^2 - z^2)/2, twist S_36 m Omega^2 L^3/3, to the square of it."""
    K = np.diag([1e7, 1e7, 1e7, 1e4, 1e4, 1e4])
    K[2, 5] = K[5, 2] = 1e5
    M = np.diag([1.0, 1.0, 1.0, 5e-4, 5e-4, 1e-3])
    found = tip(matrices(K, M), 8, speed=5.0, length=2.0)
    twist = np.linalg.inv(K)[2, 5] * 1.0 * 25.0 * 8.0 / 3.0
    assert found[5] == pytest.approx(twist, rel=2e-3)


@pytest.mark.parametrize("factors", [[2e-3] * 6, [3e-3, 2e-3, 1e-3, 2e-3, 3e-3, 1e-3]])
def test_damping_ratio_is_half_the_factor_times_the_frequency(factors) -> None:
    """zeta = mu omega/2 for equal factors in every mode; without coupling bending has mu_5 and mu_4, torsion
    mu_6, to the share of the shear strain. `internal_damping` replaces them."""
    equal = len(set(factors)) == 1
    K = BOX if equal else np.diag([1e7, 1e7, 1e7, 3e4, 6e4, 2e4])
    given = f"{matrices(K, BOX_MASS)}, damping: {factors}"
    ratio = damping_over_stiffness(given)
    if equal:
        np.testing.assert_allclose(ratio, 2e-3, rtol=1e-6)
        np.testing.assert_allclose(damping_over_stiffness(given, "5 ms"), 5e-3, rtol=1e-6)
    else:
        assert {round(1e3 * x, 1) for x in ratio} == {1.0, 2.0, 3.0}


def damping_over_stiffness(properties, internal="0 s"):
    """Damping ratios of six modes over half of the angular frequency [s]."""
    found = find_modes(clamped(properties, f"4\n    internal_damping: {internal}"), count=6)
    return np.asarray(found.damping_ratio) / (np.pi * np.asarray(found.frequency))
