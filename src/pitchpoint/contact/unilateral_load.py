# SPDX-License-Identifier: Apache-2.0
"""Unilateral contact under a given total force: rigid-body approach and forces.

The penetrations are x_i = p_i X - g_i with one approach X, gaps g_i and weights p_i > 0, and the load is
sum p_i f_i = F. The weights are the derivatives of the penetrations by X, so that F dX is the work of the
load: F increases with X, from 0 at the first contact, and the approach is unique.

Source: Judice and Pires, Comput. Oper. Res. 21 (1994) 587-596, for the forces at one approach. Derivation:
docs/decisions/0032-unilateral-contact.md.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.contact.active_newton import newton
from pitchpoint.contact.local_approach import local_approach
from pitchpoint.contact.unilateral import solve_contact, solve_tangent, tangent_block
from pitchpoint.contact.unilateral_work import FORCE, GAP, LISTED, SIDE, WEIGHT, forget
from pitchpoint.core.kernel import kernel
from pitchpoint.core.status import NOT_FINITE, OK, REFUSED, SLOW

_SEARCHES = 200
"""Maximum number of approaches of a search; fewer than ten are needed."""
_EXACT = 1e-12
"""Relative error of the load at the end of a search."""


@kernel
def _total(state, on, v):
    """Sum of weight times force."""
    total = 0.0
    for k in range(state["m"]):
        total += v[WEIGHT, on[LISTED, k]] * v[FORCE, on[LISTED, k]]
    return total


@kernel
def _stiffness(state, on, v, U):
    """Derivative of the total force by the approach, with the factor at hand."""
    side = v[SIDE]
    for k in range(state["m"]):
        side[k] = v[WEIGHT, on[LISTED, k]]
    solve_tangent(state, v, U, side)
    total = 0.0
    for k in range(state["m"]):
        total += v[WEIGHT, on[LISTED, k]] * side[k]
    return total


@kernel
def _alone(C, node, load, first, v):
    """Approach from first contact at which the node of first contact would carry the load alone."""
    f = load / v[WEIGHT, first]
    return (local_approach(node, first, f)[0] + C[first, first] * f) / v[WEIGHT, first]


@kernel
def _search(C, node, n, load, start, state, on, v, U):
    """Newton's method for the total force over the approach, within a bracket that always narrows.

    A step that does not halve the error of the force is followed by one to the middle of the bracket.
    """
    low = 0.0
    high = np.inf
    y = start
    last = np.inf
    x = v[SIDE, :n]
    state["searches"] += 1
    for _ in range(_SEARCHES):
        for i in range(n):
            x[i] = v[WEIGHT, i] * y - v[GAP, i]
        status = solve_contact(C, node, x, state, on, v, U)
        if status == OK:
            status = tangent_block(C, state, on, v, U)
        if status != OK:
            return status
        state["approach"] = y
        total = _total(state, on, v)
        error = abs(total - load)
        if error <= _EXACT * load:
            return OK
        if total < load:
            low = y
        else:
            high = y
        stiffness = _stiffness(state, on, v, U)
        y = y + (load - total) / stiffness if stiffness > 0.0 else np.inf
        if high < np.inf and (error > 0.5 * last or not low < y < high):
            y = 0.5 * (low + high)
        elif not low < y < high:
            y = 2.0 * low
        last = error
        if not low < y < high:  # neighbouring numbers
            return OK if high < np.inf else NOT_FINITE
    return SLOW


@kernel
def solve_load(C, node, gap, weight, load, state, on, v, U):
    """Rigid-body approach and forces at a given total force.

    The forces are in row FORCE of the vectors, the approach is `state["approach"]`.

    Parameters
    ----------
    C, node
        Compliance matrix and nodes, as for `unilateral.solve_contact`.
    gap
        Gaps at zero approach g [m], shape (n,); any sign.
    weight
        Penetration per approach, p > 0, shape (n,).
    load
        Sum of weight times force F >= 0 [N]; 0: first contact.
    state, on, v, U
        Workspace; forces, approach and factor in it start the solution.

    Returns
    -------
    int
        As for `unilateral.solve_contact`; REFUSED without nodes or if load or a weight is negative.

    Examples
    --------
    >>> from pitchpoint.contact.local_approach import N_NODE, D
    >>> from pitchpoint.contact.unilateral_work import ContactWorkspace
    >>> C, node, work = np.array([[2.0, 1.0], [1.0, 2.0]]), np.eye(N_NODE)[[D, D]], ContactWorkspace.of(2)
    >>> solve_load(C, node, np.array([0.0, 4.0]), np.ones(2), 10.0, *work.arrays())
    1
    >>> float(work.state["approach"][0]), work.v[FORCE, :2].tolist()
    (22.0, [6.0, 4.0])
    """
    n = gap.size
    sound = abs(load) < np.inf
    positive = n > 0 and load >= 0.0
    for i in range(n):
        sound = sound and abs(gap[i]) < np.inf and abs(weight[i]) < np.inf
        positive = positive and weight[i] > 0.0
    if not sound or not positive:
        forget(n, state, v)
        state["approach"] = 0.0
        return REFUSED if sound else NOT_FINITE
    first = 0
    for i in range(n):
        if gap[i] * weight[first] < gap[first] * weight[i]:
            first = i
    contact = gap[first] / weight[first]
    for i in range(n):
        v[WEIGHT, i] = weight[i]
        v[GAP, i] = gap[i] - weight[i] * contact  # approaches are counted from first contact: no cancellation
    v[GAP, first] = 0.0
    if load == 0.0:
        forget(n, state, v)
        state["approach"] = contact
        return OK
    y = state["approach"] - contact
    if state["m"] == 0 or not y > 0.0:
        y = _alone(C, node, load, first, v)
    state["approach"] = y
    status = newton(C, node, n, load, state, on, v, U)
    if status == SLOW:
        status = _search(C, node, n, load, y, state, on, v, U)
    if status != OK:
        forget(n, state, v)
        state["approach"] = 0.0
        return status
    state["approach"] += contact
    return OK
