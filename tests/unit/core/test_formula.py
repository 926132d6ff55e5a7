# SPDX-License-Identifier: Apache-2.0
"""The formula language: units, precedence, messages, and the compiled evaluation at its edges."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.formula.formula import FUNCTIONS, MAX_DEPTH, Formula, FormulaError
from pitchpoint.core.formula.kernel import evaluate, evaluate_slope

pytestmark = pytest.mark.nojit


def compiled(formula, *xs):
    xs = (*xs, 0.0, 0.0)[:3]
    with np.errstate(all="ignore"):  # without the compiler numpy warns where the hardware is silent
        return evaluate(formula.ops.copy(), formula.ops.size, formula.workspace(), *xs)


@pytest.mark.parametrize(
    ("text", "at_two"),
    [
        ("150 N m * (1 + 0.1*sin(2*pi*25 Hz*t))", 150.0),
        ("5 N/m * t", 10.0),
        ("10 rad/s*t", 20.0),
        ("3 mm/t", 0.0015),
        ("14 N/(mm um)*t", 28e9),
        ("2 kN·m*t", 4000.0),
        ("60 rpm * t", 4 * math.pi),
        ("5 % * t", 0.1),
        ("-2^2 + t", -2.0),
        ("2^3^2*t", 1024.0),
        ("2**-1", 0.5),
        ("min(3, t, 5)", 2.0),
        ("step(t, 1 s)", 1.0),
        ("step(1 - t)", 0.0),
        ("ramp(t, 0, 8 s)", 0.25),
        ("smoothstep(t, 0, 4)", 0.5),
        ("pulse(t, 2, 3) + pulse(t, 1, 2)", 1.0),
        ("mod(-t, 3)", 1.0),
        ("5 m^2*t", 10.0),
    ],
)
def test_values(text, at_two):
    formula = Formula.parse(text)
    assert formula(2.0) == pytest.approx(at_two, rel=1e-14, abs=1e-14)
    assert compiled(formula, 2.0) == pytest.approx(at_two, rel=1e-14, abs=1e-14)
    array = formula(np.array([2.0, 2.0]))
    assert array.shape == (2,)
    assert array == pytest.approx(at_two, rel=1e-14, abs=1e-14)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "missing before the end"),
        ("__import__('os')", "unexpected '''"),
        ("t.__class__", r"unexpected '\.' at character 2"),
        ("(lambda: 1)()", "unexpected ':'"),
        ("t if t else 1", "operator is missing"),
        ("t[0]", "unexpected '\\['"),
        ("2t", "operator is missing at character 2"),
        ("open(t)", "unknown name 'open'; known are t, pi, sin"),
        ("sin t", "needs its arguments in brackets"),
        ("sin(t, t)", "takes 1 argument, not 2"),
        ("ramp(t, 1)", "takes 3 arguments, not 2"),
        ("max(t)", "takes 2 arguments, not 1"),
        ("1/0*t", "not a finite number at character 2"),
        ("1e999", "too large"),
        ("(t", "closing bracket is missing"),
        ("t)", r"unexpected \)"),
        ("t +", "missing before the end"),
        ("(" * 200 + "t" + ")" * 200, "nested too deeply"),
        ("-" * 200 + "t", "nested too deeply"),
        ("^".join("t" * 200), "nested too deeply"),
        ("t+" * 400 + "t", "too long"),
        ("t" * 3000, "3000 characters"),
        (None, "not a formula"),
    ],
)
def test_messages_show_the_place(text, message):
    with pytest.raises(FormulaError, match=message):
        Formula.parse(text)


def test_variables():
    formula = Formula.parse("2*angle - speed", ("t", "angle", "speed"))
    assert formula.uses("angle")
    assert not formula.uses("t")
    assert formula(0.0, 3.0, 1.0) == 5.0
    with pytest.raises(FormulaError, match="needs 3 values"):
        formula(1.0)
    with pytest.raises(FormulaError, match="cannot be a variable"):
        Formula.parse("1", ("sin",))
    with pytest.raises(FormulaError, match="at most 3"):
        Formula.parse("1", ("a", "b", "c", "d"))


def test_a_formula_cannot_be_changed():
    formula = Formula.parse("2*t")
    with pytest.raises(ValueError, match="read-only"):
        formula.ops[0] = 1


def test_deep_but_allowed():
    n = MAX_DEPTH - 1
    formula = Formula.parse("(" * n + "t" + ")" * n)
    assert compiled(formula, 3.0) == 3.0


def test_the_stack_is_as_deep_as_it_must_be():
    text = "t" + "".join(f"+({i}*t" for i in range(2, 20)) + ")" * 18
    formula = Formula.parse(text)
    assert compiled(formula, 1.0) == formula(1.0) == 190.0
    assert formula.depth > 18


EDGES = (0.0, -0.0, 1.0, 710.4, -710.6, -1.0, 0.5, -2.5, 3.0, 1e3, -1e3, 1e300, math.inf, -math.inf, math.nan)


@pytest.mark.parametrize("name", [n for n, (_, k) in FUNCTIONS.items() if k == 1])
def test_unary_functions_agree_at_the_edges(name):
    formula = Formula.parse(f"{name}(t)")
    for x in EDGES:
        got, want = compiled(formula, x), formula(x)
        if math.isinf(x) and name == "sign":
            want = math.copysign(1.0, x)
        if math.isnan(x) and name == "step":
            continue
        assert got == pytest.approx(want, rel=1e-12, nan_ok=True), x


@pytest.mark.parametrize("text", ["t / u", "t ^ u", "mod(t, u)", "atan2(t, u)", "min(t, u)", "max(t, u)"])
def test_binary_operations_agree_at_the_edges(text):
    formula = Formula.parse(text, ("t", "u"))
    for x in EDGES:
        for y in EDGES:
            if "^" in text and math.isinf(x):
                continue  # libraries differ for infinite bases
            got, want = compiled(formula, x, y), formula(x, y)
            assert got == pytest.approx(want, rel=1e-12, nan_ok=True), (x, y)


@pytest.mark.parametrize(
    ("text", "x", "slope"),
    [
        ("t^3", 2.0, 12.0),
        ("2^t", 3.0, 8 * math.log(2)),
        ("t^2", 0.0, 0.0),
        ("sqrt(t)", 4.0, 0.25),
        ("1/t", 2.0, -0.25),
        ("tan(t)", 0.0, 1.0),
        ("asin(t) + acos(t)", 0.3, 0.0),
        ("atan2(t, 2)", 0.0, 0.5),
        ("log(t)", 4.0, 0.25),
        ("mod(3*t, 2)", 1.9, 3.0),
        ("smoothstep(t, 0, 2)", 1.0, 0.75),
        ("ramp(t, 1, 3)", 2.0, 0.5),
        ("ramp(0, -t, t)", 1.0, 0.0),
        ("ramp(1, t, 4)", 0.0, -3.0 / 16.0),
        ("abs(-t)", 2.0, 1.0),
        ("max(t, 3*t)", 1.0, 3.0),
        ("sinh(t)", 0.7, math.cosh(0.7)),
        ("cosh(2*t)", 0.7, 2.0 * math.sinh(1.4)),
        ("tanh(t/2)", 0.6, 0.5 * (1.0 - math.tanh(0.3) ** 2)),
        ("tanh(1000*t)", 2.0, 0.0),
    ],
)
def test_slopes(text, x, slope):
    formula = Formula.parse(text)
    _, got = evaluate_slope(formula.ops.copy(), formula.ops.size, formula.workspace(), x, 0.0, 0.0, 0)
    assert got == pytest.approx(slope, rel=1e-12, abs=1e-12)
