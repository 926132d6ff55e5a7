# SPDX-License-Identifier: Apache-2.0
"""Teeth in plane strain, for tests of the finite elements: displacements by single forces on the flank."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.optimize import brentq

from pitchpoint.contact.tooth_fe.contour import Contour
from pitchpoint.contact.tooth_fe.loads import flank_cases
from pitchpoint.contact.tooth_fe.local_part import contact_depth, indentation
from pitchpoint.contact.tooth_fe.ring import ring, with_loads
from pitchpoint.contact.tooth_fe.section_matrices import lagrange, shape
from pitchpoint.contact.tooth_fe.section_mesh import Density, section_mesh
from pitchpoint.contact.tooth_fe.solid import PLANE_STRAIN, LoadCase, Solid
from pitchpoint.contact.tooth_fe.width_basis import WidthBasis
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.tooth_form import tooth_form

E, NU = 206.0e9, 0.3
FINE = Density(order=6, across=(0.0, 0.3, 0.65, 1.0), fillet=2, root=2, body=(0.0, 0.3, 1.0), growth=1.7)


def clamped_radius(gear: CylindricalGear) -> float:
    """Bore of the published case, r_f/1.4; a rim of 3.5 modules for internal gears."""
    r_f = tooth_form(gear).r_f
    return r_f + 3.5 * gear.m_n if gear.is_internal else r_f / 1.4


def hertz_bracket(depth: float, b: float) -> float:
    """Displacement of a half-plane under Hertzian pressure relative to a depth, over 2 q (1 - nu²)/(pi E)."""
    return math.asinh(depth / b) - NU / (1.0 - NU) * depth / (math.hypot(depth, b) + depth)


def approach(depth: float, b: float) -> float:
    """The displacement itself, per force per length [m²/N]."""
    return 2.0 * (1.0 - NU * NU) / (math.pi * E) * hertz_bracket(depth, b)


@dataclass(frozen=True)
class PlaneTooth:
    """One gear in plane strain with forces at lengths of roll [m] on one tooth."""

    gear: CylindricalGear
    density: Density = Density()

    @cached_property
    def contour(self) -> Contour:
        return Contour(tooth_form(self.gear))

    @cached_property
    def solid(self) -> Solid:
        mesh = section_mesh(self.contour, self.gear.m_n, clamped_radius(self.gear), self.density)
        return Solid(mesh, abs(self.gear.z), E, NU, 0.0, WidthBasis(self.gear.b, 1))

    def roll(self, radius: float) -> float:
        """Length of roll at a radius, zero inside the base circle."""
        return math.sqrt(max(0.0, radius * radius - self.contour.form.r_b**2))

    def flank(self, rho: list[float], weights: np.ndarray | None = None) -> list[LoadCase]:
        """Forces at lengths of roll, or sums of them with weights (case, force)."""
        return flank_cases(
            self.solid, self.contour, np.array(rho), np.eye(len(rho)) if weights is None else weights
        )

    def at_centre(self, rho: float, number: int) -> LoadCase:
        """Unit force where the line of force at a length of roll meets the centre line of the tooth."""
        point, normal = (f(np.array([rho]))[0] for f in (self.contour.involute, self.contour.inward_normal))
        x = point.real - point.imag / normal.imag * normal.real
        mesh = self.solid.mesh
        for element in np.flatnonzero(mesh.column == 0.0):
            line = mesh.points[mesh.elements[element][0]].real

            def beyond(t: float, line: np.ndarray = line) -> float:
                return float((lagrange(mesh.order, np.array([t]))[0] @ line)[0] - x)

            if beyond(-1.0) * beyond(1.0) <= 0.0:
                values, _ = shape(mesh.order, np.array([-1.0]), np.array([brentq(beyond, -1.0, 1.0)]))
                force = np.outer(values[0], [normal.real, normal.imag, 0.0])
                return LoadCase(int(element), np.array([number]), force[:, :, None, None])
        raise AssertionError("the line of force does not meet the tooth")

    def displacements(self, cases: list[LoadCase], teeth: int = 1) -> np.ndarray:
        """Displacements (tooth, case, tooth, case) by all cases on neighbouring teeth [m²/N]."""
        mesh = self.solid.mesh
        borders = np.union1d(mesh.clockwise, mesh.counter)
        every = np.arange(len(mesh.elements))
        sector = self.solid.condensed(every, PLANE_STRAIN, mesh.clamped, borders, cases)
        n = sector.columns.size
        copies = [with_loads(sector, np.arange(n), sector.columns + k * n) for k in range(teeth)]
        return ring(copies, self.solid.z).compliance.reshape(teeth, n, teeth, n)

    def without_indentation(self, rho: list[float], column: float = 0.0) -> np.ndarray:
        """Displacement under each force without the indentation relative to the contact depth [m²/N]."""
        whole = np.diag(self.displacements(self.flank(rho))[0, :, 0])
        clamped, moved = indentation(self.solid, self.contour, np.array(rho), column)
        return np.asarray(whole - clamped - moved)

    def depth(self, rho: float) -> float:
        """Distance from the flank to the centre line along the base tangent [m]."""
        return float(contact_depth(self.contour, np.array([rho]))[0])
