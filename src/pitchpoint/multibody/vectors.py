# SPDX-License-Identifier: Apache-2.0
"""Three numbers at a time: vectors as tuples, for kernels that need more of them than they have names for."""

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
    """Multiple."""
    return s * a[0], s * a[1], s * a[2]


@kernel
def plus(a, s, b):
    """a + s b."""
    return a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]


@kernel
def row(A, r):
    """Row r of a 3 x 3 matrix."""
    return A[r, 0], A[r, 1], A[r, 2]


@kernel
def column(A, c):
    """Column c of a 3 x 3 matrix."""
    return A[0, c], A[1, c], A[2, c]


@kernel
def triple(x, first):
    """Three numbers of an array: r (first 0), or the parts 0 and 3 of a twist."""
    return x[first], x[first + 1], x[first + 2]


@kernel
def unit(c):
    """Unit vector of column c of three; zero beyond."""
    return 1.0 if c == 0 else 0.0, 1.0 if c == 1 else 0.0, 1.0 if c == 2 else 0.0


@kernel
def into_world(S, a):
    """S a: vector with components a (tuple) along the columns of S, or any matrix (3, 3) times a vector."""
    return (
        S[0, 0] * a[0] + S[0, 1] * a[1] + S[0, 2] * a[2],
        S[1, 0] * a[0] + S[1, 1] * a[1] + S[1, 2] * a[2],
        S[2, 0] * a[0] + S[2, 1] * a[1] + S[2, 2] * a[2],
    )


@kernel
def into_body(S, a):
    """Components of a vector along the columns of S."""
    return (
        S[0, 0] * a[0] + S[1, 0] * a[1] + S[2, 0] * a[2],
        S[0, 1] * a[0] + S[1, 1] * a[1] + S[2, 1] * a[2],
        S[0, 2] * a[0] + S[1, 2] * a[1] + S[2, 2] * a[2],
    )


@kernel
def moved_axis(f, a):
    """Vector fixed to a body, given by its components in an array, in world axes."""
    return into_world(f["S"], triple(a, 0))
