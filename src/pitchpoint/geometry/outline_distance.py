# SPDX-License-Identifier: Apache-2.0
"""Signed distance of points from the outline of a gear.

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

from pitchpoint.geometry.tip_edge import tip_edge
from pitchpoint.geometry.tooth_form import tooth_profile

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

ComplexArray = NDArray[np.complex128]
FloatArray = NDArray[np.float64]
Parts = NDArray[np.int8]

ROOT, FILLET, FLANK, TIP = range(4)
"""Parts of an outline, as in `pitchpoint.geometry.tooth_form.REGIONS`; tip corners are part of the tip."""
N_FLANK = 400
"""Points per flank for distances: the chord error in the fillet is below 5e-5 modules."""

_STEP = 8.0
"""Maximum distance of adjacent points in modules, times the number of points per flank."""


@dataclass(frozen=True)
class Nearest:
    """Nearest points of an outline to given points, arrays of one shape.

    Attributes
    ----------
    distance
        Distance [m], negative for points inside the material.
    foot
        Nearest points x + iy [m].
    part
        Part of the outline: `ROOT`, `FILLET`, `FLANK` or `TIP`.
    """

    distance: FloatArray
    foot: ComplexArray
    part: Parts


@dataclass(frozen=True)
class Outline:
    """Outline of one pitch of a gear; the other pitches repeat it.

    Attributes
    ----------
    z
        Number of teeth, positive.
    sign
        +1 with the material inside, −1 for an internal gear.
    pitch
        Points x + iy [m] of the pitch of tooth 0, counter-clockwise.
    part
        Part of the outline of each point.
    """

    z: int
    sign: int
    pitch: ComplexArray
    part: Parts

    @cached_property
    def _chain(self) -> tuple[ComplexArray, Parts]:
        """Outline of three pitches, because the nearest point may be on an adjacent tooth."""
        turn = np.exp(2j * math.pi / self.z)
        line = np.concatenate([self.pitch / turn, self.pitch, self.pitch * turn])
        return line, np.tile(self.part, 3)

    @cached_property
    def _tree(self) -> Any:
        from scipy.spatial import cKDTree

        line = self._chain[0]
        return cKDTree(np.column_stack([line.real, line.imag]))

    def nearest(self, points: ComplexArray) -> Nearest:
        """Nearest point of the outline for every point x + iy [m], shape (n,)."""
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
        # the outline is counter-clockwise: the material (internal gear: the hole) is on its left
        signed = np.where(self.sign * side > 0.0, -distance, distance)
        return Nearest(signed, foot * turn, part)


def _between(one: Parts, two: Parts) -> Parts:
    """Part of the outline between two points of parts `one` and `two`."""
    return np.asarray(np.where(one == two, one, np.minimum(np.maximum(one, two), FLANK)), dtype=np.int8)


def _divided(plane: ComplexArray, part: Parts, turn: complex, step: float) -> tuple[ComplexArray, Parts]:
    """Subdivide an outline so that adjacent points are at most `step` apart, as `nearest` requires."""
    after, part_after = np.append(plane[1:], plane[0] * turn), np.append(part[1:], part[0])
    count = np.maximum(1, np.ceil(np.abs(after - plane) / step)).astype(np.int64)
    start = np.repeat(np.arange(plane.size), count)
    share = (np.arange(start.size) - np.repeat(np.cumsum(count) - count, count)) / count[start]
    points = plane[start] + share * (after - plane)[start]
    return points, np.where(share == 0.0, part[start], _between(part, part_after)[start])


@lru_cache(maxsize=32)
def gear_line(gear: CylindricalGear, n_flank: int = N_FLANK) -> Outline:
    """Outline of a gear, from its real tooth if it has one.

    Parameters
    ----------
    gear
        External or internal gear.
    n_flank
        Points per flank of a generated tooth.

    Raises
    ------
    GeometryError
        If the tooth is not possible.

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
    corner = float(height.max()) if tip_edge(gear) is None else min(0.5 * gear.d_Fa, float(height.max()))
    part[height > corner - 1e-9 * gear.m_n] = TIP
    turn = complex(np.exp(2j * math.pi / abs(gear.z)))
    plane, part = _divided(plane, part, turn, _STEP * gear.m_n / n_flank)
    return Outline(abs(gear.z), gear.sign, plane, part)
