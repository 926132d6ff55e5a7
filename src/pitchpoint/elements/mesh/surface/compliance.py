# SPDX-License-Identifier: Apache-2.0
"""Compliance matrix of the contact nodes of one flank, from the influence functions of both gears.

A force f_j on the plane s_j of a tooth at the height t_j displaces the plane s_i of the same tooth at t_i by

    f_j times the sum over m, n of P_m(t_i) own[s_i, m, n, s_j] P_n(t_j)

with Legendre polynomials P of the height t, -1 at the root and +1 at the tip; those on the neighbouring teeth
likewise (`contact.compliance`). All nodes of a gear also move by the torsion of its blank. Matrices
refer to a nominal width of the planes; their change with an axial offset of the gears is neglected.
"""

from __future__ import annotations

from pitchpoint.contact.local_approach import A1, A2, K1, K2, T1, B, D
from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.mesh.line_of_action import pooled
from pitchpoint.multibody.channels import F8

HEIGHTS = 4
"""Number of Legendre polynomials of the height, P_0 to P_3."""


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
    """Set polynomials of the heights of node i at its pair and plane, and its local compliance."""
    node = nodes[i]
    place = node["roll"]
    least = b["least_roll"]
    for gear in range(2):
        t, _ = _height(b, gear, place[gear])
        p = _polynomials(t)
        for m in range(HEIGHTS):
            legs[node["slot"], gear, m, node["plane"]] = p[m]
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
def influence(b, gear, which):
    """Influence functions of a gear, shape (planes, 4, 4, columns) over plane and polynomial of the displaced
    node, polynomial and plane of the force; columns beyond the planes are zero.

    `which` 0: of a tooth on itself, 1 and 2: of a tooth on the one before and after it (`own`, `before`,
    `after` of the record).
    """
    n = b["slices"]
    offset = b["own"][gear]
    if which == 1:
        offset = b["before"][gear]
    elif which == 2:
        offset = b["after"][gear]
    return view(pooled(b, offset), (n, HEIGHTS, HEIGHTS, b["columns"]), F8)


@kernel
def _add_row(a, p, legs, row):
    """Add to `row` the displacement per force on each plane of a tooth.

    `a`: influence functions of the displaced plane, shape (4, 4, columns); `p`: its four polynomials; `legs`:
    polynomials at the planes of the forces, shape (4, columns).
    """
    p0, p1, p2, p3 = p
    a00 = a[0, 0]
    a01 = a[0, 1]
    a02 = a[0, 2]
    a03 = a[0, 3]
    a10 = a[1, 0]
    a11 = a[1, 1]
    a12 = a[1, 2]
    a13 = a[1, 3]
    a20 = a[2, 0]
    a21 = a[2, 1]
    a22 = a[2, 2]
    a23 = a[2, 3]
    a30 = a[3, 0]
    a31 = a[3, 1]
    a32 = a[3, 2]
    a33 = a[3, 3]
    l0 = legs[0]
    l1 = legs[1]
    l2 = legs[2]
    l3 = legs[3]
    for s in range(row.size):
        row[s] += (
            (p0 * a00[s] + p1 * a10[s] + p2 * a20[s] + p3 * a30[s]) * l0[s]
            + (p0 * a01[s] + p1 * a11[s] + p2 * a21[s] + p3 * a31[s]) * l1[s]
            + (p0 * a02[s] + p1 * a12[s] + p2 * a22[s] + p3 * a32[s]) * l2[s]
            + (p0 * a03[s] + p1 * a13[s] + p2 * a23[s] + p3 * a33[s]) * l3[s]
        )


@kernel
def _reset(row, value):
    for s in range(row.size):
        row[s] = value


@kernel
def _which(lead, gear):
    """Influence functions between two pairs: 0 the same pair, 1 and 2 neighbours, -1 others.

    Of two teeth of gear 1 that with the higher number of its pair precedes the other one counter-clockwise
    (right flanks: clockwise), of gear 2 that with the lower number.
    """
    if lead == 0:
        return 0
    if lead == 1:
        return 1 if gear == 0 else 2
    if lead == -1:
        return 2 if gear == 0 else 1
    return -1


@kernel
def _polynomials_at(b, node, gear):
    return _polynomials(_height(b, gear, node["roll"][gear])[0])


@kernel
def assemble(b, nodes, n, legs, local, index, row, C):
    """Set the compliance matrix C of n nodes, their local compliances, and the polynomials of their heights.

    `index`: number of the node of each pair and plane, -1 without; `row`: scratch of one value per column.
    """
    pairs = nodes[n - 1]["slot"] + 1
    for k in range(pairs):
        for s in range(b["columns"]):
            index[k, s] = -1
            for m in range(HEIGHTS):
                legs[k, 0, m, s] = 0.0
                legs[k, 1, m, s] = 0.0
    for i in range(n):
        set_local(b, nodes, i, legs, local)
        index[nodes[i]["slot"], nodes[i]["plane"]] = i
    windup = b["windup"]
    for i in range(n):
        node = nodes[i]
        plane = node["plane"]
        p_1 = _polynomials_at(b, node, 0)
        p_2 = _polynomials_at(b, node, 1)
        for k in range(pairs):
            # pairs are listed in descending order of their numbers
            lead = k - node["slot"]
            _reset(row, windup)
            if _which(lead, 0) >= 0:
                _add_row(influence(b, 0, _which(lead, 0))[plane], p_1, legs[k, 0], row)
                _add_row(influence(b, 1, _which(lead, 1))[plane], p_2, legs[k, 1], row)
            for s in range(b["slices"]):
                j = index[k, s]
                if j >= 0:
                    C[i, j] = row[s]


@kernel
def load_planes(nodes, n, legs, loads):
    """Set the polynomials of the heights times the elastic forces of n nodes."""
    pairs = nodes[n - 1]["slot"] + 1
    for k in range(pairs):
        for gear in range(2):
            for m in range(HEIGHTS):
                _reset(loads[k, gear, m], 0.0)
    for i in range(n):
        node = nodes[i]
        for gear in range(2):
            for m in range(HEIGHTS):
                where = legs[node["slot"], gear, m, node["plane"]]
                loads[node["slot"], gear, m, node["plane"]] = where * node["elastic"]


@kernel
def energy_by_height(b, node, pairs, loads, row):
    """Derivatives of the elastic energy f C f/2 by both signed lengths of roll of a node, at constant forces.

    `pairs`: number of pairs, `loads`: as from `load_planes`.
    """
    plane = node["plane"]
    f = node["elastic"]
    by_1 = by_2 = 0.0
    for gear in range(2):
        t, slope = _height(b, gear, node["roll"][gear])
        if slope == 0.0:
            continue
        d = _slopes(t)
        _reset(row, 0.0)
        for k in range(pairs):
            which = _which(k - node["slot"], gear)
            if which >= 0:
                _add_row(influence(b, gear, which)[plane], d, loads[k, gear], row)
        total = 0.0
        for s in range(row.size):
            total += row[s]
        if gear == 0:
            by_1 = f * total * slope
        else:
            by_2 = f * total * slope
    return by_1, by_2
