# SPDX-License-Identifier: Apache-2.0
"""Wind at the blades: wind field, and the flow around a tower."""

from __future__ import annotations

from typing import Any

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.rotor.tower import TOWER, disturbed
from pitchpoint.elements.wind import WIND, wind_velocity
from pitchpoint.multibody.channels import F8

WIND_FIELDS: list[tuple[Any, ...]] = [
    ("wind", WIND),
    ("tower", TOWER),
    ("pool", "i8"),  # address of the pool that contains tower and box
    ("box", "i8"),  # offset of the box of turbulence, -1 without one
    ("sections", "i8"),  # offset of the heights and radii of the tower
]
"""Fields of a record with wind at blades."""
SAMPLE = np.dtype([*WIND_FIELDS, ("positions", "i8"), ("velocities", "i8"), ("t", "f8")], align=True)
"""Arguments of `air_entry`: wind, addresses of positions and velocities (n, 3), time [s]."""


@kernel
def undisturbed(b, at, t):
    """Velocity of the air at a point without tower, and status."""
    w = b["wind"]
    if b["box"] >= 0:
        w["box"] = b["pool"] + 8 * b["box"]
    return wind_velocity(w, at[0], at[1], at[2], t)


@kernel
def wind_of(b, at, t):
    """Velocity of the air at a point, with the flow around the tower, and status."""
    u, v, up, status = undisturbed(b, at, t)
    if status == OK and b["tower"]["n"] > 0:
        sections = view(b["pool"] + 8 * b["sections"], (b["tower"]["n"], 2), F8)
        u, v = disturbed(b["tower"], sections, at, u, v)
    return u, v, up, status


@kernel
def air_entry(_, where, n):
    """Velocities at n positions, from a `SAMPLE`."""
    b = view(where, 1, SAMPLE)[0]
    positions = view(b["positions"], (n, 3), F8)
    velocities = view(b["velocities"], (n, 3), F8)
    for k in range(n):
        u, v, up, status = wind_of(b, (positions[k, 0], positions[k, 1], positions[k, 2]), b["t"])
        if status != OK:
            return status
        velocities[k, 0] = u
        velocities[k, 1] = v
        velocities[k, 2] = up
    return OK
