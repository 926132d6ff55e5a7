# SPDX-License-Identifier: Apache-2.0
"""History of a multistep method: values at earlier times, and the polynomials through them.

Row j of the history is the state at the offset times[j] <= 0 from the latest one (times[0] = 0). The backward
differences, Nordsieck arrays and divided differences of the literature are all linear combinations of these
rows; their weights are computed once per step for all coordinates.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel

DEPTH = 8
"""Rows of the history: order 6 needs 7 for its predictor and one more for the error estimate of order 7."""


@kernel
def weights_at(times, n, s, w):
    """Weights of n values for their interpolation polynomial at the offset s."""
    for j in range(n):
        p = 1.0
        for i in range(n):
            if i != j:
                p *= (s - times[i]) / (times[j] - times[i])
        w[j] = p


@kernel
def slopes_at(times, n, s, w):
    """Weights of n values for the derivative of their interpolation polynomial at the offset s."""
    for j in range(n):
        total = 0.0
        for k in range(n):
            if k != j:
                p = 1.0 / (times[j] - times[k])
                for i in range(n):
                    if i != j and i != k:
                        p *= (s - times[i]) / (times[j] - times[i])
                total += p
        w[j] = total


@kernel
def difference_weights(times, n, h, w):
    """Weights of a value at the offset h (first) and n earlier values for h^n times the n-th derivative."""
    for j in range(n + 1):
        mine = h if j == 0 else times[j - 1]
        p = 1.0
        for i in range(n + 1):
            if i != j:
                p *= (mine - (h if i == 0 else times[i - 1])) / h
        w[j] = 1.0 / p
    factorial = 1.0
    for i in range(2, n + 1):
        factorial *= i
    for j in range(n + 1):
        w[j] *= factorial


@kernel
def combine(rows, n, w, out):
    """Weighted sum of n rows."""
    for i in range(out.size):
        s = 0.0
        for j in range(n):
            s += w[j] * rows[j, i]
        out[i] = s


@kernel
def regrid(rows, times, n, h, W):
    """Interpolate n rows to the offsets 0, -h, -2h ...: the history of a constant step h."""
    for m in range(1, n):
        weights_at(times, n, -m * h, W[m])
    for i in range(rows.shape[1]):
        for m in range(1, n):
            s = 0.0
            for j in range(n):
                s += W[m, j] * rows[j, i]
            W[0, m] = s
        for m in range(1, n):
            rows[m, i] = W[0, m]
    for m in range(1, n):
        times[m] = -m * h


@kernel
def push(rows, times, n, h):
    """Shift n rows to make room for a new row at the offset h, which becomes the origin."""
    for j in range(n, 0, -1):
        for i in range(rows.shape[1]):
            rows[j, i] = rows[j - 1, i]
        times[j] = times[j - 1] - h
    times[0] = 0.0


@kernel
def _multiply(p, degree, root, scale):
    """Multiply a polynomial (coefficients by power) by (x - root) scale."""
    p[degree + 1] = 0.0
    for k in range(degree + 1, 0, -1):
        p[k] = (p[k - 1] - root * p[k]) * scale
    p[0] = -root * p[0] * scale


@kernel
def dense_weights(times, n, h, W, p):
    """Weights W[r, j] of value j for the dense output coefficient r of the last step.

    y = c0 + x (c1 + (1 - x) (c2 + x (c3 + ...))) with x from 0 to 1 over the step of length h that ended at
    the offset 0; see `explicit.dense_output.interpolate`.
    """
    for j in range(n):
        for k in range(n):
            p[k] = 0.0
        p[0] = 1.0
        degree = 0
        mine = 1.0 + times[j] / h
        for i in range(n):
            if i != j:
                root = 1.0 + times[i] / h
                _multiply(p, degree, root, 1.0 / (mine - root))
                degree += 1
        for r in range(n):
            left = n - 1 - r
            if r % 2 == 0:  # value at x = 0, then divide by x
                W[r, j] = p[0]
                for k in range(left):
                    p[k] = p[k + 1]
            else:  # value at x = 1, then divide by 1 - x
                s = 0.0
                for k in range(left, -1, -1):
                    s += p[k]
                    p[k] = -s  # sums from above are the quotient by x - 1
                W[r, j] = s
                for k in range(left):
                    p[k] = p[k + 1]
