# SPDX-License-Identifier: Apache-2.0
"""Labels next to a drawing without overlap: spread along a column, with leader lines to their positions."""

from __future__ import annotations

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
