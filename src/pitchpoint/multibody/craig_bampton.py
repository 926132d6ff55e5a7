# SPDX-License-Identifier: Apache-2.0
"""Few modes for many displacements: Craig-Bampton reduction of an unsupported elastic body.

Interface displacements b keep their meaning; the rest i follows them statically and swings in the modes of
the body with its interface held:

    u = Psi q,   Psi = [I 0; -K_ii^-1 K_ib  Phi],   K_ii Phi = M_ii Phi Omega^2.

The reduced pencil is then brought to its own modes. Six of them are the rigid motions, which a floating frame
takes over; the others are orthonormal to them and to each other by the mass: modal mass 1, stiffness omega^2.

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

DENSE = 600  # up to so many displacements dense algebra is faster and finds all modes
TWO_PI = 2.0 * math.pi


@dataclass(frozen=True)
class Modes:
    """Free-free elastic modes of a body, ascending.

    Parameters
    ----------
    frequency
        Natural frequencies [Hz], shape (n,).
    shape
        Displacements of the structure per modal coordinate, shape (size, n), modal mass 1 kg m^2 or 1 kg.
    rigid_residual
        Largest frequency that was found for a rigid motion [Hz]: a measure of round-off.
    """

    frequency: Array
    shape: Array
    rigid_residual: float

    def at_node(self, structure: Structure, node: int) -> Array:
        """Shapes of one node (6, n); rotations of nodes that have none are left zero."""
        found = np.zeros((6, self.frequency.size))
        rows = structure.displacements(node)
        found[structure.direction[rows]] = self.shape[rows]
        return found

    def select(self, below: float | None = None, count: int | None = None) -> Modes:
        """Keep the lowest modes.

        Parameters
        ----------
        below
            Highest frequency [Hz].
        count
            Largest number of modes.
        """
        keep = np.ones(self.frequency.size, bool) if below is None else self.frequency <= below
        keep[self.frequency.size if count is None else count :] = False
        return Modes(self.frequency[keep], self.shape[:, keep], self.rigid_residual)


def craig_bampton(
    structure: Structure, interface: Sequence[int], count: int = 0, *, below: float | None = None
) -> Modes:
    """Reduce a structure to its interface nodes and some modes with the interface held.

    Parameters
    ----------
    structure
        Matrices of the unsupported body.
    interface
        Nodes where joints and forces act.
    count
        Number of modes with the interface held.
    below
        Instead of a number: all such modes up to this frequency [Hz]. Six times the highest frequency of
        interest keeps the error below 0.1 % (tests/unit/multibody/test_craig_bampton.py).

    Returns
    -------
    Modes
        All elastic modes of the reduced body: 6 fewer than interface displacements and held modes together.

    Raises
    ------
    CompileError
        If a node does not exist, a part is loose, or the body has not six rigid motions.

    Notes
    -----
    The highest of these modes carry the static shapes of the interface; keep them for local deflections or
    drop them by `Modes.select`.
    """
    from scipy.linalg import eigh
    from scipy.sparse.linalg import splu

    nodes = sorted(set(interface))
    if not nodes or nodes[0] < 0 or nodes[-1] >= len(structure.places):
        raise CompileError(f"interface: nodes are 0 to {len(structure.places) - 1}, at least one is needed")
    kept = np.isin(structure.node, nodes)
    b, i = np.flatnonzero(kept), np.flatnonzero(~kept)
    if np.linalg.matrix_rank(structure.rigid(structure.places.mean(axis=0))[b], tol=1e-9) < 6:
        raise CompileError(
            "interface: its displacements do not hold the body; name a node with rotations or three nodes"
        )
    K_ii, M_ii = structure.K[i][:, i].tocsc(), structure.M[i][:, i].tocsc()
    K_ib = structure.K[i][:, b].toarray()
    if below is None:
        swinging = _held_modes(K_ii, M_ii, min(count, i.size))[0]
    else:
        swinging = _held_below(K_ii, M_ii, below)
    basis = np.zeros((structure.size, b.size + swinging.shape[1]))
    basis[b, : b.size] = np.eye(b.size)
    basis[i, b.size :] = swinging
    if i.size:
        try:
            basis[i, : b.size] = -splu(K_ii).solve(K_ib)
        except RuntimeError as error:
            raise CompileError(f"a part of the body hangs on no interface node ({error})") from None
    if not np.all(np.isfinite(basis)):
        raise CompileError("a part of the body hangs on no interface node")
    K, M = basis.T @ (structure.K @ basis), basis.T @ (structure.M @ basis)
    if np.linalg.eigvalsh(M)[0] <= 0.0:
        raise CompileError("M: some motion of the interface has no mass; give its nodes mass and inertia")
    values, vectors = eigh(0.5 * (K + K.T), 0.5 * (M + M.T))
    return _elastic(values, basis @ vectors)


def _held_below(K: Any, M: Any, limit: float) -> Array:
    """All modes with the interface held up to a frequency [Hz]; more are requested until one lies above."""
    count = 16
    while True:
        shapes, frequency = _held_modes(K, M, min(count, K.shape[0]))
        if frequency.size < count or frequency[-1] > limit:
            return shapes[:, frequency <= limit]
        count *= 2


def _held_modes(K: Any, M: Any, count: int) -> tuple[Array, Array]:
    """Lowest modes of the body with its interface held: shapes (n, count) of mass 1, frequencies [Hz]."""
    from scipy.linalg import eigh
    from scipy.sparse.linalg import eigsh

    if count <= 0:
        return np.zeros((K.shape[0], 0)), np.zeros(0)
    if K.shape[0] <= DENSE or count >= K.shape[0] - 1:
        # 1/omega^2, the largest first: M may have displacements without mass
        try:
            values, vectors = eigh(M.toarray(), K.toarray())
        except np.linalg.LinAlgError:
            raise CompileError("a part of the body hangs on no interface node") from None
        vectors, values = vectors[:, ::-1][:, :count], values[::-1][:count]
        real = values > 1e-14 * max(float(values[0]), 0.0)
        root = np.sqrt(values[real])
        return np.asarray(vectors[:, real] / root), np.asarray(1.0 / (TWO_PI * root))
    values, vectors = eigsh(K, count, M, sigma=0.0, which="LM", v0=np.ones(K.shape[0]))
    order = np.argsort(values)
    return np.asarray(vectors[:, order]), np.sqrt(np.abs(values[order])) / TWO_PI


def _elastic(values: Array, vectors: Array) -> Modes:
    """Take the six rigid motions away."""
    root = np.sqrt(np.abs(values)) / TWO_PI
    if root.size < 6 or (root.size > 6 and root[:6].max() > 1e-2 * root[6]):
        lowest = ", ".join(f"{f:.4g}" for f in root[:8])
        raise CompileError(
            f"the body has not six rigid motions: its lowest frequencies are {lowest} Hz; "
            "take away supports and check the places of the nodes"
        )
    if root.size > 6 and root[6] < 1e3 * max(float(root[:6].max()), 1e-12) and root[6] < 1e-3:
        raise CompileError("the body has more than six motions without stiffness: a part of it is loose")
    return Modes(root[6:], np.asarray(vectors[:, 6:]), float(root[:6].max(initial=0.0)))


def modal_damping(modes: Modes, ratio: float | Sequence[float]) -> Array:
    """Damping of every modal coordinate, 2 zeta omega [1/s] per modal mass, shape (n,).

    Parameters
    ----------
    modes
        The modes.
    ratio
        One damping ratio for all, or one of each [-].
    """
    share = np.broadcast_to(np.asarray(ratio, float), modes.frequency.shape)
    if np.any(share < 0.0) or not np.all(np.isfinite(share)):
        raise CompileError("damping ratios must be finite and not negative")
    return np.asarray(2.0 * share * TWO_PI * modes.frequency)
