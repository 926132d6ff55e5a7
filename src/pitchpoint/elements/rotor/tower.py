# SPDX-License-Identifier: Apache-2.0
"""Wind around a tower: potential flow around a cylinder."""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel

TOWER = np.dtype(
    [
        ("n", "i8"),  # sections of the tower; 0 without one
        ("x", "f8"),  # its axis in the world [m]
        ("y", "f8"),
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
def radius_at(sections, z):
    """Radius at a height from rows of height and radius; zero above the tower."""
    last = sections.shape[0] - 1
    if z > sections[last, 0]:
        return 0.0
    k = 0
    while k < last - 1 and sections[k + 1, 0] < z:
        k += 1
    share = (z - sections[k, 0]) / (sections[k + 1, 0] - sections[k, 0])
    share = max(share, 0.0)
    return (1.0 - share) * sections[k, 1] + share * sections[k + 1, 1]


@kernel
def disturbed(tower, sections, at, u, v):
    """Horizontal velocities u and v of the wind at a point, with the flow around the tower."""
    square = u * u + v * v
    if square == 0.0:
        return u, v
    dx = at[0] - tower["x"]
    dy = at[1] - tower["y"]
    speed = math.sqrt(square)
    along, across = tower_flow(
        (u * dx + v * dy) / speed, (u * dy - v * dx) / speed, radius_at(sections, at[2])
    )
    return along * u - across * v, along * v + across * u
