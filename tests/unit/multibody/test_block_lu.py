# SPDX-License-Identifier: Apache-2.0
"""The block programmes solve what a dense solver solves, whatever the pattern."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.status import OK, SINGULAR
from pitchpoint.multibody.block_lu import factorise, plan, substitute


def solve(sizes, edges, seed):
    rng = np.random.default_rng(seed)
    offsets = [int(n) for n in np.concatenate([[0], np.cumsum(sizes)[:-1]])]
    blocks, factor, sweep = plan(list(sizes), edges, offsets)
    n = sum(sizes)
    A = np.zeros((len(blocks) + 1, 6, 6))
    dense = np.zeros((n, n))
    both = {(i, i) for i in range(len(sizes))} | set(edges) | {(j, i) for i, j in edges}
    for i, j in both:
        block = rng.normal(size=(sizes[i], sizes[j])) + (8.0 * np.eye(sizes[i]) if i == j else 0.0)
        A[blocks[i, j], : sizes[i], : sizes[j]] = block
        dense[offsets[i] : offsets[i] + sizes[i], offsets[j] : offsets[j] + sizes[j]] = block
    b = rng.normal(size=n)
    x = b.copy()
    assert factorise(factor, A, np.zeros((6, 6)), np.zeros(6, np.int64)) == OK
    substitute(sweep, A, x, np.zeros(6))
    return x, np.linalg.solve(dense, b)


@pytest.mark.nojit
@pytest.mark.parametrize(
    ("sizes", "edges"),
    [
        ([2], []),
        ([6, 6], [(0, 1)]),
        ([1, 3, 6, 2], [(0, 1), (1, 2), (2, 3)]),
        ([6, 6, 6, 6], [(0, 1), (1, 2), (2, 3), (3, 0)]),  # a loop brings fill
        ([3, 6, 1, 6, 2], [(0, 1), (0, 2), (0, 3), (0, 4)]),
    ],
)
def test_solution_is_that_of_a_dense_solver(sizes, edges):
    x, expected = solve(sizes, edges, len(sizes))
    np.testing.assert_allclose(x, expected, rtol=1e-10, atol=1e-12)


def test_pivoting_inside_a_block_and_singular_blocks():
    _, factor, sweep = plan([2], [], [0])
    A = np.zeros((2, 6, 6))
    A[1, 0, 1] = A[1, 1, 0] = 2.0  # zero diagonal
    assert factorise(factor, A, np.zeros((6, 6)), np.zeros(6, np.int64)) == OK
    x = np.array([2.0, 4.0])
    substitute(sweep, A, x, np.zeros(6))
    np.testing.assert_allclose(x, [2.0, 1.0])
    A[:] = 0.0
    assert factorise(factor, A, np.zeros((6, 6)), np.zeros(6, np.int64)) == SINGULAR
