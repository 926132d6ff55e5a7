# SPDX-License-Identifier: Apache-2.0
"""Torque about the spin axis of a body: constant, table, formula or user law of time, angle and speed.

The torque vector follows the spin axis; its reaction goes to body j (0 = ground). The speed a law sees is the
angular velocity along the axis, so power is torque times that speed.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.elements.signal import CONSTANT, SIGNAL, signal
from pitchpoint.multibody.channels import frame_args, observations

SPINS = "free"

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")] + SIGNAL + [("out", "i8")], align=True
)

OUTPUTS = (("torque", "N m", "torque of the load on its body"),)


@kernel
def _tangent(f, k, s, torque, by_angle, by_speed, ck, cd):
    """Add s times the derivative of the torque vector by the motion of its body."""
    R = f["R"]
    n0 = R[0, 2]
    n1 = R[1, 2]
    n2 = R[2, 2]
    w = f["tw"]
    g0 = n1 * w[5] - n2 * w[4]  # change of the speed with the turn of the axis: n x omega
    g1 = n2 * w[3] - n0 * w[5]
    g2 = n0 * w[4] - n1 * w[3]
    for r in range(3):
        p = s * R[r, 2]
        k[3 + r, 3] += p * ((ck * by_angle + cd * by_speed) * n0 + ck * by_speed * g0)
        k[3 + r, 4] += p * ((ck * by_angle + cd * by_speed) * n1 + ck * by_speed * g1)
        k[3 + r, 5] += p * ((ck * by_angle + cd * by_speed) * n2 + ck * by_speed * g2)
    t = s * ck * torque  # dn = dtheta x n
    k[3, 4] += t * n2
    k[3, 5] -= t * n1
    k[4, 5] += t * n0
    k[4, 3] -= t * n2
    k[5, 3] += t * n1
    k[5, 4] -= t * n0


@kernel
def _spin_alone(f, k, s):
    """Correct s times the slope over the angle: of a tilted body not every turn about its axis is spin."""
    for r in range(3):
        for a in range(3):
            k[3 + r, 3 + a] += s * f["R"][r, 2] * (f["axle"][a] - f["R"][a, 2])


@kernel(inline=True)
def torque(rec, ctl, fr, kk):
    """Torques, tangents and observations of all loads."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        R = f["R"]
        w = f["tw"]
        value = b["value"]
        by_angle = 0.0
        by_speed = 0.0
        if b["form"] != CONSTANT or b["ramp"] > 0.0:
            speed = R[0, 2] * w[3] + R[1, 2] * w[4] + R[2, 2] * w[5]
            value, by_angle, by_speed = signal(b, c["t"], f["phi"], f["turns"], speed, c["jac"])
        if not math.isfinite(value):
            c["bad"] = e
            return NOT_FINITE
        for r in range(3):
            f["F"][3 + r] += value * R[r, 2]
            g["F"][3 + r] -= value * R[r, 2]
        if c["jac"] != 0:
            _tangent(f, kk[b["ii"]], -1.0, value, by_angle, by_speed, c["ck"], c["cd"])
            if b["j"] != 0:
                _tangent(f, kk[b["ji"]], 1.0, value, by_angle, by_speed, c["ck"], c["cd"])
            if c["jac"] == 2 and by_angle != 0.0:
                _spin_alone(f, kk[b["ii"]], -c["ck"] * by_angle)
                if b["j"] != 0:
                    _spin_alone(f, kk[b["ji"]], c["ck"] * by_angle)
        if c["out"] != 0:
            observations(ctl)[b["out"]] = value
    return OK


@kernel
def entry(ctl, rec, n):
    """Uniform entry of the kind."""
    c, fr, kk = frame_args(ctl)
    return torque(view(rec, n, RECORD), c, fr, kk)
