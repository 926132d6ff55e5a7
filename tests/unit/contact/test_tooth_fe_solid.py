# SPDX-License-Identifier: Apache-2.0
"""Finite elements of one pitch: geometry, rigid motions, uniform strains, the ring of equal sectors."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.sparse import csc_matrix
from scipy.sparse.linalg import splu

from pitchpoint.contact.tooth_fe.contour import Contour
from pitchpoint.contact.tooth_fe.loads import flank_load
from pitchpoint.contact.tooth_fe.local_part import contact_depth
from pitchpoint.contact.tooth_fe.root_stress import stress_cases
from pitchpoint.contact.tooth_fe.section_matrices import element_matrices, shape, strain
from pitchpoint.contact.tooth_fe.section_mesh import Density, section_mesh
from pitchpoint.contact.tooth_fe.solid import LoadCase, Solid, freedoms
from pitchpoint.contact.tooth_fe.solve import one_pitch
from pitchpoint.contact.tooth_fe.tooth_model import Resolution, ToothModel
from pitchpoint.contact.tooth_fe.width_basis import WidthBasis
from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.cutter import PinionCutter
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.rack import BasicRack
from pitchpoint.geometry.tooth_form import tooth_form
from tests.support.plane_teeth import NU, E, PlaneTooth, clamped_radius

GEARS = {
    "17": CylindricalGear(z=17, m_n=1e-3),
    "undercut": CylindricalGear(z=10, m_n=1e-3),
    "many": CylindricalGear(z=200, m_n=1e-3, x=0.3),
    "helical": CylindricalGear(z=31, m_n=2e-3, beta=0.4, x=0.2),
    "ring": CylindricalGear.internal(z=60, m_n=1e-3),
    "shaped": CylindricalGear.internal(z=60, m_n=1e-3, cutter=PinionCutter(z_0=20)),
    "short": CylindricalGear.internal(z=40, m_n=1e-3, x=-0.4),
}
SHARP = CylindricalGear.internal(z=60, m_n=1e-3, rack=BasicRack(rho_fP_star=0.0))
COARSE = Density(order=2, across=(0.0, 1.0), body=(0.0, 1.0))


def outline_area(contour, end):
    """Area of one pitch between its outline and a circle, from many points."""
    form = contour.form
    root = contour.root(np.linspace(-contour.land_length, contour.fillet_length, 20001))
    flank = contour.involute(np.linspace(*contour.roll, 20001))
    tip = form.r_a * np.exp(1j * np.linspace(np.angle(flank[-1]), 0.0, 2001))
    half = np.concatenate([root, flank[1:], tip])
    ends = end * np.exp(1j * np.linspace(0.0, form.half_pitch_angle, 2001))
    line = np.concatenate([half, ends])
    return abs(np.sum((line.conj() * np.roll(line, -1)).imag))


def areas(mesh):
    """Areas and polar moments of the elements of a mesh by their quadrature."""
    points, weights = np.polynomial.legendre.leggauss(mesh.order + 2)
    first, second = (grid.ravel() for grid in np.meshgrid(points, points, indexing="ij"))
    found = strain(mesh, np.arange(len(mesh.elements)), (first, second), 0.0)
    assert (found.area > 0.0).all() or (found.area < 0.0).all(axis=1).any()
    return np.abs(found.area) * np.outer(weights, weights).ravel()


@pytest.mark.parametrize("name", GEARS)
def test_mesh_has_the_area_of_the_pitch(name):
    gear = GEARS[name]
    contour = Contour(tooth_form(gear))
    end = clamped_radius(gear)
    mesh = section_mesh(contour, gear.m_n, end, Density())
    assert areas(mesh).sum() == pytest.approx(outline_area(contour, end), rel=3e-5)
    assert np.abs(mesh.points[mesh.clamped]) == pytest.approx(end)
    # every element has one orientation
    grid = np.linspace(-1.0, 1.0, 9)
    first, second = (g.ravel() for g in np.meshgrid(grid, grid))
    found = strain(mesh, np.arange(len(mesh.elements)), (first, second), 0.0).area
    assert (np.sign(found) == np.sign(found[:, :1])).all()


@pytest.mark.parametrize("name", GEARS)
def test_elements_of_thin_rims_are_not_inside_out(name):
    """Down to the smallest rim that is not refused, in steps of a fiftieth of a module."""
    gear = GEARS[name]
    contour = Contour(tooth_form(gear))
    grid = np.linspace(-1.0, 1.0, 9)
    first, second = (g.ravel() for g in np.meshgrid(grid, grid))
    form, refused = contour.form, 0
    for rim in gear.m_n * np.arange(0.1, 0.8, 0.02):
        try:
            mesh = section_mesh(contour, gear.m_n, form.r_f - form.sign * rim, Density())
        except GeometryError:
            refused += 1
            continue
        found = strain(mesh, np.arange(len(mesh.elements)), (first, second), 0.0).area
        assert (np.sign(found) == np.sign(found[:, :1])).all()
    assert 5 < refused < 16


@pytest.mark.parametrize("name", GEARS)
def test_normals_are_perpendicular_to_the_flank(name):
    contour = Contour(tooth_form(GEARS[name]))
    low, high = contour.roll
    rho = np.linspace(low + 0.05 * (high - low), high, 7)
    step = 1e-6 * abs(high - low)
    tangent = contour.involute(rho + step) - contour.involute(rho - step)
    normal = contour.inward_normal(rho)
    assert (normal * tangent.conj()).real / np.abs(tangent) == pytest.approx(0.0, abs=1e-6)
    # along the base tangent: its distance from the axis is the base radius
    assert (normal.conj() * contour.involute(rho)).imag == pytest.approx(contour.form.r_b, rel=1e-12)
    assert (contact_depth(contour, rho) > 0.0).all()


def stiffness(solid, free):
    """Stiffness of one pitch with all its nodes."""
    none = np.empty(0, np.int64)
    every = np.arange(solid.mesh.points.size)
    return solid.condensed(np.arange(len(solid.mesh.elements)), free, none, every, []).K


def values(solid, free, field):
    """Nodal values of a field (points, polynomials) -> (n, 3, P) in the axes of the nodes."""
    u = field(solid.mesh.points)
    turned = (u[:, 0] + 1j * u[:, 1]) * np.exp(-1j * solid.axes)[:, None]
    u = np.stack([turned.real, turned.imag, u[:, 2]], axis=1)
    return u[:, free.components, free.polynomials].ravel()


def small(beta, web=None, count=4):
    """One pitch with few elements."""
    gear = CylindricalGear(z=20, m_n=1e-3, b=8e-3, beta=beta)
    rim = tooth_form(gear).r_f - 1.5e-3
    mesh = section_mesh(Contour(tooth_form(gear)), gear.m_n, 5e-3, COARSE, rim if web else None)
    basis = None if web is None else WidthBasis(web, count)
    return Solid(mesh, 20, E, NU, 2.0 * math.tan(beta) / gear.d, WidthBasis(gear.b, count), basis)


def constant(solid, vector):
    """Coefficients of a field that does not depend on z."""
    found = np.zeros((*vector.shape, solid.rim.count))
    found[..., 0] = vector * math.sqrt(solid.rim.width)
    return found


def linear(solid, vector):
    """Coefficients of a field proportional to z."""
    found = np.zeros((*vector.shape, solid.rim.count))
    found[..., 1] = vector * math.sqrt(solid.rim.width**3 / 12.0)
    return found


@pytest.mark.parametrize("web", [None, 3e-3])
def test_rigid_motions_of_a_spur_gear_have_no_energy(web):
    solid = small(0.0, web)
    (free,) = freedoms(solid.rim.count, True)
    K = stiffness(solid, free)
    x, y = solid.mesh.points.real, solid.mesh.points.imag
    o, i = np.zeros_like(x), np.ones_like(x)
    fields = [constant(solid, np.stack(f, 1)) for f in ((i, o, o), (o, i, o), (o, o, i), (-y, x, o))]
    fields.append(linear(solid, np.stack([o, -i, o], 1)) + constant(solid, np.stack([o, o, y], 1)))
    fields.append(linear(solid, np.stack([i, o, o], 1)) + constant(solid, np.stack([o, o, -x], 1)))
    if web is None:
        U = np.stack([values(solid, free, lambda _, f=f: f) for f in fields], axis=1)
        assert np.abs(K @ U).max() < 1e-9 * np.abs(K).max() * np.abs(U).max()
        eigenvalues = np.linalg.eigvalsh(K)
        assert (np.abs(eigenvalues[:6]) < 1e-10 * eigenvalues[-1]).all()
        assert eigenvalues[6] > 1e-9 * eigenvalues[-1]
    else:
        # nodes of the web have their own polynomials
        eigenvalues = np.linalg.eigvalsh(K)
        assert (np.abs(eigenvalues[:6]) < 1e-10 * eigenvalues[-1]).all()
        assert eigenvalues[6] > 1e-9 * eigenvalues[-1]
    assert np.abs(K - K.T).max() <= 1e-12 * np.abs(K).max()


@pytest.mark.parametrize("beta", [0.0, 0.4])
def test_uniform_strains_have_their_energy(beta):
    """Extension with lateral contraction and torsion without warping, exact for every helix angle."""
    solid = small(beta)
    (free,) = freedoms(solid.rim.count, True)
    K = stiffness(solid, free)
    x, y = solid.mesh.points.real, solid.mesh.points.imag
    o, i = np.zeros_like(x), np.ones_like(x)
    dA = areas(solid.mesh)
    b = solid.rim.width
    for field, energy in (
        (constant(solid, np.stack([o, o, i], 1)), 0.0),
        (constant(solid, np.stack([-y, x, o], 1)), 0.0),
        (
            constant(solid, np.stack([-NU * x, -NU * y, o], 1)) + linear(solid, np.stack([o, o, i], 1)),
            E * b * dA.sum(),
        ),
    ):
        u = values(solid, free, lambda _, f=field: f)
        assert u @ K @ u == pytest.approx(energy, rel=1e-9, abs=1e-13 * np.abs(K).max() * (u @ u))
    points, _ = np.polynomial.legendre.leggauss(solid.mesh.order + 2)
    first, second = (grid.ravel() for grid in np.meshgrid(points, points, indexing="ij"))
    N, _ = shape(solid.mesh.order, first, second)
    place = solid.mesh.points[solid.mesh.elements.reshape(len(solid.mesh.elements), -1)] @ N.T
    u = values(solid, free, lambda _: linear(solid, np.stack([-y, x, o], 1)))
    G = 0.5 * E / (1.0 + NU)
    assert u @ K @ u == pytest.approx(
        G * b * np.sum(np.abs(place) ** 2 * dA), rel=1e-6
    )  # quadrature of curved elements


@pytest.mark.parametrize("beta", [0.0, 0.3])
def test_surface_stress_of_uniform_extension(beta):
    """Extension of 1 along the axis; on the inclined surface of a helical tooth by its two strains.

    The order of the mesh is low: its normals are off by a few hundredths.
    """
    solid = small(beta)
    contour = Contour(tooth_form(CylindricalGear(z=20, m_n=1e-3, b=8e-3, beta=beta)))
    tangents = np.radians([35.0, 50.0, 65.0])
    x, y = solid.mesh.points.real, solid.mesh.points.imag
    o, i = np.zeros_like(x), np.ones_like(x)
    field = constant(solid, np.stack([-NU * x, -NU * y, o], 1)) + linear(solid, np.stack([o, o, i], 1))
    for k, case in enumerate(stress_cases(solid, contour, tangents, 0)):
        u = field[solid.mesh.elements[case.element].ravel()]
        stress = np.einsum("ndp,ndpr->r", u, case.values).reshape(3, -1)
        assert stress[:, 1:] == pytest.approx(0.0, abs=1e-6 * E)
        along, width, shear = stress[:, 0] / math.sqrt(solid.rim.width)
        length = float(contour.fillet_length_at(tangents[k : k + 1])[0])
        low, point, high = contour.root(length + np.array([-1e-7, 0.0, 1e-7]))
        lever = (point.conj() * 1j * (high - low) / abs(high - low)).imag  # of the normal about the axis
        upright = 1.0 / (1.0 + (solid.twist * lever) ** 2)
        assert along == pytest.approx(-NU * E / (1.0 - NU) * (1.0 - upright), rel=0.1, abs=1e-6 * E)
        assert width == pytest.approx(E / (1.0 - NU) * (upright - NU), rel=1e-2)
        assert shear == pytest.approx(0.0, abs=1e-6 * E)


def test_symmetric_and_antisymmetric_values_of_spur_gears_are_independent():
    solid = small(0.0)
    contour = Contour(tooth_form(CylindricalGear(z=20, m_n=1e-3, b=8e-3)))
    element, _, force = flank_load(solid.mesh, contour, 3.5e-3)
    P = solid.rim.count
    full = np.column_stack([force, np.zeros(len(force))])
    cases = [LoadCase(element, np.arange(P), full[:, :, None, None] * np.eye(P))]
    none = np.empty(0, np.int64)
    fixed = np.unique(np.concatenate([solid.mesh.clamped, solid.mesh.clockwise, solid.mesh.counter]))
    every = np.arange(len(solid.mesh.elements))
    (free,) = freedoms(P, True)
    together = solid.condensed(every, free, fixed, none, cases).compliance
    apart = np.zeros((P, P))
    for free in freedoms(P, False):
        part = solid.condensed(every, free, fixed, none, cases)
        apart[np.ix_(part.columns, part.columns)] += part.compliance
    assert apart == pytest.approx(together, rel=1e-9, abs=1e-9 * together.max())


def direct_ring(tooth, rho):
    """Displacement of the loaded point of a whole ring with elements rotated one by one, [m²/N]."""
    mesh, z = tooth.solid.mesh, tooth.solid.z
    n = mesh.elements[0].size
    in_plane = (3 * np.arange(n)[:, None] + np.arange(2)).ravel()
    K = element_matrices(mesh, E, NU, 0.0)[0][:, in_plane][:, :, in_plane]
    own = np.setdiff1d(np.arange(mesh.points.size), mesh.counter)
    number = np.empty((z, mesh.points.size), np.int64)
    number[:, own] = np.arange(z * own.size).reshape(z, -1)
    number[:, mesh.counter] = np.roll(number, -1, axis=0)[:, mesh.clockwise]
    size = 2 * z * own.size
    rows, columns, data = [], [], []
    for k in range(z):
        c, s = math.cos(2.0 * math.pi * k / z), math.sin(2.0 * math.pi * k / z)
        turn = np.kron(np.eye(n), [[c, -s], [s, c]])
        at = (2 * number[k][mesh.elements].reshape(len(K), -1, 1) + np.arange(2)).reshape(len(K), -1)
        turned = turn @ K @ turn.T
        rows.append(np.broadcast_to(at[:, :, None], turned.shape).ravel())
        columns.append(np.broadcast_to(at[:, None, :], turned.shape).ravel())
        data.append(turned.ravel())
    matrix = csc_matrix(
        (np.concatenate(data), (np.concatenate(rows), np.concatenate(columns))), shape=(size, size)
    )
    fixed = (2 * np.unique(number[:, mesh.clamped])[:, None] + np.arange(2)).ravel()
    free = np.setdiff1d(np.arange(size), fixed)
    element, _, force = flank_load(mesh, tooth.contour, rho)
    load = np.zeros(size)
    load[(2 * number[0][mesh.elements[element].ravel()][:, None] + np.arange(2)).ravel()] = force.ravel()
    return float(load[free] @ splu(matrix[free][:, free]).solve(load[free]))


@pytest.mark.parametrize("z", [9, 17, 18])
def test_ring_of_condensed_sectors_is_the_whole_gear(z):
    tooth = PlaneTooth(CylindricalGear(z=z, m_n=1e-3, x=0.3 if z == 9 else 0.0), COARSE)
    rho = tooth.roll(0.5e-3 * z + 0.4e-3)
    found = tooth.displacements(tooth.flank([rho]))[0, 0, 0, 0]
    assert found == pytest.approx(direct_ring(tooth, rho), rel=1e-9)


def test_all_teeth_loaded_wind_up_the_body():
    """Below the teeth the ring rotates as a disc: u = T r (1/r_i² - 1/r²)/(4 pi G) for unit width."""
    gear = CylindricalGear(z=17, m_n=1e-3)
    tooth = PlaneTooth(gear, Density(order=4, growth=1.3))
    mesh = tooth.solid.mesh
    at = int(np.argmin(np.abs(np.abs(mesh.points[mesh.clockwise]) - 5.8e-3)))
    node = mesh.clockwise[at]
    element, local = (int(k[0]) for k in np.where(mesh.elements.reshape(len(mesh.elements), -1) == node))
    probe = np.zeros((mesh.elements[0].size, 3, 1, 1))
    direction = 1j * mesh.points[node] / abs(mesh.points[node])
    probe[local, :2, 0, 0] = direction.real, direction.imag
    cases = [*tooth.flank([tooth.roll(8.5e-3)]), LoadCase(element, np.array([1]), probe)]
    found = tooth.displacements(cases, 16)
    total = found[0, 1, :, 0].sum() + found[1, 1, 0, 0]
    r, r_i, r_b = abs(mesh.points[node]), clamped_radius(gear), gear.r_b
    G = 0.5 * E / (1.0 + NU)
    assert total == pytest.approx(
        -17.0 * r_b * r / (4.0 * math.pi * G) * (1.0 / r_i**2 - 1.0 / r**2), rel=1e-3
    )


@pytest.mark.parametrize(
    ("change", "where"),
    [
        ({"gear": SHARP}, "root_fillet_radius"),
        ({"web_thickness": 12e-3, "rim_thickness": 2e-3, "bore_diameter": 8e-3}, "web_thickness"),
        ({"bore_diameter": 40e-3}, "bore_diameter"),
        ({"bore_diameter": 27.1e-3}, "bore_diameter: rim of 0.2 mm is too thin .*above 0.2727"),
        ({"web_thickness": 4e-3, "rim_thickness": 0.2e-3}, "rim_thickness: rim of 0.2 mm"),
        ({"gear": CylindricalGear(z=4, m_n=1e-3, x=0.8)}, "number_of_teeth"),
        ({"E": math.nan}, "youngs_modulus"),
        ({"E": True}, "youngs_modulus"),
        ({"nu": 0.5}, "poisson_ratio"),
    ],
)
def test_impossible_models_are_refused(change, where):
    settings = {"gear": CylindricalGear(z=30, m_n=1e-3), **change}
    with pytest.raises(GeometryError, match=where):
        one_pitch(ToothModel(**settings))


@pytest.mark.parametrize(
    "change", [{"heights": 0}, {"heights": True}, {"widths": 41}, {"fillet_points": 1.5}]
)
def test_impossible_resolutions_are_refused(change):
    with pytest.raises(GeometryError, match=next(iter(change))):
        Resolution(**change)
