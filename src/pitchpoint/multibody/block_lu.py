# SPDX-License-Identifier: Apache-2.0
"""Sparse LU factorisation over 6 x 6 blocks; the symbolic factorisation is done once.

Nodes are groups of at most six coordinates. `plan` orders them by minimum degree, adds fill-in blocks and
writes two programmes: *factor* (invert a diagonal block, form L = A D^-1, subtract L U) and *solve* (forward
and backward substitution). After factorisation the diagonal blocks contain their inverses.
"""

from __future__ import annotations

from collections.abc import Iterable
from heapq import heapify, heappop, heappush

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.kernel import kernel
from pitchpoint.core.status import NOT_FINITE, OK, SINGULAR
from pitchpoint.multibody.block_mass import invert_mass

INVERT, SCALE, SUBTRACT, INVERT_MASS = 0, 1, 2, 3
SWEEP, FINISH = 0, 1

FACTOR = np.dtype([(n, "i8") for n in ("op", "a", "b", "c", "na", "nb", "nc")], align=True)
SOLVE = np.dtype([(n, "i8") for n in ("op", "blk", "to", "by", "nt", "nb")], align=True)


def plan(
    sizes: list[int], edges: Iterable[tuple[int, int]], offsets: list[int]
) -> tuple[dict[tuple[int, int], int], NDArray[np.void], NDArray[np.void]]:
    """Symbolic factorisation: order the nodes, number the blocks, write both programmes.

    Parameters
    ----------
    sizes, offsets
        Number of coordinates of each node and index of its first one.
    edges
        Pairs of coupled nodes.

    Returns
    -------
    blocks
        Block index of each ordered pair of nodes, fill-in included; block 0 is the sink.
    factor, solve
        Programmes (FACTOR, SOLVE).
    """
    n = len(sizes)
    near: list[set[int]] = [set() for _ in range(n)]
    for i, j in edges:
        if i != j:
            near[i].add(j)
            near[j].add(i)
    blocks: dict[tuple[int, int], int] = {}
    for i in range(n):
        for j in sorted({i} | near[i]):
            blocks[i, j] = len(blocks) + 1
    factor: list[tuple[int, ...]] = []
    forward: list[tuple[int, ...]] = []
    backward: list[list[tuple[int, ...]]] = []
    queue = [(len(near[i]), i) for i in range(n)]  # heap; entries with an outdated degree are skipped
    heapify(queue)
    left = set(range(n))
    while queue:
        degree, k = heappop(queue)
        if k not in left or degree != len(near[k]):
            continue
        left.remove(k)
        others = sorted(near[k] & left)
        factor.append((INVERT, blocks[k, k], 0, 0, sizes[k], 0, 0))
        last: list[tuple[int, ...]] = []
        for i in others:
            factor.append((SCALE, blocks[i, k], blocks[k, k], 0, sizes[i], sizes[k], 0))
            forward.append((SWEEP, blocks[i, k], offsets[i], offsets[k], sizes[i], sizes[k]))
            last.append((SWEEP, blocks[k, i], offsets[k], offsets[i], sizes[k], sizes[i]))
            for j in others:
                if (i, j) not in blocks:
                    blocks[i, j] = len(blocks) + 1
                near[i].add(j)
                factor.append(
                    (SUBTRACT, blocks[i, j], blocks[i, k], blocks[k, j], sizes[i], sizes[k], sizes[j])
                )
            near[i] -= {i, k}
            heappush(queue, (len(near[i]), i))
        last.append((FINISH, blocks[k, k], offsets[k], offsets[k], sizes[k], sizes[k]))
        backward.append(last)
    solve = forward + [row for rows in reversed(backward) for row in rows]
    return blocks, np.array(factor, FACTOR), np.array(solve, SOLVE)


@kernel
def invert(B, n, order):
    """Invert an n x n block in place by Gauss-Jordan elimination with pivoting; order is scratch (n)."""
    if n == 1:
        if B[0, 0] == 0.0:
            return SINGULAR
        B[0, 0] = 1.0 / B[0, 0]
        return OK
    for k in range(n):
        best = k
        size = abs(B[k, k])
        for i in range(k + 1, n):
            if abs(B[i, k]) > size:
                size = abs(B[i, k])
                best = i
        if not size > 0.0:
            return SINGULAR if size == 0.0 else NOT_FINITE
        order[k] = best
        if best != k:
            for c in range(n):
                x = B[k, c]
                B[k, c] = B[best, c]
                B[best, c] = x
        d = 1.0 / B[k, k]
        B[k, k] = 1.0
        for c in range(n):
            B[k, c] *= d
        for i in range(n):
            if i != k:
                x = B[i, k]
                B[i, k] = 0.0
                for c in range(n):
                    B[i, c] -= x * B[k, c]
    for k in range(n - 1, -1, -1):
        if order[k] != k:
            h = order[k]
            for i in range(n):
                x = B[i, k]
                B[i, k] = B[i, h]
                B[i, h] = x
    return OK


@kernel
def scale(L, D, n, m, T):
    """L <- L D for an n x m block L and an inverted diagonal block D; T is scratch."""
    if n == 6 and m == 6:
        for i in range(6):
            for c in range(6):
                s = 0.0
                for h in range(6):
                    s += L[i, h] * D[h, c]
                T[i, c] = s
        for i in range(6):
            for c in range(6):
                L[i, c] = T[i, c]
    else:
        for i in range(n):
            for c in range(m):
                s = 0.0
                for h in range(m):
                    s += L[i, h] * D[h, c]
                T[i, c] = s
        for i in range(n):
            for c in range(m):
                L[i, c] = T[i, c]


@kernel
def subtract(B, L, U, n, m, o):
    """B <- B - L U for blocks n x m and m x o."""
    if n == 6 and m == 6 and o == 6:
        for i in range(6):
            for c in range(6):
                s = 0.0
                for h in range(6):
                    s += L[i, h] * U[h, c]
                B[i, c] -= s
    else:
        for i in range(n):
            for c in range(o):
                s = 0.0
                for h in range(m):
                    s += L[i, h] * U[h, c]
                B[i, c] -= s


@kernel
def factorise(programme, A, T, order):
    """Run the factor programme on the blocks A in place."""
    for row in range(programme.size):
        w = programme[row]
        if w["op"] == INVERT_MASS:
            if invert_mass(A[w["a"]]) != OK:
                return SINGULAR
        elif w["op"] == INVERT:
            status = invert(A[w["a"]], w["na"], order)
            if status != OK:
                return status
        elif w["op"] == SCALE:
            scale(A[w["a"]], A[w["b"]], w["na"], w["nb"], T)
        else:
            subtract(A[w["a"]], A[w["b"]], A[w["c"]], w["na"], w["nb"], w["nc"])
    return OK


@kernel(inline=True)
def substitute(programme, A, x, y):
    """Solve in place: x is the right-hand side on entry and the solution on exit; y is scratch (6).

    Blocks with three or six columns (planar and free bodies) have unrolled loops.
    """
    for row in range(programme.size):
        w = programme[row]
        m = w["blk"]
        to = w["to"]
        by = w["by"]
        n = w["nt"]
        sweep = w["op"] == SWEEP
        if w["nb"] == 6:
            x0 = x[by]
            x1 = x[by + 1]
            x2 = x[by + 2]
            x3 = x[by + 3]
            x4 = x[by + 4]
            x5 = x[by + 5]
            for i in range(n):
                s = A[m, i, 0] * x0
                s += A[m, i, 1] * x1
                s += A[m, i, 2] * x2
                s += A[m, i, 3] * x3
                s += A[m, i, 4] * x4
                s += A[m, i, 5] * x5
                x[to + i] = x[to + i] - s if sweep else s
        elif w["nb"] == 3:
            x0 = x[by]
            x1 = x[by + 1]
            x2 = x[by + 2]
            for i in range(n):
                s = A[m, i, 0] * x0
                s += A[m, i, 1] * x1
                s += A[m, i, 2] * x2
                x[to + i] = x[to + i] - s if sweep else s
        else:
            for i in range(n):
                s = 0.0
                for c in range(w["nb"]):
                    s += A[m, i, c] * x[by + c]
                y[i] = s
            for i in range(n):
                x[to + i] = x[to + i] - y[i] if sweep else y[i]
