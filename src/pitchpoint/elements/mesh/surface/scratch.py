# SPDX-License-Identifier: Apache-2.0
"""Scratch of flexible contact in the pool of the kind: vectors, matrices and the workspace of the solver."""

from __future__ import annotations

from typing import Any

from pitchpoint.contact.active_block import LANES
from pitchpoint.contact.local_approach import N_NODE
from pitchpoint.contact.unilateral_work import CONTACT_STATE, N_VECTOR
from pitchpoint.core.kernel import kernel, plain, view
from pitchpoint.elements.mesh.line_of_action import pooled
from pitchpoint.elements.mesh.surface.compliance import LEGS
from pitchpoint.multibody.channels import F8, I8

STATE_BYTES = CONTACT_STATE.itemsize


def widened(n: int) -> int:
    """Number of nodes rounded up to whole lanes of the solver."""
    return -(-n // LANES) * LANES


def scratch_size(n: int, slots: int) -> int:
    """Size of the scratch for up to n nodes [8 bytes]; `slots`: number of pairs times planes.

    >>> scratch_size(8, 8) > 8 * 8
    True
    """
    w = widened(n)
    vectors = n * (1 + LEGS + N_NODE + n + 1) + slots + LEGS
    return vectors + STATE_BYTES // 8 + (2 + N_VECTOR + w) * w


@kernel
def _solver_start(b):
    """Offset of the workspace of the solver in the pool."""
    n = b["max_nodes"]
    return b["work"] + n * (1 + LEGS + N_NODE + n + 1) + b["n_slot_pairs"] * b["slices"] + LEGS


def state_offset(record: Any) -> int:
    """Offset of the state of the solver in the pool."""
    return int(plain(_solver_start)(record))


@kernel
def flexible_arrays(b, n):
    """Penetrations, polynomials of the heights, local approaches and compliances of n nodes; kept forces.

    Shapes (n,), (n, 8), (n, N_NODE) and (n, n); slots of the nodes of the last solution (max_nodes,), forces
    by slot (pairs x planes,), and a scratch of 8 values.
    """
    size = b["max_nodes"]
    at = b["work"]
    x = view(pooled(b, at), n, F8)
    at += size
    legs = view(pooled(b, at), (n, LEGS), F8)
    at += size * LEGS
    local = view(pooled(b, at), (n, N_NODE), F8)
    at += size * N_NODE
    C = view(pooled(b, at), (n, n), F8)
    at += size * size
    slots = view(pooled(b, at), size, I8)
    at += size
    n_slots = b["n_slot_pairs"] * b["slices"]
    kept = view(pooled(b, at), n_slots, F8)
    return x, legs, local, C, slots, kept, view(pooled(b, at + n_slots), LEGS, F8)


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
