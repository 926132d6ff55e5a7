# SPDX-License-Identifier: Apache-2.0
"""Reduction against the full model, mass integrals against moving point masses."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.linalg import eigh
from scipy.sparse import block_diag, csc_array

from pitchpoint.core.errors import CompileError
from pitchpoint.multibody.beam_section import Beam, rectangle, tube
from pitchpoint.multibody.craig_bampton import craig_bampton, modal_damping
from pitchpoint.multibody.mass_invariants import mass_invariants
from pitchpoint.multibody.structure import beam_line, make_structure
from tests.support.beam_modes import free_modes
from tests.support.floating import truss

STEEL = {"E": 2.1e11, "G": 8.1e10, "rho": 7850.0}


def stepped(n=30):
    """Shaft of three diameters."""
    sizes = [0.05] * (n // 3) + [0.08] * (n // 3) + [0.04] * (n // 3)
    return beam_line([Beam(section=tube(d), length=1.2 / n, **STEEL) for d in sizes])


def test_reduced_frequencies_are_those_of_the_full_model():
    """All modes up to a sixth of the limit of the held modes to 0.1 %, with a seventh of the
    displacements."""
    full = stepped(60)
    exact = free_modes(full, 30)
    reduced = craig_bampton(full, [0, 30, 60], below=6.0 * 2000.0)
    lowest = exact.frequency[exact.frequency < 2000.0]
    assert lowest.size >= 8
    np.testing.assert_allclose(reduced.frequency[: lowest.size], lowest, rtol=1e-3)
    assert np.all(reduced.frequency[: lowest.size] >= lowest * (1.0 - 1e-9))  # Ritz: from above
    assert reduced.frequency.size < full.size // 7


def test_reduced_response_with_the_interface_held():
    """The reduced body on springs: frequencies of the whole machine to 0.1 %, though springs were not in
    it."""
    full = stepped()
    springs = np.zeros(full.size)
    springs[[0, 1, 180, 181]] = 5e7
    springs[[2, 5]] = 1e6
    values = eigh(full.K.toarray() + np.diag(springs), full.M.toarray(), eigvals_only=True)
    modes = craig_bampton(full, [0, 30], below=3000.0)
    rigid = full.rigid()
    basis = np.hstack([rigid, modes.shape])
    K = basis.T @ (full.K @ basis) + basis.T * springs @ basis
    M = basis.T @ (full.M @ basis)
    got = eigh(K, M, eigvals_only=True)
    np.testing.assert_allclose(np.sqrt(got[:8]), np.sqrt(values[:8]), rtol=1e-3)


def test_modes_are_orthonormal_to_each_other_and_to_rigid_motion():
    full = stepped(12)
    modes = craig_bampton(full, [0, 12], 5)
    M = modes.shape.T @ (full.M @ modes.shape)
    np.testing.assert_allclose(M, np.eye(len(M)), atol=1e-8)
    coupled = full.rigid().T @ (full.M @ modes.shape)
    np.testing.assert_allclose(coupled, 0.0, atol=1e-6)
    K = modes.shape.T @ (full.K @ modes.shape)
    square = (2.0 * math.pi * modes.frequency) ** 2
    np.testing.assert_allclose(K, np.diag(square), atol=1e-6 * square.max())
    assert modes.rigid_residual < 1e-2 * modes.frequency[0]


def test_static_shape_of_the_interface_is_exact():
    """A force between the interface nodes gives the full model's deflection, with all modes kept."""
    full = stepped(12)
    modes = craig_bampton(full, [0, 6, 12], 0)
    load = np.zeros(full.size)
    ends = [full.displacements(k)[0] for k in (0, 6, 12)]
    load[ends] = 1.0, -2.0, 1.0
    eta = (modes.shape.T @ load) / (2.0 * math.pi * modes.frequency) ** 2
    u = modes.shape @ eta
    rest = full.K @ u - load
    # rigid motion apart the equilibrium holds
    np.testing.assert_allclose(rest[ends], 0.0, atol=1e-5)
    np.testing.assert_allclose(rest, 0.0, atol=1e-5)


def test_selection_and_sparse_algebra_agree():
    full = beam_line([Beam(section=rectangle(0.03, 0.02), length=0.01, **STEEL)] * 120)
    assert full.size > 600  # takes the sparse way
    modes = free_modes(full, 6)
    values = eigh(full.K.toarray(), full.M.toarray(), eigvals_only=True)[6:12]
    np.testing.assert_allclose(modes.frequency, np.sqrt(values) / (2.0 * math.pi), rtol=1e-6)
    reduced = craig_bampton(full, [0, 120], below=2000.0)
    np.testing.assert_allclose(reduced.frequency[:4], modes.frequency[:4], rtol=1e-3)
    below = reduced.select(below=modes.frequency[3] * 1.01)
    assert below.frequency.size == 4
    assert below.select(count=2).shape.shape == (full.size, 2)
    np.testing.assert_allclose(modal_damping(below, 0.02), 0.04 * 2.0 * math.pi * below.frequency, rtol=1e-14)


def test_one_node_shows_its_six_shapes():
    full = stepped(12)
    modes = craig_bampton(full, [0, 12], 2)
    np.testing.assert_array_equal(modes.at_node(full, 12), modes.shape[-6:])


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda K, M, x: (K[:-1, :-1], M, x), "K has 17"),
        (lambda K, M, x: (K + csc_array(np.diag([1e9] + [0.0] * 17)), M, x), "remove supports"),
        (lambda K, M, x: (K, M, x[:-1]), "neither 3 nor 6"),
        (lambda K, M, x: (K * np.nan, M, x), "not finite"),
        (lambda K, M, x: (np.triu(K.toarray()), M, x), "both triangles"),
    ],
)
def test_matrices_that_are_no_body(change, message):
    line = beam_line([Beam(section=tube(0.05), length=0.3, **STEEL)] * 2)
    with pytest.raises(CompileError, match=message):
        make_structure(*change(line.K, line.M, line.places))


def test_loose_parts_and_wrong_interfaces():
    line = beam_line([Beam(section=tube(0.05), length=0.3, **STEEL)] * 2)
    with pytest.raises(CompileError, match="interface"):
        craig_bampton(line, [7], 1)
    two = make_structure(
        block_diag([line.K, line.K]),
        block_diag([line.M, line.M]),
        np.vstack([line.places, line.places + 1.0]),
    )
    with pytest.raises(CompileError, match="connected to no interface|not connected|six rigid"):
        craig_bampton(two, [0], 2)
    solid = truss()
    with pytest.raises(CompileError, match="do not constrain all rigid-body motions"):
        craig_bampton(solid, [0], 2)


def mass_matrix(found, eta):
    """Mass matrix (6 + n, 6 + n) of (v, omega, eta') at a deflection."""
    n = eta.size
    M = np.zeros((6 + n, 6 + n))
    M[:3, :3] = found.mass * np.eye(3)
    M[3:6, :3] = np.cross(np.eye(3), found.first + found.momentum @ eta)
    M[3:6, 3:6] = found.inertia + np.einsum("k,kij->ij", eta, found.inertia_1)
    M[3:6, 3:6] += np.einsum("k,l,klij->ij", eta, eta, found.inertia_2)
    M[6:, :3] = found.momentum.T
    M[6:, 3:6] = (found.angular + np.einsum("k,kin->in", eta, found.angular_1)).T
    M[6:, 6:] = found.modal
    return np.tril(M) + np.tril(M, -1).T


def test_mass_integrals_are_those_of_the_point_masses():
    """Kinetic energy of any motion of any deflected state, summed over the points."""
    rng = np.random.default_rng(2)
    body = truss()
    modes = free_modes(body, 5)
    origin = np.array([0.1, -0.2, 0.3])
    found = mass_invariants(body, modes.shape, origin)
    masses = body.M.diagonal().reshape(-1, 3)[:, 0]
    for _ in range(3):
        eta, rate = 0.3 * rng.normal(size=5), rng.normal(size=5)
        v, w = rng.normal(size=3), rng.normal(size=3)
        x = body.places - origin + (modes.shape @ eta).reshape(-1, 3)
        speed = v + np.cross(w, x) + (modes.shape @ rate).reshape(-1, 3)
        energy = 0.5 * np.sum(masses[:, None] * speed**2)
        all_rates = np.concatenate([v, w, rate])
        assert 0.5 * all_rates @ mass_matrix(found, eta) @ all_rates == pytest.approx(energy, rel=1e-12)


def test_mass_integrals_of_a_consistent_mass_are_those_of_the_rod():
    beam = Beam(section=tube(0.05), length=0.1, **STEEL)
    line = beam_line([beam] * 10)
    found = mass_invariants(line, np.zeros((line.size, 0)))
    assert found.mass == pytest.approx(10 * beam.mass, rel=1e-12)
    np.testing.assert_allclose(found.first, [0.0, 0.0, 5.0 * beam.mass], atol=1e-12)
    assert found.inertia[2, 2] == pytest.approx(beam.rho * 1.0 * beam.section.J, rel=1e-12)
