# SPDX-License-Identifier: Apache-2.0
"""Evaluation of formulas in kernels: value and slope of a postfix programme, without allocation.

Slopes are computed by dual numbers on the same stack. No operation raises: outside its domain the result is
NaN or infinite, which the solver reports as a status.
"""

from __future__ import annotations

import math

from pitchpoint.core.formula.language import (
    ABS,
    ACOS,
    ADD,
    ASIN,
    ATAN,
    ATAN2,
    CONST,
    COS,
    COSH,
    DIV,
    EXP,
    FLOOR,
    LOG,
    MAX,
    MIN,
    MOD,
    MUL,
    NEG,
    POW,
    PULSE,
    RAMP,
    SIGN,
    SIN,
    SINH,
    SQRT,
    STEP,
    SUB,
    TAN,
    TANH,
    VAR,
)
from pitchpoint.core.kernel import kernel

NAN = math.nan
INF = math.inf
LARGEST = 710.475860073944
"""Greatest argument at which cosh and sinh are finite: acosh of the largest number."""


@kernel
def unary(op, a, da):
    """Value and slope of an operation with one operand."""
    if op == NEG:
        return -a, -da
    if op == ABS:
        return (a, da) if a > 0.0 else (-a, -da) if a < 0.0 else (a, 0.0)
    if op == STEP:
        return (1.0, 0.0) if a >= 0.0 else (0.0, 0.0)
    if op == SIGN:
        return (1.0, 0.0) if a > 0.0 else (-1.0, 0.0) if a < 0.0 else (a, 0.0)
    # functions of the interpreter raise where compiled ones return NaN: test the domain first
    if not math.isfinite(a):
        if op == EXP:
            return (0.0, 0.0) if a < 0.0 else (a, a)
        if op == ATAN:
            return math.atan(a), 0.0
        if op == TANH:
            return (NAN, NAN) if math.isnan(a) else (math.copysign(1.0, a), 0.0)
        if op == COSH:
            return abs(a), 0.0
        if op == FLOOR or op == SINH or ((op == SQRT or op == LOG) and a > 0.0):
            return a, 0.0
        return NAN, NAN
    if op == SIN:
        return math.sin(a), math.cos(a) * da
    if op == COS:
        return math.cos(a), -math.sin(a) * da
    if op == EXP:
        v = math.exp(a) if a < 709.0 else INF
        return v, v * da
    if op == SQRT:
        if a < 0.0:
            return NAN, NAN
        v = math.sqrt(a)
        return v, (0.0 if da == 0.0 else INF * da if v == 0.0 else 0.5 * da / v)
    if op == LOG:
        if a <= 0.0:
            return (NAN, NAN) if a < 0.0 else (-INF, NAN)
        return math.log(a), da / a
    return unary_rare(op, a, da)


@kernel
def unary_rare(op, a, da):
    """Value and slope of the remaining operations with one finite operand."""
    if op == TAN:
        v = math.tan(a)
        return v, (1.0 + v * v) * da
    if op == ATAN:
        return math.atan(a), da / (1.0 + a * a)
    if op == FLOOR:
        return a - a % 1.0, 0.0
    if op == SINH or op == COSH:
        if abs(a) > LARGEST:
            up, down = INF, math.copysign(INF, a)
        else:
            up, down = math.cosh(a), math.sinh(a)
        return (down, up * da) if op == SINH else (up, down * da)
    if op == TANH:
        v = math.tanh(a)
        return v, (1.0 - v * v) * da
    if abs(a) > 1.0:
        return NAN, NAN
    s = math.sqrt(1.0 - a * a)
    slope = 0.0 if da == 0.0 else INF * da if s == 0.0 else da / s
    if op == ASIN:
        return math.asin(a), slope
    if op == ACOS:
        return math.acos(a), -slope
    return NAN, NAN


@kernel
def power(a, b):
    """Real power with the special values of the C library instead of exceptions."""
    if b == 0.0 or a == 1.0:
        return 1.0
    if not (math.isfinite(a) and math.isfinite(b)):
        if math.isnan(a) or math.isnan(b):
            return NAN
        return math.pow(a, b)
    whole = b % 1.0 == 0.0
    odd = whole and b % 2.0 != 0.0
    if a == 0.0:
        if b > 0.0:
            return a if odd else 0.0
        return math.copysign(INF, a) if odd else INF
    if a < 0.0 and not whole:
        return NAN
    if b * math.log(abs(a)) > 709.7:
        return -INF if a < 0.0 and odd else INF
    return math.pow(a, b)


@kernel
def quotient(a, b):
    """Quotient; infinite or NaN for a zero divisor."""
    if b == 0.0:
        return NAN if a == 0.0 or math.isnan(a) else math.copysign(INF, a) * math.copysign(1.0, b)
    return a / b


@kernel
def remainder(a, b):
    """Remainder with the sign of the divisor."""
    if b == 0.0 or not math.isfinite(a) or math.isnan(b):
        return NAN
    if math.isinf(b):
        return a if a == 0.0 or (a > 0.0) == (b > 0.0) else b
    r = a % b
    return math.copysign(0.0, b) if r == 0.0 else r


@kernel
def binary(op, a, da, b, db):
    """Value and slope of an operation with two operands."""
    if op == ADD:
        return a + b, da + db
    if op == SUB:
        return a - b, da - db
    if op == MUL:
        return a * b, da * b + a * db
    if op == DIV:
        v = quotient(a, b)
        return v, quotient(da - v * db, b)
    if op == MIN or op == MAX:
        if math.isnan(a) or math.isnan(b):
            return NAN, NAN
        return (a, da) if (a <= b) == (op == MIN) else (b, db)
    if op == POW:
        v = power(a, b)
        slope = 0.0
        if da != 0.0:
            slope = b * power(a, b - 1.0) * da
        if db != 0.0 and v != 0.0:
            slope += v * math.log(a) * db if a > 0.0 else NAN
        return v, slope
    if op == ATAN2:
        square = a * a + b * b
        return math.atan2(a, b), quotient(b * da - a * db, square)
    if op == MOD:
        v = remainder(a, b)
        return v, da - (quotient(a - v, b) * db if db != 0.0 else 0.0)
    return NAN, NAN


@kernel
def ternary(op, u, du, low, dlow, high, dhigh):
    """Value and slope of ramp, smoothstep and pulse."""
    if math.isnan(u) or math.isnan(low) or math.isnan(high):
        return NAN, NAN
    if op == PULSE:
        return (1.0, 0.0) if low <= u < high else (0.0, 0.0)
    width = high - low
    if u <= low or width <= 0.0:
        return (1.0, 0.0) if width <= 0.0 and u >= low else (0.0, 0.0)
    if u >= high:
        return 1.0, 0.0
    s = (u - low) / width
    ds = (du - dlow - s * (dhigh - dlow)) / width
    if op == RAMP:
        return s, ds
    return s * s * (3.0 - 2.0 * s), 6.0 * s * (1.0 - s) * ds


@kernel
def evaluate_slope(ops, n, work, x0, x1, x2, k):
    """Evaluate a programme and its derivative.

    Parameters
    ----------
    ops
        Programme of a `Formula`, int64.
    n
        Length of the programme.
    work
        `workspace()` of the formula: constants, then the stack, which is overwritten. Not thread-safe.
    x0, x1, x2
        Values of the variables; values without a variable are ignored.
    k
        Index of the variable of the derivative; -1 for none.

    Returns
    -------
    tuple
        Value and slope.
    """
    base = ops[0]
    p = base
    for i in range(1, n):
        op = ops[i] & 255
        if op == CONST:
            work[p] = work[ops[i] >> 8]
            work[p + 1] = 0.0
            p += 2
        elif op == VAR:
            j = ops[i] >> 8
            work[p] = x0 if j == 0 else x1 if j == 1 else x2
            work[p + 1] = 1.0 if j == k else 0.0
            p += 2
        elif op == NEG or SIN <= op <= STEP:
            work[p - 2], work[p - 1] = unary(op, work[p - 2], work[p - 1])
        elif op >= RAMP:
            p -= 4
            work[p - 2], work[p - 1] = ternary(
                op, work[p - 2], work[p - 1], work[p], work[p + 1], work[p + 2], work[p + 3]
            )
        else:
            p -= 2
            work[p - 2], work[p - 1] = binary(op, work[p - 2], work[p - 1], work[p], work[p + 1])
    return work[base], work[base + 1]


@kernel
def evaluate_curvature(ops, n, work, x, h):
    """Value, slope and second derivative of a programme of one variable.

    The second derivative is a difference quotient of fourth order of the exact slope with the step h.
    """
    value, slope = evaluate_slope(ops, n, work, x, 0.0, 0.0, 0)
    second = 0.0
    for k in range(-2, 3):
        if k != 0:
            _, s = evaluate_slope(ops, n, work, x + k * h, 0.0, 0.0, 0)
            second += s * (8.0 if abs(k) == 1 else -1.0) * (1.0 if k > 0 else -1.0)
    return value, slope, second / (12.0 * h)


@kernel
def evaluate(ops, n, work, x0, x1, x2):
    """Evaluate a programme without derivative; arguments as in `evaluate_slope`."""
    value, _ = evaluate_slope(ops, n, work, x0, x1, x2, -1)
    return value
