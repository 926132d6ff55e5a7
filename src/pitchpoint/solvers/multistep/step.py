# SPDX-License-Identifier: Apache-2.0
"""Backward differentiation formulas of order 1 to 6 for all kinds of coefficients and forms of constraints.

A step predicts state and derivative at t + h by the polynomial through the last k + 1 values and solves

    y' = y'_p + alpha / h (y - y_p),   alpha = sum 1/i  or  sum h / (t + h - t_i)

for the state: the rates are then v = q'_p + alpha/h (q - q_p), and their derivative follows in the same way.
The kinds differ in alpha and in the history: LEADING has the leading coefficient of constant steps; VARIABLE
uses the last k values at their actual times; FIXED has the coefficients of constant steps, and interpolates
the history to the new grid when the step changes, like a Nordsieck array (C. W. Gear, Numerical Initial Value
Problems in Ordinary Differential Equations, 1971, 9.2); CONSTANT has a given step and order, and no error
control. Forms: `constrained_newton`.

When a spin angle is wrapped, its history is shifted by the whole turns. After a reset of a rotation chart,
and after an event, the method continues with a new history (`multistep.restart`).
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import call, kernel, view
from pitchpoint.core.status import DIED, DIVERGED, OK, SLOW, STEP_UNDERFLOW
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.solvers.implicit.constrained_newton import ITERATION, constrained_step
from pitchpoint.solvers.implicit.newton import rows_hold
from pitchpoint.solvers.multistep.accepted_step import go_back, keep_accelerations, leave_behind, view_past
from pitchpoint.solvers.multistep.history import (
    DEPTH,
    combine,
    push,
    regrid,
    slopes_at,
    weights_at,
)
from pitchpoint.solvers.multistep.order_control import (
    CONSTANT,
    FIXED,
    LARGEST,
    LEADING,
    PAST,
    choose,
    judge,
    set_allowed,
    shrink,
)
from pitchpoint.solvers.sampling import recorder_at
from pitchpoint.system.residual import wrap
from pitchpoint.system.workspace import MACH, RECHARTED, REJECTED, STEPS, VALID

NEWTON_SHARE = 0.02
"""Tolerance of the Newton iteration relative to that of the step."""
ROUND_OFF = 2e-15
"""Smallest relative tolerance of the iterated values: some units of rounding."""
RADIUS = 0.1
"""Reference size of rounding [m, rad] without constraints: the travel of teeth is an angle times a radius.
The tolerances of methods with error control are above this rounding, those of constant steps are not."""
FIRST_SHARE = 0.5
"""Error of the first step at order 1 over the tolerance."""
LADDER = 1.0 / 1024.0
"""First step over the constant step: it starts at order 1, whose error must remain negligible."""
SAME = 1e-9
"""Relative difference up to which two steps count as equal."""
ANEW = 1e-10
"""Smallest relative time between two restarts at order 1 after a failed event search."""


@kernel
def begin(at, where, nominal, reach):
    """Start at order 1 with the state in the workspace; the second row follows from its derivatives."""
    c = view(at, 1, CTL)[0]
    b = view(where, 1, PAST)[0]
    nd = c["nd"]
    nc = c["nc"]
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    lam = view(c["lam"], nc, F8)
    rows, times, _, _ = view_past(at, where)
    for i in range(nd):
        rows[0, i] = q[i]
        rows[0, nd + i] = v[i]
    for r in range(nc):
        rows[0, 2 * nd + r] = lam[r]
        for j in range(2):  # integrals start at zero
            rows[j, 2 * nd + nc + r] = 0.0
            rows[j, 2 * nd + 2 * nc + r] = 0.0
    set_allowed(at, where)
    allowed = view(b["allowed"], 2 * nd, F8)
    total = 0.0
    for i in range(nd):
        total += (a[i] / allowed[i]) ** 2
    curvature = math.sqrt(total / max(nd, 1))
    h = LADDER * nominal
    if b["kind"] != CONSTANT:
        h = 1e-3 * reach
        if curvature * h * h > 2.0 * FIRST_SHARE:
            h = math.sqrt(2.0 * FIRST_SHARE / curvature)
    h = min(h, nominal)
    for i in range(nd):
        rows[1, i] = q[i] - h * v[i] + 0.5 * h * h * a[i]
        rows[1, nd + i] = v[i] - h * a[i]
    for r in range(nc):
        rows[1, 2 * nd + r] = lam[r]
        rows[1, 2 * nd + nc + r] = -h * lam[r]
    times[0] = 0.0
    times[1] = -h
    b["h"] = h
    b["gridded"] = h
    b["k"] = 1
    b["origin"] = b["t"]
    b["points"] = 2
    b["steady"] = 0
    b["failures"] = 0
    b["rising"] = 1
    view(view(c["mach"], 1, MACH)[0]["clock"], 16, I8)[VALID] = 0  # the rotation chart may have changed


@kernel
def _leading(where, times, h):
    """Leading coefficient alpha / h of the step."""
    b = view(where, 1, PAST)[0]
    total = 0.0
    for i in range(1, b["k"] + 1):
        total += 1.0 / (i * h) if b["kind"] == LEADING else 1.0 / (h - times[i - 1])
    return total


@kernel
def _predict(at, where, h):
    """Write the prediction to the workspace and set the factors and tolerances of the Newton iteration."""
    c = view(at, 1, CTL)[0]
    b = view(where, 1, PAST)[0]
    n = view(b["iteration"], 1, ITERATION)[0]
    nd = c["nd"]
    nc = c["nc"]
    rows, times, w, W = view_past(at, where)
    k = b["k"]
    if b["kind"] == FIXED and not abs(h - b["gridded"]) <= SAME * h:
        regrid(rows, times, k + 1, h, W)
        b["points"] = k + 1
        b["gridded"] = h
    size = rows.shape[1]
    ahead = view(b["ahead"], size, F8)
    slope = view(b["slope"], size, F8)
    weights_at(times, k + 1, h, w)
    combine(rows, k + 1, w, ahead)
    slopes_at(times, k + 1, h, w)
    combine(rows, k + 1, w, slope)
    cd = _leading(where, times, h)
    n["t"] = b["t"] + h
    n["cd"] = cd
    n["cm"] = cd * cd
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    lam = view(c["lam"], nc, F8)
    allowed = view(b["allowed"], 2 * nd, F8)
    per_q = view(n["per_q"], nd, F8)
    per_v = view(n["per_v"], nd, F8)
    for i in range(nd):
        q[i] = ahead[i]
        v[i] = slope[i]
        a[i] = slope[nd + i] + cd * (slope[i] - ahead[nd + i])
        # constraint rows are rounded at the size of the machine, forces at the size of gears
        size = 1.0 if nc > 0 else RADIUS if b["kind"] == CONSTANT else 0.0
        floor = ROUND_OFF * (abs(q[i]) + size)
        per_q[i] = 1.0 / max(NEWTON_SHARE * allowed[i], floor)
        per_v[i] = 0.0
        if b["rates"] != 0:
            per_v[i] = 1.0 / max(NEWTON_SHARE * allowed[nd + i], ROUND_OFF * abs(v[i]) + cd * floor)
    for r in range(nc):
        lam[r] = slope[2 * nd + nc + r] if b["integrals"] != 0 else ahead[2 * nd + r]


@kernel
def _collect(at, where):
    """Store the state in the workspace as a new row of the history."""
    c = view(at, 1, CTL)[0]
    b = view(where, 1, PAST)[0]
    n = view(b["iteration"], 1, ITERATION)[0]
    nd = c["nd"]
    nc = c["nc"]
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    lam = view(c["lam"], nc, F8)
    mu = view(n["mu"], nc, F8)
    size = 2 * nd + 3 * nc
    new = view(b["new"], size, F8)
    ahead = view(b["ahead"], size, F8)
    slope = view(b["slope"], size, F8)
    for i in range(nd):
        new[i] = q[i]
        new[nd + i] = v[i]
    for r in range(nc):
        new[2 * nd + r] = lam[r]
        eta = 2 * nd + nc + r
        xi = eta + nc
        new[eta] = ahead[eta] + (lam[r] - slope[eta]) / n["cd"]
        new[xi] = ahead[xi] + (mu[r] - slope[xi]) / n["cd"]


@kernel
def _time_after(where, h, limit, nominal):
    """Time at the end of a step, rounded to the limit or to the grid of constant steps."""
    b = view(where, 1, PAST)[0]
    t = b["t"] + h
    if abs(limit - t) <= SAME * h + ROUND_OFF * abs(limit):
        return limit
    unit = LADDER * nominal
    if b["kind"] == CONSTANT and h > 0.9 * unit:
        return b["origin"] + math.floor((t - b["origin"]) / unit + 0.5) * unit
    return t


@kernel
def step(at, where, spare):
    """Take one accepted step that ends at the limit or before, and append it to the history.

    Called through its address, so that it is not compiled again in the driver.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    b = view(where, 1, PAST)[0]
    clock = view(m["clock"], 16, I8)
    rows, times, _, _ = view_past(at, where)
    new = view(b["new"], rows.shape[1], F8)
    limit = b["limit"]
    nominal = view(b["tol"], LARGEST + 1, F8)[LARGEST]
    keep_accelerations(at)
    set_allowed(at, where)
    while True:
        h = min(b["h"], nominal)
        rest = limit - b["t"]
        cut = 0
        if h >= rest * (1.0 - SAME):
            same = abs(h - rest) <= SAME * h + ROUND_OFF * abs(limit)
            cut = 0 if same else 1
            h = h if same else rest
        elif h > 0.5 * rest and b["kind"] != CONSTANT:
            cut = 1
            h = 0.5 * rest
        if not h > 1e-14 * max(abs(b["t"]), 1e-9):
            return STEP_UNDERFLOW
        _predict(at, where, h)
        status = constrained_step(at, b["iteration"], b["iterate"])
        solved = status == OK
        if solved and c["nc"] > 0:
            status = rows_hold(at, b["t"] + h)
            if status != OK:
                go_back(at, where)
                return status
        if solved:
            _collect(at, where)
            judge(at, where, h)
            if b["error"] <= 1.0:
                break
        elif status == DIED:
            go_back(at, where)
            return status
        clock[REJECTED] += 1
        shrink(where, h, solved)
        go_back(at, where)
        if not b["h"] > 1e-14 * max(abs(b["t"]), 1e-9):
            return STEP_UNDERFLOW if status == OK else status
        c["bad"] = -1  # the retry with a shorter step may succeed
        c["badkind"] = -1
    choose(at, where, h, cut, nominal)
    push(rows, times, min(b["points"], DEPTH - 1), h)
    b["points"] = min(b["points"] + 1, DEPTH)
    for i in range(new.size):
        rows[0, i] = new[i]
    b["used"] = h
    b["t"] = _time_after(where, h, limit, nominal)
    if cut != 0:
        b["origin"] = b["t"]
    return OK


@kernel
def _go_on(at, where, nominal, reach):
    """Restart from the state in the workspace, at order 1 if its derivatives are unreliable."""
    if call(view(where, 1, PAST)[0]["resume"], at, where, 0) != OK:
        begin(at, where, nominal, reach)


@kernel
def _follow_turns(at, where, nominal, reach):
    """Wrap spin angles and shift their history; restart after a reset of a rotation chart."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    b = view(where, 1, PAST)[0]
    clock = view(m["clock"], 16, I8)
    q = view(c["q"], c["nd"], F8)
    spins = view(m["spins"], (m["nspins"], 2), I8)
    rows, _, _, _ = view_past(at, where)
    fresh = clock[RECHARTED]
    wrap(at)
    if clock[RECHARTED] != fresh:
        _go_on(at, where, nominal, reach)
        return
    for e in range(spins.shape[0]):
        d = spins[e, 0]
        moved = q[d] - rows[0, d]
        if moved != 0.0:
            for j in range(b["points"]):
                rows[j, d] += moved


@kernel(inline=True)
def advance_multistep(at, where, t_end, grid, most, restart, recorder):
    """Integrate to t_end, with at most `most` steps; grid: time of sample 0, sample period (0: none).

    restart != 0: steps end at events, and the method restarts there with a new history.
    """
    c = view(at, 1, CTL)[0]
    b = view(where, 1, PAST)[0]
    clock = view(view(c["mach"], 1, MACH)[0]["clock"], 16, I8)
    nominal = view(b["tol"], LARGEST + 1, F8)[LARGEST]
    watch = c["ne"] > 0 and recorder.found.shape[0] > 0
    done = recorder.done
    anew = b["t"]
    if b["k"] == 0:
        begin(at, where, nominal, t_end - b["t"])
    while b["t"] < t_end and done[0] < most:
        b["limit"] = t_end
        b["event"] = 0
        seek = watch and restart != 0
        status = call(b["seek"] if seek else b["step"], at, where, 0)
        lost = status == STEP_UNDERFLOW or status == DIVERGED or status == SLOW
        if seek and lost and b["t"] >= anew:
            # very short steps to events make the history inaccurate: restart, and step over events
            anew = b["t"] + ANEW * max(abs(b["t"]), 1e-9)
            c["bad"] = -1
            c["badkind"] = -1
            begin(at, where, nominal, t_end - b["t"])
            seek = False
            status = call(b["step"], at, where, 0)
        if status != OK:
            return status
        status = leave_behind(at, where, grid, watch and (b["event"] != 0 or not seek), recorder)
        if status != OK:
            return status
        _follow_turns(at, where, nominal, max(t_end - b["t"], b["used"]))
        if b["event"] != 0:
            b["events"] += 1
            _go_on(at, where, nominal, max(t_end - b["t"], b["used"]))
        clock[STEPS] += 1
        done[0] += 1
    return OK


#: Arguments of `advance_multistep` from Python.
ORDER = np.dtype(
    [
        *((name, "f8") for name in ("t_end", "sample_zero", "sample")),
        *((name, "i8") for name in ("past", "most", "restart")),
    ],
    align=True,
)


@kernel
def entry(at, order, recorder):
    """Execute an ORDER; both arguments are addresses of records."""
    o = view(order, 1, ORDER)[0]
    grid = (o["sample_zero"], o["sample"])
    return advance_multistep(at, o["past"], o["t_end"], grid, o["most"], o["restart"], recorder_at(recorder))
