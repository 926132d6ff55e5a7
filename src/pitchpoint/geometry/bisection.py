# SPDX-License-Identifier: Apache-2.0
"""Bisection, for the few equations of gear geometry without a closed-form solution."""

from __future__ import annotations

from collections.abc import Callable


def bisect(function: Callable[[float], float], low: float, high: float) -> float:
    """Root of a function between two numbers by bisection, to machine precision.

    Parameters
    ----------
    function
        Continuous, with opposite signs at both ends; without a change of sign the result is `low`.
    low, high
        Ends of the interval, in either order.

    Examples
    --------
    >>> round(bisect(lambda x: x * x - 2.0, 0.0, 2.0), 12)
    1.414213562373
    """
    positive = function(high) > 0.0
    for _ in range(200):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        if (function(middle) > 0.0) == positive:
            high = middle
        else:
            low = middle
    return low
