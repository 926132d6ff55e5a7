# SPDX-License-Identifier: Apache-2.0
"""Coefficients of an airfoil at an angle of attack: cubic pieces with continuous slope."""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel


@kernel
def wrapped(angle):
    """Angle in [-pi, pi]."""
    return angle - 2.0 * math.pi * math.floor(angle / (2.0 * math.pi) + 0.5)


@kernel
def interval(knots, first, last, alpha, near):
    """Row of the polar on the left of an angle of attack, by search from a row that may be near it.

    The result is independent of `near`, which is usually that of the last angle of attack.
    """
    i = min(max(near, first), last - 1)
    while i < last - 1 and knots[i + 1, 0] <= alpha:
        i += 1
    while i > first and knots[i, 0] > alpha:
        i -= 1
    return i


@kernel
def coefficient(knots, i, column, alpha):
    """Coefficient of a column and its slope over the angle of attack, in the interval from row i."""
    h = knots[i + 1, 0] - knots[i, 0]
    t = (alpha - knots[i, 0]) / h
    u = 1.0 - t
    step = knots[i + 1, column] - knots[i, column]
    left = h * knots[i, column + 1]
    right = h * knots[i + 1, column + 1]
    value = knots[i, column] + t * t * (3.0 - 2.0 * t) * step + t * u * (u * left - t * right)
    slope = 6.0 * t * u * step + u * (1.0 - 3.0 * t) * left + t * (3.0 * t - 2.0) * right
    return value, slope / h
