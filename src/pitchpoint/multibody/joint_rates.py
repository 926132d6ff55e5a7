# SPDX-License-Identifier: Apache-2.0
"""How twists and accelerations change with moving joint axes; only exact linearisation asks."""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel
from pitchpoint.multibody.joints import FREE


@kernel
def axles(body, fr, q):
    """Write the vector of every body whose product with a small turn is the change of the spin.

    It is the spin axis, unless the body is tilted about its second axis: the joint's first axis w1 then has a
    share along the spin axis, and w1 x w2 / cos(beta) is the vector that stands on both tilt axes.
    """
    for b in range(1, body.size):
        o = body[b]
        axle = fr[b]["axle"]
        for i in range(3):
            axle[i] = o["axes"][i, 2]
        if o["joint"] == FREE:
            d = o["dof"]
            ca = math.cos(q[d + 3]) / math.cos(q[d + 4])
            sa = math.sin(q[d + 3]) / math.cos(q[d + 4])
            for i in range(3):
                axle[i] = ca * o["axes"][i, 2] - sa * o["axes"][i, 1]


@kernel
def cross(J, p, c, x, y, z, out, col):
    """Write column c of the rotations of J crossed with (x, y, z) into rows 3..5 of out[p, :, col]."""
    a = J[p, 3, c]
    b = J[p, 4, c]
    d = J[p, 5, c]
    out[p, 3, col] = b * z - d * y
    out[p, 4, col] = d * x - a * z
    out[p, 5, col] = a * y - b * x


@kernel
def joint_rates(body, fr, J, Tq, Av, Aq, v, a):
    """Derivatives of twists and accelerations that only an exact linearisation needs.

    Tq = d(twist)/dq, Av = d(acceleration)/dv, Aq = d(acceleration)/dq at fixed coordinates of the rest. Only
    the two tilts of a free body have any: all vectors turn about w1 with alpha; with beta only n moves.
    """
    for p in range(J.shape[0]):
        for i in range(6):
            for c in range(6):
                Tq[p, i, c] = 0.0
                Av[p, i, c] = 0.0
                Aq[p, i, c] = 0.0
    for b in range(1, body.size):
        o = body[b]
        if o["joint"] == FREE:
            f = fr[b]
            d = o["dof"]
            p = o["path"]
            va = v[d + 3]
            vb = v[d + 4]
            vs = v[d + 5]
            cross(J, p, 3, f["tw"][3], f["tw"][4], f["tw"][5], Tq, 3)
            cross(J, p, 3, f["ac"][3], f["ac"][4], f["ac"][5], Aq, 3)
            nx = J[p, 3, 5]
            ny = J[p, 4, 5]
            nz = J[p, 5, 5]
            m0 = f["R"][0, 0]  # w2 x n, the derivative of n by beta
            m1 = f["R"][1, 0]
            m2 = f["R"][2, 0]
            w0 = J[p, 3, 3] * va + J[p, 3, 4] * vb  # velocity of the frame without spin
            w1 = J[p, 4, 3] * va + J[p, 4, 4] * vb
            w2 = J[p, 5, 3] * va + J[p, 5, 4] * vb
            Tq[p, 3, 4] = vs * m0
            Tq[p, 4, 4] = vs * m1
            Tq[p, 5, 4] = vs * m2
            Aq[p, 3, 4] = a[d + 5] * m0 + vs * (w1 * m2 - w2 * m1)
            Aq[p, 4, 4] = a[d + 5] * m1 + vs * (w2 * m0 - w0 * m2)
            Aq[p, 5, 4] = a[d + 5] * m2 + vs * (w0 * m1 - w1 * m0)
            Av[p, 3, 5] = w1 * nz - w2 * ny
            Av[p, 4, 5] = w2 * nx - w0 * nz
            Av[p, 5, 5] = w0 * ny - w1 * nx
            s0 = J[p, 3, 4] * vb + nx * vs
            s1 = J[p, 4, 4] * vb + ny * vs
            s2 = J[p, 5, 4] * vb + nz * vs
            cross(J, p, 3, s0, s1, s2, Av, 3)  # w1 x (beta' w2 + phi' n)
            Av[p, 3, 4] = m0 * vs
            Av[p, 4, 4] = m1 * vs
            Av[p, 5, 4] = m2 * vs
            c0 = J[p, 4, 3] * J[p, 5, 4] - J[p, 5, 3] * J[p, 4, 4]
            c1 = J[p, 5, 3] * J[p, 3, 4] - J[p, 3, 3] * J[p, 5, 4]
            c2 = J[p, 3, 3] * J[p, 4, 4] - J[p, 4, 3] * J[p, 3, 4]
            Av[p, 3, 4] += va * c0
            Av[p, 4, 4] += va * c1
            Av[p, 5, 4] += va * c2
