# SPDX-License-Identifier: Apache-2.0
"""Explicit integration of a system with `explicit.equal_steps` and `explicit.dormand_prince`.

Constraints are enforced at acceleration level with Baumgarte stabilisation against drift.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.solvers.constraints.row_notes import rows_agree
from pitchpoint.solvers.explicit.coefficients import EIGHTH, FIFTH, Pair
from pitchpoint.solvers.explicit.derivative import SLOPE_AT
from pitchpoint.solvers.explicit.dormand_prince import (
    LARGEST,
    LAST_ERROR,
    RATE,
    STEP_SIZE,
    TIME,
    adaptive_order,
)
from pitchpoint.solvers.explicit.dormand_prince import entry as adaptive_entry
from pitchpoint.solvers.explicit.equal_steps import ADAMS, CLASSICAL, ORDER, PAST, entry
from pitchpoint.solvers.sampling import Accumulators, Chunk, advance_into, new_recorder
from pitchpoint.system import evaluate
from pitchpoint.system.link import heard
from pitchpoint.system.system import State, System
from pitchpoint.system.workspace import VALID


@dataclass
class ExplicitRun:
    """Running explicit integration. Created by `start_classical`, `start_adams` or `start_adaptive`.

    Parameters
    ----------
    system
        The system; its workspace contains the state.
    h
        Step [s] of a fixed-step method; 0 for the adaptive one.
    tolerances
        rtol [-], atol [m], atol_rate [m/s], Baumgarte rate [1/s], largest step [s].
    pair
        Coefficients of the adaptive method.
    counts
        Flags of `watch`; empty: all events count.
    method
        Code of the fixed-step method.
    """

    system: System
    h: float
    tolerances: NDArray[np.float64]
    t0: float = 0.0
    steps: int = 0
    t: float = 0.0
    pair: Pair = FIFTH
    counts: NDArray[np.int64] = field(default_factory=lambda: np.zeros(0, np.int64))
    method: int = CLASSICAL

    @property
    def longest(self) -> float:
        """Longest step of the adaptive method [s]."""
        return float(self.tolerances[LARGEST])

    def advance(
        self,
        n: int,
        *,
        every: int = 0,
        statistics: Accumulators | None = None,
        stride: int = 1,
        events: int = 0,
        picked: NDArray[np.int64] | None = None,
    ) -> Chunk:
        """Take n fixed steps; arguments as in `generalized_alpha.Run.advance`.

        Samples contain the channels `picked`, or all channels if none are picked.
        """
        room = n // every + 1 if every else 0
        recorder = new_recorder(
            self.system.sizes["no"],
            every=every,
            stride=stride,
            rows=room,
            sums=statistics,
            events=events,
            picked=picked,
        )
        order = self.order(n)
        asked = picked if statistics is None else None
        with heard(self.system.workspace, self.system.records, asked):
            done = advance_into(entry, self.system.workspace.at, order, recorder)
        self.steps += done.steps
        self.t = self.t0 + self.steps * self.h
        return self._checked(done)

    def order(self, n: int) -> NDArray[np.void]:
        """Arguments of the compiled loop for n fixed steps, shape (1,)."""
        return np.array([(self.t0, self.h, self.tolerances[RATE], self.steps, n, self.method)], ORDER)

    def change_step(self, h: float) -> None:
        """Change the step from the present time on."""
        self.t0, self.steps, self.h = self.t, 0, h
        self.system.workspace.arrays["real"][PAST] = 0.0  # the history is spaced at the old step

    def watch(self, functions: NDArray[np.int64]) -> None:
        """Restrict the events of the adaptive method to the flagged functions, shape (ne,); default all."""
        self.counts = functions

    def advance_to(
        self,
        t_end: float,
        *,
        sample: float = 0.0,
        statistics: Accumulators | None = None,
        events: int = 0,
        restart: bool = False,
        most: int = 1_000_000_000,
    ) -> Chunk:
        """Integrate to a time with step control.

        Parameters
        ----------
        sample
            Sample period [s], from the start of the run; statistics are updated at the same times.
        events
            Maximum number of events to record; their times are located on the dense output.
        restart
            Start a new step at every event.
        most
            Maximum number of steps of this call; `t` is the time reached.
        """
        reach = min(t_end - self.t, most * float(self.tolerances[LARGEST]))
        room = int(reach / sample) + 2 if sample > 0.0 else 0
        recorder = new_recorder(self.system.sizes["no"], rows=room, sums=statistics, events=events)
        w = self.system.workspace
        w.clock[VALID] = 0
        times = (self.t, float(t_end), self.t0, sample)
        ends = (restart, self.counts.ctypes.data if len(self.counts) else 0)
        order = adaptive_order(times, self.pair, self.tolerances, most, ends)
        done = advance_into(adaptive_entry, w.at, order, recorder)
        self.t = float(w.arrays["real"][TIME])
        self.steps += done.steps
        return self._checked(done)

    def _checked(self, done: Chunk) -> Chunk:
        """The chunk, with status INCONSISTENT if a redundant constraint row contradicts the others."""
        return replace(done, status=rows_agree(self.system, self.t)) if done.status == OK else done

    def state(self) -> State:
        """Copy of the state reached."""
        return evaluate.store(self.system, self.t)


def _start(system: System, state: State, rate: float) -> None:
    evaluate.prepare(system)
    evaluate.load(system, state)
    w = system.workspace
    w.clock[:] = 0
    w.arrays["real"][:] = 0.0
    w.arrays["real"][SLOPE_AT] = math.nan
    w.ctl[0]["bad"] = w.ctl[0]["badkind"] = -1
    evaluate.check(system, evaluate.accelerations(system, state.t, rate), state)
    if system.sizes["ne"]:
        evaluate.check(system, evaluate.fill_events(system, state.t, w.arrays["ev0"]), state)


def start_classical(system: System, state: State, h: float, *, rate: float = 200.0) -> ExplicitRun:
    """Start a run of the classical fourth-order Runge-Kutta method; parameters as in `start_adams`."""
    return _start_equal(system, state, h, rate, CLASSICAL)


def start_adams(system: System, state: State, h: float, *, rate: float = 200.0) -> ExplicitRun:
    """Start a run of the fourth-order Adams method, with one force evaluation per step.

    The first two steps, and two after every jump of the forces by a controller, are Runge-Kutta steps.

    Parameters
    ----------
    system, state
        The system and its initial state.
    h
        Step [s], > 0. Stability limit: 1.4 / omega_max [rad/s] without damping, 0.9 / omega_max with a
        damping ratio of 0.1.
    rate
        Baumgarte rate of the constraint stabilisation [1/s].
    """
    return _start_equal(system, state, h, rate, ADAMS)


def _start_equal(system: System, state: State, h: float, rate: float, method: int) -> ExplicitRun:
    if not (h > 0.0 and math.isfinite(h)):
        raise SolverError(f"the step must be positive and finite, not {h!r}", NOT_FINITE)
    _start(system, state, rate)
    tolerances = np.array([0.0, 0.0, 0.0, rate, math.inf])
    return ExplicitRun(system, h, tolerances, state.t, 0, state.t, method=method)


def start_adaptive(
    system: System,
    state: State,
    *,
    rtol: float = 1e-7,
    atol: float = 1e-11,
    atol_rate: float = 1e-7,
    first_step: float = 1e-7,
    largest_step: float = math.inf,
    rate: float = 200.0,
    order: int | None = None,
) -> ExplicitRun:
    """Start a run of Dormand-Prince 5(4) or 8(5,3) with step control.

    Parameters
    ----------
    system, state
        The system and its initial state.
    rtol
        Relative tolerance of rates and displacements (not of spins).
    atol, atol_rate
        Absolute tolerances as lengths [m] and velocities [m/s]; angles are scaled by the system weights.
    first_step
        First trial step [s].
    largest_step
        Longest step [s]: a load pulse within one step, or two events of one function, may be missed.
    rate
        Baumgarte rate of the constraint stabilisation [1/s].
    order
        5 or 8; default 8 for rtol up to 1e-7, where it needs half the evaluations.
    """
    _start(system, state, rate)
    system.workspace.arrays["real"][STEP_SIZE] = first_step
    system.workspace.arrays["real"][LAST_ERROR] = 1e-4
    pair = EIGHTH if order == 8 or (order is None and rtol <= 1e-7) else FIFTH
    tolerances = np.array([rtol, atol, atol_rate, rate, largest_step])
    return ExplicitRun(system, 0.0, tolerances, state.t, 0, state.t, pair)
