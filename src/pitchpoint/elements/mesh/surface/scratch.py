# SPDX-License-Identifier: Apache-2.0
"""Scratch of flexible contact in the pool of the kind: vectors, matrices and the workspace of the solver."""

from __future__ import annotations

from typing import Any

from pitchpoint.contact.active_block import LANES
from pitchpoint.contact.local_approach import N_NODE
from pitchpoint.contact.unilateral_work import CONTACT_STATE, N_VECTOR
from pitchpoint.core.kernel import kernel, plain, view
from pitchpoint.elements.mesh.line_of_action import pooled
from pitchpoint.elements.mesh.surface.compliance import HEIGHTS
from pitchpoint.multibody.channels import F8, I8

STATE_BYTES = CONTACT_STATE.itemsize


def widened(n: int) -> int:
    """Number rounded up to whole lanes of vector instructions."""
    return -(-n // LANES) * LANES


@kernel
def _flank_size(n, pairs, planes, columns):
    """Size of the arrays of `flexible_arrays` and `plane_arrays` [8 bytes]."""
    by_node = n * (N_NODE + n + 2)
    return by_node + pairs * planes + columns * (1 + pairs * (4 * HEIGHTS + 1))


def scratch_size(n: int, pairs: int, planes: int) -> int:
    """Size of the scratch for up to n nodes of up to `pairs` tooth pairs [8 bytes].

    >>> scratch_size(8, 2, 4) > 8 * 8
    True
    """
    w = widened(n)
    flank = int(plain(_flank_size)(n, pairs, planes, widened(planes)))
    return flank + STATE_BYTES // 8 + (2 + N_VECTOR + w) * w


@kernel
def _solver_start(b):
    """Offset of the workspace of the solver in the pool."""
    return b["work"] + _flank_size(b["max_nodes"], b["n_slot_pairs"], b["slices"], b["columns"])


def state_offset(record: Any) -> int:
    """Offset of the state of the solver in the pool."""
    size = (int(record[name]) for name in ("max_nodes", "n_slot_pairs", "slices", "columns"))
    return int(record["work"]) + int(plain(_flank_size)(*size))


@kernel
def flexible_arrays(b, n):
    """Penetrations, local approaches and compliances of n nodes; slots and forces of the last solution.

    Shapes (n,), (n, N_NODE), (n, n), (max_nodes,) and (pairs x planes,).
    """
    size = b["max_nodes"]
    at = b["work"]
    x = view(pooled(b, at), n, F8)
    at += size
    local = view(pooled(b, at), (n, N_NODE), F8)
    at += size * N_NODE
    C = view(pooled(b, at), (n, n), F8)
    at += size * size
    slots = view(pooled(b, at), size, I8)
    return x, local, C, slots, view(pooled(b, at + size), b["n_slot_pairs"] * b["slices"], F8)


@kernel
def plane_arrays(b):
    """Polynomials of the heights at all planes, the same times the forces, numbers of nodes, a row of planes.

    Shapes (pairs, 2, 4, columns) twice, over pair, gear, polynomial, plane; (pairs, columns); (columns,).
    """
    size = b["max_nodes"]
    pairs = b["n_slot_pairs"]
    columns = b["columns"]
    at = b["work"] + size * (N_NODE + size + 2) + pairs * b["slices"]
    legs = view(pooled(b, at), (pairs, 2, HEIGHTS, columns), F8)
    at += pairs * 2 * HEIGHTS * columns
    loads = view(pooled(b, at), (pairs, 2, HEIGHTS, columns), F8)
    at += pairs * 2 * HEIGHTS * columns
    index = view(pooled(b, at), (pairs, columns), I8)
    return legs, loads, index, view(pooled(b, at + pairs * columns), columns, F8)


@kernel
def solver_arrays(b):
    """Workspace of the solver: state, indices, vectors and factor (`contact.unilateral_work`)."""
    n = b["max_nodes"]
    w = (n + LANES - 1) // LANES * LANES
    at = _solver_start(b)
    state = view(pooled(b, at), 1, CONTACT_STATE)
    at += STATE_BYTES // 8
    on = view(pooled(b, at), (2, w), I8)
    at += 2 * w
    v = view(pooled(b, at), (N_VECTOR, w), F8)
    return state, on, v, view(pooled(b, at + N_VECTOR * w), (w, w), F8)
