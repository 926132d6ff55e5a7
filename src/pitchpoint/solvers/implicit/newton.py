# SPDX-License-Identifier: Apache-2.0
"""Modified Newton iteration of an implicit step.

The matrix is reused over steps and refactored when convergence is slow, finally at every iterate: long steps
through a stiff contact need this. An iterate is accepted when the remaining error,
|dq| theta / (1 - theta) with the last measured contraction rate theta, is below the tolerance.

At a force jump, such as the entry of a tooth pair with a rectangular stiffness curve, a step may end so close
to the jump that neither side has a solution: the force of each side pushes the state to the other side, and
the iteration alternates. The step then has a solution *at* the jump, with a force between those of the two
sides (A. F. Filippov, Differential Equations with Discontinuous Righthand Sides, 1988). `_at_jump` locates it
by bisection and accepts it only if a mean of both forces is in balance; otherwise the step fails.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import DIVERGED, INCONSISTENT, NOT_FINITE, OK, SLOW
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.system.linear import factor, solve
from pitchpoint.system.residual import FORCES, NEWTON, residual
from pitchpoint.system.workspace import EVALUATIONS, ITERATIONS, MACH, REDUNDANT, STAGE_ROWS, VALID

MAX_ITERATIONS = 12
MAX_REFRESHES = 3
SLOW_RATE = 0.5
MANY = 4
"""Corrections in a step, above which the next step may get a new matrix. With 2 instead of 4, gearboxes on
elastic shafts take up to 1.6 times as long."""
FEWEST, EXTRA = 1, 2
"""Places of the corrections in the step with a new matrix, and of the further ones in the steps since then;
-1: the matrix is new."""
WORTH = 6.0
"""Further corrections with an old matrix until a new one is made: a matrix with its factors costs as much as
6 to 10 corrections, so both cost the same."""
FADING = 1.2
"""Growth of the contraction rate per step without measurement, as the matrix becomes outdated."""

TRUSTED = 0.1
"""Contraction rate up to which one iteration per step is enough if the mass matrix changes with the rotation.
The remaining error enters the next prediction threefold: from a rate of one third it would grow."""
QUIET = 1e-7
"""Change of the accelerations [m/s^2] that counts as rounding at any rate."""

ROW_TOLERANCE = 1e-7
ROW_GOAL = 1e-13
"""Residual of a row [m, rad] that may remain: closing 1 um in a step of 10 us takes 1e4 m/s^2."""
ROW_SHARE = 100.0
ASTRAY = 0.75
"""Ratio of successive corrections with an old matrix from which they are undone."""
GUESS = 2
"""First of two rows of the stages that store the prediction."""
MAX_BISECTIONS = 60
MAX_TRIES = 6
"""Number of bisections towards a jump; the error of each is the relative error of the reused matrix."""


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
def _move(q, v, a, e, share, cm, cd):
    """Apply a fraction of a correction."""
    for i in range(q.size):
        q[i] += share * e[i]
        v[i] += share * cd * e[i]
        a[i] += share * cm * e[i]


@kernel
def _correction(at, t, cm, cd, e, fresh):
    """Compute the Newton correction in the workspace, with a new (fresh 1) or the present matrix.

    Returns status and share: the component of the correction along e, relative to e, in the error norm.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    clock = view(m["clock"], 16, I8)
    status = residual(at, t, NEWTON if fresh else FORCES, cm, cd, 1.0)
    clock[EVALUATIONS] += 1
    if status == OK and fresh:
        status = factor(at)
    if status != OK:
        return status, 0.0
    solve(at)
    clock[ITERATIONS] += 1
    x = view(m["x"], e.size, F8)
    weight = view(m["weight"], e.size, F8)
    along = 0.0
    size = 0.0
    for i in range(e.size):
        w = weight[i] * weight[i] * e[i]
        along += w * x[i]
        size += w * e[i]
    share = along / size if size != 0.0 else 0.0  # no correction left
    return (OK if math.isfinite(share) else NOT_FINITE), share


@kernel
def _at_jump(at, t, cm, cd, tol, failure):
    """Find the solution at a force jump; returns `failure` if there is none.

    From the last iterate the correction e leads to the other side of the jump, where the correction must
    point back. Bisection narrows the bracket. The weighted mean of both corrections without component along e
    is the correction for a force between the two sides.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    lam = view(c["lam"], c["nc"], F8)
    x = view(m["x"], nd, F8)
    y = view(m["y"], c["nc"], F8)
    weight = view(m["weight"], nd, F8)
    stage = view(m["stage"], (STAGE_ROWS, 2 * nd), F8)
    e = stage[0, :nd]
    beyond = stage[1, :nd]
    view(m["clock"], 16, I8)[VALID] = 0  # the next step needs a new matrix in any case
    for _ in range(MAX_TRIES):
        status, _ = _correction(at, t, cm, cd, x, True)
        if status != OK:
            return status
        for i in range(nd):
            e[i] = x[i]
        size = abs(largest_entry(e, weight))
        if size <= 1e-3 * tol:
            return OK
        here = 1.0  # correction on this side and on the other, relative to e
        there = 1.0
        width = 1.0  # distance of both sides, relative to e
        for k in range(MAX_BISECTIONS):
            _move(q, v, a, e, width, cm, cd)
            status, share = _correction(at, t, cm, cd, e, False)
            if status != OK:
                return status
            if share > 0.0:
                if k == 0:
                    return failure  # the other side does not point back
                here = share
            else:
                there = share
                for i in range(nd):
                    beyond[i] = x[i]
                for r in range(lam.size):
                    lam[r] += y[r]
                _move(q, v, a, e, -width, cm, cd)
            if width * size <= tol:
                break
            width *= 0.5
        status, here = _correction(at, t, cm, cd, e, False)
        if status != OK:
            return status
        if not here > 0.0:
            return failure
        near = there / (there - here)
        for i in range(nd):
            x[i] = near * x[i] + (1.0 - near) * beyond[i]
        for r in range(lam.size):  # lam is of the other side, and y is the change to this one
            lam[r] += near * y[r]
        _move(q, v, a, x, 1.0, cm, cd)
        if abs(largest_entry(x, weight)) <= tol:
            return OK
    return failure


@kernel
def keep_guess(at):
    """Save the prediction, for iterations that diverge."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    stage = view(m["stage"], (STAGE_ROWS, 2 * nd), F8)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    lam = view(c["lam"], c["nc"], F8)
    kept = view(m["pull"], c["nc"], F8)
    for i in range(nd):
        stage[GUESS, i] = q[i]
        stage[GUESS, nd + i] = v[i]
        stage[GUESS + 1, i] = a[i]
    for r in range(lam.size):
        kept[r] = lam[r]


@kernel
def back_to_guess(at):
    """Restore the prediction, for a restart of Newton's method with a new matrix there.

    Near positions where rows lose rank the reused matrix may be of the other side: its corrections diverge,
    and may lead to another branch of the mechanism.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    stage = view(m["stage"], (STAGE_ROWS, 2 * nd), F8)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    lam = view(c["lam"], c["nc"], F8)
    kept = view(m["pull"], c["nc"], F8)
    for i in range(nd):
        q[i] = stage[GUESS, i]
        v[i] = stage[GUESS, nd + i]
        a[i] = stage[GUESS + 1, i]
    for r in range(lam.size):
        lam[r] = kept[r]


@kernel
def _open(at):
    """Largest residual of the non-redundant rows before the last correction."""
    c = view(at, 1, CTL)[0]
    g = view(c["g"], c["nc"], F8)
    used = view(view(c["mach"], 1, MACH)[0]["used"], c["nc"], I8)
    most = 0.0
    for r in range(g.size):
        if used[r] != 0:
            most = max(most, abs(g[r]))
    return most


@kernel
def stale(at, cm, theta):
    """Whether the contraction rate of a reused matrix must be measured before a step is accepted.

    A mass matrix that changes with the rotation becomes outdated at any step size: without measurement of the
    rate, very short steps would leave an error of the whole position tolerance in every acceleration.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    if theta <= TRUSTED or m["constant_mass"] != 0:
        return False
    return cm * abs(largest_entry(view(m["x"], c["nd"], F8), view(m["weight"], c["nd"], F8))) > QUIET


@kernel
def newton_step(at, t, cm, cd, tol):
    """Iterate one step to convergence; q, v, a, lam contain the prediction and become the solution."""
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
    # increase an old contraction rate until it is measured again
    real[0] = min(FADING * real[0], SLOW_RATE)
    last = -1.0
    before = 0.0
    count = 0
    refreshes = 0
    full = 0  # full Newton iterations, with a new matrix each
    aged = clock[VALID] != 0 and nc > 0  # rows with an old matrix
    if aged:
        keep_guess(at)
    for _ in range(MAX_ITERATIONS * (2 + MAX_REFRESHES)):
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
            real[0] = min(real[0], 0.1)  # reset the rate for the new matrix
            real[EXTRA] = -1.0
            last = -1.0
            count = 0
        solve(at)
        clock[ITERATIONS] += 1
        count += 1
        size = abs(largest_entry(x, weight))
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
        outdated = False
        # rows change with the state: the rate of the last step does not hold for large corrections, and the
        # remaining residual of the rows would cause a jump of the multipliers with the next new matrix
        known = nc == 0 or size <= tol or (last > 0.0 and _open(at) * theta <= ROW_GOAL)
        if theta > TRUSTED and stale(at, cm, theta):
            if last < 0.0:
                last = size
                before = size
                continue
            outdated = True
        if known and theta < 1.0 and size * theta / (1.0 - theta) <= tol:
            if real[EXTRA] < 0.0:
                real[FEWEST] = count
                real[EXTRA] = 0.0
            real[EXTRA] += max(count - real[FEWEST], 0.0)
            if (count > MANY and real[EXTRA] >= WORTH) or theta > SLOW_RATE or outdated:
                clock[VALID] = 0
            return OK
        if size <= 1e-3 * tol:
            return OK
        if full > 0 or (theta > SLOW_RATE and last > 0.0) or count >= MAX_ITERATIONS:
            if full >= MAX_ITERATIONS:
                return _at_jump(at, t, cm, cd, tol, DIVERGED if size >= before else SLOW)
            if refreshes >= MAX_REFRESHES:
                full += 1  # stiff contact within the step: the matrix changes with every iterate
            refreshes += 1
            clock[VALID] = 0
            if aged and size > ASTRAY * last:
                back_to_guess(at)
            aged = False
        last = size
        before = size
    return SLOW


@kernel
def rows_hold(at, t):
    """Check that the redundant rows are satisfied at the accepted state.

    Their residual may be as large as the tolerance allows in the other rows.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    g = view(c["g"], c["nc"], F8)
    used = view(m["used"], c["nc"], I8)
    clock = view(m["clock"], 16, I8)
    if clock[REDUNDANT] == 0:
        return OK
    status = residual(at, t, FORCES, 0.0, 0.0, 0.0)  # g is still that of the last iterate
    if status != OK:
        return status
    left = 0.0
    for r in range(g.size):
        if used[r] != 0:
            left = max(left, abs(g[r]))
    for r in range(g.size):
        if used[r] == 0 and abs(g[r]) > ROW_TOLERANCE + ROW_SHARE * left:
            c["bad"] = r
            return INCONSISTENT
    return OK
