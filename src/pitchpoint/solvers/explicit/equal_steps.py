# SPDX-License-Identifier: Apache-2.0
"""Fixed-step explicit methods of fourth order: Runge-Kutta with four evaluations per step, Adams with one.

Both start from the derivative at the old state and end with the derivative at the new state, so that channels
at the new state need no extra evaluation. The Adams method integrates a parabola through the last three
accelerations twice for the positions, and evaluates the forces at the new positions and predicted rates; the
rates are then corrected with a cubic that includes the new acceleration. Its first steps are Runge-Kutta
steps. For a linear oscillator the roots of its difference equation are within the unit circle up to
h omega = 1.414 without damping, and up to 0.896 with a damping ratio of 0.1.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.solvers.explicit.derivative import OLD, ROWS, SLOPE_AT, bring_state, keep_state, slope
from pitchpoint.solvers.sampling import due, keep, record_events, recorder_at
from pitchpoint.system.residual import ALL, SOONER, observe, observe_bodies, observe_later, wrap
from pitchpoint.system.workspace import MACH, RECHARTED, STEPS

CLASSICAL, ADAMS = 0, 1
#: Rows of the stages with the accelerations of the last three states.
LAST, FORMER, FIRST = 4, 5, 6
#: Slot of `real` with the number of past accelerations, one step apart; number required by the Adams method.
PAST = 6
NEEDED = 2

#: Arguments of `entry` from Python, under the names of the arguments of `advance_equal`.
ORDER = np.dtype(
    [("t0", "f8"), ("h", "f8"), ("rate", "f8"), ("first", "i8"), ("n", "i8"), ("method", "i8")], align=True
)


@kernel
def _classical(at, t, h, rate):
    """One Runge-Kutta step from the state and derivative in the workspace to the state at t + h."""
    c = view(at, 1, CTL)[0]
    nd = c["nd"]
    stage = view(view(c["mach"], 1, MACH)[0]["stage"], (ROWS, 2 * nd), F8)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    for k in range(1, 4):
        share = 1.0 if k == 3 else 0.5
        for i in range(nd):
            q[i] = stage[OLD, i] + h * share * stage[k - 1, i]
            v[i] = stage[OLD, nd + i] + h * share * stage[k - 1, nd + i]
        status = slope(at, t + share * h, k, rate)
        if status != OK:
            return status
    w = h / 6.0
    for i in range(nd):
        e = nd + i
        q[i] = stage[OLD, i] + w * (stage[0, i] + 2.0 * (stage[1, i] + stage[2, i]) + stage[3, i])
        v[i] = stage[OLD, e] + w * (stage[0, e] + 2.0 * (stage[1, e] + stage[2, e]) + stage[3, e])
    return OK


@kernel
def _predict(at, h):
    """Final positions and predicted rates of the next state from three accelerations.

    The parabola through them gives q + h v + h^2 (19 a_n - 10 a_n-1 + 3 a_n-2) / 24 and
    v + h (23 a_n - 16 a_n-1 + 5 a_n-2) / 12 (Adams and Bashforth).
    """
    c = view(at, 1, CTL)[0]
    nd = c["nd"]
    stage = view(view(c["mach"], 1, MACH)[0]["stage"], (ROWS, 2 * nd), F8)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    for i in range(nd):
        e = nd + i
        q[i] += h * (v[i] + h * (19.0 * stage[0, e] - 10.0 * stage[LAST, e] + 3.0 * stage[FORMER, e]) / 24.0)
        v[i] += h * (23.0 * stage[0, e] - 16.0 * stage[LAST, e] + 5.0 * stage[FORMER, e]) / 12.0


@kernel
def _correct(at, h):
    """Corrected rates: v + h (9 a_n+1 + 19 a_n - 5 a_n-1 + a_n-2) / 24 (Adams and Moulton)."""
    c = view(at, 1, CTL)[0]
    nd = c["nd"]
    stage = view(view(c["mach"], 1, MACH)[0]["stage"], (ROWS, 2 * nd), F8)
    v = view(c["v"], nd, F8)
    for i in range(nd):
        e = nd + i
        change = 9.0 * stage[0, e] + 19.0 * stage[LAST, e] - 5.0 * stage[FORMER, e] + stage[FIRST, e]
        v[i] = stage[OLD, e] + h * change / 24.0


@kernel
def _age(at):
    """Shift the acceleration history by one step."""
    c = view(at, 1, CTL)[0]
    nd = c["nd"]
    stage = view(view(c["mach"], 1, MACH)[0]["stage"], (ROWS, 2 * nd), F8)
    for i in range(nd, 2 * nd):
        stage[FIRST, i] = stage[FORMER, i]
        stage[FORMER, i] = stage[LAST, i]
        stage[LAST, i] = stage[0, i]


@kernel(inline=True)
def advance_equal(at, t0, first, n, h, rate, method, recorder):
    """Take n fixed steps; arguments as in `generalized_alpha.advance`, and the Baumgarte rate.

    If a row is due, elements write their channels while their forces are summed for the next derivative, so
    that the rates and accelerations of the channels are consistent.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    clock = view(m["clock"], 16, I8)
    real = view(m["real"], 16, F8)
    for k in range(1, n + 1):
        before = t0 + (first + k - 1) * h
        t = t0 + (first + k) * h
        status = OK
        if real[SLOPE_AT] != before:  # reuse it across chunks: chunked runs are bitwise identical
            status = slope(at, before, 0, rate)
            real[PAST] = 0.0
        several = method == ADAMS and real[PAST] >= NEEDED
        charts = clock[RECHARTED]
        keep_state(at, OLD)
        if status == OK and several:
            _predict(at, h)
        elif status == OK:
            status = _classical(at, before, h, rate)
            wrap(at)
        _age(at)
        measure, sample = due(first + k, recorder)
        asked = measure != 0 or sample != 0
        shared = asked and m["shares"] != 0
        if status == OK:
            if shared:
                c["out"] = m["row"]
                m["part"] = SOONER
            status = slope(at, t, 0, rate)
            c["out"] = 0
            m["part"] = ALL
        if status == OK and asked:
            status = observe_later(at, t, m["row"]) if shared else observe(at, t, m["row"])
        if status != OK:
            real[SLOPE_AT] = math.nan
            bring_state(at, OLD)
            return status
        real[SLOPE_AT] = t
        real[PAST] += 1.0
        if several:
            _correct(at, h)
            wrap(at)
        if clock[RECHARTED] != charts:  # the history refers to the old rotation chart
            real[PAST] = 0.0
            if several:
                real[SLOPE_AT] = math.nan
        clock[STEPS] += 1
        recorder.done[0] = k
        if asked:
            observe_bodies(at, m["row"])
            keep(at, t, recorder, measure, sample)
        status = record_events(at, t, h, recorder)
        if status != OK:
            return status
    return OK


@kernel
def entry(at, order, recorder):
    """Execute an ORDER; both arguments are addresses of records."""
    o = view(order, 1, ORDER)[0]
    found = recorder_at(recorder)
    c = view(at, 1, CTL)[0]
    c["held"] = 1
    status = advance_equal(at, o["t0"], o["first"], o["n"], o["h"], o["rate"], o["method"], found)
    c["held"] = 0
    return status
