# SPDX-License-Identifier: Apache-2.0
"""Newton's method for unilateral contact with a changing set of nodes, started from the last solution.

One step: overlaps of all nodes; nodes that overlap join the set; residuals and slopes within it; a linear
solution with the factor at hand, or a new one; nodes that would pull leave the set. With a prescribed total
force the rigid-body approach is one more unknown, eliminated by a second right-hand side.

A factor serves over calls, as long as each step with it reduces residuals to less than 1/300: one more
factorisation costs about as much as two steps. Without exchanges and with a fresh
factor this is Newton's method; with exchanges it is block pivoting with inexact solutions (the primal-dual
active set method of Hintermueller, Ito and Kunisch, SIAM J. Optim. 13 (2002) 865-888), which may cycle.
"""

from __future__ import annotations

import math

from pitchpoint.contact.active_block import solve_block
from pitchpoint.contact.active_nodes import TOLERANCE, factorise, residual
from pitchpoint.contact.local_approach import local_force
from pitchpoint.contact.unilateral_work import (
    APPROACH,
    FORCE,
    GAP,
    INVERSE,
    LISTED,
    OVERLAP,
    PENETRATION,
    SIDE,
    SLOPE,
    STEP,
    WEIGHT,
)
from pitchpoint.core.kernel import kernel
from pitchpoint.core.status import NOT_FINITE, OK, SLOW

_STEPS = 30
"""Maximum number of steps; two to five are needed, about ten from scratch."""
_STALE = 3e-3
"""Ratio of successive residuals above which the factor is renewed."""
_TRUST = 1e-3
"""Smallest ratio of residuals that is expected of the last step."""
_SHORT = 0.3
"""A force that would fall below this fraction is scaled with its overlap instead."""


@kernel
def _join(C, node, n, limit, state, on, v):
    """Add all nodes outside the set that overlap; returns their number.

    A new node gets the force that closes its overlap alone, and the overlaps of the others change with it.
    """
    m = state["m"]
    f = v[FORCE]
    o = v[OVERLAP, :n]
    for i in range(n):
        if not o[i] <= limit and f[i] == 0.0:  # overlap, or not a number
            force = local_force(node, i, o[i], C[i, i])
            row = C[i]
            f[i] = force
            for j in range(n):
                o[j] -= force * row[j]
            on[LISTED, m] = i
            m += 1
    joined = m - state["m"]
    state["m"] = m
    return joined


@kernel
def _apply(state, on, v):
    """Add the step to the forces and remove the nodes that would pull; returns whether a force was scaled.

    Approaches are concave, so that a linear step to small forces falls too far. The overlap that the step
    predicts is more reliable: the node leaves if it is negative, otherwise its force is scaled with it.
    """
    f = v[FORCE]
    listed = on[LISTED]
    m = 0
    scaled = False
    for k in range(state["m"]):
        i = listed[k]
        old = f[i]
        new = old + v[STEP, k]
        if new < _SHORT * old:
            scaled = True
            h = v[APPROACH, k]
            if h > 0.0:
                new = old * (1.0 + v[SLOPE, k] * v[STEP, k] / h)
            if not new > 0.0:
                f[i] = 0.0
                state["factored"] = 0
                continue
        f[i] = new
        listed[m] = i
        m += 1
    state["m"] = m
    return scaled


@kernel
def _border(load, state, on, v, U):
    """Complete the step in row STEP by the rigid-body approach so that the weighted forces sum to the load.

    Returns the largest change of a penetration; not finite if the set has no stiffness.
    """
    m = state["m"]
    side = v[SIDE]
    for k in range(m):
        side[k] = v[WEIGHT, on[LISTED, k]]
    solve_block(U, m, v[INVERSE], side)
    lacking = load
    soft = 0.0
    most = 0.0
    for k in range(m):
        i = on[LISTED, k]
        lacking -= v[WEIGHT, i] * (v[FORCE, i] + v[STEP, k])
        soft += v[WEIGHT, i] * side[k]
        most = max(most, v[WEIGHT, i])
    by = lacking / soft
    for k in range(m):
        v[STEP, k] += by * side[k]
    state["approach"] += by
    return most * abs(by)


@kernel
def newton(C, node, n, load, state, on, v, U):
    """Forces at given penetrations, or at a given total force.

    Parameters
    ----------
    C, node
        Compliance matrix and nodes.
    n
        Number of nodes.
    load
        Sum of weight times force [N], > 0: penetrations are weight times approach less gap; 0: penetrations
        are given in row PENETRATION.
    state, on, v, U
        Workspace with the last forces, and the approach if a load is given.

    Returns
    -------
    int
        OK; SLOW if the set of nodes keeps changing; SINGULAR; NOT_FINITE.

    Examples
    --------
    >>> import numpy as np
    >>> from pitchpoint.contact.local_approach import N_NODE, D
    >>> from pitchpoint.contact.unilateral_work import ContactWorkspace
    >>> work, node = ContactWorkspace.of(2), np.zeros((2, N_NODE))
    >>> work.v[PENETRATION, :2], node[:, D] = (9.0, 2.0), 1.0
    >>> newton(np.array([[2.0, 1.0], [1.0, 2.0]]), node, 2, 0.0, *work.arrays())
    1
    >>> work.v[FORCE, :2].tolist()
    [3.0, 0.0]
    """
    x = v[PENETRATION]
    before = 0.0
    scale = 0.0
    for step in range(_STEPS):
        if load > 0.0:
            for i in range(n):
                x[i] = v[WEIGHT, i] * state["approach"] - v[GAP, i]
        if load > 0.0 or step == 0:
            scale = 0.0
            for i in range(n):
                scale = max(scale, x[i])
        state["exact"] = 0
        largest, sound = residual(C, node, n, state["m"], on, v)
        if not sound:
            return NOT_FINITE
        limit = TOLERANCE * scale
        joined = _join(C, node, n, limit, state, on, v) > 0
        if joined:
            state["factored"] = 0
            before = 0.0
            # the slopes of the new nodes, and the residuals that their forces leave
            largest, sound = residual(C, node, n, state["m"], on, v)
        m = state["m"]
        if m == 0:
            return OK if load == 0.0 else SLOW
        rate = min(largest / before, 1.0) if before > 0.0 else 1.0
        if before > 0.0:
            state["rate"] = rate
        if state["factored"] == 0 or state["rate"] > _STALE:
            status = factorise(C, state, on, v, U)
            if status != OK:
                return status
            state["exact"] = 1
            state["rate"] = 0.0
        solve_block(U, m, v[INVERSE], v[STEP])
        state["newton"] += 1
        if load > 0.0:
            change = _border(load, state, on, v, U)
            if not change < math.inf:
                return NOT_FINITE
            largest = max(largest, change)
        scaled = _apply(state, on, v)
        before = 0.0 if scaled else largest
        if not joined and not scaled and largest * max(rate, _TRUST) <= 0.1 * limit:
            return OK
    return SLOW
