# SPDX-License-Identifier: Apache-2.0
"""How far points are from the outline of a gear, and on which side of it.

Points are complex numbers x + iy [m] in the transverse plane of the gear, tooth 0 on the +x axis.

Derivation: docs/theory/geometry.md, "A pair".
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.tooth_form import tooth_profile

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

ComplexArray = NDArray[np.complex128]
FloatArray = NDArray[np.float64]
Parts = NDArray[np.int8]

ROOT, FILLET, FLANK, TIP = range(4)
"""Parts of an outline, as in `pitchpoint.geometry.tooth_form.REGIONS`; the corner of a tip belongs to it."""
N_FLANK = 400
"""Points of a flank from which distances are taken: chords stay within 5e-5 modules of the fillet."""

_STEP = 8.0
"""Largest distance of two points in modules, times the number of points of a flank."""


@dataclass(frozen=True)
class Nearest:
    """The nearest places of an outline to some points, arrays of one shape.

    Attributes
    ----------
    distance
        [m], negative for points inside the material.
    foot
        The places x + iy [m].
    part
        `ROOT`, `FILLET`, `FLANK` or `TIP`.
    """

    distance: FloatArray
    foot: ComplexArray
    part: Parts


@dataclass(frozen=True)
class Outline:
    """One pitch of a gear as a line of points, which all its pitches repeat.

    Attributes
    ----------
    z
        Number of teeth, positive.
    sign
        +1 with the material inside, −1 for an internal gear.
    pitch
        Points x + iy [m] of the pitch of tooth 0, counter-clockwise.
    part
        Part of the outline that each of them belongs to.
    """

    z: int
    sign: int
    pitch: ComplexArray
    part: Parts

    @cached_property
    def _chain(self) -> tuple[ComplexArray, Parts]:
        """Three pitches: what is nearest to a point of one may lie on the next tooth."""
        turn = np.exp(2j * math.pi / self.z)
        line = np.concatenate([self.pitch / turn, self.pitch, self.pitch * turn])
        return line, np.tile(self.part, 3)

    @cached_property
    def _tree(self) -> Any:
        from scipy.spatial import cKDTree

        line = self._chain[0]
        return cKDTree(np.column_stack([line.real, line.imag]))

    def nearest(self, points: ComplexArray) -> Nearest:
        """The nearest place of the outline for every point x + iy [m], shape (n,)."""
        line, parts = self._chain
        turn = np.exp(2j * math.pi / self.z * np.rint(np.angle(points) * self.z / (2.0 * math.pi)))
        local = points / turn
        _, at = self._tree.query(np.column_stack([local.real, local.imag]))
        at = np.clip(at, 1, line.size - 2)
        distance = np.full(local.shape, np.inf)
        foot = np.zeros_like(local)
        side = np.zeros(local.shape)
        part = np.zeros(local.shape, dtype=np.int8)
        for start in (at - 1, at):
            along = line[start + 1] - line[start]
            away = local - line[start]
            share = np.clip((away * along.conj()).real / np.abs(along) ** 2, 0.0, 1.0)
            here = line[start] + share * along
            far = np.abs(local - here)
            closer = far < distance
            distance = np.where(closer, far, distance)
            foot = np.where(closer, here, foot)
            side = np.where(closer, (along.conj() * away).imag, side)
            ends = parts[start], parts[start + 1]
            within = _between(*ends)
            part = np.where(
                closer, np.where(share <= 0.0, ends[0], np.where(share >= 1.0, ends[1], within)), part
            )
        # the outline runs counter-clockwise: on its left lies the material, of an internal gear the hole
        signed = np.where(self.sign * side > 0.0, -distance, distance)
        return Nearest(signed, foot * turn, part)


def _between(one: Parts, two: Parts) -> Parts:
    """Part of what lies between two points: flank next to the corner of a tip and behind a fillet."""
    return np.asarray(np.where(one == two, one, np.minimum(np.maximum(one, two), FLANK)), dtype=np.int8)


def _divided(plane: ComplexArray, part: Parts, turn: complex, step: float) -> tuple[ComplexArray, Parts]:
    """Points no farther apart than a step, which the search for the nearest of them relies on."""
    after, part_after = np.append(plane[1:], plane[0] * turn), np.append(part[1:], part[0])
    count = np.maximum(1, np.ceil(np.abs(after - plane) / step)).astype(np.int64)
    start = np.repeat(np.arange(plane.size), count)
    share = (np.arange(start.size) - np.repeat(np.cumsum(count) - count, count)) / count[start]
    points = plane[start] + share * (after - plane)[start]
    return points, np.where(share == 0.0, part[start], _between(part, part_after)[start])


@lru_cache(maxsize=32)
def gear_line(gear: CylindricalGear, n_flank: int = N_FLANK) -> Outline:
    """Outline of a gear, with its real tooth if it has one.

    Parameters
    ----------
    gear
        External or internal gear.
    n_flank
        Points per flank of a generated tooth.

    Raises
    ------
    GeometryError
        If there is no such tooth.

    Examples
    --------
    Half a module above the tip, and a quarter below:

    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> line = gear_line(CylindricalGear(z=20, m_n=2e-3))
    >>> found = line.nearest(np.array([0.023 + 0j, 0.0215 + 0j]))
    >>> [round(1e3 * d, 4) for d in found.distance.tolist()], found.part.tolist()
    ([1.0, -0.5], [3, 3])
    """
    profile = tooth_profile(gear, n_flank)
    plane = profile.points[:, 0] + 1j * profile.points[:, 1]
    part = profile.region.copy()
    height = gear.sign * np.abs(plane)
    part[height > height.max() - 1e-9 * gear.m_n] = TIP
    turn = complex(np.exp(2j * math.pi / abs(gear.z)))
    plane, part = _divided(plane, part, turn, _STEP * gear.m_n / n_flank)
    return Outline(abs(gear.z), gear.sign, plane, part)
