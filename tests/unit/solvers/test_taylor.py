# SPDX-License-Identifier: Apache-2.0
"""Taylor series of a motion: exact for polynomials of as many derivatives as they know."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.solvers.taylor import forward_derivatives, integral_on, position_on

pytestmark = pytest.mark.nojit

MOTION = np.polynomial.Polynomial([0.3, -1.2, 0.7, 2.0, -0.4])
ROUNDING = 1e-13
"""Some units of rounding of numbers of about 1, over a square of the distance 1/16."""


def test_derivatives_from_three_values_are_those_of_their_parabola():
    a, d = MOTION.deriv(2), 1.0 / 16.0
    slope, bend = forward_derivatives(a(0.0), a(d), a(2.0 * d), d)
    assert slope == pytest.approx(MOTION.deriv(3)(0.0), abs=ROUNDING)
    assert bend == pytest.approx(MOTION.deriv(4)(0.0), abs=16 * ROUNDING)


def test_rates_and_positions_are_those_of_a_polynomial_of_order_four():
    q, v, a, jerk, snap = (float(MOTION.deriv(k)(0.0)) for k in range(5))
    for s in (-2.0, 0.0, 0.5):
        assert integral_on(v, s, a, jerk, snap) == pytest.approx(MOTION.deriv()(s), abs=ROUNDING)
        assert position_on(q, v, s, a, jerk, snap) == pytest.approx(MOTION(s), abs=ROUNDING)
