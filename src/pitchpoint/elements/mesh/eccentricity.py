# SPDX-License-Identifier: Apache-2.0
"""Eccentric and wobbling gears: gear frames that replace the body frames in the mesh.

The centre of the gear is displaced at mid-face and its axis is tilted, both fixed to the rotating body. The
gear frame has the same spin phi: with B the small tilt of the axis in body axes, the body rotated by phi and
then tilted is R R_z(phi) B = R' R_z(phi), where R' is the body frame R rotated so that its third axis is the
gear axis. Line of action, centre distance, travel and phase of the mesh follow from the gear frames as from
any others; the mesh itself is unchanged.

With rho from the origin of the body to that of the gear, T transforms velocities to the gear, and its
transpose transforms wrenches and tangents back,

    v' = v + w x rho,   F = T^T F',   dF/dx = T^T (dF'/dx') T + (theta x rho) x f'

where rho rotates with the body: exact tangents include the last term and the change w x (theta x rho) of v'
at constant body velocity. The latter needs the damping part of the tangent alone, for which the mesh is
summed again.

The transmission error is reported as for centred gears, from the frames of the bodies.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.mesh.line_of_action import line_of_action, pooled
from pitchpoint.elements.mesh.observations import observed
from pitchpoint.elements.wrench import angular_velocity
from pitchpoint.multibody.channels import F8, FRAME
from pitchpoint.multibody.vectors import add, column, cross, dot, times, triple, unit

PLACE = 8
"""Number of leading values: displacement x, y [m] and axis tilt x, y of each gear, in body axes at spin 0."""
_FRAMES = PLACE
_TANGENTS = _FRAMES + 2 * FRAME.itemsize // 8
_DAMPING = _TANGENTS + 4 * 36
_ARMS = _DAMPING + 4 * 36
_TRAVEL = _ARMS + 6
WORDS = _TRAVEL + 1
"""Size of the pool entry of a mesh with displaced gears: leading values, then scratch."""


def displaced(place: np.ndarray) -> np.ndarray:
    """Pool entry of a mesh whose gears have the displacement and tilt `place`, shape (2, 4)."""
    room = np.zeros(WORDS)
    room[:PLACE] = np.ravel(place)
    return room


@kernel
def _displace(f, own, zc, place, arms, side):
    """Set the frame of one gear from that of its body; `zc`: mid-face from the origin of the body [m]."""
    R = f["R"]
    c = math.cos(f["phi"])
    s = math.sin(f["phi"])
    n = column(R, 2)
    x = add(times(c, column(R, 0)), times(s, column(R, 1)))  # axes of the rotating body
    y = add(times(-s, column(R, 0)), times(c, column(R, 1)))
    nx = place[4 * side + 2]
    ny = place[4 * side + 3]
    nz = math.sqrt(1.0 - nx * nx - ny * ny)
    lean = add(times(nx, x), times(ny, y))
    axis = add(lean, times(nz, n))
    swing = cross(n, axis)
    arm = add(times(place[4 * side], x), times(place[4 * side + 1], y))
    arm = add(arm, times(zc, add(times(1.0 - nz, n), times(-1.0, lean))))
    for k in range(2):
        a = column(R, k)
        swung = add(add(times(nz, a), cross(swing, a)), times(dot(swing, a) / (1.0 + nz), swing))
        for r in range(3):
            own["R"][r, k] = swung[r]
    v = cross(angular_velocity(f), arm)
    for r in range(3):
        own["R"][r, 2] = axis[r]
        own["r"][r] = f["r"][r] + arm[r]
        own["tw"][r] = f["tw"][r] + v[r]
        own["tw"][3 + r] = f["tw"][3 + r]
        arms[side, r] = arm[r]
    for r in range(6):
        own["F"][r] = 0.0
    own["phi"] = f["phi"]
    own["spin"] = f["spin"]
    own["turns"] = f["turns"]
    own["base"] = f["base"]
    own["base_turns"] = f["base_turns"]


@kernel
def begin_displaced(b, fr):
    """Redirect the evaluation of mesh `b` to its gear frames; returns these frames."""
    request = b["request"]
    where = pooled(b, b["seats"])
    own = view(where + 8 * _FRAMES, 2, FRAME)
    place = view(where, PLACE, F8)
    if request["out"] != 0:
        line_of_action(b, fr[b["i"]], fr[b["j"]])
        view(where + 8 * _TRAVEL, 1, F8)[0] = b["now"]["u"]
    arms = view(where + 8 * _ARMS, (2, 3), F8)
    _displace(fr[b["i"]], own[0], b["zc1"], place, arms, 0)
    _displace(fr[b["j"]], own[1], b["zc2"], place, arms, 1)
    request["i"] = 0
    request["j"] = 1
    request["ii"] = 0
    request["ij"] = 1
    request["ji"] = 2
    request["jj"] = 3
    request["fr"] = where + 8 * _FRAMES
    request["nb"] = 2
    request["np"] = 4
    return own


@kernel
def _own_tangents(b, first):
    """Cleared tangent blocks of the gear frames, as target of the mesh evaluation."""
    request = b["request"]
    request["kk"] = pooled(b, b["seats"]) + 8 * first
    kk = view(request["kk"], (4, 6, 6), F8)
    if request["jac"] != 0:
        for p in range(4):
            for r in range(6):
                for k in range(6):
                    kk[p, r, k] = 0.0
    return kk


@kernel
def tangent_blocks(b):
    """Tangents of the gear frames [4, 6, 6]."""
    return view(pooled(b, b["seats"]) + 8 * _TANGENTS, (4, 6, 6), F8)


@kernel
def damping_blocks(b):
    """Damping part of these tangents [4, 6, 6], with exact tangents only."""
    return view(pooled(b, b["seats"]) + 8 * _DAMPING, (4, 6, 6), F8)


@kernel
def arms_of(b):
    """Vectors from the origins of the bodies to those of the gears [2, 3]."""
    return view(pooled(b, b["seats"]) + 8 * _ARMS, (2, 3), F8)


@kernel
def damping_alone(b):
    """Target blocks for the tangents of the damping alone; requests them from the next evaluation."""
    b["request"]["jac"] = 1
    return _own_tangents(b, _DAMPING)


@kernel
def whole(b, own):
    """Target blocks for the full tangents; resets the forces of an earlier evaluation."""
    for side in range(2):
        for r in range(6):
            own[side]["F"][r] = 0.0
    return _own_tangents(b, _TANGENTS)


@kernel
def swing_rate(own, arms, side, k):
    """Change of a gear velocity with a rotation of its body about axis k, at constant body velocities."""
    return cross(angular_velocity(own[side]), cross(unit(k), triple(arms[side], 0)))


@kernel
def _swing_rates(kk, dk, own, arms, ck):
    """Add the change of the gear velocities with rotations of the bodies, at constant body velocities."""
    for side in range(2):
        for k in range(3):
            moved = swing_rate(own, arms, side, k)
            for p in range(2):
                for r in range(6):
                    s = 0.0
                    for h in range(3):
                        s += dk[2 * p + side, r, h] * moved[h]
                    kk[2 * p + side, r, 3 + k] += ck * s


@kernel
def _carry(source, target, left, right):
    """Add T_left^T `source` T_right to one pair block."""
    for c in range(6):
        shift = cross(unit(c - 3), right)
        force = column(source, c)
        moment = (source[3, c], source[4, c], source[5, c])
        for h in range(3):
            force = add(force, times(shift[h], column(source, h)))
            moment = add(moment, times(shift[h], (source[3, h], source[4, h], source[5, h])))
        moment = add(moment, cross(left, force))
        for r in range(3):
            target[r, c] += force[r]
            target[3 + r, c] += moment[r]


@kernel
def end_displaced(b, ctl, fr, kk, own):
    """Transform wrenches and tangents of the displaced gears `own` back to their bodies."""
    where = pooled(b, b["seats"])
    own_kk = tangent_blocks(b)
    arms = arms_of(b)
    if ctl["jac"] == 2 and ctl["ck"] != 0.0:
        _swing_rates(own_kk, damping_blocks(b), own, arms, ctl["ck"])
    if ctl["out"] != 0:
        observed(b)["transmission_error"] = view(where + 8 * _TRAVEL, 1, F8)[0]
    one = triple(arms[0], 0)
    two = triple(arms[1], 0)
    if ctl["jac"] != 0:
        _carry(own_kk[0], kk[b["ii"]], one, one)
        _carry(own_kk[1], kk[b["ij"]], one, two)
        _carry(own_kk[2], kk[b["ji"]], two, one)
        _carry(own_kk[3], kk[b["jj"]], two, two)
    for side in range(2):
        f = fr[b["i"]] if side == 0 else fr[b["j"]]
        arm = one if side == 0 else two
        force = triple(own[side]["F"], 0)
        moment = cross(arm, force)
        for r in range(3):
            f["F"][r] += force[r]
            f["F"][3 + r] += own[side]["F"][3 + r] + moment[r]
        if ctl["jac"] == 2:
            block = kk[b["ii"]] if side == 0 else kk[b["jj"]]
            for k in range(3):
                more = cross(cross(unit(k), arm), force)
                for r in range(3):
                    block[3 + r, 3 + k] -= ctl["ck"] * more[r]
