# SPDX-License-Identifier: Apache-2.0
"""Gap between two modified flanks: grids of both gears, read at the point of contact."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.mesh_line import pooled
from pitchpoint.multibody.channels import F8


@kernel
def pair_separation(b, tooth1, tooth2, z, xi):
    """Material missing on both flanks at width z and path position xi [m], along the base tangent."""
    tan_a = b["sin_a"] / b["cos_a"]
    flank = 0 if b["flank"] > 0 else 1
    nz = b["n_sz"]
    nx = b["n_sx"]
    # z counts from the plane of the pitch point; each grid has its own mid-face
    z1 = z + b["w1"] * b["dz"]
    grid1 = view(pooled(b, b["sep1"]), (2, b["n_t1"], nz, nx), F8)
    grid2 = view(pooled(b, b["sep2"]), (2, b["n_t2"], nz, nx), F8)
    rho1 = abs(xi + b["r_b1"] * tan_a)
    rho2 = abs(b["r_b2"] * tan_a - xi)
    gap = _grid(grid1, flank, tooth1 % b["n_t1"], z1 / b["b1"] + 0.5, _share(rho1, b["roll1"]))
    return gap + _grid(
        grid2, flank, tooth2 % b["n_t2"], (z1 - b["dz"]) / b["b2"] + 0.5, _share(rho2, b["roll2"])
    )


@kernel
def _share(rho, span):
    return (rho - span[0]) / (span[1] - span[0])


@kernel
def _grid(grid, flank, tooth, z, x):
    """Bilinear value of grid[flank, tooth] at shares (z, x) of its spans, constant beyond the edges."""
    nz = grid.shape[2]
    nx = grid.shape[3]
    z = min(max(z, 0.0), 1.0) * (nz - 1)
    x = min(max(x, 0.0), 1.0) * (nx - 1)
    i = max(min(int(z), nz - 2), 0)
    j = min(int(x), nx - 2)
    i1 = min(i + 1, nz - 1)
    z -= i
    x -= j
    g0 = grid[flank, tooth, i, j] * (1.0 - x) + grid[flank, tooth, i, j + 1] * x
    g1 = grid[flank, tooth, i1, j] * (1.0 - x) + grid[flank, tooth, i1, j + 1] * x
    return g0 * (1.0 - z) + g1 * z
