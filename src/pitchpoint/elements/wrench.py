# SPDX-License-Identifier: Apache-2.0
"""Access to body frames in kernels: vectors as tuples, addition of wrenches and tangents."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.multibody.vectors import add, cross, triple


@kernel
def origin(f):
    """Origin of a body, world axes."""
    return triple(f["r"], 0)


@kernel
def spin_axis(f):
    """Spin axis of a body, world axes."""
    return f["R"][0, 2], f["R"][1, 2], f["R"][2, 2]


@kernel
def velocity(f):
    """Velocity of the origin of a body."""
    return triple(f["tw"], 0)


@kernel
def angular_velocity(f):
    """Angular velocity of a body, spin included."""
    return triple(f["tw"], 3)


@kernel
def push(f, arm, force, couple, sense):
    """Add `sense` times a force at `arm` from the origin of a body, and a couple, to its wrench."""
    m = add(cross(arm, force), couple)
    for r in range(3):
        f["F"][r] += sense * force[r]
        f["F"][3 + r] += sense * m[r]


@kernel
def put(k, c, s, force, couple):
    """Add s times a force and a couple to column c of a tangent block."""
    for r in range(3):
        k[r, c] += s * force[r]
        k[3 + r, c] += s * couple[r]
