# SPDX-License-Identifier: Apache-2.0
"""A helical tooth on one pitch by scikit-fem (BSD): another geometry of layers, other shape functions."""

from __future__ import annotations

import math

import numpy as np
import pytest
import skfem

from pitchpoint.contact.tooth_fe.contour import Contour
from pitchpoint.contact.tooth_fe.loads import flank_cases, flank_load
from pitchpoint.contact.tooth_fe.section_mesh import Density, section_mesh
from pitchpoint.contact.tooth_fe.solid import Solid, freedoms
from pitchpoint.contact.tooth_fe.width_basis import WidthBasis
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.tooth_form import tooth_form

E, NU = 206.0e9, 0.3
LAYERS = 8


def bricks(section, z, twist):
    """Hexahedra with 27 nodes by layers of a section of order two."""
    n = section.points.size
    points = (section.points * np.exp(1j * twist * z)[:, None]).ravel()
    nodes = np.stack([points.real, points.imag, np.repeat(z, n)])
    quads = section.elements
    cells = [np.stack([quads + (2 * k + j) * n for j in range(3)], axis=-1) for k in range((len(z) - 1) // 2)]
    return nodes, np.concatenate(cells)


def test_a_helical_tooth_agrees_with_scikit_fem():
    """Clamped sides and bore; uniform, linear and quadratic forces over the width on a line of the flank."""
    gear = CylindricalGear(z=20, m_n=1e-3, b=4e-3, beta=0.3)
    contour = Contour(tooth_form(gear))
    section = section_mesh(contour, gear.m_n, 7e-3, Density(order=2, body=(0.0, 1.0)))
    twist = 2.0 * math.tan(gear.beta) / gear.d
    solid = Solid(section, gear.z, E, NU, twist, WidthBasis(gear.b, 9))
    fixed = np.unique(np.concatenate([section.clamped, section.clockwise, section.counter]))
    rho = 0.5 * sum(contour.roll)
    (free,) = freedoms(9, True)
    cases = flank_cases(solid, contour, np.array([rho]), np.ones((1, 1)))
    none = np.empty(0, np.int64)
    ours = solid.condensed(np.arange(len(section.elements)), free, fixed, none, cases).compliance[:3, :3]
    theirs = compliance_by_scikit_fem(section, contour, rho, gear, fixed)
    # their layers are 0.5 mm thick, our polynomials have order eight
    assert ours == pytest.approx(theirs, rel=5e-3, abs=5e-3 * ours.max())


def compliance_by_scikit_fem(section, contour, rho, gear, fixed):
    """Displacements of the loaded line in its three lowest polynomials [m²/N], shape (3, 3)."""
    from skfem.helpers import ddot, sym_grad, trace

    twist = 2.0 * math.tan(gear.beta) / gear.d
    z = np.linspace(-0.5 * gear.b, 0.5 * gear.b, 2 * LAYERS + 1)
    nodes, cells = bricks(section, z, twist)
    # corners and order of the 27 nodes of scikit-fem, by their positions in the unit cube
    element = skfem.ElementVector(skfem.ElementHex2())
    lame, G = E * NU / ((1.0 + NU) * (1.0 - 2.0 * NU)), 0.5 * E / (1.0 + NU)
    where = np.rint(2.0 * skfem.ElementHex2().doflocs).astype(int)
    order = where @ np.array([9, 3, 1])
    flat = cells.reshape(len(cells), 27)
    corners = flat[:, order[:8]].T
    used, renumbered = np.unique(corners, return_inverse=True)
    mesh = skfem.MeshHex2.from_mesh(skfem.MeshHex(nodes[:, used], renumbered.reshape(corners.shape)))
    mesh = skfem.MeshHex2(mesh.doflocs, mesh.t, sort_t=False)
    base = skfem.Basis(mesh, skfem.ElementHex2(), intorder=6)
    # curved map: node positions of ours at the degrees of freedom of the mesh
    positions = np.empty((3, base.N))
    positions[:, base.element_dofs] = nodes[:, flat[:, order].T]
    mesh = skfem.MeshHex2(positions, base.mesh.t, sort_t=False)
    basis = skfem.Basis(mesh, element, intorder=6)

    @skfem.BilinearForm
    def energy(u, v, _):
        e, f = sym_grad(u), sym_grad(v)
        return lame * trace(e) * trace(f) + 2.0 * G * ddot(e, f)

    K = energy.assemble(basis)
    number = np.empty(nodes.shape[1], np.int64)  # ours to theirs
    number[flat[:, order].T] = base.element_dofs
    dof = basis.element_dofs  # three components at each node
    vector = np.empty((base.N, 3), np.int64)
    vector[base.element_dofs.ravel()] = dof.reshape(27, 3, -1).transpose(0, 2, 1).reshape(-1, 3)
    clamped = vector[number[(fixed[:, None] + section.points.size * np.arange(z.size)).ravel()]].ravel()
    loaded, shares, force = flank_load(section, contour, rho)
    full = np.column_stack([force, twist * contour.form.r_b * shares])
    width, loads = WidthBasis(gear.b, 3), np.zeros((K.shape[0], 3))
    line = section.elements[loaded].ravel()
    points, weights = np.polynomial.legendre.leggauss(5)
    for k in range(LAYERS):
        at = 0.5 * (z[2 * k] + z[2 * k + 2]) + 0.5 * points * (z[2 * k + 2] - z[2 * k])
        parabolas = np.stack([0.5 * points * (points - 1.0), 1.0 - points**2, 0.5 * points * (points + 1.0)])
        turn = np.exp(1j * twist * at)
        psi = width.values(at) * (weights * 0.5 * (z[2 * k + 2] - z[2 * k]))[:, None]
        for j in range(3):
            rows = vector[number[line + (2 * k + j) * section.points.size]]
            plane = (full[:, 0] + 1j * full[:, 1])[:, None] * turn
            for c, part in enumerate((plane.real, plane.imag, np.repeat(full[:, 2:], 5, axis=1))):
                loads[rows[:, c]] += (part * parabolas[j]) @ psi
    keep = np.setdiff1d(np.arange(K.shape[0]), clamped)
    from scipy.sparse.linalg import spsolve

    return loads[keep].T @ spsolve(K[keep][:, keep].tocsc(), loads[keep])
