# SPDX-License-Identifier: Apache-2.0
"""Labels next to a drawing that do not cover each other: spread along a column, each joined to its place."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pitchpoint.viz.svg import Array


def spread(wanted: Sequence[float], step: float, low: float, high: float) -> Array:
    """Places along a column at least a step apart, as near as can be to those that are wanted.

    Parameters
    ----------
    wanted
        Places that labels would like to have, in any order.
    step
        Least distance between two of them.
    low, high
        Ends of the column; what does not fit continues beyond `high`.

    Returns
    -------
    ndarray
        Places in the order of `wanted`, in which their order along the column stays.

    Notes
    -----
    Labels that meet form a group around the mean of what they want; groups that meet become one.

    Examples
    --------
    >>> spread([10.0, 12.0, 50.0], 10.0, 0.0, 100.0).tolist()
    [6.0, 16.0, 50.0]
    """
    order = np.argsort(np.asarray(wanted, dtype=np.float64), kind="stable")
    groups: list[list[float]] = []  # first place, number of labels, sum of what the first place should be
    for at in np.asarray(wanted, dtype=np.float64)[order]:
        groups.append([float(at), 1.0, float(at)])
        while True:
            first, count, total = groups[-1]
            groups[-1][0] = min(max(total / count, low), max(low, high - (count - 1.0) * step))
            if len(groups) < 2 or groups[-1][0] >= groups[-2][0] + groups[-2][1] * step:
                break
            first, count, total = groups.pop()
            before = groups[-1]
            # the first of the later group is `before[1]` steps behind the first of the joint one
            before[2] += total - count * before[1] * step
            before[1] += count
    found = np.empty(len(order))
    found[order] = [first + k * step for first, count, _ in groups for k in range(int(count))]
    return found
