# SPDX-License-Identifier: Apache-2.0
"""Restart of a multistep method at a force jump or kink: at order 3, from derivatives after the event.

The history before the event is invalid. Accelerations slightly later give jerk and its derivative (finite
differences with two points, in two passes, the second one with the states of the first); their Taylor series
gives a history for the time after the event. This costs five evaluations of the accelerations, while a start
at order 1 takes about ten steps with a new matrix each. If a mode is too stiff for finite differences, the
two passes disagree, and the method starts at order 1.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.solvers.multistep.accepted_step import view_past
from pitchpoint.solvers.multistep.order_control import CONSTANT, PAST, set_allowed
from pitchpoint.solvers.taylor import APART, DISAGREEMENT, forward_derivatives, integral_on, position_on
from pitchpoint.system.linear import solve_acceleration
from pitchpoint.system.workspace import MACH, VALID

ORDER_AFTER = 3
"""Order of the first step, equal to the number of known derivatives of the rates."""
MAX_TRIES = 3
"""Number of trial spacings, each an eighth of the previous one: the motion may be faster after the event."""
FIRST_SHARE = 0.25
"""Target error of the first step over the tolerance."""
NOW, SOON, LATER, SERIES = 4, 5, 6, 7
"""Rows of the history used as temporary storage of accelerations at three times and derivatives."""


@kernel
def _look(at, where, s, row):
    """Compute accelerations and multipliers at the offset s on the present Taylor series."""
    c = view(at, 1, CTL)[0]
    b = view(where, 1, PAST)[0]
    nd = c["nd"]
    nc = c["nc"]
    rows, _, _, _ = view_past(at, where)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    lam = view(c["lam"], nc, F8)
    for i in range(nd):
        now = rows[NOW, i]
        jerk = rows[SERIES, i]
        snap = rows[SERIES, nd + i]
        v[i] = integral_on(rows[0, nd + i], s, now, jerk, snap)
        q[i] = position_on(rows[0, i], rows[0, nd + i], s, now, jerk, snap)
    status = solve_acceleration(at, b["t"] + s, 0.0)
    for i in range(nd):
        rows[row, i] = a[i]
    for r in range(nc):
        rows[row, 2 * nd + r] = lam[r]
    return status


@kernel
def _differences(at, where, d):
    """Derivatives of accelerations and multipliers from their values at 0, d, 2 d; returns the change."""
    c = view(at, 1, CTL)[0]
    nd = c["nd"]
    nc = c["nc"]
    rows, _, _, _ = view_past(at, where)
    allowed = view(view(where, 1, PAST)[0]["allowed"], 2 * nd, F8)
    changed = 0.0
    for i in range(nd):
        one, two = forward_derivatives(rows[NOW, i], rows[SOON, i], rows[LATER, i], d)
        changed += ((two - rows[SERIES, nd + i]) / allowed[nd + i]) ** 2
        rows[SERIES, i] = one
        rows[SERIES, nd + i] = two
    for r in range(nc):
        k = 2 * nd + r
        one, two = forward_derivatives(rows[NOW, k], rows[SOON, k], rows[LATER, k], d)
        rows[SERIES, k] = one
        rows[SERIES, k + nc] = two
    return math.sqrt(changed)


@kernel
def _derive(at, where, h):
    """Compute the derivatives and restore the state; returns 1 if they are reliable."""
    c = view(at, 1, CTL)[0]
    b = view(where, 1, PAST)[0]
    nd = c["nd"]
    nc = c["nc"]
    rows, _, _, _ = view_past(at, where)
    allowed = view(b["allowed"], 2 * nd, F8)
    for k in range(rows.shape[1]):
        rows[SERIES, k] = 0.0
        rows[NOW, k] = 0.0
    status = _look(at, where, 0.0, NOW)
    good = status == OK
    d = APART * h
    changed = 0.0
    for times in range(2):
        if good and times == 0:
            good = _look(at, where, d, SOON) == OK
            for i in range(nd):
                rows[SERIES, i] = (rows[SOON, i] - rows[NOW, i]) / d
        elif good:
            good = _look(at, where, d, SOON) == OK
        if good:
            good = _look(at, where, 2.0 * d, LATER) == OK
            changed = _differences(at, where, d)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    lam = view(c["lam"], nc, F8)
    for i in range(nd):
        q[i] = rows[0, i]
        v[i] = rows[0, nd + i]
        a[i] = rows[NOW, i]
    for r in range(nc):
        lam[r] = rows[NOW, 2 * nd + r]
        rows[0, 2 * nd + r] = lam[r]
    c["bad"] = -1
    c["badkind"] = -1
    size = 1.0 / h
    for i in range(nd):
        size += DISAGREEMENT * (abs(rows[NOW, i]) + h * abs(rows[SERIES, i])) / allowed[nd + i]
    return 1 if good and changed * h * h <= size else 0


@kernel
def _first_step(at, where, h):
    """Step for the target error at order 3, at most h."""
    c = view(at, 1, CTL)[0]
    nd = c["nd"]
    rows, _, _, _ = view_past(at, where)
    allowed = view(view(where, 1, PAST)[0]["allowed"], 2 * nd, F8)
    squares = (0.0, 0.0, 0.0)
    positions = 0.0
    for i in range(nd):
        w = 1.0 / allowed[nd + i]
        squares = (
            squares[0] + (w * rows[NOW, i]) ** 2,
            squares[1] + (w * rows[SERIES, i]) ** 2,
            squares[2] + (w * rows[SERIES, nd + i]) ** 2,
        )
        positions += (rows[SERIES, nd + i] / allowed[i]) ** 2
    last = math.sqrt(squares[2])
    # frequency of an equivalent vibration, independent of its phase
    among = math.sqrt(squares[1] + math.sqrt(squares[0]) * last)
    pace = last / among if among > 0.0 else 0.0
    fourth = math.sqrt((positions + (last * pace) ** 2) / max(2 * nd, 1))
    wanted = 4.0 * FIRST_SHARE
    if fourth * h**4 > wanted:
        h = (wanted / fourth) ** 0.25
    return h


@kernel
def resume(at, where, spare):
    """Create a new history from the state in the workspace; returns 0 if a start at order 1 is needed."""
    c = view(at, 1, CTL)[0]
    b = view(where, 1, PAST)[0]
    nd = c["nd"]
    nc = c["nc"]
    rows, times, _, _ = view_past(at, where)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    for i in range(nd):
        rows[0, i] = q[i]
        rows[0, nd + i] = v[i]
    for r in range(2 * nc):
        rows[0, 2 * nd + nc + r] = 0.0
    set_allowed(at, where)
    h = b["h"]
    view(view(c["mach"], 1, MACH)[0]["clock"], 16, I8)[VALID] = 0
    tries = MAX_TRIES
    while _derive(at, where, h) == 0:
        tries -= 1
        if tries == 0 or b["kind"] == CONSTANT:
            b["k"] = 0
            return 0
        h *= 0.125
    if b["kind"] != CONSTANT:
        h = _first_step(at, where, h)
    k = min(ORDER_AFTER, b["most_k"])
    for j in range(1, k + 1):
        s = -j * h
        times[j] = s
        for i in range(nd):
            now = rows[NOW, i]
            jerk = rows[SERIES, i]
            snap = rows[SERIES, nd + i]
            rows[j, nd + i] = integral_on(rows[0, nd + i], s, now, jerk, snap)
            rows[j, i] = position_on(rows[0, i], rows[0, nd + i], s, now, jerk, snap)
        for r in range(nc):
            e = 2 * nd + r
            value = rows[NOW, e]
            one = rows[SERIES, e]
            two = rows[SERIES, e + nc]
            rows[j, e] = integral_on(value, s, one, two, 0.0)
            rows[j, e + nc] = integral_on(0.0, s, value, one, two)
            rows[j, e + 2 * nc] = 0.0
    times[0] = 0.0
    b["h"] = h
    b["gridded"] = h
    b["k"] = k
    b["origin"] = b["t"]
    b["points"] = k + 1
    b["steady"] = 0
    b["failures"] = 0
    b["rising"] = 2
    return OK
