# SPDX-License-Identifier: Apache-2.0
"""From the sums of a mesh to wrenches and tangents on its two bodies, for cylindrical and bevel gears.

Every row of the wrench basis is the wrench of a unit force on both bodies. Sums over the rows give forces,
sums over pairs of rows tangents; the power that a row takes from the bodies is its rate. Gears that only
spin, without friction, need one number: the torque of a base-tangent force F is -r_b F about both axes.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.mesh_sums import begin_sums


@kernel
def rate_of_row(b, f, g, p):
    """Rate of both bodies against row `p` of the wrench basis: the power it takes from them."""
    s = 0.0
    for k in range(6):
        s -= b["basis_i"][p, k] * f["tw"][k] + b["basis_j"][p, k] * g["tw"][k]
    return s


@kernel
def push(b, f, g, kk, rows):
    """Add the summed forces of the first rows to both bodies, and their tangents to the four pair blocks."""
    sums = b["sums"]
    for p in range(rows):
        s = sums["force"][p]
        for k in range(6):
            f["F"][k] += s * b["basis_i"][p, k]
            g["F"][k] += s * b["basis_j"][p, k]
    if b["ask"]["jac"] == 0:
        return
    for p in range(rows):
        for q in range(rows):
            c = sums["tangent"][p, q]
            if c == 0.0:
                continue
            for k in range(6):
                one = c * b["basis_i"][p, k]
                two = c * b["basis_j"][p, k]
                for n in range(6):
                    kk[b["ask"]["ii"], k, n] += one * b["basis_i"][q, n]
                    kk[b["ask"]["ij"], k, n] += one * b["basis_j"][q, n]
                    kk[b["ask"]["ji"], k, n] += two * b["basis_i"][q, n]
                    kk[b["ask"]["jj"], k, n] += two * b["basis_j"][q, n]


@kernel
def mesh_damper(b, f, g, kk, e_rate):
    """Damper along the travel, row 0 of the basis, in the gap too; returns its force and its rate.

    `e_rate` is the rate of the transmission error, which the damper does not feel [m/s].
    """
    rate = rate_of_row(b, f, g, 0) - e_rate
    force = b["d_gap"] * rate
    begin_sums(b)
    b["sums"]["force"][0] = force
    b["sums"]["tangent"][0, 0] = b["ask"]["cd"] * b["d_gap"]
    push(b, f, g, kk, 1)
    b["sums"]["tangent"][0, 0] = b["d_gap"]
    return force, rate


@kernel
def add_spin_torque(b, f, g, force):
    """Torques of the base-tangent force `force` [N], front flank positive."""
    s1 = force * b["r_b1"]
    s2 = force * b["r_b2"]
    m = b["now"]["m"]
    for k in range(3):
        f["F"][3 + k] -= s1 * m[k]
        g["F"][3 + k] -= s2 * m[k]


@kernel
def add_spin_tangent(b, kk, c):
    """Tangent `c` of the base-tangent force along the travel."""
    m = b["now"]["m"]
    r1 = b["r_b1"]
    r2 = b["r_b2"]
    for k in range(3):
        for n in range(3):
            s = c * m[k] * m[n]
            kk[b["ask"]["ii"], 3 + k, 3 + n] += r1 * r1 * s
            kk[b["ask"]["ij"], 3 + k, 3 + n] += r1 * r2 * s
            kk[b["ask"]["ji"], 3 + k, 3 + n] += r1 * r2 * s
            kk[b["ask"]["jj"], 3 + k, 3 + n] += r2 * r2 * s
