# SPDX-License-Identifier: Apache-2.0
"""Constant damping matrix on the coordinates, in blocks of bodies: Rayleigh and modal damping.

f = -D v. One record per ordered pair of bodies with a block that is not zero.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.core.symmetric_pencil import symmetric_pencil
from pitchpoint.multibody.channels import coordinate_args

SPINS = "free"

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("blk", "i8"),  # block of the matrix and offsets in it; written by the layout, like the next four
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


def modal_damping(M: NDArray[np.float64], K: NDArray[np.float64], ratio: float) -> NDArray[np.float64]:
    """Damping matrix that gives every elastic mode the same damping ratio: D = sum 2 ratio omega M x x^T M.

    Parameters
    ----------
    M, K
        Symmetric mass and stiffness matrix (symmetric parts are taken), shape (nd, nd).
    ratio
        Damping ratio of every mode [-]; rigid-body motion is not damped.

    Examples
    --------
    >>> modal_damping(np.eye(1), np.array([[4.0]]), 0.25)
    array([[1.]])
    """
    M, K = 0.5 * (M + M.T), 0.5 * (K + K.T)
    squares, modes = symmetric_pencil(K, M)
    omega = np.sqrt(np.where(squares > 1e-9 * np.abs(squares).max(initial=0.0), squares, 0.0))
    left = M @ modes
    D = (left * (2.0 * ratio * omega)) @ left.T
    return np.asarray(D)


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
    """Uniform entry of the kind."""
    c, q, v, R, A = coordinate_args(ctl)
    return damping(view(rec, n, RECORD), c, q, v, R, A)
