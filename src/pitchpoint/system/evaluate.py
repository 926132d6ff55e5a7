# SPDX-License-Identifier: Apache-2.0
"""Evaluation of a compiled system at one state: residual, linearisation, observations, accelerations."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INTERRUPTED, NOT_FINITE, OK, sentence
from pitchpoint.system import linearise
from pitchpoint.system.law_fault import law_fault
from pitchpoint.system.link import kind_of_row, link_exact
from pitchpoint.system.requests import (
    ACCELERATE,
    EVENTS,
    OBSERVE,
    RESIDUAL,
    REST,
    WRAP,
    handle_request,
    send_request,
)
from pitchpoint.system.residual import EXACT
from pitchpoint.system.source import source
from pitchpoint.system.system import State, System
from pitchpoint.system.workspace import VALID

if TYPE_CHECKING:
    from scipy.sparse import csc_array


def load(system: System, state: State) -> None:
    """Copy a state to the workspace of a system."""
    w = system.workspace
    w.q[:], w.v[:], w.a[:], w.lam[:] = state.q, state.v, state.a, state.lam
    w.fr["turns"] = state.turns
    w.arrays["charts"][:] = state.charts
    w.ctl[0]["t"] = state.t


def store(system: System, t: float) -> State:
    """Copy of the state in the workspace of a system, with the time t [s]."""
    w = system.workspace
    return State(
        float(t),
        w.q.copy(),
        w.v.copy(),
        w.a.copy(),
        w.lam.copy(),
        w.fr["turns"].copy(),
        w.arrays["charts"].copy(),
    )


def explain(system: System, status: int) -> str:
    """Message for a status, with the name of the element that caused it, if any."""
    text = sentence(status)
    row, record = int(system.workspace.ctl[0]["badkind"]), int(system.workspace.ctl[0]["bad"])
    if row < 0 or status == INTERRUPTED:
        return text
    kind = kind_of_row(system.records, row)
    if record < 0:
        return f"{text} ({kind.replace('_', ' ')})"
    names = system.names.get(kind, ())
    name = (
        source(system, kind, names[record])
        if record < len(names)
        else f"{kind.replace('_', ' ')} {record + 1}"
    )
    text = f"{name}: {text}"
    return text + law_fault(system, kind, record) if status == NOT_FINITE else text


def check(system: System, status: int, partial: State | None = None) -> None:
    """Raise a SolverError unless the status is OK."""
    if status != OK:
        raise SolverError(explain(system, status), int(status), partial)


def prepare(system: System) -> None:
    """Write the constant parts of a new workspace, once."""
    w = system.workspace
    if not w.ready:
        send_request(w, REST)
        w.ready = True


def accelerations(system: System, t: float, rate: float = 0.0) -> int:
    """Solve accelerations and multipliers at the state in the workspace, wrap the spins; returns the status.

    `rate` [1/s] is the Baumgarte stabilisation of the constraints.
    """
    status = send_request(system.workspace, ACCELERATE, t, factors=(0.0, 0.0, rate))
    send_request(system.workspace, WRAP)
    return status


def fill_events(system: System, t: float, target: NDArray[np.float64]) -> int:
    """Write all event functions at the state in the workspace to `target`; returns the status."""
    return send_request(system.workspace, EVENTS, t, where=target.ctypes.data)


def residual(system: System, state: State) -> NDArray[np.float64]:
    """Residual R = M a - f + G^T lam at a state, shape (nd,).

    Raises
    ------
    SolverError
        If an element cannot be evaluated at the state.
    """
    prepare(system)
    load(system, state)
    check(system, send_request(system.workspace, RESIDUAL, state.t))
    return system.workspace.R.copy()


def blocks(
    system: System, state: State, cm: float, cd: float, ck: float, jac: int = EXACT
) -> NDArray[np.float64]:
    """Blocks of the matrix cm M + cd D + ck K at a state; parameters as in `matrix`.

    Returns
    -------
    ndarray, shape (na, 6, 6)
        Blocks for `dense` and `sparse`; blocks may be added.
    """
    prepare(system)
    load(system, state)
    w = system.workspace
    entry = handle_request
    if jac == EXACT:
        entry = linearise.entry
        link_exact(system.records)
    check(system, send_request(w, RESIDUAL, state.t, jac, (cm, cd, ck), entry=entry))
    w.clock[VALID] = 0  # invalidates the matrix of a run in progress
    found = w.A.copy()
    found[0] = 0.0  # sink of contributions to ground
    return found


def dense(system: System, parts: NDArray[np.float64]) -> NDArray[np.float64]:
    """Dense matrix (nd, nd) from its blocks."""
    rows, columns, places = system.layout.entries
    nd = system.sizes["nd"]
    whole = np.zeros((nd, nd))
    whole[rows, columns] = parts.reshape(-1)[places]
    return whole


def sparse(system: System, parts: NDArray[np.float64]) -> csc_array:
    """Sparse matrix (nd, nd) in compressed column format from its blocks."""
    from scipy.sparse import csc_array

    rows, columns, places = system.layout.entries
    nd = system.sizes["nd"]
    starts = np.searchsorted(columns, np.arange(nd + 1))
    return csc_array((parts.reshape(-1)[places], rows, starts), shape=(nd, nd))


def matrix(
    system: System, state: State, cm: float, cd: float, ck: float, jac: int = EXACT
) -> NDArray[np.float64]:
    """Dense matrix cm M + cd D + ck K at a state, shape (nd, nd).

    Parameters
    ----------
    cm, cd, ck
        Factors of mass, damping and stiffness.
    jac
        `residual.EXACT` for the exact derivative of the residual, `residual.NEWTON` for the Newton matrix of
        the integrators.
    """
    return dense(system, blocks(system, state, cm, cd, ck, jac))


def linearize(
    system: System, state: State
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Exact derivatives of the residual: M = dR/da, D = dR/dv, K = dR/dq, each (nd, nd).

    D includes gyroscopic terms. K includes geometric stiffness due to loads and spins, and circulatory terms
    due to dampers of spinning bodies, and is then not symmetric. Mesh phase, path of contact and shared face
    width of the meshes are frozen in K (docs/decisions/0006-frozen-phase-tangents.md); mesh friction is not
    linearised.
    """
    return (
        matrix(system, state, 1.0, 0.0, 0.0),
        matrix(system, state, 0.0, 1.0, 0.0),
        matrix(system, state, 0.0, 0.0, 1.0),
    )


def constraint_jacobian(system: System, state: State) -> NDArray[np.float64]:
    """Constraint Jacobian G = dg/dq at a state, shape (nc, nd)."""
    residual(system, state)
    return system.workspace.G.copy()


def observe(system: System, state: State) -> NDArray[np.float64]:
    """All observations at a state, in the order of ``system.layout.channels``."""
    prepare(system)
    load(system, state)
    row = np.zeros(system.sizes["no"])
    check(system, send_request(system.workspace, OBSERVE, state.t, where=row.ctypes.data))
    return row


def event_values(system: System, state: State) -> NDArray[np.float64]:
    """All event functions at a state, in the order of ``system.layout.events``."""
    prepare(system)
    load(system, state)
    row = np.zeros(system.sizes["ne"])
    check(system, send_request(system.workspace, EVENTS, state.t, where=row.ctypes.data))
    return row
