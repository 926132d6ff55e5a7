# SPDX-License-Identifier: Apache-2.0
"""Beam elements with full section matrices: tangents, potential, invariance, equality with plain sections."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.elements.beam import beam_row
from pitchpoint.multibody.beam_coupling import Coupling, coupling, end_matrix, parallel_compliance
from pitchpoint.multibody.beam_section import Beam
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.joints import FLOATING
from pitchpoint.solvers.implicit.generalized_alpha import start
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import differences, frame
from tests.unit.elements.test_beam import FLAT, SOFT, one, stirred


def full_section(size=1.0):
    """Stiffness matrix of a section with all couplings, positive definite."""
    parts = np.random.default_rng(1).normal(size=(6, 6))
    scale = np.sqrt([3e5, 2e5, 4e5, 900.0, 1200.0, 500.0])
    return size * scale[:, None] * (parts @ parts.T / 6.0 + np.eye(6)) * scale


@pytest.fixture(scope="module")
def beam():
    """Element with mass, all couplings in stiffness and, other than these, in damping."""
    part = coupling(np.linalg.inv(full_section()), 0.4)
    rough = np.random.default_rng(2).normal(size=(6, 6))
    return Beam(section=FLAT, length=0.4, coupling=Coupling(part.stiffness, rough @ rough.T), **SOFT)


@pytest.mark.nojit
def test_tangents_are_derivatives(beam):
    system = one("beam", beam=beam, gravity=(1.0, 2.0, -9.81))
    state = stirred(system)
    M, D, K = evaluate.linearize(system, state)
    for found, key, step in ((M, "a", 1e-2), (D, "v", 1e-5), (K, "q", 1e-6)):
        np.testing.assert_allclose(found, differences(system, state, key, step), atol=1e-8 * np.abs(K).max())


def test_small_motion_is_that_of_the_matrix(beam):
    bodies = [Body(motion=FLOATING, position=(0, 0, z), inertia=np.eye(3), mass=1.0) for z in (0.0, 0.4)]
    system = assemble(bodies, {"beam": beam_row(beam, bodies=(1, 2))})
    K = evaluate.linearize(system, system.initial_state())[2]
    np.testing.assert_allclose(K, beam.stiffness(), atol=1e-12 * np.abs(K).max())
    rigid = np.vstack([np.eye(6), np.eye(6)])
    rigid[6, 4], rigid[7, 3] = 0.4, -0.4
    np.testing.assert_allclose(beam.stiffness() @ rigid, 0.0, atol=1e-12 * np.abs(K).max())


def test_moved_and_turned_world_changes_nothing(beam):
    rng = np.random.default_rng(5)
    first = one("beam", beam=beam)
    second = one("beam", beam=beam, turn=frame(rng), shift=rng.normal(size=3))
    state = stirred(first)
    before, after = evaluate.residual(first, state), evaluate.residual(second, state)
    np.testing.assert_allclose(after, before, atol=1e-11 * np.abs(before).max())
    np.testing.assert_allclose(
        evaluate.observe(second, state), evaluate.observe(first, state), atol=1e-11 * np.abs(before).max()
    )


def test_uncoupled_sections_are_those_of_the_plain_element():
    """Stiffness and shear parameter of a flat section; forces within 1 % at rotations of 0.1 rad."""
    plain = Beam(section=FLAT, length=0.4, **SOFT)
    own = Beam(section=FLAT, length=0.4, coupling=coupling(compliance_of(plain), 0.4), **SOFT)
    np.testing.assert_allclose(own.stiffness(), plain.stiffness(), atol=1e-12 * plain.stiffness().max())
    assert (own.phi(1), own.phi(2)) == pytest.approx((plain.phi(1), plain.phi(2)), rel=1e-12)
    systems = [one("beam", beam=each) for each in (plain, own)]
    state = stirred(systems[0])
    state.a[:], state.v[:] = 0.0, 0.0
    a, b = (evaluate.residual(s, state) for s in systems)
    np.testing.assert_allclose(a, b, atol=1e-2 * np.abs(a).max())


def compliance_of(beam, centre=(0.0, 0.0), shear_centre=(0.0, 0.0)):
    """Compliance of a section of E, G and a plain section."""
    s = beam.section
    return parallel_compliance(
        centre=centre,
        shear_centre=shear_centre,
        bending=(beam.E * s.I_1, beam.E * s.I_2),
        shear=(s.kappa_1 * s.A * beam.G, s.kappa_2 * s.A * beam.G),
        axial=beam.E * s.A,
        torsion=beam.G * s.J,
    )


def test_centres_off_the_axis_are_elements_in_parallel():
    """One element has the stiffness of two: axial stiffness on the line of the elastic centres, the rest on
    that of the shear centres."""
    beam, e, s = Beam(section=FLAT, length=0.4, **SOFT), (0.02, -0.03), (-0.01, 0.05)
    K = beam.stiffness()
    along = np.zeros((12, 12))
    along[np.ix_([2, 8], [2, 8])] = K[np.ix_([2, 8], [2, 8])]
    expected = sum(moved(part, place) for part, place in ((K - along, s), (along, e)))
    # bending is that about the elastic centre, on whichever line it acts
    found = Beam(
        section=FLAT, length=0.4, coupling=coupling(compliance_of(beam, e, s), 0.4), **SOFT
    ).stiffness()
    np.testing.assert_allclose(found, expected, atol=1e-12 * np.abs(found).max())


def moved(K, place):
    """Matrix of an element on nodes fixed to others at a distance."""
    x, y = place
    arm = np.eye(6)
    arm[0, 5], arm[1, 5], arm[2, 3], arm[2, 4] = -y, x, y, -x
    both = np.kron(np.eye(2), arm)
    return both.T @ K @ both


def test_the_compliance_of_the_end_is_the_integral():
    """Tip of a cantilever against quadrature of B^T S B with 4 points, for all loads."""
    soft, length = np.linalg.inv(full_section()), 0.4
    end = end_matrix(length)
    found = np.linalg.inv(end.T @ coupling(soft, length).stiffness @ end)
    expected = np.zeros((6, 6))
    for x, w in zip(*np.polynomial.legendre.leggauss(4), strict=True):
        forces = np.eye(6)
        forces[3, 1], forces[4, 0] = -0.5 * (1.0 - x) * length, 0.5 * (1.0 - x) * length
        expected += 0.5 * w * length * forces.T @ soft @ forces
    np.testing.assert_allclose(found, expected, atol=1e-12 * np.abs(expected).max())


def thrown():
    """Two bodies with a soft element between them, thrown and turning."""
    bodies = [
        Body(motion=FLOATING, position=(0, 0, z), inertia=np.diag([0.1, 0.2, 0.15]), mass=1.0, name=n)
        for n, z in (("a", 0.0), ("b", 0.4))
    ]
    part = coupling(np.linalg.inv(full_section(0.02)), 0.4)
    beam = Beam(section=FLAT, length=0.4, E=0.0, G=0.0, coupling=part)
    system = assemble(bodies, {"beam": beam_row(beam, bodies=(1, 2))})
    state = system.initial_state()
    state.v[:] = [0.0, -0.6, 0.0, 3.0, 0.5, 1.0, 0.05, 0.6, 0.02, 2.9, 0.1, 1.4]
    return system, state


def energies(system, state):
    """Kinetic and strain energy together, and strain energy."""
    evaluate.residual(system, state)
    kinetic = 0.0
    for body, f in zip(system.bodies, system.workspace.fr[1:], strict=True):
        inertia = f["S"] @ body.inertia @ f["S"].T
        kinetic += 0.5 * body.mass * f["tw"][:3] @ f["tw"][:3] + 0.5 * f["tw"][3:] @ inertia @ f["tw"][3:]
    b = system.records["beam"][0]
    w, y = b["w"], b["y"][0]
    angle = np.arctan2(np.linalg.norm(np.cross(w[3], w[4])), w[3] @ w[4])
    across = (w[3] + w[4]) - (w[3] + w[4]) @ w[2] * w[2]
    strain = 0.5 * (b["k_u"] * y[0] ** 2 + b["k_t"] * y[1] ** 2 + y @ b["Q"] @ y)
    strain += 0.5 * (b["k_d"] * angle**2 + b["k_s"] * across @ across)
    return kinetic + strain, strain


@pytest.mark.parametrize("size", [0.1, 0.6])
def test_forces_have_a_potential(size):
    """The force in coordinates is the gradient of the strain energy, its stiffness symmetric, at any
    deflection and rotation."""
    system, state = thrown()
    state.v[:] = 0.0
    state.q[:] = size * np.random.default_rng(1).normal(size=12)
    force, K = evaluate.residual(system, state).copy(), evaluate.linearize(system, state)[2]
    np.testing.assert_allclose(K, K.T, atol=1e-13 * np.abs(K).max())
    for k in range(12):
        around = []
        for step in (1e-6, -1e-6):
            near = state.copy()
            near.q[k] += step
            around.append(energies(system, near)[1])
        assert (around[0] - around[1]) / 2e-6 == pytest.approx(force[k], abs=1e-9 * np.abs(force).max())


def test_energy_of_a_tumbling_beam_stays():
    """To 1e-4 over half a second, while more than half of it goes to and fro."""
    system, state = thrown()
    begin = energies(system, state)[0]
    run = start(system, state, 5e-4, rho_inf=1.0)
    strain = 0.0
    for _ in range(25):
        run.advance(40)
        now = run.state()
        found = energies(system, now)
        evaluate.load(system, now)
        assert found[0] == pytest.approx(begin, rel=1e-4)
        strain = max(strain, found[1])
    assert strain > 0.5 * begin
