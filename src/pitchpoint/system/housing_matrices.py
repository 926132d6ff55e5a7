# SPDX-License-Identifier: Apache-2.0
"""Matrices of a housing between its nodes: read from files and checked."""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.model.components.housing import HousingMatrix
from pitchpoint.model.frames import axes_of
from pitchpoint.model.housing import NAME, bearings_in, seat_name
from pitchpoint.model.rings import mounted_place
from pitchpoint.multibody.square_matrix import read_square

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

MASSLESS = 1e5
"""Frequency at which a node without mass vibrates on its own stiffness [Hz], far above all excitation."""
UNEQUAL = 1e-6
"""Difference of opposite entries, over the mean of their diagonal entries, due to rounded numbers."""
WAYS = ("a displacement in x", "one in y", "one in z", "a rotation about x", "one about y", "one about z")
"""Motions of a rigid body."""
RIGID = 1e-3
"""Strain energy of a motion of a rigid body, over the sum of the magnitudes of its parts, due to rounding."""
ZERO = 1e-7
"""Eigenvalue of a matrix with unit diagonal up to which it is zero; exported numbers have seven digits."""


@dataclass(frozen=True)
class Matrices:
    """Matrices of the free nodes of a housing, in its axes, SI units.

    Parameters
    ----------
    nodes
        Names of the nodes, in the order of the rows.
    K, M, D
        Stiffness, mass and damping, (rows per node times nodes) squared.
    loose
        Number of motions without stiffness, before the elastic feet: 0, or 6 of a free housing.
    weighed
        Whether a mass matrix was given.
    """

    nodes: tuple[str, ...]
    K: Array
    M: Array
    D: Array
    loose: int
    weighed: bool


def housing_matrices(model: Model) -> Matrices:
    """Matrices of the free nodes of a housing, read and checked.

    Raises
    ------
    ModelError
        If a file is not a symmetric positive semidefinite matrix of the nodes, or the housing can move
        freely.
    """
    held = model.housing
    assert isinstance(held, HousingMatrix)
    files = (held.stiffness_file, held.mass_file, held.damping_file)
    n = held.rows_per_node
    read: list[Array | None] = []
    problems: list[Message] = []
    for key, file in zip(("stiffness_file", "mass_file", "damping_file"), files, strict=True):
        try:
            read.append(None if file is None else _checked(file, n, held.nodes))
        except ModelError as fault:
            read.append(None)
            found = fault.problems[0]
            text = found.text + (f" (line {found.line})" if found.line is not None else "")
            problems.append(found.changed(where=f"{NAME}.{key}", text=text, line=None))
    K = read[0]
    if K is not None:
        problems += _loose(model, K)
        problems += _mass_of_rows(model, read[1])
    if problems or K is None:
        raise ModelError(problems, model.file)
    free = [
        k
        for k, node in enumerate(held.nodes)
        if node not in held.feet or held.feet[node].stiffness is not None
    ]
    kept = (n * np.array(free)[:, None] + np.arange(n)).ravel()
    cut = np.ix_(kept, kept)
    M = _light(K) if read[1] is None else read[1]
    D = held.stiffness_damping * K + (0.0 if read[2] is None else read[2])
    nodes = tuple(held.nodes[k] for k in free)
    return Matrices(nodes, K[cut], M[cut], D[cut], _free_motions(K), read[1] is not None)


def supported_stiffness(model: Model) -> tuple[tuple[str, ...], Array]:
    """Free nodes of a housing, and its stiffness matrix with the springs of its feet.

    Raises
    ------
    ModelError
        As `housing_matrices`, and if the springs of the feet leave the housing free.
    """
    held = model.housing
    assert isinstance(held, HousingMatrix)
    found = housing_matrices(model)
    K, n = found.K.copy(), held.rows_per_node
    for k, node in enumerate(found.nodes):
        spring = held.feet[node].stiffness if node in held.feet else None
        if spring is not None:
            at = slice(n * k, n * k + n)
            K[at, at] += np.array(spring.matrix6())[:n, :n]
    if free := _free_motions(K):
        text = f"leave {free} motions of the housing free"
        raise ModelError(
            [Message(f"{NAME}.feet", text, remedy="give them stiffness in all directions, or more feet")],
            model.file,
        )
    return found.nodes, K


def _light(K: Array) -> Array:
    """Diagonal mass matrix of nodes without mass: each vibrates at `MASSLESS` on its own stiffness."""
    size = np.abs(np.diag(K))
    least = np.where(size > 0.0, size, size.max())
    return np.asarray(np.diag(least / (2.0 * math.pi * MASSLESS) ** 2))


def _checked(file: str, n: int, nodes: tuple[str, ...]) -> Array:
    stamp = Path(file).stat().st_mtime_ns if Path(file).is_file() else 0
    return _symmetric(file, stamp, n, nodes)


@functools.lru_cache(maxsize=8)
def _symmetric(file: str, stamp: int, n: int, nodes: tuple[str, ...]) -> Array:
    """Matrix of a file; `stamp` is its modification time and part of the cache key."""
    A = read_square(file)
    if len(A) != n * len(nodes):
        raise ModelError(
            [
                Message(
                    "",
                    f"has {len(A)} rows",
                    limit=f"{n * len(nodes)}, {n} for each of {len(nodes)} nodes",
                    remedy="list all nodes of the matrix in nodes, or correct rows_per_node",
                )
            ]
        )
    size = np.sqrt(np.abs(np.diag(A)))
    scale = np.outer(size, size)
    off = np.abs(A - A.T) - UNEQUAL * np.where(scale > 0.0, scale, np.abs(A).max())
    if off.max() > 0.0:
        i, j = (int(v) for v in np.unravel_index(int(np.argmax(off)), A.shape))
        raise ModelError(
            [
                Message(
                    "",
                    f"is not symmetric: row {i + 1}, column {j + 1} ({place(i, n, nodes)}, "
                    f"{place(j, n, nodes)}) is {A[i, j]:.6g}, its opposite {A[j, i]:.6g}",
                    remedy="export both triangles with the same number of digits",
                )
            ]
        )
    A = 0.5 * (A + A.T)
    values, shapes = np.linalg.eigh(_unit(A))
    if values[0] < -ZERO * len(A):
        row = int(np.argmax(np.abs(shapes[:, 0])))
        raise ModelError(
            [
                Message(
                    "",
                    "is not positive semidefinite: a motion, mostly of "
                    f"{place(row, n, nodes)}, has negative energy",
                    remedy="check signs, units (N, m, rad) and the order of the nodes",
                )
            ]
        )
    return A


def place(row: int, n: int, nodes: tuple[str, ...]) -> str:
    """Node and displacement of a row.

    Examples
    --------
    >>> place(7, 6, ("left", "right"))
    'right y'
    """
    return f"{nodes[row // n]} {('x', 'y', 'z', 'rx', 'ry', 'rz')[row % n]}"


def _unit(A: Array) -> Array:
    """Symmetric matrix with its diagonal scaled to 1."""
    size = np.abs(np.diag(A))
    size = np.where(size > 0.0, size, max(float(np.abs(A).max()), 1e-300))
    return np.asarray(A / np.sqrt(np.outer(size, size)))


def _free_motions(K: Array) -> int:
    """Number of motions of all nodes without stiffness."""
    return int(np.sum(np.linalg.eigvalsh(_unit(K)) < ZERO * len(K)))


def _loose(model: Model, K: Array) -> list[Message]:
    """Problems of a matrix that leaves motions free that nothing holds."""
    held = model.housing
    assert isinstance(held, HousingMatrix)
    n = held.rows_per_node
    where = f"{NAME}.stiffness_file"
    free = _free_motions(K)
    places = _node_places(model, held)
    if not free:
        return []
    if free == 6 and places is not None:
        rigid = rigid_motions(places, n)
        strain = np.einsum("ik,ij,jk->k", rigid, K, rigid)
        share = strain / np.einsum("ik,ij,jk->k", np.abs(rigid), np.abs(K), np.abs(rigid))
        if share.max() > RIGID:
            motion = WAYS[int(np.argmax(share))]
            return [
                Message(
                    where,
                    f"has six motions without stiffness, but {motion} of all nodes is none of them",
                    remedy="check the order and positions of the nodes, and axes and units of the matrix",
                )
            ]
    if not held.feet:
        return [
            Message(
                where,
                f"leaves {free} motions of the housing free",
                remedy="export the matrix with the feet fixed, or include the feet in nodes and feet",
            )
        ]
    if free != 6:
        return [
            Message(
                where,
                f"has {free} motions without stiffness",
                limit="0 of a housing on ground, 6 of a free one",
                remedy="remove nodes and displacements without stiffness, or check the order of the nodes",
            )
        ]
    return []


def _mass_of_rows(model: Model, M: Array | None) -> list[Message]:
    """Problem of a mass matrix without mass in some direction."""
    held = model.housing
    assert isinstance(held, HousingMatrix)
    if M is None:
        return []
    n = held.rows_per_node
    masses = [float(M[k::n, k::n].sum()) for k in range(3)]
    if min(masses) > ZERO * float(np.abs(M).max()):
        return []
    words = ", ".join(f"{mass:.4g} kg in {way}" for mass, way in zip(masses, "xyz", strict=True))
    return [
        Message(
            f"{NAME}.mass_file",
            f"has a mass of {words}",
            limit="> 0",
            remedy="check the file, which may be another matrix, its unit (kg) and the order of its rows",
        )
    ]


def rigid_motions(places: Array, n: int) -> Array:
    """Displacements of all nodes in the six motions of a rigid body, (n times nodes, 6); rotations about the
    first node.

    Parameters
    ----------
    places
        Positions of the nodes in the axes of the matrix (nodes, 3) [m].
    n
        Rows per node, 3 or 6.
    """
    found = np.zeros((n * len(places), 6))
    for k, arm in enumerate(places - places[0]):
        found[n * k : n * k + 3, :3] = np.eye(3)
        found[n * k : n * k + 3, 3:] = np.cross(np.eye(3), arm).T
        if n == 6:
            found[n * k + 3 : n * k + 6, 3:] = np.eye(3)
    return found


def _node_places(model: Model, held: HousingMatrix) -> Array | None:
    """Positions of all nodes in the axes of the matrix [m]; None if one is unknown."""
    seats = bearings_in(model)
    found = []
    for node in held.nodes:
        if node in seats:
            place = mounted_place(model, seats[node][1])
        else:
            foot = held.feet.get(node)
            place = np.array(foot.position if foot is not None else model.bodies[node].origin, float)
        if place is None:
            return None
        found.append(place)
    axes = next((axes_of(model, seat_name(n)) for n in held.nodes if seat_name(n) in model.bodies), np.eye(3))
    return np.array(found) @ axes
