# SPDX-License-Identifier: Apache-2.0
"""What is unknown at rest: places of bodies, and the states of elements, which are among the rates.

Large systems have sparse matrices here, small ones dense ones; both are used alike.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.kind import SIGNAL
from pitchpoint.elements.signals.record import SATURATION
from pitchpoint.system import evaluate
from pitchpoint.system.residual import EXACT
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

STATE = "state."
"""How the names of the hidden bodies of signals begin."""
SLIGHT = 1e-3
"""Influence of a place on the rate of a state, over that of the speeds, up to which it is neglected: the axis
of a shaft that bends is sensed at a small tilt."""
ROUNDING = 8 * 2.2e-16
"""Rounding of a force relative to its terms, also of one caused by a place: as many add up at a body."""
GROWTH = 1.01
"""Factor by which the step that would follow may grow over an accepted one: in the gap nothing gets less."""
LARGE = 300
"""Coordinates from which matrices are sparse (SciPy, which takes a fifth of a second to import)."""
REGULAR = 1e13
"""Condition number up to which a matrix is inverted as it is; beyond it singular parts are excluded."""


def slopes(system: System, state: State, jac: int) -> Array:
    """Derivative of the residual at rest by places and states, shape (nd, nd).

    Parameters
    ----------
    system, state
        Where.
    jac
        `residual.NEWTON` or `residual.EXACT`.
    """
    return evaluate.dense(system, _slope_blocks(system, state, jac))


def _slope_blocks(system: System, state: State, jac: int) -> Array:
    found = evaluate.blocks(system, state, 0.0, 0.0, 1.0, jac)
    if system.states.size:
        rates = evaluate.blocks(system, state, 0.0, 1.0, 0.0, jac)
        _, columns, places = system.layout.entries
        own = places[np.isin(columns, system.states)]
        found.reshape(-1)[own] = rates.reshape(-1)[own]
    return found


def rest_matrix(system: System, state: State, jac: int, factors: tuple[float, float, float] | None) -> Any:
    """Matrix cm M + cd D + ck K, or `slopes` without factors; sparse if the system is large."""
    if factors is None:
        found = _slope_blocks(system, state, jac)
    else:
        found = evaluate.blocks(system, state, *factors, jac)
    large = system.sizes["nd"] >= LARGE
    return evaluate.sparse(system, found) if large else evaluate.dense(system, found)


def inverse_of(A: Any, root: Array) -> Callable[[Array], Array]:
    """Function that solves A x = b in the scale of the masses; directions that nothing resists stay at zero.

    Parameters
    ----------
    A
        Dense or sparse matrix, shape (n, n).
    root
        Square roots of the masses, shape (n,).
    """
    if not isinstance(A, np.ndarray):
        if (solve := _sparse_inverse(A, root)) is not None:
            return solve
        A = A.toarray()
    scaled = A / np.outer(root, root)
    try:
        inverse = np.linalg.inv(scaled)
        regular = bool(np.linalg.norm(scaled, 1) * np.linalg.norm(inverse, 1) < REGULAR)
    except np.linalg.LinAlgError:
        regular = False
    if not regular:
        inverse = np.linalg.pinv(scaled)
    return lambda b: np.asarray(inverse @ (b / root) / root)


def _sparse_inverse(A: Any, root: Array) -> Callable[[Array], Array] | None:
    """The same by sparse elimination; none if the matrix is singular."""
    from scipy.sparse import diags_array
    from scipy.sparse.linalg import splu

    scale = diags_array(1.0 / root)
    try:
        lu = splu((scale @ A @ scale).tocsc())
    except RuntimeError:  # a pivot is zero
        return None
    pivots = np.abs(lu.U.diagonal())
    if not pivots.min() * REGULAR > pivots.max():
        return None
    return lambda b: np.asarray(lu.solve(b / root) / root)


def signal_states(system: System) -> NDArray[np.int64]:
    """Coordinates whose rates are states of signals: those of filters, integrals, transfer functions."""
    if not system.kinds(SIGNAL):
        return np.zeros(0, np.int64)
    found = [k for k in system.states if system.layout.coordinates[int(k)].startswith(STATE)]
    return np.array(found, np.int64)


def unsettled_states(system: System, state: State, free: NDArray[np.int64]) -> NDArray[np.int64]:
    """States of signals whose rates do not depend on free coordinates, such as the integral of a speed error.

    They cannot be brought to rest and keep their values. Limits do not count: an integral that comes to rest
    only because a controller tracks its limit has not found anything.

    Parameters
    ----------
    system, state
        Where.
    free
        Coordinates that may change.
    """
    found = np.intersect1d(signal_states(system), free)
    if not found.size:
        return found
    loose = _without_limits(system)
    by_place = np.abs(slopes(loose, state, EXACT)[np.ix_(found, free)]).max(axis=1)
    by_rate = np.abs(evaluate.matrix(loose, state, 0.0, 1.0, 0.0, EXACT)[found])
    by_rate[:, system.states] = 0.0
    return found[by_place <= SLIGHT * (by_rate @ np.abs(state.v))]


def _without_limits(system: System) -> System:
    """The same system with signals that no limits keep."""
    kind = system.kinds(SIGNAL)[0]
    records = system.records[kind].copy()
    kept = records["op"] == SATURATION
    records["low"][kept], records["high"][kept] = -np.inf, np.inf
    return system.with_params({kind: records}) if kept.any() else system


def step_on(system: System, state: State, free: NDArray[np.int64], step: NDArray[np.float64]) -> State:
    """The state with some coordinates moved; those that hold states change their rates."""
    found = state.copy()
    holds = np.isin(free, system.states)
    found.q[free[~holds]] += step[~holds]
    found.v[free[holds]] += step[holds]
    return found
