# SPDX-License-Identifier: Apache-2.0
"""Newton iteration of an implicit step with constraints at position level, or at position and velocity level.

A correction x changes coordinates, rates and accelerations by x, cd x and cm x; it solves A x + G^T y = -R
with A = cm M + cd D + K. With constraints at position level only (form I3), G x = -g. The stabilised form of
Gear, Gupta and Leimkuhler has q' = v + G^T mu in addition, so positions and rates are corrected separately:

    G x = -(G v + gt) / cd,   dq = x + G^T m,   G G^T m = -g + (G v + gt) / cd,   mu = cd m

m is mu over cd, and y scales with A: both multipliers are scaled by the step (mu by h, lambda by h^2) without
row scaling, because the two Schur complements G G^T and G A^-1 G^T are solved in sequence. The multipliers
are not part of the convergence test: mu is round-off over h, and lambda follows from the forces.

Sources: C. W. Gear, B. Leimkuhler, G. K. Gupta, J. Comp. Appl. Math. 12-13 (1985) 77-90; scaling:
L. R. Petzold, P. Lotstedt, SIAM J. Sci. Stat. Comput. 7 (1986) 720-733; stopping by the rate of contraction:
E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, IV.8.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.kernel import call, kernel, view
from pitchpoint.core.status import DIVERGED, NOT_FINITE, OK, SLOW
from pitchpoint.multibody.block_lu import SOLVE
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.multibody.constraints import schur_factor, schur_solve
from pitchpoint.solvers.implicit.newton import (
    ASTRAY,
    FADING,
    SLOW_RATE,
    TRUSTED,
    back_to_guess,
    keep_guess,
    stale,
)
from pitchpoint.system.linear import factor, solve
from pitchpoint.system.residual import FORCES, NEWTON, residual
from pitchpoint.system.workspace import EVALUATIONS, ITERATIONS, MACH, VALID

MAX_ITERATIONS = 8
DRIFT = 0.1
"""Relative change of cd up to which a matrix is reused."""
AGED = 0.25
"""Contraction rate from which the next step needs a new matrix."""
SMALL = 0.5
"""Fraction of the tolerance below which a correction is accepted at any rate: it may be round-off."""
STUCK = 10.0
"""Multiple of the tolerance up to which a correction is accepted that a new matrix does not reduce."""

_ARRAYS: tuple[tuple[str, str, tuple[str, ...]], ...] = (
    ("per_q", "f8", ("nd",)),  # reciprocal tolerance of each coordinate
    ("per_v", "f8", ("nd",)),  # and of each rate; zero: not tested
    ("e", "f8", ("nd",)),  # contribution of the position rows to a correction
    ("Y", "f8", ("nc", "nd")),
    ("S", "f8", ("nc", "nc")),
    ("diag", "f8", ("nc",)),
    ("order", "i8", ("nc",)),
    ("used", "i8", ("nc",)),
    ("y", "f8", ("nc",)),
    ("z", "f8", ("nc",)),
    ("rhs", "f8", ("nc",)),
    ("mu", "f8", ("nc",)),  # multipliers of the position rows: q' = v + G^T mu
)

#: Input and memory of the iteration: time, factors, form; addresses of its arrays.
ITERATION = np.dtype(
    [
        ("t", "f8"),
        ("cm", "f8"),
        ("cd", "f8"),
        ("kept", "f8"),  # cd of the present matrix
        ("stabilised", "i8"),  # 0: rows at position level, 1: at position and velocity level
        ("patience", "i8"),  # maximum number of full Newton iterations, with a new matrix each
        *((name, "i8") for name, _, _ in _ARRAYS),
    ],
    align=True,
)


def new_iteration(nd: int, nc: int, stabilised: bool, patience: int) -> tuple[NDArray[np.void], list[Any]]:
    """ITERATION record, shape (1,), and the arrays it refers to, which must outlive it.

    Parameters
    ----------
    nd, nc
        Number of coordinates and of constraint rows.
    stabilised
        Whether the constraints hold at velocity level, too.
    patience
        Maximum number of full Newton iterations per step.
    """
    sizes = {"nd": nd, "nc": nc}
    arrays = {name: np.zeros([sizes[d] for d in shape], dtype) for name, dtype, shape in _ARRAYS}
    record = np.zeros(1, ITERATION)
    for name, array in arrays.items():
        record[0][name] = array.ctypes.data
    record[0]["stabilised"], record[0]["patience"] = stabilised and nc > 0, patience
    return record, list(arrays.values())


@kernel
def _factor_rows(at, where):
    """Factorise G G^T with detection of redundant rows."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    n = view(where, 1, ITERATION)[0]
    nc = c["nc"]
    schur_factor(
        view(c["G"], (nc, c["nd"]), F8),
        view(c["A"], (c["na"], 6, 6), F8),
        view(m["solve"], 0, SOLVE),  # no blocks: A is the unit matrix
        view(n["Y"], (nc, c["nd"]), F8),
        view(n["S"], (nc, nc), F8),
        view(n["diag"], nc, F8),
        view(n["order"], nc, I8),
        view(n["used"], nc, I8),
        view(m["y6"], 6, F8),
    )


@kernel
def _split_rows(at, where):
    """Compute the correction e of the positions; sets the velocity-level rows as right-hand side."""
    c = view(at, 1, CTL)[0]
    n = view(where, 1, ITERATION)[0]
    nd = c["nd"]
    nc = c["nc"]
    g = view(c["g"], nc, F8)
    gt = view(c["gt"], nc, F8)
    G = view(c["G"], (nc, nd), F8)
    v = view(c["v"], nd, F8)
    e = view(n["e"], nd, F8)
    rhs = view(n["rhs"], nc, F8)
    for i in range(nd):
        e[i] = 0.0
    for r in range(nc):
        s = gt[r]
        for i in range(nd):
            s += G[r, i] * v[i]
        s /= n["cd"]
        rhs[r] = s - g[r]
        g[r] = s
    y = view(n["y"], nc, F8)
    schur_solve(
        G,
        rhs,
        view(n["Y"], (nc, nd), F8),
        view(n["S"], (nc, nc), F8),
        view(n["order"], nc, I8),
        view(n["used"], nc, I8),
        e,
        y,
        view(n["z"], nc, F8),
    )
    mu = view(n["mu"], nc, F8)
    for r in range(nc):
        mu[r] += n["cd"] * y[r]
    for i in range(nd):  # use the present rows: those of an old matrix would shift the state along its motion
        s = 0.0
        for r in range(nc):
            s += G[r, i] * y[r]
        e[i] = -s


@kernel
def _move(at, where):
    """Apply the correction; returns its size in units of the tolerance."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    n = view(where, 1, ITERATION)[0]
    nd = c["nd"]
    nc = c["nc"]
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    lam = view(c["lam"], nc, F8)
    x = view(m["x"], nd, F8)
    y = view(m["y"], nc, F8)
    e = view(n["e"], nd, F8)
    per_q = view(n["per_q"], nd, F8)
    per_v = view(n["per_v"], nd, F8)
    most = 0.0
    total = 0.0
    for i in range(nd):
        dq = x[i] - e[i] if n["stabilised"] != 0 else x[i]
        dv = n["cd"] * x[i]
        q[i] += dq
        v[i] += dv
        a[i] += n["cm"] * x[i]
        size = max(abs(dq) * per_q[i], abs(dv) * per_v[i])
        total += size
        most = max(most, size)
    for r in range(nc):
        lam[r] += y[r]
    return most if math.isfinite(total) else total


@kernel
def iterate(at, where, spare):
    """Iterate one step to convergence; q, v, a, lam contain the prediction and become the solution."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    n = view(where, 1, ITERATION)[0]
    clock = view(m["clock"], 16, I8)
    real = view(m["real"], 16, F8)
    mu = view(n["mu"], c["nc"], F8)
    for r in range(mu.size):
        mu[r] = 0.0
    real[0] = min(FADING * real[0], SLOW_RATE)
    last = -1.0
    count = 0
    full = 0
    if not abs(n["cd"] - n["kept"]) <= DRIFT * n["cd"]:
        clock[VALID] = 0
    aged = clock[VALID] != 0 and c["nc"] > 0
    if aged:
        keep_guess(at)
    for _ in range(MAX_ITERATIONS + n["patience"]):
        fresh = clock[VALID] == 0
        status = residual(at, n["t"], NEWTON if fresh else FORCES, n["cm"], n["cd"], 1.0)
        clock[EVALUATIONS] += 1
        if status != OK:
            return status
        if fresh:
            status = factor(at)
            if status != OK:
                return status
            if n["stabilised"] != 0:
                _factor_rows(at, where)
            clock[VALID] = 1
            n["kept"] = n["cd"]
            real[0] = min(real[0], 0.1)  # reset the rate for the new matrix
            last = -1.0
            count = 0
        if n["stabilised"] != 0:
            _split_rows(at, where)
        solve(at)
        clock[ITERATIONS] += 1
        count += 1
        size = _move(at, where)
        if not math.isfinite(size):
            clock[VALID] = 0
            return NOT_FINITE
        if last > 0.0:
            real[0] = max(size / last, 1e-4)
        theta = real[0]
        known = last > 0.0 or size <= 1.0  # the rate of a large correction must be measured
        if theta > TRUSTED and last < 0.0 and stale(at, n["cm"], theta):
            last = size
            continue
        if size <= SMALL or (known and theta < 1.0 and size * theta <= 1.0 - theta):
            if count > 3 or (last > 0.0 and theta > AGED):
                clock[VALID] = 0  # the next step needs a new matrix
            return OK
        if full > 1 and size <= STUCK and size > SLOW_RATE * last:
            return OK
        if full > 0 or (last > 0.0 and theta > SLOW_RATE) or count >= MAX_ITERATIONS:
            clock[VALID] = 0
            if full >= n["patience"]:
                return DIVERGED if size >= last else SLOW
            full += 1
            if aged and size > ASTRAY * last:
                back_to_guess(at)
                for r in range(mu.size):
                    mu[r] = 0.0
            aged = False
        last = size
    clock[VALID] = 0
    return SLOW


@kernel
def constrained_step(at, where, iteration):
    """Call `iterate` through its address, so that it is not compiled again in every driver."""
    return call(iteration, at, where, 0)
