# SPDX-License-Identifier: Apache-2.0
"""Residual R(t, q, v, a, lam) = M a - f + G^T lam and its matrix cm M + cd D + ck K.

Statics, modes, frequency response and all integrators use this residual with their own three factors. `jac`
selects the result: FORCES (0), NEWTON (1, tangents may be approximate), EXACT (2, for linearisation) or MASS
(3, mass matrix only, elements compute forces only).
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import call, kernel, view
from pitchpoint.core.status import OK
from pitchpoint.multibody.attitude import attitude
from pitchpoint.multibody.bodies import BODY, PATH
from pitchpoint.multibody.channels import CTL, F8, FRAME, I8
from pitchpoint.multibody.constraints import add_multipliers, frame_rows
from pitchpoint.multibody.inertia import inertia
from pitchpoint.multibody.kinematics import kinematics
from pitchpoint.multibody.projection import PROJ, project_force, project_tangent
from pitchpoint.system.workspace import MACH

FORCES, NEWTON, EXACT, MASS = 0, 1, 2, 3
FRAME_CHANNEL, COORDINATE_CHANNEL = 0, 1
OBSERVER_CHANNEL = 4
"""Channel of signals used for output only; evaluated only when observations are requested."""
ENTRY, RECORDS, COUNT, CHANNEL, EARLY = range(5)
COLUMNS = 5
"""Columns of the address tables: entry, records, number of records, channel, early. early is 1 if the
observations of the kind depend on positions and rates only, so that they are available before the
accelerations, and 2 if they are not requested (`link.heard`)."""
ALL, SOONER, LATER = 0, 1, 2
"""Kinds that observe: all, those that need no accelerations, only the others (the first are then skipped)."""
TWO_PI = 6.283185307179586
MAX_TURN = 1e12  # maximum rotation in one step that is wrapped [rad]


@kernel
def zero(x):
    """Set a vector to zero."""
    for i in range(x.size):
        x[i] = 0.0


@kernel
def run_kinds(at, table, frames_only):
    """Call the entries of an address table; stop at the first error and store its row in `badkind`."""
    c = view(at, 1, CTL)[0]
    part = view(c["mach"], 1, MACH)[0]["part"]
    out = c["out"]
    unseen = c["jac"] == FORCES and (out == 0 or part == SOONER) and c["ev"] == 0
    status = OK
    for e in range(table.shape[0]):
        if unseen and table[e, CHANNEL] == OBSERVER_CHANNEL:
            continue
        if part == LATER and table[e, EARLY] != 0:
            continue
        if frames_only == 0 or table[e, CHANNEL] == FRAME_CHANNEL:
            if part == SOONER:
                c["out"] = out if table[e, EARLY] == 1 else 0
            status = call(table[e, ENTRY], at, table[e, RECORDS], table[e, COUNT])
            if status != OK:
                c["badkind"] = e
                break
    c["out"] = out
    return status


@kernel
def constraints(at):
    """Evaluate all constraint rows; add the multipliers to residual (coordinates) and wrenches (frames)."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nc = c["nc"]
    G = view(c["G"], (nc, c["nd"]), F8)
    Gf = view(c["Gf"], (nc, 2, 6), F8)
    gt = view(c["gt"], nc, F8)
    gtt = view(c["gtt"], nc, F8)
    lam = view(c["lam"], nc, F8)
    for r in range(nc):
        gt[r] = 0.0
        gtt[r] = 0.0
        for k in range(c["nd"]):
            G[r, k] = 0.0
        for side in range(2):
            for k in range(6):
                Gf[r, side, k] = 0.0
    status = run_kinds(at, view(m["cons"], (m["ncons"], COLUMNS), I8), 0)
    if status != OK:
        c["badkind"] += m["nforces"]
        return status
    add_multipliers(G, lam, view(c["R"], c["nd"], F8))
    frame_rows(
        view(m["rows"], (nc, 2), I8),
        view(m["body"], c["nb"], BODY),
        view(m["path"], m["npath"], PATH),
        view(c["fr"], c["nb"], FRAME),
        view(m["J"], (m["npath"], 6, 6), F8),
        Gf,
        G,
        lam,
    )
    return OK


@kernel
def entry(at, jac, spare):
    """Evaluate R, and with jac > 0 the matrix, at the state, time and factors in the workspace."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    nb = c["nb"]
    n = m["npath"]
    body = view(m["body"], nb, BODY)
    fr = view(c["fr"], nb, FRAME)
    J = view(m["J"], (n, 6, 6), F8)
    R = view(c["R"], nd, F8)
    kk = view(c["kk"], (c["np"], 6, 6), F8)
    A = view(c["A"], (c["na"], 6, 6), F8)
    kinematics(body, fr, J, view(c["q"], nd, F8), view(c["v"], nd, F8), view(c["a"], nd, F8))
    zero(R)
    if jac != FORCES:
        zero(view(c["A"], 36 * c["na"], F8))  # as a vector, which compiles to a single call
        zero(view(c["kk"], 36 * c["np"], F8))
    else:
        c["cm"] = 0.0  # elements with mass use this factor for any jac
    inertia(body, fr, kk, jac, c["cm"], c["cd"])
    c["jac"] = FORCES if jac == MASS else jac
    if m["tree"] != 0:
        status = call(m["tree"], at, jac, 0)
        if status != OK:
            return status
    status = run_kinds(at, view(m["forces"], (m["nforces"], COLUMNS), I8), 0)
    if status != OK:
        return status
    if c["nc"] > 0:
        status = constraints(at)
        if status != OK:
            return status
    if m["part"] == LATER:
        return OK
    if m["nfrictions"] > 0:
        status = run_kinds(at, view(m["frictions"], (m["nfrictions"], COLUMNS), I8), 0)
        if status != OK:
            c["badkind"] += m["nforces"] + m["ncons"] + m["nguiding"]
            return status
    project_force(view(m["path"], n, PATH), fr, J, R)
    if jac != FORCES:
        proj = view(m["proj"], m["nproj"], PROJ)
        if jac == MASS:
            proj = view(m["mass_proj"], m["nmass_proj"], PROJ)
        project_tangent(proj, J, kk, J, A, view(m["T"], (6, 6), F8))
    return OK


@kernel
def residual(at, t, jac, cm, cd, ck):
    """Evaluate R, and with jac > 0 the blocks of cm M + cd D + ck K, at the state in the workspace.

    Called by the address of `entry`, so that its code is compiled once and not inlined in every driver.
    """
    c = view(at, 1, CTL)[0]
    c["t"] = t
    c["cm"] = cm
    c["cd"] = cd
    c["ck"] = ck
    m = view(c["mach"], 1, MACH)[0]
    if m["watch"] == 0 or c["out"] != 0:
        return call(m["residual"], at, jac, 0)
    c["out"] = m["watch"]  # signals read observations of elements
    status = call(m["residual"], at, jac, 0)
    c["out"] = 0
    return status


@kernel
def observe(at, t, where):
    """Write all observations at the state in the workspace to the row at address `where`."""
    c = view(at, 1, CTL)[0]
    c["out"] = where
    status = residual(at, t, FORCES, 0.0, 0.0, 0.0)
    c["out"] = 0
    if status != OK:
        return status
    observe_bodies(at, where)
    return OK


@kernel
def observe_later(at, t, where):
    """Complete the observations at address `where` that `part` SOONER has started at the same state.

    Requires the accelerations and multipliers of the state. The bodies are written by `observe_bodies`.
    """
    m = view(view(at, 1, CTL)[0]["mach"], 1, MACH)[0]
    if m["later"] == 0:
        return OK
    c = view(at, 1, CTL)[0]
    c["out"] = where
    m["part"] = LATER
    status = residual(at, t, FORCES, 0.0, 0.0, 0.0)
    m["part"] = ALL
    c["out"] = 0
    return status


@kernel
def observe_bodies(at, where):
    """Write the observations of the bodies to the row at address `where`."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    table = view(m["body_out"], (m["nbody_out"], 4), I8)
    out = view(where, c["no"], F8)
    q = view(c["q"], c["nd"], F8)
    v = view(c["v"], c["nd"], F8)
    fr = view(c["fr"], c["nb"], FRAME)
    charts = view(m["charts"], (m["ncharts"], 3, 3), F8)
    for e in range(table.shape[0]):
        d = table[e, 2]
        if table[e, 0] == 0:
            out[table[e, 3]] = q[d]
        elif table[e, 0] == 1:  # unwrapped for output
            out[table[e, 3]] = q[d] + TWO_PI * fr[table[e, 1]]["turns"]
        elif table[e, 0] == 3:
            attitude(charts[table[e, 1]], q[d], q[d + 1], q[d + 2], out, table[e, 3])
        else:
            out[table[e, 3]] = v[d]


@kernel
def evaluate_events(at, t, where):
    """Write all event functions at the state in the workspace to the row at address `where`."""
    c = view(at, 1, CTL)[0]
    c["ev"] = where
    status = residual(at, t, FORCES, 0.0, 0.0, 0.0)
    c["ev"] = 0
    return status


@kernel
def wrap(at):
    """Wrap all spins to (-pi, pi] after an accepted step; the subtraction of 2 pi is exact there."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    spins = view(m["spins"], (m["nspins"], 2), I8)
    q = view(c["q"], c["nd"], F8)
    fr = view(c["fr"], c["nb"], FRAME)
    for e in range(spins.shape[0]):
        d = spins[e, 0]
        if not abs(q[d]) < MAX_TURN:
            # NaN, or too large for a meaningful angle: the integrator detects it
            continue
        if abs(q[d]) > 2.0 * TWO_PI:
            # many revolutions in one step: divide instead of counting
            n = math.floor(q[d] / TWO_PI + 0.5)
            q[d] -= n * TWO_PI
            fr[spins[e, 1]]["turns"] += int(n)
        while q[d] > 0.5 * TWO_PI:
            q[d] -= TWO_PI
            fr[spins[e, 1]]["turns"] += 1
        while q[d] <= -0.5 * TWO_PI:
            q[d] += TWO_PI
            fr[spins[e, 1]]["turns"] -= 1
    if m["tumble"] != 0:
        call(m["tumble"], at, 0, 0)
