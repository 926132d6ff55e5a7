# SPDX-License-Identifier: Apache-2.0
"""Jumps of the forces between two steps of generalised-alpha, such as by the outputs of sampled controllers.

With a jump Delta f of the forces, the accelerations and multipliers at the end of a step and those at the
start of the next one differ by the solution of

    M delta + G^T mu = Delta f,   G delta = 0

and so do the algorithmic acceleration and the values of the step before, with which the method continues:
then the rates of the next step have no error, and the predictions keep their slopes. Here delta is computed
with the matrix A = cm M + cd D + K of the iteration: cm A^-1 Delta f = delta (1 + O(h)). An error epsilon of
delta changes the rates by h epsilon / 2, once per jump, so the method keeps its second order. Stiff parts,
for which A is mainly K, get an acceleration of the size that their displacement requires, whereas a restart
with the mass matrix would let them swing with their own frequency. Without any correction the jump would act
half a step late, with an error of the first order.

Method: M. Arnold, O. Bruels, Multibody System Dynamics 18 (2007) 185-202.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.kernel import invoke, plain
from pitchpoint.core.status import OK, SINGULAR
from pitchpoint.solvers.implicit.generalized_alpha import Run
from pitchpoint.solvers.implicit.interface import forget_slopes
from pitchpoint.solvers.implicit.newton import EXTRA
from pitchpoint.solvers.implicit.step import coefficients, factors
from pitchpoint.solvers.implicit.substeps import LONG_RHO, SubstepRun
from pitchpoint.system.linear import factor_entry, solve_entry
from pitchpoint.system.link import NO_MATTER
from pitchpoint.system.part import solve_entry as part_solution
from pitchpoint.system.requests import RESIDUAL, send_request
from pitchpoint.system.residual import NEWTON
from pitchpoint.system.system import System
from pitchpoint.system.workspace import EVALUATIONS, VALID

SMALL = 0.1
"""Largest error of delta by a matrix of earlier steps, relative to the change of the accelerations in the
last step: with shorter steps it vanishes, too."""


def continue_after_jump(run: Run, change: NDArray[np.float64]) -> int:
    """Continue a run after a jump of the forces at the state in the workspace; returns the status.

    Parameters
    ----------
    run
        The run, between two steps. With forces that depend on accelerations it restarts.
    change
        Jump of the residual R at constant coordinates, rates and accelerations, shape (nd,).
    """
    w = run.system.workspace
    if w.mach[0]["settles"] != 0:
        return run.go_on()
    if isinstance(run, SubstepRun):
        return _in_parts(run, change)
    beta, gamma, alpha_m, alpha_f = plain(coefficients)(run.rho_inf)
    cm = (1.0 - alpha_m) / (run.h**2 * beta * (1.0 - alpha_f))
    histories = [w.a, w.arrays["al"], w.arrays["ap"]]
    limit = SMALL * _size(run.system, w.a - w.arrays["ap"])
    good = w.clock[VALID] != 0 and _solve(run.system, change)
    if not good or w.arrays["real"][0] * _size(run.system, cm * w.arrays["x"]) > limit:
        status = send_request(w, RESIDUAL, run.t, NEWTON, (cm, gamma / (run.h * beta), 1.0))
        w.clock[EVALUATIONS] += 1
        if status != OK:
            return status
        if invoke(factor_entry, w.at, 0, 0) != OK or not _solve(run.system, change):
            return run.go_on()
        w.arrays["real"][EXTRA] = -1.0
        w.clock[VALID] = run.iteration is None  # the stabilised form has further factors
    for history in histories:
        history += cm * w.arrays["x"]
    for multipliers in (w.lam, w.arrays["lp"]):
        multipliers += w.arrays["y"]
    return OK


def _in_parts(run: SubstepRun, change: NDArray[np.float64]) -> int:
    """Continue a run with long steps: each part with the matrix of its own step; returns the status."""
    w = run.system.workspace
    for part, h, rho in zip(run.parts, (run.h, run.count * run.h), (run.rho_inf, LONG_RHO), strict=True):
        cm, cd, _ = plain(factors)(h, rho)
        status = part.refactor(run.t, cm, cd)
        if status != OK:
            return run.go_on() if status == SINGULAR else status
        w.R[:] = change - part.arrays["shift"]
        part.run(part_solution, run.t)
        delta = cm * part.arrays["x"][part.own]
        if not np.isfinite(delta).all():
            return run.go_on()
        for history in (w.a, w.arrays["al"], w.arrays["ap"]):
            history[part.own] += delta
    forget_slopes(run.parts[0])
    return OK


def _solve(system: System, change: NDArray[np.float64]) -> bool:
    """Solve A x + G^T y = -change, G x = 0 with the present factors; returns whether x is finite."""
    w = system.workspace
    w.R[:], w.g[:] = change, 0.0
    return invoke(solve_entry, w.at, 0, 0) == OK and bool(np.isfinite(w.arrays["x"]).all())


def _size(system: System, a: NDArray[np.float64]) -> float:
    """Weighted size of the accelerations of bodies, without those of signals."""
    moving = system.workspace.arrays["relative"] < NO_MATTER
    return float(np.abs(a * system.workspace.arrays["weight"])[moving].max(initial=0.0))
