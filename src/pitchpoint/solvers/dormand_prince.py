# SPDX-License-Identifier: Apache-2.0
"""Dormand-Prince 5(4) and 8(5,3) with step control, dense output for samples, and location of events.

Sources: J. R. Dormand, P. J. Prince, J. Comp. Appl. Math. 6 (1980) 19-26; dense output and step control of
E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., II.5-II.6 (DOPRI5).
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import NOT_FINITE, OK, STEP_UNDERFLOW
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.solvers.explicit import DENSE, NEW, OLD, ROWS, bring_state, keep_state, slope
from pitchpoint.solvers.sampling import take
from pitchpoint.system.linear import solve_acceleration
from pitchpoint.system.residual import evaluate_events, wrap
from pitchpoint.system.workspace import MACH, REJECTED, STEPS, VALID

# slots of `real` that outlive a call
STEP_SIZE, LAST_ERROR = 2, 3


@kernel
def _stages(at, t, h, rate, A, C, begin, end, last):
    """Stages `begin` to `end` - 1 from the ones before; stage `last` stands at the new state, row NEW."""
    c = view(at, 1, CTL)[0]
    nd = c["nd"]
    stage = view(view(c["mach"], 1, MACH)[0]["stage"], (ROWS, 2 * nd), F8)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    for k in range(begin, end):
        for i in range(nd):
            s = 0.0
            p = 0.0
            for j in range(k):
                s += A[k, j] * stage[j, i]
                p += A[k, j] * stage[j, nd + i]
            q[i] = stage[OLD, i] + h * s
            v[i] = stage[OLD, nd + i] + h * p
        if k == last:
            keep_state(at, NEW)
        status = slope(at, t + C[k] * h, k, rate)
        if status != OK:
            return status
    return OK


@kernel
def _error(at, h, E, rtol, atol, atol_rate):
    """Error of the step in units of the tolerance, root mean square over all coordinates and rates.

    With two rows of E the errors e of fifth and d of third order make |e|^2 / sqrt(|e|^2 + 0.01 |d|^2).
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    stage = view(m["stage"], (ROWS, 2 * nd), F8)
    weight = view(m["weight"], nd, F8)
    relative = view(m["relative"], nd, F8)
    total = 0.0
    lower = 0.0
    for i in range(2 * nd):
        s = 0.0
        p = 0.0
        for k in range(E.shape[1]):
            s += E[0, k] * stage[k, i]
            p += E[1, k] * stage[k, i]
        size = max(abs(stage[OLD, i]), abs(stage[NEW, i]))
        if i < nd:
            allowed = atol / weight[i] + rtol * size * relative[i]
        else:
            allowed = atol_rate / weight[i - nd] + rtol * size
        s *= h / allowed
        p *= h / allowed
        total += s * s
        lower += p * p
    if total == 0.0:
        return 0.0
    return total / math.sqrt((total + 0.01 * lower) * max(2 * nd, 1))


@kernel
def _prepare_dense(at, h, D, last):
    """Coefficients of the interpolant of the step just made; returns their number."""
    c = view(at, 1, CTL)[0]
    nd = c["nd"]
    stage = view(view(c["mach"], 1, MACH)[0]["stage"], (ROWS, 2 * nd), F8)
    for i in range(2 * nd):
        d = stage[NEW, i] - stage[OLD, i]
        b = h * stage[0, i] - d
        stage[DENSE, i] = d
        stage[DENSE + 1, i] = b
        stage[DENSE + 2, i] = d - h * stage[last, i] - b
        for r in range(D.shape[0]):
            s = 0.0
            for k in range(D.shape[1]):
                s += D[r, k] * stage[k, i]
            stage[DENSE + 3 + r, i] = h * s
    return 3 + D.shape[0]


@kernel
def _interpolate(at, x, n):
    """Put the state at the share x of the step into the workspace; n coefficients."""
    c = view(at, 1, CTL)[0]
    nd = c["nd"]
    stage = view(view(c["mach"], 1, MACH)[0]["stage"], (ROWS, 2 * nd), F8)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    for i in range(2 * nd):
        s = 0.0
        for r in range(n - 1, -1, -1):
            s = (s + stage[DENSE + r, i]) * (x if r % 2 == 0 else 1.0 - x)
        s += stage[OLD, i]
        if i < nd:
            q[i] = s
        else:
            v[i - nd] = s


@kernel
def _locate(at, t, h, n, k, low, high):
    """Share of the step, just behind the sign change of event function k (regula falsi, Illinois variant)."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    ev = view(m["ev1"], c["ne"], F8)
    a = 0.0
    b = 1.0
    for _ in range(80):
        if (b - a) * abs(h) <= 1e-13 * max(abs(t), abs(h)):
            break
        x = b - high * (b - a) / (high - low)
        if not (a < x < b):
            x = 0.5 * (a + b)
        _interpolate(at, x, n)
        if evaluate_events(at, t + x * h, m["ev1"]) != OK:
            break
        f = ev[k]
        if (f < 0.0) == (low < 0.0) and f != 0.0:
            a = x
            low = f
            high *= 0.5
        else:
            b = x
            high = f
            low *= 0.5
            if f == 0.0:
                break
    return b


@kernel
def _events(at, t, h, dense, found, n):
    """Find all sign changes of the step, in order of the functions; returns count and the earliest share."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    ev0 = view(m["ev0"], c["ne"], F8)
    ev1 = view(m["ev1"], c["ne"], F8)
    first = 2.0
    for k in range(ev0.size):
        _interpolate(at, 1.0, dense)
        if evaluate_events(at, t + h, m["ev1"]) != OK:
            return n, -1.0
        low = ev0[k]
        high = ev1[k]
        if (low < 0.0 and high >= 0.0) or (low > 0.0 and high <= 0.0):
            x = _locate(at, t, h, dense, k, low, high)
            if x < first:
                first = x
            if n < found.shape[0]:
                found[n, 0] = t + x * h
                found[n, 1] = k
                found[n, 2] = 1.0 if high > low else -1.0
            n += 1
    return n, first


@kernel
def advance_adaptive(at, t, t_end, pair, tol, grid, most, restart, rows, sums, found, done):
    """Go from t to t_end with step control; `pair` holds the coefficients (`dormand_prince_pairs.Pair`).

    tol: rtol, atol, atol_rate, constraint rate. grid: time of sample 0, distance of samples (0: none); rows
    are stored and statistics fed at grid times. restart != 0: begin anew at every event. done: steps, rows,
    events. The time reached and the next step size stay in `real`.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    real = view(m["real"], 16, F8)
    clock = view(m["clock"], 16, I8)
    nd = c["nd"]
    ne = c["ne"]
    stage = view(m["stage"], (ROWS, 2 * nd), F8)
    A = pair.A
    last_stage = pair.E.shape[1] - 1
    dense = 0
    measure = 1 if sums.shape[0] > 0 else 0
    watch = ne > 0 and found.shape[0] > 0
    done[0] = 0
    done[1] = 0
    done[2] = 0
    real[4] = t
    status = slope(at, t, 0, tol[3])
    if status != OK:
        return status
    while t < t_end and done[0] < most:
        h = real[STEP_SIZE]
        last = t + 1.01 * h >= t_end
        if last:
            h = t_end - t
        if not h > 1e-14 * max(abs(t), 1e-9):
            return STEP_UNDERFLOW
        keep_state(at, OLD)
        status = _stages(at, t, h, tol[3], A, pair.C, 1, last_stage + 1, last_stage)
        error = 1e10
        if status == OK:
            error = _error(at, h, pair.E, tol[0], tol[1], tol[2])
        elif status != NOT_FINITE:
            return status
        if not error <= 1.0:
            clock[REJECTED] += 1
            real[STEP_SIZE] = h * (
                max(0.2, 0.9 * error ** (-1.0 / pair.order)) if math.isfinite(error) else 0.2
            )
            if not real[STEP_SIZE] > 1e-14 * max(abs(t), 1e-9):
                return STEP_UNDERFLOW if status == OK else NOT_FINITE
            bring_state(at, OLD)
            continue
        end = t_end if last else t + h
        share = 2.0
        if watch or grid[1] > 0.0:
            status = _stages(at, t, h, tol[3], A, pair.C, last_stage + 1, A.shape[0], last_stage)
            if status != OK:
                return status
            dense = _prepare_dense(at, h, pair.D, last_stage)
        if watch:
            before = done[2]
            done[2], share = _events(at, t, h, dense, found, done[2])
            if share < 0.0:
                return NOT_FINITE
            if restart != 0 and share <= 1.0:
                end = t + share * h
                kept = before  # keep only what happened up to the restart
                for r in range(before, min(done[2], found.shape[0])):
                    if found[r, 0] <= end:
                        for k in range(3):
                            found[kept, k] = found[r, k]
                        kept += 1
                done[2] = kept
        if grid[1] > 0.0:
            k = math.floor((t - grid[0]) / grid[1] + 1e-9) + 1
            while grid[0] + k * grid[1] <= end * (1.0 + 1e-15):
                s = grid[0] + k * grid[1]
                _interpolate(at, (s - t) / h, dense)
                status = solve_acceleration(at, s, tol[3])
                if status == OK:
                    sample = 1 if done[1] < rows.shape[0] else 0
                    status = take(at, s, sums, measure, rows, done[1], sample)
                    done[1] += sample
                if status != OK:
                    return status
                clock[VALID] = 1
                k += 1
        if restart != 0 and share <= 1.0:
            _interpolate(at, share, dense)
            status = slope(at, end, 0, tol[3])
            if status != OK:
                return status
        else:
            bring_state(at, NEW)
            for i in range(2 * nd):
                stage[0, i] = stage[last_stage, i]
        if watch:
            status = evaluate_events(at, end, m["ev0"])
            if status != OK:
                return status
        t = end
        real[4] = t
        wrap(at)
        clock[STEPS] += 1
        done[0] += 1
        # the exponents of DOPRI5 damp the change of the step, those of DOP853 do not
        damped = 0.04 if pair.order < 8.0 else 0.0
        growth = (
            max(error, 1e-10) ** (0.75 * damped - 1.0 / pair.order) * max(real[LAST_ERROR], 1e-4) ** damped
        )
        growth *= 0.9
        real[LAST_ERROR] = max(error, 1e-4)
        if not last:
            real[STEP_SIZE] = h * min(5.0, max(0.2, growth))
    status = solve_acceleration(at, t, tol[3])
    clock[VALID] = 1
    return status
