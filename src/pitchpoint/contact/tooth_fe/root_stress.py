# SPDX-License-Identifier: Apache-2.0
"""Stresses at the surface of the fillet as load cases: the stress is the displacement of such a case.

Derivation: docs/theory/tooth_fe.md, "Root stress".
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.tooth_fe.contour import Contour
from pitchpoint.contact.tooth_fe.section_matrices import shape, strain
from pitchpoint.contact.tooth_fe.solid import LoadCase, Solid

FloatArray = NDArray[np.float64]


def stress_points(contour: Contour, count: int) -> FloatArray:
    """Tangent angles of points of the fillet [rad], from root to involute, shape (count,).

    Parameters
    ----------
    contour
        Outline of the tooth.
    count
        Number of points.

    Notes
    -----
    The point nearest to the critical section of ISO 6336-3 is moved to it: tangent at 30°, for internal gears
    at 60°.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> contour = Contour(tooth_form(CylindricalGear(z=17, m_n=1e-3)))
    >>> np.degrees(stress_points(contour, 5)).round(2).tolist()
    [79.83, 59.87, 30.0, 19.96, 0.0]
    """
    low, high = contour.tangent_range
    found = np.linspace(min(high, math.radians(80.0)), max(low, 0.0), count)
    standard = math.radians(60.0 if contour.form.is_internal else 30.0)
    if low < standard < high:
        found[int(np.argmin(np.abs(found - standard)))] = standard
    return found


def stress_cases(solid: Solid, contour: Contour, tangents: FloatArray, first: int) -> list[LoadCase]:
    """Load cases of the stresses at points of the fillet at the left flank.

    Parameters
    ----------
    solid, contour
        The gear.
    tangents
        Tangent angles of the points [rad], shape (n,).
    first
        Number of the first case.

    Returns
    -------
    list of LoadCase
        Component c of point f and polynomial p have the number first + (3 f + c) P + p. Components: along the
        profile, along the width, shear.

    Examples
    --------
    >>> from pitchpoint.contact.tooth_fe.section_mesh import Density, section_mesh
    >>> from pitchpoint.contact.tooth_fe.width_basis import WidthBasis
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> contour = Contour(tooth_form(CylindricalGear(z=17, m_n=1e-3)))
    >>> mesh = section_mesh(contour, 1e-3, 5e-3, Density(order=2))
    >>> solid = Solid(mesh, 17, 206e9, 0.3, 0.0, WidthBasis(1e-2, 2))
    >>> [case.columns.tolist() for case in stress_cases(solid, contour, np.array([0.5]), 10)]
    [[10, 11, 12, 13, 14, 15]]
    """
    mesh, P = solid.mesh, solid.rim.count
    on_body = int(np.count_nonzero(mesh.column[mesh.fillet] == 1.0))
    cases = []
    for f, length in enumerate(contour.fillet_length_at(tangents)):
        k = int(np.clip(np.searchsorted(mesh.fillet_length, length) - 1, 0, mesh.fillet.size - 1))
        low, high = mesh.fillet_length[k : k + 2]
        xi = float(2.0 * (length - low) / (high - low) - 1.0)
        B, C = _surface_stress(solid, int(mesh.fillet[k]), xi, k < on_body)
        B, C = B[:, :, None, :, None], C[:, :, None, :, None]
        values = B * np.eye(P)[:, None] + C * solid.rim.slopes.T[:, None]
        columns = first + 3 * f * P + np.arange(3 * P)
        cases.append(LoadCase(int(mesh.fillet[k]), columns, values.reshape(*B.shape[:2], P, 3 * P)))
    return cases


def _surface_stress(solid: Solid, element: int, xi: float, on_body: bool) -> tuple[FloatArray, FloatArray]:
    """Stresses at a point of an edge by nodal displacements and their slopes over z, shape (n, 3, 3) each.

    Plane stress in the surface: its strains give the stresses, since it has no traction.
    """
    # columns of the body run from the tooth to the next root, rows of the tooth run upwards
    at = np.array([[-xi, -1.0] if on_body else [1.0, xi]])
    found = strain(solid.mesh, np.array([element]), (at[:, 0], at[:, 1]), solid.twist)
    values, slopes = shape(solid.mesh.order, at[:, 0], at[:, 1])
    nodes = solid.mesh.points[solid.mesh.elements[element].ravel()]
    place = (values @ nodes)[0]
    tangent = -(slopes[0] @ nodes)[0] if on_body else (slopes[1] @ nodes)[0]
    tangent /= abs(tangent)
    across = 1j * tangent
    # the surface contains the direction of the twisted axis, e_z + twist e_z × x
    lean = -solid.twist * (across * np.conj(1j * place)).real
    normal = np.array([across.real, across.imag, lean]) / math.hypot(1.0, lean)
    s = np.array([tangent.real, tangent.imag, 0.0])
    w = np.cross(s, normal)
    w *= math.copysign(1.0, w[2])
    projected = np.stack([_component(a, b) for a, b in ((s, s), (w, w), (s, w))])
    E, nu = solid.E, solid.nu
    elastic = E / (1.0 - nu * nu) * np.array([[1.0, nu, 0.0], [nu, 1.0, 0.0], [0.0, 0.0, 1.0 - nu]])
    rows = elastic @ projected
    B, C = ((rows @ part[0, 0]).reshape(3, -1, 3).transpose(1, 2, 0) for part in (found.B, found.C))
    return B, C


def _component(a: FloatArray, b: FloatArray) -> FloatArray:
    """Row that gives a·ε·b from strains in the order of `Strain`, shape (6,)."""
    first, second = np.array([0, 1, 2, 0, 1, 2]), np.array([0, 1, 2, 1, 2, 0])
    return np.asarray(0.5 * (a[first] * b[second] + a[second] * b[first]))
