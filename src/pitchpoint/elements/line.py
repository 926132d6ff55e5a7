# SPDX-License-Identifier: Apache-2.0
"""Line between two body-fixed points, and the wrenches and tangents of a tension along it.

The points are given in body axes. A tension T > 0 pulls them together: T times the unit vector from the point
of body i to that of body j acts on body i, the reaction on body j. For coincident points the direction is
undefined: the unit vector is zero, and a spring of free length zero retains its stiffness.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.wrench import angular_velocity, origin, push, put, velocity
from pitchpoint.multibody.vectors import add, cross, dot, into_world, less, times, triple, unit

COINCIDENT = 1e-12
"""Distance below which two points coincide [m]."""


@kernel
def line_between(b, f, g):
    """Arms of both points, unit vector from j to i, length, velocity of i relative to j and its component
    along the line."""
    arm_i = into_world(f["S"], triple(b["p_i"], 0))
    arm_j = into_world(g["S"], triple(b["p_j"], 0))
    u = less(add(origin(f), arm_i), add(origin(g), arm_j))
    w = less(velocity(f), velocity(g))
    w = add(w, less(cross(angular_velocity(f), arm_i), cross(angular_velocity(g), arm_j)))
    length = math.sqrt(dot(u, u))
    e = times(1.0 / length, u) if length > COINCIDENT else (0.0, 0.0, 0.0)
    return arm_i, arm_j, e, length, w, dot(e, w)


@kernel
def pull(f, g, arm_i, arm_j, e, tension):
    """Add the wrenches of a tension."""
    nothing = (0.0, 0.0, 0.0)
    push(f, arm_i, times(-tension, e), nothing, 1.0)
    push(g, arm_j, times(tension, e), nothing, 1.0)


@kernel
def line_column(f, g, line, side, c):
    """Changes of length, of its rate at constant velocities, of the unit vector times length, and of the arm.

    Motion c of body i (`side` 0) or j (1): three translations, three rotations. The change of the length is
    also the change of the rate for the same motion as a velocity.
    """
    arm_i, arm_j, e, length, w, rate = line
    moved = cross(unit(c - 3), arm_i if side == 0 else arm_j)
    du = add(unit(c), moved)
    dw = cross(angular_velocity(f) if side == 0 else angular_velocity(g), moved)
    if side == 1:
        du = times(-1.0, du)
        dw = times(-1.0, dw)
    longer = dot(e, du)
    across = less(du, times(longer, e))
    by_rate = dot(e, dw)
    if length > COINCIDENT:
        by_rate += dot(across, w) / length
    return longer, by_rate, across, moved


@kernel
def tension_tangent(b, f, g, kk, ctl, line, tension, by_length, by_rate):
    """Add the tangents of `pull`; b needs the index fields of the pair (i, j)."""
    c = ctl[0]
    arm_i, arm_j, e, length, w, rate = line
    # coincident points: the stiffness is isotropic
    over = tension / length if length > COINCIDENT else by_length
    force = times(-tension, e)
    for side in range(2):
        if side == 1 and b["j"] == 0:
            break
        ki = kk[b["ii"]] if side == 0 else kk[b["ij"]]
        kj = kk[b["ji"]] if side == 0 else kk[b["jj"]]
        for k in range(6):
            longer, faster, across, moved = line_column(f, g, line, side, k)
            s = c["ck"] * (by_length * longer + by_rate * faster) + c["cd"] * by_rate * longer
            df = add(times(-s, e), times(-c["ck"] * over, across))
            swung = times(c["ck"], cross(moved, force))
            if side == 0:
                put(ki, k, -1.0, df, add(cross(arm_i, df), swung))
                put(kj, k, 1.0, df, cross(arm_j, df))
            else:
                put(ki, k, -1.0, df, cross(arm_i, df))
                put(kj, k, 1.0, df, add(cross(arm_j, df), swung))
