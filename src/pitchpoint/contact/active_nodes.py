# SPDX-License-Identifier: Apache-2.0
"""Residuals and tangent matrix of the nodes in contact, for the methods that change their set.

Residual of a node: its overlap x - C f less its local approach h(f). Tangent matrix: C + diag(dh/df).
"""

from __future__ import annotations

import math

from pitchpoint.contact.active_block import factorise_block, pack_block, subtract_columns
from pitchpoint.contact.local_approach import local_approach
from pitchpoint.contact.unilateral_work import (
    APPROACH,
    FORCE,
    INVERSE,
    LISTED,
    OVERLAP,
    PENETRATION,
    SLOPE,
    STEP,
)
from pitchpoint.core.kernel import kernel
from pitchpoint.core.status import OK

TOLERANCE = 1e-12
"""Largest residual, relative to the largest penetration."""


@kernel
def residual(C, node, n, m, on, v):
    """Residuals of the nodes in contact at the current forces; approach, slope and overlap on the way.

    Parameters
    ----------
    C, node
        Compliance matrix and nodes.
    n, m
        Number of nodes, and of those in contact.
    on, v
        Indices and vectors of the workspace; the residuals are in row STEP.

    Returns
    -------
    tuple
        Largest absolute residual [m]; whether all residuals are finite.

    Examples
    --------
    >>> import numpy as np
    >>> from pitchpoint.contact.local_approach import N_NODE, D
    >>> from pitchpoint.contact.unilateral_work import ContactWorkspace
    >>> work, node = ContactWorkspace.of(2), np.zeros((2, N_NODE))
    >>> work.v[PENETRATION, :2], work.v[FORCE, :2], node[:, D] = (9.0, 2.0), (1.0, 0.0), 3.0
    >>> C = np.array([[2.0, 1.0], [1.0, 2.0]])
    >>> largest, sound = residual(C, node, 2, 1, work.on, work.v)
    >>> float(largest), bool(sound)
    (4.0, True)
    """
    f = v[FORCE]
    o = v[OVERLAP]
    approach = v[APPROACH]
    slopes = v[SLOPE]
    step = v[STEP]
    listed = on[LISTED]
    subtract_columns(C, listed, m, f, v[PENETRATION, :n], o)
    largest = 0.0
    sound = True
    for k in range(m):
        i = listed[k]
        h, slope = local_approach(node, i, f[i])
        approach[k] = h
        slopes[k] = slope
        r = o[i] - h
        step[k] = r
        sound = sound and abs(r) < math.inf
        largest = max(largest, abs(r))
    return largest, sound


@kernel
def factorise(C, state, on, v, U):
    """Factorise the block of the nodes in contact with the slopes in row SLOPE; returns a status.

    Parameters
    ----------
    C
        Compliance matrix.
    state, on, v, U
        Workspace.

    Examples
    --------
    >>> import numpy as np
    >>> from pitchpoint.contact.unilateral_work import ContactWorkspace
    >>> state, on, v, U = ContactWorkspace.of(1).arrays()
    >>> state["m"], v[SLOPE, 0] = 1, 1.0
    >>> factorise(np.array([[3.0]]), state, on, v, U), float(U[0, 0])
    (1, 2.0)
    """
    pack_block(C, on[LISTED], state["m"], v[SLOPE], U)
    status = factorise_block(U, state["m"], v[INVERSE])
    state["factorisations"] += 1
    state["factored"] = 1 if status == OK else 0
    return status
