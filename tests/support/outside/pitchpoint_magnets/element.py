# SPDX-License-Identifier: Apache-2.0
"""Element: the magnets of two rotors pull each other into line, eddy currents brake their slip.

The torque on body i is -k u - d w, u being the angle of body i against body j and w its rate.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.kind import FRAME, TOGETHER, Kind, Power
from pitchpoint.elements.torsion import (
    add_torque,
    common_axis,
    sense_of,
    speed_between,
    torque_tangent,
    turn_between,
)
from pitchpoint.multibody.channels import frame_args, observations

TURN = 6.283185307179586
RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("stiffness", "f8"),  # [N m/rad]
        ("damping", "f8"),  # [N m s/rad]
        ("out", "i8"),
    ],
    align=True,
)
OUTPUTS = (("torque", "N m", "torque on the first body"),)


@kernel
def magnet_coupling(rec, ctl, fr, kk):
    """Torques, tangents and observations of all magnetic couplings."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        sense = sense_of(f, g, b["j"])
        m = common_axis(f, g, sense)
        rest, turns = turn_between(f, g, sense)
        k, d = b["stiffness"], b["damping"]
        torque = -k * (rest + TURN * turns) - d * speed_between(f, g, m)
        add_torque(f, g, m, torque)
        if c["jac"] != 0:
            torque_tangent(b, f, g, kk, ctl, m, sense, torque, -k, -d)
        if c["out"] != 0:
            observations(ctl)[b["out"]] = torque
    return OK


@kernel
def entry(ctl, rec, n):
    """Uniform entry of the kind."""
    c, fr, kk = frame_args(ctl)
    return magnet_coupling(view(rec, n, RECORD), c, fr, kk)


KIND = Kind(
    name="magnet_coupling",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    massless=True,
    spins=TOGETHER,
    linear=True,
    sections={"magnet_couplings": "discs"},
    plural="magnetic couplings",
    power=Power("torque[{}]", loss="damping"),
)
