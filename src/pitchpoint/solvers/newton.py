# SPDX-License-Identifier: Apache-2.0
"""The modified Newton iteration of an implicit step.

The matrix is kept over steps and factored again when the iteration slows down. An iterate is accepted when
the error that is left, |dq| theta / (1 - theta) with the last measured contraction rate theta, is below the
tolerance.

Where a force jumps, as when a tooth pair enters a mesh whose stiffness is a rectangular wave, a step may end
so close to the jump that neither side has a solution: the force of one side pushes the state to the other.
The iteration then swings between both. It is accepted there: each side is a solution to within the swing,
beta h^2 times the jump over the mass, which is the error of any step across a jump.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import DIVERGED, INCONSISTENT, NOT_FINITE, OK, SLOW
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.system.linear import factor, solve
from pitchpoint.system.residual import FORCES, NEWTON, residual
from pitchpoint.system.workspace import EVALUATIONS, ITERATIONS, MACH, VALID

MOST_ITERATIONS = 12
MOST_REFRESHES = 3
SLOW_RATE = 0.5
ROW_TOLERANCE = 1e-7
SWING = 0.02
"""Relative difference up to which two opposite corrections count as a swing over a jump."""


@kernel
def largest_entry(x, weight):
    """Weighted entry of the largest magnitude, with its sign; not finite if any entry is not."""
    most = 0.0
    total = 0.0
    for i in range(x.size):
        s = x[i] * weight[i]
        total += abs(s)
        if abs(s) > abs(most):
            most = s
    return most if math.isfinite(total) else total


@kernel
def newton_step(at, t, cm, cd, tol):
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
    before = 0.0
    count = 0
    refreshes = 0
    for _ in range(MOST_ITERATIONS * (1 + MOST_REFRESHES)):
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
        swing = largest_entry(x, weight)
        size = abs(swing)
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
                if abs(swing + before) <= SWING * size:
                    clock[VALID] = 0
                    return OK
                return DIVERGED if theta >= 1.0 else SLOW
            refreshes += 1
            clock[VALID] = 0
        last = size
        before = swing
    return SLOW


@kernel
def rows_hold(at):
    """Check that flagged redundant rows are satisfied by the others."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    g = view(c["g"], c["nc"], F8)
    used = view(m["used"], c["nc"], I8)
    for r in range(g.size):
        if used[r] == 0 and abs(g[r]) > ROW_TOLERANCE:
            return INCONSISTENT
    return OK
