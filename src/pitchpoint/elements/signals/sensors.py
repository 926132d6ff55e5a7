# SPDX-License-Identifier: Apache-2.0
"""Sensors: kinematic quantities between two frames with their derivatives by the motion of both bodies.

With u the vector from the point of body j to that of body i, w its relative velocity, A its relative
acceleration, and an axis E fixed to body j with angular velocity o and acceleration o', the component along E
and its time derivatives as seen from body j are

    s = E.u,  s' = E.w + (o x E).u,  s'' = E.A + 2 (o x E).w + (o' x E + o x (o x E)).u

Angular velocity and acceleration are the first two with the relative angular velocity in place of u. The
derivatives are given for small changes of E, u, w, A, o, o', which follow from a small displacement of a body
at constant velocities, a change of its velocity, or a change of its acceleration.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.line import COINCIDENT
from pitchpoint.elements.signals.record import (
    ANGLE,
    ANGULAR_ACCELERATION,
    ANGULAR_VELOCITY,
    DISTANCE,
    DISTANCE_RATE,
    POSITION,
    ROW,
    VELOCITY,
)
from pitchpoint.elements.torsion import sense_of, turn_between
from pitchpoint.elements.wrench import origin
from pitchpoint.multibody.vectors import add, cross, dot, less, moved_axis, times, triple, unit

TWO_PI = 6.283185307179586


@kernel
def point_motion(f, arm):
    """Position, velocity and acceleration of a point at an arm from the origin of a body."""
    o = triple(f["tw"], 3)
    v = add(triple(f["tw"], 0), cross(o, arm))
    a = add(triple(f["ac"], 0), add(cross(triple(f["ac"], 3), arm), cross(o, cross(o, arm))))
    return add(origin(f), arm), v, a


@kernel
def component(level, E, u, w, A, o, do):
    """Component of a distance vector (`level` 0), its rate (1) or second derivative (2) in rotating axes."""
    if level == 0:
        return dot(E, u)
    oE = cross(o, E)
    if level == 1:
        return dot(E, w) + dot(oE, u)
    return dot(E, A) + 2.0 * dot(oE, w) + dot(add(cross(do, E), cross(o, oE)), u)


@kernel
def component_change(level, now, change):
    """Change of `component` for small changes of all its arguments."""
    E, u, w, A, o, do = now
    dE, du, dw, dA, d_o, d_do = change
    if level == 0:
        return dot(dE, u) + dot(E, du)
    oE = cross(o, E)
    d_oE = add(cross(d_o, E), cross(o, dE))
    if level == 1:
        return dot(dE, w) + dot(E, dw) + dot(d_oE, u) + dot(oE, du)
    s = dot(dE, A) + dot(E, dA) + 2.0 * (dot(d_oE, w) + dot(oE, dw))
    bend = add(add(cross(d_do, E), cross(do, dE)), add(cross(d_o, oE), cross(o, d_oE)))
    return s + dot(bend, u) + dot(add(cross(do, E), cross(o, oE)), du)


@kernel
def point_change(f, arm, order, k):
    """Changes of position, velocity and acceleration of a point when a body moves.

    `order` 0: displacement along or rotation about world axis k at constant velocities; 1: change of its
    velocity; 2: change of its acceleration.
    """
    o = triple(f["tw"], 3)
    nothing = (0.0, 0.0, 0.0)
    turned = cross(unit(k - 3), arm)
    step = add(unit(k), turned)
    if order == 0:
        spun = cross(o, turned)
        return step, spun, add(cross(triple(f["ac"], 3), turned), cross(o, spun))
    if order == 1:
        return nothing, step, add(cross(unit(k - 3), cross(o, arm)), cross(o, turned))
    return nothing, nothing, step


@kernel
def spin_change(f, order, k):
    """Changes of angular velocity and acceleration when a body moves; arguments as in `point_change`."""
    nothing = (0.0, 0.0, 0.0)
    return unit(k - 3) if order == 1 else nothing, unit(k - 3) if order == 2 else nothing


@kernel
def _axis_along(op, e, u, length):
    """Axis of the component: fixed to body j, or along the line between the points."""
    if op == DISTANCE or op == DISTANCE_RATE:
        return times(1.0 / length, u) if length > COINCIDENT else (0.0, 0.0, 0.0)
    return e


@kernel
def sense_way(b, f, g, rows, tangents):
    """Component of a distance vector, a distance, or their rates; rows: derivatives by x, x', x''."""
    op = b["op"]
    line = op == DISTANCE or op == DISTANCE_RATE
    level = 0 if op == POSITION or op == DISTANCE else 1 if op == VELOCITY or op == DISTANCE_RATE else 2
    nothing = (0.0, 0.0, 0.0)
    arm_i = moved_axis(f, b["p_i"])
    arm_j = moved_axis(g, b["p_j"])
    r_i, v_i, a_i = point_motion(f, arm_i)
    r_j, v_j, a_j = point_motion(g, arm_j)
    u = less(r_i, r_j)
    w = less(v_i, v_j)
    A = less(a_i, a_j)
    length = math.sqrt(dot(u, u))
    E = _axis_along(op, moved_axis(g, b["e"]), u, length)
    o = nothing if line else triple(g["tw"], 3)
    do = nothing if line else triple(g["ac"], 3)
    now = (E, u, w, A, o, do)
    if tangents != 0:
        for side in range(2):
            for order in range(3):
                for k in range(6):
                    if side == 0:
                        du, dw, dA = point_change(f, arm_i, order, k)
                    else:
                        du, dw, dA = point_change(g, arm_j, order, k)
                        du = times(-1.0, du)
                        dw = times(-1.0, dw)
                        dA = times(-1.0, dA)
                    dE = nothing
                    d_o = nothing
                    d_do = nothing
                    if line:
                        if length > COINCIDENT:
                            dE = times(1.0 / length, less(du, times(dot(E, du), E)))
                    elif side == 1:
                        if order == 0:
                            dE = cross(unit(k - 3), E)
                        d_o, d_do = spin_change(g, order, k)
                    rows[side * ROW + 6 * order + k] = component_change(
                        level, now, (dE, du, dw, dA, d_o, d_do)
                    )
    return component(level, E, u, w, A, o, do)


@kernel
def sense_spin(b, f, g, rows, tangents):
    """Component of the relative angular velocity or acceleration as seen from body j."""
    level = 0 if b["op"] == ANGULAR_VELOCITY else 1
    nothing = (0.0, 0.0, 0.0)
    E = moved_axis(g, b["e"])
    o = triple(g["tw"], 3)
    O = less(triple(f["tw"], 3), o)  # noqa: E741 - capital of the rate of the axes
    dO = less(triple(f["ac"], 3), triple(g["ac"], 3))
    now = (E, O, dO, nothing, o, nothing)
    if tangents != 0:
        for side in range(2):
            for order in range(3):
                for k in range(6):
                    faster, bent = spin_change(f, order, k)
                    dE = nothing
                    d_o = nothing
                    if side == 1:
                        d_o = faster
                        faster = times(-1.0, faster)
                        bent = times(-1.0, bent)
                        if order == 0:
                            dE = cross(unit(k - 3), E)
                    rows[side * ROW + 6 * order + k] = component_change(
                        level, now, (dE, faster, bent, nothing, d_o, nothing)
                    )
    return component(level, E, O, dO, nothing, o, nothing)


@kernel
def sense_angle(b, f, g, rows, tangents):
    """Angle of a direction on body i in a plane of body j, with whole turns from the spins."""
    x = moved_axis(f, b["x_i"])
    e = moved_axis(g, b["e"])
    y = moved_axis(g, b["y"])
    p = dot(x, e)
    s = dot(x, y)
    angle = math.atan2(s, p)
    if tangents != 0:
        size = p * p + s * s
        for k in range(2 * ROW):
            rows[k] = 0.0
        for k in range(3, 6):
            w = unit(k - 3)
            dx = cross(w, x)
            rows[k] = (p * dot(dx, y) - s * dot(dx, e)) / size
            rows[ROW + k] = (p * dot(x, cross(w, y)) - s * dot(x, cross(w, e))) / size
    rest, turns = turn_between(f, g, sense_of(f, g, b["j"]))
    n = (f["R"][0, 2], f["R"][1, 2], f["R"][2, 2])
    way = 1.0 if dot(n, cross(e, y)) > 0.0 else -1.0
    # the spins give the number of turns; atan2 gives the angle without them
    n_turns = math.floor((way * rest - angle + b["low"]) / TWO_PI + 0.5) + way * turns
    return angle + TWO_PI * n_turns


@kernel
def sense(b, f, g, rows, tangents):
    """Value of a kinematic sensor; rows (36) are written if tangents are requested."""
    op = b["op"]
    if op == ANGLE:
        return sense_angle(b, f, g, rows, tangents)
    if op == ANGULAR_VELOCITY or op == ANGULAR_ACCELERATION:
        return sense_spin(b, f, g, rows, tangents)
    return sense_way(b, f, g, rows, tangents)
