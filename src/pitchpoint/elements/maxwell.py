# SPDX-License-Identifier: Apache-2.0
"""Maxwell element: spring and damper in series along the line between two body-fixed points.

The state is the tension T. It is equal in both parts, and their elongation rates add up to that of the line:

    dT/dt = k (w - T/d)

J. C. Maxwell, Phil. Trans. R. Soc. 157 (1867). Body k is a hidden torsional body of polar inertia 1 kg m^2 on
ground; its spin rate is T in newtons. A spring or damper in parallel gives the standard linear solid.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.kind import FRAME, FREE, WITH_STATE, Kind
from pitchpoint.elements.line import line_between, line_column, pull, tension_tangent
from pitchpoint.elements.wrench import put, spin_axis
from pitchpoint.multibody.channels import frame_args, observations
from pitchpoint.multibody.vectors import cross, dot, times, unit

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj", "k", "ik", "ki", "jk", "kj", "kk")]
    + [
        ("p_i", "f8", 3),  # point on body i from its origin, axes of the body [m]
        ("p_j", "f8", 3),  # point on body j likewise
        ("stiffness", "f8"),  # of the spring [N/m]
        ("damping", "f8"),  # of the damper [N s/m]
        ("out", "i8"),
    ],
    align=True,
)

OUTPUTS = (("tension", "N", "tension of a spring, positive in tension"),)


@kernel
def _state_tangent(b, f, g, kk, ctl, line, n):
    """Add the tangents with respect to the state: of the force by T, and of the rate of T."""
    c = ctl[0]
    arm_i, arm_j, e, length, w, rate = line
    k = b["stiffness"]
    nothing = (0.0, 0.0, 0.0)
    for h in range(3):  # dT = n . (angular velocity of body k)
        s = c["cd"] * dot(unit(h), n)
        put(kk[b["ik"]], 3 + h, s, e, cross(arm_i, e))
        put(kk[b["jk"]], 3 + h, -s, e, cross(arm_j, e))
        put(kk[b["kk"]], 3 + h, s * k / b["damping"], nothing, n)
    for side in range(2):
        if side == 1 and b["j"] == 0:
            break
        for h in range(6):
            longer, faster, across, moved = line_column(f, g, line, side, h)
            s = k * (c["ck"] * faster + c["cd"] * longer)
            put(kk[b["ki"]] if side == 0 else kk[b["kj"]], h, -s, nothing, n)


@kernel
def maxwell(rec, ctl, fr, kk):
    """Wrenches, rates of the states, tangents and observations."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        hidden = fr[b["k"]]
        tension = hidden["spin"]
        line = line_between(b, f, g)
        arm_i, arm_j, along, length, w, rate = line
        pull(f, g, arm_i, arm_j, along, tension)
        n = spin_axis(hidden)
        change = times(b["stiffness"] * (rate - tension / b["damping"]), n)
        for r in range(3):
            hidden["F"][3 + r] += change[r]
        if c["jac"] != 0:
            tension_tangent(b, f, g, kk, ctl, line, tension, 0.0, 0.0)
            _state_tangent(b, f, g, kk, ctl, line, n)
        if c["out"] != 0:
            observations(ctl)[b["out"]] = tension
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return maxwell(view(rec, n, RECORD), c, fr, kk)


KIND = Kind(
    name="maxwell",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    pairs=WITH_STATE,
    body_fixed=True,
    spins=FREE,
    sections={"maxwells": "spring"},
)
