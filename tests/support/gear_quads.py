# SPDX-License-Identifier: Apache-2.0
"""Meshes of whole gears for CalculiX: quadrilaterals with 8 nodes, bricks with 20; lengths in mm.

They share nothing with the meshes of `contact.tooth_fe` but the closed form of the tooth. A pitch has a block
between the flanks, from the middles of the fillets to the tip, and a block of radial columns below it. Grid
lines of all pitches meet on their borders, so that a few teeth may be finer than the others.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from pitchpoint.geometry.tooth_generation import ToothForm

Ints = np.ndarray
Points = np.ndarray

# corners counter-clockwise, then the middles of the sides between them, in a patch of 3 x 3 points
_RING = ((0, 0), (0, 2), (2, 2), (2, 0), (0, 1), (1, 2), (2, 1), (1, 0))


def with_middles(borders: np.ndarray) -> np.ndarray:
    """Borders and the middles between them."""
    found = np.empty(2 * len(borders) - 1)
    found[::2], found[1::2] = borders, 0.5 * (borders[:-1] + borders[1:])
    return found


def graded(n: int, growth: float) -> np.ndarray:
    """Borders of n intervals from 0 to 1, each `growth` times as long as the one before."""
    found = np.append(0.0, np.cumsum(growth ** np.arange(n)))
    return found / found[-1]


def even(n: int) -> np.ndarray:
    """Borders of n equal intervals from 0 to 1."""
    return np.linspace(0.0, 1.0, n + 1)


@dataclass(frozen=True)
class Fineness:
    """Elements of one pitch.

    Parameters
    ----------
    flank
        Borders over the involute from its root end (0) to its tip end (1), in arc length.
    half
        Borders across half of the tooth, from its flank (0) to its centre line (1).
    fillet, land
        Elements along each half of a fillet, and along half of the root circle.
    edge
        Elements along a rounded tip edge.
    """

    flank: np.ndarray
    half: np.ndarray
    fillet: int = 2
    land: int = 1
    edge: int = 2


COARSE = Fineness(flank=even(2), half=even(2), edge=1)
COARSEST = Fineness(flank=even(1), half=even(1), fillet=1, edge=1)


@dataclass
class Quads:
    """Section of a gear.

    Parameters
    ----------
    points
        Nodes x + iy [mm], shape (n,).
    quads
        Elements, shape (m, 8).
    flanks
        Nodes of the left flank of each fine tooth, from the middle of the root to the tip.
    faces
        Elements of these flanks above the middle of the fillet; their third sides are the flank.
    """

    points: Points
    quads: Ints
    flanks: dict[int, Ints]
    faces: dict[int, Ints]


class Pitch:
    """One pitch of a gear, its tooth on the x axis."""

    def __init__(self, form: ToothForm, bore: float, layers: np.ndarray, fineness: Fineness) -> None:
        self.form, self.fineness = form, fineness
        theta = np.linspace(form.fillet.theta_root, form.theta_form, 4001)
        points = self._fillet(theta)
        length = np.append(0.0, np.cumsum(np.abs(np.diff(points))))
        share = with_middles(even(2 * fineness.fillet))
        along = self._fillet(np.interp(share * length[-1], length, theta))
        middle = 2 * fineness.fillet
        side = np.concatenate([along[middle:], self._involute()[1:], self._edge()])
        self.tooth = self._tooth(side)
        angle = np.linspace(form.half_pitch_angle, np.angle(along[0]), 2 * fineness.land + 1)
        left = np.concatenate([1e3 * form.r_f * np.exp(1j * angle)[:-1], along[: middle + 1]])
        top = np.concatenate([left[:-1].conj(), self.tooth[:, 0], left[::-1][1:]])
        # radial columns: every node keeps its angle down to the bore
        share = with_middles(layers)
        rows = top[:, None] * (1.0 - share) + bore * np.exp(1j * np.angle(top))[:, None] * share
        self.body = rows[:, ::-1]
        self.n_foot = left.size

    def _fillet(self, theta: np.ndarray) -> Points:
        r, angle = self.form.fillet_polar(theta)
        return 1e3 * r * np.exp(1j * angle)

    def _involute(self) -> Points:
        form = self.form
        low, high = (max(0.0, r * r / form.r_b**2 - 1.0) for r in (form.r_Ff, form.r_Fa))
        roll = np.sqrt(low + (high - low) * with_middles(self.fineness.flank))
        return 1e3 * form.r_b * np.hypot(1.0, roll) * np.exp(1j * (form.psi_b - roll + np.arctan(roll)))

    def _edge(self) -> Points:
        if self.form.edge is None:
            return np.empty(0, complex)
        return 1e3 * self.form.edge.points(with_middles(even(self.fineness.edge)))[0][1:]

    def _tooth(self, side: Points) -> Points:
        """Columns from the right to the left flank, rows from the curved foot to the tip."""
        half = with_middles(self.fineness.half)
        s = np.concatenate([half - 1.0, (1.0 - half)[::-1][1:]])[:, None]
        height = np.append(0.0, np.cumsum(np.abs(np.diff(side))))
        u = height / height[-1]
        bulge = (1.0 - u) * -0.35 * side[0].imag + u * (abs(side[-1]) - side[-1].real)
        return side.real + bulge * (1.0 - s * s) + 1j * s * side.imag


def gear_quads(
    form: ToothForm, bore: float, layers: np.ndarray, fine: dict[int, Fineness], others: Fineness = COARSE
) -> Quads:
    """Section of a whole gear.

    Parameters
    ----------
    form
        The tooth.
    bore
        Radius of the bore [mm].
    layers
        Borders of the layers of the body, from the root (0) to the bore (1).
    fine
        Fineness of teeth by their numbers, counter-clockwise from the x axis.
    others
        Fineness of all other teeth.
    """
    points, quads, flanks, faces, count = [], [], {}, {}, 0
    for k in range(form.z):
        pitch = Pitch(form, bore, layers, fine.get(k, others))
        for patch in (pitch.body, pitch.tooth):
            number = count + np.arange(patch.size).reshape(patch.shape)
            last = np.subtract(patch.shape, 2)
            sides = [number[a : last[0] + a : 2, b : last[1] + b : 2] for a, b in _RING]
            quads.append(np.stack([side.ravel() for side in sides], axis=1))
            points.append((patch * np.exp(2j * math.pi * k / form.z)).ravel())
            count += patch.size
        if k in fine:
            root = count - pitch.tooth.size - np.arange(pitch.n_foot) * pitch.body.shape[1] - 1
            flanks[k] = np.append(root, number[-1, 1:])
            faces[k] = sum(map(len, quads)) - np.arange(sides[0].shape[1])[::-1] - 1
    every, quad = np.concatenate(points), np.concatenate(quads)
    twins = cKDTree(np.column_stack([every.real, every.imag])).query_pairs(1e-6, output_type="ndarray")
    same = np.arange(every.size)
    np.minimum.at(same, twins.max(axis=1), twins.min(axis=1))
    used, quad = np.unique(same[quad], return_inverse=True)
    flanks = {k: np.searchsorted(used, same[nodes]) for k, nodes in flanks.items()}
    return Quads(every[used], quad.reshape(-1, 8), flanks, faces)


def bricks(section: Quads, z: np.ndarray) -> tuple[np.ndarray, Ints, Ints]:
    """Section times width: nodes [mm], bricks with 20 nodes, and the nodes of each section, -1 for none.

    Parameters
    ----------
    section
        Section.
    z
        Borders of the layers over the width [mm], shape (k + 1,).

    Returns
    -------
    nodes : ndarray, shape (n, 3)
    bricks : ndarray, shape (m, 20)
    numbers : ndarray, shape (2 k + 1, nodes of the section)
        Borders and middles of the layers; the latter have nodes at corners of quadrilaterals only.
    """
    at = with_middles(z)
    corner = np.isin(np.arange(section.points.size), section.quads[:, :4])
    held = np.where((np.arange(at.size) % 2 == 1)[:, None], corner, True)
    numbers = np.where(held, np.cumsum(held).reshape(held.shape) - 1, -1)
    layer, place = np.nonzero(held)
    points = section.points[place]
    nodes = np.column_stack([points.real, points.imag, at[layer]])
    below, middle, above = (numbers[k : at.size - 2 + k : 2] for k in range(3))
    q = section.quads
    parts = [
        below[:, q[:, :4]],
        above[:, q[:, :4]],
        below[:, q[:, 4:]],
        above[:, q[:, 4:]],
        middle[:, q[:, :4]],
    ]
    return nodes, np.concatenate(parts, axis=2).reshape(-1, 20), numbers
