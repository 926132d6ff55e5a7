# SPDX-License-Identifier: Apache-2.0
"""Casing: rigid, or the reduced stiffness matrix of its assembly group as the housing of the model.

The matrix has six rows for each reduction point, in the order of their relations: displacements along u, v, w
of the assembly group and rotations about them, in N, mm and rad. Each reduction point refers to a bearing.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.io.rexs.conversion.bearings import CASING, centre_of
from pitchpoint.io.rexs.conversion.frames import TO_MODEL, frame_of, place_in_world
from pitchpoint.io.rexs.conversion.state import Conversion
from pitchpoint.io.rexs.document import RexsComponent

MATRIX, FIXED = "reduced_static_stiffness_matrix", "matrix_with_inertial_environment_boundary"
MILLI = 1e-3
SYMMETRIC = 1e-6
"""Largest difference of opposite entries over their diagonal entries."""
FAR = 1e-3
"""Distance of a reduction point from its bearing that is listed [m]."""
TOUCH = 1e-9
"""Distance that counts as rounding [m]."""
SEATED = ("bearings", "rolling_bearings")


def convert_casing(conversion: Conversion) -> np.ndarray | None:
    """Add the housing with a stiffness matrix; the matrix in SI units and world axes, None if it is rigid."""
    for casing in conversion.source.of_type(*CASING):
        for group in conversion.referenced(casing, "assembly_group"):
            if MATRIX in group.attributes and "housing" not in conversion.data:
                found = _matrix_housing(conversion, group)
                if found is not None:
                    return found
            elif MATRIX in group.attributes:
                conversion.ignored(group, "all", "a model has one housing")
    return None


def _matrix_housing(conversion: Conversion, group: RexsComponent) -> np.ndarray | None:
    points = conversion.parts(group, "reduction_point")
    K = np.array(group.get(MATRIX), float)
    reason = _obstacle(group, points, K)
    frame = frame_of(conversion, group)
    if reason or frame is None:
        conversion.ignored(group, "all", reason or "it has no position: the casing is rigid")
        conversion.done.update(point.id for point in points)
        return None
    conversion.value(group, MATRIX, "housing.stiffness_file")
    conversion.value(group, FIXED, "housing")
    conversion.done.add(group.id)
    K = in_world(0.5 * (K + K.T), frame.axes @ TO_MODEL)
    bearings = [_bearing_at(conversion, point) for point in points]
    offsets = [_offset(conversion, p, b) for p, b in zip(points, bearings, strict=True)]
    kept = [k for k, bearing in enumerate(bearings) if bearing is not None]
    if not kept:
        conversion.ignored(group, "all", "its reduction points are at no bearings: the casing is rigid")
        return None
    K = condensed(moved(K, offsets), kept)
    nodes = [conversion.name(bearing) for bearing in bearings if bearing is not None]
    for section in SEATED:
        for name, entry in conversion.data.get(section, {}).items():
            if "body" in entry and "housing" not in entry and name not in nodes:
                entry["housing"] = "ground"
                part = conversion.origins[section, name]
                text = "it is at no reduction point of the casing"
                conversion.default(part, "housing", "ground", f"{section}.{name}.housing", text)
    conversion.data["housing"] = {"type": "stiffness_matrix", "stiffness_file": "", "nodes": nodes}
    target, text = "housing.nodes", "bearings of the reduction points"
    conversion.default(group, "reduction points", f"{len(nodes)} nodes", target, text)
    return K


def _obstacle(group: RexsComponent, points: list[RexsComponent], K: np.ndarray) -> str:
    """Why a matrix is not that of a housing; empty if it is."""
    rigid = "the casing is rigid"
    if K.ndim != 2 or K.shape[0] != K.shape[1] or len(K) != 6 * len(points):
        shape = " x ".join(map(str, K.shape))
        return f"its matrix is {shape}, and there are {len(points)} reduction points: {rigid}"
    size = np.sqrt(np.abs(np.diag(K)))
    scale = np.outer(size, size)
    if np.any(np.abs(K - K.T) > SYMMETRIC * np.where(scale > 0.0, scale, np.abs(K).max())):
        return f"its matrix is not symmetric: {rigid}"
    if group.get(FIXED) is False:
        return f"its matrix is that of a free casing, and the file has no stiffness of its feet: {rigid}"
    return ""


def in_world(K: np.ndarray, axes: np.ndarray) -> np.ndarray:
    """Stiffness matrix in N, m, rad along the axes of the world.

    Parameters
    ----------
    K
        Matrix in N, mm, rad, six rows per point.
    axes
        Directions u, v, w of its axes in the world as columns, shape (3, 3).

    Examples
    --------
    A point with 5 N/mm along u, which is z of the world, and 1000 N mm/rad about it:

    >>> K = np.diag([5.0, 0.0, 0.0, 1000.0, 0.0, 0.0])
    >>> np.diag(in_world(K, TO_MODEL)).tolist()
    [0.0, 0.0, 5000.0, 0.0, 0.0, 1.0]
    """
    n = len(K) // 3
    turn = np.kron(np.eye(n), axes)
    unit = np.kron(np.tile([1.0 / MILLI, 1.0], n // 2), np.ones(3))  # displacements in mm, rotations in rad
    newton = np.kron(np.tile([1.0, MILLI], n // 2), np.ones(3))  # forces in N, moments in N m
    found: np.ndarray = turn @ (newton[:, None] * K * unit[None, :]) @ turn.T
    return 0.5 * (found + found.T)


def moved(K: np.ndarray, offsets: list[np.ndarray]) -> np.ndarray:
    """Stiffness matrix of points that are moved rigidly with those of the matrix.

    Parameters
    ----------
    K
        Matrix in SI units, six rows per point.
    offsets
        From the new points to those of the matrix, in the axes of the matrix [m].

    Examples
    --------
    A spring of 1 N/m along y at 0.5 m on the x axis, seen from the origin: 0.25 N m/rad about z.

    >>> K = np.diag([0.0, 1.0, 0.0, 0.0, 0.0, 0.0])
    >>> moved(K, [np.array([0.5, 0.0, 0.0])])[5].tolist()
    [0.0, 0.5, 0.0, 0.0, 0.0, 0.25]
    """
    T = np.eye(len(K))
    for k, (x, y, z) in enumerate(offsets):
        # u_point = u + rotation x offset
        T[6 * k : 6 * k + 3, 6 * k + 3 : 6 * k + 6] = [[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]]
    found: np.ndarray = T.T @ K @ T
    return found


def condensed(K: np.ndarray, kept: list[int]) -> np.ndarray:
    """Stiffness matrix of some of the points; the others carry no load.

    Examples
    --------
    Two springs of 2 N/m in series, ground - point 2 - point 1, along x:

    >>> K = np.eye(12)
    >>> K[0, 0], K[0, 6], K[6, 0], K[6, 6] = 2.0, -2.0, -2.0, 4.0
    >>> float(condensed(K, [0])[0, 0])
    1.0
    """
    rows = (6 * np.array(kept, int)[:, None] + np.arange(6)).ravel()
    rest = np.setdiff1d(np.arange(len(K)), rows)
    if not len(rest):
        return K[np.ix_(rows, rows)]
    coupling = K[np.ix_(rest, rows)]
    shares = np.linalg.lstsq(K[np.ix_(rest, rest)], coupling, rcond=None)[0]
    return np.asarray(K[np.ix_(rows, rows)] - coupling.T @ shares)


def _bearing_at(conversion: Conversion, point: RexsComponent) -> RexsComponent | None:
    """Bearing in the casing at a reduction point; None if there is none in the model."""
    conversion.done.add(point.id)
    for relation in conversion.source.related("reference", origin=point.id):
        number = relation.roles.get("referenced", -1)
        name = conversion.names.get(number)
        for section in SEATED:
            entry = conversion.data.get(section, {}).get(name)
            if entry is not None and "body" in entry and "housing" not in entry:
                return conversion.source.components[number]
    conversion.ignored(point, "all", "it is at no bearing between a shaft and the casing: without load")
    return None


def _offset(conversion: Conversion, point: RexsComponent, bearing: RexsComponent | None) -> np.ndarray:
    """From the centre of a bearing to its reduction point in the world [m]."""
    there = place_in_world(conversion, point)
    here = None if bearing is None else centre_of(conversion, bearing)
    if bearing is None or there is None or here is None:
        return np.zeros(3)
    found = there - here
    distance = float(np.linalg.norm(found))
    if distance > FAR:
        target = f"housing.{conversion.name(bearing)}"
        text = f"it is {1e3 * distance:.4g} mm from the bearing, to which the matrix is transformed"
        conversion.changed(point, "support_vector", "centre of the bearing", target, text)
    return np.where(np.abs(found) < TOUCH, 0.0, found)
