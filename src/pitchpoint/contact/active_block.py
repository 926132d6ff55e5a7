# SPDX-License-Identifier: Apache-2.0
"""Cholesky factorisation of the block of a compliance matrix that belongs to the nodes in contact.

A = U^T U with U in the upper triangle, by rows. All inner loops run along rows, which are contiguous, from a
multiple of `LANES` to a multiple of it, so that they become vector instructions without a remainder. The
factorisation subtracts four rows from two at a time.

Source: Golub and Van Loan, Matrix Computations (2013), 4.2.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel
from pitchpoint.core.status import NOT_FINITE, OK, SINGULAR

LANES = 8
"""Number of columns to which rows are padded; the width of U is a multiple of it."""

_SINGULAR = 2e-14
"""Smallest pivot relative to the diagonal element before elimination."""


@kernel
def pack_block(C, on, m, slope, U):
    """Copy the block of m nodes to the upper triangle of U and add slopes to its diagonal.

    Columns up to the next multiple of `LANES` are set to zero; an odd block gets one more row of the unit
    matrix.

    Parameters
    ----------
    C
        Symmetric matrix, shape (n, n).
    on
        Indices of the nodes, the first m of which are used.
    m
        Number of nodes.
    slope
        Additional diagonal, one value per node of the block.
    U
        Result, shape (w, w), w a multiple of `LANES` and at least m.

    Examples
    --------
    >>> U = np.ones((8, 8))
    >>> pack_block(np.arange(9.0).reshape(3, 3), np.array([2, 0, 0]), 2, np.array([0.5, 0.25]), U)
    >>> U[:2, :4].tolist()
    [[8.5, 6.0, 0.0, 0.0], [6.0, 0.25, 0.0, 0.0]]
    """
    width = ((m + LANES - 1) // LANES) * LANES
    for i in range(m):
        row = U[i]
        source = C[on[i]]
        first = (i // LANES) * LANES
        for j in range(first, m):
            row[j] = source[on[j]]
        for j in range(m, width):
            row[j] = 0.0
        row[i] += slope[i]
    if m % 2 == 1:
        row = U[m]
        for j in range((m // LANES) * LANES, width):
            row[j] = 0.0
        row[m] = 1.0


@kernel
def factorise_block(U, m, inverse):
    """Cholesky factor of a packed block, in place.

    Parameters
    ----------
    U
        Block from `pack_block`.
    m
        Number of nodes.
    inverse
        Reciprocal diagonal of the factor, one value per node and one more if m is odd.

    Returns
    -------
    int
        OK; SINGULAR if a pivot is zero or negative within rounding; NOT_FINITE.

    Examples
    --------
    >>> U, inverse = np.zeros((8, 8)), np.zeros(8)
    >>> pack_block(np.array([[4.0, 2.0], [2.0, 5.0]]), np.array([0, 1]), 2, np.zeros(2), U)
    >>> factorise_block(U, 2, inverse)
    1
    >>> U[0, :2].tolist(), float(U[1, 1]), inverse[:2].tolist()
    ([2.0, 1.0], 2.0, [0.5, 0.5])
    """
    end = ((m + LANES - 1) // LANES) * LANES
    for i in range(0, m, 2):
        first = (i // LANES) * LANES
        width = end - first
        x = U[i, first:]
        y = U[i + 1, first:]
        limit = _SINGULAR * U[i, i]
        next_limit = _SINGULAR * U[i + 1, i + 1]
        for k in range(0, i - 2, 4):
            p = U[k, first:]
            q = U[k + 1, first:]
            r = U[k + 2, first:]
            s = U[k + 3, first:]
            a = U[k, i]
            b = U[k + 1, i]
            c = U[k + 2, i]
            d = U[k + 3, i]
            e = U[k, i + 1]
            f = U[k + 1, i + 1]
            g = U[k + 2, i + 1]
            h = U[k + 3, i + 1]
            for j in range(width):
                x[j] -= a * p[j] + b * q[j] + c * r[j] + d * s[j]
                y[j] -= e * p[j] + f * q[j] + g * r[j] + h * s[j]
        if i % 4 == 2:
            p = U[i - 2, first:]
            q = U[i - 1, first:]
            a = U[i - 2, i]
            b = U[i - 1, i]
            e = U[i - 2, i + 1]
            f = U[i - 1, i + 1]
            for j in range(width):
                x[j] -= a * p[j] + b * q[j]
                y[j] -= e * p[j] + f * q[j]
        pivot = U[i, i]
        if not pivot > limit:
            return SINGULAR if pivot <= limit else NOT_FINITE
        a = 1.0 / math.sqrt(pivot)
        b = U[i, i + 1] * a
        pivot = U[i + 1, i + 1] - b * b
        if not pivot > next_limit:
            return SINGULAR if pivot <= next_limit else NOT_FINITE
        c = 1.0 / math.sqrt(pivot)
        if not a * c > 0.0:
            return NOT_FINITE
        for j in range(width):
            x[j] *= a
            y[j] = (y[j] - b * x[j]) * c
        inverse[i] = a
        inverse[i + 1] = c
    return OK


@kernel
def solve_block(U, m, inverse, b):
    """Solve with a factorised block, in place.

    Parameters
    ----------
    U, m, inverse
        Factor, see `factorise_block`.
    b
        Right-hand side on entry, solution on exit; up to the next multiple of `LANES` it is overwritten.

    Examples
    --------
    >>> U, inverse, b = np.zeros((8, 8)), np.zeros(8), np.array([8.0, 9.0, 0, 0, 0, 0, 0, 0])
    >>> pack_block(np.array([[4.0, 2.0], [2.0, 5.0]]), np.array([0, 1]), 2, np.zeros(2), U)
    >>> factorise_block(U, 2, inverse)
    1
    >>> solve_block(U, 2, inverse, b)
    >>> b[:2].round(12).tolist()
    [1.375, 1.25]
    """
    end = ((m + LANES - 1) // LANES) * LANES
    for j in range(m, end):
        b[j] = 0.0
    for k in range(0, m, 2):
        # rows k and k + 1: forward elimination of their columns from all that follow
        x = b[k] * inverse[k]
        y = (b[k + 1] - U[k, k + 1] * x) * inverse[k + 1]
        p = U[k, k:]
        q = U[k + 1, k:]
        rest = b[k:]
        for j in range(2, end - k):
            rest[j] -= p[j] * x + q[j] * y
        rest[0] = x
        rest[1] = y
    for k in range(((m - 1) // 2) * 2, -1, -2):
        p = U[k, k:]
        q = U[k + 1, k:]
        rest = b[k:]
        x = 0.0
        y = 0.0
        for j in range(2, m - k):
            x += p[j] * rest[j]
            y += q[j] * rest[j]
        y = (rest[1] - y) * inverse[k + 1]
        rest[0] = (rest[0] - x - p[1] * y) * inverse[k]
        rest[1] = y
