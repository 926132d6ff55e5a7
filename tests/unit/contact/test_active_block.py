# SPDX-License-Identifier: Apache-2.0
"""Cholesky factor of the nodes in contact against NumPy, for all sizes around a vector length."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.contact.active_block import LANES, factorise_block, pack_block, solve_block, subtract_columns
from pitchpoint.core.status import NOT_FINITE, OK, SINGULAR

pytestmark = pytest.mark.nojit


def factor(C, on, slope):
    """Factor of a block with its status; everything outside the block is NaN before."""
    m = len(on)
    w = max(-(-len(C) // LANES) * LANES, LANES)
    U, inverse = np.full((w, w), np.nan), np.full(w, np.nan)
    listed, diagonal = np.zeros(w, np.int64), np.full(w, np.nan)
    listed[:m], diagonal[:m] = on, slope
    pack_block(C, listed, m, diagonal, U)
    return factorise_block(U, m, inverse), U, inverse


@pytest.mark.parametrize("m", [0, 1, 2, 3, 4, 5, 7, 8, 9, 12, 15, 16, 17, 23])
def test_factor_and_solution(m):
    rng = np.random.default_rng(m)
    A = rng.standard_normal((m + 3, m + 3))
    C, on, slope = A @ A.T, rng.permutation(m + 3)[:m], rng.uniform(0.0, 2.0, m)
    status, U, inverse = factor(C, on, slope)
    assert status == OK
    block = C[np.ix_(on, on)] + np.diag(slope)
    assert np.triu(U[:m, :m]) == pytest.approx(np.linalg.cholesky(block).T, abs=1e-12)
    b = np.full(len(inverse), np.nan)
    b[:m] = rng.standard_normal(m)
    expected = np.linalg.solve(block, b[:m])
    solve_block(U, m, inverse, b)
    assert b[:m] == pytest.approx(expected, abs=1e-10 * max(np.abs(expected).max(initial=0.0), 1.0))


@pytest.mark.parametrize("m", [2, 5, 11])
def test_failures(m):
    """A zero or negative pivot wherever it is, and numbers that are not finite."""
    for at in range(m):
        C = np.eye(m)
        C[at, at] = -1.0
        assert factor(C, np.arange(m), np.zeros(m))[0] == SINGULAR
        C[at, at] = np.nan
        assert factor(C, np.arange(m), np.zeros(m))[0] == NOT_FINITE
        C[at, at] = np.inf
        assert factor(C, np.arange(m), np.zeros(m))[0] == NOT_FINITE
    twice = np.arange(m)
    twice[-1] = 0
    C = np.diag(10.0 ** np.linspace(-6.0, 6.0, m)) + 1e-7
    assert factor(C, np.arange(m), np.zeros(m))[0] == OK
    assert factor(C, twice, np.zeros(m))[0] == SINGULAR
    assert factor(C, twice, np.full(m, 1e-3 * C[0, 0]))[0] == OK


@pytest.mark.parametrize("m", [0, 1, 7, 8, 9, 19])
def test_difference_of_forces(m):
    rng = np.random.default_rng(m)
    C = rng.standard_normal((20, 20))
    C += C.T
    on, f, x = rng.permutation(20).astype(np.int64), rng.standard_normal(20), rng.standard_normal(20)
    o = np.full(24, np.nan)
    subtract_columns(C, on, m, f, x, o)
    assert o[:20] == pytest.approx(x - C[:, on[:m]] @ f[on[:m]], abs=1e-13)
