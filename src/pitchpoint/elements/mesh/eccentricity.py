# SPDX-License-Identifier: Apache-2.0
"""Eccentric and wobbling gears: the frames that a mesh sees in place of those of their bodies.

The centre of such a gear is displaced in its mid-face and its axis is tilted, both fixed to the turning body.
Its own frame has the same spin phi: with B the small tilt of the axis in the axes of the body, the body
turned by phi and then tilted is R R_z(phi) B = R' R_z(phi), R' the frame of the body swung so that its third
axis is that of the gear. Line of action, centre distance, travel and phase of the mesh follow from the moved
frames as from any others, and nothing in it knows of the fault.

With rho from the origin of the body to that of the gear, twists go there by T and wrenches and tangents come
back by its transpose,

    v' = v + w x rho,   F = T^T F',   dF/dx = T^T (dF'/dx') T + (theta x rho) x f'

where rho turns with the body: the last term, and v' that changes by w x (theta x rho) at a constant twist,
make exact tangents whole. The latter needs the damping part of the tangent alone, which the mesh sums again.

The transmission error is reported as for centred gears: it is that of the bodies.
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
"""Numbers of both gears that come first: displacement x, y [m] and the tilt of the axis as its x and y, all
in the axes of the bodies at spin 0."""
_FRAMES = PLACE
_TANGENTS = _FRAMES + 2 * FRAME.itemsize // 8
_DAMPING = _TANGENTS + 4 * 36
_ARMS = _DAMPING + 4 * 36
_TRAVEL = _ARMS + 6
WORDS = _TRAVEL + 1
"""Numbers in the pool of a mesh with displaced gears: the places, then scratch."""


def displaced(place: np.ndarray) -> np.ndarray:
    """Room in the pool for a mesh whose gears sit at `place`, shape (2, 4)."""
    room = np.zeros(WORDS)
    room[:PLACE] = np.ravel(place)
    return room


@kernel
def _displace(f, own, zc, place, arms, side):
    """Fill the frame of one gear from that of its body; `zc` mid-face from the origin of the body [m]."""
    R = f["R"]
    c = math.cos(f["phi"])
    s = math.sin(f["phi"])
    n = column(R, 2)
    x = add(times(c, column(R, 0)), times(s, column(R, 1)))  # axes of the turning body
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
    """Turn the evaluation of mesh `b` towards frames of its own, which it gives."""
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
    """Tangents of the displaced frames, set to zero, where the mesh finds them."""
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
def damping_alone(b):
    """Where the next sum puts its tangents, which are those of the damping alone."""
    b["request"]["jac"] = 1
    return _own_tangents(b, _DAMPING)


@kernel
def whole(b, own):
    """Where the requested sum puts its tangents; forces of an earlier one are dropped."""
    for side in range(2):
        for r in range(6):
            own[side]["F"][r] = 0.0
    return _own_tangents(b, _TANGENTS)


@kernel
def _swing_rates(kk, dk, own, arms, ck):
    """Add the change of the velocities of both gears with the turns of the bodies, at constant twists."""
    for side in range(2):
        arm = triple(arms[side], 0)
        w = angular_velocity(own[side])
        for k in range(3):
            moved = cross(w, cross(unit(k), arm))
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
    """Bring wrenches and tangents of the displaced gears `own` back to their bodies."""
    where = pooled(b, b["seats"])
    own_kk = view(where + 8 * _TANGENTS, (4, 6, 6), F8)
    arms = view(where + 8 * _ARMS, (2, 3), F8)
    if ctl["jac"] == 2 and ctl["ck"] != 0.0:
        _swing_rates(own_kk, view(where + 8 * _DAMPING, (4, 6, 6), F8), own, arms, ctl["ck"])
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
