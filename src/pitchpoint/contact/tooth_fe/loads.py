# SPDX-License-Identifier: Apache-2.0
"""Load cases of the left flank of a tooth: Legendre polynomials over height and width.

Heights t are -1 at the root end of the involute and +1 at its tip end, linear in the length of roll.

Derivation: docs/theory/tooth_fe.md, "Loads".
"""

from __future__ import annotations

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from pitchpoint.contact.tooth_fe.contour import Contour
from pitchpoint.contact.tooth_fe.section_matrices import shape
from pitchpoint.contact.tooth_fe.section_mesh import SectionMesh
from pitchpoint.contact.tooth_fe.solid import LoadCase, Solid

FloatArray = NDArray[np.float64]

HEIGHTS = 10
"""Heights at which a polynomial force acts on the flank, at the points of a Gauss rule."""


def roll_at(contour: Contour, t: FloatArray) -> FloatArray:
    """Lengths of roll at heights.

    Parameters
    ----------
    contour
        Outline of the tooth.
    t
        Heights.

    Returns
    -------
    ndarray, shape of t
        Lengths of roll [m].

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> contour = Contour(tooth_form(CylindricalGear(z=17, m_n=1e-3)))
    >>> (1e3 * roll_at(contour, np.array([1.0]))).round(4).tolist()    # of the tip
    [5.1431]
    """
    root, tip = contour.roll
    return np.asarray(0.5 * ((1.0 - t) * root + (1.0 + t) * tip))


def gauss_heights(count: int) -> tuple[FloatArray, FloatArray]:
    """Heights of a Gauss rule, shape (n,), and Legendre coefficients of values there, shape (count, n).

    Parameters
    ----------
    count
        Number of Legendre polynomials.

    Examples
    --------
    >>> t, to_legendre = gauss_heights(3)
    >>> (abs(to_legendre @ (1.5 * t**2 - 0.5))).round(12).tolist()    # P_2
    [0.0, 0.0, 1.0]
    """
    t, weights = legendre.leggauss(max(HEIGHTS, count))
    return t, legendre.legvander(t, count - 1).T * weights * (np.arange(count)[:, None] + 0.5)


def flank_load(mesh: SectionMesh, contour: Contour, rho: float) -> tuple[int, FloatArray, FloatArray]:
    """Unit force into the left flank along the base tangent, as forces on the nodes of an element.

    Parameters
    ----------
    mesh, contour
        The section.
    rho
        Length of roll [m].

    Returns
    -------
    element : int
    shares : ndarray, shape (n,)
        Shares of the nodes.
    forces : ndarray, shape (n, 2)
        Forces on the nodes.

    Examples
    --------
    >>> from pitchpoint.contact.tooth_fe.section_mesh import Density, section_mesh
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> contour = Contour(tooth_form(CylindricalGear(z=17, m_n=1e-3)))
    >>> mesh = section_mesh(contour, 1e-3, 5e-3, Density())
    >>> _, shares, forces = flank_load(mesh, contour, 3e-3)
    >>> round(float(shares.sum()), 12), round(float(np.hypot(*forces.sum(axis=0))), 12)
    (1.0, 1.0)
    """
    borders = mesh.flank_roll**2
    rising = 1.0 if borders[-1] > borders[0] else -1.0
    row = int(np.clip(np.searchsorted(rising * borders, rising * rho * rho) - 1, 0, borders.size - 2))
    xi = 2.0 * (rho * rho - borders[row]) / (borders[row + 1] - borders[row]) - 1.0
    values, _ = shape(mesh.order, np.array([1.0]), np.array([xi]))
    normal = contour.inward_normal(np.array([rho]))[0]
    return int(mesh.flank[row]), values[0], np.outer(values[0], [normal.real, normal.imag])


def flank_cases(solid: Solid, contour: Contour, rho: FloatArray, combined: FloatArray) -> list[LoadCase]:
    """Load cases of combinations of forces at several heights, times all polynomials over the width.

    Parameters
    ----------
    solid, contour
        The gear.
    rho
        Lengths of roll of the forces [m], shape (n,).
    combined
        Forces there of each combination, shape (m, n).

    Returns
    -------
    list of LoadCase
        Combination k and polynomial p have the number k P + p; forces per length [N/m] are ψ_p(z), along the
        transverse base tangent, with the axial part of the normal force.

    Examples
    --------
    >>> from pitchpoint.contact.tooth_fe.section_mesh import Density, section_mesh
    >>> from pitchpoint.contact.tooth_fe.width_basis import WidthBasis
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> contour = Contour(tooth_form(CylindricalGear(z=17, m_n=1e-3)))
    >>> mesh = section_mesh(contour, 1e-3, 5e-3, Density(order=2))
    >>> solid = Solid(mesh, 17, 206e9, 0.3, 0.0, WidthBasis(1e-2, 2))
    >>> [case.columns.tolist() for case in flank_cases(solid, contour, np.array([3e-3]), np.eye(1))]
    [[0, 1]]
    """
    P, m = solid.rim.count, len(combined)
    n = solid.mesh.elements[0].size
    axial = solid.twist * contour.form.r_b
    found: dict[int, FloatArray] = {}
    for k, at in enumerate(rho):
        element, share, force = flank_load(solid.mesh, contour, float(at))
        total = found.setdefault(element, np.zeros((n, 3, m)))
        total += np.column_stack([force, axial * share])[:, :, None] * combined[:, k]
    cases = []
    for element, total in found.items():
        values = total[:, :, None, :, None] * np.eye(P)[None, None, :, None, :]
        cases.append(LoadCase(element, np.arange(m * P), values.reshape(n, 3, P, m * P)))
    return cases
