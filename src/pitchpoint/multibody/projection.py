# SPDX-License-Identifier: Apache-2.0
"""Projection of wrenches and pair tangents from frames to joint coordinates.

The programme has one row per ordered pair of interacting bodies (i, j) and pair of joints on their paths:
pair block, path entry of i, path entry of j, target block, sizes, offsets inside the merged nodes, and a
fast-path code. The cost is independent of the number of elements between two bodies.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel
from pitchpoint.multibody.joints import FREE, TORSION

#: Fast-path codes of a programme row.
ANY, SPINS, SHAFTS = 0, 1, 2

PROJ = np.dtype(
    [(name, "i8") for name in ("pair", "pi", "pj", "blk", "ni", "nj", "oi", "oj", "short")],
    align=True,
)


@kernel(inline=True)
def project_force(path, fr, J, R):
    """R -= J^T F for all joints on the paths of all bodies."""
    for p in range(path.size):
        w = path[p]
        F = fr[w["body"]]["F"]
        d = w["dof"]
        if w["joint"] == TORSION:
            R[d] -= J[p, 3, 0] * F[3] + J[p, 4, 0] * F[4] + J[p, 5, 0] * F[5]
        elif w["joint"] == FREE:
            for c in range(3):
                R[d + c] -= J[p, 0, c] * F[0] + J[p, 1, c] * F[1] + J[p, 2, c] * F[2]
                R[d + 3 + c] -= J[p, 3, 3 + c] * F[3] + J[p, 4, 3 + c] * F[4] + J[p, 5, 3 + c] * F[5]
        else:
            for c in range(w["n"]):
                s = 0.0
                for i in range(6):
                    s += J[p, i, c] * F[i]
                R[d + c] -= s


@kernel(inline=True)
def project_tangent(proj, J, kk, X, A, T):
    """A[block] += J_i^T kk[pair] X_j; X is J, or the derivatives of `joint_rates` for exact linearisation.

    T is scratch (6, 6): kk[pair] X_j, kept for all joints on the path of body i.
    """
    known = -1
    pair = -1
    for row in range(proj.size):
        w = proj[row]
        k = w["pair"]
        pi = w["pi"]
        pj = w["pj"]
        m = w["blk"]
        oi = w["oi"]
        oj = w["oj"]
        if w["short"] == SPINS:
            s = 0.0
            for r in range(3, 6):
                s += J[pi, r, 0] * (
                    kk[k, r, 3] * X[pj, 3, 0] + kk[k, r, 4] * X[pj, 4, 0] + kk[k, r, 5] * X[pj, 5, 0]
                )
            A[m, oi, oj] += s
        elif w["short"] == SHAFTS:  # translations and rotations are decoupled in J
            for r in range(6):
                for c in range(3):
                    T[r, c] = (
                        kk[k, r, 0] * X[pj, 0, c] + kk[k, r, 1] * X[pj, 1, c] + kk[k, r, 2] * X[pj, 2, c]
                    )
                    T[r, 3 + c] = (
                        kk[k, r, 3] * X[pj, 3, 3 + c]
                        + kk[k, r, 4] * X[pj, 4, 3 + c]
                        + kk[k, r, 5] * X[pj, 5, 3 + c]
                    )
            for r in range(3):
                for c in range(6):
                    A[m, r, c] += J[pi, 0, r] * T[0, c] + J[pi, 1, r] * T[1, c] + J[pi, 2, r] * T[2, c]
                    A[m, 3 + r, c] += (
                        J[pi, 3, 3 + r] * T[3, c] + J[pi, 4, 3 + r] * T[4, c] + J[pi, 5, 3 + r] * T[5, c]
                    )
            known = -1
        else:
            nj = w["nj"]
            if pj != known or k != pair:
                _pair_columns(kk[k], X[pj], nj, T)
                known = pj
                pair = k
            if w["ni"] == 6 and nj == 6:  # constant bounds, which the compiler unrolls
                for r in range(6):
                    for h in range(6):
                        x = J[pi, h, r]
                        for c in range(6):
                            A[m, r, c] += x * T[h, c]
            else:
                for r in range(w["ni"]):
                    for h in range(6):
                        x = J[pi, h, r]
                        for c in range(nj):
                            A[m, oi + r, oj + c] += x * T[h, c]


@kernel
def _pair_columns(K, X, n, T):
    """T = K X for n columns of X."""
    if n == 6:
        for r in range(6):
            for c in range(6):
                T[r, c] = 0.0
            for h in range(6):
                x = K[r, h]
                for c in range(6):
                    T[r, c] += x * X[h, c]
        return
    for r in range(6):
        for c in range(n):
            s = 0.0
            for h in range(6):
                s += K[r, h] * X[h, c]
            T[r, c] = s


@kernel
def project_geometry(proj, path, fr, J, A, ck):
    """Subtract ck dJ^T/dq F, the derivative of the joint columns times the wrench (exact linearisation only).

    For coordinates a, c of one path with columns (l, w): dQ_a/dq_c = (w_c x l_a).f + (w_c x w_a).m if c is
    inboard of a, otherwise (w_a x l_c).f. Only programme rows with equal bodies contribute.
    """
    for row in range(proj.size):
        g = proj[row]
        pi = g["pi"]
        pj = g["pj"]
        if path[pi]["body"] == path[pj]["body"]:
            F = fr[path[pi]["body"]]["F"]
            for a in range(g["ni"]):
                for c in range(g["nj"]):
                    if pj < pi or (pj == pi and c < a):
                        x = J[pj, 3, c]
                        y = J[pj, 4, c]
                        z = J[pj, 5, c]
                        s = 0.0
                        for h in range(0, 6, 3):
                            s += (y * J[pi, h + 2, a] - z * J[pi, h + 1, a]) * F[h]
                            s += (z * J[pi, h, a] - x * J[pi, h + 2, a]) * F[h + 1]
                            s += (x * J[pi, h + 1, a] - y * J[pi, h, a]) * F[h + 2]
                    else:
                        x = J[pi, 3, a]
                        y = J[pi, 4, a]
                        z = J[pi, 5, a]
                        s = (y * J[pj, 2, c] - z * J[pj, 1, c]) * F[0]
                        s += (z * J[pj, 0, c] - x * J[pj, 2, c]) * F[1]
                        s += (x * J[pj, 1, c] - y * J[pj, 0, c]) * F[2]
                    A[g["blk"], g["oi"] + a, g["oj"] + c] -= ck * s
