# SPDX-License-Identifier: Apache-2.0
"""Torsional Maxwell element: spring and damper in series between two bodies about their common axis.

The state is the torque T on body i. It is equal in both parts, and their speeds add up to the relative speed
w (see `torsion`):

    dT/dt = -k (w + T/d)

The counterpart along a line is `maxwell`. Body k is a hidden torsional body of polar inertia 1 kg m^2 on
ground; its spin rate is T in newton metres.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.kind import FRAME, FREE, WITH_STATE, Kind, Power
from pitchpoint.elements.torsion import (
    add_torque,
    common_axis,
    sense_of,
    speed_between,
    state_tangent,
    torque_tangent,
)
from pitchpoint.elements.wrench import spin_axis
from pitchpoint.multibody.channels import frame_args, observations

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj", "k", "ik", "ki", "jk", "kj", "kk")]
    + [
        ("stiffness", "f8"),  # of the spring [N m/rad]
        ("damping", "f8"),  # of the damper [N m s/rad]
        ("out", "i8"),
    ],
    align=True,
)

OUTPUTS = (("torque", "N m", "torque on the first body"),)


@kernel
def torsion_maxwell(rec, ctl, fr, kk):
    """Torques, rates of the states, tangents and observations."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        hidden = fr[b["k"]]
        sense = sense_of(f, g, b["j"])
        m = common_axis(f, g, sense)
        torque = hidden["spin"]
        add_torque(f, g, m, torque)
        n = spin_axis(hidden)
        k = b["stiffness"]
        rate = -k * (speed_between(f, g, m) + torque / b["damping"])
        for r in range(3):
            hidden["F"][3 + r] += rate * n[r]
        if c["jac"] != 0:
            torque_tangent(b, f, g, kk, ctl, m, sense, torque, 0.0, 0.0)
            state_tangent(b, f, g, kk, ctl, m, sense, n, (1.0, -k / b["damping"], -k))
        if c["out"] != 0:
            observations(ctl)[b["out"]] = torque
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return torsion_maxwell(view(rec, n, RECORD), c, fr, kk)


KIND = Kind(
    name="torsion_maxwell",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    pairs=WITH_STATE,
    spins=FREE,
    sections={"torsion_maxwells": "coil"},
    power=Power("torque[{}]", energy=lambda record, torque: 0.5 * torque**2 / float(record["stiffness"])),
)
