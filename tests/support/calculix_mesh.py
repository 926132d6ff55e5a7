# SPDX-License-Identifier: Apache-2.0
"""A spur pair in contact by CalculiX: plane strain, frictionless surface-to-surface penalty; mm, N, MPa.

Gear 1 turns counter-clockwise about the origin and drives gear 2 with its left flanks; gear 2 is on the +x
axis. The bore of gear 2 is held, that of gear 1 is turned by a given angle from the contact of rigid gears.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from pitchpoint.geometry import GearPair
from pitchpoint.geometry.tooth_form import tooth_form
from tests.support.calculix import Deck, material
from tests.support.gear_quads import COARSEST, Fineness, Quads, gear_quads, graded

E, NU = 206.0e3, 0.3
PENALTY = 1.0e8
"""Contact pressure per penetration [MPa/mm]: 2e-5 mm at 2000 MPa, 0.2 % of the approach."""


def around(at: float, size: float, growth: float = 1.35) -> np.ndarray:
    """Borders from 0 to 1 with equal steps about a place, or the end next to it, and growing ones beyond."""
    at = min(max(at, 0.0), 1.0)
    found = [0.0, 1.0]
    for sign, end in ((1.0, 1.0), (-1.0, 0.0)):
        place, step, n = at, size, 0
        while sign * (end - place) > 1.5 * step:
            found.append(place)
            place += sign * step
            n += 1
            step *= growth if n > 6 else 1.0
        if sign * (end - place) > 1e-9:
            found.append(place)
    return np.unique(np.round(found, 12))


@dataclass(frozen=True)
class MeshInContact:
    """A spur pair at one position.

    Parameters
    ----------
    pair
        The gears, with their tip roundings.
    phase
        Position of the pair of teeth 0 from A [base pitches].
    bores
        Radii of the bores [mm].
    size
        Length of the elements in contact [mm].
    edge
        Elements along a rounded tip edge.
    """

    pair: GearPair
    phase: float
    bores: tuple[float, float]
    size: float = 0.025
    edge: int = 24

    def rolls(self, k: int) -> tuple[float, float]:
        """Lengths of roll on both gears of pair k = -1, 0, 1, the last one ahead [m]."""
        one = self.pair.T1A + (self.phase + k) * self.pair.p_et
        return one, self.pair.T1T2 - one

    def _gear(self, number: int) -> Quads:
        """Section of one gear in its own frame, tooth 0 at its place, tooth ±k of pair k."""
        gear = (self.pair.gear1, self.pair.gear2)[number]
        form = tooth_form(gear)
        low, high = ((r / form.r_b) ** 2 - 1.0 for r in (form.r_Ff, form.r_Fa))
        length = 0.5e3 * form.r_b * (high - low)
        fine = {}
        for k in (-1, 0, 1):
            at = ((self.rolls(k)[number] / form.r_b) ** 2 - low) / (high - low)
            tooth = (k, -k)[number] % form.z
            fine[tooth] = Fineness(around(at, self.size / length), graded(7, 1.6), fillet=2, edge=self.edge)
        section = gear_quads(form, self.bores[number], graded(6, 1.6), fine, COARSEST)
        angle = self.rolls(0)[number] / form.r_b - form.psi_b - self.pair.alpha_wt
        section.points = section.points * np.exp(1j * angle)
        return section

    @cached_property
    def sections(self) -> tuple[Quads, Quads]:
        """Both gears, the second one turned by half a revolution and shifted to its place."""
        one, two = self._gear(0), self._gear(1)
        two.points = 1e3 * self.pair.a_w - two.points
        return one, two

    def deck(self, approach: float) -> Deck:
        """Model with gear 1 turned by approach/r_b1; approach in mm."""
        one, two = self.sections
        points = np.concatenate([one.points, two.points])
        deck = Deck(
            np.column_stack([points.real, points.imag]),
            np.concatenate([one.quads, two.quads + one.points.size]),
            "CPE8",
        )
        distance = np.abs(points - np.repeat([0.0, 1e3 * self.pair.a_w], [one.points.size, two.points.size]))
        first = np.arange(points.size) < one.points.size
        turned = np.flatnonzero(first & (distance < self.bores[0] * (1.0 + 1e-9)))
        deck.node_set("held", np.flatnonzero(~first & (distance < self.bores[1] * (1.0 + 1e-9))))
        deck.lines += material(E, NU)
        deck.lines += ["*SURFACE INTERACTION, NAME=touch", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR"]
        deck.lines.append(f"{PENALTY!r}")
        for k in (-1, 0, 1):
            for name, faces in (
                (f"S{k + 1}", one.faces[k % self.pair.gear1.z]),
                (f"M{k + 1}", two.faces[-k % self.pair.gear2.z] + len(one.quads)),
            ):
                deck.lines += [f"*SURFACE, NAME={name}, TYPE=ELEMENT", *(f"{f + 1}, S3" for f in faces)]
            deck.lines += ["*CONTACT PAIR, INTERACTION=touch, TYPE=SURFACE TO SURFACE", f"S{k + 1}, M{k + 1}"]
        angle = approach / (1e3 * self.pair.gear1.r_b)
        deck.lines += ["*BOUNDARY", "held, 1, 2", "*STEP, INC=100", "*STATIC", "1., 1.", "*BOUNDARY"]
        for n in turned:
            x, y = points[n].real, points[n].imag
            deck.lines += [f"{n + 1}, 1, 1, {-angle * y:.11e}", f"{n + 1}, 2, 2, {angle * x:.11e}"]
        deck.lines += [f"*CONTACT PRINT, SLAVE=S{k}, MASTER=M{k}\nCF" for k in range(3)]
        deck.lines += ["*NODE FILE, OUTPUT=2D", "U", "*END STEP"]
        return deck

    def torques(self, folder: Path, approach: float) -> np.ndarray:
        """Torques of the pairs -1, 0, 1 on gear 1 [N mm per mm] at an approach [mm]."""
        self.deck(approach).run(folder)
        return contact_torques(folder / "job.dat")


def contact_torques(path: Path) -> np.ndarray:
    """Torques on gear 1 against its motion, from the contact forces on its flanks in the last increment."""
    text = path.read_text(encoding="utf-8").splitlines()
    rows = [text[k + 2] for k, line in enumerate(text) if "moment about the origin" in line]
    return np.array([-float(row.split()[5]) for row in rows[-3:]])
