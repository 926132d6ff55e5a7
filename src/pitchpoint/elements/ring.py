# SPDX-License-Identifier: Apache-2.0
"""Kinematics of two bearing rings, one on each body, and wrenches and tangents of the forces between them.

A marker on body i (inner ring) and one on body j (outer ring) coincide as assembled; their third axis is that
of the bearing. With e_x, e_y, e_z the axes of marker j and n the third axis of marker i, the displacements
are

    U = (X, Y, Z, n_x, n_y, turn)

X, Y, Z of the inner centre relative to the outer one, the two tilts as components of n, and the rotation of
the inner ring about the axis, all in the axes of marker j. This rotation is the twist that remains after n is
rotated back to e_z; its gradient by a rotation of body i relative to j is (e_z + n)/(1 + e_z . n), the same
for both rings.

A bearing kind computes the forces f conjugate to U and the slopes K = -df/dU, D = -df/dU'; this module
converts them to wrenches and exact tangents. The wrenches are in equilibrium, and their power is f . U' for
displacements and tilts of any size.

Results have axes that coincide with those of marker j as assembled and do not spin with the outer ring: in a
planet they follow the carrier (`rest`).
"""

from __future__ import annotations

import math
from typing import Any

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.wrench import angular_velocity, origin, push, put, spin_axis, velocity
from pitchpoint.multibody.vectors import add, along, cross, dot, into_world, less, times, triple, unit

TWO_PI = 6.283185307179586
CLOSED = 1e-6
"""Interference of bearings whose clearance is removed, see `close_ring` [m]."""

RING: list[tuple[Any, ...]] = [
    ("p_i", "f8", 3),  # marker on the inner ring, from the origin of body i, axes of the body [m]
    ("p_j", "f8", 3),
    ("A_i", "f8", (3, 3)),  # axes of the marker in those of body i, columns
    ("A_j", "f8", (3, 3)),
    ("rest", "i8"),  # body whose frame R has the axes of the results, 0: those of marker j
    ("A_rest", "f8", (3, 3)),  # these axes in that frame, columns
    ("K", "f8", (6, 6)),  # scratch: stiffness -df/dU
    ("D", "f8", (6, 6)),  # scratch: damping -df/dU'
    ("x", "f8", 6),  # scratch: displacement or its change
    ("w", "f8", 6),  # scratch: rate or its change
    ("f", "f8", 6),  # scratch: force
    ("g", "f8", 6),  # scratch: change of force
]

RESULTANT_OUTPUTS = (
    ("bearing_force[{}.radial]", "N", "radial force on the body or inner ring"),
    ("bearing_force[{}.axial]", "N", "axial force on the body or inner ring"),
    ("bearing_force[{}.direction]", "rad", "direction of the radial force, from the x axis"),
)
RESULTANT_OF = {"radial": ("fx", "fy"), "direction": ("fx", "fy")}
"""Components of the resultants that have no derivative at zero force."""
OUTPUTS = (
    ("bearing_force[{}.fx]", "N", "force on the inner ring, axes of the outer ring without its spin, x"),
    ("bearing_force[{}.fy]", "N", "force on the inner ring, y"),
    ("bearing_force[{}.fz]", "N", "force on the inner ring, axial"),
    ("bearing_force[{}.mx]", "N m", "moment on the inner ring about its centre, x"),
    ("bearing_force[{}.my]", "N m", "moment on the inner ring, y"),
    ("bearing_force[{}.mz]", "N m", "moment on the inner ring about the axis"),
    *RESULTANT_OUTPUTS,
)
RESULTANTS = len(OUTPUTS)
"""Number of these observations; those of a kind follow."""


def close_ring(records: Any) -> None:
    """Replace the clearance of bearings by interference, in place.

    The inner ring is moved sideways by a tenth of it: the radial direction of a journal in the centre is not
    defined.
    """
    records["gap"] = -CLOSED
    records["p_i"] += 0.1 * CLOSED * records["A_i"][:, :, 0]


@kernel
def _axis(f, A, k):
    """Axis k of a marker in world components."""
    return into_world(f["S"], (A[0, k], A[1, k], A[2, k]))


@kernel
def _fill(x, a, tilt_x, tilt_y, turn):
    for r in range(3):
        x[r] = a[r]
    x[3] = tilt_x
    x[4] = tilt_y
    x[5] = turn


@kernel
def _sense(f, axis):
    """Sense of the spin of a body about a bearing axis: 1, -1, or 0 for a different axis."""
    along = dot(spin_axis(f), axis)
    return 1 if along > 0.7 else -1 if along < -0.7 else 0


@kernel
def whole_turns(f, g, j, line, turn):
    """Whole turns of the inner ring relative to the outer one, which make the wrapped `turn` continuous."""
    arm, reach, axes, n, h, y, spin = line
    si = _sense(f, n)
    sj = _sense(g, axes[2]) if j != 0 else 0
    counted = si * (f["phi"] + f["base"]) - sj * (g["phi"] + g["base"])
    turns = si * (f["turns"] + f["base_turns"]) - sj * (g["turns"] + g["base_turns"])
    return turns + math.floor((counted - turn) / TWO_PI + 0.5)


@kernel
def ring_motion(b, f, g):
    """Write the displacements U to the scratch x, the rates to w; returns `line` for the other functions.

    `line` has the arms of the inner centre about both origins, the axes of marker j, n, the gradient h of the
    rotation, the velocity of the inner centre relative to body j, and the relative angular velocity.
    """
    arm = into_world(f["S"], triple(b["p_i"], 0))
    reach = less(add(origin(f), arm), origin(g))
    A = b["A_j"]
    axes = (_axis(g, A, 0), _axis(g, A, 1), _axis(g, A, 2))
    c0 = _axis(f, b["A_i"], 0)
    c1 = _axis(f, b["A_i"], 1)
    n = _axis(f, b["A_i"], 2)
    h = times(1.0 / (1.0 + dot(axes[2], n)), add(axes[2], n))
    y = add(velocity(f), cross(angular_velocity(f), arm))
    y = less(less(y, velocity(g)), cross(angular_velocity(g), reach))
    spin = less(angular_velocity(f), angular_velocity(g))
    moved = cross(spin, n)
    turn = math.atan2(dot(axes[1], c0) - dot(axes[0], c1), dot(axes[0], c0) + dot(axes[1], c1))
    u = along(axes, less(reach, into_world(g["S"], triple(b["p_j"], 0))))
    _fill(b["x"], u, dot(axes[0], n), dot(axes[1], n), turn)
    _fill(b["w"], along(axes, y), dot(axes[0], moved), dot(axes[1], moved), dot(h, spin))
    return arm, reach, axes, n, h, y, spin


@kernel
def _force_and_couple(f, axes, n, h):
    """Force and couple on the inner ring about its centre, world axes, from the conjugate forces."""
    force = add(add(times(f[0], axes[0]), times(f[1], axes[1])), times(f[2], axes[2]))
    couple = add(times(f[3], cross(n, axes[0])), times(f[4], cross(n, axes[1])))
    return force, add(couple, times(f[5], h))


@kernel
def ring_forces(b, f, g, line):
    """Add the wrenches of the forces in the scratch f."""
    arm, reach, axes, n, h, y, spin = line
    force, couple = _force_and_couple(b["f"], axes, n, h)
    push(f, arm, force, couple, 1.0)
    push(g, reach, force, couple, -1.0)


@kernel
def ring_observations(b, fr, line, out):
    """Write force and moment on the inner ring in the axes of marker j without the spin of its body."""
    arm, reach, axes, n, h, y, spin = line
    force, couple = _force_and_couple(b["f"], axes, n, h)
    first = b["out"]
    for r in range(3):
        along = axes[r]
        if b["rest"] != 0:
            A = b["A_rest"]
            along = into_world(fr[b["rest"]]["R"], (A[0, r], A[1, r], A[2, r]))
        out[first + r] = dot(along, force)
        out[first + 3 + r] = dot(along, couple)
    put_resultants(out, first)


@kernel
def put_resultants(out, first):
    """Write radial force, axial force and direction of the radial force after the six components."""
    x = out[first]
    y = out[first + 1]
    out[first + 6] = math.sqrt(x * x + y * y)
    out[first + 7] = out[first + 2]
    out[first + 8] = math.atan2(y, x)


@kernel
def _column(b, f, g, line, side, c):
    """Changes of displacements and rates (in x and w) for motion c of one body at constant body velocities.

    Side 0 moves body i, 1 body j. Returns the changes of arm, reach, n and h. The change of the displacements
    is also the change of the rates for the same motion as a velocity.
    """
    arm, reach, axes, n, h, y, spin = line
    w = unit(c - 3)
    shift = unit(c)
    nothing = (0.0, 0.0, 0.0)
    moved = cross(spin, n)
    if side == 0:
        d_arm = cross(w, arm)
        d_reach = add(shift, d_arm)
        du = d_reach
        dy = less(cross(angular_velocity(f), d_arm), cross(angular_velocity(g), d_reach))
        dn = cross(w, n)
        swung = dn  # change of n relative to the axes of marker j
        d_moved = cross(spin, dn)
        dz = nothing
        turn = dot(h, w)
    else:
        d_arm = nothing
        d_reach = times(-1.0, shift)
        du = less(d_reach, cross(w, reach))
        dy = less(times(-1.0, cross(angular_velocity(g), d_reach)), cross(w, y))
        dn = nothing
        swung = times(-1.0, cross(w, n))
        d_moved = times(-1.0, cross(w, moved))
        dz = cross(w, axes[2])
        turn = -dot(h, w)
    stretch = dot(dz, n) + dot(axes[2], dn)
    dh = times(1.0 / (1.0 + dot(axes[2], n)), less(add(dz, dn), times(stretch, h)))
    _fill(b["x"], along(axes, du), dot(axes[0], swung), dot(axes[1], swung), turn)
    _fill(b["w"], along(axes, dy), dot(axes[0], d_moved), dot(axes[1], d_moved), dot(dh, spin))
    return d_arm, d_reach, dn, dh


@kernel
def ring_tangents(b, f, g, kk, ctl, line):
    """Add the exact tangents from the slopes K and D and the forces f in the scratch."""
    c = ctl[0]
    ck = c["ck"]
    cd = c["cd"]
    arm, reach, axes, n, h, y, spin = line
    F = b["f"]
    force, couple = _force_and_couple(F, axes, n, h)
    for side in range(2):
        if side == 1 and b["j"] == 0:
            break
        ki = kk[b["ii"]] if side == 0 else kk[b["ij"]]
        kj = kk[b["ji"]] if side == 0 else kk[b["jj"]]
        for k in range(6):
            d_arm, d_reach, dn, dh = _column(b, f, g, line, side, k)
            for r in range(6):
                s = 0.0
                for e in range(6):
                    s -= ck * (b["K"][r, e] * b["x"][e] + b["D"][r, e] * b["w"][e])
                    s -= cd * b["D"][r, e] * b["x"][e]
                b["g"][r] = s
            df, dm = _force_and_couple(b["g"], axes, n, h)
            more = add(times(F[3], cross(dn, axes[0])), times(F[4], cross(dn, axes[1])))
            more = add(more, times(F[5], dh))
            if side == 1:  # axes x and y rotate with body j
                w = unit(k - 3)
                df = add(df, times(ck, cross(w, force)))
                more = add(more, times(F[3], cross(n, cross(w, axes[0]))))
                more = add(more, times(F[4], cross(n, cross(w, axes[1]))))
            dm = add(dm, times(ck, more))
            put(ki, k, -1.0, df, add(dm, add(cross(arm, df), times(ck, cross(d_arm, force)))))
            put(kj, k, 1.0, df, add(dm, add(cross(reach, df), times(ck, cross(d_reach, force)))))
