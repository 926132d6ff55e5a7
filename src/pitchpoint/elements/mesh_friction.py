# SPDX-License-Identifier: Apache-2.0
"""Torques that the friction of a mesh puts on both gears, cylindrical or bevel, about their own axes.

A normal force F along the base tangent turns both gears by -r_b F. Friction has no such radius: it acts along
the tooth, at the distance of the contact from where the line of action touches each base circle, and it turns
round at the pitch point. What it takes from one gear and gives to the other follows from these two torques.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel


@kernel
def add_friction_torques(b, out, at, f, g, first):
    """Add friction, three rows of the wrench basis from `first` on, to the observations `at` and the next."""
    for p in range(first, first + 3):
        s = b["acc"][p]
        for k in range(3):
            out[at] += s * b["basis_i"][p, 3 + k] * f["R"][k, 2]
            out[at + 1] += s * b["basis_j"][p, 3 + k] * g["R"][k, 2]
