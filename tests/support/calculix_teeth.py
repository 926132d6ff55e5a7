# SPDX-License-Identifier: Apache-2.0
"""Teeth of whole gears by CalculiX: displacements and stresses of the fillet, in mm, N, MPa."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline

from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.tooth_form import tooth_form
from tests.support.calculix import Deck, material
from tests.support.gear_quads import COARSE, Fineness, Quads, bricks, even, gear_quads, graded

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
    others: Fineness = COARSE

    @cached_property
    def section(self) -> Quads:
        """Section with fine teeth 0 and beside it."""
        form = tooth_form(self.gear)
        low, high = ((r / form.r_b) ** 2 - 1.0 for r in (form.r_Ff, form.r_Fa))
        at = ((1e-3 * self.radius / form.r_b) ** 2 - 1.0 - low) / (high - low)
        flank = (
            np.append(at * even(self.rows)[:-1], at + (1.0 - at) * even(self.rows))
            if at < 1.0 - 1e-9
            else even(self.rows)
        )
        fine = Fineness(flank=flank, half=graded(self.columns, 1.5), fillet=self.fillet, land=2)
        layers = graded(self.layers, 40.0 ** (1.0 / self.layers))
        beside = Fineness(flank=even(2), half=even(1), fillet=2)
        return gear_quads(form, self.bore, layers, {0: fine, 1: beside, form.z - 1: beside}, self.others)

    @property
    def bore(self) -> float:
        """Radius of the bore [mm]."""
        return 1e3 * tooth_form(self.gear).r_f / 1.4

    @cached_property
    def place(self) -> tuple[int, complex, float]:
        """Node of the force, its direction into the tooth, and where its line meets the centre line [mm]."""
        quads = self.section
        flank = quads.flanks[0]
        node = int(flank[np.argmin(np.abs(np.abs(quads.points[flank]) - self.radius))])
        point = complex(quads.points[node])
        assert abs(abs(point) - self.radius) < 1e-9
        direction = complex(self._inward(np.array([point]))[0])
        return node, direction, float((point - point.imag / direction.imag * direction).real)

    def plane_strain(self, folder: Path, kind: str = "CPE8") -> tuple[np.ndarray, np.ndarray]:
        """Displacements u + iv [mm] and stresses (xx, yy, zz, xy, yz, zx) [MPa] by 1 N/mm."""
        quads = self.section
        deck = Deck(np.column_stack([quads.points.real, quads.points.imag]), quads.quads, kind)
        deck.node_set("bore", np.flatnonzero(np.abs(quads.points) < self.bore * (1.0 + 1e-9)))
        node, direction, _ = self.place
        deck.lines += [*material(E, NU), "*BOUNDARY", "bore, 1, 2", "*STEP", "*STATIC", "*CLOAD"]
        deck.lines += [
            f"{node + 1}, {k + 1}, {x:.11e}" for k, x in enumerate((direction.real, direction.imag))
        ]
        deck.lines += ["*NODE FILE, OUTPUT=2D", "U", "*EL FILE, OUTPUT=2D", "S", "*END STEP"]
        found = deck.run(folder)
        u, stress = found["DISP"][-1], found["STRESS"][-1]
        return u[:, 0] + 1j * u[:, 1], stress

    def solid(
        self,
        folder: Path,
        z: np.ndarray,
        loads: list[Callable[[np.ndarray], np.ndarray]],
        kind: str = "C3D20R",
    ) -> tuple[np.ndarray, np.ndarray]:
        """Displacements and stresses of a gear of finite width by line loads.

        Parameters
        ----------
        folder
            Where CalculiX runs.
        z
            Borders of the layers over the width [mm], shape (k + 1,).
        loads
            Force per length over the width [N/mm] of each case.
        kind
            Type of the elements.

        Returns
        -------
        displacement : ndarray, shape (case, k + 1, nodes of the section)
            u + iv [mm] in the section at the borders of the layers.
        stress : ndarray, shape (case, k + 1, nodes of the section, 6)
            xx, yy, zz, xy, yz, zx [MPa].
        """
        section = self.section
        nodes, elements, numbers = bricks(section, z)
        deck = Deck(nodes, elements, kind)
        deck.node_set("bore", np.flatnonzero(np.hypot(nodes[:, 0], nodes[:, 1]) < self.bore * (1.0 + 1e-9)))
        deck.lines += [*material(E, NU), "*BOUNDARY", "bore, 1, 3"]
        node, direction, _ = self.place
        x, y = float(direction.real), float(direction.imag)
        gauss, weight = np.polynomial.legendre.leggauss(5)
        shape = np.stack([0.5 * gauss * (gauss - 1.0), 1.0 - gauss**2, 0.5 * gauss * (gauss + 1.0)])
        for load in loads:
            force = np.zeros(2 * z.size - 1)
            for k, (low, high) in enumerate(zip(z[:-1], z[1:], strict=True)):
                half = 0.5 * (high - low)
                force[2 * k : 2 * k + 3] += half * shape @ (weight * load(low + half * (1.0 + gauss)))
            deck.lines += ["*STEP", "*STATIC", "*CLOAD, OP=NEW"]
            for at, total in zip(numbers[:, node] + 1, force.tolist(), strict=True):
                deck.lines += [f"{at}, 1, {total * x:.11e}", f"{at}, 2, {total * y:.11e}"]
            deck.lines += ["*NODE FILE", "U", "*EL FILE", "S", "*END STEP"]
        found = deck.run(folder)
        borders = numbers[::2]
        u, stress = (np.stack(found[name])[:, borders] for name in ("DISP", "STRESS"))
        return u[..., 0] + 1j * u[..., 1], stress

    def at_centre(self, u: np.ndarray) -> float:
        """Displacement of the centre line where the line of force meets it, along this line [mm]."""
        quads = self.section
        _, direction, x = self.place
        axis = np.flatnonzero((np.abs(quads.points.imag) < 1e-9) & (quads.points.real > 0.0))
        axis = axis[np.argsort(quads.points[axis].real)]
        moved = (u[axis] * direction.conjugate()).real
        return float(CubicSpline(quads.points[axis].real, moved)(x))

    def of_neighbour(self, u: np.ndarray, radius: float) -> float:
        """Displacement of the left flank of the tooth clockwise of the loaded one, inwards [mm]."""
        quads = self.section
        points = quads.points[quads.flanks[self.gear.z - 1]]
        form = tooth_form(self.gear)
        high = np.abs(points) > 1e3 * form.r_Ff
        moved = (u[quads.flanks[self.gear.z - 1]][high] * self._inward(points[high]).conj()).real
        return float(CubicSpline(np.abs(points[high]), moved)(radius))

    def _inward(self, points: np.ndarray) -> np.ndarray:
        """Directions into the tooth along the tangents to the base circle from points of left flanks."""
        r_b = 1e3 * tooth_form(self.gear).r_b
        return -1j * np.exp(1j * (np.angle(points) - np.arccos(np.minimum(1.0, r_b / np.abs(points)))))

    def fillet_stress(self, stress: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Tangent angles to the centre line of the tooth [rad] along the fillet, and stresses along it [MPa].

        The stress is the larger principal one in the section; the surface has no traction.
        """
        quads = self.section
        flank = quads.flanks[0]
        points = quads.points[flank]
        length = np.append(0.0, np.cumsum(np.abs(np.diff(points))))
        mean, half = 0.5 * (stress[flank, 0] + stress[flank, 1]), 0.5 * (stress[flank, 0] - stress[flank, 1])
        largest = mean + np.copysign(np.hypot(half, stress[flank, 3]), mean)
        form = tooth_form(self.gear)
        at = np.linspace(
            *np.interp(1e3 * np.array([form.r_f + 1e-9, form.r_Ff]), np.abs(points), length), 2001
        )
        slope = CubicSpline(length, points)(at, 1)
        return np.arctan2(-slope.imag, slope.real), CubicSpline(length, largest)(at)
