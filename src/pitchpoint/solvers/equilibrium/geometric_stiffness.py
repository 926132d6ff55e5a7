# SPDX-License-Identifier: Apache-2.0
"""Tangents at rest of bodies that swing far: weight and loads that turn with their joints count as well.

Tangents of integrators leave them out, which is cheap and does no harm where bodies stay nearly where they
are. A pendulum has no stiffness but this one: without it each step goes down the slope of its energy, and a
chain of ten takes hundreds of them.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.multibody.bodies import GENERAL
from pitchpoint.solvers.equilibrium.unknowns import rest_matrix
from pitchpoint.system.residual import EXACT, NEWTON
from pitchpoint.system.system import State, System

FAR, PATIENCE = 0.1, 30
"""Turn of a joint [rad] and steps from which on exact tangents are worth their cost."""


class Tangent:
    """Derivative of what acts at rest, of the kind that suits the way so far.

    Parameters
    ----------
    system
        The system.
    begin
        State that the search begins with.

    Attributes
    ----------
    joints
        Coordinates about which bodies may swing; none where elements have states of their own, or the joints
        turn with a speed that is kept: forces that follow it have no energy behind them.
    exact
        Whether the last matrix holds what turns with the joints.
    """

    def __init__(self, system: System, begin: State) -> None:
        self.system = system
        joints = turning_joints(system)
        self.joints = joints[:0] if system.states.size or begin.v[joints].any() else joints
        self.exact = False
        self._begin = begin.q.copy()
        self._state: State | None = None
        self._matrix: Any = None

    def at(self, state: State, count: int) -> Any:
        """Matrix at a state after some steps; the same again where a step was refused and changed nothing."""
        if state is not self._state:
            way = np.abs((state.q - self._begin)[self.joints]).max(initial=0.0)
            self.exact = bool(self.joints.size) and (count >= PATIENCE or way > FAR)
            self._matrix = rest_matrix(self.system, state, EXACT if self.exact else NEWTON, None)
            self._state = state
        return self._matrix

    def refuse(self) -> None:
        """Use no exact tangents any more."""
        self.joints = self.joints[:0]
        self._state = None


def turning_joints(system: System) -> NDArray[np.int64]:
    """Coordinates of joints about which bodies swing far, as pendulums do: all but those of round bodies."""
    found = []
    for b, body in enumerate(system.bodies, start=1):
        record = system.program["body"][b]
        if record["joint"] == GENERAL and not body.state:
            first = int(record["dof"])
            found += [first + k for k, (_, unit) in enumerate(body.coordinates) if unit == "rad"]
    return np.array(found, np.int64)


def resists(A: Any) -> bool:
    """Whether every step of a matrix goes down: whether its symmetric part is positive definite."""
    dense = A if isinstance(A, np.ndarray) else A.toarray()
    try:
        np.linalg.cholesky(0.5 * (dense + dense.T))
    except np.linalg.LinAlgError:
        return False
    return True
