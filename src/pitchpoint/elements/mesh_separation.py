# SPDX-License-Identifier: Apache-2.0
"""Gap between two modified flanks: grids of both gears, read at the point of contact."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.gear_mesh_record import ROLL
from pitchpoint.elements.mesh_line import pooled
from pitchpoint.multibody.channels import F8


@kernel
def begin_separation(b):
    """What all nodes of a flank need to read the grids, into the scratch."""
    b["tan_a"] = b["sin_a"] / b["cos_a"]
    b["tan_rate"] = b["xi_A_rate"] / b["r_b2"]
    b["per_z"][0] = (b["n_sz"] - 1) / b["b1"]
    b["per_z"][1] = (b["n_sz"] - 1) / b["b2"]
    b["per_roll"][0] = (b["n_sx"] - 1) / (b["roll1"][1] - b["roll1"][0])
    b["per_roll"][1] = (b["n_sx"] - 1) / (b["roll2"][1] - b["roll2"][0])


@kernel
def runs_damped(b):
    """Whether contact damping feels how fast contacts run over separated flanks."""
    return b["n_sz"] > 0 and (b["d_in"] > 0.0 or b["d_out"] > 0.0 or b["chi"] > 0.0)


@kernel(inline=True)
def pair_separation(b, teeth, z, xi, z_rate, xi_rate):
    """Material missing at width z and path position xi [m] on both of two teeth, along the base tangent.

    Also its rate where the place moves at z_rate and xi_rate [m/s], and its slope over xi.
    """
    tan_a = b["tan_a"]
    flank = 0 if b["flank"] > 0 else 1
    nz = b["n_sz"]
    nx = b["n_sx"]
    # z counts from the plane of the pitch point; each grid has its own mid-face
    z1 = z + b["w1"] * b["dz"]
    grid1 = view(pooled(b, b["sep1"]), (2, b["n_t1"], nz, nx), F8)
    grid2 = view(pooled(b, b["sep2"]), (2, b["n_t2"], nz, nx), F8)
    roll1 = xi + b["r_b1"] * tan_a
    roll2 = b["r_b2"] * tan_a - xi
    per_z = b["per_z"]
    per_roll = b["per_roll"]
    gap1, over_z1, over_roll1 = _gap(
        grid1, flank, teeth[0] % b["n_t1"], z1, per_z[0], roll1, b["roll1"][0], per_roll[0]
    )
    gap2, over_z2, over_roll2 = _gap(
        grid2, flank, teeth[1] % b["n_t2"], z1 - b["dz"], per_z[1], roll2, b["roll2"][0], per_roll[1]
    )
    slope = over_roll1 - over_roll2
    z1_rate = z_rate + b["w1"] * b["dz_rate"]
    rate = slope * xi_rate + (over_roll1 * b["r_b1"] + over_roll2 * b["r_b2"]) * b["tan_rate"]
    rate += over_z1 * z1_rate + over_z2 * (z1_rate - b["dz_rate"])
    return gap1 + gap2, rate, slope


@kernel
def spin_direction(b):
    """Row 0 of the wrench basis where the gears only spin: the torques of a base-tangent force of one."""
    m = b["m"]
    for k in range(3):
        b["basis_i"][0, k] = b["basis_j"][0, k] = 0.0
        b["basis_i"][0, 3 + k] = -b["flank"] * b["r_b1"] * m[k]
        b["basis_j"][0, 3 + k] = -b["flank"] * b["r_b2"] * m[k]


@kernel
def add_roll_tangent(b, kk, rows):
    """Tangent of the contact damping over the rate at which the contact runs over separated flanks.

    That of the mean travel, half of r_b1 omega1 - r_b2 omega2; `rows` of the wrench basis are in use. How the
    place of the contact moves with the other rates is left out, like the turning of the line of action.
    """
    m = b["m"]
    half = 0.5 * b["flank"]
    for p in range(rows):
        c1 = half * b["r_b1"] * b["acc"][ROLL + p]
        c2 = half * b["r_b2"] * b["acc"][ROLL + p]
        for k in range(6):
            Bi = b["basis_i"][p, k]
            Bj = b["basis_j"][p, k]
            for n in range(3):
                kk[b["ii"], k, 3 + n] -= Bi * c1 * m[n]
                kk[b["ij"], k, 3 + n] += Bi * c2 * m[n]
                kk[b["ji"], k, 3 + n] -= Bj * c1 * m[n]
                kk[b["jj"], k, 3 + n] += Bj * c2 * m[n]


@kernel(inline=True)
def _gap(grid, flank, tooth, z, per_z, roll, start, per_roll):
    """Gap of one gear at width z from mid-face and length of roll |roll| [m], its slopes over z and roll.

    Bilinear between the points of grid[flank, tooth], constant beyond its edges; per_z and per_roll steps to
    the metre, the first length of roll is `start`.
    """
    nz = grid.shape[2]
    nx = grid.shape[3]
    sign = 1.0 if roll > 0.0 else -1.0
    z = z * per_z + 0.5 * (nz - 1)
    x = (sign * roll - start) * per_roll
    inside_z = per_z if z > 0.0 and z < nz - 1 else 0.0
    inside_x = sign * per_roll if x > 0.0 and x < nx - 1 else 0.0
    z = min(max(z, 0.0), nz - 1.0)
    x = min(max(x, 0.0), nx - 1.0)
    i = max(min(int(z), nz - 2), 0)
    j = min(int(x), nx - 2)
    i1 = min(i + 1, nz - 1)
    z -= i
    x -= j
    a0 = grid[flank, tooth, i, j]
    a1 = grid[flank, tooth, i1, j]
    d0 = grid[flank, tooth, i, j + 1] - a0
    d1 = grid[flank, tooth, i1, j + 1] - a1
    g0 = a0 + d0 * x
    g1 = a1 + d1 * x
    return g0 + (g1 - g0) * z, (g1 - g0) * inside_z, (d0 + (d1 - d0) * z) * inside_x
