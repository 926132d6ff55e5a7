# SPDX-License-Identifier: Apache-2.0
"""Values of attributes: from text or JSON to numbers in SI units, by the value type of the schema."""

from __future__ import annotations

import base64
import binascii
import math
import re
from array import array
from fractions import Fraction
from typing import Any

from pitchpoint.io.rexs.document import Value
from pitchpoint.io.rexs.raw import Coded
from pitchpoint.io.rexs.units import RexsUnit

_NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d{1,4})?")
_CODES = {"int32": ("i", 4), "float32": ("f", 4), "float64": ("d", 8)}
LARGEST = 1e30
"""Largest number: REXS files have up to 1e23 for rigid couplings."""
LONG = 1000
"""Length of an array above which numbers are multiplied by the factor of the unit, not exactly converted."""


class BadValueError(ValueError):
    """Value that does not have the type of its attribute; the text completes "... is"."""


class LostValueError(ValueError):
    """Value that the program that wrote the file has lost."""


def typed(value: Any, kind: str | None, type: str, unit: RexsUnit) -> Value:
    """Value of an attribute in SI units.

    Parameters
    ----------
    value
        Text, JSON value, nested lists, or `Coded`.
    kind
        Value type under which a JSON file has it; None in XML.
    type
        Value type of the schema.
    unit
        Unit of the value.

    Raises
    ------
    BadValueError
        If it is not of this type.
    LostValueError
        If a JSON file has false in place of a value of another type.

    Examples
    --------
    >>> from pitchpoint.io.rexs.units import unit_of
    >>> typed("4.5", None, "floating_point", unit_of("mm"))
    0.0045
    >>> typed(27.0, "floating_point", "integer", unit_of("none"))
    27
    """
    if value is False and kind == "boolean" and type != "boolean":
        raise LostValueError
    base, _, shape = type.partition("_array") if type.endswith("_array") else type.partition("_matrix")
    if type == "array_of_integer_arrays":
        return tuple(_list(row, "integer", unit) for row in _rows(value, "array of arrays"))
    if type.endswith("_array"):
        return _list(value, base, unit)
    if type.endswith("_matrix"):
        return _matrix(value, base, unit)
    return _scalar(value, type, unit)


def _rows(value: Any, what: str) -> list[Any]:
    if not isinstance(value, list):
        raise BadValueError(f"not an {what}")
    return value


def _list(value: Any, base: str, unit: RexsUnit) -> tuple[Value, ...]:
    if isinstance(value, Coded):
        return tuple(_decoded(value, base, unit))
    entries = _rows(value, "array")
    if base == "floating_point" and len(entries) > LONG:
        return tuple(float(unit.factor) * float(_fraction(v)) + float(unit.offset) for v in entries)
    return tuple(_scalar(entry, base, unit) for entry in entries)


def _matrix(value: Any, base: str, unit: RexsUnit) -> tuple[Value, ...]:
    if not isinstance(value, Coded):
        rows = [_list(row, base, unit) for row in _rows(value, "matrix")]
        if len({len(row) for row in rows}) > 1:
            raise BadValueError("a matrix with rows of different lengths")
        return tuple(rows)
    numbers, rows_, columns = _decoded(value, base, unit), value.rows, value.columns
    if rows_ is None or columns is None or rows_ * columns != len(numbers):
        raise BadValueError(f"a coded matrix of {rows_} x {columns} with {len(numbers)} numbers")
    return tuple(tuple(numbers[i + rows_ * j] for j in range(columns)) for i in range(rows_))


def _decoded(value: Coded, base: str, unit: RexsUnit) -> list[float]:
    if value.code not in _CODES or base not in ("floating_point", "integer"):
        raise BadValueError(
            f"coded as {value.code[:20]!r}, which is not int32, float32 or float64 of numbers"
        )
    letter, size = _CODES[value.code]
    try:
        data = base64.b64decode("".join(value.text.split()), validate=True)
    except (binascii.Error, ValueError):
        raise BadValueError("not base64 text") from None
    if len(data) % size:
        raise BadValueError(f"coded data of {len(data)} bytes, not whole numbers of {size} bytes")
    numbers = array(letter)
    numbers.frombytes(data)
    import sys

    if sys.byteorder == "big":
        numbers.byteswap()
    if not all(map(math.isfinite, numbers)):
        raise BadValueError("coded data with numbers that are not finite")
    if base == "integer":
        return [int(n) for n in numbers]
    if len(numbers) > LONG:
        factor, offset = float(unit.factor), float(unit.offset)
        return [factor * n + offset for n in numbers]
    return [unit.to_si(Fraction(n)) for n in numbers]


def _fraction(value: Any) -> Fraction:
    """Number exactly as written; shortest decimals for numbers of JSON files."""
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        raise BadValueError("not a number")
    text = value.strip() if isinstance(value, str) else repr(value)
    if len(text) > 400 or not _NUMBER.fullmatch(text):
        raise BadValueError("not a number")
    if not abs(float(text)) <= LARGEST:
        raise BadValueError(f"larger than {LARGEST:g}")
    return Fraction(text) if float(text) else Fraction(0)


def _scalar(value: Any, type: str, unit: RexsUnit) -> Value:
    if isinstance(value, list | Coded | dict):
        raise BadValueError(f"an array, not a single {type.replace('_', ' ')}")
    if type == "floating_point":
        number = _fraction(value)
        return unit.to_si(number) if unit.factor != 1 or unit.offset else float(number)
    if type in ("integer", "reference_component"):
        number = _fraction(value)
        if number.denominator != 1 or abs(number) > 2**53:
            raise BadValueError("not a whole number" if type == "integer" else "not the id of a component")
        return int(number)
    if type == "boolean":
        if isinstance(value, bool):
            return value
        if isinstance(value, str) and value.strip().lower() in ("true", "false"):
            return value.strip().lower() == "true"
        raise BadValueError("not true or false")
    if isinstance(value, str):
        return value.strip()
    if isinstance(value, int | float) and not isinstance(value, bool):  # words such as "7" written as numbers
        return f"{value:.17g}"
    raise BadValueError("not a text")
