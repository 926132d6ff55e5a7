# SPDX-License-Identifier: Apache-2.0
"""Forces of the elements of a rolling bearing, without their slopes: what explicit methods ask for.

The same equations as in `rolling_bearing`, whose tangents want the gradients in memory; here they stay in
registers, which is three times as fast.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel


@kernel
def push_elements(b, c, s, share):
    """Subtract what all elements carry from the forces in the scratch f.

    c and s are cosine and sine of the azimuth of the first element, share is that of the cage.
    """
    x = b["x"]
    w = b["w"]
    half = 0.5 * b["pitch"]
    ca0 = b["ca"]
    sa0 = b["sa"]
    step_c = b["step_c"]
    step_s = b["step_s"]
    A = b["grooves"]
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
        radial = x[0] * c + x[1] * s - gap
        axial = x[2] - half * (x[3] * c + x[4] * s)
        ca = ca0
        sa = sa0
        if A > 0.0:
            p = A * ca0 + radial
            q = A * sa0 + axial
            length = math.sqrt(p * p + q * q)
            d = length - A
            ca = p / length
            sa = q / length
        else:
            d = radial * ca0 + axial * sa0
        if d > 0.0:
            g0 = ca * c
            g1 = ca * s
            g3 = -half * sa * c
            g4 = -half * sa * s
            g5 = share * (ca * (x[1] * c - x[0] * s) + half * sa * (x[3] * s - x[4] * c))
            rate = g0 * w[0] + g1 * w[1] + sa * w[2] + g3 * w[3] + g4 * w[4] + g5 * w[5]
            damped = 1.0 + chi * rate
            if damped > 0.0:
                elastic = b["stiffness"] * (d * math.sqrt(d) if power == 1.5 else d**power)
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
