# SPDX-License-Identifier: Apache-2.0
"""Torsional coupling or torsion spring between two bodies (body 0 = ground).

    T = -k x(u) - d w + L(t, u, w)

u is the angle of body i relative to body j less the angle at zero torque, w the relative speed, x(u) = u or,
with a gap, the part of u beyond +-gap/2. L is a signal: a table, a formula (`angle` is u, `speed` is w) or a
user law; a table over one revolution subtracts whole turns exactly. For bodies on spinning parents, tilted
bodies and bodies that rotate in opposite senses, `torsion` defines angle, speed and axis of the torque.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.elements.kind import FRAME, TOGETHER, Kind, Power
from pitchpoint.elements.signal import CONSTANT, SIGNAL, signal
from pitchpoint.elements.torsion import (
    add_torque,
    common_axis,
    sense_of,
    speed_between,
    torque_tangent,
    turn_between,
)
from pitchpoint.multibody.channels import frame_args, observations

TWO_PI = 6.283185307179586


RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("k", "f8"),  # stiffness [N m/rad]
        ("d", "f8"),  # damping [N m s/rad]
        ("u0", "f8"),  # angle at zero torque [rad]
        ("gap", "f8"),  # total backlash [rad]
    ]
    + SIGNAL  # additional torque on body i, function of t, u and w [N m]
    + [("out", "i8")],
    align=True,
)

OUTPUTS = (
    ("torque", "N m", "torque on the first body"),
    ("twist", "rad", "angle of the first body relative to the second"),
)


@kernel
def coupling(rec, ctl, fr, kk):
    """Torques, tangents and observations of all couplings."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        sense = sense_of(f, g, b["j"])
        m = common_axis(f, g, sense)
        rest, turns = turn_between(f, g, sense)
        speed = speed_between(f, g, m)
        rest -= b["u0"]
        u = rest + TWO_PI * turns
        k = b["k"]
        half = 0.5 * b["gap"]
        x = u
        if half > 0.0:
            if u > half:
                x = u - half
            elif u < -half:
                x = u + half
            else:
                x = 0.0
                k = 0.0
        torque = -k * x - b["d"] * speed
        by_angle = -k
        by_speed = -b["d"]
        if b["form"] != CONSTANT or b["value"] != 0.0:
            more, slope, rate = signal(b, c["t"], rest, turns, speed, c["jac"])
            if not math.isfinite(more):
                c["bad"] = e
                return NOT_FINITE
            torque += more
            by_angle += slope
            by_speed += rate
        add_torque(f, g, m, torque)
        if c["jac"] != 0:
            torque_tangent(b, f, g, kk, ctl, m, sense, torque, by_angle, by_speed)
        if c["out"] != 0:
            out = observations(ctl)
            out[b["out"]] = torque
            out[b["out"] + 1] = u
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return coupling(view(rec, n, RECORD), c, fr, kk)


def _linear(record: np.void, spinning: bool) -> bool:
    """Linear without backlash and without an additional law."""
    return bool(record["gap"] == 0.0 and record["form"] == CONSTANT)


KIND = Kind(
    name="coupling",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    massless=True,
    spins=TOGETHER,
    linear=_linear,
    excites=False,
    sections={"torsion_springs": "coil"},
    main=True,
    power=Power("torque[{}]"),
)
