# SPDX-License-Identifier: Apache-2.0
"""Vectors in space as tuples of three numbers, for kernels."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel


@kernel
def cross(a, b):
    """Vector product."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@kernel
def dot(a, b):
    """Scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@kernel
def add(a, b):
    """Sum."""
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


@kernel
def less(a, b):
    """Difference."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


@kernel
def times(s, a):
    """Scalar times vector, s a."""
    return s * a[0], s * a[1], s * a[2]


@kernel
def plus(a, s, b):
    """a + s b."""
    return a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]


@kernel
def row(A, r):
    """Row r of an array (n, 3)."""
    return A[r, 0], A[r, 1], A[r, 2]


@kernel
def column(A, c):
    """Column c of an array (3, n)."""
    return A[0, c], A[1, c], A[2, c]


@kernel
def along(axes, a):
    """Components along three axes."""
    return dot(axes[0], a), dot(axes[1], a), dot(axes[2], a)


@kernel
def set_row(A, r, a):
    """Write a vector to row r of an array (n, 3)."""
    A[r, 0] = a[0]
    A[r, 1] = a[1]
    A[r, 2] = a[2]


@kernel
def triple(x, first):
    """Three consecutive elements of an array, such as the linear (0) or angular (3) part of a twist."""
    return x[first], x[first + 1], x[first + 2]


@kernel
def unit(c):
    """Unit vector c of three; zero for other c."""
    return 1.0 if c == 0 else 0.0, 1.0 if c == 1 else 0.0, 1.0 if c == 2 else 0.0


@kernel
def into_world(S, a):
    """S a: world components of a vector given in body axes S, or any (3, 3) matrix times a vector."""
    return (
        S[0, 0] * a[0] + S[0, 1] * a[1] + S[0, 2] * a[2],
        S[1, 0] * a[0] + S[1, 1] * a[1] + S[1, 2] * a[2],
        S[2, 0] * a[0] + S[2, 1] * a[1] + S[2, 2] * a[2],
    )


@kernel
def into_body(S, a):
    """S^T a: components of a world vector along the columns of S."""
    return (
        S[0, 0] * a[0] + S[1, 0] * a[1] + S[2, 0] * a[2],
        S[0, 1] * a[0] + S[1, 1] * a[1] + S[2, 1] * a[2],
        S[0, 2] * a[0] + S[1, 2] * a[1] + S[2, 2] * a[2],
    )


@kernel
def moved_axis(f, a):
    """World components of a body-fixed vector, given by an array of its components in axes S."""
    return into_world(f["S"], triple(a, 0))
