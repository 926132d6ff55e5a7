# SPDX-License-Identifier: Apache-2.0
"""Closed solids: volume, centre of mass, inertia, and the axis of rotational symmetry.

Derivation: docs/theory/geometry.md, "Mass and inertia".
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import GeometryError

FloatArray = NDArray[np.float64]

UNEVEN = 0.02
"""Maximum difference of the transverse moments of inertia, relative to the largest moment, of a solid that
counts as rotationally symmetric: keyways and holes are below, a lever is far above."""
APART = 1e-3
"""Minimum relative difference between polar and transverse moments of inertia that identifies the axis."""


@dataclass(frozen=True)
class Solid:
    """One closed solid of a file.

    Parameters
    ----------
    name
        Name in the file; '' if it has none.
    volume
        Volume [m³].
    center
        Centre of volume in the coordinates of the file [m].
    moments
        Ixx, Iyy, Izz, Ixy, Iyz, Izx about the centre of volume along the axes of the file, for unit density
        [m⁵]; products are entries of the inertia matrix, Ixy = −∫ x y dV.
    """

    name: str
    volume: float
    center: tuple[float, float, float]
    moments: tuple[float, float, float, float, float, float]

    @property
    def matrix(self) -> FloatArray:
        """Inertia matrix about the centre of volume for unit density, shape (3, 3) [m⁵]."""
        xx, yy, zz, xy, yz, zx = self.moments
        return np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]])


@dataclass(frozen=True)
class SolidFile:
    """Solids of a file.

    Parameters
    ----------
    solids
        Solids in the order of the file.
    unit
        Unit of length as text.
    """

    solids: tuple[Solid, ...]
    unit: str

    def part(self, name: str | None = None) -> Solid:
        """Solid of a name; the name may be None if there is only one.

        Raises
        ------
        GeometryError
            If there are several and no name is given, or there is none of this name; lists the names.
        """
        if name is None and len(self.solids) == 1:
            return self.solids[0]
        found = next((s for s in self.solids if s.name == name), None)
        if found is None or name is None:
            names = ", ".join(f"'{s.name}'" for s in self.solids[:20])
            more = f" and {len(self.solids) - 20} more" if len(self.solids) > 20 else ""
            raise GeometryError(
                "is missing: the file has several solids" if name is None else "is not a solid of the file",
                where="part",
                value=None if name is None else f"'{name}'",
                remedy=f"there {'are' if len(self.solids) > 1 else 'is'} {names}{more}",
            )
        return found


@dataclass(frozen=True)
class RoundInertia:
    """Inertia of a solid that is rotationally symmetric about an axis, for unit density.

    Parameters
    ----------
    axis
        Unit vector of the axis in the file.
    polar
        Moment of inertia about the axis [m⁵].
    transverse
        Mean transverse moment of inertia about the centre of volume [m⁵].
    uneven
        Difference of the transverse moments, relative to the largest moment [-].
    """

    axis: tuple[float, float, float]
    polar: float
    transverse: float
    uneven: float


def solid_of_triangles(corners: ArrayLike, name: str = "") -> Solid:
    """Volume, centre and inertia of a solid bounded by a closed triangulated surface.

    Parameters
    ----------
    corners
        Corners of the triangles, counter-clockwise seen from outside, shape (n, 3, 3) [m].
    name
        Name of the solid.

    Notes
    -----
    Every triangle forms a tetrahedron with the middle of the surface. With the corners a, b, c relative to it
    and s = a + b + c: V = a·(b×c)/6, ∫ x dV = V s/4, ∫ x xᵀ dV = V (a aᵀ + b bᵀ + c cᵀ + s sᵀ)/20. Exact to
    round-off for any closed surface.

    Examples
    --------
    A tetrahedron with three edges of length 1 along the axes:

    >>> o, x, y, z = np.zeros(3), *np.eye(3)
    >>> found = solid_of_triangles([[o, y, x], [o, z, y], [o, x, z], [x, y, z]])
    >>> round(6.0 * found.volume, 12), [round(4.0 * c, 12) for c in found.center]
    (1.0, [1.0, 1.0, 1.0])
    >>> round(80.0 * found.moments[0], 12), round(480.0 * found.moments[3], 12)
    (1.0, 1.0)
    """
    points = np.asarray(corners, float)
    middle = 0.5 * (points.min(axis=(0, 1)) + points.max(axis=(0, 1)))
    a, b, c = np.moveaxis(points - middle, 1, 0)
    s = a + b + c
    volumes = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6.0
    volume = float(volumes.sum())
    center = volumes @ s / (4.0 * volume)
    second = np.zeros((3, 3))
    for p in (a, b, c, s):
        second += np.einsum("i,ij,ik->jk", volumes, p, p) / 20.0
    second -= volume * np.outer(center, center)
    return solid_of(name, volume, middle + center, np.trace(second) * np.eye(3) - second)


def solid_of(name: str, volume: float, center: ArrayLike, inertia: ArrayLike) -> Solid:
    """Solid from arrays.

    Parameters
    ----------
    name
        Name.
    volume
        Volume [m³].
    center
        Centre of volume, shape (3,) [m].
    inertia
        Inertia matrix about the centre for unit density, shape (3, 3) [m⁵].
    """
    x, y, z = (float(v) for v in np.asarray(center, float))
    i = np.asarray(inertia, float)
    xx, yy, zz = (float(i[k, k]) for k in range(3))
    return Solid(name, volume, (x, y, z), (xx, yy, zz, float(i[0, 1]), float(i[1, 2]), float(i[2, 0])))


def round_inertia(solid: Solid, axis: ArrayLike | None = None) -> RoundInertia:
    """Axis of a rotationally symmetric solid, and its polar and transverse moments of inertia.

    Parameters
    ----------
    solid
        The solid.
    axis
        Direction of the axis in the file, shape (3,), of any length; None: axis identified from the inertia.

    Returns
    -------
    RoundInertia
        An identified axis points in the positive direction of the nearest coordinate axis of the file.

    Raises
    ------
    GeometryError
        If the solid is not rotationally symmetric about the axis, or if no axis can be identified because all
        principal moments are about equal, as for a cylinder with a length of √3 times its radius.

    Notes
    -----
    A body with three or more equal sectors has two equal principal moments; the third is the one about its
    axis.

    Examples
    --------
    >>> lying = Solid("", 1.0, (0.0, 0.0, 0.0), (2.0, 1.5, 1.5, 0.0, 0.0, 0.0))
    >>> found = round_inertia(lying)
    >>> found.axis, found.polar, found.transverse
    ((1.0, 0.0, 0.0), 2.0, 1.5)
    """
    inertia = solid.matrix
    moments, directions = np.linalg.eigh(inertia)
    largest = float(moments[2])
    if axis is None:
        low, high = (moments[1] - moments[0]) / largest, (moments[2] - moments[1]) / largest
        uneven, apart = float(min(low, high)), float(max(low, high))
        if uneven > UNEVEN:
            raise _not_round(moments, "give axes: {z: [0, 0, 1]} if it nevertheless rotates about an axis")
        if apart < max(APART, 5.0 * uneven):
            raise GeometryError(
                "does not define an axis: its principal moments of inertia are about equal",
                where="file",
                value=_listed(moments),
                remedy="give axes: {z: [0, 0, 1]} with the direction of the axis in the file",
            )
        k = 2 if low <= high else 0
        along = directions[:, k] + 0.0
        along = along * np.sign(along[np.argmax(np.abs(along))]) + 0.0
        polar, transverse = float(moments[k]), 0.5 * float(moments.sum() - moments[k])
    else:
        along = np.asarray(axis, float) / np.linalg.norm(axis)
        polar = float(along @ inertia @ along)
        transverse = 0.5 * (float(np.trace(inertia)) - polar)
        beside = inertia - polar * np.outer(along, along) - transverse * (np.eye(3) - np.outer(along, along))
        uneven = 2.0 * float(np.abs(np.linalg.eigvalsh(beside)).max()) / largest
        if uneven > UNEVEN:
            raise _not_round(moments, "correct axes, or omit them so that the axis is found")
    x, y, z = (round(float(v), 12) + 0.0 for v in along)
    return RoundInertia((x, y, z), polar, transverse, uneven)


def _not_round(moments: FloatArray, remedy: str) -> GeometryError:
    return GeometryError(
        "is not round about an axis",
        where="file",
        value=f"a solid with {_listed(moments)}",
        limit=f"two equal to {100.0 * UNEVEN:g} %",
        remedy=remedy,
    )


def _listed(moments: FloatArray) -> str:
    parts = ", ".join(f"{m / moments[2]:.4f}" for m in moments)
    return f"principal moments as {parts}"
