# SPDX-License-Identifier: Apache-2.0
"""Free directions of constraint rows: basis of vibrations and of model damping."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.solvers.constraints.assembly import REDUNDANT
from pitchpoint.solvers.equilibrium.unknowns import LARGE
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]


def free_directions(system: System, state: State, states: Sequence[int] = ()) -> Any:
    """Basis of the null space of the constraint rows, without the states of elements, shape (nd, n).

    Sparse for large systems.
    """
    nd = system.sizes["nd"]
    mechanical = np.setdiff1d(np.arange(nd), np.array(states, np.int64))
    if system.sizes["nc"] == 0:
        return _unit_columns(nd, mechanical)
    G = evaluate.constraint_jacobian(system, state)[:, mechanical]
    fixed = np.flatnonzero(np.abs(G).sum(axis=0) > 0.0)
    if np.count_nonzero(G) == fixed.size == np.linalg.matrix_rank(G):
        return _unit_columns(nd, np.delete(mechanical, fixed))  # each row fixes one coordinate
    weight = system.weight[mechanical]
    if nd >= LARGE:
        return _sparse_null_space(G / weight, mechanical, weight, nd)
    _, values, rows = np.linalg.svd(G / weight)
    rank = int(np.sum(values > REDUNDANT * values[0]))
    whole = np.zeros((nd, mechanical.size - rank))
    whole[mechanical] = (rows[rank:] / weight).T
    return whole


def _unit_columns(nd: int, places: NDArray[np.int64]) -> Any:
    """Unit vectors of some coordinates, as columns."""
    if nd < LARGE:
        return np.eye(nd)[:, places]
    from scipy.sparse import csc_array

    n = len(places)
    return csc_array((np.ones(n), places, np.arange(n + 1)), shape=(nd, n))


def _sparse_null_space(G: Array, places: NDArray[np.int64], weight: Array, nd: int) -> Any:
    """Sparse null space of the rows: dependent coordinates as functions of the independent ones.

    The dependent coordinates are chosen by a pivoted QR factorisation of the non-zero columns; columns
    without entries are independent, so the basis is sparse if the loops are local.
    """
    from scipy.linalg import qr, solve_triangular
    from scipy.sparse import csc_array

    used = np.flatnonzero(np.abs(G).sum(axis=0) > 0.0)
    _, R, order = qr(G[:, used], mode="economic", pivoting=True)
    sizes = np.abs(np.diag(R))
    rank = int(np.sum(sizes > REDUNDANT * sizes.max(initial=0.0)))
    follows, leads = used[order[:rank]], used[order[rank:]]
    ratio = -solve_triangular(R[:rank, :rank], R[:rank, rank:])
    ratio[np.abs(ratio) < 1e-14] = 0.0
    free = np.setdiff1d(np.arange(G.shape[1]), follows)
    column = np.searchsorted(free, leads)
    one, two = np.nonzero(ratio)
    rows = np.concatenate([free, follows[one]])
    columns = np.concatenate([np.arange(free.size), column[two]])
    values = np.concatenate([np.ones(free.size), ratio[one, two]]) / weight[rows]
    return csc_array((values, (places[rows], columns)), shape=(nd, free.size))
