# SPDX-License-Identifier: Apache-2.0
"""Geometric stiffness of bodies with large joint rotations: weight, and loads that rotate with their joints.

Integrators neglect it in their tangents, which is cheap and harmless for small motions. A pendulum has no
other stiffness: without it the iteration is a gradient descent, and a chain of ten pendulums needs hundreds
of steps.
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
"""Joint rotation [rad], and number of steps, from which exact tangents are used."""


class Tangent:
    """Tangent stiffness of the equilibrium, with geometric stiffness after large joint rotations.

    Parameters
    ----------
    system
        The system.
    begin
        Initial state of the iteration.

    Attributes
    ----------
    joints
        Rotation coordinates of the joints; empty if elements have states, or if the joints rotate at a given
        speed: speed-dependent forces do not derive from an energy.
    exact
        Whether the last matrix includes the geometric stiffness.
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
        """Matrix at a state after `count` steps; reused if the last step was rejected."""
        if state is not self._state:
            rotation = np.abs((state.q - self._begin)[self.joints]).max(initial=0.0)
            self.exact = bool(self.joints.size) and (count >= PATIENCE or rotation > FAR)
            self._matrix = rest_matrix(self.system, state, EXACT if self.exact else NEWTON, None)
            self._state = state
        return self._matrix

    def refuse(self) -> None:
        """Disable exact tangents."""
        self.joints = self.joints[:0]
        self._state = None


def turning_joints(system: System) -> NDArray[np.int64]:
    """Rotation coordinates of joints that allow large rotations, as of pendulums; not those of rotors."""
    found = []
    for b, body in enumerate(system.bodies, start=1):
        record = system.program["body"][b]
        if record["joint"] == GENERAL and not body.state:
            first = int(record["dof"])
            found += [first + k for k, (_, unit) in enumerate(body.coordinates) if unit == "rad"]
    return np.array(found, np.int64)


def resists(A: Any) -> bool:
    """Whether the symmetric part of a matrix is positive definite, so that steps reduce the energy."""
    dense = A if isinstance(A, np.ndarray) else A.toarray()
    try:
        np.linalg.cholesky(0.5 * (dense + dense.T))
    except np.linalg.LinAlgError:
        return False
    return True
