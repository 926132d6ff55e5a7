# SPDX-License-Identifier: Apache-2.0
"""The search for the place where flanks lift off: it converges on both sides, whatever the curvature."""

from __future__ import annotations

import math

import pytest

from pitchpoint.contact.lift_off import narrowed, secant

CASES = {
    "straight": (lambda z: 3.0 * z - 1.0, 0.0, 2.0, 1.0 / 3.0),
    "convex": (lambda z: math.exp(6.0 * z) - 2.0, -1.0, 1.0, math.log(2.0) / 6.0),
    "concave, falling": (lambda z: 2.0 - math.exp(6.0 * z), -1.0, 1.0, math.log(2.0) / 6.0),
    "cubic": (lambda z: (z - 0.3) ** 3 + 1e-3 * (z - 0.3), -1.0, 1.0, 0.3),
}


@pytest.mark.nojit
@pytest.mark.parametrize("case", CASES)
def test_the_zero_is_found_in_few_steps(case):
    function, a, c, zero = CASES[case]
    bracket = (a, c, function(a), function(c), 0)
    for _ in range(25):
        z = secant(bracket)
        f = function(z)
        if abs(f) <= 1e-14:
            break
        bracket = narrowed(bracket, z, f)
        assert min(bracket[:2]) <= zero <= max(bracket[:2]), "the bracket keeps the zero"
    assert z == pytest.approx(zero, abs=1e-11)
