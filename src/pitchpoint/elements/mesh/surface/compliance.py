# SPDX-License-Identifier: Apache-2.0
"""Compliance matrix of the contact nodes of one flank, from the influence functions of both gears.

A force f_j on the plane s_j of a tooth at the height t_j displaces the plane s_i of the same tooth at t_i by

    f_j times the sum over m, n of P_m(t_i) own[s_i, s_j, m, n] P_n(t_j)

with Legendre polynomials P of the height t, -1 at the root and +1 at the tip; those on the neighbouring teeth
likewise (`contact.compliance`). All nodes of a gear also move by the torsion of its blank. Matrices
refer to a nominal width of the planes; their change with an axial offset of the gears is neglected.
"""

from __future__ import annotations

from pitchpoint.contact.local_approach import A1, A2, K1, K2, T1, B, D
from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.mesh.flank_modifications import roll_sign
from pitchpoint.elements.mesh.line_of_action import pooled
from pitchpoint.multibody.channels import F8

HEIGHTS = 4
"""Number of Legendre polynomials of the height, P_0 to P_3."""


@kernel
def _height(b, gear, roll):
    """Height t of a length of roll on a gear, within [-1, 1], and its derivative by the signed roll."""
    middle = b["height"][gear, 0]
    half = b["height"][gear, 1]
    sign = roll_sign(b, gear)
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
def set_local(b, node, i, legs, local):
    """Set polynomials of the heights of node i and their slopes by the rolls, and its local compliance."""
    place = node["roll"]
    least = b["least_roll"]
    for gear in range(2):
        t, slope = _height(b, gear, place[gear])
        p = _polynomials(t)
        d = _slopes(t)
        for m in range(HEIGHTS):
            legs[i, gear, 0, m] = p[m]
            legs[i, gear, 1, m] = d[m] * slope
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


@kernel(inline=True)
def influence(b, gear, which):
    """Influence functions of a gear on the current flank, shape (planes, planes, 4, 4) over planes and
    polynomials of displacement and force.

    `which` 0: of a tooth on itself, 1 and 2: of a tooth on the one before and after it (`own`, `before`,
    `after` of the record).
    """
    side = 0 if b["now"]["flank"] > 0 else 1
    offset = b["own"][side, gear]
    if which == 1:
        offset = b["before"][side, gear]
    elif which == 2:
        offset = b["after"][side, gear]
    return view(pooled(b, offset), (b["slices"], b["slices"], HEIGHTS, HEIGHTS), F8)


@kernel(inline=True)
def _between(a, leg, place):
    """Displacement per force, and its derivative by the roll of the displaced node.

    `a`: influence functions of both planes, shape (4, 4); `leg`, `place`: polynomials of force and displaced
    node, and their slopes, shape (2, 4).
    """
    l0 = leg[0, 0]
    l1 = leg[0, 1]
    l2 = leg[0, 2]
    l3 = leg[0, 3]
    u0 = a[0, 0] * l0 + a[0, 1] * l1 + a[0, 2] * l2 + a[0, 3] * l3
    u1 = a[1, 0] * l0 + a[1, 1] * l1 + a[1, 2] * l2 + a[1, 3] * l3
    u2 = a[2, 0] * l0 + a[2, 1] * l1 + a[2, 2] * l2 + a[2, 3] * l3
    u3 = a[3, 0] * l0 + a[3, 1] * l1 + a[3, 2] * l2 + a[3, 3] * l3
    u = (u0, u1, u2, u3)
    return _sum_of(place[0], u), _sum_of(place[1], u)


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
def assemble(b, nodes, n, legs, local, C, slopes):
    """Set the compliance matrix C of n nodes, its slopes and the local compliances.

    `slopes`: derivatives of C[i, j] by the rolls of node i on both gears, shape (n, 2, n); `legs`: scratch.
    """
    for i in range(n):
        set_local(b, nodes[i], i, legs, local)
    for i in range(n):
        slot = nodes[i]["slot"]
        plane = nodes[i]["plane"]
        for j in range(n):
            # pairs are listed in descending order of their numbers
            lead = nodes[j]["slot"] - slot
            C[i, j] = b["windup"]
            for gear in range(2):
                which = _which(lead, gear)
                slopes[i, gear, j] = 0.0
                if which >= 0:
                    a = influence(b, gear, which)[plane, nodes[j]["plane"]]
                    c, slope = _between(a, legs[j, gear], legs[i, gear])
                    C[i, j] += c
                    slopes[i, gear, j] = slope
