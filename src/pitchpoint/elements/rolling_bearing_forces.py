# SPDX-License-Identifier: Apache-2.0
"""Forces of the rolling elements without slopes, for explicit methods.

Same equations as in `rolling_bearing`, whose tangents need the gradients in memory; here they remain in
registers, which is three times as fast.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel

WASHER = 1e-6
"""Cosine of the contact angle up to which grooves are those of washers, with an arc to both sides of the
axial direction."""


@kernel
def push_elements(b, c, s, share, sa0):
    """Subtract the loads of all elements of a row from the forces in the scratch f.

    c and s are cosine and sine of the azimuth of the first element, `share` is the cage ratio, `sa0` the sine
    of the initial contact angle.
    """
    x0, x1, x2, x3, x4 = b["x"][0], b["x"][1], b["x"][2] + b["shift"], b["x"][3], b["x"][4]
    w0, w1, w2, w3, w4, w5 = b["w"][0], b["w"][1], b["w"][2], b["w"][3], b["w"][4], b["w"][5]
    stiffness = b["stiffness"]
    half = b["half"]
    e = b["place"]
    x0 += e * x3
    x1 += e * x4
    ca0 = b["ca"]
    step_c = b["step_c"]
    step_s = b["step_s"]
    A = b["grooves"] if b["floats"] == 0 else 0.0
    gap = b["gap"]
    power = b["exponent"]
    chi = b["chi"]
    f0 = 0.0
    f1 = 0.0
    f2 = 0.0
    f3 = 0.0
    f4 = 0.0
    f5 = 0.0
    for _k in range(b["n"]):
        radial = x0 * c + x1 * s - gap
        axial = x2 - half * (x3 * c + x4 * s)
        ca = ca0
        sa = sa0
        if A > 0.0:
            p = A * ca0 + radial
            q = A * sa0 + axial
            if p < 0.0 and ca0 > WASHER:
                p = 0.0
            if b["one_sided"] != 0 and q * sa0 < 0.0:
                q = 0.0
            length = math.sqrt(p * p + q * q)
            d = length - A
            if d > 0.0:
                ca = p / length
                sa = q / length
        else:
            d = radial * ca0 + axial * sa0
        if d > 0.0:
            g0 = ca * c
            g1 = ca * s
            arm = half * sa - e * ca
            g3 = -arm * c
            g4 = -arm * s
            g5 = share * (ca * (x1 * c - x0 * s) + half * sa * (x3 * s - x4 * c))
            rate = g0 * w0 + g1 * w1 + sa * w2 + g3 * w3 + g4 * w4 + g5 * w5
            damped = 1.0 + chi * rate
            if damped > 0.0:
                elastic = stiffness * (d * math.sqrt(d) if power == 1.5 else d**power)
                force = elastic * damped
                f0 -= force * g0
                f1 -= force * g1
                f2 -= force * sa
                f3 -= force * g3
                f4 -= force * g4
                f5 -= force * g5
        turned = c * step_c - s * step_s
        s = s * step_c + c * step_s
        c = turned
    f = b["f"]
    f[0] += f0
    f[1] += f1
    f[2] += f2
    f[3] += f3
    f[4] += f4
    f[5] += f5
