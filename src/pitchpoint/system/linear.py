# SPDX-License-Identifier: Apache-2.0
"""Linear algebra on the workspace: factorisation, solution with constraint rows, accelerations."""

from __future__ import annotations

import math

from pitchpoint.core.kernel import call, kernel, view
from pitchpoint.core.status import JAMMED, NOT_FINITE, OK
from pitchpoint.multibody.block_lu import FACTOR, SOLVE, factorise, substitute
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.multibody.constraints import schur_factor, schur_solve
from pitchpoint.system.residual import FORCES, MASS, residual
from pitchpoint.system.workspace import FACTORISATIONS, MACH, REDUNDANT

MAX_PASSES = 200
SETTLED = 1e-13
"""Relative change of the accelerations at which the iteration of joint friction has converged."""
PATIENCE = 3
"""Passes without a halved correction before it is tested for round-off; doubled after each test."""
LONGER = 1e6
"""Scale factor of the correction in this test: round-off does not increase with it."""
CLEARLY = 0.05
"""Required margin between the convergence ratios of the scaled and the unscaled correction."""


@kernel
def factor_entry(at, mass, other):
    """Factor the matrix in the workspace and, with constraints, the Schur complement.

    With `mass` the matrix is the mass matrix only; its (possibly shorter) programmes are also used by the
    solution.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    A = view(c["A"], (c["na"], 6, 6), F8)
    clock = view(m["clock"], 16, I8)
    clock[FACTORISATIONS] += 1
    m["solve_now"] = m["mass_solve"] if mass != 0 else m["solve"]
    m["nsolve_now"] = m["nmass_solve"] if mass != 0 else m["nsolve"]
    which = m["mass_factor"] if mass != 0 else m["factor"]
    rows = m["nmass_factor"] if mass != 0 else m["nfactor"]
    status = factorise(view(which, rows, FACTOR), A, view(m["T"], (6, 6), F8), view(m["order6"], 6, I8))
    if status != OK:
        return status
    nc = c["nc"]
    if nc > 0:
        clock[REDUNDANT] = schur_factor(
            view(c["G"], (nc, c["nd"]), F8),
            A,
            view(m["solve_now"], m["nsolve_now"], SOLVE),
            view(m["Y"], (nc, c["nd"]), F8),
            view(m["S"], (nc, nc), F8),
            view(m["diag"], nc, F8),
            view(m["order"], nc, I8),
            view(m["used"], nc, I8),
            view(m["y6"], 6, F8),
        )
    return OK


@kernel
def factor(at):
    """Factor the matrix in the workspace, called by the address of `factor_entry`."""
    return call(view(view(at, 1, CTL)[0]["mach"], 1, MACH)[0]["factor_entry"], at, 0, 0)


@kernel
def factor_mass(at):
    """Factor the mass matrix in the workspace, see `factor_entry`."""
    return call(view(view(at, 1, CTL)[0]["mach"], 1, MACH)[0]["factor_entry"], at, 1, 0)


@kernel
def solve_entry(at, spare, other):
    """Solve A x + G^T y = -R, G x = -g with the factors in the workspace; writes x and y there."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    x = view(m["x"], nd, F8)
    R = view(c["R"], nd, F8)
    for i in range(nd):
        x[i] = -R[i]
    substitute(
        view(m["solve_now"], m["nsolve_now"], SOLVE),
        view(c["A"], (c["na"], 6, 6), F8),
        x,
        view(m["y6"], 6, F8),
    )
    nc = c["nc"]
    if nc > 0:
        schur_solve(
            view(c["G"], (nc, nd), F8),
            view(c["g"], nc, F8),
            view(m["Y"], (nc, nd), F8),
            view(m["S"], (nc, nc), F8),
            view(m["order"], nc, I8),
            view(m["used"], nc, I8),
            x,
            view(m["y"], nc, F8),
            view(m["z"], nc, F8),
        )
    return OK


@kernel
def solve(at):
    """Solve with the factors in the workspace, called by the address of `solve_entry`."""
    call(view(view(at, 1, CTL)[0]["mach"], 1, MACH)[0]["solve_entry"], at, 0, 0)


@kernel
def solve_acceleration(at, t, rate):
    """Accelerations and multipliers of the state in the workspace: M a + G^T lam = f, G a = -gtt.

    With rate > 0 [1/s] the rows are stabilised (Baumgarte): G a = -gtt - 2 rate (G v + gt) - rate^2 g.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    nc = c["nc"]
    a = view(c["a"], nd, F8)
    lam = view(c["lam"], nc, F8)
    x = view(m["x"], nd, F8)
    y = view(m["y"], nc, F8)
    for i in range(nd):
        a[i] = 0.0
    for r in range(nc):
        lam[r] = 0.0
    status = residual(at, t, MASS, 1.0, 0.0, 0.0)
    if status != OK:
        return status
    status = factor_mass(at)
    if status != OK:
        return status
    pull_back(at, rate)
    solve(at)
    total = 0.0
    for i in range(nd):
        a[i] = x[i]
        total += x[i]
    for r in range(nc):
        lam[r] = y[r]
    if m["settles"] != 0 and math.isfinite(total):
        return _settle_friction(at, t)
    return OK if math.isfinite(total) else NOT_FINITE


@kernel
def _settle_friction(at, t):
    """Fixed-point iteration of joint friction: joint loads depend on the accelerations and vice versa.

    Each pass solves the remaining residual with the factored mass matrix; it converges unless friction jams
    the mechanism. Large forces that cancel, such as tooth and bearing forces in steady operation, cause
    round-off that is not small relative to the accelerations. Corrections that no longer decrease are
    accepted as round-off if a scaled-up correction in the same direction does converge.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    nc = c["nc"]
    a = view(c["a"], nd, F8)
    lam = view(c["lam"], nc, F8)
    x = view(m["x"], nd, F8)
    y = view(m["y"], nc, F8)
    least = math.inf
    stalled = 0
    patience = PATIENCE
    for _ in range(MAX_PASSES):
        status = _correction(at, t)
        if status != OK:
            return status
        size = 0.0
        change = 0.0
        for i in range(nd):
            a[i] += x[i]
            size += abs(a[i])
            change += abs(x[i])
        for r in range(nc):
            lam[r] += y[r]
        if not math.isfinite(change):
            return NOT_FINITE
        if change <= SETTLED * size:
            return OK
        stalled += 1
        if change <= 0.5 * least:
            least = change
            stalled = 0
        if stalled == patience:
            ratio = _convergence_ratio(at, t, change)
            if not math.isfinite(ratio):
                return NOT_FINITE
            if ratio < 0.5 ** (1.0 / patience) - CLEARLY:
                return OK
            stalled = 0
            patience *= 2
    return JAMMED


@kernel
def _correction(at, t):
    """Solve the remaining residual with the factored mass matrix; results in x and y."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    nc = c["nc"]
    status = residual(at, t, FORCES, 0.0, 0.0, 0.0)
    if status != OK:
        return status
    a = view(c["a"], nd, F8)
    g = view(c["g"], nc, F8)
    G = view(c["G"], (nc, nd), F8)
    pull = view(m["pull"], nc, F8)
    for r in range(nc):
        s = pull[r]
        for i in range(nd):
            s += G[r, i] * a[i]
        g[r] = s
    solve(at)
    return OK


@kernel
def _convergence_ratio(at, t, change):
    """Convergence ratio of the next pass for the correction x, y scaled by `LONGER`; overwrites x and y."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    nc = c["nc"]
    a = view(c["a"], nd, F8)
    lam = view(c["lam"], nc, F8)
    x = view(m["x"], nd, F8)
    y = view(m["y"], nc, F8)
    step = view(m["step"], nd, F8)
    step_lam = view(m["step_lam"], nc, F8)
    for i in range(nd):
        step[i] = LONGER * x[i]
        a[i] += step[i]
    for r in range(nc):
        step_lam[r] = LONGER * y[r]
        lam[r] += step_lam[r]
    status = _correction(at, t)
    left = 0.0
    for i in range(nd):
        left += abs(step[i] + x[i])
        a[i] -= step[i]
    for r in range(nc):
        lam[r] -= step_lam[r]
    return left / (LONGER * change) if status == OK else math.nan


@kernel
def pull_back(at, rate):
    """Replace the position residuals g by the right-hand side of the acceleration constraints."""
    c = view(at, 1, CTL)[0]
    nd = c["nd"]
    nc = c["nc"]
    if nc == 0:
        return
    g = view(c["g"], nc, F8)
    gt = view(c["gt"], nc, F8)
    gtt = view(c["gtt"], nc, F8)
    G = view(c["G"], (nc, nd), F8)
    v = view(c["v"], nd, F8)
    pull = view(view(c["mach"], 1, MACH)[0]["pull"], nc, F8)
    for r in range(nc):
        s = gt[r]
        for i in range(nd):
            s += G[r, i] * v[i]
        g[r] = gtt[r] + 2.0 * rate * s + rate * rate * g[r]
        pull[r] = g[r]
