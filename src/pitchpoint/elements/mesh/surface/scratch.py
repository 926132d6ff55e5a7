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
def _flank_size(n, pairs, planes):
    """Size of the arrays of `flexible_arrays` and `slope_arrays` [8 bytes]."""
    return n * (N_NODE + 3 * n + 2 + 4 * HEIGHTS) + pairs * planes


def scratch_size(n: int, pairs: int, planes: int) -> int:
    """Size of the scratch for up to n nodes of up to `pairs` tooth pairs [8 bytes].

    >>> scratch_size(8, 2, 4) > 8 * 8
    True
    """
    w = widened(n)
    flank = int(plain(_flank_size)(n, pairs, planes))
    return flank + STATE_BYTES // 8 + (2 + N_VECTOR + w) * w


@kernel
def _solver_start(b):
    """Offset of the workspace of the solver in the pool."""
    return b["work"] + _flank_size(b["max_nodes"], b["n_slot_pairs"], b["slices"])


def state_offset(record: Any) -> int:
    """Offset of the state of the solver in the pool."""
    size = (int(record[name]) for name in ("max_nodes", "n_slot_pairs", "slices"))
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
def slope_arrays(b, n):
    """Polynomials of the heights of n nodes and their slopes; derivatives of the compliances by the rolls.

    Shapes (n, 2, 2, 4) over node, gear, value and slope, polynomial; (n, 2, n).
    """
    size = b["max_nodes"]
    at = b["work"] + size * (N_NODE + size + 2) + b["n_slot_pairs"] * b["slices"]
    legs = view(pooled(b, at), (n, 2, 2, HEIGHTS), F8)
    return legs, view(pooled(b, at + size * 4 * HEIGHTS), (n, 2, n), F8)


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
