# SPDX-License-Identifier: Apache-2.0
"""Motion without dynamics: drives and loops decide where everything is; forces follow from the motion.

At every time the loops are closed with the drives where they are, rates and accelerations follow from the
derivatives of the rows, and the multipliers from the equations of motion: the observations of drives and
cut joints are what an inverse dynamics wants to know.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.kernel import plain
from pitchpoint.core.status import INCONSISTENT, OK
from pitchpoint.solvers.constraints.assembly import assemble_state
from pitchpoint.solvers.sampling import Chunk, accumulate
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]


def moved_to(system: System, state: State, t: float) -> State:
    """The state of a driven mechanism at a time, near another one, with accelerations and multipliers.

    Parameters
    ----------
    system
        The system; its constraints must leave no freedom.
    state
        A state nearby.
    t
        Time [s].

    Raises
    ------
    SolverError
        If something is left free, or the drives lead where loops cannot follow.
    """
    guess = state.copy()
    # along the motion so far, so that a mechanism with two ways to close keeps to its own
    step = t - state.t
    guess.t = t
    guess.q += step * state.v + 0.5 * step**2 * state.a
    guess.v += step * state.a
    found = assemble_state(system, guess)
    if found.freedoms > 0:
        raise SolverError(f"{_loose(system, found.state)}: prescribe their motion as well", INCONSISTENT)
    evaluate.prepare(system)
    evaluate.load(system, found.state)
    evaluate.check(system, evaluate.accelerations(system, t), found.state)
    return evaluate.store(system, t)


def _loose(system: System, state: State) -> str:
    """What the constraints leave free, in words."""
    G = evaluate.constraint_jacobian(system, state) / system.weight
    _, sizes, rows = np.linalg.svd(G)
    null = rows[int(np.sum(sizes > 1e-9 * sizes.max(initial=0.0))) :]
    share = (null**2).sum(axis=0)
    named = [system.layout.coordinates[k] for k in np.flatnonzero(share > 0.5 * share.max(initial=0.0))]
    count = f"{len(null)} degree{'s' if len(null) > 1 else ''} of freedom"
    return f"drives and loops leave {count}, with {', '.join(named)}"


class KinematicRun:
    """Times of a driven mechanism under way, with the face of an integration.

    Parameters
    ----------
    system, state
        What moves and from where; drives and loops must leave no freedom.
    h
        Distance of the times [s].
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
        statistics: Array | None = None,
        stride: int = 1,
        events: int = 0,
    ) -> Chunk:
        """Go n steps on, or fewer if the mechanism cannot follow; events are not looked for.

        Parameters
        ----------
        every, statistics, stride
            As of `generalized_alpha.Run.advance`.
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
                plain(accumulate)(row, statistics)
            if every and self.steps % every == 0:
                rows.append(np.concatenate([[self.here.t], row]))
        width = self.system.sizes["no"] + 1
        return Chunk(status, n, np.array(rows).reshape(-1, width), np.zeros((0, 3)))

    def change_step(self, h: float) -> None:
        """Continue with another step from here."""
        self.t0, self.steps, self.h = self.t, 0, h

    def state(self) -> State:
        """Copy of the state reached."""
        return self.here.copy()
