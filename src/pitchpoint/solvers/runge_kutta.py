# SPDX-License-Identifier: Apache-2.0
"""Explicit runs on the same residual: the classical fourth-order method, and `dormand_prince`.

Constraint rows are kept on the level of accelerations; their drift is pulled back (Baumgarte).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.solvers.dormand_prince import (
    LARGEST,
    LAST_ERROR,
    RATE,
    SLOPE_AT,
    STEP_SIZE,
    TIME,
    adaptive_order,
)
from pitchpoint.solvers.dormand_prince import entry as adaptive_entry
from pitchpoint.solvers.dormand_prince_pairs import EIGHTH, FIFTH, Pair
from pitchpoint.solvers.explicit import OLD, ROWS, bring_state, keep_state, slope
from pitchpoint.solvers.rows import rows_agree
from pitchpoint.solvers.sampling import (
    Chunk,
    advance_into,
    due,
    harvest_at,
    keep,
    new_harvest,
    record_events,
    take,
)
from pitchpoint.system import evaluate
from pitchpoint.system.link import heard
from pitchpoint.system.residual import ALL, SOONER, observe_later, wrap
from pitchpoint.system.system import State, System
from pitchpoint.system.workspace import MACH, STEPS, VALID


@kernel
def _classical(at, t, h, rate, known):
    """One step of the classical method; the state in the workspace becomes that at t + h.

    With `known` the first slope is there already.
    """
    c = view(at, 1, CTL)[0]
    nd = c["nd"]
    stage = view(view(c["mach"], 1, MACH)[0]["stage"], (ROWS, 2 * nd), F8)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    keep_state(at, OLD)
    for k in range(known, 4):
        share = 0.0 if k == 0 else 1.0 if k == 3 else 0.5
        if k > 0:
            for i in range(nd):
                q[i] = stage[OLD, i] + h * share * stage[k - 1, i]
                v[i] = stage[OLD, nd + i] + h * share * stage[k - 1, nd + i]
        status = slope(at, t + share * h, k, rate)
        if status != OK:
            return status
    w = h / 6.0
    for i in range(nd):
        e = nd + i
        q[i] = stage[OLD, i] + w * (stage[0, i] + 2.0 * (stage[1, i] + stage[2, i]) + stage[3, i])
        v[i] = stage[OLD, e] + w * (stage[0, e] + 2.0 * (stage[1, e] + stage[2, e]) + stage[3, e])
    return OK


@kernel(inline=True)
def advance_classical(at, t0, first, n, h, rate, harvest):
    """Take n equal steps; arguments as in `generalized_alpha.advance`, rate pulls constraint drift back.

    Where a row is due, elements say what they observe while their forces are summed for the first slope.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    clock = view(m["clock"], 16, I8)
    for k in range(1, n + 1):
        t = t0 + (first + k) * h
        status = _classical(at, t0 + (first + k - 1) * h, h, rate, 0 if k == 1 else 1)
        if status != OK:
            bring_state(at, OLD)
            return status
        wrap(at)
        clock[STEPS] += 1
        harvest.done[0] = k
        # the first slope of the next step: what is observed are the accelerations of this state
        measure, sample = due(first + k, harvest)
        shared = m["shares"] != 0 and (measure != 0 or sample != 0)
        if shared:
            c["out"] = m["row"]
            m["part"] = SOONER
        status = slope(at, t, 0, rate)
        c["out"] = 0
        m["part"] = ALL
        if status != OK:
            return status
        if shared:
            status = observe_later(at, t, m["row"])
            if status != OK:
                return status
            keep(at, t, harvest, measure, sample)
        elif measure != 0 or sample != 0:
            status = take(at, t, harvest, measure, sample)
            if status != OK:
                return status
        status = record_events(at, t, h, harvest)
        if status != OK:
            return status
    return OK


#: What `advance_classical` is told from Python, under the names of its arguments.
ORDER = np.dtype([("t0", "f8"), ("h", "f8"), ("rate", "f8"), ("first", "i8"), ("n", "i8")], align=True)


@kernel
def entry(at, order, harvest):
    """Take the steps of an ORDER; both are addresses of records."""
    o = view(order, 1, ORDER)[0]
    return advance_classical(at, o["t0"], o["first"], o["n"], o["h"], o["rate"], harvest_at(harvest))


@dataclass
class ExplicitRun:
    """An explicit integration under way. Made by `start_classical` or `start_adaptive`.

    Parameters
    ----------
    system
        The system; its workspace holds the state.
    h
        Step [s] of the classical method; 0 for the adaptive one.
    tolerances
        rtol [-], atol [m], atol_rate [m/s], rate at which constraint drift is pulled back [1/s], largest step
        [s].
    pair
        Coefficients of the adaptive method.
    counts
        Flags of `watch`; none: all events count.
    """

    system: System
    h: float
    tolerances: NDArray[np.float64]
    t0: float = 0.0
    steps: int = 0
    t: float = 0.0
    pair: Pair = FIFTH
    counts: NDArray[np.int64] = field(default_factory=lambda: np.zeros(0, np.int64))

    @property
    def longest(self) -> float:
        """Longest step of the adaptive method [s]."""
        return float(self.tolerances[LARGEST])

    def advance(
        self,
        n: int,
        *,
        every: int = 0,
        statistics: NDArray[np.float64] | None = None,
        stride: int = 1,
        events: int = 0,
        picked: NDArray[np.int64] | None = None,
    ) -> Chunk:
        """Take n steps of the classical method; arguments as in `generalized_alpha.Run.advance`.

        The samples hold the channels `picked` alone, if any are.
        """
        room = n // every + 1 if every else 0
        harvest = new_harvest(
            self.system.sizes["no"],
            every=every,
            stride=stride,
            rows=room,
            sums=statistics,
            events=events,
            picked=picked,
        )
        order = np.array([(self.t0, self.h, self.tolerances[RATE], self.steps, n)], ORDER)
        asked = picked if statistics is None else None
        with heard(self.system.workspace, self.system.records, asked):
            done = advance_into(entry, self.system.workspace.at, order, harvest)
        self.steps += done.steps
        self.t = self.t0 + self.steps * self.h
        return self._checked(done)

    def change_step(self, h: float) -> None:
        """Go on with another step of the classical method from here."""
        self.t0, self.steps, self.h = self.t, 0, h

    def watch(self, functions: NDArray[np.int64]) -> None:
        """Let events of the adaptive method count of functions with a flag only, shape (ne,).

        All count without it.
        """
        self.counts = functions

    def advance_to(
        self,
        t_end: float,
        *,
        sample: float = 0.0,
        statistics: NDArray[np.float64] | None = None,
        events: int = 0,
        restart: bool = False,
        most: int = 1_000_000_000,
    ) -> Chunk:
        """Go to a time with step control.

        Parameters
        ----------
        sample
            Distance of samples [s], counted from the start of the run; statistics are fed at the same times.
        events
            Most events to record; their times are located on the dense output.
        restart
            Begin a new step at every event.
        most
            Most steps of this call; `t` tells how far it got.
        """
        reach = min(t_end - self.t, most * float(self.tolerances[LARGEST]))
        room = int(reach / sample) + 2 if sample > 0.0 else 0
        harvest = new_harvest(self.system.sizes["no"], rows=room, sums=statistics, events=events)
        w = self.system.workspace
        w.clock[VALID] = 0
        times = (self.t, float(t_end), self.t0, sample)
        ends = (restart, self.counts.ctypes.data if len(self.counts) else 0)
        order = adaptive_order(times, self.pair, self.tolerances, most, ends)
        done = advance_into(adaptive_entry, w.at, order, harvest)
        self.t = float(w.arrays["real"][TIME])
        self.steps += done.steps
        return self._checked(done)

    def _checked(self, done: Chunk) -> Chunk:
        """The chunk, its status INCONSISTENT if a repeated row contradicts the others."""
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
    w.ctl[0]["bad"] = w.ctl[0]["badkind"] = -1
    evaluate.check(system, evaluate.accelerations(system, state.t, rate), state)
    if system.sizes["ne"]:
        evaluate.check(system, evaluate.fill_events(system, state.t, w.arrays["ev0"]), state)


def start_classical(system: System, state: State, h: float, *, rate: float = 200.0) -> ExplicitRun:
    """Begin a run of the classical fourth-order method.

    Parameters
    ----------
    system, state
        What to integrate and from where.
    h
        Step [s], > 0.
    rate
        Rate at which drift of constraints is pulled back [1/s].
    """
    if not (h > 0.0 and math.isfinite(h)):
        raise SolverError(f"the step must be positive and finite, not {h!r}", NOT_FINITE)
    _start(system, state, rate)
    return ExplicitRun(system, h, np.array([0.0, 0.0, 0.0, rate, math.inf]), state.t, 0, state.t)


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
    """Begin a run of Dormand-Prince 5(4) or 8(5,3) with step control.

    Parameters
    ----------
    system, state
        What to integrate and from where.
    rtol
        Relative tolerance of rates and displacements (not of spins).
    atol, atol_rate
        Absolute tolerances as lengths [m] and velocities [m/s]; angles count with the weight of the system.
    first_step
        First trial step [s].
    largest_step
        Longest step [s]: a load that comes and goes within a step, or an event that happens twice, is not
        seen.
    rate
        Rate at which drift of constraints is pulled back [1/s].
    order
        5 or 8; default 8 for rtol up to 1e-7, where it needs half the evaluations.
    """
    _start(system, state, rate)
    system.workspace.arrays["real"][STEP_SIZE] = first_step
    system.workspace.arrays["real"][LAST_ERROR] = 1e-4
    system.workspace.arrays["real"][SLOPE_AT] = math.nan
    pair = EIGHTH if order == 8 or (order is None and rtol <= 1e-7) else FIFTH
    tolerances = np.array([rtol, atol, atol_rate, rate, largest_step])
    return ExplicitRun(system, 0.0, tolerances, state.t, 0, state.t, pair)
