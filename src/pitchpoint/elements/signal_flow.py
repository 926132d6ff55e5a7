# SPDX-License-Identifier: Apache-2.0
"""Signals: sensors, blocks and actuators of a control system, evaluated in the order of their records.

A controller state is the spin rate of a hidden body of polar inertia 1 kg m^2, so that every integrator,
equilibrium and linearisation includes it. Tangents follow from the chain rule, from every source (sensor or
state) through all blocks to every actuator: the derivatives W of each signal by the sources are computed with
the values, and link records multiply them into the pair tangents of the bodies at both ends. They are exact
except for loads (reactions, observations of other elements), whose derivatives are unknown and neglected.

The kind *signal_flow* runs with the forces; *signal_of_loads*, the same code, after all of them.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from pitchpoint.core.formula.kernel import evaluate_slope
from pitchpoint.core.kernel import call_law, kernel, view
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.elements.kind import FRAME, FREE, SIGNAL, Kind, Power
from pitchpoint.elements.signal import interpolate
from pitchpoint.elements.signals.actuators import act
from pitchpoint.elements.signals.record import (
    ANGULAR_ACCELERATION,
    CHANNEL,
    FORCE,
    FORMULA,
    HELD,
    LINEAR,
    LINK,
    REACTION_FORCE,
    RECORD,
    ROW,
    SATURATION,
    STATE,
    STRUT,
    TABLE,
    TIME,
    TORQUE,
    UNITS,
)
from pitchpoint.elements.signals.sensors import sense
from pitchpoint.elements.wrench import spin_axis
from pitchpoint.multibody.channels import F8, I8, frame_args, observations
from pitchpoint.multibody.vectors import add, cross, dot, less, moved_axis, triple

__all__ = ["KIND", "RECORD"]


def outputs(record: np.void) -> tuple[tuple[str, str, str], ...]:
    """Observation of one record; links have none."""
    return () if record["op"] == LINK else (("signal", UNITS[record["unit"]] or "1", "value of a signal"),)


@kernel
def _reaction(b, fr):
    """Joint reaction on body i, moments about a point of it: component along an axis fixed to body j."""
    beyond = view(b["pool"] + 8 * b["start"], b["n"], F8)
    place = add(triple(fr[b["i"]]["r"], 0), moved_axis(fr[b["i"]], b["p_i"]))
    force = (0.0, 0.0, 0.0)
    moment = (0.0, 0.0, 0.0)
    for k in range(beyond.size):
        f = fr[int(beyond[k])]
        own = triple(f["F"], 0)
        force = add(force, own)
        moment = add(moment, add(triple(f["F"], 3), cross(less(triple(f["r"], 0), place), own)))
    axis = moved_axis(fr[b["j"]], b["e"])
    return -dot(axis, force) if b["op"] == REACTION_FORCE else -dot(axis, moment)


@kernel
def _source(b, fr, ctl, V, W, rows, tangents):
    """Value of a sensor or state and its derivatives by the motion of its bodies."""
    op = b["op"]
    value = V[b["slot"]]
    if tangents != 0:
        for s in range(b["sources"]):
            W[b["slot"], s] = 1.0 if s == b["source"] else 0.0
        for k in range(2 * ROW):
            rows[k] = 0.0
    if op == STATE:
        f = fr[b["i"]]
        n = spin_axis(f)
        if tangents != 0:
            for k in range(3):
                rows[9 + k] = n[k]
        return f["spin"]
    if op <= ANGULAR_ACCELERATION:
        return sense(b, fr[b["i"]], fr[b["j"]], rows, tangents)
    if op == CHANNEL:
        # without observations the last value is used
        return observations(ctl)[b["channel"]] if ctl[0]["out"] != 0 else value
    return _reaction(b, fr)


@kernel
def _follow(b, W, source, slope):
    """Add `slope` times the derivatives of signal `source` to those of the signal of `b`."""
    for s in range(b["sources"]):
        W[b["slot"], s] += slope * W[source, s]


@kernel
def _formula(b, t, V, W, tangents):
    """Value of a formula of up to three signals, one of which may be the time."""
    n = b["n"]
    where = b["pool"] + 8 * b["start"]
    ops = view(where, n, I8)
    room = view(where + 8 * n, 1 << 20, F8)  # upper bound; the programme uses only its own workspace
    x0 = V[b["a"]] if b["a"] >= 0 else t if b["a"] == TIME else 0.0
    x1 = V[b["b"]] if b["b"] >= 0 else t if b["b"] == TIME else 0.0
    x2 = V[b["c"]] if b["c"] >= 0 else t if b["c"] == TIME else 0.0
    value, slope = evaluate_slope(ops, n, room, x0, x1, x2, -1)
    if tangents != 0:
        for k in range(3):
            source = b["a"] if k == 0 else b["b"] if k == 1 else b["c"]
            if source >= 0:
                value, slope = evaluate_slope(ops, n, room, x0, x1, x2, k)
                _follow(b, W, source, slope)
    return value


@kernel
def _block(b, t, V, W, tangents):
    """Value of a block and its derivatives by the sources."""
    op = b["op"]
    where = b["pool"] + 8 * b["start"]
    if tangents != 0:
        for s in range(b["sources"]):
            W[b["slot"], s] = 0.0
    if op == LINEAR:
        n = b["n"]
        terms = view(where, (n, 2), F8)
        value = b["value"]
        for k in range(n):
            value += terms[k, 1] * V[int(terms[k, 0])]
            if tangents != 0:
                _follow(b, W, int(terms[k, 0]), terms[k, 1])
        return value
    if op == HELD:
        return view(where, 1, F8)[0]
    if op == FORMULA:
        return _formula(b, t, V, W, tangents)
    x = V[b["a"]]
    slope = 0.0
    value = x
    if op == SATURATION:
        slope = 1.0
        if x <= b["low"] or x >= b["high"]:
            slope = 0.0
            value = b["low"] if x <= b["low"] else b["high"]
        if math.isnan(x):
            value = x
    elif op == TABLE:
        n = b["n"]
        value, slope = interpolate(x, view(where, n, F8), view(where + 8 * n, n, F8))
    else:
        value = call_law(b["law"], t, x, where)
        if tangents != 0:
            h = 1e-6 * max(1.0, abs(x))
            slope = (call_law(b["law"], t, x + h, where) - call_law(b["law"], t, x - h, where)) / (2.0 * h)
    if tangents != 0:
        _follow(b, W, b["a"], slope)
    return value


@kernel
def _link(b, kk, ctl):
    """Add the tangent of an actuator on body i by the motion of body j, through one source."""
    c = ctl[0]
    pool = b["pool"]
    weight = view(pool + 8 * b["c"], 1, F8)[0]
    if weight == 0.0:
        return
    wrench = view(pool + 8 * b["a"], 6, F8)
    row = view(pool + 8 * b["b"], ROW, F8)
    k = kk[b["ij"]]
    for m in range(6):
        s = weight * (c["ck"] * row[m] + c["cd"] * row[6 + m] + c["cm"] * row[12 + m])
        if s != 0.0:
            for r in range(6):
                k[r, m] -= s * wrench[r]


@kernel
def flow(rec, ctl, fr, kk):
    """Values of all signals, wrenches and tangents of the actuators, observations."""
    c = ctl[0]
    tangents = 1 if c["jac"] != 0 or c["cm"] != 0.0 else 0
    if rec.size == 0:
        return OK
    pool = rec[0]["pool"]
    nodes = rec[0]["nodes"]
    sources = rec[0]["sources"]
    V = view(pool, nodes, F8)
    W = view(pool + 8 * nodes, (nodes, sources), F8)
    rows = view(pool + 8 * nodes * (1 + sources), (sources, 2 * ROW), F8)
    for e in range(rec.size):
        b = rec[e]
        op = b["op"]
        if op == LINK:
            if tangents != 0:
                _link(b, kk, ctl)
            continue
        if op < LINEAR:
            value = _source(b, fr, ctl, V, W, rows[b["source"]], tangents)
        elif op < TORQUE:
            value = _block(b, c["t"], V, W, tangents)
        else:
            value = V[b["a"]]
            wrench = view(b["pool"] + 8 * b["start"], 12, F8)
            act(b, fr, kk, ctl, value, wrench, 1 if c["jac"] != 0 else 0)
        if not math.isfinite(value):
            c["bad"] = e
            return NOT_FINITE
        V[b["slot"]] = value
        if c["out"] != 0:
            observations(ctl)[b["out"]] = value
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return flow(view(rec, n, RECORD), c, fr, kk)


def law_call(record: np.void, frames: Any, pool: Any, t: float) -> tuple[float, int, int]:
    """Input signal and parameters of the user law of a block."""
    return float(pool[int(record["a"])]), int(record["start"]), int(record["n"])


def _turns(record: np.void) -> bool:
    """Whether this is the actuator of a torque about the axis of its body."""
    return bool(record["op"] == TORQUE)


def _pushes(record: np.void) -> bool:
    """Whether this is the actuator of a force or of a moment of fixed direction."""
    return bool(record["op"] in (STRUT, FORCE))


KIND = Kind(
    name="signal_flow",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=outputs,
    body_fixed=True,
    role=SIGNAL,
    spins=FREE,
    sections={"sensors": "", "blocks": "", "controllers": "", "actuators": ""},
    title="signal",
    power=Power("signal[{}]", source="actuator", where=_turns, unknown=_pushes),
    law_call=law_call,
)
