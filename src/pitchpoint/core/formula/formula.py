# SPDX-License-Identifier: Apache-2.0
"""Formulas in model files: a small expression language, never evaluated as Python code.

A text such as ``150 N m * (1 + 0.1*sin(2*pi*25 Hz*t))`` is translated to a postfix programme of integers and
constants. The same programme is evaluated for arrays here and in kernels by `pitchpoint.core.formula.kernel`.
The language consists of the functions of `FUNCTIONS`, the constant pi, numbers with units and the declared
variables.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.formula.dimension import si_unit
from pitchpoint.core.formula.language import (
    ARITY,
    CONST,
    CONSTANTS,
    FUNCTIONS,
    MAX_DEPTH,
    MAX_TEXT,
    MAX_VARIABLES,
    VAR,
    Amount,
    FormulaError,
    apply,
)
from pitchpoint.core.formula.parser import Parser

__all__ = ["CONSTANTS", "FUNCTIONS", "MAX_DEPTH", "Amount", "Formula", "FormulaError", "constant"]


@dataclass(frozen=True, eq=False)
class Formula:
    """Formula of up to three variables as a postfix programme.

    Parameters
    ----------
    text
        Formula as written.
    variables
        Names of the variables, in the order of the arguments.
    ops
        Programme, int64, shape (n,): the first item is the number of constants, each further item an
        operation in the low byte and its argument in the higher bytes.
    consts
        Constants in SI units, float64.
    depth
        Required stack depth.
    """

    text: str
    variables: tuple[str, ...]
    ops: NDArray[np.int64]
    consts: NDArray[np.float64]
    depth: int

    @classmethod
    def parse(cls, text: str, variables: tuple[str, ...] = ("t",), dimension: str = "") -> Formula:
        """Parse a formula.

        Parameters
        ----------
        text
            Formula; numbers may have units, powers are written ^ or **.
        variables
            Up to three names of variables.
        dimension
            Required dimension of the result, a row of `DIMENSIONS`; empty for any.

        Raises
        ------
        FormulaError
            For contradictory units and for text outside the language; the text is never executed.

        Examples
        --------
        >>> Formula.parse("2 kN m * step(t - 1 ms) + 1 N m")(np.array([0.0, 1.0]))
        array([1.000e+00, 2.001e+03])
        """
        parser = parsed(text, tuple(variables), dimension)
        consts = np.array(parser.consts, dtype=np.float64)
        ops = np.array([consts.size, *(op | arg << 8 for op, arg in parser.code)], dtype=np.int64)
        ops.flags.writeable = consts.flags.writeable = False
        return cls(text, tuple(variables), ops, consts, parser.depth)

    def __call__(self, *values: float | NDArray[np.float64]) -> Any:
        """Evaluate for numbers or arrays; outside the domain of a function the result is NaN or infinite.

        Parameters
        ----------
        *values
            One value per variable, numbers or arrays of one shape.
        """
        if len(values) != len(self.variables):
            raise FormulaError(f"the formula needs {len(self.variables)} values: {', '.join(self.variables)}")
        stack: list[Any] = []
        with np.errstate(all="ignore"):
            for word in self.ops[1:]:
                op, arg = int(word) & 255, int(word) >> 8
                if op == CONST:
                    stack.append(self.consts[arg])
                elif op == VAR:
                    stack.append(np.asarray(values[arg], dtype=np.float64))
                else:
                    n = ARITY[op]
                    operands = stack[-n:]
                    del stack[-n:]
                    stack.append(apply(op, *operands))
        shape = np.broadcast_shapes(*(np.shape(v) for v in values))
        result = np.broadcast_to(np.asarray(stack[0], dtype=np.float64), shape)
        return float(result) if shape == () else np.array(result)

    def workspace(self) -> NDArray[np.float64]:
        """Work array of the compiled evaluation: constants, then a stack of values and slopes."""
        return np.concatenate([self.consts, np.zeros(2 * self.depth)])

    def uses(self, name: str) -> bool:
        """Whether a variable occurs in the formula.

        Parameters
        ----------
        name
            One of the declared variables.
        """
        code = VAR | self.variables.index(name) << 8
        return bool(np.any(self.ops[1:] == code))


_LAST_ANGLE = re.compile(r"/\s*((?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([^\W\d]+|°)\s*$")
"""Division by a number with a unit, without brackets, at the end of a formula."""


def parsed(
    text: str, variables: tuple[str, ...], dimension: str = "", names: Mapping[str, Amount] | None = None
) -> Parser:
    """Run the parser over a formula.

    Parameters
    ----------
    text, variables, dimension
        As in `Formula.parse`.
    names
        As in `constant`.
    """
    if not isinstance(text, str):
        raise FormulaError(f"{text!r} is not a formula")
    if len(text) > MAX_TEXT:
        raise FormulaError(f"the formula has {len(text)} characters (limit {MAX_TEXT})")
    if len(variables) > MAX_VARIABLES:
        raise FormulaError(f"a formula has at most {MAX_VARIABLES} variables")
    parser = Parser(text, variables, dimension, names or {})
    parser.run()
    return parser


def constant(
    text: str, dimension: str = "", names: Mapping[str, Amount] | None = None
) -> tuple[Amount, frozenset[str]]:
    """Value of a formula without variables, and the names that it uses.

    Parameters
    ----------
    text
        Formula; numbers may have units.
    dimension
        Required dimension of the result, a row of `DIMENSIONS`; empty for any.
    names
        Constants that the formula may use.

    Raises
    ------
    FormulaError
        As in `Formula.parse`.

    Examples
    --------
    >>> constant("302.585 mm * cos(120 deg)", "length")[0]
    Amount(value=-0.15129249999999994, unit='m')
    >>> constant("n/(1 rev)", "frequency", {"n": Amount(50.0, "rad s^-1")})[0].unit
    's^-1'
    """
    parser = parsed(text, (), dimension, names)
    amount = Amount(parser.consts[0], si_unit(parser.kind))
    if amount.unit == "rad^-1":
        _check_per_angle(text, dimension)
    return amount, frozenset(parser.used)


def _check_per_angle(text: str, dimension: str) -> None:
    """Refuse a division by an angle where an angle is required, or meant: pi/60 rad is pi/(60 rad)."""
    if last := _LAST_ANGLE.search(text):
        before, number, unit = text[: last.start()].strip(), last[1], last[2]
        raise FormulaError(
            "a unit belongs to the number before it, so this is a division by an angle",
            text,
            last.start(),
            f"write {before}/{number} * 1 {unit}, or {before}/({number} {unit}) for a value per angle",
        )
    if dimension == "angle":
        raise FormulaError("its units give 1/rad, not rad (an angle such as 20 deg)", text)
