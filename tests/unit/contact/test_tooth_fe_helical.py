# SPDX-License-Identifier: Apache-2.0
"""Finite elements of helical gears: whole gear, local indentation, web."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu

from pitchpoint.contact.compliance.blank import Blank, blank_radii
from pitchpoint.contact.tooth_fe.contour import Contour
from pitchpoint.contact.tooth_fe.loads import flank_cases
from pitchpoint.contact.tooth_fe.local_part import contact_depth, half_pitch, half_plane, indentation
from pitchpoint.contact.tooth_fe.ring import ring, with_loads
from pitchpoint.contact.tooth_fe.section_mesh import Density, section_mesh
from pitchpoint.contact.tooth_fe.solid import Freedoms, Solid, freedoms
from pitchpoint.contact.tooth_fe.width_basis import WidthBasis
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.tooth_form import tooth_form
from tests.support.plane_teeth import NU, E

COUNT, LOADED = 3, 3
COARSE = Density(order=2, across=(0.0, 1.0), body=(0.0, 1.0))


def turned(k: int, z: int) -> np.ndarray:
    """Values in the axes of tooth k by those in the axes of tooth 0."""
    c, s = math.cos(2.0 * math.pi * k / z), math.sin(2.0 * math.pi * k / z)
    return np.kron([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]], np.eye(COUNT))


def restriction(solid: Solid) -> np.ndarray:
    """Polynomials of the rim in those of the web, fitted at many points."""
    if solid.web is None:
        return np.eye(3 * COUNT)
    z = 0.5 * solid.web.width * np.linspace(-1.0, 1.0, 41)
    found = np.linalg.lstsq(solid.web.values(z), solid.rim.values(z), rcond=None)[0]
    return np.kron(np.eye(3), found)


def directly(solid: Solid, cases) -> np.ndarray:
    """Displacements of three neighbouring teeth by forces on them [m²/N]."""
    mesh, z, d = solid.mesh, solid.z, 3 * COUNT
    own = np.setdiff1d(np.arange(mesh.points.size), mesh.counter)
    number = np.empty((z, mesh.points.size), np.int64)
    number[:, own] = np.arange(z * own.size).reshape(z, -1)
    number[:, mesh.counter] = np.roll(number, -1, axis=0)[:, mesh.clockwise]
    size, n = z * own.size * d, mesh.elements[0].size
    on_rim, shared = np.unique(mesh.elements[~mesh.web]), restriction(solid)
    rows, columns, data = [], [], []
    for e, nodes in enumerate(mesh.elements.reshape(-1, n)):
        is_web = solid.web is not None and mesh.web[e]
        S = solid.web.slopes if solid.web is not None and is_web else solid.rim.slopes
        B, mixed, C = (part[e] for part in solid.matrices)
        K = np.kron(B, np.eye(COUNT)) + np.kron(C, S.T @ S) + np.kron(mixed, S) + np.kron(mixed, S).T
        to = np.zeros_like(K)
        for i, node in enumerate(nodes):
            to[i * d : i * d + d, i * d : i * d + d] = shared if is_web and node in on_rim else np.eye(d)
        K = to.T @ K @ to
        for k in range(z):
            axes = np.kron(np.eye(n), turned(k, z))
            at = (number[k][nodes][:, None] * d + np.arange(d)).ravel()
            rows.append(np.repeat(at, at.size))
            columns.append(np.tile(at, at.size))
            data.append((axes.T @ K @ axes).ravel())
    where = np.concatenate(rows), np.concatenate(columns)
    matrix = coo_matrix((np.concatenate(data), where), shape=(size, size)).tocsc()
    F = np.zeros((size, LOADED * COUNT))
    for k in range(LOADED):
        for case in cases:
            forces = case.values.reshape(n, d, COUNT)
            for node, force in zip(mesh.elements[case.element].ravel(), forces, strict=True):
                start = number[k][node] * d
                F[start : start + d, k * COUNT : (k + 1) * COUNT] += turned(k, z).T @ force
    fixed = (np.unique(number[:, mesh.clamped])[:, None] * d + np.arange(d)).ravel()
    free = np.setdiff1d(np.arange(size), fixed)
    return np.asarray(F[free].T @ splu(matrix[free][:, free]).solve(F[free]))


@pytest.mark.parametrize(
    ("gear", "blank"),
    [
        (CylindricalGear(z=8, m_n=1e-3, x=0.4, b=6e-3, beta=0.3), (2e-3, None, None)),
        (CylindricalGear(z=9, m_n=1e-3, x=0.3, b=6e-3, beta=-0.3), (1.5e-3, 2.6e-3, 2e-3)),
        pytest.param(
            CylindricalGear.internal(z=30, m_n=1e-3, b=6e-3, beta=0.3),
            (19.5e-3, 18e-3, 2e-3),
            marks=pytest.mark.study,
        ),
    ],
    ids=["solid", "web", "internal web"],
)
def test_condensed_ring_is_the_whole_helical_gear(gear, blank):
    clamped, rim, web = blank
    contour = Contour(tooth_form(gear))
    mesh = section_mesh(contour, gear.m_n, clamped, COARSE, rim)
    twist = 2.0 * math.tan(gear.beta) / abs(gear.d)
    basis = None if web is None else WidthBasis(web, COUNT)
    solid = Solid(mesh, abs(gear.z), E, NU, twist, WidthBasis(gear.b, COUNT), basis)
    cases = flank_cases(solid, contour, np.array([0.5 * sum(contour.roll)]), np.eye(1))
    (free,) = freedoms(COUNT, True)
    borders = np.union1d(mesh.clockwise, mesh.counter)
    sector = solid.condensed(np.arange(len(mesh.elements)), free, mesh.clamped, borders, cases)
    number = np.arange(COUNT)
    found = ring([with_loads(sector, number, number + k * COUNT) for k in range(LOADED)], solid.z).compliance
    assert found == pytest.approx(directly(solid, cases), rel=1e-9, abs=1e-10 * found.max())


def moved_in_the_normal_section(solid: Solid, contour: Contour, rho: np.ndarray) -> np.ndarray:
    """Displacement under a line load by the border of the half pitch, which moves like the half-space.

    The solid is equal along the helix, and so are load and displacement, all three components of it.
    """
    mesh, free = solid.mesh, Freedoms(np.arange(3), np.zeros(3, np.int64))
    elements, border = half_pitch(mesh)
    kept = np.union1d(border, np.intersect1d(mesh.clamped, mesh.elements[elements]))
    cases = flank_cases(solid, contour, rho, np.eye(rho.size))
    half = solid.condensed(elements, free, np.empty(0, np.int64), kept, cases)
    steep = solid.twist * contour.form.r_b
    cos_b, found = 1.0 / math.hypot(1.0, steep), np.empty(rho.size)
    for k in range(rho.size):
        origin, into = (f(rho[k : k + 1])[0] for f in (contour.involute, contour.inward_normal))
        away = mesh.points[half.nodes] - origin
        # coordinates along the normal of the surface and, perpendicular to normal and contact line, across it
        x, y = cos_b * (away * into.conjugate()).real, (away * into.conjugate()).imag
        depth = cos_b * float(contact_depth(contour, rho[k : k + 1])[0])
        u = half_plane(x + 1j * y, depth, solid.E, solid.nu)
        plane = (u.real * cos_b + 1j * u.imag) * into * np.exp(-1j * solid.axes[half.nodes])
        found[k] = half.R[:, k] @ np.column_stack([plane.real, plane.imag, u.real * cos_b * steep]).ravel()
    return found


@pytest.mark.parametrize(
    "gear",
    [
        CylindricalGear(z=30, m_n=1e-3, beta=0.35),
        CylindricalGear(z=30, m_n=1e-3, beta=-0.6),
        CylindricalGear.internal(z=60, m_n=1e-3, beta=0.35),
    ],
    ids=["20", "-34", "internal"],
)
def test_indentation_of_helical_teeth_is_that_of_a_line_load(gear):
    """Plane strain over cos β_b, within 8 % of the part by the border of the half pitch."""
    contour = Contour(tooth_form(gear))
    clamped = contour.form.r_f - contour.form.sign * 4.0 * gear.m_n
    mesh = section_mesh(contour, gear.m_n, clamped, Density())
    solid = Solid(mesh, abs(gear.z), E, NU, 2.0 * math.tan(gear.beta) / abs(gear.d), WidthBasis(gear.b, 1))
    rho = np.linspace(*contour.roll, 7)[1:-1]
    _, moved = indentation(solid, contour, rho)
    expected = moved_in_the_normal_section(solid, contour, rho)
    assert moved / math.cos(gear.beta_b) == pytest.approx(expected, rel=0.08)
    # without the inclination of the contact line
    spur = replace(solid, twist=0.0)
    straight = moved_in_the_normal_section(spur, contour, rho)
    assert straight == pytest.approx(indentation(spur, contour, rho)[1], rel=1e-9)


def plate_deflection(inner: float, outer: float, thickness: float) -> float:
    """Deflection of an annular plate clamped at its bore, level at its rim, per axial force [m/N].

    S. P. Timoshenko and S. Woinowsky-Krieger, Theory of Plates and Shells (1959), 17; with the shear.
    """
    k = 1.5 * (1.0 - NU * NU) / (math.pi * E * thickness**3)  # w = A + B r² + C ln r + k r² ln r
    rows = [
        [1.0, inner**2, math.log(inner)],
        [0.0, 2.0 * inner, 1.0 / inner],
        [0.0, 2.0 * outer, 1.0 / outer],
    ]
    slopes = [-k * r * (2.0 * math.log(r) + 1.0) for r in (inner, outer)]
    A, B, C = np.linalg.solve(rows, [-k * inner**2 * math.log(inner), *slopes])
    bending = abs(A + B * outer**2 + (C + k * outer**2) * math.log(outer))
    return bending + 1.2 * (1.0 + NU) * math.log(outer / inner) / (math.pi * E * thickness)


@pytest.mark.parametrize("beta", [0.0, 0.3])
def test_all_teeth_twist_and_bend_the_web(beta):
    """A web of 0.5 instead of 1 mm: torsion of the disc, and bending of a plate by the axial force."""
    gear = CylindricalGear(z=20, m_n=1e-3, x=0.3, b=6e-3, beta=beta)
    contour, z, count = Contour(tooth_form(gear)), gear.z, 4
    found, expected = [], []
    for web in (0.5e-3, 1e-3):
        blank = Blank(bore_diameter=8e-3, rim_thickness=2e-3, web_thickness=web)
        radii = blank_radii(gear, blank)
        mesh = section_mesh(contour, gear.m_n, radii.clamp, Density(order=3, growth=2.0), radii.rim)
        twist = 2.0 * math.tan(beta) / gear.d
        solid = Solid(mesh, z, E, NU, twist, WidthBasis(gear.b, count), WidthBasis(web, count))
        cases = flank_cases(solid, contour, np.array([0.5 * sum(contour.roll)]), np.eye(1))
        borders, one = np.union1d(mesh.clockwise, mesh.counter), np.zeros(1, np.int64)
        every = np.arange(len(mesh.elements))
        sector = solid.condensed(every, freedoms(count, True)[0], mesh.clamped, borders, cases)
        by_teeth = ring([with_loads(sector, one, one + k) for k in range(z - 1)], z).compliance[0]
        found.append(by_teeth.sum() + by_teeth[1])  # the last tooth moves like the next one
        axial = math.tan(gear.beta_b) ** 2 * gear.b * plate_deflection(radii.clamp, radii.rim, web)
        expected.append(z * (radii.torsion(gear.r_b, 0.5 * E / (1.0 + NU)) + axial))
    assert found[0] - found[1] == pytest.approx(expected[0] - expected[1], rel=0.02)
