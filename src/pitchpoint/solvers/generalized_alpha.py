# SPDX-License-Identifier: Apache-2.0
"""Implicit time loop: generalised-alpha of Arnold and Bruels with a modified Newton iteration.

The matrix is kept over steps and factored again when the iteration slows down. An iterate is accepted when the
error that is left, |dq| theta / (1 - theta) with the last measured contraction rate theta, is below tolerance.
Constraints hold on positions (index 3), multipliers are unknowns of the step.

Source: M. Arnold, O. Bruels, Convergence of the generalized-alpha scheme for constrained mechanical systems,
Multibody System Dynamics 18 (2007) 185-202. Second order; damping of high frequencies is set by rho_inf.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import DIVERGED, INCONSISTENT, NOT_FINITE, OK, SLOW
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.solvers.sampling import EVENT_COLUMNS, crossings, take
from pitchpoint.system import evaluate
from pitchpoint.system.linear import factor, solve, solve_acceleration
from pitchpoint.system.residual import FORCES, NEWTON, evaluate_events, residual, wrap
from pitchpoint.system.system import State, System
from pitchpoint.system.workspace import EVALUATIONS, ITERATIONS, MACH, STEPS, VALID

MOST_ITERATIONS = 12
MOST_REFRESHES = 3
SLOW_RATE = 0.5
ROW_TOLERANCE = 1e-7


@kernel
def _predict(q, v, a, al, h, beta, gamma, alpha_m, alpha_f):
    """First guess of a step: the acceleration of the last one goes on."""
    for i in range(q.size):
        old = al[i]
        new = (a[i] - alpha_m * old) / (1.0 - alpha_m)  # (1-af) a + af a of the last step, a assumed constant
        q[i] += h * v[i] + h * h * ((0.5 - beta) * old + beta * new)
        v[i] += h * ((1.0 - gamma) * old + gamma * new)
        al[i] = new


@kernel
def _norm(x, weight):
    """Largest weighted entry; NaN if there is one."""
    most = 0.0
    total = 0.0
    for i in range(x.size):
        s = abs(x[i]) * weight[i]
        total += s
        if s > most:
            most = s
    return most if math.isfinite(total) else total


@kernel
def _step(at, t, cm, cd, tol):
    """Iterate one step to acceptance; q, v, a, lam hold the prediction and become the solution."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    nc = c["nc"]
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    lam = view(c["lam"], nc, F8)
    x = view(m["x"], nd, F8)
    y = view(m["y"], nc, F8)
    weight = view(m["weight"], nd, F8)
    clock = view(m["clock"], 16, I8)
    real = view(m["real"], 16, F8)
    last = -1.0
    count = 0
    refreshes = 0
    for it in range(MOST_ITERATIONS * (1 + MOST_REFRESHES)):
        fresh = clock[VALID] == 0
        status = residual(at, t, NEWTON if fresh else FORCES, cm, cd, 1.0)
        clock[EVALUATIONS] += 1
        if status != OK:
            return status
        if fresh:
            status = factor(at)
            if status != OK:
                return status
            clock[VALID] = 1
            real[0] = min(real[0], 0.1)  # a fresh matrix earns new trust
            last = -1.0
            count = 0
        solve(at)
        clock[ITERATIONS] += 1
        count += 1
        size = _norm(x, weight)
        if not math.isfinite(size):
            return NOT_FINITE
        if last > 0.0:
            real[0] = max(size / last, 1e-4)
        for i in range(nd):
            q[i] += x[i]
            v[i] += cd * x[i]
            a[i] += cm * x[i]
        for r in range(nc):
            lam[r] += y[r]
        theta = real[0]
        if theta < 1.0 and size * theta / (1.0 - theta) <= tol:
            if count > 2 or theta > SLOW_RATE:
                clock[VALID] = 0
            return OK
        if size <= 1e-3 * tol:
            return OK
        if (theta > SLOW_RATE and last > 0.0) or count >= MOST_ITERATIONS:
            if not fresh and refreshes >= MOST_REFRESHES:
                return DIVERGED if theta >= 1.0 else SLOW
            refreshes += 1
            clock[VALID] = 0
        last = size
    return SLOW


@kernel
def _rows_hold(at):
    """Check that flagged redundant rows are satisfied by the others."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    g = view(c["g"], c["nc"], F8)
    used = view(m["used"], c["nc"], I8)
    for r in range(g.size):
        if used[r] == 0 and abs(g[r]) > ROW_TOLERANCE:
            return INCONSISTENT
    return OK


@kernel
def advance(at, t0, first, n, h, rho, tol, every, rows, sums, stride, found, done):
    """Take n steps; t of step k is t0 + (first + k) h.

    every > 0: store a row of observations at steps divisible by it. sums: statistics at every stride-th step
    (no rows: none). found: recorded events (no rows: none). done: steps, rows, events of this call.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    al = view(m["al"], nd, F8)
    clock = view(m["clock"], 16, I8)
    ev0 = view(m["ev0"], c["ne"], F8)
    ev1 = view(m["ev1"], c["ne"], F8)
    alpha_m = (2.0 * rho - 1.0) / (rho + 1.0)
    alpha_f = rho / (rho + 1.0)
    gamma = 0.5 - alpha_m + alpha_f
    beta = 0.25 * (gamma + 0.5) * (gamma + 0.5)
    cm = (1.0 - alpha_m) / (h * h * beta * (1.0 - alpha_f))
    cd = gamma / (h * beta)
    share = (1.0 - alpha_f) / (1.0 - alpha_m)
    done[0] = 0
    done[1] = 0
    done[2] = 0
    watch = found.shape[0] > 0 and c["ne"] > 0
    for k in range(1, n + 1):
        t = t0 + (first + k) * h
        _predict(q, v, a, al, h, beta, gamma, alpha_m, alpha_f)
        for i in range(nd):
            al[i] -= share * a[i]  # completed below with the solved acceleration
        status = _step(at, t, cm, cd, tol)
        if status != OK:
            return status
        for i in range(nd):
            al[i] += share * a[i]
        if c["nc"] > 0:
            status = _rows_hold(at)
            if status != OK:
                return status
        wrap(at)
        clock[STEPS] += 1
        done[0] = k
        sample = 1 if every > 0 and (first + k) % every == 0 else 0
        if sample != 0 and done[1] >= rows.shape[0]:
            sample = 0
        measure = 1 if sums.shape[0] > 0 and (first + k) % stride == 0 else 0
        if sample != 0 or measure != 0:
            status = take(at, t, sums, measure, rows, done[1], sample)
            if status != OK:
                return status
            done[1] += sample
        if watch:
            status = evaluate_events(at, t, m["ev1"])
            if status != OK:
                return status
            done[2] = crossings(ev0, ev1, t - h, h, found, done[2])
            for i in range(ev0.size):
                ev0[i] = ev1[i]
    return OK


@dataclass
class Chunk:
    """What one call of `Run.advance` did.

    Parameters
    ----------
    status
        Status of the core; OK, or why it stopped.
    steps
        Accepted steps.
    rows
        Samples (time, observations ...), shape (n, no + 1).
    events
        Recorded events (time, event function, direction), shape (n, 3).
    """

    status: int
    steps: int
    rows: NDArray[np.float64]
    events: NDArray[np.float64]


@dataclass
class Run:
    """An integration under way: a system, its step, how far it got. Made by `start`.

    Parameters
    ----------
    system
        The system; its workspace holds the state until the next `start`.
    h
        Step [s].
    rho_inf
        Spectral radius at infinite frequency, 0 ... 1 (1: no numerical damping).
    tolerance
        Error left in the Newton iteration, weighted as a length [m].
    """

    system: System
    h: float
    rho_inf: float = 0.8
    tolerance: float = 1e-11
    t0: float = 0.0
    steps: int = 0
    _nothing: NDArray[np.float64] = field(default_factory=lambda: np.zeros((0, 8)))

    @property
    def t(self) -> float:
        """Time reached [s]."""
        return self.t0 + self.steps * self.h

    def advance(
        self,
        n: int,
        *,
        every: int = 0,
        statistics: NDArray[np.float64] | None = None,
        stride: int = 1,
        events: int = 0,
    ) -> Chunk:
        """Take n steps, or fewer if something fails.

        Parameters
        ----------
        every
            Sample all observations at every n-th step of the run; 0 for none.
        statistics
            Accumulators of `sampling.new_statistics`, updated in place at every `stride`-th step.
        events
            Most events to record.
        """
        w = self.system.workspace
        room = n // every + 1 if every else 0
        rows = np.empty((room, self.system.sizes["no"] + 1))
        found = np.empty((events, EVENT_COLUMNS))
        done = np.zeros(3, np.int64)
        sums = self._nothing if statistics is None else statistics
        args = (self.t0, self.steps, n, self.h, self.rho_inf, self.tolerance, every, rows, sums, stride)
        status = int(advance(w.at, *args, found, done))
        self.steps += int(done[0])
        return Chunk(status, int(done[0]), rows[: done[1]], found[: min(done[2], events)])

    def change_step(self, h: float) -> None:
        """Go on with another step from here."""
        self.t0, self.steps, self.h = self.t, 0, h
        self.system.workspace.clock[VALID] = 0

    def state(self) -> State:
        """Copy of the state reached."""
        return evaluate.store(self.system, self.t)


def start(
    system: System, state: State, h: float, *, rho_inf: float = 0.8, tolerance: float = 1e-11
) -> Run:
    """Begin an integration from a state; its accelerations are computed afresh.

    Parameters
    ----------
    system, state
        What to integrate and from where.
    h
        Step [s], > 0.
    rho_inf
        Spectral radius at infinite frequency, 0 ... 1.
    tolerance
        Newton tolerance as a length [m].

    Raises
    ------
    SolverError
        If the state has no finite acceleration.
    """
    if not (h > 0.0 and math.isfinite(h)):
        raise SolverError(f"the step must be positive and finite, not {h!r}", NOT_FINITE)
    evaluate.prepare(system)
    evaluate.load(system, state)
    w = system.workspace
    w.clock[:] = 0
    w.arrays["real"][:] = 0.0
    w.arrays["real"][0] = 0.1
    w.ctl[0]["bad"] = w.ctl[0]["badkind"] = -1
    evaluate.check(system, solve_acceleration(w.at, state.t, 0.0), state)
    wrap(w.at)
    w.arrays["al"][:] = w.a
    if system.sizes["ne"]:
        evaluate.check(system, evaluate_events(w.at, state.t, w.arrays["ev0"].ctypes.data), state)
    return Run(system, h, rho_inf, tolerance, state.t)
