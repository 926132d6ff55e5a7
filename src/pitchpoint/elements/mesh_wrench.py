# SPDX-License-Identifier: Apache-2.0
"""From the sums of a mesh to wrenches and tangents on its two bodies.

Gears that only spin, without friction, need one number: the torque of a base-tangent force F is -r_b F about
both axes (signed r_b). All others get the full wrench in the basis of `mesh_nodes`.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.mesh_gradient import travel_direction


@kernel
def spin_flank_rates(b, rate):
    """Normal rate of the current flank when the gears only spin."""
    r = b["rate"]
    r[0] = b["flank"] * rate
    r[1] = 0.0
    r[2] = 0.0
    r[3] = 0.0
    r[4] = 0.0


@kernel
def add_spin_torque(b, f, g, force):
    """Torques of the base-tangent force `force` [N], front flank positive."""
    s1 = force * b["r_b1"]
    s2 = force * b["r_b2"]
    m = b["m"]
    for k in range(3):
        f["F"][3 + k] -= s1 * m[k]
        g["F"][3 + k] -= s2 * m[k]


@kernel
def add_spin_tangent(b, kk, c):
    """Tangent `c` of the base-tangent force along the travel."""
    m = b["m"]
    r1 = b["r_b1"]
    r2 = b["r_b2"]
    for k in range(3):
        for n in range(3):
            s = c * m[k] * m[n]
            kk[b["ii"], 3 + k, 3 + n] += r1 * r1 * s
            kk[b["ij"], 3 + k, 3 + n] += r1 * r2 * s
            kk[b["ji"], 3 + k, 3 + n] += r1 * r2 * s
            kk[b["jj"], 3 + k, 3 + n] += r2 * r2 * s


@kernel
def friction_directions(b, f, g, flank):
    """Rows 2 to 4 of the wrench basis: friction along tau = m x n_f at the pitch point, per z and per xi."""
    m = b["m"]
    e = b["e"]
    t = b["t"]
    P = b["P"]
    ca = flank * b["cos_a"]
    sa = b["sin_a"]
    for side in range(2):
        B = b["basis_i"] if side == 0 else b["basis_j"]
        o = f["r"] if side == 0 else g["r"]
        sign = -1.0 if side == 0 else 1.0
        for k in range(3):
            k1 = (k + 1) % 3
            k2 = (k + 2) % 3
            n1 = ca * t[k1] + sa * e[k1]
            n2 = ca * t[k2] + sa * e[k2]
            B[2, k] = sign * (m[k1] * n2 - m[k2] * n1)
            B[3, k] = 0.0
            B[3, 3 + k] = -sign * (ca * t[k] + sa * e[k])
            B[4, k] = 0.0
            B[4, 3 + k] = sign * m[k]
        x = P[0] - o[0]
        y = P[1] - o[1]
        z = P[2] - o[2]
        B[2, 3] = y * B[2, 2] - z * B[2, 1]
        B[2, 4] = z * B[2, 0] - x * B[2, 2]
        B[2, 5] = x * B[2, 1] - y * B[2, 0]


@kernel
def _along(b, f, g, p):
    """Rate of both bodies against row `p` of the wrench basis: the power it takes from them."""
    s = 0.0
    for k in range(6):
        s -= b["basis_i"][p, k] * f["tw"][k] + b["basis_j"][p, k] * g["tw"][k]
    return s


@kernel
def flank_rates(b, f, g):
    """Normal and sliding rates of the current flank at the pitch point, with their slopes."""
    r = b["rate"]
    r[0] = _along(b, f, g, 0) - b["flank"] * b["e_rate"]
    r[1] = _along(b, f, g, 1)
    if b["mu"] > 0.0:
        r[2] = _along(b, f, g, 2)
        r[3] = _along(b, f, g, 3)
        r[4] = _along(b, f, g, 4)


@kernel
def add_wrench(b, f, g):
    """Add the summed forces of the current flank to both bodies."""
    acc = b["acc"]
    n = 5 if b["mu"] > 0.0 else 2
    for p in range(n):
        s = acc[p]
        for k in range(6):
            f["F"][k] += s * b["basis_i"][p, k]
            g["F"][k] += s * b["basis_j"][p, k]


@kernel
def _coefficient(acc, p, q):
    """Entry (p, q) of the tangent in the wrench basis."""
    if p < 2:
        return acc[5 + p + q] if q < 2 else 0.0
    r = p - 2
    if q < 2:
        return acc[8 + 2 * r + q]
    s = q - 2
    lo = min(r, s)
    hi = max(r, s)
    return acc[14 + hi] if lo == 0 else acc[16 + lo + hi - 1] if lo == 1 else acc[19]


@kernel
def add_tangent(b, kk):
    """Add the summed tangents of the current flank to the four pair blocks."""
    acc = b["acc"]
    size = 5 if b["mu"] > 0.0 else 2
    for p in range(size):
        for q in range(size):
            c = _coefficient(acc, p, q)
            if c == 0.0:
                continue
            for k in range(6):
                ci = c * b["basis_i"][p, k]
                cj = c * b["basis_j"][p, k]
                for n in range(6):
                    kk[b["ii"], k, n] += ci * b["basis_i"][q, n]
                    kk[b["ij"], k, n] += ci * b["basis_j"][q, n]
                    kk[b["ji"], k, n] += cj * b["basis_i"][q, n]
                    kk[b["jj"], k, n] += cj * b["basis_j"][q, n]


@kernel
def mesh_damper(b, ctl, f, g, kk):
    """Damper along the travel, in the gap too; returns its force and its rate."""
    travel_direction(b, f, g)
    Bi = b["basis_i"]
    Bj = b["basis_j"]
    rate = _along(b, f, g, 0) - b["e_rate"]
    s = b["d_gap"] * rate
    for k in range(6):
        f["F"][k] += s * Bi[0, k]
        g["F"][k] += s * Bj[0, k]
    if ctl["jac"] != 0:
        c = ctl["cd"] * b["d_gap"]
        for k in range(6):
            for n in range(6):
                kk[b["ii"], k, n] += c * Bi[0, k] * Bi[0, n]
                kk[b["ij"], k, n] += c * Bi[0, k] * Bj[0, n]
                kk[b["ji"], k, n] += c * Bj[0, k] * Bi[0, n]
                kk[b["jj"], k, n] += c * Bj[0, k] * Bj[0, n]
    return s, rate
