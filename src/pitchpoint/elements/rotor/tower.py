# SPDX-License-Identifier: Apache-2.0
"""Wind around a tower: potential flow around a cylinder."""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK

TOWER_POINT = np.dtype(
    [
        ("x", "f8"),  # position from the axis of the tower, downwind and 90° counter-clockwise of it
        ("y", "f8"),
        ("radius", "f8"),  # radius of the tower at this height; 0 above it
        ("along", "f8"),  # results: wind along x and y over the wind without tower
        ("across", "f8"),
    ],
    align=True,
)


@kernel
def tower_flow(x, y, radius):
    """Wind along and across over the undisturbed wind: cylinder in potential flow (Lamb 1932).

    u = 1 - (x² - y²)/(x² + y²)² and v = -2 x y/(x² + y²)² with lengths over the radius; still air inside.
    """
    if radius <= 0.0:
        return 1.0, 0.0
    x /= radius
    y /= radius
    square = x * x + y * y
    if square < 1.0:
        return 0.0, 0.0
    return 1.0 - (x * x - y * y) / (square * square), -2.0 * x * y / (square * square)


@kernel
def tower_entry(ctl, rec, n):
    """Wind at n points; rec is the address of their records."""
    points = view(rec, n, TOWER_POINT)
    for k in range(n):
        p = points[k]
        along, across = tower_flow(p["x"], p["y"], p["radius"])
        p["along"] = along
        p["across"] = across
    return OK
