# SPDX-License-Identifier: Apache-2.0
"""A loop closure for tests of solvers: two points of two bodies coincide in a plane.

Both bodies turn about axes along the third world axis; the rows are x and y of the point of body i less that
of body j. With omega the angular speed and s the arm of a point, its velocity is v + omega x s.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements import registry
from pitchpoint.multibody.channels import constraint_args, constraint_rates
from pitchpoint.system import evaluate

ROWS = 2
BODY_FIXED = True
RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [("row", "i8"), ("at_i", "f8", 3), ("at_j", "f8", 3), ("out", "i8")],
    align=True,
)
OUTPUTS = ()
KIND = registry.Kind("pin_in_plane", __name__, registry.CONSTRAINT)


@kernel
def _side(f, at, sign, side, r, g, gt, gtt, Gf):
    """Add one body's point to both rows."""
    S = f["S"]
    x = S[0, 0] * at[0] + S[0, 1] * at[1] + S[0, 2] * at[2]
    y = S[1, 0] * at[0] + S[1, 1] * at[1] + S[1, 2] * at[2]
    w = f["tw"][5]
    g[r] += sign * (f["r"][0] + x)
    g[r + 1] += sign * (f["r"][1] + y)
    Gf[r, side, 0] = sign
    Gf[r, side, 5] = -sign * y
    Gf[r + 1, side, 1] = sign
    Gf[r + 1, side, 5] = sign * x
    # acceleration of the point: of the origin, by the angular acceleration, towards the origin
    gtt[r] += sign * (f["ac"][0] - f["ac"][5] * y - w * w * x)
    gtt[r + 1] += sign * (f["ac"][1] + f["ac"][5] * x - w * w * y)


@kernel
def pin_in_plane(rec, ctl, fr, g, gt, gtt, Gf):
    """Rows of all pins; gtt is the second derivative of g less what the accelerations of now make of it."""
    for e in range(rec.size):
        b = rec[e]
        r = b["row"]
        for k in range(2):
            g[r + k] = 0.0
            gtt[r + k] = 0.0
        _side(fr[b["i"]], b["at_i"], 1.0, 0, r, g, gt, gtt, Gf)
        _side(fr[b["j"]], b["at_j"], -1.0, 1, r, g, gt, gtt, Gf)
    return OK


@kernel
def entry(ctl, rec, n):
    """Uniform entry of the kind."""
    c, fr, _, g, _ = constraint_args(ctl)
    _, gt, gtt, Gf = constraint_rates(c)
    return pin_in_plane(view(rec, n, RECORD), c, fr, g, gt, gtt, Gf)


def pins(rows):
    """Records from rows (body i, point in its axes, body j, point in its axes)."""
    registry.register(KIND)
    records = np.zeros(len(rows), RECORD)
    for record, (i, at_i, j, at_j) in zip(records, rows, strict=True):
        record["i"], record["at_i"], record["j"], record["at_j"] = i, at_i, j, at_j
    return records


def row_over_time(system, state, h):
    """First and second derivative of the first row along q + v t + a t^2/2, by differences of sixth order."""
    found = {}
    for k in range(-3, 4):
        moved = state.copy()
        moved.q = state.q + k * h * state.v + 0.5 * (k * h) ** 2 * state.a
        evaluate.residual(system, moved)
        found[k] = float(system.workspace.g[0])
    rate = 45.0 * (found[1] - found[-1]) - 9.0 * (found[2] - found[-2]) + found[3] - found[-3]
    bend = 270.0 * (found[1] + found[-1]) - 27.0 * (found[2] + found[-2]) + 2.0 * (found[3] + found[-3])
    return rate / (60.0 * h), (bend - 490.0 * found[0]) / (180.0 * h * h)
