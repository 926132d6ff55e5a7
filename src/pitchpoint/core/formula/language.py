# SPDX-License-Identifier: Apache-2.0
"""Operations and functions of the formula language, evaluated for numbers and arrays.

The compiled equivalent of `apply` is `pitchpoint.core.formula.kernel`; a test compares the two.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from pitchpoint.core.errors import UnitError

CONST, VAR, NEG, ADD, SUB, MUL, DIV, POW = range(8)
SIN, COS, TAN, ASIN, ACOS, ATAN, SINH, COSH, TANH, EXP, LOG, SQRT, ABS, FLOOR, SIGN, STEP = range(8, 24)
ATAN2, MIN, MAX, MOD = range(24, 28)
RAMP, SMOOTHSTEP, PULSE = range(28, 31)

#: name: (operation, number of arguments); min and max also accept more than two
FUNCTIONS: dict[str, tuple[int, int]] = {
    "sin": (SIN, 1),
    "cos": (COS, 1),
    "tan": (TAN, 1),
    "asin": (ASIN, 1),
    "acos": (ACOS, 1),
    "atan": (ATAN, 1),
    "atan2": (ATAN2, 2),
    "sinh": (SINH, 1),
    "cosh": (COSH, 1),
    "tanh": (TANH, 1),
    "exp": (EXP, 1),
    "log": (LOG, 1),
    "sqrt": (SQRT, 1),
    "abs": (ABS, 1),
    "min": (MIN, 2),
    "max": (MAX, 2),
    "floor": (FLOOR, 1),
    "sign": (SIGN, 1),
    "mod": (MOD, 2),
    "step": (STEP, 1),
    "ramp": (RAMP, 3),
    "smoothstep": (SMOOTHSTEP, 3),
    "pulse": (PULSE, 3),
}
CONSTANTS = {"pi": math.pi}
ARITY = {CONST: 0, VAR: 0, NEG: 1, ADD: 2, SUB: 2, MUL: 2, DIV: 2, POW: 2}
ARITY.update(dict(FUNCTIONS.values()))

MAX_TEXT = 2000
MAX_TOKENS = 500
MAX_DEPTH = 40
MAX_VARIABLES = 3
UNIT_REMEDY = "give every number its unit, or none a unit: then all are SI"
RADIAN_REMEDY = "write n/(1 rev) for the frequency of a speed n"
CYCLE_REMEDY = "write 2*pi*50 Hz, or 50 rev/s, for an angular speed"


class Amount(NamedTuple):
    """Named constant of formulas: a value and its SI unit, as `dimension.si_unit` writes it."""

    value: float
    unit: str


class FormulaError(UnitError):
    """Invalid formula; the message gives the position, `remedy` the correction."""

    def __init__(self, message: str, text: str = "", position: int = 0, remedy: str = "") -> None:
        self.position = position
        self.remedy = remedy
        start = max(0, position - 20)
        snippet = text[start : position + 20]
        at = f" at character {position + 1}, near '{snippet}'" if text else ""
        super().__init__(f"{message}{at}")


def apply(op: int, *x: Any) -> Any:
    """Evaluate one operation for numbers or arrays; reference of the compiled version.

    Parameters
    ----------
    op
        Operation code.
    *x
        Operands, as many as `ARITY` gives.
    """
    if op in _NUMPY:
        return _NUMPY[op](*x)
    u, low, high = (np.asarray(v, dtype=np.float64) for v in x)
    if op == PULSE:
        return np.where((u >= low) & (u < high), 1.0, 0.0)
    width = high - low
    share = np.clip(np.divide(u - low, np.where(width > 0.0, width, 1.0)), 0.0, 1.0)
    # a ramp of zero width is a step, as in the compiled version
    share = np.where(width > 0.0, share, np.where(u >= low, 1.0, 0.0))
    return share if op == RAMP else share * share * (3.0 - 2.0 * share)


_NUMPY: dict[int, Any] = {
    NEG: np.negative,
    ADD: np.add,
    SUB: np.subtract,
    MUL: np.multiply,
    DIV: np.divide,
    POW: np.power,
    SIN: np.sin,
    COS: np.cos,
    TAN: np.tan,
    ASIN: np.arcsin,
    ACOS: np.arccos,
    ATAN: np.arctan,
    SINH: np.sinh,
    COSH: np.cosh,
    TANH: np.tanh,
    EXP: np.exp,
    LOG: np.log,
    SQRT: np.sqrt,
    ABS: np.abs,
    FLOOR: np.floor,
    SIGN: np.sign,
    STEP: lambda a: np.where(np.asarray(a) >= 0.0, 1.0, 0.0),
    ATAN2: np.arctan2,
    MIN: np.minimum,
    MAX: np.maximum,
    MOD: np.mod,
}
