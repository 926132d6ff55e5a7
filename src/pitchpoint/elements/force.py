# SPDX-License-Identifier: Apache-2.0
"""Force and moment on a body at a point of its spin axis, in world axes, scaled by a signal; also weight.

The signal is a factor: constant, table, formula or user law of time, angle and speed.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.elements.signal import SIGNAL, signal
from pitchpoint.multibody.channels import frame_args

SPINS = "free"

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + SIGNAL
    + [
        ("F", "f8", 6),  # force [N] and moment [N m] at a signal of one, world axes
        ("z", "f8"),  # point of attack on the spin axis, from the origin [m]
        ("W", "f8", 6),  # scratch: wrench about the origin at a signal of one
        ("out", "i8"),
    ],
    align=True,
)


@kernel
def _turning_arm(f, F, k, s):
    """Add s times the change of n x F with the turn of the axis n."""
    n0 = f["R"][0, 2]
    n1 = f["R"][1, 2]
    n2 = f["R"][2, 2]
    for a in range(3):
        x = 1.0 if a == 0 else 0.0
        y = 1.0 if a == 1 else 0.0
        u = 1.0 if a == 2 else 0.0
        h0 = y * n2 - u * n1  # change of n with a turn about axis a
        h1 = u * n0 - x * n2
        h2 = x * n1 - y * n0
        k[3, 3 + a] += s * (h1 * F[2] - h2 * F[1])
        k[4, 3 + a] += s * (h2 * F[0] - h0 * F[2])
        k[5, 3 + a] += s * (h0 * F[1] - h1 * F[0])


@kernel
def _slopes(f, W, k, by_angle, by_place, by_rate):
    """Subtract the change of the wrench with its factor: over the spin, and over the speed n . omega."""
    R = f["R"]
    w = f["tw"]
    for a in range(3):
        i = (a + 1) % 3
        h = (a + 2) % 3
        moved = R[i, 2] * w[3 + h] - R[h, 2] * w[3 + i]  # of the speed with the turn of n: n x omega
        s = by_angle * f["axle"][a] + by_place * moved + by_rate * R[a, 2]
        for r in range(6):
            k[r, 3 + a] -= s * W[r]


@kernel
def force(rec, ctl, fr, kk):
    """Wrenches of all forces; tangents only where they have to be exact."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        F = b["F"]
        z = b["z"]
        w = f["tw"]
        speed = f["R"][0, 2] * w[3] + f["R"][1, 2] * w[4] + f["R"][2, 2] * w[5]
        slopes = 1 if c["jac"] == 2 else 0
        scale, by_angle, by_speed = signal(b, c["t"], f["phi"], f["turns"], speed, slopes)
        if not math.isfinite(scale):
            c["bad"] = e
            return NOT_FINITE
        n0 = f["R"][0, 2]
        n1 = f["R"][1, 2]
        n2 = f["R"][2, 2]
        W = b["W"]
        for r in range(6):
            W[r] = F[r]
        W[3] += z * (n1 * F[2] - n2 * F[1])
        W[4] += z * (n2 * F[0] - n0 * F[2])
        W[5] += z * (n0 * F[1] - n1 * F[0])
        for r in range(6):
            f["F"][r] += scale * W[r]
        if c["jac"] == 2:
            _turning_arm(f, F, kk[b["ii"]], -c["ck"] * z * scale)
            _slopes(f, W, kk[b["ii"]], c["ck"] * by_angle, c["ck"] * by_speed, c["cd"] * by_speed)
    return OK


@kernel
def entry(ctl, rec, n):
    """Uniform entry of the kind."""
    c, fr, kk = frame_args(ctl)
    return force(view(rec, n, RECORD), c, fr, kk)
