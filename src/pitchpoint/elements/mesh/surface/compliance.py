# SPDX-License-Identifier: Apache-2.0
"""Compliance matrix of the contact nodes of one flank, from the influence functions of both gears.

A force f_j on the plane s_j of a tooth at the height t_j displaces the plane s_i of the same tooth at t_i by

    f_j times the sum over m, n of P_m(t_i) own[s_i, s_j, m, n] P_n(t_j)

with Legendre polynomials P of the height t, -1 at the root and +1 at the tip; that of the next tooth likewise
by `neighbour` (`contact.compliance`). All nodes of a gear also move by the torsion of its blank. Matrices
refer to a nominal width of the planes; their change with an axial offset of the gears is neglected.
"""

from __future__ import annotations

from pitchpoint.contact.local_approach import A1, A2, K1, K2, N_NODE, T1, B, D
from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.mesh.line_of_action import pooled
from pitchpoint.multibody.channels import F8

HEIGHTS = 4
"""Number of Legendre polynomials of the height, P_0 to P_3."""
LEGS = 2 * HEIGHTS
"""Values per node: polynomials of its heights on both gears."""


@kernel
def _height(b, gear, roll):
    """Height t of a length of roll on a gear, within [-1, 1], and its derivative by the signed roll."""
    middle = b["height"][gear, 0]
    half = b["height"][gear, 1]
    sign = 1.0 if roll > 0.0 else -1.0
    t = (sign * roll - middle) / half
    if t <= -1.0:
        return -1.0, 0.0
    if t >= 1.0:
        return 1.0, 0.0
    return t, sign / half


@kernel
def _polynomials(t):
    return 1.0, t, 1.5 * t * t - 0.5, t * (2.5 * t * t - 1.5)


@kernel
def _slopes(t):
    return 0.0, 1.0, 3.0 * t, 7.5 * t * t - 1.5


@kernel
def _sum_of(c, p):
    return c[0] * p[0] + c[1] * p[1] + c[2] * p[2] + c[3] * p[3]


@kernel
def set_local(b, nodes, i, legs, local):
    """Set polynomials of the heights and local compliance of node i."""
    node = nodes[i]
    place = node["roll"]
    least = b["least_roll"]
    for gear in range(2):
        t, _ = _height(b, gear, place[gear])
        p = _polynomials(t)
        for m in range(HEIGHTS):
            legs[i, HEIGHTS * gear + m] = p[m]
        local[i, T1 + gear] = _sum_of(b["depth"][gear], p)
    # radii of curvature in the transverse section; near a base circle, where they vanish, a finite one
    one = max(place[0], least)
    two = max(place[1], least) if b["r_b2"] > 0.0 else min(place[1], -one - least)
    radius = one * two / (one + two)
    local[i, D] = b["overlap"] + node["soft"] / b["plane_width"]
    local[i, A1] = b["line"][0]
    local[i, A2] = b["line"][1]
    local[i, B] = b["strip"] * radius
    local[i, K1] = b["kappa_1"]
    local[i, K2] = b["kappa_2"]


@kernel
def local_slopes(b, node, by_radius, by_depth):
    """Derivatives of the local energy of a node by both signed lengths of roll.

    `by_radius`: by ln R; `by_depth`: by both depths.
    """
    place = node["roll"]
    least = b["least_roll"]
    inside_1 = place[0] > least
    one = max(place[0], least)
    if b["r_b2"] > 0.0:
        inside_2 = place[1] > least
        two = max(place[1], least)
    else:
        inside_2 = place[1] < -one - least
        two = min(place[1], -one - least)
    over_1 = (1.0 / one - 1.0 / (one + two)) if inside_1 else 0.0
    over_2 = (1.0 / two - 1.0 / (one + two)) if inside_2 else 0.0
    t, slope = _height(b, 0, place[0])
    by_1 = by_radius * over_1 + by_depth[0] * _sum_of(b["depth"][0], _slopes(t)) * slope
    t, slope = _height(b, 1, place[1])
    return by_1, by_radius * over_2 + by_depth[1] * _sum_of(b["depth"][1], _slopes(t)) * slope


@kernel
def _product(own, s_i, s_j, legs, i, j, first):
    """Influence between two nodes: polynomials of node i times a block times those of node j."""
    block = own[s_i, s_j]
    total = 0.0
    for m in range(HEIGHTS):
        row = 0.0
        for n in range(HEIGHTS):
            row += block[m, n] * legs[j, first + n]
        total += legs[i, first + m] * row
    return total


@kernel
def blocks(b, gear, neighbour):
    """Influence functions of a gear, of a tooth on itself or on the next, shape (planes, planes, 4, 4)."""
    n = b["slices"]
    offset = b["neighbour"][gear] if neighbour else b["own"][gear]
    return view(pooled(b, offset), (n, n, HEIGHTS, HEIGHTS), F8)


@kernel
def between(b, nodes, i, j, legs, arrays):
    """Compliance between two nodes i and j, apart from the local one [m/N].

    `arrays`: own and neighbour of gear 1, own and neighbour of gear 2.
    """
    lead = nodes[i]["pair"] - nodes[j]["pair"]
    s_i = nodes[i]["plane"]
    s_j = nodes[j]["plane"]
    c = b["windup"]
    if lead == 0:
        c += _product(arrays[0], s_i, s_j, legs, i, j, 0)
        c += _product(arrays[2], s_i, s_j, legs, i, j, HEIGHTS)
    elif lead == 1:
        # of two teeth of gear 1 that with the higher number of its pair comes first in `neighbour`
        c += _product(arrays[1], s_i, s_j, legs, i, j, 0)
        c += _product(arrays[3], s_j, s_i, legs, j, i, HEIGHTS)
    elif lead == -1:
        c += _product(arrays[1], s_j, s_i, legs, j, i, 0)
        c += _product(arrays[3], s_i, s_j, legs, i, j, HEIGHTS)
    return c


@kernel
def assemble(b, nodes, n, legs, local, C):
    """Set the compliance matrix C of n nodes, and their local compliances."""
    arrays = (blocks(b, 0, False), blocks(b, 0, True), blocks(b, 1, False), blocks(b, 1, True))
    for i in range(n):
        set_local(b, nodes, i, legs, local)
        for j in range(i + 1):
            c = between(b, nodes, i, j, legs, arrays)
            C[i, j] = c
            C[j, i] = c


@kernel
def _pull(block, f, legs, j, first, flip, out):
    """Add f times a block (transposed with `flip`) times the polynomials of node j to four values."""
    for m in range(HEIGHTS):
        row = 0.0
        for n in range(HEIGHTS):
            row += (block[n, m] if flip else block[m, n]) * legs[j, first + n]
        out[m] += f * row


@kernel
def energy_by_height(b, nodes, on, n_on, f, i, legs, out):
    """Derivatives of the elastic energy f C f/2 by both signed lengths of roll of node i, at constant forces.

    `on`: indices of the n_on nodes with forces; `out`: scratch of 8 values.
    """
    arrays = (blocks(b, 0, False), blocks(b, 0, True), blocks(b, 1, False), blocks(b, 1, True))
    node = nodes[i]
    s_i = node["plane"]
    for m in range(LEGS):
        out[m] = 0.0
    one = out[:HEIGHTS]
    two = out[HEIGHTS:]
    for k in range(n_on):
        j = on[k]
        lead = node["pair"] - nodes[j]["pair"]
        s_j = nodes[j]["plane"]
        if lead == 0:
            _pull(arrays[0][s_i, s_j], f[j], legs, j, 0, False, one)
            _pull(arrays[2][s_i, s_j], f[j], legs, j, HEIGHTS, False, two)
        elif lead == 1:
            _pull(arrays[1][s_i, s_j], f[j], legs, j, 0, False, one)
            _pull(arrays[3][s_j, s_i], f[j], legs, j, HEIGHTS, True, two)
        elif lead == -1:
            _pull(arrays[1][s_j, s_i], f[j], legs, j, 0, True, one)
            _pull(arrays[3][s_i, s_j], f[j], legs, j, HEIGHTS, False, two)
    t, slope = _height(b, 0, node["roll"][0])
    by_1 = f[i] * _sum_of(one, _slopes(t)) * slope
    t, slope = _height(b, 1, node["roll"][1])
    return by_1, f[i] * _sum_of(two, _slopes(t)) * slope


@kernel
def compliance_arrays(b):
    """Scratch of a flank in the pool: polynomials, local compliances and the matrix."""
    n = b["max_nodes"]
    work = b["work"]
    legs = view(pooled(b, work), (n, LEGS), F8)
    local = view(pooled(b, work + n * LEGS), (n, N_NODE), F8)
    return legs, local, view(pooled(b, work + n * (LEGS + N_NODE)), (n, n), F8)
