# SPDX-License-Identifier: Apache-2.0
"""Ring modes against thin rings in closed form, plane finite elements, spinning rings and supported rings."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.linalg import eigh

from pitchpoint.multibody.ring_modes import (
    RingSection,
    ring_invariants,
    ring_mode,
    ring_terms,
    support_shapes,
    support_stiffness,
)

E, NU, RHO, R, B = 206e9, 0.3, 7830.0, 0.2, 0.01


def ring(height):
    return RingSection(
        inner=R - 0.5 * height,
        outer=R + 0.5 * height,
        width=B,
        youngs_modulus=E,
        poisson_ratio=NU,
        density=RHO,
    )


def thin_frequency(n, height):
    """Inextensional ring [Hz]."""
    return n * (n**2 - 1) / math.sqrt(n**2 + 1) * math.sqrt(E * height**2 / 12 / RHO / R**4) / math.tau


@pytest.mark.parametrize("n", [2, 3, 5, 8, 16])
def test_thin_rings_in_closed_form(n):
    """Shear and rotary inertia are of the order of (n h/R)^2, 6e-5 with 16 waves."""
    height = 1e-4
    mode = ring_mode(ring(height), n)
    assert mode.frequency == pytest.approx(thin_frequency(n, height), rel=1e-4)
    assert mode.tangential == pytest.approx(-1.0 / n, rel=1e-4)
    assert mode.rotation == pytest.approx((n - 1.0 / n) / R, rel=1e-4)
    assert mode.stiffness == pytest.approx(
        math.pi * E * B * height**3 / 12 * (n**2 - 1) ** 2 / R**3, rel=1e-4
    )


@pytest.mark.parametrize("count", [2, 3, 4])
def test_deflection_under_equal_radial_loads(count):
    """Timoshenko's thin ring under N loads P: P R^3/(2 E I) ((a + sin a cos a)/(2 sin^2 a) - 1/a), a = pi/N.

    Modes of more than 16 waves, 3e-3 of it at most, are added by the stiffness of a thin ring.
    """
    height, a = 1e-4, math.pi / count
    inertia = B * height**3 / 12.0
    exact = (a + math.sin(a) * math.cos(a)) / (2.0 * math.sin(a) ** 2) - 1.0 / a
    found = sum(count / ring_mode(ring(height), n).stiffness for n in range(count, 17, count))
    rest = sum(count / (n * n - 1.0) ** 2 for n in range(16 // count * count + count, 4000, count))
    found += rest * R**3 / (math.pi * E * inertia)
    assert found == pytest.approx(exact * R**3 / (2.0 * E * inertia), rel=1e-4)


@pytest.mark.parametrize(("height", "most"), [(0.02, 2e-3), (0.04, 5e-3), (0.08, 1.2e-2)])
def test_thick_rings_by_plane_finite_elements(height, most):
    """Plane stress with quadratic elements of scikit-fem; a beam has the error of its straight sections."""
    exact = plane_frequencies(height)
    for n in range(2, 7):
        found = ring_mode(ring(height), n).frequency
        nearest = exact[np.argmin(np.abs(exact - found))]
        assert found == pytest.approx(nearest, rel=most), n


def plane_frequencies(height, layers=3, around=96):
    """Natural frequencies of a free ring in plane stress [Hz]."""
    import skfem
    from scipy.sparse.linalg import eigsh
    from skfem.helpers import dot
    from skfem.models.elasticity import linear_elasticity

    radii, angles = np.linspace(R - 0.5 * height, R + 0.5 * height, layers + 1), np.arange(around)
    turn = np.exp(1j * math.tau / around * angles)
    places = np.outer(turn, radii).ravel()

    def at(i, j):
        return (j % around) * (layers + 1) + i

    cells = [[at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)] for j in angles for i in range(layers)]
    flat = skfem.MeshQuad(np.stack([places.real, places.imag]), np.array(cells).T)
    mesh = skfem.MeshQuad2.from_mesh(flat)
    at_radius = np.hypot(*mesh.doflocs)
    grid = np.linspace(radii[0], radii[-1], 2 * layers + 1)  # middle nodes of chords onto the circles
    onto = grid[np.argmin(np.abs(at_radius[:, None] - grid), axis=1)]
    mesh = skfem.MeshQuad2(mesh.doflocs * onto / at_radius, mesh.t)
    basis = skfem.Basis(mesh, skfem.ElementVector(skfem.ElementQuad2()), intorder=5)
    K = skfem.asm(linear_elasticity(E * NU / (1.0 - NU**2), E / (2.0 * (1.0 + NU))), basis)
    M = skfem.asm(skfem.BilinearForm(lambda u, v, w: RHO * dot(u, v)), basis)
    found = eigsh(K, 24, M, sigma=-1e6, return_eigenvectors=False)
    return np.sqrt(np.sort(np.abs(found))[3:]) / math.tau


@pytest.mark.parametrize("n", [2, 3, 4])
def test_spinning_ring(n):
    """Carrier's frequencies in axes that spin with a thin ring."""
    height, spin = 2e-4, 300.0
    modes = [ring_mode(ring(height), n)]
    of = ring_invariants(modes)
    M, G = of.modal, 2.0 * spin * of.angular_1[:, 2, :].T
    K = np.eye(2) * (modes[0].stiffness + spin**2 * modes[0].stretch) - spin**2 * of.inertia_2[:, :, 2, 2]
    whole = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(M, K), -np.linalg.solve(M, G)]])
    found = np.unique(np.round(np.abs(np.linalg.eigvals(whole).imag), 6))
    root = math.hypot(math.tau * modes[0].frequency, n * (n**2 - 1) / (n**2 + 1) * spin)
    shift = 2.0 * n / (n**2 + 1) * spin
    np.testing.assert_allclose(found, [root - shift, root + shift], rtol=2e-4)


def test_teeth_add_mass_only():
    bare = ring(0.02)
    toothed = bare.with_teeth(0.3, R - 0.015)
    assert toothed.mass == pytest.approx(bare.mass + 0.3)
    one, two = ring_mode(bare, 3), ring_mode(toothed, 3)
    assert two.frequency < one.frequency
    assert two.stiffness == pytest.approx(one.stiffness, rel=1e-2)


def supported(count, waves=6, radial=3e6, tangential=5e6):
    """Natural frequencies [Hz] on equal springs at equal angles, and the modes of the free ring."""
    section = ring(0.01)
    modes = [ring_mode(section, n) for n in range(2, waves + 1)]
    terms = ring_terms(modes, section.radius, section.outer)
    K = support_stiffness(support_shapes(terms, math.tau * np.arange(count) / count), radial, tangential)
    K += np.diag(np.repeat([m.stiffness for m in modes], 2))
    found = eigh(K, ring_invariants(modes).modal, eigvals_only=True)
    return np.sqrt(found) / math.tau, section, modes


def test_many_supports_are_a_uniform_foundation():
    count = 13
    found, section, modes = supported(count)
    for k, m in enumerate(modes):
        V = m.tangential + (section.outer - section.radius) * m.rotation
        added = 0.5 * count * (3e6 + 5e6 * V**2)
        wanted = math.sqrt((m.stiffness + added) / m.mass) / math.tau
        np.testing.assert_allclose(found[2 * k : 2 * k + 2], wanted, rtol=1e-9)


@pytest.mark.parametrize("count", [5, 8, 12])
def test_pairs_split_where_twice_the_waves_are_a_multiple_of_the_supports(count):
    found, _, modes = supported(count, waves=6 if count == 12 else 4, radial=1e5, tangential=0.0)
    for k, m in enumerate(modes):
        one, two = found[2 * k : 2 * k + 2]
        splits = 2 * m.waves % count == 0
        assert (two - one > 1e-4 * one) == splits, m.waves
