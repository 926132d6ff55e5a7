# SPDX-License-Identifier: Apache-2.0
"""Prescribed spin of a body: constant speed, speed table or angle formula, as a constraint row.

g = spin - theta(t), with the time derivatives that explicit methods need. The observation is the torque that
the drive puts on the spin.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.core.formula_kernel import evaluate_slope
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.signal import Pool
from pitchpoint.multibody.channels import F8, I8, constraint_args, constraint_rates, observations

TWO_PI = 6.283185307179586
SPEED, SPEED_TABLE, ANGLE_FORMULA = 0, 1, 2
ROWS = 1

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("form", "i8"),  # SPEED, SPEED_TABLE or ANGLE_FORMULA
        ("spin_i", "i8"),  # coordinate; written by the layout
        ("row", "i8"),  # constraint row; written by the layout
        ("angle", "f8"),  # spin at t = 0 [rad]
        ("speed", "f8"),  # SPEED: [rad/s]
        ("pool", "i8"),
        ("start", "i8"),
        ("n", "i8"),
        ("out", "i8"),
    ],
    align=True,
)

OUTPUTS = (("torque", "N m", "torque of the drive on its body"),)


def set_speed_table(record: np.void, pool: Pool, times: ArrayLike, speeds: ArrayLike) -> None:
    """Prescribe a speed by a table over time; the angle is its exact integral, quadratic between points."""
    t, w = np.asarray(times, float), np.asarray(speeds, float)
    if t.ndim != 1 or t.shape != w.shape or t.size < 2 or np.any(np.diff(t) <= 0.0):
        raise ValueError("a speed table needs at least two points with increasing time")
    angle = np.concatenate([[0.0], np.cumsum(0.5 * (w[1:] + w[:-1]) * np.diff(t))])
    angle -= _at_zero(t, w, angle)
    record["form"] = SPEED_TABLE
    record["start"], record["n"] = pool.add(np.concatenate([t, w, angle])), t.size


def _at_zero(t: np.ndarray, w: np.ndarray, angle: np.ndarray) -> float:
    if t[0] >= 0.0:
        return float(angle[0] - w[0] * t[0])
    k = min(int(np.searchsorted(t, 0.0, side="right")) - 1, t.size - 2)
    slope = (w[k + 1] - w[k]) / (t[k + 1] - t[k])
    return float(angle[k] + w[k] * -t[k] + 0.5 * slope * t[k] ** 2)


def set_angle_formula(record: np.void, pool: Pool, formula: object) -> None:
    """Prescribe the spin by a formula of t, added to the initial angle."""
    ops, room = formula.ops, formula.workspace()  # type: ignore[attr-defined]
    record["form"] = ANGLE_FORMULA
    record["start"], record["n"] = pool.add(ops.view(np.float64)), ops.size
    pool.add(room)


@kernel
def target(b, t):
    """Prescribed angle and its first two derivatives by time."""
    n = b["n"]
    where = b["pool"] + 8 * b["start"]
    if b["form"] == SPEED_TABLE:
        ts = view(where, n, F8)
        ws = view(where + 8 * n, n, F8)
        cs = view(where + 16 * n, n, F8)
        if t <= ts[0]:
            return b["angle"] + cs[0] + ws[0] * (t - ts[0]), ws[0], 0.0
        if t >= ts[n - 1]:
            return b["angle"] + cs[n - 1] + ws[n - 1] * (t - ts[n - 1]), ws[n - 1], 0.0
        low = 0
        high = n - 1
        while high - low > 1:
            mid = (low + high) // 2
            if ts[mid] <= t:
                low = mid
            else:
                high = mid
        slope = (ws[low + 1] - ws[low]) / (ts[low + 1] - ts[low])
        d = t - ts[low]
        return b["angle"] + cs[low] + d * (ws[low] + 0.5 * slope * d), ws[low] + slope * d, slope
    if b["form"] == ANGLE_FORMULA:
        ops = view(where, n, I8)
        room = view(where + 8 * n, 1 << 20, F8)
        h = 1e-5 * max(1.0, abs(t))
        x, s = evaluate_slope(ops, n, room, t, 0.0, 0.0, 0)
        _, above = evaluate_slope(ops, n, room, t + h, 0.0, 0.0, 0)
        _, below = evaluate_slope(ops, n, room, t - h, 0.0, 0.0, 0)
        return b["angle"] + x, s, (above - below) / (2.0 * h)
    return b["angle"] + b["speed"] * t, b["speed"], 0.0


@kernel
def drive(rec, ctl, fr, q, g, G):
    """Rows of all drives, their time derivatives and torques."""
    c = ctl[0]
    v, gt, gtt, frames = constraint_rates(ctl)
    for e in range(rec.size):
        b = rec[e]
        r = b["row"]
        d = b["spin_i"]
        angle, speed, acceleration = target(b, c["t"])
        g[r] = q[d] + TWO_PI * fr[b["i"]]["turns"] - angle
        gt[r] = -speed
        gtt[r] = -acceleration
        G[r, d] = 1.0
        if c["out"] != 0:
            observations(ctl)[b["out"]] = -view(c["lam"], c["nc"], F8)[r]
    return OK


@kernel
def entry(ctl, rec, n):
    """Uniform entry of the kind."""
    c, fr, q, g, G = constraint_args(ctl)
    return drive(view(rec, n, RECORD), c, fr, q, g, G)
