# SPDX-License-Identifier: Apache-2.0
"""Local indentation of a flank by a concentrated force, which is replaced by Hertzian contact.

The half of the pitch on the loaded side, clamped at the centre line of the tooth, has the same indentation as
the gear in the same mesh. An elastic half-plane gives the displacement of the centre line relative to its
intersection with the line of force, which refers the rest to this point.

Source: Andersson and Vedmar, J. Sound Vib. 260 (2003) 195; Fernández del Rincón et al., Mech. Mach. Theory 61
(2013) 30; half-plane: Johnson, Contact Mechanics (1985), 2.2.

Derivation: docs/theory/tooth_fe.md, "Local indentation".
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.tooth_fe.contour import ComplexArray, Contour
from pitchpoint.contact.tooth_fe.loads import flank_cases
from pitchpoint.contact.tooth_fe.section_mesh import SectionMesh
from pitchpoint.contact.tooth_fe.solid import PLANE_STRAIN, Freedoms, LoadCase, Solid
from pitchpoint.contact.tooth_fe.substructure import Part

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]


def half_plane(points: ComplexArray, depth: float, E: float, nu: float) -> ComplexArray:
    """Displacement of an elastic half-plane under a unit line force, relative to a point below the force.

    Plane strain. The force acts at the origin along the real axis, which points into the material.

    Parameters
    ----------
    points
        Points x + iy [m], shape (n,).
    depth
        Depth of the fixed point [m].
    E, nu
        Young's modulus [Pa], Poisson's ratio.

    Returns
    -------
    ndarray, shape (n,)
        Displacement per force per length, u_x + i u_y [m²/N].

    Examples
    --------
    >>> u = half_plane(np.array([1.0, 0.5]), 1.0, 1.0, 0.0)
    >>> u.real.round(6).tolist(), round(2.0 / math.pi * math.log(2.0), 6)
    ([0.0, 0.441271], 0.441271)
    """
    a, r, theta = 2.0 * (1.0 - nu * nu) / (math.pi * E), np.abs(points), np.angle(points)
    b = (1.0 - 2.0 * nu) * (1.0 + nu) / (math.pi * E)
    log = a * np.log(r / depth)
    radial = -log * np.cos(theta) - b * theta * np.sin(theta)
    around = log * np.sin(theta) - b * theta * np.cos(theta)
    around = around + (2.0 * nu * (1.0 + nu) / (math.pi * E) + b) * np.sin(theta)
    return np.asarray((radial + 1j * around) * np.exp(1j * theta))


def contact_depth(contour: Contour, rho: FloatArray) -> FloatArray:
    """Distance from the flank to the centre line of the tooth along the base tangent [m], shape of rho.

    Parameters
    ----------
    contour
        Outline of the tooth.
    rho
        Lengths of roll [m].

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> contour = Contour(tooth_form(CylindricalGear(z=17, m_n=1e-3)))
    >>> (1e3 * contact_depth(contour, np.array([2.907e-3]))).round(3).tolist()    # pitch point
    [0.811]
    """
    return np.asarray(contour.involute(rho).imag / -contour.inward_normal(rho).imag)


def half_pitch(mesh: SectionMesh, column: float = 0.0) -> tuple[IntArray, IntArray]:
    """Elements on the loaded side of a mesh line, and nodes at the border of the rest of the gear.

    Parameters
    ----------
    mesh
        The section.
    column
        Position of the line as in `Density.across`; 0 is the centre line of the tooth.

    Returns
    -------
    elements : ndarray, shape (m,)
    nodes : ndarray, shape (n,)

    Examples
    --------
    >>> from pitchpoint.contact.tooth_fe.section_mesh import Density, section_mesh
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> contour = Contour(tooth_form(CylindricalGear(z=17, m_n=1e-3)))
    >>> mesh = section_mesh(contour, 1e-3, 5e-3, Density())
    >>> 2 * half_pitch(mesh)[0].size == len(mesh.elements)
    True
    """
    first = np.isclose(mesh.column, column)
    line = np.unique(mesh.elements[first][:, 0, :])
    return np.flatnonzero(mesh.column >= column - 1e-9), np.union1d(line, mesh.counter)


def clamped_half(solid: Solid, free: Freedoms, cases: list[LoadCase]) -> Part:
    """Compliance of the clamped half, without remaining nodes.

    Parameters
    ----------
    solid
        The gear.
    free
        Values of each node.
    cases
        Load cases.

    Examples
    --------
    >>> from pitchpoint.contact.tooth_fe.section_mesh import Density, section_mesh
    >>> from pitchpoint.contact.tooth_fe.width_basis import WidthBasis
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> contour = Contour(tooth_form(CylindricalGear(z=17, m_n=1e-3)))
    >>> mesh = section_mesh(contour, 1e-3, 5e-3, Density(order=2))
    >>> solid = Solid(mesh, 17, 206e9, 0.3, 0.0, WidthBasis(1e-2, 2))
    >>> (free,) = [PLANE_STRAIN]
    >>> cases = flank_cases(solid, contour, np.array([3e-3]), np.eye(1))
    >>> clamped_half(solid, free, cases).compliance.shape
    (1, 1)
    """
    elements, clamped = half_pitch(solid.mesh)
    fixed, none = np.union1d(clamped, solid.mesh.clamped), np.empty(0, np.int64)
    return solid.condensed(elements, free, fixed, none, cases)


def indentation(
    solid: Solid, contour: Contour, rho: FloatArray, column: float = 0.0
) -> tuple[FloatArray, FloatArray]:
    """Indentation of the half pitch in plane strain, with its inner border clamped and by its displacement.

    Parameters
    ----------
    solid, contour
        The gear.
    rho
        Lengths of roll of the forces [m], shape (n,).
    column
        Inner border, see `half_pitch`.

    Returns
    -------
    clamped : ndarray, shape (n,)
        Displacement under the force with clamped border, per force per length [m²/N].
    moved : ndarray, shape (n,)
        Displacement due to the border when it moves like that of the half-plane [m²/N].

    Examples
    --------
    The effect of the border is about a fifth of 2 (1 - ν²)/(π E) = 2.8e-12 m²/N:

    >>> from pitchpoint.contact.tooth_fe.section_mesh import Density, section_mesh
    >>> from pitchpoint.contact.tooth_fe.width_basis import WidthBasis
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> contour = Contour(tooth_form(CylindricalGear(z=17, m_n=1e-3)))
    >>> mesh = section_mesh(contour, 1e-3, 5e-3, Density(order=2))
    >>> solid = Solid(mesh, 17, 206e9, 0.3, 0.0, WidthBasis(1e-2, 2))
    >>> clamped, moved = indentation(solid, contour, np.array([3e-3]))
    >>> (1e12 * moved).round(1).tolist()
    [-0.6]
    """
    mesh = solid.mesh
    elements, border = half_pitch(mesh, column)
    cases = flank_cases(solid, contour, rho, np.eye(rho.size))
    ends = np.intersect1d(mesh.clamped, mesh.elements[elements])
    none = np.empty(0, np.int64)
    half = solid.condensed(elements, PLANE_STRAIN, none, np.union1d(border, ends), cases)
    origin, axis = contour.involute(rho)[:, None], contour.inward_normal(rho)[:, None]
    depth = contact_depth(contour, rho)
    moved = np.empty(rho.size)
    for k in range(rho.size):
        u = half_plane((mesh.points[half.nodes] - origin[k]) / axis[k], float(depth[k]), solid.E, solid.nu)
        u = u * axis[k] * np.exp(-1j * solid.axes[half.nodes])
        moved[k] = half.R[:, k] @ np.column_stack([u.real, u.imag]).ravel()
    return np.diag(half.compliance).copy(), moved
