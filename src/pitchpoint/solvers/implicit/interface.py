# SPDX-License-Identifier: Apache-2.0
"""Forces and motions exchanged between gear trains and the rest of the machine within a long step.

Interface coordinates are those of the rest (slow part) on which the elements and inertia forces of a gear
train (fast part) act. During the short steps they follow the extrapolation of their accelerations, which
contains the expected forces of the gear train, and in addition the motion z caused by the difference d of
actual and expected forces: z'' = -W d, with the mobility W (the inverse of the iteration matrix of the long
step, relative to its factor of the mass matrix). z is integrated by the explicit central difference method,
which neither adds nor removes energy. Without z the reaction of the rest would be late by a long step, and an
undamped vibration would gain energy by it.

The end force of the long step is the mean of the short steps, extrapolated to the end from two long steps:
the last force alone would make slow vibrations of those at mesh frequencies. It does not depend on the
position that the rest finds in its step, as the gear train has felt the predicted one; otherwise momentum
would be produced.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.kernel import kernel, view
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.system import evaluate
from pitchpoint.system.part import Part, factor_entry, solve_entry
from pitchpoint.system.residual import FORCES, NEWTON, residual
from pitchpoint.system.workspace import EXCHANGE_ROWS, MACH

if TYPE_CHECKING:
    from pitchpoint.system.system import State, System

MOBILITY, CARRIED, STIFFNESS, DAMPING = range(4)
"""Matrices of the interface coordinates: mobility W, mass of the gear train that they carry, stiffness and
damping of its elements."""

Z, Z_RATE, Z_SECOND, TRIAL, BASE_V, BASE_A, EXPECTED, FORCE = range(8)
SUM, MEAN, END, SLOPE, AT, AT_RATE, FLAGS, SAVED = range(8, 16)
"""Rows of the values at the interface: z with its derivatives after the last short step, z'' of the present
iteration, rates and accelerations without it, expected force, present force of the gear train, its sum, mean
of the last long step, end force and its rate, position and rate after the last short step, flags, and saved
values of the first three."""
STIFFER = 2.0
"""Factor of stiffness and damping of the rest in W: with 1, undamped vibrations of the rest with six long
steps per period gain 1e-7 of their amplitude per step, with 2 none does."""
MEASURED, HALF = 0, 1
"""Flags: 1 if there is a mean, half of the present short step."""


@kernel
def _set_force(c, m):
    """Set the present force of a gear train from its residual, less the inertia of the mass carried."""
    edge = view(m["edge"], m["nedge"], I8)
    n = edge.size
    X = view(m["exchange"], (EXCHANGE_ROWS, n + 2), F8)
    P = view(m["transfer"], (4, n, n), F8)
    R = view(c["R"], c["nd"], F8)
    a = view(c["a"], c["nd"], F8)
    for i in range(n):
        force = R[edge[i]]
        for j in range(n):
            force -= P[CARRIED, i, j] * a[edge[j]]
        X[FORCE, i] = force


@kernel
def solve_fast(at, spare, other):
    """Solve for the correction of a gear train; its present forces move the interface."""
    status = solve_entry(at, spare, other)
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    _set_force(c, m)
    edge = view(m["edge"], m["nedge"], I8)
    n = edge.size
    X = view(m["exchange"], (EXCHANGE_ROWS, n + 2), F8)
    P = view(m["transfer"], (4, n, n), F8)
    v = view(c["v"], c["nd"], F8)
    a = view(c["a"], c["nd"], F8)
    for i in range(n):
        second = 0.0
        for j in range(n):
            second -= P[MOBILITY, i, j] * (X[FORCE, j] - X[EXPECTED, j])
        X[TRIAL, i] = second
    for i in range(n):
        a[edge[i]] = X[BASE_A, i] + X[TRIAL, i]
        v[edge[i]] = X[BASE_V, i] + X[FLAGS, HALF] * X[TRIAL, i]
    return status


@kernel
def solve_slow(at, spare, other):
    """Solve for the correction of the rest; the force of the gear train does not depend on its position."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    edge = view(m["edge"], m["nedge"], I8)
    n = edge.size
    X = view(m["exchange"], (EXCHANGE_ROWS, n + 2), F8)
    P = view(m["transfer"], (4, n, n), F8)
    R = view(c["R"], c["nd"], F8)
    q = view(c["q"], c["nd"], F8)
    v = view(c["v"], c["nd"], F8)
    for i in range(n):
        for j in range(n):
            R[edge[i]] -= P[STIFFNESS, i, j] * (q[edge[j]] - X[AT, j])
            R[edge[i]] -= P[DAMPING, i, j] * (v[edge[j]] - X[AT_RATE, j])
    return solve_entry(at, spare, other)


@kernel
def factor_slow(at, mass, other):
    """Factor the matrix of the rest without the elements of the gear train."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    n = m["nedge"]
    places = view(m["places"], (n, n), I8)
    P = view(m["transfer"], (4, n, n), F8)
    A = view(c["A"], 36 * c["na"], F8)
    for i in range(n):
        for j in range(n):
            if places[i, j] >= 0:
                A[places[i, j]] -= c["cd"] * P[DAMPING, i, j] + P[STIFFNESS, i, j]
    return factor_entry(at, mass, other)


@kernel
def begin(m):
    """Begin a long step: z is zero, its acceleration is due to the last force of the gear train.

    The mean of the forces is that of the trapezoidal rule.
    """
    n = m["nedge"]
    X = view(m["exchange"], (EXCHANGE_ROWS, n + 2), F8)
    P = view(m["transfer"], (4, n, n), F8)
    for i in range(n):
        X[SUM, i] = 0.5 * X[FORCE, i]
        X[Z, i] = 0.0
        X[Z_RATE, i] = 0.0
        second = 0.0
        for j in range(n):
            second -= P[MOBILITY, i, j] * (X[FORCE, j] - X[END, j])
        X[Z_SECOND, i] = second


@kernel
def begin_signals(m, whole):
    """Keep the signals that act on a gear train at the start of a long step, and their last slopes."""
    driven = view(m["driven"], m["ndriven"], I8)
    n = driven.size
    D = view(m["demand"], (2, n + 1), F8)
    for k in range(n):
        value = view(driven[k], 1, F8)[0]
        D[1, k] = (value - D[0, k]) / D[1, n] if D[0, n] != 0.0 else 0.0
        D[0, k] = value
    D[0, n] = 1.0
    D[1, n] = whole


@kernel
def place_signals(m, tau):
    """Extrapolate the signals that act on a gear train by tau: blocks have new values in long steps only."""
    driven = view(m["driven"], m["ndriven"], I8)
    D = view(m["demand"], (2, driven.size + 1), F8)
    for k in range(driven.size):
        view(driven[k], 1, F8)[0] = D[0, k] + D[1, k] * tau


@kernel
def place(c, m, tau, h):
    """Add z to the extrapolated motion, after a short step h that ends at tau of the long step."""
    edge = view(m["edge"], m["nedge"], I8)
    n = edge.size
    X = view(m["exchange"], (EXCHANGE_ROWS, n + 2), F8)
    q = view(c["q"], c["nd"], F8)
    v = view(c["v"], c["nd"], F8)
    a = view(c["a"], c["nd"], F8)
    X[FLAGS, HALF] = 0.5 * h
    for i in range(n):
        k = edge[i]
        second = X[Z_SECOND, i]
        X[BASE_V, i] = v[k] + X[Z_RATE, i] + 0.5 * h * second
        X[BASE_A, i] = a[k]
        X[EXPECTED, i] = X[END, i] + X[SLOPE, i] * tau
        q[k] += X[Z, i] + h * (X[Z_RATE, i] + 0.5 * h * second)
        v[k] = X[BASE_V, i] + 0.5 * h * second
        a[k] += second
        X[TRIAL, i] = second


@kernel
def accept(m, h):
    """Take over z of a short step h."""
    n = m["nedge"]
    X = view(m["exchange"], (EXCHANGE_ROWS, n + 2), F8)
    for i in range(n):
        X[Z, i] += h * (X[Z_RATE, i] + 0.5 * h * X[Z_SECOND, i])
        X[Z_RATE, i] += 0.5 * h * (X[Z_SECOND, i] + X[TRIAL, i])
        X[Z_SECOND, i] = X[TRIAL, i]


@kernel
def keep_motion(m, back):
    """Save z before a short step is divided; with back 1 restore it."""
    n = m["nedge"]
    X = view(m["exchange"], (EXCHANGE_ROWS, n + 2), F8)
    for i in range(n):
        for row in range(3):
            if back != 0:
                X[Z + row, i] = X[SAVED + row, i]
            else:
                X[SAVED + row, i] = X[Z + row, i]


@kernel
def measure(at, t):
    """Take the force of a gear train at the state in the workspace as end force, without history."""
    status = residual(at, t, FORCES, 0.0, 0.0, 0.0)
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    edge = view(m["edge"], m["nedge"], I8)
    n = edge.size
    X = view(m["exchange"], (EXCHANGE_ROWS, n + 2), F8)
    X[:] = 0.0
    view(m["demand"], (2, m["ndriven"] + 1), F8)[0, m["ndriven"]] = 0.0
    _set_force(c, m)
    for i in range(n):
        X[END, i] = X[FORCE, i]
    return status


@kernel
def measure_entry(at, spare, other):
    """Take the force of a gear train at the time in its control record, see `measure`."""
    return measure(at, view(at, 1, CTL)[0]["t"])


@kernel
def collect(c, m, k, count, whole):
    """Add the force after short step k to the mean of a long step; after the last one set its end force.

    `shift` becomes the end force less the present one.
    """
    edge = view(m["edge"], m["nedge"], I8)
    n = edge.size
    X = view(m["exchange"], (EXCHANGE_ROWS, n + 2), F8)
    shift = view(m["shift"], c["nd"], F8)
    q = view(c["q"], c["nd"], F8)
    v = view(c["v"], c["nd"], F8)
    for i in range(n):
        X[SUM, i] += X[FORCE, i] if k < count else 0.5 * X[FORCE, i]
        if k == count:
            mean = X[SUM, i] / count
            before = X[MEAN, i] if X[FLAGS, MEASURED] != 0.0 else mean
            end = mean + 0.5 * (mean - before)
            X[MEAN, i] = mean
            X[SLOPE, i] = (end - X[END, i]) / whole
            X[END, i] = end
            X[AT, i] = q[edge[i]]
            X[AT_RATE, i] = v[edge[i]]
            shift[edge[i]] = end - X[FORCE, i]
    if k == count:
        X[FLAGS, MEASURED] = 1.0


def forget_slopes(fast: Part) -> None:
    """Extrapolate no signals in the next long step: they have jumped."""
    fast.arrays["demand"][0, -1] = 0.0


def connect(system: System, state: State, parts: tuple[Part, Part], factors: tuple[float, float]) -> None:
    """Connect a gear train and the rest at their interface.

    Parameters
    ----------
    system, state
        The system and the state at which masses, stiffness and damping are taken.
    parts
        Fast and slow part.
    factors
        Factors cm and cd of a long step.
    """
    fast, slow = parts
    cm, cd = factors
    edge = np.intersect1d(fast.loaded, slow.own)
    n, here = edge.size, np.ix_(edge, edge)
    whole = evaluate.matrix(system, state, cm, STIFFER * cd, STIFFER, NEWTON)
    evaluate.load(system, state)
    found = {k: fast.matrix(state.t, *f)[here] for k, f in _FACTORS.items()}
    whole[here] -= STIFFER * (cd * found[DAMPING] + found[STIFFNESS])
    mobility = cm * np.linalg.inv(whole[np.ix_(slow.own, slow.own)])
    place = np.searchsorted(slow.own, edge)
    shared = {
        "edge": edge,
        "transfer": np.stack([mobility[np.ix_(place, place)], *(found[k] for k in range(CARRIED, 4))]),
        "places": _places(system, edge),
        "exchange": np.zeros((EXCHANGE_ROWS, n + 2)),
    }
    fast.attach(shared, solve_fast)
    slow.attach(shared, solve_slow, factor_slow)


def _places(system: System, edge: NDArray[np.int64]) -> NDArray[np.int64]:
    """Places of the interface coordinates in the matrix blocks, -1 outside of them, shape (n, n)."""
    rows, columns, places = system.layout.entries
    found = np.full((edge.size, edge.size), -1, np.int64)
    inside = np.isin(rows, edge) & np.isin(columns, edge)
    found[np.searchsorted(edge, rows[inside]), np.searchsorted(edge, columns[inside])] = places[inside]
    return found


_FACTORS = {CARRIED: (1.0, 0.0, 0.0), STIFFNESS: (0.0, 0.0, 1.0), DAMPING: (0.0, 1.0, 0.0)}
