# SPDX-License-Identifier: Apache-2.0
"""Outlines of drawn gears, and where points lie against them."""

from __future__ import annotations

import numpy as np


def end_face(scene, name, frame, origin, axes):
    """Edges of a gear's upper end face, shape (n, 2, 2), in the plane across the axes: those of triangles of
    the flanks, which have their third corner elsewhere."""
    points, triangles = scene.mesh(name)
    height = points[:, 2]
    at_end = np.isclose(height, height.max(), atol=1e-9)[triangles]
    flanks = at_end.sum(axis=1) == 2
    pairs = triangles[flanks][at_end[flanks]].reshape(-1, 2)
    return ((scene.placed(name, frame) - origin) @ axes)[:, :2][pairs]


def inside(points, edges):
    """Which points lie inside of closed lines (even-odd rule)."""
    x, y = points[:, :1], points[:, 1:]
    (x0, y0), (x1, y1) = edges[:, 0].T, edges[:, 1].T
    rise = np.where(y1 == y0, 1.0, y1 - y0)
    return (((y0 > y) != (y1 > y)) & (x < x0 + (y - y0) / rise * (x1 - x0))).sum(axis=1) % 2 == 1


def depth(point, edges):
    """Distance of a point from the nearest edge [m]."""
    start, along = edges[:, 0], edges[:, 1] - edges[:, 0]
    length = (along**2).sum(axis=1)
    share = np.clip(((point - start) * along).sum(axis=1) / np.where(length > 0.0, length, 1.0), 0.0, 1.0)
    return np.hypot(*(start + share[:, None] * along - point).T).min()
