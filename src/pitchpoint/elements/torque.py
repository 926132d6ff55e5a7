# SPDX-License-Identifier: Apache-2.0
"""Torque about the spin axis of a body: constant, table, formula or user law of time, angle and speed.

The reaction acts on body j (0 = ground); angle and speed are those of body i relative to body j about the
common axis of `torsion`, so that the power is torque times the speed in the law.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.kernel import invoke, kernel, view
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.elements.kind import FRAME, FREE, TORQUE, Kind, Power
from pitchpoint.elements.signal import CONSTANT, F8, SIGNAL, law_call, signal
from pitchpoint.elements.torsion import (
    add_torque,
    common_axis,
    sense_of,
    speed_between,
    torque_tangent,
    turn_between,
)
from pitchpoint.multibody.channels import frame_args, observations

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")] + SIGNAL + [("out", "i8")], align=True
)

OUTPUTS = (("torque", "N m", "torque of the load on its body"),)


@kernel(inline=True)
def torque(rec, ctl, fr, kk):
    """Torques, tangents and observations of all loads."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        value = b["value"]
        by_angle = 0.0
        by_speed = 0.0
        sense = sense_of(f, g, b["j"])
        m = common_axis(f, g, sense)
        if b["form"] != CONSTANT or b["ramp"] > 0.0:
            rest, turns = turn_between(f, g, sense)
            speed = speed_between(f, g, m)
            value, by_angle, by_speed = signal(b, c["t"], rest, turns, speed, c["jac"])
        if not math.isfinite(value):
            c["bad"] = e
            return NOT_FINITE
        add_torque(f, g, m, value)
        if c["jac"] != 0:
            torque_tangent(b, f, g, kk, ctl, m, sense, value, by_angle, by_speed)
        if c["out"] != 0:
            observations(ctl)[b["out"]] = value
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return torque(view(rec, n, RECORD), c, fr, kk)


@kernel
def values_entry(out, rec, n):
    """Values and slopes of one load; they replace its n times, angles and speeds in the rows of `out`."""
    rows = view(out, (n, 3), F8)
    b = view(rec, 1, RECORD)[0]
    for e in range(n):
        value, by_angle, by_speed = signal(b, rows[e, 0], rows[e, 1], 0, rows[e, 2], 1)
        rows[e, 0] = value
        rows[e, 1] = by_angle
        rows[e, 2] = by_speed
    return OK


def values_of(record: np.void, t: ArrayLike, angle: ArrayLike, speed: ArrayLike) -> NDArray[np.float64]:
    """Torque of a load [N m] at times [s], angles [rad] and speeds [rad/s] of equal shape (n,), for Python.

    Parameters
    ----------
    record
        Record of the load, from a system whose addresses are filled in.
    t, angle, speed
        Arguments of its law; the angle includes whole turns.
    """
    return slopes_of(record, t, angle, speed)[0]


def slopes_of(
    record: np.void, t: ArrayLike, angle: ArrayLike, speed: ArrayLike
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Torque of a load [N m] and its slopes over angle [N m/rad] and speed [N m s/rad], as in `values_of`."""
    rows = np.ascontiguousarray(np.stack(np.broadcast_arrays(t, angle, speed), axis=-1), float)
    rec = np.array([record], RECORD)
    invoke(values_entry, rows.ctypes.data, rec.ctypes.data, len(rows))
    value, by_angle, by_speed = rows.T.copy()
    return value, by_angle, by_speed


KIND = Kind(
    name="torque",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    role=TORQUE,
    massless=True,
    spins=FREE,
    sections={"loads": ""},
    names_modes=False,
    power=Power("torque[{}]", source="load"),
    law_call=law_call,
)
