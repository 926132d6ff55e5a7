# SPDX-License-Identifier: Apache-2.0
"""Actuators: wrench = signal times unit wrench, with tangents for the rotation of the unit wrench."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.line import line_between, pull, tension_tangent
from pitchpoint.elements.signals.record import BODY_I, BODY_J, RATE, STRUT, TORQUE
from pitchpoint.elements.torsion import add_torque, common_axis, sense_of, torque_tangent
from pitchpoint.elements.wrench import origin, push, put, spin_axis
from pitchpoint.multibody.vectors import add, cross, into_world, less, moved_axis, times, triple, unit


@kernel
def _keep(unit_wrench, first, force, couple):
    """Store a unit wrench."""
    for r in range(3):
        unit_wrench[first + r] = force[r]
        unit_wrench[first + 3 + r] = couple[r]


@kernel
def _push_fixed(b, f, g, kk, ctl, value, wrench, tangents):
    """Add force and moment of fixed direction at a point of body i, with reaction on body j at that point."""
    force = triple(b["F"], 0)
    couple = triple(b["F"], 3)
    if b["axes"] == BODY_I:
        force = into_world(f["S"], force)
        couple = into_world(f["S"], couple)
    elif b["axes"] == BODY_J:
        force = into_world(g["S"], force)
        couple = into_world(g["S"], couple)
    arm = moved_axis(f, b["p_i"])
    reach = less(add(origin(f), arm), origin(g))
    push(f, arm, force, couple, value)
    push(g, reach, force, couple, -value)
    _keep(wrench, 0, force, add(cross(arm, force), couple))
    _keep(wrench, 6, times(-1.0, force), times(-1.0, add(cross(reach, force), couple)))
    if tangents == 0:
        return
    s = ctl[0]["ck"] * value
    nothing = (0.0, 0.0, 0.0)
    for side in range(2):
        if side == 1 and b["j"] == 0:
            break
        ki = kk[b["ii"]] if side == 0 else kk[b["ij"]]
        kj = kk[b["ji"]] if side == 0 else kk[b["jj"]]
        turns = (side == 0 and b["axes"] == BODY_I) or (side == 1 and b["axes"] == BODY_J)
        for k in range(6):
            w = unit(k - 3)
            df = cross(w, force) if turns else nothing
            dm = cross(w, couple) if turns else nothing
            d_arm = cross(w, arm) if side == 0 else nothing
            d_reach = add(unit(k), d_arm) if side == 0 else times(-1.0, unit(k))
            put(ki, k, -s, df, add(dm, add(cross(arm, df), cross(d_arm, force))))
            put(kj, k, s, df, add(dm, add(cross(reach, df), cross(d_reach, force))))


@kernel
def act(b, fr, kk, ctl, value, wrench, tangents):
    """Add the wrenches of an actuator; writes the wrenches of a unit signal on i and j to `wrench` (12)."""
    f = fr[b["i"]]
    g = fr[b["j"]]
    op = b["op"]
    nothing = (0.0, 0.0, 0.0)
    if op == RATE:
        n = spin_axis(f)
        push(f, nothing, nothing, n, value)
        _keep(wrench, 0, nothing, n)
    elif op == TORQUE:
        sense = sense_of(f, g, b["j"])
        m = common_axis(f, g, sense)
        add_torque(f, g, m, value)
        _keep(wrench, 0, nothing, m)
        _keep(wrench, 6, nothing, times(-1.0, m))
        if tangents != 0:
            torque_tangent(b, f, g, kk, ctl, m, sense, value, 0.0, 0.0)
    elif op == STRUT:
        line = line_between(b, f, g)
        arm_i, arm_j, e, length, w, rate = line
        pull(f, g, arm_i, arm_j, e, -value)  # a positive signal pushes the points apart
        _keep(wrench, 0, e, cross(arm_i, e))
        _keep(wrench, 6, times(-1.0, e), times(-1.0, cross(arm_j, e)))
        if tangents != 0:
            tension_tangent(b, f, g, kk, ctl, line, -value, 0.0, 0.0)
    else:
        _push_fixed(b, f, g, kk, ctl, value, wrench, tangents)
