# SPDX-License-Identifier: Apache-2.0
"""Drive: constraint row for a prescribed joint coordinate.

It has a constant speed, a piecewise speed, an angle formula, or a speed that another program gives.

g = q - theta(t), with the time derivatives that explicit methods need; q is usually the spin of a body with
its whole turns. The observation is the torque or force of the drive on the coordinate.

A ripple is added to the prescribed angle phi(t): theta = phi + sum a_k sin(k phi + beta_k), with orders k of
the angle. Whole revolutions take the time of phi, so the mean speed is that without ripple.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.core.formula.kernel import evaluate_curvature
from pitchpoint.core.kernel import invoke, kernel, view
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.elements.kind import CONSTRAINT, DRIVE, FREE, Kind, Power
from pitchpoint.elements.ratio import SPIN
from pitchpoint.elements.signal import Pool, interval_of, law_call
from pitchpoint.elements.speed_profile import SpeedPieces
from pitchpoint.multibody.channels import F8, I8, constraint_args, constraint_rates, observations

TURN, TURN_REST = 6.283185303211212, 3.968374073792802e-09
"""2 pi as a sum of two parts, the first with 27 bits: exact product with the number of turns of a day."""
SPEED, SPEED_PIECES, ANGLE_FORMULA, RAMP, RATE = range(5)
"""Forms. RAMP: speed + gain (t - since), from `angle` at `since`. RATE: speed and its derivative without an
angle, for integrators of other programs, which are stabilised at the level of speeds."""
STENCIL = 1e-5
"""Step of the finite differences for the acceleration of an angle formula [s]: relative error 1e-6 for a
ripple of 1 kHz."""


RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("form", "i8"),
        ("dof_i", "i8"),  # first coordinate of the body and its spin; written by the layout
        ("spin_i", "i8"),
        ("q_i", "i8"),  # coordinate of the joint; SPIN: its spin
        ("linear", "i8"),  # 1: the coordinate is a length
        ("row", "i8"),  # constraint row; written by the layout
        ("angle", "f8"),  # spin at t = 0 [rad]
        ("speed", "f8"),  # SPEED, RAMP, RATE: [rad/s]
        ("since", "f8"),  # RAMP: start [s]
        ("gain", "f8"),  # RAMP, RATE: derivative of the speed [rad/s^2]
        ("pool", "i8"),
        ("start", "i8"),
        ("n", "i8"),  # pieces or programme words
        ("degree", "i8"),  # SPEED_PIECES: degree of the polynomials
        ("ripple", "i8"),  # offset in the pool of order, amplitude [rad] and phase [rad] by wave
        ("waves", "i8"),  # number of waves of the ripple
        ("out", "i8"),
    ],
    align=True,
)

OUTPUTS = (("torque", "N m", "torque of the drive on its body"),)


def outputs(record: np.void) -> tuple[tuple[str, str, str], ...]:
    """Observations of one record: a torque, or a force for a translation."""
    return (("force", "N", "force of the drive on its body"),) if record["linear"] else OUTPUTS


def set_speed_pieces(record: np.void, pool: Pool, pieces: SpeedPieces) -> None:
    """Prescribe a speed by piecewise polynomials; the angle is their exact integral."""
    record["form"], record["n"] = SPEED_PIECES, len(pieces.powers)
    record["degree"] = pieces.powers.shape[1] - 1
    record["start"] = pool.add(np.concatenate([pieces.edges, pieces.angles(), pieces.powers.ravel()]))


def set_angle_formula(record: np.void, pool: Pool, formula: object) -> None:
    """Prescribe the spin by a formula of t, added to the initial angle."""
    ops, room = formula.ops, formula.workspace()  # type: ignore[attr-defined]
    record["form"] = ANGLE_FORMULA
    record["start"], record["n"] = pool.add(ops.view(np.float64)), ops.size
    pool.add(room)


def set_ripple(record: np.void, pool: Pool, waves: ArrayLike) -> None:
    """Superimpose waves on the prescribed angle: order, amplitude [rad] and phase [rad], shape (n, 3)."""
    rows = np.asarray(waves, float).reshape(-1, 3)
    record["ripple"], record["waves"] = pool.add(rows), len(rows)


@kernel
def target(b, t):
    """Prescribed angle with its ripple, and its first two time derivatives."""
    phi, rate, second = _mean(b, t)
    if b["waves"] == 0:
        return phi, rate, second
    waves = view(b["pool"] + 8 * b["ripple"], (b["waves"], 3), F8)
    angle = phi
    slope = 1.0
    bend = 0.0
    for k in range(b["waves"]):
        order = waves[k, 0]
        s = waves[k, 1] * math.sin(order * phi + waves[k, 2])
        angle += s
        slope += order * waves[k, 1] * math.cos(order * phi + waves[k, 2])
        bend -= order * order * s
    return angle, slope * rate, slope * second + bend * rate * rate


@kernel
def _mean(b, t):
    """Prescribed angle without ripple, and its first two time derivatives."""
    n = b["n"]
    where = b["pool"] + 8 * b["start"]
    if b["form"] == SPEED_PIECES:
        most = b["degree"]
        edges = view(where, n + 1, F8)
        angles = view(where + 8 * (n + 1), n + 1, F8)
        powers = view(where + 16 * (n + 1), (n, most + 1), F8)
        low = interval_of(t, edges)
        half = 0.5 * (edges[low + 1] - edges[low])
        x = min(max((t - edges[low]) / half - 1.0, -1.0), 1.0)
        angle = 0.0
        speed = 0.0
        acceleration = 0.0
        for k in range(most, -1, -1):
            acceleration = acceleration * x + speed
            speed = speed * x + powers[low, k]
            angle += powers[low, k] / (k + 1) * (x ** (k + 1) - (-1.0) ** (k + 1))
        beyond = t - edges[low] - (x + 1.0) * half
        outside = t < edges[0] or t > edges[n]
        angle = angles[low] + half * angle + (speed * beyond if outside else 0.0)
        return b["angle"] + angle, speed, 0.0 if outside else acceleration / half
    if b["form"] == ANGLE_FORMULA:
        ops = view(where, n, I8)
        room = view(where + 8 * n, 1 << 20, F8)
        x, speed, acceleration = evaluate_curvature(ops, n, room, t, STENCIL)
        return b["angle"] + x, speed, acceleration
    if b["form"] == RAMP or b["form"] == RATE:
        x = t - b["since"]
        return b["angle"] + x * (b["speed"] + 0.5 * b["gain"] * x), b["speed"] + b["gain"] * x, b["gain"]
    return b["angle"] + b["speed"] * t, b["speed"], 0.0


@kernel
def target_entry(out, rec, n):
    """Targets of n drives; each row of `out` has the time as first value and is replaced by the target."""
    rows = view(out, (n, 3), F8)
    drives = view(rec, n, RECORD)
    for e in range(n):
        rows[e, 0], rows[e, 1], rows[e, 2] = target(drives[e], rows[e, 0])
    return OK


def target_of(record: np.void, t: float) -> tuple[float, float, float]:
    """Prescribed angle [rad], speed [rad/s] and acceleration [rad/s^2] of a drive at time t, for Python."""
    rec, out = np.array([record], RECORD), np.array([t, 0.0, 0.0])
    invoke(target_entry, out.ctypes.data, rec.ctypes.data, 1)
    return float(out[0]), float(out[1]), float(out[2])


@kernel
def drive(rec, ctl, fr, q, g, G):
    """Constraint rows of all drives, their time derivatives and torques."""
    c = ctl[0]
    v, gt, gtt, frames = constraint_rates(ctl)
    for e in range(rec.size):
        b = rec[e]
        r = b["row"]
        d = b["spin_i"] if b["q_i"] == SPIN else b["dof_i"] + b["q_i"]
        angle, speed, acceleration = target(b, c["t"])
        if not math.isfinite(angle + speed + acceleration):
            c["bad"] = e
            return NOT_FINITE
        if d == b["spin_i"]:
            # subtract the turns from the target: q plus the turns has the round-off of the full angle, which
            # after some seconds exceeds the tolerance of Newton's iteration
            turns = fr[b["i"]]["turns"]
            angle = (angle - turns * TURN) - turns * TURN_REST
        g[r] = 0.0 if b["form"] == RATE else q[d] - angle
        gt[r] = -speed
        gtt[r] = -acceleration
        G[r, d] = 1.0
        if c["out"] != 0:
            observations(ctl)[b["out"]] = -view(c["lam"], c["nc"], F8)[r]
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, q, g, G = constraint_args(ctl)
    return drive(view(rec, n, RECORD), c, fr, q, g, G)


KIND = Kind(
    name="drive",
    channel=CONSTRAINT,
    record=RECORD,
    entry=entry,
    outputs=outputs,
    rows=1,
    role=DRIVE,
    massless=True,
    spins=FREE,
    power=Power("torque[{}]", source="drive", where=lambda record: not record["linear"]),
    law_call=law_call,
)
