# SPDX-License-Identifier: Apache-2.0
"""Start values of generalised-alpha for second-order multipliers from the first step.

The algorithmic acceleration refers to the time (alpha_m - alpha_f) h after that of the state, and in index 3
runs the rates deviate by C h^2 q''' along the rows, C = (1 - 6 beta - 3 (alpha_m - alpha_f))/6. Start values
without both corrections cause first-order errors of multipliers and accelerations, which decay over many
steps, and not at all with rho_inf = 1.

Source: M. Arnold, O. Bruels, A. Cardona, Error analysis of generalized-alpha Lie group time integration
methods for constrained mechanical systems, Numerische Mathematik 129 (2015) 149-179, section 4.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.kernel import invoke, plain
from pitchpoint.core.status import OK
from pitchpoint.solvers.taylor import APART, DISAGREEMENT, forward_derivatives
from pitchpoint.system.linear import solve_entry
from pitchpoint.system.requests import ACCELERATE, send_request
from pitchpoint.system.system import System

Array = NDArray[np.float64]

FASTEST = 100.0
"""Largest change of the slope of the accelerations over a step, relative to the slope, by the change of the
rates that it causes: step times damping over twice the mass."""

_derivatives = plain(forward_derivatives)  # for arrays


def first_slopes(system: System, t: float, h: float) -> tuple[Array, Array] | None:
    """Derivatives of the accelerations and multipliers at the state in the workspace.

    None if two difference quotients disagree: very stiff modes, or forces that start or end within a step;
    or if the accelerations would decay within a small part of the step: very strong damping.

    Parameters
    ----------
    system
        Its workspace contains state, accelerations and multipliers.
    t
        Time of the state [s].
    h
        Step [s].
    """
    w = system.workspace
    q, v, a, lam = w.q.copy(), w.v.copy(), w.a.copy(), w.lam.copy()
    bad, kind = w.ctl[0]["bad"], w.ctl[0]["badkind"]
    d = APART * h
    found: list[tuple[Array, Array]] = []
    for s in (d, 2.0 * d):
        w.q[:], w.v[:] = q + s * v + 0.5 * s * s * a, v + s * a
        w.a[:], w.lam[:] = a, lam
        if send_request(w, ACCELERATE, t + s) == OK:
            found.append((w.a.copy(), w.lam.copy()))
    soon_jerk = None
    if len(found) == 2:  # the first quotient continued with the change of the rates that it causes
        slope = (found[0][0] - a) / d
        w.q[:], w.v[:] = q + d * v + 0.5 * d * d * a + d**3 / 6.0 * slope, v + d * a + 0.5 * d * d * slope
        w.a[:], w.lam[:] = a, lam
        if send_request(w, ACCELERATE, t + d) == OK:
            soon_jerk = w.a.copy()
    w.q[:], w.v[:] = q, v
    status = send_request(w, ACCELERATE, t)
    w.a[:], w.lam[:] = a, lam
    w.ctl[0]["bad"], w.ctl[0]["badkind"] = bad, kind
    if status != OK or soon_jerk is None:
        return None
    (soon, soon_lam), (later, later_lam) = found
    weight = w.arrays["weight"]
    with np.errstate(over="ignore", invalid="ignore"):  # divergence is reported by a status
        jerk, snap = _derivatives(a, soon, later, d)
        size = float(np.linalg.norm(weight * (soon - a))) / d
        change = float(np.linalg.norm(weight * snap)) * 0.5 * d  # difference of the two jerk estimates
        if not change <= DISAGREEMENT * size < np.inf:
            return None
        if float(np.linalg.norm(weight * (soon_jerk - soon))) > FASTEST * APART * size * d:
            return None
        rise, _ = _derivatives(lam, soon_lam, later_lam, d)
    return jerk, rise


def shift_rates(system: System, change: Array) -> None:
    """Change the rates in the workspace as little as possible so that the row residual becomes G change.

    Parameters
    ----------
    system
        Its workspace contains the factors of the mass matrix and of the rows at the state, as after
        `first_slopes`.
    change
        Change of the rates; only its component along the rows has an effect, shape (nd,).
    """
    w = system.workspace
    w.R[:] = 0.0
    w.g[:] = w.G.reshape(len(w.lam), -1) @ (w.v - change) + w.gt
    if invoke(solve_entry, w.at, 0, 0) == OK and np.isfinite(w.arrays["x"]).all():
        w.v[:] += w.arrays["x"]
