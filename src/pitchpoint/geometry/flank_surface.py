# SPDX-License-Identifier: Apache-2.0
"""Flank of a gear in space: involute helicoid with micro-geometry, and the distance of points to it.

Involute helicoids of one base cylinder are parallel surfaces. The distance of a point is therefore closed
form: rotate the flank about its axis until it passes through the point, and multiply the travel of its base
cylinder by cos(beta_b).

Frame of a gear: origin on its axis at mid-face, third axis along its axis, tooth 0 at mid-face on the first.
Lengths of roll are positive for internal gears too.

Derivation: docs/theory/geometry.md, "Distance of two flanks".
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.deviations import FLANKS, separation
from pitchpoint.geometry.modifications import deviation, flank_range

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    from pitchpoint.geometry.deviations import Deviations
    from pitchpoint.geometry.modifications import FlankModifications

FloatArray = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]

N_WIDTH, N_ROLL = 65, 257
"""Stations of deviations over face width and length of roll; bilinear in between."""
_EDGE = 1e-10
"""Distance beyond the edges up to which points belong to a flank [m]."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Flank:
    """One flank of a gear, with its deviations from the involute helicoid.

    Parameters
    ----------
    gear
        External or internal gear.
    side
        "left" or "right"; the left flank of a tooth is on its counter-clockwise side.
    tooth
        Number of the tooth, from 0.
    modifications
        Modifications of this side, or None.
    deviations
        Deviations of the teeth, or None; they and the gap of the gear's `outline` are interpolated between
        `N_WIDTH` and `N_ROLL` stations.
    every_tooth
        Use the smallest gap of all teeth at each point instead of that of `tooth`.

    Raises
    ------
    GeometryError
        If the side is unknown.
    """

    gear: CylindricalGear
    side: str = "left"
    tooth: int = 0
    modifications: FlankModifications | None = None
    deviations: Deviations | None = None
    every_tooth: bool = False

    def __post_init__(self) -> None:
        if self.side not in FLANKS:
            raise GeometryError("is unknown", where="side", value=f"{self.side!r}", limit=" or ".join(FLANKS))

    @property
    def hand(self) -> float:
        """+1 for a left, −1 for a right flank: direction of its outward normal about the axis."""
        return 1.0 if self.side == "left" else -1.0

    @property
    def is_ideal(self) -> bool:
        """Whether the flank is the involute helicoid."""
        return self.modifications is None and self.deviations is None and self.gear.outline is None

    @cached_property
    def span(self) -> tuple[float, float]:
        """Smallest and largest length of roll of the usable flank [m]."""
        low, high = sorted(flank_range(self.gear))
        return low, high

    @cached_property
    def _start(self) -> float:
        """Angle of the involute at mid-face where it meets the base circle [rad]."""
        turn = 2.0 * math.pi * self.tooth / abs(self.gear.z)
        return turn + self.hand * self.gear.sign * self.gear.psi_b

    def points(self, roll: ArrayLike, z: ArrayLike) -> tuple[FloatArray, FloatArray]:
        """Points of the involute helicoid and its outward normals.

        Parameters
        ----------
        roll
            Lengths of roll [m], any shape.
        z
            Positions along the face width [m], broadcast against roll.

        Returns
        -------
        points, normals : ndarray, shape (..., 3)
            In the frame of the gear [m], [-].
        """
        gear, s, r_b = self.gear, self.hand, abs(self.gear.r_b)
        roll, z = np.broadcast_arrays(np.asarray(roll, dtype=float), np.asarray(z, dtype=float))
        tangent = np.exp(1j * (self._start + z * (math.tan(gear.beta_b) / r_b) - s * gear.sign * roll / r_b))
        flat = tangent * (r_b + 1j * s * gear.sign * roll)
        normal = 1j * s * math.cos(gear.beta_b) * tangent
        axial = np.full(z.shape, -s * math.sin(gear.beta_b))
        return space_vectors(flat, z), space_vectors(normal, axial)

    def distance(self, points: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Distance of points to the involute helicoid, and where they are nearest to it.

        Parameters
        ----------
        points
            In the frame of the gear, shape (..., 3) [m].

        Returns
        -------
        distance, roll, z : ndarray, shape (...)
            Distance along the normal, positive outside the tooth; length of roll and position along the face
            width of the nearest point [m]. The helicoid is not limited to the flank: a negative roll is below
            the base circle. NaN for points inside the base cylinder.

        Notes
        -----
        A point at the radius r is on an involute that leaves the base circle at the angle θ_p; the flank
        leaves it at θ. The distance is ± r_b (θ_p − θ) cos β_b.
        """
        gear, s, r_b = self.gear, self.hand, abs(self.gear.r_b)
        angle, roll = self._tangent(points)
        z = points[..., 2]
        turned = angle + s * roll / r_b - z * (math.tan(gear.beta_b) / r_b) - self._start
        turned -= 2.0 * math.pi * np.round(turned / (2.0 * math.pi))
        distance = s * r_b * math.cos(gear.beta_b) * turned
        foot = gear.sign * (roll - distance * math.cos(gear.beta_b))
        return distance, foot, z + s * distance * math.sin(gear.beta_b)

    def _tangent(self, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Where the base tangent through points leaves the base circle [rad], and their signed roll [m]."""
        flat = points[..., 0] + 1j * points[..., 1]
        square = flat.real**2 + flat.imag**2 - self.gear.r_b**2
        roll = self.gear.sign * np.sqrt(np.where(square >= 0.0, square, np.nan))
        return np.angle(flat) - self.hand * np.arctan(roll / abs(self.gear.r_b)), roll

    def normals_at(self, points: FloatArray) -> FloatArray:
        """Outward normals of the parallel helicoids through points, gradient of `distance`.

        Parameters
        ----------
        points
            In the frame of the gear, shape (..., 3) [m].

        Returns
        -------
        ndarray, shape (..., 3)
            Unit vectors.
        """
        s, beta_b = self.hand, self.gear.beta_b
        angle, _ = self._tangent(points)
        axial = np.full(angle.shape, -s * math.sin(beta_b))
        return space_vectors(1j * s * math.cos(beta_b) * np.exp(1j * angle), axial)

    def covers(self, roll: FloatArray, z: FloatArray) -> NDArray[np.bool_]:
        """Whether points at lengths of roll and widths [m] are on the usable flank, shape of both."""
        low, high = self.span
        inside = (roll >= low - _EDGE) & (roll <= high + _EDGE)
        return np.asarray(inside & (np.abs(z) <= 0.5 * self.gear.b + _EDGE))

    @cached_property
    def _grid(self) -> FloatArray | None:
        """Gap by outline and deviations along the base tangent, shape (`N_WIDTH`, `N_ROLL`), or None."""
        gear = self.gear
        if self.deviations is None and gear.outline is None:
            return None
        z, roll = np.linspace(-0.5, 0.5, N_WIDTH) * gear.b, np.linspace(*self.span, N_ROLL)
        every = separation(gear, self.side, z, roll, deviations=self.deviations)
        return np.asarray(every.min(axis=0) if self.every_tooth else every[self.tooth % abs(gear.z)])

    def gap(self, roll: ArrayLike, z: ArrayLike) -> FloatArray:
        """Material missing relative to the involute helicoid, along its normal.

        Parameters
        ----------
        roll, z
            Lengths of roll and positions along the face width [m], broadcast against each other. Constant
            beyond the ends of the flank.

        Returns
        -------
        ndarray
            Modifications, deviations and outline [m], shape of the broadcast arguments; negative for excess
            material.
        """
        gear, half = self.gear, 0.5 * self.gear.b
        along: FloatArray = np.clip(np.asarray(roll, dtype=float), *self.span)
        across: FloatArray = np.clip(np.asarray(z, dtype=float), -half, half)
        found = np.zeros(np.broadcast(along, across).shape)
        if self.modifications is not None:
            found = found + deviation(self.modifications, gear, along, across)
        if self._grid is not None:
            found = found + self._read(along, across) * math.cos(gear.beta_b)
        return found

    def _read(self, roll: FloatArray, z: FloatArray) -> FloatArray:
        """Bilinear interpolation of the grid."""
        grid, (low, high) = self._grid, self.span
        assert grid is not None
        across, along = (z / self.gear.b + 0.5) * (N_WIDTH - 1), (roll - low) / (high - low) * (N_ROLL - 1)
        i = np.minimum(across.astype(int), N_WIDTH - 2)
        j = np.minimum(along.astype(int), N_ROLL - 2)
        u, v = across - i, along - j
        near = grid[i, j] * (1.0 - v) + grid[i, j + 1] * v
        far = grid[i + 1, j] * (1.0 - v) + grid[i + 1, j + 1] * v
        return np.asarray(near * (1.0 - u) + far * u)


def space_vectors(flat: ComplexArray, z: FloatArray) -> FloatArray:
    """Vectors from complex transverse parts and axial parts.

    Parameters
    ----------
    flat, z
        Transverse parts x + iy and axial parts, arrays of one shape.

    Returns
    -------
    ndarray, shape (..., 3)

    Examples
    --------
    >>> space_vectors(np.array([1.0 + 2.0j]), np.array([3.0])).tolist()
    [[1.0, 2.0, 3.0]]
    """
    return np.stack([flat.real, flat.imag, z], axis=-1)
