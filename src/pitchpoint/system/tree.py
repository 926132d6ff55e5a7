# SPDX-License-Identifier: Apache-2.0
"""Core kernels of models with trees of bodies, called by address: other models do not compile them."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.multibody.bodies import BODY, PATH
from pitchpoint.multibody.channels import CTL, F8, FRAME, GUIDE, I8
from pitchpoint.multibody.rigid_inertia import tree_inertia
from pitchpoint.multibody.tree import MOTION, start_charts_afresh, tree_kinematics
from pitchpoint.system.residual import COLUMNS, run_kinds
from pitchpoint.system.workspace import MACH, RECHARTED


@kernel
def entry(at, jac, spare):
    """Frames, columns and inertia forces of all bodies that are not round; with jac > 0 also tangents."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    nb = c["nb"]
    n = m["npath"]
    body = view(m["body"], nb, BODY)
    fr = view(c["fr"], nb, FRAME)
    if m["nguiding"] > 0:
        status = run_kinds(at, view(m["guiding"], (m["nguiding"], COLUMNS), I8), 0)
        if status != OK:
            c["badkind"] += m["nforces"] + m["ncons"]
            return status
    tree_kinematics(
        body,
        view(m["path"], n, PATH),
        fr,
        view(m["J"], (n, 6, 6), F8),
        view(m["motions"], nb, MOTION),
        view(c["guides"], c["ng"], GUIDE),
        view(m["charts"], (m["ncharts"], 3, 3), F8),
        view(c["q"], nd, F8),
        view(c["v"], nd, F8),
        view(c["a"], nd, F8),
    )
    tree_inertia(body, fr, view(c["kk"], (c["np"], 6, 6), F8), jac, c["cm"], c["cd"])
    return OK


@kernel
def tumble_entry(at, spare, other):
    """Set new charts of tumbling bodies after a step, if required; counts the changes in the clock."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    view(m["clock"], 16, I8)[RECHARTED] += start_charts_afresh(
        view(m["body"], c["nb"], BODY),
        view(c["fr"], c["nb"], FRAME),
        view(m["charts"], (m["ncharts"], 3, 3), F8),
        view(c["q"], nd, F8),
        view(c["v"], nd, F8),
        view(c["a"], nd, F8),
        view(m["al"], nd, F8),
        view(m["ap"], nd, F8),
    )
    return OK
