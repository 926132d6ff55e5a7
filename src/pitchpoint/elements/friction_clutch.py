# SPDX-License-Identifier: Apache-2.0
"""Clutch between two bodies or brake to ground: dry friction about their axis, with stick and slip.

The capacity C(t, angle, speed), a signal, is the torque of fast sliding and contains the engaging force or
pressure; zero means open. With the relative speed w about the common axis (see `torsion`) and the Stribeck
function g(w), 1 for fast sliding and `ratio` at rest:

REGULARISED  T = -C g(w) S(w/v_eps), S the smooth sign: simple, but creeps instead of sticking.
BRISTLE      T = -C (y + sigma y'), y' as in `pitchpoint.contact.bristle`: elastic until it slips, so that it
             sticks without creep. The deflection y is relative to the capacity, so an opening clutch releases
             its torque.
LOCKED       T = -C k (u - u0 + sigma u'), u the angle between the bodies: a bristle that does not yield, as a
             spring of stiffness C k, for `solvers.locked_clutches`.

Body k is the hidden torsional body of polar inertia 1 kg m^2 on ground with the spin rate y (ground if the
law is REGULARISED).
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.contact.bristle import bristle_rate, stribeck
from pitchpoint.contact.friction import coulomb
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.elements.kind import CLUTCH, FRAME, FREE, TOGETHER, WITH_STATE, Kind, Power
from pitchpoint.elements.signal import SIGNAL, signal
from pitchpoint.elements.torsion import (
    add_torque,
    common_axis,
    sense_of,
    speed_between,
    state_tangent,
    torque_tangent,
    turn_between,
)
from pitchpoint.elements.wrench import spin_axis
from pitchpoint.multibody.channels import bounded, events, frame_args, observations

TWO_PI = 6.283185307179586
STILL = 1e-3
"""Reverse slip over `v_eps` without a reversal event: hides round-off of a sticking clutch."""
REGULARISED, BRISTLE, LOCKED = 0, 1, 2


RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj", "k", "ik", "ki", "jk", "kj", "kk")]
    + SIGNAL  # torque capacity at fast sliding, >= 0 [N m]
    + [
        ("sticking", "i8"),  # REGULARISED, BRISTLE or LOCKED
        ("ratio", "f8"),  # static over dynamic friction, >= 1
        ("v_s", "f8"),  # Stribeck speed [rad/s]
        ("v_eps", "f8"),  # REGULARISED: speed of full friction [rad/s]
        ("stiffness", "f8"),  # BRISTLE: torque per angle before slip over capacity [1/rad]
        ("onset", "f8"),  # BRISTLE: fraction of the capacity below which there is no slip, < 1
        ("u0", "f8"),  # LOCKED: angle at zero torque [rad]
        ("sigma", "f8"),  # BRISTLE: damping of the bristles over the stiffness, as a time [s]
        ("ev", "i8"),
        ("out", "i8"),
    ],
    align=True,
)

EVENTS = (
    ("slip_reversal", "the slip of a clutch or brake changes its sign"),
    ("slip", "a clutch or brake starts to slip or sticks"),
)

OUTPUTS = (
    ("torque", "N m", "friction torque on the first body"),
    ("slip_speed", "rad/s", "speed of the first body relative to the second"),
    ("friction_power", "W", "friction power loss"),
)


@kernel
def _side(y, onset):
    """Direction of the last slip from the bristle deflection: -1 after backward slip, else 1.

    It gives the event function of a sticking clutch a constant sign, loaded or not; continuous between -0.95
    and -1.05 of the onset.
    """
    x = y / max(onset, 1e-6)
    return min(max(20.0 * (x + 1.0), -1.0), 1.0)


@kernel
def friction_clutch(rec, ctl, fr, kk):
    """Torques, rates of the states, tangents and observations of all clutches."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        sense = sense_of(f, g, b["j"])
        m = common_axis(f, g, sense)
        rest, turns = turn_between(f, g, sense)
        speed = speed_between(f, g, m)
        capacity, by_angle, by_speed = signal(b, c["t"], rest, turns, speed, c["jac"])
        if not math.isfinite(capacity):
            c["bad"] = e
            return NOT_FINITE
        if capacity < 0.0:
            capacity = 0.0
            by_angle = 0.0
            by_speed = 0.0
        steady, slope = stribeck(speed, b["ratio"], b["v_s"])
        hidden = fr[b["k"]]
        n = spin_axis(hidden)
        by_state = 0.0
        part_by_angle = 0.0
        rate_by_state = 0.0
        rate_by_speed = 0.0
        if b["sticking"] == BRISTLE:
            y = hidden["spin"]
            rate, rate_by_state, rate_by_speed = bristle_rate(
                y, speed, steady, slope, b["stiffness"], b["onset"]
            )
            for r in range(3):
                hidden["F"][3 + r] += rate * n[r]
            part = -(y + b["sigma"] * rate)
            by_state = -capacity * (1.0 + b["sigma"] * rate_by_state)
            part_by_speed = -b["sigma"] * rate_by_speed
        elif b["sticking"] == LOCKED:
            part = -b["stiffness"] * (rest - b["u0"] + TWO_PI * turns + b["sigma"] * speed)
            part_by_angle = -b["stiffness"]
            part_by_speed = -b["stiffness"] * b["sigma"]
        else:
            sign, rise = coulomb(speed, b["v_eps"])
            part = -steady * sign
            part_by_speed = -(steady * rise + slope * sign)
        torque = capacity * part
        add_torque(f, g, m, torque)
        if c["jac"] != 0:
            over_speed = by_speed * part + capacity * part_by_speed
            over_angle = by_angle * part + capacity * part_by_angle
            torque_tangent(b, f, g, kk, ctl, m, sense, torque, over_angle, over_speed)
            if b["sticking"] == BRISTLE:
                state_tangent(b, f, g, kk, ctl, m, sense, n, (by_state, rate_by_state, rate_by_speed))
        if c["ev"] != 0:
            beyond = abs(speed) - b["v_eps"]
            side = 1.0
            if b["sticking"] == BRISTLE:
                y = hidden["spin"]
                beyond = abs(y) - b["onset"]
                side = _side(y, b["onset"])
            ev = events(ctl)
            ev[b["ev"]] = bounded(speed + STILL * b["v_eps"] * side)
            ev[b["ev"] + 1] = bounded(beyond)
        if c["out"] != 0:
            out = observations(ctl)
            out[b["out"]] = torque
            out[b["out"] + 1] = speed
            out[b["out"] + 2] = -torque * speed
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return friction_clutch(view(rec, n, RECORD), c, fr, kk)


def _spins(record: np.void) -> str:
    """Locked, it couples the rotations of its bodies."""
    return TOGETHER if record["sticking"] == LOCKED else FREE


KIND = Kind(
    name="friction_clutch",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    pairs=WITH_STATE,
    events=EVENTS,
    role=CLUTCH,
    spins=_spins,
    sections={"clutches": "discs"},
    power=Power("torque[{}]", loss="friction"),
)
