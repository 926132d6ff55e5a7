# SPDX-License-Identifier: Apache-2.0
"""Equilibrium of a mechanism with closed loops, in the free directions of its constraints.

Each step solves Z^T (K + M/tau^2) Z y = -Z^T R in a basis Z of the free directions, closes the loops again
and determines the multipliers by least squares; K includes the geometric stiffness of loads and reactions.
With a short pseudo-time tau the bodies move along their loads; with a growing tau the step becomes a Newton
step (see `equilibrium.solve`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import DIVERGED, SINGULAR
from pitchpoint.solvers.constraints.assembly import REDUNDANT, close_loops, loop_rows
from pitchpoint.solvers.equilibrium.approach import Contacts
from pitchpoint.solvers.equilibrium.unknowns import (
    FACTORISED,
    GROWTH,
    ROUNDING,
    SOFTENING,
    extents,
    factorised,
    slopes,
)
from pitchpoint.system import evaluate
from pitchpoint.system.residual import EXACT
from pitchpoint.system.source import coordinate_source
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

MAX_STEPS = 300
FIRST = 1e2
"""Mass factor 1/tau^2 of the first step [1/s^2]."""
LONGEST = 0.3
"""Largest step of a coordinate [rad], of displacements over the size of the machine or 1 m."""
LEFT_OVER = 1e-13
"""Relative rounding error of the balance of forces."""


@dataclass(frozen=True)
class MechanismRest:
    """A mechanism in equilibrium.

    Parameters
    ----------
    state
        The state with its multipliers.
    residual
        Residual of every coordinate, shape (nd,); the reactions on the held ones.
    steps
        Number of steps.
    """

    state: State
    residual: Array
    steps: int


def is_looped(system: System) -> bool:
    """Whether the system has constraint rows other than prescribed motions."""
    return bool(loop_rows(system))


def rest_of_mechanism(system: System, state: State, kept: tuple[int, ...], tolerance: float) -> MechanismRest:
    """Find the equilibrium near an initial state.

    Parameters
    ----------
    system
        The system; rows of drives are omitted, their coordinates are held.
    state
        Initial state; its rates are retained and define the friction.
    kept
        Coordinates to hold.
    tolerance
        Largest residual, relative to the loads.

    Raises
    ------
    SolverError
        If loops do not close or no equilibrium is found.
    """
    free = np.setdiff1d(np.arange(system.sizes["nd"]), kept)
    holds = loop_rows(system)
    here, contacts = _closed(system, state, kept, drawn=True), Contacts.of(system)
    undeflected = replace(system.initial_state(), v=state.v.copy())
    loads = float(np.abs(evaluate.residual(system, undeflected)[free]).max(initial=0.0))
    mu, far = FIRST, extents(system)
    for count in range(MAX_STEPS):
        G, R, acting = _balanced(system, here, free, holds)
        Z = _directions(G[:, free], system.weight[free])
        left = Z.T @ R[free]
        whole = slopes(system, here, EXACT)
        # the force error of rounded positions limits the residual
        rounded = ROUNDING * (np.abs(whole) @ (np.abs(here.q) + far))
        least = np.maximum(rounded[free], LEFT_OVER * acting[free].max(initial=0.0))
        goal = np.abs(Z).T @ np.maximum(tolerance * acting[free], least)
        if np.all(np.abs(left) <= goal):
            return MechanismRest(here, R, count)
        K = Z.T @ whole[np.ix_(free, free)] @ Z
        M = Z.T @ evaluate.matrix(system, here, 1.0, 0.0, 0.0)[np.ix_(free, free)] @ Z
        inverse = _inverse(K + mu * M, M)
        y = -inverse(left)
        size = float(np.abs(Z @ y / far[free]).max(initial=0.0))
        part = min(1.0, LONGEST / size if size > 0.0 else 1.0)
        try:
            trial = contacts.step_on(system, here, free, Z @ y * part)
            trial = _closed(system, trial, kept)
            H, S, _ = _balanced(system, trial, free, holds)
        except SolverError:
            mu *= 8.0
            continue
        after = _directions(H[:, free], system.weight[free])
        # in the directions of the present step, orthonormal in the weights
        next_left = Z.T @ (system.weight[free] ** 2 * (after @ (after.T @ S[free])))
        ratio = float(np.linalg.norm(inverse(next_left))) / max(float(np.linalg.norm(y)), 1e-300)
        # a signal that changes a force without a reaction makes the next step longer
        softens = float(np.abs(next_left).max(initial=0.0)) <= loads
        growth = SOFTENING if softens else GROWTH
        if ratio < 1.0 or (ratio <= growth and float(next_left @ y) <= 0.0):
            here = trial
            mu = max(mu * (0.1 if ratio < 0.5 else 0.5), 0.0 if mu < 1e-9 else 1e-12)
        elif mu > 1e12:
            break
        else:
            mu *= 8.0
    worst = int(free[np.argmax(np.abs(Z @ left))])
    unit = "N m" if system.weight[worst] != 1.0 else "N"
    where = coordinate_source(system, system.layout.coordinates[worst])
    raise SolverError(
        f"no equilibrium found after {count} steps: {np.abs(left).max():.3g} {unit} are unbalanced on "
        f"{where}; check loads, springs and supports of the mechanism",
        SINGULAR if mu < 1.0 else DIVERGED,
        here,
    )


def _closed(system: System, state: State, kept: tuple[int, ...], drawn: bool = False) -> State:
    """Copy of a state with closed loops; its rates are unchanged."""
    stopped = state.copy()
    stopped.v[:] = 0.0
    stopped.v[system.states] = state.v[system.states]
    found = close_loops(system, stopped, kept, drawn=drawn)
    found.v[:] = state.v
    return found


def _balanced(
    system: System, state: State, free: NDArray[np.int64], holds: list[int]
) -> tuple[Array, Array, Array]:
    """Constraint rows, residual with least-squares multipliers, and the sum of the force magnitudes."""
    state.lam[:] = 0.0
    R = evaluate.residual(system, state)
    G = system.workspace.G[holds].copy()
    scaled = (G / system.weight)[:, free]
    lam = -np.linalg.lstsq(scaled.T, (R / system.weight)[free], rcond=REDUNDANT)[0]
    state.lam[holds] = lam
    acting = np.abs(R) + np.abs(G).T @ np.abs(lam)
    return G, evaluate.residual(system, state), acting


def _directions(G: Array, weight: Array) -> Array:
    """Orthonormal columns (in the weights of the coordinates) that span the null space of the rows."""
    _, sizes, rows = np.linalg.svd(G / weight)
    rank = int(np.sum(sizes > REDUNDANT * sizes.max(initial=0.0)))
    return np.asarray((rows[rank:] / weight).T)


def _inverse(A: Array, mass: Array) -> Callable[[Array], Array]:
    """Function that solves A x = b; components in singular directions are zero. `mass` gives the scale."""
    root = np.sqrt(np.maximum(np.diag(mass), 0.0))
    root = np.where(root > 0.0, root, 1.0)
    solve = factorised(A / np.outer(root, root), root) if len(root) >= FACTORISED else None
    if solve is not None:
        return solve
    inverse = np.linalg.pinv(A)
    return lambda b: np.asarray(inverse @ b)
