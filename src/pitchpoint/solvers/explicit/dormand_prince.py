# SPDX-License-Identifier: Apache-2.0
"""Dormand-Prince 5(4) and 8(5,3) with step control, dense output for samples, and location of events.

Sources: J. R. Dormand, P. J. Prince, J. Comp. Appl. Math. 6 (1980) 19-26; dense output and step control of
E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., II.5-II.6 (DOPRI5).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import DIED, NOT_FINITE, OK, STEP_UNDERFLOW
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.solvers.explicit.coefficients import Pair
from pitchpoint.solvers.explicit.dense_output import events_up_to, find_events, interpolate
from pitchpoint.solvers.explicit.derivative import (
    DENSE,
    NEW,
    OLD,
    ROWS,
    SLOPE_AT,
    bring_state,
    keep_state,
    slope,
)
from pitchpoint.solvers.sampling import recorder_at, samples_up_to, take
from pitchpoint.system.linear import solve_acceleration
from pitchpoint.system.residual import evaluate_events, wrap
from pitchpoint.system.workspace import MACH, REJECTED, STEPS, VALID

# slots of `real` that are retained between calls
STEP_SIZE, LAST_ERROR, TIME = 2, 3, 4
# indices of the tolerances: relative, positions, rates; Baumgarte rate, largest step
RTOL, ATOL, ATOL_RATE, RATE, LARGEST = range(5)


@kernel
def _stages(at, t, h, rate, A, C, begin, end, last):
    """Compute stages `begin` to `end` - 1; stage `last` is at the new state, which is stored in row NEW."""
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
    """Error of the step in units of the tolerance, rms over all coordinates and rates.

    With two rows of E, from the fifth-order error e and the third-order error d:
    |e|^2 / sqrt(|e|^2 + 0.01 |d|^2).
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
    """Compute the dense output coefficients of the step; returns their number."""
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
def _stop(at, status):
    """Restore the state before a failed step; returns the status."""
    bring_state(at, OLD)
    return status


@kernel(inline=True)
def advance_adaptive(at, t, t_end, pair, tol, grid, most, ends, recorder):
    """Integrate from t to t_end with step control; `pair`: coefficients (`explicit.coefficients.Pair`).

    tol: see the indices above. grid: time of sample 0, sample period (0: none); rows are stored and
    statistics updated at grid times. ends: restart at every event (0: no), and the address of one flag per
    event function (0: ignored), or 0 if all functions count. The time reached and the next step size are
    stored in `real`.
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
    found = recorder.found
    done = recorder.done
    rate = tol[RATE]
    measure = 1 if recorder.sums.shape[0] > 0 else 0
    watch = ne > 0 and found.shape[0] > 0
    restart = ends[0]
    real[TIME] = t
    if real[SLOPE_AT] != t:  # reuse it across chunks: chunked runs are bitwise identical
        status = slope(at, t, 0, rate)
        if status != OK:
            return status
    while t < t_end and done[0] < most:
        h = min(real[STEP_SIZE], tol[LARGEST])
        last = t + 1.01 * h >= t_end
        if last:
            h = t_end - t
        if not h > 1e-14 * max(abs(t), 1e-9):
            if last:  # an event just before the end
                t = t_end
                real[TIME] = t
                break
            return STEP_UNDERFLOW
        keep_state(at, OLD)
        status = _stages(at, t, h, rate, A, pair.C, 1, last_stage + 1, last_stage)
        error = 1e10
        if status == OK:
            error = _error(at, h, pair.E, tol[RTOL], tol[ATOL], tol[ATOL_RATE])
        elif status == DIED:
            return _stop(at, status)
        if not error <= 1.0:
            clock[REJECTED] += 1
            real[STEP_SIZE] = h * (
                max(0.2, 0.9 * error ** (-1.0 / pair.order)) if math.isfinite(error) else 0.2
            )
            bring_state(at, OLD)
            if not real[STEP_SIZE] > 1e-14 * max(abs(t), 1e-9):
                return STEP_UNDERFLOW if status == OK else status
            c["bad"] = -1  # the retry with a shorter step may succeed
            c["badkind"] = -1
            continue
        end = t_end if last else t + h
        share = 2.0
        if watch or grid[1] > 0.0:
            status = _stages(at, t, h, rate, A, pair.C, last_stage + 1, A.shape[0], last_stage)
            if status != OK:
                return _stop(at, status)
            dense = _prepare_dense(at, h, pair.D, last_stage)
        if watch:
            before = done[2]
            done[2], share = find_events(at, t, h, dense, found, done[2], ends[1])
            if share < 0.0:
                return _stop(at, NOT_FINITE)
            if restart != 0 and share <= 1.0:
                end = t + share * h
                done[2] = events_up_to(at, end, share, dense, found, before, done[2])
        if grid[1] > 0.0:
            for k in range(samples_up_to(t, grid) + 1, samples_up_to(end, grid) + 1):
                s = grid[0] + k * grid[1]
                interpolate(at, (s - t) / h, dense)
                status = solve_acceleration(at, s, rate)
                if status == OK:
                    status = take(at, s, recorder, measure, 1)
                if status != OK:
                    return _stop(at, status)
                clock[VALID] = 1
        if restart != 0 and share <= 1.0:
            interpolate(at, share, dense)
            status = slope(at, end, 0, rate)
            if status != OK:
                return _stop(at, status)
        else:
            bring_state(at, NEW)
            for i in range(2 * nd):
                stage[0, i] = stage[last_stage, i]
        if watch:
            status = evaluate_events(at, end, m["ev0"])
            if status != OK:
                return _stop(at, status)
        t = end
        real[TIME] = t
        real[SLOPE_AT] = t
        wrap(at)
        clock[STEPS] += 1
        done[0] += 1
        # PI step size control, beta = 0.04 as in DOPRI5; DOP853 uses beta = 0
        damped = 0.04 if pair.order < 8.0 else 0.0
        growth = (
            max(error, 1e-10) ** (0.75 * damped - 1.0 / pair.order) * max(real[LAST_ERROR], 1e-4) ** damped
        )
        growth *= 0.9
        real[LAST_ERROR] = max(error, 1e-4)
        if not last:
            real[STEP_SIZE] = h * min(5.0, max(0.2, growth))
    status = solve_acceleration(at, t, rate)
    clock[VALID] = 1
    return status


#: Arguments of `advance_adaptive` from Python: times, method order, addresses and sizes of the arrays.
ORDER = np.dtype(
    [
        *((name, "f8") for name in ("t", "t_end", "sample_zero", "sample", "order")),
        *((name, "i8") for name in ("A", "C", "E", "D", "stages", "last", "dense", "tol", "most")),
        *((name, "i8") for name in ("restart", "wanted")),
    ],
    align=True,
)


@kernel
def entry(at, order, recorder):
    """Execute an ORDER; both arguments are addresses of records."""
    o = view(order, 1, ORDER)[0]
    n = o["stages"]
    pair = Pair(
        view(o["A"], (n, n), F8),
        view(o["C"], n, F8),
        view(o["E"], (2, o["last"]), F8),
        view(o["D"], (o["dense"], n), F8),
        o["order"],
    )
    grid = (o["sample_zero"], o["sample"])
    tol = view(o["tol"], LARGEST + 1, F8)
    ends = (o["restart"], o["wanted"])
    return advance_adaptive(at, o["t"], o["t_end"], pair, tol, grid, o["most"], ends, recorder_at(recorder))


def adaptive_order(
    times: tuple[float, float, float, float],
    pair: Pair,
    tolerances: NDArray[np.float64],
    most: int,
    ends: tuple[bool, int],
) -> NDArray[np.void]:
    """ORDER record, shape (1,), with addresses of the given arrays: they must outlive it.

    Parameters
    ----------
    times
        Present time, end time, time of sample 0, sample period [s].
    pair, tolerances, most, ends
        As in `advance_adaptive`.
    """
    arrays = (a.ctypes.data for a in pair[:4])
    sizes = (pair.A.shape[0], pair.E.shape[1], pair.D.shape[0])
    return np.array([(*times, pair.order, *arrays, *sizes, tolerances.ctypes.data, most, *ends)], ORDER)
