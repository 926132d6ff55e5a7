# SPDX-License-Identifier: Apache-2.0
"""Tangents of meshes on flexible rims: from the frames of gear 1 and of the teeth to bodies and coordinates.

Exact tangents are those of the relation between the frames, see `flexible_rim`: its second derivatives with
the wrench on the teeth, and the change of the velocities with the damping part of the tangent.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.mesh.eccentricity import swing_rate
from pitchpoint.elements.mesh.rim_workspace import GROUP, put3
from pitchpoint.multibody.vectors import add, cross, dot, plus, times, triple, unit


@kernel
def right_tangents(w, kk, ways):
    """Set `half` from tangents `kk` of both frames: their forces by the motions of bodies and coordinates."""
    way = w["way"]
    for side in range(2):
        for r in range(6):
            for c in range(ways):
                s = kk[2 * side, r, c] if c < 6 else 0.0
                for h in range(6):
                    s += kk[2 * side + 1, r, h] * way[h, c]
                w["half"][6 * side + r, c] = s


@kernel
def left_tangents(w, ways):
    """Set `whole` from `half`: forces on bodies and coordinates."""
    way = w["way"]
    half = w["half"]
    for r in range(ways):
        for c in range(ways):
            s = half[r, c] if r < 6 else 0.0
            for h in range(6):
                s += way[h, r] * half[6 + h, c]
            w["whole"][r, c] = s


@kernel
def _change(w, c, order, first):
    """Change of a sum (a or c and derivatives, world axes) by motion c of bodies or coordinates."""
    if c >= 12:
        return triple(w["shape"][order, c - 12], first)
    x = times(w["turn"][c], triple(w["sum"][order + 1], first))
    if c >= 9:
        x = add(x, cross(unit(c - 9), triple(w["sum"][order], first)))
    return x


@kernel
def _change_of_shape(w, c, k, first):
    """Change of the shape of coordinate k, likewise."""
    x = times(w["turn"][c], triple(w["shape"][1, k], first))
    if c >= 9:
        x = add(x, cross(unit(c - 9), triple(w["shape"][0, k], first)))
    return x


@kernel
def _change_of_flow(w, c, first):
    """Change of the motion of the teeth by the rates of the coordinates and of theta, at constant rates."""
    rate = w["theta_rate"]
    x = times(rate, _change(w, c, 1, first))
    if c < 12:
        x = add(x, times(w["turn"][c], triple(w["flow"][1], first)))
    if c >= 9 and c < 12:
        x = add(x, cross(unit(c - 9), triple(w["flow"][0], first)))
    return x


@kernel
def _turn_gradient(w, c):
    """Set the change of the gradient of theta by motion c of the bodies."""
    for r in range(12):
        w["d_turn"][r] = 0.0
    if c >= 12:
        return
    arm = triple(w["arm"], 0)
    line = triple(w["line"], 0)
    out = triple(w["out"], 0)
    along = triple(w["along"], 0)
    d_arm = cross(unit(c - 3), arm) if c < 6 else (0.0, 0.0, 0.0)
    d_line = add(unit(c), d_arm) if c < 6 else times(-1.0, unit(c - 6))
    spin = unit(c - 9) if c >= 9 else (0.0, 0.0, 0.0)
    d_along = add(times(-w["turn"][c], out), cross(spin, along))
    d_reach = dot(out, d_line) + dot(cross(spin, out), line)
    per = 1.0 / w["reach"]
    d_per = times(per, plus(d_along, -d_reach * per, along))
    put3(w["d_turn"], 0, d_per)
    put3(w["d_turn"], 3, add(cross(d_arm, times(per, along)), cross(arm, d_per)))
    put3(w["d_turn"], 6, times(-1.0, d_per))
    put3(w["d_turn"], 9, times(-1.0, add(cross(d_line, times(per, along)), cross(line, d_per))))


@kernel
def follow_rates(b, w, f, dk, ck, ways):
    """Add to `half` the forces by the change of velocities at constant rates of bodies and coordinates."""
    spin = triple(w["tw"], 3)
    for c in range(ways):
        _turn_gradient(w, c)
        rate = 0.0
        for r in range(6):
            rate += w["d_turn"][r] * f["tw"][r] + w["d_turn"][6 + r] * w["tw"][r]
        v = add(cross(spin, _change(w, c, 0, 0)), _change_of_flow(w, c, 0))
        v = plus(v, rate, triple(w["sum"][1], 0))
        o = plus(_change_of_flow(w, c, 3), rate, triple(w["sum"][1], 3))
        for side in range(2):
            for r in range(6):
                s = 0.0
                for h in range(3):
                    s += dk[2 * side + 1, r, h] * v[h] + dk[2 * side + 1, r, 3 + h] * o[h]
                w["half"][6 * side + r, c] += ck * s


@kernel
def follow_forces(b, w, F, ck, ways):
    """Add to `whole` the change of the directions of the wrench F on the teeth."""
    force = triple(F, 0)
    moment = triple(F, 3)
    whole = w["whole"]
    torque = dot(triple(w["sum"][1], 0), force) + dot(triple(w["sum"][1], 3), moment)
    for c in range(ways):
        _turn_gradient(w, c)
        change = dot(_change(w, c, 1, 0), force) + dot(_change(w, c, 1, 3), moment)
        for r in range(12):
            whole[r, c] -= ck * (w["d_turn"][r] * torque + w["turn"][r] * change)
        lift = cross(_change(w, c, 0, 0), force)
        for r in range(3):
            whole[9 + r, c] -= ck * lift[r]
        if c < 12:
            for k in range(b["n_rim"]):
                by = dot(_change_of_shape(w, c, k, 0), force) + dot(_change_of_shape(w, c, k, 3), moment)
                whole[12 + k, c] -= ck * by


@kernel
def to_bodies(w, kk):
    """Replace the tangents of both frames by those of the bodies."""
    for side in range(2):
        for other in range(2):
            for r in range(6):
                for c in range(6):
                    kk[2 * side + other, r, c] = w["whole"][6 * side + r, 6 * other + c]


@kernel
def to_coordinates(b, w, kk, arms):
    """Add the tangents of the coordinates; `arms`: from the bodies to the gears, if eccentric."""
    whole = w["whole"]
    n = b["n_rim"]
    pairs = b["pairs"]
    for k in range(n):
        x = 2 + k // GROUP
        r = k % GROUP
        for h in range(n):
            kk[pairs[x, 2 + h // GROUP], r, h % GROUP] += whole[12 + k, 12 + h]
        for side in range(2):
            arm = triple(arms[side], 0)
            rows = kk[pairs[side, x]]
            columns = kk[pairs[x, side]]
            first = 6 * side
            up = (whole[first, 12 + k], whole[first + 1, 12 + k], whole[first + 2, 12 + k])
            across = (whole[12 + k, first], whole[12 + k, first + 1], whole[12 + k, first + 2])
            up_turn = cross(arm, up)
            across_turn = cross(arm, across)
            for c in range(3):
                rows[c, r] += up[c]
                rows[3 + c, r] += whole[first + 3 + c, 12 + k] + up_turn[c]
                columns[r, c] += across[c]
                columns[r, 3 + c] += whole[12 + k, first + 3 + c] + across_turn[c]


@kernel
def swing_coordinates(b, w, own, arms, kk, ck):
    """Add the change of the velocities of eccentric gears to the tangents of the coordinates."""
    for k in range(b["n_rim"]):
        for side in range(2):
            block = kk[b["pairs"][2 + k // GROUP, side]]
            for c in range(3):
                moved = swing_rate(own, arms, side, c)
                s = 0.0
                for h in range(3):
                    s += w["whole"][12 + k, 6 * side + h] * moved[h]
                block[k % GROUP, 3 + c] += ck * s
