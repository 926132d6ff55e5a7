# SPDX-License-Identifier: Apache-2.0
"""Matrices of the elements of a section: strain energy of displacements u(x, y) ψ(z) of a twisted solid.

Displacements are components in a frame that rotates with the section about the axis of the gear. In it the
solid and its strain energy do not depend on z, so that section and width separate.

Derivation: docs/theory/tooth_fe.md, "Twisted solid".
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.polynomial.legendre import leggauss

from pitchpoint.contact.tooth_fe.contour import FloatArray
from pitchpoint.contact.tooth_fe.section_mesh import SectionMesh, lobatto


@dataclass(frozen=True)
class Strain:
    """Strains of an element at points: B u + C ∂u/∂z with nodal values u.

    Components xx, yy, zz, xy, yz, zx (engineering shear), then nodes and directions.

    Parameters
    ----------
    B, C
        Shape (..., 6, 3 n) [1/m], [-].
    area
        Jacobian determinant at the points [m²], shape (...).
    """

    B: FloatArray
    C: FloatArray
    area: FloatArray


def elasticity(E: float, nu: float) -> FloatArray:
    """Stiffness of an isotropic solid [Pa], shape (6, 6), components as in `Strain`.

    Parameters
    ----------
    E, nu
        Young's modulus [Pa], Poisson's ratio.

    Examples
    --------
    >>> elasticity(2.5, 0.25)[0, :4].tolist()
    [3.0, 1.0, 1.0, 0.0]
    """
    G = 0.5 * E / (1.0 + nu)
    lame = 2.0 * G * nu / (1.0 - 2.0 * nu)
    found = np.diag([2.0 * G] * 3 + [G] * 3)
    found[:3, :3] += lame
    return found


def lagrange(order: int, xi: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Values and derivatives of the Lagrange polynomials on Gauss-Lobatto points, shapes (n, order + 1).

    Parameters
    ----------
    order
        Polynomial order.
    xi
        Positions in [-1, 1], shape (n,).

    Examples
    --------
    >>> [a.tolist() for a in lagrange(1, np.array([0.5]))]
    [[[0.25, 0.75]], [[-0.5, 0.5]]]
    """
    inverse = np.linalg.inv(np.vander(lobatto(order), increasing=True))
    powers = np.vander(xi, order + 1, increasing=True)
    slopes = np.zeros_like(powers)
    slopes[:, 1:] = powers[:, :-1] * np.arange(1, order + 1)
    return powers @ inverse, slopes @ inverse


def shape(order: int, first: FloatArray, second: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Shape functions of an element and their slopes at points.

    Parameters
    ----------
    order
        Polynomial order of the element.
    first, second
        Local coordinates of the points in [-1, 1], shape (n,).

    Returns
    -------
    values : ndarray, shape (n, (order + 1)²)
    slopes : ndarray, shape (2, n, (order + 1)²)

    Examples
    --------
    >>> values, slopes = shape(1, np.array([0.0]), np.array([0.0]))
    >>> values.tolist(), slopes[0].tolist()
    ([[0.25, 0.25, 0.25, 0.25]], [[-0.25, -0.25, 0.25, 0.25]])
    """
    (a, da), (b, db) = lagrange(order, first), lagrange(order, second)

    def product(left: FloatArray, right: FloatArray) -> FloatArray:
        """Products of functions of both coordinates, shape (n, (order + 1)²)."""
        return np.einsum("pi,pj->pij", left, right).reshape(len(left), -1)

    return product(a, b), np.stack([product(da, b), product(a, db)])


def strain(
    mesh: SectionMesh, elements: np.ndarray, at: tuple[FloatArray, FloatArray], twist: float
) -> Strain:
    """Strains of elements at points.

    Parameters
    ----------
    mesh
        The section.
    elements
        Element numbers, shape (m,).
    at
        Local coordinates of the points, shape (p,) each.
    twist
        Rotation of the section per length, 2 tan β / |d| [rad/m].

    Returns
    -------
    Strain
        With leading shape (m, p).

    Examples
    --------
    >>> from pitchpoint.contact.tooth_fe.contour import Contour
    >>> from pitchpoint.contact.tooth_fe.section_mesh import Density, section_mesh
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> contour = Contour(tooth_form(CylindricalGear(z=17, m_n=1e-3)))
    >>> mesh = section_mesh(contour, 1e-3, 5e-3, Density(order=2))
    >>> strain(mesh, np.array([0]), (np.zeros(1), np.zeros(1)), 0.0).B.shape
    (1, 1, 6, 27)
    """
    values, slopes = shape(mesh.order, *at)
    corner = mesh.points[mesh.elements[elements].reshape(len(elements), -1)]
    jacobian = np.einsum("dpn,en->epd", slopes, corner)  # ∂(x + iy)/∂ξ_d
    x_1, x_2, y_1, y_2 = (part[..., d] for part in (jacobian.real, jacobian.imag) for d in (0, 1))
    area = x_1 * y_2 - x_2 * y_1
    N_x = (y_2[..., None] * slopes[0] - y_1[..., None] * slopes[1]) / area[..., None]
    N_y = (x_1[..., None] * slopes[1] - x_2[..., None] * slopes[0]) / area[..., None]
    place = np.einsum("pn,en->ep", values, corner)[..., None]
    N = np.broadcast_to(values, N_x.shape)
    rate = twist * (place.imag * N_x - place.real * N_y)  # of a scalar that rotates with the section
    B = np.zeros((*N_x.shape[:2], 6, N_x.shape[2], 3))
    C = np.zeros_like(B)
    u, v, w = 0, 1, 2
    B[:, :, 0, :, u], B[:, :, 1, :, v] = N_x, N_y
    B[:, :, 3, :, u], B[:, :, 3, :, v] = N_y, N_x
    B[:, :, 2, :, w], C[:, :, 2, :, w] = rate, N
    B[:, :, 4, :, w], B[:, :, 4, :, v], B[:, :, 4, :, u] = N_y, rate, twist * N
    B[:, :, 5, :, w], B[:, :, 5, :, u], B[:, :, 5, :, v] = N_x, rate, -twist * N
    C[:, :, 4, :, v], C[:, :, 5, :, u] = N, N
    flat = (*N_x.shape[:2], 6, -1)
    return Strain(B.reshape(flat), C.reshape(flat), area)


def element_matrices(
    mesh: SectionMesh, E: float, nu: float, twist: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Energy matrices of all elements: ∫ BᵀDB, ∫ BᵀDC and ∫ CᵀDC over the section.

    Parameters
    ----------
    mesh
        The section.
    E, nu
        Young's modulus [Pa], Poisson's ratio.
    twist
        Rotation of the section per length [rad/m].

    Returns
    -------
    tuple of ndarray, shape (m, 3 n, 3 n) each
        [Pa], [Pa m], [Pa m²].

    Examples
    --------
    >>> from pitchpoint.contact.tooth_fe.contour import Contour
    >>> from pitchpoint.contact.tooth_fe.section_mesh import Density, section_mesh
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> contour = Contour(tooth_form(CylindricalGear(z=17, m_n=1e-3)))
    >>> mesh = section_mesh(contour, 1e-3, 5e-3, Density(order=2))
    >>> [a.shape for a in element_matrices(mesh, 206e9, 0.3, 0.0)][0] == (len(mesh.elements), 27, 27)
    True
    """
    points, weights = leggauss(mesh.order + 1)
    first, second = (grid.ravel() for grid in np.meshgrid(points, points, indexing="ij"))
    found = strain(mesh, np.arange(len(mesh.elements)), (first, second), twist)
    dA = np.abs(found.area) * np.outer(weights, weights).ravel()
    D = elasticity(E, nu)
    DB, DC = (np.einsum("ab,epbn,ep->epan", D, part, dA) for part in (found.B, found.C))

    def energy(left: FloatArray, right: FloatArray) -> FloatArray:
        """Sums over points and components, shape (m, 3 n, 3 n)."""
        flat = (len(left), -1, left.shape[-1])
        return np.asarray(np.swapaxes(left.reshape(flat), 1, 2) @ right.reshape(flat))

    return energy(found.B, DB), energy(found.B, DC), energy(found.C, DC)
