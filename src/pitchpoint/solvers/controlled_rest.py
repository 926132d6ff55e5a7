# SPDX-License-Identifier: Apache-2.0
"""Rest of a controlled machine: coordinates and states of controllers that all stand still.

Static equilibrium (`equilibrium`) takes rates as they are, and states of signals are rates. Here both are
unknown: Newton's method for the residuals of all bodies, hidden ones too, over the coordinates of the real
and the states of the hidden ones, begun in pseudo-time as there: limits of controllers that bind at the
start would leave it without slopes. Outputs of sampled controllers stay at what they are.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import DIVERGED, SINGULAR
from pitchpoint.system import evaluate
from pitchpoint.system.link import state_bodies
from pitchpoint.system.residual import NEWTON
from pitchpoint.system.system import State, System

MOST_ITERATIONS = 300
FIRST = 100.0
"""Factor of the masses in the first step; it falls with what is left over."""
SETTLED = 1e-12
"""Newton step over the size of what it changes at which it has come to rest."""
FLAT = 1e-12
"""Singular value over the largest one below which a step leaves a direction alone."""


def controlled_rest(system: System, start: State | None = None) -> State:
    """State at rest near a start, its controllers in steady state.

    Parameters
    ----------
    system
        System without constraint rows.
    start
        Where to begin; rates of real bodies are kept as they are (zero for rest). Default: the initial state.

    Raises
    ------
    SolverError
        If there are constraint rows, if nothing determines a coordinate or a state (a spin that nothing
        holds, an integrator in no loop), or if the iteration finds no rest.
    """
    if system.sizes["nc"]:
        raise SolverError("rest of controlled machines is sought without constraint rows only", SINGULAR)
    state = (system.initial_state() if start is None else start).copy()
    state.a[:] = 0.0
    states = system.program["body"]["spin"][state_bodies(system.records)]
    real = np.setdiff1d(np.arange(system.sizes["nd"]), states)
    both = np.concatenate([real, states])
    mass = evaluate.matrix(system, state, 1.0, 0.0, 0.0, NEWTON)
    R = evaluate.residual(system, state)
    A = _slopes(system, state, states)
    scale = np.abs(A + FIRST * mass).max(axis=1)
    first = last = float(np.linalg.norm(R / scale)) or 1.0
    for _ in range(MOST_ITERATIONS):
        step = -np.linalg.lstsq((A + FIRST * last / first * mass) / scale[:, None], R / scale, rcond=FLAT)[0]
        size = np.abs(np.concatenate([state.q[real], state.v[states]])) + 1.0
        if (np.abs(step[both]) <= SETTLED * size).all() and not _undetermined(A).any():
            return state
        state.q[real] += step[real]
        state.v[states] += step[states]
        R = evaluate.residual(system, state)
        A = _slopes(system, state, states)
        last = float(np.linalg.norm(R / scale))
    if loose := _undetermined(A).nonzero()[0].tolist():
        names = [system.layout.coordinates[k].removeprefix("state.").removesuffix(".spin") for k in loose]
        raise SolverError(f"no rest: nothing determines {', '.join(names)}", SINGULAR, state)
    raise SolverError("no rest of the controlled machine found; start nearer to it", DIVERGED, state)


def _slopes(system: System, state: State, states: NDArray[np.int64]) -> NDArray[np.float64]:
    """Derivatives of the residual by the coordinates of real bodies and the states of hidden ones."""
    A = evaluate.matrix(system, state, 0.0, 0.0, 1.0, NEWTON)
    A[:, states] = evaluate.matrix(system, state, 0.0, 1.0, 0.0, NEWTON)[:, states]
    return A


def _undetermined(A: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Which unknowns no residual depends on."""
    found: NDArray[np.bool_] = np.abs(A).max(axis=0) == 0.0
    return found
