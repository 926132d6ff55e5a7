# SPDX-License-Identifier: Apache-2.0
"""Weights of the past of a multistep method, against polynomials whose values and derivatives are known."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.solvers.explicit.dense_output import interpolate
from pitchpoint.solvers.explicit.derivative import DENSE, OLD
from pitchpoint.solvers.multistep.history import (
    DEPTH,
    dense_weights,
    difference_weights,
    push,
    regrid,
    slopes_at,
    weights_at,
)
from tests.support.engine import chain

TIMES = np.array([0.0, -0.4, -0.55, -1.3, -1.5, -2.2, -2.9, -3.1])
POWERS = np.array([1.3, -0.7, 0.2, 0.5, -0.3, 0.11, -0.05])


def polynomial(degree):
    return np.polynomial.Polynomial(POWERS[: degree + 1])


@pytest.mark.nojit
@pytest.mark.parametrize("n", range(1, 8))
def test_values_and_slopes_of_polynomials(n):
    p = polynomial(n - 1)
    w, u = np.zeros(DEPTH), np.zeros(DEPTH)
    weights_at(TIMES, n, 0.37, w)
    slopes_at(TIMES, n, 0.37, u)
    assert w[:n] @ p(TIMES[:n]) == pytest.approx(p(0.37), rel=1e-12)
    assert u[:n] @ p(TIMES[:n]) == pytest.approx(p.deriv()(0.37), rel=1e-11, abs=1e-12)


@pytest.mark.nojit
@pytest.mark.parametrize("n", range(1, 7))
def test_differences_are_derivatives_of_polynomials(n):
    p, h = polynomial(n), 0.3
    w = np.zeros(2 * DEPTH)
    difference_weights(TIMES, n, h, w)
    places = np.concatenate([[h], TIMES[:n]])
    assert w[: n + 1] @ p(places) == pytest.approx(h**n * math.factorial(n) * POWERS[n], rel=1e-9)


def test_backward_differences_of_equal_steps():
    w = np.zeros(2 * DEPTH)
    difference_weights(-0.25 * np.arange(8.0), 3, 0.25, w)
    np.testing.assert_allclose(w[:4], [1.0, -3.0, 3.0, -1.0], rtol=1e-13)


@pytest.mark.nojit
def test_a_new_grid_keeps_the_polynomial():
    n, h = 5, 0.9
    p = polynomial(n - 1)
    rows = np.zeros((DEPTH, 2))
    times = TIMES.copy()
    rows[:n, 0], rows[:n, 1] = p(times[:n]), times[:n]
    regrid(rows, times, n, h, np.zeros((DEPTH, DEPTH)))
    np.testing.assert_allclose(times[:n], -h * np.arange(n), atol=1e-15)
    np.testing.assert_allclose(rows[:n, 0], p(times[:n]), rtol=1e-11)
    np.testing.assert_allclose(rows[:n, 1], times[:n], atol=1e-12)


@pytest.mark.nojit
def test_a_new_row_moves_the_others_back():
    rows, times = np.arange(16.0).reshape(8, 2), TIMES.copy()
    push(rows, times, 3, 0.5)
    np.testing.assert_array_equal(rows[1:4], [[0.0, 1.0], [2.0, 3.0], [4.0, 5.0]])
    np.testing.assert_allclose(times[:4], [0.0, -0.5, -0.9, -1.05])


@pytest.mark.parametrize("n", range(2, 8))
def test_the_form_that_finds_events_is_the_same_polynomial(n):
    system = chain([1.0], [])
    stage = system.workspace.arrays["stage"]
    p, h = polynomial(n - 1), -TIMES[1]
    W = np.zeros((DEPTH, DEPTH))
    dense_weights(TIMES, n, h, W, np.zeros(2 * DEPTH))
    for r in range(n):
        stage[OLD if r == 0 else DENSE + r - 1, :] = W[r, :n] @ p(TIMES[:n])
    for x in (0.0, 0.3, 1.0):
        interpolate(system.workspace.at, x, n - 1)
        assert system.workspace.q[0] == pytest.approx(p((x - 1.0) * h), rel=1e-12)
