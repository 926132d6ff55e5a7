# SPDX-License-Identifier: Apache-2.0
"""What is unknown at rest: places of bodies, and the states of elements, which stand among the rates."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.signal_record import SATURATION
from pitchpoint.system import evaluate
from pitchpoint.system.residual import EXACT
from pitchpoint.system.system import State, System

STATE = "state."
"""How the names of the hidden bodies of signals begin."""
SLIGHT = 1e-3
"""Influence of a place on the rate of a state, over that of the speeds, up to which it is none: the axis of a
shaft that bends is sensed a little askew."""


def slopes(system: System, state: State, jac: int) -> NDArray[np.float64]:
    """Derivative of the residual at rest by places and states, shape (nd, nd).

    Parameters
    ----------
    system, state
        Where.
    jac
        `residual.NEWTON` or `residual.EXACT`.
    """
    found = evaluate.matrix(system, state, 0.0, 0.0, 1.0, jac)
    if system.states.size:
        rates = evaluate.matrix(system, state, 0.0, 1.0, 0.0, jac)
        found[:, system.states] = rates[:, system.states]
    return found


def signal_states(system: System) -> NDArray[np.int64]:
    """Coordinates whose rates are states of signals: those of filters, integrals, transfer functions."""
    found = [k for k in system.states if system.layout.coordinates[int(k)].startswith(STATE)]
    return np.array(found, np.int64)


def restless(system: System, state: State, free: NDArray[np.int64]) -> NDArray[np.int64]:
    """States of signals whose rates nothing that is free has a say in, such as the integral of a speed error.

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
    kind = next(kind for kind in ("signal", "signal_of_loads") if kind in system.records)
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
