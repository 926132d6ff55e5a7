# SPDX-License-Identifier: Apache-2.0
"""Teeth by CalculiX: displacement and stress of the fillet against finite elements of our own.

Source: CalculiX 2.20 (Dhondt; Debian package calculix-ccx) as an external program, on meshes of whole gears
that share nothing with those of `contact.tooth_fe` but the closed form of the tooth. Spur gears m 1 mm,
rack 1.25/0.38/1.0, bore r_f/1.4 clamped, E 206 GPa, nu 0.3. Tooth 0 is on the x axis, the force acts on its
left flank along the base tangent into the tooth. FC-1, as in `test_plane_strain_teeth`: published
displacements of the intersection of the line of force with the centre line.

Displacement in plane strain, by CPE8: 2e-3. CPE8 is stiffer than the exact solution and CPE8R on the same
mesh softer; they differ by 1.5e-3.

Stress, by CPE8R: 1 % of the largest one between CalculiX and our fine mesh. Stresses at nodes are
extrapolated from points of integration; meshes of 12 and 24 elements along the fillet differ by 0.5 %. Our
usual mesh has a single element of order four along half of the fillet. Its stress differs from that of
finer ones by up to 1.2 % for a force at the tip and 2.4 % for one at the pitch point: 3 %, and 1 % at the
30° tangent.

Finite face width of 4 mm, by C3D20R: line loads at the pitch point, uniform or a bell of 0.5 mm (standard
deviation) at mid-face or near an end. Displacement of the centre line by 0.5 %; of the flank of the next
tooth with the compliance of `tooth_fe` by 1 %; stress at the 30° tangent by 1.5 % of the largest value over
the width. Two meshes of C3D20R differ by 0.4 % in displacement and by 0.5 % in stress at mid-face.
"""

from __future__ import annotations

import numpy as np
import pytest
from numpy.polynomial.legendre import legvander

from pitchpoint.contact.tooth_fe.loads import flank_cases
from pitchpoint.contact.tooth_fe.ring import ring
from pitchpoint.contact.tooth_fe.root_stress import stress_cases
from pitchpoint.contact.tooth_fe.section_mesh import Density
from pitchpoint.contact.tooth_fe.solid import LoadCase, freedoms
from pitchpoint.contact.tooth_fe.solve import one_pitch, tooth_fe
from pitchpoint.contact.tooth_fe.tooth_model import Resolution, ToothModel
from pitchpoint.contact.tooth_fe.width_basis import WidthBasis
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from tests.support.calculix import requires_ccx
from tests.support.calculix_teeth import LoadedGear
from tests.support.gear_quads import COARSEST
from tests.support.plane_teeth import FINE, PlaneTooth

pytestmark = [pytest.mark.study, requires_ccx]

FINER = {"rows": 8, "fillet": 16, "columns": 8, "layers": 20}
TANGENTS = np.radians([25.0, 30.0, 35.0, 40.0, 45.0, 50.0])


def spur(z):
    return CylindricalGear(z=z, m_n=1e-3)


@pytest.mark.parametrize(
    ("z", "radius", "published"),
    [(17, 8.0023, 0.01626), (17, 8.5, 0.02226), (43, 21.5, 0.02085), (43, 22.4434, 0.05411)],
)
def test_displacement_of_the_centre_line(tmp_path, z, radius, published):
    """µm per N/mm."""
    loaded = LoadedGear(spur(z), radius, **FINER)
    by_calculix = 1e3 * loaded.at_centre(loaded.plane_strain(tmp_path)[0])
    tooth = PlaneTooth(spur(z), FINE)
    rho = tooth.roll(1e-3 * radius)
    ours = 1e9 * float(tooth.displacements([*tooth.flank([rho]), tooth.at_centre(rho, 1)])[0, 1, 0, 0])
    assert by_calculix == pytest.approx(published, rel=2e-3)
    assert ours == pytest.approx(by_calculix, rel=2e-3)


def at_tangents(angles, along, wanted):
    """Stresses at given tangent angles."""
    order = np.argsort(angles)
    return np.interp(wanted, angles[order], along[order])


def along_fillet(z, radius, density):
    """Stresses at the tangents, and the largest one between them, by our own elements [MPa per N/mm]."""
    tooth = PlaneTooth(spur(z), density)
    cases = flank_cases(tooth.solid, tooth.contour, np.array([tooth.roll(1e-3 * radius)]), np.eye(1))
    angles = np.append(TANGENTS, np.linspace(TANGENTS[0], TANGENTS[-1], 26))
    cases += stress_cases(tooth.solid, tooth.contour, angles, 1)
    found = 1e-3 * tooth.displacements(cases)[0, 1:, 0, 0].reshape(angles.size, -1)[:, 0]
    return found[: TANGENTS.size], found[TANGENTS.size :].max()


@pytest.mark.parametrize(("z", "radius"), [(17, 9.5), (17, 8.5), (43, 22.5), (43, 21.5)])
def test_stress_of_the_fillet(tmp_path, z, radius):
    """Force at the tip and at the pitch point; MPa per N/mm."""
    loaded = LoadedGear(spur(z), radius, **FINER)
    angles, along = loaded.fillet_stress(loaded.plane_strain(tmp_path, "CPE8R")[1])
    by_calculix = at_tangents(angles, along, TANGENTS)
    peak = along[(angles > TANGENTS[0]) & (angles < TANGENTS[-1])].max()
    usual, fine = (along_fillet(z, radius, density) for density in (Density(), FINE))
    assert usual[0][1] == pytest.approx(by_calculix[1], abs=0.01 * peak)  # the 30° tangent
    assert fine[1] == pytest.approx(peak, rel=0.01)
    assert fine[0] == pytest.approx(by_calculix, abs=0.01 * peak)
    assert usual[0] == pytest.approx(by_calculix, abs=0.03 * peak)


WIDTH = 4.0
BORDERS = np.array([-2.0, -1.92, -1.75, -1.4, -1.0, -0.5, 0.0, 0.5, 1.0, 1.4, 1.75, 1.92, 2.0])
THICK = {"rows": 2, "fillet": 4, "columns": 2, "layers": 5, "others": COARSEST}
RADIUS = 8.5


def bell(middle):
    """Line load of 1 N/mm at its largest."""
    return lambda z: np.exp(-2.0 * (z - middle) ** 2)


LOADS = (np.ones_like, bell(0.0), bell(1.8))


def in_polynomials(basis):
    """Line loads [N/m] in the polynomials over the width, shape (load, polynomial)."""
    points, weights = np.polynomial.legendre.leggauss(60)
    z, weights = 0.5 * WIDTH * points, 0.5e-3 * WIDTH * weights
    return np.array([basis.values(1e-3 * z).T @ (weights * 1e3 * load(z)) for load in LOADS])


def centre_line(model):
    """Displacement of the centre line where the line of force meets it [µm], shape (load, border)."""
    solid, contour, _ = one_pitch(model)
    P, mesh, tooth = solid.rim.count, solid.mesh, PlaneTooth(model.gear)
    rho = tooth.roll(1e-3 * RADIUS)
    at = tooth.at_centre(rho, 0)
    cases = flank_cases(solid, contour, np.array([rho]), np.eye(1))
    cases.append(LoadCase(at.element, P + np.arange(P), at.values * np.eye(P)))
    found = np.zeros((2 * P, 2 * P))
    borders = np.union1d(mesh.clockwise, mesh.counter)
    for free in freedoms(P, False):
        sector = solid.condensed(np.arange(len(mesh.elements)), free, mesh.clamped, borders, cases)
        whole = ring([sector], solid.z)
        found[np.ix_(whole.columns, whole.columns)] += whole.compliance
    return 1e6 * in_polynomials(solid.rim) @ found[:P, P:] @ solid.rim.values(1e-3 * BORDERS).T


def test_teeth_of_finite_width(tmp_path):
    """Displacements in µm and stress in MPa at the borders of the layers over the width."""
    gear = CylindricalGear(z=17, m_n=1e-3, b=1e-3 * WIDTH)
    loaded = LoadedGear(gear, RADIUS, **THICK)
    u, stress = loaded.solid(tmp_path, BORDERS, LOADS)
    model = ToothModel(gear=gear, bore_diameter=2e-3 * loaded.bore, resolution=Resolution(widths=12))
    tooth, basis = tooth_fe(model), WidthBasis(gear.b, 12)
    t = 2.0 * (PlaneTooth(gear).roll(1e-3 * RADIUS) - tooth.roll[0]) / np.ptp(tooth.roll) - 1.0
    heights, over, q = legvander(t, 5)[0], basis.values(1e-3 * BORDERS), in_polynomials(basis)
    critical = int(np.argmin(np.abs(tooth.tangents - np.radians(30.0))))
    own = centre_line(model)
    beside = 1e6 * np.einsum("m,kp,mpnq,n,lq->lk", heights, over, tooth.next, heights, q)
    fillet = 1e-6 * np.einsum("kp,pmq,m,lq->lk", over, tooth.stress[critical, 0, :, 1], heights, q)
    for k in range(len(LOADS)):
        centre = np.array([1e3 * loaded.at_centre(one) for one in u[k]])
        assert own[k] == pytest.approx(centre, abs=5e-3 * centre.max())
        next_flank = np.array([1e3 * loaded.of_neighbour(one, RADIUS) for one in u[k]])
        assert beside[k] == pytest.approx(next_flank, abs=0.01 * next_flank.max())
        root = np.array([at_tangents(*loaded.fillet_stress(one), TANGENTS[1]) for one in stress[k]])
        assert fillet[k] == pytest.approx(root, abs=0.015 * root.max())
        for at in (6, 12):  # numbers of the page: mid-face and end
            assert own[k, at] == pytest.approx(centre[at], abs=5e-3 * centre.max())
            assert beside[k, at] == pytest.approx(next_flank[at], abs=0.01 * next_flank.max())
            assert fillet[k, at] == pytest.approx(root[at], abs=0.015 * root.max())
