# SPDX-License-Identifier: Apache-2.0
"""Condensed linear part: constant mass, damping and stiffness of the coordinates, in blocks of bodies.

f_i = -(f0 + M a_j + D (v_j - v0) + K (q_j - x0)), summed over the records of body i. One record per ordered
pair of bodies with a nonzero block. Shafts rotate freely: if `relative` is set, the spin of body j is
relative to that of body i, whole turns included; the sum is the same because K has no stiffness against a
common rotation.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.kind import COORDINATE, TOGETHER, Kind
from pitchpoint.multibody.channels import F8, FRAME, coordinate_args

TWO_PI = 6.283185307179586

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("blk", "i8"),  # block of the system matrix and offsets in it; written by the layout up to spin_j
        ("o_i", "i8"),
        ("o_j", "i8"),
        ("dof_i", "i8"),
        ("dof_j", "i8"),
        ("n_i", "i8"),
        ("n_j", "i8"),
        ("spin_i", "i8"),
        ("spin_j", "i8"),
        ("relative", "i8"),  # 1: the spin of body j is relative to that of body i
        ("spin0", "f8"),  # spin of body i, whole turns included, at the operating point [rad]
        ("x0", "f8", 6),  # coordinates of body j there [m, rad], a spin with whole turns
        ("v0", "f8", 6),  # their rates there
        ("f0", "f8", 6),  # forces on body i there [N, N m]; in one record of the body
        ("M", "f8", (6, 6)),  # [kg ...]
        ("D", "f8", (6, 6)),  # [N s/m ...]
        ("K", "f8", (6, 6)),  # [N/m ...]
        ("out", "i8"),
    ],
    align=True,
)
OUTPUTS: tuple[tuple[str, str, str], ...] = ()


@kernel
def _displacement(b, k, q, fr):
    """Displacement of coordinate k of body j from the operating point."""
    d = b["dof_j"] + k
    x = q[d] - b["x0"][k]
    if d == b["spin_j"]:
        turns = fr[b["j"]]["turns"]
        if b["relative"] != 0:
            x -= q[b["spin_i"]] - b["spin0"]
            turns -= fr[b["i"]]["turns"]
        x += TWO_PI * turns
    return x


@kernel
def linear_part(rec, ctl, fr, q, v, a, R, A):
    """Forces and tangents of all blocks."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        di = b["dof_i"]
        dj = b["dof_j"]
        for r in range(b["n_i"]):
            R[di + r] += b["f0"][r]
        for k in range(b["n_j"]):
            x = _displacement(b, k, q, fr)
            w = v[dj + k] - b["v0"][k]
            u = a[dj + k]
            for r in range(b["n_i"]):
                R[di + r] += b["M"][r, k] * u + b["D"][r, k] * w + b["K"][r, k] * x
        if c["jac"] != 0 or c["cm"] != 0.0:
            cd = c["cd"] if c["jac"] != 0 else 0.0
            ck = c["ck"] if c["jac"] != 0 else 0.0
            for r in range(b["n_i"]):
                for k in range(b["n_j"]):
                    A[b["blk"], b["o_i"] + r, b["o_j"] + k] += (
                        c["cm"] * b["M"][r, k] + cd * b["D"][r, k] + ck * b["K"][r, k]
                    )
    return OK


@kernel
def part_args(where):
    """Unpack: control, frames, q, v, a, residual, blocks."""
    ctl, q, v, R, A = coordinate_args(where)
    c = ctl[0]
    return ctl, view(c["fr"], c["nb"], FRAME), q, v, view(c["a"], c["nd"], F8), R, A


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, q, v, a, R, A = part_args(ctl)
    return linear_part(view(rec, n, RECORD), c, fr, q, v, a, R, A)


KIND = Kind(
    name="linear_part",
    channel=COORDINATE,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    spins=TOGETHER,
    excites=False,
)
