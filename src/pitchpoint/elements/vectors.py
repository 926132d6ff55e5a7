# SPDX-License-Identifier: Apache-2.0
"""Vectors of three numbers inside kernels: tuples, which cost no memory."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel


@kernel
def cross(a, b):
    """a x b."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@kernel
def dot(a, b):
    """a . b."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@kernel
def add(a, b):
    """a + b."""
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


@kernel
def less(a, b):
    """a - b."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


@kernel
def times(s, a):
    """s a."""
    return s * a[0], s * a[1], s * a[2]


@kernel
def unit(c):
    """Unit vector along axis c; zero if c is none of 0, 1, 2."""
    return 1.0 if c == 0 else 0.0, 1.0 if c == 1 else 0.0, 1.0 if c == 2 else 0.0


@kernel
def turned(A, a):
    """A a: from the axes whose columns A holds into those in which they are given."""
    return (
        A[0, 0] * a[0] + A[0, 1] * a[1] + A[0, 2] * a[2],
        A[1, 0] * a[0] + A[1, 1] * a[1] + A[1, 2] * a[2],
        A[2, 0] * a[0] + A[2, 1] * a[1] + A[2, 2] * a[2],
    )


@kernel
def triple(x):
    """The first three numbers of an array."""
    return x[0], x[1], x[2]


@kernel
def origin(f):
    """Origin of a body, world axes."""
    return f["r"][0], f["r"][1], f["r"][2]


@kernel
def spin_axis(f):
    """Spin axis of a body, world axes."""
    return f["R"][0, 2], f["R"][1, 2], f["R"][2, 2]


@kernel
def velocity(f):
    """Velocity of the origin of a body."""
    return f["tw"][0], f["tw"][1], f["tw"][2]


@kernel
def angular_velocity(f):
    """Angular velocity of a body, with its spin."""
    return f["tw"][3], f["tw"][4], f["tw"][5]


@kernel
def push(f, arm, force, couple, sense):
    """Add `sense` times a force at an arm from the origin of a body, and a couple, to its wrench."""
    m = add(cross(arm, force), couple)
    for r in range(3):
        f["F"][r] += sense * force[r]
        f["F"][3 + r] += sense * m[r]


@kernel
def put(k, c, s, force, couple):
    """Add s times a force and a couple to column c of a tangent."""
    for r in range(3):
        k[r, c] += s * force[r]
        k[3 + r, c] += s * couple[r]
