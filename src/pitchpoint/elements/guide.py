# SPDX-License-Identifier: Apache-2.0
"""Guided joints: displacements as functions of time or of the joint coordinates.

One record is one function: displacement m of a guided body as a function of time (a moving frame) or of one
coordinate of its joint (a slot, a cam groove, any path). The functions of one displacement are added.
Polynomials are differentiated exactly; formulas give their exact slope, and a fourth-order difference
quotient of the slope gives the second derivative.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.formula.kernel import evaluate_curvature
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.elements.kind import FREE, MOTION, Kind, Power
from pitchpoint.elements.signal import Pool, interval_of
from pitchpoint.elements.speed_profile import fit_pieces
from pitchpoint.multibody.channels import F8, I8, motion_args

LINEAR, PIECES, FORMULA = 0, 1, 2
TIME = -1

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j")]
    + [
        ("dof_i", "i8"),  # first coordinate of the body; written by the layout
        ("guide_i", "i8"),  # number of its guide; written by the layout
        ("m", "i8"),  # displacement 0 ... 5: x, y, z, alpha, beta, spin
        ("k", "i8"),  # independent variable: coordinate of the joint, or TIME
        ("first", "i8"),  # 1: first record of its body
        ("form", "i8"),  # LINEAR, PIECES or FORMULA
        ("value", "f8"),  # LINEAR: value at zero; else an offset
        ("slope", "f8"),  # LINEAR
        ("step", "f8"),  # FORMULA: step of the difference quotient for the second derivative
        ("period", "f8"),  # PIECES: period; 0: not periodic, constant beyond the ends
        ("pool", "i8"),
        ("start", "i8"),
        ("n", "i8"),  # pieces or programme words
        ("degree", "i8"),
        ("out", "i8"),
    ],
    align=True,
)

OUTPUTS: tuple[tuple[str, str, str], ...] = ()

STEP_OF_TIME, STEP_OF_COORDINATE = 1e-5, 1e-3
"""[s]: relative error of the second derivative 1e-8 at 100 Hz; [rad], [m]: 1e-11 for smooth functions."""


def set_formula(record: Any, pool: Pool, formula: Any) -> None:
    """Set a formula of one variable, see `pitchpoint.core.formula.formula.Formula`."""
    record["form"] = FORMULA
    record["step"] = STEP_OF_TIME if record["k"] == TIME else STEP_OF_COORDINATE
    record["start"], record["n"] = pool.add(formula.ops.view(np.float64)), formula.ops.size
    pool.add(formula.workspace())


def set_table(record: Any, pool: Pool, x: ArrayLike, y: ArrayLike, period: float = 0.0) -> None:
    """Set a cubic spline through points; with a period, first and last value must be equal."""
    from scipy.interpolate import CubicSpline

    xs = np.asarray(x, float)
    spline = CubicSpline(xs, np.asarray(y, float), bc_type="periodic" if period else "not-a-knot")
    _set_pieces(record, pool, xs, lambda at: np.asarray(spline(at)), 3)
    record["period"] = period


def set_function(
    record: Any, pool: Pool, function: Callable[[NDArray[np.float64]], Any], begin: float, end: float
) -> None:
    """Set a Python function over a range, fitted by piecewise polynomials to nine digits."""
    pieces = fit_pieces(function, begin, end)
    record["form"], record["n"] = PIECES, len(pieces.powers)
    record["degree"] = pieces.powers.shape[1] - 1
    record["start"] = pool.add(np.concatenate([pieces.edges, pieces.powers.ravel()]))


def _set_pieces(record: Any, pool: Pool, edges: NDArray[np.float64], function: Any, degree: int) -> None:
    """Set the exact pieces of a piecewise polynomial function of the given degree."""
    nodes = np.linspace(-1.0, 1.0, degree + 1)
    at = 0.5 * (edges[:-1] + edges[1:])[:, None] + 0.5 * np.diff(edges)[:, None] * nodes
    powers = np.linalg.solve(np.vander(nodes, increasing=True), function(at).T).T
    record["form"], record["n"], record["degree"] = PIECES, len(powers), degree
    record["start"] = pool.add(np.concatenate([edges, powers.ravel()]))


@kernel
def _pieces(b, x):
    """Value, slope and second derivative of piecewise polynomials; constant beyond the ends."""
    n = b["n"]
    most = b["degree"]
    where = b["pool"] + 8 * b["start"]
    edges = view(where, n + 1, F8)
    powers = view(where + 8 * (n + 1), (n, most + 1), F8)
    if b["period"] > 0.0:
        x -= b["period"] * math.floor((x - edges[0]) / b["period"])
    low = interval_of(x, edges)
    half = 0.5 * (edges[low + 1] - edges[low])
    s = (x - edges[low]) / half - 1.0
    outside = s < -1.0 or s > 1.0
    s = min(max(s, -1.0), 1.0)
    value = 0.0
    slope = 0.0
    second = 0.0
    for k in range(most, -1, -1):
        second = second * s + 2.0 * slope
        slope = slope * s + value
        value = value * s + powers[low, k]
    if outside:
        return value, 0.0, 0.0
    return value, slope / half, second / (half * half)


@kernel
def function(b, x):
    """Value, slope and second derivative of the function of a record."""
    if b["form"] == LINEAR:
        return b["value"] + b["slope"] * x, b["slope"], 0.0
    if b["form"] == PIECES:
        value, slope, second = _pieces(b, x)
        return b["value"] + value, slope, second
    n = b["n"]
    where = b["pool"] + 8 * b["start"]
    ops = view(where, n, I8)
    room = view(where + 8 * n, 1 << 20, F8)  # upper bound; the programme uses only its own workspace
    value, slope, second = evaluate_curvature(ops, n, room, x, b["step"])
    return b["value"] + value, slope, second


@kernel
def guide(rec, ctl, q, guides):
    """Set the displacements of all guided bodies and their derivatives."""
    t = ctl[0]["t"]
    exact = ctl[0]["jac"] == 2
    for e in range(rec.size):
        b = rec[e]
        g = guides[b["guide_i"]]
        if b["first"] != 0:
            for m in range(6):
                g["d"][m] = 0.0
                g["rate"][m] = 0.0
                g["second"][m] = 0.0
                for k in range(6):
                    g["by"][m, k] = 0.0
                    g["by2"][m, k] = 0.0
                    g["by3"][m, k] = 0.0
        m = b["m"]
        k = b["k"]
        value, slope, second = function(b, t if k == TIME else q[b["dof_i"] + k])
        if not math.isfinite(value + slope + second):
            ctl[0]["bad"] = e
            return NOT_FINITE
        g["d"][m] += value
        if k == TIME:
            g["rate"][m] += slope
            g["second"][m] += second
        else:
            g["by"][m, k] += slope
            g["by2"][m, k] += second
            if exact and b["form"] != LINEAR:
                x = q[b["dof_i"] + k]
                h = STEP_OF_COORDINATE
                _, _, after = function(b, x + h)
                _, _, before = function(b, x - h)
                g["by3"][m, k] += (after - before) / (2.0 * h)
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, q, guides = motion_args(ctl)
    return guide(view(rec, n, RECORD), c, q, guides)


KIND = Kind(
    name="guide",
    channel=MOTION,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    spins=FREE,
    sections={"joints": "", "elastic_bodies": "", "gears": ""},
    power=Power(),
)
