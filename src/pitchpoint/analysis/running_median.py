# SPDX-License-Identifier: Apache-2.0
"""Running median of a spectrum: its background without the lines."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.sampled import Array

PLACES = 8
"""Medians per width; between them the background is interpolated."""
AT_ONCE = 1 << 20
"""Maximum number of values sorted at once."""


def running_median(power: Array, count: int) -> Array:
    """Median over `count` lines at places between which it is interpolated; at the ends of the last ones.

    Parameters
    ----------
    power
        Values of the lines, shape (n,), any unit.
    count
        Number of lines, at most n [-].

    Returns
    -------
    NDArray
        Shape (n,), in the unit of `power`.

    Examples
    --------
    A single high line has no effect:

    >>> running_median(np.array([1.0, 1.0, 9.0, 1.0, 1.0]), 3).tolist()
    [1.0, 1.0, 1.0, 1.0, 1.0]
    """
    starts = np.unique(
        np.append(np.arange(0, power.size - count, max(1, count // PLACES)), power.size - count)
    )
    windows: NDArray[np.float64] = np.lib.stride_tricks.sliding_window_view(power, count)
    at_once = max(1, AT_ONCE // count)
    parts = [np.median(windows[starts[k : k + at_once]], axis=1) for k in range(0, starts.size, at_once)]
    return np.asarray(np.interp(np.arange(power.size), starts + 0.5 * (count - 1), np.concatenate(parts)))
