# SPDX-License-Identifier: Apache-2.0
"""Readers of constant formulas and of parameters, in place of numbers.

A text such as ``302.585 mm * cos(120 deg)`` or ``radial_clearance/2`` is evaluated by the formula language,
and its dimension is compared with that of the key.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import UnitError
from pitchpoint.core.unit_table import DIMENSIONS, UNITS
from pitchpoint.core.units import format_quantity, parse_quantity
from pitchpoint.model import parameters as own
from pitchpoint.model.components.parameter import Parameter
from pitchpoint.model.keys import BAD, Key, Place
from pitchpoint.model.reading.formula_text import WORDS, is_formula
from pitchpoint.model.show import shown

if TYPE_CHECKING:
    from pitchpoint.model.reading.reader import Reader


def mentions(reader: Reader, text: str) -> bool:
    """Whether a text contains the name of a parameter."""
    if not reader.parameters and not reader.unreadable:
        return False
    return any(w in reader.parameters or w in reader.unreadable for w in WORDS.findall(text))


def quantity(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Value of a number, quantity, formula or parameter in SI units; BAD with a problem."""
    if isinstance(data, str) and mentions(reader, data):
        return number(reader, key.dimension, data, path)
    try:
        return parse_quantity(data, key.dimension)
    except UnitError as error:
        found = number(reader, key.dimension, data, path) if isinstance(data, str) else None
        if found is not None:
            return found
        message, _, wanted = str(error).partition("; expected ")
        if isinstance(data, str) and WORDS.fullmatch(data.strip()) and data.strip() not in UNITS and wanted:
            wanted += f", or define {data.strip()} in parameters"
        return reader.problem(path, message, remedy=f"write {wanted}" if wanted else None)
    except OverflowError:
        return reader.problem(path, "is too large for a number", value=shown(data))


def with_value(reader: Reader, key: Key, data: Any, value: float) -> str:
    """Value as written, with the result of a formula."""
    if isinstance(data, str) and is_formula(data, reader.parameters):
        return f"{shown(data)} = {format_quantity(value, key.dimension)}"
    return shown(data)


def number(reader: Reader, dimension: str, text: str, path: Place) -> Any:
    """Value of a constant formula or parameter in SI units; None if the text is neither.

    Parameters
    ----------
    reader
        Reader with the parameters; it collects the problems.
    dimension
        Dimension of the key; empty for any.
    text
        The text.
    path
        Path of the key.
    """
    names = {*reader.parameters, *reader.unreadable}
    if not is_formula(text, names):
        return None
    from pitchpoint.core.formula.formula import FormulaError, constant

    if reader.unreadable.intersection(WORDS.findall(text)):
        return reader.taint(path)  # the parameter has been reported
    alone = text.strip()
    if alone in reader.parameters and dimension:
        return _alone(reader, dimension, alone, path)
    try:
        amount, used = constant(text, dimension, reader.parameters)
    except FormulaError as error:
        return reader.problem(
            path, f"cannot be read as a formula: {error}", remedy=error.remedy or _remedy(reader, text)
        )
    reader.used |= used
    return amount.value


def _remedy(reader: Reader, text: str) -> str:
    if variables := sorted(set(WORDS.findall(text)) & set(own.VARIABLES)):
        return f"the value is constant and cannot depend on {' and '.join(variables)}"
    return "a formula may use parameters, pi, numbers with units and listed functions"


def _alone(reader: Reader, dimension: str, name: str, path: Place) -> Any:
    """Value of a parameter in place of a quantity: read as if the quantity were written."""
    kind = DIMENSIONS[dimension]
    value, unit = reader.parameters[name]
    reader.used.add(name)
    try:
        if not unit and kind.base != (0, 0, 0, 0):
            raise UnitError
        return parse_quantity(f"{value!r} {unit}", dimension)
    except UnitError:
        from pitchpoint.core.formula.dimension import readable

        has = f"has the unit {readable(unit)}" if unit else "has no unit"
        wanted = f"that of {kind.words} such as {kind.example}" if unit or kind.si else kind.words
        remedy = f"use a parameter in {kind.si}" if kind.si else "use a plain number"
        return reader.problem(path, f"{has}; {wanted} is required", value=name, remedy=remedy)


def is_plain(reader: Reader, text: str) -> bool:
    """Whether a text is a formula whose value is a plain number."""
    from pitchpoint.core.formula.formula import FormulaError, constant

    if not is_formula(text, reader.parameters):
        return False
    try:
        return constant(text, "", reader.parameters)[0].unit == ""
    except FormulaError:
        return False


def expanded(reader: Reader, text: str, variables: tuple[str, ...], dimension: str) -> str:
    """Formula with the values of its parameters in SI units, after a check of all units.

    Raises
    ------
    FormulaError
        As for `Formula.parse`.
    """
    from pitchpoint.core.formula.formula import parsed

    parser = parsed(text, variables, dimension, reader.parameters)
    reader.used |= parser.used
    return parser.expanded()


def whole(reader: Reader, text: str, path: Place) -> Any:
    """Value of a formula for a whole number, without rounding errors; None if the text is not a formula."""
    found = number(reader, "dimensionless", text, path)
    if found is None or found is BAD:
        return found
    if abs(found - round(found)) < 1e-9 * max(1.0, abs(found)):
        return float(round(found))
    remedy = "correct the formula, or the values of its parameters"
    return reader.problem(path, "is not a whole number", value=f"{shown(text)} = {found:g}", remedy=remedy)


def formula(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read the formula of a signal; parameters are replaced by their values in SI units."""
    text = reader.string(key, data, path)
    inputs = reader.within.get("inputs")
    if text is BAD or not isinstance(inputs, list | tuple) or not mentions(reader, text):
        return text
    if reader.unreadable.intersection(WORDS.findall(text)):
        return reader.taint(path)
    from pitchpoint.core.formula.formula import FormulaError

    try:
        return expanded(reader, text, tuple(str(name) for name in inputs), "")
    except FormulaError as error:
        remedy = error.remedy or f"a formula may use {', '.join(map(str, inputs))}, parameters and functions"
        return reader.problem(path, f"cannot be read as a formula: {error}", remedy=remedy)


def parameter(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read the value of a parameter: a number or a text, which `resolve` evaluates."""
    is_number = isinstance(data, int | float) and not isinstance(data, bool)
    if isinstance(data, str) or (is_number and abs(data) < 1e60):
        return data
    return reader.problem(
        path, "is neither a number nor a formula", value=shown(data), remedy="write 25 mm, or gap/2"
    )


def parameters(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read all parameters and compute their values for the other keys."""
    if not isinstance(data, Mapping):
        return reader.problem(
            path, "is not a mapping of names", value=shown(data), remedy="write {radial_clearance: 25 um}"
        )
    found: dict[str, Parameter] = {}
    for name, entry in data.items():
        place = (*path, str(name))
        result: Any = BAD
        if own.good_name(reader, str(name)):
            given = entry if isinstance(entry, Mapping | Parameter) else {"value": entry}
            result = reader.component(Parameter, given, place)
        if result is BAD:
            reader.unreadable.add(str(name))
        else:
            found[str(name)] = result
    reader.parameters = own.resolve(found, reader)
    return found
