# SPDX-License-Identifier: Apache-2.0
"""Constraint rows and their Schur complement: A x + G^T y = -R, G x = -g.

With Y = A^-1 G^T and S = G Y the multipliers follow from S y = g - G A^-1 R. S is factored with symmetric
pivoting. A pivot below 1e-10 of the initial diagonal entry of its row marks a redundant row: `used` is 0 and
its multiplier is 0.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.multibody.block_lu import substitute

REDUNDANT = 1e-10


@kernel
def frame_rows(rows, body, path, fr, J, Gf, G, lam):
    """Project constraint rows on frames to G by the joint columns; add their multipliers to the wrenches."""
    for r in range(rows.shape[0]):
        for side in range(2):
            b = rows[r, side]
            f = fr[b]
            for i in range(6):
                f["F"][i] -= lam[r] * Gf[r, side, i]
            first = body[b]["first"]
            for p in range(first, first + body[b]["count"]):
                w = path[p]
                for c in range(w["n"]):
                    s = 0.0
                    for i in range(6):
                        s += J[p, i, c] * Gf[r, side, i]
                    G[r, w["dof"] + c] += s


@kernel
def add_multipliers(G, lam, R):
    """R += G^T lam for constraint rows on coordinates."""
    for r in range(G.shape[0]):
        if lam[r] != 0.0:
            for c in range(G.shape[1]):
                R[c] += G[r, c] * lam[r]


@kernel
def schur_factor(G, A, programme, Y, S, diag, order, used, y6):
    """Form and factor S = G A^-1 G^T; returns the number of redundant rows."""
    n = G.shape[0]
    nd = G.shape[1]
    for r in range(n):
        for c in range(nd):
            Y[r, c] = G[r, c]
        substitute(programme, A, Y[r], y6)
    for r in range(n):
        order[r] = r
        for k in range(n):
            s = 0.0
            for c in range(nd):
                s += G[r, c] * Y[k, c]
            S[r, k] = s
    for r in range(n):
        diag[r] = abs(S[r, r])
    rank = n
    for k in range(n):
        best = k
        size = -1.0
        for i in range(k, n):
            h = order[i]
            x = abs(S[h, h]) / diag[h] if diag[h] > 0.0 else 0.0
            if x > size * 1.000001:  # ties: the first row is kept, the later one is redundant
                size = x
                best = i
        h = order[best]
        for i in range(best, k, -1):
            order[i] = order[i - 1]
        order[k] = h
        if not size > REDUNDANT:
            rank = k
            break
        d = 1.0 / S[h, h]
        for i in range(k + 1, n):
            u = order[i]
            x = S[u, h] * d
            S[u, h] = x
            for j in range(k + 1, n):
                c = order[j]
                S[u, c] -= x * S[h, c]
    for k in range(n):
        used[order[k]] = 1 if k < rank else 0
    return n - rank


@kernel
def schur_solve(G, g, Y, S, order, used, x, y, z):
    """Correct the unconstrained solution x = -A^-1 R for the constraint rows; y receives the multipliers."""
    n = G.shape[0]
    nd = G.shape[1]
    rank = 0
    for k in range(n):
        h = order[k]
        y[h] = 0.0
        if used[h] != 0:
            rank += 1
            s = g[h]
            for c in range(nd):
                s += G[h, c] * x[c]
            z[h] = s
    for k in range(rank):
        h = order[k]
        for i in range(k):
            z[h] -= S[h, order[i]] * z[order[i]]
    for k in range(rank - 1, -1, -1):
        h = order[k]
        s = z[h]
        for i in range(k + 1, rank):
            s -= S[h, order[i]] * y[order[i]]
        y[h] = s / S[h, h]
    for k in range(rank):
        h = order[k]
        for c in range(nd):
            x[c] -= Y[h, c] * y[h]
