# SPDX-License-Identifier: Apache-2.0
"""Gap between two modified flanks: grids of both gears, read at the point of contact."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.mesh_line import pooled
from pitchpoint.multibody.channels import F8


@kernel
def pair_separation(b, watch, tooth1, tooth2, z, xi, z_rate, xi_rate):
    """Material missing on both flanks at width z and path position xi [m], along the base tangent.

    Second result: its rate where the place moves at z_rate and xi_rate [m/s], zero if `watch` is None.
    """
    tan_a = b["sin_a"] / b["cos_a"]
    flank = 0 if b["flank"] > 0 else 1
    nz = b["n_sz"]
    nx = b["n_sx"]
    # z counts from the plane of the pitch point; each grid has its own mid-face
    z1 = z + b["w1"] * b["dz"]
    grid1 = view(pooled(b, b["sep1"]), (2, b["n_t1"], nz, nx), F8)
    grid2 = view(pooled(b, b["sep2"]), (2, b["n_t2"], nz, nx), F8)
    roll1 = xi + b["r_b1"] * tan_a
    roll2 = b["r_b2"] * tan_a - xi
    gap1, over_z1, over_roll1 = _gap(grid1, flank, tooth1 % b["n_t1"], z1, b["b1"], roll1, b["roll1"])
    gap2, over_z2, over_roll2 = _gap(
        grid2, flank, tooth2 % b["n_t2"], z1 - b["dz"], b["b2"], roll2, b["roll2"]
    )
    rate = 0.0
    if watch is not None:
        tan_rate = b["xi_A_rate"] / b["r_b2"]
        z1_rate = z_rate + b["w1"] * b["dz_rate"]
        rate = over_z1 * z1_rate + over_roll1 * (xi_rate + b["r_b1"] * tan_rate)
        rate += over_z2 * (z1_rate - b["dz_rate"]) + over_roll2 * (b["r_b2"] * tan_rate - xi_rate)
    return gap1 + gap2, rate


@kernel
def _gap(grid, flank, tooth, z, b, roll, span):
    """Gap of one gear at width z from mid-face and length of roll |roll| [m], its slopes over z and roll.

    Bilinear between the points of grid[flank, tooth], constant beyond its edges.
    """
    nz = grid.shape[2]
    nx = grid.shape[3]
    sign = 1.0 if roll > 0.0 else -1.0
    length = span[1] - span[0]
    z = z / b + 0.5
    x = (sign * roll - span[0]) / length
    inside_z = (nz - 1) / b if z > 0.0 and z < 1.0 else 0.0
    inside_x = sign * (nx - 1) / length if x > 0.0 and x < 1.0 else 0.0
    z = min(max(z, 0.0), 1.0) * (nz - 1)
    x = min(max(x, 0.0), 1.0) * (nx - 1)
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
