# SPDX-License-Identifier: Apache-2.0
"""Implicit time loop: generalised-alpha method of Arnold and Bruels with a modified Newton iteration.

Constraints are enforced at position level (index 3) with the multipliers as unknowns of the step; the
iteration is in `newton`. The stabilised form (index 2) enforces them at velocity level, too, with
q' = v + G^T mu; its iteration in `constrained_newton` is called through an address and compiled on demand.

Source: M. Arnold, O. Bruels, Convergence of the generalized-alpha scheme for constrained mechanical systems,
Multibody System Dynamics 18 (2007) 185-202. Second order; damping of high frequencies is set by rho_inf.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.kernel import address, kernel, view
from pitchpoint.core.status import BAD_CENTRE, DIVERGED, NOT_FINITE, OK, SLOW, UNBOUNDED
from pitchpoint.multibody.channels import CTL, I8
from pitchpoint.solvers.implicit.constrained_newton import iterate, new_iteration
from pitchpoint.solvers.implicit.start_values import first_slopes, shift_rates
from pitchpoint.solvers.implicit.step import alpha_step, bring_step, divided_step
from pitchpoint.solvers.sampling import (
    Accumulators,
    Chunk,
    advance_into,
    new_recorder,
    record_step,
    recorder_at,
)
from pitchpoint.system import evaluate
from pitchpoint.system.residual import wrap
from pitchpoint.system.system import State, System
from pitchpoint.system.workspace import MACH, STEPS, VALID

RHO_INF = 0.8
"""Spectral radius at infinite frequency."""
MAX_MATRICES = 12
"""Maximum number of full Newton iterations of the stabilised form."""
ROUND_OFF = 4e-15
"""Smallest tolerance relative to the size of the machine [m], and for angles [rad]: a few rounding units."""
JOLT = 2e-3
"""Largest acceleration error of the iteration in systems with constraints [m/s^2]: a negligible position
error, divided by the square of a short step, is a significant force in the multipliers and accumulates in the
rates."""


@kernel(inline=True)
def advance(at, t0, first, n, h, rho, tol, iteration, code, recorder):
    """Take n steps; step k ends at t0 + (first + k) h. A failed step restores the state before it.

    If the Newton iteration fails, the step is divided; the parts are not recorded.

    iteration, code: record and address of the iteration of the stabilised form, 0 for index 3.
    """
    c = view(at, 1, CTL)[0]
    clock = view(view(c["mach"], 1, MACH)[0]["clock"], 16, I8)
    for k in range(1, n + 1):
        t = t0 + (first + k) * h
        status = alpha_step(at, t, h, rho, tol, iteration, code, 1)
        if status == SLOW or status == DIVERGED or status == BAD_CENTRE or status == UNBOUNDED:
            # the iteration diverged
            status = divided_step(at, t, h, rho, tol, iteration, code)
        if status != OK:
            bring_step(at)
            return status
        wrap(at)
        clock[STEPS] += 1
        recorder.done[0] = k
        status = record_step(at, t, h, first + k, recorder)
        if status != OK:
            return status
    return OK


#: Arguments of `advance` from Python, by name.
ORDER = np.dtype(
    [
        *((name, "f8") for name in ("t0", "h", "rho", "tol")),
        *((name, "i8") for name in ("first", "n", "iteration", "code")),
    ],
    align=True,
)


@kernel
def entry(at, order, recorder):
    """Execute an ORDER; both arguments are addresses of records."""
    o = view(order, 1, ORDER)[0]
    c = view(at, 1, CTL)[0]
    c["held"] = 1
    status = advance(
        at,
        o["t0"],
        o["first"],
        o["n"],
        o["h"],
        o["rho"],
        o["tol"],
        o["iteration"],
        o["code"],
        recorder_at(recorder),
    )
    c["held"] = 0
    return status


@dataclass
class Run:
    """Running integration: system, step and time reached. Created by `start`.

    Parameters
    ----------
    system
        The system; its workspace contains the state until the next `start`.
    h
        Step [s].
    rho_inf
        Spectral radius at infinite frequency, 0 ... 1 (1: no numerical damping).
    tolerance
        Tolerance of the Newton iteration, weighted as a length [m]; tighter with constraints and short steps.
    iteration
        Record and arrays of the stabilised iteration; None for index 3.
    """

    system: System
    h: float
    rho_inf: float = RHO_INF
    tolerance: float = 1e-11
    t0: float = 0.0
    steps: int = 0
    iteration: tuple[NDArray[np.void], list[Any]] | None = None

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
        """Take n steps, or fewer if a step fails.

        Parameters
        ----------
        every
            Sample all channels at every n-th step of the run; 0 for none.
        statistics
            Accumulators of `sampling.new_statistics`, updated in place at every `stride`-th step.
        events
            Maximum number of events to record.
        """
        room = n // every + 1 if every else 0
        recorder = new_recorder(
            self.system.sizes["no"], every=every, stride=stride, rows=room, sums=statistics, events=events
        )
        done = advance_into(entry, self.system.workspace.at, self.order(n), recorder)
        self.steps += done.steps
        return done

    def order(self, n: int) -> NDArray[np.void]:
        """Arguments of the compiled loop for n steps, shape (1,)."""
        order = np.array([(self.t0, self.h, self.rho_inf, self.left(), self.steps, n, 0, 0)], ORDER)
        if self.iteration is not None:
            per_q = self.iteration[1][0]
            per_q[:] = 1.0 / np.maximum(self.left() / self.system.workspace.arrays["weight"], ROUND_OFF)
            order[0]["iteration"], order[0]["code"] = self.iteration[0].ctypes.data, address(iterate)
        return order

    def left(self) -> float:
        """Newton tolerance at the present step, weighted as a length [m]."""
        if not self.system.sizes["nc"]:
            return self.tolerance
        size = max(1.0, float(np.abs(self.system.workspace.fr["r"]).max(initial=0.0)))
        return max(ROUND_OFF * size, min(self.tolerance, 0.25 * self.h**2 * JOLT))

    def go_on(self) -> int:
        """Start or restart at the state in the workspace, after a jump of the forces; returns the status.

        The algorithmic accelerations are set to the time (alpha_m - alpha_f) h later. Otherwise accelerations
        and index 3 multipliers would have first-order errors over many steps: see `implicit.start_values`.
        """
        system, t = self.system, self.t
        w = system.workspace
        status = evaluate.accelerations(system, t)
        w.clock[VALID] = 0
        w.arrays["al"][:] = w.a
        w.arrays["ap"][:] = w.a
        w.arrays["lp"][:] = w.lam
        if status != OK:
            return status
        found = first_slopes(system, t, self.h)
        if found is not None:
            jerk, rise = found
            later = (self.rho_inf - 1.0) / (self.rho_inf + 1.0)  # alpha_m - alpha_f
            w.arrays["al"] += later * self.h * jerk
            w.arrays["ap"] -= self.h * jerk
            w.arrays["lp"] -= self.h * rise
            if self.iteration is None and len(w.lam):
                beta = 0.25 * (1.0 - later) ** 2
                shift_rates(system, (1.0 - 6.0 * beta - 3.0 * later) / 6.0 * self.h**2 * jerk)
        return OK

    def change_step(self, h: float) -> None:
        """Change the step from the present time on."""
        w = self.system.workspace
        # rescale the values that are a fraction of a step ahead or behind
        for name, now in (("al", w.a), ("ap", w.a), ("lp", w.lam)):
            w.arrays[name][:] = now + (w.arrays[name] - now) * (h / self.h)
        self.t0, self.steps, self.h = self.t, 0, h
        w.clock[VALID] = 0
        if self.iteration is None and len(w.lam):  # the row residual of index 3 rates is proportional to h^2
            self.go_on()

    def state(self) -> State:
        """Copy of the state reached."""
        return evaluate.store(self.system, self.t)


def start(
    system: System,
    state: State,
    h: float,
    *,
    rho_inf: float = RHO_INF,
    tolerance: float = 1e-11,
    form: str = "I3",
) -> Run:
    """Start an integration from a state; its accelerations are computed.

    Parameters
    ----------
    system, state
        The system and its initial state.
    h
        Step [s], > 0.
    rho_inf
        Spectral radius at infinite frequency, 0 ... 1.
    tolerance
        Newton tolerance as a length [m].
    form
        "I3": constraints at position level; "SI2": at position and velocity level.

    Raises
    ------
    SolverError
        If the state has no finite acceleration, or the form is unknown.
    """
    if not (h > 0.0 and math.isfinite(h)):
        raise SolverError(f"the step must be positive and finite, not {h!r}", NOT_FINITE)
    if form not in ("I3", "SI2"):
        raise SolverError(f"generalized_alpha has the forms I3 and SI2, not {form!r}", NOT_FINITE)
    evaluate.prepare(system)
    evaluate.load(system, state)
    w = system.workspace
    w.clock[:] = 0
    w.arrays["real"][:] = 0.0
    w.arrays["real"][0] = 0.1
    w.ctl[0]["bad"] = w.ctl[0]["badkind"] = -1
    run = Run(system, h, rho_inf, tolerance, state.t)
    if form == "SI2" and system.sizes["nc"]:
        run.iteration = new_iteration(system.sizes["nd"], system.sizes["nc"], True, MAX_MATRICES)
    evaluate.check(system, run.go_on(), state)
    if system.sizes["ne"]:
        evaluate.check(system, evaluate.fill_events(system, state.t, w.arrays["ev0"]), state)
    return run
