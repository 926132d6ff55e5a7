# SPDX-License-Identifier: Apache-2.0
"""Common parts of the explicit methods: derivative of the state, stages in the workspace."""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.system.linear import solve, solve_acceleration
from pitchpoint.system.residual import FORCES, residual
from pitchpoint.system.workspace import EVALUATIONS, MACH, STAGE_ROWS, VALID

#: Rows of `stage` after the 16 stages: state before and after the step, dense output; number of rows.
OLD, NEW, DENSE, ROWS = 16, 17, 18, STAGE_ROWS
#: Slot of `real` with the time of the derivative in the first row of the stages; valid across calls.
SLOPE_AT = 5


@kernel
def slope(at, t, k, rate):
    """Store the derivative of the state in the workspace in row k of the stages."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    stage = view(m["stage"], (ROWS, 2 * nd), F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    clock = view(m["clock"], 16, I8)
    clock[EVALUATIONS] += 1
    if clock[VALID] != 0 and m["constant_mass"] != 0 and c["nc"] == 0:
        for i in range(nd):
            a[i] = 0.0
        status = residual(at, t, FORCES, 0.0, 0.0, 0.0)
        if status != OK:
            return status
        solve(at)
        x = view(m["x"], nd, F8)
        total = 0.0
        for i in range(nd):
            a[i] = x[i]
            total += x[i]
        if not math.isfinite(total):
            return NOT_FINITE
    else:
        status = solve_acceleration(at, t, rate)
        if status != OK:
            return status
        clock[VALID] = 1
    for i in range(nd):
        stage[k, i] = v[i]
        stage[k, nd + i] = a[i]
    return OK


@kernel
def keep_state(at, k):
    """Copy the state of the workspace into a row of the stages."""
    c = view(at, 1, CTL)[0]
    nd = c["nd"]
    stage = view(view(c["mach"], 1, MACH)[0]["stage"], (ROWS, 2 * nd), F8)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    for i in range(nd):
        stage[k, i] = q[i]
        stage[k, nd + i] = v[i]


@kernel
def bring_state(at, k):
    """Copy a row of the stages into the state of the workspace."""
    c = view(at, 1, CTL)[0]
    nd = c["nd"]
    stage = view(view(c["mach"], 1, MACH)[0]["stage"], (ROWS, 2 * nd), F8)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    for i in range(nd):
        q[i] = stage[k, i]
        v[i] = stage[k, nd + i]
