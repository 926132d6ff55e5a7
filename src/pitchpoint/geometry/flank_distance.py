# SPDX-License-Identifier: Apache-2.0
"""Distance of two flanks at any relative position of their gears, micro-geometry included.

Derivation: docs/theory/geometry.md, "Distance of two flanks".
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.geometry.flank_surface import Flank
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.geometry.placement import mesh_offset

FloatArray = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Mounting:
    """Position of gear 2 relative to gear 1.

    Parameters
    ----------
    pair
        The gears and their centre distance at mid-face of gear 2.
    phi1, phi2
        Rotations of the gears about their axes, counter-clockwise, as in `mesh_outlines`; None for `phi2` =
        half of the backlash on either flank with parallel axes [rad].
    offset
        Axial position of the mid-face of gear 2, less that of gear 1 [m].
    in_plane, out_of_plane
        Tilt of axis 2 about its mid-face: components of the rotation of its direction, along the line from
        gear 1 to the pitch point and 90° counter-clockwise of it [rad].
    """

    pair: GearPair
    phi1: float = 0.0
    phi2: float | None = None
    offset: float = 0.0
    in_plane: float = 0.0
    out_of_plane: float = 0.0

    @cached_property
    def turns(self) -> tuple[float, float]:
        """Rotations of both gears [rad]."""
        if self.phi2 is not None:
            return self.phi1, self.phi2
        g1, g2 = self.pair.gear1, self.pair.gear2
        return self.phi1, -(g1.r_b * self.phi1 + math.tan(g1.beta_b) * self.offset) / g2.r_b

    @cached_property
    def _frames(self) -> tuple[tuple[FloatArray, FloatArray], ...]:
        """Origin and axes (columns) of both gears in the frame of the centre distance."""
        phi1, phi2 = self.turns
        tilt = math.hypot(self.in_plane, self.out_of_plane)
        lean = np.eye(3)
        if tilt > 0.0:
            x, y = -self.out_of_plane / tilt, self.in_plane / tilt
            cross = np.array([[0.0, 0.0, y], [0.0, 0.0, -x], [-y, x, 0.0]])
            versine = 2.0 * math.sin(0.5 * tilt) ** 2
            lean = lean + math.sin(tilt) * cross + versine * cross @ cross
        return (
            (np.zeros(3), _spin(phi1)),
            (np.array([self.pair.a_w, 0.0, self.offset]), lean @ _spin(mesh_offset(self.pair) + phi2)),
        )

    def transfer(self, vectors: FloatArray, gear: int, free: bool = False) -> FloatArray:
        """Points of one gear in the frame of the other.

        Parameters
        ----------
        vectors
            Points in the frame of gear `gear`, shape (..., 3) [m].
        gear
            1 or 2.
        free
            Directions instead of points.

        Returns
        -------
        ndarray, shape (..., 3)
            The same in the frame of the other gear.
        """
        (here, axes), (there, others) = self._frames[:: 3 - 2 * gear]
        turned = vectors @ (others.T @ axes).T
        return turned if free else turned + (here - there) @ others

    def world(self, points: FloatArray, gear: int) -> FloatArray:
        """Points of gear 1 or 2 in axes along the line of centres, axis and mid-face of gear 1 at the origin.

        Parameters
        ----------
        points
            In the frame of the gear, shape (..., 3) [m].
        gear
            1 or 2.

        Returns
        -------
        ndarray, shape (..., 3)
            The points [m].
        """
        origin, axes = self._frames[gear - 1]
        return np.asarray(points @ axes.T + origin)


@dataclass(frozen=True)
class Gap:
    """Distances of points of one flank to the flank of the mate, arrays of one shape.

    Attributes
    ----------
    distance
        Normal to the flank of the mate [m]; negative where the teeth overlap, NaN where the mate has no
        involute.
    own_roll, own_z
        Length of roll and position along the face width of the points [m].
    mate_roll, mate_z
        Those of the nearest points of the mate [m], also beyond the ends of its flank.
    """

    distance: FloatArray
    own_roll: FloatArray
    own_z: FloatArray
    mate_roll: FloatArray
    mate_z: FloatArray


@dataclass(frozen=True, eq=False, kw_only=True)
class Facing:
    """Two flanks that face each other.

    Parameters
    ----------
    mounting
        Relative position of the gears.
    own
        Flank of gear `gear`, whose points are considered.
    mate
        Flank of the other gear.
    gear
        1 or 2.
    """

    mounting: Mounting
    own: Flank
    mate: Flank
    gear: int = 1

    def swapped(self) -> Facing:
        """The same flanks, with the points of the mate considered."""
        return Facing(mounting=self.mounting, own=self.mate, mate=self.own, gear=3 - self.gear)


def flank_distance(facing: Facing, roll: ArrayLike, z: ArrayLike) -> Gap:
    """Distance of points of one flank to the flank of the mate.

    Parameters
    ----------
    facing
        The flanks and their relative position.
    roll, z
        Lengths of roll and positions along the face width of the points [m], broadcast against each other.

    Returns
    -------
    Gap
        The distances, shape of the broadcast arguments.

    Notes
    -----
    Exact for the involute helicoids and for the micro-geometry of `own`, whose points are displaced along
    their normals. The gap of the mate is added along its normal: the error is half of the gap times the
    square of its slope, below 1 nm for a relief of 30 µm over 4 mm.

    Examples
    --------
    Where the flanks of a spur pair are nearest, their distance is half of the normal backlash:

    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=30, m_n=2e-3, thickness_allowance=-40e-6)
    >>> pair = GearPair(gear, gear, 0.06)
    >>> one, two = Flank(gear=gear), Flank(gear=gear, tooth=-1)
    >>> roll = gear.r_b * (gear.psi_b + pair.alpha_wt)
    >>> facing = Facing(mounting=Mounting(pair=pair), own=one, mate=two)
    >>> bool(abs(flank_distance(facing, [roll], 0.0).distance[0] - 0.5 * pair.j_bn) < 1e-15)
    True
    """
    roll, z = np.broadcast_arrays(np.asarray(roll, dtype=float), np.asarray(z, dtype=float))
    points, normals = facing.own.points(roll, z)
    points = points - facing.own.gap(roll, z)[..., None] * normals
    distance, mate_roll, mate_z = facing.mate.distance(facing.mounting.transfer(points, facing.gear))
    gap = facing.mate.gap(np.nan_to_num(mate_roll), np.nan_to_num(mate_z))
    return Gap(distance + gap, roll, z, mate_roll, mate_z)


def _spin(angle: float) -> FloatArray:
    """Rotation about the third axis."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
