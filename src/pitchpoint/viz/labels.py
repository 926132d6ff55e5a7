# SPDX-License-Identifier: Apache-2.0
"""Labels without overlap: spread along a column next to a drawing, or around the points that they mark."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.viz.svg import Array


def spread(wanted: Sequence[float], step: ArrayLike, low: float, high: float) -> Array:
    """Positions along a column without overlap, as close as possible to the wanted ones.

    Parameters
    ----------
    wanted
        Wanted middles, in any order.
    step
        Length of each label along the column, or of all: least distance of two middles.
    low, high
        First and last middle; excess labels continue beyond `high`.

    Returns
    -------
    ndarray
        Middles in the order of `wanted`, with unchanged order along the column.

    Notes
    -----
    Less the lengths of the labels before them, the middles only have to rise: an isotonic regression, which
    also holds the least squares within bounds when it is cut to them.

    Examples
    --------
    >>> spread([10.0, 12.0, 50.0], 10.0, 0.0, 100.0).tolist()
    [6.0, 16.0, 50.0]
    >>> spread([50.0, 50.0], [10.0, 30.0], 0.0, 100.0).tolist()
    [40.0, 60.0]
    """
    from scipy.optimize import isotonic_regression

    at = np.asarray(wanted, dtype=np.float64)
    if not at.size:
        return at
    order = np.argsort(at, kind="stable")
    length = np.broadcast_to(np.asarray(step, dtype=np.float64), at.shape)[order]
    before = np.concatenate([[0.0], np.cumsum(0.5 * (length[1:] + length[:-1]))])
    rising = isotonic_regression(at[order] - before).x
    found = np.empty(at.size)
    found[order] = np.maximum(np.minimum(rising, high - before[-1]), low) + before
    return found


RINGS = (1.0, 2.2, 3.4, 4.6)
"""Distances of a label from its point, over the least one."""
OWN = 1.6
"""Least distance of a label next to its point from all other points, over that from its own."""
TURNS = (135, 90, 45, 180, 0, 225, 315, 270)
"""Directions of a label from its point [deg], the preferred one first."""


def around(points: Array, size: float, room: tuple[float, float]) -> Array:
    """Places of small labels around the points that they mark, clear of each other and of all points.

    Parameters
    ----------
    points
        Points, shape (n, 2), y upwards; the first ones choose first.
    size
        Width and height of a label; also the least distance from its point.
    room
        Width and height of the drawing, which contains the labels where it can.

    Returns
    -------
    ndarray
        Centres of the labels relative to their points, shape (n, 2): in one of eight directions, next to the
        point, or further away where other points are close; these need a leader line.

    Examples
    --------
    >>> around(np.array([[50.0, 50.0], [90.0, 50.0]]), 12.0, (100.0, 100.0)).round(1).tolist()
    [[-12.0, 12.0], [-12.0, 12.0]]
    """
    ways = [
        ring * size * np.round(np.array([math.cos(turn), math.sin(turn)]) * 1.4142, 0)
        for ring, turn in itertools.product(RINGS, map(math.radians, TURNS))
    ]
    least = np.repeat([OWN, *[1.0] * (len(RINGS) - 1)], len(TURNS)) * size
    found = np.zeros((len(points), 2))
    for k, point in enumerate(points):
        places = point + np.array(ways)
        others = np.delete(points, k, axis=0)
        from_points = _nearest(places, others) - least
        from_labels = _nearest(places, points[:k] + found[:k]) - size
        inside = ((places >= 0.0) & (places <= np.array(room))).all(axis=1)
        room_left = np.where(inside, np.minimum(from_points, from_labels), -np.inf)
        clear = np.flatnonzero(room_left >= -1e-9)
        found[k] = ways[int(clear[0]) if clear.size else int(np.argmax(room_left))]
    return found


def _nearest(places: Array, others: Array) -> Array:
    """Distance of each place from the nearest of others, along the axis in which it is larger."""
    if not len(others):
        return np.full(len(places), np.inf)
    return np.asarray(np.abs(places[:, None] - others).max(axis=2).min(axis=1))
