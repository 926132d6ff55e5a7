# SPDX-License-Identifier: Apache-2.0
"""Roller of a rolling bearing in slices across its axis: load distribution along the roller, tilting.

The approach of slice s at the position xi from the middle of the roller is

    d_s = d + xi t - 2 P(xi),   t = n_x cos(psi) + n_y sin(psi)

with the approach d of the middle (`rolling_bearing`), the tilt t of the rings in the radial plane of the
roller, for any contact angle, and the profile P of the roller, which is a gap in the inner and in the outer
contact. Each slice carries K/n_s d_s^p max(0, 1 + chi d_s'), with K of both contacts in series. With the
gradients g = dd/dU and h = dt/dU the forces are f = -(F_0 g + F_1 h), F_k = sum of q xi^k, and the stiffness
follows from three sums of slopes. Lamina model of ISO/TS 16281; the slices are independent of each other.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.multibody.channels import F8

COLUMNS = 2
"""Values of one slice: position from the middle of the roller, profile of both contacts 2 P [m]."""


@kernel
def slice_sums(b, d, rate, tilt, tilt_rate):
    """Sums over the slices: forces F_0, F_1, slopes A_0, A_1, A_2 and damping B_0, B_1, B_2."""
    n = b["n_slices"]
    rows = view(b["pool"] + 8 * b["slices"], (n, COLUMNS), F8)
    K = b["stiffness"] / n
    p = b["exponent"]
    chi = b["chi"]
    f0 = 0.0
    f1 = 0.0
    a0 = 0.0
    a1 = 0.0
    a2 = 0.0
    b0 = 0.0
    b1 = 0.0
    b2 = 0.0
    for s in range(n):
        xi = rows[s, 0]
        depth = d + xi * tilt - rows[s, 1]
        if depth > 0.0:
            damped = 1.0 + chi * (rate + xi * tilt_rate)
            if damped > 0.0:
                elastic = K * depth**p
                q = elastic * damped
                slope = p * q / depth
                push = chi * elastic
                f0 += q
                f1 += q * xi
                a0 += slope
                a1 += slope * xi
                a2 += slope * xi * xi
                b0 += push
                b1 += push * xi
                b2 += push * xi * xi
    return f0, f1, a0, a1, a2, b0, b1, b2


@kernel
def tilt_of(b, c, s):
    """Tilt of the rings in the radial plane at an azimuth with cosine c and sine s [rad].

    Rollers in a spherical raceway follow the inner ring: 0.
    """
    if b["aligns"] != 0:
        return 0.0
    return b["x"][3] * c + b["x"][4] * s


@kernel
def tilt_gradient(b, c, s, share):
    """Write the gradient of the tilt to G[3]; returns its rate."""
    h = b["G"][3]
    h[0] = 0.0
    h[1] = 0.0
    h[2] = 0.0
    h[3] = c
    h[4] = s
    h[5] = share * (b["x"][4] * c - b["x"][3] * s)
    if b["aligns"] != 0:
        h[3] = 0.0
        h[4] = 0.0
        h[5] = 0.0
        return 0.0
    return c * b["w"][3] + s * b["w"][4] + h[5] * b["w"][5]


@kernel
def add_slices(b, c, s, share, sums, jac):
    """Add the forces and slopes of one roller.

    The gradients of approach and tilt are in G[2] and G[3], the second derivative of the approach in H.
    """
    f0, f1, a0, a1, a2, b0, b1, b2 = sums
    g = b["G"][2]
    h = b["G"][3]
    H = b["H"]
    w = b["w"]
    for r in range(6):
        b["f"][r] -= f0 * g[r] + f1 * h[r]
    if jac == 0:
        return
    bend = -share * share * tilt_of(b, c, s)
    for e in range(6):
        turned = 0.0  # second derivatives of d and t times the rates
        swung = 0.0
        for r in range(6):
            turned += H[e, r] * w[r]
        if e == 3:
            swung = -share * s * w[5]
        elif e == 4:
            swung = share * c * w[5]
        elif e == 5:
            swung = share * (c * w[4] - s * w[3]) + bend * w[5]
        ge = a0 * g[e] + a1 * h[e] + b0 * turned + b1 * swung
        he = a1 * g[e] + a2 * h[e] + b1 * turned + b2 * swung
        gd = b0 * g[e] + b1 * h[e]
        hd = b1 * g[e] + b2 * h[e]
        for r in range(6):
            b["K"][r, e] += g[r] * ge + h[r] * he + f0 * H[r, e]
            b["D"][r, e] += g[r] * gd + h[r] * hd
    b["K"][3, 5] -= f1 * share * s
    b["K"][5, 3] -= f1 * share * s
    b["K"][4, 5] += f1 * share * c
    b["K"][5, 4] += f1 * share * c
    b["K"][5, 5] += f1 * bend


@kernel
def push_slices(b, c, s, share, sa):
    """Subtract the loads of all rollers of a row without slopes; arguments as of `push_elements`."""
    x = b["x"]
    w = b["w"]
    f = b["f"]
    ca = b["ca"]
    arm = b["half"] * sa - b["place"] * ca
    step_c = b["step_c"]
    step_s = b["step_s"]
    free = 1.0 if b["aligns"] == 0 else 0.0
    for _k in range(b["n"]):
        tilt = tilt_of(b, c, s)
        d = (x[0] * c + x[1] * s - b["gap"]) * ca + (x[2] + b["shift"]) * sa - arm * tilt
        swing = free * share * (x[4] * c - x[3] * s)
        turn = share * ca * (x[1] * c - x[0] * s) - arm * swing
        tilt_rate = free * (c * w[3] + s * w[4]) + swing * w[5]
        lift = share * ca * (x[1] * c - x[0] * s)
        rate = ca * (c * w[0] + s * w[1]) + sa * w[2] - arm * tilt_rate + lift * w[5]
        f0, f1, a0, a1, a2, b0, b1, b2 = slice_sums(b, d, rate, tilt, tilt_rate)
        moment = free * f1 - arm * f0
        f[0] -= f0 * ca * c
        f[1] -= f0 * ca * s
        f[2] -= f0 * sa
        f[3] -= moment * c
        f[4] -= moment * s
        f[5] -= f0 * turn + f1 * swing
        turned = c * step_c - s * step_s
        s = s * step_c + c * step_s
        c = turned
