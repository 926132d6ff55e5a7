# SPDX-License-Identifier: Apache-2.0
"""Teeth by CalculiX: displacement and stress of the fillet against finite elements of our own.

Source: CalculiX 2.20 (Dhondt; Debian package calculix-ccx) as an external program, elements CPE8 and C3D20 with
full integration, on meshes of whole gears that share nothing with those of `contact.tooth_fe` but the closed
form of the tooth. Spur gears m 1 mm, rack 1.25/0.38/1.0, bore r_f/1.4 clamped, E 206 GPa, nu 0.3; tooth 0 on the
x axis, force on its left flank along the base tangent into the tooth. FC-1 is the case of
`test_plane_strain_teeth`: published displacements of the intersection of the line of force with the centre line.

Displacement in plane strain: 2e-3; CPE8 is stiffer than the exact solution and CPE8R on the same mesh softer, and
they differ by 1.5e-3. Stress, by CPE8R: 1 % of the largest one between CalculiX and our fine mesh; stresses at
nodes are extrapolated from points of integration, and meshes of 12 and 24 elements along the fillet differ by 0.5 %.
The usual mesh of our own has a single element of order four along half of the fillet. Its stress differs from that
of finer ones by up to 1.2 % for a force at the tip, 2.4 % for one at the pitch point, by less at the 30° tangent:
1 % there, 3 % elsewhere.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.contact.tooth_fe.loads import flank_cases
from pitchpoint.contact.tooth_fe.root_stress import stress_cases
from pitchpoint.contact.tooth_fe.section_mesh import Density
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from tests.support.calculix import requires_ccx
from tests.support.calculix_teeth import LoadedGear
from tests.support.plane_teeth import FINE, PlaneTooth

pytestmark = [pytest.mark.study, requires_ccx]

FINER = {"rows": 8, "fillet": 16, "columns": 8, "layers": 20}
TANGENTS = np.radians([25.0, 30.0, 35.0, 40.0, 45.0, 50.0])


def spur(z):
    return CylindricalGear(z=z, m_n=1e-3)


@pytest.mark.parametrize(
    ("z", "radius", "published"), [(17, 8.0023, 0.01626), (17, 8.5, 0.02226), (43, 21.5, 0.02085), (43, 22.4434, 0.05411)]
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
    order = np.argsort(angles)
    by_calculix = np.interp(TANGENTS, angles[order], along[order])
    peak = along[(angles > TANGENTS[0]) & (angles < TANGENTS[-1])].max()
    usual, fine = (along_fillet(z, radius, density) for density in (Density(), FINE))
    assert usual[0][1] == pytest.approx(by_calculix[1], abs=0.01 * peak)  # the 30° tangent
    assert fine[1] == pytest.approx(peak, rel=0.01)
    assert fine[0] == pytest.approx(by_calculix, abs=0.01 * peak)
    assert usual[0] == pytest.approx(by_calculix, abs=0.03 * peak)
