# SPDX-License-Identifier: Apache-2.0
"""Scalar function of time, angle or speed: constant, table, formula or user law.

The fields `SIGNAL` are part of a record; tables, formula programmes and law parameters are in the float pool
of the kind, whose address `link` writes to ``pool``. The integers of formula programmes are stored bitwise.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.formula.kernel import evaluate_slope
from pitchpoint.core.kernel import call_law, kernel, view

F8 = np.dtype("f8")
I8 = np.dtype("i8")
TWO_PI = 6.283185307179586

CONSTANT, TABLE, FORMULA, LAW = 0, 1, 2, 3
OVER_TIME, OVER_ANGLE, OVER_SPEED = 0, 1, 2
OVER_BOTH = 3
"""User laws: x is the angle, and the speed is stored after the parameters."""

SIGNAL: list[tuple[Any, ...]] = [
    ("form", "i8"),  # CONSTANT, TABLE, FORMULA or LAW
    ("over", "i8"),  # abscissa of a table, argument x of a law
    ("value", "f8"),  # CONSTANT: the value; others: a factor
    ("ramp", "f8"),  # time over which the signal rises smoothly from zero at t = 0 [s]; 0: no ramp
    ("period", "f8"),  # TABLE: period of its abscissa, 0 = not periodic (constant beyond the ends)
    ("pool", "i8"),  # address of the pool of the kind
    ("start", "i8"),  # offset in the pool
    ("n", "i8"),  # number of points, of programme words or of law parameters
    ("law", "i8"),  # LAW: address
]


class Pool:
    """Concatenation of the float arrays of all records of one kind.

    Examples
    --------
    >>> pool = Pool()
    >>> pool.add([1.0, 2.0]), pool.add([3.0])
    (0, 2)
    >>> pool.array()
    array([1., 2., 3.])
    """

    def __init__(self) -> None:
        self._parts: list[NDArray[np.float64]] = []
        self._size = 0

    def add(self, values: ArrayLike) -> int:
        """Append values; returns the offset of the first."""
        part = np.ascontiguousarray(values, dtype=np.float64).reshape(-1)
        self._parts.append(part)
        self._size += part.size
        return self._size - part.size

    def array(self) -> NDArray[np.float64]:
        """The pool as one array (at least one element, so that it has an address)."""
        return np.concatenate(self._parts) if self._parts else np.zeros(1)


def set_constant(record: np.void, value: float) -> None:
    """Set a constant signal."""
    record["form"], record["value"] = CONSTANT, value


def set_table(
    record: np.void, pool: Pool, x: ArrayLike, y: ArrayLike, over: int = OVER_TIME, period: float = 0.0
) -> None:
    """Set a table signal, linear between its points; x must increase."""
    xs, ys = np.asarray(x, float), np.asarray(y, float)
    if xs.ndim != 1 or xs.shape != ys.shape or xs.size < 2 or np.any(np.diff(xs) <= 0.0):
        raise ValueError("a table needs at least two points with increasing abscissa")
    record["form"], record["value"], record["over"], record["period"] = TABLE, 1.0, over, period
    record["start"], record["n"] = pool.add(np.concatenate([xs, ys])), xs.size


def set_formula(record: np.void, pool: Pool, formula: Any) -> None:
    """Set a formula signal of (t, angle, speed); see `pitchpoint.core.formula.formula.Formula`."""
    record["form"], record["value"] = FORMULA, 1.0
    record["start"], record["n"] = pool.add(formula.ops.view(np.float64)), formula.ops.size
    pool.add(formula.workspace())


def set_law(record: np.void, pool: Pool, parameters: Sequence[float] = (), over: int = OVER_SPEED) -> None:
    """Set a user-law signal f(t, x, p); the law itself is an argument of `assemble(laws=...)`.

    With `over` OVER_BOTH, x is the angle (or elongation) and ``p[len(parameters)]`` the speed.
    """
    record["form"], record["value"], record["over"] = LAW, 1.0, over
    record["start"], record["n"] = pool.add(np.asarray([*parameters, 0.0])), len(parameters)


@kernel
def interval_of(x, edges):
    """Index of the interval between ascending edges that contains x; the first or the last beyond them.

    >>> import numpy as np
    >>> [int(interval_of(x, np.array([0.0, 1.0, 3.0]))) for x in (-1.0, 0.5, 1.0, 4.0)]
    [0, 0, 1, 1]
    """
    low = 0
    high = edges.size - 1
    while high - low > 1:
        mid = (low + high) // 2
        if edges[mid] <= x:
            low = mid
        else:
            high = mid
    return low


@kernel
def interpolate(x, xs, ys):
    """Value and slope of a table; constant beyond its ends."""
    n = xs.size
    if x <= xs[0]:
        return ys[0], 0.0
    if x >= xs[n - 1]:
        return ys[n - 1], 0.0
    low = interval_of(x, xs)
    slope = (ys[low + 1] - ys[low]) / (xs[low + 1] - xs[low])
    return ys[low] + slope * (x - xs[low]), slope


@kernel
def _table(b, t, phi, turns, speed):
    x = t if b["over"] == OVER_TIME else speed if b["over"] == OVER_SPEED else phi + TWO_PI * turns
    period = b["period"]
    n = b["n"]
    where = b["pool"] + 8 * b["start"]
    xs = view(where, n, F8)
    if period > 0.0:
        if b["over"] == OVER_ANGLE and period == TWO_PI:
            x = phi  # whole turns cancel exactly
        x -= period * math.floor((x - xs[0]) / period)
    return interpolate(x, xs, view(where + 8 * n, n, F8))


@kernel
def _law(b, t, phi, turns, speed, slopes):
    x = t if b["over"] == OVER_TIME else speed if b["over"] == OVER_SPEED else phi + TWO_PI * turns
    p = b["pool"] + 8 * b["start"]
    behind = view(p + 8 * b["n"], 1, F8)
    both = 1 if b["over"] == OVER_BOTH else 0
    if both != 0:
        behind[0] = speed
    value = call_law(b["law"], t, x, p)
    slope = 0.0
    by_speed = 0.0
    if slopes != 0 and b["over"] != OVER_TIME:
        h = 1e-6 * max(1.0, abs(x))
        slope = (call_law(b["law"], t, x + h, p) - call_law(b["law"], t, x - h, p)) / (2.0 * h)
        if both != 0:
            h = 1e-6 * max(1.0, abs(speed))
            behind[0] = speed + h
            more = call_law(b["law"], t, x, p)
            behind[0] = speed - h
            by_speed = (more - call_law(b["law"], t, x, p)) / (2.0 * h)
    return value, slope, by_speed


@kernel
def signal(b, t, phi, turns, speed, slopes):
    """Value, slope by angle, slope by speed; slopes = 0 requests the value only."""
    value = b["value"]
    by_angle = 0.0
    by_speed = 0.0
    form = b["form"]
    if form == TABLE:
        y, s = _table(b, t, phi, turns, speed)
        by_angle = value * s if b["over"] == OVER_ANGLE else 0.0
        by_speed = value * s if b["over"] == OVER_SPEED else 0.0
        value *= y
    elif form == FORMULA:
        n = b["n"]
        where = b["pool"] + 8 * b["start"]
        ops = view(where, n, I8)
        room = view(where + 8 * n, 1 << 20, F8)  # upper bound; the programme uses only its own workspace
        angle = phi + TWO_PI * turns
        y, s = evaluate_slope(ops, n, room, t, angle, speed, 1 if slopes != 0 else -1)
        if slopes != 0:
            by_angle = value * s
            y, s = evaluate_slope(ops, n, room, t, angle, speed, 2)
            by_speed = value * s
        value *= y
    elif form == LAW:
        y, s, d = _law(b, t, phi, turns, speed, slopes)
        if b["over"] == OVER_SPEED:
            by_speed = value * s
        elif b["over"] != OVER_TIME:
            by_angle = value * s
            by_speed = value * d
        value *= y
    ramp = b["ramp"]
    if ramp > 0.0 and t < ramp:
        x = max(t / ramp, 0.0)
        x = x * x * (3.0 - 2.0 * x)
        value *= x
        by_angle *= x
        by_speed *= x
    return value, by_angle, by_speed


def law_call(record: np.void, frames: Any, pool: Any, t: float) -> tuple[float, int, int]:
    """Argument of a user law of time, angle or speed of body i, and its parameters (`Kind.law_call`)."""
    frame = frames[int(record["i"])]
    x = float(frame["phi"]) + TWO_PI * int(frame["turns"])
    if record["over"] == OVER_TIME:
        x = t
    elif record["over"] == OVER_SPEED:
        x = float(frame["R"][:, 2] @ frame["tw"][3:])
    return x, int(record["start"]), int(record["n"])
