# SPDX-License-Identifier: Apache-2.0
"""Finite-element matrices with node positions, and matrices of straight beams."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.multibody.beam_section import Beam

if TYPE_CHECKING:
    from scipy.sparse import csc_array

Array = NDArray[np.float64]

MAX_UNKNOWNS = 2_000_000
"""Maximum number of displacements."""


@dataclass(frozen=True)
class Structure:
    """Stiffness and mass matrix of an unsupported elastic body in body axes.

    Parameters
    ----------
    K, M
        Sparse symmetric matrices (n, n) [N/m, kg, and the corresponding units for rotations].
    places
        Node positions (number of nodes, 3) [m].
    node, direction
        Node (row of `places`) and direction (0-2 translation, 3-5 rotation) of every displacement, (n,).
    K_spin
        Increase of K due to spin about the third axis, per (rad/s)^2, (n, n): stress stiffness under the
        centrifugal load at 1 rad/s.
    """

    K: csc_array
    M: csc_array
    places: Array
    node: NDArray[np.int64]
    direction: NDArray[np.int64]
    K_spin: csc_array | None = None

    @property
    def size(self) -> int:
        """Number of displacements."""
        return int(self.node.size)

    def displacements(self, node: int) -> NDArray[np.int64]:
        """Rows of one node in the order of their directions."""
        rows = np.flatnonzero(self.node == node)
        return rows[np.argsort(self.direction[rows])]

    def rigid(self, about: ArrayLike = (0.0, 0.0, 0.0)) -> Array:
        """Unit rigid-body displacements (n, 6): three translations, three rotations about a point [m]."""
        arm = (self.places - np.asarray(about, float))[self.node]
        found = np.zeros((self.size, 6))
        for k in range(3):
            turned = np.cross(np.eye(3)[k], arm)
            for d in range(3):
                rows = self.direction == d
                found[rows, 3 + k] = turned[rows, d]
            found[self.direction == k, k] = 1.0
            found[self.direction == 3 + k, 3 + k] = 1.0
        return found


def make_structure(
    K: Any,
    M: Any,
    places: ArrayLike,
    node: ArrayLike | None = None,
    direction: ArrayLike | None = None,
    K_spin: Any = None,
) -> Structure:
    """Check finite-element matrices and convert them to a `Structure`.

    Parameters
    ----------
    K, M
        Stiffness and mass matrix, sparse or dense, (n, n).
    places
        Node positions (number of nodes, 3) [m].
    node, direction
        See `Structure`; if omitted, every node has three translations or six displacements, in order.
    K_spin
        See `Structure`.

    Raises
    ------
    CompileError
        If sizes are inconsistent, a number is not finite, a matrix is not symmetric, or the body is
        supported: a rigid-body motion of an unsupported body causes no force.
    """
    from scipy.sparse import csc_array

    spots = np.asarray(places, float)
    if spots.ndim != 2 or spots.shape[1] != 3 or not np.all(np.isfinite(spots)):
        raise CompileError(f"places: {spots.shape} is not a list of finite points (nodes, 3)")
    pair = []
    for name, given in (("K", K), ("M", M), ("K_spin", K_spin)):
        if given is None:
            continue
        matrix = csc_array(given, dtype=float)
        if matrix.ndim != 2 or matrix.shape[0] != matrix.shape[1]:
            raise CompileError(f"{name}: {matrix.shape} is not square")
        if matrix.shape[0] > MAX_UNKNOWNS:
            raise CompileError(f"{name}: {matrix.shape[0]} displacements (limit {MAX_UNKNOWNS})")
        if not np.all(np.isfinite(matrix.data)):
            raise CompileError(f"{name}: has entries that are not finite")
        off = abs(matrix - matrix.T)
        if off.nnz and off.max() > 1e-8 * abs(matrix).max():
            raise CompileError(f"{name}: is not symmetric; give both triangles of the matrix")
        if name != "K_spin" and matrix.shape[0] and matrix.diagonal().min() < 0.0:
            wrong = int(matrix.diagonal().argmin())
            raise CompileError(f"{name}: has {matrix.diagonal()[wrong]:.6g} on its diagonal, row {wrong + 1}")
        pair.append((0.5 * (matrix + matrix.T)).tocsc())
    n = pair[0].shape[0]
    for name, matrix in zip(("M", "K_spin"), pair[1:], strict=False):
        if matrix.shape[0] != n:
            raise CompileError(f"K has {n} displacements, {name} has {matrix.shape[0]}")
    where, how = _numbering(n, len(spots), node, direction)
    found = Structure(pair[0], pair[1], spots, where, how, pair[2] if len(pair) == 3 else None)
    rest = np.abs(found.K @ found.rigid(spots.mean(axis=0)))
    if n and rest.max() > 1e-6 * abs(found.K).max() * max(1.0, float(np.ptp(spots, axis=0).max())):
        worst = int(rest.max(axis=1).argmax())
        raise CompileError(
            f"K: a rigid-body motion causes a force at node {where[worst]}; remove supports, and check "
            "positions, directions and units of the nodes"
        )
    return found


def _numbering(
    n: int, nodes: int, node: ArrayLike | None, direction: ArrayLike | None
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Node and direction of every displacement."""
    if node is None or direction is None:
        if n not in (3 * nodes, 6 * nodes) or nodes == 0:
            raise CompileError(
                f"{n} displacements of {nodes} nodes are neither 3 nor 6 per node; give node and direction"
            )
        each = n // nodes
        return np.repeat(np.arange(nodes), each), np.tile(np.arange(each), nodes)
    where, how = np.asarray(node, np.int64).reshape(-1), np.asarray(direction, np.int64).reshape(-1)
    if where.size != n or how.size != n:
        raise CompileError(f"node and direction have {where.size} and {how.size} entries, the matrices {n}")
    if n and not (0 <= where.min() and where.max() < nodes and 0 <= how.min() and how.max() < 6):
        raise CompileError(f"nodes are 0 to {nodes - 1}, directions 0 to 5")
    if np.unique(where * 6 + how).size != n:
        raise CompileError("a node has the same direction twice")
    return where, how


FASTEST = 1e5
"""Maximum wave speed [m/s], twenty times the speed of sound in steel, for bodies modelled as nearly rigid."""


def check_mass(structure: Structure) -> None:
    """Check that the mass is positive and the same in all directions.

    Raises
    ------
    CompileError
        If it is not; the message lists the masses along x, y and z.
    """
    rigid = structure.rigid(structure.places.mean(axis=0))[:, :3]
    m = (rigid * np.asarray(structure.M @ rigid)).sum(axis=0)
    shown = ", ".join(f"{v:.6g}" for v in m)
    if not m.min() > 0.0:
        raise CompileError(f"M: the masses along x, y and z are {shown} kg (limit > 0)")
    if np.ptp(m) > 1e-3 * m.max():
        raise CompileError(
            f"M: the masses along x, y and z are {shown} kg and must be equal; "
            "check the directions of the displacements and scalar masses"
        )


def check_speed(structure: Structure, frequency: float) -> None:
    """Check that the frequency of the lowest mode [Hz] does not imply an impossible wave speed.

    A wave crosses the body twice per period of its lowest longitudinal mode; other modes are slower.

    Raises
    ------
    CompileError
        If the wave speed exceeds `FASTEST`; usually K is in N/m but the positions are in mm.
    """
    size = float(np.linalg.norm(np.ptp(structure.places, axis=0)))
    if 2.0 * size * frequency > FASTEST:
        raise CompileError(
            f"the lowest mode of {frequency:.6g} Hz in a body of {size:.6g} m implies a wave speed of "
            f"{2.0 * size * frequency:.3g} m/s (limit {FASTEST:g} m/s); "
            "give K in N/m, M in kg and positions in m"
        )


@dataclass(frozen=True)
class Member:
    """Beam between two nodes of a frame.

    Parameters
    ----------
    ends
        Numbers of its nodes.
    beam
        Section and material with density; the length is the distance of the nodes.
    axis
        Direction near axis 1 of the section, not along the beam.
    """

    ends: tuple[int, int]
    beam: Beam
    axis: tuple[float, float, float] = (1.0, 0.0, 0.0)


def beam_line(beams: Sequence[Beam]) -> Structure:
    """Structure of beams in series along the third axis, from the origin, with six displacements per node.

    Parameters
    ----------
    beams
        Beam elements in order; a density is required.
    """
    ends = np.concatenate([[0.0], np.cumsum([b.length for b in beams])])
    places = np.zeros((ends.size, 3))
    places[:, 2] = ends
    return beam_frame(places, [Member((k, k + 1), beam) for k, beam in enumerate(beams)])


def beam_frame(places: ArrayLike, members: Sequence[Member]) -> Structure:
    """Structure of rigidly joined beams, with six displacements per node.

    Parameters
    ----------
    places
        Positions of the nodes (number of nodes, 3) [m].
    members
        The beams.

    Examples
    --------
    Two beams of 1 m and 1 kg/m at a right angle:

    >>> from pitchpoint.multibody.beam_section import rectangle
    >>> beam = Beam(section=rectangle(0.02, 0.05), length=1.0, E=2.1e11, G=8e10, rho=1000.0)
    >>> frame = beam_frame(
    ...     [[0, 0, 0], [0, 0, 1], [0, 1, 1]], [Member((0, 1), beam), Member((1, 2), beam)]
    ... )
    >>> round(float(frame.M[0::6][:, 0::6].sum()), 9)
    2.0
    """
    from scipy.sparse import coo_array

    spots = np.asarray(places, float)
    n = 6 * len(spots)
    rows, columns, stiff, heavy = [], [], [], []
    for member in members:
        one, two = member.ends
        chord = spots[two] - spots[one]
        beam = replace(member.beam, length=float(np.linalg.norm(chord)))
        z = chord / beam.length
        x = np.asarray(member.axis, float) - z * (z @ np.asarray(member.axis, float))
        x /= np.linalg.norm(x)
        turn = np.kron(np.eye(4), np.column_stack([x, np.cross(z, x), z]))
        at = np.concatenate([6 * one + np.arange(6), 6 * two + np.arange(6)])
        rows.append(np.repeat(at, 12))
        columns.append(np.tile(at, 12))
        stiff.append((turn @ beam.stiffness() @ turn.T).ravel())
        heavy.append((turn @ beam.consistent_mass() @ turn.T).ravel())
    entries = np.concatenate(rows), np.concatenate(columns)
    K = coo_array((np.concatenate(stiff), entries), (n, n))
    M = coo_array((np.concatenate(heavy), entries), (n, n))
    return make_structure(K, M, spots)


def turned_stiffening(stiffening: ArrayLike, axes: ArrayLike) -> Array:
    """Stress stiffness per load (9, n, n) for loads in rotated axes, columns (3, 3) in the present axes."""
    given, Q = np.asarray(stiffening, float), np.asarray(axes, float)
    square = np.zeros((3, 3, *given.shape[1:]))
    for r, (i, j) in enumerate(((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))):
        square[i, j] += 0.5 * given[3 + r]
        square[j, i] += 0.5 * given[3 + r]
    square = np.einsum("ia,jb,ijkl->abkl", Q, Q, square)
    found = np.zeros_like(given)
    found[:3] = np.einsum("ia,ikl->akl", Q, given[:3])
    for r, (i, j) in enumerate(((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))):
        found[3 + r] = square[i, j] if i == j else square[i, j] + square[j, i]
    return found
