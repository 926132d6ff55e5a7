# SPDX-License-Identifier: Apache-2.0
"""What is unknown at rest: places of bodies, and the states of elements, which stand among the rates."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System


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


def step_on(system: System, state: State, free: NDArray[np.int64], step: NDArray[np.float64]) -> State:
    """The state with some coordinates moved; those that hold states change their rates."""
    found = state.copy()
    holds = np.isin(free, system.states)
    found.q[free[~holds]] += step[~holds]
    found.v[free[holds]] += step[holds]
    return found
