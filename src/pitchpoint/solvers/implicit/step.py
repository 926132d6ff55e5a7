# SPDX-License-Identifier: Apache-2.0
"""One generalised-alpha step, and its division into shorter steps if the Newton iteration fails.

With friction that falls with speed, or with impacts of flanks, the equations of a long step may have no
solution, or several ones to none of which the Newton iteration converges. The equations of a short step are
dominated by the mass matrix and have a solution. So a failed step is divided into 4, 16, 64 parts; the run
then continues with its normal step.
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
"""Factor between successive divisions of a step."""
MAX_PARTS = 64
KEPT = OLD + 2
"""First row of the stages with saved values of a step: both accelerations, a, multipliers."""


@kernel
def coefficients(rho):
    """Parameters beta, gamma, alpha_m and alpha_f of generalised-alpha; rho: spectral radius at infinity."""
    alpha_m = (2.0 * rho - 1.0) / (rho + 1.0)
    alpha_f = rho / (rho + 1.0)
    gamma = 0.5 - alpha_m + alpha_f
    return 0.25 * (gamma + 0.5) * (gamma + 0.5), gamma, alpha_m, alpha_f


@kernel(inline=True)
def factors(h, rho):
    """Factors cm and cd of the corrections, and share of a in the algorithmic acceleration."""
    beta, gamma, alpha_m, alpha_f = coefficients(rho)
    return (
        (1.0 - alpha_m) / (h * h * beta * (1.0 - alpha_f)),
        gamma / (h * beta),
        (1.0 - alpha_f) / (1.0 - alpha_m),
    )


@kernel(inline=True)
def predict(i, q, v, a, al, ap, h, method):
    """Prediction of coordinate i: linear extrapolation of the acceleration.

    Constant extrapolation would cause a first-order error in h in steps with one iteration. The share of the
    solved acceleration in `al` is added after the iteration.
    """
    beta, gamma, alpha_m, alpha_f = method
    last = al[i]
    guess = 2.0 * a[i] - ap[i]
    new = ((1.0 - alpha_f) * guess + alpha_f * a[i] - alpha_m * last) / (1.0 - alpha_m)
    q[i] += h * v[i] + h * h * ((0.5 - beta) * last + beta * new)
    v[i] += h * ((1.0 - gamma) * last + gamma * new)
    al[i] = new - (1.0 - alpha_f) / (1.0 - alpha_m) * guess
    ap[i] = a[i]
    a[i] = guess


@kernel
def _predict_multipliers(at):
    """Linear extrapolation of the multipliers, for friction that depends on them.

    In steps with one iteration friction is computed from the prediction; constant extrapolation would cause a
    first-order error.
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
    """One step with constraints at position and velocity level."""
    n = view(iteration, 1, ITERATION)[0]
    n["t"] = t
    n["cm"] = cm
    n["cd"] = cd
    return constrained_step(at, iteration, code)


@kernel
def alpha_step(at, t, h, rho, tol, iteration, code, keep):
    """One step of length h to the time t; a failed step leaves its last iterate.

    rho: spectral radius at infinity; tol: as in `newton_step`; iteration, code: as in
    `generalized_alpha.advance`; keep 1: save the state so that `bring_step` can undo the step.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    al = view(m["al"], nd, F8)
    ap = view(m["ap"], nd, F8)
    cm, cd, share = factors(h, rho)
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
    method = coefficients(rho)
    for i in range(nd):
        predict(i, q, v, a, al, ap, h, method)
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
    """Save the multipliers before a step."""
    lam = view(c["lam"], c["nc"], F8)
    lp = view(m["lp"], c["nc"], F8)
    for r in range(min(lam.size, stage.shape[1])):  # further rows are redundant
        stage[KEPT + 2, r] = lam[r]
        stage[KEPT + 3, r] = lp[r]


@kernel
def bring_step(at):
    """Restore the values saved by `alpha_step`."""
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
    """Rescale the values a fraction of a step ahead or behind, for steps of `ratio` times the length."""
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
    """Repeat a failed `alpha_step` in parts, from its saved values."""
    view(view(view(at, 1, CTL)[0]["mach"], 1, MACH)[0]["clock"], 16, I8)[REJECTED] += 1
    status = DIVERGED
    parts = DIVISION
    while parts <= MAX_PARTS:
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
