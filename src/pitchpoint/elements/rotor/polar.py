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
def interval(knots, first, last, alpha):
    """Row of the polar on the left of an angle of attack, by bisection."""
    low = first
    high = last
    while high - low > 1:
        middle = (low + high) // 2
        if knots[middle, 0] <= alpha:
            low = middle
        else:
            high = middle
    return low


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
