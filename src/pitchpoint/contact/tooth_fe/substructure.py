# SPDX-License-Identifier: Apache-2.0
"""Substructures: stiffness and loads of parts of a solid, condensed to the nodes at their borders.

Parts are joined in pairs and nodes inside are eliminated by Cholesky factorisation (nested dissection: A.
George, SIAM J. Numer. Anal. 10 (1973) 345).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]


@dataclass(frozen=True)
class Mesh:
    """Nodes of elements, shape (m, k), and integer positions of the elements in a grid, shape (m, 2)."""

    nodes: IntArray
    positions: IntArray


@dataclass(frozen=True)
class Part:
    """A condensed part of a solid.

    Parameters
    ----------
    nodes
        Remaining nodes, shape (n,), ascending.
    K
        Stiffness, shape (n d, n d); d values per node.
    columns
        Numbers of the load cases that act on the part, shape (q,), ascending.
    R
        Loads transferred to the nodes, shape (n d, q).
    compliance
        Displacement of load case i by load case j with fixed nodes, shape (q, q).
    """

    nodes: IntArray
    K: FloatArray
    columns: IntArray
    R: FloatArray
    compliance: FloatArray

    @property
    def values(self) -> int:
        """Values per node d."""
        return self.K.shape[0] // max(1, self.nodes.size)


def joined(a: Part, b: Part) -> Part:
    """Both parts connected at their common nodes; load cases with equal numbers act on both.

    Parameters
    ----------
    a, b
        Parts with equal numbers of values per node.

    Examples
    --------
    One value per node, springs in a row:

    >>> none = np.empty(0, np.int64)
    >>> spring = np.array([[1.0, -1.0], [-1.0, 1.0]])
    >>> a, b = (Part(np.array(n), spring, none, np.zeros((2, 0)), np.zeros((0, 0))) for n in ([0, 1], [1, 2]))
    >>> joined(a, b).K.tolist()
    [[1.0, -1.0, 0.0], [-1.0, 2.0, -1.0], [0.0, -1.0, 1.0]]
    """
    nodes, columns = np.union1d(a.nodes, b.nodes), np.union1d(a.columns, b.columns)
    d = a.values or b.values
    K = np.zeros((nodes.size * d, nodes.size * d))
    R = np.zeros((nodes.size * d, columns.size))
    compliance = np.zeros((columns.size, columns.size))
    for part in (a, b):
        rows = _rows(np.searchsorted(nodes, part.nodes), d)
        cases = np.searchsorted(columns, part.columns)
        K[np.ix_(rows, rows)] += part.K
        R[np.ix_(rows, cases)] += part.R
        compliance[np.ix_(cases, cases)] += part.compliance
    return Part(nodes, K, columns, R, compliance)


def eliminated(part: Part, inner: IntArray) -> Part:
    """Part without some of its nodes, on which only the loads of the part act.

    Parameters
    ----------
    part
        The part.
    inner
        Nodes to eliminate, shape (m,).

    Examples
    --------
    One value per node, springs in a row:

    >>> none = np.empty(0, np.int64)
    >>> spring = np.array([[1.0, -1.0], [-1.0, 1.0]])
    >>> a, b = (Part(np.array(n), spring, none, np.zeros((2, 0)), np.zeros((0, 0))) for n in ([0, 1], [1, 2]))
    >>> eliminated(joined(a, b), np.array([1])).K.round(12).tolist()
    [[0.5, -0.5], [-0.5, 0.5]]
    """
    if inner.size == 0:
        return part
    from scipy.linalg import solve_triangular

    d = part.values
    gone = np.isin(part.nodes, inner)
    e, k = _rows(np.flatnonzero(gone), d), _rows(np.flatnonzero(~gone), d)
    factor = np.linalg.cholesky(part.K[np.ix_(e, e)])
    right = np.concatenate([part.K[np.ix_(e, k)], part.R[e]], axis=1)
    solved = solve_triangular(factor, right, lower=True, overwrite_b=True, check_finite=False)
    to_kept, loads = solved[:, : k.size], solved[:, k.size :]
    return Part(
        part.nodes[~gone],
        part.K[np.ix_(k, k)] - to_kept.T @ to_kept,
        part.columns,
        part.R[k] - to_kept.T @ loads,
        part.compliance + loads.T @ loads,
    )


def _rows(nodes: IntArray, d: int) -> IntArray:
    return (nodes[:, None] * d + np.arange(d)).ravel()


def condensed(leaf: Callable[[int], Part], elements: Mesh, kept: IntArray) -> Part:
    """Whole of all elements with only the kept nodes.

    Parameters
    ----------
    leaf
        Part of element k.
    elements
        Nodes of the elements, and their positions in a grid by which they are grouped.
    kept
        Nodes that are not eliminated, shape (n,).

    Examples
    --------
    Four springs in a row, one value per node:

    >>> nodes = np.array([[0, 1], [1, 2], [2, 3], [3, 4]])
    >>> spring, none = np.array([[1.0, -1.0], [-1.0, 1.0]]), np.empty(0, np.int64)
    >>> mesh = Mesh(nodes, np.array([[k, 0] for k in range(4)]))
    >>> whole = condensed(lambda k: Part(nodes[k], spring, none, np.zeros((2, 0)), np.zeros((0, 0))), mesh,
    ...     np.array([0, 4]))
    >>> whole.K.round(12).tolist()
    [[0.25, -0.25], [-0.25, 0.25]]
    """
    uses = np.bincount(elements.nodes.ravel())
    stays = np.zeros(uses.size, bool)
    stays[kept] = True

    def grouped(group: IntArray) -> Part:
        """Some of the elements as one part; their numbers, shape (n,)."""
        if group.size == 1:
            part = leaf(int(group[0]))
        else:
            extent = np.ptp(elements.positions[group], axis=0)
            order = group[np.argsort(elements.positions[group, int(np.argmax(extent))], kind="stable")]
            half = order.size // 2
            part = joined(grouped(order[:half]), grouped(order[half:]))
        here = np.bincount(elements.nodes[group].ravel(), minlength=uses.size)
        done = (here == uses) & ~stays
        return eliminated(part, part.nodes[done[part.nodes]])

    return grouped(np.arange(len(elements.nodes)))
