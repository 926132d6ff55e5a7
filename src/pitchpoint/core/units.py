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
from pitchpoint.core.unit_table import (
    DIMENSIONS,
    FORCE_OF_MASS,
    JOINED,
    ONE,
    ONLY_IN_SPEEDS,
    REFUSED,
    UNITS,
    WORDS,
    Dimension,
    Unit,
    zero_of,
)

TWO_PI = 2.0 * math.pi


_NUMBER = r"(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?"
_QUANTITY = re.compile(rf"\s*([+-]?\s*{_NUMBER})\s*(.*?)\s*", re.DOTALL)
# A power may follow its symbol directly (m2, s-1). A hyphen is a product only between two symbols without
# spaces (N-m), so that a missing operand is detected; a 1 is the numerator of a division or the whole unit.
_TOKEN = re.compile(
    r"\s*(?:(?P<power>(?:\^|\*\*)\s*[+-]?\d+|(?<=[A-Za-zµ°])-?\d+)|(?P<name>[A-Za-zµ°_]+|%)"
    r"|(?P<op>[*/()]|(?<=[\w°%)])-(?=[^\W\d]|[°(]))|(?P<one>(?<![\w°%)\s])1(?=\s*(?:/|$))))\s*"
)
_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_ONE_SIGN = str.maketrans({"μ": "µ", "º": "°"} | dict.fromkeys("·⋅∙•×", "*") | dict.fromkeys("−‐‑–", "-"))
_BRACKETED_POWER = re.compile(r"(\^|\*\*)\s*\(\s*([+-]?\d+)\s*\)")
_MAX_TEXT = 100
_MAX_POWER = 12


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


@lru_cache(maxsize=1024)
def parse_unit(text: str) -> Unit:
    """Parse a unit expression: names, products, powers, one or more divisions, brackets.

    Factors are separated by a space, `*`, `·`, `.` or a hyphen; powers are `^2`, `**2`, `²` or a 2 directly
    after the symbol. A power after a product in one word applies to its last symbol: `kgm2` is `kg m^2`.

    Parameters
    ----------
    text
        Unit such as "kg m^2", "kg-m2", "N/(mm um)", "N·m·s/rad", "N.m", "kNm/rad", "min^-1", "/min".

    Examples
    --------
    >>> parse_unit("N m/rad")[:5]
    (Fraction(1, 1), 2, 1, -2, 0)
    """
    if len(text) > _MAX_TEXT:
        raise UnitError("the unit is too long")
    clean = _BRACKETED_POWER.sub(r"\1\2", text.strip().translate(_ONE_SIGN))
    clean = re.sub(r"(?<=[\w)])\s*\.\s*(?=[^\W\d_(])", "*", clean)
    clean = re.sub(r"[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+", lambda m: "^" + m.group().translate(_SUPERSCRIPTS), clean)
    clean = re.sub(r"^/", "1/", clean)
    tokens: list[tuple[str, str]] = []
    at = 0
    while at < len(clean):
        match = _TOKEN.match(clean, at)
        if match is None or match.lastgroup is None:
            raise UnitError(f"'{text}' is not a unit: unexpected '{clean[at]}'")
        tokens.append((match.lastgroup, match.group(match.lastgroup)))
        at = match.end()
    unit, at = _product(tokens, 0, text, 0)
    if at != len(tokens):
        raise UnitError(f"'{text}' is not a unit: unexpected '{tokens[at][1]}'")
    for kind, word in tokens:
        if kind == "name" and word in ONLY_IN_SPEEDS and unit[1:] != UNITS["rpm"][1:]:
            raise UnitError(f"'{word}' is a revolution in {word}/min only; write rev or rad")
    return unit


def _product(tokens: list[tuple[str, str]], at: int, text: str, depth: int) -> tuple[Unit, int]:
    """Parse factors up to a closing bracket or the end."""
    unit, divided, empty = Unit(ONE), False, True
    while at < len(tokens) and tokens[at] != ("op", ")"):
        sign = 1
        if tokens[at] == ("op", "/") and not empty:
            sign, divided, at = -1, True, at + 1
        elif tokens[at] in (("op", "*"), ("op", "-")) and not empty:
            at += 1
        if sign == 1 and divided:
            raise UnitError(
                f"'{text}' is ambiguous: put everything below the line into brackets, as in N/(mm um)"
            )
        factor, at = _factor_at(tokens, at, text, depth)
        unit, empty = unit.times(factor, sign), False
    if empty:
        raise UnitError(f"'{text}' is not a unit")
    return unit, at


def _factor_at(tokens: list[tuple[str, str]], at: int, text: str, depth: int) -> tuple[Unit, int]:
    """Parse one name, a 1, or a bracket, with its power."""
    kind, word = tokens[at] if at < len(tokens) else ("end", "")
    ahead = Unit(ONE)
    if kind == "name":
        *front, last = JOINED.get(word, (word,))
        unit, at = _lookup(last), at + 1
        for part in front:
            ahead = ahead.times(UNITS[part])
    elif kind == "one":
        unit, at = Unit(ONE), at + 1
    elif word == "(" and depth < 2:
        unit, at = _product(tokens, at + 1, text, depth + 1)
        if at >= len(tokens):
            raise UnitError(f"'{text}' lacks a closing bracket")
        at += 1
    else:
        raise UnitError(f"'{text}' is not a unit")
    if at < len(tokens) and tokens[at][0] == "power":
        power = int(tokens[at][1].lstrip("^*").replace(" ", ""))
        if abs(power) > _MAX_POWER:
            raise UnitError(f"'{text}' has a power beyond {_MAX_POWER}")
        unit, at = Unit(ONE).times(unit, power), at + 1
    return ahead.times(unit), at


def _lookup(name: str) -> Unit:
    """Unit of a name, from the table or from pint."""
    if name in UNITS:
        return UNITS[name]
    if name in REFUSED:
        raise UnitError(f"'{name}' is refused: {REFUSED[name]}")
    one = name.removesuffix("s")
    if one in UNITS and one not in JOINED and (len(one) > 3 or one == "rev"):
        return UNITS[one]
    for word in (name, one):
        if word.lower() in WORDS and word[1:].islower():
            return WORDS[word.lower()]
    from pitchpoint.core._pint import foreign_unit

    try:
        return Unit(*foreign_unit(name))
    except UnitError as error:
        near = [known for known in UNITS if known.lower() == name.lower()]
        guess = f" (did you mean {' or '.join(near)}?)" if near else ""
        raise UnitError(f"{error}{guess}") from None
