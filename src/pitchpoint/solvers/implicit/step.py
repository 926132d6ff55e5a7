# SPDX-License-Identifier: Apache-2.0
"""One step of generalised-alpha, and the same way in shorter steps where Newton's iteration fails.

Friction that falls with speed, or flanks that meet at speed, may leave the equations of a long step without a
solution, or with several of which Newton's iteration finds none. The equations of a short step are governed
by the mass matrix and have one. So a step that fails is taken in 4, 16, 64 parts; the run continues with
its own step afterwards.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import DIVERGED, OK
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.solvers.explicit.derivative import OLD, bring_state
from pitchpoint.solvers.implicit.constrained_newton import ITERATION, constrained_step
from pitchpoint.solvers.implicit.newton import newton_step, rows_hold
from pitchpoint.system.workspace import MACH, REJECTED, STAGE_ROWS, VALID

DIVISION = 4
"""Parts of a divided step, and of those again."""
MOST_PARTS = 64
KEPT = OLD + 2
"""First of the rows of the stages that keep what a step changes: both accelerations, a, multipliers."""


@kernel
def _predict(q, v, a, al, ap, h, method):
    """First guess of a step: linear extrapolation of the acceleration.

    A guess that merely kept the last acceleration would leave an error of first order in h behind whenever
    one iteration is enough.
    """
    beta, gamma, alpha_m, alpha_f = method
    for i in range(q.size):
        last = al[i]
        guess = 2.0 * a[i] - ap[i]
        new = ((1.0 - alpha_f) * guess + alpha_f * a[i] - alpha_m * last) / (1.0 - alpha_m)
        q[i] += h * v[i] + h * h * ((0.5 - beta) * last + beta * new)
        v[i] += h * ((1.0 - gamma) * last + gamma * new)
        al[i] = new
        ap[i] = a[i]
        a[i] = guess


@kernel
def _predict_multipliers(at):
    """Linear extrapolation of the multipliers, where friction depends on them.

    One iteration makes a step, so friction works with the guess; the last one would leave an error of first
    order behind.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    lam = view(c["lam"], c["nc"], F8)
    last = view(m["lp"], c["nc"], F8)
    for r in range(lam.size):
        before = last[r]
        last[r] = lam[r]
        lam[r] += lam[r] - before


@kernel
def _stabilised_step(at, t, cm, cd, iteration, code):
    """One step with the rows on positions and rates."""
    n = view(iteration, 1, ITERATION)[0]
    n["t"] = t
    n["cm"] = cm
    n["cd"] = cd
    return constrained_step(at, iteration, code)


@kernel
def alpha_step(at, t, h, rho, tol, iteration, code, keep):
    """One step of length h to the time t; one that fails leaves its last iterate.

    rho spectral radius at infinity, tol of `newton_step`; iteration, code as in
    `generalized_alpha.advance`; keep 1: `bring_step` can undo it.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    al = view(m["al"], nd, F8)
    ap = view(m["ap"], nd, F8)
    alpha_m = (2.0 * rho - 1.0) / (rho + 1.0)
    alpha_f = rho / (rho + 1.0)
    gamma = 0.5 - alpha_m + alpha_f
    beta = 0.25 * (gamma + 0.5) * (gamma + 0.5)
    cm = (1.0 - alpha_m) / (h * h * beta * (1.0 - alpha_f))
    cd = gamma / (h * beta)
    share = (1.0 - alpha_f) / (1.0 - alpha_m)
    if keep != 0:
        stage = view(m["stage"], (STAGE_ROWS, 2 * nd), F8)
        for i in range(nd):
            stage[OLD, i] = q[i]
            stage[OLD, nd + i] = v[i]
            stage[KEPT, i] = al[i]
            stage[KEPT, nd + i] = ap[i]
            stage[KEPT + 1, i] = a[i]
        if c["nc"] > 0:
            _keep_multipliers(c, m, stage)
    _predict(q, v, a, al, ap, h, (beta, gamma, alpha_m, alpha_f))
    for i in range(nd):
        al[i] -= share * a[i]  # completed below with the solved acceleration
    if m["settles"] != 0:
        _predict_multipliers(at)
    if iteration != 0:
        status = _stabilised_step(at, t, cm, cd, iteration, code)
    else:
        status = newton_step(at, t, cm, cd, tol)
    if status == OK and c["nc"] > 0:
        status = rows_hold(at, t)
    if status == OK:
        for i in range(nd):
            al[i] += share * a[i]
    return status


@kernel
def _keep_multipliers(c, m, stage):
    """Keep the multipliers before a step."""
    lam = view(c["lam"], c["nc"], F8)
    lp = view(m["lp"], c["nc"], F8)
    for r in range(min(lam.size, stage.shape[1])):  # more rows than that repeat each other
        stage[KEPT + 2, r] = lam[r]
        stage[KEPT + 3, r] = lp[r]


@kernel
def bring_step(at):
    """Bring back what `implicit.step` has kept."""
    bring_state(at, OLD)
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    nc = c["nc"]
    stage = view(m["stage"], (STAGE_ROWS, 2 * nd), F8)
    a = view(c["a"], nd, F8)
    al = view(m["al"], nd, F8)
    ap = view(m["ap"], nd, F8)
    for i in range(nd):
        al[i] = stage[KEPT, i]
        ap[i] = stage[KEPT, nd + i]
        a[i] = stage[KEPT + 1, i]
    lam = view(c["lam"], nc, F8)
    lp = view(m["lp"], nc, F8)
    for r in range(nc):
        lam[r] = stage[KEPT + 2, r] if r < 2 * nd else 0.0
        lp[r] = stage[KEPT + 3, r] if r < 2 * nd else 0.0
    view(m["clock"], 16, I8)[VALID] = 0


@kernel
def _other_step(at, ratio):
    """Continue with steps of `ratio` times the length: what lies a share of a step ahead or behind moves."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    nc = c["nc"]
    a = view(c["a"], nd, F8)
    al = view(m["al"], nd, F8)
    ap = view(m["ap"], nd, F8)
    for i in range(nd):
        al[i] = a[i] + (al[i] - a[i]) * ratio
        ap[i] = a[i] + (ap[i] - a[i]) * ratio
    lam = view(c["lam"], nc, F8)
    lp = view(m["lp"], nc, F8)
    for r in range(nc):
        lp[r] = lam[r] + (lp[r] - lam[r]) * ratio
    view(m["clock"], 16, I8)[VALID] = 0


@kernel
def divided_step(at, t, h, rho, tol, iteration, code):
    """The step of `implicit.step` in parts, from what it has kept."""
    view(view(view(at, 1, CTL)[0]["mach"], 1, MACH)[0]["clock"], 16, I8)[REJECTED] += 1
    status = DIVERGED
    parts = DIVISION
    while parts <= MOST_PARTS:
        bring_step(at)
        _other_step(at, 1.0 / parts)
        for p in range(1, parts + 1):
            status = alpha_step(at, t - (parts - p) * h / parts, h / parts, rho, tol, iteration, code, 0)
            if status != OK:
                break
        if status == OK:
            _other_step(at, 1.0 * parts)
            return OK
        parts *= DIVISION
    return status
