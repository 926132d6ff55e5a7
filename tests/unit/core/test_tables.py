# SPDX-License-Identifier: Apache-2.0
"""Interpolation tables against SciPy, at their edges, and as periodic functions."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator

from pitchpoint.core.tables import cubic_table, interval, linear_table, monotone_slopes

pytestmark = pytest.mark.nojit

X = np.array([0.0, 0.3, 1.0, 1.5, 2.2, 3.0])
Y = np.array([0.0, 1.0, 1.2, -0.5, -0.6, 2.0])


def test_cubic_is_scipys_pchip():
    d = monotone_slopes(X, Y)
    ours = PchipInterpolator(X, Y)
    assert d == pytest.approx(ours.derivative()(X), rel=1e-13, abs=1e-13)
    for u in np.linspace(0.0, 2.999, 101):
        value, slope = cubic_table(X, Y, d, X.size, 0.0, u)
        assert value == pytest.approx(float(ours(u)), rel=1e-12, abs=1e-12)
        assert slope == pytest.approx(float(ours.derivative()(u)), rel=1e-11, abs=1e-11)


def test_linear_is_numpys():
    for u in np.linspace(-1.0, 4.0, 101):
        value, slope = linear_table(X, Y, X.size, 0.0, u)
        assert value == pytest.approx(np.interp(u, X, Y), rel=1e-13, abs=1e-13)
        if u < 0.0 or u > 3.0:
            assert slope == 0.0


def test_two_points():
    x, y = np.array([1.0, 3.0]), np.array([2.0, 6.0])
    d = monotone_slopes(x, y)
    assert cubic_table(x, y, d, 2, 0.0, 1.5) == pytest.approx((3.0, 2.0))


@pytest.mark.parametrize("shift", [-8.0, -4.0, 0.0, 4.0, 4e6])
def test_periodic_tables_repeat(shift):
    d = monotone_slopes(X, Y, 4.0)
    for u in np.linspace(0.0, 3.99, 50):
        tolerance = 1e-12 + 1e-15 * abs(shift) * 100
        assert linear_table(X, Y, 6, 4.0, u + shift)[0] == pytest.approx(
            np.interp(u, X, Y, period=4.0), abs=tolerance
        )
        assert cubic_table(X, Y, d, 6, 4.0, u + shift) == pytest.approx(
            cubic_table(X, Y, d, 6, 4.0, u), abs=tolerance * 10
        )


def test_periodic_cubic_is_smooth_over_the_seam():
    d = monotone_slopes(X, Y, 4.0)
    left, right = cubic_table(X, Y, d, 6, 4.0, 4.0 - 1e-9), cubic_table(X, Y, d, 6, 4.0, 4.0 + 1e-9)
    assert left == pytest.approx(right, abs=1e-6)


def test_slopes_are_the_derivative():
    d = monotone_slopes(X, Y)
    for u in (0.1, 0.7, 1.2, 1.9, 2.7):
        h = 1e-6
        high, low = cubic_table(X, Y, d, 6, 0.0, u + h)[0], cubic_table(X, Y, d, 6, 0.0, u - h)[0]
        assert cubic_table(X, Y, d, 6, 0.0, u)[1] == pytest.approx((high - low) / (2 * h), rel=1e-6)


def test_nan_stays_nan():
    d = monotone_slopes(X, Y)
    assert math.isnan(linear_table(X, Y, 6, 0.0, math.nan)[0])
    assert math.isnan(cubic_table(X, Y, d, 6, 4.0, math.nan)[0])


def test_interval():
    assert interval(X, 6, -0.1) == -1
    assert [interval(X, 6, float(x)) for x in X] == list(range(6))
    assert interval(X, 6, 99.0) == 5
