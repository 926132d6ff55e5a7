# SPDX-License-Identifier: Apache-2.0
"""Torsion between two bodies: angle, speed and common axis, and a torque about that axis with its tangents.

The rotation of each body is relative to ground: its own spin plus those of its parents, as a remainder and
whole turns. The common axis m is the bisector of the two spin axes, so that action equals reaction and the
element is symmetric; for axes of opposite sense the angles are added. A body whose axis differs by more than
45 degrees from that of body i (a housing, ground) has no rotation about it: m is then the axis of body i. The
speed is m . (omega_i - omega_j), so that the power of the torque is torque times speed for any tilt.

Angles are joint angles, whose rate is the speed for parallel axes; the error is of first order in the tilt
times the rate of tilt.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.wrench import angular_velocity, spin_axis
from pitchpoint.multibody.vectors import add, cross, dot, less, times, unit

SAME = math.sqrt(0.5)
"""Cosine of the maximum angle between two axes that are treated as one."""


@kernel(inline=True)
def sense_of(f, g, j):
    """Sense of rotation of body j about the axis of body i: 1 same, -1 opposite, 0 none."""
    if j == 0:
        return 0
    along = dot(spin_axis(f), spin_axis(g))
    return 1 if along > SAME else -1 if along < -SAME else 0


@kernel(inline=True)
def common_axis(f, g, sense):
    """Unit vector of the bisector of both spin axes."""
    n = spin_axis(f)
    if sense == 0:
        return n
    other = times(float(sense), spin_axis(g))
    if n[0] == other[0] and n[1] == other[1] and n[2] == other[2]:  # discs on one axis
        return n
    m = add(n, other)
    return times(1.0 / math.sqrt(dot(m, m)), m)


@kernel(inline=True)
def turn_between(f, g, sense):
    """Angle of body i relative to body j: remainder [rad] and whole turns."""
    angle = f["phi"] + f["base"]
    turns = f["turns"] + f["base_turns"]
    if sense != 0:
        angle -= sense * (g["phi"] + g["base"])
        turns -= sense * (g["turns"] + g["base_turns"])
    return angle, turns


@kernel(inline=True)
def speed_between(f, g, m):
    """Angular velocity of body i relative to body j about m [rad/s]."""
    return dot(m, less(angular_velocity(f), angular_velocity(g)))


@kernel(inline=True)
def add_torque(f, g, m, torque):
    """Add a torque about m on body i and its reaction on body j."""
    for r in range(3):
        f["F"][3 + r] += torque * m[r]
        g["F"][3 + r] -= torque * m[r]


@kernel
def turn_column(f, g, sense, m, side, c, exact):
    """Changes of angle, speed and m for a rotation of body i (`side` 0) or j (1) about the world axis c.

    If `exact` is 0, the component of the rotation about m is used as the change of the angle.
    """
    w = unit(c)
    here = f if side == 0 else g
    back = 1.0 if side == 0 else -1.0
    share = 1.0 if side == 0 else float(sense)
    dn = times(share, cross(w, spin_axis(here)))
    dm = dn
    if sense != 0:
        both = add(spin_axis(f), times(float(sense), spin_axis(g)))
        dm = times(1.0 / math.sqrt(dot(both, both)), less(dn, times(dot(m, dn), m)))
    speed = dot(dm, less(angular_velocity(f), angular_velocity(g)))
    if side == 1 and sense == 0:
        return 0.0, speed, dm
    if exact != 0:
        a = here["axle"]
        return back * share * (a[0] * w[0] + a[1] * w[1] + a[2] * w[2]), speed, dm
    return back * dot(m, w), speed, dm


@kernel
def torque_tangent(b, f, g, kk, ctl, m, sense, torque, by_angle, by_speed):
    """Add the tangents of `add_torque`; b needs the index fields of the pair (i, j)."""
    c = ctl[0]
    exact = 1 if c["jac"] == 2 else 0
    for side in range(2):
        if side == 1 and b["j"] == 0:
            break
        ki = kk[b["ii"]] if side == 0 else kk[b["ij"]]
        kj = kk[b["ji"]] if side == 0 else kk[b["jj"]]
        back = 1.0 if side == 0 else -1.0
        for k in range(3):
            angle, speed, dm = turn_column(f, g, sense, m, side, k, exact)
            s = c["ck"] * (by_angle * angle + by_speed * speed) + c["cd"] * by_speed * back * m[k]
            for r in range(3):
                x = s * m[r] + c["ck"] * torque * dm[r]
                ki[3 + r, 3 + k] -= x
                kj[3 + r, 3 + k] += x


@kernel
def state_tangent(b, f, g, kk, ctl, m, sense, n, slopes):
    """Add the tangents of a torque that depends on a state y, the spin rate of body k with the axis n.

    `slopes`: derivatives of the torque by y, of y' by y and of y' by the speed. b needs the index fields of
    all pairs of i, j and k.
    """
    by_state, rate_by_state, rate_by_speed = slopes
    c = ctl[0]
    exact = 1 if c["jac"] == 2 else 0
    cd = c["cd"]
    for r in range(3):
        for h in range(3):
            kk[b["ik"], 3 + r, 3 + h] -= cd * by_state * m[r] * n[h]
            kk[b["jk"], 3 + r, 3 + h] += cd * by_state * m[r] * n[h]
            kk[b["kk"], 3 + r, 3 + h] -= cd * rate_by_state * n[r] * n[h]
    for side in range(2):
        if side == 1 and b["j"] == 0:
            break
        back = 1.0 if side == 0 else -1.0
        for h in range(3):
            angle, speed, dm = turn_column(f, g, sense, m, side, h, exact)
            s = rate_by_speed * (c["ck"] * speed + cd * back * m[h])
            for r in range(3):
                if side == 0:
                    kk[b["ki"], 3 + r, 3 + h] -= s * n[r]
                else:
                    kk[b["kj"], 3 + r, 3 + h] -= s * n[r]
