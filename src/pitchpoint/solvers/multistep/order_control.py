# SPDX-License-Identifier: Apache-2.0
"""Memory of a multistep method, its error estimate, and the control of order and step.

The rows of the history are q, v, lambda, eta, xi: 2 nd + 3 nc numbers. The error of a step of order k is
proportional to the difference of order k + 1, and likewise for the neighbouring orders. Rules of
L. R. Petzold's DASSL: K. E. Brenan, S. L. Campbell, L. R. Petzold, Numerical Solution of Initial-Value
Problems in Differential-Algebraic Equations, SIAM 1996, 5.2.

Multipliers are not part of the error. In form SI1 their integrals are: an error of eta counts as the change
of rates M^-1 G^T that it causes, one of xi as the change of positions G^T.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.multibody.channels import CTL, F8
from pitchpoint.solvers.implicit.constrained_newton import ITERATION
from pitchpoint.solvers.multistep.history import DEPTH, difference_weights
from pitchpoint.system.workspace import MACH

#: Kinds of coefficients: fixed leading coefficient (DASSL); variable (WSTIFF); fixed, with the history
#: interpolated to the new step (GSTIFF); fixed step and order.
LEADING, VARIABLE, FIXED, CONSTANT = range(4)

# indices of the tolerances: relative, positions, rates; largest step
RTOL, ATOL, ATOL_RATE, LARGEST = range(4)

PAST = np.dtype(
    [
        ("t", "f8"),  # time reached
        ("h", "f8"),  # next trial step
        ("gridded", "f8"),  # step of the grid of the history, 0: none
        ("used", "f8"),  # length of the last step
        ("limit", "f8"),  # time that no step may exceed
        ("origin", "f8"),  # origin of the grid of constant steps
        ("error", "f8"),  # error of the present step, in units of the tolerance
        ("estimate", "f8"),  # error estimate of the order chosen next
        ("kind", "i8"),
        ("k", "i8"),  # order
        ("next_k", "i8"),  # order of the next step
        ("points", "i8"),  # number of filled rows of the history
        ("steady", "i8"),  # consecutive steps with the same step and order
        ("rising", "i8"),  # start-up phase, 1: raise order and step, 2: raise the order, after a jump
        ("failures", "i8"),  # consecutive failures
        ("most_k", "i8"),  # highest order
        ("rates", "i8"),  # 1: error control includes the rates
        ("integrals", "i8"),  # 1: multipliers are rates of eta and xi
        *(
            (name, "i8")
            for name in ("rows", "times", "new", "ahead", "slope", "allowed", "W", "p", "tol", "iteration")
        ),
        ("wanted", "i8"),  # address of one flag per event function (0: ignored), or 0 if all count
        ("iterate", "i8"),  # address of the Newton iteration
        ("step", "i8"),  # address of `step.step`
        ("seek", "i8"),  # address of `events.step_to_event`
        ("resume", "i8"),  # address of `restart.resume`
        ("kept", "i8"),  # address of the record saved before a step that may be undone
        ("event", "i8"),  # 1: the last step ended at an event
        ("events", "i8"),  # number of steps that ended at an event
    ],
    align=True,
)


@kernel
def set_allowed(at, where):
    """Set the tolerance of every coordinate and rate, from the latest row of the history."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    b = view(where, 1, PAST)[0]
    nd = c["nd"]
    newest = view(b["rows"], 2 * nd, F8)
    allowed = view(b["allowed"], 2 * nd, F8)
    weight = view(m["weight"], nd, F8)
    relative = view(m["relative"], nd, F8)
    tol = view(b["tol"], LARGEST + 1, F8)
    for i in range(nd):
        allowed[i] = tol[ATOL] / weight[i] + tol[RTOL] * abs(newest[i]) * relative[i]
        allowed[nd + i] = tol[ATOL_RATE] / weight[i] + tol[RTOL] * abs(newest[nd + i])


@kernel
def _norm(at, where, x):
    """RMS norm of a vector in the layout of a history row, in units of the tolerance."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    b = view(where, 1, PAST)[0]
    n = view(b["iteration"], 1, ITERATION)[0]
    nd = c["nd"]
    nc = c["nc"]
    allowed = view(b["allowed"], 2 * nd, F8)
    if b["integrals"] != 0:
        Y = view(m["Y"], (nc, nd), F8)
        G = view(n["Y"], (nc, nd), F8)
        for r in range(nc):
            eta = n["kept"] * n["kept"] * x[2 * nd + nc + r]
            xi = x[2 * nd + 2 * nc + r]
            for i in range(nd):
                x[i] += G[r, i] * xi
                x[nd + i] += Y[r, i] * eta
    count = 2 * nd if b["rates"] != 0 else nd
    total = 0.0
    for i in range(count):
        s = x[i] / allowed[i]
        total += s * s
    return math.sqrt(total / max(count, 1))


@kernel
def _difference(at, where, n, h):
    """Norm of h^n times the n-th derivative at the new state, from n earlier values."""
    c = view(at, 1, CTL)[0]
    b = view(where, 1, PAST)[0]
    size = 2 * c["nd"] + 3 * c["nc"]
    rows = view(b["rows"], (DEPTH, size), F8)
    new = view(b["new"], size, F8)
    x = view(b["slope"], size, F8)
    w = view(b["p"], 2 * DEPTH, F8)
    difference_weights(view(b["times"], DEPTH, F8), n, h, w)
    for i in range(size):
        s = w[0] * new[i]
        for j in range(n):
            s += w[j + 1] * rows[j, i]
        x[i] = s
    return _norm(at, where, x)


@kernel
def _miss(at, where, h):
    """Error of the step, from the difference of solution and prediction."""
    c = view(at, 1, CTL)[0]
    b = view(where, 1, PAST)[0]
    size = 2 * c["nd"] + 3 * c["nc"]
    times = view(b["times"], DEPTH, F8)
    new = view(b["new"], size, F8)
    ahead = view(b["ahead"], size, F8)
    x = view(b["slope"], size, F8)
    for i in range(size):
        x[i] = new[i] - ahead[i]
    k = b["k"]
    factor = h / (h - times[k])
    if b["kind"] == LEADING:
        s = factor
        for i in range(1, k + 1):
            s += h / (h - times[i - 1]) - 1.0 / i
        factor = max(factor, abs(s))
    return factor * _norm(at, where, x)


@kernel
def judge(at, where, h):
    """Estimate the error of the present step, and whether a lower order is sufficient."""
    b = view(where, 1, PAST)[0]
    k = b["k"]
    b["next_k"] = k
    if b["kind"] == CONSTANT:
        b["error"] = 0.0
        return
    b["error"] = _miss(at, where, h)
    here = _difference(at, where, k + 1, h)
    b["estimate"] = here / (k + 1)
    if k > 1:
        below = _difference(at, where, k, h)
        lower = below <= 0.5 * here
        if k > 2:
            lower = max(below, _difference(at, where, k - 1, h)) <= here
        if lower:
            b["next_k"] = k - 1
            b["estimate"] = below / k


@kernel
def shrink(where, h, solved):
    """Set order and step after a failed step: from its error if it was solved, otherwise a quarter."""
    b = view(where, 1, PAST)[0]
    b["failures"] += 1
    b["rising"] = 0
    b["steady"] = 0
    share = 0.25
    if solved:
        b["k"] = b["next_k"]
        if b["failures"] == 1:
            r = 0.9 * (2.0 * b["estimate"] + 1e-4) ** (-1.0 / (b["k"] + 1))
            share = max(0.25, min(0.9, r)) if math.isfinite(r) else 0.25
    if b["failures"] > 2:
        b["k"] = 1
    b["h"] = share * h


@kernel
def _next_order(at, where, h):
    """Raise, lower or retain the order, by the differences of the neighbouring orders."""
    b = view(where, 1, PAST)[0]
    k = b["k"]
    if b["next_k"] < k or k == b["most_k"] or b["steady"] <= k + 1 or b["points"] < k + 2:
        return
    here = b["estimate"] * (k + 1)
    above = _difference(at, where, k + 2, h)
    if k > 1 and _difference(at, where, k, h) <= min(here, above):
        b["next_k"] = k - 1
        b["estimate"] = _difference(at, where, k, h) / k
    elif above < (0.5 * here if k == 1 else here):
        b["next_k"] = k + 1
        b["estimate"] = above / (k + 2)


@kernel
def _growth(estimate, k):
    """Ratio of the next step to the present one: 2, 1 or less."""
    share = (2.0 * estimate + 1e-4) ** (-1.0 / (k + 1))
    return 2.0 if share >= 2.0 else 1.0 if share > 1.0 else max(0.5, min(0.9, share))


@kernel
def choose(at, where, h, cut, nominal):
    """Set order and step after an accepted step; `cut`: it was shortened to end at a given time."""
    b = view(where, 1, PAST)[0]
    k = b["k"]
    b["failures"] = 0
    b["steady"] += 1
    if b["kind"] == CONSTANT:
        # doubling the step excites parasitic roots, which decay slowly at high orders
        if b["steady"] >= (k + 2 if k < 4 else 2 ** (k - 1)) and not cut:
            x = (b["t"] + h - b["origin"]) / (2.0 * h)
            if k < b["most_k"]:
                b["next_k"] = k + 1
            elif abs(x - math.floor(x + 0.5)) < 1e-3:  # on the grid of the longer step
                b["h"] = 2.0 * h if 2.0 * h < 0.99 * nominal else nominal
        share = 1.0
    elif b["rising"] != 0 and b["next_k"] == k:
        share = 2.0
        if b["rising"] == 2:  # the error of the next higher order is a fraction of the estimate
            share = max(0.5, min(2.0, (0.8 * b["estimate"] + 1e-4) ** (-1.0 / (k + 2))))
        if k < b["most_k"]:
            b["next_k"] = k + 1
        else:
            b["rising"] = 0
    else:
        b["rising"] = 0
        _next_order(at, where, h)
        share = _growth(b["estimate"], b["next_k"])
    if b["kind"] != CONSTANT and not (cut and share >= 1.0):
        b["h"] = share * h
    if b["h"] != h or b["next_k"] != k:
        b["steady"] = 0
    b["k"] = b["next_k"]
