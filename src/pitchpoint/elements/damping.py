# SPDX-License-Identifier: Apache-2.0
"""Constant damping matrix of the coordinates in blocks of bodies: Rayleigh and modal damping.

f = -D v. One record per ordered pair of bodies with a nonzero block.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.kind import COORDINATE, EVERYWHERE, FREE, RAYLEIGH, Kind
from pitchpoint.multibody.channels import coordinate_args

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("blk", "i8"),  # block of the system matrix and offsets in it; written by the layout
        ("o_i", "i8"),
        ("o_j", "i8"),
        ("dof_i", "i8"),
        ("dof_j", "i8"),
        ("n_i", "i8"),
        ("n_j", "i8"),
        ("D", "f8", (6, 6)),  # block for the coordinates of both bodies [N s/m ...]
        ("out", "i8"),
    ],
    align=True,
)


@kernel
def damping(rec, ctl, q, v, R, A):
    """Forces and tangents of all blocks."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        di = b["dof_i"]
        dj = b["dof_j"]
        D = b["D"]
        for r in range(b["n_i"]):
            s = 0.0
            for k in range(b["n_j"]):
                s += D[r, k] * v[dj + k]
            R[di + r] += s
        if c["jac"] != 0:
            for r in range(b["n_i"]):
                for k in range(b["n_j"]):
                    A[b["blk"], b["o_i"] + r, b["o_j"] + k] += c["cd"] * D[r, k]
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, q, v, R, A = coordinate_args(ctl)
    return damping(view(rec, n, RECORD), c, q, v, R, A)


KIND = Kind(
    name="damping",
    channel=COORDINATE,
    record=RECORD,
    entry=entry,
    role=RAYLEIGH,
    scope=EVERYWHERE,
    massless=True,
    spins=FREE,
    linear=True,
    excites=False,
)
