# SPDX-License-Identifier: Apache-2.0
"""Kinematic analysis with inverse dynamics: drives and loops determine the motion; forces follow from it.

At every time the loops are closed for the given drives. Rates and accelerations follow from the derivatives
of the constraint rows, and the multipliers from the equations of motion: the drive torques and the reactions
of cut joints.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.kernel import plain
from pitchpoint.core.status import INCONSISTENT, OK
from pitchpoint.solvers.constraints.assembly import assemble_state
from pitchpoint.solvers.sampling import Accumulators, Chunk, accumulate
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]


def moved_to(system: System, state: State, t: float) -> State:
    """State of a driven mechanism at time t, with accelerations and multipliers, from a nearby state.

    Parameters
    ----------
    system
        The system; its constraints must leave no degree of freedom.
    state
        A nearby state.
    t
        Time [s].

    Raises
    ------
    SolverError
        If a degree of freedom is left, or the loops cannot close for the given drives.
    """
    guess = state.copy()
    # extrapolate the motion, to stay in the same assembly configuration
    step = t - state.t
    guess.t = t
    guess.q += step * state.v + 0.5 * step**2 * state.a
    guess.v += step * state.a
    found = assemble_state(system, guess)
    if found.freedoms > 0:
        raise SolverError(f"{_loose(system, found.state)}: prescribe its motion, too", INCONSISTENT)
    evaluate.prepare(system)
    evaluate.load(system, found.state)
    evaluate.check(system, evaluate.accelerations(system, t), found.state)
    return evaluate.store(system, t)


def _loose(system: System, state: State) -> str:
    """Sentence on the degrees of freedom left by the constraints."""
    G = evaluate.constraint_jacobian(system, state) / system.weight
    _, sizes, rows = np.linalg.svd(G)
    null = rows[int(np.sum(sizes > 1e-9 * sizes.max(initial=0.0))) :]
    share = (null**2).sum(axis=0)
    named = [system.layout.coordinates[k] for k in np.flatnonzero(share > 0.5 * share.max(initial=0.0))]
    count = f"{len(null)} degree{'s' if len(null) > 1 else ''} of freedom"
    return f"drives and loops leave {count}, with {', '.join(named)}"


class KinematicRun:
    """Running kinematic analysis, with the interface of an integration.

    Parameters
    ----------
    system, state
        The system and its initial state; drives and loops must leave no degree of freedom.
    h
        Time step [s].
    """

    def __init__(self, system: System, state: State, h: float) -> None:
        self.system, self.h, self.t0, self.steps = system, h, state.t, 0
        self.here = moved_to(system, state, state.t)

    @property
    def t(self) -> float:
        """Time reached [s]."""
        return self.t0 + self.steps * self.h

    def advance(
        self,
        n: int,
        *,
        every: int = 0,
        statistics: Accumulators | None = None,
        stride: int = 1,
        events: int = 0,
    ) -> Chunk:
        """Take n steps, or fewer if the loops cannot close; events are not detected.

        Parameters
        ----------
        every, statistics, stride
            As in `generalized_alpha.Run.advance`; impacts are not counted, since there are no forces.
        """
        rows: list[Array] = []
        status = OK
        for done in range(n):
            try:
                self.here = moved_to(self.system, self.here, self.t0 + (self.steps + 1) * self.h)
            except SolverError as failure:
                status, n = failure.status, done
                break
            self.steps += 1
            row = evaluate.observe(self.system, self.here)
            if statistics is not None and self.steps % stride == 0:
                plain(accumulate)(row, statistics.sums)
            if every and self.steps % every == 0:
                rows.append(np.concatenate([[self.here.t], row]))
        width = self.system.sizes["no"] + 1
        return Chunk(status, n, np.array(rows).reshape(-1, width), np.zeros((0, 3)))

    def change_step(self, h: float) -> None:
        """Change the step from the present time on."""
        self.t0, self.steps, self.h = self.t, 0, h

    def state(self) -> State:
        """Copy of the state reached."""
        return self.here.copy()
