# SPDX-License-Identifier: Apache-2.0
"""Workspace of the unilateral contact solver: state, counters, vectors and factor, all owned by the caller.

The forces and the factor of the last solution remain in it and start the next one.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.active_block import LANES
from pitchpoint.core.kernel import kernel

#: State and counters of a solver, one record.
CONTACT_STATE = np.dtype(
    [
        ("m", "i8"),  # nodes in contact
        ("factored", "i8"),  # 1: U is a factor for these nodes, with the slopes of an earlier iteration
        ("exact", "i8"),  # 1: with the slopes of the solution
        ("rate", "f8"),  # last ratio of successive residuals with this factor, 0: none yet
        ("approach", "f8"),  # rigid-body approach X of the last `solve_load` [m]
        ("newton", "i8"),  # Newton steps since the workspace was made
        ("factorisations", "i8"),
        ("pivoted", "i8"),  # solutions that required pivoting with certain termination
        ("blocks", "i8"),  # exchanges of all infeasible nodes in these
        ("singles", "i8"),  # exchanges of the infeasible node of the lowest index (Murty)
        ("searches", "i8"),  # solutions of `solve_load` that required a search for X
    ],
    align=True,
)

#: Rows of the vectors. By node: force, overlap x - C f, penetration x, gap, weight.
FORCE, OVERLAP, PENETRATION, GAP, WEIGHT = range(5)
#: By position in the list of nodes in contact: local approach, its slope, residual and then Newton step,
#: second right-hand side, step of `pivoting`, reciprocal diagonal of the factor.
APPROACH, SLOPE, STEP, SIDE, BASE, INVERSE = range(5, 11)
N_VECTOR = 11

#: Rows of the indices: nodes in contact in the order of the factor; 1 for each node in the list.
LISTED, MEMBER = range(2)


@dataclass(frozen=True)
class ContactWorkspace:
    """Arrays of a solver for up to n nodes.

    Parameters
    ----------
    state
        Record of `CONTACT_STATE`, shape (1,).
    on
        Indices, shape (2, w); w is n rounded up to a multiple of `LANES`.
    v
        Vectors, shape (N_VECTOR, w).
    U
        Factor, shape (w, w).
    """

    state: NDArray[np.void]
    on: NDArray[np.int64]
    v: NDArray[np.float64]
    U: NDArray[np.float64]

    @classmethod
    def of(cls, n: int) -> ContactWorkspace:
        """New workspace for up to n nodes.

        Examples
        --------
        >>> work = ContactWorkspace.of(11)
        >>> work.on.shape, work.v.shape, work.U.shape
        ((2, 16), (11, 16), (16, 16))
        """
        w = max(-(-n // LANES) * LANES, LANES)
        state = np.zeros(1, CONTACT_STATE)
        return cls(state, np.zeros((2, w), np.int64), np.zeros((N_VECTOR, w)), np.zeros((w, w)))

    def arrays(self) -> tuple[np.void, NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
        """State record, indices, vectors and factor, the last arguments of the kernels; shapes as above."""
        return self.state[0], self.on, self.v, self.U


@kernel
def forget(n, state, v):
    """Delete the forces of the last solution, after a failure or for other nodes.

    Parameters
    ----------
    n
        Number of nodes.
    state, v
        State and vectors of the workspace.

    Examples
    --------
    >>> work = ContactWorkspace.of(2)
    >>> work.v[FORCE] = 3.0
    >>> forget(2, work.state[0], work.v)
    >>> work.v[FORCE, :3].tolist()
    [0.0, 0.0, 3.0]
    """
    state["m"] = 0
    state["factored"] = 0
    state["exact"] = 0
    for i in range(n):
        v[FORCE, i] = 0.0
