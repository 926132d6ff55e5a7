# SPDX-License-Identifier: Apache-2.0
"""Events of a run as result variables, identical for results in memory and in files."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike


def event_variables(
    time: ArrayLike, index: ArrayLike, direction: ArrayLike, names: Sequence[str]
) -> dict[str, tuple[str, Any, dict[str, str]]]:
    """Variables over the dimension `event`, sorted by time.

    Parameters
    ----------
    time
        Times of the zeros of the event functions, shape (n,) [s].
    index
        Index of the event function in `names`, shape (n,).
    direction
        1 rising, -1 falling, shape (n,).
    names
        Names of the event functions.

    Examples
    --------
    >>> found = event_variables([0.2, 0.1], [0, 1], [1, -1], ["front_gap[m]", "back_gap[m]"])
    >>> found["event_name"][1].tolist(), found["event_direction"][1].tolist()
    (['back_gap[m]', 'front_gap[m]'], [-1, 1])
    """
    when = np.asarray(time, dtype=float)
    order = np.argsort(when, kind="stable")
    which = np.asarray(index).astype(int)[order]
    way = np.asarray(direction).astype(np.int32)[order]
    about = {"units": "s", "long_name": "time of the event", "symbol": "t"}
    return {
        "event_time": ("event", when[order], about),
        "event_name": (
            "event",
            np.array([names[k] for k in which], dtype=str),
            {"long_name": "event function"},
        ),
        "event_direction": ("event", way, {"long_name": "direction: 1 rising, -1 falling"}),
    }
