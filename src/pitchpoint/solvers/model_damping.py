# SPDX-License-Identifier: Apache-2.0
"""Rayleigh and modal damping of a model: one matrix about the initial state of a run.

Both damp vibrations only: motions in the free directions of the constraints with driven coordinates at rest.
The rigid motion of the machine (rotation of free trains, and motion that follows a drive) is projected out,
so that damping does not brake the rotation at any speed.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.damping import KIND
from pitchpoint.solvers.constraints.free_directions import free_directions
from pitchpoint.solvers.eigen import symmetric, undamped
from pitchpoint.solvers.element_tangents import without_friction, without_loads
from pitchpoint.solvers.equilibrium.closed_loops import is_looped
from pitchpoint.solvers.gear_trains import (
    driven_coordinates,
    driven_rotations,
    rates_through_loops,
    rigid_rotations,
)
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System

if TYPE_CHECKING:
    from pitchpoint.model.components.damping import Damping

Array = NDArray[np.float64]


def with_damping(system: System, state: State) -> System:
    """Copy of the system with the Rayleigh and modal damping about the initial state in its records.

    Loads are excluded from the stiffness: loads that depend on the angle or the speed would make the damping
    brake or drive the rotation.
    """
    if KIND.name not in system.records or system.model is None or system.model.damping is None:
        return system
    stopped = state.copy()
    stopped.v[:] = 0.0
    D = _matrix(without_loads(without_friction(system)), stopped, system.model.damping)
    records = system.records[KIND.name].copy()
    for record in records:
        i, j, n, m = (int(record[k]) for k in ("dof_i", "dof_j", "n_i", "n_j"))
        record["D"][:n, :m] = D[i : i + n, j : j + m]
    return system.with_params({KIND.name: records})


def _matrix(system: System, stopped: State, given: Damping) -> Array:
    """Damping matrix at a state with zero speeds, shape (nd, nd)."""
    M, _, K = evaluate.linearize(system, stopped)
    basis = free_directions(system, stopped, tuple(int(s) for s in system.states))
    basis = basis if isinstance(basis, np.ndarray) else basis.toarray()
    rigid = rigid_rotations(system)
    D = np.zeros_like(M)
    if given.rayleigh is not None:
        D += given.rayleigh.mass * symmetric(M)
    if given.modal is not None and basis.shape[1]:
        D += modal_damping(M, K, basis, rigid, given.modal)
    vibrates = _vibrating_part(symmetric(M), rigid.T, _following(system, stopped, K, basis))
    D = vibrates.T @ D @ vibrates
    if given.rayleigh is not None:
        D += given.rayleigh.stiffness * K
    return np.asarray(D)


def modal_damping(M: Array, K: Array, basis: Array, rigid: Array, ratio: float) -> Array:
    """Damping matrix that gives every elastic mode the same damping ratio: D = sum 2 ratio omega M x x^T M.

    Parameters
    ----------
    M, K
        Mass and stiffness matrix, shape (nd, nd); only their symmetric parts are used.
    basis
        Columns that span the free directions, shape (nd, n).
    rigid
        Free rigid rotations, shape (r, nd); they are not damped.
    ratio
        Damping ratio of every mode [-].

    Raises
    ------
    SolverError
        If a free direction has no mass.

    References
    ----------
    .. [1] R. W. Clough, J. Penzien: Dynamics of Structures, 3rd ed., section 12-5.

    Examples
    --------
    >>> modal_damping(np.eye(1), np.array([[4.0]]), np.eye(1), np.zeros((0, 1)), 0.25)
    array([[1.]])
    """
    omega, shapes = undamped(M, K, basis, rigid)
    left = symmetric(M) @ shapes.T
    return np.asarray((left * (2.0 * ratio * np.maximum(omega, 0.0))) @ left.T)


def _following(system: System, stopped: State, K: Array, basis: Array) -> dict[int, Array]:
    """Rates of all coordinates for one driven coordinate at 1 m/s or 1 rad/s with the other drives at rest.

    Trains rotate in their tooth ratios; other bodies follow with minimum strain energy.
    """
    driven = driven_coordinates(system)
    if not is_looped(system) and all(c in system.program["body"]["spin"] for c in driven):
        return driven_rotations(system)
    motions, left = {}, basis.T @ symmetric(K)
    loose = np.linalg.pinv(left @ basis, hermitian=True)
    for place in driven:
        unit = stopped.copy()
        unit.v[place] = 1.0
        rates = rates_through_loops(system, unit, driven)
        motions[place] = rates - basis @ (loose @ (left @ rates))
    return motions


def _vibrating_part(M: Array, free: Array, following: dict[int, Array]) -> Array:
    """Projection that removes the rigid motion of the machine from rates, shape (nd, nd).

    Parameters
    ----------
    M
        Mass matrix, shape (nd, nd); vibrations have no momentum along free rotations.
    free
        Free rotations without drive, shape (nd, r).
    following
        Rates that follow each driven coordinate.
    """
    found = np.eye(len(M))
    for place, rates in following.items():
        found[:, place] -= rates
    if free.shape[1]:
        found -= free @ np.linalg.solve(free.T @ M @ free, free.T @ M @ found)
    return found
