# SPDX-License-Identifier: Apache-2.0
"""Compliance and fillet stress of a cylindrical gear by finite elements of teeth, rim and web.

One pitch is condensed to its radial borders. Equal sectors form the ring, which is clamped at the bore, or at
the outside of an internal gear. Forces act on the left flanks of three neighbouring teeth.

Derivation: docs/theory/tooth_fe.md, "Ring".
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.tooth_fe.contour import Contour
from pitchpoint.contact.tooth_fe.gear_body import GearBody, gear_body
from pitchpoint.contact.tooth_fe.loads import flank_cases, gauss_heights, roll_at
from pitchpoint.contact.tooth_fe.local_part import clamped_half, indentation
from pitchpoint.contact.tooth_fe.ring import ring, with_loads
from pitchpoint.contact.tooth_fe.root_stress import stress_cases, stress_points
from pitchpoint.contact.tooth_fe.section_mesh import section_mesh
from pitchpoint.contact.tooth_fe.solid import Freedoms, LoadCase, Solid, freedoms
from pitchpoint.contact.tooth_fe.tooth import ToothFE
from pitchpoint.contact.tooth_fe.tooth_model import ToothModel
from pitchpoint.contact.tooth_fe.width_basis import WidthBasis
from pitchpoint.geometry.tooth_form import tooth_form

FloatArray = NDArray[np.float64]

LOADED = 3
"""Neighbouring teeth with forces; stress is that of the middle one."""


def one_pitch(model: ToothModel) -> tuple[Solid, Contour, GearBody]:
    """Finite elements of one pitch, the outline of its tooth, and the body of the gear.

    Parameters
    ----------
    model
        The gear.

    Raises
    ------
    GeometryError
        If tooth or body are not possible, or the root has a sharp corner.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> solid, contour, body = one_pitch(ToothModel(gear=CylindricalGear(z=17, m_n=1e-3)))
    >>> solid.z, round(1e3 * body.clamped, 3)    # half of the root radius
    (17, 3.625)
    """
    gear = model.gear
    body = gear_body(gear, model.blank)
    contour = Contour(tooth_form(gear))
    mesh = section_mesh(contour, gear.m_n, body.clamped, model.resolution.density, body.rim)
    count = model.resolution.polynomials(gear)
    web = None if body.web is None else WidthBasis(body.web, count)
    twist = 2.0 * math.tan(gear.beta) / abs(gear.d)
    return Solid(mesh, abs(gear.z), model.E, model.nu, twist, WidthBasis(gear.b, count), web), contour, body


def tooth_fe(model: ToothModel) -> ToothFE:
    """Compliance of the flanks and stress of the fillets of a gear by finite elements.

    Parameters
    ----------
    model
        The gear.

    Raises
    ------
    GeometryError
        If tooth or body are not possible.

    Notes
    -----
    Linear elastic solid, small displacements. Chamfers and tip rounding are not modelled. Computing time
    increases with the cube of the number of polynomials over the width.

    Examples
    --------
    A spur tooth, force at the middle of its height and uniform over its width of 10 mm, mean displacement in
    µm per N/mm:

    >>> from pitchpoint.contact.tooth_fe.tooth_model import Resolution
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear, coarse = CylindricalGear(z=17, m_n=1e-3, b=10e-3), Resolution(heights=4, widths=5)
    >>> fe = tooth_fe(ToothModel(gear=gear, bore_diameter=10.357e-3, resolution=coarse))
    >>> middle = np.array([1.0, 0.0, -0.5, 0.0])    # P_0 ... P_3 at t = 0
    >>> round(1e9 * float(middle @ fe.same[:, 0, :, 0] @ middle), 4)
    0.0211
    """
    solid, contour, body = one_pitch(model)
    M, P, F = model.resolution.heights, solid.rim.count, model.resolution.fillet_points
    t, to_legendre = gauss_heights(M)
    rho, tangents = roll_at(contour, t), stress_points(contour, F)
    flank = flank_cases(solid, contour, rho, to_legendre)
    cases = flank + stress_cases(solid, contour, tangents, M * P)
    n = LOADED * M * P
    G, local = np.zeros((n + 3 * F * P,) * 2), np.zeros((M * P, M * P))
    for free in freedoms(P, solid.twist != 0.0):
        _add_ring(G, solid, free, cases, M * P)
        half = clamped_half(solid, free, flank)
        local[np.ix_(half.columns, half.columns)] += half.compliance
    flanks = G[:n, :n].reshape(LOADED, M, P, LOADED, M, P)
    _, moved = indentation(solid, contour, rho)
    contact = np.sqrt(np.maximum(-moved, 0.0) / math.cos(model.gear.beta_b))
    fillet = contour.root(contour.fillet_length_at(tangents))
    return ToothFE(
        width=model.gear.b,
        roll=np.array(contour.roll),
        same=flanks[1, :, :, 1] - local.reshape(M, P, M, P),
        next=flanks[0, :, :, 1].copy(),
        far=flanks[0, :, :, 2].copy(),
        contact=to_legendre @ contact,
        tangents=tangents,
        fillet=np.column_stack([fillet.real, fillet.imag]),
        stress=G[n:, :n].reshape(F, 3, P, LOADED, M, P).copy(),
        provenance=_provenance(solid, body),
    )


def _add_ring(G: FloatArray, solid: Solid, free: Freedoms, cases: list[LoadCase], n_flank: int) -> None:
    """Add the displacements of one set of values to those of all load cases of the ring."""
    mesh = solid.mesh
    borders = np.union1d(mesh.clockwise, mesh.counter)
    sector = solid.condensed(np.arange(len(mesh.elements)), free, mesh.clamped, borders, cases)
    on_flank = np.flatnonzero(sector.columns < n_flank)
    sectors = [with_loads(sector, on_flank, sector.columns[on_flank] + k * n_flank) for k in range(LOADED)]
    # stress follows the forces of all teeth
    numbers = sector.columns + np.where(sector.columns < n_flank, 1, LOADED - 1) * n_flank
    sectors[1] = with_loads(sector, np.arange(numbers.size), numbers)
    whole = ring(sectors, solid.z)
    G[np.ix_(whole.columns, whole.columns)] += whole.compliance


def _provenance(solid: Solid, body: GearBody) -> dict[str, str | float]:
    found: dict[str, str | float] = {
        "level": "finite elements",
        "flank": "left",
        "youngs_modulus": solid.E,
        "poisson_ratio": solid.nu,
        "clamped_radius": body.clamped,
        "section_nodes": solid.mesh.points.size,
        "section_order": solid.mesh.order,
        "width_polynomials": solid.rim.count,
    }
    if body.rim is not None and body.web is not None:
        found |= {"rim_radius": body.rim, "web_thickness": body.web}
    return found
