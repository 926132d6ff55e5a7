# SPDX-License-Identifier: Apache-2.0
"""Flank deviations from the involute: modifications, and grids interpolated at the contact point.

Modifications are closed form (`mesh.flank_modifications`). Each gear also has two stacks of grids over
face width and length of roll. The first holds gaps along the base tangent and additional compliances; the
second, with a finer grid where necessary, level functions: material broken out of or worn off the flank is
the positive part of a level, and its zero line is the edge of the damage. A table per gear gives the grids
(rows of the stacks) of every flank and tooth, and the stations between which they vary over the width; a
tooth without grids has the common modifications only.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.mesh.flank_modifications import modification, roll_sign
from pitchpoint.elements.mesh.line_of_action import pooled
from pitchpoint.elements.mesh.record import N_ROW
from pitchpoint.multibody.channels import F8

_NEAR = 1e-9
"""Distance of a station from the end of a piece, in cells, below which it does not split the piece."""


@kernel
def begin_separation(b):
    """Set the scratch that the nodes of a flank need to read the grids."""
    now = b["now"]
    now["tan_a"] = now["sin_a"] / now["cos_a"]
    now["tan_rate"] = now["xi_A_rate"] / b["r_b2"]
    for s in range(4):
        gear = s % 2
        now["per_z"][s] = (b["n_sz"][s] - 1) / (b["b1"] if gear == 0 else b["b2"])
        now["per_roll"][s] = (b["n_sx"][s] - 1) / (b["roll"][gear, 1] - b["roll"][gear, 0])


@kernel
def runs_damped(b):
    """Whether contact damping depends on the rate at which the contact moves over deviating flanks."""
    return b["n_sep"] > 0 and (
        b["contact"]["d_in"] > 0.0 or b["contact"]["d_out"] > 0.0 or b["contact"]["chi"] > 0.0
    )


@kernel
def find_rows(b, teeth):
    """Write the grid rows of two teeth to the scratch; returns whether they differ from the involute."""
    now = b["now"]
    flank = 0 if now["flank"] > 0 else 1
    found = b["modified"][0] == 1 or b["modified"][1] == 1
    for gear in range(2):
        n = b["n_t"][gear]
        table = view(pooled(b, b["teeth"][gear]), (2, n, N_ROW), F8)
        tooth = (teeth[0] if gear == 0 else teeth[1]) % n
        for k in range(N_ROW):
            now["rows"][gear, k] = int(table[flank, tooth, k])
        if now["rows"][gear, 0] >= 0 or now["rows"][gear, 1] >= 0 or now["rows"][gear, 2] >= 0:
            found = True
    return found


@kernel
def _place_on(b, gear, z, xi):
    """Position on the flank of a gear: width from its mid-face and length of roll [m].

    z is relative to the plane of the pitch point, each grid to the mid-face of its gear.
    """
    now = b["now"]
    z1 = z + b["w1"] * now["dz"]
    if gear == 0:
        return z1, xi + b["r_b1"] * now["tan_a"]
    return z1 - now["dz"], b["r_b2"] * now["tan_a"] - xi


@kernel
def pair_separation(b, z, xi, z_rate, xi_rate):
    """Deviations of the two teeth of `find_rows` at width z and path position xi [m].

    Gap along the base tangent [m], its rate if the point moves at z_rate and xi_rate [m/s], its slope over
    xi; depth of missing material [m] and its rate; additional compliance per face width [m^2/N] and its rate.
    """
    now = b["now"]
    gap = gap_rate = slope = level = level_rate = soft = soft_rate = 0.0
    z_rate += b["w1"] * now["dz_rate"]
    for gear in range(2):
        at, roll = _place_on(b, gear, z, xi)
        way = 1.0 if gear == 0 else -1.0
        along = way * xi_rate + (b["r_b1"] if gear == 0 else b["r_b2"]) * now["tan_rate"]
        across = z_rate if gear == 0 else z_rate - now["dz_rate"]
        if b["modified"][gear] == 1:
            value, over_z, over_roll = modification(b, gear, at, roll)
            gap += value
            gap_rate += over_z * across + over_roll * along
            slope += way * over_roll
        row = now["rows"][gear, 0]
        if row >= 0:
            value, over_z, over_roll = _read(b, gear, row, at, roll)
            gap += value
            gap_rate += over_z * across + over_roll * along
            slope += way * over_roll
        row = now["rows"][gear, 1]
        if row >= 0:
            value, over_z, over_roll = _read(b, gear, row, at, roll)
            soft += value
            soft_rate += over_z * across + over_roll * along
        row = now["rows"][gear, 2]
        if row >= 0:
            value, over_z, over_roll = _read(b, 2 + gear, row, at, roll)
            if value > 0.0:
                level += value
                level_rate += over_z * across + over_roll * along
    return gap, gap_rate, slope, level, level_rate, soft, soft_rate


@kernel
def flank_slopes(b, gear, z, roll):
    """Deviation of the tooth of gear 1 or 2 (0 or 1) of `find_rows` at a point of its flank.

    z: width from the mid-face of the gear [m], roll: length of roll [m]. Gap, missing material included [m],
    and its slopes over z and roll; additional compliance per face width [m^2/N] and its slopes.
    """
    rows = b["now"]["rows"]
    gap = by_z = by_roll = soft = soft_by_z = soft_by_roll = 0.0
    if b["modified"][gear] == 1:
        gap, by_z, by_roll = modification(b, gear, z, roll)
    if rows[gear, 0] >= 0:
        own, own_by_z, own_by_roll = _read(b, gear, rows[gear, 0], z, roll)
        gap += own
        by_z += own_by_z
        by_roll += own_by_roll
    if rows[gear, 1] >= 0:
        soft, soft_by_z, soft_by_roll = _read(b, gear, rows[gear, 1], z, roll)
    if rows[gear, 2] >= 0:
        level, level_by_z, level_by_roll = _read(b, 2 + gear, rows[gear, 2], z, roll)
        if level > 0.0:
            gap += level
            by_z += level_by_z
            by_roll += level_by_roll
    return gap, by_z, by_roll, soft, soft_by_z, soft_by_roll


@kernel
def has_level(b, gear):
    """Whether the tooth of gear 1 or 2 (0 or 1) has a level function (missing material)."""
    return b["now"]["rows"][gear, 2] >= 0


@kernel
def level_at(b, gear, z, xi):
    """Level of the tooth of gear 1 or 2 (0 or 1) at a point of a contact line [m]; below 0: undamaged."""
    at, roll = _place_on(b, gear, z, xi)
    return _read(b, 2 + gear, b["now"]["rows"][gear, 2], at, roll)[0]


@kernel
def gap_at(b, z, xi):
    """Total gap of both teeth at a point of a contact line, missing material included [m]."""
    now = b["now"]
    gap = 0.0
    for gear in range(2):
        at, roll = _place_on(b, gear, z, xi)
        if b["modified"][gear] == 1:
            gap += modification(b, gear, at, roll)[0]
        row = now["rows"][gear, 0]
        if row >= 0:
            gap += _read(b, gear, row, at, roll)[0]
        row = now["rows"][gear, 2]
        if row >= 0:
            gap += max(0.0, _read(b, 2 + gear, row, at, roll)[0])
    return gap


@kernel
def softening_at(b, z, xi):
    """Additional compliance of both teeth at a point of a contact line [m^2/N]."""
    soft = 0.0
    for gear in range(2):
        row = b["now"]["rows"][gear, 1]
        if row >= 0:
            at, roll = _place_on(b, gear, z, xi)
            soft += _read(b, gear, row, at, roll)[0]
    return soft


@kernel
def next_station(b, a, end):
    """Width after `a` at which a contact line crosses the next station of a varying grid.

    For gaps and compliances, which are smooth, a piece spans several stations (`stride`).
    """
    now = b["now"]
    for s in range(4):
        gear = s % 2
        first = now["rows"][gear, 3 + 2 * (s // 2)]
        last = now["rows"][gear, 4 + 2 * (s // 2)]
        if last <= first:
            continue
        zero = 0.5 * (b["n_sz"][s] - 1) / now["per_z"][s]
        shift = b["w1"] * now["dz"]
        if gear == 1:
            shift -= now["dz"]
        stride = b["stride"] if s < 2 else 1
        here = (a + shift + zero) * now["per_z"][s] + _NEAR
        i = min(max(first, (int(math.floor(here / stride)) + 1) * stride), last)
        if i > here:
            stop = i / now["per_z"][s] - zero - shift
            if stop > a and stop < end:
                end = stop
    return end


@kernel
def spin_direction(b):
    """Set row 0 of the wrench basis for pure rotation: torques of a unit base-tangent force."""
    now = b["now"]
    m = now["m"]
    for k in range(3):
        b["basis_i"][0, k] = b["basis_j"][0, k] = 0.0
        b["basis_i"][0, 3 + k] = -now["flank"] * b["r_b1"] * m[k]
        b["basis_j"][0, 3 + k] = -now["flank"] * b["r_b2"] * m[k]


@kernel
def add_roll_tangent(b, kk, rows):
    """Add the tangent of contact damping by the rate at which the contact moves over deviating flanks.

    That rate is the mean travel rate, half of r_b1 omega1 - r_b2 omega2; `rows` of the wrench basis are in
    use. The motion of the contact with the other rates and the rotation of the line of action are neglected.
    """
    now = b["now"]
    m = now["m"]
    half = 0.5 * now["flank"]
    for p in range(rows):
        c1 = half * b["r_b1"] * b["sums"]["roll"][p]
        c2 = half * b["r_b2"] * b["sums"]["roll"][p]
        for k in range(6):
            Bi = b["basis_i"][p, k]
            Bj = b["basis_j"][p, k]
            for n in range(3):
                kk[b["request"]["ii"], k, 3 + n] -= Bi * c1 * m[n]
                kk[b["request"]["ij"], k, 3 + n] += Bi * c2 * m[n]
                kk[b["request"]["ji"], k, 3 + n] -= Bj * c1 * m[n]
                kk[b["request"]["jj"], k, 3 + n] += Bj * c2 * m[n]


@kernel
def _read(b, stack, row, z, roll):
    """Value of a grid at width z from mid-face and signed length of roll [m], and its slopes over both.

    `stack` 0, 1: gaps and compliances of gear 1, 2; 2, 3: levels. Bilinear between the stations, constant
    beyond the edges.
    """
    now = b["now"]
    nz = b["n_sz"][stack]
    nx = b["n_sx"][stack]
    grid = view(pooled(b, b["sep"][stack] + row * nz * nx), (nz, nx), F8)
    per_z = now["per_z"][stack]
    per_roll = now["per_roll"][stack]
    sign = roll_sign(b, stack % 2)
    z = z * per_z + 0.5 * (nz - 1)
    x = (sign * roll - b["roll"][stack % 2, 0]) * per_roll
    inside_z = per_z if z > 0.0 and z < nz - 1 else 0.0
    inside_x = sign * per_roll if x > 0.0 and x < nx - 1 else 0.0
    z = min(max(z, 0.0), nz - 1.0)
    x = min(max(x, 0.0), nx - 1.0)
    i = max(min(int(z), nz - 2), 0)
    j = min(int(x), nx - 2)
    i1 = min(i + 1, nz - 1)
    z -= i
    x -= j
    a0 = grid[i, j]
    a1 = grid[i1, j]
    d0 = grid[i, j + 1] - a0
    d1 = grid[i1, j + 1] - a1
    g0 = a0 + d0 * x
    g1 = a1 + d1 * x
    return g0 + (g1 - g0) * z, (g1 - g0) * inside_z, (d0 + (d1 - d0) * z) * inside_x
