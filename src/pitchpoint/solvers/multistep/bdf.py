# SPDX-License-Identifier: Apache-2.0
"""Stiff integration by backward differentiation formulas of four kinds and three constraint formulations.

Kinds: *gstiff* (fixed coefficients), *wstiff* (variable coefficients), *dassl* (fixed leading coefficient),
*constant_bdf* (given order and step). Forms: *I3* (constraints at position level), *SI2* (at position and
velocity level, q' = v + G^T mu), *SI1* (SI2 with lambda = eta', mu = xi'). Without constraints all forms are
equal.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.kernel import address, invoke
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.solvers.constraints.row_notes import rows_agree
from pitchpoint.solvers.implicit.constrained_newton import iterate, new_iteration
from pitchpoint.solvers.multistep.events import step_to_event
from pitchpoint.solvers.multistep.history import DEPTH
from pitchpoint.solvers.multistep.order_control import CONSTANT, FIXED, LARGEST, LEADING, PAST, VARIABLE
from pitchpoint.solvers.multistep.restart import resume
from pitchpoint.solvers.multistep.step import ORDER, entry, step
from pitchpoint.solvers.sampling import Accumulators, Chunk, advance_into, new_recorder
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System
from pitchpoint.system.workspace import VALID

KINDS = {"gstiff": FIXED, "wstiff": VARIABLE, "dassl": LEADING, "constant_bdf": CONSTANT}
FORMS = ("I3", "SI2", "SI1")
MAX_ORDER = 6
LASTING = 12
"""Maximum number of full Newton iterations of constant_bdf, whose step should not be shortened."""
HASTY = 3
"""The same for methods with step control."""


@dataclass
class StiffRun:
    """Running integration. Created by `start`.

    Parameters
    ----------
    system
        The system; its workspace contains the state.
    past
        Memory of the method, PAST record, shape (1,).
    tolerances
        rtol [-], atol [m], atol_rate [m/s], longest step [s].
    t0
        Start time, from which samples count [s].
    steps
        Accepted steps.
    keep
        Arrays referenced by address in the memory.
    """

    system: System
    past: NDArray[np.void]
    tolerances: NDArray[np.float64]
    t0: float
    steps: int = 0
    keep: list[Any] = field(default_factory=list)

    @property
    def t(self) -> float:
        """Time reached [s]."""
        return float(self.past[0]["t"])

    @property
    def longest(self) -> float:
        """Longest step [s]."""
        return float(self.tolerances[LARGEST])

    @property
    def order(self) -> int:
        """Order of the next step."""
        return int(self.past[0]["k"])

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
        """Integrate to a time; arguments as in `explicit.runge_kutta.ExplicitRun.advance_to`.

        With `restart`, steps end at events and the method restarts there: no step and no history crosses a
        jump or a kink of the forces. Otherwise events are located on the polynomial of the step, and their
        effect on the solution is left to the error control.
        """
        reach = min(t_end - self.t, most * self.longest)
        room = int(reach / sample) + 2 if sample > 0.0 else 0
        recorder = new_recorder(self.system.sizes["no"], rows=room, sums=statistics, events=events)
        order = np.array([(t_end, self.t0, sample, self.past.ctypes.data, most, restart)], ORDER)
        done = advance_into(entry, self.system.workspace.at, order, recorder)
        self.steps += done.steps
        return replace(done, status=rows_agree(self.system, self.t)) if done.status == OK else done

    def watch(self, functions: NDArray[np.int64]) -> None:
        """Restrict events to the flagged functions, shape (ne,); default all."""
        self.keep.append(functions)
        self.past[0]["wanted"] = functions.ctypes.data

    @property
    def restarts(self) -> int:
        """Number of restarts at events."""
        return int(self.past[0]["events"])

    def go_on(self) -> int:
        """Restart from the state in the workspace after a jump of the forces; returns the status.

        At order 3 with derivatives after the jump, or at order 1 if these are unreliable.
        """
        status = evaluate.accelerations(self.system, self.t)
        if status == OK and self.past[0]["k"] > 0:
            invoke(resume, self.system.workspace.at, self.past.ctypes.data, 0)
        return status

    def state(self) -> State:
        """Copy of the state reached."""
        return evaluate.store(self.system, self.t)


def start(
    system: System,
    state: State,
    kind: str = "gstiff",
    *,
    form: str = "SI2",
    rtol: float | None = None,
    atol: float | None = None,
    atol_rate: float | None = None,
    order: int | None = None,
    largest_step: float = math.inf,
) -> StiffRun:
    """Start a stiff integration from a state; its accelerations and multipliers are computed.

    Parameters
    ----------
    system, state
        The system and its initial state.
    kind
        One of `KINDS`.
    form
        One of `FORMS`. With constraints, I3 controls the error of the positions only, because error estimates
        of the rates are unreliable after a change of step.
    rtol
        Relative tolerance of rates and displacements (not of spins) per step, default 1e-6. constant_bdf has
        no error control: its tolerance, default 1e-11, is that of the Newton iteration.
    atol, atol_rate
        Absolute tolerances as lengths [m] and velocities [m/s]; angles are scaled by the system weights.
        Default 1e-4 rtol and rtol.
    order
        Highest order 1 ... 6 (default 5), or the order of constant_bdf (default 2).
    largest_step
        Longest step [s]; the step of constant_bdf, which is shorter only at the start, at the end, and if the
        iteration fails.

    Raises
    ------
    SolverError
        If the state has no finite acceleration, or an argument is invalid.
    """
    constant = kind == "constant_bdf"
    order = order or (2 if constant else 5)
    rtol = rtol or (1e-11 if constant else 1e-6)
    _check(kind, form, order, largest_step)
    nd, nc = system.sizes["nd"], system.sizes["nc"]
    evaluate.prepare(system)
    evaluate.load(system, state)
    w = system.workspace
    w.clock[:] = 0
    w.arrays["real"][:] = 0.0
    w.arrays["real"][0] = 0.1
    w.ctl[0]["bad"] = w.ctl[0]["badkind"] = -1
    evaluate.check(system, evaluate.accelerations(system, state.t, 0.0), state)
    w.clock[VALID] = 0
    if system.sizes["ne"]:
        evaluate.check(system, evaluate.fill_events(system, state.t, w.arrays["ev0"]), state)
    iteration, keep = new_iteration(nd, nc, form != "I3", LASTING if constant else HASTY)
    size = 2 * nd + 3 * nc
    atol = 1e-4 * rtol if atol is None else atol
    tolerances = np.array([rtol, atol, rtol if atol_rate is None else atol_rate, largest_step])
    arrays = {
        "rows": np.zeros((DEPTH, size)),
        "times": np.zeros(DEPTH),
        "new": np.zeros(size),
        "ahead": np.zeros(size),
        "slope": np.zeros(size),
        "allowed": np.zeros(2 * nd),
        "W": np.zeros((DEPTH, DEPTH)),
        "p": np.zeros(2 * DEPTH),
        "tol": tolerances,
        "iteration": iteration,
    }
    past, kept = np.zeros(1, PAST), np.zeros(1, PAST)
    saved = {"rows": np.zeros((DEPTH, size)), "times": np.zeros(DEPTH)}
    for name, array in arrays.items():
        past[0][name] = array.ctypes.data
        kept[0][name] = saved.get(name, array).ctypes.data
    past[0]["kept"] = kept.ctypes.data
    past[0]["t"], past[0]["kind"], past[0]["most_k"] = state.t, KINDS[kind], order
    past[0]["rates"] = nc == 0 or form != "I3"
    past[0]["integrals"] = nc > 0 and form == "SI1"
    past[0]["iterate"], past[0]["step"] = address(iterate), address(step)
    past[0]["seek"], past[0]["resume"] = address(step_to_event), address(resume)
    return StiffRun(system, past, tolerances, state.t, 0, [*keep, *arrays.values(), kept, *saved.values()])


def _check(kind: str, form: str, order: int, largest_step: float) -> None:
    if kind not in KINDS:
        raise SolverError(f"unknown kind {kind!r}; choose one of {', '.join(KINDS)}", NOT_FINITE)
    if form not in FORMS:
        raise SolverError(f"unknown form {form!r}; choose one of {', '.join(FORMS)}", NOT_FINITE)
    if not 1 <= order <= MAX_ORDER:
        raise SolverError(f"the order must be 1 ... {MAX_ORDER}, not {order!r}", NOT_FINITE)
    if not largest_step > 0.0 or (kind == "constant_bdf" and not math.isfinite(largest_step)):
        raise SolverError(
            f"the step must be positive, and finite for constant_bdf, not {largest_step!r}", NOT_FINITE
        )
