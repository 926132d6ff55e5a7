# SPDX-License-Identifier: Apache-2.0
"""Craig-Bampton reduction of an unsupported elastic body.

The interface displacements b are retained; the interior displacements i are the sum of constraint modes and
fixed-interface normal modes:

    u = Psi q,   Psi = [I 0; -K_ii^-1 K_ib  Phi],   K_ii Phi = M_ii Phi Omega^2.

The reduced system is then transformed to its own modes. Six of them are the rigid-body modes, which the
floating frame represents; the others are mass-orthonormal: modal mass 1, modal stiffness omega^2.

Sources: Craig, Bampton, AIAA J. 6 (1968) 1313-1319; Friberg, Int. J. Numer. Meth. Engng 32 (1991) 1637-1658
for the orthogonal form.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.multibody.structure import Structure

Array = NDArray[np.float64]

DENSE = 600  # up to this number of displacements dense algebra is faster and finds all modes
TWO_PI = 2.0 * math.pi


@dataclass(frozen=True)
class Modes:
    """Free-free elastic modes of a body, in ascending order.

    Parameters
    ----------
    frequency
        Natural frequencies [Hz], shape (n,).
    shape
        Displacements of the structure per modal coordinate, shape (size, n), modal mass 1 kg m^2 or 1 kg.
    rigid_residual
        Largest frequency of a rigid-body mode [Hz], a measure of round-off.
    """

    frequency: Array
    shape: Array
    rigid_residual: float

    def at_node(self, structure: Structure, node: int) -> Array:
        """Mode shapes at one node (6, n); zero for directions the node does not have."""
        found = np.zeros((6, self.frequency.size))
        rows = structure.displacements(node)
        found[structure.direction[rows]] = self.shape[rows]
        return found

    def select(self, below: float | None = None, count: int | None = None) -> Modes:
        """Select the lowest modes.

        Parameters
        ----------
        below
            Maximum frequency [Hz].
        count
            Maximum number of modes.
        """
        keep = np.ones(self.frequency.size, bool) if below is None else self.frequency <= below
        keep[self.frequency.size if count is None else count :] = False
        return Modes(self.frequency[keep], self.shape[:, keep], self.rigid_residual)


def craig_bampton(
    structure: Structure, interface: Sequence[int], count: int = 0, *, below: float | None = None
) -> Modes:
    """Reduce a structure to its interface nodes and fixed-interface modes.

    Parameters
    ----------
    structure
        Matrices of the unsupported body.
    interface
        Nodes at which joints and forces act.
    count
        Number of fixed-interface modes.
    below
        Instead of a number: all fixed-interface modes up to this frequency [Hz]. Six times the highest
        frequency of interest keeps the error below 0.1 % (tests/unit/multibody/test_craig_bampton.py).

    Returns
    -------
    Modes
        All elastic modes of the reduced body: number of interface displacements plus fixed-interface modes
        minus 6.

    Raises
    ------
    CompileError
        If a node does not exist, a part of the body is not connected, or the body does not have six
        rigid-body modes.

    Notes
    -----
    The highest of these modes represent the static deformation at the interface; retain them for local
    deflections or remove them with `Modes.select`.
    """
    from scipy.linalg import eigh
    from scipy.sparse.linalg import splu

    nodes = sorted(set(interface))
    if not nodes or nodes[0] < 0 or nodes[-1] >= len(structure.places):
        raise CompileError(f"interface: give at least one node from 0 to {len(structure.places) - 1}")
    kept = np.isin(structure.node, nodes)
    b, i = np.flatnonzero(kept), np.flatnonzero(~kept)
    if np.linalg.matrix_rank(structure.rigid(structure.places.mean(axis=0))[b], tol=1e-9) < 6:
        raise CompileError(
            "interface: its displacements do not constrain all rigid-body motions; add a node with rotations "
            "or use three nodes"
        )
    K_ii, M_ii = structure.K[i][:, i].tocsc(), structure.M[i][:, i].tocsc()
    K_ib = structure.K[i][:, b].toarray()
    if below is None:
        swinging = _fixed_interface_modes(K_ii, M_ii, min(count, i.size))[0]
    else:
        swinging = _fixed_interface_modes_below(K_ii, M_ii, below)
    basis = np.zeros((structure.size, b.size + swinging.shape[1]))
    basis[b, : b.size] = np.eye(b.size)
    basis[i, b.size :] = swinging
    if i.size:
        try:
            basis[i, : b.size] = -splu(K_ii).solve(K_ib)
        except RuntimeError as error:
            raise CompileError(f"a part of the body is connected to no interface node ({error})") from None
    if not np.all(np.isfinite(basis)):
        raise CompileError("a part of the body is connected to no interface node")
    K, M = basis.T @ (structure.K @ basis), basis.T @ (structure.M @ basis)
    if np.linalg.eigvalsh(M)[0] <= 0.0:
        raise CompileError("M: an interface motion has no mass; give the interface nodes mass and inertia")
    values, vectors = eigh(0.5 * (K + K.T), 0.5 * (M + M.T))
    return _elastic(values, basis @ vectors)


def fixed_modes(structure: Structure, held: Sequence[int], count: int) -> Modes:
    """Lowest modes of a structure with some nodes fixed.

    Parameters
    ----------
    structure
        Matrices of the unsupported body.
    held
        Nodes without displacements.
    count
        Number of modes.

    Raises
    ------
    CompileError
        If a node does not exist, or the held nodes do not fix the body.
    """
    nodes = sorted(set(held))
    if not nodes or nodes[0] < 0 or nodes[-1] >= len(structure.places):
        raise CompileError(f"held: give at least one node from 0 to {len(structure.places) - 1}")
    fixed = np.isin(structure.node, nodes)
    if np.linalg.matrix_rank(structure.rigid(structure.places.mean(axis=0))[fixed], tol=1e-9) < 6:
        raise CompileError(
            "held: the nodes do not fix all rigid-body motions; add a node with rotations or use three nodes"
        )
    free = np.flatnonzero(~fixed)
    K, M = structure.K[free][:, free].tocsc(), structure.M[free][:, free].tocsc()
    shapes, frequency = _fixed_interface_modes(K, M, min(count, free.size))
    whole = np.zeros((structure.size, frequency.size))
    whole[free] = shapes
    return Modes(frequency, whole, 0.0)


def _fixed_interface_modes_below(K: Any, M: Any, limit: float) -> Array:
    """All fixed-interface modes up to a frequency [Hz]; the number is doubled until one is above it."""
    count = 16
    while True:
        shapes, frequency = _fixed_interface_modes(K, M, min(count, K.shape[0]))
        if frequency.size < count or frequency[-1] > limit:
            return shapes[:, frequency <= limit]
        count *= 2


def _fixed_interface_modes(K: Any, M: Any, count: int) -> tuple[Array, Array]:
    """Lowest fixed-interface modes: shapes (n, count) with modal mass 1, frequencies [Hz]."""
    from scipy.linalg import eigh
    from scipy.sparse.linalg import eigsh

    if count <= 0:
        return np.zeros((K.shape[0], 0)), np.zeros(0)
    if K.shape[0] <= DENSE or count >= K.shape[0] - 1:
        # solve for 1/omega^2, since M may be singular
        try:
            values, vectors = eigh(M.toarray(), K.toarray())
        except np.linalg.LinAlgError:
            raise CompileError("a part of the body is connected to no interface node") from None
        vectors, values = vectors[:, ::-1][:, :count], values[::-1][:count]
        real = values > 1e-14 * max(float(values[0]), 0.0)
        root = np.sqrt(values[real])
        return np.asarray(vectors[:, real] / root), np.asarray(1.0 / (TWO_PI * root))
    values, vectors = eigsh(K, count, M, sigma=0.0, which="LM", v0=np.ones(K.shape[0]))
    order = np.argsort(values)
    return np.asarray(vectors[:, order]), np.sqrt(np.abs(values[order])) / TWO_PI


def _elastic(values: Array, vectors: Array) -> Modes:
    """Remove the six rigid-body modes."""
    root = np.sqrt(np.abs(values)) / TWO_PI
    if root.size < 6 or (root.size > 6 and root[:6].max() > 1e-2 * root[6]):
        lowest = ", ".join(f"{f:.4g}" for f in root[:8])
        raise CompileError(
            f"the body does not have six rigid-body modes: its lowest frequencies are {lowest} Hz; "
            "remove supports and check the positions of the nodes"
        )
    if root.size > 6 and root[6] < 1e3 * max(float(root[:6].max()), 1e-12) and root[6] < 1e-3:
        raise CompileError("the body has more than six modes without stiffness: a part is not connected")
    return Modes(root[6:], np.asarray(vectors[:, 6:]), float(root[:6].max(initial=0.0)))


def modal_damping(modes: Modes, ratio: float | Sequence[float]) -> Array:
    """Damping of each modal coordinate, 2 zeta omega [1/s] per modal mass, shape (n,).

    Parameters
    ----------
    modes
        Elastic modes.
    ratio
        Damping ratio, one for all modes or one per mode [-].

    Raises
    ------
    CompileError
        If a damping ratio is negative or not finite.
    """
    share = np.broadcast_to(np.asarray(ratio, float), modes.frequency.shape)
    if np.any(share < 0.0) or not np.all(np.isfinite(share)):
        raise CompileError("damping ratios must be finite and not negative")
    return np.asarray(2.0 * share * TWO_PI * modes.frequency)
