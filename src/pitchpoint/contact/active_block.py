# SPDX-License-Identifier: Apache-2.0
"""Cholesky factorisation of the block of a compliance matrix that belongs to the nodes in contact.

A = U^T U with U in the upper triangle, by rows. All inner loops run along rows, which are contiguous, from a
multiple of `LANES` to a multiple of it, so that they become vector instructions without a remainder. Four
rows are subtracted from four at a time: a load serves several products, and the compiler does not unroll so
large a loop beyond the short rows of small blocks.

Source: Golub and Van Loan, Matrix Computations (2013), 4.2.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel
from pitchpoint.core.status import NOT_FINITE, OK, SINGULAR

LANES = 8
"""Number of columns to which rows are padded; the width of U is a multiple of it."""
ROWS = 4
"""Number of rows that are treated together."""

_SINGULAR = 2e-14
"""Smallest pivot relative to the diagonal element before elimination."""


@kernel
def pack_block(C, on, m, slope, U):
    """Copy the block of m nodes to the upper triangle of U and add slopes to its diagonal.

    The block is completed with rows and columns of the unit matrix to a multiple of `ROWS`; further columns
    up to the next multiple of `LANES` are set to zero.

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
    >>> C = np.array([[4.0, 3.0, 2.0], [3.0, 5.0, 1.0], [2.0, 1.0, 6.0]])
    >>> pack_block(C, np.array([2, 0, 0]), 2, np.array([0.5, 0.25]), U)
    >>> U[:2, :4].tolist()
    [[6.5, 2.0, 0.0, 0.0], [2.0, 4.25, 0.0, 0.0]]
    """
    width = ((m + LANES - 1) // LANES) * LANES
    for i in range(((m + ROWS - 1) // ROWS) * ROWS):
        row = U[i]
        first = (i // LANES) * LANES
        if i < m:
            source = C[on[i]]
            for j in range(first, m):
                row[j] = source[on[j]]
            for j in range(m, width):
                row[j] = 0.0
            row[i] += slope[i]
        else:
            for j in range(first, width):
                row[j] = 0.0
            row[i] = 1.0


@kernel
def _root(pivot, diagonal):
    """Reciprocal root of a pivot, and SINGULAR if it is not positive within the rounding of the diagonal."""
    if pivot > _SINGULAR * diagonal and pivot < np.inf:
        return 1.0 / math.sqrt(pivot), OK
    return 0.0, SINGULAR if pivot < np.inf and diagonal < np.inf else NOT_FINITE


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
        Reciprocal diagonal of the factor, up to the next multiple of `ROWS` of m.

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
    for i in range(0, m, ROWS):
        first = (i // LANES) * LANES
        width = end - first
        x = U[i, first:]
        y = U[i + 1, first:]
        z = U[i + 2, first:]
        w = U[i + 3, first:]
        d_0 = U[i, i]
        d_1 = U[i + 1, i + 1]
        d_2 = U[i + 2, i + 2]
        d_3 = U[i + 3, i + 3]
        for k in range(0, i, ROWS):
            p = U[k, first:]
            q = U[k + 1, first:]
            r = U[k + 2, first:]
            s = U[k + 3, first:]
            p_0, p_1, p_2, p_3 = U[k, i], U[k, i + 1], U[k, i + 2], U[k, i + 3]
            q_0, q_1, q_2, q_3 = U[k + 1, i], U[k + 1, i + 1], U[k + 1, i + 2], U[k + 1, i + 3]
            r_0, r_1, r_2, r_3 = U[k + 2, i], U[k + 2, i + 1], U[k + 2, i + 2], U[k + 2, i + 3]
            s_0, s_1, s_2, s_3 = U[k + 3, i], U[k + 3, i + 1], U[k + 3, i + 2], U[k + 3, i + 3]
            for j in range(width):
                e = p[j]
                f = q[j]
                g = r[j]
                h = s[j]
                x[j] -= p_0 * e + q_0 * f + r_0 * g + s_0 * h
                y[j] -= p_1 * e + q_1 * f + r_1 * g + s_1 * h
                z[j] -= p_2 * e + q_2 * f + r_2 * g + s_2 * h
                w[j] -= p_3 * e + q_3 * f + r_3 * g + s_3 * h
        # factor of the four rows on the diagonal, then the four rows
        a_0, sound_0 = _root(U[i, i], d_0)
        x_1, x_2, x_3 = U[i, i + 1] * a_0, U[i, i + 2] * a_0, U[i, i + 3] * a_0
        a_1, sound_1 = _root(U[i + 1, i + 1] - x_1 * x_1, d_1)
        y_2, y_3 = (U[i + 1, i + 2] - x_1 * x_2) * a_1, (U[i + 1, i + 3] - x_1 * x_3) * a_1
        a_2, sound_2 = _root(U[i + 2, i + 2] - x_2 * x_2 - y_2 * y_2, d_2)
        z_3 = (U[i + 2, i + 3] - x_2 * x_3 - y_2 * y_3) * a_2
        a_3, sound_3 = _root(U[i + 3, i + 3] - x_3 * x_3 - y_3 * y_3 - z_3 * z_3, d_3)
        status = max(sound_0, sound_1, sound_2, sound_3)
        if status != OK:
            return status
        for j in range(width):
            e = x[j] * a_0
            f = (y[j] - x_1 * e) * a_1
            g = (z[j] - x_2 * e - y_2 * f) * a_2
            x[j] = e
            y[j] = f
            z[j] = g
            w[j] = (w[j] - x_3 * e - y_3 * f - z_3 * g) * a_3
        inverse[i] = a_0
        inverse[i + 1] = a_1
        inverse[i + 2] = a_2
        inverse[i + 3] = a_3
    return OK


@kernel
def solve_block(U, m, inverse, b):
    """Solve with a factorised block, in place.

    Parameters
    ----------
    U, m, inverse
        Factor, see `factorise_block`.
    b
        Right-hand side on entry, solution on exit; up to the next multiple of `ROWS` it is overwritten.

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
    end = ((m + ROWS - 1) // ROWS) * ROWS
    for j in range(m, end):
        b[j] = 0.0
    for k in range(0, end, ROWS):
        p = U[k, k:end]
        q = U[k + 1, k:end]
        r = U[k + 2, k:end]
        s = U[k + 3, k:end]
        rest = b[k:end]
        e = rest[0] * inverse[k]
        f = (rest[1] - p[1] * e) * inverse[k + 1]
        g = (rest[2] - p[2] * e - q[2] * f) * inverse[k + 2]
        h = (rest[3] - p[3] * e - q[3] * f - r[3] * g) * inverse[k + 3]
        for j in range(ROWS, end - k):
            rest[j] -= p[j] * e + q[j] * f + r[j] * g + s[j] * h
        rest[0] = e
        rest[1] = f
        rest[2] = g
        rest[3] = h
    for k in range(end - ROWS, -1, -ROWS):
        p = U[k, k:end]
        q = U[k + 1, k:end]
        r = U[k + 2, k:end]
        s = U[k + 3, k:end]
        rest = b[k:end]
        e = rest[0]
        f = rest[1]
        g = rest[2]
        h = rest[3]
        for j in range(ROWS, end - k):
            e -= p[j] * rest[j]
            f -= q[j] * rest[j]
            g -= r[j] * rest[j]
            h -= s[j] * rest[j]
        h *= inverse[k + 3]
        g = (g - r[3] * h) * inverse[k + 2]
        f = (f - q[2] * g - q[3] * h) * inverse[k + 1]
        e = (e - p[1] * f - p[2] * g - p[3] * h) * inverse[k]
        rest[0] = e
        rest[1] = f
        rest[2] = g
        rest[3] = h


@kernel
def subtract_columns(C, on, m, f, x, o):
    """Difference x - C f for forces at m nodes.

    Parameters
    ----------
    C
        Symmetric matrix, shape (n, n) or larger.
    on
        Indices of the nodes with forces, the first m of which are used.
    m
        Number of these nodes.
    f
        Forces by node.
    x
        Minuend, shape (n,).
    o
        Difference, shape (n,).

    Examples
    --------
    >>> C, o = np.array([[4.0, 2.0], [2.0, 5.0]]), np.zeros(2)
    >>> subtract_columns(C, np.array([1]), 1, np.array([9.0, 2.0]), np.array([5.0, 5.0]), o)
    >>> o.tolist()
    [1.0, -5.0]
    """
    n = x.size
    for i in range(n):
        o[i] = x[i]
    whole = (m // LANES) * LANES
    for k in range(0, whole, LANES):
        a, b, c, d = on[k], on[k + 1], on[k + 2], on[k + 3]
        e, g, h, i = on[k + 4], on[k + 5], on[k + 6], on[k + 7]
        p, q, r, s = C[a], C[b], C[c], C[d]
        t, u, v, w = C[e], C[g], C[h], C[i]
        f_p, f_q, f_r, f_s = f[a], f[b], f[c], f[d]
        f_t, f_u, f_v, f_w = f[e], f[g], f[h], f[i]
        for j in range(n):
            first = f_p * p[j] + f_q * q[j] + f_r * r[j] + f_s * s[j]
            o[j] -= first + (f_t * t[j] + f_u * u[j] + f_v * v[j] + f_w * w[j])
    for k in range(whole, m):
        p = C[on[k]]
        f_p = f[on[k]]
        for j in range(n):
            o[j] -= f_p * p[j]
