# SPDX-License-Identifier: Apache-2.0
"""Unilateral contact of elastically coupled nodes: forces from penetrations.

Given are a compliance matrix C, the local approaches h_i of the nodes and the penetrations x_i without
deformation. Forces f and gaps w fulfil

    f >= 0,  w = C f + h(f) - x >= 0,  f_i w_i = 0.

C is symmetric and positive semidefinite and h increases, so that the forces are unique: the minimum of
f.C f/2 + sum Psi_i(f_i) - x.f over f >= 0, with the integrals Psi of h. `active_newton` solves nearly all
states; where its set of nodes does not settle, `pivoting` ends after finitely many exchanges.

Source: Judice and Pires, Comput. Oper. Res. 21 (1994) 587-596. Derivation:
docs/decisions/0032-unilateral-contact.md.
"""

from __future__ import annotations

import math

from pitchpoint.contact.active_block import solve_block
from pitchpoint.contact.active_newton import newton
from pitchpoint.contact.active_nodes import factorise
from pitchpoint.contact.local_approach import local_approach, local_energy
from pitchpoint.contact.pivoting import pivot
from pitchpoint.contact.unilateral_work import FORCE, INVERSE, LISTED, PENETRATION, forget
from pitchpoint.core.kernel import kernel
from pitchpoint.core.status import NOT_FINITE, OK, SLOW


@kernel
def solve_contact(C, node, x, state, on, v, U):
    """Forces at given penetrations; they are in row FORCE of the vectors.

    Parameters
    ----------
    C
        Compliance matrix, symmetric and positive semidefinite [m/N], shape (n, n).
    node
        Local approach of the nodes, see `local_approach.set_node`, shape (n, N_NODE).
    x
        Penetrations without deformation [m], shape (n,); negative: gaps.
    state, on, v, U
        Workspace, see `ContactWorkspace.arrays`. The forces and the factor in it start the solution.

    Returns
    -------
    int
        OK; NOT_FINITE if a number is not finite; SINGULAR if C is singular for the nodes in contact, which
        requires nodes without local approach; SLOW if rounding errors prevent the solution. After a failure
        all forces are 0.

    Examples
    --------
    >>> import numpy as np
    >>> from pitchpoint.contact.local_approach import N_NODE, D
    >>> from pitchpoint.contact.unilateral_work import ContactWorkspace
    >>> C, node, work = np.array([[2.0, 1.0], [1.0, 2.0]]), np.eye(N_NODE)[[D, D]], ContactWorkspace.of(2)
    >>> solve_contact(C, node, np.array([9.0, 4.0]), *work.arrays())
    1
    >>> work.v[FORCE, :2].tolist()
    [2.875, 0.375]
    """
    n = x.size
    scale = 0.0
    sound = True
    for i in range(n):
        v[PENETRATION, i] = x[i]
        sound = sound and abs(x[i]) < math.inf
        scale = max(scale, x[i])
    if not sound or scale == 0.0:
        forget(n, state, v)
        return OK if sound else NOT_FINITE
    status = newton(C, node, n, 0.0, state, on, v, U)
    if status == SLOW:
        status = pivot(C, node, n, scale, state, on, v, U)
    if status != OK:
        forget(n, state, v)
    return status


@kernel
def tangent_block(C, state, on, v, U):
    """Factorise the tangent matrix of the nodes in contact, C + diag(dh/df), at the solution.

    Without this call `solve_tangent` uses the factor of the last iterations, which may be that of an earlier
    state: good enough for the matrix of a Newton method around this one.

    Parameters
    ----------
    C, state, on, v, U
        Compliance matrix and workspace, as for `solve_contact`.

    Returns
    -------
    int
        OK, SINGULAR or NOT_FINITE.

    Examples
    --------
    >>> import numpy as np
    >>> from pitchpoint.contact.local_approach import N_NODE, D
    >>> from pitchpoint.contact.unilateral_work import ContactWorkspace
    >>> C, node, work = np.array([[2.0, 1.0], [1.0, 2.0]]), np.eye(N_NODE)[[D, D]], ContactWorkspace.of(2)
    >>> solve_contact(C, node, np.array([9.0, 4.0]), *work.arrays()), tangent_block(C, *work.arrays())
    (1, 1)
    """
    if state["exact"] == 1 and state["factored"] == 1:
        return OK
    status = factorise(C, state, on, v, U)
    state["exact"] = 1 if status == OK else 0
    return status


@kernel
def solve_tangent(state, v, U, b):
    """Changes of the forces of the nodes in contact with their penetrations, in place.

    Parameters
    ----------
    state, v, U
        Workspace of a solution.
    b
        Changes of the penetrations on entry, of the forces on exit, in the order of the list of nodes in
        contact (row LISTED of the indices); its length is that of the vectors.

    Examples
    --------
    >>> import numpy as np
    >>> from pitchpoint.contact.local_approach import N_NODE, D
    >>> from pitchpoint.contact.unilateral_work import ContactWorkspace
    >>> C, node, work = np.array([[2.0, 1.0], [1.0, 2.0]]), np.eye(N_NODE)[[D, D]], ContactWorkspace.of(2)
    >>> solve_contact(C, node, np.array([9.0, 4.0]), *work.arrays())
    1
    >>> b = np.array([1.0, 0, 0, 0, 0, 0, 0, 0])
    >>> solve_tangent(work.state[0], work.v, work.U, b)
    >>> b[:2].round(12).tolist()
    [0.375, -0.125]
    """
    solve_block(U, state["m"], v[INVERSE], b)


@kernel
def contact_energy(node, state, on, v):
    """Energy stored at a solution, U(x) = max over f >= 0 of x.f - f.C f/2 - sum Psi_i(f_i) [J].

    Its derivatives by the penetrations are the forces. With C f = x - h(f) in contact it is the sum of
    f (x + h)/2 - Psi.

    Examples
    --------
    >>> import numpy as np
    >>> from pitchpoint.contact.local_approach import N_NODE, D
    >>> from pitchpoint.contact.unilateral_work import ContactWorkspace
    >>> C, node, work = np.array([[2.0, 1.0], [1.0, 2.0]]), np.eye(N_NODE)[[D, D]], ContactWorkspace.of(2)
    >>> solve_contact(C, node, np.array([9.0, 4.0]), *work.arrays())
    1
    >>> float(contact_energy(node, work.state[0], work.on, work.v))
    13.6875
    """
    total = 0.0
    for k in range(state["m"]):
        i = on[LISTED, k]
        f = v[FORCE, i]
        total += 0.5 * f * (v[PENETRATION, i] + local_approach(node, i, f)[0]) - local_energy(node, i, f)
    return total
