# SPDX-License-Identifier: Apache-2.0
"""Rigid gear coupling of two spins as a constraint row: z1 spin1 + z2 spin2 = constant.

The whole turns are summed as integers, so the row is as exact after 1e5 revolutions as at the start. Numbers
of teeth are signed: both positive for an external pair, the second negative for an internal one.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.multibody.channels import F8, constraint_args, observations

TWO_PI = 6.283185307179586
ROWS = 1

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("spin_i", "i8"),  # coordinates; written by the layout
        ("spin_j", "i8"),
        ("row", "i8"),  # constraint row; written by the layout
        ("z1", "i8"),
        ("z2", "i8"),  # signed numbers of teeth
        ("u0", "f8"),  # value of spin1 + z2/z1 spin2 as assembled [rad]
        ("out", "i8"),
    ],
    align=True,
)

OUTPUTS = (("torque", "N m", "torque of the coupling on the first body"),)


@kernel
def gear_constraint(rec, ctl, fr, q, g, G):
    """Rows of all rigid gear couplings and their torques."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        r = b["row"]
        z1 = b["z1"]
        z2 = b["z2"]
        whole = z1 * fr[b["i"]]["turns"] + z2 * fr[b["j"]]["turns"]
        g[r] = q[b["spin_i"]] + (z2 * q[b["spin_j"]] + TWO_PI * whole) / z1 - b["u0"]
        G[r, b["spin_i"]] = 1.0
        G[r, b["spin_j"]] = z2 / z1
        if c["out"] != 0:
            observations(ctl)[b["out"]] = -view(c["lam"], c["nc"], F8)[r]
    return OK


@kernel
def entry(ctl, rec, n):
    """Uniform entry of the kind."""
    c, fr, q, g, G = constraint_args(ctl)
    return gear_constraint(view(rec, n, RECORD), c, fr, q, g, G)
