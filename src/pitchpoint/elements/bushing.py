# SPDX-License-Identifier: Apache-2.0
"""Elastic bushing: a 6 x 6 spring and damper between two body-fixed markers, for large rotations.

Displacement u and rotation vector s of marker i relative to marker j, in the axes of marker j. With
x = (u, s) - x0 and its time derivative x', the generalised force is

    f = -K x - D x'

The wrenches are conjugate to x: the power on both bodies is f . x', so K stores and D dissipates energy
exactly, for any rotation. The rotation is limited to half a turn; beyond it, the rotation vector jumps to the
shorter rotation of opposite sense. For springs about a spin axis over many turns use `coupling`.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.kind import FRAME, Kind
from pitchpoint.elements.rotation_vector import by_turn, by_turn_change, rotation_vector
from pitchpoint.elements.wrench import angular_velocity, origin, push, put, velocity
from pitchpoint.multibody.channels import frame_args, observations
from pitchpoint.multibody.vectors import add, along, cross, dot, into_world, less, times, triple, unit

SOFT = 1e-9
"""Ratio of stiffness about the axis to largest stiffness below which the ends rotate freely [1]."""
RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("p_i", "f8", 3),  # marker on body i from its origin, axes of the body [m]
        ("p_j", "f8", 3),
        ("A_i", "f8", (3, 3)),  # axes of the marker in those of body i, columns
        ("A_j", "f8", (3, 3)),
        ("K", "f8", (6, 6)),  # stiffness [N/m, N/rad, N m/m, N m/rad]
        ("D", "f8", (6, 6)),  # damping, likewise per second
        ("x0", "f8", 6),  # displacement at zero force [m, rad]
        ("x", "f8", 6),  # scratch: displacement or its change
        ("w", "f8", 6),  # scratch: rate or its change
        ("f", "f8", 6),  # scratch: force
        ("g", "f8", 6),  # scratch: change of force
        ("out", "i8"),
    ],
    align=True,
)

OUTPUTS = (
    ("bushing_force[{}.fx]", "N", "force on the first body, axes of the second marker, x"),
    ("bushing_force[{}.fy]", "N", "force on the first body, y"),
    ("bushing_force[{}.fz]", "N", "force on the first body, z"),
    ("bushing_force[{}.mx]", "N m", "moment on the first body about its marker, x"),
    ("bushing_force[{}.my]", "N m", "moment on the first body, y"),
    ("bushing_force[{}.mz]", "N m", "moment on the first body, z"),
)


def defaults(record: np.void) -> None:
    """Set the marker axes of a new record to those of the bodies."""
    record["A_i"] = record["A_j"] = np.eye(3)


@kernel
def _axes(f, A):
    """World components of the three axes of a marker."""
    return (
        into_world(f["S"], (A[0, 0], A[1, 0], A[2, 0])),
        into_world(f["S"], (A[0, 1], A[1, 1], A[2, 1])),
        into_world(f["S"], (A[0, 2], A[1, 2], A[2, 2])),
    )


@kernel
def _out_of(axes, a):
    """Vector from its components along three axes."""
    return add(add(times(a[0], axes[0]), times(a[1], axes[1])), times(a[2], axes[2]))


@kernel
def _join(x, a, b):
    for r in range(3):
        x[r] = a[r]
        x[3 + r] = b[r]


@kernel
def _respond(K, D, x, w, f):
    """f = -K x - D w."""
    for r in range(6):
        s = 0.0
        for h in range(6):
            s -= K[r, h] * x[h] + D[r, h] * w[h]
        f[r] = s


@kernel
def _kinematics(b, f, g):
    """Arms of marker i about both origins, axes of marker j, rotation vector, relative velocities in world
    axes; writes displacement and rate to the scratch x and w."""
    arm = into_world(f["S"], triple(b["p_i"], 0))
    reach = less(add(origin(f), arm), origin(g))
    axes = _axes(g, b["A_j"])
    c0, c1, c2 = _axes(f, b["A_i"])
    rows = (
        (dot(axes[0], c0), dot(axes[0], c1), dot(axes[0], c2)),
        (dot(axes[1], c0), dot(axes[1], c1), dot(axes[1], c2)),
        (dot(axes[2], c0), dot(axes[2], c1), dot(axes[2], c2)),
    )
    s = rotation_vector(rows)
    y = add(velocity(f), cross(angular_velocity(f), arm))
    y = less(less(y, velocity(g)), cross(angular_velocity(g), reach))
    turn = less(angular_velocity(f), angular_velocity(g))
    _join(b["x"], along(axes, less(reach, into_world(g["S"], triple(b["p_j"], 0)))), s)
    _join(b["w"], along(axes, y), by_turn(s, along(axes, turn), -1.0))
    for r in range(6):
        b["x"][r] -= b["x0"][r]
    return arm, reach, axes, s, y, turn


@kernel
def _column(b, f, g, line, side, c):
    """Changes of displacement and rate (in x and w), of both arms and of the rotation vector for motion c.

    Side 0 moves body i, 1 body j, at constant body velocities. The change of the displacement is also the
    change of the rate for the same motion as a velocity.
    """
    arm, reach, axes, s, y, turn = line
    shift = unit(c)
    w = unit(c - 3)
    if side == 0:
        d_arm = cross(w, arm)
        d_reach = add(shift, d_arm)
        du = d_reach
        dy = less(cross(angular_velocity(f), d_arm), cross(angular_velocity(g), d_reach))
        p = along(axes, w)
        spun = (0.0, 0.0, 0.0)
    else:
        d_arm = (0.0, 0.0, 0.0)
        d_reach = times(-1.0, shift)
        du = less(d_reach, cross(w, reach))
        dy = less(times(-1.0, cross(angular_velocity(g), d_reach)), cross(w, y))
        p = times(-1.0, along(axes, w))
        spun = times(-1.0, along(axes, cross(w, turn)))
    ds = by_turn(s, p, -1.0)
    _join(b["x"], along(axes, du), ds)
    d_rate = add(by_turn_change(s, ds, along(axes, turn), -1.0), by_turn(s, spun, -1.0))
    _join(b["w"], along(axes, dy), d_rate)
    return d_arm, d_reach, ds


@kernel
def _tangents(b, f, g, kk, ctl, line):
    """Add the exact tangents; the scratch f holds the force on body i in the axes of marker j."""
    c = ctl[0]
    ck = c["ck"]
    cd = c["cd"]
    arm, reach, axes, s, y, turn = line
    force = _out_of(axes, triple(b["f"], 0))
    own = triple(b["f"], 3)
    couple = _out_of(axes, by_turn(s, own, 1.0))
    for side in range(2):
        if side == 1 and b["j"] == 0:
            break
        ki = kk[b["ii"]] if side == 0 else kk[b["ij"]]
        kj = kk[b["ji"]] if side == 0 else kk[b["jj"]]
        for k in range(6):
            d_arm, d_reach, ds = _column(b, f, g, line, side, k)
            for r in range(6):  # as a displacement ck, as a velocity cd
                b["w"][r] = ck * b["w"][r] + cd * b["x"][r]
                b["x"][r] *= ck
            _respond(b["K"], b["D"], b["x"], b["w"], b["g"])
            df = _out_of(axes, triple(b["g"], 0))
            dm = by_turn(s, triple(b["g"], 3), 1.0)
            dm = _out_of(axes, add(dm, times(ck, by_turn_change(s, ds, own, 1.0))))
            if side == 1:
                w = unit(k - 3)
                df = add(df, times(ck, cross(w, force)))
                dm = add(dm, times(ck, cross(w, couple)))
            put(ki, k, -1.0, df, add(dm, add(cross(arm, df), times(ck, cross(d_arm, force)))))
            put(kj, k, 1.0, df, add(dm, add(cross(reach, df), times(ck, cross(d_reach, force)))))


@kernel
def bushing(rec, ctl, fr, kk):
    """Wrenches, tangents and observations of all bushings."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        line = _kinematics(b, f, g)
        arm, reach, axes, s, y, turn = line
        _respond(b["K"], b["D"], b["x"], b["w"], b["f"])
        force = _out_of(axes, triple(b["f"], 0))
        moment = by_turn(s, triple(b["f"], 3), 1.0)
        couple = _out_of(axes, moment)
        push(f, arm, force, couple, 1.0)
        push(g, reach, force, couple, -1.0)
        if c["out"] != 0:
            out = observations(ctl)
            for r in range(3):
                out[b["out"] + r] = b["f"][r]
                out[b["out"] + 3 + r] = moment[r]
        if c["jac"] != 0:
            _tangents(b, f, g, kk, ctl, line)
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return bushing(view(rec, n, RECORD), c, fr, kk)


def _lets_turn(record: np.void) -> tuple[str, ...]:
    """Ends whose body can rotate about its axis because the bushing has no stiffness about it."""
    axis = np.array([0.0, 0.0, 1.0])
    K = record["K"] + record["K"].T
    found = []
    for end in "ij":
        A = record[f"A_{end}"]
        x = np.concatenate([A.T @ np.cross(axis, record[f"p_{end}"]), A.T @ axis])
        if np.abs(K @ x).max() <= SOFT * np.abs(K).max():
            found.append(end)
    return tuple(found)


KIND = Kind(
    name="bushing",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    body_fixed=True,
    massless=True,
    lets_turn=_lets_turn,
    linear=True,
    excites=False,
    sections={"bushings": "bushing"},
)
