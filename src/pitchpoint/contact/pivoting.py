# SPDX-License-Identifier: Apache-2.0
"""Block principal pivoting for unilateral contact, with Murty's least-index rule as back-up.

For each set of nodes the forces follow from C f + h(f) = x within the set and f = 0 outside; h is continued
to negative forces as an odd function, so that they exist and are unique. A node is infeasible if it pulls or,
outside the set, overlaps. All infeasible nodes change sides as long as their number decreases, with a few
further attempts; then only the one of the lowest index changes sides until their number is lower than ever
before. The rule of the lowest index ends after finitely many exchanges for the linear problem with a
P-matrix, and by the same argument for this strictly monotone one.

Source: Judice and Pires, Comput. Oper. Res. 21 (1994) 587-596; Murty, Linear Algebra Appl. 7 (1974) 65-108.
Derivation: docs/decisions/0032-unilateral-contact.md.
"""

from __future__ import annotations

from pitchpoint.contact.active_block import solve_block
from pitchpoint.contact.active_nodes import TOLERANCE, factorise, residual
from pitchpoint.contact.local_approach import local_force
from pitchpoint.contact.unilateral_work import BASE, FORCE, INVERSE, LISTED, MEMBER, OVERLAP, SLOPE, STEP
from pitchpoint.core.kernel import kernel
from pitchpoint.core.status import NOT_FINITE, OK, SLOW

_CHANCES = 5
"""Block exchanges without a decrease of the number of infeasible nodes before Murty's rule."""
_STEPS = 80
"""Maximum number of Newton steps for one set of nodes."""
_HALVINGS = 60
"""Maximum number of halvings of a Newton step."""
_ROUNDING = 1e-15
"""Rounding error of a residual relative to the largest product of compliance and force, per node."""


@kernel
def _work(m, step, v):
    """Product of the residuals in row STEP with a step."""
    total = 0.0
    for k in range(m):
        total += v[STEP, k] * step[k]
    return total


@kernel
def _balance(C, node, n, scale, state, on, v, U):
    """Forces of either sign for a given set of nodes: Newton's method on a strictly convex function.

    The residual times the step is minus the derivative of this function along the step. It decreases along
    the step; steps are halved until it is not clearly negative at the end, so that the function decreases.
    """
    m = state["m"]
    f = v[FORCE]
    listed = on[LISTED]
    step = v[BASE]
    for _ in range(_STEPS):
        largest, sound = residual(C, node, n, m, on, v)
        if not sound:
            return NOT_FINITE
        size = 0.0
        for k in range(m):
            size = max(size, C[listed[k], listed[k]] * abs(f[listed[k]]))
        if largest <= max(0.1 * TOLERANCE * scale, _ROUNDING * m * size):
            return OK
        status = factorise(C, state, on, v, U)
        if status != OK:
            return status
        for k in range(m):
            step[k] = v[STEP, k]
        solve_block(U, m, v[INVERSE], step)
        state["newton"] += 1
        start = _work(m, step, v)
        low = 0.0
        high = 1.0
        part = 1.0
        done = 0.0
        for _ in range(_HALVINGS):
            for k in range(m):
                f[listed[k]] += (part - done) * step[k]
            done = part
            largest, sound = residual(C, node, n, m, on, v)
            end = _work(m, step, v)
            if not sound:
                return NOT_FINITE
            if end < -0.1 * start:
                high = part
            elif end > 0.9 * start and part < 1.0:
                low = part
            else:
                break
            part = 0.5 * (low + high)
    return SLOW


@kernel
def _infeasible(C, n, limit, state, on, v):
    """Number of infeasible nodes and the lowest index among them; their mark in MEMBER becomes 2 or 3."""
    for k in range(state["m"]):
        i = on[LISTED, k]
        if v[FORCE, i] * (C[i, i] + v[SLOPE, k]) < -limit:
            on[MEMBER, i] = 3
    count = 0
    lowest = -1
    for i in range(n):
        if on[MEMBER, i] == 0 and not v[OVERLAP, i] <= limit:
            on[MEMBER, i] = 2
        if on[MEMBER, i] >= 2:
            count += 1
            if lowest < 0:
                lowest = i
    return count, lowest


@kernel
def _exchange(C, node, n, only, state, on, v):
    """Exchange the marked nodes, or only one of them if `only` >= 0, and list the new set."""
    m = 0
    for i in range(n):
        mark = on[MEMBER, i]
        if mark >= 2:
            mark -= 2
            if only < 0 or only == i:
                mark = 1 - mark
                v[FORCE, i] = local_force(node, i, v[OVERLAP, i], C[i, i]) if mark == 1 else 0.0
        on[MEMBER, i] = mark
        if mark == 1:
            on[LISTED, m] = i
            m += 1
    state["m"] = m
    state["factored"] = 0


@kernel
def pivot(C, node, n, scale, state, on, v, U):
    """Solve by pivoting from the current set of nodes.

    Parameters
    ----------
    C, node
        Compliance matrix and nodes.
    n
        Number of nodes.
    scale
        Largest penetration, > 0 [m].
    state, on, v, U
        Workspace with the penetrations.

    Returns
    -------
    int
        OK; SINGULAR if C is singular for a set of nodes without local approach; NOT_FINITE; SLOW if rounding
        errors prevent the solution.

    Examples
    --------
    >>> import numpy as np
    >>> from pitchpoint.contact.local_approach import D
    >>> from pitchpoint.contact.unilateral_work import PENETRATION, ContactWorkspace
    >>> work, node = ContactWorkspace.of(2), np.zeros((2, 8))
    >>> work.v[PENETRATION, :2], node[:, D] = (9.0, 2.0), 1.0
    >>> pivot(np.array([[2.0, 1.0], [1.0, 2.0]]), node, 2, 9.0, *work.arrays())
    1
    >>> work.v[FORCE, :2].tolist()
    [3.0, 0.0]
    """
    state["pivoted"] += 1
    state["exact"] = 0
    limit = TOLERANCE * scale
    fewest = n + 1
    chances = _CHANCES
    for i in range(n):
        on[MEMBER, i] = 0
    for k in range(state["m"]):
        on[MEMBER, on[LISTED, k]] = 1
    for _ in range(1000 + 100 * n):
        status = _balance(C, node, n, scale, state, on, v, U)
        if status != OK:
            return status
        count, lowest = _infeasible(C, n, limit, state, on, v)
        if count == 0:
            break
        if count < fewest:
            fewest = count
            chances = _CHANCES
        else:
            chances -= 1
        if chances >= 0:
            state["blocks"] += 1
            lowest = -1
        else:
            state["singles"] += 1
        _exchange(C, node, n, lowest, state, on, v)
    else:
        return SLOW
    m = 0
    for k in range(state["m"]):
        i = on[LISTED, k]
        if v[FORCE, i] > 0.0:
            on[LISTED, m] = i
            v[SLOPE, m] = v[SLOPE, k]
            m += 1
        else:
            v[FORCE, i] = 0.0
            state["factored"] = 0
    state["m"] = m
    return OK
