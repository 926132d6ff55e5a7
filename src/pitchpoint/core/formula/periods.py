# SPDX-License-Identifier: Apache-2.0
"""Periods of formulas: the arguments of their sines, found in the programme without evaluating it.

A formula repeats if its variables occur only inside periodic functions of linear arguments. Its value is then
a function of the phases c . x, one per argument, periodic or quasi-periodic along every straight line.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass

from pitchpoint.core.formula.formula import Formula
from pitchpoint.core.formula.language import ADD, ARITY, CONST, COS, DIV, MOD, MUL, NEG, SIN, SUB, TAN, VAR

Phases = frozenset[tuple[float, ...]]


@dataclass(frozen=True)
class _Term:
    """Part of a formula: slopes by variable if it is linear, its value if constant, and its phases if not.

    `phases` None: it does not repeat.
    """

    slopes: tuple[float, ...] | None = None
    value: float | None = None
    phases: Phases | None = frozenset()

    @property
    def repeats(self) -> Phases | None:
        """Phases of a term that is used by value; None if it grows."""
        return None if self.slopes is not None and any(self.slopes) else self.phases


def phases_of(formula: Formula, steady: Collection[str] = ()) -> Phases | None:
    """Phases of a formula: coefficients of its variables in the arguments of periodic functions.

    Parameters
    ----------
    formula
        The formula.
    steady
        Variables that count as constants.

    Returns
    -------
    frozenset of tuple or None
        One tuple of coefficients per phase [rad per unit of the variable], in the order of the variables;
        empty for a constant. None if the formula does not repeat.

    Examples
    --------
    >>> f = Formula.parse("150*(1 + 0.3*sin(2*angle))^2 + speed", ("t", "angle", "speed"))
    >>> phases_of(f, ("speed",))
    frozenset({(0.0, 2.0, 0.0)})
    >>> phases_of(Formula.parse("min(t/0.1, 1)")) is None
    True
    """
    zero = (0.0,) * len(formula.variables)
    stack: list[_Term] = []
    for word in formula.ops[1:]:
        op, arg = int(word) & 255, int(word) >> 8
        if op == CONST:
            stack.append(_Term(zero, float(formula.consts[arg])))
        elif op == VAR:
            unit = tuple(float(k == arg) for k in range(len(zero)))
            stack.append(_Term() if formula.variables[arg] in steady else _Term(unit))
        else:
            n = ARITY[op]
            operands = stack[-n:]
            del stack[-n:]
            stack.append(_applied(op, operands))
    return stack[0].repeats


def _applied(op: int, x: list[_Term]) -> _Term:
    """Result of an operation; the value of a constant is known only where a linear term needs it."""
    slopes = [term.slopes for term in x]
    if all(s is not None for s in slopes):
        found = _linear(op, x)
        if found is not None:
            return found
        first = x[0].slopes or ()
        turning = any(first)
        if op in (SIN, COS, TAN) and turning:
            return _Term(phases=frozenset({first}))
        if op == MOD and turning and x[1].value:
            return _Term(phases=frozenset({tuple(2.0 * math.pi * s / x[1].value for s in first)}))
    phases = [term.repeats for term in x]
    return _Term(phases=None if None in phases else frozenset().union(*(p for p in phases if p is not None)))


def _linear(op: int, x: list[_Term]) -> _Term | None:
    """Linear combination, or product with a constant of known value; None for other operations."""
    slopes = [term.slopes or () for term in x]
    if op == NEG:
        return _scaled(x[0], -1.0)
    if op in (ADD, SUB):
        sign = 1.0 if op == ADD else -1.0
        total = tuple(a + sign * b for a, b in zip(*slopes, strict=True))
        one, two = (term.value for term in x)
        return _Term(total, None if one is None or two is None else one + sign * two)
    if op == MUL:
        for factor, term in ((x[0].value, x[1]), (x[1].value, x[0])):
            if factor is not None:
                return _scaled(term, factor)
    if op == DIV and x[1].value:
        return _scaled(x[0], 1.0 / x[1].value)
    return None


def _scaled(term: _Term, factor: float) -> _Term:
    """Linear term times a constant."""
    value = None if term.value is None else factor * term.value
    return _Term(tuple(factor * s for s in term.slopes or ()), value)
