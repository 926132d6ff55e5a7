# SPDX-License-Identifier: Apache-2.0
"""Inertia forces of round bodies as wrenches: Newton-Euler equations about the body origin, world axes.

With c = c_z n and I about the origin (axisymmetric about n): F = -m (a + omega' x c + omega x (omega x c)),
M = -(I omega' + omega x I omega + m c x a). The tangents are the 6 x 6 mass matrix (factor cm), the
gyroscopic matrix (cd) and, for exact linearisation, the derivative by the direction of n (ck).
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.multibody.bodies import GENERAL
from pitchpoint.multibody.joints import FREE


@kernel
def euler(o, f):
    """Set the wrench of a free body to its inertia forces."""
    R = f["R"]
    n0 = R[0, 2]
    n1 = R[1, 2]
    n2 = R[2, 2]
    w = f["tw"]
    e = f["ac"]
    F = f["F"]
    m = o["mass"]
    c = o["c_z"]
    it = o["i_t"] + m * c * c
    d = o["i_p"] - it
    w0 = w[3]
    w1 = w[4]
    w2 = w[5]
    dw = d * (n0 * w0 + n1 * w1 + n2 * w2)
    de = d * (n0 * e[3] + n1 * e[4] + n2 * e[5])
    # omega x I omega = dw (omega x n): the isotropic part cancels
    k0 = w1 * n2 - w2 * n1
    k1 = w2 * n0 - w0 * n2
    k2 = w0 * n1 - w1 * n0
    F[0] = -m * e[0]
    F[1] = -m * e[1]
    F[2] = -m * e[2]
    F[3] = -(it * e[3] + de * n0 + dw * k0)
    F[4] = -(it * e[4] + de * n1 + dw * k1)
    F[5] = -(it * e[5] + de * n2 + dw * k2)
    if c != 0.0:
        s = m * c
        F[0] -= s * (e[4] * n2 - e[5] * n1 + w1 * k2 - w2 * k1)
        F[1] -= s * (e[5] * n0 - e[3] * n2 + w2 * k0 - w0 * k2)
        F[2] -= s * (e[3] * n1 - e[4] * n0 + w0 * k1 - w1 * k0)
        F[3] -= s * (n1 * e[2] - n2 * e[1])
        F[4] -= s * (n2 * e[0] - n0 * e[2])
        F[5] -= s * (n0 * e[1] - n1 * e[0])


@kernel
def mass_tangent(o, f, k, cm):
    """Add cm times the mass matrix of a free body about its origin to its 6 x 6 block."""
    m = o["mass"]
    c = o["c_z"]
    it = o["i_t"] + m * c * c
    d = o["i_p"] - it
    R = f["R"]
    for i in range(3):
        k[i, i] += cm * m
        k[3 + i, 3 + i] += cm * it
        for j in range(3):
            k[3 + i, 3 + j] += cm * d * R[i, 2] * R[j, 2]
    if c != 0.0:
        s = cm * m * c
        for i in range(3):
            j = (i + 1) % 3
            h = (i + 2) % 3
            k[i, 3 + j] += s * R[h, 2]  # row i of e x n
            k[i, 3 + h] -= s * R[j, 2]
            k[3 + i, h] += s * R[j, 2]  # row i of n x a
            k[3 + i, j] -= s * R[h, 2]


@kernel
def gyro_tangent(o, f, k, cd):
    """Add cd times the derivative of the velocity-dependent forces by omega (constant n)."""
    m = o["mass"]
    s = m * o["c_z"]
    it = o["i_t"] + s * o["c_z"]
    d = o["i_p"] - it
    R = f["R"]
    n0 = R[0, 2]
    n1 = R[1, 2]
    n2 = R[2, 2]
    w0 = f["tw"][3]
    w1 = f["tw"][4]
    w2 = f["tw"][5]
    nw = n0 * w0 + n1 * w1 + n2 * w2
    k0 = w1 * n2 - w2 * n1
    k1 = w2 * n0 - w0 * n2
    k2 = w0 * n1 - w1 * n0
    for c in range(3):
        x = 1.0 if c == 0 else 0.0
        y = 1.0 if c == 1 else 0.0
        z = 1.0 if c == 2 else 0.0
        h0 = y * n2 - z * n1  # e_c x n
        h1 = z * n0 - x * n2
        h2 = x * n1 - y * n0
        p = d * R[c, 2]
        k[3, 3 + c] += cd * (p * k0 + d * nw * h0)
        k[4, 3 + c] += cd * (p * k1 + d * nw * h1)
        k[5, 3 + c] += cd * (p * k2 + d * nw * h2)
        if s != 0.0:
            k[0, 3 + c] += cd * s * (y * k2 - z * k1 + w1 * h2 - w2 * h1)
            k[1, 3 + c] += cd * s * (z * k0 - x * k2 + w2 * h0 - w0 * h2)
            k[2, 3 + c] += cd * s * (x * k1 - y * k0 + w0 * h1 - w1 * h0)


@kernel
def attitude_tangent(o, f, k, ck):
    """Add ck times the derivative of the inertia forces by the direction of n (constant tw, ac)."""
    m = o["mass"]
    s = m * o["c_z"]
    it = o["i_t"] + s * o["c_z"]
    d = o["i_p"] - it
    R = f["R"]
    e = f["ac"]
    w0 = f["tw"][3]
    w1 = f["tw"][4]
    w2 = f["tw"][5]
    n0 = R[0, 2]
    n1 = R[1, 2]
    n2 = R[2, 2]
    nw = d * (n0 * w0 + n1 * w1 + n2 * w2)
    ne = d * (n0 * e[3] + n1 * e[4] + n2 * e[5])
    k0 = w1 * n2 - w2 * n1
    k1 = w2 * n0 - w0 * n2
    k2 = w0 * n1 - w1 * n0
    for c in range(3):
        x = 1.0 if c == 0 else 0.0
        y = 1.0 if c == 1 else 0.0
        z = 1.0 if c == 2 else 0.0
        h0 = y * n2 - z * n1  # change of n due to a rotation about axis c
        h1 = z * n0 - x * n2
        h2 = x * n1 - y * n0
        hw = d * (h0 * w0 + h1 * w1 + h2 * w2)
        he = d * (h0 * e[3] + h1 * e[4] + h2 * e[5])
        g0 = w1 * h2 - w2 * h1  # omega x change
        g1 = w2 * h0 - w0 * h2
        g2 = w0 * h1 - w1 * h0
        k[3, 3 + c] += ck * (he * n0 + ne * h0 + hw * k0 + nw * g0)
        k[4, 3 + c] += ck * (he * n1 + ne * h1 + hw * k1 + nw * g1)
        k[5, 3 + c] += ck * (he * n2 + ne * h2 + hw * k2 + nw * g2)
        if s != 0.0:
            k[0, 3 + c] += ck * s * (e[4] * h2 - e[5] * h1 + w1 * g2 - w2 * g1)
            k[1, 3 + c] += ck * s * (e[5] * h0 - e[3] * h2 + w2 * g0 - w0 * g2)
            k[2, 3 + c] += ck * s * (e[3] * h1 - e[4] * h0 + w0 * g1 - w1 * g0)
            k[3, 3 + c] += ck * s * (h1 * e[2] - h2 * e[1])
            k[4, 3 + c] += ck * s * (h2 * e[0] - h0 * e[2])
            k[5, 3 + c] += ck * s * (h0 * e[1] - h1 * e[0])


@kernel(inline=True)
def inertia(body, fr, kk, jac, cm, cd):
    """Set the wrenches of round bodies to the inertia forces; with jac > 0 add the tangents by a and v."""
    for b in range(body.size):
        o = body[b]
        f = fr[b]
        if o["joint"] == FREE:
            euler(o, f)
            if jac != 0:
                k = kk[o["ii"]]
                mass_tangent(o, f, k, cm)
                if cd != 0.0:
                    gyro_tangent(o, f, k, cd)
        elif o["joint"] != GENERAL:
            # the spin axis is fixed: gyroscopic moments do not affect the coordinates
            for i in range(3):
                f["F"][i] = -o["mass"] * f["ac"][i]
                f["F"][3 + i] = -o["i_p"] * f["ac"][3 + i]
            if jac != 0 and o["joint"] != 0:
                k = kk[o["ii"]]
                for i in range(3):
                    k[i, i] += cm * o["mass"]
                    k[3 + i, 3 + i] += cm * o["i_p"]


@kernel
def attitude(body, fr, kk, ck):
    """Add the tangents of the inertia forces by the attitude of free bodies (exact linearisation)."""
    for b in range(body.size):
        if body[b]["joint"] == FREE:
            attitude_tangent(body[b], fr[b], kk[body[b]["ii"]], ck)
