# SPDX-License-Identifier: Apache-2.0
"""Quantities with units: conversion from text to SI and radians, and back to text.

All code except readers, formulas and tables works in SI units. General unit libraries convert rotational
quantities incorrectly (60 rpm to 6.28 Hz, 1 Hz to 1 rad/s), because they treat the radian as 1. Here radians,
revolutions and cycles are separate dimensions, and every conversion between them is explicit. Units that are
not in the table are converted by pint, which is imported on demand and not used for rates.
"""

from __future__ import annotations

import math
import re
from decimal import Decimal
from fractions import Fraction
from functools import lru_cache
from numbers import Real

from pitchpoint.core.errors import UnitError
from pitchpoint.core.unit_expression import parse_unit
from pitchpoint.core.unit_table import (
    DIMENSIONS,
    FORCE_OF_MASS,
    ONE,
    UNITS,
    Dimension,
    Unit,
    zero_of,
)

TWO_PI = 2.0 * math.pi


_NUMBER = r"(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?"
_QUANTITY = re.compile(rf"\s*([+-]?\s*{_NUMBER})\s*(.*?)\s*", re.DOTALL)
_MAX_TEXT = 100


def parse_quantity(
    value: object, dimension: str, *, positive: bool = False, nonnegative: bool = False
) -> float:
    """Convert a quantity to SI units and radians.

    Parameters
    ----------
    value
        Number (in SI units) or text such as "3 mm", "4.0e8 N/m", "1500 rpm", "14 N/(mm um)".
    dimension
        Name of a row of `DIMENSIONS`, such as "length" or "angular_speed".
    positive
        Zero and negative values are an error.
    nonnegative
        Negative values are an error.

    Returns
    -------
    float
        Value in SI units; a frequency in Hz, a rotational speed in rad/s.

    Raises
    ------
    UnitError
        For text that is not a quantity, a wrong dimension, booleans, NaN and infinite values.

    Examples
    --------
    >>> parse_quantity("3 mm", "length")
    0.003
    >>> round(parse_quantity("60 rpm", "angular_speed"), 9), parse_quantity("60 rpm", "frequency")
    (6.283185307, 1.0)
    """
    kind = _dimension(dimension)
    if isinstance(value, str):
        number, unit = _split(value, kind)
        shown = value.strip()
        try:
            factor = ONE if unit == "" else _factor(unit, dimension)
        except UnitError as error:
            raise UnitError(f"'{shown}': {error}") from None
        result = _product_of(number, factor) + zero_of(unit, dimension)
    elif isinstance(value, Real) and not isinstance(value, bool):
        result, shown = float(value), f"{value}"
    elif hasattr(value, "magnitude") and hasattr(value, "units"):
        shown = f"{value.magnitude} {value.units}"
        result = float(value.magnitude) * float(_factor(str(value.units), dimension))
    else:
        raise UnitError(f"{value!r} is not a quantity; expected {kind.words} such as {kind.example}")
    if not math.isfinite(result):
        raise UnitError(f"{shown} is not a finite number; expected {kind.words} such as {kind.example}")
    if positive and not result > 0.0:
        raise UnitError(f"{shown} must be greater than zero; expected {kind.words} such as {kind.example}")
    if nonnegative and result < 0.0:
        raise UnitError(f"{shown} must not be negative; expected {kind.words} such as {kind.example}")
    return result


def format_quantity(value: float, dimension: str, digits: int = 5) -> str:
    """Format an SI value in customary units: millimetres, degrees, rpm, MPa.

    Parameters
    ----------
    value
        Value in SI units and radians.
    dimension
        Name of a row of `DIMENSIONS`.
    digits
        Significant digits.

    Examples
    --------
    >>> format_quantity(0.1500001, "length"), format_quantity(4.0e8, "stiffness")
    ('150 mm', '400 N/µm')
    """
    unit = display_unit(dimension, value)
    return f"{in_unit(value, dimension, unit):.{digits}g} {unit}".rstrip()


def display_unit(dimension: str, magnitude: float = 0.0) -> str:
    """Display unit of a value; without magnitude the customary unit of the dimension.

    Parameters
    ----------
    dimension
        Name of a row of `DIMENSIONS`.
    magnitude
        Magnitude of the value in SI units.

    Examples
    --------
    >>> display_unit("length"), display_unit("length", 2e-6), display_unit("angular_speed")
    ('mm', 'µm', 'rpm')
    """
    kind = _dimension(dimension)
    choices = kind.display
    if not choices:
        return kind.si
    size = abs(magnitude)
    if size == 0.0 or not math.isfinite(size):
        return _USUAL.get(dimension, choices[0][1])
    return [unit for least, unit in choices if size >= least][-1]


def in_unit(value: float, dimension: str, unit: str) -> float:
    """Convert an SI value to a unit given as text.

    Parameters
    ----------
    value
        Value in SI units and radians.
    dimension
        Name of a row of `DIMENSIONS`.
    unit
        Text of the unit; empty for none.

    Examples
    --------
    >>> round(in_unit(0.3490658503988659, "angle", "deg"), 12)
    20.0
    """
    return (value - zero_of(unit, dimension)) / (1.0 if unit == "" else float(_factor(unit, dimension)))


def natural_quantity(text: str) -> tuple[float, str]:
    """SI value of a quantity of any dimension, and its unit as written.

    Cycles and radians are kept apart as in `natural_si`. Text that is not a number with a unit is an error.

    Examples
    --------
    >>> natural_quantity("25 um"), natural_quantity("3")
    ((2.5e-05, 'um'), (3.0, ''))
    """
    match = _QUANTITY.fullmatch(text.replace("−", "-")) if len(text) <= _MAX_TEXT else None
    if match is None:
        raise UnitError(
            f"{text[:_MAX_TEXT]!r} does not begin with a number; expected a quantity such as 3 mm"
        )
    number, unit = _split(text, DIMENSIONS["length"])
    if not unit:
        return float(number), ""
    resolved = parse_unit(unit)
    value = _product_of(number, _scaled(resolved.factor, resolved.rev))
    if not math.isfinite(value):
        raise UnitError(f"{text.strip()} is not a finite number")
    return value, unit


def natural_si(unit: str) -> float:
    """Factor of a unit to its SI unit, without an expected dimension.

    For literals in formulas: cycles remain cycles (25 Hz is 25), revolutions are converted to radians
    (1500 rpm is 157.08).

    Examples
    --------
    >>> natural_si("Hz"), natural_si("kN m"), round(natural_si("rpm"), 6)
    (1.0, 1000.0, 0.10472)
    """
    resolved = parse_unit(unit)
    return float(_scaled(resolved.factor, resolved.rev))


_USUAL = {"length": "mm", "mass": "kg", "time": "s"}


def _dimension(name: str) -> Dimension:
    try:
        return DIMENSIONS[name]
    except KeyError:
        raise UnitError(
            f"{name!r} is not a known dimension; known are {', '.join(sorted(DIMENSIONS))}"
        ) from None


def _split(text: str, kind: Dimension) -> tuple[str, str]:
    """Number and unit text of a quantity."""
    expected = f"expected {kind.words} such as {kind.example}"
    if len(text) > _MAX_TEXT:
        raise UnitError(f"a text of {len(text)} characters is not a quantity; {expected}")
    match = _QUANTITY.fullmatch(text.replace("−", "-"))
    if match is None:
        raise UnitError(f"{text!r} does not begin with a number; {expected}")
    number, unit = match.groups()
    unit = re.sub(r"^[*·⋅]\s*(?=[^\W\d])", "", unit)  # 3*mm
    if unit.startswith(","):
        raise UnitError(f"{text!r} has a decimal comma; write a point; {expected}")
    return "".join(number.split()), unit


def _product_of(number: str, factor: Fraction | float) -> float:
    """Number times factor, rounded once if both are exact."""
    plain = float(number)
    if isinstance(factor, float) or factor == 1 or not 1e-300 < abs(plain) < 1e300:
        return plain * float(factor)
    try:
        return float(Fraction(Decimal(number)) * factor)
    except OverflowError:
        return math.inf


@lru_cache(maxsize=1024)
def _factor(unit: str, dimension: str) -> Fraction | float:
    """Factor from a unit text to the SI unit of a dimension."""
    kind = _dimension(dimension)
    expected = f"expected {kind.words} such as {kind.example}"
    try:
        u = UNITS["K"] if zero_of(unit, dimension) else parse_unit(unit)
    except UnitError as error:
        raise UnitError(f"{error}; {expected}") from None
    if (u.m, u.kg, u.s, u.K) != kind.base:
        hint = _force_for_mass(unit, u, kind)
        raise UnitError(f"'{unit}' is not the unit of {kind.words}{hint}; {expected}")
    turns = u.rev + u.cycle
    if dimension == "frequency":
        if (u.rad, turns) in ((0, 0), (0, 1)):
            return u.factor
        if (u.rad, turns) == (1, 0):
            return float(u.factor) / TWO_PI
    elif dimension == "angular_speed" and u.rad == 0 and turns == 0:
        # 1/min is common for revolutions; 1/s may be radians or revolutions
        if u.factor == Fraction(1, 60):
            return TWO_PI / 60.0
        raise UnitError(f"'{unit}' does not state what is counted; write rad/s, rpm or 1/min; {expected}")
    elif (u.cycle == 0 or dimension == "angular_speed") and u.rad + turns in kind.angle:
        return _scaled(u.factor, turns)
    raise UnitError(f"'{unit}' is not the unit of {kind.words}; {expected}")


def _force_for_mass(unit: str, found: Unit, kind: Dimension) -> str:
    """Hint if a unit has a mass in place of a force, as in ft-lb."""
    if (found.m + 1, found.kg, found.s - 2, found.K) != kind.base:
        return ""
    masses = [w for w in re.findall(r"[A-Za-z]+", unit) if w in FORCE_OF_MASS]
    return f" ('{masses[0]}' is a mass; write {FORCE_OF_MASS[masses[0]]} for the force)" if masses else ""


def _scaled(factor: Fraction | float, turns: int) -> Fraction | float:
    """Factor times (2 pi)^turns, exact for turns = 0."""
    return factor if turns == 0 else float(factor) * TWO_PI**turns
