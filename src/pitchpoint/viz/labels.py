# SPDX-License-Identifier: Apache-2.0
"""Labels without overlap: spread along a column next to a drawing, or around the points that they mark."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

import numpy as np

from pitchpoint.viz.svg import Array


def spread(wanted: Sequence[float], step: float, low: float, high: float) -> Array:
    """Positions along a column at least a step apart, as close as possible to the wanted ones.

    Parameters
    ----------
    wanted
        Wanted positions, in any order.
    step
        Minimum distance between two positions.
    low, high
        Ends of the column; excess labels continue beyond `high`.

    Returns
    -------
    ndarray
        Positions in the order of `wanted`, with unchanged order along the column.

    Notes
    -----
    Overlapping labels form a group around the mean of their wanted positions; overlapping groups are merged.

    Examples
    --------
    >>> spread([10.0, 12.0, 50.0], 10.0, 0.0, 100.0).tolist()
    [6.0, 16.0, 50.0]
    """
    order = np.argsort(np.asarray(wanted, dtype=np.float64), kind="stable")
    groups: list[list[float]] = []  # first position, number of labels, sum of the wanted first positions
    for at in np.asarray(wanted, dtype=np.float64)[order]:
        groups.append([float(at), 1.0, float(at)])
        while True:
            first, count, total = groups[-1]
            groups[-1][0] = min(max(total / count, low), max(low, high - (count - 1.0) * step))
            if len(groups) < 2 or groups[-1][0] >= groups[-2][0] + groups[-2][1] * step:
                break
            first, count, total = groups.pop()
            before = groups[-1]
            # the first of the later group is `before[1]` steps after the first of the merged one
            before[2] += total - count * before[1] * step
            before[1] += count
    found = np.empty(len(order))
    found[order] = [first + k * step for first, count, _ in groups for k in range(int(count))]
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
