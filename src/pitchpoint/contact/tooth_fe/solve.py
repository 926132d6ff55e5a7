# SPDX-License-Identifier: Apache-2.0
"""Compliance and fillet stress of a cylindrical gear by finite elements of teeth, rim and web.

One pitch is condensed to its radial borders; equal sectors form the ring, which is clamped at the bore, or at the
outside of an internal gear. Forces act on the left flanks of three neighbouring teeth.

Derivation: docs/theory/tooth_fe.md.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.tooth_fe.contour import Contour
from pitchpoint.contact.tooth_fe.gear_body import GearBody, gear_body
from pitchpoint.contact.tooth_fe.loads import flank_cases, gauss_heights, roll_at
from pitchpoint.contact.tooth_fe.local_part import clamped_half, indentation
from pitchpoint.contact.tooth_fe.ring import ring, with_loads
from pitchpoint.contact.tooth_fe.root_stress import stress_cases, stress_points
from pitchpoint.contact.tooth_fe.section_mesh import Density, section_mesh
from pitchpoint.contact.tooth_fe.solid import Freedoms, LoadCase, Solid, freedoms
from pitchpoint.contact.tooth_fe.tooth import ToothFE
from pitchpoint.contact.tooth_fe.width_basis import WidthBasis
from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.tooth_form import tooth_form

FloatArray = NDArray[np.float64]

LOADED = 3
"""Neighbouring teeth with forces; the middle one has the stress."""
FEWEST = 5
"""Smallest number of teeth of the ring."""


@dataclass(frozen=True)
class Resolution:
    """Resolution of the finite elements.

    Parameters
    ----------
    heights
        Number M of polynomials over the height of the flank.
    widths
        Number P of polynomials over the face width; None: 6 + 0.6 b/m_n, between 7 and 16.
    fillet_points
        Number of points of the fillet with stress.
    density
        Mesh of the section.
    """

    heights: int = 6
    widths: int | None = None
    fillet_points: int = 9
    density: Density = Density()

    def polynomials(self, gear: CylindricalGear) -> int:
        """Number of polynomials over the face width of a gear."""
        return self.widths or min(16, max(7, round(6.0 + 0.6 * gear.b / gear.m_n)))


def gear_solid_of(
    gear: CylindricalGear, body: GearBody, E: float, nu: float, resolution: Resolution
) -> tuple[Solid, Contour]:
    """Finite elements of one pitch, and the outline of its tooth.

    Parameters
    ----------
    gear
        The gear.
    body
        Its rim and web.
    E, nu
        Young's modulus [Pa], Poisson's ratio.
    resolution
        Mesh and polynomials.

    Raises
    ------
    GeometryError
        If the tooth is not possible, has a sharp root, or has fewer than five neighbours.
    """
    if abs(gear.z) < FEWEST:
        raise GeometryError(
            "is too small for a ring of teeth",
            where="number_of_teeth",
            value=f"{abs(gear.z)}",
            limit=f"at least {FEWEST}",
        )
    contour = Contour(tooth_form(gear))
    mesh = section_mesh(contour, gear.m_n, body.clamped, resolution.density, body.rim)
    count = resolution.polynomials(gear)
    web = None if body.web is None else WidthBasis(body.web, count)
    twist = 2.0 * math.tan(gear.beta) / abs(gear.d)
    return Solid(mesh, abs(gear.z), E, nu, twist, WidthBasis(gear.b, count), web), contour


def tooth_fe(
    gear: CylindricalGear,
    *,
    E: float = 206.0e9,
    nu: float = 0.3,
    bore_diameter: float | None = None,
    rim_thickness: float | None = None,
    web_thickness: float | None = None,
    resolution: Resolution | None = None,
) -> ToothFE:
    """Compliance of the flanks and stress of the fillets of a gear by finite elements.

    Parameters
    ----------
    gear
        External or internal gear, spur or helical. The generated tooth is used, not its `outline`.
    E, nu
        Young's modulus [Pa], Poisson's ratio.
    bore_diameter, rim_thickness, web_thickness
        Body, see `pitchpoint.contact.tooth_fe.gear_body.gear_body` [m].
    resolution
        Mesh and polynomials; None: the default ones.

    Raises
    ------
    GeometryError
        If tooth or body are not possible.

    Notes
    -----
    Linear elastic solid, small displacements. Chamfers and tip rounding are not modelled. Time and memory grow
    with the cube and the square of the number of polynomials over the width.

    Examples
    --------
    A spur tooth with 10 mm face width, mean displacement due to a force at the middle of its height, uniform
    over the width [µm per N/mm]:

    >>> gear = CylindricalGear(z=17, m_n=1e-3, b=10e-3)
    >>> coarse = Resolution(heights=4, widths=5, fillet_points=3)
    >>> fe = tooth_fe(gear, bore_diameter=10.357e-3, resolution=coarse)
    >>> middle = np.array([1.0, 0.0, -0.5, 0.0])    # P_0 ... P_3 at t = 0
    >>> round(1e9 * float(middle @ fe.same[:, 0, :, 0] @ middle), 4)
    0.0225
    """
    resolution = resolution or Resolution()
    body = gear_body(gear, bore_diameter, rim_thickness, web_thickness)
    solid, contour = gear_solid_of(gear, body, E, nu, resolution)
    M, P, F = resolution.heights, solid.rim.count, resolution.fillet_points
    t, to_legendre = gauss_heights(M)
    rho = roll_at(contour, t)
    flank = flank_cases(solid, contour, rho, to_legendre)
    tangents = stress_points(contour, F)
    fillet = stress_cases(solid, contour, tangents, M * P)
    G, local = np.zeros((LOADED * M * P + 3 * F * P,) * 2), np.zeros((M * P, M * P))
    for free in freedoms(P, solid.twist != 0.0):
        _add_ring(G, solid, free, flank + fillet, M * P)
        half = clamped_half(solid, free, flank)
        local[np.ix_(half.columns, half.columns)] += half.compliance
    n = LOADED * M * P
    flanks = G[:n, :n].reshape(LOADED, M, P, LOADED, M, P)
    _, moved = indentation(solid, contour, rho)
    to_normal = 1.0 / math.cos(gear.beta_b)
    root = contour.root(contour.fillet_length_at(tangents))
    return ToothFE(
        width=gear.b,
        roll=np.array(contour.roll),
        same=flanks[1, :, :, 1] - local.reshape(M, P, M, P),
        next=flanks[0, :, :, 1].copy(),
        far=flanks[0, :, :, 2].copy(),
        contact=to_legendre @ np.sqrt(np.maximum(-moved, 0.0) * to_normal),
        tangents=tangents,
        fillet=np.column_stack([root.real, root.imag]),
        stress=G[n:, :n].reshape(F, 3, P, LOADED, M, P).copy(),
        provenance=_provenance(solid, body),
    )


def _add_ring(G: FloatArray, solid: Solid, free: Freedoms, cases: list[LoadCase], n_flank: int) -> None:
    """Add the displacements of a set of values to those of all load cases of the ring."""
    mesh = solid.mesh
    borders = np.union1d(mesh.clockwise, mesh.counter)
    sector = solid.condensed(np.arange(len(mesh.elements)), free, mesh.clamped, borders, cases)
    on_flank = np.flatnonzero(sector.columns < n_flank)
    sectors = [with_loads(sector, on_flank, sector.columns[on_flank] + k * n_flank) for k in range(LOADED)]
    numbers = sector.columns + np.where(sector.columns < n_flank, 1, LOADED - 1) * n_flank
    sectors[1] = with_loads(sector, np.arange(numbers.size), numbers)
    whole = ring(sectors, solid.z)
    G[np.ix_(whole.columns, whole.columns)] += whole.compliance


def _provenance(solid: Solid, body: GearBody) -> dict[str, float | int | str]:
    found: dict[str, float | int | str] = {
        "compliance": "finite elements",
        "foundation": "ring clamped at its inner circle"
        if body.clamped < abs(solid.mesh.points).max()
        else "",
        "youngs_modulus": solid.E,
        "poisson_ratio": solid.nu,
        "clamped_radius": body.clamped,
        "section_nodes": solid.mesh.points.size,
        "section_order": solid.mesh.order,
        "width_polynomials": solid.rim.count,
        "contact_depth": "centre line of the tooth",
    }
    if body.rim is not None and body.web is not None:
        found |= {"rim_radius": body.rim, "web_thickness": body.web}
    return found
