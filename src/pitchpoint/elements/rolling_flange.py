# SPDX-License-Identifier: Apache-2.0
"""Flanges of a cylindrical roller bearing: axial contact between the rings over the ends of the rollers.

The inner ring, displaced by Z along the axis, touches a flange at `flange_high` (force along -z) or at
`flange_low` (along +z); the force is k d max(0, 1 + chi d') with the depth d beyond it. It acts on the axis
of the bearing: the flanges do not resist tilting, and their friction is neglected.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel


@kernel
def push_flange(b, jac):
    """Add the force of the flanges, and its slopes, to the scratch f, K and D."""
    k = b["flange"]
    if k == 0.0:
        return
    z = b["x"][2] + b["shift"]
    side = 1.0
    depth = z - b["flange_high"]
    if depth <= 0.0:
        side = -1.0
        depth = b["flange_low"] - z
    if depth <= 0.0:
        return
    damped = 1.0 + b["chi"] * side * b["w"][2]
    if damped <= 0.0:
        return
    b["f"][2] -= side * k * depth * damped
    if jac != 0:
        b["K"][2, 2] += k * damped
        b["D"][2, 2] += k * depth * b["chi"]
