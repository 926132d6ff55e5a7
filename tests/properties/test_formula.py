# SPDX-License-Identifier: Apache-2.0
"""Formulas: any text gives a formula or a FormulaError; valid ones agree with Python and their slopes.

The oracle for values is Python's own arithmetic on a text that the strategy builds (never on a user's
text); the oracle for slopes is a central difference of the same programme.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from pitchpoint.core.errors import PitchpointError
from pitchpoint.core.formula.formula import FUNCTIONS, Formula, FormulaError
from pitchpoint.core.formula.kernel import evaluate, evaluate_slope

NAMES = ("t", "angle", "speed")


def away(distance, value):
    """Pass a value on if no rounding can carry its argument across a kink."""
    if not abs(distance) > 1e-6:
        raise OverflowError
    return value


def small(function):
    """A periodic function whose argument keeps its digits."""
    return lambda a: away(1e4 - min(abs(a), 1e4), function(a))


PYTHON = {
    "sin": small(math.sin),
    "cos": small(math.cos),
    **{n: getattr(math, n) for n in ("atan", "atan2", "exp")},
    "pi": math.pi,
    "abs": abs,
    "min": min,
    "max": max,
    "floor": lambda a: away(a - round(a), math.floor(a)),
    "sign": lambda a: away(a, math.copysign(1.0, a)),
    "step": lambda a: away(a, float(a > 0.0)),
    "pulse": lambda u, a, b: away((u - a) * (u - b), float(a <= u < b)),
    "ramp": lambda u, a, b: away(
        (b - a) * (u - a) * (u - b), min(max((u - a) / (b - a), 0.0), 1.0) if b > a else float(u >= a)
    ),
}
SMOOTH_ONE = ("sin", "cos", "atan", "exp")
ROUGH_ONE = ("abs", "floor", "sign", "step")

numbers = st.floats(0.01, 50.0, allow_nan=False).map(lambda v: f"{v:.6g}")
values = st.floats(-20.0, 20.0, allow_nan=False)
leaves = st.one_of(numbers, st.sampled_from((*NAMES, "pi")))


def grow(rough: bool):
    """Expressions over the variables, with or without kinks."""

    def extend(inner):
        pair = st.tuples(inner, inner)
        parts = [
            st.tuples(pair, st.sampled_from("+-*/")).map(lambda x: f"({x[0][0]} {x[1]} {x[0][1]})"),
            st.tuples(st.sampled_from(SMOOTH_ONE), inner).map(lambda x: f"{x[0]}({x[1]})"),
            inner.map(lambda x: f"(-{x})"),
            inner.map(lambda x: f"({x})**2"),
        ]
        if rough:
            parts += [
                st.tuples(st.sampled_from(ROUGH_ONE), inner).map(lambda x: f"{x[0]}({x[1]})"),
                st.tuples(st.sampled_from(("min", "max", "atan2")), pair).map(
                    lambda x: f"{x[0]}({x[1][0]}, {x[1][1]})"
                ),
                st.tuples(st.sampled_from(("ramp", "pulse")), pair, inner).map(
                    lambda x: f"{x[0]}({x[2]}, {x[1][0]}, {x[1][1]})"
                ),
            ]
        return st.one_of(parts)

    return st.recursive(leaves, extend, max_leaves=8)


def run(formula, xs, k=None):
    work = formula.workspace()
    with np.errstate(all="ignore"):  # without the compiler numpy warns where the hardware is silent
        if k is None:
            return evaluate(formula.ops, formula.ops.size, work, *xs)
        return evaluate_slope(formula.ops, formula.ops.size, work, *xs, k)


@given(st.text(max_size=60))
def test_any_text_is_a_formula_or_a_clean_error(text):
    try:
        formula = Formula.parse(text, NAMES)
    except PitchpointError as error:
        assert str(error)
    else:
        formula(1.0, 2.0, 3.0)


@given(
    st.lists(st.sampled_from([*FUNCTIONS, *NAMES, *"+-*/^(),.5 2", "mm", "N", "rpm", "%", "°"]), max_size=25)
)
def test_any_sequence_of_words_is_a_formula_or_a_clean_error(words):
    try:
        formula = Formula.parse(" ".join(words), NAMES)
    except FormulaError:
        return
    with np.errstate(all="ignore"):
        a, b = formula(1.5, -2.0, 3.0), run(formula, (1.5, -2.0, 3.0))
    assert a == pytest.approx(b, rel=1e-9, abs=1e-12, nan_ok=True)


@given(
    st.one_of(
        grow(rough=True),
        st.lists(st.sampled_from([*FUNCTIONS, *NAMES, "pi", *"+-*/^(),2"]), max_size=25).map(" ".join),
    ),
    st.sampled_from(("torque", "force", "angle", "angular_speed")),
)
def test_without_units_no_formula_is_refused_for_its_dimension(text, dimension):
    try:
        Formula.parse(text, NAMES, dimension)
    except FormulaError as error:
        assert error.remedy == ""


plain = st.recursive(
    st.sampled_from(
        ("0.5", "2", "sin(t)", "angle", "(t/0.1 s)", "(speed/10 rpm)", "(5 mm/1 m)", "(20 Hz*t)")
    ),
    lambda inner: st.one_of(
        st.tuples(inner, st.sampled_from("+-*/"), inner).map(lambda x: f"({x[0]} {x[1]} {x[2]})"),
        st.tuples(st.sampled_from((*SMOOTH_ONE, *ROUGH_ONE)), inner)
        .filter(lambda x: not (x[0] in ("sin", "cos") and "Hz" in x[1]))
        .map(lambda x: f"{x[0]}({x[1]})"),
        st.tuples(inner, inner).map(lambda x: f"max({x[0]}, {x[1]})"),
    ),
    max_leaves=5,
)
torques = st.recursive(
    st.sampled_from(
        ("5 N m", "2 N m/s * t", "0.1 N m s/rad * speed", "3 kN * 20 mm", "1 kg m^2 * speed / (2 s)")
    ),
    lambda inner: st.one_of(
        st.tuples(inner, st.sampled_from("+-"), inner).map(lambda x: f"({x[0]} {x[1]} {x[2]})"),
        st.tuples(inner, st.sampled_from("*/"), plain).map(lambda x: f"({x[0]} {x[1]} {x[2]})"),
        st.tuples(plain, inner).map(lambda x: f"({x[0]} * {x[1]})"),
        inner.map(lambda x: f"min({x}, 1 kN m)"),
        inner.map(lambda x: f"sqrt(({x})^2)"),
        inner.map(lambda x: f"(-{x})"),
    ),
    max_leaves=5,
)


@given(torques)
def test_right_units_are_accepted_and_a_wrong_factor_is_not(text):
    try:
        Formula.parse(text, NAMES, "torque")
    except FormulaError as error:
        # a constant part may overflow or divide by zero
        assert "finite" in str(error)
        return
    # seconds are left out: a number without unit may supply those of a variable
    for wrong in ("3 kg", "3 mm", "3 K"):
        with pytest.raises(FormulaError, match="its units give"):
            Formula.parse(f"{wrong} * {text}", NAMES, "torque")


@given(grow(rough=True), st.tuples(values, values, values))
def test_values_agree_with_python(text, xs):
    try:
        expected = eval(text, {"__builtins__": {}, **PYTHON}, dict(zip(NAMES, xs, strict=True)))
    except (ZeroDivisionError, OverflowError, ValueError):
        assume(False)
    assume(math.isfinite(expected) and abs(expected) < 1e12)
    try:
        formula = Formula.parse(text, NAMES)
    except FormulaError as error:
        # a constant part may overflow although the whole stays finite (atan(exp(exp(9))))
        assert "finite" in str(error)
        return
    for got in (formula(*xs), run(formula, xs)):
        assert got == pytest.approx(expected, rel=1e-8, abs=1e-8)


@given(grow(rough=False), st.tuples(values, values, values), st.integers(0, 2))
def test_slopes_agree_with_differences(text, xs, k):
    try:
        formula = Formula.parse(text, NAMES)
    except FormulaError:
        assume(False)
    value, slope = run(formula, xs, k)
    assume(math.isfinite(value) and abs(value) < 1e6 and abs(slope) < 1e6)

    def at(h):
        return run(formula, [x + h * (i == k) for i, x in enumerate(xs)])

    h = 1e-4
    fine = (8.0 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12.0 * h)
    coarse = (8.0 * (at(2 * h) - at(-2 * h)) - (at(4 * h) - at(-4 * h))) / (24.0 * h)
    # only where the difference itself has converged is it an oracle
    assume(math.isfinite(fine) and abs(fine - coarse) < 1e-5 * (1.0 + abs(fine)))
    assert slope == pytest.approx(fine, rel=1e-4, abs=1e-4 * (1.0 + abs(value)))
