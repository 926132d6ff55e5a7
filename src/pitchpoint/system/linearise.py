# SPDX-License-Identifier: Apache-2.0
"""Exact linearisation: terms of moving axes, rotated loads and gyroscopic effects.

Integrators do not use these terms. They have a separate entry, compiled only if modes or damping require it.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.multibody.bodies import BODY, PATH
from pitchpoint.multibody.channels import CTL, F8, FRAME, GUIDE, I8
from pitchpoint.multibody.inertia import attitude, inertia
from pitchpoint.multibody.joint_rates import guided_geometry, joint_motions, joint_rates
from pitchpoint.multibody.projection import PROJ, project_geometry, project_tangent
from pitchpoint.multibody.rigid_inertia import tree_attitude, tree_inertia
from pitchpoint.multibody.tree import MOTION
from pitchpoint.system.residual import COLUMNS, EXACT, FORCES, residual, run_kinds, zero
from pitchpoint.system.workspace import MACH


@kernel
def _project(proj, J, kk, X, A, T):
    """`project_tangent` as a separate function, so that it is compiled only once here."""
    project_tangent(proj, J, kk, X, A, T)


@kernel
def _any(x):
    """Whether a vector has a nonzero element; at rest most terms vanish and are skipped."""
    others = 0
    for i in range(x.size):
        others += int(x[i] != 0.0)
    return others > 0


@kernel
def exact_rates(at, cm, cd, ck):
    """Add the terms of the exact matrix that are not frame tangents.

    Due to the moving joint axes twists depend on q, and accelerations on q and v:
    A += ck J^T D (d twist/dq) + J^T M (cd d acc/dv + ck d acc/dq). Requires further passes over the elements.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    n = m["npath"]
    body = view(m["body"], c["nb"], BODY)
    fr = view(c["fr"], c["nb"], FRAME)
    J = view(m["J"], (n, 6, 6), F8)
    Tq = view(m["Tq"], (n, 6, 6), F8)
    Av = view(m["Av"], (n, 6, 6), F8)
    Aq = view(m["Aq"], (n, 6, 6), F8)
    T = view(m["T"], (6, 6), F8)
    kk = view(c["kk"], (c["np"], 6, 6), F8)
    A = view(c["A"], (c["na"], 6, 6), F8)
    proj = view(m["proj"], m["nproj"], PROJ)
    guides = view(c["guides"], c["ng"], GUIDE)
    v = view(c["v"], c["nd"], F8)
    a = view(c["a"], c["nd"], F8)
    joint_rates(
        body, view(m["path"], n, PATH), fr, view(m["motions"], c["nb"], MOTION), guides, (Tq, Av, Aq), v, a
    )
    zero(view(c["kk"], 36 * c["np"], F8))
    attitude(body, fr, kk, ck)
    tree_attitude(body, fr, kk, ck)
    if _any(view(c["kk"], 36 * c["np"], F8)):
        _project(proj, J, kk, J, A, T)
    for p in range(n):
        for i in range(6):
            for k in range(6):
                Tq[p, i, k] *= ck
                Aq[p, i, k] = cd * Av[p, i, k] + ck * Aq[p, i, k]
    c["ck"] = 0.0
    if _any(view(m["Tq"], 36 * n, F8)):
        zero(view(c["kk"], 36 * c["np"], F8))
        inertia(body, fr, kk, EXACT, 0.0, 1.0)
        tree_inertia(body, fr, kk, EXACT, 0.0, 1.0)
        c["cm"] = 0.0
        c["cd"] = 1.0
        c["jac"] = EXACT
        status = run_kinds(at, view(m["forces"], (m["nforces"], COLUMNS), I8), 1)
        if status != OK:
            return status
        _project(proj, J, kk, Tq, A, T)
    if not _any(view(m["Aq"], 36 * n, F8)):
        return OK
    zero(view(c["kk"], 36 * c["np"], F8))
    inertia(body, fr, kk, EXACT, 1.0, 0.0)
    tree_inertia(body, fr, kk, EXACT, 1.0, 0.0)
    c["cm"] = 1.0  # elements with mass add theirs
    c["cd"] = 0.0
    c["jac"] = FORCES
    status = run_kinds(at, view(m["forces"], (m["nforces"], COLUMNS), I8), 1)
    if status != OK:
        return status
    _project(proj, J, kk, Aq, A, T)
    return OK


@kernel
def entry(at, spare, other):
    """Exact blocks of cm M + cd D + ck K at the state, time and factors in the workspace."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    n = m["npath"]
    cm = c["cm"]
    cd = c["cd"]
    ck = c["ck"]
    fr = view(c["fr"], c["nb"], FRAME)
    nd = c["nd"]
    status = residual(at, c["t"], FORCES, cm, cd, ck)
    if status != OK:
        return status
    joint_motions(
        view(m["body"], c["nb"], BODY),
        fr,
        view(m["motions"], c["nb"], MOTION),
        view(c["guides"], c["ng"], GUIDE),
        view(m["charts"], (m["ncharts"], 3, 3), F8),
        view(c["q"], nd, F8),
        view(c["v"], nd, F8),
        view(c["a"], nd, F8),
    )
    status = residual(at, c["t"], EXACT, cm, cd, ck)
    if status != OK:
        return status
    J = view(m["J"], (n, 6, 6), F8)
    A = view(c["A"], (c["na"], 6, 6), F8)
    proj = view(m["proj"], m["nproj"], PROJ)
    path = view(m["path"], n, PATH)
    project_geometry(proj, path, fr, J, A, ck)
    if c["ng"] > 0:
        body = view(m["body"], c["nb"], BODY)
        guides = view(c["guides"], c["ng"], GUIDE)
        guided_geometry(proj, path, body, fr, view(m["motions"], c["nb"], MOTION), guides, A, ck)
    return exact_rates(at, cm, cd, ck)
