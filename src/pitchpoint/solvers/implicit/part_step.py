# SPDX-License-Identifier: Apache-2.0
"""One generalised-alpha step of a part of the coordinates; its saved values and its extrapolated motion."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.multibody.channels import CTL, F8, FRAME, I8
from pitchpoint.solvers.implicit.newton import newton_step
from pitchpoint.solvers.implicit.step import coefficients, factors, predict
from pitchpoint.system.workspace import MACH, STAGE_ROWS, VALID

SHORT, LONG = 4, 8
"""First of three rows of the stages of a part: q and v, a and both memories at the start of its step; the
Newton iteration uses the first four. LONG: of a gear train at the start of a long step."""


@kernel
def keep_part(c, m, row, back):
    """Save the values of a part at the start of a step; with back 1 restore them."""
    nd = c["nd"]
    own = view(m["own"], m["nown"], I8)
    stage = view(m["stage"], (STAGE_ROWS, 2 * nd), F8)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    al = view(m["al"], nd, F8)
    ap = view(m["ap"], nd, F8)
    spins = view(m["spins"], (m["nspins"], 2), I8)
    fr = view(c["fr"], c["nb"], FRAME)
    for e in range(spins.shape[0]):
        if back != 0:
            fr[spins[e, 1]]["turns"] = int(stage[row + 2, nd + spins[e, 0]])
        else:
            stage[row + 2, nd + spins[e, 0]] = fr[spins[e, 1]]["turns"]
    for k in range(own.size):
        i = own[k]
        if back != 0:
            q[i] = stage[row, i]
            v[i] = stage[row, nd + i]
            a[i] = stage[row + 1, i]
            al[i] = stage[row + 1, nd + i]
            ap[i] = stage[row + 2, i]
        else:
            stage[row, i] = q[i]
            stage[row, nd + i] = v[i]
            stage[row + 1, i] = a[i]
            stage[row + 1, nd + i] = al[i]
            stage[row + 2, i] = ap[i]


@kernel
def follow(c, m, tau, h):
    """Extrapolate a part from the start of its step by tau, with the slope of its accelerations over h."""
    nd = c["nd"]
    own = view(m["own"], m["nown"], I8)
    stage = view(m["stage"], (STAGE_ROWS, 2 * nd), F8)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    for k in range(own.size):
        i = own[k]
        a0 = stage[SHORT + 1, i]
        jerk = (a0 - stage[SHORT + 2, i]) / h
        a[i] = a0 + jerk * tau
        v[i] = stage[SHORT, nd + i] + tau * (a0 + 0.5 * jerk * tau)
        q[i] = stage[SHORT, i] + tau * (stage[SHORT, nd + i] + tau * (0.5 * a0 + jerk * tau / 6.0))


@kernel
def rescale(c, m, ratio):
    """Rescale the values a fraction of a step ahead or behind, for steps of `ratio` times the length."""
    nd = c["nd"]
    own = view(m["own"], m["nown"], I8)
    a = view(c["a"], nd, F8)
    al = view(m["al"], nd, F8)
    ap = view(m["ap"], nd, F8)
    for k in range(own.size):
        i = own[k]
        al[i] = a[i] + (al[i] - a[i]) * ratio
        ap[i] = a[i] + (ap[i] - a[i]) * ratio
    view(m["clock"], 16, I8)[VALID] = 0


@kernel
def part_step(at, t, h, rho, tol):
    """One generalised-alpha step of a part to the time t; see `step.alpha_step`."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    own = view(m["own"], m["nown"], I8)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    al = view(m["al"], nd, F8)
    ap = view(m["ap"], nd, F8)
    method = coefficients(rho)
    cm, cd, share = factors(h, rho)
    for k in range(own.size):
        predict(own[k], q, v, a, al, ap, h, method)
    status = newton_step(at, t, cm, cd, tol)
    if status == OK:
        for k in range(own.size):
            al[own[k]] += share * a[own[k]]
    return status
