# SPDX-License-Identifier: Apache-2.0
"""Teeth of whole gears by CalculiX: displacements of the centre line and stresses of the fillet, in mm, N, MPa."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline

from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.tooth_form import tooth_form
from tests.support.calculix import Deck, material
from tests.support.gear_quads import Fineness, Quads, even, gear_quads, graded

E, NU = 206.0e3, 0.3


@dataclass(frozen=True)
class LoadedGear:
    """Gear with a clamped bore r_f/1.4, fine elements in tooth 0, and forces on its left flank.

    Parameters
    ----------
    gear
        The gear.
    radius
        Radius of the forces [mm], a border of elements.
    rows, fillet
        Elements over the involute on each side of the force, and along each half of the fillet.
    """

    gear: CylindricalGear
    radius: float
    rows: int = 6
    fillet: int = 6
    columns: int = 4
    layers: int = 9

    @cached_property
    def section(self) -> tuple[Quads, np.ndarray]:
        """Section, and the nodes of the loaded flank from the middle of the root to the tip."""
        form = tooth_form(self.gear)
        low, high = ((r / form.r_b) ** 2 - 1.0 for r in (form.r_Ff, form.r_Fa))
        at = ((1e-3 * self.radius / form.r_b) ** 2 - 1.0 - low) / (high - low)
        flank = np.append(at * even(self.rows)[:-1], at + (1.0 - at) * even(self.rows)) if at < 1.0 - 1e-9 else even(self.rows)
        fine = Fineness(flank=flank, half=graded(self.columns, 1.5), fillet=self.fillet, land=2)
        layers = graded(self.layers, 40.0 ** (1.0 / self.layers))
        beside = Fineness(flank=even(2), half=even(1), fillet=2)
        quads, flanks = gear_quads(form, self.bore, layers, {0: fine, 1: beside, form.z - 1: beside})
        return quads, flanks[0]

    @property
    def bore(self) -> float:
        """Radius of the bore [mm]."""
        return 1e3 * tooth_form(self.gear).r_f / 1.4

    @cached_property
    def place(self) -> tuple[int, complex, float]:
        """Node of the force, its direction into the tooth, and where its line meets the centre line [mm]."""
        quads, flank = self.section
        node = int(flank[np.argmin(np.abs(np.abs(quads.points[flank]) - self.radius))])
        point = complex(quads.points[node])
        assert abs(abs(point) - self.radius) < 1e-9
        r_b = 1e3 * tooth_form(self.gear).r_b
        # the line of force is tangent to the base circle
        turn = np.angle(point) - math.acos(r_b / self.radius)
        direction = -1j * np.exp(1j * turn)
        return node, direction, float((point - point.imag / direction.imag * direction).real)

    def plane_strain(self, folder: Path, kind: str = "CPE8") -> tuple[np.ndarray, np.ndarray]:
        """Displacements u + iv [mm] and stresses (xx, yy, zz, xy, yz, zx) [MPa] by 1 N/mm."""
        quads, _ = self.section
        deck = Deck(np.column_stack([quads.points.real, quads.points.imag]), quads.quads, kind)
        deck.node_set("bore", np.flatnonzero(np.abs(quads.points) < self.bore * (1.0 + 1e-9)))
        node, direction, _ = self.place
        deck.lines += [*material(E, NU), "*BOUNDARY", "bore, 1, 2", "*STEP", "*STATIC", "*CLOAD"]
        deck.lines += [f"{node + 1}, {k + 1}, {float(x)!r}" for k, x in enumerate((direction.real, direction.imag))]
        deck.lines += ["*NODE FILE, OUTPUT=2D", "U", "*EL FILE, OUTPUT=2D", "S", "*END STEP"]
        found = deck.run(folder)
        u, stress = found["DISP"][-1], found["STRESS"][-1]
        return u[:, 0] + 1j * u[:, 1], stress

    def at_centre(self, u: np.ndarray) -> float:
        """Displacement of the centre line where the line of force meets it, along this line [mm]."""
        quads, _ = self.section
        _, direction, x = self.place
        axis = np.flatnonzero((np.abs(quads.points.imag) < 1e-9) & (quads.points.real > 0.0))
        axis = axis[np.argsort(quads.points[axis].real)]
        moved = (u[axis] * direction.conjugate()).real
        return float(CubicSpline(quads.points[axis].real, moved)(x))

    def fillet_stress(self, stress: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Tangent angles to the centre line of the tooth [rad] along the fillet, and stresses along it [MPa].

        The stress is the larger principal one in the section; the surface has no traction.
        """
        quads, flank = self.section
        points = quads.points[flank]
        length = np.append(0.0, np.cumsum(np.abs(np.diff(points))))
        mean, half = 0.5 * (stress[flank, 0] + stress[flank, 1]), 0.5 * (stress[flank, 0] - stress[flank, 1])
        largest = mean + np.copysign(np.hypot(half, stress[flank, 3]), mean)
        form = tooth_form(self.gear)
        at = np.linspace(*np.interp(1e3 * np.array([form.r_f + 1e-9, form.r_Ff]), np.abs(points), length), 2001)
        slope = CubicSpline(length, points)(at, 1)
        return np.arctan2(-slope.imag, slope.real), CubicSpline(length, largest)(at)
