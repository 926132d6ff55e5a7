# SPDX-License-Identifier: Apache-2.0
"""Periods of formulas: found in the programme, confirmed by the values."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.formula.formula import Formula
from pitchpoint.core.formula.periods import phases_of

VARIABLES = ("t", "angle", "speed")
REPEAT = {
    "5 N m": set(),
    "2*abs(speed) + exp(speed)": set(),
    "100*(1 + 0.5*cos(angle))": {(0.0, 1.0)},
    "120*cos(angle/2)^2": {(0.0, 0.5)},
    "sin(2*pi*10 Hz*t + 0.3)*cos(3*angle)": {(20.0 * math.pi, 0.0), (0.0, 3.0)},
    "sin(3*(angle - 4*t)/2)": {(-6.0, 1.5)},
    "pulse(mod(t, 0.1), 0, 0.01)": {(20.0 * math.pi, 0.0)},
    "max(0, sin(-angle))*speed": {(0.0, -1.0)},
    "abs(tan(mod(angle, pi)))": {(0.0, 2.0)},
    "exp(sin(sin(angle) + cos(2*angle)))": {(0.0, 1.0), (0.0, 2.0)},
}
GROW = ("angle", "50*angle + sin(angle)", "min(t/0.1, 1)", "t*sin(angle)", "sin(angle^2)", "sin(speed*t)")


@pytest.mark.parametrize("text", REPEAT)
def test_arguments_of_periodic_functions_are_found(text):
    found = phases_of(Formula.parse(text, VARIABLES), ("speed",))
    assert found is not None
    assert {tuple(np.round(phase[:2], 12)) for phase in found} == {
        tuple(np.round(p, 12)) for p in REPEAT[text]
    }


@pytest.mark.parametrize("text", [t for t in REPEAT if len(REPEAT[t]) == 1])
def test_the_value_returns_after_a_period_of_the_argument(text):
    """In the direction of the coefficients c the phase returns after 2 pi/(c . c)."""
    formula = Formula.parse(text, VARIABLES)
    (phase,) = phases_of(formula, ("speed",)) or ()
    step = 2.0 * math.pi * np.array(phase[:2]) / np.dot(phase, phase)
    t, angle = np.random.default_rng(3).uniform(0.0, 9.0, (2, 50))
    one, two = formula(t, angle, 0 * t + 7.0), formula(t + step[0], angle + step[1], 0 * t + 7.0)
    np.testing.assert_allclose(two, one, rtol=1e-7, atol=1e-7)


@pytest.mark.parametrize("text", GROW)
def test_formulas_that_do_not_repeat_have_no_phases(text):
    assert phases_of(Formula.parse(text, VARIABLES), ("speed",)) is None
