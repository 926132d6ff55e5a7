# SPDX-License-Identifier: Apache-2.0
"""Unknowns of an equilibrium: positions of bodies, and states of elements, which are stored as rates.

Matrices are sparse for large systems and dense for small ones.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.kind import SIGNAL
from pitchpoint.elements.signals.record import LIMITED, SATURATION
from pitchpoint.system import evaluate
from pitchpoint.system.residual import EXACT
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

STATE = "state."
"""Prefix of the names of the hidden bodies of signals."""
SLIGHT = 1e-3
"""Influence of a position on the rate of a state, relative to that of the speeds, up to which it is
neglected: sensors on a bending shaft measure along a slightly tilted axis."""
ALIKE = 1e-9
"""Relative size of a coefficient that counts as zero."""
ROUNDING = 8 * 2.2e-16
"""Relative rounding error of a force, from forces or positions, for about eight terms per body."""
GROWTH = 1.01
"""Factor by which the next step may exceed an accepted one: within backlash steps do not decrease."""
SOFTENING = 2.0
"""The same where the force along the step grows because its stiffness k is negative: the next step is
mu/(mu + k/m) times this one, so the mass factor mu stays above 2 |k|/m."""
LARGE = 300
"""Number of coordinates from which matrices are sparse (importing SciPy takes a fifth of a second)."""
FACTORISED = 100
"""Number of unknowns from which SciPy factorises dense matrices, in a third of the time of an inverse."""
REGULAR = 1e13
"""Condition number up to which a matrix is inverted; beyond it the pseudo-inverse is used."""


def slopes(system: System, state: State, jac: int) -> Array:
    """Derivative of the static residual with respect to positions and states, shape (nd, nd).

    Parameters
    ----------
    system, state
        The system and the state to evaluate.
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
    """Function that solves A x = b in mass scaling; components in singular directions are zero.

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
    if len(root) >= FACTORISED and (solve := factorised(scaled, root)) is not None:
        return solve
    try:
        inverse = np.linalg.inv(scaled)
        regular = bool(np.linalg.norm(scaled, 1) * np.linalg.norm(inverse, 1) < REGULAR)
    except np.linalg.LinAlgError:
        regular = False
    if not regular:
        inverse = np.linalg.pinv(scaled)
    return lambda b: np.asarray(inverse @ (b / root) / root)


def factorised(scaled: Array, root: Array) -> Callable[[Array], Array] | None:
    """`inverse_of` by triangular factors of a dense matrix; None if the matrix is singular."""
    from scipy.linalg.lapack import dgecon, dgetrf, dgetrs

    lu, pivots, failed = dgetrf(scaled)
    if failed or not dgecon(lu, np.linalg.norm(scaled, 1))[0] * REGULAR > 1.0:
        return None
    return lambda b: np.asarray(dgetrs(lu, pivots, b / root)[0] / root)


def _sparse_inverse(A: Any, root: Array) -> Callable[[Array], Array] | None:
    """`inverse_of` by sparse factorisation; None if the matrix is singular."""
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
    """Coordinates whose rates are states of signals: filters, integrators, transfer functions."""
    if not system.kinds(SIGNAL):
        return np.zeros(0, np.int64)
    found = [k for k in system.states if system.layout.coordinates[int(k)].startswith(STATE)]
    return np.array(found, np.int64)


def unsettled_states(system: System, state: State, free: NDArray[np.int64]) -> NDArray[np.int64]:
    """States of signals that neither rates nor free coordinates determine, such as a sum of speed errors.

    The error may be filtered, and the integral may pass a lag, as that of a pitch drive. They have no
    equilibrium and retain their values. Limits are ignored: an integrator that is constant only
    because its controller is saturated (anti-windup) is not in equilibrium.

    Parameters
    ----------
    system, state
        The system and the state to evaluate.
    free
        Coordinates that may change.
    """
    found = signal_states(system)
    if not found.size:
        return found
    found = np.intersect1d(found, free)
    if not found.size:
        return found
    loose = without_limits(system)
    K = slopes(loose, state, EXACT)[found]
    by_rate = np.abs(evaluate.matrix(loose, state, 0.0, 1.0, 0.0, EXACT)[found])
    by_rate[:, system.states] = 0.0
    slight = SLIGHT * (by_rate @ np.abs(state.v))
    moved = np.setdiff1d(free, found)
    alone = np.abs(K[:, moved]).max(axis=1, initial=0.0) <= slight
    among = K[:, found]
    while True:  # states that depend on states that depend on the machine do so, too
        on_machine = np.abs(among[:, ~alone]).max(axis=1, initial=0.0) > slight
        if not np.any(alone & on_machine):
            break
        alone &= ~on_machine
    own = among[np.ix_(alone, alone)]
    return np.asarray(found[alone][_undetermined(own)])


def integrators(system: System, state: State) -> NDArray[np.int64]:
    """States of signals that do not decay, such as a sum of errors, whatever their inputs depend on.

    Parameters
    ----------
    system, state
        The system and the state to evaluate.
    """
    found = signal_states(system)
    if not found.size:
        return found
    return found[_undetermined(slopes(without_limits(system), state, EXACT)[np.ix_(found, found)])]


def _undetermined(rates: Array) -> NDArray[np.bool_]:
    """Flags of the states without a rate of their own that take part in the null space of their rates."""
    sizes = np.abs(rates).max(axis=1, initial=0.0)
    _, values, basis = np.linalg.svd(rates / np.where(sizes > 0.0, sizes, 1.0)[:, None])
    null = basis[np.sum(values > ALIKE * values.max(initial=0.0)) :]
    part = np.abs(null).max(axis=0, initial=0.0) > ALIKE
    return np.asarray(part & (np.abs(np.diag(rates)) <= ALIKE * sizes))


def without_limits(system: System) -> System:
    """Copy of the system without signal limits."""
    kind = system.kinds(SIGNAL)[0]
    records = system.records[kind].copy()
    kept = records["op"] == SATURATION
    records["low"][kept], records["high"][kept] = -np.inf, np.inf
    return system.with_params({kind: records}) if kept.any() else system


def without_rate_limits(system: System) -> System:
    """The system, or a copy without the limits of rates: in equilibrium all rates are zero.

    A rate at its limit does not change with the state, so Newton's method would not find the state.
    """
    for kind in system.kinds(SIGNAL):
        names = system.names.get(kind, ())
        limited = np.array([name.endswith(LIMITED) for name in names], bool)
        if limited.any():
            records = system.records[kind].copy()
            records["low"][limited], records["high"][limited] = -np.inf, np.inf
            return system.with_params({kind: records})
    return system


def step_on(system: System, state: State, free: NDArray[np.int64], step: NDArray[np.float64]) -> State:
    """Copy of a state after a step of the free coordinates; for element states the rates change."""
    found = state.copy()
    states = system.states
    if not states.size:
        found.q[free] += step
        return found
    holds = np.isin(free, states)
    found.q[free[~holds]] += step[~holds]
    found.v[free[holds]] += step[holds]
    return found


def wrapped(system: System, state: State) -> State:
    """Wrap every spin angle of a state into (-pi, pi] and whole turns; changes and returns the state."""
    for b in range(1, len(system.layout.bodies)):
        spin = int(system.program["body"][b]["spin"])
        if spin >= 0:
            turns = int(np.floor(state.q[spin] / (2.0 * np.pi) + 0.5))
            if turns:
                state.q[spin] -= 2.0 * np.pi * turns
                state.turns[b] += turns
    return state


def extents(system: System) -> Array:
    """Size of every coordinate whose rounding error it has at least, shape (nd,).

    Angles have the error of one radian, positions that of the largest distance of a body from the origin of
    the world as drawn, at least 1 m: the forces of stiff parts of a tall machine have the error of stiffness
    times distance.

    Parameters
    ----------
    system
        The system.
    """
    bodies = system.program["body"]
    distance = np.zeros(len(bodies))
    for b in range(1, len(bodies)):
        distance[b] = distance[bodies["parent"][b]] + float(np.linalg.norm(bodies["pos"][b]))
    return np.where(system.weight == 1.0, max(1.0, distance.max(initial=0.0)), 1.0)
