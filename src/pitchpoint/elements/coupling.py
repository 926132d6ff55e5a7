# SPDX-License-Identifier: Apache-2.0
"""Torsional coupling between two bodies (body 0 = ground): spring and damper on the difference of the spins.

With a gap the spring acts beyond +-gap/2 only; the damper acts always. The torque turns about the spin axis
of each body, so it is meant for bodies whose axes are (nearly) parallel; the sense flips where they are
opposite.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.multibody.channels import frame_args, observations

TWO_PI = 6.283185307179586

SPINS = "together"

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("k", "f8"),  # stiffness [N m/rad]
        ("d", "f8"),  # damping [N m s/rad]
        ("u0", "f8"),  # difference of the spins without torque [rad]
        ("gap", "f8"),  # total play [rad]
        ("out", "i8"),
    ],
    align=True,
)

OUTPUTS = (
    ("torque", "N m", "torque on the first body"),
    ("twist", "rad", "angle of the first body against the second"),
)


@kernel
def _follow(f, k, torque):
    """Add the change of a torque that follows the spin axis: d(T n) = T dtheta x n."""
    n0 = f["R"][0, 2]
    n1 = f["R"][1, 2]
    n2 = f["R"][2, 2]
    k[3, 4] -= torque * n2
    k[3, 5] += torque * n1
    k[4, 5] -= torque * n0
    k[4, 3] += torque * n2
    k[5, 3] -= torque * n1
    k[5, 4] += torque * n0


@kernel
def coupling(rec, ctl, fr, kk):
    """Torques, tangents and observations of all couplings."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        u = f["phi"] - g["phi"] + TWO_PI * (f["turns"] - g["turns"]) - b["u0"]
        k = b["k"]
        half = 0.5 * b["gap"]
        x = u
        if half > 0.0:
            if u > half:
                x = u - half
            elif u < -half:
                x = u + half
            else:
                x = 0.0
                k = 0.0
        torque = -k * x - b["d"] * (f["spin"] - g["spin"])
        for r in range(3):
            f["F"][3 + r] += torque * f["R"][r, 2]
            g["F"][3 + r] -= torque * g["R"][r, 2]
        if c["jac"] != 0:
            s = c["ck"] * k + c["cd"] * b["d"]
            p = kk[b["ii"]]
            q = kk[b["ij"]]
            o = kk[b["ji"]]
            w = kk[b["jj"]]
            for r in range(3):
                for h in range(3):
                    p[3 + r, 3 + h] += s * f["R"][r, 2] * f["R"][h, 2]
                    q[3 + r, 3 + h] -= s * f["R"][r, 2] * g["R"][h, 2]
                    o[3 + r, 3 + h] -= s * g["R"][r, 2] * f["R"][h, 2]
                    w[3 + r, 3 + h] += s * g["R"][r, 2] * g["R"][h, 2]
            _follow(f, p, torque * c["ck"])
            _follow(g, w, -torque * c["ck"])
        if c["out"] != 0:
            out = observations(ctl)
            out[b["out"]] = torque
            out[b["out"] + 1] = u
    return OK


@kernel
def entry(ctl, rec, n):
    """Uniform entry of the kind."""
    c, fr, kk = frame_args(ctl)
    return coupling(view(rec, n, RECORD), c, fr, kk)
