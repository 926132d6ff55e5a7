# SPDX-License-Identifier: Apache-2.0
"""Constant force and moment on a body at a point of its spin axis, in world axes; also weight."""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.multibody.channels import frame_args

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("F", "f8", 6),  # force [N] and moment [N m], world axes
        ("z", "f8"),  # point of attack on the spin axis, from the origin [m]
        ("out", "i8"),
    ],
    align=True,
)


@kernel
def force(rec, ctl, fr, kk):
    """Wrenches of all constant forces; the tangent is the turn of the arm with the axis."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        F = b["F"]
        z = b["z"]
        n0 = f["R"][0, 2]
        n1 = f["R"][1, 2]
        n2 = f["R"][2, 2]
        for r in range(6):
            f["F"][r] += F[r]
        f["F"][3] += z * (n1 * F[2] - n2 * F[1])
        f["F"][4] += z * (n2 * F[0] - n0 * F[2])
        f["F"][5] += z * (n0 * F[1] - n1 * F[0])
        if c["jac"] == 2 and z != 0.0:
            k = kk[b["ii"]]
            s = -c["ck"] * z
            for a in range(3):
                x = 1.0 if a == 0 else 0.0
                y = 1.0 if a == 1 else 0.0
                w = 1.0 if a == 2 else 0.0
                h0 = y * n2 - w * n1  # change of n with a turn about axis a
                h1 = w * n0 - x * n2
                h2 = x * n1 - y * n0
                k[3, 3 + a] += s * (h1 * F[2] - h2 * F[1])
                k[4, 3 + a] += s * (h2 * F[0] - h0 * F[2])
                k[5, 3 + a] += s * (h0 * F[1] - h1 * F[0])
    return OK


@kernel
def entry(ctl, rec, n):
    """Uniform entry of the kind."""
    c, fr, kk = frame_args(ctl)
    return force(view(rec, n, RECORD), c, fr, kk)
