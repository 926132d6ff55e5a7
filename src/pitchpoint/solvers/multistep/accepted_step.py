# SPDX-License-Identifier: Apache-2.0
"""Output of an accepted multistep step: samples, statistics and events on its polynomial."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.multibody.channels import CTL, F8
from pitchpoint.solvers.explicit.dense_output import find_events
from pitchpoint.solvers.explicit.derivative import DENSE, OLD, ROWS
from pitchpoint.solvers.multistep.history import DEPTH, dense_weights, slopes_at, weights_at
from pitchpoint.solvers.multistep.order_control import PAST
from pitchpoint.solvers.sampling import samples_up_to, take
from pitchpoint.system.residual import evaluate_events
from pitchpoint.system.workspace import MACH


@kernel
def view_past(at, where):
    """Rows of the history, their times, scratch weights."""
    c = view(at, 1, CTL)[0]
    b = view(where, 1, PAST)[0]
    size = 2 * c["nd"] + 3 * c["nc"]
    return (
        view(b["rows"], (DEPTH, size), F8),
        view(b["times"], DEPTH, F8),
        view(b["p"], 2 * DEPTH, F8),
        view(b["W"], (DEPTH, DEPTH), F8),
    )


@kernel
def keep_accelerations(at):
    """Save the accelerations of the workspace, for a failed step."""
    c = view(at, 1, CTL)[0]
    a = view(c["a"], c["nd"], F8)
    ap = view(view(c["mach"], 1, MACH)[0]["ap"], c["nd"], F8)
    for i in range(a.size):
        ap[i] = a[i]


@kernel
def go_back(at, where):
    """Restore the state before the step, with its saved accelerations."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    b = view(where, 1, PAST)[0]
    nd = c["nd"]
    nc = c["nc"]
    newest = view(b["rows"], 2 * nd + nc, F8)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    ap = view(m["ap"], nd, F8)
    lam = view(c["lam"], nc, F8)
    for i in range(nd):
        q[i] = newest[i]
        v[i] = newest[nd + i]
        a[i] = ap[i]
    for r in range(nc):
        lam[r] = newest[2 * nd + r]


@kernel
def _look_back(at, where, s, n):
    """Interpolate the state at the offset s, within the last step, into the workspace."""
    c = view(at, 1, CTL)[0]
    nd = c["nd"]
    nc = c["nc"]
    rows, times, w, _ = view_past(at, where)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    lam = view(c["lam"], nc, F8)
    weights_at(times, n, s, w[:DEPTH])
    slopes_at(times, n, s, w[DEPTH:])
    for i in range(nd):
        x = 0.0
        y = 0.0
        z = 0.0
        for j in range(n):
            x += w[j] * rows[j, i]
            y += w[j] * rows[j, nd + i]
            z += w[DEPTH + j] * rows[j, nd + i]
        q[i] = x
        v[i] = y
        a[i] = z
    for r in range(nc):
        x = 0.0
        for j in range(n):
            x += w[j] * rows[j, 2 * nd + r]
        lam[r] = x


@kernel
def prepare_events(at, where, h, n):
    """Store the dense output coefficients of the last step for the event search; returns their degree."""
    c = view(at, 1, CTL)[0]
    nd = c["nd"]
    rows, times, w, W = view_past(at, where)
    stage = view(view(c["mach"], 1, MACH)[0]["stage"], (ROWS, 2 * nd), F8)
    dense_weights(times, n, h, W, w)
    for i in range(2 * nd):
        for r in range(n):
            s = 0.0
            for j in range(n):
                s += W[r, j] * rows[j, i]
            stage[OLD if r == 0 else DENSE + r - 1, i] = s
    return n - 1


@kernel
def leave_behind(at, where, grid, watch, recorder):
    """Record samples, statistics and events of the last step; restores the state after it."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    b = view(where, 1, PAST)[0]
    h = b["used"]
    t = b["t"]
    done = recorder.done
    measure = 1 if recorder.sums.shape[0] > 0 else 0
    n = min(b["points"] - 1, b["next_k"] + 1)
    keep_accelerations(at)
    if watch:
        dense = prepare_events(at, where, h, n)
        done[2], share = find_events(at, t - h, h, dense, recorder.found, done[2], b["wanted"])
        if share < 0.0:
            return NOT_FINITE
    if grid[1] > 0.0:
        for k in range(samples_up_to(t - h, grid) + 1, samples_up_to(t, grid) + 1):
            s = grid[0] + k * grid[1]
            if s >= t:
                go_back(at, where)
            else:
                _look_back(at, where, s - t, n)
            status = take(at, s, recorder, measure, 1)
            if status != OK:
                return status
    go_back(at, where)
    return evaluate_events(at, t, m["ev0"]) if watch else OK
