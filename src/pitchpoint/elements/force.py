# SPDX-License-Identifier: Apache-2.0
"""Force and moment at a point of a body, in world or body axes, scaled by a signal.

The signal is a factor: constant, table, formula or user law of time, angle and speed, as for a torque (see
`torsion`). Components with different signals need one record each. The point is at z on the spin axis, plus p
in the axes of the body. The reaction acts on body j at the same point (0 = ground).
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.elements.kind import FORCE, FRAME, FREE, Kind
from pitchpoint.elements.signal import CONSTANT, SIGNAL, law_call, signal
from pitchpoint.elements.torsion import (
    common_axis,
    sense_of,
    speed_between,
    turn_between,
    turn_column,
)
from pitchpoint.elements.wrench import origin, push, put, spin_axis
from pitchpoint.multibody.channels import frame_args
from pitchpoint.multibody.vectors import add, cross, dot, less, times, triple, unit

WORLD, BODY = 0, 1

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + SIGNAL
    + [
        ("F", "f8", 6),  # force [N] and moment [N m] at a signal of 1, in the axes `axes`
        ("axes", "i8"),  # WORLD or BODY
        ("z", "f8"),  # point of application on the spin axis, from the origin [m]
        ("p", "f8", 3),  # additional offset, axes of the body [m]
        ("out", "i8"),
    ],
    align=True,
)


@kernel
def _from_body(f, a):
    """World components of a vector given in body axes; from R and phi, since S may be out of date."""
    c = math.cos(f["phi"])
    s = math.sin(f["phi"])
    x = c * a[0] - s * a[1]
    y = s * a[0] + c * a[1]
    R = f["R"]
    return (
        R[0, 0] * x + R[0, 1] * y + R[0, 2] * a[2],
        R[1, 0] * x + R[1, 1] * y + R[1, 2] * a[2],
        R[2, 0] * x + R[2, 1] * y + R[2, 2] * a[2],
    )


@kernel
def _tangents(b, f, g, kk, ctl, sense, place, load, slopes):
    """Add the tangents: rotation of the arm and of loads in body axes, slopes of the factor."""
    c = ctl[0]
    ck = c["ck"]
    arm, reach, m = place
    force, couple = load
    scale, by_angle, by_speed = slopes
    exact = 1 if c["jac"] == 2 else 0
    nothing = (0.0, 0.0, 0.0)
    for side in range(2):
        if side == 1 and b["j"] == 0:
            break
        ki = kk[b["ii"]] if side == 0 else kk[b["ij"]]
        kj = kk[b["ji"]] if side == 0 else kk[b["jj"]]
        for k in range(6):
            w = unit(k - 3)
            df = nothing
            dm = nothing
            d_arm = nothing
            d_reach = times(-1.0, unit(k))
            if side == 0:
                d_arm = cross(w, arm)
                d_reach = add(unit(k), d_arm)
                if b["axes"] == BODY:
                    df = times(ck * scale, cross(w, force))
                    dm = times(ck * scale, cross(w, couple))
            if k > 2 and (by_angle != 0.0 or by_speed != 0.0):
                angle, speed, swing = turn_column(f, g, sense, m, side, k - 3, exact)
                s = ck * (by_angle * angle + by_speed * speed)
                s += c["cd"] * by_speed * (dot(w, m) if side == 0 else -dot(w, m))
                df = add(df, times(s, force))
                dm = add(dm, times(s, couple))
            held = times(ck * scale, force)
            put(ki, k, -1.0, df, add(dm, add(cross(arm, df), cross(d_arm, held))))
            put(kj, k, 1.0, df, add(dm, add(cross(reach, df), cross(d_reach, held))))


@kernel
def force(rec, ctl, fr, kk):
    """Wrenches and tangents of all forces."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        sense = sense_of(f, g, b["j"])
        m = common_axis(f, g, sense)
        scale = b["value"]
        by_angle = 0.0
        by_speed = 0.0
        if b["form"] != CONSTANT or b["ramp"] > 0.0:
            rest, turns = turn_between(f, g, sense)
            speed = speed_between(f, g, m)
            scale, by_angle, by_speed = signal(b, c["t"], rest, turns, speed, c["jac"])
        if not math.isfinite(scale):
            c["bad"] = e
            return NOT_FINITE
        load = triple(b["F"], 0)
        couple = triple(b["F"], 3)
        if b["axes"] == BODY:
            load = _from_body(f, load)
            couple = _from_body(f, couple)
        arm = times(b["z"], spin_axis(f))
        p = b["p"]
        if p[0] != 0.0 or p[1] != 0.0 or p[2] != 0.0:
            arm = add(arm, _from_body(f, triple(p, 0)))
        reach = less(add(origin(f), arm), origin(g))
        push(f, arm, load, couple, scale)
        push(g, reach, load, couple, -scale)
        if c["jac"] != 0:
            _tangents(b, f, g, kk, ctl, sense, (arm, reach, m), (load, couple), (scale, by_angle, by_speed))
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return force(view(rec, n, RECORD), c, fr, kk)


KIND = Kind(
    name="force",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    role=FORCE,
    massless=True,
    spins=FREE,
    excites=False,
    sections={"loads": ""},
    names_modes=False,
    law_call=law_call,
)
